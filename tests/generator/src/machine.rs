//! Two tests of one lathe, whose tailstock gives way: shafts that were turned on it under one force, and the
//! tailstock itself, loaded and let go again. What the tailstock does is the same in both.

use crate::job::{Job as _, NoiseKind};
use crate::law::Cause;
use crate::random::{Random, figures};
use crate::turning::design::STEEL;
use crate::turning::job::{Holding, Job as Shafts, Row as Place};
use crate::turning::set_up::SetUp;
use crate::turning::shaft::{Segment, Shaft};
use crate::{stiffness, writing};

/// How the tailstock gives way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tailstock {
    /// Stiffness of its spring, N/um; infinite where it has none.
    pub stiffness: f64,
    /// Coefficient (um/N^n) and exponent of its contact, where it has one.
    pub contact: Option<(f64, f64)>,
    /// Whether the model of the shafts knows the spring.
    pub is_known: bool,
}

/// Models and measurements of both tests.
#[derive(Debug, Clone)]
pub struct Tests {
    /// Model of the shafts.
    pub shafts: String,
    /// Measurements of the shafts.
    pub turned: String,
    /// Model of the tailstock under test.
    pub tailstock: String,
    /// Measurements of the tailstock.
    pub loaded: String,
}

/// The file of the lathe.
pub const LATHE: &str = "# What its tests have in common.\n[machine]\nname = \"Lathe 3\"\n\n[machine.headstock]\n\n\
                         [machine.tailstock]\n";

/// Noise of the micrometer, um: a good one, and that of the story.
const GOOD: f64 = 0.8;
const OF_STORY: f64 = 2.0;

/// Noise of the gauge at the tailstock, um.
const GAUGE: f64 = 0.15;

/// Both tests of a tailstock, as a seed has them: the shafts, the force and the noise are drawn.
pub fn drawn(tailstock: Tailstock, seed: u64) -> Tests {
    let mut random = Random::new("two tests", seed);
    let length = figures(random.uniform(350.0, 650.0), 2);
    let diameter = figures(random.uniform(40.0, 70.0), 2);
    let force = figures(random.uniform(300.0, 600.0), 2);
    let most = figures(random.uniform(600.0, 1500.0), 2);
    tests(tailstock, (length, diameter, force), most, GOOD, &mut random)
}

/// The tests of `models/tailstock`: a tailstock whose quill sits badly in its bore.
pub fn story() -> Tests {
    let tailstock = Tailstock { stiffness: f64::INFINITY, contact: Some((0.2, 0.6)), is_known: false };
    tests(tailstock, (500.0, 50.0, 450.0), 800.0, OF_STORY, &mut Random::new("two tests", 0))
}

fn tests(tailstock: Tailstock, shaft: (f64, f64, f64), most: f64, micrometer: f64, random: &mut Random) -> Tests {
    let (shafts, joint) = (shafts(shaft), joint(tailstock, most));
    let mut causes = Vec::new();
    if tailstock.stiffness.is_finite() {
        causes.push(Cause { effect: "tailstock-compliance", parameters: vec![("stiffness", tailstock.stiffness)] });
    }
    let known = if tailstock.is_known { causes.clone() } else { Vec::new() };
    let mut of_joint = Vec::new();
    if let Some((c, n)) = tailstock.contact {
        causes.push(Cause { effect: "tailstock-contact", parameters: vec![("c", c), ("n", n)] });
        of_joint.push(Cause { effect: "contact-joint", parameters: vec![("c", c), ("n", n)] });
    }
    let mut read = |exact: Vec<f64>, sigma: f64| -> Vec<f64> {
        exact.into_iter().map(|value| value + sigma * random.normal()).collect()
    };
    let turned = read(shafts.predict(&causes), micrometer);
    let loaded = read(joint.predict(&of_joint), GAUGE);
    let named = |text: String| text.replacen("process =", "machine = \"lathe.toml\"\nprocess =", 1);
    let stiffness = if tailstock.is_known { format!("{}", tailstock.stiffness) } else { "?".into() };
    let own = format!("[joint]\nunit = \"tailstock\"\nstiffness = \"{stiffness} N/um\"");
    let written = format!("[joint]\nstiffness = \"{} N/um\"", joint.stiffness);
    Tests {
        shafts: named(writing::model(&shafts, None, &known)),
        turned: shafts.data(&turned, micrometer),
        tailstock: named(writing::model(&joint, None, &[]).replacen(&written, &own, 1)),
        loaded: joint.data(&loaded, GAUGE),
    }
}

/// Three shafts between centres, each measured at nine places, turned with the same force.
fn shafts((length, diameter, force): (f64, f64, f64)) -> Shafts {
    let place =
        |part: usize, i: usize| Place { part, x: length * (0.04 + 0.115 * i as f64), force, ..Place::default() };
    Shafts {
        shaft: Shaft {
            material: STEEL,
            segments: vec![Segment { length, diameter, ..Segment::default() }],
            shear: true,
        },
        holding: Holding::Centres,
        depth: 0.5,
        feed: 0.2,
        speed: 600.0,
        force,
        forward: false,
        parts: 3,
        cycle: 8.0,
        pauses: Vec::new(),
        rows: (1..=3).flat_map(|part| (0..9).map(move |i| place(part, i))).collect(),
        force_column: false,
        noise: NoiseKind::Column,
        shown: Vec::new(),
        survey: None,
        set_up: SetUp::default(),
    }
}

/// The tailstock under a force that rises in twenty steps, and falls again.
fn joint(tailstock: Tailstock, most: f64) -> stiffness::Job {
    let row = |unload: bool| move |step: usize| stiffness::Row { force: most * step as f64 / 20.0, unload };
    stiffness::Job {
        stiffness: tailstock.stiffness,
        max_force: most,
        loading: stiffness::Loading::FromZero,
        rows: (0..=20).map(row(false)).chain((0..=20).rev().map(row(true))).collect(),
        noise: NoiseKind::Column,
        shown: Vec::new(),
    }
}
