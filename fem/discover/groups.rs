//! Laws that only tell groups of rows apart: however many rows there are, they are as good as their groups are many.

use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::Law;
use crate::model::Data;
use crate::process::Holds;

/// Part of a law's variance within groups below which it is one of groups.
const WITHIN: f64 = 0.02;
/// Chance, over the whole search, of a law that is held back.
const CHANCE: f64 = 0.01;
/// Forms among which a law of groups is sought, about: those of one variable.
const FORMS: f64 = 1000.0;

/// Why a law of groups is held back: the groups are so few that some law of the search fits whatever they are.
pub fn too_few(data: &Data, before: &[f64], law: &Law) -> Option<String> {
    let coordinates = data.model.process.coordinates();
    let is_label = |i: &usize| !coordinates[*i].is_recorded && matches!(coordinates[*i].holds, Holds::Number(_));
    let after = data.residuals(&law.predicted);
    let effect: Vec<f64> = before.iter().zip(&after).map(|(before, after)| before - after).collect();
    let told = |i: usize| {
        let levels = data.levels(&[i]);
        let groups = levels.iter().max().map_or(0, |most| most + 1);
        let means = |values: &[f64]| {
            let mut sums = vec![(0.0, 0.0); groups];
            values.iter().zip(&levels).for_each(|(value, level)| {
                sums[*level].0 += value;
                sums[*level].1 += 1.0;
            });
            sums.into_iter().map(|(sum, count)| sum / count).collect::<Vec<f64>>()
        };
        let own = means(&effect);
        let spread = |values: &[f64]| {
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            values.iter().map(|value| (value - mean).powi(2)).sum::<f64>()
        };
        let within: f64 = effect.iter().zip(&levels).map(|(value, level)| (value - own[*level]).powi(2)).sum();
        if groups < 3 || within > WITHIN * spread(&effect) {
            return None;
        }
        // What the law explains of the means of the groups, against what it leaves of them (F test).
        let constants = law.estimates.len().max(1) as f64;
        let (whole, left) = (spread(&means(before)), spread(&means(&after)));
        let freedom = groups as f64 - 1.0 - constants;
        if freedom < 1.0 {
            return Some((groups, coordinates[i].name.clone()));
        }
        let ratio = ((whole - left).max(0.0) / constants) / (left / freedom).max(f64::MIN_POSITIVE);
        let chance = FisherSnedecor::new(constants, freedom).map_or(1.0, |f| f.sf(ratio));
        (FORMS * chance > CHANCE).then(|| (groups, coordinates[i].name.clone()))
    };
    let (groups, name) = data.given.iter().copied().filter(is_label).find_map(told)?;
    Some(format!(
        "what is left goes by {name}, and {groups} of them are too few: some law of the search fits whatever they are"
    ))
}
