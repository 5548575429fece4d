//! A report of a positioning test by ISO 230-2 as text with tables in Markdown, as the test programs of motion
//! controllers at laboratories write it [ecmccfg and ecmc_target_muts_logger: "ecmc motion system test report"].
//!
//! Under a heading with "forward" and one with "backward" stands a table: a number, the target `tgt_pos(i) [mm]`, and
//! the position that was reached in each cycle, `ref_pos(i,1) [mm]` and on. "Position count" and "Cycle count" say
//! how many there are. Deviations and quantities of the standard, which stand below, are computed again.

use super::lines::{Instrument, Line, lines, sheet};
use crate::input::{Problem, Source, name_and_unit};
use crate::measure::records::Records;
use crate::measure::sheet::Sheet;

pub const REPORT: Instrument = Instrument { is_one, read };

/// Most cycles of a test.
const MOST_CYCLES: usize = 1000;

fn is_one(text: &str) -> bool {
    let is_heading = |line: &str| line.starts_with('#') && line.to_uppercase().contains("ISO 230-2");
    text.lines().any(is_heading) && text.lines().any(|line| is_table(line.trim()))
}

/// Whether a line is the header of a table of targets and what was reached.
fn is_table(line: &str) -> bool {
    let names: Vec<&str> = cells(line).map(|cell| name_and_unit(cell).0).collect();
    matches!(&names[..], [_, target, first, ..] if is_target(target) && first.starts_with("ref_pos("))
}

fn is_target(name: &str) -> bool {
    name.starts_with("tgt_pos(")
}

/// Cells between bars; a bar at either end parts nothing.
fn cells(line: &str) -> impl Iterator<Item = &str> {
    let inner = line.strip_prefix('|').unwrap_or(line);
    inner.strip_suffix('|').unwrap_or(inner).split('|').map(str::trim)
}

/// Extent of the table of one direction.
#[derive(Default)]
struct Table {
    cycles: usize,
    targets: usize,
}

fn read(source: &Source) -> Result<Sheet, Problem> {
    let mut all = lines(&source.text).peekable();
    let mut direction = None;
    let mut said = [None; 2];
    let (mut tables, mut units, mut place) = ([None, None], None, 0..0);
    let mut records = Records::written(source.text.clone(), 4);
    while let Some(line) = all.next() {
        if line.says.starts_with('#') {
            direction = direction_of(line.says);
            continue;
        }
        for (count, key) in said.iter_mut().zip(["Position count", "Cycle count"]) {
            if let Some(value) = line.says.strip_prefix(key).and_then(|rest| cells(rest.trim_start()).next()) {
                *count = value.split_whitespace().next().and_then(|word| word.parse::<usize>().ok());
            }
        }
        if !is_table(line.says) {
            continue;
        }
        let Some(way) = direction else {
            return Err(line.problem(
                "a table of targets stands under no direction".into(),
                "put it under a heading with `forward` or `backward`",
            ));
        };
        if tables[way].is_some() {
            let word = WAYS[way];
            return Err(line.problem(format!("a second table of the way {word}"), "keep one report in a file"));
        }
        let own = units_of(&line)?;
        if units.get_or_insert_with(|| own.clone()) != &own {
            return Err(line.problem("the tables are in different units".into(), "write both in one unit"));
        }
        if place.is_empty() {
            place = line.place.clone();
        }
        let width = cells(line.says).count();
        let mut table = Table { cycles: width - 2, targets: 0 };
        while let Some(record) = all.next_if(|next| next.says.contains('|')) {
            if record.says.chars().all(|c| matches!(c, '-' | '|' | ':' | ' ')) {
                continue;
            }
            take(&record, width, way, &mut records)?;
            table.targets += 1;
        }
        check(&line, &table, said)?;
        tables[way] = Some(table);
    }
    let [target, reached] = units.unwrap_or_default();
    let mut told = vec!["targets and the positions reached from a report by ISO 230-2".to_string()];
    told.push("its deviations and quantities are computed again".into());
    told.extend(WAYS.iter().zip(&tables).filter(|(_, t)| t.is_none()).map(|(word, _)| format!("no table {word}")));
    let header = ["run", &format!("position [{target}]"), "direction", &format!("actual_position [{reached}]")];
    Ok(sheet(header.map(str::to_string).into(), place, records, told))
}

/// The two ways, as reports name them.
const WAYS: [&str; 2] = ["forward", "backward"];

fn direction_of(heading: &str) -> Option<usize> {
    let heading = heading.to_lowercase();
    WAYS.iter().position(|way| heading.contains(way))
}

/// Units of the targets and of what was reached.
fn units_of(header: &Line) -> Result<[String; 2], Problem> {
    let mut units = cells(header.says).skip(1).map(|cell| name_and_unit(cell).1.to_string());
    let target = units.next().unwrap_or_default();
    let reached: Vec<String> = units.collect();
    let first = reached.first().cloned().unwrap_or_default();
    if target.is_empty() || first.is_empty() || reached.iter().any(|unit| *unit != first) {
        let help = "write tgt_pos(i) [mm] and ref_pos(i,1) [mm] and on, all of these in one unit";
        return Err(header.problem("the columns have no unit, or different ones".into(), help));
    }
    if reached.len() > MOST_CYCLES {
        let message = format!("{} cycles are more than the {MOST_CYCLES} that are read", reached.len());
        return Err(header.problem(message, "is it a report of a positioning test?"));
    }
    Ok([target, first])
}

/// Takes a row of the table: a record of the sheet for each cycle.
fn take(record: &Line, width: usize, way: usize, records: &mut Records) -> Result<(), Problem> {
    let own: Vec<&str> = cells(record.says).collect();
    if own.len() != width {
        let message = format!("the row has {} cells, and the header {width}", own.len());
        return Err(record.problem(message, "has the file been cut off? give every row a cell for each column"));
    }
    let direction = ["+", "-"][way];
    for (reached, run) in own[2..].iter().zip(1_usize..) {
        records.push_written(record.place.start, [&*run.to_string(), own[1], direction, reached]);
    }
    Ok(())
}

/// Refuses a table that has other counts than the report says.
fn check(header: &Line, table: &Table, said: [Option<usize>; 2]) -> Result<(), Problem> {
    let found = [(table.targets, "targets"), (table.cycles, "cycles")];
    for ((count, what), said) in found.into_iter().zip(said) {
        if said.is_some_and(|said| said != count) || count == 0 {
            let said = said.map_or("a table has some".to_string(), |said| format!("the report says {said}"));
            let message = format!("the table has {count} {what}, and {said}");
            return Err(header.problem(message, "has the file been cut off?"));
        }
    }
    Ok(())
}
