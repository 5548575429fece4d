//! Response of z′ = s·z + u to an input, step by step, at the points of a contour: the same for every rod.
//!
//! Constant inputs and swings are sums of waves e^(rate·t). Under these n equal steps have a closed form, z = Σ own·ρⁿ
//! with ρ of each wave and of the decay of the z at the beginning; other inputs are stepped through.

use std::sync::Arc;

use nalgebra::Complex;

use super::lanes::{LANES, Lanes};
use super::laws::{Law, Laws, Look, Programme, STAGES, Stretch};
use super::{History, Power, Swing};

/// Everything on which a response depends.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Time constant of what shows it, s.
    pub lag: f64,
    /// Input per unit.
    pub unit: Power,
    /// When; compared last, for it is long and most inputs that are known have the same.
    pub programme: Arc<Programme>,
}

/// Response of an instrument to an input, for each z = 1/(s + A).
#[derive(Debug, Default)]
pub struct Response {
    /// Times that are read by marks which were stepped to, with what is shown there at all points.
    pub stepped: Vec<(usize, Vec<Lanes>)>,
    /// Of every stretch in closed form; none where all was stepped through.
    pub stretches: Vec<Closed>,
}

/// Response in a stretch, in closed form: amplitudes of the parts of the instrument's reading.
#[derive(Debug, Default)]
pub struct Closed {
    /// Of the decay of the z at the beginning.
    pub first: Vec<Lanes>,
    /// Of every wave.
    pub waves: Vec<Vec<Lanes>>,
    /// Of the decay of the reading at the beginning.
    pub kept: Vec<Lanes>,
    /// How far the waves have turned: for every look of the stretch, all waves.
    pub turns: Vec<Complex<f64>>,
    /// Factor by which the reading at the beginning has decayed, for every look.
    pub left: Vec<f64>,
}

/// Size and rate (1/s) of a wave.
type Wave = (Complex<f64>, Complex<f64>);

/// z, and what an instrument shows of it.
#[derive(Clone, Copy, Default)]
struct State {
    own: Lanes,
    shown: Lanes,
}

impl Input {
    pub fn response(&self, laws: &Laws) -> Response {
        let groups = laws.groups();
        let lags: Vec<[f64; 3]> = laws.lengths.iter().map(|length| lag(*length, self.lag)).collect();
        let waves = waves(&self.unit.level);
        let mut state = vec![State::default(); groups];
        let mut response = Response::default();
        let mut stepped: Vec<(usize, Vec<Lanes>)> = Vec::new();
        let (mut step, mut stretches) = (0, laws.stretches.iter());
        let mut stretch = stretches.next();
        // At the start nothing has come in yet.
        let mut mark = laws.marks.partition_point(|mark| *mark == 0);
        while let Some(of_step) = laws.of_step.get(step).copied() {
            let (own, lag) = (&laws.laws[of_step], lags[of_step]);
            match (&waves, stretch) {
                (Some(waves), Some(equal)) if equal.from == step => {
                    let span = Span { laws: own, lag, length: laws.lengths[of_step], time: laws.steps.times[step] };
                    let end = laws.steps.times[step + equal.steps];
                    let on = self.unit.factor([span.time, end]);
                    let waves: Vec<Wave> = waves.iter().map(|(size, rate)| (size * on, *rate)).collect();
                    response.stretches.push(self.closed(&span, equal, &laws.marks, &waves, &mut state));
                    (step, mark, stretch) = (step + equal.steps, equal.marks.end, stretches.next());
                }
                _ => {
                    let inputs = self.stages(laws.steps.times[step], laws.lengths[of_step]);
                    state.iter_mut().zip(own).for_each(|(state, law)| state.step(law, lag, &inputs));
                    step += 1;
                    if laws.marks.get(mark) == Some(&step) {
                        stepped.push((mark, state.iter().map(|state| state.shown).collect()));
                        mark += 1;
                    }
                }
            }
        }
        let shown = |mark: &usize| stepped.binary_search_by_key(mark, |own| own.0).ok().map(|i| &stepped[i].1);
        for (time, look) in laws.looks.iter().enumerate() {
            let own: Vec<_> = look.iter().filter_map(|(mark, weight)| Some((shown(mark)?, *weight))).collect();
            if !own.is_empty() {
                let read = |group: usize| own.iter().map(|(shown, weight)| shown[group] * *weight).sum();
                response.stepped.push((time, (0..groups).map(read).collect()));
            }
        }
        response
    }

