//! A machine on which the advised measurement is made: by the generator, at the rows that the diagnosis asks for.

use fem::diagnose::Next;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Edit, Entry, Model};
use fem::process::{Holds, Rows};
use generator::asked::Asked;
use generator::job::Job;
use generator::random::Random;
use generator::whole::apart_in;
use generator::{AXIS, CAM, CONTOUR, FIXTURE, Hidden, RING, STIFFNESS, THERMAL, TURNING, Whole, writing};

use crate::score;

/// A machine with all that was measured of it.
pub struct Machine {
    /// The model file, with the batch as long as it has become.
    pub model: String,
    /// The measurement files, the first first.
    pub data: Vec<String>,
    /// What was measured, as the data; the last has the batch as long as it has become.
    jobs: Vec<Box<dyn Job>>,
    hidden: Vec<Hidden>,
    sigma: f64,
    random: Random,
}

impl Machine {
    /// A machine with its first measurements.
    pub fn new(whole: Whole, seed: u64) -> Self {
        let Whole { case, job } = whole;
        let (hidden, sigma) = (case.truth.hidden, case.truth.sigma);
        let random = Random::new(&format!("{} advised", job.process()), seed);
        Self { model: case.model, data: vec![case.data], jobs: vec![job], hidden, sigma, random }
    }

    /// The hidden effects that the rows measured so far tell from the other hidden ones, by four standard
    /// uncertainties.
    pub fn tellable(&self) -> Vec<&'static str> {
        let apart = apart_in(&self.jobs, &self.hidden, self.sigma);
        self.hidden.iter().zip(apart).filter(|(_, apart)| *apart >= 4.0).map(|(hidden, _)| hidden.effect).collect()
    }

    /// Makes a measurement.
    ///
    /// # Errors
    /// The generator cannot make one of its rows, or has no value there.
    pub fn measure(&mut self, next: &Next) -> Result<(), String> {
        let words = &next.experiment.words;
        let model = Model::parse(Source::new("case.toml", self.model.clone())).expect("the model is right");
        let rows = asked(&model, &next.experiment.rows, next.repeats);
        let job =
            self.jobs.last().and_then(|job| job.asked(&rows)).ok_or_else(|| format!("the generator cannot {words}"))?;
        let mut values = job.predict(&self.hidden);
        if values.iter().any(|value| !value.is_finite()) {
            return Err(format!("the generator has no value where it is to {words}"));
        }
        for (value, scale) in values.iter_mut().zip(job.scales()) {
            *value += self.sigma * scale * self.random.normal();
        }
        self.data.push(job.data(&values, self.sigma));
        self.model = writing::model(&*job, None, &[]);
        self.jobs.push(job);
        Ok(())
    }
}

/// Rows, each as often as it is to be repeated.
fn asked(model: &Model, rows: &Rows, repeats: usize) -> Vec<Asked> {
    let one = |row: usize| {
        let mut asked = Asked {
            observable: model.process.observables()[rows.observable[row]].name.to_string(),
            numbers: Vec::new(),
            words: Vec::new(),
        };
        for (column, coordinate) in model.process.coordinates().iter().enumerate() {
            let (Some(value), name) = (rows.get(column, row), coordinate.name.to_string()) else { continue };
            match &coordinate.holds {
                Holds::Word(words) => asked.words.push((name, words.of_value(value).unwrap_or_default().to_string())),
                Holds::Quantity(_) | Holds::Number(_) => asked.numbers.push((name, value)),
            }
        }
        asked
    };
    (0..rows.len()).flat_map(|row| std::iter::repeat_n(one(row), repeats)).collect()
}

/// No process offers an experiment, or two in sequence, that its own model refuses or that the generator cannot make, and what the generator
/// makes at its rows the program predicts, to half a standard uncertainty of all of them together.
#[test]
fn both_know_what_an_advised_measurement_shows() {
    for process in [&AXIS, &CAM, &CONTOUR, &FIXTURE, &RING, &STIFFNESS, &THERMAL, &TURNING] {
        for seed in 0..2 {
            let Whole { case, job } = process.whole_machine(seed);
            let model = Model::parse(Source::new("case.toml", case.model)).unwrap();
            let measured = Measurements::parse(Source::new("case.csv", case.data), &*model.process).unwrap();
            let singles = model.system.candidate_experiments(&measured.rows);
            let together = singles.windows(2).filter_map(|two| model.system.in_sequence(&two[0], &two[1]));
            for experiment in singles.iter().cloned().chain(together) {
                let place = format!("{}{seed}: {}", process.name, experiment.words);
                let raised = experiment.raises.map(|(path, count)| {
                    let edit = Edit::Set { path: path.into(), entry: Entry::Whole(count as i64) };
                    model.edited(&[edit]).unwrap()
                });
                let misplaced = raised.as_ref().unwrap_or(&model).system.misplaced(&experiment.rows);
                assert!(misplaced.is_empty(), "{place}: {misplaced:?}");
                let made = job.asked(&asked(&model, &experiment.rows, 1)).unwrap_or_else(|| panic!("{place}"));
                let apart = score::between(
                    &writing::model(&*made, None, &case.truth.hidden),
                    &made.data(&made.predict(&case.truth.hidden), case.truth.sigma),
                    &made
                        .scales()
                        .iter()
                        .zip(made.si())
                        .map(|(scale, si)| case.truth.sigma * scale * si)
                        .collect::<Vec<_>>(),
                );
                assert!(apart < 0.5, "{place}: {apart} with {:?}", case.truth.hidden);
            }
        }
    }
}

/// The lathe does what was expected of it when the rows were chosen, by the model of the batch as it was: to a standard
/// uncertainty of all rows together.
#[test]
fn a_lathe_shows_what_was_expected_of_it() {
    for seed in 0..4 {
        let Whole { case, job } = TURNING.whole_machine(seed);
        let (hidden, sigma) = (&case.truth.hidden, case.truth.sigma);
        let truth = Model::parse(Source::new("truth.toml", writing::model(&*job, None, hidden))).unwrap();
        let measured = Measurements::parse(Source::new("case.csv", case.data.clone()), &*truth.process).unwrap();
        let singles = truth.system.candidate_experiments(&measured.rows);
        let together = singles.windows(2).filter_map(|two| truth.system.in_sequence(&two[0], &two[1]));
        for experiment in singles.iter().cloned().chain(together) {
            let expected = truth.system.with_effects(&truth.effects).observe(&experiment.rows).unwrap();
            let made = job.asked(&asked(&truth, &experiment.rows, 1)).unwrap();
            let apart = expected.iter().zip(made.predict(hidden)).map(|(e, made)| ((1e6 * e - made) / sigma).powi(2));
            let apart = apart.sum::<f64>().sqrt();
            assert!(apart < 1.0, "{seed}: {}: {apart} with {hidden:?}", experiment.words);
        }
    }
}
