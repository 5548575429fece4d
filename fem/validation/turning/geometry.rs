//! Geometric errors of the machine in the diameter.

use super::rig::*;
use crate::validation::bench::figure as figure_of;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [shifts(), play(), carriage(), hyperboloid()].concat()
}

fn shifts() -> Vec<Case> {
    let at = |name: &str, effect: &str, x: f64, expected: f64, source| {
        diameter_error(name, (expected, shift(&uniform("centres", effect), 1, x)), source)
    };
    let worn = "[guideway-wear]\ndepth = \"8 um\"\ncentre = \"200 mm\"\nwidth = \"50 mm\"";
    let high = lathe(
        &UNIFORM.replace("HELD\"", "centres\", centre_height = \"400 mm\""),
        "[bed-twist]\ntwist = \"30 um/m/m\"",
    );
    let by_height = row(
        "bed twist 30 um/m/m, centres 400 mm high, x = 0.4 m",
        "diameter error",
        (2.0 * 0.4 * (12e-6f64).sin(), shift(&high, 1, 0.4), "m"),
        Tolerance::Relative(12e-6 * 12e-6),
        "nose turned about the guideways by the twist of 0.4 m; its sine",
    );
    vec![
        by_height,
        at("bed twist 30 um/m/m, x = 0.4 m", "[bed-twist]\ntwist = \"30 um/m/m\"", 0.4, 6e-6, "geometry of guideways"),
        at("guideway taper 30 um/m, x = 0.4 m", "[guideway-taper]\nslope = \"30 um/m\"", 0.4, 24e-6, "seed 002 (6)"),
        at("tailstock offset 10 um, x = 0.3 L", "[tailstock-offset]\noffset = \"10 um\"", 0.15, 6e-6, "statics"),
        at(
            "setting error -6 um",
            "[setting-error]\noffset = \"-6 um\"",
            0.1,
            -12e-6,
            "seed 002 (6): the nose off by dy",
        ),
        at("guideway wear, worst place", worn, 0.2, 16e-6, "seed 002, wear of the guideways"),
        at("guideway wear, one width off", worn, 0.25, 16e-6 * (-0.5f64).exp(), "seed 002, wear of the guideways"),
    ]
}

/// A stepped shaft, Ø30, Ø50, Ø50, Ø49.98 and Ø40 from the tailstock, 100 mm each, and a slide with 15 um of play: from
/// Ø30 to Ø50 it moves outwards and stays behind by all of it, keeps that along the second Ø50, takes up 10 um of it on the
/// way in to Ø49.98, and the rest on that to Ø40.
fn play() -> Vec<Case> {
    let one = |diameter: &str| format!("{{ length = \"100 mm\", diameter = \"{diameter} mm\" }}");
    let all = ["40", "49.98", "50", "50", "30"].map(one).join(", ");
    let text = UNIFORM.replace("HELD", "centres").replace("{ length = \"500 mm\", diameter = \"40 mm\" }", &all);
    let effect = "[cross-slide-play]\ngap = \"15 um\"";
    let backwards = lathe(&text, effect);
    // The other way round Ø40 is where the pass begins; the slide climbs to Ø49.98, by 10 um to Ø50, and goes in to Ø30.
    let forwards = lathe(&text.replace("radial_force", "from = \"0 mm\", to = \"500 mm\", radial_force"), effect);
    let at = |lathe: &Option<Lathe>, way: &str, x: f64, expected: f64| {
        let name = format!("cross slide with 15 um of play, {way}, x = {x} m");
        let tolerance = Tolerance::Absolute(1e-16);
        row(
            name,
            "diameter error",
            (expected, shift(lathe, 1, x), "m"),
            tolerance,
            "seed 000, fig. 2a: the nut moved by hand",
        )
    };
    vec![
        at(&backwards, "to the headstock", 0.45, 0.0),
        at(&backwards, "to the headstock", 0.35, -30e-6),
        at(&backwards, "to the headstock", 0.25, -30e-6),
        at(&backwards, "to the headstock", 0.15, -10e-6),
        at(&backwards, "to the headstock", 0.05, 0.0),
        at(&forwards, "to the tailstock", 0.05, 0.0),
        at(&forwards, "to the tailstock", 0.15, -30e-6),
        at(&forwards, "to the tailstock", 0.35, -30e-6),
        at(&forwards, "to the tailstock", 0.45, 0.0),
    ]
}

/// A carriage on two guideways 300 mm apart that have sunk apart: the rigid body turned exactly, on its front foot.
/// The nose stands 250 mm above them and 100 mm behind the front one, so that a turn by θ is off by 0.2·θ.
fn carriage() -> Vec<Case> {
    let toward_front = |front: f64, rear: f64| {
        let turn = ((front - rear) / 0.3).atan();
        0.25 * turn.sin() + 0.1 * (1.0 - turn.cos())
    };
    let on_two = |effect: &str| lathe(&UNIFORM.replace("HELD\"", "centres\", guideway_spacing = \"300 mm\""), effect);
    let worn = on_two("[front-guideway-wear]\nwear = \"30 um\"\ncentre = \"200 mm\"\nwidth = \"50 mm\"");
    let sagged = on_two("[bed-sag]\nfront = \"40 um\"\nrear = \"-20 um\"");
    let fallen = on_two("[bed-sag]\nfront = \"200 um\"\nrear = \"200 um\"");
    let (turned, source) = (
        Tolerance::Relative(0.2 * 2e-4),
        "seed 002, wear and sag of the guideways: rigid carriage turned on its front foot",
    );
    let at = |name: &str, expected: f64, lathe: &Option<Lathe>, x: f64, tolerance, source| {
        row(name, "diameter error", (expected, shift(lathe, 1, x), "m"), tolerance, source)
    };
    let root = 2.0 * (0.02f64.powi(2) + 200e-6f64.powi(2)).sqrt() - 0.04;
    let exact = Tolerance::Relative(1e-9);
    let half = (-0.5f64).exp();
    let beside = 2.0 * toward_front(half * 30e-6, half * 6e-6);
    vec![
        at("front guideway worn 30 um", 2.0 * toward_front(30e-6, 6e-6), &worn, 0.2, turned, source),
        at("the same, one width off", beside, &worn, 0.25, turned, source),
        at(
            "guideways that sag 40 and -20 um, middle",
            2.0 * toward_front(40e-6, -20e-6),
            &sagged,
            0.25,
            turned,
            source,
        ),
        at("the same, a tenth along", 2.0 * toward_front(14.4e-6, -7.2e-6), &sagged, 0.05, turned, source),
        at("guideways that sag alike by 200 um, middle", root, &fallen, 0.25, exact, "seed 002 (2)"),
    ]
}

