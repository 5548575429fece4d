//! A diagnosis that a person reads: the verdict, what is certain, what is not, and how to go on.

use super::absent::{Absent, limit_of_effect};
use super::additions::name;
use super::campaign;
use super::commands::{command, discover, next_rows};
use super::kinds::{Kinds, Open};
use super::text::{NO_ROWS_ADVISED, experiment, head, told_by, told_otherwise, unexplained};
use super::verdict::verdict;
use super::words::{added, as_written, bent, label, largest_change, like, moved, percent, rivals, value_before};
use crate::diagnose::{Cause, Diagnosis, Group, Missing, Next, Outlier};
use crate::fit::Estimate;
use crate::input::Name;
use crate::model::Data;
use crate::output::block::Block;
use crate::output::fit::Short;
use crate::output::listing::listed;
use crate::output::text::whole;

/// Most members of a group and most open effects that are listed: two or three lines.
const MANY: usize = 6;
/// Most effects that are not there, and most outlying rows, that are listed.
const SEVERAL: usize = 4;
/// Most look-alikes, most pairs of effects, and most of what is hardly likely or remains, that are
/// listed.
const FEW: usize = 2;
/// Characters up to which an entry has room for what an effect is: two lines; and most causes up to which each has.
const ROOM: usize = 165;
const MOST_EXPLAINED: usize = 3;

/// The answer in some 25 lines.
pub fn blocks(data: &Data, d: &Diagnosis) -> Vec<Block> {
    let mut blocks = vec![Block::Lines(head(data, d)), Block::Paragraph(verdict(data, d))];
    blocks.extend(d.cautions.iter().cloned().map(Block::Caution));
    let entries = entries(data, d);
    if !entries.is_empty() {
        blocks.push(Block::Entries(entries));
    }
    blocks.push(Block::Heading("to go on".into()));
    let rest = match data.model.campaign() {
        Some(_) if !d.missing.is_empty() => "all of it, and the commands that complete each model: --verbose",
        _ => "all of it: --verbose",
    };
    let further = [command(data, d), next_rows(data, d), Some(rest.into())];
    blocks.push(Block::Commands(discover(data, d).into_iter().chain(further.into_iter().flatten()).collect()));
    blocks
}

/// The kinds of effects, what remains and what to measure next, each behind its label.
fn entries(data: &Data, d: &Diagnosis) -> Vec<(String, String)> {
    let kinds = Kinds::of(d);
    let mut entries = Vec::new();
    let mut tell = |label: &str, texts: Vec<String>| {
        let labels = std::iter::once(label).chain(std::iter::repeat(""));
        entries.extend(labels.zip(texts).map(|(label, text)| (label.to_string(), text)));
    };
    tell("certain", kinds.certain.iter().map(|m| cause(m, data, d)).collect());
    tell("described", kinds.described.iter().map(|m| cause(m, data, d)).collect());
    tell("group", d.posterior.groups.iter().map(|group| some_of(group, d)).collect());
    tell("open", open(&kinds.open));
    let moved = moved(d);
    tell("moved", (!moved.is_empty()).then(|| listed(&moved, SEVERAL)).into_iter().collect());
    if d.leaves_structure() {
        tell("remains", vec![remains(data, d)]);
    }
    let Absent { mut ruled_out, unseen } = Absent::of(d);
    ruled_out.sort_by(|a, b| b.probability.total_cmp(&a.probability));
    let limits: Vec<String> = ruled_out.iter().map(|c| whole(&limit_of_effect(c))).collect();
    let number = if limits.len() == 1 { "1 effect".into() } else { format!("{} effects", limits.len()) };
    let seen = format!("{number}, which would have been seen from: {}", listed(&limits, SEVERAL));
    tell("ruled out", (!limits.is_empty()).then_some(seen).into_iter().collect());
    let unseen: Vec<_> = unseen.iter().map(|c| c.effect.label()).collect();
    let hidden = || format!("by these data: {}", listed(&unseen, SEVERAL));
    tell("not shown", (!unseen.is_empty()).then(hidden).into_iter().collect());
    tell("measure next", measure_next(d).into_iter().collect());
    entries
}

/// A cause with its values, what it does to the part, what looks like it, and what it is where there is room.
fn cause(missing: &Missing, data: &Data, d: &Diagnosis) -> String {
    let mut text = label(missing);
    if let Some(campaign) = data.model.campaign() {
        text += &format!(" in {}", campaign::places(campaign, data, missing).join(", "));
    }
    let sizes = missing.estimates.iter().map(|e| estimate(e, missing));
    let values: Vec<String> = match &missing.cause {
        Cause::Law(law) => [added(law)].into_iter().chain(sizes).collect(),
        Cause::Measurement { from: Some(place), .. } => [format!("from {place} on")].into_iter().chain(sizes).collect(),
        // The factor of outlying rows is set, and says nothing of them.
        Cause::Measurement { records, .. } if !records.is_empty() => vec![lines(records, data, d)],
        _ => as_written(missing).into_iter().chain(sizes).collect(),
    };
    text += &format!(": {}", values.join(", "));
    text += &largest_change(missing, data).map_or(String::new(), |[moves, size]| format!("; {moves} {}", whole(&size)));
    if !missing.indistinguishable_from.is_empty() {
        let others: Vec<_> = missing.indistinguishable_from.iter().map(|other| other.label()).collect();
        text += &format!("; alike here: {}", listed(&others, FEW));
    }
    text += &missing.bend.as_ref().map_or(String::new(), |bend| format!("; {}", bent(bend)));
    text += &like(missing).map_or(String::new(), |like| format!("; {like}"));
    text += &rivals(missing).map_or(String::new(), |rivals| format!("; {rivals}"));
    if let Some(doubt) = &missing.doubt {
        return format!("{text}; {doubt}");
    }
    let about = &missing.effect.about;
    let has_room = d.missing.len() <= MOST_EXPLAINED && text.chars().count() + about.chars().count() < ROOM;
    if has_room { format!("{text}; {about}") } else { text }
}

