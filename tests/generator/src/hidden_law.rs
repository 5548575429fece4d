//! Laws that are in no catalogue: a job without fault is measured in several passes under conditions that further columns
//! of the file record, and a law of these and of the job's own coordinates is added to what is read. The forms are drawn
//! from a list of their own.

use std::fmt::Write as _;

use crate::Process;
use crate::random::{Random, decimals};

/// Most rows of one pass, and passes.
const ROWS: usize = 42;
const PASSES: (usize, usize) = (9, 14);

/// What stands in the readings beside the job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// A law.
    Law,
    /// A law, and a column that runs with one of its own.
    LawAndDecoy,
    /// Noise alone.
    Noise,
    /// A zero of every part, run or pass, five standard uncertainties wide.
    Zeros,
    /// A slow walk through all rows.
    Drift,
    /// Noise that neighbours share.
    Correlated,
}

/// A case with a hidden law, or with none.
#[derive(Clone, Debug)]
pub struct HiddenLaw {
    /// The model file, right but for the law.
    pub model: String,
    /// The measurement file.
    pub data: String,
    /// Rows that were never shown, in the same ranges.
    pub fresh: String,
    /// Rows beyond the ranges of the columns of which the law is made.
    pub far: String,
    /// The law, for people.
    pub law: String,
    /// The columns of which it is made.
    pub variables: Vec<String>,
    /// How many factors and summands it has.
    pub factors: usize,
}

/// A column that the model does not know: name, unit and range.
type Extra = (&'static str, &'static str, f64, f64);

const EXTRAS: &[Extra] = &[
    ("oil_temperature", "degC", 17.0, 36.0),
    ("hardness", "HV", 170.0, 245.0),
    ("oil_pressure", "bar", 2.0, 9.0),
    ("payload", "kg", 2.0, 60.0),
    ("coolant_flow", "l/min", 2.0, 22.0),
    ("drive_speed", "rpm", 200.0, 3000.0),
    ("pull_force", "N", 60.0, 900.0),
    ("grip_force", "N", 300.0, 2400.0),
    ("air_humidity", "%", 30.0, 70.0),
];

/// Columns of the jobs that a law may be made of.
const INNER: &[&str] = &["x", "position", "angle", "force", "time"];
/// Columns that are read.
const READ: &[&str] = &["diameter_error", "deviation", "displacement", "height_error", "temperature", "elongation"];

/// A form of one variable from its value and range, as text and number. Sizes are about one.
struct Form {
    text: String,
    shape: Box<dyn Fn(f64) -> f64>,
}

