//! How typical each effect is of machines in a workshop: by these weights the effects of a whole machine are drawn.

/// Every machine has it, more or less.
const ALWAYS: f64 = 4.0;
/// Most machines have it.
const OFTEN: f64 = 2.0;
/// Some machines have it.
const SOMETIMES: f64 = 1.0;
/// A machine that is worn out, bent or badly made.
const SELDOM: f64 = 0.25;

/// Effect, weight, and why.
pub const WEIGHTS: &[(&str, f64, &str)] = &[
    // Turned shafts.
    ("headstock-compliance", ALWAYS, "every unit gives way"),
    ("tailstock-compliance", ALWAYS, "every unit gives way"),
    ("carriage-compliance", ALWAYS, "every unit gives way"),
    ("headstock-contact", SOMETIMES, "spindle bearings are preloaded, so that they are springs"),
    ("tailstock-contact", SOMETIMES, "a quill is clamped, most often well"),
    ("carriage-contact", SOMETIMES, "gibs are adjusted, most often well"),
    ("chuck-tilt", SOMETIMES, "a chuck holds long work over short jaws"),
    ("force-feedback", OFTEN, "the force follows the depth"),
    ("tool-wear", ALWAYS, "every edge wears"),
    (
        "offset-correction",
        SOMETIMES,
        "offsets are corrected in the middle of a batch, and it is not always written down",
    ),
    ("insert-change", SELDOM, "inserts are changed within a batch where edges last for less than one"),
    ("tool-thermal-growth", OFTEN, "tools warm, less so under coolant"),
    ("workpiece-heating", OFTEN, "work warms, less so under coolant"),
    ("spindle-thermal-drift", ALWAYS, "every headstock warms from a cold start"),
    ("guideway-taper", SOMETIMES, "ways are aligned, but not for ever"),
    ("guideway-height", SELDOM, "a bent way: it shows by its square only"),
    ("guideway-wear", SELDOM, "a dip needs years in one place"),
    ("tailstock-offset", OFTEN, "a tailstock is set by hand"),
    ("setting-error", ALWAYS, "every tool is set, by hand or by a probe"),
    ("tool-breakdown", SELDOM, "edges are changed before"),
    ("wear-land", SOMETIMES, "it replaces wear where the land was measured"),
    ("front-guideway-wear", SELDOM, "a dip needs years in one place"),
    ("bed-twist", SELDOM, "beds are levelled"),
    ("bed-sag", SELDOM, "beds are stiff"),
    ("rest-offset", OFTEN, "a rest is set by hand"),
    ("cross-slide-play", SOMETIMES, "gibs wear, but the cut presses one way"),
    // Bored rings.
    ("jaw-contact-arc", ALWAYS, "no jaw presses along a line"),
    ("jaw-position", OFTEN, "jaws that are not bored in place are off"),
    ("jaw-imbalance", OFTEN, "independent jaws are tightened one by one"),
    ("centrifugal-unloading", OFTEN, "every jaw has mass"),
    ("residual-stress", OFTEN, "drawn and forged rings have it"),
    ("spindle-error", OFTEN, "every spindle has one"),
    ("chuck-runout", OFTEN, "no chuck runs true"),
    ("cutting-heat", ALWAYS, "all work warms"),
    ("copying", ALWAYS, "no blank is round, and every tool gives way"),
    // Heated rods.
    ("convection", ALWAYS, "every body stands in air"),
    ("base-conductance", ALWAYS, "every body stands on something"),
    ("ambient-drift", OFTEN, "rooms swing through the day"),
    ("extra-source", SELDOM, "a source that nobody knows is rare"),
    ("heater-capacity", OFTEN, "every heater has mass"),
    ("contact-resistance", SOMETIMES, "bodies of several pieces have joints"),
    ("sensor-lag", OFTEN, "every sensor lags"),
    // Feed axes.
    ("scale-error", ALWAYS, "no screw and no scale is exact"),
    ("periodic-error", OFTEN, "every screw and every encoder has one"),
    ("backlash", ALWAYS, "no compensation is exact"),
    ("uneven-backlash", SOMETIMES, "screws wear where they work"),
    ("worn-screw", SELDOM, "a screw worn in its middle needs years of short travels"),
    ("elastic-lost-motion", OFTEN, "every drive winds up"),
    ("thermal-growth", ALWAYS, "every screw warms when it runs"),
    ("abbe-error", SOMETIMES, "the line of measurement is put near the axis, and ways are nearly straight"),
    ("reference-shift", OFTEN, "a zero is set anew for each test"),
    // Rotary axes; play and a shifted zero are those of feed axes.
    ("worm-error", ALWAYS, "every worm runs out by some micrometres"),
    ("worm-second-harmonic", OFTEN, "worms and couplings are oval by less than they run out"),
    ("wheel-eccentricity", OFTEN, "a wheel is centred by hand"),
    ("tooth-error", OFTEN, "no flank is an involute to an arc second"),
    ("gear-eccentricity", OFTEN, "pinions run out"),
    ("motor-gear-eccentricity", SOMETIMES, "what a pinion on the motor is off by, the ratio makes small"),
    ("ratio-error", SELDOM, "teeth are whole numbers"),
    ("elastic-wind-up", OFTEN, "every drive winds up"),
    ("compliance", OFTEN, "no drive is rigid"),
    ("unbalance", OFTEN, "what an axis carries is seldom balanced"),
    ("scale-eccentricity", OFTEN, "a ring is centred by hand"),
    ("scale-second-harmonic", SOMETIMES, "rings follow their seat"),
    ("interpolation-error", SOMETIMES, "it is a hundredth of a line"),
    ("thermal-drift", OFTEN, "every drive warms when it runs"),
    // Joints under load; fixtures share the contact and, with shafts, the feedback.
    ("gap", OFTEN, "joints have play unless they are preloaded"),
    ("contact-joint", ALWAYS, "rough surfaces touch in every joint"),
    ("headstock-friction", SELDOM, "clamped joints hardly slide under a finishing cut"),
    ("tailstock-friction", SELDOM, "clamped joints hardly slide under a finishing cut"),
    ("dry-friction", OFTEN, "surfaces that slide rub"),
    ("preload", SOMETIMES, "bearings and screws are preloaded"),
    ("settling", OFTEN, "joints settle under their first load"),
    ("datum-offset", OFTEN, "a gauge is set to zero by hand"),
    // Contours.
    ("servo-mismatch", OFTEN, "gains are matched, but not for ever"),
    ("gain-with-feed-x", SELDOM, "drives are linear unless they rub"),
    ("gain-with-feed-y", SELDOM, "drives are linear unless they rub"),
    ("backlash-x", ALWAYS, "no compensation is exact"),
    ("backlash-y", ALWAYS, "no compensation is exact"),
    ("elastic-lost-motion-x", SOMETIMES, "drives wind up, stiff ones by little"),
    ("elastic-lost-motion-y", SOMETIMES, "drives wind up, stiff ones by little"),
    ("cyclic-error-x", OFTEN, "every screw and every encoder has one"),
    ("cyclic-error-y", OFTEN, "every screw and every encoder has one"),
    ("stick-slip-x", SELDOM, "ways are made against it"),
    ("stick-slip-y", SELDOM, "ways are made against it"),
    ("scale-mismatch", OFTEN, "no two scales are equal"),
    ("squareness", ALWAYS, "no two axes are square"),
    ("cutting-deflection", SOMETIMES, "tests are cut seldom, and then every system gives way"),
    ("reversal-spike-x", OFTEN, "friction holds every slide at its reversal"),
    ("reversal-spike-y", OFTEN, "friction holds every slide at its reversal"),
    ("centre-offset", ALWAYS, "an instrument is centred by hand"),
    // Parts in fixtures.
    ("support-compliance", ALWAYS, "every support gives way"),
    ("clamp-offset", SOMETIMES, "clamps are set by hand, near their mark"),
    ("cutter-tilt", SOMETIMES, "heads are trammed, but not for ever"),
    ("locator-height", ALWAYS, "no two locators are equally high"),
    ("locator-wear", ALWAYS, "every locator wears"),
    // Ground cams.
    ("wheel-wear", ALWAYS, "every wheel wears"),
    ("servo-lag", OFTEN, "every drive lags, some behind feed-forward"),
    ("infeed-backlash", OFTEN, "no compensation is exact"),
    ("centre-height", ALWAYS, "heads are set by hand"),
    ("grinding-deflection", ALWAYS, "every system gives way"),
];

/// Weight of an effect; 0 of an unknown one.
pub fn weight(effect: &str) -> f64 {
    WEIGHTS.iter().find(|own| own.0 == effect).map_or(0.0, |own| own.1)
}
