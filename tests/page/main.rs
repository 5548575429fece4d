//! What a browser makes of the page of `fem report`. Runs where `FEM_PAGE_PYTHON` names a Python with playwright and
//! axe, and a Chromium is installed; elsewhere it says that it did not.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// The page that a report writes, and what a browser says of it.
fn seen(args: &[&str]) -> Option<(String, Value)> {
    let Ok(python) = std::env::var("FEM_PAGE_PYTHON") else {
        println!("no FEM_PAGE_PYTHON: not checked");
        return None;
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let place = tempfile::tempdir().unwrap();
    let page = place.path().join("report.html");
    let mut report = Command::new(env!("CARGO_BIN_EXE_fem"));
    let report = report.arg("report").args(args).arg("-o").arg(&page).current_dir(root).output().unwrap();
    assert!(report.status.success(), "{}", String::from_utf8_lossy(&report.stderr));
    let mut look = Command::new(python);
    look.arg(root.join("tests/page/look.py")).arg(&page);
    if let Ok(shots) = std::env::var("FEM_PAGE_SHOTS") {
        look.arg(shots);
    }
    let look = look.output().unwrap();
    assert!(look.status.success(), "{}", String::from_utf8_lossy(&look.stderr));
    Some((std::fs::read_to_string(&page).unwrap(), serde_json::from_slice(&look.stdout).unwrap()))
}

fn texts(value: &Value) -> Vec<String> {
    value.as_array().unwrap().iter().map(|v| v.as_str().unwrap().to_string()).collect()
}

/// What must hold of every page.
fn is_sound(page: &str, seen: &Value) {
    for key in ["trouble", "requests", "violations"] {
        assert!(seen[key].as_array().unwrap().is_empty(), "{key}: {:#}", seen[key]);
    }
    assert!(page.len() < 1_000_000, "{} bytes", page.len());
    for look in ["light", "dark", "phone"] {
        assert!(seen["overflow"][look].as_i64().unwrap() <= 0, "{look} is wider than its window");
    }
    for key in ["away", "zoomed", "unzoomed", "printed_steps", "plain_steps"] {
        assert_eq!(seen[key], true, "{key}: {seen:#}");
    }
    assert!(!seen["key"].as_str().unwrap().is_empty());
    assert!(seen["plain_figures"].as_u64().unwrap() > 2);
    let (before, mut sorted) = (texts(&seen["unsorted"]), texts(&seen["sorted"]));
    assert_ne!(before, sorted);
    assert!(sorted.is_sorted(), "{sorted:?}");
    let mut before = before;
    before.sort();
    sorted.sort();
    assert_eq!(before, sorted);
    assert!(seen["SVG"].as_str().unwrap().contains("<style") && seen["SVG"].as_str().unwrap().starts_with("<svg"));
}

#[test]
fn a_diagnosis_can_be_read_asked_and_printed() {
    let args = ["models/story/rigid.toml", "--with", "models/story/measured.csv"];
    let Some((page, seen)) = seen(&args) else { return };
    is_sound(&page, &seen);
    // The mark asked for is that of the straight line, or of a row: both name their axes with units.
    let hover = seen["hover"].as_str().unwrap();
    assert!(hover.contains("predicted diameter error = ") && hover.contains(" um"), "{hover}");
    assert_eq!(seen["first_step"], serde_json::json!([true, false, false, false]));
    assert_eq!(seen["last_step"], serde_json::json!([false, false, false, true]));
    assert_eq!(seen["step_label"], "+ guideway-wear: 0.896 um");
    assert!(
        seen["plain_verdict"].as_str().unwrap().contains("Missing: tool-wear, headstock-compliance, guideway-wear")
    );
    // A heading, the two ends of the line, and a row of the file each.
    let csv = seen["CSV"].as_str().unwrap();
    assert!(csv.starts_with("series,predicted diameter error [um],measured diameter error [um]"), "{csv}");
    assert_eq!(csv.lines().count(), 1 + 2 + 108);
}

#[test]
fn a_prediction_has_a_page_too() {
    let Some((page, seen)) = seen(&["models/lathe.toml"]) else { return };
    is_sound(&page, &seen);
    assert!(
        seen["plain_verdict"].as_str().unwrap().contains("+173.587 \u{b5}m at x = 312.0 mm on part 12"),
        "{seen:#}"
    );
}
