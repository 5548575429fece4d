//! How far a prediction may be off, and with which probability parts are within what is asked.

use std::sync::Arc;

use rayon::prelude::*;

use super::Knowledge;
use crate::budget::{Law, Stream};
use crate::model::Model;
use crate::process::{Failure, Rows, Standing};

/// Rows that draws of the values may cost together, and the fewest and the most draws.
const MOST_DRAWN: usize = 2_000_000;
const DRAWS: (usize, usize) = (100, 400);
/// Times that as many are drawn, where few of them make a model.
const ROUNDS: usize = 8;
/// Parts of a standard deviation that are tried, where one leads to no model.
const SHARES: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];
/// Part of the draws below and above an interval that holds 95 % of them.
const BEYOND: f64 = 0.025;
/// Seed of what stays unexplained: that of the values is another.
const SEED: u64 = 2;
/// Half-field of a normal law in standard deviations.
const FIELD: f64 = 3.0;

/// What is known of a prediction, with the values known together. SI.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Band {
    /// The interval that holds the true value of each row with 95 %.
    pub interval: Vec<[f64; 2]>,
    /// Probability that parts are within what is asked; none where nothing is.
    pub probability: Option<Probability>,
    /// Values of the model that are known roughly.
    pub uncertain: usize,
    /// What stays unexplained of the measurements that the model was fitted to, as a standard deviation.
    pub unexplained: f64,
    /// Other sets of effects that explain them as well, with which the interval reckons.
    pub others: usize,
}

/// Probabilities of being within what is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct Probability {
    /// Of each part, by its number.
    pub of_parts: Vec<(Option<usize>, f64)>,
    /// Of all together.
    pub of_all: f64,
}

impl Band {
    /// The band about the best prediction of rows of a model, by drawing its values; those that make no model are none. `made` predicts
    /// the rows by values of the model, or of another that explains its measurements as well.
    ///
    /// # Errors
    /// Most of what the values may be makes no model.
    pub fn of(
        (model, knowledge): (&Model, &Knowledge),
        (rows, best): (&Rows, &[f64]),
        made: impl Fn(&Model, &[f64]) -> Result<Vec<f64>, Failure> + Sync,
    ) -> Result<Self, Failure> {
        let others = others(model, &made);
        Self::gathered((model, knowledge), (rows, best), &others, |number| made(model, &knowledge.drawn(number)).ok())
    }

    /// The band about a prediction of rows with nothing corrected, by draws from a parabola through what is one standard deviation
    /// away to both sides in each direction in which the values are independent: a few predictions, however dear they are.
    ///
    /// # Errors
    /// Values a sixteenth of a standard deviation away to either side make no model.
    pub fn about(model: &Model, rows: &Rows, best: &[f64]) -> Result<Self, Failure> {
        let (knowledge, nothing) = (Knowledge::of(model), Arc::default());
        let made = |model: &Model, values: &[f64]| model.commanded_at(values, &nothing)?.observe(rows);
        let others = others(model, &made);
        let mirrored = |own: &[f64]| own.iter().zip(best).map(|(own, best)| 2.0 * best - own).collect::<Vec<f64>>();
        let at = |way: usize, share: f64| match knowledge.both_ways(way, share).map(|values| made(model, &values)) {
            [Ok(up), Ok(down)] => Some([up, down]),
            // Beyond what a model may hold it goes on as it comes from the other side.
            [Ok(up), Err(_)] => Some([up.clone(), mirrored(&up)]),
            [Err(_), Ok(down)] => Some([mirrored(&down), down]),
            [Err(_), Err(_)] => None,
        };
        // Where both sides are beyond it, nothing lies farther away than the farthest that makes a model.
        let predicted = |way: usize| Some((way, SHARES.into_iter().find_map(|share| at(way, share))?));
        let ways: Vec<usize> = knowledge.ways().collect();
        let ways: Option<Vec<(usize, [Vec<f64>; 2])>> = ways.into_par_iter().map(predicted).collect();
        let ways = ways.ok_or_else(vague)?;
        let told = model.system.resolved(rows);
        Self::gathered((model, &knowledge), (&told, best), &others, |number| {
            let at = knowledge.independent(number);
            let mut values = best.to_vec();
            for (own, [up, down]) in &ways {
                let (slope, bend) = (0.5 * at[*own], 0.5 * at[*own] * at[*own]);
                for (((value, best), up), down) in values.iter_mut().zip(best).zip(up).zip(down) {
                    *value += slope * (up - down) + bend * (up + down - 2.0 * best);
                }
            }
            Some(values)
        })
    }

