//! Several settings together, and what minutes buy.

use rayon::prelude::*;

use super::bench::{Bench, Places, Trial};
use super::search;

/// Most settings that are tried together with others, and most of one combination.
const MOST_CANDIDATES: usize = 6;
/// Pairs to which a third setting is added.
const MOST_PAIRS: usize = 4;
/// Limits of time between the least and that of the best, at which less error is sought.
const LEVELS: usize = 4;
/// Most points of the front.
const MOST_POINTS: usize = 10;
/// Part of what is left by which several must be better than fewer.
const BETTER: f64 = 0.01;
/// Time by which several must be better than fewer, s.
const SOONER: f64 = 3.0;

/// The better trial first.
pub fn order(a: &Trial, b: &Trial) -> std::cmp::Ordering {
    match (search::is_better(a, b), search::is_better(b, a)) {
        (true, false) => std::cmp::Ordering::Less,
        (false, true) => std::cmp::Ordering::Greater,
        _ => std::cmp::Ordering::Equal,
    }
}

/// Whether a trial is better than another by more than nothing.
pub fn is_worth_it(trial: &Trial, than: &Trial) -> bool {
    let is_within = (trial.left.is_within(), than.left.is_within());
    match is_within {
        (true, false) => true,
        (true, true) => trial.time < than.time - SOONER || trial.left.cost() < (1.0 - BETTER) * than.left.cost(),
        _ => trial.left.cost() < (1.0 - BETTER) * than.left.cost(),
    }
}

/// The best pair, and the best three, where they are better than fewer.
pub fn several(bench: &Bench, alone: &[(usize, Trial)], limit: f64) -> Vec<Trial> {
    let candidates: Vec<usize> = alone.iter().take(MOST_CANDIDATES).map(|(lever, _)| *lever).collect();
    let mut places = vec![None; bench.levers.len()];
    for (lever, trial) in alone {
        places[*lever] = trial.places[*lever];
    }
    let go = |set: &[usize]| {
        let pairs = set.iter().enumerate().flat_map(|(i, a)| set[..i].iter().map(move |b| (*a, *b)));
        pairs.into_iter().all(|(a, b)| bench.levers[a].goes_with(&bench.levers[b]))
    };
    let sets = |larger: Vec<Vec<usize>>| -> Vec<(Vec<usize>, Trial)> {
        let all = larger.into_par_iter().filter(|set| go(set));
        let mut found: Vec<(Vec<usize>, Trial)> = all
            .filter_map(|set| search::together(bench, &set, &places, limit, &[]).map(|trial| (set, trial)))
            .collect();
        found.sort_by(|(_, a), (_, b)| order(a, b));
        found
    };
    let pairs = candidates.iter().enumerate().flat_map(|(i, a)| candidates[..i].iter().map(move |b| vec![*b, *a]));
    let pairs = sets(pairs.collect());
    let mut threes: Vec<Vec<usize>> = Vec::new();
    for (pair, _) in pairs.iter().take(MOST_PAIRS) {
        for third in candidates.iter().filter(|own| !pair.contains(own)) {
            let mut three = [&pair[..], &[*third]].concat();
            three.sort_unstable();
            if !threes.contains(&three) {
                threes.push(three);
            }
        }
    }
    let threes = sets(threes);
    let nothing = bench.nothing();
    let mut than = alone.first().map_or(nothing.clone(), |(_, own)| own.clone());
    if search::is_better(&nothing, &than) {
        than = nothing;
    }
    let mut chosen = Vec::new();
    for best in [pairs.first(), threes.first()].into_iter().flatten() {
        levels(bench, &best.0, &places, &best.1);
        if is_worth_it(&best.1, &than) && search::is_better(&best.1, &than) {
            than = best.1.clone();
            chosen.push(best.1.clone());
        }
    }
    chosen
}

/// Seeks what less time than the least error takes would leave, for the front.
fn levels(bench: &Bench, set: &[usize], places: &Places, best: &Trial) {
    let of_set =
        |trial: &Trial| trial.places.iter().enumerate().all(|(lever, at)| at.is_some() == set.contains(&lever));
    let own: Vec<Trial> = bench.tried().into_iter().filter(of_set).collect();
    let least = own.iter().map(|trial| trial.time).fold(best.time, f64::min);
    let most = own.iter().min_by(|a, b| a.left.cost().total_cmp(&b.left.cost())).map_or(best.time, |trial| trial.time);
    if most - least > SOONER {
        let level = |i: usize| least + (most - least) * i as f64 / (LEVELS + 1) as f64;
        let all: Vec<f64> = (1..=LEVELS).map(level).collect();
        search::together(bench, set, places, all[LEVELS - 1], &all[..LEVELS - 1]);
    }
}

/// Trials of some settings than which no other leaves less in less time, by rising time; those that are told anyway are not left
/// out for want of room.
pub fn front(bench: &Bench, levers: &[usize], limit: f64, chosen: &[Trial]) -> Vec<Trial> {
    let least = |mut trials: Vec<Trial>| {
        trials.push(bench.nothing());
        let is_of_them =
            |trial: &Trial| trial.places.iter().enumerate().all(|(i, at)| at.is_none() || levers.contains(&i));
        trials.retain(|trial| trial.time <= limit + SOONER && is_of_them(trial));
        trials.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.left.cost().total_cmp(&b.left.cost())));
        let mut cost = f64::INFINITY;
        trials.retain(|trial| {
            let is_less = trial.left.cost() < (1.0 - BETTER) * cost;
            cost = if is_less { trial.left.cost() } else { cost };
            is_less
        });
        trials
    };
    let all = least(bench.tried());
    let thinned: Vec<Trial> = match all.len() {
        count if count > MOST_POINTS => {
            (0..MOST_POINTS).map(|i| all[i * (count - 1) / (MOST_POINTS - 1)].clone()).collect()
        }
        _ => all,
    };
    // What is told can be set.
    let set = |trial: &Trial| search::best(&search::settable(bench, trial), f64::INFINITY).cloned();
    let is_nothing = |trial: &Trial| trial.places.iter().all(Option::is_none);
    let all = thinned.iter().filter(|own| !is_nothing(own)).filter_map(set);
    least(all.chain(chosen.iter().cloned()).collect())
}
