//! All of a diagnosis for people: the story from the failing model to the noise.

use super::additions::name;
use super::commands::{commands, discover};
use super::verdict::verdict;
use super::words::{
    added, as_written, bent, chance, label, largest_change, like, moved, percent, rivals, traits, value_before,
};
use super::{absent, campaign};
use crate::diagnose::{CERTAIN, Cause, Diagnosis, GoodnessOfFit, Group, Missing, Next, Outlier, RULED_OUT, Verdict};
use crate::fit::Estimate;
use crate::input::Name;
use crate::model::{Data, Model};
use crate::output::block::{Block, Cell, Column, Table};
use crate::output::fit::Short;
use crate::output::listing::listed;
use crate::output::{comparison, measurement};
use crate::process::{Description, Holds};
use crate::units::Kind;

/// The story.
pub fn blocks(data: &Data, d: &Diagnosis) -> Vec<Block> {
    let (model, kind) = (data.model, data.kind());
    let mut blocks = vec![Block::Lines(head(data, d))];
    blocks.extend(d.cautions.iter().cloned().map(Block::Caution));
    blocks.push(Block::Heading(verdict(data, d)));
    blocks.extend(where_it_fails(d));
    blocks.extend((1..).zip(&d.missing).flat_map(|(number, missing)| cause(number, missing, data, d)));
    blocks.extend(shared(d));
    let mut fits = errors(model, d, kind, "");
    fits.rows.push(vec![Cell::Text("noise".into()), Cell::number(kind.from_si(d.noise.together()))]);
    blocks.extend([Block::Table(fits), Block::Sentence(format!("in {}", kind.unit))]);
    if model.campaign().is_some() {
        blocks.push(Block::Lines(campaign::fits(data, d)));
    }
    let moved = moved(d);
    if !moved.is_empty() {
        blocks.push(Block::Heading("roughly known values that the data move far".into()));
        blocks.push(Block::Lines(moved.iter().map(|own| format!("  {own}\n")).collect()));
    }
    if d.leaves_structure() {
        if !d.missing.is_empty() {
            let caution = "the intervals count the noise alone: what remains may have bent the values further";
            blocks.push(Block::Heading(caution.into()));
        }
        blocks.push(Block::Heading("what remains, described and not explained".into()));
        blocks.push(Block::Sentence(unexplained(data, d)));
        blocks.extend(own_effect(data, d));
    }
    blocks.extend(absent::blocks(d));
    let next = next_measurement(d);
    if !next.is_empty() {
        blocks.push(Block::Heading("measure next".into()));
    }
    blocks.extend(next);
    let commands = commands(data, d);
    if !commands.is_empty() {
        blocks.extend([Block::Heading("to go on".into()), Block::Commands(commands)]);
    }
    if d.trials.0 > 0 {
        let failed = format!("the model could not be computed at {} of {} trial values", d.trials.0, d.trials.1);
        blocks.push(Block::Heading(failed));
    }
    blocks
}

/// The model, its data, their noise, and what is known of both.
pub fn head(data: &Data, d: &Diagnosis) -> String {
    let (name, noise) = (&data.model.source.name, comparison::noise_of_both(d.noise_before(), &d.noise, data));
    let mut text = format!("{name} against {}: {} observations, {noise}\n", data.name, data.len());
    text += &measurement::at_work(name, &data.terms, &*data.model.process, Some(data));
    if let Some(machine) = data.model.machine.as_ref().filter(|_| data.model.campaign().is_some()) {
        let name = machine.name.as_ref().map_or(String::new(), |name| format!(", {name}"));
        text += &format!("tests of one machine: {}{name}\n", machine.path.display());
    }
    text
}

fn where_it_fails(d: &Diagnosis) -> Vec<Block> {
    if matches!(d.verdict, Verdict::Adequate | Verdict::NotJudged) {
        return Vec::new();
    }
    let mut blocks = vec![Block::Heading("where it fails, with what the model leaves open re-fitted".into())];
    if d.features.is_empty() {
        let is_of_noise = d.missing.iter().all(|m| matches!(m.cause, Cause::Measurement { .. }));
        let sentence = match d.before.is_as_noise() {
            true if is_of_noise => "along no coordinate: the noise is not what it is taken for",
            true => "along no coordinate by itself: what is missing is known by its shape alone",
            false => "more is left than the noise explains, but along no coordinate",
        };
        blocks.push(Block::Sentence(sentence.into()));
    }
    blocks.push(comparison::features(&d.features));
    blocks.extend(comparison::residual_curve(&d.features));
    blocks
}