fn form(name: &str, low: f64, high: f64, is_angle: bool, random: &mut Random) -> Form {
    let (range, c) = (high - low, decimals(low + (high - low) * random.uniform(0.25, 0.75), 3));
    let w = decimals(range * random.uniform(0.12, 0.35), 3);
    let p = decimals(random.uniform(0.4, 3.2), 1);
    let phase = random.uniform(0.0, std::f64::consts::TAU);
    let k = random.whole(1, 8) as f64;
    let tau = std::f64::consts::TAU;
    let is_positive = low >= 0.0;
    let of = |text: String, shape: Box<dyn Fn(f64) -> f64>| Form { text, shape };
    if is_angle {
        return match random.whole(0, 2) {
            0 => of(format!("|cos({k}*{name})|"), Box::new(move |v| (k * v.to_radians()).cos().abs())),
            _ => of(format!("cos({k}*{name} + {phase:.2})"), Box::new(move |v| (k * v.to_radians() + phase).cos())),
        };
    }
    match random.whole(0, 23) {
        0 | 1 => of(format!("({name} - {c})/{w}"), Box::new(move |v| (v - c) / (0.5 * range))),
        2 if is_positive => of(format!("{name}^{p}"), Box::new(move |v| (v / high).powf(p))),
        3 if is_positive => of(format!("{name}^2"), Box::new(move |v| (v / high).powi(2))),
        4 if is_positive => of(format!("sqrt({name})"), Box::new(move |v| (v / high).sqrt())),
        5 if is_positive => of(format!("{name}^3"), Box::new(move |v| (v / high).powi(3))),
        6 if is_positive => of(format!("ln(1 + {name}/{w})"), Box::new(move |v| (1.0 + v / w).ln() / 2.0)),
        7 if is_positive => of(format!("1/(1 + {name}/{w})"), Box::new(move |v| 1.0 / (1.0 + v / w))),
        8 => of(format!("exp(-{name}/{w})"), Box::new(move |v| (-(v - low) / w).exp())),
        9 => of(format!("1 - exp(-{name}/{w})"), Box::new(move |v| 1.0 - (-(v - low) / w).exp())),
        10 => of(format!("tanh(({name} - {c})/{w})"), Box::new(move |v| ((v - c) / w).tanh())),
        11 => of(format!("max(0, {name} - {c})"), Box::new(move |v| (v - c).max(0.0) / (0.5 * range))),
        12 => of(format!("max(0, {c} - {name})"), Box::new(move |v| (c - v).max(0.0) / (0.5 * range))),
        13 => of(format!("step({name} - {c})"), Box::new(move |v| if v >= c { 1.0 } else { 0.0 })),
        14 => of(format!("exp(-(({name} - {c})/{w})^2)"), Box::new(move |v| (-((v - c) / w).powi(2)).exp())),
        15 => of(format!("max(0, 1 - |{name} - {c}|/{w})"), Box::new(move |v| (1.0 - (v - c).abs() / w).max(0.0))),
        16 => of(
            format!("sqrt(1 + (({name} - {c})/{w})^2)"),
            Box::new(move |v| (1.0 + ((v - c) / w).powi(2)).sqrt() / 3.0),
        ),
        17 if is_positive => {
            let z = decimals(random.uniform(0.05, 0.2), 2);
            let shape = move |v: f64| 0.2 / ((1.0 - (v / c).powi(2)).powi(2) + (2.0 * z * v / c).powi(2)).sqrt();
            of(format!("resonance of {name} at {c}, damping {z}"), Box::new(shape))
        }
        18 if is_positive => {
            let c = decimals(high * random.uniform(1.4, 2.0), 2);
            of(format!("1/(1 - ({name}/{c})^2)"), Box::new(move |v| 0.4 / (1.0 - (v / c).powi(2))))
        }
        19 if is_positive => {
            of(format!("{name}/{w}*exp(-{name}/{w})"), Box::new(move |v| 2.0 * v / w * (-v / w).exp()))
        }
        20 => {
            let period = decimals(range / random.uniform(0.8, 3.0), 3);
            of(format!("sin(2 pi {name}/{period} + {phase:.2})"), Box::new(move |v| (tau * v / period + phase).sin()))
        }
        // What no list of shapes here has.
        21 => of(format!("atan(({name} - {c})/{w})"), Box::new(move |v| ((v - c) / w).atan())),
        22 => of(format!("1/(1 + (({name} - {c})/{w})^2)"), Box::new(move |v| 1.0 / (1.0 + ((v - c) / w).powi(2)))),
        23 => of(format!("cosh(({name} - {c})/{w})"), Box::new(move |v| ((v - c) / (w + 0.15 * range)).cosh() / 4.0)),
        _ => of(format!("(({name} - {c})/{w})^2"), Box::new(move |v| ((v - c) / (0.4 * range)).powi(2))),
    }
}

/// A table of text.
struct Text {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Text {
    fn read(text: &str) -> Self {
        let mut lines = text.lines().map(|line| line.split(',').map(String::from).collect::<Vec<String>>());
        Self { header: lines.next().unwrap_or_default(), rows: lines.collect() }
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|head| head.split(' ').next() == Some(name))
    }
}

/// The level of a cell within its column.
fn number(cell: &str) -> f64 {
    cell.parse().unwrap_or(f64::NAN)
}

/// How often the job is measured, and what of its rows.
struct Design {
    base: Text,
    read: usize,
    sigma: f64,
    extras: Vec<Extra>,
    /// Several passes of a few rows, or every part and run once.
    is_passes: bool,
}

