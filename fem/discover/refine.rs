//! The refinement of laws: constants by steps that are halved, shapes exchanged for others of the same variable, terms left
//! out that are not worth their price.

use super::search::{Bench, Found, MOST_FUNCTIONS, Term, basis};
use super::shape::Shape;
use super::variable::{Factor, product};

/// Rounds of refinement, each with half the step.
const ROUNDS: usize = 7;
/// Rounds in which shapes are exchanged for others of the same variable.
const EXCHANGES: usize = 3;
/// Difference of criteria up to which they are the same.
const SAME: f64 = 1e-6;

impl Bench<'_, '_> {
    /// Refined terms with the shapes and the number of them that say most.
    pub fn polished(&self, found: Found) -> Found {
        let mut best = found;
        for _ in 0..EXCHANGES {
            let before = best.criterion;
            if let Some(other) = self.exchanged(&best) {
                let other = self.refined(other);
                if other.criterion < best.criterion {
                    best = other;
                }
            }
            while best.terms.len() > 1 {
                let less = (0..best.terms.len()).map(|without| {
                    let kept = best.terms.iter().enumerate().filter(|(i, _)| *i != without);
                    self.judged(kept.map(|(_, term)| term.clone()).collect())
                });
                match less.min_by(|a, b| a.criterion.total_cmp(&b.criterion)) {
                    // Of two that say the same the plainer one is told.
                    Some(less) if less.criterion <= best.criterion + SAME => best = self.refined(less),
                    _ => break,
                }
            }
            if best.criterion > before - SAME {
                break;
            }
        }
        best
    }

    /// The best law with one shape exchanged for another of the same variable.
    fn exchanged(&self, found: &Found) -> Option<Found> {
        let mut best: Option<Found> = None;
        for (t, term) in found.terms.iter().enumerate() {
            let metric = self.metric(term.observable)?;
            let rest: Vec<Term> =
                found.terms.iter().enumerate().filter(|(i, _)| *i != t).map(|(_, own)| own.clone()).collect();
            let others = basis(self.seen(&rest));
            let form = metric.beside(&others);
            let whole = self.residual.norm_squared() - form.chi2;
            for (f, factor) in term.factors.iter().enumerate().filter(|(_, factor)| factor.other.is_none()) {
                let beside = term.factors.iter().enumerate().filter(|(i, _)| *i != f);
                let columns: Vec<Vec<Vec<f64>>> = beside.map(|(_, own)| own.columns(self.variables)).collect();
                let own = if columns.is_empty() { vec![vec![1.0; self.rows]] } else { product(&columns) };
                let variable = &self.variables[factor.variable];
                let sums = form.sums(&metric.rows, &own, (&variable.level, variable.levels.len()));
                let products = sums.products(&self.at_levels[factor.variable]);
                let shapes = &self.factors[factor.variable];
                // What rings without an end is a wave, of just this period.
                if let (Shape::Ringing, Some(wave)) = (factor.shape, shapes.iter().find(|own| own.shape == Shape::Wave))
                {
                    let mut terms = found.terms.clone();
                    terms[t].factors[f] =
                        Factor { constants: vec![factor.constants[0]], is_known: false, ..wave.clone() };
                    let judged = self.judged(terms);
                    if best.as_ref().is_none_or(|best| judged.criterion < best.criterion) {
                        best = Some(judged);
                    }
                }
                for (shape, other) in shapes.iter().enumerate() {
                    let is_twice = term.factors.iter().enumerate().any(|(i, own)| {
                        let is_envelope = own.shape.is_envelope() && other.shape.is_wave()
                            || own.shape.is_wave() && other.shape.is_envelope();
                        i != f && own.variable == factor.variable && !is_envelope
                    });
                    let is_long = own.len() * other.shape.functions() > MOST_FUNCTIONS;
                    if is_long || is_twice || other.shape == factor.shape {
                        continue;
                    }
                    let (gain, count) = products.gain(shape);
                    if count == 0 {
                        // It would say what another term says.
                        continue;
                    }
                    let mut terms = found.terms.clone();
                    terms[t].factors[f] = other.clone();
                    let judged = self.priced(terms, (whole + gain, others.len() + count));
                    if best.as_ref().is_none_or(|best| judged.criterion < best.criterion) {
                        best = Some(judged);
                    }
                }
            }
        }
        best
    }

    /// A search by steps along each constant, which are halved.
    pub fn refined(&self, found: Found) -> Found {
        let mut terms = found.terms;
        let mut step = 0.5;
        for _ in 0..ROUNDS {
            for _ in 0..2 {
                let moved = (0..terms.len()).filter(|t| self.moves(&mut terms, *t, step)).count();
                if moved == 0 {
                    break;
                }
            }
            step *= 0.5;
        }
        self.judged(terms)
    }

    /// Moves each constant of a term by a step either way where that explains more; whether one does.
    fn moves(&self, terms: &mut [Term], t: usize, step: f64) -> bool {
        let others: Vec<Term> = terms.iter().enumerate().filter(|(i, _)| *i != t).map(|(_, own)| own.clone()).collect();
        let others = basis(self.seen(&others));
        let Term { observable, factors } = &mut terms[t];
        let Some(metric) = self.metric(*observable) else { return false };
        let gain = |columns: &[Vec<Vec<f64>>]| self.gain(&others, metric.seen(&product(columns))).0;
        let mut columns: Vec<Vec<Vec<f64>>> = factors.iter().map(|own| own.columns(self.variables)).collect();
        let before = gain(&columns);
        let mut best = before;
        for f in (0..factors.len()).filter(|f| !factors[*f].is_known).collect::<Vec<_>>() {
            for (constant, sign) in (0..factors[f].constants.len()).flat_map(|c| [(c, 1.0), (c, -1.0)]) {
                let ends = self.variables[factors[f].variable].ends();
                let to = moved(&factors[f], constant, sign * step, ends);
                let from = std::mem::replace(&mut factors[f].constants[constant], to);
                let columns_from = std::mem::replace(&mut columns[f], factors[f].columns(self.variables));
                let own = gain(&columns);
                if own > best {
                    best = own;
                } else {
                    factors[f].constants[constant] = from;
                    columns[f] = columns_from;
                }
            }
        }
        best > before * (1.0 + 1e-9)
    }
}

/// A constant moved by a part of its step: places by a tenth of the range, sizes by a ratio.
fn moved(own: &Factor, constant: usize, part: f64, (low, high): (f64, f64)) -> f64 {
    let here = own.constants[constant];
    match own.shape {
        _ if constant == 0 && own.shape.is_placed() => here + 0.2 * part * (high - low),
        Shape::Exponent => here + 0.5 * part,
        // A period is sharper than any width.
        Shape::Wave | Shape::Arch | Shape::Ringing if constant == 0 => {
            let turns = (high - low) / here;
            here * (0.25 * part / turns.max(0.5)).exp()
        }
        _ => here * part.exp(),
    }
}
