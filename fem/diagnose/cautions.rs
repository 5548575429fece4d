//! Cautions about the data, to be read before a diagnosis is believed.

use super::few_places::few_places;
use super::prior_conflict::{PriorConflict, Released};
use super::search::SearchResult;
use super::verdict::Verdict;
use crate::fit::Fit;
use crate::measure::Repeats;
use crate::model::OwnOdds;

/// Cautions about the limits of these data.
pub fn cautions(
    found: &SearchResult,
    (repeats, fit): (&Repeats, &Fit),
    verdict: Verdict,
    released: &Released,
) -> Vec<String> {
    let base = &found.base;
    let measurements = base.objective.data;
    let coordinates = base.objective.data.model.process.coordinates();
    let varies = |i: &usize| {
        let column = &measurements.rows.columns[*i];
        !coordinates[*i].repeats && column.iter().any(|v| *v != column[0])
    };
    let mut cautions: Vec<String> = released.conflicts.iter().map(PriorConflict::text).collect();
    cautions.extend(own_odds(&measurements.model.odds));
    if measurements.progress.is_over() {
        cautions.push("the time was over before the search was: the verdict is about what was tried by then".into());
    }
    cautions.extend(measurements.cautions.iter().chain(&fit.doubts).cloned());
    if !measurements.given.iter().any(varies) {
        cautions
            .push("every row stands at the same place under the same conditions: causes cannot be told apart".into());
    }
    if base.objective.freedom() < 3.0 {
        cautions.push("the rows are so few that almost any cause fits them".into());
    }
    if measurements.uncertainty.is_none() && repeats.scatter.iter().any(|s| s.freedom > 0 && s.sum_of_squares == 0.0) {
        cautions
            .push("rows that repeat each other are identical, as if copied: the noise cannot be judged by them".into());
    }
    cautions.extend(few_places(found.best()));
    let left = matches!(verdict, Verdict::PartlyExplained | Verdict::Unexplained);
    if left && found.best().members.len() == found.most && found.most < found.candidates.len() {
        let most = found.most;
        cautions.push(format!("no more than {most} effects were looked for together; --max-effects looks for more"));
    }
    cautions
}

/// What the model says about odds, on which all probabilities depend.
fn own_odds(odds: &OwnOdds) -> Option<String> {
    let told: Vec<String> = odds.iter().map(|(name, odds)| format!("{odds} to one for {name}")).collect();
    (!told.is_empty())
        .then(|| format!("probabilities follow the odds that the model gives itself: {}", told.join(", ")))
}
