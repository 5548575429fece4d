//! Fitting the effects that are really there.

use fem::ask::fitted;
use fem::fit::fit;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};

use super::{case_with_effects, truths};

/// The noise explains what is left (p above 0.1 %: seven cases, of which the worst of a hundred sets of
/// seven would fall lower), and the intervals hold the truth, save one in twenty.
#[test]
fn the_truth_is_in_the_interval_and_nothing_but_noise_is_left() {
    let (mut inside, mut all) = (0, 0);
    for (name, truth) in truths() {
        let hidden = case_with_effects(&name, &truth);
        let fit = fit(&hidden.data()).unwrap();
        if let Some(p) = fit.p_value {
            assert!(p > 1e-3, "{name}: p = {p}");
        }
        // A place on trial may leave the body.
        assert!(20 * fit.failures <= fit.evaluations, "{name}: {} of {}", fit.failures, fit.evaluations);
        for (effect, parameters) in hidden.truth["hidden"].as_object().unwrap() {
            for (key, value) in parameters.as_object().unwrap() {
                let path = format!("effects.{effect}.{key}");
                let estimate = fit.estimates.iter().find(|e| e.parameter.path == path).unwrap();
                let true_value = estimate.parameter.kind.to_si(value["value"].as_f64().unwrap());
                let above = estimate.interval.low.is_none_or(|low| low <= true_value);
                let below = estimate.interval.high.is_none_or(|high| true_value <= high);
                all += 1;
                inside += usize::from(above && below);
            }
        }
    }
    // Intervals of 95 %: of 12 fewer than 10 inside, of 40 fewer than 35, would happen in 2 % of such sets.
    assert!(all >= 12 && inside + 2 + all / 16 >= all, "{inside} of {all}");
}

#[test]
fn a_fitted_model_reads_back_and_leaves_the_same() {
    let (name, truth) = truths().swap_remove(0);
    let hidden = case_with_effects(&name, &truth);
    let found = fit(&hidden.data()).unwrap();
    let text = fitted(&hidden.data(), &found).unwrap().text();
    let model = Model::parse(Source::new("fitted.toml", text.clone())).unwrap();
    assert!(model.require_values().is_ok());
    assert_eq!(model.parameters.len(), hidden.model.parameters.len(), "uncertainties stand in the file");
    let predicted = model.system.with_effects(&model.effects).observe(&hidden.measurements.rows).unwrap();
    // Values are written to two digits of their uncertainty, so predictions agree to a part of the noise.
    for (a, b) in predicted.iter().zip(&found.predicted) {
        assert!((a - b).abs() < 0.5 * found.noise.rms(), "{a} and {b}");
    }
    // Everything but the values stays, and what is known of them together comes behind.
    assert!(text.contains("[known.together]"), "{text}");
    let untouched = |text: &str| {
        let text = text.split("\n[known.together]").next().unwrap();
        text.lines().filter(|l| !(l.contains("+-") || l.contains('?'))).map(str::to_string).collect::<Vec<_>>()
    };
    assert_eq!(untouched(&text), untouched(&hidden.model.source.text));
}

#[test]
fn what_cannot_be_told_apart_is_said() {
    // A taper of the guideway and an offset of the tailstock give the same diameters.
    let (name, truth) = truths().into_iter().find(|(_, t)| t["hidden"].get("tailstock-offset").is_some()).unwrap();
    let hidden = case_with_effects(&name, &truth);
    let text = format!("{}\n[effects.guideway-taper]\nslope = \"? um/m\"\n", hidden.model.source.text);
    let model = Model::parse(Source::new("both.toml", text)).unwrap();
    let fit = fit(&Data::of(&model, hidden.measurements).unwrap()).unwrap();
    let named = |i: usize| {
        fit.estimates[i].parameter.path.contains("taper") || fit.estimates[i].parameter.path.contains("offset")
    };
    assert!(fit.correlated.iter().any(|(i, j, c)| named(*i) && named(*j) && c.abs() > 0.999), "{:?}", fit.correlated);
}

/// Of a model that is linear in its parameter, χ² rises as the square of the distance in standard uncertainties: with
/// n rows of 1 um, a zero is known to 1/√n um.
#[test]
fn the_profile_of_a_linear_parameter_is_a_parabola() {
    let text = "process = \"stiffness\"\n[joint]\nstiffness = \"100 N/um\"\n[test]\nmax_force = \"1000 N\"\nsteps = 20\n\
                [effects.datum-offset]\noffset = \"? um\"\n";
    let model = Model::parse(Source::new("model.toml", text)).unwrap();
    // F/k + 3 um, off by a tenth of a micrometre up and down.
    let row = |i: i32| {
        let force = 50.0 * f64::from(i);
        format!("{force},{},1\n", force / 100.0 + 3.0 + if i % 2 == 0 { 0.1 } else { -0.1 })
    };
    let csv = "force [N],displacement [um],u [um]\n".to_string() + &(1..=16).map(row).collect::<String>();
    let measurements = Measurements::parse(Source::new("measured.csv", csv), &*model.process).unwrap();
    let fit = fit(&Data::of(&model, measurements).unwrap()).unwrap();
    let found = &fit.estimates[0];
    assert!((found.value - 3e-6).abs() < 1e-11, "{}", found.value);
    assert!(found.profile.len() >= 3 && found.profile.is_sorted_by(|a, b| a.0 <= b.0), "{:?}", found.profile);
    for (value, rise) in &found.profile {
        let expected = ((value - 3e-6) / (1e-6 / 4.0)).powi(2);
        assert!((rise - expected).abs() < 1e-3 * (1.0 + expected), "{value}: {rise} and not {expected}");
    }
    // The walk reaches the ends of the interval on either side.
    let far = |beyond: fn(f64, f64) -> bool, end: f64| found.profile.iter().any(|p| beyond(p.0, end));
    assert!(far(|v, end| v <= end * 1.001, found.interval.low.unwrap()));
    assert!(far(|v, end| v >= end * 0.999, found.interval.high.unwrap()));
}
