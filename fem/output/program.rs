//! What is told of a program that carries a correction.

use serde_json::{Value as Json, json};

use super::block::Block;
use super::json::finite;
use super::number;
use crate::compare::rms;
use crate::correct::{Offset, Programmed};
use crate::gcode::{Corrected, Deeper, Level, Machine, Other};
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
    let (level, letter) = (corrected.axes.level, char::from(corrected.axes.letters[0]));
    let one = format!("{letter} word has another number");
    let words = counted(corrected.words, &one, &format!("{letter} words have other numbers"));
    let added = match corrected.added {
        0 => String::new(),
        count => format!(", {} put in", counted(count, "block or word is", "blocks and words are")),
    };
    let mut lines = vec![
        format!(
            "{words}{added}, and nothing else is changed; the {} by {} to {} um",
            level.name(),
            signed(low),
            signed(high)
        ),
        format!("off the contour by {} um rms{}", um(corrected.left.rms), worst(corrected)),
    ];
    lines.extend(short(corrected).map(str::to_string));
    lines.extend(corrected.deeper.filter(|own| own.worst > NONE).map(deeper));
    lines.extend(corrected.off.as_ref().filter(|(_, off)| off.abs() > NONE).map(|(block, off)| {
        let (measured, times) = level.measured();
        let (size, by) = (larger(level, *off > 0.0), um(times * off.abs()));
        format!(
            "{block} sets a {measured} {by} um {size} than that of the model; the change is added to what the program sets, \
             which is right if what the model knows was measured on parts of this program"
        )
    }));
    lines.extend(corrected.others.iter().take(MOST_NAMED).map(|own| other(level, own)));
    let more = corrected.others.len().saturating_sub(MOST_NAMED);
    lines.extend((more > 0).then(|| format!("{more} more blocks are left as they are for that")));
    lines.extend(corrected.unfinished.iter().take(MOST_NAMED).map(|[from, to]| {
        let what = if corrected.axes.machine == Machine::Mill { "over the whole width" } else { "the part" };
        format!("no block cuts {what} from x = {} to {} mm", number::mm(*from, 1), number::mm(*to, 1))
    }));
    vec![Block::Heading(format!("program {name}")), Block::List(lines)]
}

fn worst(corrected: &Corrected) -> String {
    let left = &corrected.left;
    let (by, [x, y]) = (number::trimmed(MICRO.from_si(left.worst), 2), [left.x, left.y].map(|at| number::mm(at, 1)));
    let place = match corrected.axes.machine {
        Machine::Lathe => format!("x = {x} mm"),
        Machine::Mill => format!("x = {x}, y = {y} mm"),
    };
    if left.worst < NONE { String::new() } else { format!(", {by} um at worst, at {place} in {}", left.block) }
}

/// What the model, whose cutter cuts where its middle stands, does not know of a flat one.
fn deeper(deeper: Deeper) -> String {
    let [rms, worst] = [deeper.rms, deeper.worst].map(|si| number::trimmed(MICRO.from_si(si), 2));
    format!(
        "a flat cutter, square to the table, stands lower before or after its middle passes a place: reaching {} mm it takes {rms} um \
         rms more, {worst} um at worst, which is in no figure above",
        number::mm(deeper.reach, 1)
    )
}

fn larger(level: Level, is_so: bool) -> &'static str {
    match (level, is_so) {
        (Level::Radius, true) => "larger",
        (Level::Radius, false) => "smaller",
        (Level::Height, true) => "higher",
        (Level::Height, false) => "lower",
    }
}

/// Why it does not carry the whole contour, if it does not.
fn short(corrected: &Corrected) -> Option<&'static str> {
    if corrected.could_add {
        return Some(
            "a straight block cannot bow: with `--add-blocks` others are put before it, and carry the contour",
        );
    }
    corrected.is_short.then_some(match corrected.axes.machine {
        Machine::Lathe => {
            "what is left is in blocks before which none can be put, for they are round, count on (G91, U, W) or order more \
             than a motion and its feed: write these orders in blocks of their own"
        }
        Machine::Mill => {
            "what is left is across the tracks, each of which has one height over the breadth that it makes; or in blocks before \
             which none can be put, for they are round, count on (G91) or order more than a motion and its feed"
        }
    })
}

fn other(level: Level, other: &Other) -> String {
    let (measured, times) = level.measured();
    let [is, part] = other.levels.map(|level| number::mm(times * level, 3));
    format!("{} is left as it is: it cuts at {is} mm of {measured} where the part has {part} mm", other.block)
}

fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// The same for programs; SI.
pub fn json(programmed: &Programmed, key: &str, offsets: impl Fn(&[Offset]) -> Json) -> Json {
    let Programmed { name, corrected, with } = programmed;
    let left = &corrected.left;
    let level = corrected.axes.level.name();
    let of_part = format!("{level}_of_part");
    let other = |own: &Other| json!({ "block": own.block, level: own.levels[0], of_part.as_str(): own.levels[1] });
    let mut place = json!({ "rms": left.rms, "worst": left.worst, "x": left.x });
    if corrected.axes.machine == Machine::Mill {
        place["y"] = json!(left.y);
    }
    place["block"] = json!(left.block);
    json!({
        "file": name,
        "words_changed": corrected.words,
        "added": corrected.added,
        key: corrected.changed.map(finite),
        "left": place,
        "deeper": corrected.deeper.map(|own| json!({ "reach": own.reach, "rms": own.rms, "worst": own.worst })),
        "could_add_blocks": corrected.could_add,
        "left_as_they_are": corrected.others.iter().map(other).collect::<Vec<_>>(),
        "unfinished": corrected.unfinished,
        "rms": rms(&with.left),
        "offsets": offsets(&with.offsets),
    })
}
