//! What is added to the command of a machine: corrected contours.

use std::cmp::Ordering;
use std::ops::Range;

use super::polyline::on_lines;

/// Key of a change of the radius at which a tool is programmed.
pub const RADIUS_CHANGE: &str = "radius_change";

/// How a process takes a correction of its command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Commanded {
    /// Key of a change for programs.
    pub key: &'static str,
    /// Name of what is changed, for people: "programmed radius".
    pub words: &'static str,
    /// Name of what runs along it, for people: "contour", "table".
    pub course: &'static str,
    /// The coordinate along which a contour runs, by its position.
    pub along: usize,
    /// The coordinate that numbers what is made one after another, by its position, if there is one.
    pub number: Option<usize>,
    /// Further coordinates of which each value has a contour of its own, by their positions.
    pub beside: &'static [usize],
    /// The observable that it changes, by its position.
    pub observable: usize,
    /// By how much a unit of it changes the observable where nothing gives way.
    pub gain: f64,
    /// To what of the command a row answers.
    pub answers: Answers,
    /// Length after which a contour comes back to where it began, if it does.
    pub period: Option<f64>,
    /// What a machine must be able to do that not every one can, as a sentence.
    pub takes: Option<&'static str>,
}

/// To what of a command a row answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answers {
    /// To the change at its own place alone.
    Here,
    /// To that of places before it too, less and less: drives lag behind.
    Along,
}

impl Commanded {
    /// Whether an offset of it is what is entered for a tool between two parts.
    pub fn is_tool_offset(&self) -> bool {
        self.key == RADIUS_CHANGE
    }

    /// The coordinates of which each set of values has a contour of its own.
    pub fn apart(&self) -> impl Iterator<Item = usize> {
        self.number.into_iter().chain(self.beside.iter().copied())
    }
}

/// Changes of a command along contours; between two places on a straight line. SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Command {
    /// Contours, rising by the values of the coordinates that set them apart, with their stretch of `places`.
    contours: Vec<(Vec<f64>, Range<usize>)>,
    /// Places of every contour, rising, one contour after the other.
    places: Vec<f64>,
    /// The change at every place.
    changes: Vec<f64>,
    /// Length after which a contour comes back to where it began, if it does.
    period: Option<f64>,
}

impl Command {
    /// A command that changes nothing, of contours by the values that set them apart (rising) and their places (rising).
    pub fn new(contours: impl IntoIterator<Item = (Vec<f64>, Vec<f64>)>, period: Option<f64>) -> Self {
        let mut command = Self { period, ..Self::default() };
        for (apart, places) in contours {
            let begin = command.places.len();
            command.places.extend(places);
            command.contours.push((apart, begin..command.places.len()));
        }
        command.changes = vec![0.0; command.places.len()];
        command
    }

    /// The same contours with other changes, one for each place.
    #[must_use]
    pub fn with(&self, changes: Vec<f64>) -> Self {
        Self { changes, ..self.clone() }
    }

    /// The contours: what sets each apart, and its stretch of the places.
    pub fn contours(&self) -> &[(Vec<f64>, Range<usize>)] {
        &self.contours
    }

    /// The change at every place, contour by contour.
    pub fn changes(&self) -> &[f64] {
        &self.changes
    }

    /// Places of every contour, one contour after the other.
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// The change at a place of the contour that these values set apart; beyond its ends that of the end, or straight on to where
    /// it begins anew; of contours that there are not none.
    pub fn at(&self, place: f64, apart: &[f64]) -> f64 {
        let Ok(found) = self.contours.binary_search_by(|(own, _)| order(own, apart)) else { return 0.0 };
        let own = self.contours[found].1.clone();
        let (places, changes) = (&self.places[own.clone()], &self.changes[own]);
        let next = places.partition_point(|own| *own <= place);
        let last = places.len().wrapping_sub(1);
        match self.period {
            Some(period) if places.len() > 1 && (next == 0 || next > last) => {
                let place = if next == 0 { place + period } else { place };
                let ends = [(places[last], changes[last]), (places[0] + period, changes[0])];
                on_lines(1, 2, |i| ends[i], place)
            }
            _ => on_lines(next, places.len(), |i| (places[i], changes[i]), place),
        }
    }
}

/// The order of what sets contours apart.
pub fn order(one: &[f64], other: &[f64]) -> Ordering {
    one.iter().zip(other).fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_straight_between_its_places() {
        let places = vec![0.0, 1.0, 3.0];
        let command = Command::new(
            [(vec![1.0, 0.0], places.clone()), (vec![1.0, 1.0], places), (vec![4.0, 0.0], vec![2.0])],
            None,
        );
        let command = command.with(vec![0.0, 2.0, 6.0, 1.0, 1.0, 5.0, 7.0]);
        for (place, apart, change) in [
            (0.5, [1.0, 0.0], 1.0),
            (1.0, [1.0, 0.0], 2.0),
            (2.0, [1.0, 0.0], 4.0),
            (-1.0, [1.0, 1.0], 1.0),
            (2.0, [1.0, 1.0], 3.0),
            (9.0, [1.0, 1.0], 5.0),
            (9.0, [4.0, 0.0], 7.0),
            (1.0, [2.0, 0.0], 0.0),
        ] {
            assert_eq!(command.at(place, &apart), change, "{place} {apart:?}");
        }
    }
    #[test]
    fn around_a_period_it_goes_on_to_where_it_begins() {
        let command = Command::new([(vec![], vec![1.0, 2.0, 3.0])], Some(4.0)).with(vec![5.0, 0.0, 7.0]);
        for (place, change) in [(1.5, 2.5), (3.5, 6.5), (4.0, 6.0), (0.5, 5.5), (0.0, 6.0), (1.0, 5.0), (3.0, 7.0)] {
            assert_eq!(command.at(place, &[]), change, "{place}");
        }
    }
}
