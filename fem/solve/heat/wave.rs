//! The rise around a source that moves through an infinite rod, in closed form.

use std::f64::consts::PI;

use super::RodPiece;

/// A source of 1 W that starts at `start` in an infinite cold rod of one piece and moves to the right.
///
/// With alpha = k A / (rho c A), beta = loss / (rho c A), a = (x - x_tool) / sqrt(alpha), b = speed /
/// sqrt(alpha) and r = sqrt(time) the rise is 1 / sqrt(pi k A rho c A) times the integral from 0 to r of
/// exp(-beta s^2 - (a + b s^2)^2 / (4 s^2)) ds: the heat released s^2 seconds ago, with 2 s ds for the time.
pub(super) struct Wave {
    start: f64,
    speed: f64,
    /// sqrt(alpha), m/s^(1/2)
    spread: f64,
    /// loss / (rho c A), 1/s
    beta: f64,
    /// 1 / sqrt(pi k A rho c A), K/(W s^(1/2))
    unit: f64,
}

/// The side of the source on which a point lies. At the source the slope has two values.
#[derive(Clone, Copy)]
pub(super) enum Side {
    Left,
    Right,
}

impl Wave {
    /// The source starts at `start` (m) and moves at `speed` (m/s).
    pub(super) fn new(piece: &RodPiece, start: f64, speed: f64) -> Self {
        Self {
            start,
            speed,
            spread: (piece.conductance / piece.heat_capacity).sqrt(),
            beta: piece.loss / piece.heat_capacity,
            unit: 1.0 / (PI * piece.conductance * piece.heat_capacity).sqrt(),
        }
    }

    /// Place of the source after `time` (s), m.
    pub(super) fn tool(&self, time: f64) -> f64 {
        self.start + self.speed * time
    }

    /// Distance (m) over which heat diffuses in `time` (s).
    pub(super) fn spread(&self, time: f64) -> f64 {
        self.spread * time.sqrt()
    }

    /// Length over which the steady rise ahead of the source falls by e, m.
    pub(super) fn front(&self) -> f64 {
        let root = self.speed.hypot(2.0 * self.spread * self.beta.sqrt());
        2.0 * self.spread * self.spread / (self.speed + root)
    }

    /// Rise at the source after `time` (s), K/W.
    pub(super) fn rise_at_tool(&self, time: f64) -> f64 {
        self.at(self.tool(time), Side::Right, time).0
    }

    /// Rise (K/W) and k A d(rise)/dx (W/W) at `x` (m), which lies on that side of the source, after `time`
    /// (s).
    pub(super) fn at(&self, x: f64, side: Side, time: f64) -> (f64, f64) {
        let sign = match side {
            Side::Left => -1.0,
            Side::Right => 1.0,
        };
        let r = time.sqrt();
        let distance = (sign * (x - self.tool(time))).max(0.0) / self.spread;
        if time <= 0.0 {
            let half = if distance > 0.0 { 0.0 } else { 0.5 };
            return (0.0, -sign * half);
        }
        let (a, b) = (sign * distance, self.speed / self.spread);
        let q = (self.beta + 0.25 * b * b).sqrt();
        let (near, far) = (0.5 * distance / r - q * r, 0.5 * distance / r + q * r);
        // `first` and `second` are e^(-a b / 2 -+ |a| q) erfc(near, far), without the overflow of either
        // factor.
        let common = (-self.beta * time - (0.5 * (a + b * time) / r).powi(2)).exp();
        let first = if near >= 0.0 {
            common * erfcx(near)
        } else {
            2.0 * (-0.5 * a * b - distance * q).exp() - common * erfcx(-near)
        };
        let second = common * erfcx(far);
        let integral = PI.sqrt() / (4.0 * q) * (first - second);
        let slope = -0.5 * b * integral - sign * 0.25 * PI.sqrt() * (first + second);
        (self.unit * integral, slope / PI.sqrt())
    }
}

/// exp(x^2) erfc(x) for x >= 0, to 2e-15 of its value: W. J. Cody, Math. Comp. 23 (1969) 631.
pub(super) fn erfcx(x: f64) -> f64 {
    if x <= 0.46875 {
        let square = x * x;
        square.exp() * (1.0 - x * ratio(&SMALL, square))
    } else if x <= 4.0 {
        ratio(&MEDIUM, x)
    } else {
        let square = 1.0 / (x * x);
        (1.0 / PI.sqrt() - square * ratio(&LARGE, square)) / x
    }
}

/// Ratio of two polynomials, the highest coefficients first.
fn ratio(coefficients: &[(f64, f64)], x: f64) -> f64 {
    let sums = coefficients.iter().fold((0.0, 0.0), |sums, c| (sums.0 * x + c.0, sums.1 * x + c.1));
    sums.0 / sums.1
}

/// erf(x) / x from x^2.
const SMALL: [(f64, f64); 5] = [
    (1.857_777_061_846_031_5e-1, 1.0),
    (3.161_123_743_870_565_6, 2.360_129_095_234_412_1e1),
    (1.138_641_541_510_501_6e2, 2.440_246_379_344_441_7e2),
    (3.774_852_376_853_02e2, 1.282_616_526_077_372_3e3),
    (3.209_377_589_138_469_5e3, 2.844_236_833_439_171e3),
];

/// exp(x^2) erfc(x) from x.
const MEDIUM: [(f64, f64); 9] = [
    (2.153_115_354_744_038_5e-8, 1.0),
    (5.641_884_969_886_701e-1, 1.574_492_611_070_983_5e1),
    (8.883_149_794_388_376, 1.176_939_508_913_125e2),
    (6.611_919_063_714_163e1, 5.371_811_018_620_099e2),
    (2.986_351_381_974_001e2, 1.621_389_574_566_690_2e3),
    (8.819_522_212_417_69e2, 3.290_799_235_733_459_6e3),
    (1.712_047_612_634_070_6e3, 4.362_619_090_143_247e3),
    (2.051_078_377_826_071_5e3, 3.439_367_674_143_721_6e3),
    (1.230_339_354_797_997_2e3, 1.230_339_354_803_749_4e3),
];

/// x^2 (1 / sqrt(pi) - x exp(x^2) erfc(x)) from 1 / x^2.
const LARGE: [(f64, f64); 6] = [
    (1.631_538_713_730_209_8e-2, 1.0),
    (3.053_266_349_612_323_4e-1, 2.568_520_192_289_822),
    (3.603_448_999_498_044_4e-1, 1.872_952_849_923_467_3),
    (1.257_817_261_112_292_5e-1, 5.279_051_029_514_284e-1),
    (1.608_378_514_874_228e-2, 6.051_834_131_244_132e-2),
    (6.587_491_615_298_378e-4, 2.335_204_976_268_691_8e-3),
];