    /// The input at the stages of a step.
    fn stages(&self, time: f64, length: f64) -> [f64; STAGES] {
        let mut stages = [0.0; STAGES];
        for (stage, place) in stages.iter_mut().zip(self.programme.scheme.places()) {
            *stage = self.unit.within(time + place * length, [time, time + length]);
        }
        stages
    }

    /// Equal steps under waves, and the state behind them.
    fn closed(&self, span: &Span, stretch: &Stretch, marks: &[usize], waves: &[Wave], state: &mut [State]) -> Closed {
        let past = |step: usize| span.length * (step - stretch.from) as f64;
        let turn = |past: f64, wave: &Wave| (wave.1 * past).exp();
        let left = |past: f64| (-past / self.lag).exp();
        let pasts: Vec<f64> = marks[stretch.marks.clone()].iter().map(|mark| past(*mark)).collect();
        let at_marks: Vec<Vec<Complex<f64>>> =
            waves.iter().map(|wave| pasts.iter().map(|past| turn(*past, wave)).collect()).collect();
        let left_at_marks: Vec<f64> = pasts.iter().map(|past| left(*past)).collect();
        let turns = |look: &Look| at_marks.iter().map(|own| look.read(|mark| own[mark])).collect::<Vec<_>>();
        let mut closed = Closed {
            turns: stretch.looks.iter().flat_map(turns).collect(),
            left: stretch.looks.iter().map(|look| look.read(|mark| left_at_marks[mark])).collect(),
            waves: vec![Vec::new(); waves.len()],
            ..Closed::default()
        };
        let whole = past(stretch.from + stretch.steps);
        let turns: Vec<_> = waves.iter().map(|wave| turn(whole, wave)).collect();
        let left = left(whole);
        let [passed, was, is] = span.lag;
        for ((law, remains), state) in span.laws.iter().zip(&stretch.left_in_the_end).zip(state) {
            let (mut first, mut kept, mut end) = (state.own, state.shown, State::default());
            for ((wave, turn), shown) in waves.iter().zip(&turns).zip(&mut closed.waves) {
                let (own, seen) = span.wave(law, self.programme.scheme.places(), *wave);
                first.add(&own, -1.0);
                kept.add(&seen, -1.0);
                end.own.add(&own.scaled(*turn), 1.0);
                end.shown.add(&seen.scaled(*turn), 1.0);
                shown.push(seen);
            }
            let ratio = law.kept.scaled(is.into()).plus(was).times(&law.kept.plus(-passed).inverse());
            let shown = first.times(&ratio);
            kept.add(&shown, -1.0);
            end.own.add(&first.times(remains), 1.0);
            end.shown.add(&shown.times(remains), 1.0);
            end.shown.add(&kept, left);
            closed.first.push(shown);
            closed.kept.push(kept);
            *state = end;
        }
        closed
    }
}

/// The steps of a stretch.
struct Span<'l> {
    /// Of all points.
    laws: &'l [Law],
    lag: [f64; 3],
    /// Length of a step, s.
    length: f64,
    /// Time of the start, s.
    time: f64,
}

impl Span<'_> {
    /// Amplitudes at the start of z and of its reading under a wave; they turn with the wave.
    fn wave(&self, law: &Law, places: &[f64], (size, rate): Wave) -> (Lanes, Lanes) {
        let turn = (rate * self.length).exp();
        let mut driven = Lanes::default();
        for (stage, place) in law.driven.iter().zip(places) {
            driven.add(&stage.scaled((rate * (place * self.length)).exp()), 1.0);
        }
        let mut behind = Lanes::new([turn; LANES]);
        behind.add(&law.kept, -1.0);
        let own = driven.times(&behind.inverse()).scaled(size * (rate * self.time).exp());
        let [left, was, is] = self.lag;
        (own, own.scaled((turn * is + was) / (turn - left)))
    }
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

/// Parts of what was shown, of z before and of z after a step in what is shown after it: the terms of
/// [`lagged`](super::lagged) by what they belong to.
fn lag(length: f64, time_constant: f64) -> [f64; 3] {
    let part = length / time_constant;
    let (left, gone) = ((-part).exp(), -(-part).exp_m1() / part);
    [left, gone - left, 1.0 - gone]
}

/// A history as a sum of waves, if it is one.
fn waves(history: &History) -> Option<Vec<Wave>> {
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
