//! The kinds of what a diagnosis says of effects: certain, described, open; groups have their own in the posterior.

use super::words::label;
use crate::diagnose::{CERTAIN, Diagnosis, Missing, RULED_OUT, speaks};
use crate::process::Description;

/// The effects that a diagnosis tells, by kind.
pub struct Kinds<'d> {
    /// Those that are certain.
    pub certain: Vec<&'d Missing>,
    /// Those that describe what no law here has.
    pub described: Vec<&'d Missing>,
    /// Those of the set that is told that are neither, and in no group.
    pub perhaps: Vec<&'d Missing>,
    /// The same and what may be there beside that set, the most probable first.
    pub open: Vec<Open>,
}

/// An effect that may be there.
pub struct Open {
    /// Its name, with what groups the rows.
    pub label: String,
    /// Its probability.
    pub probability: f64,
    /// That before the data, where its odds are known.
    pub before: Option<f64>,
}

impl<'d> Kinds<'d> {
    /// Sorts what a diagnosis tells.
    pub fn of(d: &'d Diagnosis) -> Self {
        let (described, explaining): (Vec<&Missing>, Vec<&Missing>) = d.missing.iter().partition(|m| m.describes());
        let (certain, others): (Vec<&Missing>, Vec<&Missing>) =
            explaining.into_iter().partition(|m| m.probability >= CERTAIN);
        let perhaps: Vec<&Missing> = others.into_iter().filter(|m| !is_grouped(d, &m.effect)).collect();
        let is_told = |name: &str| d.missing.iter().any(|m| m.effect.name == *name);
        let beside = d.posterior.open().into_iter().filter(|(name, p)| *p >= RULED_OUT && !is_told(name));
        let open = |label: String, name: &str, probability: f64| Open { label, probability, before: before(d, name) };
        let told = perhaps.iter().map(|m| open(label(m), &m.effect.name, m.probability));
        let mut all: Vec<Open> = told.chain(beside.map(|(name, p)| open(name.to_string(), &name, p))).collect();
        all.sort_by(|a, b| b.probability.total_cmp(&a.probability));
        Self { certain, described, perhaps, open: all }
    }
}

impl Open {
    /// Whether the data speak for it.
    pub fn is_notable(&self) -> bool {
        self.before.is_none_or(|before| speaks(self.probability, before))
    }
}

/// Whether an effect is in a group of which some are there.
pub fn is_grouped(d: &Diagnosis, effect: &Description) -> bool {
    d.posterior.groups.iter().any(|group| group.effects.contains(&effect.name))
}

/// Probability of an effect before the data; of an effect of the measurement that is no candidate nothing is known.
fn before(d: &Diagnosis, name: &str) -> Option<f64> {
    let odds: f64 = d.candidates.iter().filter(|c| c.effect.name == *name).map(|c| c.effect.odds.to_one).sum();
    (odds > 0.0).then(|| odds / (1.0 + odds))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_as_likely_as_before_is_no_finding() {
        let is_notable =
            |before: Option<f64>, probability: f64| Open { label: "a".into(), probability, before }.is_notable();
        // Odds of 1 and 2, of 1 and 4, and of 1 to 9 and 1.
        assert!(!is_notable(Some(0.5), 2.0 / 3.0) && is_notable(Some(0.5), 0.8) && is_notable(Some(0.1), 0.5));
        assert!(!is_notable(Some(0.9), 0.9) && is_notable(Some(0.9), 1.0) && is_notable(None, 0.06));
    }
}
