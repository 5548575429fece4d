//! The words of a program: a letter and a number each, with the bytes where they stand. Whatever else is in the file is kept as
//! it is and not understood: comments, blank lines, marks of the tape, byte order marks, letters of any code page.

use std::ops::Range;

use crate::input::Problem;

/// A word.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// Its letter, in capitals.
    pub letter: u8,
    /// Its number.
    pub value: f64,
    /// Bytes of the word.
    pub span: Range<usize>,
    /// Bytes of its number.
    pub number: Range<usize>,
}

impl Word {
    /// The word as people say it.
    pub fn shown(&self) -> String {
        format!("{}{}", char::from(self.letter), self.value)
    }

    /// A problem with this word.
    pub fn problem(&self, message: impl Into<String>, help: &str) -> Problem {
        Problem::new(message).help(help).at(Some(self.span.clone()))
    }
}

/// A line.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Bytes of the line, without its end.
    pub line: Range<usize>,
    /// Its number in the file, from 1.
    pub number: usize,
    /// Bytes of the sign that lets an operator skip it, if there is one.
    pub skip: Option<Range<usize>>,
    /// Whether it is a mark of the tape, `%`, at which a program begins and ends.
    pub is_mark: bool,
    /// The words.
    pub words: Vec<Word>,
    /// What is no word in it; of no account behind the end of the program.
    pub problem: Option<Problem>,
}

impl Block {
    /// The word with a letter, if there is one.
    pub fn word(&self, letter: u8) -> Option<&Word> {
        self.words.iter().find(|word| word.letter == letter)
    }

    /// The line as people find it: its number, and that which it has itself.
    pub fn shown(&self) -> String {
        let own = self.word(b'N').map(|word| format!(" ({})", word.shown()));
        format!("line {}{}", self.number, own.unwrap_or_default())
    }
}

const PLAIN: &str = "write plain blocks of letters and numbers, as CAM systems do";

/// The lines of a program with their words.
pub fn blocks(bytes: &[u8]) -> Vec<Block> {
    let mark = if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
    let mut blocks = Vec::new();
    let (mut start, mut number) = (mark, 1);
    while start < bytes.len() {
        let is_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let end = bytes[start..].iter().position(is_end).map_or(bytes.len(), |length| start + length);
        let mut block =
            Block { line: start..end, number, skip: None, is_mark: false, words: Vec::new(), problem: None };
        block.problem = block.read(bytes).err();
        blocks.push(block);
        start = end + if bytes[end..].starts_with(b"\r\n") { 2 } else { 1 };
        number += 1;
    }
    blocks
}

impl Block {
    /// Finds the words of the line.
    fn read(&mut self, bytes: &[u8]) -> Result<(), Problem> {
        let mut at = self.line.start;
        let end = self.line.end;
        while at < end {
            let wrong = |length: usize, message: &str, help: &str| {
                Err(Problem::new(message).help(help).at(Some(at..(at + length).min(end))))
            };
            match bytes[at] {
                b' ' | b'\t' => at += 1,
                b';' => break,
                b'(' => match bytes[at..end].iter().position(|byte| *byte == b')') {
                    Some(length) => at += length + 1,
                    None => return wrong(end - at, "the comment does not end on its line", "close it with `)`"),
                },
                b'%' if self.words.is_empty() && self.skip.is_none() => {
                    self.is_mark = true;
                    break;
                }
                b'/' if self.skip.is_none() && self.words.iter().all(|word| word.letter == b'N') => {
                    let digits = bytes[at + 1..end].iter().take_while(|byte| byte.is_ascii_digit()).count();
                    self.skip = Some(at..at + 1 + digits);
                    at += 1 + digits;
                }
                letter if letter.is_ascii_alphabetic() => {
                    let word = word(bytes, at, end)?;
                    at = word.span.end;
                    self.words.push(word);
                }
                b'#' | b'[' | b']' | b'=' | b'<' | b'*' => {
                    return wrong(end - at, "variables and expressions are computed by the control alone", PLAIN);
                }
                b',' => return wrong(end - at, "a corner after a comma is computed by the control", CORNER),
                _ => return wrong(1, "this is no word of a program", PLAIN),
            }
        }
        Ok(())
    }
}

