//! Each block of the programme: errors, envelope and imprints, jumps and back-sweeps, feed, and the
//! metal it removes.

use rayon::prelude::*;

use super::super::fewest::overcut;
use super::super::forward;
use super::super::machine::{Machine, Run};
use super::super::motion::{Leg, Motion};
use super::super::profile::turn;
use super::super::search::peak;
use super::contact::{self, MOST_BLOCKS, PARTS, Removal};
use crate::process::range;

/// Everything about one block.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Places of the profile where it begins and ends, m.
    pub places: (f64, f64),
    /// Time it takes, s.
    pub time: f64,
    /// The most that is left between its places, and where: (m, s).
    pub thickest: (f64, f64),
    /// The least that is left between its places, and where: (m, s).
    pub thinnest: (f64, f64),
    /// Greatest depth to which the block itself cuts into the ideal profile, m; negative where it stays
    /// clear.
    pub overcut: f64,
    /// Length of the whole envelope over the block, m.
    pub envelope: f64,
    /// Length of profile that its envelope has given the final shape, m.
    pub shaped: f64,
    /// Length of profile that has the imprint of the wheel as it stands at the end of the block, m.
    pub imprint: f64,
    /// How far the grinding point moves at once at the end of the block, forwards positive: a jump, or a
    /// back-sweep, m.
    pub jump: f64,
    /// Least and greatest speed of the grinding point along its envelope, forwards positive, m/s.
    pub feed: (f64, f64),
    /// Mean speed of the grinding point along its envelope in each tenth of the block's time, m/s; empty
    /// where there are too many blocks to look at tenths.
    pub tenths: Vec<f64>,
    /// The metal it removes, where the layer is known.
    pub removal: Option<Removal>,
}

impl Block {
    /// The place of the profile in its middle, m.
    pub fn middle(&self) -> f64 {
        0.5 * (self.places.0 + self.places.1)
    }

    /// Length of its profile, m.
    pub fn length(&self) -> f64 {
        self.places.1 - self.places.0
    }

    /// Mean speed of the grinding point along the profile, m/s.
    pub fn mean_feed(&self) -> f64 {
        self.length() / self.time
    }

    /// Mean speed of the grinding point along its own envelope, m/s.
    pub fn envelope_feed(&self) -> f64 {
        self.envelope / self.time
    }
}

/// Everything about a programme.
#[derive(Clone, Debug, PartialEq)]
pub struct Blocks {
    /// The blocks in the order in which they are executed.
    pub list: Vec<Block>,
    /// The worst overcut by a block that grinds elsewhere: (m, place that is cut, place that is ground), if
    /// there is any.
    pub collision: Option<(f64, f64, f64)>,
    /// After a pass of another programme: the least and the greatest layer above the wheel, m, and the
    /// part of the profile that it does not reach.
    pub layer: Option<(f64, f64, f64)>,
}

/// A function that adds to deviations (m) at places of the profile (m) what formula effects change there.
pub type Formulas<'a> = &'a (dyn Fn(&[f64], &mut [f64]) + Sync);

/// A place of the profile and what shapes it last.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sample {
    s: f64,
    /// Deviation by the motion alone, m.
    left: f64,
    /// Deviation with what gives way and with formula effects, m.
    shown: f64,
    /// The layer that is above the wheel, where the pass before was another, m.
    layer: Option<f64>,
    by: Shaper,
}

/// The cause of the final shape of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shaper {
    /// The envelope of a block.
    Envelope(usize),
    /// The wheel as it stands at the end of a leg.
    Imprint(usize),
}

/// Looks at every block of the programme as the machine executes it, forwards.
pub fn look(machine: &Machine, run: &Run, formulas: Option<Formulas>) -> Blocks {
    let view = View { machine, run, motion: &run.motion, formulas };
    let program = &machine.setup.program;
    let of_block = |block: usize| {
        program.middles(block, program.samples(block)).filter_map(|s| view.sample(s)).collect::<Vec<Sample>>()
    };
    let mut samples: Vec<Vec<Sample>> = (0..program.blocks()).into_par_iter().map(of_block).collect();
    if let Some(add) = formulas {
        let (places, mut shown): (Vec<f64>, Vec<f64>) = samples.iter().flatten().map(|s| (s.s, s.shown)).unzip();
        add(&places, &mut shown);
        samples.iter_mut().flatten().zip(shown).for_each(|(sample, shown)| sample.shown = shown);
    }
    let all = samples.concat();
    let lengths = view.lengths(&all);
    let removals = machine.setup.stock.map(|stock| contact::removals(machine, run, stock));
    let block = |i: usize| Block {
        removal: removals.as_ref().map(|r| r[i].clone()),
        shaped: lengths.0[i],
        imprint: lengths.1[i],
        ..view.block(i, &samples[i])
    };
    let list = (0..program.blocks()).into_par_iter().map(block).collect();
    Blocks { list, collision: view.collision(&all), layer: machine.setup.before.is_some().then(|| layer(&all)) }
}

struct View<'a> {
    machine: &'a Machine,
    run: &'a Run,
    motion: &'a Motion,
    formulas: Option<Formulas<'a>>,
}

