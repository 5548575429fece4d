//! Measurements of a heated body: how far its end has moved, temperatures at places, and how diameters have changed, over
//! time.

use super::revolved;
use super::setup::Setup;
use crate::process::{Absent, CandidateExperiment, Coordinate, Holds, Limit, Misplaced, Observable, Rows, Values};
use crate::units::{LENGTH, MICRO, TEMPERATURE, TIME};

/// Growth first, for it is what a workpiece feels.
pub const OBSERVABLES: &[Observable] = &[
    Observable::new("elongation", "the elongation", MICRO).sensed(),
    Observable::new("temperature", "temperatures", TEMPERATURE).sensed(),
    Observable::new("diameter", "diameters", MICRO).sensed(),
];

/// Positions in [`OBSERVABLES`].
pub const ELONGATION: usize = 0;
pub const TEMPERATURE_OF_ROW: usize = 1;
pub const DIAMETER: usize = 2;

/// Positions in [`COORDINATES`].
pub const TIME_OF_ROW: usize = 0;
pub const X: usize = 1;
pub const Y: usize = 2;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("time", "since the start of the run", Holds::Quantity(TIME), Absent::Refused),
    Coordinate::new(
        "x",
        "from the base, where a temperature or the change of a diameter is measured",
        Holds::Quantity(LENGTH),
        Absent::NeededBy(TEMPERATURE_OF_ROW, DIAMETER),
    ),
    Coordinate::new(
        "y",
        "height in a plane body, half way up if left out; radius in a body of revolution, its outside if left out",
        Holds::Quantity(LENGTH),
        Absent::ModelOf(TEMPERATURE_OF_ROW, DIAMETER),
    ),
];

/// Growth and temperatures that no body stands.
pub fn limit(setup: &Setup, observable: usize) -> Limit {
    /// Steel boils.
    const HOTTEST: f64 = 5000.0;
    let [from, to] = setup.body.extent();
    let (size, why) = match observable {
        ELONGATION => (to - from, "no body grows by its own length"),
        DIAMETER => {
            let largest = setup.body.plane().map_or(f64::INFINITY, |plane| 2.0 * plane.extent(1)[1]);
            (largest, "no body grows by its own diameter")
        }
        _ => (HOTTEST, "no body stands that"),
    };
    Limit { size, why, help: "check powers, fluxes and dimensions: a unit may be wrong" }
}

/// Rows before the start, or beside the body.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let plane = setup.body.plane();
    let outside = |row: usize, coordinate: usize, [low, high]: [f64; 2]| {
        let slack = 1e-9 * (high - low);
        let is_outside = rows.get(coordinate, row).is_some_and(|v| v < low - slack || v > high + slack);
        let message = || format!("the body reaches from {} to {}", LENGTH.from_si(low), LENGTH.format(high));
        is_outside.then(|| (coordinate, message()))
    };
    let known = setup.known_until();
    let wrong = |row: usize| {
        if rows.get(TIME_OF_ROW, row).is_some_and(|t| t < 0.0) {
            return Some((TIME_OF_ROW, "the time is before the start of the run".to_string()));
        }
        if rows.get(TIME_OF_ROW, row).is_some_and(|t| t > known * (1.0 + 1e-9)) {
            let message = format!("a record that the model names ends at {}", TIME.format(known));
            return Some((TIME_OF_ROW, message));
        }
        if rows.observable[row] == ELONGATION && !setup.body.has_ends() {
            let message = "the elongation is that from edge left to edge right, and the mesh does not name both";
            return Some((TIME_OF_ROW, message.into()));
        }
        if rows.observable[row] == DIAMETER && setup.body.revolved().is_none() {
            let message =
                format!("the change of a diameter is that of a body of revolution, not of {}", setup.body.name());
            return Some((X, message));
        }
        if let (DIAMETER, Some(walls), Some(y)) = (rows.observable[row], setup.body.revolved(), rows.get(Y, row)) {
            let [inner, outer] = revolved::radii_at(walls, rows.get(X, row).unwrap_or_default());
            let slack = 1e-9 * outer;
            if y > inner + slack && y < outer - slack {
                let [inner, outer, y] = [inner, outer, y].map(|radius| LENGTH.format(radius));
                let message =
                    format!("y = {y} is within the body, whose surfaces there have radii of {inner} and {outer}");
                return Some((Y, message));
            }
        }
        outside(row, X, setup.body.extent()).or_else(|| match plane {
            Some(plane) => outside(row, Y, plane.extent_at(rows.get(X, row).unwrap_or_default())),
            None => rows.get(Y, row).map(|_| (Y, "a rod is as warm above as below: it has no y".into())),
        })
    };
    let check = |row: usize| wrong(row).map(|(coordinate, message)| Misplaced { row, coordinate, message });
    (0..rows.len()).filter_map(check).collect()
}

/// The rows of an observable.
pub fn own(rows: &Rows, observable: usize) -> impl Iterator<Item = usize> {
    (0..rows.len()).filter(move |row| rows.observable[*row] == observable)
}

/// The model's own programme: at every time the elongation, then the temperatures from the base on, then diameters.
pub fn programme(setup: &Setup) -> Rows {
    let elongation = setup.body.has_ends().then_some(Seen::Elongation);
    let circles = setup.circles.iter().copied().map(Seen::Diameter);
    let warm = setup.places.iter().copied().map(Seen::Temperature);
    rows(setup, &setup.times, &elongation.into_iter().chain(warm).chain(circles).collect::<Vec<_>>())
}

