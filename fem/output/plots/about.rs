//! What stands about the curves of a prediction: how far it may be off, and what a drawing allows.

use super::layout::Layout;
use crate::output::chart::{Form, Point, Series};

/// What stands about the curves of a prediction, of rows by their places in a layout, in the unit of the ordinate.
pub struct About<'a> {
    /// The interval that holds the true value with 95 %, where it is not exactly known.
    pub interval: &'a dyn Fn(usize) -> Option<[f64; 2]>,
    /// The limits that a drawing sets.
    pub limits: &'a dyn Fn(usize) -> Option<[f64; 2]>,
}

/// Colour of what a drawing allows, and how many times as far as the curves reach its limits may lie.
const LIMITS: usize = 5;
const FAR: f64 = 3.0;

impl About<'_> {
    /// The band of each curve that has a colour.
    pub fn bands(&self, layout: &Layout) -> Vec<Series> {
        if layout.is_loop() || (self.interval)(0).is_none() {
            return Vec::new();
        }
        let ends = |row: usize| (self.interval)(row).unwrap_or([f64::NAN; 2]);
        let middle = |row: usize| 0.5 * (ends(row)[0] + ends(row)[1]);
        let half = |row: usize| 0.5 * (ends(row)[1] - ends(row)[0]);
        let one =
            |(colour, group): (usize, usize)| Series::new("", colour, Form::Band, layout.points(group, &middle, &half));
        layout.chosen().into_iter().enumerate().map(one).collect()
    }

    /// Both limits of the first curve, and what is to be said of them; none where they are so far off that the curves would
    /// be flat.
    pub fn limits(&self, layout: &Layout, lines: &[Series]) -> (Vec<Series>, Option<String>) {
        let none = |_| f64::NAN;
        let end = |end: usize| layout.points(0, &|row| (self.limits)(row).map_or(f64::NAN, |own| own[end]), &none);
        let is_there = |points: &[Point]| points.iter().any(|p| p.y.is_finite());
        let ends = [end(0), end(1)].map(Some).map(|own| own.filter(|own| is_there(own) && !layout.is_loop()));
        let reach = |points: &mut dyn Iterator<Item = &Point>| {
            points.filter(|p| p.y.is_finite()).map(|p| p.y.abs()).fold(0.0f64, f64::max)
        };
        let of_lines = reach(&mut lines.iter().flat_map(|own| &own.points));
        let all: Vec<(usize, Vec<Point>)> =
            ends.into_iter().enumerate().filter_map(|(i, own)| Some((i, own?))).collect();
        match all.is_empty() {
            true => (Vec::new(), None),
            false if reach(&mut all.iter().flat_map(|(_, own)| own)) > FAR * of_lines => {
                (Vec::new(), Some("the limits of the drawing lie farther out".into()))
            }
            false => {
                let one = |(i, own)| Series::new(["lower limit", "upper limit"][i], LIMITS, Form::Dashed, own);
                (all.into_iter().map(one).collect(), None)
            }
        }
    }
}
