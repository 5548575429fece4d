//! The answer of `fem budget`: errors added up.

use std::fmt::Write;

use serde_json::{Value as Json, json};

use super::answer::Answer;
use super::block::Block;
use super::text::titled;
use crate::budget::{
    Budget, Drawn, Drill, Estimate, Handbook, Kind, Measured, ModelPart, Purchase, Share, Source, Unknown, rules,
};

/// Unit of all lengths.
const UNIT: &str = "um";
/// Fewest samples beyond either end of the interval that determine it.
const LEAST_BEYOND: f64 = 10.0;
/// Widest bar of the tornado, in characters.
const BAR: f64 = 28.0;

fn um(si: f64) -> f64 {
    1e6 * si
}

/// The errors of a budget, and what they add up to, where it has any.
pub struct BudgetAnswer<'a>(pub &'a Budget, pub Option<&'a Estimate>);

impl Answer for BudgetAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(budget, estimate) = *self;
        let title = titled(budget.title.as_deref(), &budget.file.name);
        let mut text = format!("{title}\nbudget: errors added up by the handbook's rules and by Monte Carlo\n\n");
        if let Some(estimate) = estimate {
            handbook_text(&mut text, budget, &estimate.handbook);
            drawn_text(&mut text, budget, &estimate.monte_carlo);
            if let Some(pessimism) = pessimism(estimate) {
                line(&mut text, "handbook over drawn", &format!("{pessimism:.3}"));
            }
            tornado(&mut text, &estimate.shares);
            to_buy(&mut text, budget, &estimate.purchases);
        }
        if let Some(drill) = &budget.drill {
            if estimate.is_some() {
                text.push('\n');
            }
            drill_text(&mut text, drill);
        }
        vec![Block::Lines(text)]
    }

    /// `fem budget --json`: `fem-budget/1`.
    fn json(&self) -> Json {
        let Self(budget, estimate) = *self;
        json!({
            "schema": "fem-budget/1",
            "budget": &*budget.file.name,
            "title": budget.title,
            "model": budget.models.parts.first().map(|m| m.model.source.name.to_string()),
            "models": budget.models.parts.iter().map(model_json).collect::<Vec<_>>(),
            "unit": UNIT,
            "t": budget.t,
            "risk": budget.risk(),
            "tolerance": budget.tolerance.map(|(lower, upper)| [um(lower), um(upper)]),
            "handbook": estimate.map(|e| handbook_json(&e.handbook)),
            "monte_carlo": estimate.map(|e| drawn_json(budget, &e.monte_carlo)),
            "pessimism": estimate.and_then(pessimism),
            "contributions": estimate.map(|e| e.shares.iter().map(share_json).collect::<Vec<_>>()),
            "to_buy_down": estimate.map(|e| e.purchases.iter().map(purchase_json).collect::<Vec<_>>()),
            "drill": budget.drill.as_ref().map(drill_json),
            "warnings": self.warnings(),
        })
    }
}

impl BudgetAnswer<'_> {
    /// Warnings for the user.
    pub fn warnings(&self) -> Vec<String> {
        let Self(budget, estimate) = *self;
        let mut warnings = Vec::new();
        if let Some(drill) = budget.drill.filter(|d| d.drill_tolerance < 0.0 || d.wear < 0.0 || d.left() < -1e-15) {
            let lacking = (-drill.left()).max(-drill.drill_tolerance).max(-drill.wear);
            warnings.push(format!(
                "the tolerance of the hole does not suffice for its drill: {:.3} um are lacking",
                um(lacking)
            ));
        }
        let Some(estimate) = estimate else { return warnings };
        let drawn = &estimate.monte_carlo;
        if 0.5 * budget.risk() * (drawn.samples as f64) < LEAST_BEYOND {
            warnings.push(format!(
                "{} samples are too few for a risk of {:.2} %: take {:.0} or more",
                drawn.samples,
                100.0 * budget.risk(),
                2.0 * LEAST_BEYOND / budget.risk()
            ));
        }
        if drawn.redrawn > 0 {
            warnings.push(format!(
                "{} draws fell where the model has no value, and were drawn again: laws are cut off there",
                drawn.redrawn
            ));
        }
        for error in &budget.errors {
            if let Source::Clamping { c, force, exponent } = error.source {
                /// Range of that ratio in which the rule agrees with the samples.
                const CLOSE: std::ops::Range<f64> = 0.8..1.25;
                let half = 0.5 * rules::clamping_scatter(c, force, exponent);
                let ratio = error.value.abs() / half;
                // (30) takes the whole of it, and says so.
                let is_whole = (ratio - 2.0).abs() < 1e-9;
                if CLOSE.contains(&ratio) || is_whole || error.value.abs() == half {
                    continue;
                }
                warnings.push(format!(
                    "`{}` moves by {:.3} um either way from least to largest; (47) makes {:.3} um of it, from whole ranges of the force at either c",
                    error.name,
                    um(half),
                    um(error.value)
                ));
            }
        }
        for (group, _) in &estimate.handbook.groups {
            let member =
                |e: &&crate::budget::Contribution| e.group.as_ref() == Some(group) && e.kind == Kind::Systematic;
            if let Some(error) = budget.errors.iter().find(member) {
                warnings.push(format!(
                    "`{}` is systematic, and stands under the root with its group `{group}`; the rule adds it arithmetically: see the total one by one",
                    error.name
                ));
            }
        }
        warnings
    }
}

