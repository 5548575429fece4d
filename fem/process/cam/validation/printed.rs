//! What seed 003 prints of its cam. Its geometry is reconstructed from the drawing: lines and arcs are tangent, the nose of R3 lies inside R17.9 and R24.

use super::rig::*;
use crate::process::{Case, Tolerance};

/// Blocks of the model: one arc, four of the line, one of R17.9, then those of the nose.
const NOSE: usize = 6;

pub fn cases() -> Vec<Case> {
    let studied = blocks(&of_text(SEED, ""));
    let whole = SEED.replace("blocks = 4", "blocks = 1").replace("step = \"0.5 mm\"", "step = \"15 mm\"");
    let whole = blocks(&of_text(&whole, ""));
    let of = |of: &dyn Fn(&[super::super::report::Block]) -> f64| studied.as_ref().map_or(f64::NAN, |r| of(&r.blocks));
    let mm = |name: &str, quantity, printed, computed: f64, tolerance, source| {
        row(format!("cam of the source, {name}"), quantity, (printed, 1e3 * computed, "mm"), tolerance, source)
    };
    let nose = |k: usize| of(&|b| -b[NOSE + k - 1].overcut);
    // The source's steps are 0.5 mm, those of the reconstructed nose 2.48699 mm/5, and errors go as the square of steps.
    let steps = Tolerance::Relative(2.0 * (2.5 / 2.486_992 - 1.0));
    let by_steps = "seed 003, printed; tolerance: its steps of 0.5 mm are 0.4974 mm on the reconstructed nose";
    let mut cases = vec![
        mm(
            "line in one block",
            "largest thickening",
            0.15,
            whole.as_ref().map_or(f64::NAN, |r| r.blocks[1].thickest.0),
            Tolerance::Absolute(0.005),
            "seed 003 2.1, printed with two digits",
        ),
        mm(
            "line in four blocks, the first",
            "length of envelope",
            0.278,
            of(&|b| b[1].envelope),
            Tolerance::Absolute(0.0005),
            "seed 003 2.1.2, printed",
        ),
        mm("nose in five, the first", "largest overcut", -0.049, nose(1), steps, by_steps),
        mm("nose in five, the third", "largest overcut", -0.0601, nose(3), steps, by_steps),
        mm("nose in five, the fifth", "largest overcut", -0.0649, nose(5), steps, by_steps),
        mm(
            "nose in one block",
            "largest overcut",
            -1.468,
            whole.as_ref().map_or(f64::NAN, |r| -r.blocks[3].overcut),
            steps,
            by_steps,
        ),
    ];
    for (k, first, last) in [(1, 1.0, 6.0), (3, 3.0, 6.0), (5, 3.0, 9.0)] {
        let cutting = |end: fn(&[usize]) -> Option<&usize>| {
            of(&|b| {
                b[NOSE + k - 1].removal.as_ref().and_then(|r| end(&r.cutting()).copied()).map_or(f64::NAN, |t| t as f64)
            })
        };
        let name = format!("cam of the source, nose in five, block {k}");
        let source = "seed 003 2.2, pictures to a tenth; their layer is not printed, here 20 um";
        cases.push(row(
            name.clone(),
            "first tenth that cuts",
            (first, cutting(<[usize]>::first), "-"),
            Tolerance::Absolute(1.0),
            source,
        ));
        cases.push(row(
            name,
            "last tenth that cuts",
            (last, cutting(<[usize]>::last), "-"),
            Tolerance::Absolute(1.0),
            source,
        ));
    }
    cases
}
