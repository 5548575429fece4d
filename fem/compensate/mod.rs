//! Compensation of a moving axis: its positioning test evaluated, what a controller's tables make of it, and what they cannot.
//!
//! Knows of a process only that its observations are a positioning test (`System::positioning`). The tables come from what was measured; they are
//! applied to what was measured, target by target, and to what the model predicts between the targets, where nothing was measured.

mod causes;
mod reversal;

pub use causes::Cause;
pub use reversal::{LostMotion, Rules};

use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use crate::compare::{SIGNIFICANCE, compare};
use crate::fit::fit;
use crate::measure::Measurements;
use crate::model::Model;
use crate::positioning::{Approach, Check, Evaluation, Law, PitchErrors, Reversal, Table, Target, Tolerance};
use crate::process::{Failure, Job, Positioning};
use crate::progress::Progress;

/// Everything that is said of an axis and its compensation. SI units.
#[derive(Clone, Debug)]
pub struct Compensation {
    /// As measured.
    pub evaluation: Evaluation,
    /// Of every target approached from both sides; `None` where there is none.
    pub reversal: Option<Reversal>,
    /// From target to target.
    pub pitch: PitchErrors,
    /// What part of the reversal grows along the screw; `None` where too few targets tell.
    pub lost_motion: Option<LostMotion>,
    /// What is allowed.
    pub tolerance: Tolerance,
    /// Held against what was measured.
    pub before: Vec<Check>,
    /// What each way of compensating leaves: points, segments, both directions.
    pub schemes: [Scheme; 3],
    /// Whether compensation can do it.
    pub verdict: Verdict,
    /// What stands in the way, where something does.
    pub causes: Vec<Cause>,
    /// How well the model itself agrees with the measurements.
    pub model: Agreement,
    /// What a model that agrees with them says of the lost motion.
    pub modelled_lost_motion: Option<String>,
    /// What should not be overlooked.
    pub cautions: Vec<String>,
}

/// A way of compensating.
#[derive(Clone, Debug)]
pub struct Scheme {
    /// For programs.
    pub key: &'static str,
    /// For people.
    pub name: &'static str,
    /// What is entered.
    pub table: Table,
    /// The measured axis with the table: every reading with what the table adds at its target.
    pub after: Evaluation,
    /// Its tolerances.
    pub checks: Vec<Check>,
    /// The modelled axis with the table, from target to target.
    pub modelled: Course,
}

/// An axis along its travel, both directions. m.
#[derive(Clone, Debug)]
pub struct Course {
    /// Where.
    pub approaches: Vec<Approach>,
    /// Deviation of each.
    pub deviations: Vec<f64>,
}

/// How well a model agrees with what was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Root mean square of measured less predicted, m.
    pub rms: f64,
    /// Whether the noise explains that.
    pub adequate: bool,
    /// Whether the model was fitted first, since it leaves something open.
    pub fitted: bool,
}

/// Whether compensation brings the axis within its tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is within them as it is.
    Within,
    /// One pitch table and one backlash value do it.
    Compensation,
    /// Only a table for each direction does it.
    BothDirections,
    /// Tables would do it if the controller took finer entries.
    Resolution,
    /// No table does it: the mechanics must be repaired first.
    Repair,
    /// The test does not tell: repeated approaches are missing.
    Unknown,
}

impl Verdict {
    /// For programs.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Within => "within-tolerance",
            Self::Compensation => "compensation-suffices",
            Self::BothDirections => "needs-both-directions",
            Self::Resolution => "needs-finer-resolution",
            Self::Repair => "repair-first",
            Self::Unknown => "unknown",
        }
    }
}

impl Course {
    /// Largest less smallest deviation, m.
    pub fn spread(&self) -> f64 {
        let fold = |start: f64, better: fn(f64, f64) -> f64| self.deviations.iter().copied().fold(start, better);
        fold(f64::NEG_INFINITY, f64::max) - fold(f64::INFINITY, f64::min)
    }
}

/// Evaluates and compensates; `axis` is the model's system as one that moves to targets.
///
/// # Errors
/// The model cannot be computed or fitted.
pub fn compensate(model: &Model, axis: &dyn Positioning, measurements: &Measurements) -> Result<Compensation, Failure> {
    let approaches = axis.approaches(&measurements.rows);
    let evaluation = Evaluation::of(&approaches, &measurements.observed);
    let (job, agreement) = known(model, measurements, &approaches)?;
    let (tolerance, resolution) = (axis.tolerance(), axis.resolution());
    let between = axis.between(&measurements.rows);
    let course = Course { approaches: axis.approaches(&between), deviations: job.observe(&between)? };
    let scheme = |key, name, table: Table| {
        let after = Evaluation::of(&approaches, &table.applied(&approaches, &measurements.observed));
        let deviations = table.applied(&course.approaches, &course.deviations);
        let modelled = Course { deviations, approaches: course.approaches.clone() };
        Scheme { key, name, checks: tolerance.checks(&after), after, modelled, table }
    };
    let one = |law| Table::with_backlash(&evaluation, law, resolution);
    let both = Table::both_directions(&evaluation, Law::Points, resolution);
    let schemes = [
        scheme("points", "point table and backlash value", one(Law::Points)),
        scheme("segments", "segments and backlash value", one(Law::Segments)),
        scheme("both_directions", "point table each way", both),
    ];
    let before = tolerance.checks(&evaluation);
    let fine = Table::both_directions(&evaluation, Law::Points, 0.0);
    let fine = tolerance.checks(&Evaluation::of(&approaches, &fine.applied(&approaches, &measurements.observed)));
    let verdict = verdict(&before, &schemes, &fine);
    Ok(Compensation {
        reversal: Reversal::of(&evaluation),
        pitch: PitchErrors::of(&evaluation),
        lost_motion: LostMotion::of(&evaluation, |x| axis.screw_compliance(x)),
        causes: causes::causes(&approaches, &measurements.observed, &evaluation, verdict),
        cautions: cautions(&evaluation, &schemes[0].modelled, agreement, &tolerance),
        modelled_lost_motion: if agreement.adequate { lost_motion_of(&*job) } else { None },
        model: agreement,
        evaluation,
        tolerance,
        before,
        schemes,
        verdict,
    })
}

