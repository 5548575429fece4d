//! A simulated line: a machine of the generator that makes part after part, with what happens in a shop. What happens, and when
//! each part is made, is code of its own.

use generator::job::Job;
use generator::random::{Random, decimals};
use generator::{Hidden, TURNING, Whole, asked::Asked};
use toml_edit::{Document, Item, Table};

/// Parts of a line.
pub const PARTS: usize = 30;

/// What is drawn of a line beside its machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Conditions change: a new insert, a new set-up, pauses.
    Changing,
    /// The same, and from some part on another job: a cut of `HARDER` times the force.
    TwoJobs,
    /// One set-up and one insert, a drift and nothing else.
    Drifting,
}

/// What the shop's model knows of the machine's effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knows {
    /// All to a fifth.
    Roughly,
    /// All but one to a fifth.
    AllButOne,
    /// Nothing.
    Nothing,
}

/// How many times the force of the first job the second has.
const HARDER: f64 = 1.4;

/// A line before anybody has corrected it. Numbers in um of the diameter.
pub struct Line {
    /// The model of each job as the shop has it.
    pub models: Vec<String>,
    /// Part, from 0, from which on the second job is made.
    pub second: Option<usize>,
    /// Places that are measured, m.
    pub places: Vec<f64>,
    /// What each part is off at each place with an offset of nothing.
    pub off: Vec<Vec<f64>>,
    /// By how much of an offset (um of the radius) each answers.
    pub answers: Vec<Vec<f64>>,
    /// Noise of a reading, one standard deviation, and each reading's own.
    pub sigma: f64,
    pub noise: Vec<Vec<f64>>,
    /// Parts, from 0, before which something changes: the pause (min), the insert, the set-up.
    pub pauses: Vec<(usize, f64)>,
    pub insert: Option<usize>,
    pub set_up: Option<usize>,
    /// What nobody can foresee of the mean of each part, one standard deviation: noise, scatter, walk and jumps.
    pub unforeseen: Vec<f64>,
    /// The machine, to make parts again.
    pub machine: Machine,
}

/// A machine of the generator on its schedule.
pub struct Machine {
    job: Box<dyn Job>,
    hidden: Vec<Hidden>,
    /// (part from 0, place in m, time in s where the machine has rested, force in N where it is another).
    rows: Vec<(usize, f64, Option<f64>, Option<f64>)>,
}

impl Machine {
    /// What is made of all rows with an offset (um of the radius) for each part.
    pub fn made(&self, offset: impl Fn(usize) -> f64) -> Vec<f64> {
        let asked = |(part, x, time, force): &(usize, f64, Option<f64>, Option<f64>)| {
            let number = |(name, value): (&str, f64)| (name.to_string(), value);
            let mut numbers: Vec<_> =
                [("part", (part + 1) as f64), ("x", *x), ("radius_change", 1e-6 * offset(*part))].map(number).into();
            numbers.extend(time.map(|time| number(("time", time))));
            numbers.extend(force.map(|force| number(("radial_force", force))));
            Asked { observable: "diameter_error".into(), numbers, words: Vec::new() }
        };
        let all: Vec<Asked> = self.rows.iter().map(asked).collect();
        self.job.asked(&all).expect("the generator makes it").predict(&self.hidden)
    }
}

/// What the model file says of when parts are made, min.
struct Schedule {
    cycle: f64,
    pauses: Vec<(usize, f64)>,
    length: f64,
    speed: f64,
    is_forward: bool,
    force: f64,
}

fn number(table: &Table, key: &str) -> f64 {
    let text = table[key].as_str().unwrap();
    text.split(' ').next().unwrap().parse().unwrap()
}

