//! What steps through time make of an input, at the points of a contour: the same for every rod.

use std::sync::Arc;

use nalgebra::Complex;

use super::contour::{Contour, Reach};
use super::lanes::{LANES, Lanes};
use super::run::{Steps, is_same};
use super::track::weights;
use super::{History, Power, Scheme, Swing};

/// What runs of any rod and any input share.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Programme {
    pub scheme: Scheme,
    /// Longest step, s.
    pub step: f64,
    /// Times 0, of switches, and of the end, s.
    pub intervals: Vec<f64>,
    pub reach: Reach,
    /// When it is read, s, rising.
    pub times: Vec<f64>,
}

/// Everything on which responses depend.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Input {
    pub programme: Arc<Programme>,
    /// What comes in, per unit.
    pub unit: Power,
    /// Time constant of what shows it, s.
    pub lag: f64,
}

/// One step that a reading takes, with its weight.
#[derive(Debug)]
struct Look {
    step: usize,
    reading: usize,
    weight: f64,
}

impl Input {
    /// Weights by which a transfer is read at every time: for each time groups of [`LANES`] factors of the
    /// real parts and as many of the imaginary ones.
    pub fn response(&self, laws: &Laws) -> Vec<f64> {
        let Laws { contour, steps, looks, .. } = laws;
        let stretches = self.stretches(steps, looks);
        let is_closed = |step: &usize| stretches.iter().any(|s| (s.from..s.from + s.steps).contains(step));
        let stages = |step| if is_closed(&step) { [0.0; STAGES] } else { self.stages(steps, step) };
        let inputs: Vec<[f64; STAGES]> = (0..steps.lengths.len()).map(stages).collect();
        let lags: Vec<[f64; 3]> = laws.lengths.iter().map(|length| lag(*length, self.lag)).collect();
        let groups = contour.points.len() / LANES;
        let mut read = vec![Lanes::default(); self.programme.times.len() * groups];
        for group in 0..groups {
            let mut state = State::default();
            // At the start nothing has come in yet.
            let mut next = looks.partition_point(|look| look.step == 0);
            let mut step = 0;
            while let Some(of_step) = laws.of_step.get(step).copied() {
                let (law, lag) = (&laws.laws[of_step][group], lags[of_step]);
                if let Some(stretch) = stretches.iter().find(|stretch| stretch.from == step) {
                    let closed = Closed::new(law, lag, &state, stretch);
                    let mut power = Powers::new(law.kept);
                    for (look, turns) in looks[next..].iter().zip(&stretch.turns[1..]) {
                        let shown = closed.shown(&power.up_to(look.step - step), turns);
                        read[look.reading * groups + group].add(&shown, look.weight);
                    }
                    next += stretch.turns.len() - 1;
                    step += stretch.steps;
                    state = closed.end(&power.up_to(stretch.steps), &stretch.turns[0]);
                    continue;
                }
                state.step(law, lag, &inputs[step]);
                step += 1;
                while let Some(look) = looks.get(next).filter(|look| look.step == step) {
                    read[look.reading * groups + group].add(&state.shown, look.weight);
                    next += 1;
                }
            }
        }
        // Im(share · read · transfer) as factors of the real and of the imaginary part.
        let shares: Vec<Lanes> = contour.weights.as_chunks().0.iter().map(|all| Lanes::new(*all)).collect();
        let mut factors = Vec::with_capacity(2 * LANES * read.len());
        for (read, share) in read.iter().zip(shares.iter().cycle()) {
            let [re, im] = read.times(share).0;
            factors.extend_from_slice(&im);
            factors.extend_from_slice(&re);
        }
        factors
    }

    /// The input at the stages of a step.
    fn stages(&self, steps: &Steps, step: usize) -> [f64; STAGES] {
        let (time, length) = (steps.times[step], steps.lengths[step]);
        let mut stages = [0.0; STAGES];
        for (stage, place) in stages.iter_mut().zip(self.programme.scheme.places()) {
            *stage = self.unit.within(time + place * length, [time, time + length]);
        }
        stages
    }

