//! Several tests as one process and one system.

use std::sync::Arc;

use super::forward::Together;
use super::test::{Campaign, Test};
use crate::gcode::Workpiece;
use crate::input::Reader;
use crate::process::{
    Active, CandidateExperiment, Characteristic, Command, Commanded, Contradiction, Coordinate, DatumDirection,
    Description, ForwardModel, Misplaced, Observable, Places, Positioning, Process, Requirement, Rows, Spot, System,
    UnitRole,
};
use crate::tolerance::Limits;

impl Process for Campaign {
    fn name(&self) -> &'static str {
        "tests of one machine"
    }

    fn about(&self) -> &'static str {
        "several tests of one machine"
    }

    fn observables(&self) -> &[Observable] {
        &self.layout.observables
    }

    fn coordinates(&self) -> &[Coordinate] {
        &self.layout.coordinates
    }

    fn starting_model(&self) -> &'static str {
        ""
    }

    fn effects(&self) -> Vec<Description> {
        self.effects.iter().map(|effect| effect.description.clone()).collect()
    }

    fn in_order(&self) -> Option<&'static str> {
        None
    }

    fn carried_over(&self, _effect: &str) -> Option<&'static str> {
        None
    }

    fn of_unit(&self) -> &'static [(&'static str, UnitRole)] {
        &[]
    }

    fn read(&self, _model: &Reader) -> Option<Box<dyn System>> {
        None
    }
}

/// The systems of all tests.
pub struct Whole(pub Arc<Campaign>);

impl Whole {
    /// Each test with its number, and its rows with their numbers among all.
    fn parts<'s>(&'s self, rows: &'s Rows) -> impl Iterator<Item = (usize, &'s Test, Vec<usize>, Rows)> + 's {
        self.0.tests.iter().enumerate().map(|(number, test)| {
            let (numbers, own) = self.0.layout.own(number, rows);
            (number, test, numbers, own)
        })
    }
}

impl System for Whole {
    fn admits(&self, effect: &str) -> Result<(), String> {
        self.0.effect(effect).map(|_| ()).ok_or_else(|| format!("`{effect}` acts in none of the tests"))
    }

    fn contradiction(&self, _effect: &Active) -> Option<Contradiction> {
        None
    }

    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced> {
        let of = |(number, test, numbers, own): (usize, &Test, Vec<usize>, Rows)| {
            let all = test.model.system.misplaced(&own).into_iter();
            all.map(move |m| Misplaced {
                row: numbers[m.row],
                coordinate: self.0.layout.coordinate(number, m.coordinate),
                ..m
            })
        };
        self.parts(rows).flat_map(of).collect()
    }

    fn programme(&self) -> Rows {
        let own = self.0.tests.iter().enumerate();
        let all = own.map(|(number, test)| self.0.layout.among_all(number, &test.model.system.programme()));
        all.reduce(|all, own| all.and(&own)).unwrap_or_default()
    }

    fn resolved(&self, rows: &Rows) -> Rows {
        let mut all = rows.clone();
        for (number, test, numbers, own) in self.parts(rows) {
            let own = self.0.layout.among_all(number, &test.model.system.resolved(&own));
            for (column, own) in all.columns.iter_mut().zip(&own.columns) {
                numbers.iter().zip(own.iter()).for_each(|(row, value)| column.set(*row, *value));
            }
        }
        all
    }

    fn places(&self, _rows: &Rows) -> Option<Places> {
        None
    }

    fn contour(&self) -> Option<Vec<Vec<Spot>>> {
        None
    }

    fn datum_directions(&self, rows: &Rows) -> Vec<DatumDirection> {
        let of = |(_, test, numbers, own): (usize, &Test, Vec<usize>, Rows)| {
            let all = test.model.system.datum_directions(&own).into_iter();
            all.map(move |d| DatumDirection { rows: d.rows.iter().map(|row| numbers[*row]).collect(), ..d })
        };
        self.parts(rows).flat_map(of).collect()
    }

    fn reach(&self, coordinate: &str) -> Option<(f64, f64)> {
        self.0.tests.iter().find_map(|test| test.model.system.reach(coordinate))
    }

    fn candidate_experiments(&self, rows: &Rows) -> Vec<CandidateExperiment> {
        let mut all = Vec::new();
        for (number, test, _, own) in self.parts(rows) {
            let layout = &self.0.layout;
            all.extend(test.model.system.candidate_experiments(&own).into_iter().map(|experiment| {
                CandidateExperiment {
                    words: format!("{}: {}", test.file(), experiment.words),
                    coordinate: layout.named(number, &experiment.coordinate).unwrap_or(experiment.coordinate),
                    rows: layout.among_all(number, &experiment.rows),
                    ..experiment
                }
            }));
        }
        all
    }

    fn in_sequence(&self, _one: &CandidateExperiment, _other: &CandidateExperiment) -> Option<CandidateExperiment> {
        None
    }

    fn unit(&self) -> Option<&str> {
        None
    }

    fn requirements(&self) -> Vec<Requirement> {
        Vec::new()
    }

    fn limits(&self, rows: &Rows) -> Vec<Option<Limits>> {
        vec![None; rows.len()]
    }

    fn commanded(&self) -> Option<Commanded> {
        None
    }

    fn program(&self) -> Option<Workpiece> {
        None
    }

    fn characteristics(&self, _rows: &Rows, _values: &[f64]) -> Vec<Characteristic> {
        Vec::new()
    }

    fn positioning(&self) -> Option<&dyn Positioning> {
        None
    }

    fn with_effects(&self, effects: &[Active]) -> Box<dyn ForwardModel> {
        let of = |(number, test): (usize, &Test)| test.model.system.with_effects(&self.0.own_effects(number, effects));
        let parts = self.0.tests.iter().enumerate().map(of).collect();
        Box::new(Together { parts, layout: self.0.layout.clone() })
    }

    fn with_command(&self, effects: &[Active], _command: &Arc<Command>) -> Box<dyn ForwardModel> {
        self.with_effects(effects)
    }
}
