//! Changes to models, measurement files and meshes: by what stands in them, and by bytes.

use super::rng::Rng;

/// Numbers at which programs fail.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e-9",
    "1e9",
    "-1e9",
    "1e-30",
    "1e30",
    "1e39",
    "1e-300",
    "1e300",
    "1e400",
    "nan",
    "inf",
    "",
    "1e",
    "0x10",
    "1_000",
    "7.",
    "00012",
    "9007199254740993",
    "18446744073709551616",
    "-9223372036854775808",
];

const UNITS: &[&str] = &[
    "m", "mm", "um", "nm", "km", "N", "kN", "MN", "N/um", "N/m", "kN*m/rad", "rpm", "rad", "deg", "s", "min", "h",
    "Hz", "K", "degC", "W", "kW", "W/m^2/K", "/K", "um/km", "um/m", "mm/rev", "mm/min", "um/N^n", "GPa", "kg/m^3", "",
    "?", "%",
];

/// A model changed in up to three places.
pub fn model(text: &str, rng: &mut Rng) -> String {
    let mut text = text.to_string();
    for _ in 0..=rng.below(3) {
        text = one_of_model(&text, rng);
    }
    text
}

fn one_of_model(text: &str, rng: &mut Rng) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    let quoted: Vec<(usize, usize, usize)> = quoted(&lines);
    match rng.below(14) {
        // Most changes are to what is quoted: quantities.
        0..=7 if !quoted.is_empty() => {
            let (line, from, to) = quoted[rng.below(quoted.len())];
            let new = quantity(&lines[line][from..to], rng);
            lines[line].replace_range(from..to, &new);
        }
        8 | 9 => {
            // Bare numbers: counts, exponents, forces by formula.
            let bare: Vec<usize> = (0..lines.len()).filter(|i| bare(&lines[*i]).is_some()).collect();
            if let Some(line) = (!bare.is_empty()).then(|| bare[rng.below(bare.len())])
                && let Some(at) = self::bare(&lines[line])
            {
                let new = match rng.below(4) {
                    0 => "\"?\"".to_string(),
                    1 => rng.below(100_000).to_string(),
                    _ => rng.pick(NUMBERS).to_string(),
                };
                lines[line].replace_range(at.0..at.1, &new);
            }
        }
        10 if !lines.is_empty() => drop(lines.remove(rng.below(lines.len()))),
        11 if !lines.is_empty() => {
            let line = lines[rng.below(lines.len())].clone();
            lines.insert(rng.below(lines.len() + 1), line);
        }
        12 if lines.len() > 1 => {
            let (a, b) = (rng.below(lines.len()), rng.below(lines.len()));
            lines.swap(a, b);
        }
        _ => {
            let (name, body) = EFFECTS[rng.below(EFFECTS.len())];
            lines.push(format!("[effects.{name}]"));
            lines.extend(body.iter().map(|l| (*l).to_string()));
        }
    }
    lines.join("\n") + "\n"
}

/// Effects that any model may be given, whether they fit it or not.
const EFFECTS: &[(&str, &[&str])] = &[
    ("mine", &["formula = \"a*x/(x - b)\"", "a = \"? um\"", "b = \"100 mm\""]),
    ("mine", &["formula = \"a*sqrt(part - 3)\"", "a = \"3 um\""]),
    ("mine", &["formula = \"a*exp(x/b)\"", "a = \"? um\"", "b = \"? mm\""]),
    ("carriage-compliance", &["stiffness = \"? N/um\""]),
    ("tool-wear", &["rate = \"? um/km\""]),
    ("backlash", &["gap = \"? um\""]),
    ("ambient-drift", &["amplitude = \"? K\"", "period = \"? h\"", "phase = \"? deg\""]),
    ("clamp-force", &["force = \"? N\""]),
];

/// Text between quotes: line and bytes.
fn quoted(lines: &[String]) -> Vec<(usize, usize, usize)> {
    let mut found = Vec::new();
    for (number, line) in lines.iter().enumerate() {
        let marks: Vec<usize> = line.match_indices('"').map(|(i, _)| i).collect();
        found.extend(marks.chunks_exact(2).map(|pair| (number, pair[0] + 1, pair[1])));
    }
    found
}

/// A bare number behind an equals sign: bytes.
fn bare(line: &str) -> Option<(usize, usize)> {
    let from = line.find('=')? + 1;
    let from = from + line[from..].len() - line[from..].trim_start().len();
    let length = line[from..].find(|c: char| !(c.is_ascii_digit() || ".-+e_".contains(c))).unwrap_or(line.len() - from);
    (length > 0).then_some((from, from + length))
}

/// Another quantity in the place of one.
fn quantity(written: &str, rng: &mut Rng) -> String {
    let (number, unit) = written.trim().split_once(' ').unwrap_or((written, ""));
    let value: f64 = number.parse().unwrap_or(1.0);
    match rng.below(10) {
        0 => format!("? {unit}"),
        1 => format!("? near {number} {unit}"),
        2 => format!("? near {} {unit}", value * 1.15),
        3 => format!("{number} +- {} {unit}", value.abs() * 0.2 + 1e-9),
        4 => format!("-{number} {unit}"),
        5 => format!("{number} {}", rng.pick(UNITS)),
        6 => format!("{} {unit}", rng.pick(NUMBERS)),
        7 => format!("{} {unit}", value * 10f64.powi(rng.below(13) as i32 - 6)),
        8 => format!("{} {unit}", value * (0.25 + 0.5 * rng.below(6) as f64)),
        _ => [written, written].concat(),
    }
}

