//! Every command that README, `docs/` and `tests/seeds.md` show is run, page by page, and prints what the page says.
//!
//! In a block of ```` ```console ````, `$` begins a command, `? 1` is an exit status other than 0, and what
//! follows is what it prints (on standard error where it fails); `...` stands for any lines, `[..]` for
//! anything on a line. A block whose language is followed by a name, as in ```` ```csv measured.csv ````, is a file
//! that the commands of its page find.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod materials;

use std::path::{Path, PathBuf};
use std::process::Command;

use rayon::prelude::*;

/// A command of a page.
struct Step {
    line: String,
    status: i32,
    expected: String,
}

/// The steps of a page, in their order.
fn steps(page: &str) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    let mut is_inside = false;
    for line in page.lines() {
        if line.starts_with("```") {
            is_inside = line == "```console";
        } else if let (true, Some(command)) = (is_inside, line.strip_prefix("$ ")) {
            steps.push(Step { line: command.into(), status: 0, expected: String::new() });
        } else if let (true, Some(step)) = (is_inside, steps.last_mut()) {
            match line.strip_prefix("? ") {
                Some(status) if step.expected.is_empty() => step.status = status.parse().unwrap(),
                _ => step.expected.push_str(&format!("{line}\n")),
            }
        }
    }
    steps
}

/// The files that a page shows, by their names.
fn files(page: &str) -> Vec<(&str, String)> {
    let mut files = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let Some((_, name)) = line.strip_prefix("```").and_then(|fence| fence.split_once(' ')) else { continue };
        let text = lines.by_ref().take_while(|line| !line.starts_with("```"));
        files.push((name, text.map(|line| format!("{line}\n")).collect()));
    }
    files
}

/// The words of a command, single quotes kept together.
fn words(line: &str) -> Vec<String> {
    line.split('\'')
        .enumerate()
        .flat_map(|(i, part)| match i % 2 {
            0 => part.split_whitespace().map(str::to_string).collect(),
            _ => vec![part.to_string()],
        })
        .collect()
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let target = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy(&path, &target);
        } else {
            std::fs::copy(&path, target).unwrap();
        }
    }
}

fn pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let docs = std::fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let mut pages: Vec<PathBuf> = docs.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.extend(["README.md", "tests/seeds.md"].map(|page| root.join(page)));
    pages.sort();
    pages
}

#[test]
fn commands_print_what_the_pages_say() {
    // Pages know nothing of each other.
    let pages: Vec<(usize, String)> = pages().par_iter().map(|page| checked(page)).collect();
    let others: String = pages.iter().map(|(_, others)| others.as_str()).collect();
    assert!(others.is_empty(), "{others}");
    let count: usize = pages.iter().map(|(count, _)| count).sum();
    assert!(count > 10, "only {count} commands were found");
}

/// Number of the commands of a page, and what they print otherwise than it says.
fn checked(page: &Path) -> (usize, String) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut count, mut others) = (0, String::new());
    let place = tempfile::tempdir().unwrap();
    for folder in ["models", "meshes", "tests/data/real", "tests/data/seeds"] {
        copy(&root.join(folder), &place.path().join(folder));
    }
    let text = std::fs::read_to_string(page).unwrap();
    for (name, shown) in files(&text) {
        std::fs::write(place.path().join(name), shown).unwrap();
    }
    for step in steps(&text) {
        let words = words(&step.line);
        assert_eq!(words[0], "fem", "{}: {}", page.display(), step.line);
        let answer = Command::new(env!("CARGO_BIN_EXE_fem"))
            .args(&words[1..])
            .current_dir(place.path())
            .env("NO_COLOR", "1")
            .output()
            .unwrap();
        let told = |bytes: &[u8]| {
            let text = String::from_utf8_lossy(bytes);
            text.lines().map(|line| format!("{}\n", line.trim_end())).collect::<String>()
        };
        let (out, err) = (told(&answer.stdout), told(&answer.stderr));
        assert_eq!(answer.status.code(), Some(step.status), "{}: {}\n{err}", page.display(), step.line);
        let shown = if step.status == 0 { out } else { err };
        let result = snapbox::Assert::new().try_eq(Some(&step.line), shown.into(), step.expected.into());
        if let Err(difference) = result {
            others += &format!("{}: {difference}\n", page.display());
        }
        count += 1;
    }
    (count, others)
}

/// Diameter error (m) of a steel shaft of 40 mm by 500 mm between centres of 60 and 40 N/um under 400 N, x from the
/// headstock: Timoshenko's beam on two supports by hand.
fn bent(x: f64) -> f64 {
    let (force, length, diameter, modulus) = (400.0, 0.5, 0.04f64, 210e9);
    let pi = std::f64::consts::PI;
    let (inertia, area) = (pi * diameter.powi(4) / 64.0, pi * diameter.powi(2) / 4.0);
    // Cowper's coefficient of a round section, ν = 0.3.
    let shear = 6.0 * 1.3 / (7.0 + 6.0 * 0.3) * modulus / 2.6 * area;
    let rest = length - x;
    let shaft = (x * rest).powi(2) / (3.0 * modulus * inertia * length) + x * rest / (shear * length);
    2.0 * force * (shaft + (rest / length).powi(2) / 60e6 + (x / length).powi(2) / 40e6)
}

/// What the wear that the page tells adds (m): 3 um over the first 300 m, and 4 um per km.
fn worn(part: f64, x: f64) -> f64 {
    // At 0.2 mm/rev, from the tailstock to the headstock.
    let path = std::f64::consts::PI * 0.04 / 0.2e-3 * ((part - 1.0) * 0.5 + 0.5 - x);
    2.0 * (-3e-6 * (-path / 300.0).exp_m1() + 4e-9 * path)
}

#[test]
fn the_readings_of_the_first_shaft_are_what_the_page_says() {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/first-shaft.md")).unwrap();
    let (_, text) = files(&page).into_iter().find(|(name, _)| *name == "measured.csv").unwrap();
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 25);
    let residual = |row: &Vec<f64>| 1e3 * (row[2] - 40.0) - 1e6 * (bent(1e-3 * row[1]) + worn(row[0], 1e-3 * row[1]));
    let square: f64 = rows.iter().map(|row| residual(row).powi(2)).sum();
    // Noise of 1 um, of 25 rows: χ² lies between 10 and 47 with all but one chance in two hundred.
    assert!((10.0..47.0).contains(&square), "{square}");
    let without: f64 = rows.iter().map(|row| (residual(row) + 1e6 * worn(row[0], 1e-3 * row[1])).powi(2)).sum();
    assert!(without > 1000.0, "the wear is not in them: {without}");
}

#[test]
fn links_lead_somewhere() {
    for page in pages() {
        let text = std::fs::read_to_string(&page).unwrap();
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let target = link.split('#').next().unwrap();
            if !target.is_empty() && !target.contains("://") {
                assert!(page.with_file_name(target).exists(), "{}: {link}", page.display());
            }
        }
    }
}