    /// The equal steps of every interval, where the input is made of waves.
    fn stretches(&self, steps: &Steps, looks: &[Look]) -> Vec<Stretch> {
        let Some(waves) = waves(&self.unit.level) else { return Vec::new() };
        let mut all = Vec::new();
        for ends in steps.switches.windows(2) {
            let length = steps.lengths[ends[1] - 1];
            let is_equal = |i: &usize| is_same(steps.lengths[*i], length);
            // The first step is halved towards the switch.
            let Some(from) = (ends[0]..ends[1]).find(is_equal) else { continue };
            let [start, end] = [steps.times[from], steps.times[ends[1]]];
            let on = self.unit.factor([start, end]);
            let at_start = |(size, rate): &(Complex<f64>, Complex<f64>)| (size * (rate * start).exp() * on, *rate);
            let waves: Vec<_> = waves.iter().map(at_start).collect();
            let turns = |step: usize| {
                let past = length * (step - from) as f64;
                let waves = waves.iter().map(|(_, rate)| (rate * past).exp()).collect();
                Turns { waves, left: (-past / self.lag).exp() }
            };
            let own = looks.partition_point(|l| l.step <= from)..looks.partition_point(|l| l.step <= ends[1]);
            let turns = std::iter::once(ends[1]).chain(looks[own].iter().map(|look| look.step)).map(turns).collect();
            let stages = self.programme.scheme.places().iter().map(|place| place * length).collect();
            all.push(Stretch { from, steps: ends[1] - from, length, waves, stages, turns });
        }
        all
    }
}

/// A history as a sum of size·e^(rate·t), if it is one.
fn waves(history: &History) -> Option<Vec<(Complex<f64>, Complex<f64>)>> {
    match history {
        History::Constant(value) => Some(vec![((*value).into(), 0.0.into())]),
        History::Swing(Swing { size, omega, phase }) => {
            // sin x = (e^ix − e^−ix)/2i
            let up = (Complex::new(0.0, -0.5 * size) * Complex::from_polar(1.0, *phase), Complex::new(0.0, *omega));
            let level = Complex::from(-size * phase.sin());
            Some(vec![up, (up.0.conj(), up.1.conj()), (level, 0.0.into())])
        }
        _ => None,
    }
}

/// Most stages of a scheme.
const STAGES: usize = 2;

/// Equal steps under waves.
struct Stretch {
    from: usize,
    steps: usize,
    /// Length of a step, s.
    length: f64,
    /// Value at the start and rate (1/s) of every wave.
    waves: Vec<(Complex<f64>, Complex<f64>)>,
    /// Places of the stages in a step, s.
    stages: Vec<f64>,
    /// For its end, then for every look into it.
    turns: Vec<Turns>,
}

/// How far waves have turned since the start of a stretch, and what an instrument still keeps from there.
struct Turns {
    waves: Vec<Complex<f64>>,
    left: f64,
}

/// z′ = s·z + u at some points, and what an instrument shows of it.
#[derive(Default)]
struct State {
    own: Lanes,
    shown: Lanes,
}

/// How the steps of a programme act on z, for every rod and input.
#[derive(Debug)]
pub(super) struct Laws {
    pub contour: Contour,
    steps: Steps,
    /// Steps that are read, in their order.
    looks: Vec<Look>,
    /// Lengths that steps have, s.
    lengths: Vec<f64>,
    /// Position in `lengths` of every step.
    of_step: Vec<usize>,
    /// For every length those of all points.
    laws: Vec<Vec<Law>>,
}

/// How a step of one length acts.
#[derive(Debug)]
struct Law {
    /// On z.
    kept: Lanes,
    /// Of the input at every stage.
    driven: [Lanes; STAGES],
}

impl Laws {
    pub fn new(programme: &Programme) -> Self {
        let contour = programme.reach.contour();
        let steps = Steps::between(&programme.intervals, programme.step);
        let of_time = |(reading, time): (usize, &f64)| {
            weights(&steps.times, &steps.switches, *time).map(move |(step, weight)| Look { step, reading, weight })
        };
        let mut looks: Vec<Look> = programme.times.iter().enumerate().flat_map(of_time).collect();
        looks.sort_by_key(|look| look.step);
        let (mut lengths, mut of_step) = (Vec::<f64>::new(), Vec::new());
        for length in &steps.lengths {
            of_step.push(lengths.iter().rposition(|known| is_same(*known, *length)).unwrap_or_else(|| {
                lengths.push(*length);
                lengths.len() - 1
            }));
        }
        let groups = contour.points.as_chunks().0;
        let law = |length: f64| groups.iter().map(|points| Law::new(programme.scheme, length, points)).collect();
        let laws = lengths.iter().map(|length| law(*length)).collect();
        Self { steps, looks, lengths, of_step, laws, contour }
    }
}

