//! A stretch of the motion on which slide and cam go linearly.

use super::super::search::root;
use super::reach::{Ray, Reach, lowest_of_capsule};
use crate::processes::cam::profile::{Vector, direction, left};

/// Shorter parts of a leg are not divided any more: over one a wheel moves by less than round-off in what it
/// leaves.
const SHORTEST: f64 = 1e-8;
/// Parts that can wait: one more than the halvings down to the shortest.
const LEVELS: usize = 32;

/// The shape over time, as far as it is proved, of what a part of a leg leaves.
enum Bend {
    Convex,
    Concave,
    /// Nothing is proved.
    Open,
}

/// A stretch of the motion from t = 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Leg {
    /// Polar angle of the slide's line in the cam at the beginning, and by how much it grows, rad.
    pub turn: (f64, f64),
    /// Place of the slide at the beginning, and its way, m.
    pub slide: (f64, f64),
    /// Height of the wheel above the cam's axis, m.
    pub height: f64,
    /// Block of the programme to which it belongs.
    pub block: usize,
    /// The part of the block that it is: from, to.
    pub part: (f64, f64),
    /// The wheel's centre at both ends, m.
    pub ends: [Vector; 2],
    /// The wheel's centre is nowhere farther than this from the chord between its ends, m.
    pub bow: f64,
}

impl Leg {
    /// A leg of a block.
    pub fn new(turn: (f64, f64), slide: (f64, f64), height: f64, block: usize, part: (f64, f64)) -> Self {
        let mut leg = Self { turn, slide, height, block, part, ends: [Vector::zeros(); 2], bow: 0.0 };
        leg.ends = [leg.centre(0.0), leg.centre(1.0)];
        // Linear interpolation of a vector errs by no more than an eighth of the greatest second derivative.
        leg.bow = leg.greatest_acceleration() / 8.0;
        leg
    }

    /// The wheel's centre and its first two derivatives by t, m.
    pub fn motion(&self, t: f64) -> [Vector; 3] {
        let (e, x) = (direction(self.turn.0 + self.turn.1 * t), self.slide.0 + self.slide.1 * t);
        let (across, rate, rise) = (left(&e), self.turn.1, self.slide.1);
        [
            e * x + across * self.height,
            e * (rise - self.height * rate) + across * (x * rate),
            across * ((2.0 * rise - self.height * rate) * rate) - e * (x * rate * rate),
        ]
    }

    /// The wheel's centre, m.
    pub fn centre(&self, t: f64) -> Vector {
        self.motion(t)[0]
    }

    /// Its derivative by t, m.
    pub fn velocity(&self, t: f64) -> Vector {
        self.motion(t)[1]
    }

    fn greatest_slide(&self) -> f64 {
        self.slide.0.abs().max((self.slide.0 + self.slide.1).abs())
    }

    fn greatest_speed(&self) -> f64 {
        (self.slide.1 - self.height * self.turn.1).hypot(self.greatest_slide() * self.turn.1)
    }

    fn greatest_acceleration(&self) -> f64 {
        let rate = self.turn.1;
        (self.greatest_slide() * rate * rate).hypot((2.0 * self.slide.1 - self.height * rate) * rate)
    }

    fn greatest_jerk(&self) -> f64 {
        let rate = self.turn.1;
        (self.greatest_slide() * rate * rate).hypot((3.0 * self.slide.1 - self.height * rate) * rate) * rate.abs()
    }

