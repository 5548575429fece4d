//! Other programmes: ends shifted, slides along x and y, blocks that begin and end at rest, and a pass
//! after a different one.

use std::f64::consts::{PI, TAU};

use super::rig::*;
use crate::processes::cam::cartesian::{self, Block};
use crate::processes::cam::fewest::errors;
use crate::processes::cam::forward;
use crate::processes::cam::guide::Guide;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [shifted(), fewer(), cartesian_blocks(), envelope(), at_rest(), after()].concat()
}

/// The speed of the programmes, rad/s.
const SPEED: f64 = 20.0 * TAU / 60.0;
const TURNING: &str = "cam_speed = \"20 rpm\"";

/// A flank of 40 mm in forty blocks: x = 189/cos φ errs by L²·cos²φ·(1 + sin²φ)/(8·189) in a block. In the
/// middle half of it stays on either side; beside a joint, with one end on the profile and the other at
/// −e/2, 49/64 of it, where √T + √(T + e/2) = 2√e.
fn shifted() -> Vec<Case> {
    let program = format!("step = \"1 mm\"\nends = \"half-error\"\n{TURNING}");
    let cam = cam(&stadium(""), 175.0, &program, "");
    let case = |(number, part, name): (usize, f64, &str)| {
        let at = (20.0 - (number as f64 + 0.5)) / 189.0;
        let sine = at.atan().sin();
        let error = 1e3 * (1.0 - sine * sine) * (1.0 + sine * sine) / (8.0 * 189.0);
        let computed = cam.as_ref().map_or(f64::NAN, |cam| {
            let setup = cam.setup();
            let guide = Guide::new(&setup.profile, setup.wheel_radius);
            let [from, to] = [number, number + 1].map(|i| (setup.program.places[i], setup.program.shifts[i]));
            let (thick, deep) = errors(&setup.profile, &guide, from, to);
            1e6 * if part > 0.0 { thick } else { -deep }
        });
        // The error changes from block to block, and its parabola is the first term, by the angle of a
        // block.
        let tolerance = Tolerance::Relative(8.0 / 189.0);
        let source = "parabola of a block's error; tolerance: eight times its angle";
        row(format!("shifted ends, {name}"), "error", (part * error, computed, "um"), tolerance, source)
    };
    let cases = [
        (19, 0.5, "the flank's middle, left"),
        (19, -0.5, "the flank's middle, cut too deep"),
        (8, 0.5, "a block off the middle, left"),
        (0, 49.0 / 64.0, "a block at a joint, left"),
    ];
    cases.map(case).to_vec()
}

/// Within a tolerance blocks with shifted ends are √2 as long, but for those beside joints and where the
/// error changes its sign.
fn fewer() -> Vec<Case> {
    let count = |ends: &str| {
        let program = format!("tolerance = \"2 um\"\nends = \"{ends}\"\n{TURNING}");
        cam(&circle(20.0, 4.0, true), 175.0, &program, "").map_or(f64::NAN, |cam| cam.setup().program.blocks() as f64)
    };
    let values = (count("on-profile") / 2f64.sqrt(), count("half-error"), "-");
    let source = "seed 003, 3: errors go as the square of lengths; tolerance: the last block, and one at each of two changes of sign";
    vec![row("fewest blocks with shifted ends", "blocks", values, Tolerance::Absolute(3.0), source)]
}

/// Straight and circular blocks on the stadium: a flank from 0 to 40 mm, then an arc of 14 mm about an end.
fn cartesian_blocks() -> Vec<Case> {
    let program = format!("step = \"1 mm\"\n{TURNING}");
    let cam = cam(&stadium(""), 175.0, &program, "");
    let on = |of: &dyn Fn(&crate::processes::cam::profile::Profile, &Guide) -> f64| {
        cam.as_ref().map_or(f64::NAN, |cam| {
            let setup = cam.setup();
            of(&setup.profile, &Guide::new(&setup.profile, setup.wheel_radius))
        })
    };
    let error = |block, from: f64, to: f64| {
        1e6 * on(&|profile, guide| cartesian::error(profile, guide, block, 1e-3 * from, 1e-3 * to))
    };
    let (arc, angle) = (40.0 + 14.0 * 0.1, 0.04f64);
    let sagitta = 1e3 * 189.0 * (1.0 - (0.5 * angle).cos());
    let chord = 2.0 * 189.0 * (0.5 * angle).sin();
    let blocks = |block| {
        on(&|profile, guide| {
            let joints = profile.joints();
            cartesian::fewest(profile, guide, block, (joints[1], joints[2]), 2e-6) as f64
        })
    };
    let straight = (PI / (2.0 * (1.0 - 2e-3 / 189.0f64).acos())).ceil();
    let square = Tolerance::Relative(angle * angle);
    let (along, by_square) =
        (error(Block::Straight, arc, arc + 14.0 * angle), "s^2/(8(rho + R)); tolerance: square of its angle");
    vec![
        row("straight block on an arc", "error", (sagitta, along, "um"), ROUND_OFF, "(rho + R)(1 - cos(angle/2))"),
        row(
            "straight block on an arc, by its chord",
            "error",
            (1e3 * chord * chord / (8.0 * 189.0), along, "um"),
            square,
            by_square,
        ),
        micro(
            "straight block on a flank",
            (0.0, error(Block::Straight, 3.0, 35.0)),
            ROUND_OFF,
            "seed 003, 3: a line beside a line",
        ),
        micro(
            "circular block on an arc",
            (0.0, error(Block::Circular, 40.0, 40.0 + 14.0 * PI)),
            ROUND_OFF,
            "seed 003, 3: an arc beside an arc",
        ),
        row(
            "straight blocks of half a turn within 2 um",
            "blocks",
            (straight, blocks(Block::Straight), "-"),
            Tolerance::Absolute(0.5),
            "acos of the sagitta",
        ),
        row(
            "circular blocks of half a turn",
            "blocks",
            (1.0, blocks(Block::Circular), "-"),
            Tolerance::Absolute(0.5),
            "seed 003, 3: an arc beside an arc",
        ),
    ]
}

