//! Layout of the rows of a study: enough to read them again without plan and model.

use std::ops::Range;

/// Nature of the points at which a study looked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nature {
    /// Independent draws from the laws.
    Independent,
    /// Spread evenly over the laws: closer to them than independent draws.
    Even,
    /// Listed: they stand for no distribution.
    Listed,
}

impl Nature {
    /// Words in files.
    pub const WORDS: &[(&'static str, Self)] =
        &[("independent", Self::Independent), ("even", Self::Even), ("listed", Self::Listed)];
}

/// A column of numbers or words.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultColumn {
    /// Name, without the unit.
    pub name: String,
    /// Unit; empty for a pure number.
    pub unit: String,
    /// Whether it holds words.
    pub is_word: bool,
    /// Smallest and largest value that is accepted, in the unit.
    pub tolerance: Option<(f64, f64)>,
}

/// Layout of the rows of a study: their columns, and everything on which they depend.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Everything on which the rows depend, by its name: rows of two studies belong together if this is equal.
    pub facts: Vec<(String, String)>,
    /// Title of the plan.
    pub title: Option<String>,
    /// File of the plan.
    pub plan: String,
    /// Word of the task.
    pub task: String,
    /// Word of the design.
    pub design: String,
    /// Number of jobs.
    pub jobs: u64,
    /// Jobs that belong together: with indices A, B and, for each input, A with that input of B; else one.
    pub group: u64,
    /// Nature of the points.
    pub nature: Nature,
    /// Name and unit of each input.
    pub inputs: Vec<(String, String)>,
    /// Whether each row names the file of its measurements.
    pub has_data: bool,
    /// Columns of results.
    pub results: Vec<ResultColumn>,
}

impl Layout {
    /// Differences between the studies of two rows: the first few, for people; empty where there are none.
    pub fn differences(&self, other: &Self) -> Vec<String> {
        /// Most that are told.
        const MOST: usize = 4;
        let of = |layout: &Self, key: &str| layout.facts.iter().find(|(k, _)| k == key).map(|(_, v)| v.clone());
        let mut keys: Vec<&String> = self.facts.iter().chain(&other.facts).map(|(key, _)| key).collect();
        let mut seen = std::collections::BTreeSet::new();
        keys.retain(|key| seen.insert(*key));
        let told = |value: Option<String>| value.unwrap_or_else(|| "not there".into());
        let different = keys.into_iter().filter_map(|key| {
            let (before, now) = (of(self, key), of(other, key));
            (before != now).then(|| format!("{key} was {} and is {}", told(before), told(now)))
        });
        different.take(MOST).collect()
    }
}

/// Part of a study's jobs: number `number`, from 1, of `of`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Number of the shard, from 1.
    pub number: u64,
    /// Number of shards.
    pub of: u64,
}

impl Shard {
    /// All jobs.
    pub const ALL: Self = Self { number: 1, of: 1 };

    /// Its jobs, from 0; groups stay together.
    pub fn jobs(self, layout: &Layout) -> Range<u64> {
        let groups = u128::from(layout.jobs / layout.group);
        let first = |number: u64| (groups * u128::from(number) / u128::from(self.of)) as u64 * layout.group;
        first(self.number - 1)..first(self.number)
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}
