//! Draws the jobs: shafts, workholdings, cuts, schedules and measuring designs, as varied as a workshop's.

use super::catalogue::holds;
use super::job::{Holding, Job, Row, Survey};
use super::set_up::SetUp;
use super::shaft::{Material, Segment, Shaft};
use crate::job::{NoiseKind, Shown};
use crate::random::{Random, decimals, figures};
use std::f64::consts::TAU;

/// Structural steel.
pub const STEEL: Material = Material {
    modulus: 210.0,
    poisson: 0.3,
    density: 7850.0,
    expansion: 11.5,
    conductivity: 50.0,
    specific_heat: 470.0,
};
const ALUMINIUM: Material = Material {
    modulus: 70.0,
    poisson: 0.33,
    density: 2700.0,
    expansion: 23.5,
    conductivity: 160.0,
    specific_heat: 900.0,
};
const CAST_IRON: Material = Material {
    modulus: 110.0,
    poisson: 0.26,
    density: 7200.0,
    expansion: 10.5,
    conductivity: 52.0,
    specific_heat: 460.0,
};

/// A job whose workholding admits all of `hidden`, or None when none does. What is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let weighted = [Holding::Centres; 9].into_iter().chain([Holding::ChuckAndCentre; 7]).chain([Holding::Chuck; 4]);
    let fitting: Vec<Holding> = weighted.filter(|&h| hidden.iter().all(|e| holds(h, e))).collect();
    if fitting.is_empty() {
        return None;
    }
    let holding = random.pick(&fitting);
    loop {
        let mut job = skeleton(holding, random);
        job.shown = shown(holding, hidden, random);
        measure(&mut job, random);
        let bends = super::equilibrium::errors(&job, &[]).into_iter().fold(0.0, f64::max);
        // Slimmer than this nobody would turn it, and the finish cut would vanish under force-feedback.
        if bends < 0.35e3 * job.depth.min(0.6) && (60..=300).contains(&job.rows.len()) {
            return Some(job);
        }
    }
}

/// The same on a lathe whose edge and bed were measured.
pub fn draw_surveyed_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let job = draw_job(hidden, random)?;
    let from = if job.forward { job.shaft.length() } else { 0.0 };
    let last = job.path(job.parts, from);
    let (run_in, rate, worse) = (random.uniform(0.03, 0.08), random.uniform(0.03, 0.1), random.uniform(0.0, 0.1));
    let width = |share: f64| run_in * (1.0 - (-8.0 * share).exp()) + rate * share + worse * (share - 0.6).max(0.0);
    let point = |i: usize| {
        let share = i as f64 / 8.0;
        // Up, so that the last part is cut within what is known.
        ((share * last).ceil(), decimals(width(share), 4))
    };
    let survey = Survey {
        clearance: random.uniform(5.0, 10.0).round(),
        land: (0..=8).map(point).collect(),
        spacing: random.uniform(250.0, 450.0).round(),
        height: random.uniform(180.0, 320.0).round(),
    };
    Some(Job { survey: Some(survey), ..job })
}

/// Shaft, cut and batch.
fn skeleton(holding: Holding, random: &mut Random) -> Job {
    let shaft = shaft(random);
    let feed = decimals(random.uniform(0.15, 0.3), 3);
    let speed = random.uniform(400.0, 850.0).round();
    let parts = random.whole(8, 13);
    let mut job = Job {
        shaft,
        holding,
        depth: decimals(random.uniform(0.45, 1.2), 2),
        feed,
        speed,
        force: random.uniform(250.0, 900.0).round(),
        forward: random.chance(0.12),
        parts,
        cycle: 0.0,
        pauses: Vec::new(),
        rows: Vec::new(),
        force_column: true,
        noise: random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither]),
        shown: Vec::new(),
        survey: None,
        set_up: SetUp::default(),
    };
    job.cycle = decimals(job.cutting_time() * random.uniform(1.15, 1.6) + random.uniform(0.5, 2.5), 2);
    let pauses = random.pick(&[0, 1, 1, 1, 1, 2]);
    if pauses >= 1 {
        job.pauses.push((parts / 2, random.uniform(15.0, 40.0).round()));
    }
    if pauses == 2 {
        job.pauses.push((parts / 2 + random.whole(1, 3), random.uniform(10.0, 60.0).round()));
    }
    job
}

