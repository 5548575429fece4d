//! Rings on meshes from files: as good as the ring of equal cells, and clear about what is wrong with a mesh.

use std::f64::consts::TAU;
use std::path::Path;

use super::fem::{Place, model};

/// The ring of `meshes/ring-*.geo`, to be followed by a [mesh] table and effects.
const RING: &str = r#"
process = "ring"
workpiece = { material = "steel", outer_diameter = "100 mm", inner_diameter = "84 mm", width = "20 mm" }
chuck = { jaws = 3, jaw_force = "3 kN" }
measurement = { reference = "absolute" }
"#;
const POSITION: &str = "[effects.jaw-position]\nerror_2 = \"2 deg\"\nerror_3 = \"-1 deg\"\n";
const ARC: &str = "[effects.jaw-contact-arc]\narc = \"24 deg\"\n";

fn mesh(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes").join(name)).unwrap()
}

/// A place with the meshes that come with the program.
fn place() -> Place {
    let place = Place::new();
    for name in ["ring-quad8.msh", "ring-tri6.msh", "keyway.msh"] {
        place.write(name, mesh(name));
    }
    place
}

/// Deviations all around, um.
fn deviations(place: &Place, mesh: &str, effects: &str) -> Vec<f64> {
    place.write("ring.toml", format!("{RING}mesh = {{ {mesh} }}\n{effects}"));
    let answer = place.fem(&["run", "ring.toml", "-o", "out"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    let profile = place.read("out/profile.csv");
    profile.lines().skip(1).map(|line| line.rsplit(',').next().unwrap().parse().unwrap()).collect()
}

#[test]
fn drawn_rings_agree_with_the_ring_of_equal_cells() {
    let place = place();
    // The ring of equal cells is good to 1e-4 of peak to valley (`fem validate`); the drawn ones have
    // elements three times as large.
    let [line, arc, position, both] =
        ["", ARC, POSITION, &format!("{ARC}{POSITION}")].map(|effects| deviations(&place, "radial = 6", effects));
    for (name, drawn, cells) in
        [("ring-quad8.msh", POSITION, &both), ("ring-tri6.msh", ARC, &arc), ("ring-tri6.msh", POSITION, &position)]
    {
        let found = deviations(&place, &format!("file = \"{name}\""), drawn);
        let range = cells.iter().fold(0.0f64, |m, d| m.max(*d)) - cells.iter().fold(0.0f64, |m, d| m.min(*d));
        let worst = cells.iter().zip(&found).fold(0.0f64, |m, (a, b)| m.max((a - b).abs())) / range;
        assert!(worst < 5e-4, "{name} {drawn}: {worst:.2e}");
    }
    assert!((line[0] - arc[0]).abs() > 1.0, "an arc that changes nothing would be no test");
}

#[test]
fn effects_move_and_spread_what_is_drawn_and_are_found_again() {
    let place = place();
    place.write("ring.toml", format!("{RING}mesh.file = \"ring-tri6.msh\"\n{ARC}{POSITION}"));
    assert_eq!(place.fem(&["run", "ring.toml", "-o", "out"]).status, 0);
    let profile = place.read("out/profile.csv");
    place.write(
        "m.csv",
        profile.lines().enumerate().filter(|(i, _)| i % 10 < 2).map(|(_, l)| l.to_string() + "\n").collect::<String>(),
    );
    let free = format!("{RING}mesh.file = \"ring-tri6.msh\"\n{ARC}{POSITION}")
        .replace("\"24 deg\"", "\"? deg\"")
        .replace("\"2 deg\"", "\"? deg\"");
    place.write("ring.toml", free);
    let fit: serde_json::Value =
        serde_json::from_str(&place.fem(&["fit", "ring.toml", "--with", "m.csv", "--json"]).out).unwrap();
    let value = |i: usize| fit["parameters"][i]["value"].as_f64().unwrap();
    assert!((value(0) - 24.0).abs() < 1e-3 && (value(1) - 2.0).abs() < 1e-3, "{fit}");
}

#[test]
fn a_model_written_into_another_folder_finds_its_mesh() {
    let place = place();
    place.write("ring.toml", format!("{RING}mesh = {{ file = \"ring-tri6.msh\" }} # drawn\n"));
    std::fs::create_dir(place.path("new")).unwrap();
    let added = place.fem(&["add", "ring.toml", "jaw-contact-arc", "arc=24 deg", "-o", "new/arc.toml"]);
    assert_eq!(added.status, 0, "{}", added.err);
    assert!(place.read("new/arc.toml").contains("mesh = { file = \"../ring-tri6.msh\" } # drawn"));
    assert_eq!(place.fem(&["run", "new/arc.toml"]).status, 0);
}

/// (in the model, replaced by, part of the message, part of the remedy)
const MODELS: &[(&str, &str, &str, &str)] = &[
    ("keyway.msh", "keway.msh", "keway.msh: the file cannot be read", "relative to the folder of the model file"),
    (
        "\"100 mm\"",
        "\"90 mm\"",
        "outer diameter of 100.0000 mm, [workpiece] one of 90.0000 mm",
        "leave the diameter out",
    ),
    ("\"mm\"", "\"cm\"", "outer diameter of 1000.0000 mm", "in which `unit` the mesh is"),
    ("\"mm\"", "\"furlong\"", "`unit` is \"furlong\"", "\"mm\", \"cm\""),
    (
        "jaws = 3",
        "jaws = 4",
        "there is no physical group `jaw-4`; there are bore, jaw-1, jaw-2, jaw-3",
        "`jaw-1`, `jaw-2`",
    ),
    ("jaws = 3", "jaws = 2", "there is a physical group `jaw-3`, and the chuck has 2 jaws", "`jaw-1`, `jaw-2`"),
    ("unit = \"mm\"", "radial = 6", "`radial` is of a mesh of equal cells", "leave one of them out"),
    ("\"70 mm\"", "\"70 +- 1 mm\"", "has this diameter for certain", "leave it out"),
    (
        "[effects.centrifugal-unloading]\njaw_moment = \"60 +- 15 kg*mm\"",
        "[effects.jaw-contact-arc]\narc = \"10 deg\"",
        "over which arc the jaws press, and so does the mesh",
        "remove the effect",
    ),
];

#[test]
fn a_model_that_does_not_fit_its_mesh_is_told() {
    let place = place();
    let good = model("keyway.toml").replace("../meshes/", "");
    for (from, to, message, remedy) in MODELS {
        assert!(good.contains(from), "{from}");
        place.write("ring.toml", good.replacen(from, to, 1));
        assert_refused(&place, 2, to, &[message, remedy]);
    }
}

/// Runs ring.toml and checks its status and the parts of its message.
fn assert_refused(place: &Place, status: i32, case: &str, parts: &[&str]) {
    let answer = place.fem(&["run", "ring.toml"]);
    let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(answer.status, status, "{case}: {told}");
    // Lines that are broken at the width of the screen have a bar at their beginning.
    let told = told.replace(" │ ", " ");
    assert!(parts.iter().all(|part| told.contains(part)), "{case}: {told}");
}

/// A ring of 36 four-node cells around and one across in Gmsh's format, with jaws of two cells each; `node`
/// moves nodes (place, tag) and `cells` chooses which cells there are. Tags of cells are 101 and on.
fn ring(node: impl Fn([f64; 2], usize) -> [f64; 2], cells: impl Fn(usize) -> bool, jaws: &[(usize, usize)]) -> String {
    let mut text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n1 1 \"jaw-1\"\n1 2 \"jaw-2\"\n1 3 \"jaw-3\"\n1 4 \"bore\"\n2 5 \"ring\"\n$EndPhysicalNames\n".to_string();
    text += "$Entities\n0 4 1 0\n";
    (1..=4).for_each(|curve| text += &format!("{curve} 0 0 0 0 0 0 1 {curve} 0\n"));
    text += "1 0 0 0 0 0 0 1 5 0\n$EndEntities\n$Nodes\n1 72 1 72\n2 1 0 72\n";
    (1..=72).for_each(|tag| text += &format!("{tag}\n"));
    for tag in 1..=72 {
        let (radius, angle) = (if tag <= 36 { 42.0 } else { 50.0 }, TAU * (tag - 1) as f64 / 36.0);
        let [x, y] = node([radius * angle.cos(), radius * angle.sin()], tag);
        text += &format!("{x} {y} 0\n");
    }
    let next = |k: usize| (k + 1) % 36;
    let mut blocks = Vec::new();
    for (curve, (from, to)) in (1..).zip(jaws) {
        let lines = (*from..*to).map(|k| format!("{} {}", 37 + k % 36, 37 + next(k)));
        blocks.push((format!("1 {curve} 1"), lines.collect::<Vec<_>>()));
    }
    blocks.push(("1 4 1".into(), (0..36).map(|k| format!("{} {}", 1 + k, 1 + next(k))).collect()));
    let quad = |k: usize| format!("{} {} {} {}", 1 + k, 37 + k, 37 + next(k), 1 + next(k));
    blocks.push(("2 1 3".into(), (0..36).filter(|k| cells(*k)).map(quad).collect()));
    text += &format!("$EndNodes\n$Elements\n{} 0 1 200\n", blocks.len());
    for (block, (head, elements)) in blocks.iter().enumerate() {
        text += &format!("{head} {}\n", elements.len());
        let first = if head.starts_with('2') { 101 } else { 1 + 40 * block };
        (first..).zip(elements).for_each(|(tag, nodes)| text += &format!("{tag} {nodes}\n"));
    }
    text + "$EndElements\n"
}

const JAWS: [(usize, usize); 3] = [(35, 37), (11, 13), (23, 25)];

#[test]
fn meshes_that_are_no_rings_are_told_by_their_elements() {
    let place = Place::new();
    place.write("ring.toml", format!("{RING}mesh.file = \"ring.msh\"\n"));
    let same = |at: [f64; 2], _| at;
    place.write("ring.msh", ring(same, |_| true, &JAWS));
    assert_eq!(place.fem(&["run", "ring.toml"]).status, 0, "{}", place.fem(&["run", "ring.toml"]).err);
    let at = |moved: usize, x: f64, y: f64| move |at: [f64; 2], tag: usize| if tag == moved { [x, y] } else { at };
    for (case, mesh, message) in [
        ("folded", ring(at(40, 42.0, 0.0), |_| true, &JAWS), "(quad4) near"),
        ("folded", ring(at(40, 42.0, 0.0), |_| true, &JAWS), "element 103"),
        (
            "bore out of round",
            ring(at(5, 35.0, 25.0), |_| true, &JAWS),
            "`bore` is no circle about the origin: its node at (35.0000, 25.0000) mm",
        ),
        ("off centre", ring(|[x, y], _| [x + 5.0, y], |_| true, &JAWS), "`bore` is no circle about the origin"),
        (
            "a cell is missing",
            ring(same, |k| k != 7, &JAWS),
            "element 128 of the physical curve `bore` is not a side of a plane element",
        ),
        (
            "jaws on one side",
            ring(same, |_| true, &[(35, 37), (5, 7), (11, 13)]),
            "jaws at 0.00, 60.00, 120.00 deg cannot press in equilibrium",
        ),
        (
            "clockwise",
            ring(same, |_| true, &[(35, 37), (23, 25), (11, 13)]),
            "jaws are numbered counter-clockwise, and stand at 0.00, 240.00, 120.00 deg",
        ),
        (
            "unlike jaws",
            ring(same, |_| true, &[(35, 37), (11, 13), (23, 27)]),
            "`jaw-3` presses over 40.00 deg and `jaw-1` over 20.00 deg",
        ),
        (
            "jaw on a flat",
            ring(at(37 + 12, -20.0, 40.0), |_| true, &JAWS),
            "what the jaws press on is no circle about the origin",
        ),
        ("no mesh", "solid ring\n".into(), "this is no Gmsh mesh of format 4.1"),
    ] {
        place.write("ring.msh", mesh);
        assert_refused(&place, 2, case, &[message]);
    }
}

#[test]
fn two_rings_in_one_file_are_told_apart() {
    let place = Place::new();
    place.write("ring.toml", format!("{RING}mesh.file = \"ring.msh\"\n"));
    // Two cells are cut out, and the bore is drawn on neither: what is left hangs together; a third and
    // fourth cut it in two.
    let text = ring(|at, _| at, |k| ![7, 25].contains(&k), &JAWS);
    let start = text.find("1 4 1 36\n").unwrap();
    let end = start + text[start..].find("2 1 3").unwrap();
    let text = format!("{}{}", &text[..start], &text[end..]).replace("$Elements\n5", "$Elements\n4");
    place.write("ring.msh", text);
    assert_refused(
        &place,
        2,
        "cut in two",
        &["the mesh falls into 2 pieces: element 108 is not connected to element 101"],
    );
}

#[test]
fn a_jaw_that_leaves_the_round_border_is_told() {
    let place = place();
    let wide = model("keyway.toml").replace("../meshes/", "");
    place.write("ring.toml", format!("{wide}{}", POSITION.replace("\"2 deg\"", "\"-55 deg\"")));
    assert_refused(&place, 1, "in the keyway", &["jaw 2 at 65.00 deg over 10.00 deg is not on the circle of the mesh"]);
}
