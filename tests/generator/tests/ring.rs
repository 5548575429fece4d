//! The ring by collocation against closed forms.

use generator::ring::elastic::{bore, compliances};
use std::f64::consts::{PI, TAU};

const NU: f64 = 0.3;

#[test]
fn even_pressure_is_lames() {
    for ratio in [0.6, 0.8, 0.92] {
        // One newton per radian is a pressure of one on Ro = b = 1: u(Ri) = -2 p Ro^2 Ri/(E (Ro^2 - Ri^2)).
        let lame = -2.0 * ratio / (1.0 - ratio * ratio);
        assert!((bore(ratio, NU, 0) / lame - 1.0).abs() < 1e-10);
    }
}

/// Of a thin ring n equal forces F move the loaded points inwards by (F R^3/2EI)[(β/2 + sin 2β/4)/sin²β −
/// 1/β], β = π/n.
#[test]
fn thin_rings() {
    for n in [2usize, 3, 4] {
        let beta = PI / n as f64;
        let thin = 0.5 * ((beta / 2.0 + (2.0 * beta).sin() / 4.0) / beta.sin().powi(2) - 1.0 / beta);
        let error = |ratio: f64| {
            let c = compliances(ratio, NU, n);
            let waves: f64 = (1..).map(|k| k * n).take_while(|m| *m < c.len()).map(|m| c[m]).sum();
            let inward = -(n as f64) / TAU * 2.0 * waves;
            let (mean, wall) = (0.5 * (1.0 + ratio), 1.0 - ratio);
            let found = inward * wall.powi(3) / 12.0 / mean.powi(3);
            (found / thin - 1.0).abs()
        };
        // What the thin ring leaves out, shear and the wall's own thickness, vanishes with the wall.
        assert!(error(0.99) < 0.02 && error(0.99) < 0.5 * error(0.96), "{n}: {} {}", error(0.96), error(0.99));
    }
}

/// The thick ring of 50 and 40 mm, 20 mm wide, E 210 GPa, three jaws of 2 kN over 10°: u_r as seed 002's
/// chuck squeezes it, by Michell's series of another program.
#[test]
fn a_thick_ring_to_the_digits_of_michells_series() {
    let c = compliances(0.8, NU, 3);
    let arc = TAU / 36.0;
    let at = |angle: f64| {
        let wave = |m: usize| {
            let half = 0.5 * m as f64 * arc;
            c[m] * if m == 0 { 1.0 } else { 2.0 * half.sin() / half } * (m as f64 * angle).cos()
        };
        let sum: f64 = (0..c.len()).step_by(3).map(wave).sum();
        1e6 * 2000.0 * 3.0 / TAU * sum / (210e9 * 0.02)
    };
    for (degrees, expected) in [(0.0, -10.025_369), (30.0, -0.532_458), (60.0, 6.892_577)] {
        assert!((at(f64::to_radians(degrees)) - expected).abs() < 2e-6, "{degrees}: {}", at(f64::to_radians(degrees)));
    }
}

mod bored {
    use generator::job::{Job as _, NoiseKind};
    use generator::law::Cause;
    use generator::ring::elastic::compliances;
    use generator::ring::job::{Job, Row, SetUp};

    fn job(clamped: bool, blank: f64) -> Job {
        Job {
            outer: 50.0,
            inner: 40.0,
            width: 20.0,
            modulus: 210.0,
            poisson: 0.3,
            expansion: 11.5,
            jaws: 3,
            force: 2000.0,
            speed: 400.0,
            force_per_depth: 1.0,
            absolute: true,
            set_ups: vec![SetUp { force: 2000.0, speed: 400.0, orientation: 10.0, clamped }],
            rows: [0.0, 25.0, 60.0, 140.0]
                .iter()
                .map(|angle| Row { change: 0.0, set_up: 0, angle: *angle, blank })
                .collect(),
            noise: NoiseKind::Neither,
            shown: vec![],
            compliances: compliances(0.8, 0.3, 1),
        }
    }

    fn cause(effect: &'static str, parameters: &[(&'static str, f64)]) -> Cause {
        Cause { effect, parameters: parameters.to_vec() }
    }

    /// k·blank − (1 − k)·(u + heat + aside) + (1 − k)·spindle + stress, k = 1/(1 + 4).
    #[test]
    fn the_tool_finds_the_blank_where_it_is() {
        let copying = cause("copying", &[("stiffness", 4.0)]);
        let others = [
            cause("cutting-heat", &[("temperature_rise", 10.0)]),
            cause("chuck-runout", &[("runout", 30.0), ("phase", 50.0)]),
            cause("spindle-error", &[("amplitude", 5.0), ("phase", -20.0)]),
            cause("residual-stress", &[("amplitude", 3.0), ("phase", 15.0)]),
        ];
        let squeezed = job(true, 0.0).predict(&[]);
        let found = job(false, 25.0).predict(&[std::slice::from_ref(&copying), &others].concat());
        for ((found, u), row) in found.iter().zip(squeezed).zip(job(false, 0.0).rows) {
            let turned = |lobes: f64, phase: f64| (lobes * (row.angle - phase).to_radians()).cos();
            let moved = u + 11.5e-6 * 40e3 * 10.0 + 15.0 * turned(1.0, 50.0);
            let expected = 0.2 * 25.0 - 0.8 * moved + 0.8 * 5.0 * turned(2.0, -20.0) + 3.0 * turned(2.0, 25.0);
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
        // Clamped and not yet bored the jaws alone are seen.
        assert_eq!(job(true, 25.0).predict(&[copying]), job(true, 0.0).predict(&[]));
    }
}
