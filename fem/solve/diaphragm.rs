//! A thin circular plate that is clamped around its edge, bent by moments on a circle and pushed in its middle.
//!
//! With w the deflection, a the radius of the edge, D the rigidity and M·cos mθ a moment per length on the circle r = b, which turns
//! the plate there in a plane through its axis, D·∇⁴w = 0 within and outside of the circle, and across it
//!
//! ```text
//!   [w] = [w'] = 0,  [w''] = −M/D,  [w'''] = M/(D·b)        w = w' = 0 at r = a
//! ```
//!
//! (the last two say that the radial moment jumps by M and the shear not at all). For m = 0 the slope at the circle is
//! M·b·(1 − b²/a²)/2D. For m ≥ 2 the difference of the two sides, with x = r/b and M·b²/D = 1, is
//!
//! ```text
//!   g = −Σ a_p·x^p,  a_p = (p − 2)/Π(p − q)   over p, q of m, m + 2, −m, 2 − m
//! ```
//!
//! and the powers m and m + 2 of the inside follow from the clamped edge. Moments of jaws add up, each spread evenly over its root. A push P on a
//! circle of radius c within b makes the slope P·[b·ln(a/b) − c²/2·(1/b − b/a²)]/4πD there. Deflections are small beside the
//! thickness, and shear bends nothing [Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, ch. 3 and 9].

use std::f64::consts::{PI, TAU};

/// A plate that is clamped around.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diaphragm {
    /// a, m.
    pub radius: f64,
    /// h, m.
    pub thickness: f64,
    /// E, Pa.
    pub youngs_modulus: f64,
    /// ν.
    pub poisson_ratio: f64,
}

/// Arms that stand evenly around on a circle of the plate, each turned by the same moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arms {
    /// b, m.
    pub circle: f64,
    /// How many, two at least.
    pub count: usize,
    /// Full angle of the circle over which each is rooted, rad; at most that from arm to arm.
    pub root: f64,
}

/// A plate under a unit of load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// Slope at the circle of the arms, mean over a root.
    pub slope: f64,
    /// Deflection of the middle, m.
    pub deflection: f64,
    /// Largest radial bending moment per length, of arms at the middle of a root or at the edge, of a push in the middle or at the edge, N.
    pub moment: f64,
}

impl Bent {
    /// Under so many units of the load.
    #[must_use]
    pub fn times(self, load: f64) -> Self {
        let Self { slope, deflection, moment } = self;
        Self { slope: load * slope, deflection: load * deflection, moment: load.abs() * moment }
    }
}

/// What one wave of moment does, for M = 1.
struct Wave {
    /// Slope times D/b.
    slope: f64,
    /// Radial moments within and outside of the circle, and at the edge.
    moments: [f64; 3],
    /// Coefficients of the deflection times D/b² within the circle, of x^m and x^(m + 2).
    inside: [f64; 2],
    /// Outside of it, of the same powers of r/a, and of its powers −m and 2 − m.
    outside: [f64; 4],
}

/// Harmonics of a root are counted up to this many radians across it.
const ACROSS: f64 = 1500.0;
/// And so many of them at most: a narrower root is as good as a point.
const MOST: usize = 20_000;
/// Of the deflection, which falls with the cube of the wave, so many are counted.
const SEEN: usize = 40;

impl Diaphragm {
    /// D = E·h³/12(1 − ν²), N·m.
    fn rigidity(&self) -> f64 {
        self.youngs_modulus * self.thickness.powi(3) / (12.0 * (1.0 - self.poisson_ratio * self.poisson_ratio))
    }

    /// The plate under a moment of 1 N·m on every arm.
    pub fn under_arms(&self, arms: &Arms) -> Bent {
        let Arms { circle, count, root } = *arms;
        // Moment per length, if it were even around.
        let mean = count as f64 / (TAU * circle);
        let even = self.even(circle);
        let mut slope = even.slope;
        // Across the circle the moment jumps by what is on the root; what else there is falls with the wave's length.
        let local = TAU / (count as f64 * root);
        let beside = |wave: &Wave| 0.5 * (wave.moments[0] + wave.moments[1]);
        let (mut at_root, mut at_edge) = (beside(&even), even.moments[2]);
        for m in (1..MOST).map(|k| k * count).take_while(|m| (*m as f64) * root < ACROSS) {
            let wave = self.wave(circle, m);
            let half = 0.5 * m as f64 * root;
            let spread = half.sin() / half;
            slope += 2.0 * wave.slope * spread * spread;
            at_root += 2.0 * beside(&wave) * spread;
            at_edge += 2.0 * wave.moments[2] * spread;
        }
        let moment = (at_root.abs() + 0.5 * local).max(at_edge.abs());
        Bent {
            slope: mean * slope * circle / self.rigidity(),
            deflection: mean * circle * circle * (self.radius / circle).ln() / (2.0 * self.rigidity()),
            moment: mean * moment,
        }
    }

