//! A diagnosis for people: the story from the failing model to the noise.

use std::fmt::Write;
use std::path::Path;

use crate::diagnose::{Diagnosis, Missing, Outlook, State, Verdict};
use crate::fit::{Estimate, Fit};
use crate::measure::Measurements;
use crate::model::{Model, Setting};
use crate::output::comparison;
use crate::output::fit::Short;
use crate::output::plot;
use crate::process::{Description, Holds, Neutral, Plot};
use crate::units::{Kind, Knowledge};

/// The story. Writing to a String does not fail, here and below.
pub fn text(model: &Model, measurements: &Measurements, diagnosis: &Diagnosis) -> String {
    let (d, kind) = (diagnosis, measurements.kind());
    let noise = comparison::noise_text(&d.noise, measurements);
    let mut text = format!(
        "{} against {}: {} observations, noise {noise}\n",
        model.source.name,
        measurements.name,
        measurements.len()
    );
    for caution in &d.cautions {
        let _ = writeln!(text, "\ncaution: {caution}");
    }
    let _ = writeln!(text, "\n{}", verdict(d));
    where_it_fails(&mut text, d);
    for (i, missing) in d.missing.iter().enumerate() {
        cause(&mut text, i + 1, missing);
    }
    errors(&mut text, model, d, kind);
    if structure_remains(d) {
        if !d.missing.is_empty() {
            let _ =
                writeln!(text, "\nthe intervals count the noise alone: what remains may have bent the values further");
        }
        let _ = writeln!(text, "\nwhat remains, described and not explained\n  {}", unexplained(d));
        own_effect(&mut text, model, measurements, d);
    }
    not_seen(&mut text, d);
    measure_next(&mut text, d);
    commands(&mut text, model, measurements, d);
    if d.trials.0 > 0 {
        let _ = writeln!(text, "\nthe model could not be computed at {} of {} trial values", d.trials.0, d.trials.1);
    }
    text
}

fn structure_remains(d: &Diagnosis) -> bool {
    matches!(d.verdict, Verdict::PartlyExplained | Verdict::Unexplained)
}

