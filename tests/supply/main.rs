//! What the program is built of: licences, sources and duplicates, held to `deny.toml` without the network.

#![allow(clippy::unwrap_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use serde_json::Value;
use toml_edit::DocumentMut;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every package of the lock file that is not our own.
fn packages() -> Vec<Value> {
    let told = |network: &[&str]| {
        let args = [&["metadata", "--format-version", "1", "--locked"], network].concat();
        Command::new(env!("CARGO")).args(args).current_dir(root()).output().unwrap()
    };
    // A machine that built for itself alone has not got the packages of other systems.
    let output = Some(told(&["--offline"])).filter(|o| o.status.success()).unwrap_or_else(|| told(&[]));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let all: Value = serde_json::from_slice(&output.stdout).unwrap();
    let others = all["packages"].as_array().unwrap().iter().filter(|p| !p["source"].is_null());
    others.cloned().collect()
}

fn rules() -> DocumentMut {
    std::fs::read_to_string(root().join("deny.toml")).unwrap().parse().unwrap()
}

fn words(rules: &DocumentMut, table: &str, key: &str) -> BTreeSet<String> {
    rules[table][key].as_array().unwrap().iter().map(|v| v.as_str().unwrap().to_string()).collect()
}

/// Whether a licence expression is met by licences that are allowed: OR binds less than AND.
fn is_met(expression: &str, allowed: &BTreeSet<String>) -> bool {
    let expression = expression.trim();
    // The parts that stand between an operator outside of parentheses.
    let parts = |operator: &str| {
        let (mut parts, mut depth, mut start) = (Vec::new(), 0, 0);
        for (i, c) in expression.char_indices() {
            depth += i32::from(c == '(') - i32::from(c == ')');
            if depth == 0 && expression[i..].starts_with(operator) && i >= start {
                parts.push(&expression[start..i]);
                start = i + operator.len();
            }
        }
        parts.push(&expression[start..]);
        parts
    };
    // The slash of old manifests is an OR.
    for operator in [" OR ", "/"] {
        if let all @ [_, _, ..] = &parts(operator)[..] {
            return all.iter().any(|part| is_met(part, allowed));
        }
    }
    if let all @ [_, _, ..] = &parts(" AND ")[..] {
        return all.iter().all(|part| is_met(part, allowed));
    }
    match expression.strip_prefix('(').and_then(|e| e.strip_suffix(')')) {
        Some(inner) => is_met(inner, allowed),
        None => allowed.contains(expression),
    }
}

#[test]
fn expressions_are_read_as_they_are_meant() {
    let allowed: BTreeSet<String> = ["MIT", "Zlib"].map(str::to_string).into();
    for (expression, met) in [
        ("MIT", true),
        ("GPL-3.0", false),
        ("GPL-3.0 OR MIT", true),
        ("Unlicense/MIT", true),
        ("MIT AND Zlib", true),
        ("MIT AND GPL-3.0", false),
        ("(MIT OR GPL-3.0) AND Zlib", true),
        ("(GPL-3.0 OR MIT) AND GPL-2.0", false),
        ("GPL-3.0 OR MIT AND Zlib", true),
        ("MIT-0", false),
    ] {
        assert_eq!(is_met(expression, &allowed), met, "{expression}");
    }
}

#[test]
fn every_licence_is_allowed_and_every_source_known() {
    let rules = rules();
    let (allowed, registries) = (words(&rules, "licenses", "allow"), words(&rules, "sources", "allow-registry"));
    let packages = packages();
    assert!(packages.len() > 100);
    for package in &packages {
        let (name, licence) = (&package["name"], package["license"].as_str().unwrap_or_default());
        assert!(is_met(licence, &allowed), "{name}: {licence}");
        let source = package["source"].as_str().unwrap().trim_start_matches("registry+");
        assert!(registries.contains(source), "{name}: {source}");
    }
}

#[test]
fn duplicates_are_those_that_are_known() {
    let rules = rules();
    let skipped = rules["bans"]["skip"].as_array().unwrap().iter();
    let known: BTreeSet<String> =
        skipped.map(|s| s.as_inline_table().unwrap()["name"].as_str().unwrap().to_string()).collect();
    let mut versions: BTreeMap<String, usize> = BTreeMap::new();
    for package in packages() {
        *versions.entry(package["name"].as_str().unwrap().to_string()).or_default() += 1;
    }
    let found: BTreeSet<String> = versions.into_iter().filter(|(_, count)| *count > 1).map(|(name, _)| name).collect();
    assert_eq!(found, known, "mend Cargo.lock, or the list in deny.toml");
}

/// Each known advisory that is left out stands with its number and the reason for which the crate stays.
#[test]
fn advisories_that_are_left_out_have_a_reason() {
    let rules = rules();
    let crates = packages();
    for own in rules["advisories"]["ignore"].as_array().unwrap() {
        let own = own.as_inline_table().unwrap();
        let [id, reason] =
            ["id", "reason"].map(|key| own.get(key).and_then(|value| value.as_str()).unwrap_or_default());
        assert!(id.starts_with("RUSTSEC-20") && id.len() == 17, "{id}");
        let named = crates.iter().any(|p| reason.split_whitespace().next() == p["name"].as_str());
        assert!(named && reason.len() > 40, "{id}: say which crate it is, and why it stays: {reason}");
    }
}

/// The wheel is built of what was compiled for the tests: no crate is asked for other features, and nothing is compiled again.
#[test]
fn the_wheel_is_built_of_what_the_tests_compile() {
    let tree = |of: &[&str]| -> BTreeSet<String> {
        let args = [&["tree", "--locked", "--offline", "--prefix", "none", "--format", "{p} [{f}]"], of].concat();
        let told = Command::new(env!("CARGO")).args(args).current_dir(root()).output().unwrap();
        assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
        let told = String::from_utf8(told.stdout).unwrap();
        told.lines().map(|line| line.trim_end_matches(" (*)").to_string()).collect()
    };
    let of_tests = tree(&["--workspace", "--edges", "normal,build,dev"]);
    let of_wheel = tree(&["--manifest-path", "python/Cargo.toml", "--edges", "normal,build"]);
    let others: Vec<&String> = of_wheel.difference(&of_tests).collect();
    assert!(others.is_empty(), "name the features that the tests ask for in python/Cargo.toml: {others:?}");
}