impl Schedule {
    fn of(model: &str) -> Self {
        let document = Document::parse(model.to_string()).unwrap();
        let of = |key: &str| document[key].as_table().unwrap();
        let (batch, cut) = (of("batch"), of("cut"));
        let entries = |item: Option<&Item>| {
            item.and_then(Item::as_array).map_or(Vec::new(), |list| list.iter().cloned().collect())
        };
        let pause = |own: &toml_edit::Value| {
            let own = own.as_inline_table().unwrap();
            let minutes = own["duration"].as_str().unwrap().split(' ').next().unwrap().parse().unwrap();
            (own["after"].as_integer().unwrap() as usize, minutes)
        };
        let segment = |own: &toml_edit::Value| {
            let text = own.as_inline_table().unwrap()["length"].as_str().unwrap();
            text.split(' ').next().unwrap().parse::<f64>().unwrap()
        };
        Self {
            cycle: number(batch, "cycle_time"),
            pauses: entries(batch.get("pauses")).iter().map(pause).collect(),
            length: entries(of("workpiece").get("segments")).iter().map(segment).sum(),
            speed: number(cut, "feed") * number(cut, "spindle_speed"),
            is_forward: cut.contains_key("from"),
            force: number(cut, "radial_force"),
        }
    }

    /// When the tool is at a place (mm) of a part (from 0), where the machine has rested before these parts, min.
    fn time(&self, part: usize, x: f64, pauses: &[(usize, f64)]) -> f64 {
        let rested: f64 = pauses.iter().filter(|(before, _)| *before <= part).map(|(_, minutes)| minutes).sum();
        let travelled = if self.is_forward { x } else { self.length - x };
        part as f64 * self.cycle + rested + travelled / self.speed
    }
}

impl Line {
    /// The line of a seed.
    pub fn draw(kind: Kind, seed: u64, knows: Knows) -> Self {
        let Whole { case, job } = TURNING.whole_machine(seed);
        let mut random = Random::new("line", seed);
        let schedule = Schedule::of(&case.model);
        let is_changing = kind != Kind::Drifting;
        let places: Vec<f64> = [0.1, 0.5, 0.9].map(|share| 1e-3 * decimals(share * schedule.length, 1)).into();
        let mut pauses: Vec<(usize, f64)> = schedule.pauses.iter().map(|(after, minutes)| (*after, *minutes)).collect();
        let own: Vec<(usize, f64)> = match is_changing {
            true => [random.whole(13, 19), random.whole(20, 27)]
                .map(|part| (part, random.uniform(20.0, 90.0).round()))
                .into(),
            false => Vec::new(),
        };
        pauses.extend(own.iter().copied());
        let insert = is_changing.then(|| random.whole(9, 18));
        let set_up = is_changing.then(|| random.whole(19, 25));
        let second = (kind == Kind::TwoJobs).then(|| Random::new("second job", seed).whole(7, 22));
        let mut hidden = case.truth.hidden.clone();
        if let Some(insert) = insert {
            hidden.push(Hidden { effect: "insert-change", parameters: vec![("after", insert as f64), ("share", 1.0)] });
        }
        let rows = (0..PARTS).flat_map(|part| places.iter().map(move |x| (part, *x)));
        let time = |part: usize, x: f64| {
            own.iter().any(|(before, _)| *before <= part).then(|| 60.0 * schedule.time(part, 1e3 * x, &pauses))
        };
        let harder = HARDER * schedule.force;
        let force = |part: usize| second.is_some_and(|second| part >= second).then_some(harder);
        let rows = rows.map(|(part, x)| (part, x, time(part, x), force(part))).collect();
        let machine = Machine { job, hidden, rows };
        let by_part = |values: Vec<f64>| values.chunks(places.len()).map(<[f64]>::to_vec).collect::<Vec<_>>();
        let (off, moved) = (by_part(machine.made(|_| 0.0)), by_part(machine.made(|_| -20.0)));
        let answer =
            |(off, moved): (&Vec<f64>, &Vec<f64>)| off.iter().zip(moved).map(|(a, b)| (b - a) / -20.0).collect();
        let answers = off.iter().zip(&moved).map(answer).collect();
        let sigma = decimals(random.log_uniform(0.5, 2.0), 3);
        let model = match knows {
            Knows::Nothing => case.model.clone(),
            Knows::Roughly => roughly(&case.revealed, &mut random),
            Knows::AllButOne => {
                let forgotten = &case.truth.hidden[seed as usize % case.truth.hidden.len()];
                roughly(&without(&case.revealed, forgotten.effect), &mut random)
            }
        };
        let of_second = |_| model.replace(&format!("\"{} N\"", schedule.force), &format!("\"{harder} N\""));
        let mut line = Self {
            models: std::iter::once(model.clone()).chain(second.map(of_second)).collect(),
            second,
            noise: (0..PARTS).map(|_| places.iter().map(|_| sigma * random.normal()).collect()).collect(),
            unforeseen: Vec::new(),
            off,
            answers,
            places,
            sigma,
            pauses,
            insert,
            set_up,
            machine,
        };
        line.wander(&mut random);
        line
    }

