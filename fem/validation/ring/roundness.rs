//! The least-squares circle and the figures of a roundness instrument.

use super::rig::*;
use crate::processes::ring::circle::{evenly, form};
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    // Jaws without force: what is left is an oval of 4 um at 20 deg, 360 points of it.
    let text = ring(84.0, 3).replace("3 kN", "0 N").replace("absolute", "least-squares-circle");
    // Any mesh will do.
    let text = text.replace("circumferential = 360, radial = 6", "circumferential = 36, radial = 1");
    let oval = chuck(&text, "[residual-stress]\namplitude = \"4 um\"\nphase = \"20 deg\"");
    let found = |key: &str, path: &str| figure_of(&oval, key, path);
    let source = "an oval A cos 2(theta - phase): 2A, A, A, A/sqrt 2 (ISO 12181-1)";
    let um = |name: &str, expected: f64, computed| {
        row(name, "oval of 4 um", (expected, computed, "um"), Tolerance::Absolute(1e-9), source)
    };
    let mut cases = vec![
        um("RONt", 8.0, found("roundness", "/RONt")),
        um("RONp", 4.0, found("roundness", "/RONp")),
        um("RONv", 4.0, found("roundness", "/RONv")),
        um("RONq", 8f64.sqrt(), found("roundness", "/RONq")),
        um("amplitude of two waves a turn", 4.0, found("harmonics", "/list/0/amplitude")),
        row(
            "crest of two waves a turn",
            "oval of 4 um",
            (20.0, found("harmonics", "/list/0/crest"), "deg"),
            Tolerance::Absolute(1e-9),
            source,
        ),
    ];
    cases.extend(circle());
    cases.extend(instruments(&text));
    cases
}

/// What a filter and gauges show of the same oval: two waves a turn.
fn instruments(text: &str) -> Vec<Case> {
    let stress = "[residual-stress]\namplitude = \"4 um\"\nphase = \"20 deg\"";
    let filtered = text.replace("reference =", "filter = 4, reference =");
    let [behind, oval] = [filtered.as_str(), text].map(|text| chuck(text, stress));
    let of = |name: &str, expected: f64, computed: f64, tolerance: Tolerance, source: &'static str| {
        row(name, "oval of 4 um", (expected, computed, "um"), tolerance, source)
    };
    let gauss = "ISO 16610-21: 2^(-(n/n_c)^2) of n waves";
    let contacts = "ISO 4292: 1 + cos(n pi) of two contacts, none of two waves by three";
    vec![
        // The weighting function is cut off where it is 1e-6 of its middle.
        of(
            "RONt behind a filter of 4",
            8.0 * 0.5f64.powf(0.25),
            figure_of(&behind, "roundness", "/RONt"),
            Tolerance::Absolute(1e-6),
            gauss,
        ),
        of(
            "diameters of two contacts differ by",
            16.0,
            figure_of(&oval, "gauges", "/two_point"),
            Tolerance::Absolute(1e-9),
            contacts,
        ),
        // Points a degree apart, between which a third of a turn falls on a point.
        of(
            "diameters of three contacts differ by",
            0.0,
            figure_of(&oval, "gauges", "/three_point"),
            Tolerance::Absolute(1e-9),
            contacts,
        ),
    ]
}

/// A centre that is off by (3, −2) um and a radius by 5 um, over angles that are not even: all of it is the
/// circle's, and three waves a turn stay.
fn circle() -> Vec<Case> {
    let angles: Vec<f64> = evenly(90).into_iter().map(|a| a + 0.2 * a.sin()).collect();
    let circle: Vec<f64> = angles.iter().map(|a| 5e-6 + 3e-6 * a.cos() - 2e-6 * a.sin()).collect();
    let left = form(&angles, &circle).iter().fold(0.0f64, |size, v| size.max(v.abs()));
    let waves: Vec<f64> = angles.iter().map(|a| 1e-6 * (3.0 * a).cos()).collect();
    let by_normal_equations = least_squares(&angles, &waves);
    vec![
        row(
            "circle off centre, uneven angles",
            "what its own circle leaves",
            (0.0, 1e6 * left, "um"),
            Tolerance::Absolute(1e-12),
            "least squares",
        ),
        row(
            "three waves a turn over uneven angles",
            "deviation at 0 deg",
            (1e6 * by_normal_equations, 1e6 * form(&angles, &waves)[0], "um"),
            Tolerance::Absolute(1e-12),
            "normal equations by Cramer's rule",
        ),
    ]
}

/// The first value less its least-squares circle.
fn least_squares(angles: &[f64], values: &[f64]) -> f64 {
    let shapes = |a: f64| [1.0, a.cos(), a.sin()];
    let (mut normal, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    for (a, v) in angles.iter().zip(values) {
        let s = shapes(*a);
        for i in 0..3 {
            right[i] += s[i] * v;
            for j in 0..3 {
                normal[i][j] += s[i] * s[j];
            }
        }
    }
    let determinant = |m: [[f64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    let whole = determinant(normal);
    let coefficient = |i: usize| {
        let mut replaced = normal;
        (0..3).for_each(|row| replaced[row][i] = right[row]);
        determinant(replaced) / whole
    };
    values[0] - (0..3).map(|i| coefficient(i) * shapes(angles[0])[i]).sum::<f64>()
}