/// A table of measurements changed in up to three places.
pub fn table(text: &str, rng: &mut Rng) -> String {
    let mut text = text.to_string();
    for _ in 0..=rng.below(3) {
        text = one_of_table(&text, rng);
    }
    text
}

fn one_of_table(text: &str, rng: &mut Rng) -> String {
    let is_row = |line: &&str| !line.starts_with('#') && !line.trim().is_empty();
    let mut cells: Vec<Vec<String>> =
        text.lines().filter(is_row).map(|line| line.split(',').map(str::to_string).collect()).collect();
    let (rows, columns) = (cells.len(), cells.first().map_or(0, Vec::len));
    if rows < 2 || columns == 0 {
        return text.to_string();
    }
    let (row, column) = (1 + rng.below(rows - 1), rng.below(columns));
    let factor = [-1.0, 1e-3, 1e3, 1e6, 1e-6, 0.0, 1e20, 1e-20][rng.below(8)];
    let mut each = |change: &mut dyn FnMut(&mut String)| {
        cells[1..].iter_mut().filter_map(|row| row.get_mut(column)).for_each(change);
    };
    match rng.below(17) {
        0 | 1 => each(&mut |cell| {
            if let Ok(value) = cell.trim().parse::<f64>() {
                *cell = (value * factor).to_string();
            }
        }),
        2 => each(&mut String::clear),
        3 => {
            let new = rng.pick(NUMBERS).to_string();
            each(&mut |cell| cell.clone_from(&new));
        }
        4 => each(&mut |cell| {
            if let Ok(value) = cell.trim().parse::<f64>() {
                *cell = value.round().to_string();
            }
        }),
        5 => {
            let new = rng.pick(NUMBERS).to_string();
            if let Some(cell) = cells[row].get_mut(column) {
                *cell = new;
            }
        }
        6 => {
            cells.iter_mut().filter(|row| row.len() > column).for_each(|row| drop(row.remove(column)));
        }
        7 => {
            cells.truncate(1 + rng.below(rows));
        }
        8 => {
            let copies: Vec<_> = (0..1 + rng.below(4)).flat_map(|_| cells[1..].to_vec()).collect();
            cells.extend(copies);
        }
        9 => {
            let name = cells[0][column].split('[').next().unwrap_or_default().trim().to_string();
            cells[0][column] = format!("{name} [{}]", rng.pick(UNITS));
        }
        10 => {
            let other = rng.below(columns);
            let (a, b) = (cells[0][column].clone(), cells[0][other].clone());
            (cells[0][column], cells[0][other]) = (b, a);
        }
        11 => {
            for i in (2..rows).rev() {
                cells.swap(i, 1 + rng.below(i));
            }
        }
        12 => {
            let column =
                rng.pick(&["u [um]", "time [s]", "part", "run", "direction", "temperature [degC]", "x [mm]", "u [K]"]);
            let values = [rng.pick(NUMBERS), rng.pick(NUMBERS)];
            cells[0].push(column.to_string());
            cells[1..].iter_mut().enumerate().for_each(|(i, row)| row.push(values[i % 2].to_string()));
        }
        13 => {
            let keep = 1 + rng.below(5);
            let mut i = 0;
            cells.retain(|_| {
                i += 1;
                i == 1 || i % keep == 0
            });
        }
        14 => cells[1..].iter_mut().enumerate().for_each(|(i, row)| {
            if let (Some(cell), true) = (row.get_mut(column), i % 3 == 0) {
                cell.clear();
            }
        }),
        15 => drop(cells.remove(row)),
        _ => each(&mut |cell| *cell = format!("{cell}{factor}")),
    }
    let separator = if rng.one_in(20) { ";" } else { "," };
    let ending = if rng.one_in(40) { "" } else { "\n" };
    cells.iter().map(|row| row.join(separator) + ending).collect()
}

/// A mesh changed in up to three numbers or lines.
pub fn mesh(text: &str, rng: &mut Rng) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    for _ in 0..=rng.below(3) {
        let count = lines.len().max(1);
        let at = if rng.one_in(2) { rng.below(count.min(40)) } else { rng.below(count) };
        let Some(line) = lines.get_mut(at) else { break };
        match rng.below(5) {
            0 => drop(lines.remove(at)),
            1 => {
                let copy = line.clone();
                lines.insert(at, copy);
            }
            _ => {
                let mut words: Vec<String> = line.split(' ').map(str::to_string).collect();
                let word = rng.below(words.len());
                words[word] = match rng.below(3) {
                    0 => rng.below(2000).to_string(),
                    _ => rng.pick(NUMBERS).to_string(),
                };
                *line = words.join(" ");
            }
        }
    }
    lines.join("\n") + "\n"
}

/// Bytes changed, put in, cut off and repeated.
pub fn bytes(mut all: Vec<u8>, rng: &mut Rng) -> Vec<u8> {
    for _ in 0..=rng.below(4) {
        let at = rng.below(all.len() + 1);
        match rng.below(6) {
            0 if at < all.len() => all[at] = rng.next() as u8,
            1 => all.insert(at, rng.next() as u8),
            2 => all.truncate(at),
            3 => {
                let end = (at + rng.below(60)).min(all.len());
                let copy = all[at..end].to_vec();
                let copies = copy.repeat(rng.below(40));
                all.splice(at..at, copies);
            }
            4 if at < all.len() => all[at] = b"\"[]{}=,.#\n\r\t \\?+-e0"[rng.below(18)],
            _ => {
                let end = (at + rng.below(20)).min(all.len());
                all.drain(at..end);
            }
        }
    }
    all
}
