//! The one adapter: it makes [`Process`], [`System`] and [`ForwardModel`] of every [`Definition`].

use std::sync::{Arc, OnceLock};

use super::{
    Active, CandidateExperiment, Contradiction, Coordinate, DatumDirection, Definition, Description, Failure,
    FormulaLaw, Forward, ForwardModel, Misplaced, Observable, Places, Positioning, Process, Rows, RunReport, Spot,
    System, UnitRole,
};
use crate::input::Reader;
use crate::progress::Progress;

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

    fn effects(&self) -> Vec<Description> {
        D::EFFECTS.iter().map(|effect| effect.description()).collect()
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

    fn contradiction(&self, effect: &Active) -> Option<Contradiction> {
        D::contradiction(&self.setup, effect)
    }

    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced> {
        D::misplaced(&self.setup, rows)
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
}

/// A machine with its effects acting.
pub struct Assembled<D: Definition> {
    setup: Arc<D::Setup>,
    programme: Arc<OnceLock<Rows>>,
    machine: D::Machine,
    /// The effects that are formulas, with the values of their parameters (SI).
    formulas: Vec<(Arc<FormulaLaw>, Vec<f64>)>,
    /// Why an effect cannot act; the machine then predicts nothing.
    failure: Option<Failure>,
}

impl<D: Definition> Assembled<D> {
    /// Lets the effects act on a set-up.
    pub fn new(setup: Arc<D::Setup>, effects: &[Active]) -> Self {
        let (machine, programme) = (D::ideal(setup.clone()), Arc::default());
        let mut all = Self { setup, programme, machine, formulas: Vec::new(), failure: None };
        for active in effects {
            if let Some(law) = &active.formula {
                all.formulas.push((law.clone(), active.values.clone()));
            } else if let Err(failure) = all.act(active) {
                all.failure = Some(failure);
            }
        }
        all
    }

    fn act(&mut self, active: &Active) -> Result<(), Failure> {
        let known = D::EFFECTS.iter().find(|e| e.description().name == active.description.name);
        let effect = known.ok_or_else(|| Failure {
            message: format!("`{}` is no effect of {}", active.description.name, D::NAME),
            help: format!("`fem effects {}` lists them", D::NAME),
        })?;
        effect.act(&active.values, &mut self.machine)
    }

    /// The set-up, as the tables of the model give it.
    pub fn setup(&self) -> &D::Setup {
        &self.setup
    }

    /// The machine as the effects shape it.
    pub fn machine(&self) -> &D::Machine {
        &self.machine
    }

    fn programme(&self) -> &Rows {
        self.programme.get_or_init(|| D::programme(&self.setup))
    }

    fn possible(&self) -> Result<(), Failure> {
        self.failure.clone().map_or(Ok(()), Err)
    }

    /// Adds formula effects, takes datum directions out, and refuses what is not believable.
    fn completed(&self, mut values: Vec<f64>, rows: &Rows) -> Result<Vec<f64>, Failure> {
        self.add_formulas(rows, &mut values);
        D::datum_directions(&self.setup, rows).iter().for_each(|direction| direction.take_out(&mut values));
        self.believable(&values, rows)?;
        Ok(values)
    }

    fn add_formulas(&self, rows: &Rows, values: &mut [f64]) {
        if self.formulas.is_empty() {
            return;
        }
        let rows = D::resolved(&self.setup, rows);
        for (law, parameters) in &self.formulas {
            law.add_to(values, &rows, parameters);
        }
    }

    fn believable(&self, values: &[f64], rows: &Rows) -> Result<(), Failure> {
        let limits: Vec<_> = (0..D::OBSERVABLES.len()).map(|o| D::limit(&self.setup, o)).collect();
        // A size that is itself unknown limits nothing.
        let wrong = |(value, o): &(&f64, &usize)| !value.is_finite() || value.abs() >= limits[**o].size;
        let Some((value, observable)) = values.iter().zip(rows.observable.iter()).find(wrong) else { return Ok(()) };
        if !value.is_finite() && !self.formulas.is_empty() {
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
        self.completed(D::predict(&self.machine, programme, progress)?, programme)
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        self.possible()?;
        self.completed(D::observe(&self.machine, rows)?, rows)
    }

    fn doubts(&self, rows: &Rows) -> Result<Vec<String>, Failure> {
        self.possible()?;
        D::doubts(&self.machine, rows)
    }

    fn report(&self, prediction: Vec<f64>) -> Result<RunReport, Failure> {
        self.possible()?;
        let forward = Forward {
            programme: self.programme(),
            prediction: &prediction,
            observe: &|rows| ForwardModel::observe(self, rows),
            add_formulas: &|rows, values| self.add_formulas(rows, values),
            has_formulas: !self.formulas.is_empty(),
        };
        D::report(&self.machine, &forward)
    }
}
