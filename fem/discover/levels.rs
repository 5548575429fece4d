//! Laws of what is set once for many rows: however many rows there are, they are as good as these settings are many.

use std::fmt;

use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::search::{Bench, Found, Term, basis};
use super::variable::{Factor, Variable, product};

/// Rows to each setting from which they are settings, about.
const ROWS_EACH: usize = 3;
/// Chance, over the whole search, of a law that is held back.
const CHANCE: f64 = 0.02;
/// Shapes of a variable that its levels tell apart, each.
const SHAPES: usize = 4;
/// Most settings more that are worth telling.
const MOST_MORE: usize = 200;
/// Part of the levels of a variable up to which a law may have numbers that vary with it; of settings of several variables a
/// third is left to test the law by; and the numbers that it may have on however few.
const OF_LEVELS: f64 = 0.5;
const OF_SETTINGS: f64 = 2.0 / 3.0;
pub const LEAST_NUMBERS: usize = 4;

/// Settings that are too few for a law: some law of the search fits whatever they are.
#[derive(Clone, Debug, PartialEq)]
pub struct TooFew {
    /// How many there are.
    pub settings: usize,
    /// The variables that are set.
    pub variables: Vec<String>,
    /// How many more would tell, where some would.
    pub more: Option<usize>,
}

impl fmt::Display for TooFew {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { settings, variables, more } = self;
        let of = variables.join(", ");
        write!(f, "{settings} settings of {of} are too few: some law of the search fits whatever they are; ")?;
        match more {
            Some(more) => write!(f, "{more} more, unlike these, would decide"),
            None => f.write_str("many more would be needed"),
        }
    }
}

/// What is set once for many rows.
pub struct Settings {
    /// Setting of each row.
    pub level: Vec<usize>,
    /// How many there are.
    pub count: usize,
    /// Numbers of the variables that are set.
    set: Vec<usize>,
}

/// Whether a law has no more numbers of a variable, nor of all together that are set once for many rows, than a part of their
/// levels: with more it follows them, and is no law.
pub fn has_levels(bench: &Bench, law: &Found) -> bool {
    let is_few =
        |numbers: usize, part: f64, levels: usize| numbers as f64 <= (part * levels as f64).max(LEAST_NUMBERS as f64);
    let factors = || law.terms.iter().flat_map(|term| &term.factors);
    let has_levels_of = |v: usize| {
        let of = factors().filter(|own| own.variable == v && own.other.is_none());
        let numbers = of.map(|own| own.shape.functions() + own.sought()).sum();
        bench.variables[v].words > 0 || is_few(numbers, OF_LEVELS, bench.variables[v].levels.len())
    };
    let settings = Settings::of(bench, law);
    (0..bench.variables.len()).all(has_levels_of)
        && is_few(settings.numbers_of(bench, law), OF_SETTINGS, settings.count)
}

