//! What VTK itself makes of the written shapes. Runs where a Python with VTK is named in `FEM_VTK_PYTHON`
//! or is `python3`; elsewhere it says that it did not.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;
use std::process::Command;

use fem::output::vtk::vtu;
use fem::process::{Cell, Field, Grid};
use fem::units::NUMBER;

/// A Python that can import VTK's XML readers.
fn python() -> Option<String> {
    let candidates = std::env::var("FEM_VTK_PYTHON").into_iter().chain(["python3".to_string()]);
    candidates.into_iter().find(|python| {
        let probe = Command::new(python).args(["-c", "import vtkmodules.vtkIOXML"]).output();
        probe.is_ok_and(|o| o.status.success())
    })
}

/// A run of a model that comes with the program, in a folder of its own.
fn run(model: &str) -> tempfile::TempDir {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let place = tempfile::tempdir().unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_fem"))
        .args(["run", root.join("models").join(model).to_str().unwrap(), "--json", "-o"])
        .arg(place.path())
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    place
}

/// What a script of this folder prints of a file.
fn read(python: &str, script: &str, file: &Path) -> serde_json::Value {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/vtk").join(script);
    let read = Command::new(python).arg(script).arg(file).output().unwrap();
    assert!(read.status.success(), "{}: {}", file.display(), String::from_utf8_lossy(&read.stderr));
    serde_json::from_slice(&read.stdout).unwrap()
}

/// What VTK sees of a run of a model that comes with the program.
fn seen(python: &str, model: &str, series: &str) -> serde_json::Value {
    let place = run(model);
    read(python, "read_pvd.py", &place.path().join(series))
}

#[test]
fn vtk_plays_the_ring_clamped_bored_and_released() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    let seen = seen(&python, "ring.toml", "ring.pvd");
    // Six steps of each phase, and the beginning.
    assert_eq!(seen["frames"], 19);
    let first = &seen["steps"][0];
    // 360 × 6 elements: (3·6 + 2)·360 nodes, and three jaws, each a body of 8 corners and the middles of its ends:
    // 4 sides and 2·4 triangles.
    assert_eq!((first["points"].as_u64(), first["cells"].as_u64()), (Some(7203 + 30), Some(2163 + 36)));
    let largest = |step: usize, field: &str| seen["steps"][step]["point_fields"][field]["range"][1].as_f64().unwrap();
    // Clamped: stressed and moved. Released: free of stress, and what was bored stays.
    assert!(largest(6, "equivalent_stress") > 50e6 && largest(0, "displacement") == 0.0);
    assert!(largest(18, "equivalent_stress") == 0.0);
    // Near θ = 0 the bore stands out most: by what the model's header states, and by the mean that the
    // least-squares circle took out of it, 1.946 um (Lame) for jaws that press with 2894.7 of 3000 N while
    // boring, of which the tool of 25 N/um copies one part in 26.
    let expected = 27.003 + 1.946 * 2894.7 / 3000.0 * 25.0 / 26.0;
    assert!((1e6 * largest(18, "displacement") - expected).abs() < 0.02, "{}", 1e6 * largest(18, "displacement"));
}

#[test]
fn vtk_reads_every_frame_of_a_run() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    let seen = seen(&python, "lathe.toml", "shaft.pvd");
    assert_eq!(seen["frames"], 26);
    let first = &seen["steps"][0];
    // 121 nodes and 120 elements of 5 mm, two supports and the tool: what was computed. The bodies stand behind it.
    assert!(first["points"].as_u64() > Some(124) && first["cells"].as_u64() > Some(123));
    assert_eq!((&first["cell_types"]["3"], &first["cell_types"]["1"]), (&120.into(), &3.into()));
    let largest = |step: usize, field: &str| seen["steps"][step]["point_fields"][field]["range"][1].as_f64().unwrap();
    // At the tailstock end of the pass the shaft itself is straight: the tailstock gives way by 450/40 +
    // 0.2·√450 um.
    let expected = 1e-6 * (450.0 / 40.0 + 0.2 * 450f64.sqrt());
    assert!((largest(0, "displacement") / expected - 1.0).abs() < 1e-12);
    let bending = 450.0 * 0.6 / 4.0;
    assert!((largest(12, "bending_moment") - bending).abs() < 1e-9);
    // Statically determinate: the stress is M·D/2I in the middle, where the diameter is 50 mm.
    let stress = bending * 0.025 / (std::f64::consts::PI * 0.05f64.powi(4) / 64.0);
    assert!(largest(12, "bending_stress") >= stress * (1.0 - 1e-12));
    assert!((largest(12, "force") - 450.0).abs() < 1e-9, "the tool's force");
    // What Warp By Vector at factor 1 shows.
    let magnified = largest(0, "displacement_magnified") / largest(0, "displacement");
    assert!((magnified / 1000.0 - 1.0).abs() < 1e-12, "{magnified}");
}

/// A body revolved in 24 sides is a polygon of area 12·sin 15°·r².
fn revolved(radius: f64) -> f64 {
    12.0 * 15f64.to_radians().sin() * radius * radius
}