/// Remedy for corners that a control rounds.
pub const CORNER: &str = "write the chamfer or the fillet as a G1, G2 or G3 of its own";

/// The word at a place.
fn word(bytes: &[u8], start: usize, end: usize) -> Result<Word, Problem> {
    let count = |from: usize, is: fn(&u8) -> bool| bytes[from..end].iter().take_while(|byte| is(byte)).count();
    let letters = count(start, u8::is_ascii_alphabetic);
    if letters > 1 {
        let span = start..start + letters;
        let text = String::from_utf8_lossy(&bytes[span.clone()]).into_owned();
        let problem = Problem::new(format!("`{text}` is no word of a letter and a number"));
        return Err(problem.help(PLAIN).at(Some(span)));
    }
    let from = start + 1 + count(start + 1, |byte| matches!(byte, b' ' | b'\t'));
    let sign = usize::from(bytes[from..end].first().is_some_and(|byte| matches!(byte, b'+' | b'-')));
    let whole = count(from + sign, u8::is_ascii_digit);
    let point = usize::from(bytes[from + sign + whole..end].first() == Some(&b'.'));
    let decimals = if point == 1 { count(from + sign + whole + 1, u8::is_ascii_digit) } else { 0 };
    let number = from..from + sign + whole + point + decimals;
    let text = std::str::from_utf8(&bytes[number.clone()]).unwrap_or_default();
    match text.parse() {
        Ok(value) if whole + decimals > 0 => {
            Ok(Word { letter: bytes[start].to_ascii_uppercase(), value, span: start..number.end, number })
        }
        _ => {
            let letter = char::from(bytes[start]);
            let problem =
                Problem::new(format!("`{letter}` has no number, or one that the control computes")).help(PLAIN);
            Err(problem.at(Some(start..(number.end + 1).min(end))))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> String {
        let all = blocks(text.as_bytes());
        if let Some(problem) = all.iter().find_map(|own| own.problem.as_ref()) {
            return format!("! {}", problem.message);
        }
        let one = |own: &Block| own.words.iter().map(Word::shown).collect::<Vec<_>>().join(" ");
        all.iter().map(one).collect::<Vec<_>>().join("|")
    }

    #[test]
    fn words_are_a_letter_and_a_number() {
        for (text, words) in [
            ("N10 G1 X40. Z-10.5\n", "N10 G1 X40 Z-10.5"),
            ("g01x40.z-10.f.2", "G1 X40 Z-10 F0.2"),
            ("\u{feff}%\r\nO1234 (X99)\r\n G0 X +5;X6\r\n\r\n%\r\n", "|O1234|G0 X5||"),
            ("/2 N10 X1\nN20 /X2", "N10 X1|N20 X2"),
            ("(Länge \u{e4} X40) X1(X2)Z3", "X1 Z3"),
            ("G1 X#101", "! `X` has no number, or one that the control computes"),
            ("X1 [2]", "! variables and expressions are computed by the control alone"),
            ("IF X1", "! `IF` is no word of a letter and a number"),
            ("X40,R2", "! a corner after a comma is computed by the control"),
            ("X4 0", "! this is no word of a program"),
            ("X1 (open", "! the comment does not end on its line"),
            ("X.", "! `X` has no number, or one that the control computes"),
            ("X4 /Z1", "! this is no word of a program"),
        ] {
            assert_eq!(read(text), words, "{text}");
        }
    }

    #[test]
    fn a_word_knows_its_bytes() {
        let text = "\u{feff}G1 X 40.5Z-1";
        let all = blocks(text.as_bytes());
        let x = all[0].word(b'X').unwrap();
        assert_eq!((&text[x.span.clone()], &text[x.number.clone()]), ("X 40.5", "40.5"));
    }
}
