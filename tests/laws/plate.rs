//! A heated plate: linear in what heats it, the same above as below, and no heat comes or goes unseen.

use proptest::prelude::*;

use super::{alike, model, observed, reported, sum};

#[derive(Clone, Debug)]
pub(super) struct Plate {
    /// Length, height and width, mm.
    size: [f64; 3],
    /// Heat flux into the top and into the bottom, kW/m².
    flux: [f64; 2],
    /// Convection from the top and from the bottom, W/m²/K.
    convection: [f64; 2],
    /// Power of a source over a section (W), and its place as a part of the length.
    source: (f64, f64),
}

pub(super) fn plate() -> impl Strategy<Value = Plate> {
    let size = [100.0..400.0, 15.0..60.0, 20.0..100.0];
    (size, [0.2..4.0, 0.2..4.0], [5.0..60.0, 5.0..60.0], (5.0..50.0, 0.1..0.9))
        .prop_map(|(size, flux, convection, source)| Plate { size, flux, convection, source })
}

/// The run, s.
const END: f64 = 1200.0;

impl Plate {
    /// The model; its surroundings begin with it at 0 degC.
    pub(super) fn text(&self, scheme: &str) -> String {
        let Self { size: [length, height, width], flux, convection, source: (power, part) } = self;
        let edges = ["top", "bottom"].iter().zip(flux.iter().zip(convection)).map(|(edge, (flux, convection))| {
            format!(
                "[[boundary]]\nedge = \"{edge}\"\nflux = \"{flux} kW/m^2\"\n\
                 [[boundary]]\nedge = \"{edge}\"\nconvection = \"{convection} W/m^2/K\"\n"
            )
        });
        format!(
            "process = \"thermal\"\nenvironment = {{ temperature = \"0 degC\" }}\n\
             body = {{ material = \"steel\", rectangle = {{ length = \"{length} mm\", height = \"{height} mm\", width = \"{width} mm\" }} }}\n\
             mesh = {{ element_size = \"{} mm\" }}\ntime = {{ end = \"{END} s\", step = \"60 s\", scheme = \"{scheme}\" }}\n\
             [[source]]\nat = \"{} mm\"\npower = \"{power} W\"\n{}",
            length / 10.0,
            part * length,
            edges.collect::<String>(),
        )
    }

    /// Rises at parts of length and height, and elongations, in the middle of the run and in its end.
    fn rises(&self, parts: &[[f64; 2]]) -> [Vec<f64>; 2] {
        let model = model(&self.text("sdirk2"));
        let metres = |axis: usize| -> Vec<f64> {
            parts.iter().chain(parts).map(|part| 1e-3 * part[axis] * self.size[axis]).collect()
        };
        let time: Vec<f64> = [0.5 * END, END].iter().flat_map(|time| vec![*time; parts.len()]).collect();
        let kelvins = observed(&model, "temperature", &[("time", &time), ("x", &metres(0)), ("y", &metres(1))]);
        let grown = observed(&model, "elongation", &[("time", &[0.5 * END, END])]);
        [kelvins.iter().map(|value| value - 273.15).collect(), grown]
    }

    /// Upside down.
    fn turned(&self) -> Self {
        let swapped = |[top, bottom]: [f64; 2]| [bottom, top];
        Self { flux: swapped(self.flux), convection: swapped(self.convection), ..self.clone() }
    }
}

const PARTS: [[f64; 2]; 5] = [[0.0, 0.0], [0.13, 0.8], [0.5, 0.5], [0.77, 0.31], [1.0, 0.9]];

/// Round-off of temperatures about 273 K, of rises of some kelvins.
const OF_KELVINS: f64 = 1e-8;

proptest! {
    #![proptest_config(super::random(32))]

    /// What flows in is what area, time and source give, and all of it is stored or lost.
    #[test]
    fn heat_is_kept_or_lost(plate in plate(), scheme in prop::sample::select(vec!["sdirk2", "crank-nicolson", "backward-euler"])) {
        let model = model(&plate.text(scheme));
        let [supplied, lost, stored] = ["supplied", "lost", "stored"].map(|name| reported(&model, "energy", name));
        let area = 1e-6 * plate.size[0] * plate.size[2];
        let given = END * (1e3 * area * (plate.flux[0] + plate.flux[1]) + plate.source.0);
        alike(&[supplied, lost + stored], &[given, given], 1e-9)?;
        prop_assert!(lost > 0.0 && stored > 0.0, "{lost} J lost, {stored} J stored");
    }

    #[test]
    fn fluxes_and_sources_superpose(plate in plate()) {
        let none = Plate { flux: [0.0; 2], source: (0.0, plate.source.1), ..plate.clone() };
        let alone = [
            Plate { flux: [plate.flux[0], 0.0], ..none.clone() },
            Plate { flux: [0.0, plate.flux[1]], ..none.clone() },
            Plate { source: plate.source, ..none },
        ];
        let all = plate.rises(&PARTS);
        for (which, all) in all.iter().enumerate() {
            let nothing = vec![0.0; all.len()];
            let one_by_one = alone.iter().fold(nothing, |before, one| sum(&before, &one.rises(&PARTS)[which]));
            alike(&one_by_one, all, OF_KELVINS)?;
        }
    }

    /// Upside down it warms alike, grows as much, and bows the other way.
    #[test]
    fn a_plate_upside_down_bows_the_other_way(plate in plate()) {
        let turned = plate.turned();
        let image = PARTS.map(|[x, y]| [x, 1.0 - y]);
        let (own, other) = (plate.rises(&PARTS), turned.rises(&image));
        alike(&own[0], &other[0], OF_KELVINS)?;
        alike(&own[1], &other[1], OF_KELVINS)?;
        let [up, down] = [&plate, &turned].map(|plate| reported(&model(&plate.text("sdirk2")), "bow", "end"));
        // A bow is a difference of displacements as large as the elongation.
        prop_assert!((up + down).abs() <= OF_KELVINS * own[1][1].abs().max(up.abs()), "{up:e} and {down:e}");
    }
}
