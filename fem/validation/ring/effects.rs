//! Effects of chuck and cut, by hand.

use super::rig::*;
use crate::processes::ring::rows::{BLANK, JAW_FORCE, ORIENTATION, SPEED, STATE};
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    let plain = chuck(&ring(84.0, 3), "");
    let at = |effects: &str, angle: f64, changes: &[(usize, f64)]| {
        deviations(&chuck(&ring(84.0, 3), effects), &[angle], changes)[0]
    };
    let squeezed = |angle: f64| deviations(&plain, &[angle], &[])[0];
    let added = |effects: &str, angle: f64, changes: &[(usize, f64)]| at(effects, angle, changes) - squeezed(angle);
    let added_row = |name: &str, expected: f64, computed: f64, source| {
        row(name, "deviation", (1e6 * expected, 1e6 * computed, "um"), Tolerance::Absolute(1e-9), source)
    };
    let rpm = std::f64::consts::TAU / 60.0;
    let throwing = "[centrifugal-unloading]\njaw_moment = \"50 kg*mm\"";
    // 0.05 kg m at 400, 800 and 3000 rpm.
    let left = |speed: f64| (3000.0 - 0.05 * (speed * rpm).powi(2)).max(0.0) / 3000.0;
    let thrown = |speed: f64| at(throwing, 0.0, &[(SPEED, speed * rpm)]) / squeezed(0.0);
    let let_go = chuck(&ring(84.0, 3), throwing).map_or(f64::NAN, |c| c.machine().let_go() / rpm);
    let source = "F0 - m*r*omega^2";
    let part = |name: &str, expected, computed, source| {
        row(name, "part of the deviation", (expected, computed, "-"), ROUND_OFF, source)
    };
    let copying = "[copying]\nstiffness = \"19 N/um\"";
    let stressed = "[residual-stress]\namplitude = \"4 um\"\nphase = \"20 deg\"";
    let spindle = "[spindle-error]\namplitude = \"3 um\"\nphase = \"-35 deg\"";
    let eccentric = "[chuck-runout]\nrunout = \"30 um\"\nphase = \"50 deg\"";
    let both = format!("{eccentric}\n{copying}");
    let degrees = f64::to_radians;
    // Springs of 38 N/um on both sides of the cut: 19 N/um between them. A bar on top of that, and a tool of 19 N/um beside it.
    let springs = "[structure]\nmaterial = \"steel\"\n[structure.nodes]\nnose = [\"0 mm\", \"0 mm\"]\nslide = [\"200 mm\", \"0 mm\"]\ntip = [\"60 mm\", \"0 mm\"]\n\
        [structure.front]\nat = \"nose\"\nalong = \"y\"\nstiffness = \"38 N/um\"\n[structure.guide]\nat = \"slide\"\nalong = \"y\"\nstiffness = \"38 N/um\"\n\
        [structure.keep-nose]\nat = \"nose\"\nalong = \"x\"\nstiffness = \"100 N/um\"\n[structure.keep-slide]\nat = \"slide\"\nalong = \"x\"\nstiffness = \"100 N/um\"\n\
        [structure.square-nose]\nat = \"nose\"\nalong = \"turning\"\nstiffness = \"1 kN*m/rad\"\n[structure.square-slide]\nat = \"slide\"\nalong = \"turning\"\nstiffness = \"1000000 kN*m/rad\"\n\
        [structure.bar]\nbetween = [\"slide\", \"tip\"]\ndiameter = \"40 mm\"\n";
    let drawn = |tool: &str, effects: &str| {
        let text = format!("{}\n{springs}[structure.ports]\nspindle = \"nose\"\ntool = \"{tool}\"\n", ring(84.0, 3));
        deviations(&chuck(&text, effects), &[0.7], &[])[0] / squeezed(0.7)
    };
    let kept = |newtons_per_um: f64| newtons_per_um / (newtons_per_um + 1.0);
    // A cantilever of 140 mm that bends and shears (Cowper's 6(1 + nu)/(7 + 6 nu)) on the slide.
    let (inertia, area) = (std::f64::consts::PI * 0.04f64.powi(4) / 64.0, std::f64::consts::PI * 4e-4);
    let bends = 0.14f64.powi(3) / (3.0 * 210e9 * inertia);
    let shears = 0.14 / (6.0 * 1.3 / (7.0 + 6.0 * 0.3) * 210e9 / 2.6 * area);
    let on_bar = 1e-6 / (1.0 / 19e6 + bends + shears + 0.14f64.powi(2) / 1e9);
    vec![
        part("jaws thrown outwards at 400 rpm", left(400.0), thrown(400.0), source),
        part("jaws thrown outwards at 1800 rpm", left(1800.0), thrown(1800.0), source),
        row(
            "jaws thrown outwards at 3000 rpm",
            "deviation",
            (0.0, 1e6 * at(throwing, 0.0, &[(SPEED, 3000.0 * rpm)]), "um"),
            Tolerance::Absolute(1e-12),
            source,
        ),
        row(
            "jaws of 50 kg mm and 3 kN",
            "let go above",
            ((3000.0f64 / 0.05).sqrt() / rpm, let_go, "rpm"),
            ROUND_OFF,
            source,
        ),
        part(
            "clamped at standstill, whatever the speed",
            -1.0,
            at(throwing, 0.0, &[(STATE, 1.0), (SPEED, 800.0 * rpm)]) / squeezed(0.0),
            source,
        ),
        part("half the jaw force", 0.5, at("", 0.3, &[(JAW_FORCE, 1500.0)]) / squeezed(0.3), "linear elasticity"),
        part(
            "tool of 19 N/um at 1 N/um, round blank as it is squeezed",
            0.95,
            at(copying, 0.7, &[]) / squeezed(0.7),
            "seed 002 (27): k*(blank + u) - u",
        ),
        part("drawn machine of 19 N/um", 0.95, drawn("slide", ""), "springs in series"),
        part("the same, the tool of 19 N/um beside it", kept(9.5), drawn("slide", copying), "springs in series"),
        row(
            "the same, tool on a bar of 140 mm",
            "part of the deviation",
            (kept(on_bar), drawn("tip", ""), "-"),
            Tolerance::Relative(1e-9),
            "cantilever that bends and shears (Cowper 1966)",
        ),
        added_row(
            "the same, blank off by 40 um",
            (40e-6 - squeezed(0.7)) / 20.0,
            added(copying, 0.7, &[(BLANK, 40e-6)]),
            "seed 002 (27): k*(blank + u) - u",
        ),
        added_row(
            "the same, oval of the spindle of 3 um",
            (3e-6 * (2.0 * degrees(95.0)).cos()) * 0.95 - squeezed(degrees(60.0)) / 20.0,
            added(&format!("{spindle}\n{copying}"), degrees(60.0), &[]),
            "s - k*(s - u) - u",
        ),
        added_row(
            "the same, bored 10 K too warm",
            -0.95 * 11.5e-6 * 0.042 * 10.0 - squeezed(1.0) / 20.0,
            added(&format!("[cutting-heat]\ntemperature_rise = \"10 K\"\n{copying}"), 1.0, &[]),
            "k*(u + heat) - u - heat",
        ),
        added_row(
            "ring bored 10 K too warm",
            -11.5e-6 * 0.042 * 10.0,
            added("[cutting-heat]\ntemperature_rise = \"10 K\"", 1.0, &[]),
            "seed 002 (36)",
        ),
        added_row(
            "oval of residual stress, mark at 30 deg",
            4e-6 * (2.0 * degrees(10.0)).cos(),
            added(stressed, degrees(60.0), &[(ORIENTATION, degrees(30.0))]),
            "A cos 2(theta - orientation - phase)",
        ),
        added_row(
            "oval of the spindle, mark at 30 deg",
            3e-6 * (2.0 * degrees(95.0)).cos(),
            added(spindle, degrees(60.0), &[(ORIENTATION, degrees(30.0))]),
            "A cos 2(theta - phase)",
        ),
        added_row(
            "chuck that runs out by 30 um, 30 deg from the crest",
            -15e-6 * degrees(30.0).cos(),
            added(eccentric, degrees(80.0), &[(ORIENTATION, degrees(30.0))]),
            "half the reading times cos(theta - phase)",
        ),
        // A tool that yields leaves a twentieth of what it finds: 40 um of the blank, and 15 um of the chuck's.
        added_row(
            "the same and a tool of 19 N/um, blank off by 40 um, at the crest",
            -15e-6 + (40e-6 + 15e-6 - squeezed(degrees(50.0))) / 20.0,
            added(&both, degrees(50.0), &[(BLANK, 40e-6)]),
            "two axes, and seed 002 (27) about the spindle's",
        ),
        row(
            "oval of residual stress, clamped",
            "deviation",
            (-1e6 * squeezed(0.2), 1e6 * at(stressed, 0.2, &[(STATE, 1.0)]), "um"),
            ROUND_OFF,
            "a ring that is not bored yet has no cut",
        ),
    ]
}
