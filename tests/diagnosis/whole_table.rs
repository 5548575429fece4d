//! The table of whole machines.

use std::fmt;

use super::whole::Story;

/// Lower ends of the ranges of probability in which what is told is counted.
const RANGES: &[f64] = &[0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];

/// Stories of machines of one process.
pub struct Tally {
    stories: Vec<Story>,
}

impl Tally {
    /// The tally of some stories.
    pub fn of(stories: Vec<Story>) -> Self {
        Self { stories }
    }

    /// Of how many machines a false cause was told with certainty at first, and of how many in all.
    pub fn with_false_causes(&self) -> (usize, usize) {
        (self.count(|story| !story.first.false_causes.is_empty()), self.stories.len())
    }

    /// How many hidden effects stand in a certain cause, a group or a set told at first, and how many are hidden.
    pub fn held(&self) -> (usize, usize) {
        self.stories.iter().fold((0, 0), |(a, b), s| (a + s.first.held.0, b + s.first.held.1))
    }

    fn count(&self, is: impl Fn(&Story) -> bool) -> usize {
        self.stories.iter().filter(|story| is(story)).count()
    }

    /// What was told at first with a probability in each of the ranges: how much of it is there, and all.
    pub fn calibration(&self) -> Vec<(usize, usize)> {
        let mut counts = vec![(0, 0); RANGES.len()];
        for (_, probability, is_there) in self.stories.iter().flat_map(|story| &story.first.told) {
            let range = RANGES.iter().rposition(|from| probability >= from).unwrap_or(0);
            counts[range].0 += usize::from(*is_there);
            counts[range].1 += 1;
        }
        counts
    }
}

/// The head of the table.
pub const HEAD: &str = "| machines | nothing false at first | nothing false at last | held | just what is hidden is certain at first | and at last | each alone at first | \
                        and at last | each tellable alone at first | and at last | measurements made | broke off | told ≥ 90 % and there | median s | worst s |\n\
                        |---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|";

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |(some, all): (usize, usize)| format!("{some} of {all}");
        let machines = self.stories.len();
        let of = |is: fn(&Story) -> bool| part((self.count(is), machines));
        let measured: usize = self.stories.iter().map(|story| story.measured).sum();
        let mut seconds: Vec<f64> = self.stories.iter().map(|story| story.seconds).collect();
        seconds.sort_unstable_by(f64::total_cmp);
        let calibration = self.calibration();
        writeln!(
            f,
            "{HEAD}\n| {machines} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.1} | {} | {} | {:.2} | {:.2} |\n",
            of(|story| story.first.false_causes.is_empty()),
            of(|story| story.last.false_causes.is_empty()),
            part(self.held()),
            of(|story| story.first.is_right),
            of(|story| story.last.is_right),
            of(|story| story.first.is_exact),
            of(|story| story.last.is_exact),
            of(|story| story.first.is_exact_where_tellable),
            of(|story| story.last.is_exact_where_tellable),
            measured as f64 / machines as f64,
            self.count(|story| story.broke_off.is_some()),
            calibration.last().map_or(String::new(), |certain| part(*certain)),
            seconds[machines / 2],
            seconds[machines - 1],
        )?;
        let ranges = RANGES.iter().zip(RANGES.iter().skip(1).chain(&[1.0]));
        let names = ranges.map(|(from, to)| format!("{:.0} to {:.0} %", 100.0 * from, 100.0 * to));
        writeln!(f, "| {} |", names.collect::<Vec<_>>().join(" | "))?;
        writeln!(f, "|{}", "---|".repeat(RANGES.len()))?;
        writeln!(f, "| {} |", calibration.into_iter().map(part).collect::<Vec<_>>().join(" | "))?;
        let reasons: Vec<&str> = self.stories.iter().filter_map(|story| story.broke_off.as_deref()).collect();
        reasons.iter().try_for_each(|reason| writeln!(f, "broke off: {reason}"))
    }
}
