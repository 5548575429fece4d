//! Sobol' indices: which part of the variance of a result an input makes alone, and which with all others.
//!
//! With f_A, f_B at two independent points and f_i at A with input i taken from B,
//!
//! - first order S_i = E[(f_B − E f)·(f_i − f_A)]/V (Saltelli et al., Comput. Phys. Commun. 181 (2010) 259),
//! - total T_i = E[(f_A − f_i)²]/2V (Jansen, Comput. Phys. Commun. 117 (1999) 35),
//!
//! with V the variance over both points. Standard errors are those of the jackknife over 64 blocks of groups, which
//! takes the groups for independent draws.

/// Blocks of the jackknife.
const BLOCKS: usize = 64;
/// Fewest complete groups of which an index is told.
const FEWEST: u64 = 8;

/// Estimate of an index, with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index {
    /// First-order index: 0 to 1.
    pub first: f64,
    /// Standard error of it.
    pub first_error: f64,
    /// Total index: 0 to 1, not below the first.
    pub total: f64,
    /// Standard error of it.
    pub total_error: f64,
}

/// Sums over groups, each of the values at A, B and A with one input of B after the other.
#[derive(Clone, Debug)]
pub struct Indices {
    blocks: Vec<Sums>,
    groups: u64,
    /// About which values are summed, so that a large mean costs no digits.
    origin: Option<f64>,
}

/// Sums of one block.
#[derive(Clone, Debug, Default)]
struct Sums {
    count: f64,
    /// Σ f and Σ f² over A and B.
    values: f64,
    squares: f64,
    /// For each input: Σ f_B·(f_i − f_A), Σ (f_i − f_A), Σ (f_A − f_i)².
    inputs: Vec<[f64; 3]>,
}

impl Sums {
    fn add(&mut self, a: f64, b: f64, mixed: impl Iterator<Item = f64>) {
        self.count += 1.0;
        self.values += a + b;
        self.squares += a * a + b * b;
        for (sums, f) in self.inputs.iter_mut().zip(mixed) {
            let change = f - a;
            sums[0] += b * change;
            sums[1] += change;
            sums[2] += change * change;
        }
    }

    /// These less those of a part of them.
    fn combined(&self, other: &Self, sign: f64) -> Self {
        let inputs = self.inputs.iter().zip(&other.inputs);
        Self {
            count: self.count + sign * other.count,
            values: self.values + sign * other.values,
            squares: self.squares + sign * other.squares,
            inputs: inputs.map(|(a, b)| [0, 1, 2].map(|i| a[i] + sign * b[i])).collect(),
        }
    }

    /// First-order and total index of every input.
    fn indices(&self) -> Vec<[f64; 2]> {
        let mean = self.values / (2.0 * self.count);
        let variance = self.squares / (2.0 * self.count) - mean * mean;
        let index = |sums: &[f64; 3]| {
            let first = (sums[0] - mean * sums[1]) / self.count / variance;
            [first, sums[2] / (2.0 * self.count) / variance]
        };
        self.inputs.iter().map(index).collect()
    }
}

impl Indices {
    /// Nothing yet, of so many inputs.
    pub fn new(inputs: usize) -> Self {
        let none = Sums { inputs: vec![[0.0; 3]; inputs], ..Sums::default() };
        Self { blocks: vec![none; BLOCKS], groups: 0, origin: None }
    }

    /// Adds a group of values: A, B, and A with each input of B. A group in which one is missing tells nothing.
    pub fn add(&mut self, group: &[f64]) {
        let [a, b, mixed @ ..] = group else { return };
        if group.iter().any(|value| !value.is_finite()) {
            return;
        }
        let origin = *self.origin.get_or_insert(*a);
        let block = (self.groups % BLOCKS as u64) as usize;
        self.blocks[block].add(a - origin, b - origin, mixed.iter().map(|f| f - origin));
        self.groups += 1;
    }

    /// Number of complete groups.
    pub fn groups(&self) -> u64 {
        self.groups
    }

    /// Index of every input; `None` where there are too few groups, or the result does not vary.
    pub fn estimates(&self) -> Option<Vec<Index>> {
        let used: Vec<&Sums> = self.blocks.iter().filter(|block| block.count > 0.0).collect();
        let (first, rest) = used.split_first()?;
        if self.groups < FEWEST {
            return None;
        }
        let all = rest.iter().fold((*first).clone(), |sum, block| sum.combined(block, 1.0));
        let estimates = all.indices();
        let without: Vec<Vec<[f64; 2]>> = used.iter().map(|block| all.combined(block, -1.0).indices()).collect();
        let count = used.len() as f64;
        let error = |input: usize, which: usize| {
            let mean = without.iter().map(|w| w[input][which]).sum::<f64>() / count;
            let square: f64 = without.iter().map(|w| (w[input][which] - mean).powi(2)).sum();
            ((count - 1.0) / count * square).sqrt()
        };
        let index = |(input, [first, total]): (usize, &[f64; 2])| Index {
            first: *first,
            first_error: error(input, 0),
            total: *total,
            total_error: error(input, 1),
        };
        let found: Vec<Index> = estimates.iter().enumerate().map(index).collect();
        found.iter().all(|i| i.first.is_finite() && i.total.is_finite()).then_some(found)
    }
}
