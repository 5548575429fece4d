//! Parts on their supports against the tables of beams, and against elements.

use generator::dense::solve;
use generator::fixture::part::Part;

const RIGID: Part = Part { rigidity: 2.0e10, supports: Vec::new(), stiffness: None, contact: None };

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
