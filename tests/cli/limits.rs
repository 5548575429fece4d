//! What no machine has, and names that the program needs itself: refused with the reason.

use super::fem::{Place, model};

/// The measured compliance of a lathe, changed, and what is said of it.
#[test]
fn compliances_that_nobody_can_have_measured_are_refused() {
    let place = Place::new();
    place.write("lathe.toml", model("measured-lathe.toml").replace("measured-lathe.csv", "own.csv"));
    // With an uncertainty of each.
    let uncertain =
        |(number, line): (usize, &str)| format!("{line},{}\n", if number == 0 { "u [um/kN]" } else { "0.3" });
    let own: String = model("measured-lathe.csv").lines().enumerate().map(uncertain).collect();
    place.write("own.csv", &own);
    let run = place.fem(&["run", "lathe.toml"]);
    assert_eq!(run.status, 0, "{}", run.err);
    for (text, message) in [
        (own.replacen(",0.3\n", ",0\n", 1), "an uncertainty is above zero"),
        (own.replacen(",0.3\n", ",-0.3\n", 1), "an uncertainty is above zero"),
        (own.replacen("tool,0,", "tool,-5,", 1), "and the shaft begins at 0"),
    ] {
        place.write("own.csv", text);
        place.is_refused(&["run", "lathe.toml"], message, (message, ""));
    }
}

#[test]
fn properties_below_absolute_zero_are_refused() {
    let place = Place::new();
    let record = "expansion = { file = \"expansion.csv\" }";
    let material = "{ base = \"steel\", expansion = { file = \"expansion.csv\" } }";
    place.write("rod.toml", model("thermal.toml").replacen("\"steel\"", material, 1));
    assert!(place.read("rod.toml").contains(record));
    place.write("expansion.csv", "temperature [degC],expansion [um/m/K]\n-400,10\n20,11\n100,12\n");
    place.is_refused(
        &["run", "rod.toml"],
        "-400 degC",
        ("`temperature` is below absolute zero: -400 degC", "its sign"),
    );
    // What is said of a good record is another thing.
    place.write("expansion.csv", "temperature [degC],expansion [um/m/K]\n-100,10\n20,11\n100,12\n");
    assert!(!place.fem(&["run", "rod.toml"]).err.contains("absolute zero"));
}

#[test]
fn files_that_the_program_needs_itself_are_no_results() {
    let place = Place::new();
    place.write("model.toml", model("stiffness.toml"));
    for name in [".fem-files.json", "out/.fem-files.json", "--output=.fem-study.json"] {
        let args =
            if name.starts_with('-') { vec!["run", "model.toml", name] } else { vec!["run", "model.toml", "-o", name] };
        place.is_refused(&args, name, ("in which the program keeps what it has written itself", "name another"));
    }
}

#[cfg(unix)]
#[test]
fn what_was_left_empty_is_renewed() {
    let place = Place::new();
    place.write("model.toml", model("stiffness.toml"));
    assert_eq!(place.fem(&["run", "model.toml", "-o", "out"]).status, 0);
    // A key that a full disk has left empty.
    std::fs::write(place.state().join("key"), "").unwrap();
    assert_eq!(place.fem(&["run", "model.toml", "-o", "other"]).status, 0);
    assert_eq!(std::fs::read(place.state().join("key")).unwrap().len(), 32);
    assert_eq!(place.fem(&["run", "model.toml", "-o", "other"]).status, 0);
    // Hidden folders without anything in them, one of long ago.
    let [old, new] =
        ["0123456789abcdef01234567", "0123456789abcdef01234568"].map(|digits| format!(".fem-{digits}.partial"));
    for (name, age) in [(&old, "2 hours ago"), (&new, "now")] {
        std::fs::create_dir(place.path(name)).unwrap();
        let touched = std::process::Command::new("touch").args(["-d", age]).arg(place.path(name)).status().unwrap();
        assert!(touched.success());
    }
    assert_eq!(place.fem(&["run", "model.toml", "-o", "third"]).status, 0);
    assert!(!place.path(&old).exists() && place.path(&new).exists());
}

/// Far more digits than anybody reads or knows.
#[test]
fn numbers_without_measure_have_exponents() {
    let place = Place::new();
    place.write("model.toml", model("stiffness.toml"));
    place.write(
        "m.csv",
        "force [N],displacement [um],u [um]\n100,1.3,1e-9\n300,3.7,1e-9\n500,6.2,1e-9\n900,11.3,1e-9\n",
    );
    for command in ["compare", "fit"] {
        let told = place.fem(&[command, "model.toml", "--with", "m.csv"]).out;
        let digits = told.split(|c: char| !c.is_ascii_digit()).map(str::len).max().unwrap_or(0);
        assert!(digits <= 13, "{told}");
    }
}
