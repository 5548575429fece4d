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
        "clamps = \"table\"",
        "clamps = [\"table\", \"spindle\"]",
        "`spindle` is a node, and a list is of members along x",
        "clamps = \"spindle\"",
    ),
    (
        "spindle = \"spindle\"",
        "spindle = \"table\"",
        "members do not say where on them the cutter is held",
        "name a node",
    ),
];

#[test]
fn a_machine_that_does_not_carry_the_part_is_told() {
    let place = Place::new();
    place.refuses(("run", "mill.toml"), &model("portal-mill.toml"), MISTAKES);
}

/// A contact in the guides of the spindle yields less and less the harder it is pressed; without a preload it opens where the
/// cutter pulls it apart.
#[test]
fn a_machine_under_a_part_may_have_contacts() {
    let place = Place::new();
    let text = model("portal-mill.toml");
    let guides = text.split("[structure.").find(|own| own.contains("along = \"y\"")).unwrap().to_string();
    let with =
        |contact: &str| text.replace(&guides, &guides.replacen("stiffness", &format!("{contact}\nstiffness"), 1));
    let gives_way = |contact: &str| {
        place.write("mill.toml", with(contact));
        let answer = place.fem(&["run", "mill.toml", "-o", "out"]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        let summary: serde_json::Value = serde_json::from_str(&place.read("out/summary.json")).unwrap();
        summary["findings"]["under_cutter"]["value"].as_f64().unwrap()
    };
    let contact = |preload: &str| format!("c = \"0.3 um/N^n\"\nn = 0.5\npreload = \"{preload}\"");
    let all = [gives_way(""), gives_way(&contact("5 kN")), gives_way(&contact("1 kN")), gives_way(&contact("200 N"))];
    assert!(all.is_sorted() && all[3] > 1.05 * all[0], "{all:?}");
    place.write("mill.toml", with(&format!("{}\n", contact("0 N"))).replace("along = \"y\"", "along = \"-y\""));
    let answer = place.fem(&["run", "mill.toml"]);
    assert_eq!(answer.status, 1, "{}", answer.out);
    assert!(answer.err.contains("opens under a force of"), "{}", answer.err);
}

/// A part on two supports above a table on three joints, and a spindle by itself.
const MILL: &str = r#"
process = "fixture"
workpiece = { material = "steel", length = "200 mm", width = "60 mm", height = "40 mm" }
support = [{ at = "20 mm" }, { at = "180 mm" }]
clamp = [{ at = "20 mm", force = "2 kN" }, { at = "180 mm", force = "2 kN" }]
cutter = { force = "600 N", depth = "DEPTH" }
sweep = { positions = 11 }
[effects.force-feedback]
exponent = 0.8
[structure]
material = "cast-iron"
[structure.nodes]
a = ["20 mm", "-40 mm"]
b = ["180 mm", "-40 mm"]
s = ["100 mm", "100 mm"]
[structure.ports]
supports = "table"
clamps = "table"
spindle = "s"
[structure.table]
between = ["a", "b"]
width = "200 mm"
height = "100 mm"
[structure.along]
at = "a"
along = "x"
stiffness = "100 N/um"
[structure.left]
at = "a"
along = "-y"
stiffness = "200 N/um"
[structure.right]
at = "b"
along = "y"
stiffness = "300 N/um"
[structure.spindle-along]
at = "s"
along = "x"
stiffness = "100 N/um"
[structure.spindle-square]
at = "s"
along = "turning"
stiffness = "100 kN*m/rad"
[structure.column]
at = "s"
along = "y"
stiffness = "150 N/um"
"#;

/// A cutter whose spindle has more clearance than it is set to cut rests on the blank, wherever it stands.
#[test]
fn a_cutter_that_is_lifted_across_a_clearance_cuts_nothing() {
    let place = Place::new();
    for (depth, left) in [("4 um", 4.0), ("5.9 um", 5.9)] {
        place.write("mill.toml", format!("{MILL}gap = \"6 um\"\n").replace("DEPTH", depth));
        assert_eq!(place.fem(&["run", "mill.toml", "-o", "out", "--force"]).status, 0);
        let heights = place.column("out/profile.csv", "height_error");
        assert!(heights.iter().all(|own| (own - left).abs() < 1e-9), "{heights:?}");
    }
}

/// The force that opens a joint is told as that on the joint, and values that are sought are asked for.
#[test]
fn a_joint_that_opens_is_told_with_its_own_force() {
    let place = Place::new();
    let contact = "c = \"0.5 um/N^n\"\nn = 0.5\npreload = \"599 N\"\n";
    let mill = MILL.replace("DEPTH", "4 um").replace("[effects.force-feedback]\nexponent = 0.8\n", "");
    let opening =
        format!("{mill}{contact}").replace("along = \"y\"\nstiffness = \"150", "along = \"-y\"\nstiffness = \"150");
    place.write("mill.toml", opening);
    let answer = place.fem(&["run", "mill.toml"]);
    assert_eq!(answer.status, 1, "{}", answer.out);
    assert!(answer.err.contains("`structure.column` opens under a force of -600"), "{}", answer.err);
    for sought in ["stiffness = \"? N/um\"", "stiffness = \"150 N/um\"\ngap = \"? um\""] {
        place.write("mill.toml", mill.replace("stiffness = \"150 N/um\"", sought));
        let answer = place.fem(&["run", "mill.toml"]);
        assert!(answer.status != 0 && answer.err.contains("structure.column."), "{}", answer.err);
    }
}

/// A force that falls as the cutter is lifted leaves the spindle's joint shut; the whole force would open it, and so what the
/// machine without this effect would make is not told, and all else is.
#[test]
fn what_cannot_be_computed_without_an_effect_is_not_told() {
    let place = Place::new();
    let contact = "c = \"0.5 um/N^n\"\nn = 0.5\npreload = \"599 N\"\n";
    let opening = format!("{MILL}{contact}").replace("DEPTH", "4 um");
    let opening = opening.replace("along = \"y\"\nstiffness = \"150", "along = \"-y\"\nstiffness = \"150");
    place.write("mill.toml", &opening);
    let answer = place.fem(&["run", "mill.toml", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    for told in [
        "caution: nothing is told of the machine without any effect: `structure.column` opens under a force of -600 N",
        "caution: what force-feedback changes is not told, for without it `structure.column` opens",
    ] {
        let words: Vec<&str> = answer.out.split_whitespace().collect();
        assert!(words.join(" ").contains(told), "{}", answer.out);
    }
    let summary: serde_json::Value = serde_json::from_str(&place.read("out/summary.json")).unwrap();
    let untold: Vec<_> =
        summary["untold"].as_array().unwrap().iter().map(|own| own["effect"].as_str().unwrap()).collect();
    assert_eq!((untold, &summary["shares"]), (vec!["ideal", "force-feedback"], &serde_json::json!([])));
    // The cutter is lifted, and leaves a part of its depth uncut.
    let uncut = place.column("out/profile.csv", "height_error");
    assert!(uncut.iter().all(|own| (0.0..4.0).contains(own)), "{uncut:?}");
}

/// A written clearance is on trial as other estimates are: a foot of the table that stands 2.5 um above the floor.
#[test]
fn a_clearance_of_a_drawn_joint_is_on_trial() {
    let place = Place::new();
    let foot = "[structure.foot]\nat = \"m\"\nalong = \"-y\"\nstiffness = \"300 N/um\"\ngap = \"GAP\"\n";
    let half = "[structure.half]\nbetween = [\"m\", \"b\"]\nwidth = \"200 mm\"\nheight = \"100 mm\"\n";
    let mill = MILL
        .replace("DEPTH", "1 mm")
        .replace("[effects.force-feedback]\nexponent = 0.8\n", "")
        .replace("along = \"y\"\nstiffness = \"300", "along = \"-y\"\nstiffness = \"300")
        .replace("between = [\"a\", \"b\"]", "between = [\"a\", \"m\"]")
        .replace("= \"table\"", "= [\"table\", \"half\"]")
        .replace("\ns = [", "\nm = [\"100 mm\", \"-40 mm\"]\ns = [");
    let mill = mill + half + foot;
    let mut measured = "x [mm],cutter_force [N],height_error [um],u [um]\n".to_owned();
    for (number, force) in [100, 400, 800, 1500].into_iter().enumerate() {
        let text = mill.replace("GAP", "2.5 um").replace("600 N", &format!("{force} N"));
        place.write("true.toml", text);
        let answer = place.fem(&["run", "true.toml", "-o", "out", "--force"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        let heights = place.column("out/profile.csv", "height_error");
        for (i, height) in heights.iter().enumerate() {
            // Even over 0.14 um, one value like no other.
            let mixed = ((11 * number + i) as u32).wrapping_mul(2_654_435_761);
            let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(2_246_822_519);
            let noise = 0.14 * (f64::from(mixed) / f64::from(u32::MAX) - 0.5);
            measured += &format!("{},{force},{},0.04\n", 20 * i, height + noise);
        }
    }
    place.write("measured.csv", measured);
    place.write("mill.toml", mill.replace("GAP", "1 um"));
    let answer = place.fem(&["diagnose", "mill.toml", "--with", "measured.csv"]);
    assert!(answer.out.contains("missing: structure.foot.gap;"), "{}{}", answer.out, answer.err);
}
