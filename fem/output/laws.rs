//! The answer of `fem discover`: the law that was found, what it says of rows that were left out, laws that fit as well and
//! the row that would tell them apart, and the command that adds it.

use serde_json::{Value as Json, json};

use super::answer::Answer;
use super::apart;
use super::block::{Block, Column, Table};
use super::comparison::not_judged;
use super::diagnosis::{add, with};
use super::fit::{Short, estimate, rows};
use super::measurement::{self, files};
use crate::diagnose::SIGNIFICANCE;
use crate::discover::{Discovery, Law, LeftOut, Tried, Wandering};
use crate::model::Data;
use crate::progress::Progress;
use crate::units::Kind;

/// Most rivals that are shown.
const MOST_RIVALS: usize = 5;

/// What was found, with the data.
pub struct LawsAnswer<'a>(pub &'a Data<'a>, pub &'a Discovery);

impl LawsAnswer<'_> {
    fn observable(&self, law: &Law) -> String {
        self.0.model.process.observables()[law.ranked.observable].name.to_string()
    }

    /// The command that adds a law; where it names columns that the process does not know, the measurements tell these.
    fn command(&self, law: &Law) -> String {
        let data = self.0;
        let line = add(&data.model.source.name, &law.ranked.name, &law.settings).0;
        let is_recorded = data.recorded.iter().any(|own| law.ranked.variables.contains(&own.name.to_string()));
        if is_recorded { format!("{line} {}", with(data)) } else { line }
    }

    /// Why the best law is not told.
    fn held_back(&self) -> Option<String> {
        let Self(data, found) = *self;
        found.laws.first().filter(|_| found.told().is_none())?;
        if let Some(too_few) = &found.too_few {
            return Some(too_few.to_string());
        }
        if !found.instead.is_empty() {
            let of = |term| measurement::words(term, &*data.model.process, Some(data));
            let terms: Vec<String> = found.instead.iter().map(of).collect();
            return Some(format!("what the measurement itself may do says as much: {}", terms.join("; ")));
        }
        let left_out = found.left_out?;
        Some(format!(
            "it does not foresee rows that it was not fitted to: {:.2} standard uncertainties there, {:.2} without it",
            left_out.after, left_out.before
        ))
    }
}