fn cause(number: usize, missing: &Missing, data: &Data, d: &Diagnosis) -> Vec<Block> {
    let effect = &missing.effect;
    let what = if missing.describes() { "described" } else { "cause" };
    // What is in doubt is not what the catalogue says of it.
    let about = if missing.doubt.is_some() { String::new() } else { format!(", {}", effect.about) };
    let mut blocks = vec![Block::Heading(format!("{what} {number}: {}{about}", label(missing)))];
    if let Some(campaign) = data.model.campaign() {
        let places = campaign::places(campaign, data, missing).join(", in ");
        blocks.push(Block::Sentence(format!("in {places}")));
    }
    blocks.extend(as_written(missing).map(Block::Sentence));
    if let Cause::Law(law) = &missing.cause {
        blocks.push(Block::Sentence(added(law)));
    }
    blocks.push(Block::List(estimates(missing)));
    blocks.extend(largest_change(missing, data).map(|[moves, size]| Block::Sentence(format!("it {moves} {size}"))));
    blocks.push(Block::Sentence(chance(missing.p_value)));
    if missing.probability < CERTAIN {
        let percent = percent(missing.probability);
        blocks.push(Block::Sentence(format!("it is there with a probability of {percent}, over all sets of effects")));
    }
    blocks.extend(missing.bend.as_ref().map(|bend| Block::Sentence(bent(bend))));
    blocks.extend(like(missing).into_iter().chain(rivals(missing)).map(Block::Sentence));
    blocks.extend(missing.doubt.iter().map(|doubt| Block::Caution(doubt.clone())));
    for alternative in &missing.indistinguishable_from {
        let by = separated(effect, alternative).map_or(String::new(), |by| format!("; in general: {by}"));
        blocks.push(Block::Sentence(format!("or {}: these data cannot tell{by}", alternative.label())));
    }
    let outlying = match &missing.cause {
        Cause::Measurement { records, from: None, .. } => outlying(records, data, d),
        _ => Vec::new(),
    };
    let mut traits = traits(missing, data.model);
    let separates = traits.pop();
    blocks.extend([Block::List(traits), Block::List(outlying)]);
    blocks.extend(separates.map(Block::Sentence));
    blocks
}

/// What the sets of effects that fit share beyond the causes: groups of which some are there, and what may be.
pub fn shared(d: &Diagnosis) -> Vec<Block> {
    let mut blocks = Vec::new();
    if !d.posterior.groups.is_empty() {
        let line = |group: &Group| {
            let names = group.effects.iter().map(|name| &**name).collect::<Vec<_>>().join(", ");
            format!("at least {} of {names} ({})", group.at_least, percent(group.probability))
        };
        blocks.push(Block::Heading("these data cannot tell which of these are there".into()));
        blocks.push(Block::List(d.posterior.groups.iter().map(line).collect()));
    }
    let is_told = |name: &str| d.missing.iter().any(|m| m.effect.name == *name);
    let open = d.posterior.open().into_iter().filter(|(name, p)| *p >= RULED_OUT && !is_told(name));
    let open: Vec<String> = open.map(|(name, p)| format!("{name} {}", percent(p))).collect();
    if !open.is_empty() {
        blocks.push(Block::Heading(format!("these may be there: {}", open.join(", "))));
    }
    blocks
}

/// A line for each value of a missing effect, with its interval.
fn estimates(missing: &Missing) -> Vec<String> {
    let width = missing.estimates.iter().map(|e| name(e).len()).max().unwrap_or(0);
    let line = |e: &Estimate| {
        let k = e.parameter.kind;
        let before = value_before(missing, name(e)).unwrap_or_default();
        let value = format!("{before}{:.4} {}", Short(k.from_si(e.value)), k.unit);
        let end = |si: Option<f64>| si.map_or("open".into(), |v| format!("{:.4}", Short(k.from_si(v))));
        // The factor of outlying rows is set, and has no interval.
        let is_set =
            matches!(missing.cause, Cause::Measurement { .. }) && e.interval.low.is_none() && e.interval.high.is_none();
        let interval = match is_set {
            true => String::new(),
            false => format!(" 95 %: {} to {}", end(e.interval.low), end(e.interval.high)),
        };
        let warnings = if e.warnings.is_empty() { String::new() } else { format!("   ({})", e.warnings.join("; ")) };
        format!("{:<width$}  {:<20}{interval}{warnings}", name(e), value.trim_end()).trim_end().to_string()
    };
    missing.estimates.iter().map(line).collect()
}

/// Most outlying rows that are listed.
const MOST_ROWS: usize = 10;

