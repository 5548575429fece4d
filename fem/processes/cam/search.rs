//! Searches along a line: where a function is largest, and where it vanishes.

/// Golden section's part.
const PART: f64 = 0.381_966_011_250_105_1;

/// The place between two others at which `f` is largest, and its value there: the largest of evenly spaced
/// samples, ends included, then a golden section between its neighbours. A peak that is narrower than the
/// samples' distance can be missed.
pub fn peak(mut f: impl FnMut(f64) -> f64, from: f64, to: f64, samples: usize) -> (f64, f64) {
    let step = (to - from) / (samples - 1) as f64;
    let at = |i: usize| if i + 1 == samples { to } else { from + step * i as f64 };
    let mut best = (from, f64::NEG_INFINITY);
    let mut number = 0;
    for i in 0..samples {
        let value = f(at(i));
        if value > best.1 {
            (best, number) = ((at(i), value), i);
        }
    }
    let (mut low, mut high) = (at(number.saturating_sub(1)), at((number + 1).min(samples - 1)));
    let mut inner = (low + PART * (high - low), high - PART * (high - low));
    let mut values = (f(inner.0), f(inner.1));
    // At 1e-5 of the step a smooth peak is flat to 1e-10 of what it rises over a step.
    while high - low > 1e-5 * step {
        if values.0 > values.1 {
            high = inner.1;
            inner = (low + PART * (high - low), inner.0);
            values = (f(inner.0), values.0);
        } else {
            low = inner.0;
            inner = (inner.1, high - PART * (high - low));
            values = (values.1, f(inner.1));
        }
    }
    for (x, value) in [(inner.0, values.0), (inner.1, values.1)] {
        if value > best.1 {
            best = (x, value);
        }
    }
    best
}

/// The place between two others at which a function vanishes, by Newton's method, or by halving where that
/// leads astray. `step` gives Newton's step, which must have the sign of what lies ahead; steps up to `small`
/// are none.
pub fn root(step: impl Fn(f64) -> f64, from: f64, (mut low, mut high): (f64, f64), small: f64) -> f64 {
    let mut x = from;
    for _ in 0..60 {
        let step = step(x);
        *(if step > 0.0 { &mut low } else { &mut high }) = x;
        if step.abs() <= small {
            break;
        }
        x = if x + step > low && x + step < high { x + step } else { 0.5 * (low + high) };
    }
    x
}

#[cfg(test)]
mod tests {
    use super::peak;

    #[test]
    fn smooth_and_sharp_peaks_and_ends() {
        assert!((peak(|x| -(x - 0.3f64).powi(2), 0.0, 1.0, 9).0 - 0.3).abs() < 1e-6);
        assert!((peak(|x| 1.0 - (x - 0.7f64).abs(), 0.0, 1.0, 9).1 - 1.0).abs() < 1e-5);
        assert_eq!(peak(|x| x, 0.0, 2.0, 5), (2.0, 2.0));
    }
}
