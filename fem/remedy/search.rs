//! The best place of one setting, and the best places of several together.

use std::cell::RefCell;

use super::bench::{Bench, Places, Trial};
use super::left::Made;
use super::minimum::{in_cube, on_interval};

/// Places at which a range is tried before its best part is searched.
const TRIED: usize = 9;
/// Evaluations of one search of one number, and for each number of several.
const MOST_OF_ONE: u64 = 20;
const MOST_OF_SEVERAL: u64 = 25;
/// Part of a tolerance that is aimed at where minutes are saved: what is set is rounded.
const AIMED: f64 = 0.99;
/// Most combinations of values of a list that are all tried.
const MOST_COMBINED: usize = 12;
/// Part of what is left that is no change.
const NONE: f64 = 1e-9;
/// Part of a range of time within which two times are the same.
const SAME: f64 = 2e-3;
/// Time that is none, s.
const NO_TIME: f64 = 1e-3;
/// How often worse than what is there a model that fails counts.
const FAILED: f64 = 10.0;

/// Why a setting is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// Name of the setting.
    pub name: String,
    /// The reason.
    pub reason: String,
    /// What to write, where something can be written.
    pub help: Option<String>,
}

/// Which of two trials a shop takes: within what is asked the one that takes less time; else the one that leaves less.
pub fn is_better(a: &Trial, b: &Trial) -> bool {
    match (a.left.is_within(), b.left.is_within()) {
        (true, true) if (a.time - b.time).abs() > NO_TIME => a.time < b.time,
        (true, false) => true,
        (false, true) => false,
        _ => a.left.cost() < b.left.cost(),
    }
}

/// The best of some trials that take no longer than a limit, s.
pub fn best<'t>(trials: impl IntoIterator<Item = &'t Trial>, limit: f64) -> Option<&'t Trial> {
    let allowed = trials.into_iter().filter(|trial| trial.time <= limit + NO_TIME);
    allowed.reduce(|best, trial| if is_better(trial, best) { trial } else { best })
}

/// The best place of one setting within a limit of time, s; what makes no model of all that was tried is added to `failed`.
///
/// # Errors
/// It changes nothing, or makes no model anywhere.
pub fn alone(bench: &Bench, lever: usize, limit: f64, failed: &mut Vec<Refused>) -> Result<Trial, Refused> {
    let name = bench.levers[lever].setting.name.clone();
    let refused = |reason: String, help: Option<&str>| {
        Err(Refused { name: name.clone(), reason, help: help.map(str::to_string) })
    };
    let places = tried_places(bench, lever);
    let found = bench.all(places.iter().map(|at| bench.with(lever, *at)).collect());
    let why = |own: &String| format!("makes no model: {own}");
    let made: Vec<&(Trial, Made)> = found.iter().flatten().collect();
    if made.is_empty() {
        let first = found.iter().find_map(|own| own.as_ref().err());
        return refused(first.map_or_else(String::new, why), None);
    }
    let wrong =
        places.iter().zip(&found).filter_map(|(at, own)| Some((bench.levers[lever].shown(*at)?, own.as_ref().err()?)));
    failed.extend(wrong.map(|(at, own)| Refused { name: format!("{name} {at}"), reason: why(own), help: None }));
    if made.iter().all(|(_, own)| is_same(own, &bench.now)) {
        let help = "leave it out, or write the law or the effect by which it acts";
        return refused("changes nothing of what is made here: the model has no law for it".into(), Some(help));
    }
    let trials: Vec<Trial> = made.into_iter().map(|(trial, _)| trial.clone()).collect();
    let cell = RefCell::new(trials);
    if bench.levers[lever].is_continuous() {
        refine(bench, lever, limit, &cell);
    }
    let trials = cell.into_inner();
    let Some(chosen) = best(&trials, limit).cloned() else {
        return refused("takes longer than the minutes that there are, wherever it is set".into(), None);
    };
    match best(&settable(bench, &chosen), limit).cloned() {
        Some(own) => Ok(own),
        None => Ok(chosen),
    }
}

