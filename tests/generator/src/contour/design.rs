//! Draws the jobs: machines, circles and the laps round them.

use super::{Job, Row, Screw};
use crate::job::{NoiseKind, Shown};
use crate::random::{Random, decimals, figures};

/// Of all laps together.
const READINGS: (usize, usize) = (60, 300);

/// A job that admits all of `hidden`; what is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let asked = |effects: &[&str]| effects.iter().any(|effect| hidden.contains(effect));
    let radius = decimals(random.log_uniform(30.0, 200.0), 0);
    let feed = figures(random.log_uniform(600.0, 4000.0), 2);
    let noise = random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither]);
    let screw = |random: &mut Random| Screw {
        diameter: decimals(random.uniform(20.0, 40.0), 0),
        fixed_at: decimals(random.sign() * (radius + random.uniform(50.0, 500.0)), 0),
        nut: None,
    };
    let has_lead = asked(&["cyclic-error-x", "cyclic-error-y"]) || random.chance(0.8);
    let has_frequency = asked(&["stick-slip-x", "stick-slip-y"]) || random.chance(0.3);
    let has_screws = asked(&["elastic-lost-motion-x", "elastic-lost-motion-y"]) || random.chance(0.4);
    let has_cut = asked(&["cutting-deflection"]) || random.chance(0.25);
    Some(Job {
        command: [Vec::new(), Vec::new()],
        radius,
        feed,
        gain: figures(random.uniform(20.0, 60.0), 3),
        lead: has_lead.then(|| random.pick(&[5.0, 10.0, 10.0, 16.0, 20.0])),
        frequency: has_frequency.then(|| decimals(random.uniform(0.3, 3.0), 2)),
        screws: has_screws.then(|| [screw(random), screw(random)]),
        cut: has_cut.then(|| [figures(random.uniform(80.0, 400.0), 2), figures(random.uniform(0.0, 300.0), 2)]),
        rows: rows(feed, if noise == NoiseKind::Repeats { 2 } else { 1 }, random),
        noise,
        shown: shown(hidden, random),
    })
}

/// A lap each way round, often at a second feed too, each from an angle of its own; where there are few
/// laps, sometimes more points behind the places at which an axis turns round.
fn rows(feed: f64, copies: usize, random: &mut Random) -> Vec<Row> {
    let second = random.chance(0.5).then(|| figures(feed * random.pick(&[0.3, 0.5, 1.6, 2.0]), 2));
    let feeds: Vec<f64> = std::iter::once(feed).chain(second).collect();
    let laps = 2 * feeds.len();
    let places = (random.whole(READINGS.0, READINGS.1) / (laps * copies)).max(READINGS.0 / laps);
    let closer = if random.chance(0.4) { places / 12 } else { 0 };
    let mut rows = Vec::new();
    for (number, (feed, clockwise)) in feeds.into_iter().flat_map(|feed| [(feed, false), (feed, true)]).enumerate() {
        let start = random.uniform(0.0, 360.0);
        let spread = places - 4 * closer;
        let evenly = (0..spread).map(|i| 360.0 * i as f64 / spread as f64);
        let behind = (0..4 * closer).map(|i| 90.0 * (i % 4) as f64 + 0.7 * (1 + i / 4) as f64);
        let round = if clockwise { -1.0 } else { 1.0 };
        let mut angles: Vec<f64> = evenly.map(|a| start + a).chain(behind.map(|a| round * a)).collect();
        angles.iter_mut().for_each(|a| *a = decimals(a.rem_euclid(360.0), 2) % 360.0);
        // In the order in which they are passed.
        angles.sort_by(f64::total_cmp);
        if clockwise {
            angles.reverse();
        }
        for angle in angles {
            rows.extend(std::iter::repeat_n(Row { lap: number, clockwise, feed, angle }, copies));
        }
    }
    rows
}

/// Where the instrument stands is known roughly, as a rule; sometimes more.
fn shown(hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut offer = |chance, parameters: &[Shown]| {
        if random.chance(chance) && !hidden.contains(&parameters[0].effect) {
            shown.extend_from_slice(parameters);
        }
    };
    let known = |effect, parameter, written, std| Shown { effect, parameter, written, std };
    offer(0.7, &[known("centre-offset", "x", 0.0, 5.0), known("centre-offset", "y", 0.0, 5.0)]);
    offer(0.25, &[known("backlash-x", "gap", 6.0, 1.0)]);
    offer(0.25, &[known("squareness", "angle", 15.0, 5.0)]);
    shown
}
