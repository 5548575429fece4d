//! What is added to the command of a machine: a corrected contour, part by part.

use super::polyline::on_lines;

/// How a process takes a correction of its command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Commanded {
    /// Key of a change for programs.
    pub key: &'static str,
    /// Name of what is changed, for people: "radius".
    pub words: &'static str,
    /// The coordinate along which the contour runs, by its position.
    pub along: usize,
    /// The coordinate that numbers what has a contour of its own, by its position.
    pub number: usize,
    /// The observable that it changes, by its position.
    pub observable: usize,
    /// By how much a unit of it changes the observable where nothing gives way.
    pub gain: f64,
}

/// Changes of a command at places, for each number, m; between two places on a straight line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Command {
    /// Places along the contour, rising, m.
    pub places: Vec<f64>,
    /// Numbers that have a contour of their own, rising.
    pub numbers: Vec<usize>,
    /// The change at every place, number by number, m.
    pub changes: Vec<f64>,
}

impl Command {
    /// The change at a place (m) of a number, m; beyond the ends that of the end, of numbers that it does not have none.
    pub fn at(&self, place: f64, number: usize) -> f64 {
        let Ok(row) = self.numbers.binary_search(&number) else { return 0.0 };
        let (count, next) = (self.places.len(), self.places.partition_point(|own| *own <= place));
        on_lines(next, count, |i| (self.places[i], self.changes[row * count + i]), place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_straight_between_its_places() {
        let command =
            Command { places: vec![0.0, 1.0, 3.0], numbers: vec![1, 4], changes: vec![0.0, 2.0, 6.0, 1.0, 1.0, 5.0] };
        for (place, number, change) in
            [(0.5, 1, 1.0), (1.0, 1, 2.0), (2.0, 1, 4.0), (-1.0, 4, 1.0), (2.0, 4, 3.0), (9.0, 4, 5.0), (1.0, 2, 0.0)]
        {
            assert_eq!(command.at(place, number), change, "{place} {number}");
        }
    }
}
