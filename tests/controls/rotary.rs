//! Rotary axes: the controls that take angles are read in degrees, and move an axis with a known error.

use fem::compensate::{Compensation, compensate};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};

use super::axis::files;
use super::{linuxcnc, siemens};

/// Actual less commanded angle (deg) at an angle (deg): a wheel off its axis by 20 seconds of arc, and 9 lost.
fn error(angle: f64, forward: bool) -> f64 {
    (20.0 * (angle + 40.0).to_radians().sin() + if forward { 0.0 } else { 9.0 }) / 3600.0
}

/// Targets each 15 degrees, two runs; the axis begins at `from` and goes `range` far (deg).
fn found(from: f64, range: f64) -> (Vec<f64>, Compensation) {
    let text = format!(
        "process = \"rotary\"\naxis = {{ range = \"{range} deg\", from = \"{from} deg\" }}\n\
         drive = {{ type = \"worm\", teeth = 90 }}\n"
    );
    let model = Model::parse(Source::new("rotary.toml", text)).unwrap();
    let targets: Vec<f64> = (0..=(range / 15.0) as u32).map(|i| from + 15.0 * f64::from(i)).collect();
    let mut rows = String::from("run,angle [deg],direction,deviation [arcsec]\n");
    for run in [1, 2] {
        for at in &targets {
            for (sign, forward) in [("+", true), ("-", false)] {
                rows.push_str(&format!("{run},{at},{sign},{}\n", 3600.0 * error(*at, forward)));
            }
        }
    }
    let measured = Measurements::parse(Source::new("m.csv", rows), &*model.process).unwrap();
    let data = Data::of(&model, measured).unwrap();
    (targets, compensate(&data, model.system.positioning().unwrap()).unwrap())
}

/// A part of a turn, and a whole one, which the table of a SINUMERIK repeats.
#[test]
fn angles_are_met_in_degrees() {
    /// Roundings of a value and of one for backlash, and the change of the error over what is added, deg.
    const LEFT: f64 = 3e-6;
    for (from, range) in [(-90.0, 180.0), (0.0, 360.0)] {
        let (targets, found) = found(from, range);
        for (control, read) in
            [("linuxcnc", linuxcnc::read as fn(&_) -> _), ("siemens-eec", siemens::eec), ("siemens-cec", siemens::cec)]
        {
            let files = files(control, &found).unwrap();
            let added = read(&files);
            let left: Vec<f64> = targets
                .iter()
                .flat_map(|at| [true, false].map(|forward| added(*at, forward) + error(*at, forward)))
                .collect();
            let (low, high) =
                left.iter().fold((f64::MAX, f64::MIN), |(low, high), own| (low.min(*own), high.max(*own)));
            assert!(high - low < LEFT, "{control}, {range} deg: {:?}", (low, high));
            // The zero may be another, half a turn of the wave at most.
            assert!(low.abs().max(high.abs()) < 20.0 / 3600.0 + LEFT, "{control}: {low} to {high}");
        }
    }
}
