//! What VTK itself makes of the written shapes. Runs where a Python with VTK is named in `FEM_VTK_PYTHON`
//! or is `python3`; elsewhere it says that it did not.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;
use std::process::Command;

/// A Python that can import VTK's XML readers.
fn python() -> Option<String> {
    let candidates = std::env::var("FEM_VTK_PYTHON").into_iter().chain(["python3".to_string()]);
    candidates.into_iter().find(|python| {
        let probe = Command::new(python).args(["-c", "import vtkmodules.vtkIOXML"]).output();
        probe.is_ok_and(|o| o.status.success())
    })
}

/// What VTK sees of a run of a model that comes with the program.
fn seen(python: &str, model: &str, series: &str) -> serde_json::Value {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let place = tempfile::tempdir().unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_fem"))
        .args(["run", root.join("models").join(model).to_str().unwrap(), "--json", "-o"])
        .arg(place.path())
        .output()
        .unwrap();
    assert!(run.status.success());
    let read =
        Command::new(python).arg(root.join("tests/vtk/read_pvd.py")).arg(place.path().join(series)).output().unwrap();
    assert!(read.status.success(), "{}", String::from_utf8_lossy(&read.stderr));
    serde_json::from_slice(&read.stdout).unwrap()
}

#[test]
fn vtk_plays_the_ring_clamped_bored_and_released() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    let seen = seen(&python, "ring.toml", "ring.pvd");
    assert_eq!(seen["frames"], 10);
    let first = &seen["steps"][0];
    // 360 × 6 elements: (3·6 + 2)·360 nodes, and three jaws.
    assert_eq!((first["points"].as_u64(), first["cells"].as_u64()), (Some(7203), Some(2163)));
    let largest = |step: usize, field: &str| seen["steps"][step]["point_fields"][field]["range"][1].as_f64().unwrap();
    // Clamped: stressed and moved. Released: free of stress, and what was bored stays.
    assert!(largest(3, "equivalent_stress") > 50e6 && largest(0, "displacement") == 0.0);
    assert!(largest(9, "equivalent_stress") == 0.0);
    // Near θ = 0 the bore stands out most: by what the model's header states, and by the mean that the
    // least-squares circle took out of it, 1.946 um (Lame) for jaws that press with 2894.7 of 3000 N while
    // boring.
    let expected = 28.034 + 1.946 * 2894.7 / 3000.0;
    assert!((1e6 * largest(9, "displacement") - expected).abs() < 0.02, "{}", 1e6 * largest(9, "displacement"));
}

#[test]
fn vtk_reads_every_frame_of_a_run() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    let seen = seen(&python, "lathe.toml", "shaft.pvd");
    assert_eq!(seen["frames"], 101);
    let first = &seen["steps"][0];
    // 121 nodes and 120 elements of 5 mm, two supports and the tool.
    assert_eq!((first["points"].as_u64(), first["cells"].as_u64()), (Some(124), Some(123)));
    let largest = |step: usize, field: &str| seen["steps"][step]["point_fields"][field]["range"][1].as_f64().unwrap();
    // At the tailstock end of the pass the shaft itself is straight: the tailstock gives way by 450/40 +
    // 0.2·√450 um.
    let expected = 1e-6 * (450.0 / 40.0 + 0.2 * 450f64.sqrt());
    assert!((largest(0, "displacement") / expected - 1.0).abs() < 1e-12);
    let bending = 450.0 * 0.6 / 4.0;
    assert!((largest(50, "bending_moment") - bending).abs() < 1e-9);
    // Statically determinate: the stress is M·D/2I in the middle, where the diameter is 50 mm.
    let stress = bending * 0.025 / (std::f64::consts::PI * 0.05f64.powi(4) / 64.0);
    assert!(largest(50, "bending_stress") >= stress * (1.0 - 1e-12));
    assert!((largest(50, "force") - 450.0).abs() < 1e-9, "the tool's force");
}
