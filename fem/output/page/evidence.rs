//! Evidence of measurements: the error falling, measured beside predicted, residuals, what to do next.

use super::causes;
use super::html::{self, Cell};
use super::section::Section;
use super::step::{Step, steps};
use super::subject::{Evidence, Subject};
use crate::compare::Comparison;
use crate::output::chart::{Chart, Svg, draw, number};
use crate::output::falling::Falling;
use crate::output::{Report, comparison, diagnosis, drawing, plots};

/// Most coordinates along which the residuals of every step are drawn.
const MOST_ALONG: usize = 3;

/// The figures at the head of the page.
pub fn facts(found: &Evidence) -> Vec<(String, String)> {
    let data = found.data;
    let kind = data.kind();
    let fact = |name: &str, value: String| (name.to_string(), value);
    let mut facts = Vec::new();
    match (found.diagnosis, found.comparisons) {
        (Some(d), _) => {
            let [before, after] = [&d.before, &d.after].map(|g| kind.from_si(g.rms));
            let is_better = !d.missing.is_empty();
            let fall = |a: String, b: String| if is_better { format!("{a} \u{2192} {b}") } else { a };
            facts.push(fact(
                "root mean square error",
                fall(format!("{before:.3}"), format!("{after:.3}")) + " " + &kind.unit,
            ));
            // As many parameters as conditions leave no lack of fit to judge.
            let shown = |chi2: f64| match chi2.is_finite() {
                true => format!("{:.4}", crate::output::fit::Short(chi2)),
                false => "\u{2013}".into(),
            };
            let [b, a] = [&d.before, &d.after].map(|g| shown(g.reduced_chi2));
            facts.push(fact("reduced \u{3c7}\u{b2}", fall(b, a)));
            facts.push(fact("noise", format!("{:.3} {}", kind.from_si(d.noise.together()), kind.unit)));
            facts.push(fact("missing effects", d.missing.len().to_string()));
        }
        (None, [.., c]) => {
            facts.push(fact("root mean square error", format!("{:.3} {}", kind.from_si(c.rms), kind.unit)));
            facts.push(fact("reduced \u{3c7}\u{b2}", format!("{:.3}", c.reduced_chi2)));
            facts.push(fact("noise", format!("{:.3} {}", kind.from_si(c.noise.level(data).together()), kind.unit)));
        }
        (None, []) => {}
    }
    facts.push(fact("observations", data.len().to_string()));
    facts
}

/// All sections that come of measurements.
pub fn sections(subject: &Subject, found: &Evidence) -> Vec<Section> {
    let steps = steps(subject, found);
    let mut all = vec![falling(subject, found, &steps)];
    if let Some(d) = found.diagnosis {
        all.push(causes::section(subject, found, d));
        all.push(causes::next(d));
        all.push(causes::outliers(found, d));
    }
    if let Some(last) = steps.last() {
        all.push(measured(subject, found, last));
        all.push(left(subject, found, last));
    }
    if let Some(d) = found.diagnosis {
        all.push(causes::candidates(found, d));
    }
    all
}

fn rows<'a>(subject: &Subject<'a>, found: &Evidence<'a>, step: &'a Step<'a>) -> plots::Rows<'a> {
    let (predicted, residuals, noise) = (step.predicted, &step.residuals, step.noise);
    plots::Rows { model: subject.model(), measurements: found.data, predicted, residuals, noise }
}

/// Charts as figures.
fn charts(all: &[Chart]) -> String {
    let drawn: Vec<(&str, Svg)> = all.iter().map(|c| (c.name.as_str(), draw(c))).collect();
    html::figures(drawn.iter().map(|(name, svg)| (*name, svg)))
}

fn falling(subject: &Subject, found: &Evidence, steps: &[Step]) -> Section {
    let kind = found.data.kind();
    let level = match (found.diagnosis, steps.last()) {
        (Some(d), _) => d.noise.together(),
        (None, Some(last)) => last.noise.level(found.data).together(),
        (None, None) => f64::NAN,
    };
    let noise = kind.from_si(level);
    let (cautions, features) = match (found.diagnosis, found.comparisons) {
        (Some(d), _) => (&d.cautions[..], &d.features[..]),
        (None, [.., c]) => (&c.cautions[..], &c.features[..]),
        (None, []) => (&[][..], &[][..]),
    };
    let mut blocks: Vec<String> =
        cautions.iter().map(|c| html::paragraph("caution", &format!("Caution: {c}"))).collect();
    let undone = found.diagnosis.map_or(Vec::new(), |d| Report::Diagnosis(found.data, d).left_undone());
    blocks.extend(undone.iter().map(|u| html::paragraph("caution", &format!("Left undone for want of time: {u}"))));
    if steps.len() > 1 {
        let title = format!("root mean square error of {}", subject.model().stem().display());
        let stem = |s: &Step| s.label.rsplit('/').next().unwrap_or(&s.label).to_string();
        let fallen = Falling { title, steps: steps.iter().map(|s| (stem(s), s.rms)).collect(), noise, unit: kind.unit };
        blocks.push(html::figures([("falling-error", &fallen.svg())]));
    }
    if found.diagnosis.is_some() && subject.models.len() < 2 {
        blocks.push(refitted(found, steps, noise));
    }
    blocks.push(compared(found));
    let list: Vec<String> =
        comparison::notable_features(features).map(|f| format!("{:.0} %: {}", 100.0 * f.share, f.text)).collect();
    if !list.is_empty() {
        blocks.push(html::heading("Where the model fails"));
        blocks.push(html::list(&list));
    }
    if steps.len() > 1 {
        blocks.push(html::heading("What each step leaves"));
        blocks.push(slider(subject, found, steps));
    }
    Section { id: "error", title: if steps.len() > 1 { "The error falling" } else { "The error" }, blocks }
}

