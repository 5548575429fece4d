//! The answer of `fem plan`: what a design could show.

use serde_json::{Value as Json, json};

use super::answer::Answer;
use super::block::Block;
use super::diagnosis::{bound, experiment, next as next_json, told_apart};
use super::measurement;
use crate::diagnose::Plan;
use crate::measure::MeasuredObservable;
use crate::model::Data;
use crate::progress::Progress;

/// Most pairs that are told, the most alike first.
const MOST_PAIRS: usize = 12;

/// The plan of a design with its model.
pub struct PlanAnswer<'a>(pub &'a Data<'a>, pub &'a Plan);

impl Answer for PlanAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(design, plan) = *self;
        let mut blocks = vec![Block::Lines(head(design, plan))];
        let width = plan.effects.iter().map(|e| e.0.label().len()).max().unwrap_or(0);
        blocks.push(Block::Heading("would be seen, nine times in ten at a usual shape, from".into()));
        for (d, v) in &plan.effects {
            let Some(v) = v.as_ref().filter(|v| v.detectable) else { continue };
            let size = v.smallest.map_or(String::new(), |s| bound(d, &v.parameter, s));
            let own = 100.0 * v.own_share;
            blocks.push(Block::Sentence(format!("{:<width$}  {size:<28} {own:>3.0} % of it is its own", d.label())));
        }
        let hidden = plan.effects.iter().filter(|(_, v)| v.as_ref().is_none_or(|v| !v.detectable));
        let hidden: Vec<_> = hidden.map(|e| e.0.label()).collect();
        if !hidden.is_empty() {
            blocks.push(Block::Heading(format!("would not be seen: {}", hidden.join(", "))));
        }
        if !plan.alike.is_empty() {
            blocks.push(Block::Heading("would look alike".into()));
            let pairs = plan.alike.iter().take(MOST_PAIRS).map(|a| {
                let (one, other) = (a.one.label(), a.other.label());
                format!("{one} and {other}, {:.1} sigma apart where either shows by 15", a.separation)
            });
            blocks.push(Block::List(pairs.collect()));
        }
        if plan.alike.len() > MOST_PAIRS {
            let more = plan.alike.len() - MOST_PAIRS;
            blocks.push(Block::Sentence(format!("and {more} pairs more (--json has them all)")));
        }
        if let Some(next) = &plan.next {
            blocks.push(Block::Heading("to tell most of them apart".into()));
            blocks.push(Block::Sentence(format!("{} more", experiment(next))));
            blocks.push(Block::Sentence(format!("tells {}", told_apart(next).join(", "))));
        }
        blocks
    }

    /// `fem plan --json`: `fem-plan/1`.
    fn json(&self) -> Json {
        let Self(design, plan) = *self;
        let noise = |(seen, sigma): (&MeasuredObservable, &f64)| json!({ "observable": seen.name, "sigma": seen.kind.from_si(*sigma), "unit": seen.kind.unit });
        let mut noise: Vec<Json> = design.observables.iter().zip(&plan.sigma).map(noise).collect();
        let effect = |(d, v): &(crate::process::Description, Option<crate::diagnose::DetectionLimit>)| {
            let unit =
                v.as_ref().and_then(|v| d.parameters.iter().find(|p| p.name == v.parameter)).map(|p| p.kind.unit);
            json!({
                "effect": d.name,
                "observable": d.observable,
                "visible": v.as_ref().is_some_and(|v| v.detectable),
                "parameter": v.as_ref().map(|v| &v.parameter),
                "smallest": v.as_ref().and_then(|v| v.smallest),
                "unit": unit,
                "own_share": v.as_ref().map(|v| v.own_share),
            })
        };
        json!({
            "schema": "fem-plan/1",
            "model": &*design.model.source.name,
            "design": design.name,
            "observations": plan.rows,
            "measurement": measurement::json(&plan.terms, &*design.model.process, Some(design)),
            "left_aside": measurement::json(&plan.unknown, &*design.model.process, Some(design)),
            "cautions": design.cautions,
            "noise": if noise.len() == 1 { noise.remove(0) } else { json!(noise) },
            "effects": plan.effects.iter().map(effect).collect::<Vec<_>>(),
            "alike": plan.alike.iter().map(|a| json!({ "effects": [a.one.name, a.other.name], "separation": a.separation })).collect::<Vec<_>>(),
            "next_measurement": plan.next.as_ref().map(|n| next_json(n, design.model)),
        })
    }

    fn progress(&self) -> Option<&Progress> {
        Some(&self.0.progress)
    }
}

/// The design, its noise, and cautions about it.
fn head(design: &Data, plan: &Plan) -> String {
    let (name, process) = (&design.model.source.name, &*design.model.process);
    let noise =
        |(seen, sigma): (&MeasuredObservable, &f64)| format!("{:.3} {}", seen.kind.from_si(*sigma), seen.kind.unit);
    let noise: Vec<String> = design.observables.iter().zip(&plan.sigma).map(noise).collect();
    let mut text = format!("{name}: {} rows of {}, noise {}\n", plan.rows, design.name, noise.join(" and "));
    text += &measurement::at_work(name, &plan.terms, process, Some(design));
    if !plan.unknown.is_empty() {
        let names: Vec<&str> = plan.unknown.iter().map(|t| t.effect.name).collect();
        text += &format!("{} left aside, for no size is known\n", names.join(", "));
    }
    text + &design.cautions.iter().map(|caution| format!("caution: {caution}\n")).collect::<String>()
}
