//! Reads what the size of an error follows from: its value, or the laws of the handbook for it.

use super::{Contribution, Kind, Law, Source, rules};
use crate::input::Reader;
use crate::material::Material;
use crate::units::{
    CONTACT_COEFFICIENT, FORCE, FORCE_PER_DEPTH, HEAT, LENGTH, MICRO, NUMBER, PATH, STIFFNESS, VOLUME, WEAR_RATE,
};

/// Size or half-field (m), law, and what it comes from.
type Size = (f64, Law, Source);

/// Reads the one size that an error must have.
pub(super) fn read(t: &Reader, kind: Kind, law: Option<Law>) -> Size {
    let table = |key, about, read: fn(&Reader, Option<Law>) -> Size| t.optional_table(key, about, |t| read(t, law));
    let sizes = [
        read_value(t, kind, law),
        table("trial_parts", "setting by trial parts", read_trial_parts),
        table("template", "setting by a template", read_template),
        table("clamping", "contact under a clamping force that varies", read_clamping),
        table("locating", "locating elements, their wear, and the fixture's mounting", read_locating),
        table("inheritance", "what a cut copies of the blank's error", read_inheritance),
        table("wear", "tool wear over a cutting path", read_wear),
        table("heating", "a part that is warm when it is cut or measured", read_heating),
        table("machine", "geometric accuracy of a machine of some class", read_machine),
    ];
    let given = sizes.iter().flatten().count();
    if given != 1 && !t.is_described() {
        let message = if given == 0 { "the error has no size" } else { "the error has several sizes" };
        let help = "give one of `value`, `trial_parts`, `template`, `clamping`, `locating`, `inheritance`, `wear`, \
                    `heating` and `machine`";
        t.problem("", message, help);
    }
    sizes.into_iter().flatten().next().unwrap_or((0.0, Law::Uniform, Source::Given))
}

fn read_value(t: &Reader, kind: Kind, law: Option<Law>) -> Option<Size> {
    let about = "size with its sign if systematic, half of the field if random";
    let field = t.quantity("value", MICRO, about);
    let value = if kind == Kind::Random { field.not_negative() } else { field }.optional()?;
    Some((value, law.unwrap_or(Law::Uniform), Source::Given))
}

/// Reads an error of setting by trial parts: (33), (34), (44)–(46).
fn read_trial_parts(t: &Reader, law: Option<Law>) -> Size {
    let half = |key, about| t.quantity(key, MICRO, about).not_negative().required();
    let measuring = half("measuring", "error of measuring a trial part, Δ_meas");
    let adjusting = half("adjusting", "error of adjusting the tool, Δ_adj");
    let field = half("field", "field over which the process scatters, T = 6σ");
    let parts = t.count("parts", "trial parts, usually 5 to 10").between(1, 1000).required();
    let parts = [measuring, adjusting, rules::calculation(field, parts)].map(|half| (Law::Uniform, half));
    of_parts(law.unwrap_or(Law::Normal), parts.to_vec())
}

/// Ends of the handbook's ranges for a template, its making and the mounting of the tool, m.
const TEMPLATES: [(f64, f64); 2] = [(10e-6, 20e-6), (2e-6, 50e-6)];
/// Places in a range that is chosen from: 0 is its lower end.
const GRADES: &[(&str, f64)] = &[("fine", 0.0), ("medium", 0.5), ("coarse", 1.0)];

/// Reads an error of setting by a template: what is not given lies in the handbook's range.
fn read_template(t: &Reader, law: Option<Law>) -> Size {
    let about = "where in the handbook's ranges lies what is left out: their lower end, middle or upper end";
    let place = t.choice("grade", about, GRADES).or_first(0.0);
    let part = |key, about, (low, high): (f64, f64)| {
        let field = t.quantity(key, MICRO, about).not_negative();
        if t.has("grade") { field.or(low + place * (high - low)) } else { field.required() }
    };
    let making = part("making", "error of the template, usually 10 to 20 um", TEMPLATES[0]);
    let mounting = part("mounting", "error of bringing the tool to it, usually 2 to 50 um", TEMPLATES[1]);
    of_parts(law.unwrap_or(Law::Normal), vec![(Law::Uniform, making), (Law::Uniform, mounting)])
}

