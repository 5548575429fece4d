//! Writes a compensation as JSON: `fem-compensation/1`.

use serde_json::{Map, Value as Json, json};

use super::Supplied;
use crate::compensate::{self, Compensation, Kinematic, LostMotion, Rules, Scheme, WrongReading};
use crate::model::Data;
use crate::output::measurement::{self, files};
use crate::positioning::{Check, EDITION, Evaluation, Measures, PitchErrors, Quantity, Side, Step, Target};

/// Makes the JSON: positions in `position_unit` (mm or deg), everything else in `unit` (um or arcsec); unknown values are
/// null.
pub fn json(data: &Data, c: &Compensation, supplied: &[Supplied]) -> Json {
    let m = c.measures;
    let [per_length, length, travel] =
        if m.is_rotary() { ["per_angle", "angle", "range"] } else { ["per_length", "length", "travel"] };
    let reversal = c.reversal.as_ref().map(|r| {
        let lost = |(position, lost): &(f64, f64)| json!({ "position": m.place(*position), "b": m.off(-lost), "lost_motion": m.off(*lost) });
        json!({
            "targets": r.lost.iter().map(lost).collect::<Vec<_>>(),
            "backlash_value": m.off(r.value),
            "unavoidable_rest": m.off(r.rest),
        })
    });
    let mut all = json!({
        "schema": "fem-compensation/1",
        "model": &*data.model.source.name,
        "data": data.name,
        "files": files(data),
        "observations": data.len(),
        "unit": m.deviation_unit(),
        "position_unit": m.position_unit(),
        "iso230": { "edition": EDITION, "targets": c.evaluation.targets.iter().map(|t| target(t, m)).collect::<Vec<_>>(), "quantities": quantities(&c.evaluation, m), "uncertainty_of_means": m.off(c.evaluation.uncertainty()) },
        "reversal": reversal,
        "lost_motion": c.lost_motion.as_ref().map(|l| lost_motion(l, m)),
        "pitch": pitch(&c.pitch, m),
        "tolerance": {
            per_length: m.off(c.tolerance.per_length),
            length: m.place(c.tolerance.length),
            travel: m.off(c.tolerance.travel),
            "repeatability": m.off(c.tolerance.repeatability),
        },
        "before": c.before.iter().map(|c| check(c, m)).collect::<Vec<_>>(),
        "schemes": c.schemes.iter().map(|s| scheme(s, m)).collect::<Vec<_>>(),
        "verdict": c.feasibility.word(),
        "causes": c.causes.iter().map(|c| json!({ "cause": c.key, "finding": c.finding, "remedy": c.remedy })).collect::<Vec<_>>(),
        "agreement": { "rms": m.off(c.model.rms), "adequate": c.model.adequate, "fitted": c.model.fitted },
        "cautions": c.cautions,
        "wrong_readings": c.wrong_readings.iter().map(|w| wrong(w, m)).collect::<Vec<_>>(),
        "measurement": measurement::json(&data.terms, &*data.model.process, Some(data)),
    });
    if supplied.iter().any(|s| s.is_asked) {
        all["controls"] = supplied.iter().map(|s| control(s, m)).collect();
    }
    all
}

fn control(s: &Supplied, m: Measures) -> Json {
    let files: Vec<&str> = s.files.iter().map(|(name, _)| *name).collect();
    json!({ "control": s.control.name, "files": files, "left": m.off(s.left), "notes": s.notes })
}

fn wrong(w: &WrongReading, m: Measures) -> Json {
    json!({
        "row": w.record,
        "line": w.line,
        "position": m.place(w.approach.position),
        "direction": w.approach.direction.sign(),
        "value": m.off(w.value),
        "others": w.others.map(|off| m.off(off)),
        "because": if w.is_stated { "model" } else { "repeats" },
    })
}

/// Makes the JSON of the quantities, by their symbols.
fn quantities(evaluation: &Evaluation, m: Measures) -> Map<String, Json> {
    let one = |q: &Quantity| {
        let entry = json!({ "name": q.name, "formula": q.formula, "value": q.value.map(|off| m.off(off)), "at": q.at.map(|at| m.place(at)) });
        (q.symbol.to_string(), entry)
    };
    evaluation.quantities().iter().map(one).collect()
}

fn target(t: &Target, m: Measures) -> Json {
    let side = |s: &Side| json!({ "mean": m.off(s.mean), "s": s.scatter.map(|off| m.off(off)), "n": s.count, "R": s.repeatability().map(|off| m.off(off)) });
    json!({
        "position": m.place(t.position),
        "forward": t.forward.as_ref().map(side),
        "backward": t.backward.as_ref().map(side),
        "mean": t.mean().map(|off| m.off(off)),
        "B": t.reversal().map(|off| m.off(off)),
        "R": t.repeatability().map(|off| m.off(off)),
    })
}

fn lost_motion(l: &LostMotion, m: Measures) -> Json {
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
            "from": m.place(s.from),
            "to": m.place(s.to),
            "height": m.off(s.height),
            "constant": m.off(s.constant),
            "friction": s.friction,
            "misfit": m.off(s.misfit),
        })
    };
    json!({
        "constant": { "value": m.off(l.constant), "std": m.off(l.constant_std), "unit": m.deviation_unit() },
        "friction": { "value": l.friction, "std": l.friction_std, "unit": "N" },
        "screw": [m.off(l.screw.0), m.off(l.screw.1)],
        "grows": l.grows(),
        "rules": rules,
        "kinematic": kinematic,
        "misfit": m.off(l.misfit),
        "explained_by_scatter": l.fits,
        "step": l.step.as_ref().map(step),
    })
}

fn pitch(p: &PitchErrors, m: Measures) -> Json {
    let step = |s: &Step| json!({ "from": m.place(s.from), "to": m.place(s.to), "forward": s.forward.map(|off| m.off(off)), "backward": s.backward.map(|off| m.off(off)), "mean": s.mean().map(|off| m.off(off)) });
    let list = |steps: &[Step]| steps.iter().map(step).collect::<Vec<_>>();
    json!({ "relative": list(&p.relative), "absolute": list(&p.absolute) })
}

fn check(c: &Check, m: Measures) -> Json {
    json!({ "check": c.key, "name": c.name, "limit": m.off(c.limit), "value": c.value.map(|off| m.off(off)), "passed": c.passed() })
}

fn scheme(s: &Scheme, m: Measures) -> Json {
    let entry = |n: &crate::positioning::Node| json!({ "position": m.place(n.position), "added_forward": m.off(n.forward), "added_backward": m.off(n.backward) });
    json!({
        "scheme": s.key,
        "name": s.name,
        "entries": s.table.nodes.iter().map(entry).collect::<Vec<_>>(),
        "entered": s.entered.nodes.iter().map(entry).collect::<Vec<_>>(),
        "after": quantities(&s.after, m),
        "checks": s.checks.iter().map(|c| check(c, m)).collect::<Vec<_>>(),
        "left_out": s.left_out.iter().map(|c| check(c, m)).collect::<Vec<_>>(),
        "modelled_range": m.off(s.modelled.spread()),
    })
}
