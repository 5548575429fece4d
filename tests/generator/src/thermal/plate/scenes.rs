//! Small plates in which any two effects may meet: heated from above, cooled through films of their own, covered,
//! held at edges, under strips that stand and that move, and warm at the start.

use super::series::Side;
use super::{Condition, Job, Row, Seen};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals};

const fn known(effect: &'static str, parameter: &'static str, written: f64) -> Shown {
    Shown { effect, parameter, written, std: 0.1 }
}

/// What is in the model unless it is asked for; nothing in the first scene.
const COMPANY: &[Shown] = &[known("convection", "coefficient", 15.0), known("base-conductance", "conductance", 0.15)];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let length = decimals(random.uniform(60.0, 90.0), 0);
    let height = decimals(length * random.uniform(0.3, 0.5), 0);
    let (end, whole) = (40.0, 40.0);
    let (edges, source) = match scene {
        0 => (vec![(Side::Top, Condition::Flux(6.0, 0.0, 12.5, false))], None),
        1 => (
            vec![
                (Side::Top, Condition::Flux(9.0, 0.0, 20.5, false)),
                (Side::Top, Condition::Film(60.0, Some(26.0))),
                (Side::Bottom, Condition::Film(120.0, None)),
                (Side::Left, Condition::Film(35.0, Some(16.0))),
            ],
            None,
        ),
        2 => (
            vec![
                (Side::Top, Condition::Flux(6.0, 0.5, 20.5, true)),
                (Side::Right, Condition::Flux(8.0, 0.0, whole, false)),
                (Side::Bottom, Condition::Flux(-2.0, 8.5, 28.5, true)),
            ],
            None,
        ),
        3 => (
            vec![
                (Side::Bottom, Condition::Held(32.0)),
                (Side::Top, Condition::Flux(15.0, 0.0, 20.5, false)),
                (Side::Right, Condition::Film(200.0, None)),
            ],
            None,
        ),
        4 => (
            vec![(Side::Left, Condition::Held(45.0)), (Side::Top, Condition::Film(80.0, Some(18.0)))],
            Some((decimals(0.6 * length, 0), 5.0, 0.0, 20.5)),
        ),
        5 => (
            vec![
                (Side::Top, Condition::Strip(20.0, decimals(0.35 * length, 0), 0.0, decimals(0.3 * length, 0))),
                (Side::Bottom, Condition::Film(90.0, None)),
            ],
            None,
        ),
        6 => (
            vec![
                (Side::Top, Condition::Strip(30.0, -6.0, decimals(length / 30.0, 1), 12.0)),
                (Side::Right, Condition::Strip(12.0, decimals(0.5 * height, 0), 0.0, decimals(0.4 * height, 0))),
                (Side::Right, Condition::Film(50.0, Some(30.0))),
            ],
            None,
        ),
        _ => (
            vec![(Side::Top, Condition::Flux(3.0, 12.5, 28.5, true)), (Side::Bottom, Condition::Film(40.0, None))],
            Some((decimals(0.3 * length, 0), 4.0, 0.0, 16.5)),
        ),
    };
    // On what is heated, but not close to the ends of a strip, where no element follows.
    let face = if [4, 5, 6].contains(&scene) { 0.7 } else { 1.0 };
    let sensors: Vec<(f64, f64)> = [(0.1, 0.8), (0.45, face), (0.8, 0.2)]
        .map(|(x, y)| (decimals(x * length, 0), decimals(y * height, 0)))
        .to_vec();
    let seen = (0..sensors.len()).map(Seen::Temperature).chain([Seen::Elongation]);
    let rows = (1..=10)
        .flat_map(|k| seen.clone().map(move |seen| Row { change: 0.0, time: 4.0 * f64::from(k), seen }))
        .collect();
    let mut job = Job {
        size: [length, height, 12.0],
        edges,
        source,
        ambient: 21.0,
        start: (scene == 7).then_some(48.0),
        end,
        sensors,
        rows,
        fine: (2.0, if [5, 6].contains(&scene) { 2.0 } else { 3.0 }),
        noise: NoiseKind::Neither,
        shown: if scene == 0 { Vec::new() } else { COMPANY.to_vec() },
    };
    let shows = |shown: &Shown| !effects.contains(&shown.effect) && job.admits(shown.effect, &[]);
    job.shown = job.shown.iter().copied().filter(shows).collect();
    let causes = job.causes(&job.shown.iter().map(|s| s.written).collect::<Vec<_>>());
    let loses = effects.iter().any(|effect| ["convection", "base-conductance"].contains(effect));
    let admits = |effect: &str| if effect == "ambient-drift" && loses { true } else { job.admits(effect, &causes) };
    effects.iter().all(|effect| admits(effect)).then_some(job)
}
