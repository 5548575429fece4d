//! The one adapter: it makes [`Process`], [`System`] and [`ForwardModel`] of every [`Definition`].

use std::sync::{Arc, OnceLock};

use super::{
    Active, Advice, CandidateExperiment, Characteristic, Command, Commanded, Contradiction, Coordinate, DatumDirection,
    Definition, Description, Failure, FormulaLaw, Forward, ForwardModel, Limit, Making, Misplaced, NoLaw, Observable,
    Odds, Places, Positioning, Process, Requirement, Rows, RunReport, Spot, System, UnitRole, Variant,
};
use crate::gcode::Workpiece;
use crate::input::Reader;
use crate::progress::Progress;
use crate::tolerance::Limits;

/// How many times beyond what is believable of the model's own programme a prediction of measured rows may be: what is
/// measured is there, however coarse.
const MEASURED: f64 = 1000.0;

impl<D: Definition> Process for D {
    fn name(&self) -> &'static str {
        D::NAME
    }

    fn about(&self) -> &'static str {
        D::ABOUT
    }

    fn observables(&self) -> &[Observable] {
        D::OBSERVABLES
    }

    fn coordinates(&self) -> &[Coordinate] {
        D::COORDINATES
    }

    fn starting_model(&self) -> &'static str {
        D::STARTING_MODEL
    }

    fn starting_variant(&self, variant: Variant) -> Option<&'static str> {
        D::STARTING_VARIANTS.iter().find(|(own, _)| *own == variant).map(|(_, text)| *text)
    }

    fn effects(&self) -> Vec<Description> {
        D::EFFECTS.iter().map(|effect| effect.description()).collect()
    }

    fn in_order(&self) -> Option<&'static str> {
        D::IN_ORDER
    }

    fn carried_over(&self, effect: &str) -> Option<&'static str> {
        D::CARRIED_OVER.iter().find(|(name, _)| *name == effect).map(|(_, reason)| *reason)
    }

    fn of_unit(&self) -> &'static [(&'static str, UnitRole)] {
        D::OF_UNIT
    }

    fn read(&self, model: &Reader) -> Option<Box<dyn System>> {
        Some(Box::new(Ready::<D> { setup: Arc::new(D::read(model)?), programme: Arc::default() }))
    }
}

/// A set-up before any effect acts.
struct Ready<D: Definition> {
    setup: Arc<D::Setup>,
    /// Made once for all machines of the set-up, when it is first asked for.
    programme: Arc<OnceLock<Rows>>,
}

impl<D: Definition> System for Ready<D> {
    fn admits(&self, effect: &str) -> Result<(), String> {
        match D::EFFECTS.iter().find(|e| e.description().name == effect) {
            Some(known) => known.admissible(&self.setup).map_err(|reason| format!("`{effect}` {reason}")),
            None => Ok(()),
        }
    }

    fn odds(&self, effect: &str) -> Option<Odds> {
        D::odds(&self.setup, effect)
    }

    fn contradiction(&self, effect: &Active) -> Option<Contradiction> {
        D::contradiction(&self.setup, effect)
    }

    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced> {
        D::misplaced(&self.setup, rows)
    }

    fn limit(&self, observable: usize) -> Option<Limit> {
        Some(D::limit(&self.setup, observable))
    }

    fn programme(&self) -> Rows {
        self.programme.get_or_init(|| D::programme(&self.setup)).clone()
    }

    fn resolved(&self, rows: &Rows) -> Rows {
        D::resolved(&self.setup, rows)
    }

    fn places(&self, rows: &Rows) -> Option<Places> {
        D::places(&self.setup, rows)
    }

    fn contour(&self) -> Option<Vec<Vec<Spot>>> {
        D::contour(&self.setup)
    }

    fn datum_directions(&self, rows: &Rows) -> Vec<DatumDirection> {
        D::datum_directions(&self.setup, rows)
    }

    fn requirements(&self) -> Vec<Requirement> {
        D::requirements(&self.setup)
    }

    fn limits(&self, rows: &Rows) -> Vec<Option<Limits>> {
        D::limits(&self.setup, rows)
    }

    fn commanded(&self) -> Option<Commanded> {
        D::COMMANDED
    }

