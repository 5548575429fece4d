//! A heated rod: linear in its sources, and no heat comes or goes unseen.

use proptest::prelude::*;

use super::{alike, model, observed, times};

/// Of the rods; kg/m³, J/kg/K, 1/K.
const DENSITY: f64 = 7850.0;
const SPECIFIC_HEAT: f64 = 460.0;
const EXPANSION: f64 = 11.7e-6;

#[derive(Clone, Debug)]
pub(super) struct Rod {
    /// Length and diameter of each segment from the base, mm.
    segments: Vec<(f64, f64)>,
    /// Places of two sources as parts of the length.
    sources: [f64; 2],
    /// Coefficient of convection, W/m²/K.
    convection: f64,
    /// Conductance from the base, W/K.
    base: f64,
    /// Time step, of which the run has forty, s.
    step: f64,
}

pub(super) fn rod() -> impl Strategy<Value = Rod> {
    let segments = prop::collection::vec((30.0..120.0, 15.0..40.0), 1..4);
    (segments, 0.05..0.45, 0.55..0.95, 5.0..60.0).prop_map(|(segments, a, b, convection)| Rod {
        segments,
        sources: [a, b],
        convection,
        base: 0.8,
        step: 60.0,
    })
}

impl Rod {
    fn length(&self) -> f64 {
        self.segments.iter().map(|s| s.0).sum()
    }

    /// The rod with the power of each source, W; its surroundings begin with it at 0 degC.
    pub(super) fn text(&self, powers: [f64; 2], loses: bool) -> String {
        let segment =
            |(length, diameter): &(f64, f64)| format!("{{ length = \"{length} mm\", diameter = \"{diameter} mm\" }}");
        let segments: Vec<String> = self.segments.iter().map(segment).collect();
        let source =
            |(at, power): (&f64, &f64)| format!("{{ at = \"{} mm\", power = \"{power} W\" }}", at * self.length());
        let sources: Vec<String> = self.sources.iter().zip(&powers).map(source).collect();
        let mut text = format!(
            "process = \"thermal\"\n\
             body = {{ material = {{ base = \"steel\", density = \"{DENSITY} kg/m^3\", specific_heat = \"{SPECIFIC_HEAT} J/kg/K\", \
             expansion = \"{} um/m/K\" }}, segments = [{}] }}\n\
             source = [{}]\nenvironment = {{ temperature = \"0 degC\" }}\ntime = {{ end = \"{} s\", step = \"{} s\" }}\n",
            1e6 * EXPANSION,
            segments.join(", "),
            sources.join(", "),
            40.0 * self.step,
            self.step,
        );
        if loses {
            text += &format!("[effects.convection]\ncoefficient = \"{} W/m^2/K\"\n", self.convection);
            text += &format!("[effects.base-conductance]\nconductance = \"{} W/K\"\n", self.base);
        }
        text
    }

    /// Temperatures (degC, and so the rises) at parts of the length over some times.
    fn rises(&self, powers: [f64; 2], loses: bool, places: &[f64]) -> Vec<f64> {
        let at = |part: &f64| TIMES.map(|time| (time * self.step / 60.0, 1e-3 * part * self.length()));
        let (time, x): (Vec<f64>, Vec<f64>) = places.iter().flat_map(at).unzip();
        let zero = 273.15;
        let kelvins = observed(&model(&self.text(powers, loses)), "temperature", &[("time", &time), ("x", &x)]);
        kelvins.iter().map(|value| value - zero).collect()
    }
}

/// Seconds, where a step has sixty.
const TIMES: [f64; 4] = [60.0, 300.0, 1140.0, 2400.0];

/// Round-off of temperatures about 273 K, of rises of some kelvins.
const OF_KELVINS: f64 = 1e-8;

