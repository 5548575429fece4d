//! Forward model of a campaign: predictions for the rows of all tests.

use super::layout::Layout;
use crate::process::{Failure, ForwardModel, Rows, RunReport};
use crate::progress::Progress;

/// The forward models of all tests.
pub struct Together {
    /// Of each test.
    pub parts: Vec<Box<dyn ForwardModel>>,
    /// Where the rows of each test stand.
    pub layout: Layout,
}

impl ForwardModel for Together {
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        let all: Result<Vec<Vec<f64>>, Failure> = self.parts.iter().map(|part| part.predict(progress)).collect();
        Ok(all?.concat())
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        let mut values = vec![f64::NAN; rows.len()];
        for (number, part) in self.parts.iter().enumerate() {
            let (numbers, own) = self.layout.own(number, rows);
            if numbers.is_empty() {
                continue;
            }
            numbers.iter().zip(part.observe(&own)?).for_each(|(row, value)| values[*row] = value);
        }
        Ok(values)
    }

    fn doubts(&self, rows: &Rows) -> Result<Vec<String>, Failure> {
        let mut doubts = Vec::new();
        for (number, part) in self.parts.iter().enumerate() {
            doubts.extend(part.doubts(&self.layout.own(number, rows).1)?);
        }
        Ok(doubts)
    }

    fn report(&self, _prediction: Vec<f64>) -> Result<RunReport, Failure> {
        Err(Failure {
            message: "several tests have no report together".into(),
            help: "ask for that of each test by itself".into(),
        })
    }
}
