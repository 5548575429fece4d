//! A profile given by a follower's lift table: a file of radius over angle.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::chain::{Drawn, Segment};
use super::closed::Profile;
use super::curve::Curve;
use super::lift::Lift;
use crate::input::{Problem, Reader};
use crate::units::{ANGLE, Kind, LENGTH};

/// Largest table, bytes: more than a row per arc second.
const LARGEST: u64 = 50_000_000;
/// Rows of a table, at least.
const FEWEST: usize = 12;
/// Widest gap between rows, rad.
const WIDEST: f64 = TAU / 8.0;

/// Reads `table`, if the model has one; `Some(None)` where it makes no profile, with the problem noted.
pub fn read_table(t: &Reader) -> Option<Option<Drawn>> {
    let file = t.file("table", "a follower's lift: a CSV file with angle [deg] and radius [mm]", LARGEST);
    let about = "radius of the follower's roller, whose centre the table gives; 0 for a knife edge";
    let roller = t.quantity("roller", LENGTH, about).not_negative().or(0.0);
    if !t.has("table") {
        if t.has("roller") {
            t.problem("roller", "`roller` belongs to a lift table", "add table = \"lift.csv\", or leave it out");
        }
        return None;
    }
    let Some(file) = file else { return Some(None) };
    let name = file.path.display().to_string();
    let drawn =
        file.text().and_then(|source| rows(&source.text)).and_then(|(angles, radii)| drawn(angles, radii, roller));
    match drawn {
        Ok(drawn) => Some(Some(drawn)),
        Err(problem) => {
            t.problem("table", format!("{name}: {}", problem.message), problem.help.unwrap_or_default());
            Some(None)
        }
    }
}

fn drawn(angles: Vec<f64>, radii: Vec<f64>, roller: f64) -> Result<Drawn, Problem> {
    let count = angles.len();
    let lift = Arc::new(Lift::new(angles, radii, roller));
    for i in 0..lift.intervals() {
        for k in 0..4 {
            let place = lift.place(i, 0.25 * f64::from(k));
            if !(place.point.dot(&place.normal) > 0.0 && (1.0 + place.curvature * roller) > 0.0) {
                let message = format!("the curve of the table turns back near {:.2}", ANGLE.shown(lift.angle(i)));
                let help = match roller > 0.0 {
                    true => "the roller is too large for the curve there: its centre cannot run so",
                    false => "the profile must meet every direction from the axis once",
                };
                return Err(Problem::new(message).help(help));
            }
        }
    }
    let curves = (0..lift.intervals()).map(|i| (0, Curve::lift(&lift, i))).collect();
    let segments = vec![Segment { name: format!("lift table of {count} rows"), blocks: None }];
    Ok(Drawn { profile: Profile::new(curves, 1.0), segments })
}

/// Angles (rad) and radii (m) of a table.
fn rows(text: &str) -> Result<(Vec<f64>, Vec<f64>), Problem> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let unreadable = |e: csv::Error| Problem::new(format!("no CSV: {e}")).help("give every row one cell per column");
    let header = reader.headers().map_err(unreadable)?.clone();
    let column = |name: &'static str, kind: Kind| {
        let split = |cell: &str| {
            cell.split_once('[').map(|(n, u)| (n.trim().to_string(), u.trim_end_matches(']').trim().to_string()))
        };
        let found = header.iter().map(split).position(|c| c.is_some_and(|(n, _)| n == name));
        let help = format!("add a column {name} [{}]", kind.unit);
        let position = found.ok_or_else(|| Problem::new(format!("no column `{name} [unit]`")).help(help.clone()))?;
        let unit = split(&header[position]).map(|c| c.1).unwrap_or_default();
        let unit = kind.unit_of(&unit).map_err(|e| Problem::new(format!("`{name}`: {}", e.message)).help(help))?;
        Ok::<_, Problem>((position, unit.factor))
    };
    let (angle, radius) = (column("angle", ANGLE)?, column("radius", LENGTH)?);
    let (mut angles, mut radii): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for record in reader.records() {
        let record = record.map_err(unreadable)?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |(position, factor): (usize, f64)| {
            let cell = record.get(position).unwrap_or_default();
            let value = cell.parse::<f64>().ok().filter(|v| v.is_finite());
            let problem = || Problem::new(format!("line {line}: `{cell}` is no finite number")).help("write a number");
            value.map(|v| v * factor).ok_or_else(problem)
        };
        let (angle, radius) = (number(angle)?, number(radius)?);
        if radius <= 0.0 {
            return Err(
                Problem::new(format!("line {line}: the radius is not above zero")).help("it is from the cam's axis")
            );
        }
        if angles.last().is_some_and(|last| angle <= *last) {
            return Err(Problem::new(format!("line {line}: the angles do not rise")).help("sort the rows by angle"));
        }
        angles.push(angle);
        radii.push(radius);
    }
    close(&mut angles, &mut radii)?;
    Ok((angles, radii))
}

/// Drops a last row that repeats the first one turn on, and checks that the rows go round.
fn close(angles: &mut Vec<f64>, radii: &mut Vec<f64>) -> Result<(), Problem> {
    let few =
        || Problem::new(format!("{} rows are too few for a cam", angles.len())).help("give at least twelve all around");
    let (Some(first), Some(last)) = (angles.first().copied(), angles.last().copied()) else { return Err(few()) };
    if angles.len() < FEWEST {
        return Err(few());
    }
    if (last - first - TAU).abs() < 1e-9 {
        if (radii[0] - radii[radii.len() - 1]).abs() > 1e-9 {
            let problem = Problem::new("the first and the last row are one turn apart and differ in radius");
            return Err(problem.help("a cam is closed: give them the same radius"));
        }
        angles.pop();
        radii.pop();
    } else if last - first > TAU {
        return Err(Problem::new("the angles go round more than once").help("give one turn"));
    }
    let ahead = angles.iter().skip(1).copied().chain([angles[0] + TAU]);
    match angles.iter().zip(ahead).find(|(a, b)| b - **a > WIDEST) {
        None => Ok(()),
        Some((angle, next)) => {
            let (angle, next) = (ANGLE.from_si(*angle), ANGLE.shown(next));
            let problem = Problem::new(format!("nothing is known from {angle:.2} to {next:.2}"));
            Err(problem.help("give rows all around, 45 deg apart at most"))
        }
    }
}
