//! What each block of the programme does: errors, envelope and imprints, jumps and back-sweeps, feed, and the metal it removes.

use rayon::prelude::*;

use super::contact::{self, Removal};
use super::extreme::peak;
use super::machine::Machine;
use super::motion::{Motion, Ray, Reach};
use super::profile::turn;
use super::program::Program;

/// Everything about one block.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Place of the profile where it begins and ends, m.
    pub places: (f64, f64),
    /// Time it takes, s.
    pub time: f64,
    /// The most that is left between its places, and where: (m, s).
    pub thickest: (f64, f64),
    /// The least that is left between its places, and where: (m, s).
    pub thinnest: (f64, f64),
    /// How deep the block itself cuts into the ideal profile, wherever, m; negative where it stays clear.
    pub overcut: f64,
    /// Length of the whole envelope over the block, m.
    pub envelope: f64,
    /// Length of profile that its envelope has given the final shape, m.
    pub shaped: f64,
    /// Length of profile that has the imprint of the wheel as it stands at the end of the block, m.
    pub imprint: f64,
    /// How far the grinding point moves at once at the end of the block, forwards positive: a jump, or a back-sweep, m.
    pub jump: f64,
    /// Least and greatest speed of the grinding point along its envelope, forwards positive, m/s.
    pub feed: (f64, f64),
    /// What it removes, where the layer is known.
    pub removal: Option<Removal>,
}

/// Everything about a programme.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// In the order in which they are executed.
    pub blocks: Vec<Block>,
    /// The worst overcut by a block that grinds elsewhere: (m, place that is cut, place that is ground), if there is any.
    pub collision: Option<(f64, f64, f64)>,
}

/// A place of the profile and what shapes it last.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sample {
    s: f64,
    left: f64,
    by: Shaper,
}

/// What gives a place its final shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shaper {
    /// The envelope of a block.
    Envelope(usize),
    /// The wheel as it stands at the end of a leg.
    Imprint(usize),
}

/// Places looked at in a block, fewer where there are many blocks, and more where its neighbours are much shorter and may reach into it.
pub fn samples(program: &Program, block: usize) -> usize {
    let count = program.blocks();
    let usual = (17_280 / count).clamp(6, 24) as f64;
    let length = |block: usize| program.places[block + 1] - program.places[block];
    let shortest = length((block + count - 1) % count).min(length((block + 1) % count)).min(length(block));
    (usual * length(block) / shortest).ceil().min(400.0) as usize
}

/// Looks at every block of the programme as the machine executes it, forwards.
pub fn report(machine: &Machine, motion: &Motion) -> Report {
    let view = View { machine, motion };
    let program = &machine.setup.program;
    let of_block = |block: usize| {
        let count = samples(program, block);
        (0..count).filter_map(|k| view.sample(view.place(block, (k as f64 + 0.5) / count as f64))).collect()
    };
    let samples: Vec<Vec<Sample>> = (0..program.blocks()).into_par_iter().map(of_block).collect();
    let lengths = view.lengths(&samples.concat());
    let removals = machine.setup.stock.map(|stock| contact::removals(machine, motion, stock));
    let block = |i: usize| Block {
        removal: removals.as_ref().map(|r| r[i].clone()),
        shaped: lengths.0[i],
        imprint: lengths.1[i],
        ..view.block(i, &samples[i])
    };
    let blocks = (0..program.blocks()).into_par_iter().map(block).collect();
    Report { blocks, collision: view.collision(&samples.concat()) }
}

struct View<'a> {
    machine: &'a Machine,
    motion: &'a Motion,
}

