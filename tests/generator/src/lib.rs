//! Practice cases with a hidden physical effect, made by other code and other numerics than the program
//! under test: see [`turning`], [`ring`], [`thermal`], [`axis`], [`rotary`], [`stiffness`], [`contour`], [`fixture`] and
//! [`cam`]. Laws, signs and units are those that `fem effects` states; what several of them make together is one
//! machine in one equilibrium, and [`meeting`] lets any two of them meet in any way of holding.
//!
//! Every case is decided by its seed. lambda is the length of an effect's signature, in standard
//! deviations, after projection onto the tangent of all `+-` parameters of the written model with their
//! prior rows appended.

pub mod asked;
pub mod axis;
pub mod cam;
pub mod contour;
pub mod dense;
pub mod fixture;
pub mod foreign;
pub mod hidden_law;
pub mod job;
pub mod law;
pub mod machine;
pub mod meeting;
pub mod mill;
pub mod preload;
pub mod random;
pub mod ring;
pub mod rotary;
pub mod stiffness;
pub mod structure;
pub mod thermal;
pub mod trouble;
mod tuning;
pub mod turning;
pub mod typical;
pub mod visibility;
pub mod whole;
pub mod writing;

pub use axis::AXIS;
pub use cam::CAM;
pub use contour::CONTOUR;
pub use fixture::FIXTURE;
pub use hidden_law::{Beside, HiddenLaw};
pub use job::NoiseKind;
pub use law::Cause as Hidden;
pub use ring::RING;
pub use rotary::ROTARY;
pub use stiffness::STIFFNESS;
pub use thermal::THERMAL;
pub use trouble::Trouble;
pub use turning::{RUBBING_TURNING, SURVEYED_TURNING, TURNING, story};
pub use whole::Whole;

use foreign::what_catalogue_leaves;
use job::Job;
use law::Law;
use random::{Random, figures};
use tuning::{Tuned, apart, tune};
use visibility::Nuisance;

/// Draws a job that admits some effects and does not show them.
pub type DrawJob = fn(&[&'static str], &mut Random) -> Option<Box<dyn Job>>;

/// Draws a job of one of the scenes of a process; None where it does not admit the effects.
pub type DrawScene = fn(usize, &[&'static str], &mut Random) -> Option<Box<dyn Job>>;

/// A process of which cases can be made.
pub struct Process {
    /// Before the label of a stream of random numbers, so that processes do not share draws.
    pub name: &'static str,
    /// Its effects.
    pub laws: &'static [Law],
    /// A job that admits these effects and does not show them; None where there is none, or the draw was
    /// not lucky.
    pub draw_job: DrawJob,
    /// Effects that no measurement tells apart.
    pub never_together: &'static [[&'static str; 2]],
    /// All effects that the program knows of this process, those of `laws` among them.
    pub catalogue: &'static [Law],
    /// Ways of holding, of making and of measuring, in each of which any two effects may meet.
    pub scenes: &'static [&'static str],
    /// A small job of a scene.
    pub draw_scene: DrawScene,
}

/// All processes by the names that models give them.
pub const BY_NAME: [(&str, &Process); 9] = [
    ("turning", &TURNING),
    ("ring", &RING),
    ("stiffness", &STIFFNESS),
    ("axis", &AXIS),
    ("rotary", &ROTARY),
    ("contour", &CONTOUR),
    ("fixture", &FIXTURE),
    ("thermal", &THERMAL),
    ("cam", &CAM),
];

/// What sort of thing is hidden.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The written model is right.
    Nothing,
    /// Effects of the catalogue.
    Effects,
    /// Structure outside the catalogue.
    Outside,
}

/// What the generator knows and the program must find out.
#[derive(Debug, Clone)]
pub struct Truth {
    /// What sort of thing is hidden.
    pub kind: Kind,
    /// The hidden effects with their true parameters.
    pub hidden: Vec<Hidden>,
    /// Standard deviation of the noise, in the unit of the job.
    pub sigma: f64,
    /// Visibility of every hidden effect, or of the outside structure.
    pub lambda: Vec<f64>,
    /// Standard deviation of the noise of each row, SI.
    pub noise_of_rows: Vec<f64>,
    /// What is left of each lambda when the other hidden effects are re-fitted too; for outside structure,
    /// when the best three effects of the catalogue are fitted to it.
    pub apart: Vec<f64>,
    /// Share of each lambda squared that stands in the rows; the rest is a contradiction of the written
    /// `+-` values.
    pub in_rows: Vec<f64>,
    /// lambda without the prior rows, the `+-` parameters wholly free: what the rows alone can show.
    pub free: Vec<f64>,
    /// True values of the shown `+-` parameters.
    pub shown: Vec<Hidden>,
    /// Name of the outside structure, else empty.
    pub shape: &'static str,
    /// Where the noise can be learnt from.
    pub noise: NoiseKind,
    /// Rows, from 0, that are wrong by themselves.
    pub outliers: Vec<usize>,
}

