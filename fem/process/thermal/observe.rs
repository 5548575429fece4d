//! What is measured of a heated body: how far its end has moved, and temperatures at places, over time.

use super::body::Body;
use super::follow::{Look, Span, follow, step};
use super::job::Heated;
use super::model::Setup;
use crate::process::{Absent, Coordinate, Failure, Further, Holds, Misplaced, Observable, Rows};
use crate::solve::rod::lagged;
use crate::units::{LENGTH, MICRO, TEMPERATURE, TIME};

/// Growth first, for it is what a workpiece feels.
pub const OBSERVABLES: &[Observable] = &[
    Observable { name: "elongation", words: "the elongation", kind: MICRO },
    Observable { name: "temperature", words: "temperatures", kind: TEMPERATURE },
];

/// Positions in [`OBSERVABLES`].
pub const ELONGATION: usize = 0;
pub const TEMPERATURE_OF_ROW: usize = 1;

/// Positions in [`COORDINATES`].
pub const TIME_OF_ROW: usize = 0;
pub const X: usize = 1;
pub const Y: usize = 2;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    coordinate("time", "since the start of the run", Holds::Quantity(TIME), Absent::Refused),
    coordinate(
        "x",
        "from the base, where a temperature is measured",
        Holds::Quantity(LENGTH),
        Absent::NeededBy(TEMPERATURE_OF_ROW),
    ),
    coordinate(
        "y",
        "height in a plane body; half way up if left out",
        Holds::Quantity(LENGTH),
        Absent::ModelOf(TEMPERATURE_OF_ROW),
    ),
];

const fn coordinate(name: &'static str, about: &'static str, holds: Holds, absent: Absent) -> Coordinate {
    Coordinate { name, about, holds, absent, repeats: false }
}

/// Rows before the start, or beside the body.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let length = setup.body.length();
    let check = |row: usize| {
        let off = |coordinate: usize, message: String| Some(Misplaced { row, coordinate, message });
        if rows.get(TIME_OF_ROW, row).is_some_and(|t| t < 0.0) {
            return off(TIME_OF_ROW, "the time is before the start of the run".into());
        }
        if rows.observable[row] == ELONGATION && !setup.body.has_ends() {
            return off(
                TIME_OF_ROW,
                "the elongation is that from edge left to edge right, and the mesh does not name both".into(),
            );
        }
        let outside = |value: Option<f64>, [low, high]: [f64; 2]| {
            let slack = 1e-9 * (high - low);
            value.is_some_and(|v| v < low - slack || v > high + slack)
        };
        let (along, across) = match &setup.body {
            Body::Rod(_) => ([0.0, length], None),
            Body::Plane(plane) => (plane.extent(0), Some(plane.extent(1))),
        };
        if outside(rows.get(X, row), along) {
            return off(X, format!("the body reaches from {} to {} mm", 1e3 * along[0], 1e3 * along[1]));
        }
        match (rows.get(Y, row), across) {
            (Some(_), None) => off(Y, "a rod is as warm above as below: it has no y".into()),
            (y, Some(across)) if outside(y, across) => {
                off(Y, format!("the body reaches from {} to {} mm", 1e3 * across[0], 1e3 * across[1]))
            }
            _ => None,
        }
    };
    (0..rows.len()).filter_map(check).collect()
}

/// The model's own programme: at every time the elongation, then the temperatures from the base on.
pub fn programme(setup: &Setup) -> Rows {
    let elongation = setup.body.has_ends().then_some(None);
    let places: Vec<Option<f64>> = elongation.into_iter().chain(setup.places.iter().copied().map(Some)).collect();
    rows(setup, &setup.times, &places)
}

/// The elongation (`None`) or the temperature at places, at every one of some times.
fn rows(setup: &Setup, times: &[f64], places: &[Option<f64>]) -> Rows {
    let all = || times.iter().flat_map(|t| places.iter().map(move |x| (*t, *x)));
    let of = |value: &dyn Fn(f64, Option<f64>) -> f64| all().map(|(t, x)| value(t, x)).collect::<Vec<f64>>();
    Rows {
        columns: vec![
            of(&|t, _| t),
            of(&|_, x| x.unwrap_or(f64::NAN)),
            of(&|_, x| x.map_or(f64::NAN, |_| height(setup).unwrap_or(f64::NAN))),
        ],
        observable: all().map(|(_, x)| if x.is_some() { TEMPERATURE_OF_ROW } else { ELONGATION }).collect(),
    }
}

