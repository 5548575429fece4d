//! Compensates a moving axis: evaluates its positioning test, and tells what a controller's tables can reach
//! and what they cannot.
//!
//! Of a process it knows only that its observations are a positioning test (`System::positioning`). The
//! tables are made from the measured deviations; they are applied to these, target by target, and to the
//! prediction of the model between the targets, where nothing was measured.

mod causes;
mod feasibility;
mod reversal;
mod wrong;

pub use causes::Cause;
pub use feasibility::Feasibility;
pub use reversal::{Kinematic, LostMotion, Rules, Step};
pub use wrong::WrongReading;

use crate::compare::{SIGNIFICANCE, compare};
use crate::fit::{Estimate, fit};
use crate::input::Parameter;
use crate::model::Data;
use crate::noise::{Acts, Term, beyond_f};
use crate::positioning::{
    Approach, Check, Evaluation, Law, Measures, PitchErrors, Reversal, Steps, Table, Target, Tolerance,
};
use crate::process::{Controller, Failure, ForwardModel, Positioning, System};
use crate::progress::Progress;
use crate::units::Knowledge;
use std::sync::Arc;

/// Evaluation of an axis and of its compensation. SI units: m of a linear axis, rad of a rotary one.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Compensation {
    /// In what positions and deviations are told.
    #[doc(hidden)]
    pub measures: Measures,
    /// Evaluation of the test as measured.
    #[doc(hidden)]
    pub evaluation: Evaluation,
    /// Reversal at every target approached from both sides; `None` where there is none.
    #[doc(hidden)]
    pub reversal: Option<Reversal>,
    /// Pitch errors from target to target.
    #[doc(hidden)]
    pub pitch: PitchErrors,
    /// Parts of the reversal without what the controller compensates, constant and growing along the screw; `None`
    /// where the targets are too few.
    #[doc(hidden)]
    pub lost_motion: Option<LostMotion>,
    /// Tolerances of the axis.
    #[doc(hidden)]
    pub tolerance: Tolerance,
    /// Tolerances checked against the test as measured.
    #[doc(hidden)]
    pub before: Vec<Check>,
    /// Table by which the controller compensated during the test.
    #[doc(hidden)]
    pub active: Option<Table>,
    /// Points at which the controller takes increments.
    #[doc(hidden)]
    pub steps: Option<Steps>,
    /// Ways of compensating: points, segments, both directions.
    #[doc(hidden)]
    pub schemes: [Scheme; 3],
    /// Whether compensation brings the axis within its tolerances.
    pub feasibility: Feasibility,
    /// Causes that stand in the way, if any.
    #[doc(hidden)]
    pub causes: Vec<Cause>,
    /// Agreement of the model itself with the measurements.
    #[doc(hidden)]
    pub model: ModelAgreement,
    /// Lost motion by the model, where the model agrees with the measurements.
    pub modelled_lost_motion: Option<String>,
    /// Readings that are wrong, and left out of means and tables.
    #[doc(hidden)]
    pub wrong_readings: Vec<WrongReading>,
    /// Cautions for the user.
    pub cautions: Vec<String>,
}

/// Way of compensating.
#[derive(Clone, Debug)]
pub struct Scheme {
    /// Key in JSON.
    pub key: &'static str,
    /// Name for people.
    pub name: &'static str,
    /// Table that goes onto what the controller had during the test.
    pub table: Table,
    /// Table that is entered: the sum of both.
    pub entered: Table,
    /// Evaluation of the measured axis with the table: every reading with the correction at its target.
    pub after: Evaluation,
    /// Tolerances checked with the table.
    pub checks: Vec<Check>,
    /// Tolerances checked with a table that was made without the target at which it is judged.
    pub left_out: Vec<Check>,
    /// Modelled axis with the table, along the travel.
    pub modelled: Course,
}

/// Deviations of an axis along its travel, both directions. m.
#[derive(Clone, Debug)]
pub struct Course {
    /// Positions and directions of approach.
    pub approaches: Vec<Approach>,
    /// Deviation of each approach.
    pub deviations: Vec<f64>,
}

/// Agreement of a model with measurements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelAgreement {
    /// Root mean square of measured less predicted, m.
    pub rms: f64,
    /// Whether the noise explains the residuals.
    pub adequate: bool,
    /// Whether the model was fitted first, because it leaves parameters open.
    pub fitted: bool,
}

