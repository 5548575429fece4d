//! Effects on a position, each alone and on a dragged axis, against results by hand.

use super::rig::*;
use crate::positioning::Direction::{Backward, Forward};
use crate::validation::Case;

pub fn cases() -> Vec<Case> {
    [alone(), dragged()].concat()
}

/// Friction of 300 N to 200 mm that rises to 900 N at 400 mm and falls to 100 N at the end: 300·200 + 600·200 + 500·400
/// over 800 mm, 475 N on the mean.
fn dragged() -> Vec<Case> {
    const MEAN: f64 = 475.0;
    let points = [(0.0, 300.0), (200.0, 300.0), (400.0, 900.0), (800.0, 100.0)]
        .map(|(at, drag)| format!("{{ at = \"{at} mm\", drag = \"{drag} N\" }}"));
    let goes = format!("drag_points = [{}]", points.join(", "));
    let wound = format!("[elastic-lost-motion]\nfriction = \"{MEAN} N\"\nstiffness = \"200 N/um\"");
    let play = format!("[backlash]\ngap = \"6 um\"\n{wound}");
    let [free, with_play] = [&wound, &play].map(|effects| axis_that(&goes, effects));
    let twice = axis_that(&goes, &wound.replace("475 N", "950 N"));
    let lost = |axis: &Option<Machine>, x| deviation(axis, x, Backward, 0.0) - deviation(axis, x, Forward, 0.0);
    // 1/C_n + |x - 50 mm|/(EA), um/N.
    let compliance = |mm: f64| 1.0 / 200.0 + 1e6 * 1e-3 * (mm - 50.0).abs() / rigidity();
    let um = |name: &str, quantity, expected: f64, computed: f64| {
        row(name, quantity, (expected, computed, "um"), CANCELLED, "seed 001, b(x) = delta + 2F(x)/C(x)")
    };
    vec![
        um("drag of 300 N at 100 mm", "lost motion", 600.0 * compliance(100.0), lost(&free, 100.0)),
        um("drag of 600 N at 300 mm", "lost motion", 1200.0 * compliance(300.0), lost(&free, 300.0)),
        um(
            "drag of 900 N at 400 mm and play",
            "lost motion",
            6.0 + 1800.0 * compliance(400.0),
            lost(&with_play, 400.0),
        ),
        um("drag of 500 N at 600 mm", "deviation", -500.0 * compliance(600.0), deviation(&free, 600.0, Forward, 0.0)),
        um(
            "the same shape and twice the friction, 600 mm",
            "lost motion",
            2000.0 * compliance(600.0),
            lost(&twice, 600.0),
        ),
    ]
}

