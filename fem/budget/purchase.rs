//! Which term of a budget to buy down: what the total becomes with less of it, and with how little of it alone the total keeps
//! its tolerance.

/// Halvings after which the part of a term that may stay is known.
const HALVINGS: usize = 40;

/// What less of one term does to the total by the handbook. m.
#[derive(Clone, Debug, PartialEq)]
pub struct Purchase {
    /// Name of the term.
    pub name: String,
    /// The total with half of it.
    pub halved: f64,
    /// The total without it.
    pub without: f64,
    /// Part of it that may stay for the total to keep the tolerance, all else as it is; `None` where there is no tolerance, or
    /// not even the whole of it suffices.
    pub may_stay: Option<f64>,
}

/// The result of the handbook's rules with less of a term: its systematic part and its random half-field, m.
pub(super) type Less = (f64, f64);

/// Every term by its name, the one whose half takes most off the total first; `with` is the result with a part of a term, by its
/// number.
pub(super) fn purchases(
    names: impl Iterator<Item = String>,
    tolerance: Option<(f64, f64)>,
    with: impl Fn(usize, f64) -> Less,
) -> Vec<Purchase> {
    let keeps = |term: usize, part: f64, (lower, upper): (f64, f64)| {
        let (systematic, random) = with(term, part);
        lower <= systematic - random && systematic + random <= upper
    };
    let may_stay = |term: usize| {
        let tolerance = tolerance?;
        if keeps(term, 1.0, tolerance) {
            return Some(1.0);
        }
        let (mut good, mut bad) = (0.0, 1.0);
        if !keeps(term, good, tolerance) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (good + bad);
            *(if keeps(term, middle, tolerance) { &mut good } else { &mut bad }) = middle;
        }
        Some(good)
    };
    let one = |(term, name): (usize, String)| {
        let [halved, without] = [0.5, 0.0].map(|part| {
            let (systematic, random) = with(term, part);
            systematic.abs() + random
        });
        Purchase { name, halved, without, may_stay: may_stay(term) }
    };
    let mut all: Vec<Purchase> = names.enumerate().map(one).collect();
    all.sort_by(|a, b| a.halved.total_cmp(&b.halved));
    all
}
