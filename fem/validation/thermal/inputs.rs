//! Rooms and powers that are recorded, pulses that differ, heaters that store heat: against lumped bodies.

use std::f64::consts::PI;
use std::sync::Arc;

use super::rig::*;
use crate::input::{Record, Varying};
use crate::process::Rows;
use crate::processes::thermal::boundary::Condition;
use crate::processes::thermal::forward::{follow, observe};
use crate::processes::thermal::machine::Machine;
use crate::processes::thermal::rows::{elongations, temperatures};
use crate::processes::thermal::setup::Setup;
use crate::solve::conduction::{Energy, Run};
use crate::solve::rod::{History, Power};
use crate::validation::bench::figure as figure_of;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [rooms(), powers(), whole_heats(), edges(), pulses(), heaters()].concat()
}

/// 2 kcal over two intervals, the second with half the power, into an insulated rod: t = Q/(c·V·ρ), and α·L·t once
/// all is in.
fn whole_heats() -> Vec<Case> {
    let source = "at = \"200 mm\", heat = \"2 kcal\", pulses = [1.0, 0.5], on = [[\"0 min\", \"5 min\"], [\"10 min\", \"20 min\"]]";
    let heated = body(&ROD.replace("at = \"200 mm\", power = \"15 W\"", source), "");
    let heat = 2.0 * 4186.8;
    // 10 s steps meet the ends of the intervals, and the balance of heat is that of every step.
    let balance = Tolerance::Relative(1e-9);
    let of = |key: &str, path: &str| figure_of(&heated, key, path);
    let growth = 1e6 * ALPHA * heat / (RHO_C * AREA);
    vec![
        row(
            "2 kcal over two intervals",
            "heat",
            (heat, of("energy", "supplied"), "J"),
            balance,
            "seed 002 (35), kcal: 1 cal = 4.1868 J",
        ),
        row("2 kcal in a rod", "elongation", (growth, of("largest", "value"), "um"), balance, "seed 002 (35), (36)"),
    ]
}

/// A record of points (s, SI).
fn record(points: &[[f64; 2]]) -> Option<History> {
    Record::new(points.to_vec()).map(|record| History::Record(Arc::new(record)))
}

/// A body as another room and another power act on it.
fn recorded(body: Heated, room: Option<History>, power: Option<History>) -> Option<Machine> {
    let mut machine = body?.machine().clone();
    if let Some(power) = power {
        machine.sources.first_mut()?.power.level = power;
    }
    if let Some(ambient) = room {
        machine.setup = Arc::new(Setup { ambient, ..(*machine.setup).clone() });
    }
    Some(machine)
}

fn seen(machine: &Option<Machine>, rows: &Rows) -> f64 {
    machine.as_ref().and_then(|m| observe(m, rows).ok()).map_or(f64::NAN, |v| v[0])
}

/// The room warms by 10 K, stays, and cools by 15 K, with kinks between the steps: m′ = (a − m)/τ, which along
/// a = a₀ + s·t is a − s·τ + (m₀ − a₀ + s·τ)·e^(−t/τ).
fn rooms() -> Vec<Case> {
    let tau = RHO_C * AREA / (25.0 * PI * 0.02);
    let points = [[0.0, 0.0], [1803.0, 10.0], [2417.0, 10.0], [3604.0, -5.0], [10_800.0, -5.0]];
    let lumped = |time: f64| {
        points.windows(2).take_while(|ends| ends[0][0] < time).fold(0.0, |before, ends| {
            let [[from, a0], [to, a1]] = [ends[0], ends[1]];
            let (passed, slope) = (time.min(to) - from, (a1 - a0) / (to - from));
            a0 + slope * (passed - tau) + (before - a0 + slope * tau) * (-passed / tau).exp()
        })
    };
    let room = record(&points.map(|[time, rise]| [time, 293.15 + rise]));
    let losing = rod("[convection]\ncoefficient = \"25 W/m^2/K\"");
    let machine = recorded(losing, room, Some(History::Constant(0.0)));
    let one = |time: f64| {
        let found = seen(&machine, &temperatures(&[[0.1, f64::NAN]], time)) - 293.15;
        // Steps of 10 s, of second order, of what the room has moved by.
        let tolerance = Tolerance::Absolute(15.0 * (10.0 / tau).powi(2));
        let name = format!("rod in a room by record, 25 W/m^2/K, {time:.0} s");
        row(name, "rise", (lumped(time), found, "K"), tolerance, "lumped body, ramps")
    };
    [1500.0, 2400.0, 3600.0, 7200.0].map(one).to_vec()
}

