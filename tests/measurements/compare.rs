//! Where a model fails.

use fem::compare::{Comparison, Trend, compare};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::noise::NoiseSource;

use super::{case, truths};

const MODEL: &str = r#"
process = "turning"
workpiece = { material = "steel", segments = [{ length = "500 mm", diameter = "40 mm" }] }
workholding = { type = "centres" }
cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "600 rpm", radial_force = "400 N" }
batch = { parts = 10, cycle_time = "6 min" }
"#;

/// Rows at 11 places on 10 parts: P·x²(L − x)²/3EIL twice, what `more` adds (um), and noise of 1 um.
fn measured(header: &str, more: impl Fn(f64, f64) -> f64, cells: impl Fn(f64) -> String) -> Measurements {
    let ei = 210e9 * std::f64::consts::PI * 0.04f64.powi(4) / 64.0;
    let kappa_ga = 6.0 * 1.3 / 8.8 * 210e9 / 2.6 * std::f64::consts::PI * 0.04f64.powi(2) / 4.0;
    let mut text = format!("# made for a test\npart,x [mm],{header}\n");
    let mut state = 7u64;
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    for part in 1..=10 {
        for i in 0..=10 {
            let x = 0.05 * f64::from(i);
            let b = 0.5 - x;
            let bending = 400.0 * (x * x * b * b / (3.0 * ei * 0.5) + x * b / (0.5 * kappa_ga));
            // Twelve uniform numbers add up to a variance of one.
            let noise: f64 = (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
            let error = 2e6 * bending + more(x, f64::from(part)) + noise;
            text.push_str(&format!("{part},{},{}\n", 1e3 * x, cells(error)));
        }
    }
    let model = Model::parse(Source::new("model.toml", MODEL)).unwrap();
    Measurements::parse(Source::new("measured.csv", text), &*model.process).unwrap()
}

fn with_u(more: impl Fn(f64, f64) -> f64) -> Measurements {
    measured("diameter_error [um],u [um]", more, |error| format!("{error},1"))
}

fn model() -> Model {
    Model::parse(Source::new("model.toml", MODEL)).unwrap()
}

fn compared(measurements: Measurements) -> Comparison {
    compare(&Data::of(&model(), measurements).unwrap()).unwrap()
}

#[test]
fn the_right_model_is_adequate() {
    let comparison = compared(with_u(|_, _| 0.0));
    assert!(comparison.adequate(), "{comparison:?}");
    assert_eq!(comparison.noise.source, NoiseSource::Column);
    // 110 rows of noise 1: the mean square scatters by √(2/110) = 0.13.
    assert!((comparison.reduced_chi2 - 1.0).abs() < 0.4);
    // The same without u: the noise is found, and no size is judged by it.
    let blind = measured("diameter_error [um]", |_, _| 0.0, |error| format!("{error}"));
    let comparison = compared(blind);
    assert_eq!((comparison.noise.source, comparison.p_value), (NoiseSource::Estimated, None));
    assert!((1e6 * comparison.noise.rms() - 1.0).abs() < 0.4, "{}", comparison.noise.rms());
    assert!(comparison.adequate(), "{:?} {:?}", comparison.features, comparison.suspects);
}

#[test]
fn each_failing_is_found_where_it_is() {
    type More = fn(f64, f64) -> f64;
    let cases: [(More, &str, &str); 5] = [
        (|_, part| 2.5 * part, "part", "linear"),
        (|x, _| 40.0 * x, "x", "linear"),
        (|x, _| 160.0 * x * (0.5 - x), "x", "quadratic"),
        (|_, part| if part > 6.0 { 5.0 } else { 0.0 }, "part", "step"),
        (|x, _| 4.0 * (80.0 * x * x).sin(), "x", "irregular"),
    ];
    for (more, coordinate, shape) in cases {
        let comparison = compared(with_u(more));
        assert!(!comparison.adequate());
        let along: Vec<_> = comparison.features.iter().filter(|f| f.trend.is_some()).collect();
        assert_eq!(along.len(), 1, "{coordinate} {shape}: {:?}", comparison.features);
        assert_eq!((along[0].coordinate.as_str(), along[0].trend.unwrap().word()), (coordinate, shape));
    }
    let comparison = compared(with_u(|_, part| 2.5 * part));
    let part = comparison.features.iter().find(|f| f.coordinate == "part").unwrap();
    let Some(Trend::Linear { slope }) = part.trend else { panic!("{part:?}") };
    // A slope over ten parts of eleven rows is known to 1/√(11·82.5) = 0.033 um per part.
    assert!((slope - 2.5).abs() < 0.15, "{slope}");
    assert!(part.text.starts_with("the error grows by 2."), "{}", part.text);
}

#[test]
fn a_pair_of_coordinates_is_seen_together() {
    let comparison = compared(with_u(|x, part| 16.0 * (x - 0.25) * (part - 5.5)));
    let names: Vec<&str> = comparison.features.iter().map(|f| f.coordinate.as_str()).collect();
    assert_eq!(names, ["x and part"]);
}

#[test]
fn diameters_and_their_errors_are_the_same_observation() {
    let errors = with_u(|x, _| 40.0 * x);
    let diameters = measured("diameter [mm],u [um]", |x, _| 40.0 * x, |error| format!("{:.9},1", 40.0 + 1e-3 * error));
    let (a, b) = (compared(errors), compared(diameters));
    for (a, b) in a.residuals.iter().zip(&b.residuals) {
        // The diameters are written to 1e-9 mm.
        assert!((a - b).abs() < 1e-12, "{a} and {b}");
    }
}

#[test]
fn hidden_effects_make_models_fail() {
    for (name, truth) in truths() {
        let (model, measurements) = case(&name);
        // What leaves values unknown cannot be compared as it is written.
        if model.require_values().is_ok() {
            let comparison = compare(&Data::of(&model, measurements).unwrap()).unwrap();
            assert!(!comparison.adequate(), "{name}: {truth}");
        }
    }
}

/// Of several files one may lack a column, and a bow along it is told of the others.
#[test]
fn a_file_without_a_column_stands_beside_one_with_it() {
    let model = Model::parse(Source::new("model.toml", MODEL)).unwrap();
    let read = |name: &str, text: String| Measurements::parse(Source::new(name, text), &*model.process).unwrap();
    let blank = |i: u32| 41.0 + 0.02 * f64::from(i);
    let bow = |i: u32| 0.5 * (f64::from(i) - 9.5).powi(2);
    let with: String = (0..20).map(|i| format!("100,{},{},1\n", blank(i), bow(i))).collect();
    let without: String = (0..20).map(|i| format!("{},20,1\n", 20 + 20 * i)).collect();
    let files = vec![
        read("with.csv", format!("x [mm],blank [mm],diameter_error [um],u [um]\n{with}")),
        read("without.csv", format!("x [mm],diameter_error [um],u [um]\n{without}")),
    ];
    let data = Data::of(&model, Measurements::joined(files).unwrap()).unwrap();
    let trends: Vec<Trend> = compare(&data).unwrap().features.into_iter().filter_map(|f| f.trend).collect();
    let is_bow = |trend: &Trend| matches!(trend, Trend::Quadratic { at, .. } if (at - blank(9)).abs() < 0.05);
    assert!(trends.iter().any(is_bow), "{trends:?}");
}

/// Half of the rows share a value of each coordinate, twenty of which there are: more pairs than waves are made of.
#[test]
fn values_that_many_rows_share_leave_few_pairs() {
    let model = Model::parse(Source::new("model.toml", MODEL)).unwrap();
    let of = |i: u32, step: u32| if i % (2 * step) < step { 0 } else { (i * 7 + i / 20) % 20 };
    let row = |i: u32| format!("{},{},{},1\n", 100 + 10 * of(i, 1), 300 + 10 * of(i, 2), i % 5);
    let text = format!("x [mm],radial_force [N],diameter_error [um],u [um]\n{}", (0..800).map(row).collect::<String>());
    let measurements = Measurements::parse(Source::new("rows.csv", text), &*model.process).unwrap();
    assert!(!compare(&Data::of(&model, measurements).unwrap()).unwrap().features.is_empty());
}