impl Course {
    /// Largest less smallest deviation, m.
    pub fn spread(&self) -> f64 {
        let fold = |start: f64, better: fn(f64, f64) -> f64| self.deviations.iter().copied().fold(start, better);
        fold(f64::NEG_INFINITY, f64::max) - fold(f64::INFINITY, f64::min)
    }
}

impl Scheme {
    /// Whether the tolerances are kept between the targets too: by a model that agrees with the test, or else
    /// by what a table misses at a target that it was made without.
    fn is_kept_between(&self, tolerance: &Tolerance, model: ModelAgreement) -> bool {
        if model.adequate { self.modelled.spread() <= narrowest(tolerance) } else { passed(&self.left_out) }
    }
}

/// Width of the narrowest band for deviations, m.
fn narrowest(tolerance: &Tolerance) -> f64 {
    tolerance.travel.min(2.0 * tolerance.per_length)
}

fn passed(checks: &[Check]) -> bool {
    checks.iter().all(Check::passed)
}

/// Evaluates a test and compensates the axis; `axis` is the model's system as one that moves to targets.
///
/// # Errors
/// The model cannot be computed or fitted.
pub fn compensate(data: &Data, axis: &dyn Positioning) -> Result<Compensation, Failure> {
    let all = axis.approaches(&data.rows);
    let weighed = wrong::weighed(data, &all);
    let Known { forward, system, agreement, open } = known(&weighed, &all)?;
    // What the model left open has a value now.
    let axis = system.positioning().unwrap_or(axis);
    let wrong_readings = wrong::readings(data, &weighed, &all);
    let out = wrong::stated(&weighed);
    let kept: Vec<usize> = (0..data.len()).filter(|row| !out.contains(row)).collect();
    let approaches: Vec<Approach> = kept.iter().map(|row| all[*row]).collect();
    if axis.reading_at_zero().is_none() {
        asked(&data.observed, axis.measures())?;
    }
    let zero = axis.reading_at_zero().unwrap_or(0.0);
    let deviations_of = |readings: Vec<f64>| readings.into_iter().map(|reading| reading - zero).collect::<Vec<f64>>();
    let observed = deviations_of(kept.iter().map(|row| data.observed[*row]).collect());
    let evaluation = Evaluation::of(&approaches, &observed);
    let Controller { resolution, active, steps } = axis.controller();
    let (tolerance, resolution, active, steps) = (axis.tolerance(), *resolution, active.as_ref(), *steps);
    let measures = axis.measures();
    let alone = active.map(|active| Evaluation::of(&approaches, &active.removed(&approaches, &observed)));
    let between = axis.between(&data.rows);
    let course =
        Course { approaches: axis.approaches(&between), deviations: deviations_of(forward.observe(&between)?) };
    let scheme = |key, name, table: Table| {
        let after = Evaluation::of(&approaches, &table.applied(&approaches, &observed));
        let deviations = table.applied(&course.approaches, &course.deviations);
        let modelled = Course { deviations, approaches: course.approaches.clone() };
        let left_out = Evaluation::of(&approaches, &table.applied_without_own(&approaches, &observed));
        Scheme {
            key,
            name,
            checks: tolerance.checks(&after),
            left_out: tolerance.checks(&left_out),
            after,
            modelled,
            entered: active.map_or_else(|| table.clone(), |active| table.and(active)),
            table,
        }
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
    let fine = tolerance.checks(&Evaluation::of(&approaches, &fine.applied(&approaches, &observed)));
    let feasibility = feasibility(&before, &schemes, &fine, |scheme| scheme.is_kept_between(&tolerance, agreement));
    Ok(Compensation {
        measures,
        reversal: Reversal::of(&evaluation),
        pitch: PitchErrors::of(&evaluation),
        lost_motion: LostMotion::of(alone.as_ref().unwrap_or(&evaluation), |x| axis.screw_compliance(x)),
        active: active.cloned(),
        steps,
        causes: causes::causes((&approaches, &observed), &evaluation, measures, feasibility),
        cautions: [
            of_instrument(data),
            open,
            cautions(&evaluation, &schemes[0], agreement, &tolerance),
            steps.and_then(|steps| of_counts(&schemes[0].entered, steps)).into_iter().collect(),
        ]
        .concat(),
        wrong_readings,
        modelled_lost_motion: if agreement.adequate { lost_motion_of(&*forward) } else { None },
        model: agreement,
        evaluation,
        tolerance,
        before,
        schemes,
        feasibility,
    })
}

/// Readings that lie this many times their own span from zero are hardly deviations.
const FAR: f64 = 3.0;

/// Refuses readings that all lie far beyond their scatter on one side: of such a zero a table would be made too.
fn asked(readings: &[f64], measures: Measures) -> Result<(), Failure> {
    let (low, high) = readings.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(*r), h.max(*r)));
    let (middle, span) = (0.5 * (low + high), high - low);
    if middle.abs() <= FAR * span.max(measures.deviation.to_si(1.0)) {
        return Ok(());
    }
    let [middle, span] = [middle, span].map(|reading| measures.deviation.format(reading));
    Err(Failure {
        message: format!(
            "all readings lie about {middle}, and differ by {span}: is the axis so far off, or the gauge?"
        ),
        help: format!(
            "say in [test] what the instrument shows where the axis stands right: reading_at_zero = \"{middle}\"; or \
             reading_at_zero = \"0 {}\", if these are deviations",
            measures.deviation_unit()
        ),
    })
}