/// What a row looks at.
#[derive(Clone, Copy)]
enum Seen {
    Elongation,
    /// Where, m from the base.
    Temperature(f64),
    /// Of a circle: distance from the left end, and radius, m.
    Diameter([f64; 2]),
}

impl Seen {
    fn observable(self) -> usize {
        match self {
            Self::Elongation => ELONGATION,
            Self::Temperature(_) => TEMPERATURE_OF_ROW,
            Self::Diameter(_) => DIAMETER,
        }
    }

    fn place(self) -> [f64; 2] {
        match self {
            Self::Elongation => [f64::NAN; 2],
            Self::Temperature(x) => [x, f64::NAN],
            Self::Diameter(circle) => circle,
        }
    }
}

/// What is seen, at every one of some times.
fn rows(setup: &Setup, times: &[f64], seen: &[Seen]) -> Rows {
    let all = || times.iter().flat_map(|t| seen.iter().map(move |own| (*t, *own)));
    let rows = Rows {
        columns: vec![
            all().map(|(t, _)| t).collect(),
            all().map(|(_, own)| own.place()[0]).collect(),
            all().map(|(_, own)| own.place()[1]).collect(),
        ],
        observable: all().map(|(_, own)| own.observable()).collect(),
    };
    resolved(setup, &rows)
}

/// Elongations at some times (s).
pub fn elongations(times: &[f64]) -> Rows {
    let nowhere = Values::shared(f64::NAN, times.len());
    Rows {
        columns: vec![times.to_vec().into(), nowhere.clone(), nowhere],
        observable: Values::shared(ELONGATION, times.len()),
    }
}

/// Temperatures at some places (x and y in m; a rod has no y) at a time (s).
pub fn temperatures(places: &[[f64; 2]], time: f64) -> Rows {
    let along = |axis: usize| places.iter().map(|place| place[axis]).collect();
    Rows {
        columns: vec![Values::shared(time, places.len()), along(0), along(1)],
        observable: Values::shared(TEMPERATURE_OF_ROW, places.len()),
    }
}

/// Changes of the diameter of a circle (x and radius in m) at some times (s).
pub fn of_circle([x, radius]: [f64; 2], times: &[f64]) -> Rows {
    let everywhere = |value: f64| Values::shared(value, times.len());
    Rows {
        columns: vec![times.to_vec().into(), everywhere(x), everywhere(radius)],
        observable: Values::shared(DIAMETER, times.len()),
    }
}

/// Changes of the diameters of some circles (x and radius in m) at a time (s).
pub fn diameters(circles: &[[f64; 2]], time: f64) -> Rows {
    Rows { observable: Values::shared(DIAMETER, circles.len()), ..temperatures(circles, time) }
}

/// Temperatures half way up, or on the outside, where no height is said; and diameters of the outside.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut resolved = rows.clone();
    if let Some(plane) = setup.body.plane() {
        for row in (0..rows.len()).filter(|row| rows.observable[*row] != ELONGATION) {
            if rows.columns[Y][row].is_nan() {
                resolved.columns[Y].set(row, plane.usual_y(rows.columns[X][row]));
            }
        }
    }
    resolved
}

/// Further experiments: temperatures at other places, the elongation, the time after the heat is off, and
/// more often early on.
pub fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
    /// New rows along time.
    const TIMES: usize = 40;
    let length = setup.body.length();
    let last = rows.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max).max(setup.time.end);
    let evenly =
        |from: f64, to: f64| (1..=TIMES).map(|i| from + (to - from) * i as f64 / TIMES as f64).collect::<Vec<f64>>();
    let experiment = |words: &str, coordinate: usize, values: &[f64], rows: Rows| {
        CandidateExperiment::new(words, &COORDINATES[coordinate], values, rows)
    };
    let seen = |observable: usize| rows.observable.contains(&observable);
    let mut experiments = Vec::new();
    // Without a row of an observable nothing tells its noise.
    if seen(TEMPERATURE_OF_ROW) {
        for (words, x) in [
            ("measure the temperature of the base as well", 0.0),
            ("measure the temperature half way along as well", 0.5 * length),
            ("measure the temperature of the free end as well", length),
        ] {
            experiments.push(experiment(
                words,
                X,
                &[x],
                self::rows(setup, &evenly(0.0, last), &[Seen::Temperature(x)]),
            ));
        }
        let words = "measure temperatures at both ends often in the first tenth of the run";
        let early = evenly(0.0, 0.1 * last);
        let both = [Seen::Temperature(0.0), Seen::Temperature(length)];
        experiments.push(experiment(words, TIME_OF_ROW, &early, self::rows(setup, &early, &both)));
    }
    let half_way = seen(TEMPERATURE_OF_ROW).then_some(Seen::Temperature(0.5 * length));
    let elongation = seen(ELONGATION).then_some(Seen::Elongation);
    let circles = setup.circles.iter().copied().map(Seen::Diameter).filter(|_| seen(DIAMETER));
    let places: Vec<Seen> = elongation.into_iter().chain(half_way).chain(circles).collect();
    // What is not recorded yet cannot be predicted.
    if 2.0 * last <= setup.known_until() {
        let after = evenly(last, 2.0 * last);
        let words = "go on measuring for as long again";
        experiments.push(experiment(words, TIME_OF_ROW, &after, self::rows(setup, &after, &places)));
    }
    experiments
}
