//! Small circular tests in which any two effects may meet, both ways round: at one feed, at two, on a small circle
//! that is gone round fast, on a large one, and with nuts of two halves.

use super::{Job, Row, Screw};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::preload::Side;
use crate::random::{Random, decimals};

/// Their names.
pub const NAMES: &[&str] = &["one feed", "two feeds", "small and fast", "large and slow", "nuts of two halves"];

const fn known(effect: &'static str, parameter: &'static str, written: f64) -> Shown {
    Shown { effect, parameter, written, std: 0.1 }
}

/// What is in the model unless it is asked for; nothing in the first scene.
const COMPANY: &[Shown] = &[
    known("servo-mismatch", "mismatch", 0.03),
    known("backlash-x", "gap", 6.0),
    known("elastic-lost-motion-x", "friction", 500.0),
    known("elastic-lost-motion-x", "stiffness", 150.0),
    known("elastic-lost-motion-y", "friction", 800.0),
    known("elastic-lost-motion-y", "stiffness", 250.0),
];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let radius = [100.0, 80.0, 25.0, 200.0, 120.0][scene];
    let feed = [1000.0, 1200.0, 4000.0, 500.0, 1500.0][scene];
    let feeds = if scene == 0 { vec![feed] } else { vec![feed, 1.7 * feed] };
    let nut = (scene == 4).then_some((Side { stiffness: Some(300.0), contact: Some((0.1, 0.6)) }, 900.0));
    let mut screw =
        |side: f64| Screw { diameter: 28.0, fixed_at: decimals(side * (radius + random.uniform(60.0, 300.0)), 0), nut };
    let screws = [screw(-1.0), screw(1.0)];
    // Close behind a turn and far from one, and a turn each further.
    let places = [1.1, 4.3, 17.0, 33.0, 52.0, 71.0, 86.0, 91.3, 128.0, 176.0, 183.0, 226.0, 268.0, 274.0, 312.0, 357.0];
    let mut rows = Vec::new();
    for (lap, (feed, clockwise)) in feeds.iter().flat_map(|feed| [(*feed, false), (*feed, true)]).enumerate() {
        rows.extend(places.iter().map(|angle| Row { lap, clockwise, feed, angle: *angle }));
    }
    let mut job = Job {
        command: [Vec::new(), Vec::new()],
        radius,
        feed,
        gain: decimals(random.uniform(25.0, 50.0), 1),
        lead: Some(10.0),
        frequency: Some(0.7),
        screws: Some(screws),
        cut: Some([220.0, 140.0]),
        rows,
        noise: NoiseKind::Neither,
        shown: if scene == 0 { Vec::new() } else { COMPANY.to_vec() },
    };
    job.shown.retain(|shown| !effects.contains(&shown.effect));
    effects.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}
