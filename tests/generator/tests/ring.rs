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
