//! The rows to measure next: written to be filled in, with the model that has them, and diagnosed with the others.

use super::fem::{Answer, model};
use super::tailstock::place;

const DIAGNOSE: [&str; 6] = ["diagnose", "shafts.toml", "--with", "shafts.csv", "--next", "next.csv"];

#[test]
fn rows_are_written_filled_in_and_read_with_those_there_are() {
    let place = place();
    let Answer { status, err, out } = place.fem(&[&DIAGNOSE[..], &["--json"]].concat());
    assert_eq!(status, 0, "{err}");
    assert!(err.contains("fem diagnose next.toml --with shafts.csv --with next.csv"), "{err}");
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    let next = &json["next_measurement"];
    let rows = place.read("next.csv");
    let mut lines = rows.lines();
    assert_eq!(lines.next().unwrap(), format!("# {}", next["text"].as_str().unwrap()));
    assert_eq!(lines.next().unwrap(), "x [mm],part,radial_force [N],diameter_error [um],u [um]");
    assert_eq!(Some(lines.count() as u64), next["observations"].as_u64());
    // The three shafts are all that the batch had, and each experiment of the sequence turns one more.
    assert!(next["steps"] == 2 && next["minutes"].as_f64().unwrap() > 0.0);
    assert!(place.read("next.toml").contains("parts = 5") && place.read("shafts.toml").contains("parts = 3"));
    let empty = place.fem(&["diagnose", "next.toml", "--with", "next.csv"]);
    assert!(empty.status == 2 && empty.err.contains("empty cell"), "{}", empty.err);
    place.write("next.csv", rows.replace(",,", ",1.5,"));
    let again = place.fem(&["compare", "next.toml", "--with", "shafts.csv", "--with", "next.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&again.out).unwrap();
    let first = model("tailstock/shafts.csv").lines().filter(|line| line.starts_with(char::is_numeric)).count() as u64;
    assert_eq!(json["observations"].as_u64(), Some(first + next["observations"].as_u64().unwrap()), "{}", again.err);
}

#[test]
fn nothing_of_the_users_is_replaced() {
    let place = place();
    for taken in ["next.csv", "next.toml"] {
        place.write(taken, "mine");
        let Answer { status, err, .. } = place.fem(&DIAGNOSE);
        assert!(status == 2 && err.contains(taken) && err.contains("--force"), "{status} {err}");
        assert_eq!(place.read(taken), "mine");
        std::fs::remove_file(place.path(taken)).unwrap();
    }
    assert!(!place.path("next.csv").exists(), "rows without their model");
}

#[test]
fn several_tests_are_refused() {
    let both = ["tailstock.toml", "--with", "tailstock.csv"];
    let Answer { status, err, .. } = place().fem(&[&DIAGNOSE[..], &both].concat());
    assert!(status == 2 && err.contains("--next writes rows of one test") && err.contains("leave it out"), "{err}");
}
