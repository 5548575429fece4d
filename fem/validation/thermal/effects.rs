//! Effects against closed forms: the ways that they open, the heat that they bring, the delays.

use std::f64::consts::PI;

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// Steady states of linear elements are exact where the flow is even; what is left is rounding and the way
/// towards the steady state.
const SETTLED: Tolerance = Tolerance::Relative(1e-6);
/// A rod that takes its steady state in a few very long steps.
const FOR_EVER: &str = "end = \"1e7 min\", step = \"2e5 min\", scheme = \"backward-euler\"";

pub fn cases() -> Vec<Case> {
    [lumped(), steady(), shapes(), sources_and_sensors()].concat()
}

/// The elongation is that of a lumped body wherever the heat comes in: C·m′ = P − hπDL·(m − a).
fn lumped() -> Vec<Case> {
    let tau = RHO_C * AREA / (25.0 * PI * 0.02);
    let settled = POWER / (25.0 * PI * 0.02 * LENGTH);
    let grown = |mean: f64| 1e6 * ALPHA * LENGTH * mean;
    let time = 3000.0;
    let convection = "[convection]\ncoefficient = \"25 W/m^2/K\"";
    let at_end = |body: &Heated| 1e6 * elongation(body, time);
    let drift = "[ambient-drift]\namplitude = \"3 K\"\nperiod = \"2 h\"\nphase = \"40 deg\"";
    // Of the drift alone: A·[sin(ωt + φ) − sin φ] through a first-order body of rate β.
    let (beta, omega, phase) = (1.0 / tau, 2.0 * PI / 7200.0, 40f64.to_radians());
    let wave = |t: f64| {
        let (sine, cosine) = (omega * t + phase).sin_cos();
        (beta * sine - omega * cosine) * beta / (beta * beta + omega * omega) - phase.sin()
    };
    let response = 3.0 * (wave(time) - wave(0.0) * (-time * beta).exp());
    let warming = |scheme: &str, allowed: f64| {
        let text = ROD.replace("step = \"10 s\"", &format!("step = \"10 s\", scheme = \"{scheme}\""));
        row(
            format!("rod that loses 25 W/m^2/K, 50 min, {scheme}"),
            "elongation",
            (grown(-settled * (-time / tau).exp_m1()), at_end(&body(&text, convection)), "um"),
            Tolerance::Relative(allowed),
            "lumped body, 1 - exp(-t/tau)",
        )
    };
    let second_order = (10.0 / tau).powi(2);
    vec![
        // Steps of 10 s.
        warming("sdirk2", second_order),
        row(
            "the same in a room that swings by 3 K, 50 min",
            "change of elongation",
            (grown(response), at_end(&rod(&format!("{convection}\n{drift}"))) - at_end(&rod(convection)), "um"),
            Tolerance::Relative((10.0 * omega).powi(2) + second_order),
            "lumped body, sinusoid",
        ),
        warming("crank-nicolson", second_order),
        warming("backward-euler", 10.0 / tau),
    ]
}

/// Steps of the diameter and bores.
fn shapes() -> Vec<Case> {
    let stepped = ROD.replace(
        "{ length = \"200 mm\", diameter = \"20 mm\" }",
        "{ length = \"120 mm\", diameter = \"30 mm\" }, { length = \"80 mm\", diameter = \"20 mm\", bore = \"10 mm\" }",
    );
    let still = stepped.replace("end = \"180 min\", step = \"10 s\"", FOR_EVER);
    let held = body(&still, "[base-conductance]\nconductance = \"0.5 W/K\"");
    let (thick, hollow) = (PI / 4.0 * 0.03 * 0.03, PI / 4.0 * (0.02 * 0.02 - 0.01 * 0.01));
    let at_step = POWER / 0.5 + POWER * 0.12 / (K * thick);
    let name = "stepped rod, Ø30 × 120 and Ø20/10 × 80 mm, steady";
    let one = |place, expected: f64, x: f64| {
        row(name, place, (expected, rise(&held, x, 6e8), "K"), SETTLED, "resistances in series")
    };
    let grown = 1e6
        * elongation(&body(&ROD.replace("diameter = \"20 mm\"", "diameter = \"20 mm\", bore = \"12 mm\""), ""), 3600.0);
    let expected = 1e6 * ALPHA * POWER * 3600.0 / (RHO_C * PI / 4.0 * (0.02 * 0.02 - 0.012 * 0.012));
    vec![
        one("rise at the step", at_step, 0.12),
        one("rise of the heated end", at_step + POWER * 0.08 / (K * hollow), 0.2),
        row(
            "hollow rod, insulated, 60 min",
            "elongation",
            (expected, grown, "um"),
            Tolerance::Relative(1e-9),
            "seed 002 (35)-(37): all heat stays inside",
        ),
    ]
}

