//! Parameters in which the law is a step: the number of the part after which something happened.
//!
//! The prediction of measured rows has no slope in them, and changes only where a measured part changes sides. So
//! they stand at measured parts alone. A search for a minimum leaves them where they are, for their column of the
//! Jacobian is zero; then `settle` goes to the neighbouring places as long as χ² falls.

/// Most places from which a search begins; between them it goes on by halves.
pub const MOST_STARTS: usize = 64;

/// The places at which such a parameter may stand.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    /// Numbers of the measured parts, rising, two at least: something that happened after the last of them is not seen.
    measured: Vec<f64>,
}

impl Steps {
    /// Those of rows with these numbers, in any order; `None` where all are the same.
    pub fn new(numbers: impl Iterator<Item = f64>) -> Option<Self> {
        let mut measured: Vec<f64> = numbers.filter(|number| number.is_finite()).collect();
        measured.sort_unstable_by(f64::total_cmp);
        measured.dedup();
        (measured.len() > 1).then_some(Self { measured })
    }

    /// Number of places.
    pub fn count(&self) -> usize {
        self.measured.len() - 1
    }

    /// Bounds within which every place lies.
    pub fn bounds(&self) -> (f64, f64) {
        const BESIDE: f64 = 0.4;
        (self.measured[0] - BESIDE, self.measured[self.count() - 1] + BESIDE)
    }

    /// The place that stands for a number: no measured part lies between the two.
    pub fn at(&self, number: f64) -> f64 {
        self.measured[self.index(number)]
    }

    fn index(&self, number: f64) -> usize {
        let below = self.measured.partition_point(|m| *m <= number.round());
        below.saturating_sub(1).min(self.count() - 1)
    }

    /// Some of the places, evenly spread.
    pub fn spread(&self, count: usize) -> Vec<f64> {
        let count = count.min(self.count());
        (0..count).map(|i| self.measured[(2 * i + 1) * self.count() / (2 * count)]).collect()
    }

    /// The place so many places on, if there is one.
    pub fn beside(&self, number: f64, by: isize) -> Option<f64> {
        let index = self.index(number).checked_add_signed(by)?;
        (index < self.count()).then(|| self.measured[index])
    }

    /// The largest number that a place stands for.
    pub fn last_of(&self, place: f64) -> f64 {
        let next = self.measured[self.index(place) + 1];
        (next - 1.0).max(place)
    }

    /// The widest moves that are tried: between places from which a search began.
    pub fn stride(&self) -> usize {
        (self.count() / MOST_STARTS).max(1).next_power_of_two()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_stands_for_the_numbers_up_to_the_next_measured_part() {
        let steps = Steps::new([8.0, 1.0, 4.0, 4.0, f64::NAN].into_iter()).unwrap();
        assert_eq!([0.0, 1.0, 3.4, 3.6, 7.0, 8.0, 20.0].map(|n| steps.at(n)), [1.0, 1.0, 1.0, 4.0, 4.0, 4.0, 4.0]);
        assert_eq!((steps.last_of(1.0), steps.last_of(4.0)), (3.0, 7.0));
        assert_eq!((steps.beside(1.0, 1), steps.beside(1.0, -1), steps.beside(4.0, 1)), (Some(4.0), None, None));
        assert_eq!(Steps::new([2.0, 2.0].into_iter()), None);
    }

    #[test]
    fn starts_are_spread_over_all_places() {
        let steps = Steps::new((1..=1001).map(f64::from)).unwrap();
        let starts = steps.spread(MOST_STARTS);
        assert_eq!(starts.len(), MOST_STARTS);
        let widest = starts.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        // Halves of the widest move lead to every place between two starts.
        assert!(widest <= 2.0 * steps.stride() as f64, "{widest}");
        assert_eq!(Steps::new((1..=5).map(f64::from)).unwrap().spread(9), [1.0, 2.0, 3.0, 4.0]);
    }
}