/// A model with a value for every parameter.
struct Known {
    forward: Box<dyn ForwardModel>,
    system: Arc<dyn System>,
    agreement: ModelAgreement,
    /// Cautions about values that the data do not tell.
    open: Vec<String>,
}

/// Takes the model as it is, or fitted where it leaves parameters open.
fn known(data: &Data, approaches: &[Approach]) -> Result<Known, Failure> {
    let model = data.model;
    let mut open = Vec::new();
    let (forward, system, agreement) = if model.parameters.is_empty() {
        let comparison = compare(data)?;
        let agreement = ModelAgreement { rms: comparison.rms, adequate: comparison.adequate(), fitted: false };
        (model.forward(), model.system.clone(), agreement)
    } else {
        let fit = fit(data)?;
        let values: Vec<f64> = fit.estimates.iter().map(|e| e.value).collect();
        let adequate = fit.adequacy == Some(true);
        open.extend(fit.estimates.iter().filter_map(assumed));
        let agreement = ModelAgreement { rms: fit.rms, adequate, fitted: true };
        (model.forward_at(&values)?, model.system_at(&values)?, agreement)
    };
    let predicted = forward.observe(&data.rows)?;
    let left = data.residuals(&predicted);
    let out = wrong::stated(data);
    let kept = || (0..data.len()).filter(|row| !out.contains(row));
    let left: Vec<f64> = kept().map(|row| left[row]).collect();
    let approaches: Vec<Approach> = kept().map(|row| approaches[row]).collect();
    let adequate = agreement.adequate && scatter_explains(&approaches, &left, model.parameters.len());
    Ok(Known { forward, system, agreement: ModelAgreement { adequate, ..agreement }, open })
}

/// The caution about a value of the set-up that nobody knows: neither the model nor the data.
fn assumed(estimate: &Estimate) -> Option<String> {
    let Parameter { path, kind, quantity, .. } = &estimate.parameter;
    let is_assumed = quantity.knowledge == Knowledge::Free && !estimate.is_closed() && !path.starts_with("effects.");
    let value = || format!("{:.4} {}", kind.from_si(estimate.value), kind.unit);
    is_assumed
        .then(|| format!("`{path}` is unknown, and the test does not tell it: what hangs on it takes {}", value()))
}

/// Whether the scatter about the means of the residuals at the targets, each from one side, explains those
/// means (F test). Runs at other times or temperatures count as repeats here, for the model's part of those
/// has been subtracted. `parameters` were fitted.
fn scatter_explains(approaches: &[Approach], left: &[f64], parameters: usize) -> bool {
    let evaluation = Evaluation::of(approaches, left);
    let sides = || evaluation.targets.iter().flat_map(Target::sides);
    let between = sides().count().saturating_sub(parameters) as f64;
    let of_means: f64 = sides().map(|s| s.count as f64 * s.mean.powi(2)).sum();
    // Without repeats there is no test.
    is_scatter(&evaluation.targets, of_means, between).unwrap_or(true)
}

