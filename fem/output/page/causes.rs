//! The causes, one by one; what to measure next; rows that are wrong; every effect on trial.

use super::html::{self, Section, capital, sentence};
use super::subject::{Evidence, Subject};
use crate::diagnose::{Cause, Diagnosis, FreeLaw, Missing, Rival};
use crate::fit::Estimate;
use crate::input::Name;
use crate::output::block::{Block, Cell, Column, Table};
use crate::output::chart::{Axis, Chart, Form, Plane, Point, Series, Svg, escaped, named};
use crate::output::fit::Short;
use crate::output::run::RunAnswer;
use crate::output::{apart, diagnosis, plots};

/// Rise of χ² at the ends of a 95 % interval: 95 % point of χ² with one degree of freedom.
const QUANTILE: f64 = 3.841_458_820_694_124;
/// Largest rise that is drawn.
const HIGHEST: f64 = 9.0;
/// Points between two that were computed.
const BETWEEN: usize = 12;

/// The missing effects.
pub fn section(subject: &Subject, found: &Evidence, d: &Diagnosis) -> Section {
    let curves =
        found.completed.map_or(Vec::new(), |RunAnswer(model, run, _)| plots::changes(model, &run.contributions));
    let card = |(number, missing): (usize, &Missing)| {
        // As the command numbers them.
        let number = if missing.describes() { format!("described {number}") } else { number.to_string() };
        card(&number, missing, &curves, (subject, found))
    };
    let cards = (1..).zip(&d.missing).map(card).collect();
    Section { id: "causes".into(), title: "The causes".into(), blocks: cards }
}

fn card(number: &str, missing: &Missing, curves: &[(Name, Chart)], (subject, found): (&Subject, &Evidence)) -> String {
    let effect = &missing.effect;
    let mut html = format!(
        "<article class=\"cause\"><h3><span class=\"number\">{number}</span>{}</h3><p>{}</p>",
        escaped(&diagnosis::label(missing)),
        escaped(&capital(&effect.about))
    );
    html.push_str(&format!(
        "<p><code>{}</code><br><span class=\"note\">source: {}</span></p>",
        escaped(&effect.law),
        escaped(effect.source)
    ));
    html.push_str(&estimates("Values, with the 95 % intervals of their profiles", &missing.estimates));
    if let Some(changed) = diagnosis::changed(missing) {
        html.push_str(&html::paragraph("note", &sentence(&changed)));
    }
    if let Some([moves, size]) = diagnosis::largest_change(missing, found.data) {
        html.push_str(&html::paragraph("note", &sentence(&format!("it {moves} {size}"))));
    }
    html.push_str(&html::paragraph("note", &sentence(&diagnosis::chance(missing.p_value))));
    if let Cause::Law(FreeLaw { like: Some(like), .. }) = &missing.cause {
        html.push_str(&html::paragraph("note", &sentence(&format!("it has the form of {like}"))));
    }
    if let Some(doubt) = &missing.doubt {
        html.push_str(&html::paragraph("caution", &sentence(doubt)));
    }
    if let Some(bend) = &missing.bend {
        html.push_str(&html::paragraph("caution", &sentence(&diagnosis::bent(bend))));
    }
    let mut figures: Vec<(String, Svg)> = Vec::new();
    if matches!(missing.cause, Cause::Physical) {
        let own = curves.iter().filter(|c| c.0 == effect.name);
        figures.extend(own.map(|(_, chart)| named(chart)));
    }
    if let Cause::Law(law) = &missing.cause {
        figures.extend(over_rows(&effect.name, law, found).iter().map(named));
    }
    figures.extend(missing.estimates.iter().filter_map(profile).map(|chart| named(&chart)));
    html.push_str(&html::figures(figures));
    let alternative = |other: &crate::process::Description| {
        let by =
            diagnosis::separated(effect, other).map_or(String::new(), |by| format!("; what tells them apart: {by}"));
        format!("{}: {}{by}", other.label(), other.about)
    };
    if !missing.indistinguishable_from.is_empty() {
        html.push_str("<h4>These data cannot tell it from</h4>");
        html.push_str(&html::list(&missing.indistinguishable_from.iter().map(alternative).collect::<Vec<_>>()));
    }
    let rivals = effect
        .look_alikes
        .iter()
        .filter(|(name, _)| missing.indistinguishable_from.iter().all(|other| other.name != *name));
    let rivals: Vec<String> = rivals.map(|(name, by)| format!("{name}: {by}")).collect();
    if !rivals.is_empty() {
        html.push_str("<h4>Alike elsewhere, told apart here by</h4>");
        html.push_str(&html::list(&rivals));
    }
    if let Cause::Law(law) = &missing.cause {
        html.push_str(&rivals_of(law));
    }
    let traits = diagnosis::traits(missing, subject.model());
    html.extend(traits.into_iter().map(|text| html::block(&Block::Sentence(text))));
    html + "</article>"
}

