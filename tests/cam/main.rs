//! Cams against brute force, and causes hidden in what brute force has ground.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod brute;
mod hidden;

use brute::{Causes, Job, Segment};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::Model;

/// The cam that the program's starting model has: two arcs and two flanks. Steps are of `step` mm.
fn starting_cam(step: f64, is_reversed: bool, speed: f64) -> Job {
    use std::f64::consts::PI;
    let segments = [
        Segment::Arc([0.0, 0.0], 14.0, 0.0, PI),
        Segment::Line([-14.0, 0.0], [-14.0, -20.0]),
        Segment::Arc([0.0, -20.0], 14.0, PI, PI),
        Segment::Line([14.0, -20.0], [14.0, 0.0]),
    ];
    let count = |length: f64| (length / step - 1e-9).ceil() as usize;
    let counts = [count(14.0 * PI), count(20.0), count(14.0 * PI), count(20.0)];
    Job { segments: segments.into_iter().zip(counts).collect(), wheel: 175.0, speed, is_reversed }
}

/// The program's model of the same cam.
fn model(step: f64, effects: &str) -> Model {
    let text = fem::processes::ALL.iter().find(|p| p.name() == "cam").unwrap().starting_model();
    let text = text.split("[effects").next().unwrap().replace("\"0.5 mm\"", &format!("\"{step} mm\""));
    Model::parse(Source::new("cam.toml", format!("{text}\n{effects}"))).unwrap()
}

/// A revolution a second, as a third of which the model turns.
const SPEED: f64 = 20.0 * std::f64::consts::TAU / 60.0;

/// The cam ground by brute force, as a measurement file with noise (um).
fn measured(job: &Job, causes: &Causes, sigma: f64, seed: u64) -> String {
    let angles: Vec<f64> = (0..240).map(|i| (1.5 * f64::from(i) + 0.4).to_radians()).collect();
    let mut noise = brute::Noise::new(seed);
    let rpm = job.speed * 60.0 / std::f64::consts::TAU;
    let direction = if job.is_reversed { "reverse" } else { "forward" };
    let mut text = String::from("angle [deg],cam_speed [rpm],direction,deviation [um],u [um]\n");
    for (angle, deviation) in angles.iter().zip(job.deviations(causes, &angles)) {
        let value = 1e3 * deviation + sigma * noise.normal();
        text.push_str(&format!("{},{rpm},{direction},{value},{}\n", angle.to_degrees(), sigma.max(1e-6)));
    }
    text
}

#[test]
fn every_effect_grinds_what_brute_force_grinds() {
    let none = Causes::default();
    // 10 N/(mm²/s)·0.02 mm over 4 N/um is 5e-5 mm per mm/s.
    let cases = [
        ("", none),
        ("[effects.wheel-wear]\nloss = \"80 um\"", Causes { loss: 0.08, ..none }),
        ("[effects.servo-lag]\ntime = \"3 ms\"", Causes { lag: 3e-3, ..none }),
        ("[effects.servo-lag]\ntime = \"-7 ms\"", Causes { lag: -7e-3, ..none }),
        ("[effects.infeed-backlash]\ngap = \"35 um\"", Causes { gap: 0.035, ..none }),
        ("[effects.centre-height]\nheight = \"-400 um\"", Causes { height: -0.4, ..none }),
        ("[effects.grinding-deflection]\nstiffness = \"4 N/um\"", Causes { yielding: 5e-5, ..none }),
        (
            "[effects.infeed-backlash]\ngap = \"35 um\"\n[effects.servo-lag]\ntime = \"3 ms\"\n[effects.wheel-wear]\nloss = \"20 um\"\n[effects.centre-height]\nheight = \"100 um\"",
            Causes { gap: 0.035, lag: 3e-3, loss: 0.02, height: 0.1, yielding: 0.0 },
        ),
    ];
    for step in [0.5, 4.0] {
        for (is_reversed, speed) in [(false, SPEED), (true, 0.4 * SPEED)] {
            for (effects, causes) in &cases {
                let job = starting_cam(step, is_reversed, speed);
                let model = model(step, effects);
                let text = measured(&job, causes, 0.0, 1);
                let rows = Measurements::parse(Source::new("m.csv", text), &*model.process).unwrap();
                let predicted = model.forward().observe(&rows.rows).unwrap();
                // Brute force puts the wheel down in even steps: what it misses between them is of the
                // order of their length, more where play ends between two.
                let worst = predicted.iter().zip(&rows.observed).map(|(p, o)| (p - o).abs()).fold(0.0, f64::max);
                assert!(worst < 4e-8 * step, "{step} {is_reversed} {effects}: {worst:e}");
            }
        }
    }
}

