//! Models, and what is asked of them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fem::ask::{self, Depth, Page, compare_all, compensate, completed, fit, fitted, plan, refuse_mixed, steps};
use fem::discover::{diagnose, discover, read_candidates};
use fem::input::{Parameter, Source};
use fem::measure::Measurements;
use fem::model::{self, Data, Entry, Setting, add_effect};
use fem::output;
use fem::output::files::Guard;
use fem::output::{
    ActionAnswer, ComparisonAnswer, CompensationAnswer, DiagnosisAnswer, FitAnswer, Folder, LawsAnswer, PlanAnswer,
    RemedyAnswer, RunAnswer, tables_of_band, text,
};
use fem::progress::Progress;
use fem::units::{Knowledge, TIME};
use pyo3::prelude::*;

use crate::answer::{Answer, tables_of_comparison, tables_of_rows, tables_of_run};
use crate::compute::{compute, within};
use crate::data::Asked;
use crate::error::Error;
use crate::handle::Model;

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
    fn text(&self) -> String {
        self.0.text()
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
        self.0.effects.iter().map(|e| &*e.description.name).collect()
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
        all.map(|(p, (value, std))| (&*p.path, &*p.kind.unit, value, std)).collect()
    }

    /// Its text for a file at another place.
    fn text_at(&self, path: PathBuf) -> String {
        self.0.text_at(&path)
    }

    /// The model with one more effect.
    fn add(&self, py: Python, effect: String, settings: Vec<(String, String)>) -> PyResult<Self> {
        let model = self.0.clone();
        compute(py, &Arc::default(), move |_| {
            let settings: Vec<Setting> =
                settings.into_iter().map(|(key, value)| Setting { key, value: Entry::Text(value) }).collect();
            Ok(Self(Arc::new(add_effect(&model, &effect, &settings)?)))
        })
    }

    /// Predicts.
    fn run(&self, py: Python) -> PyResult<Answer> {
        let model = self.0.clone();
        compute(py, &Arc::default(), move |progress| {
            model.require_part()?;
            let (mut run, band) = ask::run(&model, progress)?;
            let answer = Answer::of(&RunAnswer(&model, &run, band.as_ref()), &model);
            let notes = run.report.warnings.clone();
            Ok(Answer { tables: vec![tables_of_run(&model, &mut run)], notes, ..answer })
        })
    }

    /// Predicts rows, those of its own programme or of a design, with the bands that hold the truth about them with 95 %.
    fn predict(&self, py: Python, design: Option<Asked>) -> PyResult<Answer> {
        let model = self.0.clone();
        compute(py, &Arc::default(), move |progress| {
            model.require_part()?;
            let asked = design.map(|asked| asked.bound(&model, true)).transpose()?;
            let asked = asked.as_ref().map(|(model, rows)| data_of(model, rows.clone())).transpose()?;
            let (model, rows) = match &asked {
                Some(data) => (data.model, model.system.resolved(&data.rows)),
                None => (&*model, model.system.programme()),
            };
            let (predicted, band) = ask::predict(model, &rows, progress)?;
            let coordinates = model.process.coordinates().iter().map(|c| c.name.to_string()).collect();
            let tables = vec![tables_of_band(model, &rows, &predicted, &band)];
            Ok(Answer { tables, coordinates, ..Answer::default() })
        })
    }

    /// What to command so that the part comes out as the drawing asks; files go into a folder, if one is named.
    fn correct(
        &self,
        py: Python,
        program: Option<PathBuf>,
        add_blocks: bool,
        despite_failure: bool,
        output: Option<PathBuf>,
        overwrite: bool,
    ) -> PyResult<Answer> {
        let model = self.0.clone();
        compute(py, &Arc::default(), move |progress| {
            let read = program.as_ref().map(|path| ask::program(&model, path)).transpose()?;
            let found = ask::action(&model, (read.as_ref(), add_blocks), despite_failure, progress)?;
            let answer = ActionAnswer(&model, &found);
            let reads = [model.paths(), program.iter().cloned().collect()].concat();
            written(&answer, (output.as_deref(), overwrite), &reads, progress)?;
            let tables = vec![vec![("correction".to_string(), answer.table())]];
            Ok(Answer { tables, ..Answer::of(&answer, &model) })
        })
    }

    /// Which of its settings a shop should change.
    fn remedies(
        &self,
        py: Python,
        minutes: Option<f64>,
        despite_failure: bool,
        output: Option<PathBuf>,
        overwrite: bool,
    ) -> PyResult<Answer> {
        let model = self.0.clone();
        compute(py, &Arc::default(), move |progress| {
            let found = ask::remedies(&model, minutes.map(|minutes| TIME.to_si(minutes)), despite_failure, progress)?;
            let correction = match model.system.commanded() {
                Some(_) => Some(ask::correct(&model, despite_failure, progress)?),
                None => None,
            };
            let directory = output.as_deref();
            let answer = RemedyAnswer { model: &model, found: &found, correction: correction.as_ref(), directory };
            written(&answer, (directory, overwrite), &model.paths(), progress)?;
            let best = found.best().and_then(|own| model.edited(&own.edits).ok());
            Ok(Answer { model: best.map(|better| marked(better, "remedied")), ..Answer::of(&answer, &model) })
        })
    }

    /// Estimates what it leaves open.
    fn fit(&self, py: Python, data: Asked, seconds: Option<f64>) -> PyResult<Answer> {
        self.of_data(py, within(seconds), data, |data, _| {
            let found = fit(data)?;
            let residuals = data.residuals(&found.predicted);
            let tables = vec![tables_of_rows(data, &found.predicted, &residuals, &found.noise.sigma)];
            // A fitted value that no model may hold leaves none.
            let model = fitted(data, &found).ok().map(|better| marked(better, "fitted"));
            let answer = Answer::of(&FitAnswer(data, &found), data.model);
            Ok(Answer { tables, notes: data.notes_of_fit(), model, ..answer })
        })
    }

    /// Names the effect that is missing.
    fn diagnose(&self, py: Python, data: Asked, most_effects: usize, seconds: Option<f64>) -> PyResult<Answer> {
        self.of_data(py, within(seconds), data, move |data, progress| {
            let found = diagnose(data, most_effects, progress)?;
            let notes = ask::notes(data, &found);
            // A fitted value that no model may hold leaves none.
            let model = completed(data, &found).ok().map(|better| marked(better, "completed"));
            let mut marks = String::new();
            let steps = steps(data, &found).into_iter().map(|(effect, model)| {
                marks = if marks.is_empty() { effect } else { format!("{marks}-{effect}") };
                marked(model, &marks)
            });
            let steps = steps.collect();
            let answer = Answer::of(&DiagnosisAnswer::new(data, &found), data.model);
            let details = text(&DiagnosisAnswer::new(data, &found).verbose(), None);
            Ok(Answer { details, notes, model, steps, ..answer })
        })
    }

    /// Seeks a law that is in no catalogue.
    fn discover(&self, py: Python, data: Asked, candidates: Vec<PathBuf>, seconds: Option<f64>) -> PyResult<Answer> {
        self.of_data(py, within(seconds), data, move |data, progress| {
            let candidates = read_candidates(&candidates)?;
            let found = discover(data, &candidates, progress)?;
            let model = found.told().and_then(|law| law.model.clone()).map(|better| marked(better, "law"));
            let answer = Answer::of(&LawsAnswer(data, &found), data.model);
            Ok(Answer { notes: data.notes_of_fit(), model, ..answer })
        })
    }

    /// What could be seen by measuring, and what would look alike.
    fn plan(&self, py: Python, design: Option<Asked>, noise: Vec<String>, seconds: Option<f64>) -> PyResult<Answer> {
        let model = self.0.clone();
        compute(py, &within(seconds), move |progress| {
            let design = match design {
                Some(asked) => Some(asked.bound(&model, true)?),
                None => None,
            };
            let design = match &design {
                Some((model, rows)) => data_of(model, rows.clone())?,
                None => Data::programme(&model)?,
            };
            let design = design.watched(progress.clone());
            let (found, note) = plan(&design, &noise)?;
            let answer = Answer::of(&PlanAnswer(&design, &found), &model);
            Ok(Answer { notes: note.into_iter().collect(), ..answer })
        })
    }

    /// Evaluates the test of an axis, and compensates it.
    fn compensate(&self, py: Python, data: Asked) -> PyResult<Answer> {
        self.of_data(py, Arc::default(), data, |data, _| {
            let found = compensate(data)?;
            let notes = data.notes.clone();
            Ok(Answer { notes, ..Answer::of(&CompensationAnswer(data, &found, &[]), data.model) })
        })
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
            let (model, measurements) = asked.bound(&model, false)?;
            work(&data_of(&model, measurements)?.watched(progress.clone()), progress)
        })
    }
}

