//! The rise around a source that moves through an infinite rod, in closed form.

use std::f64::consts::PI;

use super::RodPiece;

/// A source of 1 W that starts at `start` in an infinite cold rod and moves to the right.
///
/// With z = x / sqrt(alpha), alpha = k A / (rho c A), beta = loss / (rho c A) and r = sqrt(t) the rise is
/// 1 / sqrt(pi k A rho c A) times the integral from 0 to r of exp(-beta s^2 - (a + b s^2)^2 / (4 s^2)) ds, where a is
/// z - z_tool and b is speed / sqrt(alpha): the heat spread over the past s^2 seconds, with `2 s ds` for the time.
pub(super) struct Wave {
    start: f64,
    speed: f64,
    /// sqrt(alpha), m / s^(1/2)
    spread: f64,
    /// 1/s
    beta: f64,
    /// K s^(1/2) per W and unit of the integral
    unit: f64,
}

/// Where a rise is read: left of the source, at it or right of it. At the source the slope has two values.
#[derive(Clone, Copy)]
pub(super) enum Side {
    Left,
    Right,
}

impl Wave {
    /// The source starts at `start` (m) and goes right at `speed` (m/s).
    pub(super) fn new(piece: &RodPiece, start: f64, speed: f64) -> Self {
        Self {
            start,
            speed,
            spread: (piece.conductance / piece.heat_capacity).sqrt(),
            beta: piece.loss / piece.heat_capacity,
            unit: 1.0 / (PI * piece.conductance * piece.heat_capacity).sqrt(),
        }
    }

    /// Where the source stands after `time` (s).
    pub(super) fn tool(&self, time: f64) -> f64 {
        self.start + self.speed * time
    }

    /// Diffusivity, m^2/s.
    pub(super) fn diffusivity(&self) -> f64 {
        self.spread * self.spread
    }

    /// Rise (K/W) at the source after `time` (s).
    pub(super) fn rise_at_tool(&self, time: f64) -> f64 {
        self.at(self.tool(time), Side::Right, time).0
    }

    /// Rise at `x` (K/W) and k A d(rise)/dx (W/W) on that side of the source after `time` (s).
    pub(super) fn at(&self, x: f64, side: Side, time: f64) -> (f64, f64) {
        if time <= 0.0 {
            return (0.0, 0.0);
        }
        let r = time.sqrt();
        let (distance, sign) = match side {
            Side::Left => ((self.tool(time) - x).max(0.0), -1.0),
            Side::Right => ((x - self.tool(time)).max(0.0), 1.0),
        };
        let (a, b) = (sign * distance / self.spread, self.speed / self.spread);
        let q = (self.beta + 0.25 * b * b).sqrt();
        let (near, far) = (0.5 * a.abs() / r - q * r, 0.5 * a.abs() / r + q * r);
        // e^(-ab/2 -+ |a| q) erfc(near, far), from exp(x^2) erfc(x) so that nothing overflows.
        let common = (-self.beta * time - (0.5 * (a + b * time) / r).powi(2)).exp();
        let arrived = if near >= 0.0 {
            common * erfcx(near)
        } else {
            2.0 * (-0.5 * a * b - a.abs() * q).exp() - common * erfcx(-near)
        };
        let coming = common * erfcx(far);
        let integral = PI.sqrt() / (4.0 * q) * (arrived - coming);
        let slope = -0.5 * b * integral - sign * 0.25 * PI.sqrt() * (arrived + coming);
        (self.unit * integral, slope / PI.sqrt())
    }
}

/// exp(x^2) erfc(x) for x >= 0, to 1e-15 of its value.
///
/// Rational approximations of W. J. Cody, Math. Comp. 23 (1969) 631.
pub(super) fn erfcx(x: f64) -> f64 {
    const A: [f64; 5] = [
        1.85777706184603153e-1,
        3.16112374387056560,
        1.13864154151050156e2,
        3.77485237685302021e2,
        3.20937758913846947e3,
    ];
    const B: [f64; 5] =
        [1.0, 2.36012909523441209e1, 2.44024637934444173e2, 1.28261652607737228e3, 2.84423683343917062e3];
    const C: [f64; 9] = [
        2.15311535474403846e-8,
        5.64188496988670089e-1,
        8.88314979438837594,
        6.61191906371416295e1,
        2.98635138197400131e2,
        8.81952221241769090e2,
        1.71204761263407058e3,
        2.05107837782607147e3,
        1.23033935479799725e3,
    ];
    const D: [f64; 9] = [
        1.0,
        1.57449261107098347e1,
        1.17693950891312499e2,
        5.37181101862009858e2,
        1.62138957456669019e3,
        3.29079923573345963e3,
        4.36261909014324716e3,
        3.43936767414372164e3,
        1.23033935480374942e3,
    ];
    const P: [f64; 6] = [
        1.63153871373020978e-2,
        3.05326634961232344e-1,
        3.60344899949804439e-1,
        1.25781726111229246e-1,
        1.60837851487422766e-2,
        6.58749161529837803e-4,
    ];
    const Q: [f64; 6] = [
        1.0,
        2.56852019228982242,
        1.87295284992346725,
        5.27905102951428412e-1,
        6.05183413124413191e-2,
        2.33520497626869185e-3,
    ];
    let ratio = |top: &[f64], bottom: &[f64], at: f64| horner(top, at) / horner(bottom, at);
    if x <= 0.46875 {
        let square = x * x;
        square.exp() * (1.0 - x * ratio(&A, &B, square))
    } else if x <= 4.0 {
        ratio(&C, &D, x)
    } else {
        let square = 1.0 / (x * x);
        (1.0 / PI.sqrt() - square * ratio(&P, &Q, square)) / x
    }
}

/// Polynomial with the highest coefficient first.
fn horner(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().fold(0.0, |sum, c| sum * x + c)
}
