//! A run appears as one, whatever happens to it, and replaces nothing that the program did not write.

use std::collections::BTreeMap;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use super::fem::{Place, model};

/// Two models with seven places and frames, and with five.
fn two_models(place: &Place) {
    for (name, positions) in [("long.toml", 7), ("short.toml", 5)] {
        let text = model("lathe.toml").replace("positions = 101", &format!("positions = {positions}"));
        place.write(name, text.replace("parts = 12", "parts = 7"));
    }
}

fn begin(place: &Place, model: &str, folder: &str) -> Child {
    let mut command = place.command(&["run", model, "-o", folder]);
    command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

/// The number of places of a run, if all of its files agree in it.
fn places(place: &Place, folder: &str) -> Option<usize> {
    let rows = place.read(&format!("{folder}/profile.csv")).lines().count() - 1;
    let named = place.read(&format!("{folder}/shaft.pvd")).matches("<DataSet").count();
    let list = || std::fs::read_dir(place.path(&format!("{folder}/shaft"))).unwrap();
    let [frames, magnified] =
        ["vtu", "vtp"].map(|end| list().filter(|f| f.as_ref().unwrap().path().extension().unwrap() == end).count());
    let table = place.read(&format!("{folder}/compliance.csv")).lines().count() - 1;
    let summary: serde_json::Value =
        serde_json::from_str(&place.read(&format!("{folder}/summary.json"))).expect("a whole summary");
    assert!(summary["findings"].is_object());
    (rows == 7 * named && frames == named && magnified == named && table == named).then_some(named)
}

fn leftovers(place: &Place) -> Vec<String> {
    place.files().into_iter().filter(|f| f.contains(".partial")).collect()
}

/// Kills runs into a folder at moments all over their time, and looks at the folder after each.
fn killed(folder: &str, times: u32) {
    let place = Place::new();
    two_models(&place);
    place.write("notes.txt", "mine");
    let start = Instant::now();
    assert_eq!(place.fem(&["run", "long.toml", "-o", folder]).status, 0);
    let whole = start.elapsed();
    for i in 0..times {
        let mut child = begin(&place, if i % 2 == 0 { "short.toml" } else { "long.toml" }, folder);
        // Golden sections of the later half of a run visit every moment of it; some runs come to their end.
        let part = 0.4 + 0.7 * (f64::from(i) * 0.618_034).fract();
        std::thread::sleep(whole.mul_f64(part).min(Duration::from_millis(500)));
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(places(&place, folder).is_some(), "a mixture after kill {i}: {:?}", place.files());
    }
    assert_eq!(place.fem(&["run", "long.toml", "-o", folder]).status, 0);
    assert_eq!((places(&place, folder), leftovers(&place)), (Some(7), vec![]));
    assert_eq!(place.read("notes.txt"), "mine");
}

#[cfg(target_os = "linux")]
#[test]
fn a_run_that_is_killed_leaves_the_old_files_or_the_new_ones() {
    killed("out", 100);
}

#[cfg(target_os = "linux")]
#[test]
fn two_runs_into_one_folder_leave_the_files_of_one() {
    let place = Place::new();
    two_models(&place);
    for round in 0..12 {
        // Both where the folder is there and where it is not.
        if round % 3 == 0 {
            std::fs::remove_dir_all(place.path("out")).ok();
        }
        for child in [begin(&place, "long.toml", "out"), begin(&place, "short.toml", "out")] {
            let output = child.wait_with_output().unwrap();
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        }
        assert!(places(&place, "out").is_some(), "{:?}", place.files());
        assert_eq!(leftovers(&place), [""; 0]);
    }
}

#[test]
fn what_belongs_to_others_stays_where_it_is() {
    let place = Place::new();
    two_models(&place);
    std::fs::create_dir_all(place.path("out/deep/er")).unwrap();
    std::fs::create_dir_all(place.path("out/shaft")).unwrap();
    for name in ["out/notes.txt", "out/deep/er/scan.vtu", "out/shaft/scan.vtu"] {
        place.write(name, "mine");
    }
    for model in ["long.toml", "short.toml"] {
        assert_eq!(place.fem(&["run", model, "-o", "out"]).status, 0);
        for name in ["out/notes.txt", "out/deep/er/scan.vtu", "out/shaft/scan.vtu"] {
            assert_eq!(place.read(name), "mine", "{name}");
        }
    }
    let files = place.files();
    assert!(
        files.iter().any(|f| f.ends_with("shaft_0004.vtu")) && !files.iter().any(|f| f.ends_with("shaft_0005.vtu"))
    );
    // Results of another command stand beside these.
    place.write("measured.csv", "part,x [mm],diameter_error [um]\n1,100,3\n1,200,4\n1,300,5\n");
    assert_eq!(place.fem(&["compare", "long.toml", "--with", "measured.csv", "-o", "out"]).status, 0);
    assert_eq!(place.fem(&["run", "long.toml", "-o", "out"]).status, 0);
    assert!(place.path("out/residuals.csv").exists() && place.path("out/shaft/shaft_0006.vtu").exists());
}

#[test]
fn files_of_a_user_are_replaced_only_by_force() {
    let place = Place::new();
    two_models(&place);
    place.write("profile.csv", "mine");
    for folder in [".", "./", "../"] {
        std::fs::create_dir_all(place.path("below")).unwrap();
        let mut command = place.command(&[]);
        if folder == "../" {
            command.current_dir(place.path("below")).args(["run", "../long.toml", "-o", ".."]);
        } else {
            command.args(["run", "long.toml", "-o", folder]);
        }
        let answer = super::fem::answer(command.output().unwrap());
        assert_eq!(answer.status, 2, "{folder}: {}", answer.out);
        assert!(
            answer.err.contains("profile.csv is there already") && answer.err.contains("--force"),
            "{}",
            answer.err
        );
        assert_eq!(place.read("profile.csv"), "mine");
        assert!(!place.path("summary.json").exists() && leftovers(&place).is_empty(), "{:?}", place.files());
    }
    assert_eq!(place.fem(&["run", "long.toml", "-o", ".", "--force"]).status, 0);
    assert!(place.read("profile.csv").starts_with("part,x [mm]"));
    // Its own it replaces, and what a user has made of them it does not.
    assert_eq!(place.fem(&["run", "short.toml", "-o", "."]).status, 0);
    assert_eq!(places(&place, "."), Some(5));
    let changed = place.read("profile.csv") + "8,1,2\n";
    place.write("profile.csv", &changed);
    assert_eq!(place.fem(&["run", "long.toml", "-o", "."]).status, 2);
    assert_eq!((place.read("profile.csv"), place.read("summary.json").is_empty()), (changed, false));
}

#[test]
fn models_and_measurements_are_replaced_only_by_force() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    place.write("free.toml", model("story/rigid.toml") + "\n[effects.carriage-compliance]\nstiffness = \"? N/um\"\n");
    place.write("measured.csv", model("story/measured.csv"));
    let commands: &[&[&str]] = &[
        &["add", "lathe.toml", "guideway-taper", "slope=3 um/m", "-o", "TO"],
        &["set", "lathe.toml", "cut.depth=1 mm", "-o", "TO"],
        &["fit", "free.toml", "--with", "measured.csv", "--add-to", "TO"],
        &["diagnose", "free.toml", "--with", "measured.csv", "--max-effects", "1", "--add-to", "TO"],
        &["import", "measured.csv", "--process", "turning", "-o", "TO"],
    ];
    for command in commands {
        place.write("other.toml", "mine");
        let args: Vec<&str> = command.iter().map(|word| if *word == "TO" { "other.toml" } else { word }).collect();
        let answer = place.fem(&args);
        assert_eq!((answer.status, place.read("other.toml").as_str()), (2, "mine"), "{command:?}: {}", answer.err);
        assert!(answer.err.contains("other.toml is there already") && answer.err.contains("--force"), "{}", answer.err);
        assert!(!answer.err.contains("changed since"), "{}", answer.err);
        if command[0] != "diagnose" {
            let answer = place.fem(&[&args[..], &["--force"]].concat());
            assert_eq!(answer.status, 0, "{command:?}: {}", answer.err);
            assert_ne!(place.read("other.toml"), "mine");
        }
    }
    // Force does not reach what is read.
    let own = ["add", "lathe.toml", "guideway-taper", "slope=3 um/m", "-o", "lathe.toml", "--force"];
    assert_eq!((place.fem(&own).status, place.read("lathe.toml")), (2, model("lathe.toml")));
}

