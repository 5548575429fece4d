//! Every two effects of every process, in every way of holding, against the generator, which puts each machine together
//! as one equilibrium of its own.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use fem::compare::compare;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use generator::meeting::Meeting;
use generator::{AXIS, CAM, CONTOUR, FIXTURE, Process, RING, STIFFNESS, THERMAL, TURNING};

/// How far the program is off the generator, as a part of the range of what is measured.
fn apart(meeting: &Meeting) -> Result<f64, String> {
    let model = Model::parse(Source::new("pair.toml", meeting.model.clone())).map_err(|e| format!("{e:?}"))?;
    let source = Source::new("pair.csv", meeting.data.clone());
    let measured = Measurements::parse(source, model.process).map_err(|e| format!("{e:?}"))?;
    let data = Data::of(&model, measured).map_err(|e| format!("{e:?}"))?;
    let compared = compare(&data).map_err(|e| e.to_string())?;
    let largest = compared.residuals.iter().fold(0.0f64, |most, r| most.max(r.abs()));
    let all = |of: fn(f64, f64) -> f64, start: f64| data.observed.iter().copied().fold(start, of);
    Ok(largest / (all(f64::max, f64::NEG_INFINITY) - all(f64::min, f64::INFINITY)))
}

#[test]
fn measure() {
    let only = std::env::var("FEM_PROCESS").unwrap_or_default();
    let every: usize = std::env::var("FEM_EVERY").ok().and_then(|n| n.parse().ok()).unwrap_or(1);
    for process in [&TURNING, &RING, &STIFFNESS, &AXIS, &CONTOUR, &FIXTURE, &THERMAL, &CAM] as [&Process; 8] {
        if !only.is_empty() && process.name.trim() != only {
            continue;
        }
        let start = std::time::Instant::now();
        let (mut count, mut worst, mut bad) = (0, 0.0f64, 0);
        let mut number = 0;
        for pair in process.pairs() {
            for scene in 0..process.scenes.len() {
                number += 1;
                if number % every != 0 {
                    continue;
                }
                let Some(meeting) = process.meeting(&pair, scene, 1) else { continue };
                count += 1;
                match apart(&meeting) {
                    Ok(off) => {
                        worst = worst.max(off);
                        if off > 2e-5 {
                            bad += 1;
                            println!("{off:.1e} {} {} in {}", pair[0], pair[1], meeting.scene);
                        }
                    }
                    Err(error) => {
                        bad += 1;
                        println!("error {} {} in {}: {error}", pair[0], pair[1], meeting.scene);
                    }
                }
            }
        }
        println!("== {}: {count} meetings, {bad} bad, worst {worst:.1e}, {:.1} s", process.name, start.elapsed().as_secs_f64());
    }
}
