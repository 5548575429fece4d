//! Fitting the effects that are really there.

use fem::fit::{fit, fitted_text};
use fem::input::Source;
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
    let fitted = fit(&hidden.data()).unwrap();
    let text = fitted_text(&hidden.data(), &fitted);
    let model = Model::parse(Source::new("fitted.toml", text.clone())).unwrap();
    assert!(model.require_values().is_ok());
    assert_eq!(model.parameters.len(), hidden.model.parameters.len(), "uncertainties stand in the file");
    let predicted = model.system.with_effects(&model.effects).observe(&hidden.measurements.rows).unwrap();
    // Values are written to two digits of their uncertainty, so predictions agree to a part of the noise.
    for (a, b) in predicted.iter().zip(&fitted.predicted) {
        assert!((a - b).abs() < 0.5 * fitted.noise.rms(), "{a} and {b}");
    }
    // Everything but the values stays.
    let untouched = |text: &str| {
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