    fn program(&self) -> Option<Workpiece> {
        D::program(&self.setup)
    }

    fn characteristics(&self, rows: &Rows, values: &[f64]) -> Vec<Characteristic> {
        D::characteristics(&self.setup, rows, values)
    }

    fn making(&self) -> Option<Making> {
        D::making(&self.setup)
    }

    fn no_law(&self, path: &str) -> Option<NoLaw> {
        D::no_law(&self.setup, path)
    }

    fn reach(&self, coordinate: &str) -> Option<(f64, f64)> {
        D::reach(&self.setup, coordinate)
    }

    fn candidate_experiments(&self, rows: &Rows) -> Vec<CandidateExperiment> {
        let mut all = D::candidate_experiments(&self.setup, rows);
        // What hangs on a value that is unknown can be said to nobody.
        all.retain(|experiment| experiment.values.iter().all(|value| value.is_finite()));
        all
    }

    fn in_sequence(&self, one: &CandidateExperiment, other: &CandidateExperiment) -> Option<CandidateExperiment> {
        let mut both = D::in_sequence(&self.setup, one, other)?;
        // A column of a file has a value in every row.
        let all = D::resolved(&self.setup, &both.rows);
        for (column, resolved) in both.rows.columns.iter_mut().zip(all.columns) {
            if column.iter().any(|value| value.is_nan()) && column.iter().any(|value| !value.is_nan()) {
                *column = resolved;
            }
        }
        Some(both)
    }

    fn unit(&self) -> Option<&str> {
        D::unit(&self.setup)
    }

    fn positioning(&self) -> Option<&dyn Positioning> {
        D::positioning(&self.setup)
    }

    fn with_effects(&self, effects: &[Active]) -> Box<dyn ForwardModel> {
        Box::new(Assembled { programme: self.programme.clone(), ..Assembled::<D>::new(self.setup.clone(), effects) })
    }

    fn with_command(&self, effects: &[Active], command: &Arc<Command>) -> Box<dyn ForwardModel> {
        let mut assembled = Assembled::<D>::new(self.setup.clone(), effects);
        assembled.stages.iter_mut().for_each(|stage| D::command(&mut stage.machine, command.clone()));
        Box::new(Assembled { programme: self.programme.clone(), ..assembled })
    }
}

/// A machine with its effects acting.
pub struct Assembled<D: Definition> {
    setup: Arc<D::Setup>,
    programme: Arc<OnceLock<Rows>>,
    /// The machine with the effects as they are at first, and those behind each border at which effects change.
    stages: Vec<Stage<D>>,
    /// Why an effect cannot act; the machine then predicts nothing.
    failure: Option<Failure>,
}

/// A machine as it is between two borders.
struct Stage<D: Definition> {
    /// The number after which it is so.
    after: f64,
    machine: D::Machine,
    /// The effects that are formulas, with the values of their parameters (SI).
    formulas: Vec<(Arc<FormulaLaw>, Vec<f64>)>,
}

impl<D: Definition> Stage<D> {
    /// Lets effects act on a set-up.
    fn new(setup: Arc<D::Setup>, after: f64, effects: &[Active]) -> Result<Self, Failure> {
        let mut stage = Self { after, machine: D::ideal(setup), formulas: Vec::new() };
        for active in effects {
            match &active.formula {
                Some(law) => stage.formulas.push((law.clone(), active.values.clone())),
                None => act::<D>(active, &mut stage.machine)?,
            }
        }
        Ok(stage)
    }
}

/// Lets an effect of the catalogue act on a machine.
fn act<D: Definition>(active: &Active, machine: &mut D::Machine) -> Result<(), Failure> {
    let known = D::EFFECTS.iter().find(|e| e.description().name == active.description.name);
    let effect = known.ok_or_else(|| Failure {
        message: format!("`{}` is no effect of {}", active.description.name, D::NAME),
        help: format!("`fem effects {}` lists them", D::NAME),
    })?;
    effect.act(&active.values, machine)
}