    /// Lowers `best` by what a wheel of `radius` leaves along the ray between two times of this leg, which
    /// has number `leg`.
    ///
    /// The rest g(t) that a position leaves has the slope W'·u/(u·n), with u from the point
    /// that is cut to the wheel's centre: where the slope vanishes the wheel touches its envelope. A part of
    /// the leg on which g is proved convex holds one such point at most, between ends whose slopes tell
    /// whether there is one; where g is proved concave an end is lowest; other parts are halved. Parts that
    /// by their chord cannot lie lower are left out.
    pub fn lower(&self, ray: &Ray, radius: f64, leg: usize, times: (f64, f64), best: &mut Reach) {
        // Halving in order of time, no more than one part waits on each level.
        let mut parts = [times; LEVELS];
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let (from, to) = parts[waiting];
            let whole = (from, to) == (0.0, 1.0);
            let ends = if whole { self.ends } else { [self.centre(from), self.centre(to)] };
            let bow = self.bow * (to - from) * (to - from);
            if lowest_of_capsule(ray, &ends, radius, bow) >= best.left {
                continue;
            }
            let middle = 0.5 * (from + to);
            let mut take = |t| best.lower(Reach { left: ray.left_by(&self.centre(t), radius), leg, at: t });
            match self.bend(ray, radius, middle, 0.5 * (to - from)) {
                Bend::Convex => take(self.lowest(ray, radius, from, to)),
                Bend::Open if to - from > SHORTEST && waiting + 2 <= LEVELS => {
                    parts[waiting] = (middle, to);
                    parts[waiting + 1] = (from, middle);
                    waiting += 2;
                }
                Bend::Concave | Bend::Open => [from, to].into_iter().for_each(take),
            }
        }
    }

    /// The bend of g for certain within `half` of `middle`: g'' has the sign of u·W'' + b'²/(R·cos²β),
    /// with b the distance of the centre beside the ray and sin β = b/R, and neither term can change by more
    /// than its bound.
    fn bend(&self, ray: &Ray, radius: f64, middle: f64, half: f64) -> Bend {
        let (speed, acceleration) = (self.greatest_speed(), self.greatest_acceleration());
        let [centre, velocity, accelerated] = self.motion(middle);
        let beside = ray.beside(&centre);
        let widest = (beside.abs() + speed * half) / radius;
        if widest >= 1.0 {
            return Bend::Open;
        }
        // Least cos β over the part.
        let cosine = (1.0 - widest * widest).sqrt();
        let swing = speed / (radius * cosine);
        let sine = beside / radius;
        let u = ray.normal * (1.0 - sine * sine).sqrt() + ray.across() * sine;
        let b = ray.across().dot(&velocity);
        let bend = u.dot(&accelerated) + b * b / (radius * (1.0 - sine * sine));
        let of_first = swing * acceleration + self.greatest_jerk();
        let of_second = 2.0 * speed * acceleration / (radius * cosine * cosine)
            + 2.0 * speed * speed * widest * swing / (radius * cosine.powi(3));
        let change = (of_first + of_second) * half;
        match bend {
            bend if bend > change => Bend::Convex,
            bend if bend < -change => Bend::Concave,
            _ => Bend::Open,
        }
    }

    /// The time at which g is least between two times between which it is convex.
    fn lowest(&self, ray: &Ray, radius: f64, from: f64, to: f64) -> f64 {
        // (W'·u, its derivative by t)
        let slope = |t: f64| {
            let [centre, velocity, acceleration] = self.motion(t);
            let sine = ray.beside(&centre) / radius;
            let cosine = (1.0 - sine * sine).max(0.0).sqrt();
            let (along, across) = (ray.normal, ray.across());
            let u = along * cosine + across * sine;
            let b = across.dot(&velocity);
            let swing = b / (radius * cosine);
            let bend = u.dot(&acceleration) + velocity.dot(&(across * cosine - along * sine)) * swing;
            (velocity.dot(&u), bend)
        };
        if slope(from).0 >= 0.0 {
            return from;
        }
        if slope(to).0 <= 0.0 {
            return to;
        }
        let step = |t: f64| {
            let (value, bend) = slope(t);
            -value / bend
        };
        // g is flat there: at this distance from its least it is the same to round-off.
        root(step, 0.5 * (from + to), (from, to), 1e-11)
    }

    /// The unit normal of the path that points away from the cam, where the path is walked the way of
    /// `sense`.
    pub fn outwards(&self, t: f64, sense: f64) -> Vector {
        -left(&self.velocity(t).normalize()) * sense
    }

    /// The point at which a wheel of `radius` touches its envelope, m.
    pub fn grinding_point(&self, t: f64, radius: f64, sense: f64) -> Vector {
        self.centre(t) - self.outwards(t, sense) * radius
    }

    /// Speed of the grinding point along the envelope by t, forwards positive, m.
    pub fn grinding_speed(&self, t: f64, radius: f64, sense: f64) -> f64 {
        let [_, velocity, acceleration] = self.motion(t);
        let speed = velocity.norm();
        // Curvature of the path, positive where it is convex.
        let curvature = sense * velocity.perp(&acceleration) / speed.powi(3);
        speed * (1.0 - radius * curvature)
    }

    /// Length of the envelope of a wheel of `radius` between two times of the leg, m, by Gauss's rule on
    /// eight parts; the integrand is smooth.
    pub fn envelope(&self, radius: f64, sense: f64, (from, to): (f64, f64)) -> f64 {
        const PARTS: u32 = 8;
        let side = 0.6f64.sqrt();
        let rule = [(-side, 5.0 / 18.0), (0.0, 8.0 / 18.0), (side, 5.0 / 18.0)];
        let part = (to - from) / f64::from(PARTS);
        let of = |k: u32| {
            let at = |(x, weight): (f64, f64)| {
                weight * self.grinding_speed(from + (f64::from(k) + 0.5 + 0.5 * x) * part, radius, sense).abs()
            };
            part * rule.map(at).iter().sum::<f64>()
        };
        (0..PARTS).map(of).sum()
    }
}