#[test]
fn the_shaft_is_a_body_to_scale_in_colours_of_the_whole_run() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    let place = run("lathe.toml");
    let seen = read(&python, "read_picture.py", &place.path().join("view.py"));
    assert_eq!(seen["frames"], 26);
    assert_eq!(seen["open_edges"], 0);
    let said = &seen["field_data"];
    assert_eq!(said["title"], "Stepped shaft between centres");
    assert_eq!(said["version"], concat!("fem ", env!("CARGO_PKG_VERSION")));
    // The largest deflection of the first part, about 40 um under 450 N, to a tenth of 600 mm: 1000 is the largest of
    // 1, 2 and 5 times a power of ten.
    assert_eq!((&said["magnification"], &seen["constants"]["MAGNIFICATION"]), (&1000.0.into(), &1000.0.into()));
    // Bent sections slide past each other and keep their volume: 40, 50 and 40 mm on 150, 300 and 150 mm.
    let volume = 2.0 * revolved(0.02) * 0.15 + revolved(0.025) * 0.3;
    let shaft = seen["volumes"]["shaft"].as_f64().unwrap();
    assert!((shaft / volume - 1.0).abs() < 1e-5, "{shaft} {volume}");
    // The scale is that of the first part's profile, which stands in a file of its own.
    let profile = std::fs::read_to_string(place.path().join("profile.csv")).unwrap();
    let mut rows = profile.lines().skip_while(|l| l.starts_with('#')).map(|l| l.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let column = |name: &str| header.iter().position(|h| h.starts_with(name)).unwrap();
    let (part, error) = (column("part"), column("diameter_error"));
    let first = rows.filter(|row| row[part] == "1").map(|row| row[error].parse::<f64>().unwrap());
    let largest = first.fold(0.0, f64::max);
    let range = &seen["ranges"]["diameter_error_um"];
    // Nodes stand every 5 mm, positions every 6: a smooth crest between them is lower by some 1e-4.
    assert!((range[1].as_f64().unwrap() / largest - 1.0).abs() < 1e-3, "{range} {largest}");
    assert_eq!(range[0].as_f64().map(|low| -low), range[1].as_f64());
    assert_eq!(seen["constants"]["SHOWN"], "diameter_error_um");
    assert!(seen["captions"][12].as_str().unwrap().starts_with("tool at x = 300 mm"), "{}", seen["captions"][12]);
}

#[test]
fn the_ring_has_its_width() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    let seen = read(&python, "read_picture.py", &run("ring.toml").path().join("view.py"));
    // 360 sides of 1 deg between radii of 50 and 42 mm, 20 mm wide.
    let volume = 180.0 * 1f64.to_radians().sin() * (0.05f64.powi(2) - 0.042f64.powi(2)) * 0.02;
    let ring = seen["volumes"]["ring"].as_f64().unwrap();
    assert!((ring / volume - 1.0).abs() < 1e-5, "{ring} {volume}");
    assert_eq!((&seen["open_edges"], &seen["frames"]), (&0.into(), &19.into()));
    // The jaws press with 3 kN and what their places make of it.
    assert!((seen["constants"]["LARGEST_FORCE_N"].as_f64().unwrap() / 3000.0 - 1.0).abs() < 0.02);
}

#[test]
fn every_process_has_a_picture_of_closed_bodies() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    for (model, shown) in [
        ("thermal.toml", "temperature_degC"),
        ("fixture.toml", "height_change_um"),
        ("axis.toml", "deviation_um"),
        ("rotary.toml", "deviation_arcsec"),
        ("rectangle.toml", "deviation_um"),
        ("cam.toml", "deviation_um"),
    ] {
        let seen = read(&python, "read_picture.py", &run(model).path().join("view.py"));
        let constants = &seen["constants"];
        assert_eq!((&constants["SHOWN"], &seen["open_edges"]), (&shown.into(), &0.into()), "{model}");
        // The script's scale is that of every frame; the files hold 32 bits.
        let [said, found] = [&constants["RANGES"][shown], &seen["ranges"][shown]];
        for end in [0, 1] {
            let [said, found] = [said, found].map(|range| range[end].as_f64().unwrap());
            assert!((said - found).abs() <= 1e-6 * said.abs(), "{model}: {said} {found}");
        }
        assert!(seen["captions"].as_array().unwrap().iter().all(|c| !c.as_str().unwrap().is_empty()), "{model}");
    }
}

/// Arrays are compressed in blocks of 32 768 bytes. 4096 numbers fill one exactly, a number more begins the next.
#[test]
fn vtk_reads_arrays_that_fill_their_blocks() {
    let Some(python) = python() else {
        println!("no Python with VTK here: not checked");
        return;
    };
    let place = tempfile::tempdir().unwrap();
    for count in [4095, 4096, 4097, 8192] {
        let values: Vec<f64> = (0..count).map(|i| 0.25 * f64::from(i)).collect();
        let mut grid = Grid { points: values.iter().map(|v| [*v, -v, 0.5]).collect(), ..Grid::default() };
        (0..count as u32).for_each(|i| grid.push(Cell::Vertex, &[i]));
        grid.point_fields.push(Field::scalar("quarter", NUMBER, values.clone()));
        let file = place.path().join("grid.vtu");
        std::fs::write(&file, vtu(&grid).unwrap()).unwrap();
        let seen = read(&python, "read_grid.py", &file);
        let numbers =
            |key: &str| -> Vec<f64> { seen[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect() };
        assert!(numbers("quarter") == values, "{count}");
        assert!(numbers("points") == grid.points.as_flattened(), "{count}");
        assert!(numbers("cells") == (0..count).map(f64::from).collect::<Vec<_>>(), "{count}");
    }
}