fn alone() -> Vec<Case> {
    let scale = axis("[scale-error]\nslope = \"25 um/m\"");
    let periodic = axis("[periodic-error]\namplitude = \"3 um\"\nphase = \"-40 deg\"");
    let gap = axis("[backlash]\ngap = \"7 um\"");
    let ahead = axis("[backlash]\ngap = \"-7 um\"");
    let uneven = axis("[backlash]\ngap = \"7 um\"\n[uneven-backlash]\nchange = \"-4 um\"");
    let worn = axis("[worn-screw]\ndepth = \"12 um\"");
    let elastic = axis("[elastic-lost-motion]\nfriction = \"600 N\"\nstiffness = \"200 N/um\"");
    let wound = "[elastic-lost-motion]\nfriction = \"600 N\"\nstiffness = \"200 N/um\"";
    let [sprung, relaxed, pressed] = [
        "{ preload = \"400 N\", stiffness = \"100 N/um\" }",
        "{ preload = \"200 N\", stiffness = \"100 N/um\" }",
        "{ preload = \"400 N\", c = \"0.25 um/N^n\", n = 0.5 }",
    ]
    .map(|nut| axis_with(&format!("nut = {nut}"), wound));
    let growth = axis("[thermal-growth]\nslope = \"40 um/m\"\ntime_constant = \"15 min\"");
    let abbe = axis("[abbe-error]\nheight = \"-9 um\"");
    let shift = axis("[reference-shift]\noffset = \"-4.5 um\"");
    let warm = axis_with("temperature = \"24 degC\"", "");
    let cold = axis_with("temperature = \"21 degC\", reference_temperature = \"22 degC\"", "");
    let all = axis(
        "[backlash]\ngap = \"7 um\"\n[elastic-lost-motion]\nfriction = \"600 N\"\nstiffness = \"200 N/um\"\n\
         [scale-error]\nslope = \"25 um/m\"",
    );
    let um = |name: &str, expected: f64, computed: f64, source| {
        row(name, "deviation", (expected, computed, "um"), CANCELLED, source)
    };
    let stretch = |x: f64| 1e6 * 600.0 * x / rigidity();
    let warmed = |minutes: f64| 40.0 * (1.0 - (-minutes / 15.0f64).exp());
    let degrees = f64::to_radians;
    let (kinematic, spring, sine) = ("seed 000, y = x - delta", "seed 000, y = x - F/C", "A sin(2 pi x/lead + phase)");
    let lost = |axis, x| deviation(axis, x, Backward, 0.0) - deviation(axis, x, Forward, 0.0);
    vec![
        um("scale of 25 um/m at 400 mm", 10.0, deviation(&scale, 400.0, Forward, 0.0), "slope*x"),
        um("scale of 25 um/m at -40 mm", -1.0, deviation(&scale, -40.0, Backward, 0.0), "slope*x"),
        um("turn's error on a whole turn", 3.0 * degrees(-40.0).sin(), deviation(&periodic, 250.0, Forward, 0.0), sine),
        um("turn's error a quarter on", 3.0 * degrees(50.0).sin(), deviation(&periodic, 252.5, Backward, 0.0), sine),
        um("play, forwards", 0.0, deviation(&gap, 300.0, Forward, 0.0), kinematic),
        um("play, backwards", 7.0, deviation(&gap, 300.0, Backward, 0.0), kinematic),
        um("too much compensated, forwards", 0.0, deviation(&ahead, 300.0, Forward, 0.0), kinematic),
        um("too much compensated, backwards", -7.0, deviation(&ahead, 300.0, Backward, 0.0), kinematic),
        um("play that falls along the travel, begin", 9.0, deviation(&uneven, 0.0, Backward, 0.0), "d + c(s - 1/2)"),
        um("play that falls along the travel, 600 mm", 6.0, deviation(&uneven, 600.0, Backward, 0.0), "d + c(s - 1/2)"),
        um("play that falls along the travel, forwards", 0.0, deviation(&uneven, 0.0, Forward, 0.0), "d + c(s - 1/2)"),
        um("worn screw, a quarter", 9.0, deviation(&worn, 200.0, Backward, 0.0), "4 h s(1 - s)"),
        um("worn screw, the same forwards", 0.0, deviation(&worn, 200.0, Forward, 0.0), "4 h s(1 - s)"),
        um("wind-up at the bearing, forwards", -3.0, deviation(&elastic, 50.0, Forward, 0.0), spring),
        um("wind-up at the bearing, backwards", 3.0, deviation(&elastic, 50.0, Backward, 0.0), spring),
        // Two springs share 600 N, or one bears it alone and stands P/k before its free place; of two contacts √Q₁ + √Q₂
        // stays 2√P.
        um("preloaded nut of springs", 3.0 + 3.0, deviation(&sprung, 50.0, Backward, 0.0), "seed 000, fig. 5: F/2k"),
        um("the same, relaxed", 3.0 + 4.0, deviation(&relaxed, 50.0, Backward, 0.0), "seed 000, fig. 5: F/k - P/k"),
        um(
            "preloaded nut of contacts, forwards",
            -3.0 - 0.25 * 600.0 / (4.0 * 20.0),
            deviation(&pressed, 50.0, Forward, 0.0),
            "seed 000, fig. 5, with c sqrt(Q): cF/(4 sqrt(P))",
        ),
        um("wind-up at 800 mm, forwards", -3.0 - stretch(0.75), deviation(&elastic, 800.0, Forward, 0.0), spring),
        um("wind-up at 800 mm, backwards", 3.0 + stretch(0.75), deviation(&elastic, 800.0, Backward, 0.0), spring),
        um("wind-up before the bearing", -3.0 - stretch(0.05), deviation(&elastic, 0.0, Forward, 0.0), spring),
        um(
            "lost motion of play and wind-up",
            7.0 + 6.0 + 2.0 * stretch(0.35),
            lost(&all, 400.0),
            "seed 000, fig. 2: delta + 2F/C",
        ),
        um("lost motion of a scale", 0.0, lost(&scale, 400.0), "a scale is the same both ways"),
        um("cold screw", 0.0, deviation(&growth, 800.0, Forward, 0.0), "1 - exp(-t/tau)"),
        um(
            "screw after 15 min at 800 mm",
            0.75 * warmed(15.0),
            deviation(&growth, 800.0, Forward, 15.0),
            "1 - exp(-t/tau)",
        ),
        um(
            "screw after 60 min, before the bearing",
            -0.05 * warmed(60.0),
            deviation(&growth, 0.0, Backward, 60.0),
            "1 - exp(-t/tau)",
        ),
        um("screw at 24 degC, 800 mm", 0.75 * 11.5 * 4.0, deviation(&warm, 800.0, Forward, 9.0), "alpha*dT*(x - x0)"),
        um(
            "screw 1 K too cold, before the bearing",
            0.05 * 11.5,
            deviation(&cold, 0.0, Backward, 0.0),
            "alpha*dT*(x - x0)",
        ),
        um("pitching slide, middle", -9.0, deviation(&abbe, 400.0, Forward, 0.0), "4 h s(1 - s)"),
        um("pitching slide, a quarter", -6.75, deviation(&abbe, 200.0, Backward, 0.0), "4 h s(1 - s)"),
        um("pitching slide, end", 0.0, deviation(&abbe, 800.0, Forward, 0.0), "4 h s(1 - s)"),
        um("reference off", -4.5, deviation(&shift, 123.0, Backward, 7.0), "the same everywhere"),
    ]
}
