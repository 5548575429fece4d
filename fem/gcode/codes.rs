//! What G and M words order, and which of them a correction cannot follow.

use super::axes::{Across, Axes, Machine};
use super::words::{Block, CORNER, Word};
use super::workpiece::{INCH, MM};
use crate::input::Problem;

/// How the tool moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// G0.
    Rapid,
    /// G1.
    Line,
    /// G2 and G3.
    Arc {
        /// G2.
        is_clockwise: bool,
    },
}

/// What words of a block are for where it makes no motion of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Once {
    /// A dwell: the words are times.
    Dwell,
    /// A way to a place that stands in the machine: afterwards nobody knows where the tool is in the program.
    Away,
    /// A limit of the spindle.
    Limit,
}

/// What lasts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// G7, G8.
    Across(Across),
    /// G17 to G19, in tenths.
    Plane(u32),
    /// G20, G21: m per unit.
    Unit(f64),
    /// G90, G91.
    Absolute(bool),
    /// G90.1, G91.1.
    AbsoluteCentres(bool),
    /// G54 to G59.3, in tenths.
    Zero(u32),
    /// G40, G41, G42 of a mill: whether the control moves the path aside by a radius of its own.
    Aside(bool),
}

/// The orders of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Orders {
    /// G0 to G3.
    pub motion: Option<Motion>,
    /// What else its words are for.
    pub once: Option<Once>,
    /// What lasts.
    pub settings: Vec<Setting>,
    /// Whether afterwards words count from another zero, by another tool.
    pub is_other_tool: bool,
    /// Whether the length of the tool comes into force or goes.
    pub is_other_length: bool,
    /// Whether it is the last of the program.
    pub ends: bool,
    /// Whether G90, G92 or G94 stand in it, each of which is a cycle in the G codes of system A where places stand
    /// beside it.
    pub may_be_a_cycle: bool,
    /// Whether nothing but a motion is ordered.
    pub is_plain: bool,
}

/// Orders that are refused, in tenths: from, to, what each is, and what to do.
type Refused = (u32, u32, &'static str, &'static str);

/// Those of any machine.
const REFUSED: &[Refused] = &[
    (50, 59, "is a curve that the control computes", "write it as G1, G2 and G3"),
    (71, 71, "wraps the path around a cylinder", TURN),
    (
        100,
        100,
        "changes an offset, so that later words count from elsewhere",
        "set offsets at the control, not in the program",
    ),
    (121, 121, "turns to polar coordinates", TURN),
    (160, 160, "turns to polar coordinates", TURN),
    (220, 220, "is a subprogram call or a limit of the travel, by the control", CALL),
    (320, 349, "cuts a thread", "take the program without its thread: threads have no finished diameter here"),
    (520, 520, "moves the zero", ZERO),
    (650, 679, "calls a macro", CALL),
    (680, 689, "turns or mirrors the coordinates", ZERO),
    (700, 769, "is a cycle: the control computes its passes", CYCLE),
    (810, 899, "is a cycle: the control computes its way", CYCLE),
    (930, 930, "makes of F an inverse time", "write the feed by G94 or G95"),
    (1120, 1120, "turns to polar coordinates", TURN),
];

/// Those of lathes alone: a nose radius moves the path across.
const OF_LATHES: &[Refused] = &[(
    410,
    422,
    "moves the path by a nose radius that stands in the control, which a new contour would turn with it",
    NOSE,
)];

/// Those of mills alone: a radius of the cutter moves the path aside, and no height.
const OF_MILLS: &[Refused] = &[
    (411, 412, "takes the cutter's radius from the program", ASIDE),
    (421, 422, "takes the cutter's radius from the program", ASIDE),
    (510, 511, "scales or mirrors the coordinates", ZERO),
];

/// Remedy for paths beside which the control drives.
pub const ASIDE: &str = "let the CAM system write the path of the cutter's middle with G40";
const TURN: &str = "write the path in straight coordinates, or take the rest of the program alone";
const CALL: &str = "write the blocks of the subprogram in its place";
const NOSE: &str = "let the CAM system write the path of the nose's point with G40";
const ZERO: &str = "write the program from one zero";
/// Remedy for cycles.
const CYCLE: &str = "write out the finishing pass in plain G1, G2 and G3 blocks; roughing and holes may stand in a program of \
                     their own";

impl Orders {
    /// The orders of a block of a machine's program.
    ///
    /// # Errors
    /// One of them cannot be followed.
    pub fn of(block: &Block, machine: Machine) -> Result<Self, Problem> {
        let mut orders = Self { is_plain: true, ..Self::default() };
        for word in &block.words {
            match word.letter {
                b'G' => orders.general(word, machine)?,
                b'M' => orders.miscellaneous(word, block, machine)?,
                // On a mill it makes a tool ready, which M6 takes.
                b'T' => orders.is_other_tool |= machine == Machine::Lathe,
                _ => {}
            }
            orders.is_plain &= !matches!(word.letter, b'M' | b'T' | b'S');
        }
        Ok(orders)
    }

