//! A program with other words across the part: numbers are exchanged, blocks put between, and nothing else is touched.

use std::ops::Range;

use super::fit::{Hold, Holds};
use super::number::like;
use super::steps::{Shape, Step};
use super::words::{Block, Word};
use super::workpiece::{Increment, Workpiece};

/// A program with other words.
#[derive(Clone, Debug, PartialEq)]
pub struct Rewritten {
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Words that have another number.
    pub words: usize,
    /// Words and blocks that were put in.
    pub added: usize,
    /// Of each of its steps that of the old program of which it comes, by their positions.
    pub origins: Vec<usize>,
}

/// What goes into the place of some bytes.
struct Edit {
    at: Range<usize>,
    text: String,
}

/// Writes a program anew, given the change of each hold, m of the level.
pub fn rewritten(
    bytes: &[u8],
    (blocks, steps): (&[Block], &[Step]),
    (holds, changes): (&Holds, &[f64]),
    work: &Workpiece,
) -> Rewritten {
    let mut writer = Writer { bytes, work, edits: Vec::new(), now: None, words: 0, added: 0 };
    let (mut before, mut origins) = (None, Vec::with_capacity(steps.len()));
    for (number, (step, hold)) in steps.iter().zip(&holds.of).enumerate() {
        let blocks = writer.step(&blocks[step.block], (step, before), hold, changes);
        origins.extend(std::iter::repeat_n(number, blocks));
        before = step.r;
    }
    let mut written = Vec::with_capacity(bytes.len() + 64 * writer.edits.len());
    let mut from = 0;
    for edit in &writer.edits {
        written.extend_from_slice(&bytes[from..edit.at.start]);
        written.extend_from_slice(edit.text.as_bytes());
        from = edit.at.end;
    }
    written.extend_from_slice(&bytes[from..]);
    Rewritten { bytes: written, words: writer.words, added: writer.added, origins }
}

struct Writer<'a> {
    bytes: &'a [u8],
    work: &'a Workpiece,
    edits: Vec<Edit>,
    /// The level of the tool by the words as they are written now, m.
    now: Option<f64>,
    words: usize,
    added: usize,
}