/// Writes the files of a correction into a folder, where one is named.
fn written(
    answer: &impl output::Answer,
    (directory, force): (Option<&Path>, bool),
    reads: &[PathBuf],
    progress: &Progress,
) -> Result<(), Error> {
    if let Some(directory) = directory {
        Folder { directory, guard: Guard { reads, force } }.write("correct", answer, progress)?;
    }
    Ok(())
}

/// Measurements with their model.
fn data_of(model: &model::Model, measurements: Measurements) -> Result<Data<'_>, ask::Error> {
    Data::of(model, measurements).map_err(|e| ask::Error::of_data(e, model))
}

/// Holds models of one process against the same measurements.
#[pyfunction]
pub fn compare(py: Python, models: Vec<PyRef<Model>>, data: Asked) -> PyResult<Answer> {
    let models = all(&models);
    compute(py, &Arc::default(), move |progress| {
        refuse_mixed(&models)?;
        let Some(first) = models.first() else { return Ok(Answer::default()) };
        let each = |data: &Data, found| (tables_of_comparison(data, &found), found);
        let measurements = data.read(first, false)?;
        let models = with_recorded(&models, &measurements)?;
        let Some(first) = models.first() else { return Ok(Answer::default()) };
        let (compared, measurements) = compare_all(&models, measurements, progress, each)?;
        let (tables, comparisons): (Vec<_>, Vec<_>) = compared.into_iter().unzip();
        let answer = ComparisonAnswer {
            process: &*first.process,
            models: &models,
            measurements: &measurements,
            comparisons: &comparisons,
        };
        Ok(Answer { tables, notes: measurements.notes.clone(), ..Answer::of(&answer, first) })
    })
}

