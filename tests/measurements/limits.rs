//! Where data end to tell: intervals, values that are written wrongly, data that were used before, and
//! noise that nobody knows. The data are closed forms.

use fem::ask::fitted;
use fem::compare::compare;
use fem::diagnose::Verdict;
use fem::discover::diagnose;
use fem::fit::fit;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;

/// 95 % point of chi-squared with one degree of freedom.
const QUANTILE: f64 = 3.841_458_820_694_124;

fn model(text: &str) -> Model {
    Model::parse(Source::new("model.toml", text.to_string())).unwrap()
}

fn measured(model: &Model, text: String) -> Measurements {
    Measurements::parse(Source::new("measured.csv", text), &*model.process).unwrap()
}

/// Noise of standard deviation one: the golden-ratio sequence through the inverse of a sum of uniforms.
fn noise(i: usize) -> f64 {
    let uniform = |k: usize| (0.618_033_988_749_894_9 * (12 * i + k) as f64 + 0.37 * (i * k) as f64).fract();
    (1..=12).map(uniform).sum::<f64>() - 6.0
}

/// An axis that grows towards a rest that it does not reach while it is looked at: slope and time constant
/// are all but one parameter. At a closed end of an interval, and nowhere nearer, the best fit with the
/// parameter held there has lost the quantile.
#[test]
fn an_interval_ends_where_the_best_of_the_others_has_lost_the_quantile() {
    let written = |slope: &str, time: &str| {
        format!(
            "process = \"axis\"\naxis = {{ travel = \"500 mm\" }}\n\
             screw = {{ material = \"steel\", diameter = \"32 mm\", lead = \"10 mm\", fixed_at = \"0 mm\" }}\n\
             [effects.thermal-growth]\nslope = \"{slope}\"\ntime_constant = \"{time}\"\n"
        )
    };
    let free = model(&written("? um/m", "? min"));
    let mut text = String::from("position [mm],direction,time [min],deviation [um],u [um]\n");
    for (i, t) in (1..=10).map(|i| 2.0 * f64::from(i)).enumerate() {
        let grown = 20.0 * 0.5 * (1.0 - f64::exp(-t / 25.0));
        text.push_str(&format!("500,+,{t},{:.4},0.5\n", grown + 0.5 * noise(i)));
    }
    let data = measured(&free, text);
    let found = fit(&Data::of(&free, data.clone()).unwrap()).unwrap();
    let chi2 = |f: &fem::fit::Fit| {
        let z = data.observed.iter().zip(&f.predicted).map(|(y, p)| (y - p) / 0.5e-6);
        z.map(|z| z * z).sum::<f64>()
    };
    let best = chi2(&found);
    let mut closed = 0;
    for (estimate, slope) in found.estimates.iter().zip([true, false]) {
        let shown = |v: f64| estimate.parameter.kind.from_si(v);
        for end in [estimate.interval.low, estimate.interval.high].into_iter().flatten() {
            closed += 1;
            let held = match slope {
                true => model(&written(&format!("{} um/m", shown(end)), "? min")),
                false => model(&written("? um/m", &format!("{} min", shown(end)))),
            };
            let lost = chi2(&fit(&Data::of(&held, data.clone()).unwrap()).unwrap()) - best;
            // Ends are found to 0.02 in the root of it.
            assert!((lost.sqrt() - QUANTILE.sqrt()).abs() < 0.05, "{}: {lost}", estimate.parameter.path);
        }
    }
    assert!(closed >= 2, "{:?}", found.estimates);
}