impl Process {
    /// A case of a law that is in no catalogue, with an amplitude of so many standard uncertainties, or of what looks like
    /// one.
    pub fn hidden_law(&self, beside: Beside, size: f64, seed: u64) -> HiddenLaw {
        let mut random = Random::new(&format!("{}hidden law", self.name), seed);
        let case = self.nothing(seed.wrapping_mul(31).wrapping_add(7));
        let mut base = Text::read(&case.exact);
        let read = READ.iter().find_map(|name| base.column(name)).unwrap_or(0);
        base.rows.retain(|row| row.get(read).is_some_and(|cell| !cell.is_empty()));
        let inner = INNER.iter().find_map(|name| base.column(name));
        base.rows.retain(|row| inner.is_none_or(|inner| !row[inner].is_empty()));
        let is_of_it = |head: &String| {
            head.strip_prefix("u_").is_some_and(|of| base.header[read].starts_with(of.split(' ').next().unwrap_or(of)))
        };
        let u = base.header.iter().position(is_of_it);
        let sigma = u.map_or(case.truth.sigma, |u| number(&base.rows[0][u]));
        let is_passes = beside != Beside::Zeros;
        if is_passes {
            let every = base.rows.len().div_ceil(ROWS);
            let mut at = 0;
            base.rows.retain(|_| {
                at += 1;
                (at - 1) % every == 0
            });
        }
        let mut extras = Vec::new();
        while extras.len() < 4 {
            let extra = random.pick(EXTRAS);
            if !extras.iter().any(|own: &Extra| own.0 == extra.0) && base.column(extra.0).is_none() {
                extras.push(extra);
            }
        }
        let design = Design { base, read, sigma, extras, is_passes };
        let (law, variables, factors, shapes) = design.law(beside, &mut random);
        let data = design.written(beside, size, &shapes, 0.0, &mut random);
        let fresh = design.written(beside, size, &shapes, 0.0, &mut random);
        let far = design.written(beside, size, &shapes, 0.2, &mut random);
        HiddenLaw { model: case.model, data, fresh, far, law, variables, factors }
    }
}

/// A law as a sum of products of forms, each of a column of the file: those of the job, then the extras.
type Law = Vec<Vec<(usize, Form)>>;

impl Design {
    fn law(&self, beside: Beside, random: &mut Random) -> (String, Vec<String>, usize, Law) {
        if !matches!(beside, Beside::Law | Beside::LawAndDecoy) {
            return (String::new(), Vec::new(), 0, Vec::new());
        }
        let width = self.base.header.len();
        let is_varied = |column: &usize| self.range(*column).1 < self.range(*column).2;
        let inner = INNER.iter().filter_map(|name| self.base.column(name)).find(is_varied);
        let mut columns: Vec<usize> = (0..self.extras.len()).map(|i| width + i).collect();
        // One of the extras has nothing to do with it.
        columns.truncate(3);
        columns.extend(inner);
        let mut pick = |random: &mut Random, is_inner: bool| {
            let at = match inner.filter(|_| is_inner) {
                Some(_) => columns.len() - 1,
                None => random.whole(0, columns.len() - 1),
            };
            columns.remove(at)
        };
        let layout: &[usize] = random.pick(&[&[1], &[1], &[2], &[2], &[2], &[2], &[1, 1], &[3]]);
        let (mut law, mut text, mut variables) = (Vec::new(), Vec::new(), Vec::new());
        for count in layout {
            let (mut term, mut words) = (Vec::new(), Vec::new());
            for i in 0..*count {
                let is_inner = i == 1 && random.chance(0.6);
                let column = pick(random, is_inner);
                let (name, low, high) = self.range(column);
                let form = form(&name, low, high, name == "angle", random);
                words.push(form.text.clone());
                variables.push(name);
                term.push((column, form));
            }
            text.push(words.join(" * "));
            law.push(term);
        }
        (text.join(" + "), variables, layout.iter().sum(), law)
    }

    fn range(&self, column: usize) -> (String, f64, f64) {
        let width = self.base.header.len();
        if column >= width {
            let (name, _, low, high) = self.extras[column - width];
            return (name.into(), low, high);
        }
        let name = self.base.header[column].split(' ').next().unwrap_or_default().to_string();
        let values = self.base.rows.iter().map(|row| number(&row[column]));
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        (name, low, high)
    }

