//! Text of others that a terminal shows and does not obey.

use std::borrow::Cow;

/// A text with control characters as JSON writes them, for a name in a file may hold what recolours, clears or retitles a
/// terminal. Line ends and tabs stay.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.chars().any(char::is_control) {
        return text.into();
    }
    let mut seen = String::with_capacity(text.len() + 16);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '\n' | '\t' => seen.push(letter),
            '\r' if letters.peek() == Some(&'\n') => seen.push(letter),
            _ if letter.is_control() => seen.push_str(&format!("\\u{:04x}", u32::from(letter))),
            _ => seen.push(letter),
        }
    }
    seen.into()
}

/// A name with all control characters as JSON writes them, line ends and tabs too: a line in which it stands is one line.
pub fn on_one_line(name: &str) -> Cow<'_, str> {
    if !name.contains(char::is_control) {
        return name.into();
    }
    let shown = |letter: char| match letter.is_control() {
        true => format!("\\u{:04x}", u32::from(letter)),
        false => letter.to_string(),
    };
    name.chars().map(shown).collect::<String>().into()
}

/// A text as [`visible`] shows it where places of bytes stay what they are.
pub(super) fn visible_in_place(text: &str) -> String {
    let shown = |letter: char| match letter {
        '\n' | '\t' => letter,
        '\0'..='\x1f' | '\x7f' => '?',
        // Of two bytes, as these control characters.
        '\u{80}'..='\u{9f}' => '¿',
        _ => letter,
    };
    text.chars().map(shown).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_control_character_is_left_but_line_ends_and_tabs() {
        assert_eq!(visible("a\tb\r\nc\rd\u{1b}[2J\u{9b}1m\u{7f}"), "a\tb\r\nc\\u000dd\\u001b[2J\\u009b1m\\u007f");
        assert!(matches!(visible("plain µm"), Cow::Borrowed(_)));
        assert_eq!(on_one_line("a\nfem: done\t\u{1b}"), "a\\u000afem: done\\u0009\\u001b");
        let own = "a\u{1b}\u{9b}\u{7f}ä\n";
        assert_eq!((visible_in_place(own).len(), &*visible_in_place(own)), (own.len(), "a?¿?ä\n"));
    }
}
