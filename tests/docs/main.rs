//! Every command that README, `docs/` and `tests/seeds.md` show is run, page by page, and prints what the page says.
//!
//! In a block of ```` ```console ````, `$` begins a command, `? 1` is an exit status other than 0, and what
//! follows is what it prints (on standard error where it fails); `...` stands for any lines, `[..]` for
//! anything on a line.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::{Path, PathBuf};
use std::process::Command;

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
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut count = 0;
    for page in pages() {
        let place = tempfile::tempdir().unwrap();
        for folder in ["models", "meshes", "tests/data/real", "tests/data/seeds"] {
            copy(&root.join(folder), &place.path().join(folder));
        }
        for step in steps(&std::fs::read_to_string(&page).unwrap()) {
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
            result.unwrap_or_else(|difference| panic!("{}: {difference}", page.display()));
            count += 1;
        }
    }
    assert!(count > 10, "only {count} commands were found");
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
