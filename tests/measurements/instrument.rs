//! What an instrument shows: its scale and its clock.

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