/// A law over its variables, with what every row leaves without it.
fn over_rows(name: &Name, law: &FreeLaw, found: &Evidence) -> Vec<Chart> {
    let charts = || {
        let RunAnswer(model, ..) = found.completed?;
        let effect = model.effects.iter().find(|own| own.description.name == *name)?;
        let rows = &found.data.rows;
        let predicted = model.forward().observe(rows).ok()?;
        let added = model.change_in(effect, &predicted, rows).ok()?;
        let residuals = found.data.residuals(&predicted);
        let said = plots::Said { name, variables: &law.variables, added: &added, residuals: &residuals };
        Some(plots::law(&plots::Rows::of(model, found.data), &said))
    };
    charts().unwrap_or_default()
}

/// Laws that fit as well as one, with the row that tells each from it.
fn rivals_of(law: &FreeLaw) -> String {
    let line = |own: &Rival| {
        let told = own.apart.as_ref().map_or(String::new(), |apart| format!("; {}", apart::words(apart)));
        format!("{}{told}", own.formula)
    };
    match law.rivals.is_empty() {
        true => String::new(),
        false => {
            format!("<h4>Laws that fit as well</h4>{}", html::list(&law.rivals.iter().map(line).collect::<Vec<_>>()))
        }
    }
}

/// Values with their intervals as a table.
pub fn estimates(caption: &str, all: &[Estimate]) -> String {
    let row = |e: &Estimate| {
        let k = e.parameter.kind;
        let end = |si: Option<f64>| match si {
            Some(si) => Cell::Number(format!("{:.4}", Short(k.from_si(si))), k.from_si(si)),
            None => Cell::Text("open".into()),
        };
        let std = e.std / k.canonical().factor;
        let uncertainty = if std.is_finite() { format!("{:.2}", Short(std)) } else { "unknown".into() };
        vec![
            Cell::Text(diagnosis::name(e).into()),
            Cell::Number(format!("{:.4}", Short(k.from_si(e.value))), k.from_si(e.value)),
            Cell::Text(k.unit.into()),
            end(e.interval.low),
            end(e.interval.high),
            Cell::Number(uncertainty, std),
            Cell::Text(e.warnings.join("; ")),
        ]
    };
    let head = ["parameter", "value", "unit", "from", "to", "standard uncertainty", "remarks"];
    let table = Table { caption: caption.into(), ..Table::new(head.map(Column::wide), all.iter().map(row)) };
    if all.is_empty() { String::new() } else { html::table(&table) }
}

/// The profile of χ² of a parameter, where it was walked: √Δχ² runs nearly straight between what was computed.
fn profile(e: &Estimate) -> Option<Chart> {
    let kind = e.parameter.kind;
    let walked: Vec<(f64, f64)> = e
        .profile
        .iter()
        .map(|(v, rise)| (kind.from_si(*v), rise.sqrt().copysign(v - e.value)))
        .filter(|(v, z)| v.is_finite() && z.abs() <= 2.0 * HIGHEST.sqrt())
        .collect();
    if walked.len() < 3 {
        return None;
    }
    let smooth = walked.windows(2).flat_map(|w| {
        let part = |i: usize| i as f64 / BETWEEN as f64;
        let (a, b) = (w[0], w[1]);
        (0..=BETWEEN).map(move |i| Point::new(a.0 + part(i) * (b.0 - a.0), (a.1 + part(i) * (b.1 - a.1)).powi(2)))
    });
    let smooth: Vec<Point> = smooth.filter(|p| p.y <= HIGHEST).collect();
    let ends = [smooth.first()?.x, smooth.last()?.x];
    let dots = walked.iter().map(|(v, z)| Point::new(*v, z * z)).filter(|p| p.y <= HIGHEST).collect();
    let name = diagnosis::name(e);
    Some(Chart {
        name: format!("profile-{}", e.parameter.path.replace('.', "-")),
        title: format!("profile of \u{3c7}\u{b2} along {name}"),
        note: "dots: computed, all other values re-fitted; below the broken line lie 95 %".into(),
        plane: Plane::Curves {
            x: Axis::new(name.replace('_', " "), kind.unit),
            y: Axis { limits: Some((0.0, HIGHEST)), ..Axis::new("rise of \u{3c7}\u{b2}", "") },
            series: vec![
                Series::new("95 %", 1, Form::Dashed, ends.map(|x| Point::new(x, QUANTILE)).to_vec()),
                Series::new("", 0, Form::Line, smooth),
                Series::new("", 0, Form::Dots, dots),
            ],
        },
    })
}