    /// The band of draws by their numbers about the best prediction.
    fn gathered(
        (model, knowledge): (&Model, &Knowledge),
        (rows, best): (&Rows, &[f64]),
        others: &[(f64, Vec<f64>)],
        draw: impl Fn(usize) -> Option<Vec<f64>> + Sync,
    ) -> Result<Self, Failure> {
        let draws = match knowledge.is_exact() {
            true => 1,
            false => (MOST_DRAWN / rows.len().max(1)).clamp(DRAWS.0, DRAWS.1),
        };
        let parts = parts(model, rows);
        // The first is what is known best.
        let made = |number: usize| {
            let mut own = if knowledge.uncertain() == 0 { best.to_vec() } else { draw(number)? };
            // What another set predicts is as uncertain as what this one does.
            if let Some(other) = picked(others, number) {
                own.iter_mut().zip(other).zip(best).for_each(|((own, other), best)| *own += other - best);
            }
            shift(&mut own, &parts, knowledge.unexplained, number);
            Some(own)
        };
        let mut further: Vec<Vec<f64>> = (1..draws).into_par_iter().filter_map(made).collect();
        // Where what is written reaches far beyond what makes a model, others are drawn in the place of those that do not.
        for round in 1..ROUNDS {
            if 2 * further.len() + 1 >= draws {
                break;
            }
            let next: Vec<Vec<f64>> = (round * draws..(round + 1) * draws).into_par_iter().filter_map(made).collect();
            further.extend(next);
        }
        if 2 * further.len() + 1 < draws {
            return Err(vague());
        }
        let all: Vec<&[f64]> = std::iter::once(best).chain(further.iter().map(Vec::as_slice)).collect();
        let interval = (0..rows.len()).into_par_iter().map(|row| interval(all.iter().map(|made| made[row]).collect()));
        Ok(Self {
            interval: interval.collect(),
            probability: Probability::of(&all, |made| Standing::all(&*model.system, rows, made)),
            uncertain: knowledge.uncertain(),
            unexplained: knowledge.unexplained,
            others: others.len(),
        })
    }

    /// The widest half of the intervals of some rows.
    pub fn widest(&self, rows: impl IntoIterator<Item = usize>) -> f64 {
        let half = |row: usize| 0.5 * (self.interval[row][1] - self.interval[row][0]);
        rows.into_iter().map(half).fold(0.0, f64::max)
    }

    /// Whether everything is known exactly.
    pub fn is_exact(&self) -> bool {
        self.uncertain == 0 && self.unexplained == 0.0 && self.others == 0
    }
}

impl Probability {
    /// The part of the draws, the best first, in which parts are within; none where nothing is asked.
    fn of(all: &[&[f64]], standings: impl Fn(&[f64]) -> Vec<Standing>) -> Option<Self> {
        let of = |made: &[f64]| -> Vec<(Option<usize>, bool)> {
            let mut parts: Vec<(Option<usize>, bool)> = Vec::new();
            for own in &standings(made) {
                let is_in = |range: &[f64; 2]| own.requirement.limits.hold(*range);
                parts.extend(own.parts.iter().map(|(part, range)| (*part, is_in(range))));
            }
            // Of each part the worst, which sorts first.
            parts.sort_unstable();
            parts.dedup_by_key(|(part, _)| *part);
            parts
        };
        let mut within: Vec<(Option<usize>, usize)> = of(all[0]).into_iter().map(|(part, _)| (part, 0)).collect();
        if within.is_empty() {
            return None;
        }
        let mut all_within = 0;
        for made in all {
            let own = of(made);
            within.iter_mut().zip(&own).for_each(|((_, count), (_, is_in))| *count += usize::from(*is_in));
            all_within += usize::from(own.iter().all(|(_, is_in)| *is_in));
        }
        let share = |count: usize| count as f64 / all.len() as f64;
        let of_parts = within.into_iter().map(|(part, count)| (part, share(count))).collect();
        Some(Self { of_parts, of_all: share(all_within) })
    }
}

