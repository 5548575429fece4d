//! `fem next` on simulated lines, between parts: machines of the generator, which shares nothing with the program, with noise,
//! drift, new inserts, new set-ups and pauses; beside what shops do, tuned in hindsight.
//!
//! `cargo test --test lines` runs a few, `cargo test --test lines -- --ignored --nocapture` two hundred and prints the table of
//! `tests/diagnosis/README.md`; `FEM_EVERY=10` takes every tenth, `FEM_FROM=200` other two hundred.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod line;
mod shop;

use fem::ask::{Change, Log};
use fem::input::Source;
use fem::measure::Measurements;
use fem::progress::Progress;
use line::{Kind, Knows, Line, PARTS};
use shop::{Anew, tuned};

/// First part that counts, from 0: the fourth.
const FROM: usize = 3;

/// What became of a line.
struct Outcome {
    seed: u64,
    /// What was left, measured, by the program and by EWMA and double EWMA, and by these two begun anew at jumps; um.
    costs: [f64; 5],
    /// The same in what nobody can foresee of each part.
    of_unforeseen: [f64; 5],
    /// Parts that count, and those of them of which the true mean lay in the interval.
    parts: usize,
    held: usize,
    /// Parts whose offset was that of another way of correcting.
    of_others: usize,
}

impl Outcome {
    /// Whether the program leaves less than some of the others.
    fn is_better_than(&self, others: &[usize]) -> bool {
        others.iter().all(|other| self.costs[0] < self.costs[*other])
    }

    /// Whether it leaves no more than a twentieth more than any.
    fn is_even(&self) -> bool {
        self.costs[1..].iter().all(|other| self.costs[0] < 1.05 * other)
    }
}

/// Parts that count: not those before which the zero jumps, for their error is nobody's merit.
fn parts(line: &Line) -> impl Iterator<Item = usize> + use<'_> {
    (FROM..PARTS).filter(|part| !line.is_jump(*part))
}

/// Root mean square of what was left.
fn cost(line: &Line, left: &[f64]) -> f64 {
    let (sum, count) = parts(line).fold((0.0, 0), |(sum, count), part| (sum + left[part].powi(2), count + 1));
    (sum / f64::from(count)).sqrt()
}

/// The same in what nobody can foresee of each part.
fn of_unforeseen(line: &Line, left: &[f64]) -> f64 {
    let (sum, count) = parts(line)
        .fold((0.0, 0), |(sum, count), part| (sum + (left[part] / line.unforeseen[part]).powi(2), count + 1));
    (sum / f64::from(count)).sqrt()
}

/// Names of the jobs of a line.
const JOBS: [&str; 2] = ["first", "second"];

/// Runs a line part by part, as `fem next` would.
fn run(seed: u64, line: &Line) -> Outcome {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("log.toml");
    let mut text = String::new();
    for (name, model) in JOBS.iter().zip(&line.models) {
        std::fs::write(place.path().join(format!("{name}.toml")), model).unwrap();
        text += &format!("[[job]]\nname = \"{name}\"\nmodel = \"{name}.toml\"\n");
    }
    let (mut left, mut held, mut of_others) = (Vec::new(), Vec::new(), 0);
    let mut offsets = Vec::new();
    for part in 0..PARTS {
        let mut log = Log::read(&path.display().to_string(), text.as_bytes()).unwrap();
        let file = (part > 0).then(|| line.file(part - 1, offsets[part - 1]));
        let measured = file.map(|text| {
            let process = &*log.history.jobs[0].model.process;
            Measurements::parse(Source::new("today.csv", text), process).unwrap()
        });
        let job = |part: usize| usize::from(line.second.is_some_and(|second| part >= second));
        let pauses: f64 = line.pauses.iter().filter(|(before, _)| *before == part).map(|(_, minutes)| minutes).sum();
        let change = Change {
            insert: line.insert == Some(part),
            set_up: line.set_up == Some(part),
            pause: 60.0 * pauses,
            job: (line.second == Some(part)).then(|| JOBS[1].to_string()),
        };
        let (next, added) =
            log.next(measured.as_ref().map(|own| (job(part - 1), own)), None, &change, &Progress::default()).unwrap();
        text.truncate(added.whole);
        text += &added.entry;
        let offset = 1e6 * next.part.offset;
        let (made, shown) = line.mean(part, offset);
        held.push(next.interval[0] <= 1e-6 * made && 1e-6 * made <= next.interval[1]);
        of_others += usize::from(next.better.is_some());
        left.push(shown);
        offsets.push(offset);
    }
    let shops = [(false, Anew::Never), (true, Anew::Never), (false, Anew::AtJumps), (true, Anew::AtJumps)];
    let shops = shops.map(|(is_double, anew)| tuned(line, is_double, anew, |left| cost(line, left)));
    // What was reckoned along a straight line is what the machine makes.
    let made = line.machine.made(|part| offsets[part]);
    let plain = line.machine.made(|_| 0.0);
    for (row, (made, plain)) in made.iter().zip(&plain).enumerate() {
        let (part, i) = (row / line.places.len(), row % line.places.len());
        let straight = line.answers[part][i] * offsets[part];
        assert!((made - plain - straight).abs() < 0.02 * straight.abs() + 0.1, "{part}: {made} {plain} {straight}");
    }
    let [a, b, c, d] = shops;
    let all = [left, a, b, c, d];
    let held = parts(line).filter(|part| held[*part]).count();
    let of_unforeseen = all.each_ref().map(|left| of_unforeseen(line, left));
    Outcome {
        seed,
        costs: all.each_ref().map(|left| cost(line, left)),
        of_unforeseen,
        parts: parts(line).count(),
        held,
        of_others,
    }
}

