//! What controls cannot hold is refused, or told.

use super::axis::{Axis, axes};

fn refused(axis: &Axis, control: &str, controller: &str) -> String {
    axis.tried(control, controller).err().unwrap_or_else(|| panic!("{control} takes it"))
}

#[test]
fn a_control_that_counts_wants_its_points() {
    let axis = &axes()[0];
    for control in ["fanuc", "fanuc-bidirectional", "mitsubishi"] {
        assert!(refused(axis, control, "").contains("add `steps`"));
        let coarse = "[controller]\nsteps = { reference = \"0 mm\", interval = \"50 mm\" }\n";
        assert!(refused(axis, control, coarse).contains("`detection_unit`"));
    }
}

/// 3 um from point to point are 30 counts of 0.1 um; by five they are six, and six are held.
#[test]
fn increments_beyond_the_range_are_refused_with_what_would_do() {
    let axis = &axes()[0];
    let steps = |magnification: usize| {
        format!(
            "[controller]\nsteps = {{ reference = \"0 mm\", interval = \"50 mm\", detection_unit = \"0.1 um\", \
             magnification = {magnification} }}\n"
        )
    };
    let why = refused(axis, "fanuc", &steps(1));
    assert!(why.contains("30 counts") && why.contains("`magnification` of `steps` 5 at least"), "{why}");
    assert!(axis.tried("fanuc", &steps(5)).is_ok());
    // 60 halves are held without.
    assert!(axis.tried("mitsubishi", &steps(1)).is_ok());
}

#[test]
fn too_many_points_and_numbers_are_refused() {
    let axis = &axes()[0];
    let steps =
        |keys: &str| format!("[controller]\nsteps = {{ reference = \"0 mm\", detection_unit = \"1 um\", {keys} }}\n");
    let why = refused(axis, "fanuc", &steps("interval = \"4 mm\""));
    assert!(why.contains("151 points") && why.contains("4.688 mm at least"), "{why}");
    let why = refused(axis, "heidenhain", &steps("interval = \"2 mm\""));
    assert!(why.contains("301 points") && why.contains("256"), "{why}");
    let why = refused(axis, "fanuc", &steps("interval = \"50 mm\", number = 1020"));
    assert!(why.contains("1021 to 1032") && why.contains("`number`"), "{why}");
    // Number 0 at the reference point in the middle leaves none for what lies before it.
    let why = refused(&axes()[2], "fanuc", &steps("interval = \"40 mm\", number = 3"));
    assert!(why.contains("-11 to 3"), "{why}");
}

/// Targets at uneven distances are taken at points of equal distance, with what is missed.
#[test]
fn points_that_miss_the_targets_are_told() {
    let uneven = axes().pop().unwrap();
    // Of 7 mm each, 31 points meet all targets.
    let met = uneven.tried("heidenhain", "").unwrap();
    let note = met.notes.iter().find(|note| note.contains("entries")).unwrap();
    assert!(note.contains("31 points, every 7 mm from 0 to 210 mm, which miss them by 0.000 um"), "{note}");
    let missed =
        uneven.tried("siemens-cec", "[controller]\nsteps = { reference = \"0 mm\", interval = \"60 mm\" }\n").unwrap();
    let note = missed.notes.iter().find(|note| note.contains("entries")).unwrap();
    assert!(note.contains("5 points, every 60 mm from 0 to 240 mm"), "{note}");
    assert!(missed.left > 1e-3 && met.left < 2e-4, "{} and {}", missed.left, met.left);
}

/// Where nobody says where the reference point is, nothing is shifted, and that is told.
#[test]
fn a_reference_point_that_is_not_known_is_asked_for() {
    let axis = &axes()[1];
    let note = |controller: &str| {
        let files = axis.tried("siemens-eec", controller).unwrap();
        files.notes.iter().any(|note| note.contains("nothing should be added at the reference point"))
    };
    assert!(note("") && !note(&axis.counting()));
}
