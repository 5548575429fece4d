//! Entries that the program adds to a log: each a block of text with a first and a last line of its own, by which one that was
//! not written to its end is told from a whole one.
//!
//! ```text
//! # fem next, entry 3: 2 readings of 1 part
//! [[part]]
//! number = 13
//! offset = "-4.2 um"
//! …
//! # fem next, end of entry 3, 5f0e1c2b7a9d4e31
//! ```

use std::ops::Range;

use sha2::{Digest, Sha256};

const FIRST: &str = "# fem next, entry ";
const LAST: &str = "# fem next, end of entry ";

/// The entries of a log, as far as the program wrote them.
#[derive(Clone, Debug, PartialEq)]
pub struct Entries {
    /// How many are whole.
    pub whole: usize,
    /// Bytes that are whole, all but an entry that was not written to its end.
    pub bytes: usize,
    /// Numbers of those that somebody has changed since.
    pub changed: Vec<String>,
}

impl Entries {
    /// Those of a text.
    pub fn of(text: &str) -> Self {
        let (mut whole, mut changed, mut begun) = (0, Vec::new(), None::<(usize, &str)>);
        for (place, line) in lines(text) {
            if let Some(number) = line.strip_prefix(FIRST).and_then(number) {
                begun = Some((place.start, number));
            } else if let (Some((first, number)), Some(seal)) = (begun, line.strip_prefix(LAST)) {
                // A last line without its end, or of another entry, ends nothing.
                if seal.split(", ").next() != Some(number)
                    || !seal.ends_with('\n')
                    || seal.trim_end().len() < number.len() + 18
                {
                    continue;
                }
                if line != last(number, &text[first..place.start]) {
                    changed.push(number.to_string());
                }
                (whole, begun) = (whole + 1, None);
            }
        }
        Self { whole, bytes: begun.map_or(text.len(), |(first, _)| first), changed }
    }

    /// A further entry, to stand behind the whole ones of a text.
    pub fn next(&self, text: &str, about: &str, body: &str) -> String {
        let number = (self.whole + 1).to_string();
        let own = format!("{FIRST}{number}: {about}\n{body}");
        let kept = &text[..self.bytes];
        let gap = if kept.is_empty() || kept.ends_with("\n\n") {
            ""
        } else if kept.ends_with('\n') {
            "\n"
        } else {
            "\n\n"
        };
        format!("{gap}{own}{}", last(&number, &own))
    }
}

/// The number in the rest of a first line, which may end anywhere where writing stopped.
fn number(rest: &str) -> Option<&str> {
    let number = rest.trim_end_matches(|c: char| !c.is_ascii_digit()).split(':').next()?;
    let is_cut = !rest.ends_with('\n');
    let is_one = number.bytes().all(|byte| byte.is_ascii_digit());
    (is_one && (is_cut || rest[number.len()..].starts_with(": "))).then_some(number)
}

/// The last line of an entry.
fn last(number: &str, entry: &str) -> String {
    let seal: String = Sha256::digest(entry.as_bytes())[..8].iter().map(|byte| format!("{byte:02x}")).collect();
    format!("{LAST}{number}, {seal}\n")
}

/// Lines with their ends, and their places.
fn lines(text: &str) -> impl Iterator<Item = (Range<usize>, &str)> {
    text.split_inclusive('\n').scan(0, |from, line| {
        let place = *from..*from + line.len();
        *from = place.end;
        Some((place, line))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const USERS: &str = "model = \"lathe.toml\"\n";

    fn with(text: &str, body: &str) -> String {
        text.to_string() + &Entries::of(text).next(text, "a part", body)
    }

    #[test]
    fn an_entry_is_whole_or_none_wherever_writing_stops() {
        let one = with(USERS, "[[part]]\nnumber = 1\n");
        let two = with(&one, "[[part]]\nnumber = 2\n");
        assert_eq!(Entries::of(&two), Entries { whole: 2, bytes: two.len(), changed: Vec::new() });
        for end in one.len()..two.len() {
            let torn = &two[..end];
            let found = Entries::of(torn);
            assert_eq!((found.whole, &found.changed), (1, &Vec::new()), "{torn}");
            // What is kept is what was there, but for an empty line and the beginning of a comment.
            let kept = &torn[..found.bytes];
            assert!(found.bytes == torn.len() || !kept.contains("entry 2"), "{torn}");
            assert!(kept.starts_with(&one) && format!("\n{FIRST}").starts_with(&kept[one.len()..]), "{torn}");
            // And goes on as if nothing had been.
            let again = kept.to_string() + &found.next(torn, "a part", "[[part]]\nnumber = 2\n");
            assert_eq!(Entries::of(&again).whole, 2, "{again}");
        }
    }

    #[test]
    fn who_changes_an_entry_is_seen() {
        let text = with(&with(USERS, "offset = 1\n"), "offset = 2\n").replace("offset = 1", "offset = 3");
        assert_eq!(Entries::of(&text), Entries { whole: 2, bytes: text.len(), changed: vec!["1".into()] });
    }
}