/// The tool nose off the axis by Δz = 2 mm/m·x, and also by Δy = 0.5 mm/m·x.
fn hyperboloid() -> Vec<Case> {
    let height = uniform("centres", "[guideway-height]\nslope = \"2 mm/m\"");
    let both = uniform("centres", "[guideway-height]\nslope = \"2 mm/m\"\n[guideway-taper]\nslope = \"500 um/m\"");
    let (d, z) = (0.04f64, 0.8e-3f64);
    let exact = 2.0 * ((0.5 * d).powi(2) + z * z).sqrt() - d;
    let tilted = 2.0 * ((0.5 * d + 0.2e-3).powi(2) + z * z).sqrt() - d;
    // y² over x is a parabola a·x² + 2d·x + f; a from its second difference. I₂ = −a < 0 says hyperbola.
    let y2 = |x: f64| (0.5 * (d + shift(&height, 1, x))).powi(2);
    let a = (y2(0.4) - 2.0 * y2(0.2) + y2(0.0)) / (2.0 * 0.2 * 0.2);
    // Added up, and not joined under the root, these would be 0.3 um more.
    let steep = uniform("centres", "[guideway-height]\nslope = \"5 mm/m\"\n[guideway-taper]\nslope = \"200 um/m\"");
    let askew = 2.0 * ((0.5 * d + 60e-6).powi(2) + 1.5e-3f64.powi(2)).sqrt() - d;
    let at = |name: &str, pair: (f64, f64), tolerance, source| {
        row(name, "diameter error", (pair.0, pair.1, "m"), tolerance, source)
    };
    let (risen, first) = (shift(&height, 1, 0.4), 2.0 * z * z / d);
    let (own, exactly) = (Tolerance::Relative(z * z / (d * d)), Tolerance::Relative(1e-11));
    // With the taper d and f are not zero: I₁ = d² − a·f = −(D/2)²·(tan β/cos α)² and I₂ = −(tan²α + …), as a run tells.
    let told = |key: &str| figure_of(&both, "conic", key);
    // The two angles of (3): a path that runs x/cos(α) rises by tan(β) of it.
    let (alpha, beta) = (0.2f64.to_radians(), 0.5f64.to_radians());
    let (across, up) = (alpha.tan(), beta.tan() / alpha.cos());
    let slopes = format!(
        "[guideway-height]\nslope = \"{} mm/m\"\n[guideway-taper]\nslope = \"{} mm/m\"",
        1e3 * up,
        1e3 * across
    );
    let askew_path = uniform("centres", &slopes);
    let angled = 2.0 * (d * d / 4.0 + 0.3 * d * across + 0.09 * (across * across + up * up)).sqrt() - d;
    let by_angles = "seed 002 (3): tan(beta)/cos(alpha) of rise per x";
    let (source, handbook) = ("seed 002 (3)-(5): I2 = -tan^2(beta)", "seed 002 (7); its own error is (dz/D)^2");
    let joined = "seed 002 (3): y^2 = (D/2 + x*tan(alpha))^2 + (x*tan(beta))^2";
    vec![
        at("guideway rises 2 mm/m, x = 0.4 m", (exact, risen), Tolerance::Relative(1e-11), "seed 002 (2)"),
        at("the same, handbook's first term", (first, risen), own, handbook),
        at("guideway rises and tapers, x = 0.4 m", (tilted, shift(&both, 1, 0.4)), exactly, joined),
        at("guideway rises 5 mm/m and tapers 200 um/m, x = 0.3 m", (askew, shift(&steep, 1, 0.3)), exactly, joined),
        at(
            "path at 0.2 deg across and 0.5 deg up, x = 0.3 m",
            (angled, shift(&askew_path, 1, 0.3)),
            exactly,
            by_angles,
        ),
        row(
            "hyperboloid of revolution, rises and tapers",
            "invariant I1",
            (-1.6e-3, told("i1"), "mm^2"),
            Tolerance::Relative(1e-7),
            "seed 002 (3)-(5): I1 = -(D/2)^2*tan^2(beta)",
        ),
        row(
            "hyperboloid of revolution, rises and tapers",
            "invariant I2",
            (-4.25e-6, told("i2"), "-"),
            Tolerance::Relative(1e-7),
            "seed 002 (3)-(5): I2 = -tan^2(alpha) - tan^2(beta)",
        ),
        row("hyperboloid of revolution", "invariant I2", (-4e-6, -a, "-"), Tolerance::Relative(1e-9), source),
    ]
}
