//! The workbench as a person uses it, in a browser. Runs where `FEM_PAGE_PYTHON` names a Python with playwright and axe,
//! and a Chromium is installed; elsewhere it says that it did not. What must hold at once is said by the scripts
//! themselves, which end with a sentence where it does not; what they tell is judged here.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

/// What a part of a script tells of the page.
fn told(script: &str, part: &str) -> Option<Value> {
    let Ok(python) = std::env::var("FEM_PAGE_PYTHON") else {
        println!("no FEM_PAGE_PYTHON: not checked");
        return None;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/workbench").join(script);
    let mut command = Command::new(python);
    let told = command.arg("-B").arg(script).args([env!("CARGO_BIN_EXE_fem"), part]).output().unwrap();
    assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
    Some(serde_json::from_slice(&told.stdout).unwrap())
}

/// That errors of a model, µm as the page shows them, are those of the story.
fn fall(shown: &Value, expected: &[f64]) {
    let shown: Vec<f64> = shown.as_array().unwrap().iter().map(|own| own.as_f64().unwrap()).collect();
    // Three digits are shown.
    let is_same = |(shown, expected): (&f64, &f64)| (shown - expected).abs() < 0.005 * expected.max(1.0);
    assert!(shown.len() == expected.len() && shown.iter().zip(expected).all(is_same), "{shown:?}");
}

const STORY: [f64; 4] = [43.21, 8.79, 3.96, 0.90];

fn is_empty(seen: &Value, key: &str) {
    let count = seen[key].as_array().map(Vec::len).or_else(|| seen[key].as_object().map(serde_json::Map::len));
    assert_eq!(count, Some(0), "{key}: {:#}", seen[key]);
}

fn text<'v>(seen: &'v Value, key: &str) -> &'v str {
    seen[key].as_str().unwrap_or_else(|| panic!("{key}: {seen:#}"))
}

#[test]
fn the_story_is_taken_with_a_mouse_and_is_still_there_another_day() {
    let Some(seen) = told("loop.py", "mouse") else { return };
    fall(&seen["fallen"], &STORY);
    fall(&seen["undone"], &STORY[..3]);
    fall(&seen["again"], &STORY);
    fall(&seen["reloaded"], &STORY);
    fall(&seen["reopened"], &STORY[3..]);
    assert!(text(&seen, "verdict").contains("explains the measurements"), "{seen:#}");
    assert!(text(&seen, "corrected").contains("Offset of the programmed radius"), "{seen:#}");
    assert_eq!(seen["is_own_file_untouched"], true);
    assert_eq!(seen["names"], json!(["better.toml", "measured.csv", "rigid.toml"]));
}

#[test]
fn the_story_is_taken_by_keys_alone() {
    let Some(seen) = told("loop.py", "keys") else { return };
    fall(&seen["fallen"], &STORY);
    fall(&seen["undone"], &STORY[..3]);
    fall(&seen["again"], &STORY);
    fall(&seen["reloaded"], &STORY);
    fall(&seen["reopened"], &STORY[3..]);
    assert_eq!(seen["clicks"], 0);
}

#[test]
fn a_diagnosis_that_is_stopped_changes_nothing_and_another_can_begin() {
    let Some(seen) = told("loop.py", "stop") else { return };
    is_empty(&seen, "changed");
    assert_eq!(seen["is_off_meanwhile"], true);
}

#[test]
fn a_diagnosis_of_other_data_is_not_told_as_one_of_these() {
    let Some(seen) = told("loop.py", "overtaken") else { return };
    assert_eq!(seen["is_told_as_current"], false);
    assert_eq!(seen["redo"], "open measurements", "what was undone can no longer be done again");
}

#[test]
fn every_state_can_be_read_by_everyone_and_fits_a_phone() {
    let Some(seen) = told("looks.py", "looks") else { return };
    is_empty(&seen, "violations");
    is_empty(&seen, "wider");
    assert_eq!(seen["states"].as_array().unwrap().len(), 6);
}

#[test]
fn five_hundred_clicks_at_random_break_nothing_and_are_undone() {
    let Some(seen) = told("monkey.py", "clicks") else { return };
    is_empty(&seen, "trouble");
    is_empty(&seen, "differs");
    assert_eq!(seen["clicks"], 500);
    // It went about.
    assert!(seen["kinds"].as_u64().unwrap() > 60 && seen["undone"].as_u64().unwrap() > 20, "{seen:#}");
}