/// All heat stays inside: the elongation tells the integral of the power, whatever lies between the steps.
fn powers() -> Vec<Case> {
    let ramps = [[0.0, 0.0], [333.3, 20.0], [1001.0, 20.0], [1007.0, 5.0], [4000.0, 12.0]];
    // Of 3 s, in steps of 10 s.
    let teeth: Vec<[f64; 2]> = (0..=1200).map(|i| [3.0 * f64::from(i), if i % 2 == 0 { 0.0 } else { 30.0 }]).collect();
    let one = |name: &str, body: Heated, points: &[[f64; 2]], heat: f64| {
        let grown = 1e6 * seen(&recorded(body, None, record(points)), &elongations(&[3600.0]));
        let expected = 1e6 * ALPHA * heat / (RHO_C * AREA);
        row(
            name,
            "elongation",
            (expected, grown, "um"),
            Tolerance::Relative(1e-9),
            "seed 002 (35)-(37): all heat stays inside",
        )
    };
    let last = 5.0 + 7.0 * (3600.0 - 1007.0) / (4000.0 - 1007.0);
    let heat = 333.3 * 10.0 + (1001.0 - 333.3) * 20.0 + 6.0 * 12.5 + (3600.0 - 1007.0) * 0.5 * (5.0 + last);
    // A section of 100π mm².
    let bar = "rectangle = { length = \"200 mm\", height = \"20 mm\", width = \"15.70796326794897 mm\" }";
    let bar = body(&ROD.replace("segments = [{ length = \"200 mm\", diameter = \"20 mm\" }]", bar), "");
    vec![
        one("power by record, ramps and a drop, 60 min", rod(""), &ramps, heat),
        one("power by record, teeth of 3 s in steps of 10 s", rod(""), &teeth, 15.0 * 3600.0),
        one("the same teeth into the end of a plate", bar, &teeth, 15.0 * 3600.0),
    ]
}

/// An edge as a record acts on it.
fn with_edge(body: Heated, condition: Option<Condition>) -> Option<Machine> {
    let mut machine = body?.machine().clone();
    let mut setup = (*machine.setup).clone();
    setup.boundaries.first_mut()?.condition = condition?;
    machine.setup = Arc::new(setup);
    Some(machine)
}

/// Edges of a bar 200 mm long: a flux into its end, a room of its own about its end, and an end whose
/// temperature rises steadily for long, so that the bar follows with the parabola b/2κ·(x² − 2·L·x) behind it.
fn edges() -> Vec<Case> {
    let bar = |edge: &str, time: &str| {
        let text = r#"
            body = { material = "steel", rectangle = { length = "200 mm", height = "20 mm", width = "10 mm" } }
            environment = { temperature = "20 degC" }
        "#;
        body(&format!("{text}boundary = [{{ {edge} }}]\ntime = {{ {time} }}"), "")
    };
    let usual = "end = \"180 min\", step = \"10 s\"";
    let ramps = [[0.0, 0.0], [333.3, 8e4], [1001.0, 8e4], [1007.0, 2e4], [4000.0, 2e4]];
    let level = |level| Condition::Flux(Power { level, on: Vec::new() });
    let heated = with_edge(bar("edge = \"right\", flux = \"1 W/m^2\"", usual), record(&ramps).map(level));
    let heat = 333.3 * 4e4 + (1001.0 - 333.3) * 8e4 + 6.0 * 5e4 + (3600.0 - 1007.0) * 2e4;
    let grown = 1e6 * seen(&heated, &elongations(&[3600.0]));
    let rate = 1e-3;
    let ramp = |from: f64| record(&[[0.0, from], [1e5, from + rate * 1e5]]);
    let long = "end = \"1000 min\", step = \"60 s\"";
    let held =
        with_edge(bar("edge = \"left\", temperature = \"20 degC\"", long), ramp(293.15).map(Condition::Temperature));
    let lag = rate * RHO_C / K * 0.5 * LENGTH * LENGTH;
    let film = |ambient| Condition::Convection { coefficient: Varying::Constant(200.0), ambient: Some(ambient) };
    let blown = with_edge(
        bar("edge = \"left\", convection = \"200 W/m^2/K\", ambient = \"20 degC\"", long),
        ramp(293.15).map(film),
    );
    let through = rate * RHO_C * LENGTH / 200.0;
    let behind = |machine: &Option<Machine>| rate * 6e4 - (seen(machine, &temperatures(&[[0.2, 0.01]], 6e4)) - 293.15);
    // The slowest wave has died: e^(−20) with the end held, e^(−14) behind the film.
    let settled = Tolerance::Relative(1e-5);
    let source = "a body behind a steady ramp: b*rho*c/k*L^2/2, and b*rho*c*L/h through a film";
    vec![
        row(
            "flux by record into the end of a bar, 60 min",
            "elongation",
            (1e6 * ALPHA * heat / RHO_C, grown, "um"),
            Tolerance::Relative(1e-9),
            "seed 002 (35)-(37): all heat stays inside",
        ),
        row("end held at a rising record", "lag of the other end", (lag, behind(&held), "K"), settled, source),
        row(
            "end in a room of its own by record",
            "lag of the other end",
            (lag + through, behind(&blown), "K"),
            settled,
            source,
        ),
    ]
}

