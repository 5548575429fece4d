//! Tolerance classes of ISO 286-1:2010: h6 of a shaft, H7 of a hole.

use std::fmt;

use super::limits::Limits;

/// Ends of the ranges of nominal sizes of ISO 286-1:2010, table 1, mm: over the one before, up to and with this one.
const SIZES: [u32; 21] =
    [3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150];

/// Standard tolerances of ISO 286-1:2010, table 1, um: a row a grade, IT1 to IT11, a column a range of [`SIZES`]. What is
/// printed there, not what the formula i = 0.45·∛D + 0.001·D gives, from which it was rounded by hand.
const GRADES: [[f64; 21]; 11] = [
    [0.8, 1.0, 1.0, 1.2, 1.5, 1.5, 2.0, 2.5, 3.5, 4.5, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 13.0, 15.0, 18.0, 22.0, 26.0],
    [1.2, 1.5, 1.5, 2.0, 2.5, 2.5, 3.0, 4.0, 5.0, 7.0, 8.0, 9.0, 10.0, 11.0, 13.0, 15.0, 18.0, 21.0, 25.0, 30.0, 36.0],
    [
        2.0, 2.5, 2.5, 3.0, 4.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 13.0, 15.0, 16.0, 18.0, 21.0, 24.0, 29.0, 35.0, 41.0,
        50.0,
    ],
    [
        3.0, 4.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 33.0, 39.0, 46.0,
        55.0, 68.0,
    ],
    [
        4.0, 5.0, 6.0, 8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 20.0, 23.0, 25.0, 27.0, 32.0, 36.0, 40.0, 47.0, 55.0, 65.0,
        78.0, 96.0,
    ],
    [
        6.0, 8.0, 9.0, 11.0, 13.0, 16.0, 19.0, 22.0, 25.0, 29.0, 32.0, 36.0, 40.0, 44.0, 50.0, 56.0, 66.0, 78.0, 92.0,
        110.0, 135.0,
    ],
    [
        10.0, 12.0, 15.0, 18.0, 21.0, 25.0, 30.0, 35.0, 40.0, 46.0, 52.0, 57.0, 63.0, 70.0, 80.0, 90.0, 105.0, 125.0,
        150.0, 175.0, 210.0,
    ],
    [
        14.0, 18.0, 22.0, 27.0, 33.0, 39.0, 46.0, 54.0, 63.0, 72.0, 81.0, 89.0, 97.0, 110.0, 125.0, 140.0, 165.0,
        195.0, 230.0, 280.0, 330.0,
    ],
    [
        25.0, 30.0, 36.0, 43.0, 52.0, 62.0, 74.0, 87.0, 100.0, 115.0, 130.0, 140.0, 155.0, 175.0, 200.0, 230.0, 260.0,
        310.0, 370.0, 440.0, 540.0,
    ],
    [
        40.0, 48.0, 58.0, 70.0, 84.0, 100.0, 120.0, 140.0, 160.0, 185.0, 210.0, 230.0, 250.0, 280.0, 320.0, 360.0,
        420.0, 500.0, 600.0, 700.0, 860.0,
    ],
    [
        60.0, 75.0, 90.0, 110.0, 130.0, 160.0, 190.0, 220.0, 250.0, 290.0, 320.0, 360.0, 400.0, 440.0, 500.0, 560.0,
        660.0, 780.0, 920.0, 1100.0, 1350.0,
    ],
];
/// The finest and the coarsest grade; from IT12 on each is ten times the fifth below it.
const COARSEST: usize = 18;

/// Distances of a shaft's tolerance from its nominal size by ISO 286-1:2010, tables 4 and 5, um, a column a range of [`SIZES`]:
/// the upper deviation of d to g is that much below it, the lower one of k to p above it.
const DISTANCES: [(&str, [f64; 21]); 8] = [
    (
        "d",
        [
            20.0, 30.0, 40.0, 50.0, 65.0, 80.0, 100.0, 120.0, 145.0, 170.0, 190.0, 210.0, 230.0, 260.0, 290.0, 320.0,
            350.0, 390.0, 430.0, 480.0, 520.0,
        ],
    ),
    (
        "e",
        [
            14.0, 20.0, 25.0, 32.0, 40.0, 50.0, 60.0, 72.0, 85.0, 100.0, 110.0, 125.0, 135.0, 145.0, 160.0, 170.0,
            195.0, 220.0, 240.0, 260.0, 290.0,
        ],
    ),
    (
        "f",
        [
            6.0, 10.0, 13.0, 16.0, 20.0, 25.0, 30.0, 36.0, 43.0, 50.0, 56.0, 62.0, 68.0, 76.0, 80.0, 86.0, 98.0, 110.0,
            120.0, 130.0, 145.0,
        ],
    ),
    (
        "g",
        [
            2.0, 4.0, 5.0, 6.0, 7.0, 9.0, 10.0, 12.0, 14.0, 15.0, 17.0, 18.0, 20.0, 22.0, 24.0, 26.0, 28.0, 30.0, 32.0,
            34.0, 38.0,
        ],
    ),
    ("k", [0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
    (
        "m",
        [
            2.0, 4.0, 6.0, 7.0, 8.0, 9.0, 11.0, 13.0, 15.0, 17.0, 20.0, 21.0, 23.0, 26.0, 30.0, 34.0, 40.0, 48.0, 58.0,
            68.0, 76.0,
        ],
    ),
    (
        "n",
        [
            4.0, 8.0, 10.0, 12.0, 15.0, 17.0, 20.0, 23.0, 27.0, 31.0, 34.0, 37.0, 40.0, 44.0, 50.0, 56.0, 66.0, 78.0,
            92.0, 110.0, 135.0,
        ],
    ),
    (
        "p",
        [
            6.0, 12.0, 15.0, 18.0, 22.0, 26.0, 32.0, 37.0, 43.0, 50.0, 56.0, 62.0, 68.0, 78.0, 88.0, 100.0, 120.0,
            140.0, 170.0, 195.0, 240.0,
        ],
    ),
];
/// Letters whose tolerance lies above the nominal size.
const ABOVE: [&str; 4] = ["k", "m", "n", "p"];
/// Grades for which k stands off; for others its lower deviation is zero.
const K_STANDS_OFF: std::ops::RangeInclusive<usize> = 4..=7;

/// Why a tolerance class gives no limits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// It is no tolerance class at all.
    NoClass,
    /// A letter of which no table is here.
    Letter(String),
    /// A grade beyond IT18, or none.
    Grade(String),
    /// A size beyond 3150 mm.
    Size,
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoClass => f.write_str("it is no tolerance class: a letter and a grade, such as h6"),
            Self::Letter(letter) => write!(
                f,
                "of `{letter}` there is no table here: known are d, e, f, g, h, js, k, m, n, p and D to H, JS"
            ),
            Self::Grade(grade) => write!(f, "there is no grade {grade}: they go from 1 to {COARSEST}"),
            Self::Size => f.write_str("ISO 286-1 reaches from 0 to 3150 mm"),
        }
    }
}

