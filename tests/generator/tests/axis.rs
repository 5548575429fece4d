//! Lost motion of an axis: play, screw, bearing and nut in series.

use generator::axis::{AXIS, Job, Row, SetUp};
use generator::job::{Job as _, NoiseKind};
use generator::law::Cause;
use generator::preload::Side;

fn job(x: f64, set_up: SetUp) -> Job {
    let row = |backward| Row { change: 0.0, run: 1, x, backward, time: 0.0, pull: 0.0 };
    Job {
        travel: 400.0,
        from: 0.0,
        lead: 10.0,
        diameter: 30.0,
        fixed_at: -50.0,
        rows: vec![row(false), row(true)],
        own_clock: false,
        noise: NoiseKind::Neither,
        shown: vec![],
        set_up,
    }
}

fn causes() -> Vec<Cause> {
    vec![
        Cause { effect: "backlash", parameters: vec![("gap", 8.0)] },
        Cause { effect: "elastic-lost-motion", parameters: vec![("friction", 600.0), ("stiffness", 200.0)] },
    ]
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found} against {expected}");
}

/// −F/C ahead and δ + F/C back, 1/C = 1/k + |x − x_b|/EA, or of a screw between two bearings a·b/((a + b)·EA).
#[test]
fn play_stands_in_series_with_what_friction_winds_up() {
    let ea = 210e3 * std::f64::consts::FRAC_PI_4 * 900.0;
    for (set_up, free) in [
        (SetUp::default(), 200.0),
        (SetUp { also_fixed_at: Some(450.0), ..SetUp::default() }, 200.0 * 300.0 / 500.0),
        (SetUp { drag: vec![(0.0, 500.0), (400.0, 500.0)], ..SetUp::default() }, 200.0),
    ] {
        let found = job(150.0, set_up).predict(&causes());
        let wound = 600.0 * (1.0 / 200.0 + 1e3 * free / ea);
        close(found[0], -wound);
        close(found[1], 8.0 + wound);
    }
    // Twice the mean friction at the end of a friction that rises from none.
    let rising = SetUp { drag: vec![(0.0, 0.0), (400.0, 700.0)], ..SetUp::default() };
    close(job(400.0, rising).predict(&causes())[0], -1200.0 * (1.0 / 200.0 + 1e3 * 450.0 / ea));
    // A nut of two springs is twice as stiff as one.
    let nut = Some((Side { stiffness: Some(150.0), contact: None }, 2000.0));
    let more = job(150.0, SetUp { nut, ..SetUp::default() }).predict(&causes())[1];
    close(more - job(150.0, SetUp::default()).predict(&causes())[1], 600.0 / 300.0);
    assert!(AXIS.meeting(&["backlash", "worn-screw"], 1, 1).is_some());
}