/// Half as long steps err by a quarter, and blocks as long as a tolerance allows keep it with the fewest.
#[test]
fn the_fewest_blocks_keep_the_tolerance() {
    let text = |program: &str| {
        let model = fem::processes::ALL.iter().find(|p| p.name() == "cam").unwrap().starting_model();
        model.split("[effects").next().unwrap().replace("step = \"0.5 mm\"", program)
    };
    let run = |program: &str| {
        let model = Model::parse(Source::new("cam.toml", text(program))).unwrap();
        let report = model.run(&fem::progress::Progress::default()).unwrap().report;
        let value = |key: &str, of: &str| report.figures.iter().find(|f| f.key == key).unwrap().value_at(of).unwrap();
        let error = value("largest", "value").max(-value("smallest", "value"));
        (value("program", "blocks") as usize, error)
    };
    for tolerance in [20.0, 3.0] {
        let (blocks, error) = run(&format!("tolerance = \"{tolerance} um\""));
        assert!(error <= tolerance * (1.0 + 1e-6), "{error} of {tolerance}");
        // Equal blocks of the same number do worse.
        assert!(run(&format!("blocks = {blocks}")).1 > tolerance);
        let (finer, _) = run(&format!("tolerance = \"{} um\"", tolerance / 4.0));
        // Each of the three segments that err is rounded up by a block.
        assert!(finer >= 2 * blocks - 8 && finer <= 2 * blocks + 4, "{blocks} {finer}");
    }
}

/// One block fewer on a segment does not keep the tolerance, whichever way it is divided: equal blocks are
/// best where blocks are alike.
#[test]
fn one_block_fewer_fails() {
    // A circle beside the axis in so many equal blocks by its symmetry: the tolerance is what n blocks
    // need, so n − 1 err more.
    let circle = |program: &str| {
        format!(
            "process = \"cam\"\n[profile]\nstart = [\"14 mm\", \"20 mm\"]\nsegments = [{{ line = {{ to = [\"-14 mm\", \"20 mm\"] }} BLOCKS }}, {{ arc = {{ centre = [\"-14 mm\", \"0 mm\"], sweep = \"180 deg\" }}, blocks = 400 }}, {{ line = {{ to = [\"14 mm\", \"-20 mm\"] }}, blocks = 400 }}, {{ arc = {{ centre = [\"14 mm\", \"0 mm\"], sweep = \"180 deg\" }}, blocks = 400 }}]\n[wheel]\nradius = \"175 mm\"\n[program]\ncam_speed = \"20 rpm\"\n{program}"
        )
    };
    let on_flank = |text: String| {
        let model = Model::parse(Source::new("cam.toml", text)).unwrap();
        let report = model.run(&fem::progress::Progress::default()).unwrap().report;
        let segments = report.figures.iter().find(|f| f.key == "segments").unwrap();
        (segments.value_at("list/0/blocks").unwrap() as u64, segments.value_at("list/0/largest").unwrap())
    };
    for count in [2, 3, 7] {
        // The flank's blocks are nearly alike, so that equal ones err as little as so many can, to a percent.
        let equal = on_flank(circle("step = \"1 mm\"").replace("BLOCKS", &format!(", blocks = {count}"))).1;
        let fewest =
            |part: f64| on_flank(circle(&format!("tolerance = \"{} um\"", part * equal)).replace("BLOCKS", "")).0;
        assert_eq!((fewest(1.02), fewest(0.98)), (count, count + 1));
    }
}