#[test]
fn two_files_of_one_command_have_two_places() {
    let place = Place::new();
    place.write("rigid.toml", model("story/rigid.toml"));
    place.write("measured.csv", model("story/measured.csv"));
    for (new, rows) in [("both.csv", "./both.csv"), ("next.toml", "next.csv")] {
        let args = ["diagnose", "rigid.toml", "--with", "measured.csv", "--add-to", new, "--next", rows];
        let refused = place.fem(&args);
        assert!(refused.status == 2 && refused.err.contains("would both write"), "{}", refused.err);
    }
    assert_eq!(place.files(), ["measured.csv", "rigid.toml"]);
}

/// A note of a hidden folder in the state folder, as a run makes it, with the files that go from there into `folder`.
#[cfg(unix)]
fn note(place: &Place, name: &str, hidden: &str, placing: Option<serde_json::Value>) -> std::path::PathBuf {
    let host = String::from_utf8(std::process::Command::new("uname").arg("-n").output().unwrap().stdout).unwrap();
    let hidden = place.path(hidden);
    let begun = serde_json::json!({ "schema": "fem-work/1", "host": host.trim(), "hidden": hidden });
    let works = place.state().join("works");
    std::fs::create_dir_all(&works).unwrap();
    let path = works.join(name);
    std::fs::write(&path, format!("{begun}\n{}", placing.map_or(String::new(), |p| format!("{p}\n")))).unwrap();
    path
}