/// Lists the outlying rows that stand in these records.
fn outlying(records: &[usize], data: &Data, d: &Diagnosis) -> Vec<String> {
    let own: Vec<&Outlier> = d.outliers.iter().filter(|o| records.contains(&o.record)).collect();
    let line = |o: &&Outlier| {
        let kind = data.observables[o.observable].kind;
        let [value, predicted] = [o.value, o.predicted].map(|si| kind.shown(si));
        let of = data.file_of_record(o.record - 1).map_or(String::new(), |name| format!(" of {name}"));
        let place = format!("{}{of}", o.line);
        format!("line {place:<5} {value:.3}, predicted {predicted:.3}")
    };
    let more = (own.len() > MOST_ROWS).then(|| format!("and {} more", own.len() - MOST_ROWS));
    own.iter().take(MOST_ROWS).map(line).chain(more).collect()
}

/// Finds what would separate two effects by the catalogue.
pub fn separated(one: &Description, other: &Description) -> Option<&'static str> {
    let said = |a: &Description, b: &str| a.look_alikes.iter().find(|l| l.0 == b).map(|l| l.1);
    let of_measurement = |d: &Description| measurement::entry_named(&d.name).map(|effect| effect.separates);
    let of_one = said(one, &other.name).or_else(|| said(other, &one.name));
    of_one.or_else(|| of_measurement(one)).or_else(|| of_measurement(other))
}

/// Pairs of a cause and what cannot be told from it, with what the catalogue says would separate them.
pub fn separated_pairs(d: &Diagnosis) -> Vec<[&str; 3]> {
    let pairs = d.missing.iter().flat_map(|m| m.indistinguishable_from.iter().map(move |other| (&m.effect, other)));
    pairs.filter_map(|(a, b)| Some([&*a.name, &*b.name, separated(a, b)?])).collect()
}

/// Pairs of what these data cannot tell apart, those of a group as well, with what the catalogue says would separate them.
fn left_open(d: &Diagnosis) -> Vec<[&str; 3]> {
    let described = |name: &Name| d.candidates.iter().map(|c| &c.effect).find(|effect| effect.name == *name);
    let mut pairs = separated_pairs(d);
    for group in &d.posterior.groups {
        let members: Vec<&Description> = group.effects.iter().filter_map(described).collect();
        for (i, one) in members.iter().enumerate() {
            let others = members[i + 1..].iter();
            pairs.extend(others.filter_map(|other| Some([&*one.name, &*other.name, separated(one, other)?])));
        }
    }
    let mut seen: Vec<[&str; 2]> = Vec::new();
    pairs.retain(|[a, b, _]| {
        let is_new = !seen.contains(&[a, b]) && !seen.contains(&[b, a]);
        seen.push([a, b]);
        is_new
    });
    pairs
}

/// Pairs that something else tells than the next rows: where none are advised all that are left open, else those of which
/// one is the measurement's.
pub fn told_otherwise(d: &Diagnosis) -> Vec<[&str; 3]> {
    let is_of_measurement = |[a, b, _]: &[&str; 3]| [a, b].iter().any(|name| measurement::entry_named(name).is_some());
    match &d.next {
        Some(_) => separated_pairs(d).into_iter().filter(is_of_measurement).collect(),
        None => left_open(d),
    }
}

/// What separates pairs of effects.
pub fn separations(pairs: &[[&str; 3]]) -> Block {
    Block::List(pairs.iter().map(|[one, other, by]| format!("{one} from {other}: {by}")).collect())
}

/// The falling error: the model re-fitted, and with each missing effect added. The last column is headed by the
/// coordinate of which levels were held out, or by `unknown`.
pub fn errors(model: &Model, d: &Diagnosis, kind: Kind, unknown: &str) -> Table {
    let sigma = kind.from_si(d.noise.together());
    let row = |(label, goodness): (String, &GoodnessOfFit)| {
        let held_out = goodness.cross_validation.map_or(f64::NAN, |held| held * sigma);
        // As many parameters as conditions leave no lack of fit to judge.
        let [chi2, held_out] = [goodness.reduced_chi2, held_out].map(Cell::finite);
        vec![Cell::Text(label), Cell::number(kind.from_si(goodness.rms)), chi2, held_out]
    };
    let first = (format!("{} re-fitted", model.source.name), &d.before);
    let added = d.missing.iter().map(|m| (format!("+ {}", label(m)), &m.goodness));
    let held = d.cross_validation_by.as_ref().map_or(unknown.to_string(), |by| format!("held out by {by}"));
    let numbers = ["rms", "chi2/dof"].map(|name| Column::new(name, 11));
    let columns = [Column::wide("model")].into_iter().chain(numbers).chain([Column::remark(held, 11)]);
    let unit = kind.unit;
    let caption = format!("Every step is fitted anew to all rows; errors in {unit}, noise {sigma:.3} {unit}");
    Table { caption, ..Table::new(columns, [first].into_iter().chain(added).map(row)) }
}

