//! Draws measured and predicted deviations on the contour, magnified.

use crate::output::plots::{Judged, Rows};
use crate::output::thread::{BENT, goes_around};
use crate::process::{self, Coordinate, Curve, Drawing, Holds, Spot};

/// Most frames that can be told apart in one picture.
const MOST_FRAMES: usize = 4;

/// Draws the rows of each frame on the contour, where the process has one: dots for measured values, a line for
/// predicted ones.
pub fn drawing(rows: &Rows, judged: &Judged) -> Option<Drawing> {
    let (model, resolved) = (rows.model, &rows.resolved);
    let (places, nominal) = (model.system.places(&rows.measurements.rows)?, model.system.contour()?);
    let mut frames: Vec<(f64, Vec<usize>)> = Vec::new();
    for (row, frame) in places.frames.iter().enumerate() {
        match frames.iter_mut().find(|f| f.0 == *frame) {
            Some(known) => known.1.push(row),
            None => frames.push((*frame, vec![row])),
        }
    }
    let of =
        if frames.len() > MOST_FRAMES { format!(", {MOST_FRAMES} of {} sets", frames.len()) } else { String::new() };
    let names = names(model.process.coordinates(), resolved, &frames);
    let spot = |row: usize, deviation: f64| {
        let ([x, y, _], [u, v, _]) = (places.points[row], places.directions[row]);
        Spot { at: [x, y], outward: [u, v], deviation: deviation - places.references[row] }
    };
    let mut curves = Vec::new();
    for (family, ((_, own), name)) in frames.iter().zip(&names).take(MOST_FRAMES).enumerate() {
        let mut own = own.clone();
        own.sort_by(|a, b| places.along[*a].total_cmp(&places.along[*b]));
        let measured = own.iter().map(|r| spot(*r, judged.measured[*r])).collect();
        let predicted = own.iter().map(|r| spot(*r, judged.predicted[*r])).collect();
        let curve = |what, is_measured, pieces| Curve { label: format!("{what}{name}"), family, is_measured, pieces };
        curves.push(curve("predicted", false, lines(predicted)));
        curves.push(curve("measured", true, vec![measured]));
    }
    Some(Drawing { name: "compared", title: format!("measured and predicted{of}"), nominal, curves })
}

/// Makes lines through spots that follow each other, broken at corners and closed all around.
fn lines(spots: Vec<Spot>) -> Vec<Vec<Spot>> {
    let near = |a: &Spot, b: &Spot| a.outward[0] * b.outward[0] + a.outward[1] * b.outward[1] > BENT;
    let mut pieces: Vec<Vec<Spot>> = Vec::new();
    for spot in spots {
        match pieces.last_mut() {
            Some(piece) if piece.last().is_some_and(|last| near(last, &spot)) => piece.push(spot),
            _ => pieces.push(vec![spot]),
        }
    }
    if let [one] = pieces.as_mut_slice()
        && goes_around(&one.iter().map(|spot| spot.outward).collect::<Vec<_>>())
    {
        one.push(one[0]);
    }
    pieces
}

/// Names each frame by the coordinates that are the same within every frame and differ between some, as `,
/// cw, 500 mm/min`.
fn names(coordinates: &[Coordinate], rows: &process::Rows, frames: &[(f64, Vec<usize>)]) -> Vec<String> {
    let value = |column: usize, row: &usize| rows.columns[column][*row];
    let tells = |column: &usize| {
        let same = |own: &[usize]| own.iter().all(|r| value(*column, r) == value(*column, &own[0]));
        let first = value(*column, &frames[0].1[0]);
        frames.iter().all(|f| same(&f.1)) && frames.iter().any(|f| value(*column, &f.1[0]) != first)
    };
    let telling: Vec<usize> = (0..coordinates.len()).filter(tells).collect();
    let word = |column: usize, value: f64| match &coordinates[column].holds {
        Holds::Word(words) => words.of_value(value).map_or(String::new(), |w| format!(", {w}")),
        Holds::Number(_) => format!(", {} {value}", coordinates[column].name),
        Holds::Quantity(kind) => format!(", {} {}", super::rounded(kind.from_si(value)), kind.unit),
    };
    frames.iter().map(|f| telling.iter().map(|c| word(*c, value(*c, &f.1[0]))).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_at_corners_and_close_around() {
        let facing = |degrees: f64| {
            let (y, x) = degrees.to_radians().sin_cos();
            Spot { at: [x, y], outward: [x, y], deviation: 0.0 }
        };
        let around = lines((0..36).map(|i| facing(10.0 * f64::from(i))).collect());
        assert_eq!(around.iter().map(Vec::len).collect::<Vec<_>>(), [37]);
        let sides = lines([0.0, 0.0, 90.0, 90.0, 90.0, 180.0].map(facing).to_vec());
        assert_eq!(sides.iter().map(Vec::len).collect::<Vec<_>>(), [2, 3, 1]);
        let part = lines((0..9).map(|i| facing(10.0 * f64::from(i))).collect());
        assert_eq!(part[0].len(), 9);
        let alike = lines(vec![facing(30.0); 12]);
        assert_eq!(alike[0].len(), 12);
    }
}