fn steady() -> Vec<Case> {
    let still = |effects: &str| body(&ROD.replace("end = \"180 min\", step = \"10 s\"", FOR_EVER), effects);
    let at = |effects: &str, x: f64| rise(&still(effects), x, 6e8);
    let fin = "[convection]\ncoefficient = \"25 W/m^2/K\"";
    let m = (25.0 * PI * 0.02 / (K * AREA)).sqrt();
    let along = |x: f64| POWER / (K * AREA * m) * (m * x).cosh() / (m * LENGTH).sinh();
    // Linear elements bend between the nodes: (m·h)² of sixty of them.
    let bent = Tolerance::Relative((m * LENGTH / 60.0).powi(2));
    let base = "[base-conductance]\nconductance = \"0.5 W/K\"";
    let joint = format!("{base}\n[contact-resistance]\nat = \"70 mm\"\nconductance = \"3000 W/m^2/K\"");
    let flow = POWER / (K * AREA);
    let fins = |place, x: f64| {
        row("fin of 25 W/m^2/K, steady", place, (along(x), at(fin, x), "K"), bent, "Q cosh(mx)/(kAm sinh(mL))")
    };
    let held = |name: &str, place, expected: f64, computed: f64| {
        row(name, place, (expected, computed, "K"), SETTLED, "resistances in series")
    };
    let jointed = "joint of 3000 W/m^2/K at 70 mm, steady";
    let linear = POWER / 0.5 + 0.5 * flow * LENGTH;
    vec![
        fins("rise of the heated end", LENGTH),
        fins("rise of the far end", 0.0),
        held("base of 0.5 W/K, steady", "rise of the base", POWER / 0.5, at(base, 0.0)),
        held("base of 0.5 W/K, steady", "rise of the heated end", POWER / 0.5 + flow * LENGTH, at(base, LENGTH)),
        row(
            "base of 0.5 W/K, steady",
            "elongation",
            (1e6 * ALPHA * LENGTH * linear, 1e6 * elongation(&still(base), 6e8), "um"),
            SETTLED,
            "seed 002 (37): alpha times the integral of a linear rise",
        ),
        held(jointed, "rise before it", POWER / 0.5 + flow * 0.07, at(&joint, 0.07)),
        held(
            jointed,
            "rise of the heated end",
            POWER / 0.5 + flow * LENGTH + POWER / (3000.0 * AREA),
            at(&joint, LENGTH),
        ),
    ]
}

fn sources_and_sensors() -> Vec<Case> {
    let time = 3600.0;
    let kept = |name: &str, heat: f64, body: &Heated| {
        let expected = 1e6 * ALPHA * heat / (RHO_C * AREA);
        let computed = 1e6 * elongation(body, time);
        row(
            name,
            "elongation",
            (expected, computed, "um"),
            Tolerance::Relative(1e-9),
            "seed 002 (35)-(37): all heat stays inside",
        )
    };
    let bearing = rod("[extra-source]\nat = \"63 mm\"\npower = \"4 W\"");
    let turns = "power = \"15 W\", on = [[\"1.3 min\", \"10.7 min\"], [\"20 min\", \"21 min\"]]";
    let switched = body(&ROD.replace("power = \"15 W\"", turns), "");
    let (late, instant) = (rod("[sensor-lag]\ntime_constant = \"120 s\""), rod(""));
    let slope = POWER / (RHO_C * AREA * LENGTH);
    let heated = rod("[heater-capacity]\nheat_capacity = \"40 J/K\"\ncontact = \"2 W/K\"");
    // Once waves have settled heater and rod warm alike: what comes through the contact drives the heater ahead of the
    // end by flow/G, and the end ahead of the mean by flow·L/(3kA).
    let (held, whole) = (40.0, RHO_C * AREA * LENGTH);
    let flow = POWER * whole / (held + whole);
    let mean = (POWER * time - held * flow * (0.5 + LENGTH / (3.0 * K * AREA))) / (held + whole);
    let energy = followed(&rod("[convection]\ncoefficient = \"25 W/m^2/K\""), &[], 10.0, time);
    vec![
        kept("further source of 4 W, 60 min", 19.0 * time, &bearing),
        kept("source on for 10.4 min in two turns", 15.0 * 624.0, &switched),
        row(
            "sensors of 120 s, even rise",
            "behind by",
            (120.0 * slope, rise(&instant, 0.1, time) - rise(&late, 0.1, time), "K"),
            // What is left of the slowest wave, which takes 5 min, after an hour.
            Tolerance::Relative(1e-4),
            "tau dT/dt",
        ),
        row(
            "heater of 40 J/K behind 2 W/K, 60 min",
            "elongation",
            (1e6 * ALPHA * LENGTH * mean, 1e6 * elongation(&heated, time), "um"),
            // The slowest wave again.
            Tolerance::Relative(1e-4),
            "two bodies that warm alike",
        ),
        row(
            "heat in less lost less stored, 360 steps",
            "part of the turnover",
            (0.0, energy.map_or(f64::NAN, |f| f.energy.imbalance()), "-"),
            // Rounding of kA·θ/ℓ between elements, some hundred times what comes in.
            Tolerance::Absolute(1e-11),
            "first law",
        ),
    ]
}
