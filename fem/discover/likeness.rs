//! Effects of the catalogue, of whatever process, that have the form of a law: what makes something alike elsewhere may make it
//! here.

use super::search::{Bench, Found};
use super::shape::Shape;
use super::variable::Factor;
use crate::units::{ANGLE, FEED_RATE, FORCE, Kind, LENGTH, SPINDLE_SPEED, TEMPERATURE, TIME};

/// Shapes that are one form.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// A straight line, from zero or not.
    Line,
    /// The square.
    Square,
    /// A power below one.
    Root,
    /// What comes to rest with time.
    Fading,
    Logarithm,
    Wave,
    /// So many waves a turn.
    Lobes(u8),
    /// Nothing up to a place, and from there more and more.
    Hinge,
}

/// What laws are made of, with what has that form. Forms of several variables stand before those of one.
const FORMS: &[(&[(Kind, Form)], &str)] = &[
    (
        &[(LENGTH, Form::Line), (TIME, Form::Fading)],
        "`thermal-growth` of an axis: a screw that warms from its bearing on",
    ),
    (&[(LENGTH, Form::Line), (TEMPERATURE, Form::Line)], "`workpiece-heating` of a turned shaft: a length that warms"),
    (&[(TIME, Form::Fading)], "`spindle-thermal-drift` of a lathe: a machine that warms"),
    (&[(TEMPERATURE, Form::Line)], "`ambient-drift` of a rod in a room: a length that the room warms"),
    (&[(TIME, Form::Logarithm)], "`settling` of a joint: contacts that creep under load"),
    (&[(LENGTH, Form::Wave)], "`periodic-error` of an axis: the turns of a screw, or the pitch of a scale"),
    (&[(FEED_RATE, Form::Line)], "`servo-lag` of cam grinding: a drive that follows late"),
    (&[(SPINDLE_SPEED, Form::Square)], "`centrifugal-unloading` of a chuck: a mass that turns"),
    (&[(FORCE, Form::Line)], "`support-compliance` of a lathe: a spring"),
    (&[(FORCE, Form::Root)], "`contact-joint` of a fixture: a contact that gives less the harder it is pressed"),
    (&[(FORCE, Form::Hinge)], "`preload` of a joint: a contact that opens or closes at a force"),
    (&[(ANGLE, Form::Lobes(1))], "`centre-offset` of a contour: a centre that is elsewhere"),
    (&[(ANGLE, Form::Lobes(2))], "`squareness` of a contour: axes that are not square, or an oval"),
];

/// The effect that has the form of a law of one term, with what it is.
pub fn like(bench: &Bench, law: &Found) -> Option<&'static str> {
    let [term] = law.terms.as_slice() else { return None };
    let part = |own: &Factor| {
        let variable = &bench.variables[own.variable];
        let is_plain =
            own.other.is_none() && variable.words == 0 && !variable.is_prediction && variable.made_of.is_empty();
        is_plain.then(|| Some((variable.kind, form(own)?))).flatten()
    };
    let parts: Vec<(Kind, Form)> = term.factors.iter().map(part).collect::<Option<_>>()?;
    let dimension = |kind: &Kind| kind.canonical().dimension;
    let is_part =
        |(kind, form): &(Kind, Form)| parts.iter().any(|own| own.1 == *form && dimension(&own.0) == dimension(kind));
    let has = |all: &&(&[(Kind, Form)], &'static str)| all.0.len() == parts.len() && all.0.iter().all(is_part);
    FORMS.iter().find(has).map(|own| own.1)
}

fn form(own: &Factor) -> Option<Form> {
    /// Exponents that are squares, and that are below one.
    const SQUARES: std::ops::RangeInclusive<f64> = 1.85..=2.15;
    const ROOTS: std::ops::RangeInclusive<f64> = 0.3..=0.9;
    let power = |p: f64| match p {
        p if SQUARES.contains(&p) => Some(Form::Square),
        p if ROOTS.contains(&p) => Some(Form::Root),
        _ => None,
    };
    match own.shape {
        Shape::Proportional | Shape::Line => Some(Form::Line),
        Shape::Power(p) => power(p),
        Shape::Exponent => power(own.constants[0]),
        Shape::Decay | Shape::Relaxation => Some(Form::Fading),
        Shape::Logarithm => Some(Form::Logarithm),
        Shape::Wave => Some(Form::Wave),
        Shape::Harmonic(k) => Some(Form::Lobes(k as u8)),
        Shape::Hinge | Shape::Fall => Some(Form::Hinge),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::FORMS;
    use crate::processes::ALL;

    #[test]
    fn effects_that_are_likened_to_are_in_the_catalogue() {
        for (_, words) in FORMS {
            let name = words.split('`').nth(1).unwrap();
            assert!(ALL.iter().any(|process| process.effects().iter().any(|own| own.name == *name)), "{name}");
        }
    }
}
