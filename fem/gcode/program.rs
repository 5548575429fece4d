//! A program that was read.

use std::path::Path;

use super::interpret::steps;
use super::steps::Step;
use super::words::{Block, blocks};
use super::workpiece::Workpiece;
use crate::input::{InputError, Source};

/// Most bytes of a program.
const MOST_BYTES: u64 = 16_000_000;

/// A program, as bytes and as steps of the tool.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its name, and its text as far as it is one: every byte has its place.
    pub source: Source,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Its lines.
    pub blocks: Vec<Block>,
    /// What the tool does.
    pub steps: Vec<Step>,
}

impl Program {
    /// Reads a program from a file.
    ///
    /// # Errors
    /// The file cannot be read, or as those of [`of`](Self::of).
    pub fn read(path: &Path, work: &Workpiece) -> Result<Self, InputError> {
        let name = path.display().to_string();
        let bytes = crate::input::bytes_of(path, MOST_BYTES)
            .map_err(|problem| InputError::one(Source::new(&*name, ""), problem))?;
        Self::of(&name, bytes, work)
    }

    /// Reads a program from its bytes, in any code page that has ASCII in it.
    ///
    /// # Errors
    /// Blocks that a correction cannot follow, each with its place and a remedy.
    pub fn of(name: &str, bytes: Vec<u8>, work: &Workpiece) -> Result<Self, InputError> {
        let text = match std::str::from_utf8(&bytes) {
            Ok(text) => text.to_string(),
            // Comments in a code page: a sign stands for each byte that is no ASCII.
            Err(_) => bytes.iter().map(|byte| if byte.is_ascii() { char::from(*byte) } else { '?' }).collect(),
        };
        let source = Source::new(name, text);
        let fail = |problems| InputError::new(source.clone(), problems);
        let blocks = blocks(&bytes);
        let steps = steps(&blocks, work).map_err(fail)?;
        Ok(Self { source, bytes, blocks, steps })
    }
}