impl Writer<'_> {
    /// Writes a step, and says how many blocks there are of it now.
    fn step(&mut self, block: &Block, (step, before): (&Step, Option<f64>), hold: &Hold, changes: &[f64]) -> usize {
        let change = |hold: Option<usize>| hold.map_or(0.0, |hold| changes[hold]);
        let count = 1 + self.between(block, (step, before), hold, changes);
        let Some(r) = step.r else {
            self.now = None;
            return count;
        };
        let target = r + change(hold.end);
        let increment = self.work.increment(step.unit);
        match step.word.map(|at| &block.words[at]) {
            Some(word) => {
                // A word that counts on closes the sum from where the words before it, as they are now, have led.
                let (old, from) = (word.value, self.now.filter(|_| step.is_on).unwrap_or(self.work.zero.r));
                let value = if step.is_on { (target - from) / step.scale } else { old + change(hold.end) / step.scale };
                let is_kept = (value - old).abs() < 0.5 * increment.size;
                let value = if is_kept { old } else { increment.round(value) };
                if value != old {
                    let text = like(self.text(&word.number), value, increment);
                    self.edits.push(Edit { at: word.number.clone(), text });
                    self.words += 1;
                }
                self.now = Some(if value == old && !step.is_on { r } else { from + value * step.scale });
            }
            None if !hold.between.is_empty() || hold.end != hold.start => {
                self.put_word(block, step, target, increment);
            }
            None => {}
        }
        count
    }

    /// Puts a word across into a block that has none, beside its words along.
    fn put_word(&mut self, block: &Block, step: &Step, target: f64, increment: Increment) {
        let axes = self.work.axes;
        let value = increment.round((target - self.work.zero.r) / step.scale);
        let level = self.work.zero.r + value * step.scale;
        let is_there = self.now.is_some_and(|now| (level - now).abs() < 0.5 * increment.size * step.scale);
        let mut along = block.words.iter().filter(|word| axes.letters[1..].contains(&word.letter) && !is_there);
        let beside = if axes.is_across_first { along.next() } else { along.next_back() };
        let Some(beside) = beside else { return };
        let word = self.letter(beside, axes.letters[0]) + &like(DECIMAL, value, increment);
        let gap = self.gap(block);
        let (at, text) = match axes.is_across_first {
            true => (beside.span.start, format!("{word}{gap}")),
            false => (beside.span.end, format!("{gap}{word}")),
        };
        self.edits.push(Edit { at: at..at, text });
        self.now = Some(level);
        self.added += 1;
    }

    /// Puts blocks before one that finishes the part, which run by the same motion and feed, and says how many.
    fn between(&mut self, block: &Block, (step, before): (&Step, Option<f64>), hold: &Hold, changes: &[f64]) -> usize {
        let axes = self.work.axes;
        let (Some(cut), Some(before)) = (step.cut.filter(|cut| cut.shape == Shape::Line), before) else { return 0 };
        let ways: Vec<(usize, &Word)> = (1..axes.letters.len())
            .filter_map(|axis| block.word(axes.letters[axis]).map(|word| (axis, word)))
            .collect();
        let Some((_, first)) = ways.first() else { return 0 };
        let increment = self.work.increment(step.unit);
        let style = step.word.map_or(DECIMAL, |at| self.text(&block.words[at].number)).to_string();
        let (gap, end) = (self.gap(block), self.line_end(block));
        let motion = block.word(b'G').map(|word| self.text(&word.span).to_string());
        let mut feed = block.word(b'F').map(|word| self.text(&word.span).to_string());
        let skip = block.skip.as_ref().map(|skip| self.text(skip).to_string()).unwrap_or_default();
        let zero = self.work.zero.in_axes();
        for (share, own) in &hold.between {
            let r = before + (cut.to.r - before) * share;
            let value = increment.round((r + changes[*own] - zero[0]) / step.scale);
            let spot = cut.at(*share).in_axes();
            let place = |(axis, way): &(usize, &Word)| {
                let place = increment.round((spot[*axis] - zero[*axis]) / step.unit);
                self.letter(way, axes.letters[*axis]) + &like(self.text(&way.number), place, increment)
            };
            let mut path: Vec<String> = ways.iter().map(place).collect();
            let at = if axes.is_across_first { 0 } else { path.len() };
            path.insert(at, self.letter(first, axes.letters[0]) + &like(&style, value, increment));
            let words: Vec<String> = motion.clone().into_iter().chain(path).chain(feed.take()).collect();
            let at = block.line.start..block.line.start;
            self.edits.push(Edit { at, text: format!("{skip}{}{end}", words.join(gap)) });
            self.now = Some(zero[0] + value * step.scale);
            self.added += 1;
        }
        hold.between.len()
    }

    fn text(&self, span: &Range<usize>) -> &str {
        std::str::from_utf8(&self.bytes[span.clone()]).unwrap_or_default()
    }

    /// A letter in the case of a word.
    fn letter(&self, word: &Word, letter: u8) -> String {
        let is_small = self.bytes[word.span.start].is_ascii_lowercase();
        char::from(if is_small { letter.to_ascii_lowercase() } else { letter }).to_string()
    }

    /// What parts the words of a block.
    fn gap(&self, block: &Block) -> &'static str {
        let has_gap = block.words.windows(2).any(|pair| pair[1].span.start > pair[0].span.end);
        if has_gap || block.words.len() < 2 { " " } else { "" }
    }

    /// The end of a line, or where it is the last without one that of the line before.
    fn line_end(&self, block: &Block) -> &'static str {
        let after = &self.bytes[block.line.end..];
        let before = &self.bytes[..block.line.start];
        match (after, before) {
            ([b'\r', b'\n', ..], _) => "\r\n",
            ([b'\r', ..], _) => "\r",
            ([b'\n', ..], _) => "\n",
            (_, [.., b'\r', b'\n']) => "\r\n",
            (_, [.., b'\r']) => "\r",
            _ => "\n",
        }
    }
}

/// A number whose style is taken where no other is there.
const DECIMAL: &str = "0.";