/// One practice case.
#[derive(Debug, Clone)]
pub struct Case {
    /// The model file.
    pub model: String,
    /// The measurement file.
    pub data: String,
    /// The same job measured again: same design, same truth, new noise.
    pub fresh: String,
    /// The model file with everything known and the hidden effects added: what a perfect diagnosis would
    /// arrive at.
    pub revealed: String,
    /// The measurement file without noise.
    pub exact: String,
    /// What is hidden.
    pub truth: Truth,
}

/// How many draws of job and effect are tried before a wish is given up.
const ATTEMPTS: usize = 60;

/// Smallest and largest noise where nothing of the catalogue is hidden, as parts of the smallest and
/// largest that a workshop has.
const PLAIN_NOISE: (f64, f64) = (6.0, 0.5);

impl Process {
    /// A case in which nothing is missing.
    pub fn nothing(&self, seed: u64) -> Case {
        self.nothing_but(None, seed)
    }

    /// A case in which nothing is missing, measured with a trouble.
    pub fn nothing_but(&self, trouble: Option<Trouble>, seed: u64) -> Case {
        let mut random = self.random("nothing", seed);
        loop {
            if let Some(job) = (self.draw_job)(&[], &mut random) {
                let causes = job.causes(&true_values(&*job, &mut random));
                let sigma = plain_noise(&*job, &mut random);
                let tuned =
                    Tuned { hidden: Vec::new(), sigma, lambda: Vec::new(), in_rows: Vec::new(), free: Vec::new() };
                return finish(&*job, &causes, tuned, Vec::new(), None, trouble, &mut random);
            }
        }
    }

    /// A case with one hidden effect at the given lambda; None if no draw of job and size reaches it.
    pub fn single(&self, effect: &str, lambda: f64, seed: u64) -> Option<Case> {
        self.single_with(None, effect, lambda, seed)
    }

    /// A case with one hidden effect at the given lambda for white noise, measured with a trouble; None if
    /// no draw of job and size reaches it.
    pub fn single_with(&self, trouble: Option<Trouble>, effect: &str, lambda: f64, seed: u64) -> Option<Case> {
        let effect = self.laws.iter().find(|law| law.0 == effect)?.0;
        let mut random = self.random(effect, seed);
        (0..ATTEMPTS).find_map(|_| self.attempt(&[effect], lambda, trouble, &mut random))
    }

    /// A case with `count` different hidden effects, the weakest at the given lambda, the others up to four
    /// times that. Pairs that nothing tells apart are avoided, and so are sets of which a member vanishes
    /// behind the others.
    pub fn several(&self, count: usize, lambda: f64, seed: u64) -> Case {
        let mut random = self.random("several", seed);
        let names: Vec<&'static str> = self.laws.iter().map(|law| law.0).collect();
        loop {
            let mut effects: Vec<&'static str> = Vec::new();
            while effects.len() < count.min(names.len()) {
                let effect = random.pick(&names);
                if !effects.contains(&effect) {
                    effects.push(effect);
                }
            }
            if self.never_together.iter().any(|pair| pair.iter().all(|e| effects.contains(e))) {
                continue;
            }
            if let Some(case) = self.attempt(&effects, lambda, None, &mut random) {
                return case;
            }
        }
    }

    /// A case whose structure no effect of the catalogue can make, at the given lambda after the nuisance
    /// is projected out.
    pub fn outside(&self, lambda: f64, seed: u64) -> Case {
        let mut random = self.random("outside", seed);
        loop {
            let Some(job) = (self.draw_job)(&[], &mut random) else { continue };
            let causes = job.causes(&true_values(&*job, &mut random));
            let nuisance = Nuisance::new(&*job, &causes);
            let sigma = plain_noise(&*job, &mut random);
            let (name, mut shape) = job.shape(&mut random);
            let size = nuisance.lambda(&shape, sigma);
            shape.iter_mut().for_each(|s| *s *= lambda / size);
            let left = what_catalogue_leaves(&*job, &causes, &nuisance, &shape, sigma, &mut random);
            // At least half of the excess must stay unexplained, else naming the effect would be right.
            if left * left > 0.5 * lambda * lambda {
                let in_rows = vec![nuisance.in_rows(&shape, sigma)];
                let free = vec![nuisance.free_lambda(&shape, sigma)];
                let tuned = Tuned { hidden: Vec::new(), sigma, lambda: vec![lambda], in_rows, free };
                return finish(&*job, &causes, tuned, vec![left], Some((name, shape)), None, &mut random);
            }
        }
    }

