//! The report of a run: figures, the profile, and shapes for people.

mod clamped;
mod membrane;
mod plate;
mod shapes;
mod sketch;
mod wide;

use std::f64::consts::TAU;

use super::base::Base;
use super::body::Body;
use super::circle;
use super::forward::{self, absolute};
use super::gauged;
use super::grip::Grip;
use super::machine::Machine;
use super::response::MeshSize;
use super::rows::{
    ANGLE_OF_ROW, BLANK, CLAMPED, COORDINATES, JAW_FORCE, OBSERVABLES, RUN, SECTION, SPEED, STATE, released,
};
use super::setup::{Reference, Setup};
use crate::process::{Curve, Datum, Drawing, Failure, Figure, Forward, Plot, RunReport, Spot, Table, extremes, spread};
use crate::roundness::Contacts;
use crate::units::{ANGLE, FORCE, LENGTH, MICRO, SPINDLE_SPEED, STIFFNESS, STRESS};

/// A surface that varies by less than a tenth of a nanometre is round.
const ROUND: f64 = 1e-10;
/// Harmonics are listed down to this part of the largest, and no more than so many.
const LISTED: f64 = 1e-3;
const MOST_LISTED: usize = 8;
/// Parts of the width between sections that are told.
const PARTS: usize = 4;
/// Elements that are stiffer by more than this part are warned of.
const STIFFENED: f64 = 0.01;

/// Everything that a run reports.
///
/// # Errors
/// The ring cannot be computed.
pub fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
    let (setup, rows, deviations) = (&machine.setup, forward.programme, forward.prediction);
    let angles = &rows.columns[ANGLE_OF_ROW].to_vec();
    let scene = shapes::Scene::new(machine, forward)?;
    let form = circle::form(angles, deviations);
    let around = gauged::trace(setup.instrument.filter);
    let trace = absolute(machine, forward, &released(setup, around.clone()))?;
    let mut figures = extremes("deviation", &OBSERVABLES[0], (COORDINATES, &[ANGLE_OF_ROW]), rows, deviations);
    figures.extend([
        size(setup.reference, angles, deviations),
        roundness(setup.grip, &gauged::traced(&around, &trace, setup.instrument.filter)),
        harmonics(angles, &form),
        gauges(setup, &trace),
        clamping(machine, forward)?,
        force(machine),
    ]);
    figures.push(match setup.reach {
        Some(_) => sections(machine, forward)?,
        None => stress(setup, &scene),
    });
    figures.extend(setup.base.iter().map(structure));
    figures.extend(setup.grasp.iter().map(membrane::figure));
    let mut shown = vec![RUN, ANGLE_OF_ROW, JAW_FORCE];
    shown.extend(setup.spindle_speed.map(|_| SPEED));
    shown.extend((!setup.blank.is_empty()).then_some(BLANK));
    shown.extend(setup.reach.map(|_| SECTION));
    let points = angles.iter().zip(deviations).map(|(a, d)| (ANGLE.from_si(*a), MICRO.from_si(*d))).collect();
    let title = format!("deviation [um] of the released {} over angle [deg]", setup.cut_name());
    Ok(RunReport {
        profile: Table::of_rows((COORDINATES, &shown), rows, &OBSERVABLES[0], deviations),
        figures,
        plots: vec![Plot { title, x_unit: "deg", points }],
        drawings: vec![drawing(setup, angles, deviations)],
        warnings: warnings(machine),
        sketch: Some(sketch::sketch(machine)),
        animations: std::iter::once(scene.animation()).chain(plate::animation(setup)).collect(),
        ..RunReport::default()
    })
}

