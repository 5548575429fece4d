//! Validation table of budgets: the handbook's formulas by hand, read from a budget's text, and laws whose
//! moments and quantiles are known.

mod drawing;
mod formulas;
mod rig;
mod terms;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [formulas::cases(), terms::cases(), drawing::cases()].concat()
}
