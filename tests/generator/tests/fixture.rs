//! Parts on their supports against the tables of beams, and against elements.

use generator::dense::solve;
use generator::fixture::part::Part;

const RIGID: Part = Part { rigidity: 2.0e10, supports: Vec::new(), stiffness: None, contact: None, high: Vec::new() };

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found} against {expected}");
}

#[test]
fn two_rigid_supports() {
    let part = Part { supports: vec![50.0, 350.0], ..RIGID };
    let (force, span) = (2000.0_f64, 300.0_f64);
    // Half way: F·L³/(48·EI); ends beyond the supports stay straight and rise.
    let middle = part.pressed(&[(200.0, force)]);
    close(middle.sinks(200.0), 1e3 * force * span.powi(3) / (48.0 * RIGID.rigidity), 1e-9);
    let slope = 1e3 * force * span * span / (16.0 * RIGID.rigidity);
    close(middle.sinks(0.0), -50.0 * slope, 1e-9);
    // Anywhere: F·b·x·(L² − b² − x²)/(6·EI·L) before the force.
    let (at, x) = (90.0, 60.0);
    let b = span - at;
    let table = 1e3 * force * b * x * (span * span - b * b - x * x) / (6.0 * RIGID.rigidity * span);
    close(part.pressed(&[(50.0 + at, force)]).sinks(50.0 + x), table, 1e-9);
    // Above a support a force does nothing.
    close(part.pressed(&[(50.0, force), (350.0, force)]).sinks(200.0), 0.0, 1e-12);
}

#[test]
fn two_springs_with_a_contact() {
    let part = Part { supports: vec![100.0, 300.0], stiffness: Some(100.0), contact: Some((0.3, 0.5)), ..RIGID };
    // 3000 N a quarter of the span from the left: 2250 and 750 N.
    let pressed = part.pressed(&[(150.0, 3000.0)]);
    for (at, force) in [(100.0, 2250.0_f64), (300.0, 750.0)] {
        close(pressed.sinks(at), force / 100.0 + 0.3 * force.sqrt(), 1e-9);
    }
}

#[test]
fn three_rigid_supports() {
    let part = Part { supports: vec![0.0, 200.0, 400.0], ..RIGID };
    // A force half way in each of two equal spans: each bends by 7·F·L³/(768·EI) under its force.
    let pressed = part.pressed(&[(100.0, 900.0), (300.0, 900.0)]);
    close(pressed.sinks(100.0), 1e3 * 7.0 * 900.0 * 200_f64.powi(3) / (768.0 * RIGID.rigidity), 1e-9);
    // In one of them alone the other end leaves its support, which only presses: a part on two supports.
    let lifted = part.pressed(&[(100.0, 900.0)]);
    let alone = Part { supports: vec![0.0, 200.0], ..RIGID }.pressed(&[(100.0, 900.0)]);
    for x in [0.0, 100.0, 330.0, 400.0] {
        close(lifted.sinks(x), alone.sinks(x), 1e-9);
    }
    assert!(lifted.sinks(400.0) < -1.0);
    // The middle support of a part that is pressed above the outer ones and held up in the middle bears nothing.
    let hollow = part.pressed(&[(-20.0, 500.0), (420.0, 500.0)]);
    assert!(hollow.sinks(200.0) < 0.0);
}

/// Hermite's elements (nodes at supports and forces) on springs.
#[test]
fn three_springs_as_elements_have_it() {
    let (nodes, k) = ([0.0_f64, 40.0, 120.0, 190.0, 260.0, 350.0, 400.0], 80.0);
    let (held, loads) = ([1, 3, 5], [(120.0, 2500.0), (260.0, 1400.0)]);
    let count = 2 * nodes.len();
    let mut matrix = vec![vec![0.0; count]; count];
    for (element, pair) in nodes.windows(2).enumerate() {
        let l = pair[1] - pair[0];
        let s = RIGID.rigidity / l.powi(3);
        let local = [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l],
        ];
        for (i, row) in local.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                matrix[2 * element + i][2 * element + j] += s * value;
            }
        }
    }
    held.iter().for_each(|node| matrix[2 * node][2 * node] += 1e3 * k);
    let mut right = vec![0.0; count];
    for (at, force) in loads {
        let node = nodes.iter().position(|x| *x == at).expect("a node");
        right[2 * node] = force;
    }
    let bent = solve(matrix, right);
    let part = Part { supports: held.map(|i| nodes[i]).to_vec(), stiffness: Some(k), ..RIGID };
    let pressed = part.pressed(&loads);
    for (node, x) in nodes.iter().enumerate() {
        close(pressed.sinks(*x), 1e3 * bent[2 * node], 1e-7);
    }
}