    /// Deflection (m) towards the arms of places at a radius (m) and an angle (rad) from the middle of an arm, under a moment of
    /// 1 N·m on every arm that turns it outwards.
    pub fn deflections(&self, arms: &Arms) -> impl Fn(f64, f64) -> f64 + use<> {
        let Arms { circle, count, root } = *arms;
        let s = self.radius / circle;
        let size = count as f64 * circle / (TAU * self.rigidity());
        let spread = |m: usize| {
            let half = 0.5 * m as f64 * root;
            half.sin() / half
        };
        let all = (1..=SEEN).map(|k| k * count);
        let waves: Vec<(usize, f64, Wave)> = all.map(|m| (m, spread(m), self.wave(circle, m))).collect();
        move |radius, angle| {
            let x = radius / circle;
            let even = match x < 1.0 {
                true => 0.5 * s.ln() - 0.25 * (1.0 - 1.0 / (s * s)) * x * x,
                false => 0.5 * ((s / x).ln() - 0.5 * (1.0 - (x / s).powi(2))),
            };
            let uneven = waves.iter().map(|(m, spread, wave)| {
                let order = *m as i32;
                let powers = [order, order + 2, -order, 2 - order];
                let of = |terms: &[f64], place: f64| {
                    terms.iter().zip(powers).map(|(term, power)| term * place.powi(power)).sum::<f64>()
                };
                let away = if x < 1.0 { of(&wave.inside, x) } else { of(&wave.outside, x / s) };
                -2.0 * spread * away * (*m as f64 * angle).cos()
            });
            size * (even + uneven.sum::<f64>())
        }
    }

    /// Deflection (m) at a radius (m) under a push of 1 N on a circle of radius `pusher` (m).
    pub fn deflection_pushed(&self, pusher: f64, radius: f64) -> f64 {
        let (a, c, r) = (self.radius, pusher, radius.max(pusher));
        let far = 0.25 * (a * a - r * r) - 0.5 * r * r * (a / r).ln();
        let near = 0.5 * c * c * ((a / r).ln() - 0.5 * (1.0 - (r / a).powi(2)));
        // Within its circle a push bends the plate evenly.
        let steep = c * (a / c).ln() - 0.5 * c * (1.0 - (c / a).powi(2));
        let within = 0.5 * steep * (c - radius.min(c).powi(2) / c);
        (far - near + within) / (4.0 * PI * self.rigidity())
    }

    /// The plate under a push of 1 N on a circle of radius `pusher` (m), within that at which the slope is asked for.
    pub fn pushed(&self, pusher: f64, circle: f64) -> Bent {
        let (a, b, c) = (self.radius, circle, pusher);
        let part = 1.0 / (4.0 * PI * self.rigidity());
        let edge = (1.0 - (c / a).powi(2)) / (4.0 * PI);
        let middle = (1.0 + self.poisson_ratio) / (4.0 * PI) * ((a / c).ln() - 0.5 * (1.0 - (c / a).powi(2)));
        Bent {
            slope: part * (b * (a / b).ln() - 0.5 * c * c * (1.0 / b - b / (a * a))),
            deflection: 0.25 * part * (a * a - c * c - 2.0 * c * c * (a / c).ln()),
            moment: edge.max(middle),
        }
    }

    /// Bending stress under a moment per length (N), Pa: 6·M/h².
    pub fn stress(&self, moment: f64) -> f64 {
        6.0 * moment / (self.thickness * self.thickness)
    }

    /// A moment that is even around.
    fn even(&self, circle: f64) -> Wave {
        let beta = (circle / self.radius).powi(2);
        let inside = 0.5 * (1.0 + self.poisson_ratio) * (1.0 - beta);
        let moments = [-inside, 1.0 - inside, beta];
        Wave { slope: 0.5 * (1.0 - beta), moments, inside: [0.0; 2], outside: [0.0; 4] }
    }

