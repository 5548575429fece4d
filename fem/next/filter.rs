//! The state of a machine, part by part: a Kalman filter whose mean is what the model expects.
//!
//! The zero of the machine walks, with a rate that walks too, and jumps at a new insert, a new set-up and after a rest; the values
//! of the model that are known roughly, and a profile that no law makes, stay what they are [Kalman 1960; Harvey, Forecasting,
//! Structural Time Series Models and the Kalman Filter, 1989]. A part that stands far off either was measured wrongly, or
//! something changed that the log does not tell: the parts behind it decide.

use nalgebra::{DMatrix, DVector};

use super::line::{Events, Layout, Line, RATE, Reading, SCATTER, ZERO};
use super::sizes::{FIRST_RATE, NOISE, OF_INSERT, OF_PART, OF_PAUSE, OF_SET_UP, PROFILE, RATE_WALK, Sizes, WALK};

/// Standard deviations beyond which a reading counts for less, and a part is suspected.
const FAR: f64 = 4.0;
/// How often a part is measured wrongly, or something changes that nobody writes down.
const SELDOM: f64 = 0.02;
/// Parts before which none is suspected: what is usual on the machine has to be seen first.
const FIRST_PARTS: usize = 3;

/// Mean and covariance of the state.
#[derive(Clone, Debug)]
pub struct State {
    /// Mean.
    pub mean: DVector<f64>,
    /// Covariance.
    pub covariance: DMatrix<f64>,
}

/// Mean error of the readings of a part, as it was expected and as it was found, SI.
#[derive(Clone, Copy, Debug)]
pub struct Told {
    /// Expected before any of them.
    pub expected: f64,
    /// Its variance, noise of the readings within.
    pub variance: f64,
    /// As it was found.
    pub found: f64,
}

/// A part that stands far off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suspect {
    /// The step of the line.
    pub step: usize,
    /// By how much more it measures than was expected, SI.
    pub by: f64,
    /// Whether the machine changed there: not, if it was measured wrongly; `None` where nothing behind it decides.
    pub is_change: Option<bool>,
}

/// A history that was gone through.
#[derive(Clone, Debug)]
pub struct Run {
    /// Logarithm of the likelihood of what was measured.
    pub log_likelihood: f64,
    /// Of each step that was measured, what was expected and found.
    pub told: Vec<(usize, Told)>,
    /// Parts that stood far off.
    pub suspects: Vec<Suspect>,
    /// The state after the last step.
    pub state: State,
}

/// What may have happened, and how likely it is.
#[derive(Clone)]
struct Tale {
    state: State,
    log_likelihood: f64,
    is_change: bool,
}

/// Goes through the steps before that numbered `until`.
pub fn run(line: &Line, sizes: &Sizes, until: usize) -> Run {
    let first = Tale { state: State::before(&line.state, sizes), log_likelihood: 0.0, is_change: false };
    let (mut tales, mut told, mut suspects) = (vec![first], Vec::new(), Vec::<Suspect>::new());
    let mut measured = 0;
    for (number, step) in line.steps.iter().take(until).enumerate() {
        tales.iter_mut().for_each(|tale| tale.state.advance(step.further, step.events, sizes));
        if step.readings.is_empty() {
            continue;
        }
        told.push((number, State::mixed(&tales).tells(&step.readings, sizes)));
        let is_open = tales.len() > 1;
        let off = tales[0].state.far_off(&step.readings, sizes);
        if let (Some(by), false, true) = (off, is_open, measured >= FIRST_PARTS) {
            // Both have to make room for it at the same price; the parts behind it tell them apart.
            let mut changed = tales[0].clone();
            changed.state.covariance[(ZERO, ZERO)] += by.powi(2) + sizes.of(OF_SET_UP).powi(2);
            changed.log_likelihood += changed.state.learn(&step.readings, sizes) + SELDOM.ln();
            changed.is_change = true;
            tales[0].log_likelihood = changed.log_likelihood;
            tales.push(changed);
            suspects.push(Suspect { step: number, by, is_change: None });
        } else {
            for tale in &mut tales {
                tale.log_likelihood += tale.state.learn(&step.readings, sizes);
            }
            if is_open {
                tales.sort_by(|a, b| b.log_likelihood.total_cmp(&a.log_likelihood));
                tales.truncate(1);
                suspects.last_mut().into_iter().for_each(|own| own.is_change = Some(tales[0].is_change));
            }
        }
        measured += 1;
    }
    let best = tales.iter().map(|tale| tale.log_likelihood).fold(f64::NEG_INFINITY, f64::max);
    Run { log_likelihood: best, told, suspects, state: State::mixed(&tales) }
}

impl State {
    /// What is known before anything is measured.
    fn before(layout: &Layout, sizes: &Sizes) -> Self {
        let mut covariance = DMatrix::zeros(layout.len(), layout.len());
        covariance[(RATE, RATE)] = sizes.of(FIRST_RATE).powi(2);
        let values = layout.values();
        covariance.view_mut((values.start, values.start), (values.len(), values.len())).copy_from(&layout.correlation);
        for job in 0..layout.jobs() {
            let (own, first) = (&layout.profile * sizes.of(PROFILE).powi(2), layout.nodes(job));
            covariance.view_mut((first, first), own.shape()).copy_from(&own);
        }
        Self { mean: DVector::zeros(layout.len()), covariance }
    }

