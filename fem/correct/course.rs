//! The rows of a correction: every place of every contour, as the model's own programme has them.

use std::collections::HashSet;
use std::sync::Arc;

use crate::model::Model;
use crate::process::{Absent, Command, Commanded, Rows, Values, on_lines, order};

/// Contours of a programme: what sets each apart, and its rows, rising along it.
pub struct Programme {
    rows: Rows,
    contours: Vec<(Vec<f64>, Vec<usize>)>,
}

impl Programme {
    /// That of a model.
    pub fn of(model: &Model, commanded: &Commanded) -> Self {
        let rows = model.system.programme();
        let along = &rows.columns[commanded.along];
        let is_own = |row: &usize| rows.observable[*row] == commanded.observable && along[*row].is_finite();
        let apart = |row: usize| commanded.apart().map(|column| rows.columns[column][row]).collect::<Vec<f64>>();
        let mut all: Vec<(Vec<f64>, usize)> = (0..rows.len()).filter(is_own).map(|row| (apart(row), row)).collect();
        all.sort_by(|(a, one), (b, other)| order(a, b).then(along[*one].total_cmp(&along[*other])));
        let contour = |own: &[(Vec<f64>, usize)]| {
            let mut rows: Vec<usize> = own.iter().map(|(_, row)| *row).collect();
            rows.dedup_by(|a, b| along[*a] == along[*b]);
            (own[0].0.clone(), rows)
        };
        let contours = all.chunk_by(|(a, _), (b, _)| order(a, b).is_eq()).map(contour).collect();
        Self { contours, rows }
    }

    /// A command that changes nothing, at the programme's own places of every contour, or at `least` evenly spaced ones where
    /// it has fewer; beside its own ones where the part has valleys between, in which no pass makes anything.
    pub fn command(&self, model: &Model, commanded: &Commanded, least: usize) -> Command {
        let own_places = |(_, own): &(Vec<f64>, Vec<usize>)| -> Vec<f64> {
            own.iter().map(|row| self.rows.columns[commanded.along][*row]).collect()
        };
        let own: Vec<Vec<f64>> = self.contours.iter().map(own_places).collect();
        let evenly = |own: &Vec<f64>| match own[..] {
            [low, .., high] if own.len() < least => {
                (0..least).map(|i| low + (high - low) * i as f64 / (least - 1) as f64).collect()
            }
            _ => own.clone(),
        };
        let asked: Vec<Vec<f64>> = own.iter().map(evenly).collect();
        let reached = self.reached(model, commanded, &asked);
        let places = own.into_iter().zip(asked).zip(reached).map(|((own, asked), reached)| {
            if reached.len() == asked.len() {
                return asked;
            }
            let mut all = [own, reached].concat();
            all.sort_by(f64::total_cmp);
            all.dedup();
            all
        });
        let contours = self.contours.iter().map(|(apart, _)| apart.clone()).zip(places);
        Command::new(contours, commanded.period)
    }

    /// Those of places of every contour at which something is made.
    pub fn reached(&self, model: &Model, commanded: &Commanded, places: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let wrong = model.system.misplaced(&self.rows(model, commanded, places));
        let beside: HashSet<usize> =
            wrong.into_iter().filter(|own| own.coordinate == commanded.along).map(|own| own.row).collect();
        let mut rows = 0..;
        let mut is_made = |_: &&f64| rows.next().is_some_and(|row| !beside.contains(&row));
        places.iter().map(|own| own.iter().filter(&mut is_made).copied().collect()).collect()
    }

    /// The rows at places of the contours, given contour by contour; what the model cannot fill in is as in the programme,
    /// between two of its rows on a straight line. What it can is left to it: a blank that were named would be what the last pass
    /// meets, whatever earlier ones leave.
    pub fn rows(&self, model: &Model, commanded: &Commanded, places: &[Vec<f64>]) -> Rows {
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); self.rows.columns.len()];
        let coordinates = model.process.coordinates();
        for ((apart, own), places) in self.contours.iter().zip(places) {
            let along: Vec<f64> = own.iter().map(|row| self.rows.columns[commanded.along][*row]).collect();
            for (column, values) in columns.iter_mut().enumerate() {
                if column == commanded.along {
                    values.extend(places);
                } else if let Some(i) = commanded.apart().position(|own| own == column) {
                    values.extend(places.iter().map(|_| apart[i]));
                } else if matches!(coordinates.get(column).map(|own| own.absent), Some(Absent::Value(_))) {
                    let of = &self.rows.columns[column];
                    values.extend(places.iter().map(|place| {
                        let next = along.partition_point(|own| own <= place);
                        on_lines(next, own.len(), |i| (along[i], of[own[i]]), *place)
                    }));
                } else {
                    values.extend(places.iter().map(|_| f64::NAN));
                }
            }
        }
        let count = places.iter().map(Vec::len).sum();
        let columns = columns.into_iter().map(Values::from).collect();
        Rows { columns, observable: Values::shared(commanded.observable, count) }
    }
}

/// Places of every contour of a command.
pub fn places(command: &Command) -> Vec<Vec<f64>> {
    command.contours().iter().map(|(_, own)| command.places()[own.clone()].to_vec()).collect()
}

/// The middles between them.
pub fn middles(command: &Command) -> Vec<Vec<f64>> {
    let middles = |own: Vec<f64>| own.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    places(command).into_iter().map(middles).collect()
}

/// An offset: the number of which it is, if anything is numbered, and the change.
pub type Offset = (Option<usize>, f64);

/// The mean change of each number: what an offset alone can do; one for all where nothing is numbered.
pub fn offsets(command: &Command, commanded: &Commanded) -> Vec<Offset> {
    let mut all: Vec<(Option<usize>, f64, usize)> = Vec::new();
    for (apart, own) in command.contours() {
        let number = commanded.number.map(|_| apart[0] as usize);
        let sum: f64 = command.changes()[own.clone()].iter().sum();
        match all.last_mut() {
            Some((last, total, count)) if *last == number => (*total, *count) = (*total + sum, *count + own.len()),
            _ => all.push((number, sum, own.len())),
        }
    }
    all.into_iter().map(|(number, sum, count)| (number, sum / count.max(1) as f64)).collect()
}

/// The command of these offsets alone.
pub fn of_offsets(command: &Command, commanded: &Commanded, offsets: &[Offset]) -> Arc<Command> {
    let of = |apart: &[f64]| {
        let number = commanded.number.map(|_| apart[0] as usize);
        offsets.iter().find(|(own, _)| *own == number).map_or(0.0, |(_, change)| *change)
    };
    let changes = command.contours().iter().flat_map(|(apart, own)| std::iter::repeat_n(of(apart), own.len()));
    Arc::new(command.with(changes.collect()))
}
