//! A machine that is drawn in its own file: models that name it stand on it.

use super::fem::{Place, model};

const FILES: [&str; 5] = ["lathe.toml", "shaft.toml", "shaft.csv", "pushed.toml", "pushed.csv"];

fn place() -> Place {
    let place = Place::new();
    FILES.iter().for_each(|file| place.write(file, model(&format!("slant-bed/{file}"))));
    place
}

/// The same lathe, drawn in the model itself.
#[test]
fn a_drawing_in_the_machines_file_is_that_of_the_models() {
    for (own, alone, file, column) in [
        ("shaft.toml", "lathe-on-bed.toml", "profile.csv", "diameter_error [um]"),
        ("pushed.toml", "pushed-lathe.toml", "profile.csv", "displacement [um]"),
    ] {
        let place = place();
        place.write("alone.toml", model(alone));
        for (name, folder) in [(own, "shared"), ("alone.toml", "alone")] {
            let answer = place.fem(&["run", name, "-o", folder]);
            assert_eq!(answer.status, 0, "{name}: {}", answer.err);
        }
        let [shared, alone] = ["shared", "alone"].map(|folder| place.column(&format!("{folder}/{file}"), column));
        assert!(shared.len() > 10 && shared.len() == alone.len());
        assert!(shared.iter().zip(&alone).all(|(a, b)| (a - b).abs() <= 1e-9 * b.abs()), "{own}");
    }
}

#[test]
fn mistakes_in_the_drawing_are_told_at_their_place_in_the_machines_file() {
    let drawing = model("slant-bed/lathe.toml");
    let line = |text: &str| 1 + drawing[..drawing.find(text).unwrap()].matches('\n').count();
    // (in the file of the machine, in its place, the key that is wrong, message, remedy)
    for (good, bad, message, remedy) in [
        ("[\"quill\", \"centre\"]", "[\"quill\", \"centr\"]", "`centr` is no node", "did you mean `centre`?"),
        ("height = \"180 mm\"", "height = \"180 kg\"", "not a length", "write it in mm"),
        ("stiffness = \"1500 kN*m/rad\"", "stifness = \"1500 kN*m/rad\"", "`stifness` is no key", "did you mean"),
    ] {
        let place = place();
        assert!(drawing.contains(good), "{good}");
        place.write("lathe.toml", drawing.replace(good, bad));
        let answer = place.fem(&["run", "shaft.toml"]);
        let at = format!("lathe.toml:{}:", line(good));
        assert!(answer.status == 2 && answer.err.contains(&at), "{at}\n{}", answer.err);
        assert!(answer.err.contains(message) && answer.err.contains(remedy), "{}", answer.err);
    }
    let place = place();
    place.write("lathe.toml", format!("{drawing}\n[structure.ports]\nheadstock = \"nose\"\n"));
    let told = ("`ports` are not known in a machine file", "write [structure.ports] into each model");
    place.is_refused(&["run", "shaft.toml"], "ports in the machine's file", told);
    place.write("lathe.toml", format!("structure = 3\n{}", &drawing[..drawing.find("[structure]").unwrap()]));
    place.is_refused(&["run", "shaft.toml"], "no table", ("`structure` is no table", "write [structure.nodes]"));
}

/// A mistake of the model is told there, and what the model writes stands in the place of what the machine's file has.
#[test]
fn a_model_writes_over_the_drawing_key_by_key() {
    let place = place();
    let stiffest = || {
        let answer = place.fem(&["run", "shaft.toml", "-o", "out"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        let shares = place.column("out/structure.csv", "tailstock-tilt [um/kN]");
        shares.into_iter().fold(0.0, f64::max)
    };
    let before = stiffest();
    let own = model("slant-bed/shaft.toml");
    place.write("shaft.toml", format!("{own}\n[structure.tailstock-tilt]\nstiffness = \"750 kN*m/rad\"\n"));
    // Softer by half, and little else changes: it gives way twice as much under the same force.
    assert!((stiffest() / before - 2.0).abs() < 0.01, "{} {before}", stiffest());
    place.write("shaft.toml", format!("{own}\n[structure.tailstock-tilt]\nstifness = \"750 kN*m/rad\"\n"));
    place.is_refused(&["run", "shaft.toml"], "a key of its own", ("shaft.toml:36:1", "its keys are between"));
}

/// What is fitted stands in the model that is written, for the machine's file is not the program's.
#[test]
fn a_fitted_joint_is_written_into_the_model() {
    let place = place();
    let drawing = model("slant-bed/lathe.toml");
    place.write("lathe.toml", drawing.replace("\"1500 kN*m/rad\"", "\"1500 +- 400 kN*m/rad\""));
    let fit = ["fit", "pushed.toml", "--with", "pushed.csv", "--add-to", "folder/fitted.toml"];
    let answer = place.fem(&fit);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let written = place.read("folder/fitted.toml");
    assert!(written.contains("machine = \"../lathe.toml\""), "{written}");
    let (_, joint) = written.split_once("[structure.tailstock-tilt]\nstiffness = \"").unwrap();
    let value: f64 = joint.split_whitespace().next().unwrap().parse().unwrap();
    // 600 kN m/rad were hidden.
    assert!((value - 600.0).abs() < 30.0, "{joint}");
    assert_eq!(place.fem(&["compare", "folder/fitted.toml", "--with", "pushed.csv"]).status, 0);
}

/// Both tests see one lathe, of which one joint is softer than its file says.
#[test]
fn the_joint_of_both_tests_is_one() {
    let place = place();
    let tests = ["shaft.toml", "--with", "shaft.csv", "pushed.toml", "--with", "pushed.csv"];
    let answer = place.fem(&[&["diagnose"][..], &tests].concat());
    assert_eq!(answer.status, 0, "{}", answer.err);
    insta::assert_snapshot!(answer.out);
}
