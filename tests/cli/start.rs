//! The first minute: `fem` alone, `fem new`, `fem demo`.

use super::fem::{Place, model};

#[test]
fn fem_alone_says_what_to_do_next() {
    let place = Place::new();
    let empty = place.fem(&[]);
    assert_eq!(empty.status, 0);
    assert!(empty.out.contains("fem demo") && empty.out.contains("fem new turning -o model.toml"), "{}", empty.out);
    // A TOML file that is no model is none to run.
    place.write("Cargo.toml", "[package]\nname = \"x\"\n");
    assert!(place.fem(&[]).out.contains("fem demo"));
    place.write("b.toml", model("story/rigid.toml"));
    assert!(place.fem(&[]).out.contains("fem run b.toml "));
    place.write("it's.csv", model("story/measured.csv"));
    let out = place.fem(&[]).out;
    assert!(out.contains("fem diagnose b.toml --with './it'\\''s.csv'"), "{out}");
}

#[test]
fn new_without_a_process_explains() {
    let answer = Place::new().fem(&["new"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    for process in fem::processes::ALL {
        assert!(answer.out.contains(process.about()), "{}", process.name());
    }
    assert!(answer.out.contains("fem new turning -o model.toml"));
}

#[test]
fn the_commands_of_the_demo_tell_the_story() {
    let place = Place::new();
    let told = place.fem(&["demo", "here"]);
    assert_eq!(told.status, 0, "{}", told.err);
    let commands: Vec<&str> = told.out.lines().filter_map(|l| l.strip_prefix("  fem ")).collect();
    assert_eq!(commands.len(), 7, "{}", told.out);
    let (mut explained, mut corrected) = (String::new(), String::new());
    for command in commands {
        let words: Vec<&str> = command.split("  ").next().unwrap().split_whitespace().collect();
        let mut fem = place.command(&words);
        let output = fem.current_dir(place.path("here")).output().unwrap();
        assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
        let out = String::from_utf8(output.stdout).unwrap();
        if command.starts_with("compare rigid.toml better.toml") {
            explained = out;
        } else if command.contains("corrected.csv") {
            corrected = out;
        }
    }
    assert!(explained.contains("adequate: nothing is left but the noise"), "{explained}");
    assert!(corrected.contains("adequate: nothing is left but the noise"), "{corrected}");
    assert!(corrected.contains("um, within"), "{corrected}");
    assert!(place.read("here/report.html").contains("headstock-compliance"));
    // A second time nothing is written over.
    let again = place.fem(&["demo", "here"]);
    assert!(again.status == 2 && again.err.contains("exists already"), "{}", again.err);
}