/// A part that clamps press on a support which stands high bends over the middle one as over any: of a rigid
/// three-point bridge the middle bears 48·EI·δ/L³ less for each δ by which it is left behind.
#[test]
fn a_high_support_bends_the_part() {
    let loads = [(90.0, 3000.0), (300.0, 3000.0)];
    let part = |high| Part { supports: vec![0.0, 200.0, 400.0], high, ..RIGID };
    let (flat, bent) = (part(vec![0.0; 3]).pressed(&loads), part(vec![0.0, 0.0, 20.0]).pressed(&loads));
    // The middle support is 10 um under the line of the others.
    let change = |x: f64| bent.sinks(x) - flat.sinks(x);
    close(change(0.0), 0.0, 1e-9);
    close(change(200.0), 0.0, 1e-9);
    close(change(400.0), -20.0, 1e-9);
    // Between them the line, and the shape of a force half way, 3·s − 4·s³ of its largest.
    let shape = 3.0 * 0.25 - 4.0 * 0.25_f64.powi(3);
    close(change(100.0), -5.0 + 10.0 * shape, 1e-9);
    // A part too stiff for its clamps leaves the middle support.
    let stiff = Part { rigidity: 2.0e14, ..part(vec![0.0, 0.0, 20.0]) };
    close(stiff.pressed(&loads).sinks(200.0), -10.0, 0.1);
}

mod milled {
    use generator::fixture::{Cutter, Job, Row};
    use generator::job::{Job as _, NoiseKind};
    use generator::law::Cause;

    fn row(x: f64, depth: f64, blank: f64, y: f64) -> Row {
        Row { site: [0, 0], change: 0.0, part: 500, group: 0, x, clamp_force: 4000.0, depth, blank, y }
    }

    fn job(rows: Vec<Row>) -> Job {
        Job {
            length: 400.0,
            width: 60.0,
            height: 40.0,
            // Nothing bends.
            modulus: 1e10,
            supports: vec![50.0, 350.0],
            clamps: vec![50.0, 350.0],
            clamp_force: 4000.0,
            cutter: Some(Cutter { force: 300.0, depth: Some(1.0), diameter: Some(100.0) }),
            places: Vec::new(),
            pallets: Vec::new(),
            press: None,
            rows,
            noise: NoiseKind::Neither,
            shown: vec![],
        }
    }

    fn cause(effect: &'static str, parameters: &[(&'static str, f64)]) -> Cause {
        Cause { effect, parameters: parameters.to_vec() }
    }

    /// On two springs, all of supports, locator and wear takes from the depth: e = m + (t − e)·a, a = C/j.
    #[test]
    fn the_depth_takes_the_whole_height_error() {
        let causes = [
            cause("support-compliance", &[("stiffness", 50.0)]),
            cause("force-feedback", &[("exponent", 1.0)]),
            cause("locator-height", &[("height", 24.0)]),
            cause("locator-wear", &[("rate", 60.0)]),
            cause("cutter-tilt", &[("along", 400.0), ("across", -200.0)]),
        ];
        let rows = vec![row(50.0, 1.0, 0.2, 0.0), row(200.0, 1.5, -0.1, 20.0), row(200.0, 0.02, 0.0, 0.0)];
        let found = job(rows.clone()).predict(&causes);
        for (found, row) in found.iter().zip(&rows).take(2) {
            let share = (row.x - 50.0) / 300.0;
            let hollow =
                1e-3 * (400.0 * 50.0 * (1.0 - (1.0 - (2.0 * row.y / 100.0_f64).powi(2)).sqrt()) - 200.0 * row.y);
            let moved = 4000.0 / 50.0 - 24.0 * share + 30.0;
            // Under the cutter the supports give way by the squares of their shares.
            let copies = 300.0 / 1000.0 * ((1.0 - share).powi(2) + share * share) / 50.0;
            let there = 1e3 * (row.depth + row.blank);
            // One force for the whole width; the tilt shows beside its middle.
            let expected = (moved + copies * there) / (1.0 + copies) + hollow;
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        }
        // Under a blank of 20 um a top that has sunk further is not reached.
        assert!((found[2] - 20.0).abs() < 1e-9, "{}", found[2]);
    }
}
