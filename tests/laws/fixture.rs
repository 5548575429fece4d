//! A part on supports: forces in balance whatever the supports yield by, linear where they are springs.

use fem::process::Datum;
use fem::progress::Progress;
use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, sum, times};

#[derive(Clone, Debug)]
pub(super) struct Fixture {
    /// Length, width and height, mm.
    length: f64,
    width: f64,
    height: f64,
    /// Places of the supports as parts of the length, each with a clamp above it.
    places: Vec<f64>,
    /// Force of each clamp, N.
    forces: Vec<f64>,
    /// Young's modulus, GPa.
    modulus: f64,
}

pub(super) fn fixture() -> impl Strategy<Value = Fixture> {
    let drawn = prop::collection::vec((-0.4..0.4, 800.0..6000.0), 4);
    (200.0..600.0, 40.0..80.0, 30.0..60.0, 2usize..5, drawn).prop_map(|(length, width, height, count, drawn)| {
        let place = |i: usize| 0.08 + 0.84 * (i as f64 + 0.5 + drawn[i].0) / count as f64;
        let places = (0..count).map(place).collect();
        let forces = drawn[..count].iter().map(|d| d.1).collect();
        Fixture { length, width, height, places, forces, modulus: 110.0 }
    })
}

impl Fixture {
    pub(super) fn text(&self, effect: &str) -> String {
        let mut text = format!(
            "process = \"fixture\"\n\
             workpiece = {{ material = {{ base = \"cast-iron\", youngs_modulus = \"{} GPa\" }}, length = \"{} mm\", width = \"{} mm\", height = \"{} mm\" }}\n\
             sweep = {{ positions = 11 }}\ncutter = {{ force = \"0 N\" }}\n",
            self.modulus, self.length, self.width, self.height
        );
        for (part, force) in self.places.iter().zip(&self.forces) {
            let at = part * self.length;
            text += &format!("[[support]]\nat = \"{at} mm\"\n[[clamp]]\nat = \"{at} mm\"\nforce = \"{force} N\"\n");
        }
        text + effect
    }

    fn mirrored(&self) -> Self {
        let places = self.places.iter().rev().map(|part| 1.0 - part).collect();
        Self { places, forces: self.forces.iter().rev().copied().collect(), ..*self }
    }

    /// Height errors (m) at parts of the length, all clamps by one force and the cutter by another (N), standing at
    /// parts of the length.
    fn heights(&self, effect: &str, at: &[f64], cutter_at: &[f64], clamps: f64, cutter: f64) -> Vec<f64> {
        let metres = |parts: &[f64]| parts.iter().map(|part| 1e-3 * part * self.length).collect::<Vec<f64>>();
        let all = |value: f64| vec![value; at.len()];
        let given: [(&str, &[f64]); 4] = [
            ("x", &metres(at)),
            ("cutter_x", &metres(cutter_at)),
            ("clamp_force", &all(clamps)),
            ("cutter_force", &all(cutter)),
        ];
        observed(&model(&self.text(effect)), "height_error", &given)
    }
}

pub(super) const SPRINGS: &str = "[effects.support-compliance]\nstiffness = \"80 N/um\"\n";
pub(super) const CONTACTS: &str = "[effects.contact-joint]\nc = \"0.2 um/N^n\"\nn = 0.5\n";
const PLACES: [f64; 5] = [0.1, 0.3, 0.45, 0.7, 0.88];
/// A floor that is held at both of its ends: its nodes, and its member.
const FLOOR: &str = "left = [\"-10 mm\", \"-90 mm\"]\nright = [\"800 mm\", \"-90 mm\"]\n";
const FLOOR_MEMBER: &str =
    "[structure.floor]\nbetween = [\"left\", \"right\"]\nwidth = \"300 mm\"\nheight = \"80 mm\"\n";

