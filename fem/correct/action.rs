//! What to do so that a part comes out right.

use super::{Advised, Correction, Programmed};

/// What to do about a model.
#[derive(Clone, Debug)]
pub enum Action {
    /// Another command, perhaps carried by the user's own program.
    Command(Box<Correction>, Option<Box<Programmed>>),
    /// What to change, where no command of the process is corrected.
    Advice(Box<Advised>),
}
