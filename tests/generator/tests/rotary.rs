//! A rotary axis: its ratios, and where friction, a torque, a weight and play let the table rest.

use generator::job::{Job as _, NoiseKind};
use generator::law::Cause;
use generator::rotary::{Job, ROTARY, Row};

fn job(angle: f64, torque: f64) -> Job {
    let row = |backward| Row { run: 1, angle, backward, time: 0.0, torque: Some(torque), change: 0.0 };
    Job {
        range: 360.0,
        from: 0.0,
        lies: true,
        pairs: vec![[12, 48]],
        worm: Some([2, 90]),
        wheel: Some(100.0),
        stiffness: Some(4.0),
        ring: None,
        torque: 0.0,
        rows: vec![row(false), row(true)],
        own_clock: false,
        noise: NoiseKind::Neither,
        shown: vec![],
    }
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found} against {expected}");
}

/// S = T ∓ T_f over 4 N·m/arcsec, and 20 arcsec of play where S > 0.
#[test]
fn the_table_rests_on_the_flank_of_what_its_drive_bears() {
    let causes = vec![
        Cause { effect: "backlash", parameters: vec![("gap", 20.0)] },
        Cause { effect: "elastic-wind-up", parameters: vec![("friction", 8.0)] },
    ];
    for (torque, [there, back]) in
        [(0.0, [-2.0, 22.0]), (16.0, [22.0, 26.0]), (-16.0, [-6.0, -2.0]), (4.0, [-1.0, 23.0])]
    {
        let found = job(30.0, torque).predict(&causes);
        close(found[0], there);
        close(found[1], back);
    }
    // A weight of 24 N·m is a torque of 12 at 60 degrees.
    let weight = Cause { effect: "unbalance", parameters: vec![("moment", 24.0), ("phase", 0.0)] };
    let found = job(60.0, 0.0).predict(&[causes, vec![weight]].concat());
    close(found[0], 21.0);
    close(found[1], 25.0);
}

/// A worm of two starts on 90 teeth turns each 8 degrees, the pinion before it each 2, and a tooth passes each 1/6.
#[test]
fn errors_come_back_by_the_ratios() {
    for (effect, period) in [("worm-error", 8.0), ("gear-eccentricity", 2.0), ("tooth-error", 1.0 / 6.0)] {
        let cause = Cause { effect, parameters: vec![("amplitude", 6.0), ("phase", 90.0)] };
        let at = |angle: f64| job(angle, 0.0).predict(std::slice::from_ref(&cause))[0];
        close(at(0.0), 6.0);
        assert!((at(5.0 * period) - 6.0).abs() < 1e-6 && (at(5.5 * period) + 6.0).abs() < 1e-6, "{effect}");
    }
    // 10 um on 100 mm.
    let wheel = Cause { effect: "wheel-eccentricity", parameters: vec![("eccentricity", 10.0), ("phase", 0.0)] };
    close(job(90.0, 0.0).predict(&[wheel])[0], 1e-4 * 206_264.806_247_096_36);
    assert!(ROTARY.meeting(&["worm-error", "tooth-error"], 1, 1).is_some());
}