    fn general(&mut self, word: &Word, machine: Machine) -> Result<(), Problem> {
        let tenths = (10.0 * word.value).round() as u32;
        if word.value < 0.0 || (10.0 * word.value - f64::from(tenths)).abs() > 1e-6 {
            return Err(unknown(word));
        }
        let own = if machine == Machine::Lathe { OF_LATHES } else { OF_MILLS };
        if let Some((_, _, what, help)) = REFUSED.iter().chain(own).find(|own| (own.0..=own.1).contains(&tenths)) {
            return Err(word.problem(format!("`{}` {what}", word.shown()), help));
        }
        let motion = match tenths {
            0 => Some(Motion::Rapid),
            10 => Some(Motion::Line),
            20 | 30 => Some(Motion::Arc { is_clockwise: tenths == 20 }),
            _ => None,
        };
        if motion.is_some() {
            let second = self.motion.is_some() && self.motion != motion;
            self.motion = motion;
            let help = "let each motion stand in a block of its own";
            return if second { Err(word.problem("a second motion stands in the block", help)) } else { Ok(()) };
        }
        self.is_plain = false;
        self.may_be_a_cycle |= machine == Machine::Lathe && matches!(tenths, 900 | 920 | 940);
        self.is_other_length |= matches!(tenths, 430 | 431 | 490);
        match tenths {
            40 => self.once = Some(Once::Dwell),
            280 | 300 | 530 => self.once = Some(Once::Away),
            500 | 920 => self.once = Some(Once::Limit),
            _ => match setting(tenths, machine) {
                Some(setting) => self.settings.push(setting),
                None if is_harmless(tenths, machine) => {}
                None => return Err(unknown(word)),
            },
        }
        Ok(())
    }

    fn miscellaneous(&mut self, word: &Word, block: &Block, machine: Machine) -> Result<(), Problem> {
        match word.value {
            96.0..=98.0 => Err(word.problem(format!("`{}` calls a subprogram", word.shown()), CALL)),
            99.0 if block.word(b'P').is_some() => {
                Err(word.problem("`M99` jumps to a block", "write the blocks in the order in which they run"))
            }
            6.0 if machine == Machine::Mill => {
                self.is_other_tool = true;
                Ok(())
            }
            2.0 | 30.0 | 99.0 => {
                self.ends = true;
                Ok(())
            }
            _ => Ok(()),
        }
    }
}

fn setting(tenths: u32, machine: Machine) -> Option<Setting> {
    Some(match (tenths, machine) {
        (70, Machine::Lathe) => Setting::Across(Across::Diameter),
        (80, Machine::Lathe) => Setting::Across(Across::Radius),
        (400, Machine::Mill) => Setting::Aside(false),
        (410 | 420, Machine::Mill) => Setting::Aside(true),
        _ => return modal(tenths),
    })
}

/// What lasts on any machine.
fn modal(tenths: u32) -> Option<Setting> {
    Some(match tenths {
        170 | 180 | 190 => Setting::Plane(tenths),
        200 => Setting::Unit(INCH),
        210 => Setting::Unit(MM),
        540 | 550 | 560 | 570 | 580 | 590..=593 => Setting::Zero(tenths),
        900 => Setting::Absolute(true),
        910 => Setting::Absolute(false),
        901 => Setting::AbsoluteCentres(true),
        911 => Setting::AbsoluteCentres(false),
        _ => return None,
    })
}

/// Exact stops, smoothing, no compensation, lengths of tools, no cycle, feeds and speeds, return levels; on mills that
/// nothing is polar, mirrored or turned.
fn is_harmless(tenths: u32, machine: Machine) -> bool {
    let is_off = machine == Machine::Mill && matches!(tenths, 150 | 501 | 690);
    is_off || matches!(tenths, 90 | 400 | 430 | 431 | 490 | 610 | 611 | 640 | 800 | 940 | 950 | 960 | 970 | 980 | 990)
}

fn unknown(word: &Word) -> Problem {
    let help = "take it out, or write what it does in plain blocks: a path that is not understood is not corrected";
    word.problem(format!("what `{}` does is not known here", word.shown()), help)
}

/// The first word of a block that does not belong to what the block does.
///
/// # Errors
/// There is one.
pub fn check_letters(block: &Block, orders: &Orders, moves: Option<Motion>, axes: &Axes) -> Result<(), Problem> {
    let of_path = |letter: u8| [axes.letters, axes.steps, &axes.centres].iter().any(|all| all.contains(&letter));
    let has = |tenths: &[f64]| block.words.iter().any(|word| word.letter == b'G' && tenths.contains(&word.value));
    let has_m = block.word(b'M').is_some();
    for word in &block.words {
        let shown = word.shown();
        let is_arc = matches!(moves, Some(Motion::Arc { .. }));
        let is_known = match word.letter {
            b'G' | b'M' | b'N' | b'S' | b'F' | b'T' => true,
            b'P' => has_m || orders.once == Some(Once::Dwell) || has(&[64.0]),
            b'Q' => has(&[64.0]),
            b'H' => has(&[43.0]),
            b'D' => has(&[41.0, 42.0, 96.0]),
            letter if (letter == b'R' || axes.centres.contains(&letter)) && moves.is_some() && !is_arc => {
                return Err(word.problem(
                    format!("`{shown}` beside a straight motion is a corner that the control computes"),
                    CORNER,
                ));
            }
            b'R' => is_arc,
            b'C' | b'A' if moves == Some(Motion::Line) => {
                return Err(word.problem(format!("`{shown}` is a chamfer, an angle or another axis"), CORNER));
            }
            b'O' => {
                let message = format!("`{shown}` begins a further program or a subprogram");
                return Err(word.problem(message, "take the finishing program alone"));
            }
            letter => of_path(letter),
        };
        if !is_known {
            return Err(word.problem(
                format!("what `{shown}` does in this block is not known here"),
                "take it out, or write what it does in plain blocks",
            ));
        }
    }
    Ok(())
}