proptest! {
    #![proptest_config(super::random(100))]

    #[test]
    fn sources_superpose(rod in rod(), first in 2.0..20.0, second in 2.0..20.0) {
        let places = [0.0, 0.2, 0.5, 1.0];
        let of = |powers: [f64; 2]| rod.rises(powers, true, &places);
        let (one, other) = (of([first, 0.0]), of([0.0, second]));
        alike(&super::sum(&one, &other), &of([first, second]), OF_KELVINS)?;
        alike(&times(2.0, &one), &of([2.0 * first, 0.0]), OF_KELVINS)?;
    }

    /// Heat at A warms B as heat at B warms A: conduction is its own adjoint.
    #[test]
    fn what_a_source_warms_elsewhere_is_mutual(rod in rod()) {
        let [a, b] = rod.sources;
        alike(&rod.rises([10.0, 0.0], true, &[b]), &rod.rises([0.0, 10.0], true, &[a]), OF_KELVINS)?;
    }

    #[test]
    fn a_mirrored_rod_warms_as_its_image(rod in rod(), first in 2.0..20.0, second in 2.0..20.0) {
        let image = Rod {
            segments: rod.segments.iter().rev().copied().collect(),
            sources: [1.0 - rod.sources[1], 1.0 - rod.sources[0]],
            ..rod.clone()
        };
        let places = [0.1, 0.4, 0.9];
        let mirrored: Vec<f64> = places.iter().map(|part| 1.0 - part).collect();
        alike(&rod.rises([first, second], false, &places), &image.rises([second, first], false, &mirrored), OF_KELVINS)?;
    }

    /// Rods of one Fourier and one Biot number warm alike: lengths by s, times by s², powers and the
    /// conductance of the base by s, convection by 1/s.
    #[test]
    fn larger_rods_warm_alike_in_their_own_time(
        rod in rod(), first in 2.0..20.0, second in 2.0..20.0, s in 0.5..2.0,
    ) {
        let larger = Rod {
            segments: rod.segments.iter().map(|(length, diameter)| (s * length, s * diameter)).collect(),
            convection: rod.convection / s,
            base: s * rod.base,
            step: s * s * rod.step,
            ..rod.clone()
        };
        let places = [0.0, 0.2, 0.5, 1.0];
        alike(&rod.rises([first, second], true, &places), &larger.rises([s * first, s * second], true, &places), OF_KELVINS)?;
    }

    /// Nothing is lost: a rod of one section grows by α·Q/(ρ·c·A), wherever its heat Q came in.
    #[test]
    fn all_heat_stays_in_a_rod_that_loses_none(rod in rod(), first in 2.0..20.0, second in 2.0..20.0) {
        let diameter = 1e-3 * rod.segments[0].1;
        let even = Rod { segments: vec![rod.segments[0]], ..rod };
        let grown = observed(&model(&even.text([first, second], false)), "elongation", &[("time", &TIMES)]);
        let per_joule = EXPANSION / (DENSITY * SPECIFIC_HEAT * std::f64::consts::PI * diameter * diameter / 4.0);
        alike(&grown, &TIMES.map(|time| per_joule * (first + second) * time), OF_KELVINS)?;
    }

    /// What came in is kept or lost. The elongation of a rod of one section tells the heat ρ·c·A·ΔL/α that it keeps and
    /// the power h·π·d·ΔL/α that its surface loses; its base loses G·θ(0). Over a step, backward Euler counts the loss
    /// at its end, Crank and Nicolson the mean of both ends: of either the balance is exact, but for round-off of differences of what is kept.
    #[test]
    fn heat_is_kept_or_lost(
        rod in rod(), first in 2.0..20.0, second in 2.0..20.0,
        (scheme, at_end) in prop::sample::select(vec![("backward-euler", 1.0), ("crank-nicolson", 0.5)]),
    ) {
        let diameter = 1e-3 * rod.segments[0].1;
        let even = Rod { segments: vec![rod.segments[0]], ..rod };
        let stepped = format!("step = \"60 s\", scheme = \"{scheme}\"");
        let model = model(&even.text([first, second], true).replace("step = \"60 s\"", &stepped));
        let time: Vec<f64> = (1..=40).map(|i| 60.0 * f64::from(i)).collect();
        let grown = observed(&model, "elongation", &[("time", &time)]);
        let base = observed(&model, "temperature", &[("time", &time), ("x", &vec![0.0; time.len()])]);
        let around = std::f64::consts::PI * diameter;
        let kept = times(DENSITY * SPECIFIC_HEAT * around * diameter / 4.0 / EXPANSION, &grown);
        let from_base: Vec<f64> = base.iter().map(|kelvins| 0.8 * (kelvins - 273.15)).collect();
        let losing = super::sum(&times(even.convection * around / EXPANSION, &grown), &from_base);
        // The first steps behind a switch are shorter than those that are asked for.
        for row in 5..time.len() {
            let lost = 60.0 * (at_end * losing[row] + (1.0 - at_end) * losing[row - 1]);
            alike(&[kept[row] - kept[row - 1] + lost], &[60.0 * (first + second)], 1e-7)?;
        }
    }
}
