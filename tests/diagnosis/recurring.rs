//! What comes again is no noise, and a clock takes nothing away: data written here, by the laws alone.

use std::f64::consts::TAU;

use fem::diagnose::{Cause, Diagnosis, MOST_EFFECTS, Missing, Verdict};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;
use generator::random::Random;
use generator::{AXIS, Case, TURNING};

use crate::score::{self, diagnose};

const JOINT: &str = r#"process = "stiffness"
[joint]
stiffness = "60 +- 10 N/um"
[test]
max_force = "800 N""#;

const FEED_AXIS: &str = r#"process = "axis"
[axis]
travel = "500 mm"
[screw]
material = "steel"
diameter = "32 mm"
lead = "10 mm"
fixed_at = "0 mm"
[test]
positions = 11
runs = 5"#;

fn diagnosed<R>(model: &str, rows: &str, tell: impl Fn(&Diagnosis) -> R) -> R {
    let model = Model::parse(Source::new("model.toml", model)).unwrap();
    let read = Measurements::parse(Source::new("rows.csv", rows), &*model.process).unwrap();
    let data = Data::of(&model, read).unwrap();
    tell(&diagnose(&data, MOST_EFFECTS, &Progress::default()).unwrap())
}

fn names(d: &Diagnosis) -> Vec<String> {
    d.missing.iter().map(|m| m.effect.name.to_string()).collect()
}

/// A spring of 60 N/um loaded to 800 N and let go again, with a wave of two periods over the force, read to 0.2 um.
fn with_a_wave(seed: u64, cycles: usize) -> String {
    let mut random = Random::new("wave over the force", seed);
    let phase = random.uniform(0.0, TAU);
    let mut rows = String::from("force [N],branch,displacement [um],u [um]\n");
    for _ in 0..cycles {
        for (branch, forces) in [("load", (1..=24).collect::<Vec<_>>()), ("unload", (1..=24).rev().collect())] {
            for step in forces {
                let force = 800.0 * f64::from(step) / 24.0;
                let shown = force / 60.0 + 1.3 * (TAU * 2.0 * force / 800.0 + phase).sin() + 0.2 * random.normal();
                rows += &format!("{force},{branch},{shown},0.2\n");
            }
        }
    }
    rows
}

/// Neighbours agree with each other as if the noise had a memory, and one branch with the other as no noise does.
#[test]
fn a_wave_that_comes_again_on_the_other_branch_is_no_noise() {
    for (seed, cycles) in (0..8).flat_map(|seed| [(seed, 1), (seed, 2)]) {
        diagnosed(JOINT, &with_a_wave(seed, cycles), |d| {
            let said = names(d);
            println!("{seed}, {cycles}: {:?} {said:?}", d.verdict);
            assert!(d.leaves_structure(), "{seed}, {cycles}: {:?} {said:?}", d.verdict);
            assert!(!said.iter().any(|name| name == "correlated-noise" || name == "uncertainty-scale"), "{said:?}");
            assert!(d.missing.iter().all(|m| m.cause != Cause::Physical), "{said:?}");
        });
    }
}

/// Every place has an error of its own, rough from one to the next and the same in every run: `u` is not too small.
#[test]
fn errors_of_places_that_come_again_in_every_run_are_no_noise() {
    for seed in 0..6 {
        let mut random = Random::new("errors of places", seed);
        let errors: Vec<f64> = (0..12).map(|_| 5.0 * random.normal()).collect();
        let mut rows = String::from("position [mm],direction,run,deviation [um],u [um]\n");
        for run in 1..=4 {
            for (place, error) in errors.iter().enumerate() {
                let position = 3.0 + 41.3 * place as f64;
                rows += &format!("{position},+,{run},{},1\n", error + random.normal());
            }
        }
        diagnosed(FEED_AXIS, &rows, |d| {
            println!("{seed}: {:?} {:?}", d.verdict, names(d));
            assert!(d.leaves_structure(), "{seed}: {:?} {:?}", d.verdict, names(d));
            assert!(!names(d).iter().any(|name| name == "uncertainty-scale" || name == "correlated-noise"));
        });
    }
}

/// Noise with a memory, and a `u` that is too small, come with every branch anew: they are told, and the model is complete.
#[test]
fn noise_with_a_memory_is_still_noise() {
    for seed in 0..6 {
        let mut random = Random::new("memory", seed);
        let mut rows = String::from("force [N],branch,displacement [um],u [um]\n");
        let mut off = 0.0;
        for (branch, forces) in [("load", (1..=40).collect::<Vec<_>>()), ("unload", (1..=40).rev().collect())] {
            for step in forces {
                let force = 20.0 * f64::from(step);
                off = 0.7 * off + (1.0f64 - 0.49).sqrt() * random.normal();
                rows += &format!("{force},{branch},{},1\n", force / 60.0 + off);
            }
        }
        diagnosed(JOINT, &rows, |d| {
            println!("{seed}: {:?} {:?}", d.verdict, names(d));
            let said = names(d);
            assert_eq!(
                (d.verdict, &said[..]),
                (Verdict::MissingEffect, &["correlated-noise".to_string()][..]),
                "{seed}"
            );
        });
    }
}

