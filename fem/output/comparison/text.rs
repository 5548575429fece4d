//! Writes a comparison for people.

use std::fmt::Write;

use super::place;
use crate::compare::{Comparison, Feature};
use crate::measure::{MeasuredObservable, Measurements};
use crate::noise::{NoiseLevel, NoiseSource};
use crate::output::{measurement, plot};
use crate::process::{Plot, Process};

/// Writes the models side by side, and where each fails.
pub fn text(process: &dyn Process, measurements: &Measurements, comparisons: &[Comparison], columns: usize) -> String {
    let kind = measurements.kind();
    let mut text = format!("{}: {} observations", measurements.name, measurements.len());
    // Writing to a String does not fail, here and below.
    if let Some(first) = comparisons.first() {
        let _ = writeln!(text, ", noise {}", noise(&first.noise.level(measurements), measurements));
    }
    for c in comparisons {
        text.push_str(&measurement::at_work(&c.model, &c.noise.terms, process, Some(measurements)));
    }
    for (c, caution) in comparisons.iter().flat_map(|c| c.cautions.iter().map(move |caution| (c, caution))) {
        let _ = writeln!(text, "\ncaution: {}: {caution}", c.model);
    }
    let width = comparisons.iter().map(|c| c.model.chars().count()).max().unwrap_or(0).max(5);
    let _ = writeln!(
        text,
        "\n  {:<width$} {:>11} {:>11} {:>11} {:>11}   verdict",
        "model", "rms", "bias", "worst", "chi2/dof"
    );
    for c in comparisons {
        let [rms, bias, worst] = [c.rms, c.bias, c.worst_error].map(|si| kind.from_si(si));
        let _ = writeln!(
            text,
            "  {:<width$} {rms:>11.3} {bias:>+11.3} {worst:>+11.3} {:>11.3}   {}",
            c.model,
            c.reduced_chi2,
            verdict(c)
        );
    }
    let _ = writeln!(text, "  rms, bias and worst in {}, measured less predicted", kind.unit);
    for c in comparisons.iter().filter(|c| c.adequacy() == Some(false)) {
        where_it_fails(&mut text, process, measurements, c, columns);
    }
    text
}

/// The verdict on a model as it is written, in a few words.
pub(in crate::output) fn verdict(c: &Comparison) -> &'static str {
    match (c.adequate(), c.p_value) {
        _ if c.adequacy().is_none() => "not judged: too few rows, and no column u",
        (true, Some(_)) => "adequate: nothing is left but the noise",
        (false, None) if c.is_rougher() && c.features.is_empty() => {
            "fails: far more is left than neighbouring rows scatter by, though along no coordinate"
        }
        (true, None) => "no structure is left; whether the rest is noise needs repeats or a column u",
        (false, _) if !c.suspects.is_empty() => "the noise is not what it is taken for",
        (false, _) => "fails",
    }
}

/// Writes the size of the noise and its source.
pub(in crate::output) fn noise(noise: &NoiseLevel, measurements: &Measurements) -> String {
    let source = match noise.source {
        NoiseSource::Column => "from the column u",
        NoiseSource::Covariance => "from a covariance that is known",
        NoiseSource::Repeats => "from repeated rows",
        NoiseSource::Estimated => "estimated from what is left",
    };
    let own =
        |(seen, sigma): (&MeasuredObservable, &f64)| format!("{:.3} {}", seen.kind.from_si(*sigma), seen.kind.unit);
    let all: Vec<String> = measurements.observables.iter().zip(&noise.of).map(own).collect();
    format!("{} ({source})", all.join(" and "))
}

/// Smallest share of a feature that is notable where there are larger ones.
const SMALLEST_SHARE: f64 = 0.03;

/// Features with a share worth reporting; of fewer than three, all.
pub(in crate::output) fn notable_features(features: &[Feature]) -> impl Iterator<Item = &Feature> {
    features.iter().filter(|f| f.share >= SMALLEST_SHARE || features.len() < 3)
}

fn where_it_fails(
    text: &mut String,
    process: &dyn Process,
    measurements: &Measurements,
    c: &Comparison,
    columns: usize,
) {
    let _ = writeln!(text, "\nwhere {} fails", c.model);
    if !c.suspects.is_empty() {
        let all: Vec<String> = c.suspects.iter().map(|t| measurement::words(t, process, Some(measurements))).collect();
        let asked = all.join("; ");
        let _ = writeln!(text, "  the rows ask for {asked}\n  `fem diagnose` weighs it against effects of the machine");
    } else if c.features.is_empty() {
        let _ = writeln!(text, "  more is left than the noise explains, but along no coordinate");
    }
    for feature in notable_features(&c.features) {
        let _ = writeln!(text, "  {:>3.0} %  {}", 100.0 * feature.share, feature.text);
    }
    let at: Vec<String> = match place(process.coordinates(), measurements, c.worst) {
        serde_json::Value::Object(map) => {
            map.iter().map(|(k, v)| format!("{k} {}", v.to_string().replace('"', ""))).collect()
        }
        _ => Vec::new(),
    };
    let _ = writeln!(text, "  worst in {} ({})", measurements.place(c.worst), at.join(", "));
    if let Some(feature) = c.features.iter().find(|f| f.curve.len() > 2) {
        let title = format!("residual [{}] over {}, mean of the rows there", feature.unit, feature.coordinate);
        let plot = Plot { title, x_unit: "", points: feature.curve.clone() };
        let _ = writeln!(text, "\n{}", plot::lines(&plot, columns).join("\n"));
    }
}