/// What the other sets of effects predict that explain the measurements of a model as well, each with its probability.
fn others(model: &Model, made: &(impl Fn(&Model, &[f64]) -> Result<Vec<f64>, Failure> + Sync)) -> Vec<(f64, Vec<f64>)> {
    let predicted = |(probability, other): (f64, Model)| {
        let values: Vec<f64> = other.parameters.iter().map(|own| own.quantity.value).collect();
        Some((probability, made(&other, &values).ok()?))
    };
    model.alternatives().into_par_iter().filter_map(predicted).collect()
}

/// What another set predicts, for as many draws as it is probable; `None` for those of the model itself.
fn picked(others: &[(f64, Vec<f64>)], number: usize) -> Option<&[f64]> {
    /// Multiples of it fill an interval evenly.
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let mut at = (number as f64 * GOLDEN).fract();
    let own = others.iter().find(|(probability, _)| {
        at -= probability;
        at < 0.0
    });
    own.map(|(_, predicted)| predicted.as_slice())
}

/// The values are known too roughly to be drawn.
fn vague() -> Failure {
    Failure {
        message: "the values of the model are known so roughly that what they may be makes no model".into(),
        help: "fit them to measurements first: `fem fit MODEL --with DATA --add-to BETTER`".into(),
    }
}

/// The number of the part of each row; all are of one part where none are numbered.
fn parts(model: &Model, rows: &Rows) -> Vec<u32> {
    let numbered =
        model.process.in_order().and_then(|name| model.process.coordinates().iter().position(|own| own.name == name));
    let number = |row: usize| numbered.and_then(|along| rows.get(along, row)).map_or(0, |number| number as u32);
    (0..rows.len()).map(number).collect()
}

/// Moves each part by what stays unexplained: nobody knows its form, and what effects leave is smooth on a part.
fn shift(values: &mut [f64], parts: &[u32], deviation: f64, number: usize) {
    if deviation == 0.0 {
        return;
    }
    let stream = Stream::new(SEED, number as u64);
    let mut last = None;
    for (value, part) in values.iter_mut().zip(parts) {
        let by = match last {
            Some((own, by)) if own == part => by,
            _ => deviation * FIELD * Law::Normal.draw(&stream, *part, 0),
        };
        last = Some((part, by));
        *value += by;
    }
}

/// The interval that holds 95 % of some values.
fn interval(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_unstable_by(f64::total_cmp);
    let last = (values.len() - 1) as f64;
    [BEYOND, 1.0 - BEYOND].map(|part| {
        let at = part * last;
        let (below, share) = (at as usize, at.fract());
        let above = values[(below + 1).min(values.len() - 1)];
        values[below] + share * (above - values[below])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_leaves_a_fortieth_out_at_either_end() {
        let [low, high] = interval((0..=200).rev().map(f64::from).collect());
        assert!((low - 5.0).abs() < 1e-9 && (high - 195.0).abs() < 1e-9, "{low} {high}");
        assert_eq!(interval(vec![3.0]), [3.0; 2]);
    }

    /// A part moves as a whole, each by itself, with the standard deviation that is said.
    #[test]
    fn what_is_unexplained_moves_parts() {
        let parts = [1, 1, 1, 2, 2];
        let mut squares = 0.0;
        for number in 0..2000 {
            let mut values = vec![0.0, 10.0, 20.0, 0.0, 10.0];
            shift(&mut values, &parts, 2.0, number);
            let by = [values[0], values[3]];
            assert!((values[2] - 20.0 - by[0]).abs() < 1e-12 && (values[4] - 10.0 - by[1]).abs() < 1e-12);
            assert!(by[0] != by[1]);
            squares += by[0] * by[0];
        }
        // The standard error of a standard deviation of 2000 draws is 1/√4000.
        assert!(((squares / 2000.0).sqrt() / 2.0 - 1.0).abs() < 4.0 / 4000f64.sqrt(), "{squares}");
    }
}