/// Bores of rings that are off by the same whenever a speed comes again: the machine's, and no gauge's.
#[test]
fn what_a_condition_makes_is_no_instrument() {
    const RING: &str = r#"process = "ring"
[workpiece]
material = "steel"
outer_diameter = "100 mm"
inner_diameter = "84 mm"
width = "20 mm"
[chuck]
jaws = 3
jaw_force = "3 kN"
[cut]
spindle_speed = "400 rpm"
[measurement]
reference = "absolute""#;
    let model = Model::parse(Source::new("ring.toml", RING)).unwrap();
    let read = |text| Measurements::parse(Source::new("rows.csv", text), &*model.process).unwrap();
    for seed in 0..4 {
        let mut random = Random::new("condition", seed);
        let speeds = [200, 400, 600, 800].map(|speed| (speed, 4.0 * random.normal()));
        let rows = |value: &mut dyn FnMut(usize, f64) -> f64| {
            let mut text = String::from("angle [deg],spindle_speed [rpm],deviation [um],u [um]\n");
            for (number, (speed, off)) in speeds.into_iter().enumerate() {
                let line = |i: usize| format!("{},{speed},{},0.5\n", 10 * i, value(36 * number + i, off));
                text += &(0..36).map(line).collect::<String>();
            }
            text
        };
        let ideal = model.forward().observe(&read(rows(&mut |_, _| 0.0)).rows).unwrap();
        let text = rows(&mut |row, off| 1e6 * ideal[row] + off + 0.5 * random.normal());
        diagnosed(RING, &text, |d| {
            println!("{seed}: {:?} {:?}", d.verdict, names(d));
            let is_zero_by_speed = |m: &Missing| {
                matches!(&m.cause, Cause::Measurement { by, .. } if by.len() == 1 && *by[0] == *"spindle_speed")
                    && !m.describes()
            };
            assert!(!d.missing.iter().any(is_zero_by_speed), "{seed}: {:?}", names(d));
        });
    }
}

/// A servo's play, or the turns of its screw, with approaches that alternate or go there and back.
fn of_an_axis(seed: u64, alternate: bool, is_play: bool) -> [String; 2] {
    let mut random = Random::new("clock", seed);
    let phase = random.uniform(0.0, TAU);
    let count = if is_play { 11 } else { 41 };
    let places: Vec<f64> = (0..count).map(|i| 500.0 * f64::from(i) / f64::from(count - 1)).collect();
    let mut rows = Vec::new();
    for run in 1..=3 {
        let there = places.iter().map(|x| (*x, '+'));
        let order: Vec<(f64, char)> = match alternate {
            true => places.iter().flat_map(|x| [(*x, '+'), (*x, '-')]).collect(),
            false => there.chain(places.iter().rev().map(|x| (*x, '-'))).collect(),
        };
        for (x, direction) in order {
            let law = match is_play {
                true if direction == '-' => -23.0,
                true => 0.0,
                false => 6.0 * (TAU * x / 10.0 + phase).sin(),
            };
            rows.push((x, direction, run, law + random.normal()));
        }
    }
    [true, false].map(|timed| {
        let mut text =
            format!("position [mm],direction,run,deviation [um],u [um]{}\n", if timed { ",time [s]" } else { "" });
        for (number, (x, direction, run, value)) in rows.iter().enumerate() {
            let time = if timed { format!(",{}", 20 * number) } else { String::new() };
            text += &format!("{x},{direction},{run},{value},1{time}\n");
        }
        text
    })
}

#[test]
fn a_clock_takes_nothing_from_directions_and_places() {
    for (seed, alternate, is_play) in
        (0..3).flat_map(|seed| [(seed, true, true), (seed, false, true), (seed, true, false), (seed, false, false)])
    {
        let wanted = if is_play { "backlash" } else { "periodic-error" };
        for text in of_an_axis(seed, alternate, is_play) {
            diagnosed(FEED_AXIS, &text, |d| assert_eq!(names(d), [wanted], "{seed} {alternate}"));
        }
    }
}