impl<D: Definition> Assembled<D> {
    /// Lets the effects act on a set-up.
    pub fn new(setup: Arc<D::Setup>, effects: &[Active]) -> Self {
        let (changes, mut present): (Vec<Active>, Vec<Active>) =
            effects.iter().cloned().partition(|e| e.description.changes.is_some());
        let mut all = Self { setup, programme: Arc::default(), stages: Vec::new(), failure: None };
        all.add_stage(f64::NEG_INFINITY, &present);
        let mut borders: Vec<f64> = changes.iter().filter_map(Active::border).filter(|b| b.is_finite()).collect();
        borders.sort_unstable_by(f64::total_cmp);
        borders.dedup();
        for border in borders {
            for change in changes.iter().filter(|change| change.border() == Some(border)) {
                present.iter_mut().for_each(|effect| *effect = effect.changed_by(change));
                // What was not there at all comes with its change.
                let is_there = present.iter().any(|e| change.description.is_change_of(&e.description.name));
                let known = D::EFFECTS.iter().map(|e| e.description());
                let absent = known.filter(|d| !is_there && change.description.is_change_of(&d.name));
                present.extend(absent.map(|d| d.neutral().changed_by(change)));
            }
            all.add_stage(border, &present);
        }
        all
    }

    fn add_stage(&mut self, after: f64, effects: &[Active]) {
        match Stage::new(self.setup.clone(), after, effects) {
            Ok(stage) => self.stages.push(stage),
            Err(failure) => {
                self.failure = Some(failure);
                self.stages.push(Stage { after, machine: D::ideal(self.setup.clone()), formulas: Vec::new() });
            }
        }
    }

    /// The set-up, as the tables of the model give it.
    pub fn setup(&self) -> &D::Setup {
        &self.setup
    }

    /// The machine as the effects shape it, before any of them changes.
    pub fn machine(&self) -> &D::Machine {
        &self.stages[0].machine
    }

    fn programme(&self) -> &Rows {
        self.programme.get_or_init(|| D::programme(&self.setup))
    }

    fn possible(&self) -> Result<(), Failure> {
        self.failure.clone().map_or(Ok(()), Err)
    }

    /// What an instrument shows of every row, formula effects and all.
    fn shown(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        let gauged = D::gauged(&self.setup, rows);
        let observed = gauged.as_ref().map_or(rows, |gauged| &gauged.profile);
        let mut values = self.observed(observed)?;
        self.add_formulas(observed, &mut values);
        Ok(match gauged {
            Some(gauged) => gauged.read(&values),
            None => values,
        })
    }

    /// Takes datum directions out, and refuses what is so many times beyond what is believable.
    fn completed(&self, mut values: Vec<f64>, rows: &Rows, times: f64) -> Result<Vec<f64>, Failure> {
        D::datum_directions(&self.setup, rows).iter().for_each(|direction| direction.take_out(&mut values));
        self.believable(&values, rows, times)?;
        Ok(values)
    }

    fn add_formulas(&self, rows: &Rows, values: &mut [f64]) {
        if !self.has_formulas() {
            return;
        }
        let rows = D::resolved(&self.setup, rows);
        for (stage, own) in self.shared_out(&rows) {
            let Some(own) = own else {
                let predicted = values.to_vec();
                stage.formulas.iter().for_each(|(law, p)| law.add_to(values, (&rows, &predicted), p));
                continue;
            };
            let mut some: Vec<f64> = own.iter().map(|row| values[*row]).collect();
            let (its, predicted) = (rows.some(&own), some.clone());
            stage.formulas.iter().for_each(|(law, p)| law.add_to(&mut some, (&its, &predicted), p));
            own.iter().zip(some).for_each(|(row, value)| values[*row] = value);
        }
    }

    fn has_formulas(&self) -> bool {
        self.stages.iter().any(|stage| !stage.formulas.is_empty())
    }

    /// The stages that rows belong to, each with the numbers of its rows; `None` for all of them.
    fn shared_out(&self, rows: &Rows) -> Vec<(&Stage<D>, Option<Vec<usize>>)> {
        let order = D::IN_ORDER.and_then(|name| D::COORDINATES.iter().position(|c| c.name == name));
        let Some(order) = order.filter(|_| self.stages.len() > 1) else { return vec![(&self.stages[0], None)] };
        let stage_of = |row: usize| {
            let number = rows.get(order, row).unwrap_or(f64::NEG_INFINITY);
            self.stages.iter().rposition(|stage| stage.after < number).unwrap_or(0)
        };
        let stages: Vec<usize> = (0..rows.len()).map(stage_of).collect();
        let of = |number: usize| {
            let own: Vec<usize> = (0..rows.len()).filter(|row| stages[*row] == number).collect();
            match own.len() {
                0 => None,
                n if n == rows.len() => Some((&self.stages[number], None)),
                _ => Some((&self.stages[number], Some(own))),
            }
        };
        (0..self.stages.len()).filter_map(of).collect()
    }