/// The cut surface, deviations magnified.
fn drawing(setup: &Setup, angles: &[f64], deviations: &[f64]) -> Drawing {
    let spot = |(angle, deviation): (&f64, &f64)| {
        let outward = [angle.cos(), angle.sin()];
        Spot { at: outward.map(|c| setup.cut_radius() * c), outward, deviation: *deviation }
    };
    let mut round: Vec<Spot> = angles.iter().zip(deviations).map(spot).collect();
    round.extend(round.first().copied());
    Drawing {
        name: setup.cut_name(),
        title: format!("{} of {:.3}, released", setup.cut_name(), LENGTH.shown(2.0 * setup.cut_radius())),
        nominal: vec![Spot::circle(setup.cut_radius())],
        curves: vec![Curve { label: "predicted".into(), family: 0, is_measured: false, pieces: vec![round] }],
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The peak and the depth of the valley of deviations from a circle, m: the material of a bore is outside, so that its
/// peak points inwards (ISO 12181-1, 3.2.2: towards the material a deviation is negative).
fn peak_and_valley(grip: Grip, form: &[f64]) -> (f64, f64) {
    let (inwards, outwards) =
        (0.0 - form.iter().copied().fold(0.0, f64::min), form.iter().copied().fold(0.0, f64::max));
    match grip {
        Grip::Outside => (inwards, outwards),
        Grip::Inside => (outwards, inwards),
    }
}

/// Size and centre of the cut surface at evenly spaced angles, rad.
fn size(reference: Reference, angles: &[f64], deviations: &[f64]) -> Figure {
    let mean = mean(deviations);
    let figure = Figure::new("mean", "mean deviation").quantity("value", MICRO, mean);
    if reference == Reference::LeastSquaresCircle {
        return figure.line("taken out with the least-squares circle");
    }
    let [radius, diameter] = [mean, 2.0 * mean].map(|m| MICRO.shown(m));
    let (off, towards) = wave(angles, deviations, 1);
    let centre = (off > ROUND).then(|| {
        let (off, towards) = (MICRO.shown(off), ANGLE.shown(towards));
        format!("its centre {off:.3} off the ring's axis, towards {towards:.1}")
    });
    figure
        .line(format!("{radius:+.3} of the radius, {diameter:+.3} of the diameter"))
        .lines(centre)
        .quantity("off_centre", MICRO, off)
        .quantity("towards", ANGLE, towards)
}

fn roundness(grip: Grip, form: &[f64]) -> Figure {
    let (peak, valley) = peak_and_valley(grip, form);
    let rms = mean(&form.iter().map(|d| d * d).collect::<Vec<_>>()).sqrt();
    let [p, v] = [peak, valley].map(|d| MICRO.from_si(d));
    let [t, q] = [peak + valley, rms].map(|d| MICRO.shown(d));
    Figure::new("roundness", "roundness (LSC)")
        .line(format!("RONt {t:.3} peak to valley, RONp {p:.3}, RONv {v:.3}, RONq {q:.3}"))
        .quantity("RONt", MICRO, peak + valley)
        .quantity("RONp", MICRO, peak)
        .quantity("RONv", MICRO, valley)
        .quantity("RONq", MICRO, rms)
}

/// How much gauges show of the form, turned around in it: two contacts see no odd number of waves, three a third
/// apart none but multiples of three. The trace has no filter, and a multiple of six points.
fn gauges(setup: &Setup, trace: &[f64]) -> Figure {
    let count = trace.len();
    let differ = |contacts: Contacts| {
        let places = contacts.places();
        let beside = |i: usize, at: f64| (i + (at.rem_euclid(TAU) / TAU * count as f64).round() as usize) % count;
        let one = |i: usize| places.iter().map(|(at, weight)| weight * trace[beside(i, *at)]).sum();
        spread(&(0..count).map(one).collect::<Vec<f64>>())
    };
    let [two, three] = [Contacts::TwoPoint, Contacts::ThreePoint].map(differ);
    let [shown_two, shown_three] = [two, three].map(|d| MICRO.shown(d));
    let label = if setup.grip == Grip::Outside { "bore gauges show" } else { "gauges show" };
    let line = format!("diameters that differ by {shown_two:.3} with two contacts, by {shown_three:.3} with three");
    let block = match setup.instrument.gauge.contacts() {
        Contacts::VBlock(angle) => Some((angle, differ(Contacts::VBlock(angle)))),
        _ => None,
    };
    let on_block = block.map(|(angle, differ)| {
        let (angle, shown) = (ANGLE.shown(angle), MICRO.shown(differ));
        format!("readings of a dial over a V-block of {angle:.0} that differ by {shown:.3}")
    });
    let figure = Figure::new("gauges", label).line(line).lines(on_block);
    let figure = figure.quantity("two_point", MICRO, two).quantity("three_point", MICRO, three);
    match block {
        Some((_, differ)) => figure.quantity("v_block", MICRO, differ),
        None => figure,
    }
}

/// Amplitude of `m` waves around, m, and the angle of their first crest, rad.
fn wave(angles: &[f64], deviations: &[f64], m: usize) -> (f64, f64) {
    let (mut cosine, mut sine) = (0.0, 0.0);
    for (angle, d) in angles.iter().zip(deviations) {
        cosine += d * (m as f64 * angle).cos();
        sine += d * (m as f64 * angle).sin();
    }
    let amplitude = 2.0 / deviations.len() as f64 * cosine.hypot(sine);
    let step = TAU / m as f64;
    let crest = (sine.atan2(cosine) / m as f64).rem_euclid(step);
    (amplitude, if step - crest < 1e-9 * step { 0.0 } else { crest })
}

/// Waves around (undulations per revolution) with amplitude and the angle of the first crest.
fn harmonics(angles: &[f64], form: &[f64]) -> Figure {
    let of = |m: usize| {
        let (amplitude, crest) = wave(angles, form, m);
        (m, amplitude, crest)
    };
    // Up to a wave over four points, and not more than instruments show.
    let mut all: Vec<(usize, f64, f64)> = (2..=(form.len() / 4).min(500)).map(of).collect();
    let largest = all.iter().fold(0.0f64, |size, h| size.max(h.1));
    all.retain(|h| h.1 > ROUND.max(LISTED * largest));
    let mut listed = all.clone();
    listed.sort_by(|a, b| b.1.total_cmp(&a.1));
    listed.truncate(MOST_LISTED);
    listed.sort_by_key(|h| h.0);
    let line = |(m, amplitude, crest): (usize, f64, f64)| {
        format!("{m:>3} a turn: {:>9.4}, crest at {:>6.1}", MICRO.shown(amplitude), ANGLE.shown(crest))
    };
    let entry = |(m, amplitude, crest): (usize, f64, f64)| {
        Datum::record([
            ("undulations", m.into()),
            ("amplitude", Datum::of(MICRO, amplitude)),
            ("crest", Datum::of(ANGLE, crest)),
        ])
    };
    Figure::new("harmonics", "waves, amplitude")
        .lines(all.is_empty().then(|| "none: it is round".to_string()))
        .lines(listed.into_iter().map(line))
        .entry("list", Datum::List(all.into_iter().map(entry).collect()))
}

/// Roundness of sections along a ring that is pressed on a part of its width.
fn sections(machine: &Machine, forward: &Forward) -> Result<Figure, Failure> {
    let setup = &machine.setup;
    let around = gauged::trace(setup.instrument.filter);
    let of = |part: usize| -> Result<(f64, f64), Failure> {
        let section = setup.width * part as f64 / PARTS as f64;
        let mut rows = released(setup, around.clone());
        rows.columns[SECTION].fill(section);
        let trace = absolute(machine, forward, &rows)?;
        Ok((section, spread(&gauged::traced(&around, &trace, setup.instrument.filter))))
    };
    let all = (0..=PARTS).map(of).collect::<Result<Vec<_>, Failure>>()?;
    let line =
        |(section, form): &(f64, f64)| format!("RONt {:.3} at z = {:.1}", MICRO.shown(*form), LENGTH.shown(*section));
    let entry = |(section, form): &(f64, f64)| {
        Datum::record([("z", Datum::of(LENGTH, *section)), ("RONt", Datum::of(MICRO, *form))])
    };
    Ok(Figure::new("sections", "along the ring")
        .lines(all.iter().map(line))
        .entry("list", Datum::List(all.iter().map(entry).collect())))
}

/// The ring before it is cut, at standstill.
fn clamping(machine: &Machine, forward: &Forward) -> Result<Figure, Failure> {
    let mut rows = forward.programme.clone();
    rows.columns[STATE].fill(CLAMPED);
    let deviations = forward::absolute(machine, forward, &rows)?;
    let (peak, valley) =
        peak_and_valley(machine.setup.grip, &circle::form(&rows.columns[ANGLE_OF_ROW].to_vec(), &deviations));
    let (form, mean) = (peak + valley, mean(&deviations));
    let (form_shown, mean_shown) = (MICRO.shown(form), MICRO.shown(mean));
    Ok(Figure::new("clamped", "clamped, not yet cut")
        .line(format!("{form_shown:.3} peak to valley, {mean_shown:+.3} of the radius"))
        .quantity("RONt", MICRO, form)
        .quantity("mean", MICRO, mean))
}

fn force(machine: &Machine) -> Figure {
    let mean = |forces: [f64; 2]| 0.5 * (forces[0] + forces[1]);
    let (standing, boring, let_go) = (machine.setup.jaw_force, mean(machine.cutting_forces()), machine.let_go());
    let mean = if machine.difference == 0.0 { "each" } else { "on average" };
    let each = format!("{:.1} {mean}", FORCE.shown(standing));
    let figure = Figure::new("jaw_force", "jaw force")
        .lines((machine.difference != 0.0).then(|| shared_out(machine)))
        .quantity("standstill", FORCE, standing)
        .quantity("boring", FORCE, boring)
        .quantity("let_go", SPINDLE_SPEED, let_go);
    if !let_go.is_finite() {
        let more = (boring != standing).then(|| format!(" at standstill, {:.1} while it is cut", FORCE.shown(boring)));
        return figure.line(each + &more.unwrap_or_default());
    }
    let (boring, let_go) = (FORCE.shown(boring), SPINDLE_SPEED.shown(let_go));
    figure.line(format!("{each} at standstill, {boring:.1} while it is cut; let go above {let_go:.0}"))
}

fn stress(setup: &Setup, scene: &shapes::Scene) -> Figure {
    let (stress, angle) = scene.largest_stress();
    let (shown, at) = (STRESS.shown(stress), ANGLE.shown(angle));
    let label = if setup.grip == Grip::Outside { "stress on the bore" } else { "stress outside" };
    Figure::new("stress", label)
        .line(format!("up to {shown:.2} (von Mises) at {at:.1}, clamped at standstill"))
        .quantity("value", STRESS, stress)
        .quantity("angle", ANGLE, angle)
}

/// Where the drawn machine gives way.
fn structure(base: &Base) -> Figure {
    let stiffness = base.compliance().recip();
    let at = base.mean_force().map_or_else(String::new, |force| format!(" about {}", FORCE.format(force)));
    Figure::new("structure", "structure")
        .line(format!("{} between tool and spindle{at}: {}", STIFFNESS.format(stiffness), base.told()))
        .quantity("stiffness", STIFFNESS, stiffness)
}

fn warnings(machine: &Machine) -> Vec<String> {
    let stiffened = stiffened(&machine.setup).filter(|by| *by > STIFFENED).map(|by| {
        let percent = 100.0 * by;
        format!(
            "elements of order 1 are some {percent:.0} % too stiff in bending here: take order = 2, or shorter ones"
        )
    });
    let of_membrane = machine.setup.grasp.iter().flat_map(membrane::warnings);
    let_go(machine).into_iter().chain(super::advice::slips(machine)).chain(stiffened).chain(of_membrane).collect()
}

/// Which jaws press with what, where they differ.
fn shared_out(machine: &Machine) -> String {
    let listed = |first: usize| {
        (first..=machine.jaw_angles.len()).step_by(2).map(|jaw| jaw.to_string()).collect::<Vec<_>>().join(", ")
    };
    let [one, other] = machine.standing_forces().map(|force| FORCE.shown(force));
    let [later, weaker] = machine.cutting_forces().map(|force| FORCE.shown(force));
    let turning = (machine.jaw_moment > 0.0).then(|| format!(", while it is cut with {later:.1} and {weaker:.1}"));
    format!("jaws {} press with {one:.1} each, {} with {other:.1}{}", listed(1), listed(2), turning.unwrap_or_default())
}

/// Says that the turning chuck holds nothing, where it does not.
pub fn let_go(machine: &Machine) -> Option<String> {
    let setup = &machine.setup;
    let lets_go = machine.standing_forces().into_iter().zip(machine.cutting_forces());
    lets_go.into_iter().any(|(standing, cutting)| standing > 0.0 && cutting == 0.0).then(|| {
        let [speed, let_go] = [setup.speed(), machine.let_go()].map(|s| SPINDLE_SPEED.shown(s));
        let jaws = if machine.difference == 0.0 { "the jaws" } else { "the weaker jaws" };
        format!("at {speed:.0} {jaws} no longer press: above {let_go:.0} the ring is let go")
    })
}

/// Part by which elements of first order are too stiff in bending, for they shear where they should bend:
/// (1 − ν)/2·(ℓ/t)² with their length ℓ around the ring and its wall t, however many lie across it. `None`
/// where none are used.
fn stiffened(setup: &Setup) -> Option<f64> {
    let Body::Cells(MeshSize { circumferential, order: 1, .. }) = setup.body else { return None };
    let (outer, inner) = (setup.outer_radius, setup.inner_radius);
    let length = TAU * 0.5 * (outer + inner) / circumferential as f64;
    Some(0.5 * (1.0 - setup.material.poisson_ratio) * (length / (outer - inner)).powi(2))
}
