//! Two axes on a circle against their equations of motion, step by step, and against formulas of the
//! first order.

use std::f64::consts::TAU;

use generator::contour::axis::{Axis, Lost};
use generator::contour::{Job, Row, Screw, YOUNGS_MODULUS};
use generator::job::{Job as _, NoiseKind};
use generator::law::Cause;

/// Of which first-order formulas hold: a gain so high that nothing lags.
const STIFF: f64 = 1e8;

fn job(gain: f64, angles: &[f64]) -> Job {
    let row =
        |clockwise| move |angle: &f64| Row { lap: usize::from(clockwise), clockwise, feed: 1200.0, angle: *angle };
    Job {
        command: [Vec::new(), Vec::new()],
        radius: 100.0,
        feed: 1200.0,
        gain,
        lead: Some(10.0),
        frequency: Some(0.5),
        screws: Some([Screw { diameter: 30.0, fixed_at: -350.0, nut: None }; 2]),
        cut: Some([200.0, 120.0]),
        rows: angles.iter().map(row(false)).chain(angles.iter().map(row(true))).collect(),
        noise: NoiseKind::Neither,
        shown: vec![],
    }
}

fn cause(effect: &'static str, parameters: &[(&'static str, f64)]) -> Cause {
    Cause { effect, parameters: parameters.to_vec() }
}

/// Deviations counter-clockwise, then clockwise.
fn change(gain: f64, angle: f64, causes: &[Cause]) -> [f64; 2] {
    let job = job(gain, &[angle]);
    let (with, without) = (job.predict(causes), job.predict(&[]));
    [with[0] - without[0], with[1] - without[1]]
}

/// s' = Kv·(command − s) by the classical Runge-Kutta steps of two laps from rest, and a slide that stands until
/// it lags by half of its lost motion.
#[test]
fn an_axis_follows_its_equation_of_motion() {
    let steps = 40_000;
    for (bearing, growth) in [(-350.0, 0.0), (-350.0, 2e-5), (350.0, 2e-5)] {
        let lost = Lost { half: 0.004, growth, bearing };
        let axis = Axis { radius: 100.0, speed: 0.4, gain: 30.0, change: 0.0, lost };
        let h = TAU / axis.speed / f64::from(steps);
        let rate = |t: f64, s: f64| axis.gain * (axis.radius * (axis.speed * t).cos() - s);
        let (mut drive, mut slide, mut last, mut turned): (f64, f64, f64, f64) = (100.0, 100.0, 0.0, 0.0);
        let mut worst = (0.0_f64, 0.0_f64, 0.0_f64);
        for step in 0..2 * steps {
            let t = f64::from(step) * h;
            let k1 = rate(t, drive);
            let k2 = rate(t + 0.5 * h, drive + 0.5 * h * k1);
            let k3 = rate(t + 0.5 * h, drive + 0.5 * h * k2);
            let k4 = rate(t + h, drive + h * k3);
            drive += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
            let reach = |at: f64| lost.half + growth * (at - bearing).abs();
            // The slide is dragged no further than the drive has left it behind.
            if drive - slide > reach(slide) {
                slide = drive - reach(slide);
            } else if slide - drive > reach(slide) {
                slide = drive + reach(slide);
            }
            let velocity = rate(t + h, drive);
            if velocity * last < 0.0 {
                turned = t + h * velocity.abs() / (velocity - last).abs();
            }
            last = velocity;
            if step >= steps {
                let state = axis.at(axis.speed * (t + h));
                worst.0 = worst.0.max((state.place - slide).abs());
                worst.1 = worst.1.max((state.velocity - velocity).abs());
                let since = (state.since - (t + h - turned)).abs();
                // On either side of a turn one of the two has begun to count anew.
                worst.2 = worst.2.max(if state.since < 2.0 * h { 0.0 } else { since });
            }
        }
        println!("{bearing} {growth}: {worst:?}");
        // A slide dragged a step at a time is off by growth times that step, 0.1 um here.
        assert!(worst.0 < 1e-6 && worst.1 < 1e-6 && worst.2 < 2.0 * h, "{worst:?}");
    }
}

