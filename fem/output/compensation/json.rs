//! Writes a compensation as JSON: `fem-compensation/1`.

use serde_json::{Map, Value as Json, json};

use super::Supplied;
use crate::compensate::{self, Compensation, Kinematic, LostMotion, Rules, Scheme, WrongReading};
use crate::model::Data;
use crate::output::measurement::{self, files};
use crate::positioning::{Check, EDITION, Evaluation, PitchErrors, Quantity, Side, Step, Target};

/// Makes the JSON: lengths along the axis in mm, everything else in um; unknown values are null.
pub fn json(data: &Data, c: &Compensation, supplied: &[Supplied]) -> Json {
    let reversal = c.reversal.as_ref().map(|r| {
        let lost = |(position, lost): &(f64, f64)| json!({ "position": mm(*position), "b": um(-lost), "lost_motion": um(*lost) });
        json!({
            "targets": r.lost.iter().map(lost).collect::<Vec<_>>(),
            "backlash_value": um(r.value),
            "unavoidable_rest": um(r.rest),
        })
    });
    let mut all = json!({
        "schema": "fem-compensation/1",
        "model": &*data.model.source.name,
        "data": data.name,
        "files": files(data),
        "observations": data.len(),
        "unit": "um",
        "position_unit": "mm",
        "iso230": { "edition": EDITION, "targets": c.evaluation.targets.iter().map(target).collect::<Vec<_>>(), "quantities": quantities(&c.evaluation), "uncertainty_of_means": um(c.evaluation.uncertainty()) },
        "reversal": reversal,
        "lost_motion": c.lost_motion.as_ref().map(lost_motion),
        "pitch": pitch(&c.pitch),
        "tolerance": {
            "per_length": um(c.tolerance.per_length),
            "length": mm(c.tolerance.length),
            "travel": um(c.tolerance.travel),
            "repeatability": um(c.tolerance.repeatability),
        },
        "before": c.before.iter().map(check).collect::<Vec<_>>(),
        "schemes": c.schemes.iter().map(scheme).collect::<Vec<_>>(),
        "verdict": c.feasibility.word(),
        "causes": c.causes.iter().map(|c| json!({ "cause": c.key, "finding": c.finding, "remedy": c.remedy })).collect::<Vec<_>>(),
        "agreement": { "rms": um(c.model.rms), "adequate": c.model.adequate, "fitted": c.model.fitted },
        "cautions": c.cautions,
        "wrong_readings": c.wrong_readings.iter().map(wrong).collect::<Vec<_>>(),
        "measurement": measurement::json(&data.terms, &*data.model.process, Some(data)),
    });
    if supplied.iter().any(|s| s.is_asked) {
        all["controls"] = supplied.iter().map(control).collect();
    }
    all
}

fn control(s: &Supplied) -> Json {
    let files: Vec<&str> = s.files.iter().map(|(name, _)| *name).collect();
    json!({ "control": s.control.name, "files": files, "left": um(s.left), "notes": s.notes })
}

fn wrong(w: &WrongReading) -> Json {
    json!({
        "row": w.record,
        "line": w.line,
        "position": mm(w.approach.position),
        "direction": w.approach.direction.sign(),
        "value": um(w.value),
        "others": w.others.map(um),
        "because": if w.is_stated { "model" } else { "repeats" },
    })
}

fn um(m: f64) -> f64 {
    1e6 * m
}

fn mm(m: f64) -> f64 {
    // Positions were read in mm or in another unit; a picometre is round-off.
    (m * 1e12).round() / 1e9
}

/// Makes the JSON of the quantities, by their symbols.
fn quantities(evaluation: &Evaluation) -> Map<String, Json> {
    let one = |q: &Quantity| {
        let entry = json!({ "name": q.name, "formula": q.formula, "value": q.value.map(um), "at": q.at.map(mm) });
        (q.symbol.to_string(), entry)
    };
    evaluation.quantities().iter().map(one).collect()
}

fn target(t: &Target) -> Json {
    let side =
        |s: &Side| json!({ "mean": um(s.mean), "s": s.scatter.map(um), "n": s.count, "R": s.repeatability().map(um) });
    json!({
        "position": mm(t.position),
        "forward": t.forward.as_ref().map(side),
        "backward": t.backward.as_ref().map(side),
        "mean": t.mean().map(um),
        "B": t.reversal().map(um),
        "R": t.repeatability().map(um),
    })
}

fn lost_motion(l: &LostMotion) -> Json {
    let rules = match l.rules() {
        Rules::Constant => "constant",
        Rules::Elastic => "elastic",
        Rules::Both => "both",
        Rules::Unclear => "unclear",
    };
    let kinematic = match l.kinematic() {
        Kinematic::Seen => "seen",
        Kinematic::CompatibleWithNone => "compatible-with-none",
        Kinematic::BelowNone => "below-none",
    };
    let step = |s: &compensate::Step| {
        json!({
            "from": mm(s.from),
            "to": mm(s.to),
            "height": um(s.height),
            "constant": um(s.constant),
            "friction": s.friction,
            "misfit": um(s.misfit),
        })
    };
    json!({
        "constant": { "value": um(l.constant), "std": um(l.constant_std), "unit": "um" },
        "friction": { "value": l.friction, "std": l.friction_std, "unit": "N" },
        "screw": [um(l.screw.0), um(l.screw.1)],
        "grows": l.grows(),
        "rules": rules,
        "kinematic": kinematic,
        "misfit": um(l.misfit),
        "explained_by_scatter": l.fits,
        "step": l.step.as_ref().map(step),
    })
}

fn pitch(p: &PitchErrors) -> Json {
    let step = |s: &Step| json!({ "from": mm(s.from), "to": mm(s.to), "forward": s.forward.map(um), "backward": s.backward.map(um), "mean": s.mean().map(um) });
    let list = |steps: &[Step]| steps.iter().map(step).collect::<Vec<_>>();
    json!({ "relative": list(&p.relative), "absolute": list(&p.absolute) })
}

fn check(c: &Check) -> Json {
    json!({ "check": c.key, "name": c.name, "limit": um(c.limit), "value": c.value.map(um), "passed": c.passed() })
}

fn scheme(s: &Scheme) -> Json {
    let entry = |n: &crate::positioning::Node| json!({ "position": mm(n.position), "added_forward": um(n.forward), "added_backward": um(n.backward) });
    json!({
        "scheme": s.key,
        "name": s.name,
        "entries": s.table.nodes.iter().map(entry).collect::<Vec<_>>(),
        "entered": s.entered.nodes.iter().map(entry).collect::<Vec<_>>(),
        "after": quantities(&s.after),
        "checks": s.checks.iter().map(check).collect::<Vec<_>>(),
        "left_out": s.left_out.iter().map(check).collect::<Vec<_>>(),
        "modelled_range": um(s.modelled.spread()),
    })
}