/// Runs lines side by side.
fn all(kind: Kind, knows: Knows, seeds: impl Iterator<Item = u64>) -> Vec<Outcome> {
    let seeds: Vec<u64> = seeds.collect();
    let own = |from: usize| {
        let of = |seed: &u64| run(*seed, &Line::draw(kind, *seed, knows));
        seeds.iter().skip(from).step_by(2).map(of).collect::<Vec<_>>()
    };
    let own = &own;
    let mut all: Vec<Outcome> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..2).map(|from| scope.spawn(move || own(from))).collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap()).collect()
    });
    all.sort_by_key(|own| own.seed);
    all
}

fn middle(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[test]
fn a_few_lines_are_better_than_what_shops_do_in_hindsight() {
    let all = all(Kind::Changing, Knows::Roughly, 0..6);
    let better = all.iter().filter(|own| own.is_better_than(&[1, 2])).count();
    let ratio = middle(all.iter().map(|own| own.of_unforeseen[0]));
    let [held, parts] =
        [|own: &Outcome| own.held, |own: &Outcome| own.parts].map(|of| all.iter().map(of).sum::<usize>());
    assert!(
        better >= 4 && ratio < 1.5 && 10 * held > 9 * parts,
        "{better} better, {ratio} left, {held} of {parts} held"
    );
}

#[test]
#[ignore = "minutes long; prints a table of tests/diagnosis/README.md"]
fn two_hundred_lines() {
    let number = |name: &str| std::env::var(name).ok().and_then(|own| own.parse::<u64>().ok());
    let (every, from) = (number("FEM_EVERY").unwrap_or(1) as usize, number("FEM_FROM").unwrap_or(0));
    println!(
        "| lines | of | better than EWMA | than double EWMA | than both begun anew | no more than 5 % worse than any | left, of the unforeseeable | EWMA | double EWMA | double, anew | in the 95 % interval | offsets of others |\n|---|---|---|---|---|---|---|---|---|---|---|---|"
    );
    for (name, kind, knows) in [
        ("conditions change, effects known to 20 %", Kind::Changing, Knows::Roughly),
        ("conditions and the job change, effects known to 20 %", Kind::TwoJobs, Knows::Roughly),
        ("conditions change, one effect missing, the others known to 20 %", Kind::Changing, Knows::AllButOne),
        ("conditions change, no effect known", Kind::Changing, Knows::Nothing),
        ("drift alone, effects known to 20 %", Kind::Drifting, Knows::Roughly),
        ("drift alone, no effect known", Kind::Drifting, Knows::Nothing),
    ] {
        let all = all(kind, knows, (from..from + 200).step_by(every));
        if std::env::var_os("FEM_MISSES").is_some() {
            for own in &all {
                let Outcome { seed, costs, of_unforeseen, held, of_others, .. } = own;
                println!(
                    "{seed}: {costs:.2?} um, {of_unforeseen:.2?} of the unforeseeable, held {held}, others {of_others}"
                );
            }
        }
        let than = |others: &[usize]| {
            100.0 * all.iter().filter(|own| own.is_better_than(others)).count() as f64 / all.len() as f64
        };
        let left = |of: usize| middle(all.iter().map(|own| own.of_unforeseen[of]));
        let sum = |of: &dyn Fn(&Outcome) -> usize| all.iter().map(of).sum::<usize>() as f64;
        println!(
            "| {name} | {} | {:.1} % | {:.1} % | {both:.1} % | {even:.1} % | {:.2} | {:.2} | {:.2} | {:.2} | {:.1} % | {:.1} % |",
            all.len(),
            than(&[1]),
            than(&[2]),
            left(0),
            left(1),
            left(2),
            left(4),
            100.0 * sum(&|own| own.held) / sum(&|own| own.parts),
            100.0 * sum(&|own| own.of_others) / (all.len() * PARTS) as f64,
            both = than(&[3, 4]),
            even = 100.0 * sum(&|own| usize::from(own.is_even())) / all.len() as f64,
        );
    }
}