fn shaft(random: &mut Random) -> Shaft {
    let length = random.uniform(250.0, 800.0);
    let diameter = random.uniform(25.0, 70.0);
    let steps = random.pick(&[1, 1, 1, 2, 3, 3]);
    let mut shares: Vec<f64> = (0..steps).map(|_| random.uniform(0.6, 1.4)).collect();
    let whole: f64 = shares.iter().sum();
    shares.iter_mut().for_each(|s| *s /= whole);
    let factors = match steps {
        1 => vec![1.0],
        2 => vec![1.0, random.uniform(0.8, 1.2)],
        _ => vec![1.0, random.uniform(1.08, 1.2), random.uniform(0.85, 1.0)],
    };
    let segment = |(share, factor): (&f64, &f64)| Segment {
        length: decimals(length * share, 1),
        diameter: decimals(diameter * factor, 1),
        bore: 0.0,
    };
    let segments = shares.iter().zip(&factors).map(segment).collect();
    let material = random.pick(&[STEEL, STEEL, STEEL, STEEL, STEEL, STEEL, STEEL, ALUMINIUM, CAST_IRON]);
    Shaft { material, segments, shear: random.chance(0.5) }
}

/// The compliances every machine has, known to 12 %, and often the tool's setting; now and then one of them
/// is not in the model (and then not in the machine either, unless it is what is hidden).
fn shown(holding: Holding, hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let mut shown = Vec::new();
    let names = ["headstock-compliance", "tailstock-compliance", "carriage-compliance"];
    let absent = random.chance(0.15).then(|| random.whole(0, 2));
    for (i, effect) in names.into_iter().enumerate() {
        let written = figures(random.uniform(30.0, 90.0), 3);
        if holds(holding, effect) && !hidden.contains(&effect) && absent != Some(i) {
            shown.push(Shown { effect, parameter: "stiffness", written, std: figures(0.12 * written, 3) });
        }
    }
    if random.chance(0.25) && holds(holding, "chuck-tilt") && !hidden.contains(&"chuck-tilt") {
        let written = figures(random.uniform(250.0, 800.0), 3);
        shown.push(Shown { effect: "chuck-tilt", parameter: "stiffness", written, std: figures(0.12 * written, 3) });
    }
    if random.chance(0.5) && !hidden.contains(&"setting-error") {
        shown.push(Shown { effect: "setting-error", parameter: "offset", written: 0.0, std: 15.0 });
    }
    shown
}

/// The measuring design: places, force levels that cycle with the part, blanks of two batches, repeats.
fn measure(job: &mut Job, random: &mut Random) {
    let places = random.pick(&[7, 8, 9, 9, 9, 9, 9, 9, 10, 11]);
    let levels: &[f64] = random.pick::<&[f64]>(&[
        &[1.0],
        &[1.0, 1.0, 0.4],
        &[1.0, 1.0, 0.4],
        &[1.0, 1.0, 0.4],
        &[1.0, 0.5],
        &[1.0, 0.7, 0.4],
        &[1.0, 1.0, 0.35, 0.65],
    ]);
    job.force_column = levels.len() > 1 || random.chance(0.5);
    let blank = random.chance(0.8).then(|| Blanks::draw(random));
    let copies = if job.noise == NoiseKind::Repeats { 2 } else { 1 };
    let length = job.shaft.length();
    job.rows.clear();
    for part in 1..=job.parts {
        let force = decimals(job.force * levels[(part - 1) % levels.len()], 1);
        for i in 0..places {
            let share = 0.04 + 0.92 * i as f64 / (places - 1) as f64;
            let x = decimals(share * length, 1);
            let left =
                |b: &Blanks| decimals(job.shaft.diameter(x) + 2.0 * job.depth * (1.0 + b.excess(part, share)), 4);
            let row = Row { part, x, force, blank: blank.as_ref().map(left), ..Row::default() };
            job.rows.extend(std::iter::repeat_n(row, copies));
        }
    }
}

/// Shape of the blanks relative to the depth: two batches (odd and even parts), waves, cones, and sometimes
/// a size of each part's own.
struct Blanks {
    wave: [f64; 2],
    cone: [f64; 2],
    periods: f64,
    own: [f64; 13],
}

impl Blanks {
    fn draw(random: &mut Random) -> Self {
        let mut two = |size: f64| [random.uniform(-size, size), random.uniform(-size, size)];
        let (wave, cone) = (two(0.12), two(0.12));
        let own = random.pick(&[0.0, 0.0, 0.06]);
        Self { wave, cone, periods: random.pick(&[0.5, 1.0]), own: std::array::from_fn(|_| own * random.normal()) }
    }

    fn excess(&self, part: usize, share: f64) -> f64 {
        let batch = part % 2;
        let wave = self.wave[batch] * (TAU * self.periods * share).cos();
        (wave + 2.0 * self.cone[batch] * (share - 0.5) + self.own[(part - 1) % 13]).clamp(-0.35, 0.35)
    }
}