/// Turns of a screw along a single pass in which times rise with the places: what a clock says, the places say.
#[test]
fn turns_of_a_screw_in_one_pass_are_no_growth() {
    for seed in 0..4 {
        let mut random = Random::new("one pass", seed);
        let phase = random.uniform(0.0, TAU);
        let line = |i: i32, random: &mut Random| {
            let x = 500.0 * f64::from(i) / 160.0;
            let off = 4.0 * (TAU * x / 10.0 + phase).sin() + 0.03 * x + random.normal();
            format!("{x},+,{off},1,{}\n", 3.3 * f64::from(i + 1))
        };
        let rows: String = (0..=160).map(|i| line(i, &mut random)).collect();
        let head = "position [mm],direction,deviation [um],u [um],time [s]\n";
        diagnosed(FEED_AXIS, &format!("{head}{rows}"), |d| {
            let said = names(d);
            println!("{seed}: {said:?}");
            assert!(said.iter().any(|name| name == "periodic-error"), "{said:?}");
            assert!(!said.iter().any(|name| name == "thermal-growth" || name == "wave"), "{said:?}");
        });
    }
}

/// A hundredth of a turn is a curve, and any curve is like it.
#[test]
fn a_small_part_of_a_turn_is_no_periodic_error() {
    let model = FEED_AXIS.replace("500 mm", "10 mm").replace("lead = \"10 mm\"", "lead = \"1000 mm\"");
    for seed in 0..4 {
        let mut random = Random::new("part of a turn", seed);
        let line = |i: i32, random: &mut Random| {
            let x = 10.0 * f64::from(i) / 40.0;
            format!("{x},+,{},1\n", 20.0 * (x / 10.0).powi(2) + random.normal())
        };
        let rows: String = (0..=40).map(|i| line(i, &mut random)).collect();
        diagnosed(&model, &format!("position [mm],direction,deviation [um],u [um]\n{rows}"), |d| {
            assert!(d.posterior.of("periodic-error") < 0.05, "{seed}: {}", d.posterior.of("periodic-error"));
            assert!(!names(d).iter().any(|name| name == "periodic-error"), "{seed}: {:?}", names(d));
        });
    }
}

/// The case without its clock, where it has one that need not be told.
fn without_clock(case: &Case) -> Option<Case> {
    let head = case.data.lines().next()?;
    let clock = head.split(',').position(|name| name.starts_with("time ["))?;
    let cells = |line: &str| {
        let cells = line.split(',').enumerate().filter(|(i, _)| *i != clock);
        cells.map(|(_, cell)| cell).collect::<Vec<_>>().join(",") + "\n"
    };
    Some(Case { data: case.data.lines().map(cells).collect(), ..case.clone() })
}

/// The case with a clock: the times at which the model itself takes its rows to be made, or where it knows none, readings
/// half a minute apart. None where it has a clock already.
fn with_clock(case: &Case) -> Option<Case> {
    let head = case.data.lines().next()?;
    let model = Model::parse(Source::new("case.toml", case.model.clone())).unwrap();
    let time = model.process.coordinates().iter().position(|c| c.name == *"time")?;
    let rows = Measurements::parse(Source::new("case.csv", case.data.clone()), &*model.process).unwrap().rows;
    let times = model.system.resolved(&rows).columns[time].to_vec();
    let is_told = head.split(',').any(|name| name.starts_with("time ["));
    let own = |row: usize| if times[row] > 0.0 { times[row] / 60.0 } else { 0.5 * row as f64 };
    let line = |(row, line): (usize, &str)| format!("{line},{}\n", own(row));
    let rows: String = case.data.lines().skip(1).enumerate().map(line).collect();
    (!is_told).then(|| Case { data: format!("{head},time [min]\n{rows}"), ..case.clone() })
}

/// Of every process whose times need not be told, the same data with and without them: with them no less is named.
#[test]
fn times_are_never_worse_than_none() {
    let (mut all, mut worse) = ([0; 2], Vec::new());
    // Lathes have many effects, of which every fifth will do.
    for (number, (process, every)) in [(&AXIS, 1), (&TURNING, 5)].into_iter().enumerate() {
        for (law, ..) in process.laws.iter().step_by(every) {
            let Some(case) = process.single(law, 40.0, 0) else { continue };
            let both = match without_clock(&case) {
                Some(bare) => Some((case, bare)),
                None => with_clock(&case).map(|timed| (timed, case)),
            };
            let Some((timed, bare)) = both else { continue };
            all[number] += 1;
            worse.extend(lost(&timed, &bare).map(|lost| format!("{} {law}: {lost}", process.name)));
        }
    }
    assert!(all[0] >= 8 && all[1] >= 4 && worse.is_empty(), "{all:?}: {worse:#?}");
}

/// What is hidden and named without times, and with them is not.
fn lost(case: &Case, bare: &Case) -> Option<String> {
    let named = |d: &Diagnosis| d.missing.iter().flat_map(score::class).map(str::to_string).collect::<Vec<_>>();
    let (with, without) = (named(&score::diagnosis(case).ok()?), named(&score::diagnosis(bare).ok()?));
    let hidden = case.truth.hidden.iter().map(|hidden| hidden.effect.to_string());
    let mut lost = hidden.filter(|name| without.contains(name) && !with.contains(name));
    lost.next().map(|name| format!("{name} is named without times ({without:?}), not with them ({with:?})"))
}
