//! Small jobs in which any two effects may meet: from zero and reversed, alone and beside friction, contact and
//! clearance, or beside a preload.

use super::{Job, Loading, Row};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals};

/// Their names.
pub const NAMES: &[&str] =
    &["from zero", "from zero, friction and gap", "from zero, preloaded", "reversed", "reversed, friction and gap"];

const fn known(effect: &'static str, parameter: &'static str, written: f64) -> Shown {
    Shown { effect, parameter, written, std: 0.1 }
}

/// What is in the model unless it is asked for.
const LOOSE: &[Shown] = &[
    known("dry-friction", "force", 60.0),
    known("gap", "gap", 3.0),
    known("contact-joint", "c", 0.2),
    known("contact-joint", "n", 0.5),
];
const PRESSED: &[Shown] = &[known("preload", "force", 260.0), known("dry-friction", "force", 45.0)];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let loading = if scene < 3 { Loading::FromZero } else { Loading::Reversed };
    let company = [&[], LOOSE, PRESSED, &[], LOOSE][scene];
    let max_force = decimals(random.uniform(700.0, 1500.0), 0);
    let least = if loading == Loading::Reversed { -16 } else { 0 };
    // Beside the forces at which friction of whole newtons just lets go.
    let force = |step: i32| {
        if step == 0 { 0.0 } else { decimals(max_force * f64::from(step) / 16.0 + 0.137, 3).min(max_force) }
    };
    let up = (least..=16).map(|step| Row { force: force(step), unload: false });
    let down = (least..16).rev().map(|step| Row { force: force(step), unload: true });
    let mut job = Job {
        stiffness: decimals(random.uniform(50.0, 120.0), 1),
        max_force,
        loading,
        rows: up.chain(down).collect(),
        noise: NoiseKind::Neither,
        shown: company.to_vec(),
    };
    job.shown.retain(|shown| !effects.contains(&shown.effect));
    effects.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}
