//! What the drawing of a turned shaft asks of every part: diameters, taper, cylindricity.

use crate::input::Reader;
use crate::process::Segment;
use crate::tolerance::Limits;
use crate::units::MICRO;

/// Limits of the sections, from the headstock, and of their form.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tolerance {
    /// Limits of the diameter of each section, m, with what was written.
    pub diameters: Vec<Option<(Limits, String)>>,
    /// Largest difference of the diameters at the ends of a section, m.
    pub taper: Option<f64>,
    /// Largest distance of two coaxial cylinders with the surface of a section between them, m (ISO 1101:2017, 17.5).
    pub cylindricity: Option<f64>,
}

impl Tolerance {
    /// Reads `[tolerance]`.
    pub fn read(model: &Reader, segments: &[Segment]) -> Self {
        let read = |t: &Reader| {
            let limits = |t: &Reader, segment: &Segment| {
                let size = Some(segment.section.diameter);
                let limits =
                    Limits::read(t, "diameter", "limits of the diameter: h6, ±10 um, -16 um to 0 um", MICRO, size);
                limits.zip(t.written("diameter").map(str::to_string))
            };
            // What is written for all is read once for each size, and told once where it is wrong.
            let mut diameters: Vec<_> = segments.iter().take(1).map(|first| limits(t, first)).collect();
            if t.is_sound() {
                diameters.extend(segments.iter().skip(1).map(|own| limits(t, own)));
            }
            diameters.resize(segments.len(), None);
            let own = t.list("sections", "sections with limits of their own", |t, _| {
                let number = t.count("segment", "number of the segment, from the headstock");
                let number = number.between(1, segments.len().max(1)).required();
                (number, segments.get(number - 1).and_then(|segment| limits(t, segment)))
            });
            for (number, limits) in own {
                if let Some(place) = diameters.get_mut(number - 1) {
                    *place = limits;
                }
            }
            let form = |key, about| t.quantity(key, MICRO, about).chosen().positive().optional();
            let taper = form("taper", "largest difference of the diameters at the ends of a section");
            let cylindricity =
                form("cylindricity", "distance of two coaxial cylinders that hold a section between them");
            Self { diameters, taper, cylindricity }
        };
        model.optional_table("tolerance", "what the drawing asks of every part", read).unwrap_or_default()
    }
}
