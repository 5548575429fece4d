//! Small jobs in which any two effects may meet: every way of holding, with and without a steady rest that
//! stands out of line, and what a machine or a blank may be besides.

use super::catalogue::{LAWS, WEARS, admits, yields_beside};
use super::design::STEEL;
use super::job::{Holding, Job, Row, Survey};
use super::set_up::{Holder, Lobe, Pass, Rest, SetUp, Wave};
use super::shaft::{Segment, Shaft};
use crate::job::{NoiseKind, Shown};
use crate::random::{Random, decimals};

/// What a scene has beside the way of holding.
const VARIANTS: usize = 7;

/// Ways of holding, each without and with a rest, each in all variants.
#[rustfmt::skip]
pub const NAMES: &[&str] = &[
    "centres, rigid", "centres, springs", "centres, blank", "centres, passes",
    "centres, lobes", "centres, stepped", "centres, shallow",
    "centres and rest, rigid", "centres and rest, springs", "centres and rest, blank", "centres and rest, passes",
    "centres and rest, lobes", "centres and rest, stepped", "centres and rest, shallow",
    "chuck, rigid", "chuck, springs", "chuck, blank", "chuck, passes",
    "chuck, lobes", "chuck, stepped", "chuck, shallow",
    "chuck and rest, rigid", "chuck and rest, springs", "chuck and rest, blank", "chuck and rest, passes",
    "chuck and rest, lobes", "chuck and rest, stepped", "chuck and rest, shallow",
    "chuck-and-centre, rigid", "chuck-and-centre, springs", "chuck-and-centre, blank", "chuck-and-centre, passes",
    "chuck-and-centre, lobes", "chuck-and-centre, stepped", "chuck-and-centre, shallow",
    "chuck-and-centre and rest, rigid", "chuck-and-centre and rest, springs", "chuck-and-centre and rest, blank", "chuck-and-centre and rest, passes",
    "chuck-and-centre and rest, lobes", "chuck-and-centre and rest, stepped", "chuck-and-centre and rest, shallow",
];

/// Springs (N/um, kN·m/rad) and feedback that are in the model unless they are asked for.
const COMPANY: &[Shown] = &[
    Shown { effect: "headstock-compliance", parameter: "stiffness", written: 55.0, std: 5.0 },
    Shown { effect: "tailstock-compliance", parameter: "stiffness", written: 38.0, std: 5.0 },
    Shown { effect: "carriage-compliance", parameter: "stiffness", written: 45.0, std: 5.0 },
    Shown { effect: "chuck-tilt", parameter: "stiffness", written: 400.0, std: 50.0 },
    Shown { effect: "force-feedback", parameter: "exponent", written: 0.85, std: 0.1 },
];
/// Wear (um/km) of an edge that is changed.
const WORN: Shown = Shown { effect: "tool-wear", parameter: "rate", written: 9.0, std: 1.0 };
/// How many of them do not need a blank.
const SPRINGS: usize = 4;

/// A job of a scene; None where its way of holding does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let (held, variant) = (scene / VARIANTS, scene % VARIANTS);
    let holding = [Holding::Centres, Holding::Chuck, Holding::ChuckAndCentre][held / 2];
    let mut job = plain(holding, variant == 5, random);
    if held % 2 == 1 {
        let rest = Rest {
            at: decimals(job.shaft.length() * random.uniform(0.4, 0.65), 1),
            stiffness: decimals(random.uniform(20.0, 60.0), 1),
            offset: decimals(random.sign() * random.uniform(5.0, 30.0), 1),
        };
        job.set_up.rests.push(rest);
    }
    match variant {
        0 => {}
        1 => job.shown = COMPANY[..SPRINGS].to_vec(),
        _ => job.shown = COMPANY.to_vec(),
    }
    match variant {
        2 => measure_blank(&mut job, random),
        3 => earlier_passes(&mut job, random),
        4 => lobes(&mut job, random),
        6 => shallow(&mut job),
        5 => job.set_up.holder = Some(Holder { overhang: 60.0, width: 20.0, height: 25.0 }),
        _ => {}
    }
    if effects.contains(&"insert-change") && !effects.iter().any(|effect| WEARS.contains(effect)) {
        job.shown.push(WORN);
    }
    // Friction is felt by the joint beside it.
    let present = || effects.iter().copied().chain(job.shown.iter().map(|shown| shown.effect));
    let is_idle = |effect: &&str| effect.ends_with("-friction") && !present().any(|other| yields_beside(effect, other));
    if effects.iter().any(is_idle) {
        return None;
    }
    job.shown.retain(|shown| !effects.contains(&shown.effect) && admits(&job_of(holding), shown.effect));
    effects.iter().all(|effect| LAWS.iter().any(|law| law.0 == *effect) && admits(&job, effect)).then_some(job)
}