/// A spring of 60 N/um that the model has at 40 +- 1.
#[test]
fn a_value_that_the_data_contradict_is_told_and_no_cause_is_made_up_for_it() {
    let wrong =
        model("process = \"stiffness\"\n[joint]\nstiffness = \"40 +- 1 N/um\"\n[test]\nmax_force = \"1200 N\"\n");
    let mut text = String::from("force [N],branch,displacement [um],u [um]\n");
    for i in 1..=24 {
        let force = 50.0 * i as f64;
        text.push_str(&format!("{force},load,{:.4},0.1\n", force / 60.0 + 0.1 * noise(i)));
    }
    let rows = measured(&wrong, text);
    let data = Data::of(&wrong, rows.clone()).unwrap();
    let diagnosis = diagnose(&data, 3, &Progress::default()).unwrap();
    assert_eq!(diagnosis.verdict, Verdict::Adequate, "{:?}", diagnosis.cautions);
    assert!(diagnosis.cautions.iter().any(|c| c.contains("joint.stiffness is written as 40.0 +- 1.0 N/um")));
    let found = fit(&data).unwrap();
    assert!(found.estimates[0].warnings.iter().any(|w| w.contains("from what is written")), "{found:?}");
    // What was fitted to these rows knows them already.
    let again = model(&fitted(&data, &found).unwrap().text());
    assert!(Data::of(&again, rows.clone()).unwrap().was_fitted_before());
    let marked = model(&format!("\u{feff}{}", again.text()));
    assert!(Data::of(&marked, rows.clone()).unwrap().was_fitted_before());
    assert!(!data.was_fitted_before());
    assert!(!Data::of(&again, rows).unwrap().some(|row| row > 0).was_fitted_before());
}

/// Each file's rows are known again: in another order, alone, and by a name that no comment could hold.
#[test]
fn rows_that_were_fitted_are_known_file_by_file() {
    let joint = model("process = \"stiffness\"\n[joint]\nstiffness = \"? N/um\"\n[test]\nmax_force = \"1200 N\"\n");
    let file = |name: &str, from: usize| {
        // Readings of their own: what stood in two files would be copies.
        let reading = |i: usize| i as f64 / 0.6 + 0.1 * noise(20 * from + i);
        let lines = (from..from + 9).map(|i| format!("{},load,{:.4}\n", 100 * i, reading(i)));
        let text = format!("force [N],branch,displacement [um]\n{}", lines.collect::<String>());
        Measurements::parse(Source::new(name, text), &*joint.process).unwrap()
    };
    let [a, b, other] = [file("a\u{7}\n.csv", 1), file("b.csv", 3), file("c.csv", 2)];
    let joined = |files: &[&Measurements]| Measurements::joined(files.iter().map(|file| (*file).clone()).collect());
    let data = Data::of(&joint, joined(&[&a, &b]).unwrap()).unwrap();
    let again = model(&fitted(&data, &fit(&data).unwrap()).unwrap().text());
    for (files, is_known) in [
        (&[&a, &b][..], true),
        (&[&b, &a], true),
        (&[&a], true),
        (&[&b], true),
        (&[&other, &b], true),
        (&[&other], false),
    ] {
        let data = Data::of(&again, joined(files).unwrap()).unwrap();
        assert_eq!(data.was_fitted_before(), is_known, "{}", data.name);
    }
}

/// A wave of 20 um that no model has, where the noise of half a micrometre is not told.
#[test]
fn a_large_structure_shows_though_nobody_tells_the_noise() {
    let plain = model(
        "process = \"axis\"\naxis = { travel = \"500 mm\" }\n\
         screw = { material = \"steel\", diameter = \"32 mm\", lead = \"10 mm\", fixed_at = \"0 mm\" }\n",
    );
    for rows in [20, 60, 400] {
        let mut text = String::from("position [mm],direction,deviation [um]\n");
        for i in 0..rows {
            let x = 500.0 * i as f64 / (rows - 1) as f64;
            let wave = 20.0 * (std::f64::consts::TAU * x / 500.0).sin();
            text.push_str(&format!("{x},+,{:.4}\n", wave + 0.5 * noise(i)));
        }
        let found = compare(&Data::of(&plain, measured(&plain, text)).unwrap()).unwrap();
        assert!(!found.adequate() && !found.features.is_empty(), "{rows} rows");
        assert!(found.features[0].text.contains("along position"), "{}", found.features[0].text);
    }
}