/// The grinding point goes along the envelope of a block, not along its profile: at 600 mm/min the first
/// quarter of the source's line, 3.75 mm, has an envelope of 0.278 mm.
fn envelope() -> Vec<Case> {
    let fed = blocks(&seed(&[(TURNING, "feed = \"600 mm/min\"")], ""));
    let mean = fed.as_ref().map_or(f64::NAN, |b| 6e4 * b.list[1].envelope_feed());
    let tenths = fed.as_ref().map_or(f64::NAN, |b| 6e4 * b.list[1].tenths.iter().sum::<f64>() / 10.0);
    // Printed with three decimals.
    let digits = Tolerance::Absolute(0.0005 / 3.75 * 600.0);
    let expected = 0.278 / 3.75 * 600.0;
    let case = |quantity, computed| {
        let name = "cam of the source at 600 mm/min, line in four, the first";
        row(name, quantity, (expected, computed, "mm/min"), digits, "seed 003, 2.1.2: 0.278 mm of envelope in a block")
    };
    vec![case("feed along the envelope", mean), case("the same by tenths", tenths)]
}

/// A concentric circle of 14 mm in eight blocks of 45 deg at 20 rpm, 0.375 s, and 40 rad/s²: the speed is
/// reached after ω/a = 0.05236 s, and every block takes so much longer.
fn at_rest() -> Vec<Case> {
    let program = format!("blocks = 8\n{TURNING}\ncam_acceleration = \"40 rad/s^2\"");
    let text = "[grinding-deflection]\nstiffness = \"4 N/um\"";
    let cam = cam(&circle(14.0, 0.0, true), 175.0, &program, text);
    let ramp = SPEED / 40.0;
    let turn = 8.0 * (0.375 + ramp);
    let told = cam.as_ref().map_or(f64::NAN, |cam| cam.setup().program.axes.times[8]);
    // ω² = 2aφ on the ramp, of which 0.0274 rad is the half.
    let on_ramp = (2.0 * 40.0 * 0.0274f64).sqrt();
    let given = |speed: f64| 10.0 * 0.02 * 14.0 * speed / 4.0;
    let first = blocks(&cam).map_or(f64::NAN, |b| 1e3 * b.list[0].tenths[0]);
    let tenth = (0.375 + ramp) / 10.0;
    // All of the first tenth, 0.0427 s, is on the ramp.
    let mean = 14.0 * 0.5 * 40.0 * tenth;
    vec![
        row(
            "blocks that begin and end at rest",
            "time of a turn",
            (turn, told, "s"),
            Tolerance::Relative(1e-12),
            "T + v/a",
        ),
        row("the same", "feed in the first tenth", (mean, first, "mm/s"), Tolerance::Relative(1e-9), "a*t/2"),
        micro("gives way on the ramp", (given(on_ramp), usual(&cam, 0.0274f64.to_degrees())), ROUND_OFF, "v^2 = 2*a*s"),
        micro("gives way at speed", (given(SPEED), usual(&cam, 22.5)), ROUND_OFF, "F = force_per_rate*stock*feed"),
    ]
}

/// A pass in fine blocks after one of four blocks, one for each segment, whose flank stands out by √(20² +
/// 189²) − 189 at its foot; and one after nine coarse blocks of a circle, which have cut deeper there than
/// the layer is.
fn after() -> Vec<Case> {
    let fine = format!("step = \"0.5 mm\"\n{TURNING}\n[before]\nblocks = 4");
    let out = 1e3 * (20f64.hypot(189.0) - 189.0);
    let plain = cam(&stadium(""), 175.0, &fine, "");
    let layer = plain.as_ref().and_then(|cam| {
        let run = cam.machine().run(cam.setup().program.usual());
        let above = forward::surface(cam.machine(), &run, 0.02)? - forward::reach(cam.machine(), &run, 0.02)?.left;
        Some(1e6 * above)
    });
    let soft = cam(&stadium(""), 175.0, &fine, "[grinding-deflection]\nstiffness = \"40 N/um\"");
    // 10 N/(mm²/s) at 189 mm·ω over 40 N/um.
    let part = 10.0 * 189.0 * SPEED / 40e3;
    let left = part / (1.0 + part) * (20.0 + out);
    // Blocks of 0.5 mm err by 0.5²/(8·189) mm themselves.
    let own = Tolerance::Absolute(0.25e3 / (8.0 * 189.0));
    let slide = |angle: f64| 4.0 * angle.cos() + (195.0f64.powi(2) - (4.0 * angle.sin()).powi(2)).sqrt();
    let coarse = 1e3 * (slide(PI / 9.0) - slide(0.0));
    let beside = cam(&circle(20.0, 4.0, false), 175.0, &format!("blocks = 360\n{TURNING}\n[before]\nblocks = 9"), "");
    vec![
        row(
            "fine blocks after one on each segment",
            "layer at the foot",
            (20.0 + out, layer.unwrap_or(f64::NAN), "um"),
            own,
            "stock + x(end) - x(foot)",
        ),
        micro("gives way to what the pass before left", (left, usual(&soft, 90.0)), own, "y = F(layer - y)/k"),
        micro(
            "cut deeper before than the layer",
            (20.0 + coarse, usual(&beside, 0.0)),
            ROUND_OFF,
            "the old surface stays",
        ),
    ]
}
