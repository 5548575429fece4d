//! Causes for which tables do not reach a tolerance, and where to look for them in the machine [seed 001].

use super::Feasibility;
use crate::positioning::{Approach, Evaluation, Measures, Reversal, Side, Target};

/// Places where a mechanic looks first when the resistance along the travel is uneven, or the axis does not
/// come back to the same place.
const PLACES: &str = "gibs that fit unevenly, lubrication, the seat of the screw and its bearings";
/// The same where an axis turns.
const ROUND: &str =
    "the mesh of worm and wheel or of the gears, the bearing of the table, its clamp and its lubrication";
/// Part of the scatter above which a drift is its cause.
const MAIN: f64 = 0.5;
/// Ratio of variances beyond which one exceeds the other.
const UNEVEN: f64 = 2.5;
/// Fewest approaches from which a drift is estimated.
const RUNS: usize = 3;

/// Cause that keeps an axis from its tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// Key in JSON.
    pub key: &'static str,
    /// Finding, in a sentence.
    pub finding: String,
    /// Remedy, in a sentence.
    pub remedy: String,
}

/// Finds the causes that keep the axis from its tolerance. Where a table for each direction suffices, the
/// reversal is uneven; where none does, the axis scatters.
pub fn causes(
    readings: (&[Approach], &[f64]),
    evaluation: &Evaluation,
    measures: Measures,
    feasibility: Feasibility,
) -> Vec<Cause> {
    match feasibility {
        Feasibility::Within | Feasibility::Compensation | Feasibility::BetweenTargets | Feasibility::Unknown => {
            Vec::new()
        }
        Feasibility::Resolution => vec![Cause {
            key: "resolution",
            finding: "the entries of the controller are too coarse: exact ones would do".into(),
            remedy: "enter the tables in a finer unit; `resolution` in [controller] says which the controller takes"
                .into(),
        }],
        Feasibility::BothDirections => uneven(evaluation, measures).into_iter().collect(),
        Feasibility::Repair => {
            let uneven = uneven(evaluation, measures).filter(|_| varies(evaluation));
            uneven.into_iter().chain([scatter(readings, evaluation, measures)]).collect()
        }
    }
}

fn uneven(evaluation: &Evaluation, measures: Measures) -> Option<Cause> {
    let rest = measures.deviation.shown(Reversal::of(evaluation)?.rest);
    if measures.is_rotary() {
        return Some(Cause {
            key: "uneven_reversal",
            finding: format!(
                "the reversal varies round the axis: {rest:.3} either way stay beside any single backlash value"
            ),
            remedy: format!(
                "the play must be the same all round, look at {ROUND}; or enter a table for each direction"
            ),
        });
    }
    Some(Cause {
        key: "uneven_reversal",
        finding: format!(
            "the reversal varies along the travel: {rest:.3} either way stay beside any single backlash value"
        ),
        remedy: format!(
            "the slide must go equally hard all along, look at {PLACES}; or enter a table for each direction"
        ),
    })
}

/// Whether the reversal varies by more than the means are uncertain.
fn varies(evaluation: &Evaluation) -> bool {
    let Some(reversal) = Reversal::of(evaluation) else { return false };
    let n = reversal.lost.len() as f64;
    let mean = reversal.lost.iter().map(|b| b.1).sum::<f64>() / n;
    let variance = reversal.lost.iter().map(|b| (b.1 - mean).powi(2)).sum::<f64>() / (n - 1.0).max(1.0);
    let of_mean = |side: &Side| side.scatter.map_or(0.0, |s| s * s / side.count as f64);
    let of_means = evaluation.targets.iter().flat_map(Target::sides).map(of_mean).sum::<f64>() / n;
    variance > UNEVEN * of_means
}

/// Describes the scatter, which no table removes. Where most of it is a drift over the runs, its cause is
/// warmth, of the axis or of the instrument.
fn scatter((approaches, deviations): (&[Approach], &[f64]), evaluation: &Evaluation, measures: Measures) -> Cause {
    let largest = evaluation.targets.iter().flat_map(Target::sides).filter_map(Side::repeatability).fold(0.0, f64::max);
    let drift = Drift::of(approaches, deviations);
    let (most, is_rotary) = (measures.deviation.shown(largest), measures.is_rotary());
    let found = format!("approaches from one side scatter by 4s = {most:.3} where most, which no table removes");
    if drift.part > MAIN {
        let (percent, moved) = (100.0 * drift.part, measures.deviation.shown(drift.moved));
        return Cause {
            key: "drift",
            finding: format!(
                "{found}; {percent:.0} % of it is a drift over the runs, {moved:+.3} from first to last where most"
            ),
            remedy: format!(
                "the axis warms as it works, or the instrument's zero wanders: measure a master between the runs; then \
                 warm the axis up first, cool the {}, or compensate by temperature",
                if is_rotary { "drive" } else { "screw" }
            ),
        };
    }
    let places = if is_rotary { ROUND } else { PLACES };
    Cause { key: "scatter", finding: found, remedy: format!("look at {places}") }
}

/// Drift of the deviations over the runs (linear regression).
struct Drift {
    /// Part of the scatter about the targets' means that is a straight line over the runs.
    part: f64,
    /// The largest rise from the first run to the last, m.
    moved: f64,
}

impl Drift {
    fn of(approaches: &[Approach], deviations: &[f64]) -> Self {
        let mut rows: Vec<usize> = (0..approaches.len()).collect();
        let place = |row: &usize| (approaches[*row].position, approaches[*row].direction.sign());
        rows.sort_by(|a, b| place(a).0.total_cmp(&place(b).0).then(place(a).1.cmp(place(b).1)));
        let (mut straight, mut all, mut largest) = (0.0, 0.0, 0.0f64);
        for own in rows.chunk_by(|a, b| place(a) == place(b)).filter(|own| own.len() >= RUNS) {
            let n = own.len() as f64;
            let run = own.iter().map(|r| approaches[*r].run).sum::<f64>() / n;
            let mean = own.iter().map(|r| deviations[*r]).sum::<f64>() / n;
            let spread: f64 = own.iter().map(|r| (approaches[*r].run - run).powi(2)).sum();
            if spread == 0.0 {
                continue;
            }
            let along: f64 = own.iter().map(|r| (approaches[*r].run - run) * (deviations[*r] - mean)).sum();
            let squares: f64 = own.iter().map(|r| (deviations[*r] - mean).powi(2)).sum();
            // A line takes 1/(n − 1) of pure noise.
            straight += along * along / spread - squares / (n - 1.0);
            all += squares;
            let runs = own.iter().map(|r| approaches[*r].run);
            let (first, last) = runs.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), r| (a.min(r), b.max(r)));
            let moved = along / spread * (last - first);
            largest = if moved.abs() > largest.abs() { moved } else { largest };
        }
        Self { part: if all > 0.0 { straight.max(0.0) / all } else { 0.0 }, moved: largest }
    }
}
