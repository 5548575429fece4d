//! Q-DAS ASCII transfer format, `.dfq`, by its K-fields [AQDEF as read by the public libraries aqdef-tools and aqdefreader,
//! and their samples].
//!
//! Lines `Kdddd/i value` describe part (K1...) and characteristic i (K2...): K0100 is how many characteristics there
//! are, K2001 and K2002 number and name of one, K2142 its unit, K2004 its kind (1, 5 and 6 are counts of faults). A measured value is
//! K0001/i, with K0002/i its attribute (255 and 256 mark one that does not hold) and K0004/i its date and time; or a
//! line holds the values of all characteristics, parted by the character 15, each of fields parted by the character 20:
//! value, attribute, date and time, and more. An index 0 means all characteristics.
//!
//! Every characteristic becomes a column, every set of values a row.

use super::lines::{Instrument, Line, lines, sheet};
use crate::input::{Problem, Source};
use crate::measure::moment::Moment;
use crate::measure::records::Records;
use crate::measure::sheet::Sheet;

pub const QDAS: Instrument =
    Instrument { is_one: |text| text.lines().next().is_some_and(|line| line.starts_with("K0100 ")), read };

/// Parts the characteristics in a line of values, and the fields of a characteristic.
const PARTS: [char; 2] = ['\u{f}', '\u{14}'];

/// Most characteristics that are read.
const MOST: usize = 900;

/// A measured value as it is written.
#[derive(Clone, Default)]
struct Value {
    value: String,
    is_valid: bool,
    time: Option<String>,
}

/// A characteristic.
#[derive(Clone, Default)]
struct Characteristic {
    number: String,
    name: String,
    unit: String,
    kind: String,
    is_described: bool,
    values: Vec<(Value, std::ops::Range<usize>)>,
}

fn read(source: &Source) -> Result<Sheet, Problem> {
    let mut file = File::default();
    for line in lines(&source.text).filter(|line| !line.says.is_empty()) {
        file.take(&line)?;
    }
    file.sheet(source)
}

#[derive(Default)]
struct File {
    /// Line of K0100, and how many characteristics it says.
    said: Option<(std::ops::Range<usize>, usize)>,
    characteristics: Vec<Characteristic>,
    /// Fields of index 0, which hold for all characteristics.
    common: Characteristic,
}

impl File {
    fn take(&mut self, line: &Line) -> Result<(), Problem> {
        match field(line)? {
            Some((key, index, value)) => self.field(line, key, index, value),
            None => self.values(line),
        }
    }

