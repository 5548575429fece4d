//! Edges that radiate, and films that change with time.

use super::fem::{Mistake, Place};

/// A warm sheet of 4 mm whose top loses.
const SHEET: &str = r#"
process = "thermal"
[body]
material = "steel"
temperature = "300 degC"
rectangle = { length = "20 mm", height = "4 mm", width = "10 mm" }
[[boundary]]
edge = "top"
emissivity = 0.8
[environment]
temperature = "20 degC"
[time]
end = "10 min"
step = "10 s"
[measurement]
places = ["10 mm"]
interval = "1 min"
"#;

fn temperatures(place: &Place, text: &str) -> Vec<f64> {
    place.write("sheet.toml", text);
    let answer = place.fem(&["run", "sheet.toml", "-o", "out", "--force"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    // Rows of the elongation have none.
    let profile = place.read("out/profile.csv");
    let header: Vec<&str> = profile.lines().next().unwrap().split(',').collect();
    let at = header.iter().position(|name| name.starts_with("temperature")).unwrap();
    profile.lines().skip(1).filter_map(|line| line.split(',').nth(at)?.parse().ok()).collect()
}

#[test]
fn what_radiates_cools_and_what_is_blown_at_cools_then() {
    let place = Place::new();
    let radiates = temperatures(&place, SHEET);
    assert!(radiates.windows(2).all(|two| two[1] < two[0]), "{radiates:?}");
    // A film that never changes is the constant, and one that rises lets it cool more and more.
    place.write("film.csv", "time [min],convection [W/m^2/K]\n0,30\n10,30\n");
    let [record, constant] = ["{ file = \"film.csv\" }", "\"30 W/m^2/K\""]
        .map(|film| temperatures(&place, &SHEET.replace("emissivity = 0.8", &format!("convection = {film}"))));
    assert!(record.iter().zip(&constant).all(|(a, b)| (a - b).abs() < 2e-4), "{record:?} {constant:?}");
    // Off for five minutes, then on within a second.
    place.write("film.csv", "time [s],convection [W/m^2/K]\n0,0\n300,0\n301,300\n600,300\n");
    let blown = temperatures(&place, &SHEET.replace("emissivity = 0.8", "convection = { file = \"film.csv\" }"));
    let at = |minute: usize| blown[blown.len() - 1 - (10 - minute)];
    assert!((at(4) - 300.0).abs() < 1e-6 && at(6) < 290.0 && at(10) < at(6) - 20.0, "{blown:?}");
}

const MISTAKES: &[Mistake] = &[
    ("emissivity = 0.8", "emissivity = 1.8", "`emissivity` is 1.8", "at most 1"),
    (
        "emissivity = 0.8",
        "emissivity = 0.8\nconvection = \"5 W/m^2/K\"",
        "an edge has one condition",
        "another [[boundary]]",
    ),
    ("emissivity = 0.8", "emissivity = 0.8\ncovered = true", "no heat is brought to this edge", "leave it out"),
    ("emissivity = 0.8", "convection = { file = \"none.csv\" }", "none.csv", "relative to the folder"),
    (
        "emissivity = 0.8",
        "moving = { speed = \"20 mm/min\", width = \"4 mm\", flux = \"60 kW/m^2\", from = \"-900 mm\" }",
        "and never comes to the edge",
        "look at `from`, `speed` and `[time] end`",
    ),
];

#[test]
fn surfaces_that_cannot_be_are_told() {
    Place::new().refuses(("run", "sheet.toml"), SHEET, MISTAKES);
}
