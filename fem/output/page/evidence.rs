//! Evidence of measurements: the error falling, measured beside predicted, residuals, what to do next.

use super::causes;
use super::html::{self, Section};
use super::step::{Step, steps};
use super::subject::{Evidence, Subject};
use crate::output::answer::left_undone;
use crate::output::block::Block;
use crate::output::chart::{Chart, named, number};
use crate::output::comparison::Asked;
use crate::output::falling::Falling;
use crate::output::plots::Rows;
use crate::output::text::micro;
use crate::output::{comparison, diagnosis, drawing, plots};
use crate::process::range;

/// Most coordinates along which the residuals of every step are drawn.
const MOST_ALONG: usize = 3;

/// The figures at the head of the page.
pub fn facts(found: &Evidence) -> Vec<(String, String)> {
    let data = found.data;
    let kind = data.kind();
    let fact = |name: &str, value: String| (name.to_string(), value);
    let mut facts = Vec::new();
    // As many parameters as conditions leave no lack of fit to judge, and no scatter no yardstick.
    let shown = |chi2: f64, text: String| if chi2.is_finite() { text } else { "\u{2013}".into() };
    match (found.diagnosis, found.comparisons) {
        (Some(d), _) => {
            let [before, after] = [&d.before, &d.after].map(|g| kind.from_si(g.rms));
            let is_better = !d.missing.is_empty();
            let fall = |a: String, b: String| if is_better { format!("{a} \u{2192} {b}") } else { a };
            facts.push(fact(
                "root mean square error",
                fall(format!("{before:.3}"), format!("{after:.3}")) + " " + &kind.unit,
            ));
            let short = |chi2: f64| shown(chi2, format!("{:.4}", crate::output::fit::Short(chi2)));
            let [b, a] = [&d.before, &d.after].map(|g| short(g.reduced_chi2));
            facts.push(fact("reduced \u{3c7}\u{b2}", fall(b, a)));
            facts.push(fact("noise", format!("{:.3} {}", kind.from_si(d.noise.together()), kind.unit)));
            facts.push(fact("missing effects", diagnosis::counted(d)));
        }
        (None, [.., c]) => {
            facts.push(fact("root mean square error", format!("{:.3} {}", kind.from_si(c.rms), kind.unit)));
            facts.push(fact("reduced \u{3c7}\u{b2}", shown(c.reduced_chi2, format!("{:.3}", c.reduced_chi2))));
            facts.push(fact("noise", format!("{:.3} {}", kind.from_si(c.noise.level(data).together()), kind.unit)));
        }
        (None, []) => {}
    }
    facts.push(fact("observations", data.len().to_string()));
    facts.into_iter().map(|(name, value)| (name, micro(&value))).collect()
}

/// All sections that come of measurements.
pub fn sections(subject: &Subject, found: &Evidence) -> Vec<Section> {
    let (steps, data) = steps(subject, found);
    let rows = Rows::of(subject.model(), data);
    let mut all = vec![falling(subject, found, &steps, &rows)];
    if let Some(d) = found.diagnosis {
        all.push(causes::section(subject, found, d));
        all.push(causes::next(d));
        all.push(causes::outliers(found, d));
    }
    if let Some(last) = steps.last() {
        all.extend([measured(&rows, last), left(&rows, found, last)]);
    }
    if let Some(d) = found.diagnosis {
        all.push(causes::candidates(found, d));
    }
    all
}

/// Charts as figures.
fn charts(all: &[Chart]) -> String {
    html::figures(all.iter().map(named))
}

