//! Files of measurements as they are read, before anything is asked of them.

use std::path::Path;

use super::Error;
use crate::input::Problem;
use crate::measure::{Imported, Measurements, Preview, Reading, open};
use crate::process::Process;
use crate::processes;

/// Looks at a file of a process, or of whichever understands most of it.
///
/// # Errors
/// It cannot be read, or is no table.
pub fn look(path: &Path, process: Option<&'static dyn Process>, said: &Reading) -> Result<Imported, Error> {
    let file = open(path, said)?;
    if let Some(process) = process {
        let preview = Preview::of(&file, Some(process), said)?;
        let taken = Some(Measurements::of_file(&file, process, said));
        return Ok(Imported { process: Some(process), others: Vec::new(), preview, taken });
    }
    let mut all = Vec::new();
    for process in processes::ALL.iter().copied() {
        let preview = Preview::of(&file, Some(process), said)?;
        let taken = Measurements::of_file(&file, process, said);
        let understood = preview.meant.iter().flatten().count();
        all.push((taken.is_ok(), understood, process, preview, taken));
    }
    let best = all.iter().map(|own| (own.0, own.1)).max().unwrap_or_default();
    if best.1 == 0 {
        let preview = Preview::of(&file, None, said)?;
        return Ok(Imported { process: None, others: Vec::new(), preview, taken: None });
    }
    let mut fitting = all.into_iter().filter(|own| (own.0, own.1) == best);
    let Some((.., process, preview, taken)) = fitting.next() else {
        return Err(Problem::new("no process is known here").into());
    };
    let others = fitting.map(|own| own.2).collect();
    Ok(Imported { process: Some(process), others, preview, taken: Some(taken) })
}