fn pulses() -> Vec<Case> {
    let turns =
        "power = \"15 W\", on = [[\"20 min\", \"21 min\"], [\"1.3 min\", \"10.7 min\"]], pulses = [0.5, \"0.94\"]";
    let switched = body(&ROD.replace("power = \"15 W\"", turns), "");
    let expected = 1e6 * ALPHA * 15.0 * (0.5 * 60.0 + 0.94 * 564.0) / (RHO_C * AREA);
    let found = 1e6 * elongation(&switched, 3600.0);
    let name = "source of 50 % for 1 min and of 94 % for 9.4 min";
    vec![row(
        name,
        "elongation",
        (expected, found, "um"),
        Tolerance::Relative(1e-9),
        "seed 002 (35)-(37): all heat stays inside",
    )]
}

/// A heater of 40 J/K behind 0.5 W/K on a body that conducts so well that it is at one temperature: with D =
/// θ_H − θ, D = P/(C_H λ)·(1 − e^(−λt)), λ = G·(1/C_H + 1/C), and C_H·θ_H + C·θ = P·t.
fn heaters() -> Vec<Case> {
    let (own, contact, whole) = (40.0, 0.5, RHO_C * AREA * LENGTH);
    let heater = "power = \"15 W\", heat_capacity = \"40 J/K\", contact = \"0.5 W/K\"";
    let lumped = ROD
        .replace("power = \"15 W\"", heater)
        .replace("material = \"steel\"", "material = { base = \"steel\", conductivity = \"1e6 W/m/K\" }")
        .replace("step = \"10 s\"", "step = \"1 s\"");
    let lumped = body(&lumped, "");
    let rate = contact * (1.0 / own + 1.0 / whole);
    let rise_at = |time: f64| {
        let apart = POWER / (own * rate) * -(-rate * time).exp_m1();
        (POWER * time - own * apart) / (own + whole)
    };
    let one = |time: f64| {
        // Steps of 1 s, and the resistance of the body beside that of the contact.
        let tolerance = Tolerance::Relative(rate * rate + contact * LENGTH / (1e6 * AREA));
        let grown = (1e6 * ALPHA * LENGTH * rise_at(time), 1e6 * elongation(&lumped, time), "um");
        row(
            format!("heater of 40 J/K behind 0.5 W/K, {time:.0} s"),
            "elongation",
            grown,
            tolerance,
            "two lumped masses",
        )
    };
    let mut cases: Vec<Case> = [30.0, 120.0, 600.0].map(one).to_vec();
    let steady = ROD.replace("power = \"15 W\"", heater).replace(
        "end = \"180 min\", step = \"10 s\"",
        "end = \"1e7 min\", step = \"2e5 min\", scheme = \"backward-euler\"",
    );
    let steady = rise(&body(&steady, "[base-conductance]\nconductance = \"0.5 W/K\""), LENGTH, 6e8);
    let expected = POWER / 0.5 + POWER * LENGTH / (K * AREA);
    cases.push(row(
        "heater on a rod with a base of 0.5 W/K, steady",
        "rise of the heated end",
        (expected, steady, "K"),
        Tolerance::Relative(1e-6),
        "resistances in series: all that heats the heater comes through",
    ));
    let lossy = body(&ROD.replace("power = \"15 W\"", heater), "[convection]\ncoefficient = \"25 W/m^2/K\"");
    cases.push(row(
        "heat in less lost less stored, heater and record",
        "part of the turnover",
        (0.0, balance(lossy.map(|body| body.machine().clone())).map_or(f64::NAN, |e| e.imbalance()), "-"),
        // Rounding of kA·θ/ℓ between elements, some hundred times what comes in.
        Tolerance::Absolute(1e-11),
        "first law",
    ));
    cases
}

/// Where the heat of an hour went in a room that warms by 8 K in its first 1111 s.
fn balance(machine: Option<Machine>) -> Option<Energy> {
    let mut machine = machine?;
    let ambient = record(&[[0.0, 293.15], [1111.0, 301.15], [3600.0, 301.15]])?;
    machine.setup = Arc::new(Setup { ambient, ..(*machine.setup).clone() });
    let run = Run { scheme: machine.setup.time.scheme, step: 10.0, end: 3600.0 };
    follow(&machine, &[], &run, &mut |_, _| ()).ok().map(|followed| followed.energy)
}
