//! Cases of Monte Carlo: known moments and quantiles, within three standard errors that follow from the
//! laws, not from the draws.

use super::rig::{budget, row};
use crate::validation::{Case, Tolerance};

/// Samples in every row.
const SAMPLES: f64 = 200_000.0;

pub fn cases() -> Vec<Case> {
    [laws(), sum(), tails(), rejects(), clamping()].concat()
}

fn random(half: f64, law: &str) -> String {
    format!("[[error]]\nname = \"e\"\nkind = \"random\"\nvalue = \"{half} um\"\ndistribution = \"{law}\"\n")
}

fn drawn(errors: &str) -> Option<crate::budget::Drawn> {
    super::rig::drawn(errors, SAMPLES as usize)
}

/// Mean and standard deviation of a law with this standard deviation (um) and kurtosis.
fn moments(name: &str, errors: &str, known: (f64, f64, f64), source: &'static str) -> Vec<Case> {
    super::rig::moments(name, (errors, SAMPLES as usize), known, source)
}

fn laws() -> Vec<Case> {
    let source = "moments of the law; three standard errors";
    [("normal", 3.0, 3.0), ("triangular", 6f64.sqrt(), 2.4), ("uniform", 3f64.sqrt(), 1.8)]
        .into_iter()
        .flat_map(|(law, ratio, kurtosis)| {
            let name = format!("200 000 draws of a {law} error of 12 um");
            moments(&name, &random(12.0, law), (0.0, 12.0 / ratio, kurtosis), source)
        })
        .collect()
}

/// Variances add, and so do fourth cumulants: κ − 3 = Σ(κᵢ − 3)σᵢ⁴/σ⁴.
fn sum() -> Vec<Case> {
    let errors = [random(9.0, "normal"), random(6.0, "triangular"), random(6.0, "uniform")].concat();
    let fixed = "[[error]]\nname = \"f\"\nkind = \"systematic\"\nvalue = \"-4 um\"\n";
    let variances = [9.0, 6.0, 12.0];
    let variance: f64 = variances.iter().sum();
    let excess = (-0.6 * variances[1] * variances[1] - 1.2 * variances[2] * variances[2]) / (variance * variance);
    let known = (-4.0, variance.sqrt(), 3.0 + excess);
    let source = "seed 002 (43); three standard errors";
    moments("three laws and a systematic error", &format!("{errors}{fixed}"), known, source)
}

/// The sum of two equal uniform errors ±a is beyond d with (1 − d/2a)², so that all but the risk r lies
/// within 2a·(1 − √r); the handbook's 3σ is √6·a, which no part reaches.
fn tails() -> Vec<Case> {
    let drawn = drawn(&[random(10.0, "uniform"), random(10.0, "uniform")].concat());
    let risk = statrs::function::erf::erfc(3.0 / std::f64::consts::SQRT_2);
    let expected = 20.0 * (1.0 - risk.sqrt());
    // Standard error of a quantile p: √(p(1 − p)/N) over the density, here √(2·r/2)/2a = √r/20.
    let density = risk.sqrt() / 20.0;
    let error = (0.5 * risk * (1.0 - 0.5 * risk) / SAMPLES).sqrt() / density;
    let tolerance = Tolerance::Absolute(3.0 * error);
    let end = |i: usize| drawn.as_ref().map_or(f64::NAN, |d| d.interval[i].value);
    let source = "triangular law of two uniform errors; three standard errors";
    vec![
        row("two uniform errors of 10 um, risk 0.27 %", "lower end", (-expected, end(0)), tolerance, source),
        row("two uniform errors of 10 um, risk 0.27 %", "upper end", (expected, end(1)), tolerance, source),
    ]
}

/// A quarter of a uniform error of ±10 um lies beyond −6 and +9 um: (4 + 1)/20.
fn rejects() -> Vec<Case> {
    let text = format!(
        "budget = {{ samples = {SAMPLES}, tolerance = {{ lower = \"-6 um\", upper = \"9 um\" }} }}\n{}",
        random(10.0, "uniform")
    );
    let drawn = budget(&text).and_then(|e| e.monte_carlo.rejects).map_or(f64::NAN, |r| 100.0 * r.drawn.value);
    vec![Case {
        name: "uniform error of 10 um, tolerance -6 to 9 um".into(),
        quantity: "rejects",
        expected: 25.0,
        computed: drawn,
        unit: "%",
        tolerance: Tolerance::Absolute(300.0 * (0.25 * 0.75 / SAMPLES).sqrt()),
        source: "part of the field; three standard errors",
    }]
}

/// y = c·√Q of independent normal c and Q: E[y²] = E[c²]·E[Q], and E[√Q] by the trapezoidal rule over eight
/// standard deviations.
fn clamping() -> Vec<Case> {
    let (c, c_std) = (0.25, 0.05 / 3.0);
    let (q, q_std) = (5000.0, 1000.0 / 3.0);
    let steps = 4000;
    let mut root = 0.0;
    for i in 0..=steps {
        let z = -8.0 + 16.0 * f64::from(i) / f64::from(steps);
        root += (-0.5 * z * z).exp() * (q + q_std * z).max(0.0f64).sqrt();
    }
    root *= 16.0 / f64::from(steps) / std::f64::consts::TAU.sqrt();
    let square = (c * c + c_std * c_std) * q;
    let std = (square - (c * root).powi(2)).sqrt();
    let text = "[[error]]\nname = \"clamping\"\nkind = \"random\"\nclamping = { c_min = \"0.2 um/N^n\", c_max = \"0.3 um/N^n\", force_min = \"4 kN\", force_max = \"6 kN\", n = 0.5 }\n";
    // The product is nearly normal with a kurtosis near 3; 4 is taken to be sure.
    let known = (c * root - c * q.sqrt(), std, 4.0);
    moments(
        "contact under a force that varies, drawn",
        text,
        known,
        "seed 002 (29), by quadrature; three standard errors",
    )
}
