//! A page: models, measurements and a diagnosis brought together.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use sha2::{Digest, Sha256};

use super::{Error, compare_all, completed, fit, fitted, refuse_mixed, run};
use crate::diagnose::{Diagnosis, thinned};
use crate::discover::diagnose;
use crate::knowledge::Band;
use crate::measure::Measurements;
use crate::model::{Data, Model, Run};
use crate::output::{Evidence, RunAnswer, Subject, page};
use crate::progress::Progress;

/// How far a page goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Models are compared as they are written: at once.
    Compared,
    /// The last model is diagnosed too.
    Diagnosed,
}

/// A page, and what it was made of.
pub struct Made {
    /// The page.
    pub html: String,
    /// Notes on the files that were read.
    pub notes: Vec<String>,
    /// All files that were read.
    pub files: Vec<PathBuf>,
}

/// All that a page is made of.
pub struct Page<'a> {
    /// Models of one process, in their order; the last is diagnosed.
    pub models: &'a [Model],
    /// Measurements to compare with the models, if any.
    pub measurements: Option<Measurements>,
    /// Files that were read, to be named with their hashes.
    pub files: Vec<PathBuf>,
    /// Most effects to look for together.
    pub most_effects: usize,
    /// How far the page goes.
    pub depth: Depth,
    /// Version of a page that renews itself.
    pub live: Option<u64>,
}

impl Page<'_> {
    /// Makes the page.
    ///
    /// # Errors
    /// Models of several processes; as of a run, a comparison and a diagnosis.
    pub fn made(self, progress: &Arc<Progress>) -> Result<Made, Error> {
        let Self { models, measurements, files: named, most_effects, depth, live } = self;
        refuse_mixed(models)?;
        let Some(model) = models.last() else {
            return Ok(Made { html: String::new(), notes: Vec::new(), files: Vec::new() });
        };
        let of_models = models.iter().map(|model| (&*model.source.name, model.source.sha256));
        let of_data = measurements.iter().flat_map(|all| &all.files).map(|file| (&*file.name, file.sha256));
        let read: HashMap<String, [u8; 32]> =
            of_models.chain(of_data).filter_map(|(name, hash)| Some((name.to_string(), hash?))).collect();
        let named_hash = |path: &PathBuf| {
            let name = path.display().to_string();
            let hash = read.get(&name).map_or_else(|| hash(path), |digest| hex(digest));
            (name, hash)
        };
        let files = named.iter().map(named_hash).collect();
        let Some(measurements) = measurements else {
            model.require_part()?;
            let (found, band) = run(model, progress)?;
            let subject = Subject { models, run: Some(RunAnswer(model, &found, band.as_ref())), evidence: None, files };
            return Ok(Made { html: page(&subject, live), notes: Vec::new(), files: named });
        };
        let (Settled { models: settled, notes: fits }, measurements) = settled(models, measurements, progress)?;
        let (comparisons, measurements) = match &settled {
            Some(settled) => compare_all(settled, measurements, progress, |_, comparison| comparison)?,
            None => (Vec::new(), measurements),
        };
        let all = Data::of(model, measurements).map_err(|error| Error::of_data(error, model))?;
        let all = all.watched(progress.clone());
        let mut notes = all.notes_of_fit();
        notes.extend(fits);
        let some = thinned(&all);
        if let Some(some) = &some {
            notes.push(format!("{} of {} rows were used for the diagnosis, evenly chosen", some.len(), all.len()));
        }
        let is_deep = depth == Depth::Diagnosed;
        let data = some.as_ref().filter(|_| is_deep).unwrap_or(&all);
        let diagnosis = if is_deep { Some(diagnose(data, most_effects, progress)?) } else { None };
        let better = diagnosis.as_ref().and_then(|d| complete(data, d, &mut notes, progress));
        let is_best = better.is_none() && model.require_values().is_ok();
        let own = if is_best { Some(run(model, progress)?) } else { None };
        let evidence = Evidence {
            all: &all,
            data,
            comparisons: &comparisons,
            diagnosis: diagnosis.as_ref(),
            completed: better.as_ref().map(|(model, (run, band))| RunAnswer(model, run, band.as_ref())),
        };
        let best = own.as_ref().map(|(run, band)| RunAnswer(model, run, band.as_ref()));
        let subject = Subject { models, run: best, evidence: Some(evidence), files };
        Ok(Made { html: page(&subject, live), notes, files: named })
    }
}

/// Models that can be compared.
struct Settled {
    /// `None` where the measurements do not tell a value that one of them leaves open.
    models: Option<Vec<Model>>,
    /// Which values were estimated first.
    notes: Vec<String>,
}

/// Models whose unknown values were estimated from the measurements, which come back.
fn settled(
    models: &[Model],
    mut measurements: Measurements,
    progress: &Arc<Progress>,
) -> Result<(Settled, Measurements), Error> {
    let (mut all, mut notes) = (Vec::new(), Vec::new());
    for model in models {
        let unknown = model.unknown();
        if unknown.is_empty() {
            all.push(model.clone());
            continue;
        }
        let name = &model.source.name;
        let data = Data::of(model, measurements).map_err(|error| Error::of_data(error, model))?;
        let data = data.watched(progress.clone());
        let found = fit(&data).and_then(|found| fitted(&data, &found)).ok().filter(|m| m.require_values().is_ok());
        notes.push(match &found {
            Some(_) => {
                format!("{name} leaves {} open (`?`): it is compared as fitted to these rows", unknown.join(", "))
            }
            None => format!(
                "{name} leaves {} open (`?`), and these rows do not tell it: models are not compared",
                unknown.join(", ")
            ),
        });
        measurements = data.into_measurements();
        all.extend(found);
    }
    let models = (all.len() == models.len()).then_some(all);
    Ok((Settled { models, notes }, measurements))
}

/// The model with what was missing, and its run; `None` where values stay open or nothing was found.
fn complete(
    data: &Data,
    diagnosis: &Diagnosis,
    notes: &mut Vec<String>,
    progress: &Progress,
) -> Option<(Model, (Run, Option<Band>))> {
    if diagnosis.missing.is_empty() && diagnosis.fit.estimates.is_empty() {
        return None;
    }
    let better = match completed(data, diagnosis) {
        Ok(better) => better,
        Err(_) => {
            notes.push("the completed model cannot be written, and its curves are left out".into());
            return None;
        }
    };
    better.require_values().ok()?;
    let own = run(&better, progress).ok()?;
    Some((better, own))
}

/// SHA-256 of a file of which the reader kept none, as of a mesh. What cannot be read again is not waited for.
fn hash(path: &Path) -> String {
    match std::fs::metadata(path).and_then(|about| if about.is_file() { std::fs::read(path) } else { Ok(Vec::new()) }) {
        Ok(bytes) if bytes.is_empty() => "unread: it has been read to its end".into(),
        Ok(bytes) => hex(&Sha256::digest(&bytes)),
        Err(error) => format!("unread: {error}"),
    }
}

/// A digest as `sha256sum` prints it.
fn hex(digest: &[u8]) -> String {
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}