impl View<'_> {
    /// The place of the profile at a part of a block, m.
    fn place(&self, block: usize, part: f64) -> f64 {
        let places = &self.machine.setup.program.places;
        places[block] + part * (places[block + 1] - places[block])
    }

    fn reach(&self, s: f64) -> Option<Reach> {
        let setup = &self.machine.setup;
        self.motion.left_along(&Ray::from(setup.profile.at(s)), self.motion.first_leg(setup.program.block_at(s)))
    }

    fn left(&self, s: f64) -> f64 {
        let deflection = self.machine.given_way(s, self.machine.usual());
        self.reach(s).map_or(f64::NAN, |reach| reach.left + deflection)
    }

    fn sample(&self, s: f64) -> Option<Sample> {
        let reach = self.reach(s)?;
        let legs = self.motion.legs().len();
        let by = match reach.at {
            0.0 => Shaper::Imprint((reach.leg + legs - 1) % legs),
            1.0 => Shaper::Imprint(reach.leg),
            _ => Shaper::Envelope(self.motion.legs()[reach.leg].block),
        };
        Some(Sample { s, left: reach.left, by })
    }

    /// Everything about a block but lengths and removal.
    fn block(&self, block: usize, samples: &[Sample]) -> Block {
        let setup = &self.machine.setup;
        let (from, to) = (self.place(block, 0.0), self.place(block, 1.0));
        let extreme = |sign: f64| {
            let worse = |a: &&Sample, b: &&Sample| (sign * a.left).total_cmp(&(sign * b.left));
            let Some(worst) = samples.iter().max_by(worse) else { return (f64::NAN, from) };
            let reach = (to - from) / samples.len() as f64;
            let (s, value) = peak(|s| sign * self.left(s), (worst.s - reach).max(from), (worst.s + reach).min(to), 5);
            (sign * value, s)
        };
        let times = &setup.program.axes.times;
        let time = times[block + 1] - times[block];
        let radius = self.motion.radius();
        let sense = setup.profile.sense();
        let legs = || {
            let first = self.motion.first_leg(block);
            self.motion.legs()[first..].iter().take_while(move |leg| leg.block == block)
        };
        let speeds: Vec<f64> = legs()
            .flat_map(|leg| {
                let duration = (leg.part.1 - leg.part.0) * time;
                (0..=8).map(move |k| leg.grinding_speed(f64::from(k) / 8.0, radius, sense) / duration)
            })
            .collect();
        let overcut = legs().map(|leg| {
            let within = (self.place(block, leg.part.0), self.place(block, leg.part.1));
            super::fewest::overcut(&setup.profile, leg, radius, within)
        });
        Block {
            places: (from, to),
            time,
            thickest: extreme(1.0),
            thinnest: extreme(-1.0),
            overcut: overcut.fold(f64::NEG_INFINITY, f64::max),
            envelope: legs().map(|leg| leg.envelope(radius, sense)).sum(),
            shaped: 0.0,
            imprint: 0.0,
            jump: self.jump(block, radius, sense),
            feed: (
                speeds.iter().copied().fold(f64::INFINITY, f64::min),
                speeds.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ),
            removal: None,
        }
    }

    /// The path turns at once between two blocks, and the grinding point about the wheel with it: to the left of a path about the cam
    /// counter-clockwise it goes back.
    fn jump(&self, block: usize, radius: f64, sense: f64) -> f64 {
        let legs = self.motion.legs();
        let next = self.motion.first_leg((block + 1) % self.machine.setup.program.blocks());
        let last = (next + legs.len() - 1) % legs.len();
        -sense * radius * turn(&legs[last].velocity(1.0), &legs[next].velocity(0.0))
    }

    /// Lengths of profile that each block's envelope shapes, and that the wheel shapes as it stands at each block's end.
    fn lengths(&self, samples: &[Sample]) -> (Vec<f64>, Vec<f64>) {
        let blocks = self.machine.setup.program.blocks();
        let length = self.machine.setup.profile.length();
        let borders: Vec<(f64, f64)> = (0..samples.len())
            .into_par_iter()
            .map(|i| {
                let (a, mut b) = (samples[i], samples[(i + 1) % samples.len()]);
                if b.s < a.s {
                    b.s += length;
                }
                self.border(a, b)
            })
            .collect();
        let (mut shaped, mut imprints) = (vec![0.0; blocks], vec![0.0; blocks]);
        let mut add = |by: Shaper, own: f64| match by {
            Shaper::Envelope(block) => shaped[block] += own,
            Shaper::Imprint(leg) => imprints[self.motion.legs()[leg].block] += own,
        };
        for (i, sample) in samples.iter().enumerate() {
            let before = borders[(i + samples.len() - 1) % samples.len()].1;
            let before = if before > sample.s { before - length } else { before };
            let own = borders[i].0 - before;
            add(sample.by, own);
            // What is shorter than the samples are apart, as a rule the imprint of a small jump.
            let (from, to) = borders[i];
            if let Some(between) = (to > from).then(|| self.sample(0.5 * (from + to))).flatten() {
                add(between.by, to - from);
            }
        }
        (shaped, imprints)
    }

    /// Between two neighbouring places: how far what shapes the first goes, and from where on what shapes the second does.
    fn border(&self, a: Sample, b: Sample) -> (f64, f64) {
        if a.by == b.by {
            let middle = 0.5 * (a.s + b.s);
            return (middle, middle);
        }
        let end = |inside: Shaper, mut near: f64, mut far: f64| {
            // To a few millionths of a block.
            for _ in 0..14 {
                let middle = 0.5 * (near + far);
                match self.sample(middle) {
                    Some(sample) if sample.by == inside => near = middle,
                    _ => far = middle,
                }
            }
            0.5 * (near + far)
        };
        (end(a.by, a.s, b.s), end(b.by, b.s, a.s))
    }

    /// The deepest cut by a wheel that is to grind a place more than a tenth of the profile away.
    fn collision(&self, samples: &[Sample]) -> Option<(f64, f64, f64)> {
        let length = self.machine.setup.profile.length();
        let apart = |sample: &Sample| {
            let leg = match sample.by {
                Shaper::Imprint(leg) => leg,
                Shaper::Envelope(block) => self.motion.first_leg(block),
            };
            let ground = self.place(self.motion.legs()[leg].block, 0.5);
            let distance = (ground - sample.s).rem_euclid(length);
            let own = self.place(self.motion.legs()[leg].block, 1.0) - self.place(self.motion.legs()[leg].block, 0.0);
            (distance.min(length - distance) > 0.1 * length + own, ground)
        };
        let found = samples.iter().filter(|s| s.left < -1e-7).map(|s| (s, apart(s))).filter(|(_, (far, _))| *far);
        found.min_by(|a, b| a.0.left.total_cmp(&b.0.left)).map(|(s, (_, ground))| (s.left, s.s, ground))
    }
}
