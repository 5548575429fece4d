//! Friction, torques from outside, what is out of balance, the spring of the drive and its play in one equilibrium.

use super::rig::*;
use crate::positioning::Direction::{self, Backward, Forward};
use crate::validation::Case;

/// Friction of 12 N·m on 4 N·m/arcsec: 3 arcsec.
const FRICTION: &str = "[elastic-wind-up]\nfriction = \"12 N*m\"";
const PLAY: &str = "[backlash]\ngap = \"25 arcsec\"";

pub fn cases() -> Vec<Case> {
    [alone(), together(), turned_over()].concat()
}

fn arcsec(name: &str, expected: f64, computed: f64, source: &'static str) -> Case {
    row(name, "deviation", (expected, computed, "arcsec"), ROUND_OFF, source)
}

fn alone() -> Vec<Case> {
    let at = |axis: &Option<Machine>, direction, torque| deviation(axis, 77.0, direction, (0.0, torque));
    let free = axis(TILTING, "");
    let rubs = axis(TILTING, FRICTION);
    let softer = axis(TILTING, &format!("{FRICTION}\nstiffness = \"12 N*m/arcsec\""));
    let play = axis(WORM, PLAY);
    let ahead = axis(WORM, "[backlash]\ngap = \"-6 arcsec\"");
    let uneven = axis(WORM, "[uneven-backlash]\nchange = \"10 arcsec\"\nphase = \"0 deg\"");
    let yields = axis(WORM, "[compliance]\nstiffness = \"8 N*m/arcsec\"");
    let hooke = "Hooke's law: T/k";
    let lost = "seed 000, y = x - delta, with angles";
    let rounds = |angle, direction| deviation(&uneven, angle, direction, (0.0, 0.0));
    vec![
        arcsec("drive of 4 N·m/arcsec under 20 N·m", 5.0, at(&free, Forward, 20.0), hooke),
        arcsec("the same under -20 N·m, backwards", -5.0, at(&free, Backward, -20.0), hooke),
        arcsec("friction of 12 N·m, forwards", -3.0, at(&rubs, Forward, 0.0), hooke),
        arcsec("friction of 12 N·m, backwards", 3.0, at(&rubs, Backward, 0.0), hooke),
        arcsec(
            "friction on two springs in series, backwards",
            4.0,
            at(&softer, Backward, 0.0),
            "Hooke's law: T/k1 + T/k2",
        ),
        arcsec("rigid drive with a compliance of its own under 20 N·m", 2.5, at(&yields, Forward, 20.0), hooke),
        arcsec("table with play, forwards", 0.0, at(&play, Forward, 0.0), lost),
        arcsec("table with play, backwards", 25.0, at(&play, Backward, 0.0), lost),
        arcsec("table with too much compensated, backwards", -6.0, at(&ahead, Backward, 0.0), lost),
        arcsec("play round the wheel, at 0, backwards", 10.0, rounds(0.0, Backward), "gap(angle) = c cos(angle)"),
        arcsec(
            "play round the wheel, at 120 deg, backwards",
            -5.0,
            rounds(120.0, Backward),
            "gap(angle) = c cos(angle)",
        ),
        arcsec("play round the wheel, at 0, forwards", 0.0, rounds(0.0, Forward), "gap(angle) = c cos(angle)"),
    ]
}

/// The drive bears T - T_f forwards and T + T_f backwards, and presses on the flank of its sign.
fn together() -> Vec<Case> {
    let both = axis(TILTING, &format!("{FRICTION}\n{PLAY}"));
    let at = |direction: Direction, torque| deviation(&both, 200.0, direction, (0.0, torque));
    let statics = "statics: S = T -+ T_f, S/k and play where S > 0";
    let reversal = |torque| at(Backward, torque) - at(Forward, torque);
    vec![
        arcsec("play and friction, forwards", -3.0, at(Forward, 0.0), statics),
        arcsec("play and friction, backwards", 28.0, at(Backward, 0.0), statics),
        arcsec("a torque of 8 N·m below friction, forwards", -1.0, at(Forward, 8.0), statics),
        arcsec("a torque of 8 N·m below friction, backwards", 30.0, at(Backward, 8.0), statics),
        arcsec("a torque of 20 N·m, forwards on the far flank", 27.0, at(Forward, 20.0), statics),
        arcsec("a torque of 20 N·m, backwards", 33.0, at(Backward, 20.0), statics),
        arcsec("a torque of -20 N·m, forwards", -8.0, at(Forward, -20.0), statics),
        arcsec("a torque of -20 N·m, backwards on the near flank", -2.0, at(Backward, -20.0), statics),
        row("free", "reversal", (31.0, reversal(0.0), "arcsec"), ROUND_OFF, "play and 2 T_f/k"),
        row("under 20 N·m", "reversal", (6.0, reversal(20.0), "arcsec"), ROUND_OFF, "2 T_f/k: play shows no more"),
        row("under -20 N·m", "reversal", (6.0, reversal(-20.0), "arcsec"), ROUND_OFF, "2 T_f/k: play shows no more"),
    ]
}

/// M cos(angle) of 24 N·m: it is larger than friction of 12 N·m within 60 degrees of either end.
fn turned_over() -> Vec<Case> {
    const UNBALANCE: &str = "[unbalance]\nmoment = \"24 N*m\"\nphase = \"0 deg\"";
    let alone = axis(TILTING, UNBALANCE);
    let all = axis(TILTING, &format!("{UNBALANCE}\n{FRICTION}\n{PLAY}"));
    let at = |axis: &Option<Machine>, angle, direction| deviation(axis, angle, direction, (0.0, 0.0));
    let statics = "statics: T = M cos(angle), S = T -+ T_f";
    vec![
        arcsec("24 N·m out of balance, at 0", 6.0, at(&alone, 0.0, Forward), statics),
        arcsec("24 N·m out of balance, at 120 deg", -3.0, at(&alone, 120.0, Backward), statics),
        arcsec("with friction and play, at 0, forwards on the far flank", 28.0, at(&all, 0.0, Forward), statics),
        arcsec("with friction and play, at 0, backwards", 34.0, at(&all, 0.0, Backward), statics),
        arcsec("with friction and play, at 90 deg, forwards", -3.0, at(&all, 90.0, Forward), statics),
        arcsec("with friction and play, at 90 deg, backwards", 28.0, at(&all, 90.0, Backward), statics),
        arcsec("with friction and play, at 180 deg, forwards", -9.0, at(&all, 180.0, Forward), statics),
        arcsec(
            "with friction and play, at 180 deg, backwards on the near flank",
            -3.0,
            at(&all, 180.0, Backward),
            statics,
        ),
    ]
}