fn model_json(part: &ModelPart) -> Json {
    json!({
        "name": part.name,
        "file": &*part.model.source.name,
        "process": part.model.process.name(),
        "effect": part.effect,
        "kind": part.kind.word(),
    })
}

fn handbook_json(handbook: &Handbook) -> Json {
    let groups: Vec<Json> =
        handbook.groups.iter().map(|(name, total)| json!({ "name": name, "total": um(*total) })).collect();
    json!({
        "systematic": um(handbook.systematic),
        "random": um(handbook.random),
        "total": um(handbook.total),
        "one_by_one": handbook.one_by_one.map(um),
        "groups": groups,
    })
}

fn drawn_json(budget: &Budget, drawn: &Drawn) -> Json {
    let measured = |m: Measured| json!({ "value": um(m.value), "standard_error": um(m.error) });
    let [low, high] = drawn.interval;
    json!({
        "samples": drawn.samples,
        "seed": budget.seed,
        "mean": measured(drawn.mean),
        "std": measured(drawn.std),
        "interval": [measured(low), measured(high)],
        "extent": um(drawn.extent),
        "rejects": drawn.rejects.map(|r| json!({ "share": r.drawn.value, "standard_error": r.drawn.error, "by_normal_law": r.normal })),
        "redrawn": drawn.redrawn,
    })
}

fn share_json(share: &Share) -> Json {
    json!({
        "name": share.name,
        "kind": share.kind.word(),
        "distribution": (share.kind == Kind::Random).then(|| share.law.word()),
        "lambda": (share.kind == Kind::Random).then(|| share.law.lambda()),
        "from": um(share.swing.0),
        "to": um(share.swing.1),
        "variance_share": share.variance_share,
    })
}

fn drill_json(drill: &Drill) -> Json {
    json!({
        "tolerance": um(drill.tolerance),
        "drill_tolerance": um(drill.drill_tolerance),
        "wear": um(drill.wear),
        "widening_max": um(drill.widening_max),
        "widening_min": um(drill.widening_min),
        "total": um(drill.total()),
        "left": um(drill.left()),
        "computed": drill.unknown.map(unknown),
    })
}

fn unknown(unknown: Unknown) -> &'static str {
    match unknown {
        Unknown::Tolerance => "tolerance",
        Unknown::DrillTolerance => "drill_tolerance",
        Unknown::Wear => "wear",
    }
}

/// Ratio of the handbook's total to the extent of the samples at the same risk.
fn pessimism(estimate: &Estimate) -> Option<f64> {
    let ratio = estimate.handbook.total / estimate.monte_carlo.extent;
    ratio.is_finite().then_some(ratio)
}

fn line(text: &mut String, label: &str, told: &str) {
    let _ = writeln!(text, "  {label:<24} {told}");
}

fn handbook_text(text: &mut String, budget: &Budget, handbook: &Handbook) {
    let (systematic, random) = (um(handbook.systematic), um(handbook.random));
    line(text, "systematic", &format!("{systematic:+.3} um, added with their signs"));
    let risk = 100.0 * budget.risk();
    line(
        text,
        "random",
        &format!("+-{random:.3} um by the root of squares, t = {} for a risk of {risk:.2} %", budget.t),
    );
    for (name, total) in &handbook.groups {
        line(text, "", &format!("{name}: {:.3} um as one", um(*total)));
    }
    let total = um(handbook.total);
    let (low, high) = (systematic - random, systematic + random);
    line(text, "total by the handbook", &format!("{total:.3} um: from {low:+.3} to {high:+.3} um"));
    if let Some(total) = handbook.one_by_one {
        line(text, "total, one by one", &format!("{:.3} um, every error of a group by itself", um(total)));
    }
}

