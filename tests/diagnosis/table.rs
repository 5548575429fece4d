//! The table of error rates.

use std::fmt;

use super::score::Score;

/// Scores by group, in the order in which groups came.
#[derive(Default)]
pub struct Table {
    groups: Vec<(String, Vec<Score>)>,
}

impl Table {
    pub fn add(&mut self, group: &str, score: Score) {
        match self.groups.iter_mut().find(|g| g.0 == group) {
            Some(found) => found.1.push(score),
            None => self.groups.push((group.to_string(), vec![score])),
        }
    }

    pub fn scores(&self, group: &str) -> &[Score] {
        self.groups.iter().find(|g| g.0 == group).map_or(&[], |g| &g.1)
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "| hidden | cases | right | no cause | named first | all named | mean class | in interval95 | χ²/n fresh | median s | worst s |"
        )?;
        writeln!(f, "|---|---|---|---|---|---|---|---|---|---|---|")?;
        for (group, scores) in &self.groups {
            let n = scores.len() as f64;
            let part = |is: fn(&Score) -> bool| 100.0 * scores.iter().filter(|s| is(s)).count() as f64 / n;
            let fresh = scores.iter().map(|s| s.fresh).sum::<f64>() / n;
            let mut seconds: Vec<f64> = scores.iter().map(|s| s.seconds).collect();
            seconds.sort_unstable_by(f64::total_cmp);
            let (median, worst) = (seconds[seconds.len() / 2], seconds[seconds.len() - 1]);
            let mut no_cause = format!("{:.1} %", part(|s| s.no_cause));
            let named = if scores.iter().any(|s| s.hides_effects) {
                let classes: Vec<f64> = scores.iter().flat_map(|s| &s.classes).map(|c| *c as f64).collect();
                let mean = classes.iter().sum::<f64>() / classes.len().max(1) as f64;
                let covered = scores.iter().fold((0, 0), |(a, b), s| (a + s.covered.0, b + s.covered.1));
                no_cause = "-".into();
                let (first, all) = (part(|s| s.first), part(|s| s.all_named));
                format!("{first:.1} % | {all:.1} % | {mean:.2} | {} of {}", covered.0, covered.1)
            } else {
                "- | - | - | -".into()
            };
            let right = part(|s| s.right);
            writeln!(
                f,
                "| {group} | {} | {right:.1} % | {no_cause} | {named} | {fresh:.3} | {median:.2} | {worst:.2} |",
                scores.len()
            )?;
        }
        Ok(())
    }
}