/// Four arcs of the programmed radius about the corners of a square whose side is the play, joined by flats.
#[test]
fn play_leaves_four_arcs() {
    let gap = 8.0;
    let causes = [cause("backlash-x", &[("gap", gap)]), cause("backlash-y", &[("gap", gap)])];
    // The flats are 2·sqrt(R·gap) long, 1.8 mm: over in less than 2 deg.
    for angle in [2.0_f64, 30.0, 45.0, 89.0] {
        let (sine, cosine) = angle.to_radians().sin_cos();
        // Counter-clockwise x goes back and y ahead there: the centre of the arc is (gap/2, −gap/2).
        let expected = 0.5 * gap * (cosine - sine);
        let [ccw, cw] = change(STIFF, angle, &causes);
        assert!((ccw - expected).abs() < 1e-3 && (cw + expected).abs() < 1e-3, "{angle}: {ccw} {cw} {expected}");
    }
    // On the flat just behind 0 deg x stands half a gap inside.
    assert!((change(STIFF, 0.2, &causes[..1])[0] + 0.5 * gap).abs() < 1.0);
}

/// Formulas of the first order [seed 000, fig. 1; geometry; statics].
#[test]
fn first_order_formulas() {
    let velocity: f64 = 20.0;
    for angle in [10.0_f64, 75.0, 160.0, 250.0, 310.0] {
        let a = angle.to_radians();
        let near = |what: &str, found: [f64; 2], expected: [f64; 2], tolerance: f64| {
            let off = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
            assert!(off < tolerance, "{what} at {angle}: {found:?} {expected:?}");
        };
        let both = |value: f64| [value, value];
        let square = cause("squareness", &[("angle", 40.0)]);
        near("squareness", change(STIFF, angle, &[square]), both(2.0 * (2.0 * a).sin()), 1e-3);
        let scale = cause("scale-mismatch", &[("mismatch", 40.0)]);
        near("scales", change(STIFF, angle, &[scale]), both(2.0 * (2.0 * a).cos()), 1e-3);
        let centre = cause("centre-offset", &[("x", 5.0), ("y", -9.0)]);
        near("centre", change(STIFF, angle, &[centre]), both(5.0 * a.cos() - 9.0 * a.sin()), 1e-2);
        // 200 N outwards and 120 N against the travel, on 20 and 50 N/um.
        let cut = cause("cutting-deflection", &[("stiffness_x", 20.0), ("stiffness_y", 50.0)]);
        let outwards = 200.0 * (a.cos().powi(2) / 20.0 + a.sin().powi(2) / 50.0);
        let across = 120.0 * a.sin() * a.cos() * (1.0 / 20.0 - 1.0 / 50.0);
        near("cut", change(STIFF, angle, &[cut]), [outwards + across, outwards - across], 1e-2);
        // Of the second order both lags, 1 % of a radian, turn the ellipse, and the circles contract unequally.
        let servo = cause("servo-mismatch", &[("mismatch", 0.02)]);
        let ellipse = 1e3 * 0.5 * velocity * (2.0 * a).sin() * (1.0 / (20.0 * 1.01) - 1.0 / (20.0 * 0.99));
        near("servos", change(20.0, angle, &[servo]), [ellipse, -ellipse], 0.03 * 10.0);
        let gain = cause("gain-with-feed-x", &[("change", 0.02)]);
        // x lags by v·|sin α|·sin α/Kv·(1/(1 + change·|sin α|) − 1) less, of which cos α shows.
        let lag = 1e3 * velocity / 20.0 * a.sin() * (1.0 / (1.0 + 0.02 * a.sin().abs()) - 1.0);
        near("gain", change(20.0, angle, &[gain]), [lag * a.cos(), -lag * a.cos()], 0.02 * 20.0);
        // Ten millimetres a turn, counted from the centre.
        let cyclic = cause("cyclic-error-y", &[("amplitude", 3.0), ("phase", 30.0)]);
        let wave = 3.0 * (TAU * 100.0 * a.sin() / 10.0 + 30f64.to_radians()).sin() * a.sin();
        near("wave", change(STIFF, angle, &[cyclic]), both(wave), 1e-2);
        // 0.5 Hz; the lap lasts 10·π s.
        let stick = cause("stick-slip-x", &[("amplitude", 3.0), ("phase", 30.0)]);
        let jerks = [a, TAU - a].map(|turned| 3.0 * (TAU * 0.5 * 5.0 * turned + 30f64.to_radians()).sin() * a.cos());
        near("jerks", change(STIFF, angle, &[stick]), jerks, 1e-2);
    }
}