    /// What every row shows, by the machine that it belongs to.
    fn observed(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        let mut values = vec![f64::NAN; rows.len()];
        for (stage, own) in self.shared_out(rows) {
            let Some(own) = own else { return D::observe(&stage.machine, rows) };
            let some = D::observe(&stage.machine, &rows.some(&own))?;
            own.iter().zip(some).for_each(|(row, value)| values[*row] = value);
        }
        Ok(values)
    }

    fn believable(&self, values: &[f64], rows: &Rows, times: f64) -> Result<(), Failure> {
        let limits: Vec<_> = (0..D::OBSERVABLES.len()).map(|o| D::limit(&self.setup, o)).collect();
        // A size that is itself unknown limits nothing.
        let wrong = |(value, o): &(&f64, &usize)| !value.is_finite() || value.abs() >= times * limits[**o].size;
        let Some((value, observable)) = values.iter().zip(rows.observable.iter()).find(wrong) else { return Ok(()) };
        if !value.is_finite() && self.has_formulas() {
            return Err(Failure {
                message: "a formula of the model gives no finite number somewhere".into(),
                help: "check it for divisions by zero, roots and logarithms of what is negative".into(),
            });
        }
        let (limit, seen) = (limits[*observable], &D::OBSERVABLES[*observable]);
        let kind = seen.error_kind();
        Err(Failure {
            message: format!("{} is {:.3e} {} somewhere: {}", seen.name, kind.from_si(*value), kind.unit, limit.why),
            help: limit.help.into(),
        })
    }
}

impl<D: Definition> ForwardModel for Assembled<D> {
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        self.possible()?;
        if progress.is_stopped() {
            return Err(Failure { message: "the computation was stopped".into(), help: "start it again".into() });
        }
        let programme = self.programme();
        let values = match &self.stages[..] {
            [only] if D::gauged(&self.setup, programme).is_none() => {
                let mut values = D::predict(&only.machine, programme, progress)?;
                self.add_formulas(programme, &mut values);
                values
            }
            _ => self.shown(programme)?,
        };
        self.completed(values, programme, 1.0)
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        self.possible()?;
        self.completed(self.shown(rows)?, rows, MEASURED)
    }

    fn doubts(&self, rows: &Rows) -> Result<Vec<String>, Failure> {
        self.possible()?;
        let mut doubts = Vec::new();
        for (stage, own) in self.shared_out(rows) {
            let its = own.map(|own| rows.some(&own));
            doubts.extend(D::doubts(&stage.machine, its.as_ref().unwrap_or(rows))?);
        }
        doubts.dedup();
        Ok(doubts)
    }

    fn comes_loose(&self) -> Option<String> {
        self.stages.iter().find_map(|stage| D::comes_loose(&stage.machine))
    }

    fn advice(&self, rows: &Rows, values: &[f64]) -> Result<Vec<Advice>, Failure> {
        self.possible()?;
        D::advice(self.machine(), rows, values)
    }

    fn report(&self, prediction: Vec<f64>) -> Result<RunReport, Failure> {
        self.possible()?;
        let forward = Forward {
            programme: self.programme(),
            prediction: &prediction,
            observe: &|rows| ForwardModel::observe(self, rows),
            add_formulas: &|rows, values| self.add_formulas(rows, values),
            has_formulas: self.has_formulas(),
        };
        let mut report = D::report(self.machine(), &forward)?;
        if let (Some(along), [_, second, ..]) = (D::IN_ORDER, &self.stages[..]) {
            report.warnings.push(format!(
                "an effect changes after {along} {}: what is told of the machine itself, and not of rows, is of the machine \
                 before",
                second.after
            ));
        }
        Ok(report)
    }
}
