//! The files of an answer on their way into a folder.

use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::chart::Svg;
use super::files::Stage;
use super::{OutputError, vtk};
use crate::model::Model;
use crate::process::Animation;
use crate::progress::Progress;

/// The files of an answer on their way into a folder, in which they appear all together or not at all.
pub struct Staged<'a> {
    stage: Stage<'a>,
    /// Of the frames.
    progress: &'a Progress,
    /// Those that a user opens.
    written: Vec<PathBuf>,
}

impl<'a> Staged<'a> {
    /// No file yet.
    pub fn new(stage: Stage<'a>, progress: &'a Progress) -> Self {
        Self { stage, progress, written: Vec::new() }
    }

    /// Lets the files appear, and names those that a user opens.
    pub fn publish(self) -> Result<Vec<PathBuf>, OutputError> {
        self.stage.publish()?;
        Ok(self.written)
    }

    /// Writes a text.
    pub fn text(&mut self, path: impl Into<PathBuf>, text: &str) -> Result<(), OutputError> {
        self.bytes(path, text.as_bytes())
    }

    /// Writes a file as it is, in whatever code page it may be.
    pub fn bytes(&mut self, path: impl Into<PathBuf>, bytes: &[u8]) -> Result<(), OutputError> {
        let path = path.into();
        self.stage.write(&path, bytes)?;
        self.written.push(path);
        Ok(())
    }

    /// Writes figures, each with the stem of its file.
    pub fn figures(&mut self, all: Vec<(String, Svg)>) -> Result<(), OutputError> {
        all.into_iter().try_for_each(|(name, svg)| self.text(format!("{name}.svg"), &svg.file()))
    }

    /// Writes `NAME.pvd` with true geometry, `NAME-magnified.pvd` as people look at it, their frames in `NAME/`, and the
    /// script that opens the second; in a folder `own` of the folder.
    pub fn animation(
        &mut self,
        animation: &Animation,
        script: &str,
        model: &Model,
        own: &Path,
    ) -> Result<(), OutputError> {
        let file = model.source.name.to_string();
        let series = vtk::Series::new(animation, model.title.as_deref().unwrap_or(&file), &file);
        let (real, magnified) = (animation.name.to_string(), format!("{}-magnified", animation.name));
        self.progress.expect(animation.frames as u64);
        let (stage, progress) = (&self.stage, self.progress);
        let write = |i: usize| {
            let place = |stem: &str, end: &str| format!("{}/{stem}_{i:04}.{end}", animation.name);
            let paths = [place(&real, "vtu"), place(&magnified, "vtp")];
            let wrong = |error| OutputError::Shape { path: PathBuf::from(&paths[0]), error };
            let frame = series.frame(i).map_err(wrong)?;
            stage.write(&own.join(&paths[0]), &frame.real)?;
            if let Some(bytes) = &frame.magnified {
                stage.write(&own.join(&paths[1]), bytes)?;
            }
            progress.advance(1);
            Ok(paths.map(|path| (frame.time, path)))
        };
        let frames: Vec<[(f64, String); 2]> =
            (0..animation.frames).into_par_iter().map(write).collect::<Result<_, OutputError>>()?;
        let view = series.view();
        for (k, stem) in [real, magnified].iter().enumerate().take(if view.is_some() { 2 } else { 1 }) {
            let path = own.join(format!("{stem}.pvd"));
            let list: Vec<(f64, String)> = frames.iter().map(|frame| frame[k].clone()).collect();
            let text = vtk::pvd(&list).map_err(|error| OutputError::Shape { path: path.clone(), error })?;
            self.text(path, &text)?;
        }
        view.map_or(Ok(()), |view| self.text(own.join(script), &view))
    }
}