/// Places of a setting that are tried first.
fn tried_places(bench: &Bench, lever: usize) -> Vec<f64> {
    let [low, high] = bench.levers[lever].ends();
    if !bench.levers[lever].is_continuous() {
        return (0..=high as usize).map(|at| at as f64).filter(|at| bench.levers[lever].present != Some(*at)).collect();
    }
    let last = (TRIED - 1) as f64;
    (0..TRIED).map(|i| low + (high - low) * i as f64 / last).collect()
}

/// Seeks the best place of a range about the best that was tried: by Brent's method where time sets no limit, else beside
/// that constraint; and where all is within what is asked, the one that takes least time.
fn refine(bench: &Bench, lever: usize, limit: f64, trials: &RefCell<Vec<Trial>>) {
    let [low, high] = bench.levers[lever].ends();
    let at = |place: f64| {
        let trial = bench.at(&bench.with(lever, place)).ok().map(|(trial, _)| trial);
        trial.iter().for_each(|trial| trials.borrow_mut().push(trial.clone()));
        trial
    };
    let cheapest = trials.borrow().iter().map(|own| own.time).fold(f64::INFINITY, f64::min);
    let longest = trials.borrow().iter().map(|own| own.time).fold(f64::NEG_INFINITY, f64::max);
    let least = |trials: &[Trial]| {
        let own = trials.iter().filter(|own| own.time <= limit + NO_TIME);
        own.min_by(|a, b| a.left.cost().total_cmp(&b.left.cost())).and_then(|own| own.places[lever])
    };
    let start = least(&trials.borrow());
    if let Some(start) = start {
        let step = (high - low) / (TRIED - 1) as f64;
        let bracket = [(start - step).max(low), (start + step).min(high)];
        if longest <= limit {
            let worst = FAILED * bench.now.left.cost();
            on_interval(|place| at(place).map_or(worst, |own| own.left.cost()), bracket, start, MOST_OF_ONE);
        } else {
            let judged = |unit: &[f64]| judged_cost(at(low + unit[0] * (high - low)).as_ref(), bench, limit);
            in_cube(judged, 1, &[(start - low) / (high - low)], MOST_OF_SEVERAL);
        }
    }
    let within = trials.borrow().iter().filter(|own| own.left.is_within()).cloned().collect::<Vec<_>>();
    let Some(start) = best(&within, limit).filter(|_| longest - cheapest > NO_TIME).and_then(|own| own.places[lever])
    else {
        return;
    };
    let judged = |unit: &[f64]| judged_time(at(low + unit[0] * (high - low)).as_ref(), longest - cheapest, limit);
    in_cube(judged, 2, &[(start - low) / (high - low)], MOST_OF_SEVERAL);
}

/// What is to become small, as a part of what it is now, and the time beyond a limit as a part of that.
fn judged_cost(trial: Option<&Trial>, bench: &Bench, limit: f64) -> (f64, Vec<f64>) {
    let now = bench.now.left.cost().max(f64::MIN_POSITIVE);
    trial.map_or((FAILED, vec![1.0]), |own| (own.left.cost() / now, vec![over(own.time, limit)]))
}

/// Time as a part of its range, and by how much more of a tolerance is used than is aimed at, and time beyond a limit.
fn judged_time(trial: Option<&Trial>, range: f64, limit: f64) -> (f64, Vec<f64>) {
    let used = |own: &Trial| own.left.surely_used.unwrap_or(0.0) - AIMED;
    trial.map_or((FAILED, vec![1.0; 2]), |own| (own.time / range, vec![used(own), over(own.time, limit)]))
}

fn over(time: f64, limit: f64) -> f64 {
    if limit.is_finite() { (time - limit) / limit.abs().max(60.0) } else { -1.0 }
}