    fn random(&self, label: &str, seed: u64) -> Random {
        Random::new(&format!("{}{label}", self.name), seed)
    }

    /// One draw of job, true values and effects, brought to the wanted lambda.
    fn attempt(
        &self,
        effects: &[&'static str],
        lambda: f64,
        trouble: Option<Trouble>,
        random: &mut Random,
    ) -> Option<Case> {
        let job = (self.draw_job)(effects, random)?;
        let shown = job.causes(&true_values(&*job, random));
        let drawn: Vec<Hidden> = effects.iter().map(|e| job.draw(e, random)).collect();
        let tuned = tune(&*job, &shown, drawn, lambda, random)?;
        // What only contradicts the priors could be any of many causes.
        if tuned.free.iter().zip(&tuned.lambda).any(|(free, lambda)| *free < 0.5 * lambda) {
            return None;
        }
        let apart = apart(&*job, &shown, &tuned);
        // Behind the others' freedom less than 4 sigma is left: no method could name it.
        if apart.iter().any(|a| *a < 4.0) {
            return None;
        }
        Some(finish(&*job, &shown, tuned, apart, None, trouble, random))
    }
}

/// Noise where no effect has to be brought to a size.
fn plain_noise(job: &dyn Job, random: &mut Random) -> f64 {
    let (least, most) = job.noise_range();
    figures(random.log_uniform(PLAIN_NOISE.0 * least, PLAIN_NOISE.1 * most), 6)
}

/// True values of the shown parameters, drawn from what is written about them.
fn true_values(job: &dyn Job, random: &mut Random) -> Vec<f64> {
    let truth = |s: &job::Shown| if s.written > 0.0 { 0.3 * s.written } else { f64::NEG_INFINITY };
    job.shown().iter().map(|s| (s.written + s.std * random.normal()).max(truth(s))).collect()
}

/// Adds the noise and writes the files.
fn finish(
    job: &dyn Job,
    shown: &[Hidden],
    tuned: Tuned,
    apart: Vec<f64>,
    foreign: Option<(&'static str, Vec<f64>)>,
    trouble: Option<Trouble>,
    random: &mut Random,
) -> Case {
    let mut causes = shown.to_vec();
    causes.extend(tuned.hidden.iter().cloned());
    let mut exact = job.predict(&causes);
    let (shape, structure) = foreign.unwrap_or(("", vec![0.0; exact.len()]));
    exact.iter_mut().zip(structure).for_each(|(e, s)| *e += s);
    for hidden in shown.len()..causes.len() {
        let bend = trouble.map(|t| t.bend(&job.signature(&causes, hidden)));
        exact.iter_mut().zip(bend.into_iter().flatten()).for_each(|(e, off)| *e += off);
    }
    let mut measured = |trouble: Option<Trouble>| {
        let (noise, wrong) = match trouble {
            None => (job.scales().iter().map(|_| random.normal()).collect(), Vec::new()),
            Some(trouble) => trouble.noise(&job.groups(), random),
        };
        let read = |((exact, scale), noise): ((&f64, f64), f64)| {
            let sigma = tuned.sigma * scale;
            let value = exact + sigma * noise;
            trouble.map_or(value, |t| t.shown(value, sigma))
        };
        let observed: Vec<f64> = exact.iter().zip(job.scales()).zip(noise).map(read).collect();
        (job.data(&observed, tuned.sigma * trouble.map_or(1.0, Trouble::stated)), wrong)
    };
    let (data, outliers) = measured(trouble);
    let (fresh, _) = measured(None);
    let values: Vec<f64> = shown.iter().map(|c| c.parameters[0].1).collect();
    let kind = match (shape, tuned.hidden.is_empty()) {
        ("", true) => Kind::Nothing,
        ("", false) => Kind::Effects,
        _ => Kind::Outside,
    };
    Case {
        model: writing::model(job, None, &[]),
        data,
        fresh,
        revealed: writing::model(job, Some(&values), &tuned.hidden),
        exact: job.data(&exact, tuned.sigma),
        truth: Truth {
            kind,
            hidden: tuned.hidden,
            sigma: tuned.sigma,
            noise_of_rows: job.scales().iter().zip(job.si()).map(|(scale, si)| tuned.sigma * scale * si).collect(),
            lambda: tuned.lambda,
            apart,
            in_rows: tuned.in_rows,
            free: tuned.free,
            shown: shown.to_vec(),
            shape,
            noise: job.noise(),
            outliers,
        },
    }
}
