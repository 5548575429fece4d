//! A shaft between centres: linear as long as its joints are springs.

use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, sum, times};

#[derive(Clone, Debug)]
pub(super) struct Lathe {
    /// Length and diameter of each segment from the headstock, mm.
    segments: Vec<(f64, f64)>,
    /// Stiffness of headstock and tailstock, N/um.
    head: f64,
    tail: f64,
    /// Steady rests: place (mm) and stiffness (N/um).
    rests: Vec<(f64, f64)>,
    /// Young's modulus, GPa.
    modulus: f64,
}

pub(super) fn lathe() -> impl Strategy<Value = Lathe> {
    let segments = prop::collection::vec((40.0..150.0, 25.0..70.0), 1..5);
    (segments, 10.0..200.0, 10.0..200.0).prop_map(|(segments, head, tail)| Lathe {
        segments,
        head,
        tail,
        rests: vec![],
        modulus: 210.0,
    })
}

impl Lathe {
    pub(super) fn length(&self) -> f64 {
        self.segments.iter().map(|s| s.0).sum()
    }

    /// The model, on its springs or on rigid centres.
    pub(super) fn text(&self, yields: bool) -> String {
        let segment =
            |(length, diameter): &(f64, f64)| format!("{{ length = \"{length} mm\", diameter = \"{diameter} mm\" }}");
        let segments: Vec<String> = self.segments.iter().map(segment).collect();
        let rest = |(at, stiffness): &(f64, f64)| format!("{{ at = \"{at} mm\", stiffness = \"{stiffness} N/um\" }}");
        let rests: Vec<String> = self.rests.iter().map(rest).collect();
        let mut text = format!(
            "process = \"turning\"\nworkpiece = {{ material = {{ base = \"steel\", youngs_modulus = \"{} GPa\" }}, segments = [{}] }}\n\
             workholding = {{ type = \"centres\", steady_rests = [{}] }}\n\
             cut = {{ depth = \"0.5 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"600 rpm\", radial_force = \"400 N\" }}\n\
             mesh = {{ element_size = \"15 mm\" }}\n",
            self.modulus,
            segments.join(", "),
            rests.join(", "),
        );
        if yields {
            text += &format!("[effects.headstock-compliance]\nstiffness = \"{} N/um\"\n", self.head);
            text += &format!("[effects.tailstock-compliance]\nstiffness = \"{} N/um\"\n", self.tail);
        }
        text
    }

    fn mirrored(&self) -> Self {
        let rests = self.rests.iter().map(|(at, stiffness)| (self.length() - at, *stiffness)).collect();
        let segments = self.segments.iter().rev().copied().collect();
        Self { segments, head: self.tail, tail: self.head, rests, ..*self }
    }

    /// Diameter errors (m) at places that are parts of the length, under a force (N).
    fn errors(&self, yields: bool, places: &[f64], force: f64) -> Vec<f64> {
        let x: Vec<f64> = places.iter().map(|part| 1e-3 * part * self.length()).collect();
        observed(&model(&self.text(yields)), "diameter_error", &[("x", &x), ("radial_force", &vec![force; x.len()])])
    }
}

const PLACES: [f64; 7] = [0.05, 0.17, 0.31, 0.5, 0.66, 0.8, 0.93];

proptest! {
    #![proptest_config(super::random(160))]

    #[test]
    fn deflections_superpose(lathe in lathe(), first in 50.0..800.0, second in 50.0..800.0) {
        let [one, other, both] = [first, second, first + second].map(|force| lathe.errors(true, &PLACES, force));
        alike(&sum(&one, &other), &both, ROUND_OFF)?;
        alike(&times(second / first, &one), &other, ROUND_OFF)?;
    }

    #[test]
    fn a_mirrored_lathe_turns_the_mirrored_shaft(lathe in lathe(), rest in (0.2..0.8, 10.0..100.0)) {
        let own = Lathe { rests: vec![(rest.0 * lathe.length(), rest.1)], ..lathe };
        let mirrored: Vec<f64> = PLACES.iter().map(|part| 1.0 - part).collect();
        alike(&own.errors(true, &PLACES, 400.0), &own.mirrored().errors(true, &mirrored, 400.0), ROUND_OFF)?;
    }

    /// Lathes of one shape under one strain are of one shape: lengths by s, the modulus by e, stiffnesses by
    /// s·e, forces by s²·e, errors by s.
    #[test]
    fn larger_and_stiffer_lathes_err_in_proportion(
        lathe in lathe(), rest in (0.2..0.8, 10.0..100.0), s in 0.5..2.0, e in 0.4..2.0,
    ) {
        let own = Lathe { rests: vec![(rest.0 * lathe.length(), rest.1)], ..lathe };
        let larger = Lathe {
            segments: own.segments.iter().map(|(length, diameter)| (s * length, s * diameter)).collect(),
            head: s * e * own.head,
            tail: s * e * own.tail,
            rests: own.rests.iter().map(|(at, stiffness)| (s * at, s * e * stiffness)).collect(),
            modulus: e * own.modulus,
        };
        alike(&times(s, &own.errors(true, &PLACES, 400.0)), &larger.errors(true, &PLACES, s * s * e * 400.0), ROUND_OFF)?;
    }

    /// The shaft is statically determinate: its reactions follow from the balance of forces and of moments alone, and
    /// what the springs add from these.
    #[test]
    fn springs_carry_what_equilibrium_asks(lathe in lathe(), force in 50.0..800.0) {
        let of_springs = |part: &f64| {
            let (head, tail) = ((1.0 - part) * force, part * force);
            2.0 * ((1.0 - part) * head / (1e6 * lathe.head) + part * tail / (1e6 * lathe.tail))
        };
        let expected: Vec<f64> = PLACES.iter().map(of_springs).collect();
        let rigid = lathe.errors(false, &PLACES, force);
        alike(&lathe.errors(true, &PLACES, force), &sum(&rigid, &expected), ROUND_OFF)?;
    }

    /// Maxwell: a unit force at A moves B as one at B moves A. A rest of stiffness k at A takes G_AB²/(G_AA + 1/k) off
    /// the deflection at B.
    #[test]
    fn what_a_rest_takes_off_elsewhere_is_mutual(lathe in lathe(), a in 0.15..0.45, b in 0.55..0.85, rest in 5.0..100.0) {
        let force = 400.0;
        let bare = lathe.errors(true, &[a, b], force);
        let with = |part: f64| Lathe { rests: vec![(part * lathe.length(), rest)], ..lathe.clone() };
        let at_b = bare[1] - with(a).errors(true, &[a, b], force)[1];
        let at_a = bare[0] - with(b).errors(true, &[a, b], force)[0];
        let [own_a, own_b] = [bare[0], bare[1]].map(|error| error / 2.0 / force + 1e-6 / rest);
        alike(&[at_b * own_a], &[at_a * own_b], 1e-8)?;
    }
}
