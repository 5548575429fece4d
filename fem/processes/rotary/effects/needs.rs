//! What effects ask of a set-up, each with the reason that goes on from an effect's name.

use super::super::scale::{At, Scale};
use super::super::setup::Setup;

/// A drive that stands behind what is read: no loop over the table takes its errors out.
pub fn a_drive_that_shows(setup: &Setup) -> Result<(), String> {
    match setup.is_closed() {
        true => Err("needs a drive whose errors show, and here the control positions by the scale on the table \
                     (`loop = \"closed\"`), which takes them out"
            .into()),
        false => Ok(()),
    }
}

/// A worm, and nothing that takes its errors out.
pub fn a_worm(setup: &Setup) -> Result<(), String> {
    match setup.drive.worm {
        Some(_) => a_drive_that_shows(setup),
        None => Err("needs a worm: `type = \"worm\"` in [drive]".into()),
    }
}

/// Gears, and nothing that takes their errors out.
pub fn gears(setup: &Setup) -> Result<(), String> {
    match setup.drive.stages[..] {
        [] => Err("needs gears: `stages` in [drive]".into()),
        _ => a_drive_that_shows(setup),
    }
}

/// Teeth between motor and table, and nothing that takes their errors out.
pub fn teeth(setup: &Setup) -> Result<(), String> {
    match setup.drive.is_direct() {
        true => Err("needs teeth between motor and table, and a direct drive has none".into()),
        false => a_drive_that_shows(setup),
    }
}

/// A scale on the table.
pub fn a_scale_on_the_table(setup: &Setup) -> Result<(), String> {
    match setup.scale {
        Some(Scale { at: At::Table, .. }) => Ok(()),
        _ => Err("needs a scale on the table: `at = \"table\"` in [scale]".into()),
    }
}
