//! The look of text on a terminal: how wide it is, whether it shows more than ASCII, and whether it has colours.

use std::ffi::OsStr;
use std::io::IsTerminal;

use crate::ask::Marks;

/// Most columns that are used: longer lines are hard to read.
const WIDEST: usize = 180;
/// Fewest columns into which lines are wrapped.
const NARROWEST: usize = 40;

/// Columns of the terminal on stdout; `None` where it is none.
pub fn columns() -> Option<usize> {
    let out = std::io::stdout();
    let (width, _) = terminal_size::terminal_size_of(&out).filter(|_| out.is_terminal())?;
    Some(usize::from(width.0).clamp(NARROWEST, WIDEST))
}

/// Whether the locale shows nothing beyond ASCII. Where none is set, as in many containers, Unicode is meant.
pub fn is_ascii() -> bool {
    let said = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().filter_map(std::env::var_os).find(|v| !v.is_empty());
    said.is_some_and(|locale| !names_unicode(&locale))
}

fn names_unicode(locale: &OsStr) -> bool {
    let name = locale.to_string_lossy().to_lowercase();
    name.contains("utf-8") || name.contains("utf8")
}

/// The marks with which an error is drawn on stderr.
pub fn marks() -> Marks {
    match plain_marks() {
        Marks::Plain if has_colour() => Marks::Coloured,
        plain => plain,
    }
}

/// The same without colours.
pub fn plain_marks() -> Marks {
    if is_ascii() { Marks::Ascii } else { Marks::Plain }
}

/// Whether stderr shows colours that the user wants.
fn has_colour() -> bool {
    let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    let is_unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    std::io::stderr().is_terminal() && !is_dumb && !is_unwanted
}

/// The text for a terminal: lines wrapped at its columns, and in ASCII where it shows no more.
pub fn fitted(text: &str, columns: Option<usize>, ascii: bool) -> String {
    let text = if ascii { plain(text) } else { text.to_string() };
    let Some(columns) = columns else { return text };
    text.lines().map(|line| wrapped(line, columns) + "\n").collect()
}

/// Wraps a line at spaces; what follows stands under the column in which the last word after a gap began. Commands
/// stay whole, to be copied.
fn wrapped(line: &str, columns: usize) -> String {
    let letters: Vec<char> = line.chars().collect();
    if letters.len() <= columns || line.trim_start().starts_with("fem ") {
        return line.to_string();
    }
    let is_gap = |i: &usize| letters[i - 2] == ' ' && letters[i - 1] == ' ' && letters[*i] != ' ';
    let indent = (2..columns / 2).rev().find(is_gap).unwrap_or(2);
    let mut text = String::new();
    let mut rest = &letters[..];
    let mut room = columns;
    while rest.len() > room {
        // A word that is longer than the line is left whole.
        let fits = (1..=room).rev().find(|i| rest[*i] == ' ' && rest[..*i].iter().any(|c| *c != ' '));
        let Some(end) = fits.or_else(|| (room..rest.len()).find(|i| rest[*i] == ' ')) else { break };
        text.extend(&rest[..end]);
        text.truncate(text.trim_end().len());
        text.push('\n');
        text.push_str(&" ".repeat(indent));
        rest = &rest[end..];
        while rest.first() == Some(&' ') {
            rest = &rest[1..];
        }
        room = columns - indent;
    }
    text.extend(rest);
    text
}

/// Replaces the non-ASCII characters that the program itself writes by ASCII; text of the user stays as it is.
fn plain(text: &str) -> String {
    let letter = |c: char| match c {
        '•' => "*",
        '┤' | '└' => "+",
        '│' => "|",
        '─' => "-",
        'µ' | 'μ' => "u",
        '±' => "+-",
        '\u{2212}' => "-",
        '×' => "x",
        '°' => " deg",
        '²' => "^2",
        '³' => "^3",
        'χ' => "chi",
        'σ' => "sigma",
        'θ' => "theta",
        'φ' => "phi",
        'Δ' => "Delta",
        '·' => "*",
        '≤' => "<=",
        '≥' => ">=",
        '…' => "...",
        '\u{202f}' => " ",
        _ => "",
    };
    let mut plain = String::with_capacity(text.len());
    for c in text.chars() {
        match letter(c) {
            "" => plain.push(c),
            ascii => plain.push_str(ascii),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_go_on_under_their_column() {
        let line = "  schedule                 12 part(s), 3.750 min of cutting each, done after 88.75 min";
        let told = fitted(line, Some(60), false);
        assert_eq!(
            told,
            "  schedule                 12 part(s), 3.750 min of cutting\n                           each, done after 88.75 min\n"
        );
        assert!(told.lines().all(|l| l.chars().count() <= 60));
        assert_eq!(fitted("one two three four five six seven eight nine", Some(40), false).lines().count(), 2);
    }

    #[test]
    fn commands_and_long_words_stay_whole() {
        let command = "  fem add model.toml tool-wear 'rate=6.015 +- 0.064 um/km' -o model-tool-wear.toml";
        assert_eq!(fitted(command, Some(40), false).trim_end(), command);
        let word = "a".repeat(90);
        assert_eq!(fitted(&word, Some(40), false).trim_end(), word);
        assert_eq!(fitted(&format!("{word} b"), Some(40), false), format!("{word}\n  b\n"));
    }

    #[test]
    fn a_pipe_gets_lines_as_they_are() {
        let line = "a ".repeat(100);
        assert_eq!(fitted(&line, None, false), line);
    }

    #[test]
    fn plots_are_drawn_in_ascii_where_there_is_no_more() {
        assert_eq!(fitted("  1.5 µm ± 2 ┤••\n       └──", None, true), "  1.5 um +- 2 +**\n       +--");
        assert!(names_unicode(OsStr::new("de_DE.UTF-8")) && names_unicode(OsStr::new("C.utf8")));
        assert!(!names_unicode(OsStr::new("C")) && !names_unicode(OsStr::new("de_DE@euro")));
    }
}