impl Answer for LawsAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(data, found) = *self;
        let name = &data.model.source.name;
        let mut blocks = vec![Block::Sentence(format!("{name} beside {}: {} rows", data.name, data.len()))];
        let Some(best) = found.laws.first() else {
            blocks.push(Block::Sentence(match found.is_nothing_left {
                _ if !found.is_judged() => not_judged(data).into(),
                true => format!("nothing is left for a law: chi2/dof {:.3}, what noise gives", found.before),
                false => format!("chi2/dof {:.3} is left, and no law of {} explains it", found.before, sought(found)),
            }));
            blocks.extend(found.wandering.map(|own| Block::Paragraph(wanders(&own))));
            blocks.extend(tried(found));
            return blocks;
        };
        let held_back = self.held_back();
        blocks.push(Block::Heading(match held_back {
            None if best.ranked.is_candidate => {
                format!("{}, a law of your own, explains what the model leaves", best.ranked.name)
            }
            None => "a law explains what the model leaves".into(),
            Some(_) => "held back: a law that fits, and is not to be believed yet".into(),
        }));
        blocks.push(Block::Paragraph(format!("{} + {}", self.observable(best), best.ranked.written.formula)));
        let columns = [Column::wide("constant"), Column::new("value", 24), Column::remark("95 % interval", 0)];
        blocks.push(Block::Table(Table::new(columns, best.estimates.iter().flat_map(|e| rows(e, false)))));
        let known: Vec<String> = best.ranked.known().map(|(name, value)| format!("{name} = {value}")).collect();
        if !known.is_empty() {
            blocks.push(Block::Sentence(format!("chosen, not fitted: {}", known.join(", "))));
        }
        blocks.push(Block::Sentence(format!(
            "chi2/dof falls from {:.3} to {:.3}{}",
            found.before,
            best.reduced_chi2,
            if best.p_value.is_some_and(|p| p < SIGNIFICANCE) { ": more is left than noise gives" } else { "" }
        )));
        blocks.extend(found.like.map(|like| Block::Sentence(format!("it has the form of {like}"))));
        if let Some(left_out) = found.left_out {
            blocks.push(Block::Sentence(format!(
                "rows that it was not fitted to, setting by setting: {:.2} standard uncertainties, {:.2} without it",
                left_out.after, left_out.before
            )));
        }
        let among = match best.ranked.is_candidate {
            true => format!("for being one of {} laws of your own", found.tried.len()),
            false => format!("for a search over {}", sought(found)),
        };
        let price = best.ranked.found.price;
        blocks.push(Block::Sentence(format!("it pays {price:.0} of chi2 for its constants and {among}")));
        let ranges: Vec<String> = found.ranges.iter().map(range).collect();
        if !ranges.is_empty() {
            blocks.push(Block::Sentence(format!("seen for {}; beyond that it is a guess", ranges.join(", "))));
        }
        if let Some(why) = &held_back {
            blocks.push(Block::Caution(why.clone()));
        }
        let rivals = &found.laws[1..];
        if !rivals.is_empty() {
            blocks.push(Block::Heading("fit as well, and cannot be told from it".into()));
            let rival = |law: &Law| {
                let apart = law.ranked.apart.as_ref().map_or(String::new(), |own| format!("; {}", apart::words(own)));
                format!("{}   chi2/dof {:.3}{apart}", law.ranked.written.formula, law.reduced_chi2)
            };
            blocks.push(Block::List(rivals.iter().take(MOST_RIVALS).map(rival).collect()));
            let more = rivals.len().saturating_sub(MOST_RIVALS);
            blocks.extend((more > 0).then(|| Block::Sentence(format!("and {more} more"))));
        }
        blocks.extend(tried(found));
        if held_back.is_none() {
            let describes = "a law describes; it becomes a cause when somebody names what makes it";
            blocks.push(Block::Paragraph(describes.into()));
            blocks.push(Block::Commands(vec![
                self.command(best),
                format!(
                    "or with every value re-fitted: fem discover {} {} --add-to better.toml",
                    super::diagnosis::quoted(name),
                    with(data)
                ),
            ]));
        }
        blocks
    }

    /// `fem discover --json`: `fem-laws/1`.
    fn json(&self) -> Json {
        let Self(data, found) = *self;
        let law = |law: &Law, left_out: Option<LeftOut>| {
            json!({
                "observable": self.observable(law),
                "formula": law.ranked.written.formula,
                "variables": law.ranked.variables,
                "candidate": law.ranked.is_candidate.then_some(&law.ranked.name),
                "parameters": law.estimates.iter().map(estimate).collect::<Vec<_>>(),
                "chosen": law.ranked.known().map(|(name, value)| json!({ "parameter": name, "value": value })).collect::<Vec<_>>(),
                "chi2_per_dof": law.reduced_chi2,
                "p_value": law.p_value,
                "price": law.ranked.found.price,
                "criterion": law.ranked.criterion,
                "left_out": left_out.map(|own| json!({ "before": own.before, "after": own.after })),
                "apart": law.ranked.apart.as_ref().map(apart::json),
            })
        };
        let told = found.told();
        let features = told.map(
            |law| json!({ "coordinate": law.ranked.variables.join(" and "), "shape": null, "text": law.ranked.written.formula }),
        );
        let range = |(name, kind, [low, high]): &(String, Kind, [f64; 2])| json!({ "variable": name, "unit": kind.unit, "from": kind.from_si(*low), "to": kind.from_si(*high) });
        json!({
            "schema": "fem-laws/1",
            "model": &*data.model.source.name,
            "data": data.name,
            "files": files(data),
            "observations": data.len(),
            "verdict": match (found.is_nothing_left, told) {
                _ if !found.is_judged() => "not-judged",
                (true, _) => "adequate",
                (false, None) => "unexplained",
                (false, Some(_)) => "partly-explained",
            },
            "missing": [],
            "features": features.into_iter().collect::<Vec<_>>(),
            "chi2_per_dof_before": found.before,
            "variables_sought": found.sought,
            "like": told.and(found.like),
            "law": told.map(|best| law(best, found.left_out)),
            "held_back": self.held_back(),
            "wandering": found.wandering.map(|own| json!({ "size": own.size, "rows": own.memory })),
            "law_held_back": found.laws.first().filter(|_| told.is_none()).map(|best| law(best, found.left_out)),
            "rivals": found.laws.iter().skip(1).map(|rival| law(rival, None)).collect::<Vec<_>>(),
            "tried": found.tried.iter().map(|own| json!({
                "name": own.name,
                "chi2_per_dof": own.result.as_ref().ok(),
                "left_out_because": own.result.as_ref().err(),
            })).collect::<Vec<_>>(),
            "ranges": found.ranges.iter().map(range).collect::<Vec<_>>(),
            "command": told.map(|law| self.command(law)),
        })
    }

    fn progress(&self) -> Option<&Progress> {
        Some(&self.0.progress)
    }
}

/// What says more than any law: a zero that wanders.
fn wanders(own: &Wandering) -> String {
    format!(
        "a zero that wanders while rows are taken says more than laws that fit: {:.1} standard uncertainties of a row, \
         forgotten within some {:.0} rows; measure a master in between, or the rows in another order",
        own.size, own.memory
    )
}

/// What the laws came to that somebody has in mind.
fn tried(found: &Discovery) -> Vec<Block> {
    let line = |own: &Tried| match &own.result {
        Ok(reduced_chi2) => format!("{}   chi2/dof {reduced_chi2:.3}", own.name),
        Err(why) => format!("{}   left out: {why}", own.name),
    };
    match found.tried.is_empty() {
        true => Vec::new(),
        false => vec![Block::Heading("laws of your own".into()), Block::List(found.tried.iter().map(line).collect())],
    }
}

/// The variables among which laws were sought.
fn sought(found: &Discovery) -> String {
    found.sought.join(", ")
}

fn range((name, kind, [low, high]): &(String, Kind, [f64; 2])) -> String {
    let text = format!("{name} {:.4} to {:.4} {}", Short(kind.from_si(*low)), Short(kind.from_si(*high)), kind.unit);
    text.trim_end().to_string()
}