    /// Goes on by so many parts, the last of which comes after events.
    pub fn advance(&mut self, further: usize, events: Events, sizes: &Sizes) {
        let (by, all) = (further as f64, self.mean.len());
        self.mean[ZERO] += by * self.mean[RATE];
        for i in 0..all {
            self.covariance[(ZERO, i)] += by * self.covariance[(RATE, i)];
        }
        for i in 0..all {
            self.covariance[(i, ZERO)] += by * self.covariance[(i, RATE)];
        }
        let square = |which: usize| sizes.of(which).powi(2);
        let happened = [(events.set_up, OF_SET_UP), (events.insert, OF_INSERT), (events.pause, OF_PAUSE)];
        let jumps: f64 = happened.iter().filter(|(is, _)| *is).map(|(_, which)| square(*which)).sum();
        self.covariance[(ZERO, ZERO)] += by * square(WALK) + jumps;
        self.covariance[(RATE, RATE)] += by * square(RATE_WALK);
        // The scatter of a part is its own.
        self.mean[SCATTER] = 0.0;
        self.covariance.row_mut(SCATTER).fill(0.0);
        self.covariance.column_mut(SCATTER).fill(0.0);
        self.covariance[(SCATTER, SCATTER)] = square(OF_PART);
    }

    /// What the mean of some readings will be, with what was found.
    fn tells(&self, readings: &[Reading], sizes: &Sizes) -> Told {
        let count = readings.len() as f64;
        let mean = |of: &dyn Fn(&Reading) -> f64| readings.iter().map(of).sum::<f64>() / count;
        let slopes = readings.iter().fold(DVector::zeros(self.mean.len()), |sum, own| sum + &own.slopes) / count;
        let noise = mean(&|own| own.variance(sizes)) / count;
        Told {
            expected: mean(&|own| own.expected) + slopes.dot(&self.mean),
            variance: self.variance(&slopes) + noise,
            found: mean(&|own| own.error),
        }
    }

    /// Variance of what depends so on the state.
    pub fn variance(&self, slopes: &DVector<f64>) -> f64 {
        (&self.covariance * slopes).dot(slopes)
    }

    /// By how much a part is off, SI, if that is far.
    fn far_off(&self, readings: &[Reading], sizes: &Sizes) -> Option<f64> {
        // One wrong reading of several is no wrong part.
        let mut off: Vec<f64> =
            readings.iter().map(|own| own.error - own.expected - own.slopes.dot(&self.mean)).collect();
        off.sort_unstable_by(f64::total_cmp);
        let last = off.len() - 1;
        let middle = 0.5 * (off[last / 2] + off[last.div_ceil(2)]);
        (middle.powi(2) > FAR.powi(2) * self.tells(readings, sizes).variance).then_some(middle)
    }

    /// Learns from the readings of a part, and tells the logarithm of their likelihood.
    pub fn learn(&mut self, readings: &[Reading], sizes: &Sizes) -> f64 {
        readings.iter().map(|own| self.learn_one(own, own.variance(sizes))).sum()
    }

    fn learn_one(&mut self, reading: &Reading, noise: f64) -> f64 {
        let gain = &self.covariance * &reading.slopes;
        let off = reading.error - reading.expected - reading.slopes.dot(&self.mean);
        let expected = gain.dot(&reading.slopes) + noise;
        // Beyond so many standard deviations the price grows with the distance, not with its square [Huber, Robust Statistics,
        // 1981]: one chip under the gauge does not turn the machine over, and the size of what is missing still shows.
        let far = off.abs() / expected.sqrt();
        let variance = expected * (far / FAR).max(1.0);
        self.mean += &gain * (off / variance);
        self.covariance -= &gain * gain.transpose() / variance;
        let price = if far > FAR { FAR * far - 0.5 * FAR.powi(2) } else { 0.5 * far.powi(2) };
        -price - 0.5 * (std::f64::consts::TAU * expected).ln()
    }

    /// What would be known after a reading with some noise.
    pub fn after(&self, slopes: &DVector<f64>, noise: f64) -> DMatrix<f64> {
        let gain = &self.covariance * slopes;
        &self.covariance - &gain * gain.transpose() / (gain.dot(slopes) + noise)
    }

    /// One state for what may have happened, each as likely as the other.
    fn mixed(tales: &[Tale]) -> Self {
        let share = 1.0 / tales.len() as f64;
        let zeros = || DVector::zeros(tales[0].state.mean.len());
        let mean = tales.iter().fold(zeros(), |sum, own| sum + &own.state.mean * share);
        let spread = |own: &Tale| {
            let off = &own.state.mean - &mean;
            (&own.state.covariance + &off * off.transpose()) * share
        };
        let covariance = tales[1..].iter().fold(spread(&tales[0]), |sum, own| sum + spread(own));
        Self { mean, covariance }
    }
}

impl Reading {
    /// Variance of its noise, SI².
    pub fn variance(&self, sizes: &Sizes) -> f64 {
        if self.sigma.is_finite() { self.sigma.powi(2) } else { sizes.of(NOISE).powi(2) }
    }
}

impl Told {
    /// What is left of the error where what was expected is corrected: as if the offset had been that of the program.
    pub fn left(&self) -> f64 {
        self.found - self.expected
    }
}
