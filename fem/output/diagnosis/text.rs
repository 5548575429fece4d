//! Writes a diagnosis for people: the story from the failing model to the noise.

use std::fmt::Write;

use super::additions::name;
use super::campaign;
use super::commands::commands;
use crate::diagnose::{Cause, Diagnosis, GoodnessOfFit, Missing, Outlier, Outlook, Verdict};
use crate::model::{Data, Model};
use crate::output::comparison;
use crate::output::fit::Short;
use crate::output::{measurement, number, plot};
use crate::process::{Description, Holds, Neutral, Plot};
use crate::units::Kind;

/// Writes the story. Writing to a String does not fail, here and below.
pub fn text(data: &Data, diagnosis: &Diagnosis, columns: usize) -> String {
    let (d, kind) = (diagnosis, data.kind());
    let noise = comparison::noise_text(&d.noise, data);
    let mut text =
        format!("{} against {}: {} observations, noise {noise}\n", data.model.source.name, data.name, data.len());
    text.push_str(&measurement::at_work(&data.model.source.name, &data.terms, &*data.model.process, Some(data)));
    if let Some(machine) = data.model.machine.as_ref().filter(|_| data.model.campaign.is_some()) {
        let name = machine.name.as_ref().map_or(String::new(), |name| format!(", {name}"));
        let _ = writeln!(text, "tests of one machine: {}{name}", machine.path.display());
    }
    for caution in &d.cautions {
        let _ = writeln!(text, "\ncaution: {caution}");
    }
    let _ = writeln!(text, "\n{}", verdict(d));
    where_it_fails(&mut text, d, columns);
    for (i, missing) in d.missing.iter().enumerate() {
        cause(&mut text, i + 1, missing, data, d);
    }
    errors(&mut text, data.model, d, kind);
    if data.model.campaign.is_some() {
        campaign::fits(&mut text, data, d);
    }
    if structure_remains(d) {
        if !d.missing.is_empty() {
            let _ =
                writeln!(text, "\nthe intervals count the noise alone: what remains may have bent the values further");
        }
        let _ = writeln!(text, "\nwhat remains, described and not explained\n  {}", unexplained(data, d));
        own_effect(&mut text, data, d);
    }
    not_seen(&mut text, d);
    measure_next(&mut text, d);
    commands(&mut text, data, d);
    if d.trials.0 > 0 {
        let _ = writeln!(text, "\nthe model could not be computed at {} of {} trial values", d.trials.0, d.trials.1);
    }
    text
}

fn structure_remains(d: &Diagnosis) -> bool {
    matches!(d.verdict, Verdict::PartlyExplained | Verdict::Unexplained)
}

pub fn verdict(d: &Diagnosis) -> String {
    let names = d.missing.iter().map(|m| &*m.effect.name).collect::<Vec<_>>().join(", ");
    match d.verdict {
        Verdict::Adequate => "nothing is missing: the noise explains what the model leaves".into(),
        Verdict::MissingEffect => {
            let them = if d.missing.len() == 1 { "it" } else { "them" };
            format!("missing: {names}; with {them} the model comes down to the noise")
        }
        Verdict::PartlyExplained => format!("partly explained: {names}; structure remains"),
        Verdict::Unexplained => "unexplained: the model fails, and no effect known here is the cause".into(),
    }
}

fn where_it_fails(text: &mut String, d: &Diagnosis, columns: usize) {
    if d.verdict == Verdict::Adequate {
        return;
    }
    let _ = writeln!(text, "\nwhere it fails, with what the model leaves open re-fitted");
    if d.features.is_empty() {
        let is_of_noise = d.missing.iter().all(|m| m.cause != Cause::Physical);
        let _ = match d.before.is_as_noise() {
            true if is_of_noise => writeln!(text, "  along no coordinate: the noise is not what it is taken for"),
            true => writeln!(text, "  along no coordinate by itself: what is missing is known by its shape alone"),
            false => writeln!(text, "  more is left than the noise explains, but along no coordinate"),
        };
    }
    for feature in comparison::notable_features(&d.features) {
        let _ = writeln!(text, "  {:>3.0} %  {}", 100.0 * feature.share, feature.text);
    }
    if let Some(feature) = d.features.iter().find(|f| f.curve.len() > 2) {
        let title = format!("residual [{}] over {}, mean of the rows there", feature.unit, feature.coordinate);
        let plot = Plot { title, x_unit: "", points: feature.curve.clone() };
        let _ = writeln!(text, "\n{}", plot::lines(&plot, columns).join("\n"));
    }
}

/// A missing effect in a few words, with what groups the rows: `zero-shift by run`.
pub fn label(missing: &Missing) -> String {
    match &missing.cause {
        Cause::Physical => missing.effect.name.to_string(),
        Cause::Measurement { by, observable, along, period, .. } => {
            let of = observable.clone().map_or(String::new(), |name| format!(" of {name}"));
            let along = along.clone().map_or(String::new(), |name| format!(" along {name}"));
            let period = period.map_or(String::new(), |(period, kind)| {
                format!(", once in {:.4} {}", Short(kind.from_si(period)), kind.unit)
            });
            format!("{}{}{along}{of}{period}", missing.effect.name, measurement::grouped(by))
        }
    }
}