/// A value with its interval: `stiffness 30.4 [29.2, 31.7] N/um`.
fn estimate(e: &Estimate, missing: &Missing) -> String {
    let k = e.parameter.kind;
    let step = missing.effect.parameters.iter().find(|p| p.is_step && p.name == name(e));
    let short = |si: f64| match step {
        Some(_) => format!("{:.0}", k.from_si(si)),
        None => format!("{:.4}", Short(k.from_si(si))),
    };
    let along = step.and_then(|p| p.along.as_ref()).map_or(String::new(), |along| format!(" {along}"));
    let end = |si: Option<f64>| si.map_or("open".into(), short);
    let interval = match (e.interval.low, e.interval.high) {
        (None, None) if !matches!(missing.cause, Cause::Measurement { .. }) => " [open]".into(),
        (None, None) => String::new(),
        (low, high) => format!(" [{}, {}]", end(low), end(high)),
    };
    let before = value_before(missing, name(e)).unwrap_or_default();
    whole(format!("{}{along} {before}{}{interval} {}", name(e), short(e.value), k.unit).trim_end())
}

/// The lines of outlying rows.
fn lines(records: &[usize], data: &Data, d: &Diagnosis) -> String {
    let line = |o: &Outlier| {
        let of = data.file_of_record(o.record - 1).map_or(String::new(), |name| format!(" of {name}"));
        format!("{}{of}", o.line)
    };
    let own = d.outliers.iter().filter(|o| records.contains(&o.record));
    let lines: Vec<String> = own.map(line).collect();
    format!("{} {}", if lines.len() == 1 { "line" } else { "lines" }, listed(&lines, SEVERAL))
}

/// Effects of which some are there.
pub fn some_of(group: &Group, d: &Diagnosis) -> String {
    let members: Vec<String> =
        group.effects.iter().map(|name| whole(&format!("{name} {}", percent(d.posterior.of(name))))).collect();
    let (least, count, sure) = (group.at_least, members.len(), percent(group.probability));
    let are = if least == 1 { "is there, perhaps several" } else { "are there, perhaps more" };
    let is_added = |name: &&Name| d.missing.iter().any(|m| m.effect.name == **name);
    let added: Vec<&Name> = group.effects.iter().filter(is_added).collect();
    let taken =
        if added.is_empty() { String::new() } else { format!("; a completed model has {}", listed(&added, MANY)) };
    format!("at least {least} of these {count} {are} ({sure}): {}{taken}", listed(&members, MANY))
}

/// What may be there, and apart from it that for which the data hardly speak.
fn open(all: &[Open]) -> Vec<String> {
    let (notable, others): (Vec<&Open>, Vec<&Open>) = all.iter().partition(|open| open.is_notable());
    let notable: Vec<String> =
        notable.iter().map(|o| whole(&format!("{} {}", o.label, percent(o.probability)))).collect();
    let before = |o: &Open| o.before.map_or(String::new(), |p| format!(" (before: {})", percent(p)));
    let others: Vec<String> =
        others.iter().map(|o| whole(&format!("{} {}{}", o.label, percent(o.probability), before(o)))).collect();
    let told = |words: &str, some: &[String], most: usize| {
        (!some.is_empty()).then(|| format!("{words}: {}", listed(some, most)))
    };
    let found = told("may be there", &notable, MANY);
    found.into_iter().chain(told("hardly more likely than before the data", &others, FEW)).collect()
}

/// The structure that remains.
fn remains(data: &Data, d: &Diagnosis) -> String {
    match &d.remaining[..] {
        [] => unexplained(data, d),
        features => listed(&features.iter().map(|f| &*f.text).collect::<Vec<_>>(), FEW),
    }
}

/// The next measurement, or what else would tell what is left alike.
fn measure_next(d: &Diagnosis) -> Option<String> {
    let told = |next: &Next| std::iter::once(experiment(next)).chain(told_by(next, FEW)).collect::<Vec<_>>().join("; ");
    let separated = || {
        let pairs = told_otherwise(d);
        let told: Vec<String> = pairs.iter().map(|[one, other, by]| format!("{one} from {other}: {by}")).collect();
        (!told.is_empty()).then(|| format!("{NO_ROWS_ADVISED}; {}", listed(&told, FEW)))
    };
    d.next.as_ref().map(told).or_else(separated)
}