    /// Takes a K-field.
    fn field(&mut self, line: &Line, key: u32, index: Option<usize>, value: &str) -> Result<(), Problem> {
        match (key, index) {
            (100, _) => {
                let count = value.parse().ok().filter(|count| (1..=MOST).contains(count));
                let help = format!("it is how many characteristics there are, from 1 to {MOST}");
                let count = count.ok_or_else(|| line.problem(format!("K0100 is `{value}`"), &help))?;
                self.said = Some((line.place.clone(), count));
            }
            (1, Some(index)) if index > 0 => {
                let own = self.at(line, index)?;
                let value = Value { value: value.into(), is_valid: true, time: None };
                own.values.push((value, line.place.clone()));
            }
            (2 | 4, Some(index)) => {
                let all = self.characteristics.iter_mut().enumerate();
                let mut own = all.filter(|(i, _)| index == 0 || i + 1 == index).map(|(_, c)| c);
                for value_of in own.by_ref().filter_map(|c| c.values.last_mut()) {
                    match key {
                        2 => value_of.0.is_valid = is_valid(value),
                        _ => value_of.0.time = Some(moment(line, value)?),
                    }
                }
            }
            (2000..3000, Some(index)) => {
                let own = if index == 0 { &mut self.common } else { self.at(line, index)? };
                own.is_described = true;
                match key {
                    2001 => own.number = value.into(),
                    2002 => own.name = value.into(),
                    2004 => own.kind = value.into(),
                    2142 => own.unit = value.into(),
                    _ => {}
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Takes a line of the values of all characteristics.
    fn values(&mut self, line: &Line) -> Result<(), Problem> {
        for (portion, index) in line.says.split(PARTS[0]).zip(1..) {
            if index > self.characteristics.len() {
                let message = format!("the line has a value for characteristic {index}, which is not described");
                return Err(line.problem(message, "is K0100 with the K2... fields of every characteristic above?"));
            }
            let mut fields = portion.split(PARTS[1]).map(str::trim);
            let value = fields.next().unwrap_or_default().to_string();
            let attribute = fields.next().unwrap_or_default();
            let time = fields.next().filter(|field| !field.is_empty());
            let own = &mut self.characteristics[index - 1];
            if own.counts(&self.common) {
                continue;
            }
            let time = time.map(|field| moment(line, field)).transpose()?;
            own.values.push((Value { value, is_valid: is_valid(attribute), time }, line.place.clone()));
        }
        Ok(())
    }

    /// The characteristic of an index.
    fn at(&mut self, line: &Line, index: usize) -> Result<&mut Characteristic, Problem> {
        if index > MOST {
            let help = format!("at most {MOST} characteristics are read");
            return Err(line.problem(format!("there is no characteristic {index}"), &help));
        }
        if self.characteristics.len() < index {
            self.characteristics.resize_with(index, Characteristic::default);
        }
        Ok(&mut self.characteristics[index - 1])
    }

    fn sheet(self, source: &Source) -> Result<Sheet, Problem> {
        let (place, said) = self.said.unwrap_or_default();
        let found = self.characteristics.len();
        if found != said || self.characteristics.iter().any(|c| !c.is_described && c.values.is_empty()) {
            let message = format!("K0100 says {said} characteristics, and {found} are described");
            return Err(Problem::new(message).help("has the file been cut off?").at(Some(place)));
        }
        let (counts, measured): (Vec<_>, Vec<_>) =
            self.characteristics.iter().partition(|c| c.counts(&self.common) || c.values.is_empty());
        let sets = measured.iter().map(|c| c.values.len()).max().unwrap_or(0);
        let of = |set: usize| measured.iter().filter_map(move |c| c.values.get(set));
        let is_timed = sets > 0 && (0..sets).all(|set| of(set).any(|(value, ..)| value.time.is_some()));
        let mut header = vec!["part".to_string()];
        header.extend(is_timed.then(|| "time".to_string()));
        for c in &measured {
            header.push(c.heading(&self.common, &header));
        }
        let mut records = Records::written(source.text.clone(), header.len());
        for set in 0..sets {
            let mut cells = vec![(set + 1).to_string()];
            cells.extend(is_timed.then(|| of(set).find_map(|(v, ..)| v.time.clone()).unwrap_or_default()));
            let value = |c: &&Characteristic| match c.values.get(set) {
                Some((value, ..)) if value.is_valid => value.value.clone(),
                _ => String::new(),
            };
            cells.extend(measured.iter().map(value));
            let place = of(set).next().map_or(0, |(_, place)| place.start);
            records.push_written(place, cells);
        }
        let invalid = measured.iter().flat_map(|c| &c.values).filter(|(value, ..)| !value.is_valid).count();
        let mut told = vec![format!(
            "K-fields with {sets} sets of values, a row for each, of characteristics: {}",
            measured.len()
        )];
        let count = |count: usize, what: &str| (count > 0).then(|| format!("{what}, which are left out: {count}"));
        told.extend(count(invalid, "values marked as not holding (K0002)"));
        told.extend(count(counts.len(), "characteristics of counted faults, or without values"));
        Ok(sheet(header, place, records, told))
    }
}

impl Characteristic {
    /// Whether faults are counted, and nothing is measured.
    fn counts(&self, common: &Self) -> bool {
        let kind = if self.kind.is_empty() { &common.kind } else { &self.kind };
        matches!(kind.as_str(), "1" | "5" | "6")
    }

    /// Its heading, which differs from those of the others.
    fn heading(&self, common: &Self, others: &[String]) -> String {
        let number = if self.number.is_empty() { (others.len()).to_string() } else { self.number.clone() };
        let name = if self.name.is_empty() { format!("characteristic {number}") } else { self.name.clone() };
        let unit = if self.unit.is_empty() { &common.unit } else { &self.unit };
        let heading = |name: &str| if unit.is_empty() { name.to_string() } else { format!("{name} [{unit}]") };
        match others.contains(&heading(&name)) {
            true => heading(&format!("{name} no. {number}")),
            false => heading(&name),
        }
    }
}

/// A K-field: number, index and value.
type Field<'a> = (u32, Option<usize>, &'a str);

/// The K-field of a line; `None` where it is none.
fn field<'a>(line: &Line<'a>) -> Result<Option<Field<'a>>, Problem> {
    let Some(rest) = line.says.strip_prefix('K') else { return Ok(None) };
    let (key, value) = rest.split_once(' ').unwrap_or((rest, ""));
    let mut parts = key.split('/');
    let number = parts.next().and_then(|digits| digits.parse().ok());
    let index: Option<Result<usize, _>> = parts.next().map(str::parse);
    match (number, index.transpose()) {
        (Some(number), Ok(index)) => Ok(Some((number, index, value.trim()))),
        _ => {
            let message = format!("`K{}` is no K-field", key.chars().take(20).collect::<String>());
            Err(line.problem(message, "it is K with four digits, perhaps a slash and a number: K0001/2"))
        }
    }
}

/// Whether a value with an attribute holds.
fn is_valid(attribute: &str) -> bool {
    !matches!(attribute, "255" | "256")
}

/// A date and time `31.12.2024/23:59:59` in the form of ISO 8601.
fn moment(line: &Line, written: &str) -> Result<String, Problem> {
    let parts = || {
        let (date, time) = written.split_once('/')?;
        let [day, month, year] = <[u32; 3]>::try_from(numbers(date, '.')?).ok()?;
        let time = numbers(time, ':')?;
        let &[hour, minute, ref rest @ ..] = &time[..] else { return None };
        let second = *rest.first().unwrap_or(&0);
        Some(format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}"))
    };
    let short: String = written.chars().take(40).collect();
    parts()
        .filter(|iso| Moment::parse(iso).is_some())
        .ok_or_else(|| line.problem(format!("`{short}` is no date and time"), "write 31.12.2024/23:59:59"))
}

fn numbers(text: &str, part: char) -> Option<Vec<u32>> {
    text.split(part).map(|digits| digits.parse().ok()).collect()
}