/// The page of a report, and its notes.
#[pyfunction]
#[pyo3(signature = (models, data, most_effects, seconds))]
pub fn report(
    py: Python,
    models: Vec<PyRef<Model>>,
    data: Option<Asked>,
    most_effects: usize,
    seconds: Option<f64>,
) -> PyResult<(String, Vec<String>)> {
    let models = all(&models);
    compute(py, &within(seconds), move |progress| {
        refuse_mixed(&models)?;
        let Some(last) = models.last() else { return Ok(Default::default()) };
        let named = models.iter().flat_map(model::Model::paths).chain(data.iter().flat_map(Asked::files));
        let files = named.filter(|path| path.is_file()).collect();
        let measurements = data.as_ref().map(|data| data.read(last, false)).transpose()?;
        let models = match &measurements {
            Some(measurements) => with_recorded(&models, measurements)?,
            None => models.clone(),
        };
        let page = Page { models: &models, measurements, files, most_effects, depth: Depth::Diagnosed, live: None };
        let made = page.made(progress)?;
        Ok((made.html, made.notes))
    })
}

/// A model under a name that tells it from that of which it came: `lathe-fitted.toml`.
fn marked(mut model: model::Model, mark: &str) -> Model {
    let place = Path::new(&*model.source.name);
    let ending = place.extension().map_or(String::new(), |ending| format!(".{}", ending.to_string_lossy()));
    let name = format!("{}-{mark}{ending}", model.stem().to_string_lossy());
    model.source.name = place.with_file_name(name).to_string_lossy().into();
    Model(Arc::new(model))
}

/// Models whose rows have the columns that measurements record beside those of the process.
fn with_recorded(models: &[model::Model], measurements: &Measurements) -> Result<Vec<model::Model>, ask::Error> {
    models.iter().map(|model| Ok(model.with_recorded(&measurements.recorded)?)).collect()
}

fn all(models: &[PyRef<Model>]) -> Vec<model::Model> {
    models.iter().map(|model| (*model.0).clone()).collect()
}