/// The table of the steps of a diagnosis.
fn refitted(found: &Evidence, steps: &[Step], noise: f64) -> String {
    let unit = found.data.kind().unit;
    let held = found.diagnosis.and_then(|d| d.cross_validation_by.clone()).map(|by| format!("held out by {by}"));
    let held = held.unwrap_or_else(|| "held out".into());
    let number = |v: f64| match v.is_finite() {
        true => Cell::Number(format!("{v:.3}"), v),
        false => Cell::Text("\u{2013}".into()),
    };
    let row = |s: &Step| {
        let out = number(s.held_out.unwrap_or(f64::NAN));
        vec![Cell::Text(s.label.clone()), number(s.rms), number(s.reduced_chi2), out]
    };
    let caption = format!("Every step is fitted anew to all rows; errors in {unit}, noise {noise:.3} {unit}");
    let head = ["model", "rms", "\u{3c7}\u{b2}/dof", &held];
    html::table(&caption, &head, &steps.iter().map(row).collect::<Vec<_>>(), false)
}

/// The table of `fem compare`.
fn compared(found: &Evidence) -> String {
    let kind = found.data.kind();
    let row = |c: &Comparison| {
        let [rms, bias, worst] = [c.rms, c.bias, c.worst_error].map(|si| kind.from_si(si));
        vec![
            Cell::Text(c.model.clone()),
            Cell::Number(format!("{rms:.3}"), rms),
            Cell::Number(format!("{bias:+.3}"), bias),
            Cell::Number(format!("{worst:+.3}"), worst),
            Cell::Number(format!("{:.3}", c.reduced_chi2), c.reduced_chi2),
            Cell::Text(comparison::verdict(c).to_string()),
        ]
    };
    let all: Vec<_> = found.comparisons.iter().map(row).collect();
    let caption =
        format!("As fem compare says of the models as they are written, in {}, measured less predicted", kind.unit);
    let head = ["model", "rms", "bias", "worst", "\u{3c7}\u{b2}/dof", "verdict"];
    if all.is_empty() { String::new() } else { html::table(&caption, &head, &all, false) }
}

/// Residuals after each step, all on the scale of the largest.
fn slider(subject: &Subject, found: &Evidence, steps: &[Step]) -> String {
    let largest = steps.iter().flat_map(|s| &s.residuals).fold(0.0f64, |size, r| size.max(r.abs()));
    // Several observables have no scale in common.
    let limits = (found.data.observables.len() == 1).then_some(largest);
    let block = |step: &Step| {
        let rows = rows(subject, found, step);
        let mut shown = plots::along(&rows, limits);
        shown.truncate(MOST_ALONG);
        shown.extend(plots::maps(&rows, limits).into_iter().take(1));
        (format!("{}: {:.3} {}", step.label, step.rms, found.data.kind().unit), charts(&shown))
    };
    html::steps(&steps.iter().map(block).collect::<Vec<_>>())
}

fn measured(subject: &Subject, found: &Evidence, last: &Step) -> Section {
    let rows = rows(subject, found, last);
    let model = subject.model();
    let mut blocks = vec![html::paragraph("note", &format!("Of {}.", last.label.replace("+ ", "the model up to ")))];
    if let (Some(places), Some(nominal)) = (model.system.places(&found.data.rows), model.system.contour()) {
        let resolved = model.system.resolved(&found.data.rows);
        let drawn = comparison::drawing(
            nominal,
            model.process.coordinates(),
            &resolved,
            &places,
            (last.predicted, &last.residuals),
        );
        let svg = drawing::drawing(&drawn);
        blocks.push(html::figures([("compared", &svg)]));
    }
    blocks.push(charts(&[plots::measured(&rows), plots::agreement(&rows)].concat()));
    Section { id: "measured", title: "Measured and predicted", blocks }
}

fn left(subject: &Subject, found: &Evidence, last: &Step) -> Section {
    let rows = rows(subject, found, last);
    let mut blocks = Vec::new();
    if let Some(d) = found.diagnosis {
        let remaining: Vec<String> = d.remaining.iter().map(|f| f.text.clone()).collect();
        let text = match remaining.is_empty() && d.suspects.is_empty() {
            true => "No structure is left along any coordinate or pair.".to_string(),
            false => format!("What remains, described and not explained: {}.", diagnosis::unexplained(found.data, d)),
        };
        blocks.push(html::paragraph("", &text));
    }
    blocks.push(charts(&[plots::along(&rows, None), plots::maps(&rows, None)].concat()));
    let worst = (0..last.residuals.len()).max_by(|a, b| {
        let size = |row: usize| last.residuals[row].abs() / last.noise.sigma[row].max(f64::MIN_POSITIVE);
        size(*a).total_cmp(&size(*b))
    });
    if let Some(worst) = worst {
        let times = last.residuals[worst].abs() / last.noise.sigma[worst];
        let told =
            format!("The row farthest off is {}: {} standard uncertainties.", found.data.place(worst), number(times));
        blocks.push(html::paragraph("note", &told));
    }
    Section { id: "left", title: "What is left", blocks }
}