fn falling(subject: &Subject, found: &Evidence, steps: &[Step], rows: &Rows) -> Section {
    let kind = found.data.kind();
    let level = match (found.diagnosis, steps.last()) {
        (Some(d), _) => d.noise.together(),
        (None, Some(last)) => last.noise.level(rows.measurements).together(),
        (None, None) => f64::NAN,
    };
    let noise = kind.from_si(level);
    let (cautions, features) = match (found.diagnosis, found.comparisons) {
        (Some(d), _) => (&d.cautions[..], &d.features[..]),
        (None, [.., c]) => (&c.cautions[..], &c.features[..]),
        (None, []) => (&[][..], &[][..]),
    };
    let mut blocks: Vec<String> = cautions.iter().map(|c| html::block(&Block::Caution(c.clone()))).collect();
    let undone = left_undone(found.diagnosis.map(|_| &*found.data.progress));
    blocks.extend(undone.iter().map(|u| html::paragraph("caution", &format!("Left undone for want of time: {u}"))));
    let asked = steps.last().and_then(|last| {
        let judged = last.judged();
        let sigma = range(judged.noise.sigma.iter().copied()).1;
        Asked::of(rows.model, rows.measurements, (judged.measured, sigma))
    });
    if steps.len() > 1 {
        let title = format!("root mean square error of {}", subject.model().stem().display());
        let stem = |s: &Step| s.label.rsplit('/').next().unwrap_or(&s.label).to_string();
        let steps = steps.iter().map(|s| (stem(s), s.rms)).collect();
        let apart = asked.as_ref().and_then(Asked::off).map(|(_, off)| {
            ("error of the parts against the drawing".to_string(), vec![("as measured".to_string(), kind.from_si(off))])
        });
        let fallen = Falling { title, steps, apart, noise, unit: kind.unit };
        blocks.push(html::figures([("falling-error".into(), fallen.svg())]));
    }
    if let Some(d) = found.diagnosis.filter(|_| subject.models.len() < 2) {
        blocks.push(html::table(&diagnosis::errors(subject.model(), d, kind, "held out")));
    }
    if !found.comparisons.is_empty() {
        blocks.push(html::table(&comparison::compared(found.all, found.comparisons)));
    }
    blocks.extend(asked.iter().flat_map(Asked::blocks).map(|block| html::block(&block)));
    let list = html::block(&comparison::features(features));
    if !list.is_empty() {
        blocks.extend([html::heading("Where the model fails"), list]);
    }
    if steps.len() > 1 {
        blocks.push(html::heading("What each step leaves"));
        blocks.push(slider(rows, steps));
    }
    let title = if steps.len() > 1 { "The error falling" } else { "The error" };
    Section { id: "error".into(), title: title.into(), blocks }
}

/// Residuals after each step, all on the scale of the largest.
fn slider(rows: &Rows, steps: &[Step]) -> String {
    let largest = steps.iter().flat_map(|s| &s.residuals).fold(0.0f64, |size, r| size.max(r.abs()));
    // Several observables have no scale in common.
    let limits = (rows.measurements.observables.len() == 1).then_some(largest);
    let block = |step: &Step| {
        let judged = step.judged();
        let mut shown = plots::along(rows, &judged, limits);
        shown.truncate(MOST_ALONG);
        shown.extend(plots::maps(rows, &judged, limits).into_iter().take(1));
        (format!("{}: {:.3} {}", step.label, step.rms, rows.measurements.kind().unit), charts(&shown))
    };
    html::steps(&steps.iter().map(block).collect::<Vec<_>>())
}

fn measured(rows: &Rows, last: &Step) -> Section {
    let judged = last.judged();
    let mut blocks = vec![html::paragraph("note", &format!("Of {}.", last.label.replace("+ ", "the model up to ")))];
    if let Some(drawn) = comparison::drawing(rows, &judged) {
        blocks.push(html::figures([("compared".into(), drawing::drawing(&drawn))]));
    }
    blocks.push(charts(&[plots::measured(rows, &judged), plots::agreement(rows, &judged)].concat()));
    Section { id: "measured".into(), title: "Measured and predicted".into(), blocks }
}

fn left(rows: &Rows, found: &Evidence, last: &Step) -> Section {
    let judged = last.judged();
    let mut blocks = Vec::new();
    if let Some(d) = found.diagnosis {
        let remaining: Vec<String> = d.remaining.iter().map(|f| f.text.clone()).collect();
        let text = match remaining.is_empty() && d.suspects.is_empty() {
            true => "No structure is left along any coordinate or pair.".to_string(),
            false => format!("What remains, described and not explained: {}.", diagnosis::unexplained(found.data, d)),
        };
        blocks.push(html::paragraph("", &text));
    }
    blocks.push(charts(&[plots::along(rows, &judged, None), plots::maps(rows, &judged, None)].concat()));
    let worst = (0..last.residuals.len()).max_by(|a, b| {
        let size = |row: usize| last.residuals[row].abs() / last.noise.sigma[row].max(f64::MIN_POSITIVE);
        size(*a).total_cmp(&size(*b))
    });
    if let Some(worst) = worst {
        let times = last.residuals[worst].abs() / last.noise.sigma[worst];
        let told = format!(
            "The row farthest off is {}: {} standard uncertainties.",
            rows.measurements.place(worst),
            number(times)
        );
        blocks.push(html::paragraph("note", &told));
    }
    Section { id: "left".into(), title: "What is left".into(), blocks }
}
