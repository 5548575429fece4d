//! Sizes of what rows share, and estimates beside them, against independent code.
//!
//! Expected values are of statsmodels 0.15.0 (with scipy 1.17.1, numpy 2.4.6) on the numbers below, x in mm and
//! y in um, X = [1, x] and g the run:
//!
//! ```python
//! m = MixedLM(y, X, g).fit(reml=True)                          # sqrt(m.cov_re), sqrt(m.scale), m.fe_params
//! r = GLS(y, X, sigma=V).fit()                                 # r.params, sqrt(diag(r.normalized_cov_params))
//! a = ARIMA(e, order=(1, 0, 0), trend="n").fit()               # exact likelihood; length = -1/log(coefficient)
//! w = WLS(y, X).fit()                                          # sqrt(w.scale)
//! ```
//!
//! Standard errors of mixed models, and what no function of statsmodels gives (the restricted likelihood of
//! an autoregression, profiles), are of the dense definition, minimised by `scipy.optimize` to 1e-12 over the
//! logarithms of the sizes; V = σ²·toeplitz(φ**arange(n)) or σ²·1 + τ²·Z·Zᵀ, φ = exp(−1/length):
//!
//! ```python
//! def m2ll(V):                                                 # -2 ln of the restricted likelihood
//!     W = inv(V); A = X.T @ W @ X; r = y - X @ solve(A, X.T @ W @ y)
//!     return slogdet(V)[1] + slogdet(A)[1] + r @ W @ r
//! ```

use fem::fit::{Estimate, Fit, fit};
use fem::input::Source;
use fem::measure::{Measurements, repeats};
use fem::model::{Data, Model};
use fem::noise::{Noise, Restricted};
use nalgebra::DMatrix;

/// The search for a size ends in a bracket of 2e-4 of it.
const SIZE: f64 = 3e-4;
/// What that leaves of estimates and their standard errors.
const ESTIMATE: f64 = 3e-4;
/// Round-off, and the differences by which derivatives are taken.
const EXACT: f64 = 1e-6;

/// Batches A to F of dyestuff, yields in g: Davies and Goldsmith, Statistical Methods in Research and
/// Production, 4th ed. 1972, table 6.3.
const DYESTUFF: [[f64; 5]; 6] = [
    [1545.0, 1440.0, 1440.0, 1520.0, 1580.0],
    [1540.0, 1555.0, 1490.0, 1560.0, 1495.0],
    [1595.0, 1550.0, 1605.0, 1510.0, 1560.0],
    [1445.0, 1440.0, 1595.0, 1465.0, 1545.0],
    [1595.0, 1630.0, 1515.0, 1635.0, 1625.0],
    [1520.0, 1455.0, 1450.0, 1480.0, 1445.0],
];

/// Seven runs at 0, 60, … 300 mm, two rows of which are missing; drawn with a line of 4 um + 30 um/m, zeros of
/// 3 um and noise of 1 um.
const RUNS: [&[f64]; 7] = [
    &[9.044, 10.249, 12.584, 14.534, 17.453, 18.128],
    &[9.669, 9.904, 11.866, 13.505, 16.705, 19.163],
    &[0.224, 1.352, 4.461, 5.966, 9.709, 9.905],
    &[1.522, 4.229, 6.52, 7.343],
    &[9.02, 9.796, 12.504, 13.83, 14.81, 17.402],
    &[4.23, 5.946, 8.487, 8.464, 12.007, 12.26],
    &[4.397, 7.843, 10.535, 10.465, 11.577, 13.938],
];

/// Forty rows 10 mm apart, a first-order autoregression of 2 um and a coefficient of 0.7.
const SERIES: [f64; 40] = [
    0.002, 0.428, -0.092, -1.336, -1.585, -2.526, -1.682, 0.737, -0.187, -1.017, -0.012, 0.501, 0.501, -0.978, -0.726,
    0.485, -1.581, -1.76, -3.948, -4.605, -5.854, -4.434, -4.914, -3.052, -1.913, -1.606, -4.719, -4.073, -2.92,
    -1.882, -3.503, -3.134, -3.592, -3.669, -1.053, -1.891, -1.37, 0.304, -0.621, -0.594,
];

fn model(effects: &str) -> Model {
    let axis = "process = \"axis\"\naxis = { travel = \"20 m\" }\n\
                screw = { material = \"steel\", diameter = \"32 mm\", lead = \"10 mm\" }\n";
    Model::parse(Source::new("axis.toml", format!("{axis}{effects}"))).unwrap()
}

/// A line of unknown height and slope, with an effect of the measurement.
fn line(measurement: &str) -> Model {
    let line = "effects = { reference-shift = { offset = \"? um\" }, scale-error = { slope = \"? um/m\" } }\n";
    model(&format!("{line}{measurement}"))
}

