//! What is told of a program that carries a correction.

use serde_json::{Value as Json, json};

use super::block::Block;
use super::json::finite;
use super::number;
use crate::compare::rms;
use crate::correct::{Offset, Programmed};
use crate::gcode::{Corrected, Other};
use crate::units::MICRO;

/// Most blocks that are named.
const MOST_NAMED: usize = 6;
/// Differences below this are none, m.
const NONE: f64 = 0.05e-6;

/// What was changed, what that carries, and what was left.
pub fn blocks(programmed: &Programmed) -> Vec<Block> {
    let Programmed { name, corrected, .. } = programmed;
    let um = |si: f64| number::trimmed(MICRO.from_si(si), 2);
    let signed = |si: f64| number::signed(MICRO.from_si(si), 2);
    let [low, high] = corrected.changed;
    let words = counted(corrected.words, "X word has another number", "X words have other numbers");
    let added = match corrected.added {
        0 => String::new(),
        count => format!(", {} put in", counted(count, "block or word is", "blocks and words are")),
    };
    let mut lines = vec![
        format!("{words}{added}, and nothing else is changed; the radius by {} to {} um", signed(low), signed(high)),
        format!("off the contour by {} um rms{}", um(corrected.left.rms), worst(corrected)),
    ];
    lines.extend(short(corrected).map(str::to_string));
    lines.extend(corrected.off.as_ref().filter(|(_, off)| off.abs() > NONE).map(|(block, off)| {
        let (size, by) = (if *off > 0.0 { "larger" } else { "smaller" }, um(2.0 * off.abs()));
        format!(
            "{block} sets a diameter {by} um {size} than that of the model; the change is added to what the program sets, \
             which is right if what the model knows was measured on parts of this program"
        )
    }));
    lines.extend(corrected.others.iter().take(MOST_NAMED).map(other));
    let more = corrected.others.len().saturating_sub(MOST_NAMED);
    lines.extend((more > 0).then(|| format!("{more} more blocks are left as they are for that")));
    lines.extend(corrected.unfinished.iter().take(MOST_NAMED).map(|[from, to]| {
        format!("no block cuts the part from x = {} to {} mm", number::mm(*from, 1), number::mm(*to, 1))
    }));
    vec![Block::Heading(format!("program {name}")), Block::List(lines)]
}

fn worst(corrected: &Corrected) -> String {
    let left = &corrected.left;
    let (by, x) = (number::trimmed(MICRO.from_si(left.worst), 2), number::mm(left.x, 1));
    if left.worst < NONE { String::new() } else { format!(", {by} um at worst, at x = {x} mm in {}", left.block) }
}

/// Why it does not carry the whole contour, if it does not.
fn short(corrected: &Corrected) -> Option<&'static str> {
    if corrected.could_add {
        return Some(
            "a straight block cannot bow: with `--add-blocks` others are put before it, and carry the contour",
        );
    }
    corrected.is_short.then_some(
        "what is left is in blocks before which none can be put, for they are round, count on (G91, U, W) or order more \
         than a motion and its feed: write these orders in blocks of their own",
    )
}

fn other(other: &Other) -> String {
    let [is, part] = other.radii.map(|r| number::mm(2.0 * r, 3));
    format!("{} is left as it is: it cuts at {is} mm of diameter where the part has {part} mm", other.block)
}

fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// The same for programs; SI.
pub fn json(programmed: &Programmed, key: &str, offsets: impl Fn(&[Offset]) -> Json) -> Json {
    let Programmed { name, corrected, with } = programmed;
    let left = &corrected.left;
    let other = |own: &Other| json!({ "block": own.block, "radius": own.radii[0], "radius_of_part": own.radii[1] });
    json!({
        "file": name,
        "words_changed": corrected.words,
        "added": corrected.added,
        key: corrected.changed.map(finite),
        "left": { "rms": left.rms, "worst": left.worst, "x": left.x, "block": left.block },
        "could_add_blocks": corrected.could_add,
        "left_as_they_are": corrected.others.iter().map(other).collect::<Vec<_>>(),
        "unfinished": corrected.unfinished,
        "rms": rms(&with.left),
        "offsets": offsets(&with.offsets),
    })
}
