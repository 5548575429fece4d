//! One contour for all that is made one after another, and an offset for each: what a program and a wear constant can do.

use std::ops::Range;
use std::sync::Arc;

use super::{Correction, Offset};
use crate::gcode::{Corrected, Course};
use crate::model::Model;
use crate::process::{Command, Failure};

/// One contour, an offset for each number, and what they leave. SI.
#[derive(Clone, Debug, PartialEq)]
pub struct OneContour {
    /// The change at every place of the contours of one number.
    pub contour: Vec<f64>,
    /// The offset beside it for each number.
    pub offsets: Vec<Offset>,
    /// What is left at every row.
    pub left: Vec<f64>,
}

impl OneContour {
    /// The contour that comes nearest to those of all numbers: their mean; `None` where nothing is numbered, or they have other
    /// places.
    ///
    /// # Errors
    /// What is made cannot be computed.
    pub fn common(
        command: &Command,
        made: impl Fn(&Arc<Command>) -> Result<Vec<f64>, Failure>,
    ) -> Result<Option<Self>, Failure> {
        let Some(numbers) = numbers(command).filter(|all| !all.is_empty()) else { return Ok(None) };
        let places = command.places().len() / numbers.len();
        if command.places().chunks(places).any(|own| own != &command.places()[..places]) {
            return Ok(None);
        }
        let mean = |place: usize| {
            let own = command.changes().iter().skip(place).step_by(places);
            own.sum::<f64>() / numbers.len() as f64
        };
        Self::given(command, (0..places).map(mean).collect(), made).map(Some)
    }

    /// A contour with the offsets that come nearest to the command beside it.
    ///
    /// # Errors
    /// What is made cannot be computed.
    pub fn given(
        command: &Command,
        contour: Vec<f64>,
        made: impl Fn(&Arc<Command>) -> Result<Vec<f64>, Failure>,
    ) -> Result<Self, Failure> {
        let offset = |own: &[f64]| {
            let beside = own.iter().zip(&contour).map(|(change, common)| change - common);
            beside.sum::<f64>() / contour.len().max(1) as f64
        };
        let own = command.changes().chunks(contour.len().max(1)).map(offset);
        let numbers = numbers(command).unwrap_or_default();
        let offsets: Vec<Offset> = numbers.into_iter().map(Some).zip(own).collect();
        let changes = offsets.iter().flat_map(|(_, offset)| contour.iter().map(move |change| change + offset));
        let changes = changes.collect();
        let left = made(&Arc::new(command.with(changes)))?;
        Ok(Self { contour, offsets, left })
    }
}

/// The numbers of what has contours of its own, rising; `None` where nothing is numbered.
fn numbers(command: &Command) -> Option<Vec<usize>> {
    let all = command.contours().iter().map(|(apart, _)| Some(*apart.first()? as usize));
    let mut all: Vec<usize> = all.collect::<Option<_>>()?;
    all.dedup();
    Some(all)
}

/// A program of the user's with the words of a correction.
#[derive(Clone, Debug)]
pub struct Programmed {
    /// Name of its file, without its folder.
    pub name: String,
    /// It, and what it does not carry.
    pub corrected: Corrected,
    /// What is left with it and an offset for each number.
    pub with: OneContour,
}

impl Correction {
    /// The contour that is common to all numbers, along each line of the part beside which there are others; none where there is no
    /// such contour.
    pub fn common_courses(&self) -> Vec<Course<'_>> {
        let contour = self.common.as_ref().map_or(&[][..], |common| &common.contour);
        let lines = self.command.contours().iter().take_while(|(_, own)| own.end <= contour.len());
        let course = |(apart, own): &'_ (Vec<f64>, Range<usize>)| Course {
            y: apart.get(1).copied().unwrap_or(0.0),
            places: &self.command.places()[own.clone()],
            changes: &contour[own.clone()],
        };
        lines.map(course).collect()
    }

    /// Whether something else than the number and the line across the part sets contours apart, which no program tells: places
    /// of a fixture, pallets.
    pub fn is_for_several(&self) -> bool {
        let line = |(apart, _): &(Vec<f64>, Range<usize>)| [apart.first().copied(), apart.get(1).copied()];
        self.command.contours().windows(2).any(|pair| line(&pair[0]) == line(&pair[1]))
    }

    /// What is left with a contour that is given, and an offset for each number.
    ///
    /// # Errors
    /// What is made cannot be computed.
    pub fn with_contour(&self, model: &Model, contour: &[f64]) -> Result<OneContour, Failure> {
        let values: Vec<f64> = model.parameters.iter().map(|own| own.quantity.value).collect();
        let made = |command: &Arc<Command>| model.commanded_at(&values, command)?.observe(&self.rows);
        OneContour::given(&self.command, contour.to_vec(), made)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contour_and_offsets_are_the_means_of_both_ways() {
        let contours = [1.0, 2.0].map(|number| (vec![number], vec![0.0, 1.0]));
        let command = Command::new(contours, None).with(vec![1.0, 3.0, 5.0, 9.0]);
        let found = OneContour::common(&command, |command| Ok(command.changes().to_vec())).unwrap().unwrap();
        assert_eq!((found.contour, found.offsets), (vec![3.0, 6.0], vec![(Some(1), -2.5), (Some(2), 2.5)]));
        assert_eq!(found.left, [0.5, 3.5, 5.5, 8.5]);
    }
}