/// Rows (run, position in mm, deviation in um), with the uncertainty (um) if there is one.
fn rows(model: &Model, rows: &[(usize, f64, f64)], u: Option<f64>) -> Measurements {
    let mut text = format!("run,position [mm],direction,deviation [um]{}\n", if u.is_some() { ",u [um]" } else { "" });
    for (run, x, y) in rows {
        text += &format!("{run},{x},+,{y}{}\n", u.map_or(String::new(), |u| format!(",{u}")));
    }
    Measurements::parse(Source::new("rows.csv", text), &*model.process).unwrap()
}

fn runs() -> Vec<(usize, f64, f64)> {
    let of = |(i, values): (usize, &&[f64])| {
        values.iter().enumerate().map(|(k, y)| (i + 1, 60.0 * k as f64, *y)).collect::<Vec<_>>()
    };
    RUNS.iter().enumerate().flat_map(of).collect()
}

/// The series on a line of 5 um and 20 um/m, to three decimals.
fn trend() -> Vec<(usize, f64, f64)> {
    let y = |i: usize| (1e3 * (5.0 + 0.2 * i as f64 + SERIES[i])).round() / 1e3;
    (0..SERIES.len()).map(|i| (1, 10.0 * i as f64, y(i))).collect()
}

fn close(name: &str, found: f64, expected: f64, part: f64) {
    assert!((found / expected - 1.0).abs() <= part, "{name}: {found}, expected {expected}");
}

/// Height (um) and slope (um/m) with their standard errors.
fn check_line(fit: &Fit, expected: [(f64, f64); 2], part: f64) {
    let in_um = |e: &Estimate| (e.parameter.kind.from_si(e.value), e.parameter.kind.from_si(e.std));
    for (estimate, (value, error)) in fit.estimates.iter().zip(expected) {
        close(&estimate.parameter.path, in_um(estimate).0, value, part);
        close(&format!("standard error of {}", estimate.parameter.path), in_um(estimate).1, error, part);
    }
}

/// The 95 % interval of the size of the first term beside a line.
fn interval(data: &Data, fit: &Fit) -> [Option<f64>; 2] {
    let position = &data.rows.columns[0];
    let mean = DMatrix::from_fn(data.len(), 2, |row, column| if column == 0 { 1.0 } else { position[row] });
    let residuals = data.residuals(&fit.predicted);
    Restricted { measurements: data, residuals: &residuals, mean: &mean }.interval(&fit.noise, 0)
}

/// Balanced: the REML of statsmodels and lme4 (49.51, 42.00, 1527.50, 19.383) is the analysis of variance
/// (Searle, Casella and McCulloch, Variance Components, 1992, ch. 3).
#[test]
fn a_balanced_design_gives_the_analysis_of_variance() {
    let model = model(
        "effects = { reference-shift = { offset = \"? um\" } }\n[measurement.zero-shift]\nby = \"run\"\nsize = \"?\"\n",
    );
    let table: Vec<(usize, f64, f64)> =
        DYESTUFF.iter().enumerate().flat_map(|(i, batch)| batch.map(|y| (i + 1, 0.0, y))).collect();
    let data = Data::of(&model, rows(&model, &table, None)).unwrap();
    let found = fit(&data).unwrap();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let means = DYESTUFF.map(|batch| mean(&batch));
    let within: f64 = DYESTUFF.iter().zip(means).flat_map(|(batch, m)| batch.map(|y| (y - m).powi(2))).sum();
    let between: f64 = means.iter().map(|m| 5.0 * (m - mean(&means)).powi(2)).sum();
    let (within, between) = (within / 24.0, between / 5.0);
    let tau = ((between - within) / 5.0).sqrt();
    assert!((within.sqrt() - 49.51).abs() < 5e-3 && (tau - 42.00).abs() < 5e-3, "as printed");
    close("tau", 1e6 * found.noise.terms[0].size, tau, SIZE);
    close("sigma", 1e6 * found.noise.sigma[0], within.sqrt(), SIZE);
    close("mean", 1e6 * found.estimates[0].value, 1527.5, EXACT);
    close("standard error", 1e6 * found.estimates[0].std, (between / 30.0).sqrt(), ESTIMATE);
}

#[test]
fn an_unbalanced_design_gives_the_restricted_likelihood() {
    let model = line("[measurement.zero-shift]\nby = \"run\"\nsize = \"?\"\n");
    let data = Data::of(&model, rows(&model, &runs(), None)).unwrap();
    let found = fit(&data).unwrap();
    close("tau", 1e6 * found.noise.terms[0].size, 3.3681422, SIZE);
    close("sigma", 1e6 * found.noise.sigma[0], 0.8093165, SIZE);
    check_line(&found, [(5.41389497, 1.292445729), (30.987087594, 1.285803056)], ESTIMATE);
    let [low, high] = interval(&data, &found).map(Option::unwrap);
    close("low", 1e6 * low, 2.074005338, SIZE);
    close("high", 1e6 * high, 6.780517831, SIZE);
}

