//! Joints in whose way friction comes first and clearance behind it.

use generator::job::{Job as _, NoiseKind};
use generator::law::Cause;
use generator::stiffness::{Job, Loading, Row};

const MOST: f64 = 1000.0;

fn at(loading: Loading, force: f64, unload: bool, causes: &[Cause]) -> f64 {
    let rows = vec![Row { force, unload }];
    let (noise, shown) = (NoiseKind::Neither, vec![]);
    Job { stiffness: 80.0, max_force: MOST, loading, rows, noise, shown }.predict(causes)[0]
}

fn cause(effect: &'static str, parameters: &[(&'static str, f64)]) -> Cause {
    Cause { effect, parameters: parameters.to_vec() }
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found} against {expected}");
}

/// 80 N/um, a gap of 3 um, friction of 60 N: nothing moves under 50 N, and 0.75 + 3 um are left at none.
#[test]
fn the_gap_is_crossed_by_what_is_transmitted() {
    let both = [cause("gap", &[("gap", 3.0)]), cause("dry-friction", &[("force", 60.0)])];
    for (force, unload, expected) in [
        (0.0, false, 0.0),
        (50.0, false, 0.0),
        (61.0, false, 3.0 + 1.0 / 80.0),
        (MOST, false, 3.0 + 940.0 / 80.0),
        (900.0, true, 3.0 + 940.0 / 80.0),
        (500.0, true, 3.0 + 560.0 / 80.0),
        (0.0, true, 3.75),
    ] {
        close(at(Loading::FromZero, force, unload, &both), expected);
    }
}

/// In a loop between both signs the gap is crossed at f on the way up and at -f on the way down, and on the other
/// side of it the contact is the same.
#[test]
fn a_reversed_loop() {
    let causes = [
        cause("gap", &[("gap", 3.0)]),
        cause("dry-friction", &[("force", 60.0)]),
        cause("contact-joint", &[("c", 0.2), ("n", 0.5)]),
    ];
    let gives = |force: f64| force / 80.0 + 0.2 * force.sqrt();
    for (force, unload, expected) in [
        (-MOST, false, -gives(940.0)),
        (-900.0, false, -gives(940.0)),
        (-800.0, false, -gives(860.0)),
        (59.0, false, -gives(1.0)),
        (61.0, false, gives(1.0) + 3.0),
        (MOST, false, gives(940.0) + 3.0),
        (0.0, true, gives(60.0) + 3.0),
        (-59.0, true, gives(1.0) + 3.0),
        (-61.0, true, -gives(1.0)),
        (-MOST, true, -gives(940.0)),
    ] {
        close(at(Loading::Reversed, force, unload, &causes), expected);
    }
}

/// A preloaded pair is twice as stiff both ways and has no gap; it settles under what friction leaves.
#[test]
fn a_preloaded_pair() {
    let causes = [cause("preload", &[("force", 100.0)]), cause("gap", &[("gap", 3.0)])];
    close(at(Loading::Reversed, 160.0, false, &causes), 1.0);
    close(at(Loading::Reversed, -160.0, true, &causes), -1.0);
    // Beyond twice the preload one side is relaxed: u(S) - u(P).
    close(at(Loading::Reversed, -500.0, true, &causes), -(500.0 - 100.0) / 80.0);
    let settling = [cause("settling", &[("depth", 4.0)]), cause("dry-friction", &[("force", 60.0)])];
    close(at(Loading::FromZero, 0.0, true, &settling), 60.0 / 80.0 + 4.0 * 0.94);
}
