//! The files of a run, and what happens when they cannot be written.

use std::process::Stdio;

use super::fem::{Place, answer, model};

#[test]
fn a_run_writes_its_files_and_no_others() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml").replace("positions = 101", "positions = 4"));
    assert_eq!(place.fem(&["run", "lathe.toml", "-o", "results"]).status, 0);
    let frame = |i: u32| [format!("shaft_{i:04}.vtu"), format!("shaft-magnified_{i:04}.vtp")];
    let series = ["shaft.pvd", "shaft-magnified.pvd", "view.py"];
    let mut expected: Vec<String> = [
        ".fem-files.json",
        "bands.csv",
        "compliance.csv",
        "profile.csv",
        "summary.json",
        "machine.svg",
        "map.svg",
        "parts.svg",
        "profile.svg",
    ]
    .into_iter()
    .chain(series)
    .map(String::from)
    .chain((0..4).flat_map(frame).map(|name| format!("shaft/{name}")))
    .map(|name| format!("results/{name}"))
    .chain(["lathe.toml".to_string()])
    .collect();
    expected.sort();
    assert_eq!(place.files(), expected);
    // A shorter run takes the frames of a longer one away.
    place.write("lathe.toml", model("lathe.toml").replace("positions = 101", "positions = 2"));
    assert_eq!(place.fem(&["run", "lathe.toml", "-o", "results"]).status, 0);
    assert!(!place.files().iter().any(|f| f.contains("_0002") || f.contains("partial")));
}

#[test]
fn the_profile_reads_back_and_agrees_with_the_summary() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    assert_eq!(place.fem(&["run", "lathe.toml"]).status, 0);
    let mut reader = csv::Reader::from_path(place.path("out/lathe/profile.csv")).unwrap();
    let headers = reader.headers().unwrap().clone();
    assert_eq!(headers.iter().take(2).collect::<Vec<_>>(), ["part", "x [mm]"]);
    let error = headers.iter().position(|h| h == "diameter_error [um]").unwrap();
    let rows: Vec<f64> = reader.records().map(|r| r.unwrap()[error].parse().unwrap()).collect();
    assert_eq!(rows.len(), 12 * 101);
    let summary: serde_json::Value = serde_json::from_str(&place.read("out/lathe/summary.json")).unwrap();
    let largest = rows.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    assert_eq!(summary["findings"]["largest"]["value"].as_f64(), Some(largest));
}

#[test]
fn a_place_that_cannot_be_written_is_told() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    place.write("file", "in the way");
    for directory in ["file", "file/below", "/proc/none"] {
        let run = place.fem(&["run", "lathe.toml", "-o", directory]);
        assert_eq!(run.status, 1, "{directory}");
        assert!(run.err.contains("cannot be written") && run.err.contains("help:"), "{}", run.err);
    }
    assert_eq!(place.read("file"), "in the way");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = place.command(&["effects"]).stdout(Stdio::from(full)).stderr(Stdio::piped()).output().unwrap();
    let told = answer(output);
    assert_eq!(told.status, 1);
    assert!(told.err.contains("No space left"), "{}", told.err);
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let place = Place::new();
    let mut child =
        place.command(&["effects", "--json"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
}

#[test]
fn files_of_the_user_stay_where_frames_are_written() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml").replace("positions = 101", "positions = 2"));
    std::fs::create_dir_all(place.path("results/shaft")).unwrap();
    for name in ["my_scan.vtu", "shaft_scan.vtu", "shaft_0007.vtu"] {
        place.write(&format!("results/shaft/{name}"), "mine");
    }
    assert_eq!(place.fem(&["run", "lathe.toml", "-o", "results"]).status, 0);
    for name in ["my_scan.vtu", "shaft_scan.vtu", "shaft_0007.vtu"] {
        assert_eq!(place.read(&format!("results/shaft/{name}")), "mine", "{name}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_error_that_cannot_be_told_is_no_panic() {
    let place = Place::new();
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = place.command(&["run", "missing.toml"]).stderr(Stdio::from(full)).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn a_model_named_by_dots_has_its_files_in_the_folder() {
    let place = Place::new();
    place.write("m.csv", model("story/measured.csv"));
    for name in ["...toml", "other.toml"] {
        place.write(name, model("story/rigid.toml"));
    }
    let answer = place.fem(&["compare", "...toml", "other.toml", "--with", "m.csv", "-o", "made"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(place.path("made/model/residuals.csv").exists() && !place.path("residuals.csv").exists());
}

#[cfg(unix)]
#[test]
fn results_in_a_folder_of_another_group_are_replaced_and_keep_theirs() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
    let place = Place::new();
    place.write("m.toml", model("stiffness.toml"));
    let run = || place.fem(&["run", "m.toml", "-o", "out"]);
    assert_eq!(run().status, 0);
    // Who may not give a folder to a group has no such folder either.
    if chown(place.path("out"), None, Some(4321)).is_err() {
        return;
    }
    std::fs::set_permissions(place.path("out"), std::fs::Permissions::from_mode(0o2770)).unwrap();
    let before = std::fs::metadata(place.path("out/profile.csv")).unwrap().gid();
    let answer = run();
    assert_eq!(answer.status, 0, "{}", answer.err);
    let group = |name: &str| std::fs::metadata(place.path(name)).unwrap().gid();
    assert_eq!((group("out"), group("out/profile.csv")), (4321, before));
}