/// Whether the scatter at the targets, each from one side, explains squares of `between` degrees of freedom (F
/// test); `None` without repeats.
fn is_scatter(targets: &[Target], squares: f64, between: f64) -> Option<bool> {
    let sides = || targets.iter().flat_map(Target::sides);
    let within: f64 = sides().map(|s| (s.count - 1) as f64).sum();
    let of_scatter: f64 = sides().filter_map(|s| Some((s.count - 1) as f64 * s.scatter?.powi(2))).sum();
    let ratio = Some((squares / between) / (of_scatter / within)).filter(|_| of_scatter > 0.0)?;
    Some(beyond_f(between, within, ratio)? >= SIGNIFICANCE)
}

/// Lost motion that a model finds, if any.
fn lost_motion_of(forward: &dyn ForwardModel) -> Option<String> {
    let report = forward.report(forward.predict(&Progress::default()).ok()?).ok()?;
    let figure = report.figures.into_iter().find(|f| f.key == "lost_motion")?;
    Some(figure.lines.join("; ")).filter(|text| text != "none")
}

/// Judges by the checks before, those with each scheme, and those with entries as fine as can be.
fn feasibility(
    before: &[Check],
    [points, _, both]: &[Scheme; 3],
    fine: &[Check],
    is_kept_between: impl Fn(&Scheme) -> bool,
) -> Feasibility {
    let suffices = |scheme: &Scheme| passed(&scheme.checks) && is_kept_between(scheme);
    match () {
        () if passed(before) => Feasibility::Within,
        () if suffices(points) => Feasibility::Compensation,
        () if suffices(both) => Feasibility::BothDirections,
        () if passed(&points.checks) || passed(&both.checks) => Feasibility::BetweenTargets,
        () if passed(fine) => Feasibility::Resolution,
        // A known value may be out of tolerance already.
        () if both.checks.iter().any(|c| c.value.is_some_and(|v| v > c.limit)) => Feasibility::Repair,
        () => Feasibility::Unknown,
    }
}

/// Cautions about the effects of the measurement that the model states.
fn of_instrument(data: &Data) -> Vec<String> {
    let mut cautions = data.cautions.clone();
    let is_in_readings = |t: &&Term| t.effect.acts.is_reading() || matches!(t.effect.acts, Acts::Shared(_));
    let names: Vec<&str> = data.terms.iter().filter(is_in_readings).map(|t| t.effect.name).collect();
    if !names.is_empty() {
        let names = names.join(", ");
        cautions.push(format!("the tables are made of the readings as they are: {names} is not taken out of them"));
    }
    cautions
}

/// A caution where an increment has more counts than controls take.
fn of_counts(table: &Table, steps: Steps) -> Option<String> {
    /// Most counts of one increment on many controls of FANUC.
    const MOST: i64 = 7;
    let most = table.increments(steps).into_iter().filter_map(|s| s.counts).max_by_key(|counts| counts.abs())?;
    (most.abs() > MOST).then(|| {
        format!("one increment has {most} counts, and many controls take {MOST} either way: raise `magnification`, or shorten `interval`")
    })
}

fn cautions(evaluation: &Evaluation, points: &Scheme, model: ModelAgreement, tolerance: &Tolerance) -> Vec<String> {
    let mut cautions = evaluation.departures(tolerance.measures);
    if evaluation.runs() < 2 {
        cautions.push("a single approach has no scatter: A and R, and with them the tolerances, are not known".into());
    }
    if Reversal::of(evaluation).is_some() && points.entered.backlash() < 0.0 {
        let ahead = "the axis runs ahead after a reversal, and few controllers take a backlash value below zero";
        cautions.push(format!("{ahead}: use the table for each direction"));
    }
    let width = points.modelled.spread();
    if !model.adequate {
        let doubt =
            "the model does not explain what was measured, so that what it says between the targets is doubtful";
        cautions.push(format!("{doubt}; `fem diagnose` tells what is missing"));
    } else if width > narrowest(tolerance) {
        let width = tolerance.measures.deviation.shown(width);
        cautions.push(format!(
            "with the point table the model still ranges over {width:.3} between the targets: take more of them, closer than the error varies"
        ));
    }
    cautions
}