/// Friction of 600 N on 200 N/um, and on the screw from its bearing: lost on either side of where x goes back.
#[test]
fn the_far_flat_is_cut_deeper() {
    let winding = [cause("elastic-lost-motion-x", &[("friction", 600.0), ("stiffness", 200.0)])];
    let area = std::f64::consts::FRAC_PI_4 * 900.0;
    for (angle, length) in [(0.0, 450.0), (180.0, 250.0)] {
        let lost = 3.0 + 1e3 * 600.0 * length / (YOUNGS_MODULUS * area);
        let [ccw, cw] = change(STIFF, angle, &winding);
        assert!((ccw + lost).abs() < 1e-3 && (cw + lost).abs() < 1e-3, "{angle}: {ccw} {cw} {lost}");
    }
}

/// height·e^(−Δt/τ)·|cos α| from where x turns round behind its servo.
#[test]
fn spikes_fade_behind_the_reversal() {
    let spike = [cause("reversal-spike-x", &[("height", 12.0), ("time_constant", 250.0)])];
    let lag = (0.2_f64 / 40.0).atan();
    for (angle, turned) in [(3.0, [3.0, 177.0]), (182.0, [2.0, 178.0]), (359.0, [179.0, 1.0])] {
        let found = change(40.0, angle, &spike);
        for (found, turned) in found.into_iter().zip(turned) {
            let since = (f64::to_radians(turned) - lag) / 0.2;
            let expected = 12.0 * (-since / 0.25).exp() * f64::to_radians(angle).cos().abs();
            assert!((found - expected).abs() < 1e-9, "{angle}: {found} {expected}");
        }
    }
}

/// Play and friction in series lose δ + 2F/C where an axis turns round, and a gain that changes with the speed acts
/// before both: a slide stands by so much behind a drive that lags by v/Kv(v).
#[test]
fn lost_motion_lies_behind_the_servo() {
    let causes = [
        cause("gain-with-feed-x", &[("change", 0.1)]),
        cause("backlash-x", &[("gap", 8.0)]),
        cause("elastic-lost-motion-x", &[("friction", 600.0), ("stiffness", 200.0)]),
    ];
    let job = job(20.0, &[60.0]);
    let row = job.rows[0];
    let found = job.axes(&causes, &row)[0].at(60f64.to_radians());
    let [without, drive] =
        [job.axes(&causes[..1], &row), job.axes(&[], &row)].map(|axes| axes[0].at(60f64.to_radians()));
    let speed = drive.velocity.abs();
    let lag = drive.velocity / 20.0 * (1.0 / (1.0 + 0.1 * speed / 20.0) - 1.0);
    assert!((without.place - (drive.place - lag)).abs() < 1e-12);
    // It goes back, and is left ahead by half of what is lost there.
    let free = (found.place + 350.0) / (YOUNGS_MODULUS * std::f64::consts::FRAC_PI_4 * 900.0);
    let lost = 0.004 + 600.0 * (1e-3 / 200.0 + free);
    assert!((found.place - (without.place + lost)).abs() < 1e-9, "{} {lost}", found.place - without.place);
}