/// The model with a value for everything, ready to predict: fitted where it leaves something open.
fn known(
    model: &Model,
    measurements: &Measurements,
    approaches: &[Approach],
) -> Result<(Box<dyn Job>, Agreement), Failure> {
    let (job, agreement) = if model.parameters.is_empty() {
        let comparison = compare(model, measurements)?;
        (model.job(), Agreement { rms: comparison.rms, adequate: comparison.adequate(), fitted: false })
    } else {
        let fit = fit(model, measurements)?;
        let values: Vec<f64> = fit.estimates.iter().map(|e| e.value).collect();
        let adequate = fit.p_value.is_none_or(|p| p >= SIGNIFICANCE);
        (model.job_at(&values)?, Agreement { rms: fit.rms, adequate, fitted: true })
    };
    let predicted = job.observe(&measurements.rows)?;
    let left: Vec<f64> = measurements.observed.iter().zip(&predicted).map(|(y, p)| y - p).collect();
    let adequate = agreement.adequate && scatter_explains(approaches, &left, model.parameters.len());
    Ok((job, Agreement { adequate, ..agreement }))
}

/// Whether the means that a model leaves at the targets, each from one side, are such as the scatter about them leaves. Runs at other times or
/// temperatures repeat each other here too: what the model knows of those has been taken out. `parameters` were fitted.
fn scatter_explains(approaches: &[Approach], left: &[f64], parameters: usize) -> bool {
    let evaluation = Evaluation::of(approaches, left);
    let sides = || evaluation.targets.iter().flat_map(Target::sides);
    let groups = sides().count();
    let within = (approaches.len() - groups) as f64;
    let between = groups.saturating_sub(parameters) as f64;
    let of_scatter: f64 = sides().filter_map(|s| Some((s.count - 1) as f64 * s.scatter?.powi(2))).sum();
    let of_means: f64 = sides().map(|s| s.count as f64 * s.mean.powi(2)).sum();
    match FisherSnedecor::new(between, within) {
        Ok(chance) if of_scatter > 0.0 => chance.sf((of_means / between) / (of_scatter / within)) >= SIGNIFICANCE,
        // Without repeats nothing tells.
        _ => true,
    }
}

/// What a model finds of the lost motion, where it finds any.
fn lost_motion_of(job: &dyn Job) -> Option<String> {
    let outcome = job.outcome(job.predict(&Progress::default()).ok()?).ok()?;
    outcome.findings.into_iter().find(|f| f.key == "lost_motion").map(|f| f.text).filter(|text| text != "none")
}

/// From the tolerances before, those with each scheme, and those with entries as fine as can be.
fn verdict(before: &[Check], [points, _, both]: &[Scheme; 3], fine: &[Check]) -> Verdict {
    let passed = |checks: &[Check]| checks.iter().all(Check::passed);
    match () {
        () if passed(before) => Verdict::Within,
        () if passed(&points.checks) => Verdict::Compensation,
        () if passed(&both.checks) => Verdict::BothDirections,
        () if passed(fine) => Verdict::Resolution,
        // What is known may be too wide already.
        () if both.checks.iter().any(|c| c.value.is_some_and(|v| v > c.limit)) => Verdict::Repair,
        () => Verdict::Unknown,
    }
}

fn cautions(evaluation: &Evaluation, left: &Course, model: Agreement, tolerance: &Tolerance) -> Vec<String> {
    let mut cautions = evaluation.departures();
    if evaluation.runs() < 2 {
        cautions.push("a single approach has no scatter: A and R, and with them the tolerances, are not known".into());
    }
    if Reversal::of(evaluation).is_some_and(|r| r.value < 0.0) {
        let ahead = "the axis runs ahead after a reversal, and few controllers take a backlash value below zero";
        cautions.push(format!("{ahead}: use the table for each direction"));
    }
    let width = left.spread();
    if !model.adequate {
        let doubt =
            "the model does not explain what was measured, so that what it says between the targets is doubtful";
        cautions.push(format!("{doubt}; `fem diagnose` tells what is missing"));
    } else if width > tolerance.travel.min(2.0 * tolerance.per_length) {
        let width = 1e6 * width;
        cautions.push(format!(
            "with the point table the model still ranges over {width:.3} um between the targets: take more of them, closer than the error varies"
        ));
    }
    cautions
}