fn cause(text: &mut String, number: usize, missing: &Missing, data: &Data, d: &Diagnosis) {
    let effect = &missing.effect;
    let what = if missing.describes() { "described" } else { "cause" };
    let _ = writeln!(text, "\n{what} {number}: {}, {}", label(missing), effect.about);
    if let Some(campaign) = &data.model.campaign {
        let _ = writeln!(text, "  in {}", campaign::places(campaign, data, missing).join(", in "));
    }
    let width = missing.estimates.iter().map(|e| name(e).len()).max().unwrap_or(0);
    for e in &missing.estimates {
        let k = e.parameter.kind;
        let value = format!("{:.4} {}", Short(k.from_si(e.value)), k.unit);
        let end = |si: Option<f64>| si.map_or("open".into(), |v| format!("{:.4}", Short(k.from_si(v))));
        // The factor of outlying rows is set, and has no interval.
        let is_set = missing.cause != Cause::Physical && e.interval.low.is_none() && e.interval.high.is_none();
        let interval = match is_set {
            true => String::new(),
            false => format!(" 95 %: {} to {}", end(e.interval.low), end(e.interval.high)),
        };
        let warnings = if e.warnings.is_empty() { String::new() } else { format!("   ({})", e.warnings.join("; ")) };
        let line = format!("  {:<width$}  {:<20}{interval}{warnings}", name(e), value.trim_end());
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let _ = writeln!(text, "  {}", chance(missing.p_value));
    if let Some(bend) = &missing.bend {
        let along = bend.along.clone().map_or("with its own size".into(), |name| format!("along {name}"));
        let share = 100.0 * bend.share;
        let _ = writeln!(text, "  its shape is not wholly this law: it bends {along}, by up to {share:.0} % of itself");
    }
    for alternative in &missing.indistinguishable_from {
        let by = separated(effect, alternative).map_or(String::new(), |by| format!("; in general: {by}"));
        let _ = writeln!(text, "  or {}: these data cannot tell{by}", alternative.label());
    }
    if let Cause::Measurement { effect, by, records, from, .. } = &missing.cause {
        if let Some((name, about)) = measurement::curve(effect, by, &*data.model.process) {
            let _ = writeln!(text, "  in this process a {name}: {about}");
        }
        if let Some(place) = from {
            let _ = writeln!(text, "  from {place} on");
        } else {
            outlying(text, records, data, d);
        }
        let _ = writeln!(text, "  what separates it from effects of the machine: {}", effect.separates);
    }
}

/// Most outlying rows that are listed.
const MOST_ROWS: usize = 10;

/// Lists the outlying rows that stand in these records.
fn outlying(text: &mut String, records: &[usize], data: &Data, d: &Diagnosis) {
    let own: Vec<&Outlier> = d.outliers.iter().filter(|o| records.contains(&o.record)).collect();
    for o in own.iter().take(MOST_ROWS) {
        let kind = data.observables[o.observable].kind;
        let [value, predicted] = [o.value, o.predicted].map(|si| kind.shown(si));
        let of = data.file_of_record(o.record - 1).map_or(String::new(), |name| format!(" of {name}"));
        let place = format!("{}{of}", o.line);
        let _ = writeln!(text, "  line {place:<5} {value:.3}, predicted {predicted:.3}");
    }
    if own.len() > MOST_ROWS {
        let _ = writeln!(text, "  and {} more", own.len() - MOST_ROWS);
    }
}

/// Finds what would separate two effects by the catalogue.
pub fn separated(one: &Description, other: &Description) -> Option<&'static str> {
    let said = |a: &Description, b: &str| a.look_alikes.iter().find(|l| l.0 == b).map(|l| l.1);
    let of_measurement = |d: &Description| measurement::entry_named(&d.name).map(|effect| effect.separates);
    let of_one = said(one, &other.name).or_else(|| said(other, &one.name));
    of_one.or_else(|| of_measurement(one)).or_else(|| of_measurement(other))
}

/// Pairs of a cause and what cannot be told from it of which one is the measurement's, with what the catalogue
/// says would separate them.
pub fn separated_pairs(d: &Diagnosis) -> Vec<(&str, &str, &'static str)> {
    let pairs = d.missing.iter().flat_map(|m| m.indistinguishable_from.iter().map(move |other| (&m.effect, other)));
    let is_one =
        |(a, b): &(&Description, &Description)| [a, b].iter().any(|d| measurement::entry_named(&d.name).is_some());
    pairs.filter(is_one).filter_map(|(a, b)| Some((&*a.name, &*b.name, separated(a, b)?))).collect()
}

/// Writes the p-value of an effect.
pub fn chance(p: f64) -> String {
    match p {
        p if p < 1e-6 => "chance alone gives as much in less than one search in a million".into(),
        p => format!("chance alone gives as much in one search of {:.0}", (1.0 / p).max(1.0)),
    }
}

