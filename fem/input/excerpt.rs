//! The lines about a place of a file, short enough to be shown.

use std::borrow::Cow;
use std::ops::Range;

use super::Source;
use super::visible::visible_in_place;

/// Most characters of a line that are shown.
const LONGEST: usize = 200;
/// Characters of a longer line that are shown before the place in question.
const BEFORE: usize = 60;

/// A few lines of a source about a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excerpt {
    /// Lines, parted by line ends; what is left out of long ones is an ellipsis.
    pub text: String,
    /// Line of the source (from 1) with which it begins.
    pub first_line: usize,
    /// Bytes of the text that the place is.
    pub place: Range<usize>,
    /// Line and column of the place in the source, both from 1, columns in characters.
    pub line_column: (usize, usize),
}

impl Excerpt {
    /// The lines of a place, with one before and one behind.
    pub fn new(source: &Source, place: &Range<usize>) -> Self {
        let text = &*source.text;
        let start = floor(text, place.start);
        let end = floor(text, place.end).max(start);
        let line_column = source.line_column(start);
        let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
        // A place of several lines is shown by its first.
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let mut excerpt = Self { text: String::new(), first_line: line_column.0, place: 0..0, line_column };
        if line_start > 0 {
            let before = text[..line_start - 1].rfind('\n').map_or(0, |i| i + 1);
            excerpt.text = format!("{}\n", shortened(&text[before..line_start - 1], LONGEST));
            excerpt.first_line -= 1;
        }
        let line = &text[line_start..line_end];
        let within = start - line_start..end.min(line_end) - line_start;
        let (line, within) = about(line, within);
        let offset = excerpt.text.len();
        excerpt.place = offset + within.start..offset + within.end;
        excerpt.text.push_str(&line);
        if line_end < text.len() {
            let behind = text[line_end + 1..].split('\n').next().unwrap_or_default();
            excerpt.text.push('\n');
            excerpt.text.push_str(&shortened(behind, LONGEST));
        }
        // A carriage return before a line feed would count as a line of its own where lines are numbered.
        excerpt.text = visible_in_place(&excerpt.text.replace('\r', " "));
        excerpt
    }
}

/// A text of at most so many characters, its beginning and its end.
pub fn shortened(text: &str, most: usize) -> Cow<'_, str> {
    if text.len() <= most || text.chars().count() <= most {
        return text.into();
    }
    let behind = most / 4;
    let head: String = text.chars().take(most - behind - 3).collect();
    let tail: Vec<char> = text.chars().rev().take(behind).collect();
    format!("{head} … {}", tail.into_iter().rev().collect::<String>()).into()
}

/// The characters of a line about a place, and the place in them.
fn about(line: &str, place: Range<usize>) -> (Cow<'_, str>, Range<usize>) {
    if line.len() <= LONGEST || line.chars().count() <= LONGEST {
        return (line.into(), place);
    }
    let from = line[..place.start].char_indices().rev().nth(BEFORE - 1).map_or(0, |(i, _)| i);
    let to = line[from..].char_indices().nth(LONGEST).map_or(line.len(), |(i, _)| from + i);
    let (head, tail) = (if from > 0 { "…" } else { "" }, if to < line.len() { "…" } else { "" });
    let within = |byte: usize| head.len() + byte.min(to) - from;
    (format!("{head}{}{tail}", &line[from..to]).into(), within(place.start)..within(place.end))
}

/// The last place of a character at or before a byte.
fn floor(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_shown_with_its_neighbours() {
        let source = Source::new("m.toml", "a = 1\nb = 2\nc = 3\nd = 4\n");
        let found = Excerpt::new(&source, &(16..17));
        assert_eq!((found.text.as_str(), found.first_line, found.line_column), ("b = 2\nc = 3\nd = 4", 2, (3, 5)));
        assert_eq!(&found.text[found.place], "3");
        // At the ends of the file, and beyond them.
        assert_eq!(Excerpt::new(&source, &(0..1)).text, "a = 1\nb = 2");
        let end = Excerpt::new(&source, &(23..99));
        assert_eq!((end.text.as_str(), end.place.len()), ("c = 3\nd = 4\n", 0));
        assert_eq!(Excerpt::new(&Source::new("m.toml", ""), &(0..5)).text, "");
    }

    #[test]
    fn long_lines_are_cut_about_the_place() {
        let line = format!("{}x{}", "ä".repeat(70_000), "ö".repeat(100_000));
        let source = Source::new("m.toml", format!("{line}\n{line}\n{line}"));
        let start = line.len() + 1 + 140_000;
        let found = Excerpt::new(&source, &(start..start + 1));
        assert_eq!(found.line_column, (2, 70_001));
        assert_eq!(&found.text[found.place.clone()], "x");
        assert!(found.text.lines().all(|line| line.chars().count() <= LONGEST + 2), "{}", found.text);
        let whole = Excerpt::new(&source, &(line.len() + 1..2 * line.len()));
        assert!(whole.place.end <= whole.text.len() && whole.text.len() < 2000);
        // A place within a character.
        assert_eq!(Excerpt::new(&source, &(1..2)).place.start, 0);
    }

    #[test]
    fn the_beginning_and_the_end_of_a_long_text_stay() {
        assert_eq!(shortened("short", 10), "short");
        let long = shortened("abcdefghijklmnopqrstuvwxyz", 15);
        assert_eq!((&*long, long.chars().count()), ("abcdefghi … xyz", 15));
    }
}
