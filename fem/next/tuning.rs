//! Sizes by the likelihood of a history, with what is usual as prior knowledge.

use super::filter::run;
use super::line::Line;
use super::sizes::Sizes;

/// First and last step of the search, in the logarithm of a size.
const STEPS: (f64, f64) = (0.8, 0.15);

/// The most probable sizes with what was measured before the step numbered `until`, by a search along each in turn.
pub fn tuned(mut sizes: Sizes, line: &Line, until: usize) -> Sizes {
    let value = |sizes: &Sizes| sizes.prior() + run(line, sizes, until).log_likelihood;
    let (mut best, mut step) = (value(&sizes), STEPS.0);
    while step > STEPS.1 {
        let mut is_better = false;
        for which in sizes.open() {
            for by in [step, -step] {
                let other = sizes.moved(which, by);
                let own = value(&other);
                if own > best {
                    (sizes, best, is_better) = (other, own, true);
                    break;
                }
            }
        }
        if !is_better {
            step *= 0.5;
        }
    }
    sizes
}
