//! Errors of commands, and their report.

use std::io::Write;

use super::look;
use super::say::say;
use crate::ask;

/// Reason for which a command failed.
#[derive(Debug)]
pub enum Error {
    /// The question has no answer.
    Asked(Box<ask::Error>),
    /// Stdout cannot be written.
    Stdout(std::io::Error),
    /// A check failed; the result has been printed.
    Found,
}

impl<E: Into<ask::Error>> From<E> for Error {
    fn from(error: E) -> Self {
        Self::Asked(Box::new(error.into()))
    }
}

impl Error {
    /// Reports the error on stderr and returns the exit status: 2 where the input is wrong, 1 where the computation or
    /// the writing failed.
    pub fn report(&self) -> u8 {
        match self {
            // Its colours are the program's own; what it quotes is visible already.
            Self::Asked(error) => drop(writeln!(std::io::stderr(), "{}", error.text(look::marks()))),
            Self::Stdout(error) => say!("error: the output cannot be written: {error}"),
            Self::Found => {}
        }
        match self {
            Self::Asked(error) if error.is_of_input() => 2,
            Self::Asked(_) | Self::Stdout(_) | Self::Found => 1,
        }
    }
}