    /// A moment of m ≥ 2 waves around.
    fn wave(&self, circle: f64, m: usize) -> Wave {
        let (wave, s) = (m as f64, self.radius / circle);
        let powers = [wave, wave + 2.0, -wave, 2.0 - wave];
        let own = |p: f64| -(p - 2.0) / powers.iter().filter(|q| **q != p).map(|q| p - q).product::<f64>();
        // At the edge: the powers that fall outwards, and those that grow, which hold it clamped.
        let [falling, slowly] = [powers[2], powers[3]].map(|p| own(p) * s.powf(p));
        let steep = wave * falling + (wave - 1.0) * slowly;
        let grown = [-falling - slowly - steep, steep];
        let [one, two] = [0, 1].map(|i| grown[i] * s.powf(-powers[i]) - own(powers[i]));
        let slope = wave * one + (wave + 2.0) * two;
        let curvature = |terms: &[(f64, f64)]| terms.iter().map(|(p, term)| p * (p - 1.0) * term).sum::<f64>();
        let inner = curvature(&[(powers[0], one), (powers[1], two)]);
        let inside = -(inner + self.poisson_ratio * (slope - wave * wave * (one + two)));
        let outer = [(powers[0], grown[0]), (powers[1], grown[1]), (powers[2], falling), (powers[3], slowly)];
        let moments = [inside, inside + 1.0, -curvature(&outer) / (s * s)];
        Wave { slope, moments, inside: [one, two], outside: outer.map(|(_, term)| term) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLATE: Diaphragm = Diaphragm { radius: 0.1, thickness: 0.008, youngs_modulus: 210e9, poisson_ratio: 0.3 };

    /// Slopes of the plate by cubic Hermite elements along the radius, as parts of M·b/D.
    #[test]
    fn waves_turn_the_circle_as_elements_along_the_radius_say() {
        for (beta, m, expected) in
            [(0.4, 2, 0.109_536), (0.6, 3, 0.066_048), (0.6, 12, 0.020_970_85), (0.85, 6, 0.032_702_64)]
        {
            let slope = PLATE.wave(0.1 * beta, m).slope;
            assert!((slope - expected).abs() < 1e-8, "{beta} {m}: {slope}");
        }
        // Far from the edge a short wave has the slope b/4mD of an endless plate.
        assert!((PLATE.wave(0.05, 40).slope * 160.0 - 1.0).abs() < 1e-3);
    }

    /// Deflections have the slopes that are computed by themselves, and are the deflection of the middle there.
    #[test]
    fn deflections_are_those_of_their_slopes() {
        let arms = Arms { circle: 0.06, count: 6, root: 0.3 };
        let (bent, deflection) = (PLATE.under_arms(&arms), PLATE.deflections(&arms));
        assert!((deflection(0.0, 0.2) / bent.deflection - 1.0).abs() < 1e-9);
        let step = 1e-6;
        let places = (0..200).map(|i| 0.3 * ((i as f64 + 0.5) / 200.0 - 0.5));
        let steep = |radius: f64, angle: f64| {
            (deflection(radius - step, angle) - deflection(radius + step, angle)) / (2.0 * step)
        };
        let mean = places.map(|angle| steep(0.06, angle)).sum::<f64>() / 200.0;
        assert!((mean / bent.slope - 1.0).abs() < 1e-3, "{mean} {}", bent.slope);
        for angle in [0.0, 0.1, 0.5] {
            assert!(deflection(0.1, angle).abs() < 1e-12 * bent.deflection);
            assert!(steep(0.1 - step, angle).abs() < 1e-3 * bent.slope);
        }
        let pushed = PLATE.pushed(0.02, 0.06);
        let at = |radius: f64| PLATE.deflection_pushed(0.02, radius);
        assert!((at(0.0) / pushed.deflection - 1.0).abs() < 1e-12 && at(0.1) == 0.0);
        let slope = (at(0.06 - step) - at(0.06 + step)) / (2.0 * step);
        assert!((slope / pushed.slope - 1.0).abs() < 1e-6, "{slope} {}", pushed.slope);
    }

    #[test]
    fn a_push_and_the_moments_of_arms_do_the_same_work_on_each_other() {
        let arms = Arms { circle: 0.06, count: 6, root: TAU / 6.0 };
        let pusher = 1e-6;
        let (moved, pushed) = (PLATE.under_arms(&arms), PLATE.pushed(pusher, arms.circle));
        assert!((6.0 * pushed.slope / moved.deflection - 1.0).abs() < 1e-9);
    }

    #[test]
    fn roots_that_reach_around_bend_the_plate_evenly() {
        let around = Arms { circle: 0.06, count: 4, root: TAU / 4.0 };
        let rigidity = 210e9 * 0.008f64.powi(3) / (12.0 * 0.91);
        let expected = 4.0 / (TAU * 0.06) * 0.06 * (1.0 - 0.36) / (2.0 * rigidity);
        assert!((PLATE.under_arms(&around).slope / expected - 1.0).abs() < 1e-12);
        let narrow = PLATE.under_arms(&Arms { root: 0.2, ..around });
        assert!(narrow.slope > 1.2 * expected && narrow.moment > PLATE.under_arms(&around).moment);
    }
}
