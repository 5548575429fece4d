//! Words of label columns as people and instruments write them.

use crate::process::Words;

/// Words that mean the same, the program's own first.
const SAME: &[&[&str]] = &[
    &["+", "+1", "1", "forward", "forwards", "fwd", "up", "pos", "positive", "plus", "↑"],
    &["-", "-1", "−", "−1", "–", "backward", "backwards", "bwd", "reverse", "down", "neg", "negative", "minus", "↓"],
    &["forward", "forwards", "fwd"],
    &["reverse", "reversed", "backward", "backwards", "bwd"],
    &["ccw", "counter-clockwise", "counterclockwise", "anticlockwise", "anti-clockwise"],
    &["cw", "clockwise"],
    &["load", "loading"],
    &["unload", "unloading"],
];

/// The word of a list that a cell means; capitals do not matter.
pub fn meant<'w>(cell: &str, words: &'w Words) -> Option<&'w str> {
    let cell = cell.to_lowercase();
    let means = |word: &&str| {
        let same = SAME.iter().find(|group| group[0] == *word);
        *word == cell || same.is_some_and(|group| group.contains(&&*cell))
    };
    words.iter().find(means)
}
