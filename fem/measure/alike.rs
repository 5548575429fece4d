//! Problems of many rows that have one cause: told once, with the number of rows.

use std::ops::Range;

use crate::input::Problem;

/// Number of different problems that are told.
pub const MOST_PROBLEMS: usize = 20;

/// Most cells of a column that are told one by one.
const MOST_CELLS: usize = 3;

/// Problems by their causes.
#[derive(Debug, Default)]
pub struct Alike {
    causes: Vec<Cause>,
}

/// What is wrong in the same way in several rows.
#[derive(Debug)]
struct Cause {
    /// The message without the cell that it is about.
    about: String,
    /// The first problems, each with the number of rows that say the same.
    first: Vec<(Problem, usize)>,
    /// Rows with other cells than these.
    more: usize,
}

impl Alike {
    /// Adds the problem of a row that stands at a place of the text.
    pub fn push(&mut self, problem: Problem, place: Option<Range<usize>>) {
        let about = without_cell(&problem.message);
        let Some(cause) = self.causes.iter_mut().find(|own| own.about == about) else {
            if self.causes.len() < MOST_PROBLEMS {
                let place = place.or(problem.span.clone());
                self.causes.push(Cause { about, first: vec![(problem.at(place), 1)], more: 0 });
            }
            return;
        };
        match cause.first.iter().position(|(own, _)| own.message == problem.message) {
            Some(same) => cause.first[same].1 += 1,
            None if cause.first.len() < MOST_CELLS => {
                let place = place.or(problem.span.clone());
                cause.first.push((problem.at(place), 1));
            }
            None => cause.more += 1,
        }
    }

    /// The problems, in the order in which their causes came.
    pub fn problems(self) -> Vec<Problem> {
        self.causes.into_iter().flat_map(Cause::problems).collect()
    }
}

impl Cause {
    fn problems(mut self) -> Vec<Problem> {
        let told = |problem: Problem, more: usize| {
            let rows = if more == 1 { "row" } else { "rows" };
            let message = format!("{}, and so in {more} more {rows}", problem.message);
            if more == 0 { problem } else { Problem { message, ..problem } }
        };
        if self.more == 0 {
            return self.first.into_iter().map(|(problem, count)| told(problem, count - 1)).collect();
        }
        let rows: usize = self.first.iter().map(|(_, count)| count).sum();
        let (problem, _) = self.first.swap_remove(0);
        vec![told(problem, rows - 1 + self.more)]
    }
}

/// A message without the first thing that it quotes.
fn without_cell(message: &str) -> String {
    let mut parts = message.splitn(3, '`');
    match (parts.next(), parts.next(), parts.next()) {
        (Some(before), Some(_), Some(behind)) => format!("{before}{behind}"),
        _ => message.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(messages: &[&str]) -> Vec<String> {
        let mut all = Alike::default();
        messages.iter().enumerate().for_each(|(i, own)| all.push(Problem::new(*own), Some(i..i + 1)));
        all.problems().into_iter().map(|problem| problem.message).collect()
    }

    #[test]
    fn what_says_the_same_is_told_once() {
        assert_eq!(told(&["`a` is none", "`a` is none"]), ["`a` is none, and so in 1 more row"]);
        assert_eq!(told(&["`a` is none", "`b` is none"]), ["`a` is none", "`b` is none"]);
        let many = ["`a` in `x` is none", "`b` in `x` is none", "3 cells", "`c` in `x` is none", "`d` in `x` is none"];
        assert_eq!(told(&many), ["`a` in `x` is none, and so in 3 more rows", "3 cells"]);
    }
}