impl View<'_> {
    /// The deviation at a place, m.
    fn deviation(&self, s: f64) -> f64 {
        let mut deviation = [forward::left(self.machine, self.run, s).unwrap_or(f64::NAN)];
        if let Some(add) = self.formulas {
            add(&[s], &mut deviation);
        }
        deviation[0]
    }

    fn sample(&self, s: f64) -> Option<Sample> {
        let reach = forward::reach(self.machine, self.run, s)?;
        let legs = self.motion.legs().len();
        let surface = forward::surface(self.machine, self.run, s);
        let shown = forward::with_yielding(self.machine, self.run, s, (reach.left, surface));
        let layer = surface.map(|before| before - reach.left);
        let by = match reach.at {
            0.0 => Shaper::Imprint((reach.leg + legs - 1) % legs),
            1.0 => Shaper::Imprint(reach.leg),
            _ => Shaper::Envelope(self.motion.legs()[reach.leg].block),
        };
        Some(Sample { s, left: reach.left, shown, layer, by })
    }

    /// Everything about a block but lengths and removal.
    fn block(&self, block: usize, samples: &[Sample]) -> Block {
        let (profile, program) = (&self.machine.setup.profile, &self.machine.setup.program);
        let (from, to) = (program.places[block], program.places[block + 1]);
        let extreme = |sign: f64| {
            let worse = |a: &&Sample, b: &&Sample| (sign * a.shown).total_cmp(&(sign * b.shown));
            let Some(worst) = samples.iter().max_by(worse) else { return (f64::NAN, from) };
            let reach = (to - from) / samples.len() as f64;
            let (low, high) = ((worst.s - reach).max(from), (worst.s + reach).min(to));
            let (s, value) = peak(|s| sign * self.deviation(s), low, high, 5);
            (sign * value, s)
        };
        let time = program.time(block);
        let (radius, sense) = (self.motion.radius(), profile.sense());
        let legs = || {
            let first = self.motion.first_leg(block);
            self.motion.legs()[first..].iter().take_while(move |leg| leg.block == block)
        };
        let course = program.courses[block];
        let speeds = legs().flat_map(|leg| {
            let (from, part) = (leg.part.0, leg.part.1 - leg.part.0);
            (0..=8).map(move |k| {
                let at = f64::from(k) / 8.0;
                leg.grinding_speed(at, radius, sense) / (part * time) * course.speed(from + at * part)
            })
        });
        // Length of the envelope between two parts of the block's way.
        let envelope = |from: f64, to: f64| {
            let within = |leg: &&Leg| leg.part.0 < to && leg.part.1 > from;
            let of = |leg: &Leg| {
                let at = |way: f64| ((way - leg.part.0) / (leg.part.1 - leg.part.0)).clamp(0.0, 1.0);
                leg.envelope(radius, sense, (at(from), at(to)))
            };
            legs().filter(within).map(of).sum::<f64>()
        };
        let way = |tenth: usize| course.way(tenth as f64 / PARTS as f64);
        let tenths = if program.blocks() > MOST_BLOCKS { 0 } else { PARTS };
        let tenths = (0..tenths).map(|k| envelope(way(k), way(k + 1)) * PARTS as f64 / time).collect();
        let overcut = legs().map(|leg| {
            let within = (program.place(block, leg.part.0), program.place(block, leg.part.1));
            overcut(profile, leg, radius, within)
        });
        Block {
            places: (from, to),
            time,
            thickest: extreme(1.0),
            thinnest: extreme(-1.0),
            overcut: overcut.fold(f64::NEG_INFINITY, f64::max),
            envelope: envelope(0.0, 1.0),
            shaped: 0.0,
            imprint: 0.0,
            jump: self.jump(block, radius, sense),
            feed: range(speeds),
            tenths,
            removal: None,
        }
    }

    /// The path turns at once between two blocks, and the grinding point about the wheel with it: to the left
    /// of a path about the cam counter-clockwise it goes back.
    fn jump(&self, block: usize, radius: f64, sense: f64) -> f64 {
        let legs = self.motion.legs();
        let next = self.motion.first_leg((block + 1) % self.machine.setup.program.blocks());
        let last = (next + legs.len() - 1) % legs.len();
        -sense * radius * turn(&legs[last].velocity(1.0), &legs[next].velocity(0.0))
    }

    /// Lengths of profile that each block's envelope shapes, and that the wheel shapes as it stands at each
    /// block's end.
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

    /// Between two neighbouring places: how far what shapes the first goes, and from where on what shapes the
    /// second does.
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
        let program = &self.machine.setup.program;
        let length = self.machine.setup.profile.length();
        let elsewhere = |sample: &Sample| {
            let block = match sample.by {
                Shaper::Imprint(leg) => self.motion.legs()[leg].block,
                Shaper::Envelope(block) => block,
            };
            let ground = program.place(block, 0.5);
            let distance = (ground - sample.s).rem_euclid(length);
            let is_far = distance.min(length - distance) > 0.1 * length + program.length(block);
            is_far.then_some((sample.left, sample.s, ground))
        };
        samples.iter().filter(|s| s.left < -1e-7).filter_map(elsewhere).min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// The least and the greatest layer, and the part of the profile without any.
fn layer(samples: &[Sample]) -> (f64, f64, f64) {
    let (low, high) = range(samples.iter().filter_map(|s| s.layer));
    let missed = samples.iter().filter(|s| s.layer.is_some_and(|layer| layer <= 0.0)).count();
    (low, high, missed as f64 / samples.len() as f64)
}
