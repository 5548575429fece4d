//! Markdown: what is written, and the links and headings of what is read.

use std::path::{Component, Path, PathBuf};

/// A text as it is, also in a cell of a table: what Markdown would take for its own is escaped but for code spans.
pub fn plain(text: &str) -> String {
    let mut out = String::new();
    let mut is_code = false;
    for c in text.chars() {
        is_code ^= c == '`';
        if c == '|' || (!is_code && matches!(c, '*' | '_' | '<' | '[' | ']')) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}

/// A text in a code span, also in a cell of a table.
pub fn code(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("`{}`", text.replace('|', "\\|")) }
}

/// A table with these headings; cells are Markdown.
pub fn table<const N: usize>(headings: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    let line = |cells: Vec<&str>| format!("| {} |\n", cells.join(" | "));
    let mut text = line(headings.to_vec()) + &line(vec!["---"; N]);
    for row in rows {
        text.push_str(&line(row.iter().map(String::as_str).collect()));
    }
    text
}

/// A block of text of a language.
pub fn block(language: &str, text: &str) -> String {
    format!("```{language}\n{}\n```\n", text.trim_end())
}

/// The lines of a page that are not in a block.
fn outside_blocks(page: &str) -> impl Iterator<Item = &str> {
    let mut is_block = false;
    page.lines().filter(move |line| {
        let is_fence = line.trim_start().starts_with("```");
        is_block ^= is_fence;
        !is_fence && !is_block
    })
}

/// The targets of the links and pictures of a page.
pub fn links(page: &str) -> Vec<&str> {
    let mut all = Vec::new();
    for line in outside_blocks(page) {
        // Every second part stands between backticks.
        for text in line.split('`').step_by(2) {
            all.extend(text.split("](").skip(1).filter_map(|rest| rest.split(')').next()));
        }
    }
    all.retain(|target| !target.contains("://") && !target.is_empty());
    all
}

/// What the headings of a page are called in links to them.
#[cfg(test)]
pub fn anchors(page: &str) -> Vec<String> {
    let headings = outside_blocks(page).filter(|line| line.starts_with('#'));
    let words = headings.map(|line| line.trim_start_matches('#').trim());
    let name = |c: char| match c {
        c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c.to_ascii_lowercase()),
        c if c.is_whitespace() => Some('-'),
        _ => None,
    };
    words.map(|heading| heading.chars().filter_map(name).collect()).collect()
}

/// The file that a link in a page means, both from the root of the repository.
pub fn target(page: &Path, link: &str) -> PathBuf {
    let (file, _) = link.split_once('#').unwrap_or((link, ""));
    if file.is_empty() {
        return page.to_path_buf();
    }
    let mut path = PathBuf::new();
    for part in page.parent().unwrap_or(Path::new("")).join(file).components() {
        match part {
            Component::ParentDir => drop(path.pop()),
            Component::CurDir => {}
            other => path.push(other),
        }
    }
    path
}