#[test]
fn known_uncertainties_stay_as_they_are() {
    let sought = line("[measurement.zero-shift]\nby = \"run\"\nsize = \"?\"\n");
    let data = Data::of(&sought, rows(&sought, &runs(), Some(1.0))).unwrap();
    let found = fit(&data).unwrap();
    close("tau", 1e6 * found.noise.terms[0].size, 3.358786223, SIZE);
    assert_eq!(found.noise.sigma[0], 1e-6);
    check_line(&found, [(5.412958166, 1.299095319), (31.0019913, 1.588567126)], ESTIMATE);
    let [low, high] = interval(&data, &found).map(Option::unwrap);
    close("low", 1e6 * low, 2.058980832, SIZE);
    close("high", 1e6 * high, 6.775767715, SIZE);
}

/// Generalised least squares with known sizes, and the intervals of a linear model: ±1.96 standard errors.
#[test]
fn known_sizes_give_generalised_least_squares() {
    let model = line("[measurement.zero-shift]\nby = \"run\"\nsize = \"3 um\"\n");
    let data = Data::of(&model, rows(&model, &runs(), Some(1.0))).unwrap();
    let found = fit(&data).unwrap();
    check_line(&found, [(5.412285724319, 1.166930282936), (31.012689234, 1.588434545)], EXACT);
    for estimate in &found.estimates {
        let half = 1.959_963_985 * estimate.std;
        for (end, sign) in [(estimate.interval.low, -1.0), (estimate.interval.high, 1.0)] {
            close("interval", end.unwrap(), estimate.value + sign * half, 1e-4);
        }
    }
    let neighbours = line("[measurement.correlated-noise]\nlength = 2.5\n");
    let data = Data::of(&neighbours, rows(&neighbours, &trend(), Some(2.0))).unwrap();
    check_line(&fit(&data).unwrap(), [(4.150561550368, 1.242055587043), (15.619334153, 5.33630854)], EXACT);
}

/// Without anything fitted the restricted likelihood is the likelihood itself.
#[test]
fn an_autoregression_gives_its_exact_likelihood() {
    let model = model("[measurement.correlated-noise]\nlength = \"?\"\n");
    let table: Vec<(usize, f64, f64)> = SERIES.iter().enumerate().map(|(i, y)| (1, 10.0 * i as f64, *y)).collect();
    let data = Data::of(&model, rows(&model, &table, None)).unwrap();
    let repeats = repeats(&data, model.process.coordinates());
    let nothing = DMatrix::zeros(data.len(), 0);
    let (noise, _) = Noise::stated(&data.terms, &data, &repeats, &data.observed, &nothing);
    close("length", noise.terms[0].size, 6.843377844, SIZE);
    close("sigma", 1e6 * noise.sigma[0], 2.386478953, SIZE);
    let restricted = Restricted { measurements: &data, residuals: &data.observed, mean: &nothing };
    // In um, and without the constant n·ln 2π.
    let in_um = restricted.minus_two_log(&noise) - 2.0 * 40.0 * 1e-6f64.ln() + 40.0 * std::f64::consts::TAU.ln();
    close("-2 ln L", in_um, 2.0 * 64.782562377, EXACT);
}

/// The upper end is open: forty rows cannot tell a long memory from a wandering zero once the level is free.
#[test]
fn an_autoregression_beside_a_line_gives_the_restricted_likelihood() {
    let model = line("[measurement.correlated-noise]\nlength = \"?\"\n");
    let data = Data::of(&model, rows(&model, &trend(), None)).unwrap();
    let found = fit(&data).unwrap();
    close("length", found.noise.terms[0].size, 4.94728967, SIZE);
    close("sigma", 1e6 * found.noise.sigma[0], 2.073678488, SIZE);
    check_line(&found, [(4.143306530805, 1.596956155), (16.373836614, 6.642378244)], ESTIMATE);
    let [low, high] = interval(&data, &found);
    close("low", low.unwrap(), 1.72407205, SIZE);
    assert_eq!(high, None);
}

/// The factor of the restricted likelihood is Birge's ratio, √(χ²/ν).
#[test]
fn a_factor_on_uncertainties_is_the_scale_of_weighted_least_squares() {
    let model = line("[measurement.uncertainty-scale]\nfactor = \"?\"\n");
    let data = Data::of(&model, rows(&model, &runs(), Some(1.0))).unwrap();
    let found = fit(&data).unwrap();
    close("factor", found.noise.terms[0].size, 3.281228657, SIZE);
    check_line(&found, [(5.287926056, 0.902810405), (32.991138498, 5.130929883)], ESTIMATE);
}
