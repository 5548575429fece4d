//! What a diagnosis says of effects that it does not name: ruled out, with the size from which they would have been
//! seen, or nothing that these data could show.

use super::kinds::is_grouped;
use super::words::percent;
use crate::diagnose::{Diagnosis, Outlook, RULED_OUT, Verdict};
use crate::input::Grows;
use crate::output::block::Block;
use crate::output::fit::Short;
use crate::output::number;
use crate::process::{Description, Neutral, ON_TRIAL, Parameter};

/// Effects that are not there.
pub struct Absent<'d> {
    /// Those that would have been seen; none while structure remains, which may hide effects, or where nothing is judged.
    pub ruled_out: Vec<&'d Outlook>,
    /// Those that these data could not show.
    pub unseen: Vec<&'d Outlook>,
}

impl<'d> Absent<'d> {
    /// Finds them among the candidates.
    pub fn of(d: &'d Diagnosis) -> Self {
        // That a value is right is no news.
        let is_absent = |c: &&Outlook| {
            let named = d.missing.iter().any(|m| m.effect == c.effect || m.indistinguishable_from.contains(&c.effect));
            c.effect.table != ON_TRIAL
                && !named
                && !is_grouped(d, &c.effect)
                && c.probability < RULED_OUT
                && c.detection_limit.is_some()
        };
        let would_show = |c: &&Outlook| c.detection_limit.as_ref().is_some_and(|v| v.detectable);
        let (mut ruled_out, unseen): (Vec<&Outlook>, Vec<&Outlook>) =
            d.candidates.iter().filter(is_absent).partition(would_show);
        // Of rows that tell nothing of the model nothing is ruled out either.
        if d.leaves_structure() || d.verdict == Verdict::NotJudged {
            ruled_out.clear();
        }
        Self { ruled_out, unseen }
    }
}

/// The detection limit of an effect with its parameter; empty where there is none.
pub fn limit(c: &Outlook) -> String {
    let smallest = c.detection_limit.as_ref().and_then(|v| Some((&v.parameter, v.smallest?)));
    smallest.map_or(String::new(), |(parameter, smallest)| bound(&c.effect, parameter, smallest))
}

/// The same behind the name of the effect in the place of that of the parameter.
pub fn limit_of_effect(c: &Outlook) -> String {
    let limit = limit(c);
    let size = limit.split_once(' ').map_or("", |(_, size)| size);
    format!("{} {size}", c.effect.label()).trim_end().to_string()
}

/// All of them, each in a line.
pub fn blocks(d: &Diagnosis) -> Vec<Block> {
    let Absent { ruled_out, unseen } = Absent::of(d);
    let mut blocks = Vec::new();
    if !ruled_out.is_empty() {
        let width = ruled_out.iter().map(|c| c.effect.label().len()).max().unwrap_or(0);
        let line = |c: &&Outlook| format!("{:<width$}  {}", c.effect.label(), limit(c));
        let heading = "not found, and nine times in ten it would have been, at a usual shape, from";
        blocks.extend([Block::Heading(heading.into()), Block::List(ruled_out.iter().map(line).collect())]);
    }
    if !unseen.is_empty() {
        let names: Vec<_> = unseen.iter().map(|c| c.effect.label()).collect();
        blocks.push(Block::Heading(format!("these data could not show: {}", names.join(", "))));
    }
    blocks
}

/// Writes a note on a candidate effect.
pub fn note(outlook: &Outlook, d: &Diagnosis) -> String {
    if d.missing.iter().any(|m| m.effect == outlook.effect) {
        return "missing".into();
    }
    let alternative = d.missing.iter().find(|m| m.indistinguishable_from.contains(&outlook.effect));
    if let Some(missing) = alternative {
        return format!("cannot be told from {} here", missing.effect.label());
    }
    if outlook.probability >= RULED_OUT {
        return format!("may be there: {}", percent(outlook.probability));
    }
    let Some(v) = &outlook.detection_limit else { return "it cannot be computed here".into() };
    if d.verdict == Verdict::NotJudged && v.detectable {
        return "not judged".into();
    }
    if d.leaves_structure() && v.detectable {
        return "not judged while structure remains".into();
    }
    match v.smallest.filter(|_| v.detectable) {
        Some(smallest) => format!("would have been seen from {} on", bound(&outlook.effect, &v.parameter, smallest)),
        None => "cannot be seen in these data".into(),
    }
}

/// Writes a detection limit: `rate >= 0.4 um/km`, for a stiffness `<=`.
pub fn bound(effect: &Description, parameter: &str, smallest: f64) -> String {
    let entry = effect.parameters.iter().find(|p| p.name == parameter);
    let unit = entry.map(|p| p.kind.unit).unwrap_or_default();
    let is_soft = |p: &Parameter| matches!(p.neutral, Neutral::Infinity | Neutral::Written(_, Grows::Inversely));
    let sign = if entry.is_some_and(is_soft) { "<=" } else { ">=" };
    let told = match entry.map(|p| p.neutral) {
        // A factor of 1.00042 is told by what it differs from 1.
        Some(Neutral::Value(neutral)) if neutral != 0.0 && smallest != neutral => {
            let digits = 1.0 - (smallest - neutral).abs().log10().floor();
            number::fixed(smallest, digits.clamp(0.0, 15.0) as usize)
        }
        _ => format!("{:.2}", Short(smallest)),
    };
    format!("{parameter} {sign} {told} {unit}").trim_end().to_string()
}
