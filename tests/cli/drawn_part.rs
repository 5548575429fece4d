//! Parts in fixtures whose mesh is drawn: with what an independent program says of one, and clear about what is no part on supports.

use std::path::Path;

use super::fem::{Mistake, Place, model};

/// The housing of `meshes/housing.geo` on two springs, under two clamps.
const HELD: &str = r#"
process = "fixture"
mesh = { file = "housing.msh" }
sweep = { positions = 4 }
[workpiece]
material = { base = "cast-iron", youngs_modulus = "110 GPa", poisson_ratio = 0.26 }
width = "60 mm"
[[support]]
at = "20 mm"
width = "16 mm"
stiffness = "200 N/um"
friction = 0
[[support]]
at = "215 mm"
width = "20 mm"
stiffness = "150 N/um"
friction = 0
[[clamp]]
at = "115 mm"
width = "16 mm"
force = "4 kN"
[[clamp]]
at = "220 mm"
width = "12 mm"
force = "1500 N"
"#;

fn mesh(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes").join(name)).unwrap()
}

fn place() -> Place {
    let place = Place::new();
    place.write("housing.msh", mesh("housing.msh"));
    place
}

/// CalculiX 2.20 on the same mesh: `tests/validation/calculix/drawn_part.py`. It computes a plate of 0.1 mm, whose faces bend a little.
#[test]
fn a_drawn_part_sinks_as_another_program_has_it() {
    let place = place();
    for (friction, expected) in
        [("0", [-13.23755, 57.92881, 60.83746, -2.452334]), ("0.15", [-12.032883, 55.528095, 58.630117, -0.861958])]
    {
        place.write("part.toml", HELD.replace("friction = 0\n", &format!("friction = {friction}\n")));
        let answer = place.fem(&["run", "part.toml", "-o", "out"]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        for (found, expected) in place.column("out/profile.csv", "height_error").iter().zip(expected) {
            assert!((found - expected).abs() < 1e-3, "{friction}: {found} {expected}");
        }
    }
}

#[test]
fn a_drawn_part_weighs_what_its_drawing_has() {
    let place = place();
    place.write("part.toml", model("housing.toml").replace("../meshes/", ""));
    assert_eq!(place.fem(&["run", "part.toml", "-o", "out"]).status, 0);
    let summary: serde_json::Value = serde_json::from_str(&place.read("out/summary.json")).unwrap();
    let carried = summary["findings"]["supports"]["list"].as_array().unwrap().iter();
    let carried: f64 = carried.map(|own| own["force"].as_f64().unwrap()).sum();
    // The outline by the shoelace formula, less two bores, which chords of 12 triangles around make a little smaller.
    let outline = 240.0 * 60.0 - 0.5 * (160.0 + 130.0) * 12.0 - 0.5 * (120.0 + 80.0) * 25.0;
    let bores = 2.0 * std::f64::consts::PI * 100.0;
    let weight = 1e-6 * (outline - bores) * 0.06 * 7200.0 * 9.80665;
    assert!((carried - 5000.0 - weight).abs() < 2e-3 * weight, "{} {weight}", carried - 5000.0);
}

const MISTAKES: &[Mistake] = &[
    ("at = \"20 mm\"", "at = \"80 mm\"", "no level face under the pad from 72 mm to 88 mm", "move the pad"),
    (
        "at = \"20 mm\"",
        "at = \"35 mm\"",
        "the pad reaches from 27 mm to 43 mm, and its face from 0 mm to 40 mm",
        "move the pad",
    ),
    ("at = \"115 mm\"", "at = \"70 mm\"", "no level face under the pad from 62 mm to 78 mm", "move the pad"),
    (
        "width = \"60 mm\"",
        "width = \"60 mm\"\nheight = \"60 mm\"",
        "`height` stands beside a mesh from a file",
        "leave `height` out",
    ),
    ("width = \"60 mm\"", "width = \"60 mm\"\nshear = true", "`shear` is of a beam", "leave `shear` out"),
    (
        "\"housing.msh\"",
        "\"housing.msh\", element_size = \"5 mm\"",
        "`element_size` is of elements of the program's own",
        "leave one",
    ),
    ("{ file = \"housing.msh\" }", "{ unit = \"mm\" }", "`element_size` is missing", "element_size = "),
    (
        "process = \"fixture\"",
        "process = \"fixture\"\ncutter = { width = \"10 mm\", depth = \"1 mm\", before = [{ depth = \"2 mm\", force = \"100 N\" }] }",
        "how a mesh from a file looked before a pass is not known",
        "give the part as `segments`",
    ),
];

#[test]
fn what_does_not_fit_a_drawn_part_is_told() {
    place().refuses(("run", "part.toml"), HELD, MISTAKES);
}

/// (in the mesh, replaced by, part of the message)
const MESHES: &[(&str, &str, &str)] =
    &[("\"underside\"", "\"bottom\"", "underside"), ("1 2 \"top\"", "1 2 \"roof\"", "top")];

#[test]
fn a_mesh_that_is_no_part_is_told() {
    let place = place();
    place.write("part.toml", HELD);
    for (from, to, message) in MESHES {
        let good = mesh("housing.msh");
        assert!(good.contains(from), "{from}");
        place.write("housing.msh", good.replacen(from, to, 1));
        place.is_refused(&["run", "part.toml"], to, (message, "a part begins at x = 0"));
    }
    // One whose ring has another name, lies elsewhere, and whose sides are no underside.
    place.write("housing.msh", mesh("plate.msh").replace("\"bottom\"", "\"underside\"").replace("\"left\"", "\"top\""));
    place.is_refused(&["run", "part.toml"], "left", ("`top`", "a part begins at x = 0"));
}

#[test]
fn a_starting_model_can_have_a_part_that_is_drawn() {
    let place = Place::new();
    for process in ["fixture", "thermal"] {
        let file = format!("{process}.toml");
        assert_eq!(place.fem(&["new", process, "--sketch", "-o", &file]).status, 0);
        assert_eq!(place.fem(&["run", &file, "-o", process]).status, 0);
    }
    place.is_refused(&["new", "cam", "--sketch"], "cam", ("`cam` has no part that is drawn", "thermal, fixture"));
}