fn drawn_text(text: &mut String, budget: &Budget, drawn: &Drawn) {
    let told = |m: Measured| format!("{:+.3} ({:.3})", um(m.value), um(m.error));
    let (mean, std, std_error) = (told(drawn.mean), um(drawn.std.value), um(drawn.std.error));
    let told_std = format!("standard deviation {std:.3} ({std_error:.3}) um (standard errors)");
    line(text, "Monte Carlo", &format!("mean {mean}, {told_std}, {} samples", drawn.samples));
    let [low, high] = drawn.interval.map(told);
    let share = 100.0 * (1.0 - budget.risk());
    line(text, "", &format!("{share:.2} % from {low} to {high} um"));
    if let (Some((lower, upper)), Some(rejects)) = (budget.tolerance, drawn.rejects) {
        let [drawn, error, normal] =
            [rejects.drawn.value, rejects.drawn.error, rejects.normal].map(|part| 100.0 * part);
        let within = format!("{:+.3} to {:+.3} um", um(lower), um(upper));
        line(text, "tolerance", &format!("{within}: {drawn:.3} ({error:.3}) % rejects, {normal:.3} % by a normal law"));
    }
}

/// Writes every error with the changes that it alone makes, the widest first; a mark stands at no change.
fn tornado(text: &mut String, shares: &[Share]) {
    let width = shares.iter().map(|s| s.name.chars().count()).max().unwrap_or(0).max(13);
    let low = shares.iter().map(|s| s.swing.0.min(s.swing.1)).fold(0.0, f64::min);
    let high = shares.iter().map(|s| s.swing.0.max(s.swing.1)).fold(0.0, f64::max);
    let scale = BAR / (high - low).max(f64::MIN_POSITIVE);
    let column = |value: f64| ((value - low) * scale).round() as usize;
    let _ = writeln!(
        text,
        "\n  {:<width$}  {:<10} {:>9} {:>9}  {:>8}",
        "contributions", "", "from um", "to um", "variance"
    );
    for share in shares {
        let (from, to) = (share.swing.0.min(share.swing.1), share.swing.0.max(share.swing.1));
        let mark = |i: usize| match i {
            i if i == column(0.0) => '│',
            i if i >= column(from) && i <= column(to) && to > from => '█',
            _ => ' ',
        };
        let bar: String = (0..=column(high)).map(mark).collect();
        let law = if share.kind == Kind::Systematic { "systematic" } else { share.law.word() };
        let _ = writeln!(
            text,
            "  {:<width$}  {law:<10} {:>+9.3} {:>+9.3}  {:>6.1} %  {}",
            share.name,
            um(from),
            um(to),
            100.0 * share.variance_share,
            bar.trim_end()
        );
    }
}

/// Most terms of which it is said what less of them does.
const MOST_BOUGHT: usize = 5;

/// What less of the terms does to the total, and with how little of one alone it keeps the tolerance.
fn to_buy(text: &mut String, budget: &Budget, all: &[Purchase]) {
    // Of one term alone it is plain.
    if all.len() < 2 {
        return;
    }
    let told = &all[..all.len().min(MOST_BOUGHT)];
    let width = told.iter().map(|own| own.name.chars().count()).max().unwrap_or(0).max(24);
    let is_kept = all.iter().all(|own| own.may_stay == Some(1.0));
    let heading = if budget.tolerance.is_none() || is_kept { "" } else { "  for the tolerance" };
    let _ = writeln!(text, "\n  {:<width$} {:>12} {:>12}{heading}", "total by the handbook", "with half of", "without");
    for own in told {
        let needed = match own.may_stay {
            _ if heading.is_empty() => String::new(),
            Some(part) => format!("  at most {:.0} % of it", 100.0 * part),
            None => "  not by it alone".to_string(),
        };
        let _ = writeln!(text, "  {:<width$} {:>9.3} um {:>9.3} um{needed}", own.name, um(own.halved), um(own.without));
    }
}

fn purchase_json(own: &Purchase) -> Json {
    json!({
        "name": own.name,
        "total_with_half": um(own.halved),
        "total_without": um(own.without),
        "may_stay": own.may_stay,
    })
}

fn drill_text(text: &mut String, drill: &Drill) {
    let Drill { widening_max, widening_min, drill_tolerance, wear, tolerance, .. } = *drill;
    let follows = |of: Unknown| if drill.unknown == Some(of) { ", which follows" } else { "" };
    line(
        text,
        "hole by its drill",
        &format!(
            "{:.3} um = {:.3} + {:.3} + {:.3} - {:.3} um",
            um(drill.total()),
            um(widening_max),
            um(drill_tolerance),
            um(wear),
            um(widening_min)
        ),
    );
    line(
        text,
        "tolerance of the hole",
        &format!("{:.3} um{}, {:+.3} um left", um(tolerance), follows(Unknown::Tolerance), um(drill.left())),
    );
    line(text, "tolerance of the drill", &format!("{:.3} um{}", um(drill_tolerance), follows(Unknown::DrillTolerance)));
    line(text, "wear of the drill", &format!("{:.3} um{}", um(wear), follows(Unknown::Wear)));
}
