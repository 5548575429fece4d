//! Files of a folder by a name with `*`.

use std::path::{Path, PathBuf};

/// The files that a pattern names, relative to `folder`, sorted; `*` in the last part stands for any letters. None
/// where there is no such file.
pub fn files(folder: &Path, pattern: &str) -> Vec<PathBuf> {
    let path = folder.join(pattern);
    let (inside, name) = (path.parent().unwrap_or(folder), path.file_name().unwrap_or_default().to_string_lossy());
    if !name.contains('*') {
        return if path.is_file() { vec![path] } else { Vec::new() };
    }
    let listed = if inside.as_os_str().is_empty() { Path::new(".") } else { inside };
    let entries = std::fs::read_dir(listed).into_iter().flatten().flatten();
    let names = entries.map(|entry| entry.file_name()).filter(|found| matches(&name, &found.to_string_lossy()));
    let mut found: Vec<PathBuf> = names.map(|name| inside.join(name)).filter(|path| path.is_file()).collect();
    found.sort();
    found
}

/// Whether a name is of a pattern.
fn matches(pattern: &str, name: &str) -> bool {
    let Some((first, rest)) = pattern.split_once('*') else { return pattern == name };
    let Some(mut left) = name.strip_prefix(first) else { return false };
    let mut parts: Vec<&str> = rest.split('*').collect();
    let last = parts.pop().unwrap_or_default();
    for part in parts {
        // The first place leaves most for what follows.
        match left.find(part) {
            Some(at) => left = &left[at + part.len()..],
            None => return false,
        }
    }
    left.len() >= last.len() && left.ends_with(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_any_letters() {
        for (pattern, name, is_of) in [
            ("*.csv", "a.csv", true),
            ("*.csv", ".csv", true),
            ("*.csv", "a.csv.bak", false),
            ("part-*-of-*.csv", "part-1-of-12.csv", true),
            ("part-*-of-*.csv", "part-1.csv", false),
            ("a*a", "a", false),
            ("a*a", "aba", true),
            ("a", "a", true),
            ("a", "ab", false),
        ] {
            assert_eq!(matches(pattern, name), is_of, "{pattern} {name}");
        }
    }
}