fn verdict(d: &Diagnosis) -> String {
    let names = d.missing.iter().map(|m| m.effect.name).collect::<Vec<_>>().join(", ");
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

fn where_it_fails(text: &mut String, d: &Diagnosis) {
    if d.verdict == Verdict::Adequate {
        return;
    }
    let _ = writeln!(text, "\nwhere it fails, with what the model leaves open re-fitted");
    if d.features.is_empty() {
        let _ = writeln!(text, "  more is left than the noise explains, but along no coordinate");
    }
    for feature in comparison::told(&d.features) {
        let _ = writeln!(text, "  {:>3.0} %  {}", 100.0 * feature.share, feature.text);
    }
    if let Some(feature) = d.features.iter().find(|f| f.curve.len() > 2) {
        let title = format!("residual [{}] over {}, mean of the rows there", feature.unit, feature.coordinate);
        let plot = Plot { title, x_unit: "", points: feature.curve.clone() };
        let _ = writeln!(text, "\n{}", plot::lines(&plot).join("\n"));
    }
}

fn cause(text: &mut String, number: usize, missing: &Missing) {
    let effect = missing.effect;
    let _ = writeln!(text, "\ncause {number}: {}, {}", effect.name, effect.about);
    let width = missing.estimates.iter().map(|e| name(e).len()).max().unwrap_or(0);
    for e in &missing.estimates {
        let k = e.parameter.kind;
        let value = format!("{:.4} {}", Short(k.from_si(e.value)), k.unit);
        let end = |si: Option<f64>| si.map_or("open".into(), |v| format!("{:.4}", Short(k.from_si(v))));
        let (low, high) = (end(e.interval.low), end(e.interval.high));
        let warnings = if e.warnings.is_empty() { String::new() } else { format!("   ({})", e.warnings.join("; ")) };
        let line = format!("  {:<width$}  {:<20} 95 %: {low} to {high}{warnings}", name(e), value.trim_end());
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let _ = writeln!(text, "  {}", chance(missing.p_value));
    for rival in &missing.indistinguishable_from {
        let by = separated(effect, rival).map_or(String::new(), |by| format!("; in general: {by}"));
        let _ = writeln!(text, "  or {}: these data cannot tell{by}", rival.name);
    }
}

/// What the catalogue says would separate two effects.
pub fn separated(one: &Description, other: &Description) -> Option<&'static str> {
    let said = |a: &Description, b: &str| a.look_alikes.iter().find(|l| l.0 == b).map(|l| l.1);
    said(one, other.name).or_else(|| said(other, one.name))
}

/// How sure it is that something is there.
fn chance(p: f64) -> String {
    match p {
        p if p < 1e-6 => "chance alone gives as much in less than one search in a million".into(),
        p => format!("chance alone gives as much in one search of {:.0}", (1.0 / p).max(1.0)),
    }
}

fn name(e: &Estimate) -> &str {
    e.parameter.path.rsplit('.').next().unwrap_or_default()
}

/// The error falling.
fn errors(text: &mut String, model: &Model, d: &Diagnosis, kind: Kind) {
    let first = format!("{} re-fitted", model.source.name);
    let labels = d.missing.iter().map(|m| format!("+ {}", m.effect.name));
    let lines: Vec<(String, &State)> = std::iter::once(first)
        .chain(labels)
        .zip(std::iter::once(&d.before).chain(d.missing.iter().map(|m| &m.state)))
        .collect();
    let width = lines.iter().map(|l| l.0.chars().count()).max().unwrap_or(0).max(5);
    let held = d.held_out_by.map_or(String::new(), |by| format!("held out by {by}"));
    let _ = writeln!(text, "\n  {:<width$} {:>11} {:>11}   {held}", "model", "rms", "chi2/dof");
    let sigma = kind.from_si(d.noise.together());
    for (label, state) in lines {
        let out = state.held_out.filter(|h| h.is_finite()).map_or("-".into(), |h| format!("{:.3}", h * sigma));
        let _ =
            writeln!(text, "  {label:<width$} {:>11.3} {:>11.3}   {out:>11}", kind.from_si(state.rms), state.misfit);
    }
    let _ = writeln!(text, "  {:<width$} {sigma:>11.3}", "noise");
    let _ = writeln!(text, "  in {}", kind.unit);
}

/// What remains, described.
pub fn unexplained(d: &Diagnosis) -> String {
    match &d.remaining[..] {
        [] => "more is left than the noise explains, but along no coordinate".into(),
        features => features.iter().map(|f| f.text.clone()).collect::<Vec<_>>().join("; "),
    }
}

/// How a cause that is not in the catalogue is written: over a coordinate along which something remains, or else over any of the file's.
fn own_effect(text: &mut String, model: &Model, measurements: &Measurements, d: &Diagnosis) {
    let coordinates = model.process.coordinates();
    let kind = |i: usize| match coordinates[i].holds {
        Holds::Quantity(kind) => Some((coordinates[i].name, kind)),
        Holds::Number(_) | Holds::Word(_) => None,
    };
    let remaining = d.remaining.iter().flat_map(|f| f.axis.0.iter().copied());
    let Some((name, along)) = remaining.chain(measurements.given.iter().copied()).find_map(kind) else { return };
    let unit = measurements.seen[0].kind.unit;
    let _ = writeln!(
        text,
        "  if you know the cause, write it into the model and diagnose again:\n    [effects.my-cause]\n    formula = \
         \"a*sin(2*pi*{name}/p)\"   # over coordinates and these parameters\n    a = \"? {unit}\"\n    p = \"? {}\"",
        along.unit
    );
}

/// What else the data say of an effect.
pub fn note(outlook: &Outlook, d: &Diagnosis) -> String {
    if d.missing.iter().any(|m| m.effect == outlook.effect) {
        return "missing".into();
    }
    let rival = d.missing.iter().find(|m| m.indistinguishable_from.contains(&outlook.effect));
    if let Some(missing) = rival {
        return format!("cannot be told from {} here", missing.effect.name);
    }
    let Some(v) = &outlook.visibility else { return "it cannot be computed here".into() };
    if structure_remains(d) && v.visible {
        return "not judged while structure remains".into();
    }
    match v.smallest.filter(|_| v.visible) {
        Some(smallest) => format!("would have been seen from {} on", bound(outlook.effect, v.parameter, smallest)),
        None => "cannot be seen in these data".into(),
    }
}

/// `rate = 0.4 um/km`, for a stiffness from above.
pub fn bound(effect: &Description, parameter: &str, smallest: f64) -> String {
    let entry = effect.parameters.iter().find(|p| p.name == parameter);
    let unit = entry.map_or("", |p| p.kind.unit);
    let sign = if entry.is_some_and(|p| p.neutral == Neutral::Infinity) { "<=" } else { ">=" };
    format!("{parameter} {sign} {:.2} {unit}", Short(smallest)).trim_end().to_string()
}

fn not_seen(text: &mut String, d: &Diagnosis) {
    let absent = |c: &&Outlook| {
        let named = d.missing.iter().any(|m| m.effect == c.effect || m.indistinguishable_from.contains(&c.effect));
        !named && c.visibility.is_some()
    };
    let rest: Vec<&Outlook> = d.candidates.iter().filter(absent).collect();
    let seen = |c: &&&Outlook| c.visibility.as_ref().is_some_and(|v| v.visible);
    // While structure remains nobody knows what it hides.
    if rest.iter().any(|c| seen(&c)) && !structure_remains(d) {
        let _ = writeln!(text, "\nnot found, and nine times in ten it would have been, at a usual shape, from");
        let width = rest.iter().map(|c| c.effect.name.len()).max().unwrap_or(0);
        for c in rest.iter().filter(seen) {
            let v = c.visibility.as_ref().and_then(|v| v.smallest.map(|s| bound(c.effect, v.parameter, s)));
            let _ = writeln!(text, "  {:<width$}  {}", c.effect.name, v.unwrap_or_default());
        }
    }
    let hidden: Vec<&str> = rest.iter().filter(|c| !seen(c)).map(|c| c.effect.name).collect();
    if !hidden.is_empty() {
        let _ = writeln!(text, "\nthese data could not show: {}", hidden.join(", "));
    }
}

fn measure_next(text: &mut String, d: &Diagnosis) {
    let Some(next) = &d.next else { return };
    let pairs: Vec<String> = next.pairs.iter().map(|(a, b)| format!("{} from {}", a.name, b.name)).collect();
    let often = if next.repeats > 1 { format!(", {} times", next.repeats) } else { String::new() };
    let tells = if next.enough { "tells" } else { "helps to tell, though not enough," };
    let _ = writeln!(
        text,
        "\nmeasure next\n  {}{often}: {} rows\n  it {tells} {}, by {:.1} sigma",
        next.further.words,
        next.observations(),
        pairs.join(", "),
        next.separation
    );
}

/// The settings with which an effect is added, as `fem add` takes them.
pub fn settings(missing: &Missing, fit: &Fit) -> Vec<Setting> {
    let setting = |e: &Estimate| {
        let k = e.parameter.kind;
        let entry = missing.effect.parameters.iter().find(|p| p.name == name(e));
        // What the data leave open is known no better than what is plausible.
        let widest = entry.map_or(f64::INFINITY, |p| 0.5 * (p.range.1 - p.range.0));
        let value = crate::fit::uncertain(k.from_si(e.value), (fit.doubt() * e.std / k.canonical().factor).min(widest));
        Setting { key: name(e).into(), value: format!("{value} {}", k.unit).trim_end().into() }
    };
    missing.estimates.iter().map(setting).collect()
}

fn commands(text: &mut String, model: &Model, measurements: &Measurements, d: &Diagnosis) {
    if d.missing.is_empty() {
        return;
    }
    let (file, data) = (quoted(&model.source.name), quoted(&measurements.name));
    let _ = writeln!(text, "\nto go on");
    let mut from = model.source.name.to_string();
    for missing in &d.missing {
        let values: Vec<String> =
            settings(missing, &d.fit).iter().map(|s| format!("'{}={}'", s.key, s.value)).collect();
        let stem = Path::new(&from).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let to = format!("{stem}-{}.toml", missing.effect.name);
        let _ = writeln!(
            text,
            "  fem add {} {} {} -o {}",
            quoted(&from),
            missing.effect.name,
            values.join(" "),
            quoted(&to)
        );
        from = to;
    }
    if model.parameters.is_empty() {
        let _ = writeln!(text, "  fem compare {} --with {data}", quoted(&from));
        let _ = writeln!(
            text,
            "  or all at once, every value re-fitted: fem diagnose {file} --with {data} --add-to better.toml"
        );
        return;
    }
    // A fit with the effects' values in place would take them for known before, from data that it then counts twice.
    let _ = writeln!(
        text,
        "  what the model knew roughly was bent by what was missing; all at once, every value re-fitted:\n  fem diagnose {file} --with {data} --add-to better.toml"
    );
    // What stays unknown can be fitted, but not compared.
    let mut own = d.fit.estimates.iter().take(model.parameters.len());
    if own.all(|e| e.is_closed() || e.parameter.quantity.knowledge != Knowledge::Free) {
        let _ = writeln!(text, "  fem compare better.toml --with {data}");
    }
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./+,:@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) { word.into() } else { format!("'{}'", word.replace('\'', "'\\''")) }
}