#[cfg(unix)]
#[test]
fn what_dead_runs_left_is_swept_and_what_lives_is_not() {
    let place = Place::new();
    two_models(&place);
    let folders = [
        ".fem-aaaaaaaaaaaaaaaaaaaaaaaa.partial",
        ".fem-bbbbbbbbbbbbbbbbbbbbbbbb.partial",
        "out/.fem-cccccccccccccccccccccccc.partial",
        ".fem-1-0.partial",
        ".fem-x",
    ];
    for name in folders {
        std::fs::create_dir_all(place.path(name)).unwrap();
        place.write(&format!("{name}/profile.csv"), "half");
    }
    let notes: Vec<_> =
        folders[..3].iter().enumerate().map(|(i, name)| note(&place, &format!("{i}.jsonl"), name, None)).collect();
    let alive = std::fs::File::open(&notes[1]).unwrap();
    alive.lock().unwrap();
    assert_eq!(place.fem(&["run", "long.toml", "-o", "out"]).status, 0);
    // What nobody has noted may be anybody's.
    assert_eq!(folders.map(|name| place.path(name).exists()), [false, true, false, true, true]);
    assert_eq!(notes.iter().map(|note| note.exists()).collect::<Vec<_>>(), [false, true, false]);
}

#[cfg(unix)]
#[test]
fn a_run_that_died_between_two_files_is_brought_to_its_end() {
    // Where folders cannot be exchanged, files go into place one by one.
    let place = Place::new();
    two_models(&place);
    for (model, folder) in [("short.toml", "short"), ("long.toml", "out")] {
        assert_eq!(place.fem(&["run", model, "-o", folder]).status, 0);
    }
    let list = |folder: &str| -> BTreeMap<String, serde_json::Value> {
        let list: serde_json::Value = serde_json::from_str(&place.read(&format!("{folder}/.fem-files.json"))).unwrap();
        let own = |e: &serde_json::Value| (e["name"].as_str().unwrap().to_string(), e.clone());
        list["files"].as_array().unwrap().iter().map(own).collect()
    };
    let (new, mut old) = (list("short"), list("out"));
    let whole = |folder: &str| {
        let name = format!("{folder}/.fem-files.json");
        let (bytes, sha256) = (place.read(&name).len(), place.sha256(&name));
        serde_json::json!({ "name": ".fem-files.json", "of": "", "bytes": bytes, "sha256": sha256 })
    };
    let last = serde_json::json!({ "new": whole("short"), "over": whole("out") });
    let moves: Vec<_> =
        new.iter().map(|(name, e)| serde_json::json!({ "new": e, "over": old.remove(name) })).chain([last]).collect();
    let placing = serde_json::json!({
        "folder": place.path("out").canonicalize().unwrap(), "moves": moves, "leave": old.values().collect::<Vec<_>>()
    });
    std::fs::rename(place.path("short"), place.path("out/.fem-aaaaaaaaaaaaaaaaaaaaaaaa.partial")).unwrap();
    note(&place, "a.jsonl", "out/.fem-aaaaaaaaaaaaaaaaaaaaaaaa.partial", Some(placing.clone()));
    // The first file has gone into place, and another one was changed by its user since.
    std::fs::rename(place.path("out/.fem-aaaaaaaaaaaaaaaaaaaaaaaa.partial/profile.csv"), place.path("out/profile.csv"))
        .unwrap();
    place.write("out/map.svg", "mine");
    assert_eq!(places(&place, "out"), None);
    // Whatever writes next ends it, here another command into another folder.
    place.write("measured.csv", "part,x [mm],diameter_error [um]\n1,100,3\n1,200,4\n1,300,5\n");
    assert_eq!(place.fem(&["compare", "long.toml", "--with", "measured.csv", "-o", "other"]).status, 0);
    assert_eq!((places(&place, "out"), leftovers(&place)), (Some(5), vec![]));
    assert_eq!(place.read("out/map.svg"), "mine");
}