/// Forces (N) and places (m) in a list of a figure.
fn carried(model: &fem::model::Model, key: &str, list: &str) -> Vec<(f64, f64)> {
    let report = model.run(&Progress::default()).unwrap().report;
    let figure = report.figures.into_iter().find(|figure| figure.key == key).unwrap();
    let Some((_, Datum::List(all))) = figure.entries.into_iter().find(|(name, _)| name == list) else {
        panic!("{key}")
    };
    let of = |entry: Datum| {
        let Datum::Record(entries) = entry else { panic!("{entry:?}") };
        let told = |name: &str| match entries.iter().find(|(key, _)| key == name) {
            Some((_, Datum::Quantity(_, si))) => *si,
            other => panic!("{other:?}"),
        };
        (told("force"), told("at"))
    };
    all.into_iter().map(of).collect()
}

proptest! {
    #![proptest_config(super::random(100))]

    /// Newton's search ends at 1e-10 of the forces.
    #[test]
    fn supports_carry_the_clamps(fixture in fixture(), effect in prop::sample::select(vec!["", SPRINGS, CONTACTS])) {
        let model = model(&fixture.text(effect));
        let (up, down) = (carried(&model, "supports", "list"), carried(&model, "clamping", "clamps"));
        let force = |all: &[(f64, f64)]| all.iter().map(|(force, _)| force).sum::<f64>();
        let moment = |all: &[(f64, f64)]| all.iter().map(|(force, at)| force * at).sum::<f64>();
        alike(&[force(&up)], &[force(&down)], 1e-8)?;
        alike(&[moment(&up)], &[moment(&down)], 1e-8)?;
    }

    #[test]
    fn forces_on_springs_superpose(fixture in fixture(), clamps in 1000.0..4000.0, cutter in 10.0..200.0) {
        let heights = |clamps: f64, cutter: f64| fixture.heights(SPRINGS, &PLACES, &PLACES, clamps, cutter);
        // Clamps twice and the cutter once are each twice and once.
        let rest = heights(clamps, 0.0);
        alike(&sum(&heights(clamps, cutter), &rest), &heights(2.0 * clamps, cutter), ROUND_OFF)?;
    }

    /// Maxwell: pressed at A, the part moves at B as it moves at A when pressed at B.
    #[test]
    fn what_a_push_moves_elsewhere_is_mutual(fixture in fixture(), a in 0.1..0.5, b in 0.5..0.9) {
        let (at, cutter_at) = ([b, a], [a, b]);
        let pushed = |force: f64| fixture.heights(SPRINGS, &at, &cutter_at, 3000.0, force);
        let moved: Vec<f64> = pushed(100.0).iter().zip(pushed(0.0)).map(|(with, without)| with - without).collect();
        // A difference of heights some hundred times as large.
        prop_assert!((moved[0] - moved[1]).abs() <= 1e-9 * pushed(0.0)[0].abs(), "{moved:?}");
    }

    #[test]
    fn a_mirrored_fixture_makes_the_mirrored_top(fixture in fixture(), effect in prop::sample::select(vec![SPRINGS, CONTACTS])) {
        let mirrored: Vec<f64> = PLACES.iter().map(|part| 1.0 - part).collect();
        let own = fixture.heights(effect, &PLACES, &PLACES, 3000.0, 100.0);
        alike(&own, &fixture.mirrored().heights(effect, &mirrored, &mirrored, 3000.0, 100.0), 1e-8)?;
    }

    /// A contact drawn in the machine under each support is one at the support: the drawn machine has them in its own
    /// equilibrium. Its stems and its springs have no part in it that is as large as the search leaves open.
    #[test]
    fn contacts_under_the_supports_are_contacts_at_them(
        fixture in fixture(), c in 0.05..0.4, n in 0.4..0.9, clamps in 1000.0..4000.0, cutter in 0.0..800.0,
    ) {
        let at_supports = format!("[effects.contact-joint]\nc = \"{c} um/N^n\"\nn = {n}\n");
        let own = fixture.heights(&at_supports, &PLACES, &PLACES, clamps, cutter);
        let places: Vec<f64> = fixture.places.iter().map(|part| part * fixture.length).collect();
        let of = |line: &dyn Fn(usize, f64) -> String| places.iter().enumerate().map(|(i, x)| line(i, *x)).collect::<String>();
        let machine = format!(
            "[structure]\nmaterial = \"steel\"\npinned = [{}]\nclamped = [\"left\", \"right\"]\n[structure.nodes]\n{}{FLOOR}\
             [structure.ports]\nsupports = [{}]\nclamps = \"floor\"\n{}",
            of(&|i, _| format!("\"back{i}\", ")),
            of(&|i, x| format!("back{i} = [\"{} mm\", \"-50 mm\"]\nunder{i} = [\"{x} mm\", \"-50 mm\"]\n", x - 10.0)),
            of(&|i, _| format!("\"stem{i}\", ")),
            of(&|i, _| format!(
                "[structure.stem{i}]\nbetween = [\"back{i}\", \"under{i}\"]\ndiameter = \"0.05 mm\"\n[structure.pad{i}]\n\
                 at = \"under{i}\"\nalong = \"-y\"\nstiffness = \"1e10 N/um\"\nc = \"{c} um/N^n\"\nn = {n}\n"
            )) + FLOOR_MEMBER,
        );
        alike(&own, &fixture.heights(&machine, &PLACES, &PLACES, clamps, cutter), 1e-6)?;
    }

    /// Behind a spindle that is held by a contact alone the cutter rises by what that gives way under its force.
    #[test]
    fn a_spindle_rises_by_its_contact(
        fixture in fixture(), c in 0.05..0.4, n in 0.4..0.9, preload in 0.0..2000.0, cutter in 50.0..800.0,
    ) {
        let machine = |contact: &str| {
            format!(
                "[structure]\nmaterial = \"steel\"\nclamped = [\"left\", \"right\"]\n[structure.nodes]\n\
                 spindle = [\"0 mm\", \"200 mm\"]\n{FLOOR}[structure.ports]\nsupports = \"floor\"\nclamps = \"floor\"\nspindle = \"spindle\"\n\
                 [structure.along]\nat = \"spindle\"\nalong = \"x\"\nstiffness = \"1 N/um\"\n\
                 [structure.square]\nat = \"spindle\"\nalong = \"turning\"\nstiffness = \"1 N*m/rad\"\n\
                 [structure.column]\nat = \"spindle\"\nalong = \"y\"\nstiffness = \"100 N/um\"\n{contact}{FLOOR_MEMBER}",
            )
        };
        let pressed = |text: &str| fixture.heights(text, &PLACES, &PLACES, 3000.0, cutter);
        let contact = format!("c = \"{c} um/N^n\"\nn = {n}\npreload = \"{preload} N\"\n");
        let law = |force: f64| 1e-6 * c * force.powf(n);
        let rise = law(cutter + preload) - law(preload);
        alike(&pressed(&machine(&contact)), &sum(&pressed(&machine("")), &[rise; 5]), 1e-8)?;
    }

    /// Parts of one shape under one strain are of one shape: lengths by s, the modulus by e, forces by s²·e,
    /// stiffnesses by s·e, heights by s.
    #[test]
    fn larger_and_stiffer_fixtures_deviate_in_proportion(fixture in fixture(), s in 0.5..2.0, e in 0.4..2.0) {
        let Fixture { length, width, height, modulus, .. } = fixture;
        let larger = Fixture {
            length: s * length,
            width: s * width,
            height: s * height,
            modulus: e * modulus,
            ..fixture.clone()
        };
        let springs = |factor: f64| format!("[effects.support-compliance]\nstiffness = \"{} N/um\"\n", 80.0 * factor);
        let own = fixture.heights(&springs(1.0), &PLACES, &PLACES, 3000.0, 100.0);
        let scaled = larger.heights(&springs(s * e), &PLACES, &PLACES, s * s * e * 3000.0, s * s * e * 100.0);
        alike(&times(s, &own), &scaled, ROUND_OFF)?;
    }
}