/// Describes the structure that remains.
pub fn unexplained(data: &Data, d: &Diagnosis) -> String {
    match &d.remaining[..] {
        [] if !d.suspects.is_empty() => {
            let all = d.suspects.iter().map(|term| measurement::words(term, &*data.model.process, Some(data)));
            format!("the noise is not what it is taken for: the rows ask for {}", all.collect::<Vec<_>>().join("; "))
        }
        [] if d.after.is_as_noise() => "nothing but noise beside what is described and not explained".into(),
        [] => "more is left than the noise explains, but along no coordinate".into(),
        features => features.iter().map(|f| f.text.clone()).collect::<Vec<_>>().join("; "),
    }
}

/// Shows how to write a cause that is not in the catalogue: over a coordinate along which structure remains,
/// or else over any of the file's.
fn own_effect(data: &Data, d: &Diagnosis) -> Option<Block> {
    let coordinates = data.model.process.coordinates();
    let kind = |i: usize| match &coordinates[i].holds {
        Holds::Quantity(kind) => Some((&coordinates[i].name, *kind)),
        Holds::Number(_) | Holds::Word(_) => None,
    };
    let remaining = d.remaining.iter().flat_map(|f| f.along.0.iter().copied());
    let (name, along) = remaining.chain(data.given.iter().copied()).find_map(kind)?;
    let unit = data.observables[0].kind.unit;
    Some(Block::Lines(format!(
        "  {}if you know the cause, write it into the model and diagnose again:\n    [effects.my-cause]\n    formula = \
         \"a*sin(2*pi*{name}/p)\"   # over coordinates and these parameters\n    a = \"? {unit}\"\n    p = \"? {}\"\n",
        discover(data, d)
            .iter()
            .map(|own| format!("a law over all columns is sought by {own}\n  "))
            .collect::<String>(),
        along.unit
    )))
}

/// What is said before what else would tell, where no rows are advised: none would tell more, or the time was over
/// before they were looked for.
pub const NO_ROWS_ADVISED: &str = "no further rows are advised";

/// The next measurement, and what separates effects of the machine from those of the measurement.
pub fn next_measurement(d: &Diagnosis) -> Vec<Block> {
    let mut blocks = Vec::new();
    if let Some(next) = &d.next {
        blocks.push(Block::Sentence(experiment(next)));
        blocks.extend(told_by(next, usize::MAX).into_iter().map(Block::Sentence));
    }
    let pairs = told_otherwise(d);
    if !pairs.is_empty() {
        blocks.extend(d.next.is_none().then(|| Block::Sentence(NO_ROWS_ADVISED.into())));
        blocks.push(separations(&pairs));
    }
    blocks
}

/// The experiment to do next, with the number of its rows and the time that it costs.
pub fn experiment(next: &Next) -> String {
    let all = if next.steps > 1 { "all of it " } else { "" };
    let often = if next.repeats > 1 { format!(", {all}{} times", next.repeats) } else { String::new() };
    format!("{}{often}: {} rows, {}", next.experiment.words, next.observations(), about(next.cost()))
}

/// A time (s) that is roughly known.
fn about(time: f64) -> String {
    /// From here on in hours, min.
    const LONG: f64 = 100.0;
    let minutes = time / 60.0;
    if minutes < LONG { format!("about {minutes:.0} min") } else { format!("about {:.0} h", minutes / 60.0) }
}

/// What it tells: how many sets it is expected to leave, and the effects that it tells apart, up to so many.
pub fn told_by(next: &Next, most: usize) -> Vec<String> {
    let sets = next.sets.map(|(now, then)| {
        let counted = |sets: f64| format!("{:.0}", sets.max(1.0));
        format!("of what counts as {} sets that fit equally it is expected to leave {}", counted(now), counted(then))
    });
    let tells = if next.enough { "tells" } else { "helps to tell, though not enough," };
    let told = told_apart(next);
    let apart =
        (!told.is_empty()).then(|| format!("it {tells} {}, by {:.1} sigma", listed(&told, most), next.separation));
    sets.into_iter().chain(apart).collect()
}

/// The effects that it tells apart, and those of which it tells whether they are there.
pub fn told_apart(next: &Next) -> Vec<String> {
    let pairs = next.pairs.iter().map(|(a, b)| format!("{} from {}", a.label(), b.label()));
    pairs.chain(next.whether.iter().map(|effect| format!("whether {} is there", effect.label()))).collect()
}
