//! The log of a batch: a file with a line for each event, in place of the lists in `[batch]` or beside them.
//!
//! ```text
//! part,event,value            time [min],event,value
//! 4,pause,30 min              31,pause,30 min
//! 6,correction,-10 um         74,correction,-10 um
//! 8,insert,                   90,insert,3 um
//! ```
//!
//! An event stands after the part of its line, or at a time since the batch began, pauses included: then it comes
//! after the part that was in work.

use super::events::{Correction, Event, Events, InsertChange, Pause};
use crate::input::{ListedRow, Listing, Problem, Reader, did_you_mean, name_and_unit, number};
use crate::units::{Kind, Knowledge, MICRO, Quantity, TIME, Unit};

const WORDS: [&str; 3] = ["pause", "correction", "insert"];

/// Reads the log that `[batch]` names, if it names one, into the events.
pub fn read(t: &Reader, parts: usize, cycle: f64, events: &mut Events) {
    let Some(listing) = t.listing("log", "a file of the events, columns part or time, event, value") else { return };
    let columns = match Columns::of(&listing) {
        Ok(columns) => columns,
        Err(problem) => {
            let message = format!("{}: {}", listing.path.display(), problem.message);
            return t.problem("log", message, problem.help.unwrap_or_default());
        }
    };
    for row in &listing.rows {
        let event = columns.event(row, parts, cycle, events).and_then(|event| events.add(event));
        if let Err(problem) = event {
            t.problem_on_line("log", &listing, row.line, &problem);
        }
    }
}

/// When a line says that its event was.
enum When {
    /// After a part, by the position of the column.
    Part(usize),
    /// At a time, by the position of the column and its unit.
    Time(usize, Unit),
}

/// The columns of a log, by their positions.
struct Columns {
    when: When,
    event: usize,
    value: Option<usize>,
}

impl Columns {
    fn of(listing: &Listing) -> Result<Self, Problem> {
        let cells: Vec<(&str, &str)> = listing.header.iter().map(|cell| name_and_unit(cell)).collect();
        let known = ["part", "time", "event", "value"];
        if let Some((name, _)) = cells.iter().find(|(name, _)| !known.contains(name)) {
            let help = format!("{}its columns are part or time, event, value", did_you_mean(name, known, '`'));
            return Err(Problem::new(format!("`{name}` is no column of a log")).help(help));
        }
        let find = |wanted: &str| cells.iter().position(|(name, _)| *name == wanted);
        if let Some(twice) = known.iter().find(|name| cells.iter().filter(|(own, _)| own == *name).count() > 1) {
            return Err(Problem::new(format!("the column `{twice}` stands twice")).help("keep one of them"));
        }
        let when = match (find("part"), find("time")) {
            (Some(part), None) => When::Part(part),
            (None, Some(time)) => When::Time(time, unit_of_time(cells[time].1)?),
            (Some(_), Some(_)) => {
                let help = "keep the column `part` or the column `time`";
                return Err(Problem::new("the log tells part and time of every event").help(help));
            }
            (None, None) => {
                let help = "add a column `part`, after which each event was, or `time [min]` since the batch began";
                return Err(Problem::new("the log does not tell when its events were").help(help));
            }
        };
        let Some(event) = find("event") else {
            let help = format!("add a column `event` with the words {}", WORDS.join(", "));
            return Err(Problem::new("there is no column `event`").help(help));
        };
        let value = find("value");
        if let Some((_, unit)) = value.map(|i| cells[i]).filter(|(_, unit)| !unit.is_empty()) {
            let help =
                format!("write the unit behind each number, as in 10 {unit}: events differ in what they measure");
            return Err(Problem::new("the column `value` has a unit in the header").help(help));
        }
        Ok(Self { when, event, value })
    }

    /// The event of a line, among those that are known already.
    fn event(&self, row: &ListedRow, parts: usize, cycle: f64, events: &Events) -> Result<Event, Problem> {
        let after = self.after(row, parts, cycle, events)?;
        let word = row.cells[self.event].as_str();
        let value = self.value.map(|i| row.cells[i].as_str()).filter(|cell| !cell.is_empty());
        let of = |kind, example: &str| {
            let missing = || Problem::new(format!("`{word}` needs a value")).help(format!("write it as in {example}"));
            quantity(value.ok_or_else(missing)?, kind)
        };
        match word {
            "pause" => match of(TIME, "30 min")? {
                duration if duration > 0.0 => Ok(Event::Pause(Pause { after, duration })),
                _ => Err(Problem::new("a pause lasts no time").help("its value must be above zero")),
            },
            "correction" => Ok(Event::Correction(Correction { after, diameter: of(MICRO, "-10 um")? })),
            "insert" => {
                let diameter = value.map_or(Ok(0.0), |cell| quantity(cell, MICRO))?;
                Ok(Event::Insert(InsertChange { after, diameter }))
            }
            _ => {
                let help = format!("{}events are {}", did_you_mean(word, WORDS, '`'), WORDS.join(", "));
                Err(Problem::new(format!("`{word}` is no event")).help(help))
            }
        }
    }

    /// The part after which the event of a line stands.
    fn after(&self, row: &ListedRow, parts: usize, cycle: f64, events: &Events) -> Result<usize, Problem> {
        match self.when {
            When::Part(column) => {
                let cell = &row.cells[column];
                let part = cell.parse().ok().filter(|part| (1..=parts).contains(part));
                let help = || format!("it must be a whole number from 1 to {parts}");
                part.ok_or_else(|| Problem::new(format!("`part` is {cell}")).help(help()))
            }
            When::Time(column, unit) => {
                let time = number(&row.cells[column], "time")? * unit.factor + unit.offset;
                after_time(time, parts, cycle, &events.pauses)
            }
        }
    }
}

/// The part that was in work at a time (s), by the pauses that are known. While the cycle is unknown nothing can be said:
/// the first.
fn after_time(time: f64, parts: usize, cycle: f64, pauses: &[Pause]) -> Result<usize, Problem> {
    if !cycle.is_finite() {
        return Ok(1);
    }
    let rested = |part: usize| pauses.iter().filter(|p| p.after < part).map(|p| p.duration).sum::<f64>();
    let begins = |part: usize| (part - 1) as f64 * cycle + rested(part);
    // Times in other units are the same but for rounding.
    let slack = 1e-9 * cycle;
    let end = begins(parts + 1);
    if time < -slack || time > end + slack {
        let message = format!("the event is at {}", TIME.format(time));
        return Err(Problem::new(message).help(format!("the batch is from 0 to {}", TIME.format(end))));
    }
    Ok((1..=parts).take_while(|part| begins(*part) <= time + slack).count().max(1))
}

fn unit_of_time(unit: &str) -> Result<Unit, Problem> {
    TIME.unit_of(unit)
        .map_err(|e| Problem::new(format!("`time`: {}", e.message)).help("write time [min] in its header"))
}

/// A value that is known. A log tells what was done; what is only roughly known stands in the model.
fn quantity(cell: &str, kind: Kind) -> Result<f64, Problem> {
    let read = Quantity::parse(cell, &kind);
    let quantity = read.map_err(|e| Problem::new(e.message).help(e.hint.unwrap_or_default()))?;
    match quantity.knowledge {
        Knowledge::Known => Ok(quantity.value),
        _ => {
            let help = "write it in the list of [batch], and leave the line out";
            Err(Problem::new(format!("`{cell}` is not known exactly")).help(help))
        }
    }
}