impl Law {
    fn new(scheme: Scheme, length: f64, points: &[Complex<f64>; LANES]) -> Self {
        let stepped = |z: f64, inputs: [f64; STAGES]| {
            Lanes::new(points.map(|s| scheme.step_of_one(s, length, z.into(), &inputs)))
        };
        let driven = [stepped(0.0, [1.0, 0.0]), stepped(0.0, [0.0, 1.0])];
        Self { kept: stepped(1.0, [0.0; STAGES]), driven }
    }
}

/// Parts of what was shown, of z before and of z after a step in what is shown after it: the terms of
/// [`lagged`](super::lagged) by what they belong to.
fn lag(length: f64, time_constant: f64) -> [f64; 3] {
    let (left, slow) = ((-length / time_constant).exp(), time_constant / length);
    [left, slow - left * (1.0 + slow), 1.0 - slow + left * slow]
}

impl State {
    fn step(&mut self, law: &Law, [left, was, is]: [f64; 3], inputs: &[f64; STAGES]) {
        let mut own = law.kept.times(&self.own);
        own.add(&law.driven[0], inputs[0]);
        own.add(&law.driven[1], inputs[1]);
        let mut shown = Lanes::default();
        shown.add(&self.shown, left);
        shown.add(&self.own, was);
        shown.add(&own, is);
        *self = Self { own, shown };
    }
}

/// Equal steps in closed form: z = Σ own·ρⁿ after n steps, ρ of each wave and of what the first z leaves; and
/// the same of what is shown, with what an instrument keeps.
struct Closed {
    /// Of waves.
    waves: Vec<[Lanes; 2]>,
    /// Of the first z.
    first: [Lanes; 2],
    /// Of what was shown first.
    kept: Lanes,
}

impl Closed {
    fn new(law: &Law, [left, was, is]: [f64; 3], state: &State, stretch: &Stretch) -> Self {
        let (mut first, mut kept) = (state.own, state.shown);
        let wave = |(size, rate): &(Complex<f64>, Complex<f64>)| {
            let turn = (rate * stretch.length).exp();
            let mut driven = Lanes::default();
            for (stage, at) in law.driven.iter().zip(&stretch.stages) {
                driven.add(&stage.scaled((rate * at).exp()), 1.0);
            }
            let mut behind = Lanes::new([turn; LANES]);
            behind.add(&law.kept, -1.0);
            let own = driven.times(&behind.inverse()).scaled(*size);
            [own, own.scaled((turn * is + was) / (turn - left))]
        };
        let waves: Vec<[Lanes; 2]> = stretch.waves.iter().map(wave).collect();
        for [own, shown] in &waves {
            first.add(own, -1.0);
            kept.add(shown, -1.0);
        }
        let passed = law.kept.scaled(is.into()).plus(was).times(&law.kept.plus(-left).inverse());
        let shown = first.times(&passed);
        kept.add(&shown, -1.0);
        Self { waves, first: [first, shown], kept }
    }

    fn shown(&self, power: &Lanes, turns: &Turns) -> Lanes {
        let mut all = self.sum(1, power, turns);
        all.add(&self.kept, turns.left);
        all
    }

    fn end(&self, power: &Lanes, turns: &Turns) -> State {
        State { own: self.sum(0, power, turns), shown: self.shown(power, turns) }
    }

    fn sum(&self, which: usize, power: &Lanes, turns: &Turns) -> Lanes {
        let mut all = self.first[which].times(power);
        for (wave, turn) in self.waves.iter().zip(&turns.waves) {
            all.add(&wave[which].scaled(*turn), 1.0);
        }
        all
    }
}

/// Rising powers, found one from the other.
struct Powers {
    base: Lanes,
    now: (usize, Lanes),
    /// The last step from one to the next, as a rule the same again.
    more: (usize, Lanes),
}

impl Powers {
    fn new(base: Lanes) -> Self {
        Self { base, now: (0, Lanes::ONE), more: (0, Lanes::ONE) }
    }

    fn up_to(&mut self, exponent: usize) -> Lanes {
        let more = exponent - self.now.0;
        if more != self.more.0 {
            self.more = (more, self.base.power(more));
        }
        self.now = (exponent, self.now.1.times(&self.more.1));
        self.now.1
    }
}

impl Scheme {
    /// A step of z′ = s·z + u, with u at the places of the stages.
    fn step_of_one(self, s: Complex<f64>, length: f64, z: Complex<f64>, inputs: &[f64]) -> Complex<f64> {
        let mut base = z;
        for (weight, input) in self.weights().iter().zip(inputs) {
            let rate = (s * base + input) / (Complex::new(1.0, 0.0) - s * (self.gamma() * length));
            base += rate * (length * weight);
        }
        base
    }
}