/// Reads an error of clamping: (47), or (30) where it is said what the size is measured from.
fn read_clamping(t: &Reader, law: Option<Law>) -> Size {
    let coefficient = |key, about| t.quantity(key, CONTACT_COEFFICIENT, about).not_negative().required();
    let force = |key, about| t.quantity(key, FORCE, about).not_negative().required();
    let c = (coefficient("c_min", "least coefficient"), coefficient("c_max", "largest coefficient"));
    let force = (force("force_min", "least force"), force("force_max", "largest force"));
    let exponent = t.quantity("n", NUMBER, "exponent of the force").within(0.0, 1.0).required();
    for (key, (low, high)) in [("c_max", c), ("force_max", force)] {
        if high < low {
            t.problem(key, "the largest is below the least", "exchange the two");
        }
    }
    const BASES: &[(&str, Base)] = &[("moves", Base::Moves), ("stays", Base::Stays)];
    let about = "whether the face from which the size is measured moves with the contact: largest less smallest, or nothing; \
                 the root of squares of its ends if left out";
    let base = t.choice("base", about, BASES).or_first(Base::Moves);
    let base = t.has("base").then_some(base);
    let law = law.unwrap_or(Law::Normal);
    let value = match base {
        Some(Base::Moves) => rules::clamping_scatter(c, force, exponent),
        Some(Base::Stays) => return (0.0, law, Source::Parts(Vec::new())),
        None => {
            let [y1, y2] = rules::clamping_ends(c, force, exponent);
            Contribution::of_parts(law, &[(Law::Normal, y1), (Law::Normal, y2)])
        }
    };
    (value, law, Source::Clamping { c, force, exponent })
}

/// Face from which a size is measured: moved by the clamping force, or not.
#[derive(Clone, Copy)]
enum Base {
    Moves,
    Stays,
}

/// Reads an error of a fixture: (48).
fn read_locating(t: &Reader, law: Option<Law>) -> Size {
    let half = |key, about| t.quantity(key, MICRO, about).not_negative().required();
    let locators = half("locators", "error of the locating elements");
    let wear = half("wear", "their wear");
    let mounting = half("mounting", "error of the fixture's place on the machine");
    let parts = vec![(Law::Normal, locators), (Law::Uniform, wear), (Law::Normal, mounting)];
    of_parts(law.unwrap_or(Law::Normal), parts)
}

fn of_parts(law: Law, parts: Vec<(Law, f64)>) -> Size {
    (Contribution::of_parts(law, &parts), law, Source::Parts(parts))
}

/// An error of one part, of known size and unknown sign.
fn sized(law: Law, half: f64) -> Size {
    (half, law, Source::Parts(vec![(law, half)]))
}

/// Reads what a cut copies of the blank's error: (27).
fn read_inheritance(t: &Reader, law: Option<Law>) -> Size {
    let blank = t.quantity("blank", MICRO, "error of the blank").not_negative().required();
    let force = t.quantity("force_per_depth", FORCE_PER_DEPTH, "radial force per depth of cut, c");
    let force = force.not_negative().required();
    let stiffness = t.quantity("system_stiffness", STIFFNESS, "stiffness of the system, j").positive().required();
    sized(law.unwrap_or(Law::Normal), rules::inherited(blank, force, stiffness))
}

/// Reads the wear of a tool over a path: (32).
fn read_wear(t: &Reader, law: Option<Law>) -> Size {
    let rate = t.quantity("rate", WEAR_RATE, "steady wear per cutting path, u").not_negative().required();
    let path = t.quantity("path", PATH, "cutting path, L").not_negative().required();
    sized(law.unwrap_or(Law::Uniform), rules::wear(rate, path))
}

/// Reads the elongation of a part that has taken heat: (35), (36).
fn read_heating(t: &Reader, law: Option<Law>) -> Size {
    let heat = t.quantity("heat", HEAT, "heat that the part has taken, Q").not_negative().required();
    let volume = t.quantity("volume", VOLUME, "volume of the part, V").positive().required();
    let length = t.quantity("length", LENGTH, "dimension that grows, L").positive().required();
    let material = Material::read(t, "material");
    let rise = heat / (material.specific_heat * volume * material.density);
    sized(law.unwrap_or(Law::Uniform), rules::heating(material.expansion, length, rise).abs())
}

/// Parts of the errors of a machine of normal accuracy that the better classes are allowed [seed 002, geometric
/// accuracy of machines].
const CLASSES: &[(&str, f64)] = &[("N", 1.0), ("P", 0.60), ("V", 0.40), ("A", 0.24), ("S", 0.16)];
/// Least and largest error of a machine of normal accuracy for parts of medium size, m.
const NORMAL: (f64, f64) = (10e-6, 50e-6);

/// Reads the geometric error of a machine by its class.
fn read_machine(t: &Reader, law: Option<Law>) -> Size {
    let part = t.choice("class", "class of accuracy, N being normal", CLASSES).required(1.0);
    let about = "what a machine of class N is allowed, usually 10 to 50 um";
    let place = t.choice("grade", "where in that range it lies, if it is not given", GRADES).or_first(0.0);
    let field = t.quantity("normal", MICRO, about).not_negative();
    let normal = if t.has("grade") { field.or(NORMAL.0 + place * (NORMAL.1 - NORMAL.0)) } else { field.required() };
    sized(law.unwrap_or(Law::Uniform), part * normal)
}