    /// The file, with conditions so far beyond their ranges.
    fn written(&self, beside: Beside, size: f64, law: &Law, beyond: f64, random: &mut Random) -> String {
        let width = self.base.header.len();
        let passes = if self.is_passes { random.whole(PASSES.0, PASSES.1) } else { 1 };
        let label = ["part", "run"].iter().find_map(|name| self.base.column(name));
        let mut rows: Vec<(Vec<String>, Vec<f64>)> = Vec::new();
        for _ in 0..passes {
            let mut conditions: Vec<f64> = Vec::new();
            let mut last = String::new();
            for row in &self.base.rows {
                let own = label.filter(|_| !self.is_passes).map_or(String::new(), |i| row[i].clone());
                if conditions.is_empty() || own != last {
                    conditions = self.conditions(law, beyond, random);
                    if beside == Beside::LawAndDecoy {
                        let (of, by) = (self.range(width), self.range(width + 3));
                        let share = (conditions[0] - of.1) / (of.2 - of.1) + 0.08 * random.normal();
                        conditions[3] = decimals(by.1 + (by.2 - by.1) * share, 3);
                    }
                    last = own;
                }
                rows.push((row.clone(), conditions.clone()));
            }
        }
        let value = |(row, conditions): &(Vec<String>, Vec<f64>)| -> f64 {
            let at = |column: usize| if column < width { number(&row[column]) } else { conditions[column - width] };
            law.iter().map(|term| term.iter().map(|(column, form)| (form.shape)(at(*column))).product::<f64>()).sum()
        };
        let values: Vec<f64> = rows.iter().map(value).collect();
        // The amplitude is that over the range of the law itself, whatever rows are written.
        let amplitude = if law.is_empty() { 0.0 } else { size * self.sigma / self.spread(law) };
        let (mut walk, mut shared, mut zero, mut last) = (0.0, 0.0, 0.0, String::new());
        let mut text = String::new();
        let extras: Vec<String> = self.extras.iter().map(|(name, unit, ..)| format!("{name} [{unit}]")).collect();
        let unit = self.base.header[self.read].split_once(' ').map_or("", |(_, unit)| unit);
        let unit = if unit == "[degC]" { "[K]" } else { unit };
        let kept: Vec<usize> = (0..width).filter(|i| *i != self.read && self.is_kept(*i)).collect();
        let heads: Vec<&str> = kept.iter().map(|i| self.base.header[*i].as_str()).collect();
        let _ = writeln!(text, "{},{},{},u {unit}", heads.join(","), extras.join(","), self.base.header[self.read]);
        for ((row, conditions), value) in rows.iter().zip(values) {
            let own = label.map_or(String::new(), |i| row[i].clone());
            if own != last {
                zero = random.normal();
                last = own;
            }
            walk += 0.35 * random.normal();
            shared = 0.85 * shared + (1.0f64 - 0.85 * 0.85).sqrt() * random.normal();
            let noise = random.normal();
            let off = match beside {
                Beside::Zeros => 5.0 * zero + noise,
                Beside::Drift => walk + noise,
                Beside::Correlated => 3.0 * shared + noise,
                _ => noise,
            };
            let read = number(&row[self.read]) + amplitude * value + self.sigma * off;
            let cells: Vec<String> = kept.iter().map(|i| row[*i].clone()).collect();
            let extras: Vec<String> = conditions.iter().map(ToString::to_string).collect();
            let _ = writeln!(text, "{},{},{read:.6},{}", cells.join(","), extras.join(","), self.sigma);
        }
        text
    }

    /// Whether a column of the job is written: the other observable and the uncertainties are not.
    fn is_kept(&self, column: usize) -> bool {
        let head = &self.base.header[column];
        !head.starts_with("u_") && !head.starts_with("u ") && !READ.contains(&head.split(' ').next().unwrap_or(head))
    }

    fn conditions(&self, law: &Law, beyond: f64, random: &mut Random) -> Vec<f64> {
        let width = self.base.header.len();
        let is_of_law = |i: usize| law.iter().flatten().any(|(column, _)| *column == width + i);
        let one = |(i, (_, _, low, high)): (usize, &Extra)| {
            let further = if is_of_law(i) { beyond * (high - low) } else { 0.0 };
            decimals(random.uniform(*low, high + further), 3)
        };
        self.extras.iter().enumerate().map(one).collect()
    }

    /// Standard deviation of the law over conditions and rows.
    fn spread(&self, law: &Law) -> f64 {
        let width = self.base.header.len();
        let mut random = Random::new("spread", 1);
        let mut values = Vec::new();
        for _ in 0..60 {
            let conditions = self.conditions(law, 0.0, &mut random);
            for row in self.base.rows.iter().step_by(5) {
                let at = |column: usize| if column < width { number(&row[column]) } else { conditions[column - width] };
                let term = |term: &Vec<(usize, Form)>| term.iter().map(|(c, f)| (f.shape)(at(*c))).product::<f64>();
                values.push(law.iter().map(term).sum::<f64>());
            }
        }
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt().max(1e-9)
    }
}