/// Why a law cannot be told from chance, where the settings of its variables are too few: what it explains between settings
/// is held against what settings with amplitudes of their own would explain more (F test), for as many laws as were tried.
pub fn too_few(bench: &Bench, law: &Found, settings: &Settings) -> Option<TooFew> {
    let rows = bench.rows;
    let Settings { level, count, set } = settings;
    let name = |v: &usize| bench.variables[*v].name.to_string();
    if set.iter().all(|v| bench.variables[*v].words > 0) {
        return None;
    }
    // The law with the same amplitude in every setting, and each setting with an amplitude of its own of what varies within.
    let (mut columns, mut alike) = (Vec::new(), Vec::new());
    for term in &law.terms {
        let within = term.factors.iter().filter(|own| !settings.is_set(bench, own));
        let factors: Vec<Vec<Vec<f64>>> = within.map(|own| own.columns(bench.variables)).collect();
        let within = if factors.is_empty() { vec![vec![1.0; rows]] } else { product(&factors) };
        for own in within {
            let one = |setting: usize| -> Vec<f64> {
                own.iter().zip(level).map(|(value, at)| if *at == setting { *value } else { 0.0 }).collect()
            };
            let all: Vec<Vec<f64>> = (0..*count).map(one).collect();
            columns.extend(bench.metric(term.observable)?.seen(&all));
            alike.extend(bench.metric(term.observable)?.seen(std::slice::from_ref(&own)));
        }
    }
    let seen = bench.seen(&law.terms);
    let of_law = basis(seen.clone());
    let together = basis(seen.into_iter().chain(columns).collect());
    let further = &together[of_law.len().min(together.len())..];
    let extra = bench.explained(further);
    let alike = basis(alike);
    let of_alike = bench.explained(&alike);
    let factors = law.terms.iter().flat_map(|term| &term.factors);
    let of_settings: Vec<&Factor> = factors.filter(|own| settings.is_set(bench, own)).collect();
    // Constants take directions as amplitudes do.
    let constants: usize = of_settings.iter().map(|own| own.sought()).sum();
    let own = (constants + of_law.len()).saturating_sub(alike.len()).max(1) as f64;
    let freedom = further.len() as f64 - constants as f64;
    let width: f64 =
        of_settings.iter().map(|own| bench.width_of(own, SHAPES * bench.variables[own.variable].levels.len())).sum();
    let chance = |freedom: f64, extra: f64| -> f64 {
        if freedom < 1.0 {
            return 1.0;
        }
        let ratio = ((law.gain - of_alike).max(0.0) / own) / (extra / freedom).max(1.0);
        width.exp() * FisherSnedecor::new(own, freedom).map_or(1.0, |f| f.sf(ratio))
    };
    if chance(freedom, extra) < CHANCE {
        return None;
    }
    let level = (extra / freedom.max(1.0)).max(1.0);
    let more = (1..=MOST_MORE).find(|more| {
        let freedom = freedom + *more as f64;
        chance(freedom, level * freedom) < CHANCE
    });
    Some(TooFew { settings: *count, variables: set.iter().map(name).collect(), more })
}

impl Settings {
    /// The settings of the variables of a law, those that vary from row to row left out.
    pub fn of(bench: &Bench, law: &Found) -> Self {
        let rows = bench.rows;
        let mut variables = bench.variables_of(law);
        variables.sort_by_key(|v| bench.variables[*v].levels.len());
        let (mut level, mut settings, mut set) = (vec![0; rows], 1, Vec::new());
        for v in variables {
            let (finer, count) = crossed(&level, &bench.variables[v]);
            if count * ROWS_EACH <= rows {
                (level, settings) = (finer, count);
                set.push(v);
            }
        }
        Self { level, count: settings, set }
    }

    /// Whether a factor is made of what is set.
    fn is_set(&self, bench: &Bench, factor: &Factor) -> bool {
        factor.made_of(bench.variables).iter().any(|v| self.set.contains(v))
    }

    /// Numbers of a law by which it varies from setting to setting: amplitudes and constants.
    fn numbers_of(&self, bench: &Bench, law: &Found) -> usize {
        let of_term = |term: &Term| -> usize {
            let set: Vec<&Factor> = term.factors.iter().filter(|own| self.is_set(bench, own)).collect();
            let constants: usize = set.iter().map(|own| own.sought()).sum();
            if set.is_empty() { 0 } else { set.iter().map(|own| own.shape.functions()).product::<usize>() + constants }
        };
        law.terms.iter().map(of_term).sum()
    }
}

/// Levels of rows, parted by those of a variable, and their number.
fn crossed(level: &[usize], variable: &Variable) -> (Vec<usize>, usize) {
    let mut known = std::collections::BTreeMap::new();
    let finer = level.iter().zip(&variable.level).map(|pair| {
        let next = known.len();
        *known.entry(pair).or_insert(next)
    });
    let finer: Vec<usize> = finer.collect();
    (finer, known.len())
}
