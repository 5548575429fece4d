//! A table of expected values, and its twin with the values shifted, which must fail.

/// One row: what is compared, computed and expected in the same unit, relative tolerance.
pub struct Row {
    pub case: String,
    pub computed: f64,
    pub expected: f64,
    pub tolerance: f64,
}

impl Row {
    pub fn new(case: impl Into<String>, computed: f64, expected: f64, tolerance: f64) -> Self {
        Self { case: case.into(), computed, expected, tolerance }
    }

    fn error(&self, expected: f64) -> f64 {
        (self.computed - expected).abs() / expected.abs()
    }
}

/// Every row must hold, and must not hold with its expected value shifted by three tolerances.
pub fn check(rows: &[Row]) {
    let mut failures = Vec::new();
    for row in rows {
        let error = row.error(row.expected);
        println!("{:<60} {:.12e}  error {error:.1e}", row.case, row.computed);
        if error.is_nan() || error > row.tolerance {
            failures.push(format!("{}: {:e}, expected {:e}, error {error:.1e}", row.case, row.computed, row.expected));
        }
        let shifted = row.expected * (1.0 + 3.0 * row.tolerance);
        if row.error(shifted) <= row.tolerance {
            failures.push(format!("{}: the shifted value {shifted:e} passes too", row.case));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
