//! Axes with known errors, and the files that the program writes for them.

use fem::compensate::{Compensation, compensate};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::output::{CONTROLS, supplied};

use super::random::Random;
use super::text::linear;

/// An axis whose error is linear between its targets. All in mm.
pub struct Axis {
    pub name: String,
    pub targets: Vec<f64>,
    /// Actual less commanded position at the targets, forwards and backwards.
    errors: Vec<(f64, f64)>,
    /// By how much the reversal differs along the travel, half of which one value leaves on either side of it.
    pub uneven: f64,
    /// Reference point and distance of the points of a control that counts them.
    steps: (f64, f64),
}

/// Files of a control.
pub struct Files {
    pub files: Vec<(&'static str, String)>,
    /// What the program says is left, mm.
    pub left: f64,
    pub notes: Vec<String>,
}

impl Files {
    pub fn named(&self, name: &str) -> &str {
        &self.files.iter().find(|file| file.0 == name).unwrap_or_else(|| panic!("no {name}")).1
    }
}

impl Axis {
    fn new(
        name: &str,
        targets: Vec<f64>,
        steps: (f64, f64),
        error: impl Fn(f64) -> f64,
        lost: impl Fn(f64) -> f64,
    ) -> Self {
        let errors: Vec<(f64, f64)> = targets.iter().map(|x| (error(*x), error(*x) + lost(*x))).collect();
        let losts = || errors.iter().map(|e| e.1 - e.0);
        let uneven = losts().fold(f64::MIN, f64::max) - losts().fold(f64::MAX, f64::min);
        Self { name: name.into(), targets, errors, uneven, steps }
    }

    pub fn random(random: &mut Random) -> Self {
        let count = random.between(5.0, 21.0) as usize;
        let (from, every) = (random.between(-800.0, 300.0).round(), random.between(10.0, 60.0).round());
        let targets: Vec<f64> = (0..count).map(|i| from + every * i as f64).collect();
        let mut walk = 0.0;
        let errors: Vec<f64> = (0..count)
            .map(|_| {
                walk += random.between(-0.005, 0.005);
                walk
            })
            .collect();
        let losts: Vec<f64> = (0..count).map(|_| 0.01 + random.between(-0.001, 0.001)).collect();
        let of = |values: Vec<f64>| {
            let targets = targets.clone();
            move |x: f64| values[targets.iter().position(|t| *t == x).unwrap()]
        };
        let reference = from + every * random.between(0.0, count as f64).floor();
        let name = format!("{count} targets every {every} from {from}, reference {reference}");
        Self::new(&name, targets.clone(), (reference, every), of(errors), of(losts))
    }

    /// Actual less commanded position.
    pub fn error(&self, at: f64, forward: bool) -> f64 {
        let of = |e: &(f64, f64)| if forward { e.0 } else { e.1 };
        let table: Vec<(f64, f64)> = self.targets.iter().zip(&self.errors).map(|(x, e)| (*x, of(e))).collect();
        linear(&table, at)
    }

    /// The largest error, mm.
    pub fn largest(&self) -> f64 {
        self.errors.iter().flat_map(|e| [e.0.abs(), e.1.abs()]).fold(0.0, f64::max)
    }

    /// By how much the error changes over a length at most.
    pub fn steepest(&self) -> f64 {
        let slope = |i: usize, of: fn(&(f64, f64)) -> f64| {
            ((of(&self.errors[i + 1]) - of(&self.errors[i])) / (self.targets[i + 1] - self.targets[i])).abs()
        };
        (0..self.targets.len() - 1).map(|i| slope(i, |e| e.0).max(slope(i, |e| e.1))).fold(0.0, f64::max)
    }

    /// The model of the axis, with `[controller]` as it is given.
    fn model(&self, controller: &str) -> Model {
        let (first, last) = (self.targets[0], self.targets[self.targets.len() - 1]);
        let text = format!(
            "process = \"axis\"\naxis = {{ travel = \"{} mm\", from = \"{first} mm\" }}\n\
             screw = {{ material = \"steel\", diameter = \"32 mm\", lead = \"10 mm\", fixed_at = \"{first} mm\" }}\n\
             {controller}",
            last - first
        );
        Model::parse(Source::new("axis.toml", text)).unwrap_or_else(|e| panic!("{}: {e}", self.name))
    }

    /// What the program finds, for controls that count 0.1 um by tens.
    pub fn compensated(&self) -> Compensation {
        self.found(&self.counting())
    }

    /// `[controller]` with points that are counted.
    pub fn counting(&self) -> String {
        let (reference, interval) = self.steps;
        format!(
            "[controller]\nsteps = {{ reference = \"{reference} mm\", interval = \"{interval} mm\", \
             detection_unit = \"0.1 um\", magnification = 10 }}\n"
        )
    }

    /// What the program finds on two runs of the axis, with `[controller]` as it is given.
    fn found(&self, controller: &str) -> Compensation {
        let model = self.model(controller);
        let mut text = String::from("run,position [mm],direction,deviation [um]\n");
        for run in [1, 2] {
            for (x, (forward, backward)) in self.targets.iter().zip(&self.errors) {
                for (sign, error) in [("+", forward), ("-", backward)] {
                    text.push_str(&format!("{run},{x},{sign},{}\n", 1e3 * error));
                }
            }
        }
        let measured = Measurements::parse(Source::new("m.csv", text), &*model.process).unwrap();
        let data = Data::of(&model, measured).unwrap();
        compensate(&data, model.system.positioning().unwrap()).unwrap()
    }

    /// What the program writes for a control, or why not.
    pub fn tried(&self, control: &str, controller: &str) -> Result<Files, String> {
        files(control, &self.found(controller))
    }
}

/// What the program writes for a control, or why not.
pub fn files(control: &str, found: &Compensation) -> Result<Files, String> {
    let control = CONTROLS.iter().find(|c| c.name == control).unwrap();
    let supplied = supplied(control, found, "X", true)?;
    Ok(Files { files: supplied.files, left: 1e3 * supplied.left, notes: supplied.notes })
}

/// Axes of every sort.
pub fn axes() -> Vec<Axis> {
    let even = |from: f64, every: f64, count: usize| (0..count).map(|i| from + every * i as f64).collect::<Vec<_>>();
    let wave = |x: f64| 0.006 * (0.02 * x).sin() + 3e-5 * x;
    let none = |_: f64| 0.0;
    vec![
        Axis::new("a scale that is long", even(0.0, 50.0, 13), (0.0, 50.0), |x| 6e-5 * x, none),
        Axis::new("a scale that is short, with play", even(0.0, 50.0, 13), (100.0, 50.0), |x| -6e-5 * x, |_| 0.012),
        Axis::new("a wave on a travel below zero", even(-600.0, 40.0, 16), (0.0, 40.0), wave, |_| 0.008),
        Axis::new("a travel on either side of zero", even(-300.0, 30.0, 21), (-300.0, 30.0), wave, |_| -0.006),
        Axis::new("a reversal that grows", even(0.0, 25.0, 17), (200.0, 25.0), wave, |x| 0.01 + 1e-5 * x),
        // Multiples of 7 mm, which points of equal distance meet.
        Axis::new("targets at uneven distances", vec![0.0, 14.0, 63.0, 91.0, 182.0, 210.0], (63.0, 7.0), wave, |_| {
            0.009
        }),
    ]
}
