//! The numbers that seed 003 prints of its cam. Its geometry is reconstructed from the drawing: lines and
//! arcs are tangent, the nose of R3 lies inside R17.9 and R24.

use super::rig::*;
use crate::processes::cam::report::blocks::{Block, Blocks};
use crate::validation::{Case, Tolerance};

/// Blocks of the model: one arc, four of the line, one of R17.9, then those of the nose.
const NOSE: usize = 6;

pub fn cases() -> Vec<Case> {
    let studied = blocks(&seed(&[], ""));
    let whole = blocks(&seed(&[("blocks = 4", "blocks = 1"), ("step = \"0.5 mm\"", "step = \"15 mm\"")], ""));
    let of = |blocks: &Option<Blocks>, number: usize, value: &dyn Fn(&Block) -> f64| {
        blocks.as_ref().and_then(|b| b.list.get(number)).map_or(f64::NAN, value)
    };
    let mm = |name: &str, quantity, (printed, computed): (f64, f64), tolerance, source| {
        row(format!("cam of the source, {name}"), quantity, (printed, 1e3 * computed, "mm"), tolerance, source)
    };
    // The source's steps are 0.5 mm, those of the reconstructed nose 2.48699 mm/5, and errors go as the
    // square of steps.
    let steps = Tolerance::Relative(2.0 * (2.5 / 2.486_992 - 1.0));
    let by_steps = "seed 003, 2.2, printed; tolerance: its steps of 0.5 mm are 0.4974 mm on the reconstructed nose";
    let overcut = |name, printed, blocks, number| {
        mm(name, "largest overcut", (printed, of(blocks, number, &|b| -b.overcut)), steps, by_steps)
    };
    let (thickening, envelope) = (of(&whole, 1, &|b| b.thickest.0), of(&studied, 1, &|b| b.envelope));
    let two_digits = "seed 003, 2.1, printed with two digits";
    let [by_digits, by_three] = [0.005, 0.0005].map(Tolerance::Absolute);
    let line = "line in four blocks, the first";
    let mut cases = vec![
        mm("line in one block", "largest thickening", (0.15, thickening), by_digits, two_digits),
        mm(line, "length of envelope", (0.278, envelope), by_three, "seed 003, 2.1.2, printed"),
        overcut("nose in five, the first", -0.049, &studied, NOSE),
        overcut("nose in five, the third", -0.0601, &studied, NOSE + 2),
        overcut("nose in five, the fifth", -0.0649, &studied, NOSE + 4),
        overcut("nose in one block", -1.468, &whole, 3),
    ];
    // Lengths by the blocks: of the profile, and of the wheel's centre between them.
    let length = |numbers: std::ops::Range<usize>| -> f64 {
        let ends = studied.as_ref().map(|b| (b.list.get(numbers.start), b.list.get(numbers.end - 1)));
        let Some((Some(first), Some(last))) = ends else { return f64::NAN };
        last.places.1 - first.places.0
    };
    let way = |numbers: std::ops::Range<usize>| -> f64 {
        let cam = seed(&[], "");
        let Some(axes) = cam.as_ref().map(|cam| &cam.setup().program.axes) else { return f64::NAN };
        let chord = |i: usize| {
            let (near, far) = (axes.slides[i], axes.slides[i + 1]);
            (near * near + far * far - 2.0 * near * far * (axes.turns[i + 1] - axes.turns[i]).cos()).sqrt()
        };
        numbers.map(chord).sum()
    };
    let printed = |name: &str, quantity, figure: f64, computed: f64, digits: f64, source| {
        mm(name, quantity, (figure, computed), Tolerance::Absolute(digits), source)
    };
    let [line_by, nose_by] = ["seed 003, 2.1, printed: some 15 mm in four blocks", "seed 003, 2.2.1, printed"];
    cases.extend([
        printed("line", "length", 15.0, length(1..5), 0.5, line_by),
        printed(line, "length", 3.75, length(1..2), 0.005, line_by),
        printed("nose", "length", 2.5, length(NOSE..NOSE + 5), 0.05, nose_by),
        printed(
            "nose, the wheel's centre",
            "way",
            148.0,
            way(NOSE..NOSE + 5),
            0.5 + 0.2,
            "seed 003, 2.2.1, printed; chords of five blocks are 0.2 mm shorter than their arc",
        ),
    ]);
    for (k, first, last) in [(1, 1.0, 6.0), (3, 3.0, 6.0), (5, 3.0, 9.0)] {
        type End = (&'static str, f64, fn(&[usize]) -> Option<&usize>);
        let ends: [End; 2] =
            [("first tenth that cuts", first, <[usize]>::first), ("last tenth that cuts", last, <[usize]>::last)];
        cases.extend(ends.map(|(quantity, expected, end)| {
            let cutting = |b: &Block| b.removal.as_ref().and_then(|r| end(&r.cutting()).copied());
            let tenth = of(&studied, NOSE + k - 1, &|b| cutting(b).map_or(f64::NAN, |tenth| tenth as f64));
            let name = format!("cam of the source, nose in five, block {k}");
            let source = "seed 003, 2.2, pictures to a tenth; their layer is not printed, here 20 um";
            row(name, quantity, (expected, tenth, "-"), Tolerance::Absolute(1.0), source)
        }));
    }
    cases
}