    /// What happens to the zero of the machine.
    fn wander(&mut self, random: &mut Random) {
        let (scatter, walk) = (random.uniform(0.0, 0.4) * self.sigma, random.uniform(0.05, 0.4) * self.sigma);
        let rate = random.sign() * random.uniform(0.0, 0.3);
        let [of_set_up, of_insert] = [random.uniform(5.0, 25.0), random.uniform(2.0, 10.0)];
        let mut zero = of_set_up * random.normal();
        let noise = self.sigma / (self.places.len() as f64).sqrt();
        for part in 0..PARTS {
            let mut jump = 0.0f64;
            for (at, size) in [(self.insert, of_insert), (self.set_up, of_set_up)] {
                if at == Some(part) {
                    zero += size * random.normal();
                    jump = jump.hypot(size);
                }
            }
            zero += rate + walk * random.normal();
            let own = zero + scatter * random.normal();
            self.off[part].iter_mut().for_each(|off| *off += own);
            self.unforeseen.push(noise.hypot(scatter).hypot(walk).hypot(jump));
        }
    }

    /// Whether nobody can foresee the zero of a part.
    pub fn is_jump(&self, part: usize) -> bool {
        part == 0 || [self.insert, self.set_up].contains(&Some(part))
    }

    /// Whether a shop begins anew with a part: nobody foresees it, or it is the first of another job.
    pub fn is_new(&self, part: usize) -> bool {
        self.is_jump(part) || self.second == Some(part)
    }

    /// Mean of a part with an offset (um of the radius), as it is made and as it is measured.
    pub fn mean(&self, part: usize, offset: f64) -> (f64, f64) {
        let count = self.places.len() as f64;
        let made = |i: usize| self.off[part][i] + self.answers[part][i] * offset;
        let true_mean = (0..self.places.len()).map(made).sum::<f64>() / count;
        (true_mean, true_mean + self.noise[part].iter().sum::<f64>() / count)
    }

    /// What the gauge shows of a part, as a file of measurements.
    pub fn file(&self, part: usize, offset: f64) -> String {
        let row = |i: usize| {
            let shown = self.off[part][i] + self.answers[part][i] * offset + self.noise[part][i];
            format!("{},{},{shown:.3},{}\n", part + 1, 1e3 * self.places[i], self.sigma)
        };
        let rows: String = (0..self.places.len()).map(row).collect();
        format!("part,x [mm],diameter_error [um],u [um]\n{rows}")
    }
}

/// A model without one of its effects.
fn without(model: &str, effect: &str) -> String {
    let mut is_own = false;
    let own = format!("[effects.{effect}");
    let keep = |line: &&str| {
        if line.starts_with('[') {
            is_own = line.starts_with(&own) && line[own.len()..].starts_with(['.', ']']);
        }
        !is_own
    };
    model.lines().filter(keep).map(|line| format!("{line}\n")).collect()
}

/// A model whose effects are known to a fifth.
fn roughly(model: &str, random: &mut Random) -> String {
    let mut is_effect = false;
    let mut text = String::new();
    for line in model.lines() {
        if line.starts_with('[') {
            is_effect = line.starts_with("[effects.");
        }
        let quantity = line.split_once(" = \"").and_then(|(key, rest)| {
            let (value, unit) = rest.trim_end_matches('"').split_once(' ')?;
            Some((key, value.parse::<f64>().ok()?, unit))
        });
        match quantity.filter(|(_, value, _)| is_effect && *value != 0.0) {
            Some((key, value, unit)) => {
                let known = value * (0.2 * random.normal()).exp();
                text += &format!("{key} = \"{known:.6} +- {:.6} {unit}\"\n", 0.2 * known.abs());
            }
            None => text += &format!("{line}\n"),
        }
    }
    text
}
