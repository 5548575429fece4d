//! A milling machine under the part: what it gives way, and which of its joints is soft.

use super::fem::{Mistake, Place, model};

#[test]
fn a_table_bows_and_a_portal_rises() {
    let place = Place::new();
    place.write("mill.toml", model("portal-mill.toml"));
    let answer = place.fem(&["run", "mill.toml", "-o", "out"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out.split("\n\nheight error").next().unwrap());
    // A firm machine leaves less.
    let firm = model("portal-mill.toml").split("[structure]").next().unwrap().to_string();
    place.write("firm.toml", firm);
    assert_eq!(place.fem(&["run", "firm.toml", "-o", "firm"]).status, 0);
    let [yields, firm] =
        ["out", "firm"].map(|folder| place.column(&format!("{folder}/profile.csv"), "height_error").into_iter());
    assert!(yields.zip(firm).all(|(yields, firm)| yields > firm + 1.0));
}

/// A force of the model that is known roughly makes its prediction uncertain, though the profile states it in every row.
#[test]
fn what_is_known_roughly_of_forces_is_in_the_band() {
    let place = Place::new();
    place.write("mill.toml", model("portal-mill.toml"));
    let summary = |name: &str| -> serde_json::Value {
        assert_eq!(place.fem(&["run", &format!("{name}.toml"), "-o", name, "--force"]).status, 0);
        serde_json::from_str(&place.read(&format!("{name}/summary.json"))).unwrap()
    };
    let heights = |force: &str| {
        place.write("one.toml", model("portal-mill.toml").replace("600 +- 100 N", force));
        summary("one");
        place.column("one/profile.csv", "height_error")
    };
    let (low, high) = (heights("500 N"), heights("700 N"));
    let widest = low.iter().zip(&high).map(|(low, high)| 0.5 * (high - low)).fold(0.0, f64::max);
    let told = summary("mill");
    let band = told["band"]["observables"][0]["widest"].as_f64().unwrap();
    // 95 % of a normal law, by a hundred draws and more.
    assert!((band / (1.96 * widest) - 1.0).abs() < 0.15, "{band} {widest}");
}

const MISTAKES: &[Mistake] = &[
    (
        "supports = \"table\"",
        "supports = \"beam-a\"",
        "`supports` has one at x = 380 mm, and its members go from -500 mm to 200 mm",
        "draw them longer",
    ),
    ("clamps = \"table\"", "clamps = \"tabel\"", "`tabel` is neither a node nor a member", "table"),
    ("clamps = \"table\"", "", "`clamps` is missing", "add clamps ="),
    (
        "spindle = \"spindle\"",
        "spindle = \"table\"",
        "members do not say where on them the cutter is held",
        "name a node",
    ),
    (
        "along = \"x\"\nstiffness = \"200 N/um\"",
        "along = \"x\"\nstiffness = \"200 N/um\"\ngap = \"5 um\"",
        "`structure.feed` is no spring",
        "give it a stiffness alone",
    ),
];

#[test]
fn a_machine_that_does_not_carry_the_part_is_told() {
    let place = Place::new();
    place.refuses(("run", "mill.toml"), &model("portal-mill.toml"), MISTAKES);
    // At the joint, not at the head of the structure.
    let slack = "along = \"x\"\nstiffness = \"200 N/um\"\ngap = \"5 um\"";
    let text = model("portal-mill.toml").replace("along = \"x\"\nstiffness = \"200 N/um\"", slack);
    place.write("mill.toml", &text);
    let line = 1 + text.lines().position(|line| line.starts_with("[structure.feed]")).unwrap();
    let answer = place.fem(&["run", "mill.toml"]);
    assert!(answer.err.contains(&format!("mill.toml:{line}:")), "{}", answer.err);
}