/// The best of several settings together, each changed, from the best of each alone; `levels` are limits of time, s, below
/// which the least error is sought as well.
pub fn together(bench: &Bench, levers: &[usize], alone: &Places, limit: f64, levels: &[f64]) -> Option<Trial> {
    let trials = RefCell::new(Vec::new());
    let continuous: Vec<usize> = levers.iter().copied().filter(|own| bench.levers[*own].is_continuous()).collect();
    for fixed in combined(bench, levers, alone) {
        let at = |unit: &[f64]| {
            let mut places = fixed.clone();
            for (lever, unit) in continuous.iter().zip(unit) {
                let [low, high] = bench.levers[*lever].ends();
                places[*lever] = Some(low + unit * (high - low));
            }
            let trial = bench.at(&places).ok().map(|(trial, _)| trial);
            trial.iter().for_each(|trial| trials.borrow_mut().push(trial.clone()));
            trial
        };
        let unit_of = |places: &Places| -> Vec<f64> {
            let unit = |lever: &usize| {
                let [low, high] = bench.levers[*lever].ends();
                places[*lever].map_or(0.5, |at| (at - low) / (high - low))
            };
            continuous.iter().map(unit).collect()
        };
        let most = MOST_OF_SEVERAL * continuous.len().max(1) as u64;
        let start = unit_of(alone);
        for limit in [limit].iter().chain(levels) {
            in_cube(|unit| judged_cost(at(unit).as_ref(), bench, *limit), 1, &start, most);
        }
        let within: Vec<Trial> = trials.borrow().iter().filter(|own: &&Trial| own.left.is_within()).cloned().collect();
        if let Some(start) = best(&within, limit).filter(|_| !continuous.is_empty()).map(|own| unit_of(&own.places)) {
            let times = || trials.borrow().iter().map(|own: &Trial| own.time).collect::<Vec<f64>>();
            let range = times().into_iter().fold(f64::NEG_INFINITY, f64::max)
                - times().into_iter().fold(f64::INFINITY, f64::min);
            if range > NO_TIME {
                in_cube(|unit| judged_time(at(unit).as_ref(), range, limit), 2, &start, most);
                // Of all that take as long, the one that leaves least.
                let soonest = best(trials.borrow().iter(), limit).map(|own| (own.time, unit_of(&own.places)));
                if let Some((time, start)) = soonest {
                    let most_time = time + SAME * range;
                    in_cube(|unit| judged_cost(at(unit).as_ref(), bench, most_time), 1, &start, most);
                }
            }
        }
    }
    let trials = trials.into_inner();
    let chosen = best(&trials, limit)?;
    Some(best(&settable(bench, chosen), limit).unwrap_or(chosen).clone())
}

/// Places of the settings that have no range: every combination, or those that are best alone where there are too many.
fn combined(bench: &Bench, levers: &[usize], alone: &Places) -> Vec<Places> {
    let listed: Vec<(usize, Vec<f64>)> = levers
        .iter()
        .filter(|own| !bench.levers[**own].is_continuous())
        .map(|own| (*own, tried_places(bench, *own)))
        .collect();
    let count: usize = listed.iter().map(|(_, places)| places.len()).product();
    let mut all = vec![vec![None; bench.levers.len()]];
    for (lever, places) in listed {
        let places = if count > MOST_COMBINED { alone[lever].into_iter().collect() } else { places };
        let with = |before: &Places, at: &f64| {
            let mut places = before.clone();
            places[lever] = Some(*at);
            places
        };
        all = all.iter().flat_map(|before| places.iter().map(move |at| with(before, at))).collect();
    }
    all
}

/// The trials next to one with values that people can set.
pub fn settable(bench: &Bench, trial: &Trial) -> Vec<Trial> {
    let mut all: Vec<Places> = vec![trial.places.clone()];
    for (lever, at) in trial.places.iter().enumerate() {
        let Some(at) = at else { continue };
        let near = bench.levers[lever].settable(*at);
        all = all
            .iter()
            .flat_map(|before| {
                near.iter().map(|at| {
                    let mut places = before.clone();
                    places[lever] = Some(*at);
                    places
                })
            })
            .collect();
    }
    bench.all(all).into_iter().flatten().map(|(trial, _)| trial).collect()
}

/// Whether the same is made.
fn is_same(one: &Made, other: &Made) -> bool {
    let largest = other.values.iter().fold(0.0f64, |largest, own| largest.max(own.abs()));
    one.values.len() == other.values.len()
        && one.values.iter().zip(&other.values).all(|(a, b)| (a - b).abs() <= NONE * largest)
}
