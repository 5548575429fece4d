//! Heated bodies of revolution as a user meets them: summary, diameters as measurements, surroundings by section, bad input.

use super::fem::{Mistake, Place, model};

#[test]
fn a_sleeve_that_cools_after_boring() {
    let place = Place::new();
    place.write("model.toml", model("bored-sleeve.toml"));
    let answer = place.fem(&["run", "model.toml", "-o", "out"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!("summary_of_bored_sleeve", answer.out);
    let summary: serde_json::Value = serde_json::from_str(&place.read("out/summary.json")).unwrap();
    assert!(summary["findings"]["energy"]["imbalance"].as_f64().unwrap().abs() < 1e-11);
    // A profile is a measurement of its own model.
    let compared = place.fem(&["compare", "model.toml", "--with", "out/profile.csv", "--json", "-o", "c"]);
    let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    let seen = json["models"][0]["observables"].as_array().unwrap();
    assert_eq!(seen.len(), 3);
    assert!(seen.iter().all(|own| own["rms"].as_f64().unwrap() < 1e-9), "{seen:?}");
}

/// A stepped spindle in coarse elements, with a coolant in a part of its bore.
const SPINDLE: &str = r#"process = "thermal"
[body]
material = "steel"
revolved = [
  { length = "40 mm", diameter = "100 mm", bore = "40 mm" },
  { length = "60 mm", diameter = "70 mm", bore = "40 mm" },
  { length = "30 mm", diameter = "60 mm" },
]
[[source]]
edge = "outside"
from = "50 mm"
to = "80 mm"
power = "120 W"
on = [["0 min", "10 min"]]
[environment]
temperature = "20 degC"
[[environment.section]]
side = "bore"
to = "70 mm"
temperature = "15 degC"
coefficient = "300 W/m^2/K"
[time]
end = "20 min"
step = "60 s"
[measurement]
places = ["0 mm", "65 mm"]
diameters = ["65 mm"]
bores = ["20 mm"]
interval = "2 min"
[mesh]
element_size = "10 mm"
[effects.convection]
coefficient = "30 W/m^2/K"
"#;

#[test]
fn a_fit_finds_power_and_coolant_again() {
    let place = Place::new();
    place.write("m.toml", SPINDLE);
    assert_eq!(place.fem(&["run", "m.toml", "-o", "out"]).status, 0);
    place.write(
        "unknown.toml",
        SPINDLE.replace("\"120 W\"", "\"90 +- 60 W\"").replace("\"300 W/m^2/K\"", "\"200 +- 200 W/m^2/K\""),
    );
    let fitted = place.fem(&["fit", "unknown.toml", "--with", "out/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&fitted.out).unwrap();
    let found: Vec<f64> =
        json["parameters"].as_array().unwrap().iter().map(|own| own["value"].as_f64().unwrap()).collect();
    for (found, hidden) in found.iter().zip([120.0, 300.0]) {
        assert!((found / hidden - 1.0).abs() < 1e-4, "{found} {hidden}");
    }
}

/// In the long run what comes in goes into the coolant: P = h·2πa·l·(T − T_c) at least.
#[test]
fn surroundings_of_a_section_take_what_comes_in() {
    let text = SPINDLE
        .replace("on = [[\"0 min\", \"10 min\"]]\n", "")
        .replace(
            "end = \"20 min\"\nstep = \"60 s\"",
            "end = \"1e5 min\"\nstep = \"2e3 min\"\nscheme = \"backward-euler\"",
        )
        .replace("interval = \"2 min\"", "interval = \"1e5 min\"")
        .replace("\"30 W/m^2/K\"", "\"0 W/m^2/K\"");
    let place = Place::new();
    place.write("m.toml", &text);
    let answer = place.fem(&["run", "m.toml", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let profile = place.read("out/profile.csv");
    let left: f64 = profile.lines().nth(2).unwrap().split(',').nth(3).unwrap().parse().unwrap();
    // Into 70 mm of the bore of 40 mm; the first length, beside the way of the heat, is at the bore's temperature nearly.
    let film = 15.0 + 120.0 / (300.0 * std::f64::consts::PI * 0.04 * 0.07);
    assert!((left - film).abs() < 4.0, "{left} {film}");
}

const CASES: &[Mistake] = &[
    ("[body]\n", "[body]\nwidth = \"20 mm\"\n", "`width` is of a mesh from a file", "leave it out"),
    (
        "diameter = \"70 mm\", bore = \"40 mm\"",
        "diameter = \"70 mm\", bore = \"70 mm\"",
        "as wide as the segment",
        "below",
    ),
    ("diameter = \"60 mm\"", "diameter = \"40 mm\"", "lengths 2 and 3 of the body do not touch", "below 40 mm"),
    ("to = \"80 mm\"", "to = \"180 mm\"", "the strip reaches beyond the edge `outside`", "between 0 and 130 mm"),
    ("to = \"80 mm\"", "to = \"30 mm\"", "the strip ends where it begins, or before", "give it a width"),
    ("edge = \"outside\"", "edge = \"top\"", "`top` is no edge of the body", "left, right, outside, bore"),
    ("edge = \"outside\"", "at = \"65 mm\"\nedge = \"outside\"", "given twice", "keep `at`"),
    ("edge = \"outside\"\n", "at = \"65 mm\"\n", "a strip is on an edge, and none is said", "add edge"),
    (
        "edge = \"outside\"\nfrom = \"50 mm\"\nto = \"80 mm\"",
        "edge = \"bore\"\nfrom = \"50 mm\"\nto = \"120 mm\"",
        "the strip reaches beyond the edge `bore`",
        "between 0 and 100 mm",
    ),
    (
        "edge = \"outside\"\nfrom = \"50 mm\"",
        "edge = \"left\"\nfrom = \"10 mm\"",
        "beyond the edge `left`",
        "between 20 and 50 mm",
    ),
    ("to = \"70 mm\"", "to = \"120 mm\"", "a segment of 30 mm there has no bore", "give the segment a `bore`"),
    ("bores = [\"20 mm\"]", "bores = [\"120 mm\"]", "the body has no bore at 120 mm", "leave that place out"),
    ("diameters = [\"65 mm\"]", "diameters = [\"165 mm\"]", "165 mm is not on the body", "from 0 to 130 mm"),
    (
        "[environment]",
        "[[boundary]]\nedge = \"bore\"\nconvection = \"10 W/m^2/K\"\n[environment]",
        "edge `bore` has a condition of its own, and a section",
        "keep one",
    ),
    (
        "power = \"120 W\"",
        "power = \"120 W\"\nheat_capacity = \"9 J/K\"\ncontact = \"1 W/K\"",
        "known of rods, not of bodies of revolution",
        "leave `heat_capacity` and `contact` out",
    ),
    (
        "[effects.convection]",
        "[effects.contact-resistance]\nat = \"50 mm\"\nconductance = \"900 W/m^2/K\"\n[effects.convection]",
        "which it cuts through, not of bodies of revolution",
        "",
    ),
    ("element_size = \"10 mm\"", "element_size = \"0.1 mm\"", "the body has", "check its dimensions"),
    (
        "revolved = [\n  { length = \"40 mm\", diameter = \"100 mm\", bore = \"40 mm\" },\n  { length = \"60 mm\", diameter = \"70 mm\", bore = \"40 mm\" },\n  { length = \"30 mm\", diameter = \"60 mm\" },\n]",
        "segments = [{ length = \"130 mm\", diameter = \"70 mm\", bore = \"40 mm\" }]",
        "a strip heats a body of revolution, not a rod",
        "at = ",
    ),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let place = Place::new();
    place.refuses(("run", "m.toml"), SPINDLE, CASES);
    // A strip of a blind bore ends with that.
    let (from, whole) = ("edge = \"outside\"\nfrom = \"50 mm\"\nto = \"80 mm\"", "edge = \"bore\"");
    assert!(SPINDLE.contains(from));
    place.write("m.toml", SPINDLE.replacen(from, whole, 1));
    let answer = place.fem(&["run", "m.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
}

/// (file, part of the message)
const FILES: &[(&str, &str)] = &[
    ("time [min],x [mm],y [mm],diameter [um]\n5,20,35,3\n", "is within the body"),
    ("time [min],diameter [um]\n5,3\n", "the column `x` is missing"),
    ("time [min],x [mm],diameter [um]\n5,,3\n", "the cell of `x [mm]` is empty"),
    ("time [min],x [mm],y [mm],diameter [um]\n5,10,10,3\n", "the body reaches from 20 to 50 mm"),
    ("time [min],x [mm],diameter [um]\n5,140,3\n", "the body reaches from 0 to 130 mm"),
];

#[test]
fn measurements_that_cannot_be_are_refused() {
    let place = Place::new();
    place.write("m.toml", SPINDLE);
    let refuses = |model: &str, file: &str, message: &str| {
        place.write("m.csv", file);
        let answer = place.fem(&["compare", model, "--with", "m.csv"]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, 2, "{file}: {told}");
        assert!(told.contains(message), "{file}: {told}");
    };
    FILES.iter().for_each(|(file, message)| refuses("m.toml", file, message));
    place.write("rod.toml", model("thermal.toml"));
    refuses("rod.toml", "time [min],x [mm],diameter [um]\n5,100,3\n", "of a body of revolution, not of a rod");
}

/// A ring under a film, of a steel that changes with its temperature.
const CHANGING: &str = r#"process = "thermal"
[body]
material = { base = "steel", conductivity = { file = "steel.csv" }, specific_heat = { file = "steel.csv" }, expansion = { file = "steel.csv" }, expansion_from = "20 degC" }
revolved = [{ length = "60 mm", diameter = "80 mm", bore = "50 mm" }]
[[boundary]]
edge = "outside"
flux = { file = "flux.csv" }
[[boundary]]
edge = "bore"
convection = "500 W/m^2/K"
[environment]
temperature = "20 degC"
[time]
end = "120 s"
step = "2 s"
[mesh]
element_size = "7.5 mm"
"#;

/// Its properties, up to some temperature (degC), and what heats it.
fn changing(most: i32) -> Place {
    let place = Place::new();
    place.write("model.toml", CHANGING);
    let rows = [(0, 52.0, 460, 11.0), (100, 50.7, 487, 11.9), (200, 48.0, 530, 12.5), (400, 42.3, 615, 13.5)];
    let rows = rows.iter().filter(|row| row.0 <= most);
    let rows = rows.map(|(t, k, c, alpha)| format!("{t},{k},{c},{alpha}e-6\n")).collect::<String>();
    place.write(
        "steel.csv",
        format!("temperature [degC],conductivity [W/m/K],specific_heat [J/kg/K],expansion [1/K]\n{rows}"),
    );
    place.write("flux.csv", "time [s],flux [W/m^2]\n0,0\n30,1e5\n120,2e5\n");
    place
}

/// Finite volumes over the radius in enthalpy, by SciPy's BDF at 1e-8, of which the program sees the same ring: 285.151 degC
/// outside after 120 s, and a mean strain, to which a body that is free grows whatever stresses it, of 184.211 um over 60 mm.
#[test]
fn a_steel_that_changes_with_its_temperature() {
    let place = changing(400);
    let answer = place.fem(&["run", "model.toml", "-o", "out"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    let summary: serde_json::Value = serde_json::from_str(&place.read("out/summary.json")).unwrap();
    let figure = |path: [&str; 2]| summary["findings"][path[0]][path[1]].as_f64().unwrap();
    // By what elements of 7.5 mm leave, which the run tells.
    assert!((figure(["hottest", "value"]) - 285.151).abs() < 0.05, "{summary}");
    assert!((figure(["largest", "value"]) - 184.211).abs() < 0.01, "{summary}");
    assert!(figure(["energy", "imbalance"]).abs() < 1e-11, "{summary}");
}

#[test]
fn properties_over_temperature_have_limits() {
    let place = changing(200);
    let beyond = place.fem(&["run", "model.toml", "-o", "out"]);
    assert_eq!(beyond.status, 1);
    insta::assert_snapshot!(beyond.err);
    assert!(!place.path("out").exists());
    let wall = "revolved = [{ length = \"60 mm\", diameter = \"80 mm\", bore = \"50 mm\" }]";
    let mistakes = [
        (
            wall,
            "segments = [{ length = \"60 mm\", diameter = \"80 mm\" }]",
            "properties over temperature are known of plane bodies",
            "revolved = [",
        ),
        (
            "expansion = { file = \"steel.csv\" }, ",
            "",
            "the expansion is no record over temperature",
            "expansion = { file",
        ),
        (
            "convection = \"500 W/m^2/K\"",
            "convection = \"500 W/m^2/K\"\non = [[\"0 s\", \"9 s\"]]",
            "only a flux is switched on and off",
            "a film that changes is a record",
        ),
    ];
    place.refuses(("run", "model.toml"), CHANGING, &mistakes);
}
