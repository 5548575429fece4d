//! What an instrument shows: its scale, its characteristic, its clock, its contacts and its filter.

use fem::input::Source;
use fem::measure::Measurements;
use fem::model::Model;

const ROD: &str = r#"
    process = "thermal"
    body = { material = "steel", segments = [{ length = "200 mm", diameter = "20 mm" }] }
    source = [{ at = "200 mm", power = "15 W", on = [["0 min", "90 min"]] }]
    environment = { temperature = "20 degC" }
    time = { end = "180 min", step = "30 s" }
"#;

/// Predictions, degC, at these times (min).
fn shown(instrument: &str, times: &[f64]) -> Vec<f64> {
    let model = Model::parse(Source::new("rod.toml", format!("{ROD}\n{instrument}"))).unwrap();
    let rows: String = times.iter().map(|t| format!("{t},100,20\n")).collect();
    let file = Source::new("rod.csv", format!("time [min],x [mm],temperature [degC]\n{rows}"));
    let rows = Measurements::parse(file, &*model.process).unwrap();
    model.forward().observe(&rows.rows).unwrap().iter().map(|kelvin| kelvin - 273.15).collect()
}

#[test]
fn a_gain_multiplies_and_a_late_clock_shows_what_was_before() {
    let plain = shown("", &[0.0, 10.0, 30.0]);
    let more = shown("measurement.gain.factor = 1.02", &[0.0, 10.0, 30.0]);
    for (plain, more) in plain.iter().zip(&more) {
        assert!((more - 1.02 * plain).abs() < 1e-9, "{more} {plain}");
    }
    let late = shown("measurement.clock.delay = \"5 min\"", &[2.0, 15.0, 35.0]);
    for (plain, late) in plain.iter().zip(&late) {
        assert!((plain - late).abs() < 1e-9, "{late} {plain}");
    }
    let other = shown("measurement.clock = { delay = \"5 min\", observable = \"elongation\" }", &[10.0]);
    // What is asked together is summed together, to 1e-10 of the largest rise.
    assert!((other[0] - plain[1]).abs() < 1e-8, "{other:?} {plain:?}");
}

/// y + offset + (scale − 1)·y + bow·(1 − s²) + s_bend·2.598·(s − s³), worked out by hand: readings above 0 degC, s over 20
/// to 100 degC.
#[test]
fn a_calibration_adds_its_polynomial() {
    let plain = shown("", &[10.0, 30.0, 80.0]);
    let bent = shown(
        "measurement.calibration = { observable = \"temperature\", low = \"20 degC\", high = \"100 degC\", \
         offset = \"0.5 K\", scale = 1.01, bow = \"2 K\", s_bend = \"-1 K\" }",
        &[10.0, 30.0, 80.0],
    );
    for (y, found) in plain.iter().zip(&bent) {
        let s = (y - 60.0) / 40.0;
        let expected = y + 0.5 + 0.01 * y + 2.0 * (1.0 - s * s) - 27f64.sqrt() / 2.0 * (s - s * s * s);
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    }
}

const RING: &str = r#"
    process = "ring"
    workpiece = { material = "steel", outer_diameter = "100 mm", inner_diameter = "84 mm", width = "20 mm" }
    chuck = { jaws = 3, jaw_force = "0 N" }
    [effects]
    residual-stress = { amplitude = "4 um", phase = "20 deg" }
    lobes = { formula = "a*cos(5*angle) + b*cos(angle)", a = "3 um", b = "2 um" }
"#;

/// Predictions of rows of one observable, um, of a bore with two waves of 4 um and five of 3 um around, off its centre.
fn bore(instrument: &str, column: &str, rows: &[f64]) -> Vec<f64> {
    let text = RING.replace("[effects]", &format!("[measurement]\n{instrument}\n[effects]"));
    let model = Model::parse(Source::new("ring.toml", text)).unwrap();
    let rows: String = rows.iter().map(|row| format!("{row},0\n")).collect();
    let first = if column == "RONt" { "run" } else { "angle [deg]" };
    let file = Source::new("ring.csv", format!("{first},{column} [um]\n{rows}"));
    let rows = Measurements::parse(file, &*model.process).unwrap();
    model.forward().observe(&rows.rows).unwrap().iter().map(|m| 1e6 * m).collect()
}

/// Effects of the catalogue and formulas alike: two contacts double even waves and show no odd ones, three show none but
/// multiples of three, and a filter of n_c leaves 2^(−(n/n_c)²).
#[test]
fn gauges_and_filters_show_their_part_of_every_wave() {
    let angles = [0.0, 20.0, 65.0, 123.0];
    let wave = |degrees: f64, n: f64, phase: f64| (n * (degrees - phase).to_radians()).cos();
    for (angle, shown) in angles.iter().zip(bore("", "diameter_error", &angles)) {
        assert!((shown - 8.0 * wave(*angle, 2.0, 20.0)).abs() < 1e-6, "{angle}: {shown}");
    }
    for shown in bore("gauge = \"three-point\"", "diameter_error", &angles) {
        assert!(shown.abs() < 1e-6, "{shown}");
    }
    let absolute = "reference = \"absolute\"\nfilter = 5";
    for (angle, shown) in angles.iter().zip(bore(absolute, "deviation", &angles)) {
        let part = |n: f64| 0.5f64.powf((n / 5.0).powi(2));
        let expected = 4.0 * part(2.0) * wave(*angle, 2.0, 20.0)
            + 3.0 * part(5.0) * wave(*angle, 5.0, 0.0)
            + 2.0 * part(1.0) * wave(*angle, 1.0, 0.0);
        // The weighting function ends where it is 1e-6 of its middle.
        assert!((shown - expected).abs() < 1e-5, "{angle}: {shown} {expected}");
    }
}

/// RONt of a bore is the same whatever its centre: that of 4·cos 2(θ − 20°) + 3·cos 5θ on a thousand places.
#[test]
fn roundness_is_measured_from_its_own_circle() {
    let at = |i: i32| f64::from(i) * std::f64::consts::TAU / 1000.0;
    let form = |a: f64| 4.0 * (2.0 * (a - 20f64.to_radians())).cos() + 3.0 * (5.0 * a).cos();
    let all: Vec<f64> = (0..1000).map(|i| form(at(i))).collect();
    let expected = all.iter().fold(f64::MIN, |a, b| a.max(*b)) - all.iter().fold(f64::MAX, |a, b| a.min(*b));
    let shown = bore("", "RONt", &[1.0, 2.0]);
    // Half a step of 0.5° off a crest of curvature 2²·4 + 5²·3 um, at both ends.
    let bound = 2.0 * 0.5 * 91.0 * 0.25f64.to_radians().powi(2);
    assert!(shown.iter().all(|ront| (ront - expected).abs() < bound), "{shown:?} {expected}");
}