/// Anything held so, to ask what it admits.
fn job_of(holding: Holding) -> Job {
    plain(holding, false, &mut Random::new("holding", 0))
}

/// Three parts of a batch with a pause, each measured at eight places; every part is turned with a force of its
/// own.
fn plain(holding: Holding, stepped: bool, random: &mut Random) -> Job {
    // On a chuck alone nobody turns a slender shaft.
    let length = decimals(
        if holding == Holding::Chuck { random.uniform(120.0, 200.0) } else { random.uniform(300.0, 600.0) },
        0,
    );
    let diameter = decimals(random.uniform(40.0, 65.0), 1);
    let segment = |share: f64, factor: f64| Segment {
        length: decimals(length * share, 1),
        diameter: decimals(diameter * factor, 1),
        bore: 0.0,
    };
    let segments = match stepped {
        true => vec![segment(0.25, 1.0), Segment { bore: 20.0, ..segment(0.45, 1.15) }, segment(0.3, 0.85)],
        false => vec![segment(1.0, 1.0)],
    };
    let shaft = Shaft { material: STEEL, segments, shear: !stepped };
    let force = decimals(random.uniform(250.0, 500.0), 0);
    let whole = shaft.length();
    let place = |i: usize| decimals(whole * (0.05 + 0.9 * i as f64 / 7.0), 1);
    let row = |part: usize| {
        let force = decimals(force * [1.0, 0.8, 0.6][part / 4], 1);
        (0..8).map(move |i| Row { part, x: place(i), force, ..Row::default() })
    };
    let rows = [1, 4, 8].into_iter().flat_map(row).collect();
    Job {
        shaft,
        holding,
        depth: decimals(random.uniform(0.5, 1.0), 2),
        feed: 0.2,
        speed: 600.0,
        force,
        forward: false,
        parts: 8,
        cycle: decimals(whole / 120.0 * 1.3 + 1.0, 2),
        pauses: vec![(4, 30.0)],
        rows,
        force_column: true,
        noise: NoiseKind::Neither,
        shown: Vec::new(),
        survey: Some(Survey {
            clearance: 8.0,
            land: vec![(0.0, 0.0), (400.0, 0.06), (2000.0, 0.12), (9000.0, 0.4)],
            spacing: 320.0,
            height: 250.0,
        }),
        set_up: SetUp::default(),
    }
}

/// Every row's blank was measured.
fn measure_blank(job: &mut Job, random: &mut Random) {
    let (wave, cone) = (random.uniform(0.1, 0.3), random.uniform(-0.3, 0.3));
    for row in &mut job.rows {
        let share = row.x / job.shaft.length();
        let excess = wave * (6.0 * share + row.part as f64).cos() + cone * (share - 0.5);
        row.blank = Some(decimals(job.shaft.diameter(row.x) + 2.0 * job.depth * (1.0 + excess), 4));
    }
}

/// Two passes before, from a bar of uneven stock. The force is that of the model in every row.
fn earlier_passes(job: &mut Job, random: &mut Random) {
    job.set_up.passes = vec![Pass { depth: 2.0, force: 900.0 }, Pass { depth: 1.2, force: 600.0 }];
    let phase = decimals(random.uniform(-90.0, 90.0), 0);
    if random.chance(0.5) {
        job.set_up.waves =
            vec![Wave { waves: 3.0, amplitude: 0.4, phase }, Wave { waves: 1.0, amplitude: 0.2, phase: 20.0 }];
    } else {
        job.set_up.points = vec![(0.0, 0.1), (decimals(0.6 * job.shaft.length(), 0), 0.5), (job.shaft.length(), 0.0)];
    }
    // All passes fit into the cycle.
    job.cycle = decimals(3.6 * job.cutting_time() + 1.0, 2);
    job.force_column = false;
    job.rows.iter_mut().for_each(|row| row.force = job.force);
}

/// One pass, of an oval blank with a third lobe, measured across several angles and set to several depths.
fn lobes(job: &mut Job, random: &mut Random) {
    job.set_up.lobes = vec![
        Lobe { lobes: 2, amplitude: 0.15, phase: decimals(random.uniform(-90.0, 90.0), 0) },
        Lobe { lobes: 3, amplitude: 0.1, phase: 15.0 },
    ];
    for (number, row) in job.rows.iter_mut().enumerate() {
        row.angle = 37.0 * (number % 9) as f64;
        row.depth = Some(decimals(job.depth * [1.0, 1.2, 0.8][row.part / 4], 3));
    }
}

/// Finishing cuts of hundredths, which what moves the nose may miss altogether.
fn shallow(job: &mut Job) {
    for (number, row) in job.rows.iter_mut().enumerate() {
        row.depth = Some([0.06, 0.03, 0.045][number % 3]);
    }
}
