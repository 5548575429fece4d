//! A model, and what is asked of it alone.

use std::path::PathBuf;
use std::sync::Arc;

use fem::ask::{self, compensate, completed, fit, plan, steps};
use fem::diagnose::diagnose;
use fem::fit::fitted_text;
use fem::input::{Parameter, Source};
use fem::model::{self, Data, Setting, add_effect};
use fem::output::Report;
use fem::progress::Progress;
use fem::units::Knowledge;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::answer::{Answer, tables_of_rows, tables_of_run};
use crate::compute::compute;
use crate::error::Error;
use crate::question::{Asked, within};

/// A model that was read without a problem. It does not change.
#[pyclass(frozen, module = "fem._fem")]
pub struct Model(pub Arc<model::Model>);

#[pymethods]
impl Model {
    /// Reads a model file.
    #[staticmethod]
    fn load(py: Python, path: PathBuf) -> PyResult<Self> {
        compute(py, &Arc::default(), move |_| Ok(Self(Arc::new(model::Model::load(&path)?))))
    }

    /// Reads a model from its text; the paths that it names are relative to the folder of `name`.
    #[staticmethod]
    fn parse(py: Python, name: String, text: String) -> PyResult<Self> {
        compute(py, &Arc::default(), move |_| Ok(Self(Arc::new(model::Model::parse(Source::new(name, text))?))))
    }

    /// The name of its file.
    #[getter]
    fn name(&self) -> &str {
        &self.0.source.name
    }

    /// Its text.
    #[getter]
    fn text(&self) -> &str {
        &self.0.source.text
    }

    /// Its title, if it has one.
    #[getter]
    fn title(&self) -> Option<&str> {
        self.0.title.as_deref()
    }

    /// The process that it models.
    #[getter]
    fn process(&self) -> &str {
        self.0.process.name()
    }

    /// The names of its effects.
    #[getter]
    fn effects(&self) -> Vec<&str> {
        self.0.effects.iter().map(|e| e.description.name).collect()
    }

    /// What it does not know exactly: path, unit, value and standard uncertainty; an unknown one has neither.
    #[getter]
    fn parameters(&self) -> Vec<(&str, &str, Option<f64>, Option<f64>)> {
        let told = |p: &'_ Parameter| match p.quantity.knowledge {
            Knowledge::Known => (Some(p.kind.from_si(p.quantity.value)), None),
            // A difference has no zero point.
            Knowledge::Rough(std) => (Some(p.kind.from_si(p.quantity.value)), Some(std / p.kind.canonical().factor)),
            Knowledge::Free => (None, None),
        };
        let all = self.0.parameters.iter().map(|p| (p, told(p)));
        all.map(|(p, (value, std))| (&*p.path, p.kind.unit, value, std)).collect()
    }

    /// Its text for a file at another place.
    fn text_at(&self, path: PathBuf) -> String {
        self.0.text_at(&path)
    }

    /// The model with one more effect.
    fn add(&self, py: Python, effect: String, settings: Vec<(String, String)>) -> PyResult<Self> {
        let model = self.0.clone();
        compute(py, &Arc::default(), move |_| {
            let settings: Vec<Setting> = settings.into_iter().map(|(key, value)| Setting { key, value }).collect();
            Ok(Self(Arc::new(add_effect(&model, &effect, &settings)?)))
        })
    }

    /// Predicts.
    fn run<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let model = self.0.clone();
        let answer = compute(py, &Arc::default(), move |progress| {
            model.require_part()?;
            let mut run = model.run(progress)?;
            let answer = Answer::of(&Report::Run(&model, &run), &model)?;
            let notes = run.report.warnings.clone();
            Ok(Answer { tables: vec![tables_of_run(&model, &mut run)], notes, ..answer })
        })?;
        answer.told(py)
    }

    /// Estimates what it leaves open.
    fn fit<'py>(&self, py: Python<'py>, data: Asked, seconds: Option<f64>) -> PyResult<Bound<'py, PyDict>> {
        let answer = self.of_data(py, within(seconds), data, |data, _| {
            let found = fit(data)?;
            let residuals = data.residuals(&found.predicted);
            let tables = vec![tables_of_rows(data, &found.predicted, &residuals, &found.noise.sigma)];
            let model = Some(fitted_text(data, &found));
            let answer = Answer::of(&Report::Fit(data, &found), data.model)?;
            Ok(Answer { tables, notes: data.notes_of_fit(), model, ..answer })
        })?;
        answer.told(py)
    }

    /// Names the effect that is missing.
    fn diagnose<'py>(
        &self,
        py: Python<'py>,
        data: Asked,
        most_effects: usize,
        seconds: Option<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let answer = self.of_data(py, within(seconds), data, move |data, progress| {
            let found = diagnose(data, most_effects, progress)?;
            let notes = ask::notes(data, &found);
            // A fitted value that no model may hold leaves none.
            let model = completed(data, &found).ok().map(|better| better.source.text.to_string());
            let steps = steps(data, &found).into_iter().map(|(effect, model)| (effect, model.source.text.to_string()));
            let steps = steps.collect();
            Ok(Answer { notes, model, steps, ..Answer::of(&Report::Diagnosis(data, &found), data.model)? })
        })?;
        answer.told(py)
    }

    /// What could be seen by measuring, and what would look alike.
    fn plan<'py>(
        &self,
        py: Python<'py>,
        design: Option<Asked>,
        noise: Vec<String>,
        seconds: Option<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let model = self.0.clone();
        let answer = compute(py, &within(seconds), move |progress| {
            let design = match design {
                Some(asked) => {
                    Data::of(&model, asked.read(model.process, true)?).map_err(|e| ask::Error::of_data(e, &model))?
                }
                None => Data::programme(&model)?,
            };
            let design = design.watched(progress.clone());
            let (found, note) = plan(&design, &noise)?;
            Ok(Answer { notes: note.into_iter().collect(), ..Answer::of(&Report::Plan(&design, &found), &model)? })
        })?;
        answer.told(py)
    }

    /// Evaluates the test of an axis, and compensates it.
    fn compensate<'py>(&self, py: Python<'py>, data: Asked) -> PyResult<Bound<'py, PyDict>> {
        let answer = self.of_data(py, Arc::default(), data, |data, _| {
            let found = compensate(data)?;
            let notes = data.notes.clone();
            Ok(Answer { notes, ..Answer::of(&Report::Compensation(data, &found, &[]), data.model)? })
        })?;
        answer.told(py)
    }
}

impl Model {
    /// Computes with measurements.
    fn of_data(
        &self,
        py: Python,
        progress: Arc<Progress>,
        asked: Asked,
        work: impl FnOnce(&Data, &Progress) -> Result<Answer, Error> + Send + 'static,
    ) -> PyResult<Answer> {
        let model = self.0.clone();
        compute(py, &progress, move |progress| {
            let measurements = asked.read(model.process, false)?;
            let data = Data::of(&model, measurements).map_err(|e| ask::Error::of_data(e, &model))?;
            work(&data.watched(progress.clone()), progress)
        })
    }
}