/// Limits of a tolerance class at a nominal size (m), as deviations from it, m.
///
/// # Errors
/// There is no such class, or none of this size.
pub fn limits(class: &str, size: f64) -> Result<Limits, Unknown> {
    let digits = class.find(|c: char| c.is_ascii_digit()).ok_or(Unknown::NoClass)?;
    let (letter, grade) = class.split_at(digits);
    if letter.is_empty() || !letter.chars().all(|c| c.is_ascii_alphabetic()) {
        return Err(Unknown::NoClass);
    }
    let number: usize = grade.parse().map_err(|_| Unknown::NoClass)?;
    if !(1..=COARSEST).contains(&number) {
        return Err(Unknown::Grade(grade.into()));
    }
    let range = range(size).ok_or(Unknown::Size)?;
    let width = width(number, range);
    let is_hole = letter.starts_with(|c: char| c.is_ascii_uppercase());
    let distance = |name: &str| DISTANCES.iter().find(|(own, _)| *own == name).map(|(_, all)| 1e-6 * all[range]);
    let [lower, upper] = match &*letter.to_ascii_lowercase() {
        "h" => [-width, 0.0],
        "js" => [-0.5 * width, 0.5 * width],
        // Of holes with an interference the deviation depends on the grade.
        name if is_hole && ABOVE.contains(&name) => return Err(Unknown::Letter(letter.into())),
        "k" if !K_STANDS_OFF.contains(&number) => [0.0, width],
        name => match distance(name) {
            Some(distance) if ABOVE.contains(&name) => [distance, distance + width],
            Some(distance) => [-distance - width, -distance],
            None => return Err(Unknown::Letter(letter.into())),
        },
    };
    // A hole is as much too large as the shaft of its letter is too small.
    Ok(if is_hole { Limits { lower: -upper + 0.0, upper: -lower } } else { Limits { lower, upper } })
}

/// Width of a grade, m.
fn width(grade: usize, range: usize) -> f64 {
    let tens = (grade.saturating_sub(7)) / 5;
    1e-6 * GRADES[grade - 1 - 5 * tens][range] * 10f64.powi(tens as i32)
}

fn range(size: f64) -> Option<usize> {
    let mm = 1e3 * size;
    // A picometre is round-off.
    (mm > 0.0).then(|| SIZES.iter().position(|end| mm <= f64::from(*end) + 1e-9))?
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fits as tables of limits print them (ISO 286-2:2010).
    #[test]
    fn limits_are_those_that_are_printed() {
        for (class, mm, lower, upper) in [
            ("h6", 25.0, -13.0, 0.0),
            ("H7", 50.0, 0.0, 25.0),
            ("g6", 40.0, -25.0, -9.0),
            ("G7", 40.0, 9.0, 34.0),
            ("k6", 30.0, 2.0, 15.0),
            ("k9", 30.0, 0.0, 52.0),
            ("js5", 100.0, -7.5, 7.5),
            ("p6", 60.0, 32.0, 51.0),
            ("f7", 20.0, -41.0, -20.0),
            ("m5", 18.0, 7.0, 15.0),
            ("h6", 450.0, -40.0, 0.0),
            ("h7", 450.0, -63.0, 0.0),
            ("h12", 40.0, -250.0, 0.0),
            ("h17", 40.0, -2500.0, 0.0),
            ("d9", 3.0, -45.0, -20.0),
        ] {
            let found = limits(class, 1e-3 * mm).unwrap();
            let wanted = Limits { lower: 1e-6 * lower, upper: 1e-6 * upper };
            let is_near = |a: f64, b: f64| (a - b).abs() < 1e-12;
            assert!(
                is_near(found.lower, wanted.lower) && is_near(found.upper, wanted.upper),
                "{class} {mm}: {found:?}"
            );
        }
    }

    #[test]
    fn what_no_table_has_is_refused() {
        assert_eq!(limits("6h", 0.03), Err(Unknown::NoClass));
        assert_eq!(limits("fine", 0.03), Err(Unknown::NoClass));
        assert_eq!(limits("h19", 0.03), Err(Unknown::Grade("19".into())));
        assert_eq!(limits("zc6", 0.03), Err(Unknown::Letter("zc".into())));
        assert_eq!(limits("N7", 0.03), Err(Unknown::Letter("N".into())));
        assert_eq!(limits("h6", 3.2), Err(Unknown::Size));
    }
}