#[test]
fn what_was_saved_outlives_a_kill_and_the_page_says_what_became_of_it() {
    let Some(seen) = told("trouble.py", "killed") else { return };
    assert!(text(&seen, "lost").contains("The connection to fem is lost"), "{seen:#}");
    // Started again at the same port it has another token: the page cannot come back, and no longer says that it tries.
    assert!(seen["told"] != seen["lost"] && !text(&seen, "told").contains("tries again"), "{seen:#}");
    assert_eq!(seen["reopened"], "460 N");
    // What was not saved is offered, where the page says so.
    assert!(!text(&seen, "told").contains("offered") || seen["resumed"] == "480 N", "{seen:#}");
    assert!(seen["session"].is_null() || seen["resumed"] == "480 N", "{seen:#}");
    // Nothing half written stays; what is not saved yet is kept under a name of its own.
    for when in ["before", "after", "last"] {
        let mut names = seen["names"][when].as_array().unwrap().clone();
        names.retain(|name| name != ".fem-session.json");
        assert_eq!(names, ["measured.csv", "rigid.toml"], "{when}");
    }
}

#[test]
fn a_wire_that_is_cut_is_told_of_and_taken_up_again() {
    let _ = told("trouble.py", "cut");
}

#[test]
fn what_is_bad_is_told_at_its_place_and_nothing_is_lost() {
    let Some(seen) = told("trouble.py", "refused") else { return };
    is_empty(&seen, "lost");
    for (what, why) in [
        ("prose.txt", "no column holds what was observed"),
        ("empty.csv", "empty.csv"),
        ("large.csv", "too large"),
        ("huge.csv", "huge.csv"),
        ("450 mm", "measures a length, not a force"),
        ("stiffness.toml", "stiffness.toml is open"),
    ] {
        assert!(text(&seen["told"], what).contains(why), "{what}: {seen:#}");
    }
    // What is open is not blamed for what was to be opened beside it.
    assert!(!text(&seen["told"], "huge.csv").contains("measured.csv"), "{seen:#}");
}

#[test]
fn the_page_follows_its_file_and_keeps_what_was_while_that_is_wrong() {
    let Some(seen) = told("trouble.py", "edited") else { return };
    assert!(text(&seen, "told").contains("measures a length, not a force"), "{seen:#}");
}

#[test]
fn what_is_edited_on_both_sides_is_not_written_over_without_a_word() {
    let Some(seen) = told("trouble.py", "unsaved") else { return };
    assert!(seen["is_overwritten"] == false && !text(&seen, "told").is_empty(), "{seen:#}");
}

#[test]
fn a_file_that_is_gone_is_not_said_to_be_saved() {
    let Some(seen) = told("trouble.py", "gone") else { return };
    for what in ["emptied", "removed"] {
        let is_told = !text(&seen[what], "says").is_empty() || seen[what]["can_save"] == true;
        assert!(is_told && seen[what]["rows"] == 108, "{what}: {seen:#}");
    }
}

/// `docs/pictures/workbench-*.png`: taken by `tests/workbench/pictures.py FEM docs/pictures`. Browsers draw letters each in
/// their own way, so that only what must be there is held to it.
#[test]
fn the_pictures_of_the_book_are_taken() {
    let Ok(python) = std::env::var("FEM_PAGE_PYTHON") else { return };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let place = tempfile::tempdir().unwrap();
    let mut command = Command::new(python);
    let command = command.arg("-B").arg(root.join("tests/workbench/pictures.py"));
    let told = command.arg(env!("CARGO_BIN_EXE_fem")).arg(place.path()).output().unwrap();
    assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
    let page = std::fs::read_to_string(root.join("docs/workbench.md")).unwrap();
    for name in ["fails", "causes", "explained", "corrected"] {
        let name = format!("workbench-{name}.png");
        assert!(page.contains(&format!("(pictures/{name})")), "{name} is not on the page");
        for file in [place.path().join(&name), root.join("docs/pictures").join(&name)] {
            let bytes = std::fs::read(&file).unwrap();
            // Width and height stand behind the signature.
            assert_eq!(bytes[16..24], [0, 0, 5, 120, 0, 0, 3, 132], "{}", file.display());
            assert!(bytes.len() < 150_000, "{}: {} bytes", file.display(), bytes.len());
        }
    }
}

#[test]
fn a_newcomer_does_six_tasks_in_a_few_clicks() {
    for (part, most) in [("verdict", 3), ("causes", 4), ("headings", 12), ("sheet", 4), ("trial", 9), ("correction", 3)]
    {
        let Some(seen) = told("tasks.py", part) else { return };
        println!("{seen}");
        assert!(seen["clicks"].as_u64().is_some_and(|clicks| clicks <= most), "{part}: {seen:#}");
        match part {
            "causes" => fall(&json!([seen["left"]]), &STORY[3..]),
            "headings" => assert_eq!(seen["columns"].as_array().unwrap().len(), 4),
            "sheet" => {
                assert_eq!(seen["rows"], 108);
                let commands = text(&seen, "commands");
                assert!(commands.contains("--sheet Shafts") && commands.contains("--header 2"), "{seen:#}");
            }
            "trial" => assert!(seen["used"] != seen["before"] && seen["undone"] == seen["before"], "{seen:#}"),
            "correction" => assert!(seen["names"].as_array().unwrap().len() > 2, "{seen:#}"),
            _ => assert!(text(&seen, "told").contains("does not explain"), "{seen:#}"),
        }
    }
}
