//! What a run tells of a membrane: what gives way, how it opens, and what its plate bears.

use super::super::membrane::Grasp;
use crate::process::Figure;
use crate::units::{FORCE, LENGTH, MICRO, STIFFNESS, STRESS};

/// Deflections are small up to this part of the thickness: beyond, what the plate stretches makes it stiffer.
const SMALL: f64 = 0.5;
/// Thickness as a part of the length over which it bends, above which shear adds more than some hundredths: the square of that.
const THICK: f64 = 0.25;

/// Stiffnesses in series, the opening, stresses.
pub fn figure(grasp: &Grasp) -> Figure {
    let (membrane, force) = (&grasp.membrane, grasp.force());
    let clamped = membrane.pressed(force);
    let (sprung, given) = (0.5 * membrane.interference, grasp.ring * force);
    let stress = membrane.plate.stress(clamped.moment);
    let [stiffness, ring] = [grasp.own, grasp.ring].map(|compliance| STIFFNESS.shown(1.0 / compliance));
    let [radius, gives, bows] = [sprung, given, clamped.deflection].map(|length| MICRO.shown(length));
    let figure = Figure::new("membrane", "membrane")
        .line(format!("{stiffness:.2} at each jaw, the ring {ring:.2}: of {radius:.2} on the radius the ring gives way by {gives:.2}"))
        .line(format!("clamped the plate bows by {bows:.1} and bears {:.1} of bending", STRESS.shown(stress)))
        .quantity("stiffness", STIFFNESS, 1.0 / grasp.own)
        .quantity("ring_stiffness", STIFFNESS, 1.0 / grasp.ring)
        .quantity("ring_gives_way", MICRO, given)
        .quantity("bow", MICRO, clamped.deflection)
        .quantity("stress", STRESS, stress);
    let Some(push) = membrane.push else { return figure };
    let open = membrane.opened(push);
    let (stroke, stress) = (open.slope * membrane.length, membrane.plate.stress(open.moment));
    let [opens, bows] = [stroke, open.deflection].map(|length| MICRO.shown(length));
    let asked = FORCE.shown(push.force * sprung / stroke);
    figure
        .line(format!(
            "a push of {:.0} opens the jaws by {opens:.2} on the radius, {asked:.0} would let the ring in",
            FORCE.shown(push.force)
        ))
        .line(format!("pushed open it bows by {bows:.1} and bears {:.1}", STRESS.shown(stress)))
        .quantity("stroke", MICRO, stroke)
        .quantity("push_to_open", FORCE, push.force * sprung / stroke)
        .quantity("bow_open", MICRO, open.deflection)
        .quantity("stress_open", STRESS, stress)
}

/// What a run warns of.
pub fn warnings(grasp: &Grasp) -> Vec<String> {
    let membrane = &grasp.membrane;
    let open = membrane.push.map(|push| membrane.opened(push));
    let shut = open.map(|open| open.slope * membrane.length).filter(|stroke| *stroke < 0.5 * membrane.interference);
    let shut = shut.map(|stroke| {
        let [stroke, larger] = [stroke, 0.5 * membrane.interference].map(|length| MICRO.shown(length));
        format!("the push opens the jaws by {stroke:.1} on the radius, and the ring is larger by {larger:.1}: it does not go in")
    });
    let bow = membrane.pressed(grasp.force()).deflection.max(open.map_or(0.0, |open| open.deflection));
    let stretched = (bow > SMALL * membrane.plate.thickness).then(|| {
        format!(
            "the plate bows by {:.0}, more than half of its thickness: it stretches, and is stiffer than it is taken to be",
            MICRO.shown(bow)
        )
    });
    let plate = &membrane.plate;
    let beside = membrane.arms.circle.min(plate.radius - membrane.arms.circle);
    let thick = (plate.thickness > THICK * beside).then(|| {
        let [thickness, beside] = [plate.thickness, beside].map(|length| LENGTH.shown(length));
        format!(
            "the plate is {thickness:.1} thick, and bends over {beside:.1} beside the jaws: it shears, which is left out, and is \
             softer than it is taken to be"
        )
    });
    shut.into_iter().chain(stretched).chain(thick).collect()
}
