//! A comparison for people.

use super::place;
use crate::compare::{Comparison, Feature};
use crate::measure::{MeasuredObservable, Measurements};
use crate::noise::{NoiseLevel, NoiseSource};
use crate::output::block::{Block, Cell, Column, Table};
use crate::output::measurement;
use crate::process::{Plot, Process};

/// The models side by side, and where each fails.
pub fn blocks(process: &dyn Process, measurements: &Measurements, comparisons: &[Comparison]) -> Vec<Block> {
    let level = comparisons.first().map(|first| noise(&first.noise.level(measurements), measurements));
    let noise = level.map_or(String::new(), |level| format!(", {level}"));
    let mut head = format!("{}: {} observations{noise}\n", measurements.name, measurements.len());
    for c in comparisons {
        head += &measurement::at_work(&c.model, &c.noise.terms, process, Some(measurements));
    }
    let mut blocks = vec![Block::Lines(head)];
    let cautions = comparisons.iter().flat_map(|c| c.cautions.iter().map(|caution| format!("{}: {caution}", c.model)));
    blocks.extend(cautions.map(Block::Caution));
    blocks.push(Block::Table(compared(measurements, comparisons)));
    let unit = measurements.kind().unit;
    blocks.push(Block::Sentence(format!("rms, bias and worst in {unit}, measured less predicted")));
    let failed = comparisons.iter().filter(|c| c.adequacy() == Some(false));
    blocks.extend(failed.flat_map(|c| where_it_fails(process, measurements, c)));
    blocks
}

/// The models with their errors and the verdicts on them.
pub(in crate::output) fn compared(measurements: &Measurements, comparisons: &[Comparison]) -> Table {
    let kind = measurements.kind();
    let row = |c: &Comparison| {
        let [rms, bias, worst] = [c.rms, c.bias, c.worst_error].map(|si| kind.from_si(si));
        vec![
            Cell::Text(c.model.clone()),
            Cell::number(rms),
            Cell::signed(bias),
            Cell::signed(worst),
            Cell::finite(c.reduced_chi2),
            Cell::Text(verdict(c, measurements).into()),
        ]
    };
    let numbers = ["rms", "bias", "worst", "chi2/dof"].map(|name| Column::new(name, 11));
    let columns = [Column::wide("model")].into_iter().chain(numbers).chain([Column::remark("verdict", 0)]);
    let unit = kind.unit;
    let caption = format!("As fem compare says of the models as they are written, in {unit}, measured less predicted");
    Table { caption, ..Table::new(columns, comparisons.iter().map(row)) }
}

/// What is said of rows that tell nothing of a model: they read all alike, are too few, or stand too much alike to tell their
/// noise.
pub(in crate::output) fn not_judged(measurements: &Measurements) -> &'static str {
    match measurements.are_all_alike() {
        true => "not judged: all readings are one number",
        false => "not judged: too few rows at different places, and no column u",
    }
}

/// What is said of a model that leaves no structure, where the noise is only estimated.
pub(in crate::output) const NO_STRUCTURE: &str =
    "no structure is left; whether the rest is noise needs repeats or a column u";

/// The verdict on a model as it is written, in a few words.
pub(in crate::output) fn verdict(c: &Comparison, measurements: &Measurements) -> &'static str {
    match (c.adequate(), c.p_value) {
        _ if c.adequacy().is_none() => not_judged(measurements),
        (true, Some(_)) => "adequate: nothing is left but the noise",
        (false, None) if c.is_rougher() && c.features.is_empty() => {
            "fails: far more is left than neighbouring rows scatter by, though along no coordinate"
        }
        (true, None) => NO_STRUCTURE,
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
    let told = |of: &[f64]| sizes(of, measurements);
    if noise.factor != 1.0 {
        let stated: Vec<f64> = noise.of.iter().map(|sigma| sigma / noise.factor).collect();
        let (stated, left, times) = (told(&stated), told(&noise.of), noise.factor);
        return format!("u {stated} from the column; what is left is {left}, {times:.1} times as much");
    }
    format!("noise {} ({source})", told(&noise.of))
}

/// Noise of a model and of the same with what was found, which leaves less: where no column tells it, each has its own.
pub(in crate::output) fn noise_of_both(before: &NoiseLevel, after: &NoiseLevel, measurements: &Measurements) -> String {
    let [both, left] = [before, after].map(|level| noise(level, measurements));
    match before.source == after.source {
        _ if both == left => both,
        true => format!("{both}, {} beside what was found", sizes(&after.of, measurements)),
        false => format!("{both}; beside what was found {left}"),
    }
}

/// Sizes (SI) of each of the file's observables.
fn sizes(of: &[f64], measurements: &Measurements) -> String {
    let own =
        |(seen, sigma): (&MeasuredObservable, &f64)| format!("{:.3} {}", seen.kind.from_si(*sigma), seen.kind.unit);
    measurements.observables.iter().zip(of).map(own).collect::<Vec<String>>().join(" and ")
}

/// Smallest share of a feature that is notable where there are larger ones.
const SMALLEST_SHARE: f64 = 0.03;

/// Features with a share worth reporting, behind their shares; of fewer than three, all.
pub(in crate::output) fn features(all: &[Feature]) -> Block {
    let notable = all.iter().filter(|f| f.share >= SMALLEST_SHARE || all.len() < 3);
    Block::Labelled(notable.map(|f| (format!("{:>3.0} %", 100.0 * f.share), f.text.clone())).collect())
}

/// The residuals along the first coordinate over which they make a curve.
pub(in crate::output) fn residual_curve(features: &[Feature]) -> Option<Block> {
    let feature = features.iter().find(|f| f.curve.len() > 2)?;
    let title = format!("residual [{}] over {}, mean of the rows there", feature.unit, feature.coordinate);
    Some(Block::Curve(Plot { title, x_unit: "", points: feature.curve.clone() }))
}

fn where_it_fails(process: &dyn Process, measurements: &Measurements, c: &Comparison) -> Vec<Block> {
    let mut blocks = vec![Block::Heading(format!("where {} fails", c.model))];
    if !c.suspects.is_empty() {
        let all: Vec<String> = c.suspects.iter().map(|t| measurement::words(t, process, Some(measurements))).collect();
        blocks.push(Block::Sentence(format!("the rows ask for {}", all.join("; "))));
        blocks.push(Block::Sentence("`fem diagnose` weighs it against effects of the machine".into()));
    } else if c.features.is_empty() {
        blocks.push(Block::Sentence("more is left than the noise explains, but along no coordinate".into()));
    }
    blocks.push(features(&c.features));
    let at: Vec<String> = match place(process.coordinates(), measurements, c.worst) {
        serde_json::Value::Object(map) => {
            map.iter().map(|(k, v)| format!("{k} {}", v.to_string().replace('"', ""))).collect()
        }
        _ => Vec::new(),
    };
    blocks.push(Block::Sentence(format!("worst in {} ({})", measurements.place(c.worst), at.join(", "))));
    blocks.extend(residual_curve(&c.features));
    blocks
}
