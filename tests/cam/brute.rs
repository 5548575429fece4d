//! A cam grinder by brute force: the axes stepped through time, the wheel put down thousands of times a
//! turn. Shares nothing with the program: its own geometry, its own programme, no envelope, no search.

use std::f64::consts::{PI, TAU};

/// A segment of a profile, mm.
#[derive(Clone, Copy)]
pub enum Segment {
    /// From, to.
    Line([f64; 2], [f64; 2]),
    /// Centre, radius, angle at the beginning, sweep (rad).
    Arc([f64; 2], f64, f64, f64),
}

/// A convex profile that is walked counter-clockwise, ground in so many blocks per segment.
pub struct Job {
    pub segments: Vec<(Segment, usize)>,
    /// mm.
    pub wheel: f64,
    /// rad/s.
    pub speed: f64,
    pub is_reversed: bool,
}

/// What the machine adds; mm, s, mm/N.
#[derive(Clone, Copy, Default)]
pub struct Causes {
    pub loss: f64,
    pub lag: f64,
    pub gap: f64,
    pub height: f64,
    /// Deviation per feed of the grinding point, s.
    pub yielding: f64,
}

impl Segment {
    fn length(&self) -> f64 {
        match *self {
            Self::Line(a, b) => (b[0] - a[0]).hypot(b[1] - a[1]),
            Self::Arc(_, r, _, sweep) => r * sweep,
        }
    }

    /// Point and outward normal.
    fn at(&self, part: f64) -> ([f64; 2], [f64; 2]) {
        match *self {
            Self::Line(a, b) => {
                let l = self.length();
                let n = [(b[1] - a[1]) / l, -(b[0] - a[0]) / l];
                ([a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])], n)
            }
            Self::Arc(c, r, from, sweep) => {
                let angle = from + part * sweep;
                let n = [angle.cos(), angle.sin()];
                ([c[0] + r * n[0], c[1] + r * n[1]], n)
            }
        }
    }

    fn centre(&self, part: f64, wheel: f64) -> [f64; 2] {
        let (p, n) = self.at(part);
        [p[0] + wheel * n[0], p[1] + wheel * n[1]]
    }
}

/// Steps of time in each block.
const STEPS: usize = 160;

impl Job {
    /// (polar angle, distance) of the wheel's centre at the ends of blocks, the angle counted on.
    fn points(&self) -> Vec<(f64, f64)> {
        let mut points: Vec<(f64, f64)> = Vec::new();
        for (segment, count) in &self.segments {
            for k in 0..*count {
                points.push(polar(segment.centre(k as f64 / *count as f64, self.wheel), points.last()));
            }
        }
        let first = points[0];
        points.push((first.0 + TAU, first.1));
        if self.is_reversed {
            points.reverse();
        }
        points
    }

    /// The wheel's centre at many moments of a turn.
    fn positions(&self, causes: &Causes) -> Vec<[f64; 2]> {
        let points = self.points();
        let times: Vec<f64> = points.iter().map(|p| (p.0 - points[0].0).abs() / self.speed).collect();
        let period = TAU / self.speed;
        let command = |time: f64| {
            let time = time.rem_euclid(period);
            let i = times.iter().position(|t| *t > time).unwrap_or(times.len() - 1).max(1);
            let part = (time - times[i - 1]) / (times[i] - times[i - 1]);
            points[i - 1].1 + part * (points[i].1 - points[i - 1].1)
        };
        let way = if self.is_reversed { -1.0 } else { 1.0 };
        // At even steps, and where the slide's command bends.
        let mut moments: Vec<f64> = times[1..].iter().map(|t| (t + causes.lag).rem_euclid(period)).collect();
        for w in times.windows(2) {
            moments.extend((0..STEPS).map(|k| w[0] + (w[1] - w[0]) * k as f64 / STEPS as f64));
        }
        moments.sort_by(f64::total_cmp);
        let mut slide = command(-causes.lag);
        let mut positions = Vec::new();
        for turn in 0..2 {
            for time in &moments {
                let wanted = command(time - causes.lag);
                slide = slide.max(wanted - causes.gap / 2.0).min(wanted + causes.gap / 2.0);
                if turn == 1 {
                    let (sine, cosine) = (points[0].0 + way * self.speed * time).sin_cos();
                    positions.push([slide * cosine - causes.height * sine, slide * sine + causes.height * cosine]);
                }
            }
        }
        positions
    }

    /// Deviations (mm) at polar angles (rad).
    pub fn deviations(&self, causes: &Causes, angles: &[f64]) -> Vec<f64> {
        let positions = self.positions(causes);
        let wheel = self.wheel - causes.loss;
        let of = |angle: &f64| {
            let (segment, part) = self.find(*angle);
            let (p, n) = segment.at(part);
            let left = |w: &[f64; 2]| {
                let d = [w[0] - p[0], w[1] - p[1]];
                let (above, beside) = (d[0] * n[0] + d[1] * n[1], d[1] * n[0] - d[0] * n[1]);
                if beside.abs() < wheel && above > 0.0 {
                    above - (wheel * wheel - beside * beside).sqrt()
                } else {
                    f64::INFINITY
                }
            };
            positions.iter().map(left).fold(f64::INFINITY, f64::min) + causes.yielding * self.feed(segment, part)
        };
        angles.iter().map(of).collect()
    }

    /// Speed of the grinding point along the ideal profile, mm/s, by a difference.
    fn feed(&self, segment: Segment, part: f64) -> f64 {
        let step = 1e-5;
        let at = |p: f64| polar(segment.centre(p, self.wheel), None).0;
        let turn = (at(part + step) - at(part - step) + PI).rem_euclid(TAU) - PI;
        self.speed * 2.0 * step * segment.length() / turn
    }

    /// The segment and the part of it at a polar angle, by halving.
    fn find(&self, angle: f64) -> (Segment, f64) {
        let target = [angle.cos(), angle.sin()];
        for (segment, _) in &self.segments {
            const PIECES: usize = 64;
            for k in 0..PIECES {
                let ahead = |part: f64| {
                    let p = segment.at(part).0;
                    (p[0] * target[1] - p[1] * target[0], p[0] * target[0] + p[1] * target[1])
                };
                let (mut low, mut high) = (k as f64 / PIECES as f64, (k + 1) as f64 / PIECES as f64);
                if ahead(low).1 <= 0.0 || ahead(low).0 < 0.0 || ahead(high).0 >= 0.0 {
                    continue;
                }
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if ahead(middle).0 >= 0.0 { low = middle } else { high = middle }
                }
                return (*segment, 0.5 * (low + high));
            }
        }
        panic!("no point of the profile at {angle} rad");
    }
}

fn polar(w: [f64; 2], last: Option<&(f64, f64)>) -> (f64, f64) {
    let angle = w[1].atan2(w[0]);
    let angle = last.map_or(angle, |last| last.0 + (angle - last.0 + PI).rem_euclid(TAU) - PI);
    (angle, w[0].hypot(w[1]))
}

/// Normal deviates, always the same for a seed.
pub struct Noise(u64);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    pub fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}
