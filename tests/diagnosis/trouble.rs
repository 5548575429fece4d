//! Measurements with a trouble of their own: it is named for what it is, and no effect of the machine in its
//! stead; one that is hidden beside it is still named.

use std::collections::BTreeSet;

use fem::diagnose::{Cause, Diagnosis, Verdict};
use generator::{Case, NoiseKind, Process, Trouble};

use crate::score;

/// λ of hidden effects, for white noise. Under a trouble less of it is left.
const PLAIN: f64 = 60.0;

/// Counts of what was said right.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Cases with nothing hidden, those of them without an effect of the machine named, and those adequate
    /// once the trouble stands in the model.
    nothing: [usize; 3],
    /// Cases with one effect hidden, and those in which it is named, or its class, and none besides.
    one: [usize; 2],
    /// Cases, and those in which the trouble is named.
    told: [usize; 2],
    /// Outlying rows, those of them that were found, and good rows that were taken for such.
    outliers: [usize; 3],
}

impl Tally {
    /// Diagnoses cases of a process, with nothing hidden and with one effect each.
    pub fn of(process: &Process, trouble: Trouble, seeds: impl Iterator<Item = u64> + Clone) -> Self {
        let mut tally = Self::default();
        for seed in seeds.clone() {
            tally.count(process.nothing_but(Some(trouble), seed), trouble);
        }
        for (law, seed) in process.laws.iter().zip(seeds.cycle()) {
            if let Some(case) = process.single_with(Some(trouble), law.0, PLAIN, seed) {
                tally.count(case, trouble);
            }
        }
        tally
    }

    fn count(&mut self, case: Case, trouble: Trouble) {
        // An uncertainty that nobody states cannot be understated; rows that repeat each other side by side
        // share their noise with nobody who could tell.
        if case.truth.noise != NoiseKind::Column {
            return;
        }
        let Ok(diagnosis) = score::diagnosis(&case) else { return };
        let wanted = trouble.names();
        // A step of the instrument at the first row of a part and a correction of the tool there are one cause with two
        // names: whichever is named first, the other stands in its class.
        let is_hidden = |name: &&str| case.truth.hidden.iter().any(|hidden| hidden.effect == *name);
        let is_of_trouble =
            |class: &Vec<&str>| class.iter().any(|name| wanted.contains(name)) && !class.iter().any(is_hidden);
        let physical = diagnosis.missing.iter().filter(|m| m.cause == Cause::Physical).map(score::class);
        let (of_trouble, physical): (Vec<Vec<&str>>, Vec<Vec<&str>>) = physical.partition(is_of_trouble);
        if case.truth.hidden.is_empty() {
            self.nothing[0] += 1;
            self.nothing[1] += usize::from(physical.is_empty());
            self.nothing[2] += usize::from(physical.is_empty() && diagnosis.verdict_after == Verdict::Adequate);
        } else {
            self.one[0] += 1;
            let hidden = case.truth.hidden[0].effect;
            self.one[1] += usize::from(physical.len() == 1 && physical[0].contains(&hidden));
        }
        self.told[0] += 1;
        let is_told =
            wanted.is_empty() || !of_trouble.is_empty() || names(&diagnosis).any(|name| wanted.contains(&name));
        self.told[1] += usize::from(is_told);
        if !is_told || case.truth.hidden.is_empty() && !physical.is_empty() {
            let said: Vec<&str> = diagnosis.missing.iter().map(|m| &*m.effect.name).collect();
            let hidden: Vec<&str> = case.truth.hidden.iter().map(|h| h.effect).collect();
            println!("{trouble:?} and {hidden:?}: {said:?}");
            if let Some(directory) = std::env::var_os("FEM_MISSES") {
                crate::keep(&std::path::Path::new(&directory).join(format!("{trouble:?} {}", hidden.join(" "))), &case);
            }
        }
        let rows: BTreeSet<usize> = diagnosis.outliers.iter().map(|o| o.record - 1).collect();
        let wrong: BTreeSet<usize> = case.truth.outliers.iter().copied().collect();
        self.outliers[0] += wrong.len();
        self.outliers[1] += rows.intersection(&wrong).count();
        self.outliers[2] += rows.difference(&wrong).count();
    }

    /// A row of the table.
    pub fn line(&self, trouble: Trouble) -> String {
        let part = |[all, some]: [usize; 2]| format!("{some}/{all}");
        format!(
            "{:<12} {:>8} {:>8} {:>8} {:>8} {:>8}, {} good rows",
            format!("{trouble:?}"),
            part([self.nothing[0], self.nothing[1]]),
            part([self.nothing[0], self.nothing[2]]),
            part(self.one),
            part(self.told),
            part([self.outliers[0], self.outliers[1]]),
            self.outliers[2]
        )
    }

    /// Whether at least these parts of the cases are right.
    pub fn is_at_least(&self, part: f64) -> bool {
        let enough = |all: usize, some: usize| some as f64 >= part * all as f64;
        enough(self.nothing[0], self.nothing[1])
            && enough(self.nothing[0], self.nothing[2])
            && enough(self.one[0], self.one[1])
            && enough(self.told[0], self.told[1])
            && enough(self.outliers[0], self.outliers[1])
    }
}

/// Effects of the measurement that were named.
fn names(diagnosis: &Diagnosis) -> impl Iterator<Item = &str> {
    diagnosis.missing.iter().filter(|m| m.cause != Cause::Physical).map(|m| &*m.effect.name)
}
