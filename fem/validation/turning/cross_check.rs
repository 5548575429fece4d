//! The whole machine against the plain finite-element solve of its shaft: steps, bore, rests, contacts,
//! tilt.

use super::rig::*;
use crate::element::BeamPiece;
use crate::solve::Hold;
use crate::solve::frame::Frame;
use crate::validation::{Case, Tolerance};

/// A hollow stepped shaft on two steady rests.
const HOLLOW: &str = r#"
    workpiece = { material = "steel", segments = [
        { length = "120 mm", diameter = "60 mm", bore = "30 mm" }, { length = "240 mm", diameter = "45 mm" }, { length = "140 mm", diameter = "50 mm", bore = "20 mm" } ] }
    workholding = { type = "HELD", steady_rests = [{ at = "160 mm", stiffness = "25 N/um" }, { at = "400 mm", stiffness = "8 N/um" }] }
    cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "600 rpm", radial_force = "700 N" }
"#;
const JOINTS: &str = "[headstock-compliance]\nstiffness = \"60 N/um\"\n[headstock-contact]\nc = \"0.3 um/N^n\"\nn = 0.4\n[tailstock-compliance]\nstiffness = \"35 N/um\"\n[tailstock-contact]\nc = \"0.2 um/N^n\"\nn = 0.6";
const TILT: &str = "\n[chuck-tilt]\nstiffness = \"150 kN*m/rad\"";
/// 20 mm elements: beams are exact at any length.
const ELEMENTS: usize = 25;

pub fn cases() -> Vec<Case> {
    let centres = lathe(&HOLLOW.replace("HELD", "centres"), JOINTS);
    let chucked = lathe(&HOLLOW.replace("HELD", "chuck-and-centre"), &(JOINTS.to_string() + TILT));
    let mut cases = Vec::new();
    for (name, lathe) in
        [("hollow shaft on rests and contacts", &centres), ("the same in a chuck that tilts", &chucked)]
    {
        for (node, place) in [(3, "x = 60 mm"), (13, "x = 260 mm"), (25, "x = 500 mm")] {
            let expected = lathe.as_ref().and_then(|l| by_frame(l, node)).unwrap_or(f64::NAN);
            let computed = gap(lathe, 0.02 * node as f64);
            let tolerance = Tolerance::Relative(1e-9);
            cases.push(row(
                format!("{name}, {place}"),
                "deflection",
                (expected, computed, "m"),
                tolerance,
                "plain finite elements, Newton to 1e-10",
            ));
        }
    }
    cases
}

/// Deflection under the tool at a node of 20 mm elements, by the sparse solve.
fn by_frame(lathe: &Lathe, node: usize) -> Option<f64> {
    let machine = lathe.machine();
    let shaft = machine.setup.shaft(machine.hold);
    let count = |piece: &BeamPiece| (piece.length / 0.02).round() as usize;
    let pieces: Vec<BeamPiece> = shaft.pieces.iter().flat_map(|p| p.divided(count(p))).collect();
    let mut frame = Frame::new(&pieces).ok()?.joint(0, machine.headstock.clone()).ok()?;
    frame = frame.joint(ELEMENTS, machine.tailstock.clone()).ok()?;
    if let Hold::Compliance(tilt) = machine.hold {
        frame = frame.rotational_spring(0, 1.0 / tilt).ok()?;
    }
    for rest in &shaft.rests {
        frame = frame.translational_spring((rest.at / 0.02).round() as usize, rest.stiffness).ok()?;
    }
    let force = machine.setup.conditions(0.0, 0.0).force;
    let solution = frame.solve(&[(node, force)]).ok()?;
    Some(solution.displacement[node])
}
