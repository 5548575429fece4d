//! Small rods in which any two effects may meet: alone, losing heat to the room and the base, stepped, with two
//! sources, and warm at the start. Behind them stand [plates].

use super::job::{Job, Row, Seen, SetUp};
use super::plate::scenes as plates;
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals};

/// Their names, and those of the plates.
pub const NAMES: &[&str] = &[
    "insulated",
    "in a room",
    "stepped",
    "two sources",
    "warm at the start",
    "plate, insulated",
    "plate, flux and film",
    "plate, covered",
    "plate, held from below",
    "plate, held at the base",
    "plate, under a strip",
    "plate, under strips that move",
    "plate, warm at the start",
];
/// How many of them are rods.
const RODS: usize = 5;

const fn known(effect: &'static str, parameter: &'static str, written: f64) -> Shown {
    Shown { effect, parameter, written, std: 0.1 }
}

/// What is in the model unless it is asked for; nothing in the first scene.
const COMPANY: &[Shown] = &[known("convection", "coefficient", 18.0), known("base-conductance", "conductance", 0.2)];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Box<dyn crate::job::Job>> {
    match scene.checked_sub(RODS) {
        Some(plate) => Some(Box::new(plates::draw(plate, effects, random)?)),
        None => Some(Box::new(rod(scene, effects, random)?)),
    }
}

fn rod(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let length = decimals(random.uniform(160.0, 260.0), 0);
    let diameter = decimals(random.uniform(18.0, 32.0), 1);
    let step = decimals(0.45 * length, 0);
    let segments = match scene {
        2 => vec![(step, decimals(1.4 * diameter, 1)), (length - step, diameter)],
        _ => vec![(length, diameter)],
    };
    let end = 120.0;
    let mut set_up = SetUp { fine: Some((2.0, 1.0)), ..SetUp::default() };
    match scene {
        3 => set_up.sources.push((decimals(0.35 * length, 0), 6.0, 20.0, 75.0)),
        4 => set_up.start = Some(48.0),
        _ => {}
    }
    let sensors: Vec<f64> = [0.1, 0.5, 0.9].map(|share| decimals(share * length, 0)).to_vec();
    let seen = (0..sensors.len()).map(Seen::Temperature).chain([Seen::Elongation]);
    let rows = (1..=10)
        .flat_map(|k| seen.clone().map(move |seen| Row { change: 0.0, time: 12.0 * f64::from(k), seen }))
        .collect();
    let mut job = Job {
        segments,
        source: (if scene == 2 { decimals(0.8 * length, 0) } else { length }, 12.0, 0.0, 55.0),
        ambient: 21.0,
        end,
        sensors,
        rows,
        kelvin: 0.05,
        noise: NoiseKind::Neither,
        shown: if scene == 0 { Vec::new() } else { COMPANY.to_vec() },
        set_up,
    };
    job.shown.retain(|shown| !effects.contains(&shown.effect));
    let causes = job.causes(&job.shown.iter().map(|s| s.written).collect::<Vec<_>>());
    let loses = effects.iter().any(|effect| ["convection", "base-conductance"].contains(effect));
    let admits = |effect: &str| if effect == "ambient-drift" && loses { true } else { job.admits(effect, &causes) };
    effects.iter().all(|effect| admits(effect)).then_some(job)
}