/// Writes the table of the falling error.
fn errors(text: &mut String, model: &Model, d: &Diagnosis, kind: Kind) {
    let first = format!("{} re-fitted", model.source.name);
    let labels = d.missing.iter().map(|m| format!("+ {}", label(m)));
    let lines: Vec<(String, &GoodnessOfFit)> = std::iter::once(first)
        .chain(labels)
        .zip(std::iter::once(&d.before).chain(d.missing.iter().map(|m| &m.goodness)))
        .collect();
    let width = lines.iter().map(|l| l.0.chars().count()).max().unwrap_or(0).max(5);
    let held = d.cross_validation_by.clone().map_or(String::new(), |by| format!("held out by {by}"));
    let _ = writeln!(text, "\n  {:<width$} {:>11} {:>11}   {held}", "model", "rms", "chi2/dof");
    let sigma = kind.from_si(d.noise.together());
    for (label, goodness) in lines {
        let out = number::or_dash(goodness.cross_validation.map_or(f64::NAN, |held| held * sigma), 3);
        // As many parameters as conditions leave no lack of fit to judge.
        let chi2 = number::or_dash(goodness.reduced_chi2, 3);
        let _ = writeln!(text, "  {label:<width$} {:>11.3} {chi2:>11}   {out:>11}", kind.from_si(goodness.rms));
    }
    let _ = writeln!(text, "  {:<width$} {sigma:>11.3}", "noise");
    let _ = writeln!(text, "  in {}", kind.unit);
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
fn own_effect(text: &mut String, data: &Data, d: &Diagnosis) {
    let coordinates = data.model.process.coordinates();
    let kind = |i: usize| match coordinates[i].holds {
        Holds::Quantity(kind) => Some((&coordinates[i].name, kind)),
        Holds::Number(_) | Holds::Word(_) => None,
    };
    let remaining = d.remaining.iter().flat_map(|f| f.along.0.iter().copied());
    let Some((name, along)) = remaining.chain(data.given.iter().copied()).find_map(kind) else { return };
    let unit = data.observables[0].kind.unit;
    let _ = writeln!(
        text,
        "  if you know the cause, write it into the model and diagnose again:\n    [effects.my-cause]\n    formula = \
         \"a*sin(2*pi*{name}/p)\"   # over coordinates and these parameters\n    a = \"? {unit}\"\n    p = \"? {}\"",
        along.unit
    );
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
    let Some(v) = &outlook.detection_limit else { return "it cannot be computed here".into() };
    if structure_remains(d) && v.detectable {
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
    let unit = entry.map_or("", |p| &p.kind.unit);
    let sign = if entry.is_some_and(|p| p.neutral == Neutral::Infinity) { "<=" } else { ">=" };
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

fn not_seen(text: &mut String, d: &Diagnosis) {
    let absent = |c: &&Outlook| {
        let named = d.missing.iter().any(|m| m.effect == c.effect || m.indistinguishable_from.contains(&c.effect));
        !named && c.detection_limit.is_some()
    };
    let rest: Vec<&Outlook> = d.candidates.iter().filter(absent).collect();
    let seen = |c: &&&Outlook| c.detection_limit.as_ref().is_some_and(|v| v.detectable);
    // Structure that remains may hide effects.
    if rest.iter().any(|c| seen(&c)) && !structure_remains(d) {
        let _ = writeln!(text, "\nnot found, and nine times in ten it would have been, at a usual shape, from");
        let width = rest.iter().map(|c| c.effect.label().len()).max().unwrap_or(0);
        for c in rest.iter().filter(seen) {
            let v = c.detection_limit.as_ref().and_then(|v| v.smallest.map(|s| bound(&c.effect, &v.parameter, s)));
            let _ = writeln!(text, "  {:<width$}  {}", c.effect.label(), v.unwrap_or_default());
        }
    }
    let hidden: Vec<_> = rest.iter().filter(|c| !seen(c)).map(|c| c.effect.label()).collect();
    if !hidden.is_empty() {
        let _ = writeln!(text, "\nthese data could not show: {}", hidden.join(", "));
    }
}

fn measure_next(text: &mut String, d: &Diagnosis) {
    let said = separated_pairs(d);
    let Some(next) = &d.next else {
        if !said.is_empty() {
            let _ = writeln!(text, "\nmeasure next");
        }
        return say_separated(text, &said);
    };
    let pairs: Vec<String> = next.pairs.iter().map(|(a, b)| format!("{} from {}", a.label(), b.label())).collect();
    let often = if next.repeats > 1 { format!(", {} times", next.repeats) } else { String::new() };
    let tells = if next.enough { "tells" } else { "helps to tell, though not enough," };
    let _ = writeln!(
        text,
        "\nmeasure next\n  {}{often}: {} rows\n  it {tells} {}, by {:.1} sigma",
        next.experiment.words,
        next.observations(),
        pairs.join(", "),
        next.separation
    );
    say_separated(text, &said);
}

/// Writes what separates effects of the machine from those of the measurement.
fn say_separated(text: &mut String, said: &[(&str, &str, &str)]) {
    for (one, other, by) in said {
        let _ = writeln!(text, "  {one} from {other}: {by}");
    }
}