/// The next measurement.
pub fn next(d: &Diagnosis) -> Section {
    let mut blocks: Vec<String> = diagnosis::next_measurement(d).iter().map(html::block).collect();
    if blocks.is_empty() {
        blocks.push(html::block(&diagnosis::separations(&diagnosis::separated_pairs(d))));
    }
    Section { id: "next".into(), title: "Measure next".into(), blocks }
}

/// Rows that are wrong by themselves.
pub fn outliers(found: &Evidence, d: &Diagnosis) -> Section {
    let row = |o: &crate::diagnose::Outlier| {
        let kind = found.data.observables[o.observable].kind;
        let [value, predicted] = [o.value, o.predicted].map(|si| kind.from_si(si));
        let file = found.data.file_of_record(o.record - 1).unwrap_or(&found.data.name);
        vec![
            Cell::Text(file.to_string()),
            Cell::Number(o.line.to_string(), o.line as f64),
            Cell::number(value),
            Cell::number(predicted),
            Cell::Text(kind.unit.into()),
            Cell::Number(format!("{:.3}", Short(o.weight)), o.weight),
        ]
    };
    let head = ["file", "line", "measured", "predicted", "unit", "weight"];
    let caption = "Rows that lie far outside of what the others scatter; they count by their weight".into();
    let table = Table { caption, is_sortable: true, ..Table::new(head.map(Column::wide), d.outliers.iter().map(row)) };
    let blocks = if d.outliers.is_empty() { Vec::new() } else { vec![html::table(&table)] };
    Section { id: "outliers".into(), title: "Outlying rows".into(), blocks }
}

/// Every effect that was on trial.
pub fn candidates(found: &Evidence, d: &Diagnosis) -> Section {
    let kind = found.data.kind();
    let row = |c: &crate::diagnose::Outlook| {
        let rms = c.rms.map(|si| kind.from_si(si));
        vec![
            Cell::Text(c.effect.label().into()),
            rms.map_or(Cell::Missing, Cell::number),
            Cell::Number(format!("{:+.1}", c.delta_bic), c.delta_bic),
            Cell::Number(
                if c.p_value < 1e-6 { "< 1e-6".into() } else { format!("{:.2}", Short(c.p_value)) },
                c.p_value,
            ),
            Cell::Text(diagnosis::note(c, d)),
        ]
    };
    let head = ["effect", &format!("rms alone [{}]", kind.unit)[..], "\u{394}BIC", "p", "what the data say of it"];
    let caption = "Each alone added to the model; a \u{394}BIC below zero speaks for it".into();
    let rows = d.candidates.iter().map(row);
    let table = Table { caption, is_sortable: true, ..Table::new(head.map(Column::wide), rows) };
    let mut blocks = Vec::new();
    if !d.candidates.is_empty() {
        blocks.push(html::table(&table));
    }
    let own: Vec<Estimate> = d
        .fit
        .estimates
        .iter()
        .filter(|e| d.missing.iter().all(|m| m.estimates.iter().all(|o| o.parameter.path != e.parameter.path)))
        .cloned()
        .collect();
    if !own.is_empty() {
        blocks.push(html::heading("What the model leaves open, re-fitted"));
        blocks.push(estimates("Values with their 95 % intervals", &own));
    }
    Section { id: "trial".into(), title: "Every effect on trial".into(), blocks }
}