/// Where y is left out.
fn height(setup: &Setup) -> Option<f64> {
    match &setup.body {
        Body::Rod(_) => None,
        Body::Plane(plane) => Some(plane.middle()),
    }
}

/// Temperatures half way up where no height is said.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut resolved = rows.clone();
    if let Some(middle) = height(setup) {
        for (y, observable) in resolved.columns[Y].iter_mut().zip(&rows.observable) {
            if y.is_nan() && *observable == TEMPERATURE_OF_ROW {
                *y = middle;
            }
        }
    }
    resolved
}

/// What every row shows: m, or K.
///
/// # Errors
/// The body cannot be computed.
pub fn observe(heated: &Heated, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let setup = heated.setup();
    let look = |row: usize| match rows.observable[row] {
        ELONGATION => Look::Elongation,
        _ => Look::Rise { x: rows.get(X, row).unwrap_or(f64::NAN), y: rows.get(Y, row) },
    };
    let mut looks: Vec<Look> = Vec::new();
    let of_row: Vec<usize> = (0..rows.len())
        .map(|row| {
            let own = look(row);
            looks.iter().position(|l| *l == own).unwrap_or_else(|| {
                looks.push(own);
                looks.len() - 1
            })
        })
        .collect();
    let end = rows.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max);
    let span = Span { step: step(&heated.machine)?, end, pictures: 0 };
    let followed = follow(&heated.machine, &looks, &span)?;
    let track = &followed.track;
    let shown: Vec<Vec<f64>> = looks
        .iter()
        .zip(&track.values)
        .map(|(look, values)| match look {
            Look::Rise { .. } if heated.machine.lag > 0.0 => lagged(&track.times, values, heated.machine.lag),
            _ => values.clone(),
        })
        .collect();
    let one = |row: usize| {
        let value = track.at(&shown[of_row[row]], rows.columns[TIME_OF_ROW][row]);
        if rows.observable[row] == ELONGATION { value } else { setup.ambient + value }
    };
    Ok((0..rows.len()).map(one).collect())
}

/// What else could be measured: temperatures at other places, the elongation, the time after the heat is off, and more often early on.
pub fn menu(setup: &Setup, rows: &Rows) -> Vec<Further> {
    /// New rows along time.
    const TIMES: usize = 40;
    let length = setup.body.length();
    let last = rows.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max).max(setup.time.end);
    let evenly =
        |from: f64, to: f64| (1..=TIMES).map(|i| from + (to - from) * i as f64 / TIMES as f64).collect::<Vec<f64>>();
    let further = |words: &str, coordinate: usize, values: Vec<f64>, rows: Rows| Further {
        words: words.into(),
        coordinate: COORDINATES[coordinate].name,
        values,
        rows,
    };
    let times = evenly(0.0, last);
    let ends = [0.0, length];
    let seen = |observable: usize| rows.observable.contains(&observable);
    let mut menu = Vec::new();
    // Without a row of an observable nothing tells its noise.
    if seen(TEMPERATURE_OF_ROW) {
        for (words, x) in [
            ("measure the temperature of the base as well", ends[0]),
            ("measure the temperature half way along as well", 0.5 * length),
            ("measure the temperature of the free end as well", ends[1]),
        ] {
            menu.push(further(words, X, vec![x], self::rows(setup, &times, &[Some(x)])));
        }
        let early = evenly(0.0, 0.1 * last);
        let places: Vec<Option<f64>> = ends.iter().copied().map(Some).collect();
        menu.push(further(
            "measure temperatures at both ends often in the first tenth of the run",
            TIME_OF_ROW,
            early.clone(),
            self::rows(setup, &early, &places),
        ));
    }
    let place = if seen(TEMPERATURE_OF_ROW) { Some(0.5 * length) } else { None };
    let places: Vec<Option<f64>> = [seen(ELONGATION).then_some(None), place.map(Some)].into_iter().flatten().collect();
    let after = evenly(last, 2.0 * last);
    menu.push(further(
        "go on measuring for as long again",
        TIME_OF_ROW,
        after.clone(),
        self::rows(setup, &after, &places),
    ));
    menu
}
