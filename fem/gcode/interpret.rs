//! A program as a control reads it: word by word, every mode in force, until it ends.

use super::arc;
use super::axes::{Across, Axes, Machine};
use super::codes::{Motion, Once, Orders, Setting, check_letters};
use super::spot::Spot;
use super::steps::{Centre, Cut, Shape, Step};
use super::words::{Block, Word};
use super::workpiece::{MM, Workpiece};
use crate::input::Problem;

/// By how much ends of an arc that lies at one level may differ by round-off, m.
const LEVEL: f64 = 1e-9;

/// What is in force, and where the tool is.
struct Control<'a> {
    work: &'a Workpiece,
    motion: Option<Motion>,
    across: Across,
    unit: f64,
    is_absolute: bool,
    has_absolute_centres: bool,
    /// The plane of arcs, by its code in tenths.
    plane: u32,
    /// Whether the control moves the path aside by a radius of its own.
    is_aside: bool,
    zero: Option<u32>,
    /// The level, the place along the part and that beside, m, as far as the program has told.
    place: [Option<f64>; 3],
    /// Whether a block that may be skipped has brought the tool there.
    is_unsure: [bool; 3],
    /// The words by which it counts on, once one was seen: U and W, or G90 and G91.
    counts: Option<Counts>,
    has_ended: bool,
    has_begun: bool,
}

/// The way in which a program counts on.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Counts {
    /// Words of their own, on controls with the G codes of system A, where G90 is a cycle.
    Words,
    /// G90 and G91.
    Modes,
}

/// The steps of a program.
///
/// # Errors
/// What cannot be followed, block by block.
pub fn steps(blocks: &[Block], work: &Workpiece) -> Result<Vec<Step>, Vec<Problem>> {
    let mut control = Control::new(work);
    let (mut steps, mut problems) = (Vec::new(), Vec::new());
    for (number, block) in blocks.iter().enumerate() {
        match control.read(number, block) {
            Ok(step) => steps.extend(step),
            Err(problem) => problems.push(problem),
        }
        if control.has_ended {
            break;
        }
    }
    if problems.is_empty() { Ok(steps) } else { Err(problems) }
}

impl<'a> Control<'a> {
    fn new(work: &'a Workpiece) -> Self {
        Self {
            work,
            motion: None,
            across: work.across,
            unit: MM,
            is_absolute: true,
            has_absolute_centres: false,
            plane: work.axes.plane,
            is_aside: false,
            zero: None,
            place: work.axes.nowhere(),
            is_unsure: [false; 3],
            counts: None,
            has_ended: false,
            has_begun: false,
        }
    }

    fn read(&mut self, number: usize, block: &Block) -> Result<Option<Step>, Problem> {
        if block.is_mark {
            self.has_ended = self.has_begun;
            return Ok(None);
        }
        // The number of the program stands at its head.
        let is_head = !self.has_begun && block.words.iter().all(|word| matches!(word.letter, b'O' | b'N'));
        if block.problem.is_none() && (block.words.is_empty() || is_head) {
            return Ok(None);
        }
        self.has_begun = true;
        if let Some(problem) = &block.problem {
            return Err(problem.clone());
        }
        let orders = Orders::of(block, self.work.axes.machine)?;
        self.has_ended = orders.ends;
        let level = self.place[0];
        orders.settings.iter().try_for_each(|setting| self.set(*setting, block))?;
        let Axes { letters, steps, .. } = self.work.axes;
        let path: Vec<&Word> =
            block.words.iter().filter(|word| letters.contains(&word.letter) || steps.contains(&word.letter)).collect();
        self.refuse_cycles(&orders, &path)?;
        let moves = (orders.once.is_none() && !path.is_empty()).then(|| orders.motion.or(self.motion)).flatten();
        check_letters(block, &orders, moves, &self.work.axes)?;
        if orders.once != Some(Once::Dwell) {
            self.motion = orders.motion.or(self.motion);
        }
        match self.work.axes.machine {
            // A length changes the height alone, and everything on a lathe, whose tools are measured both ways.
            Machine::Mill if orders.is_other_length && !orders.is_other_tool => self.place[0] = None,
            _ if orders.is_other_tool || orders.is_other_length => self.place = self.work.axes.nowhere(),
            _ => {}
        }
        match (orders.once, path.first()) {
            (Some(Once::Away), _) => self.place = self.work.axes.nowhere(),
            (Some(Once::Dwell | Once::Limit), _) | (None, None) => {}
            (None, Some(first)) => {
                let Some(motion) = moves else {
                    let help = "write G0 or G1 before it: what a control does without differs";
                    return Err(first.problem("a place is told before any motion", help));
                };
                return self.step(number, block, motion, orders.is_plain).map(Some);
            }
        }
        let is_lost = level.is_some() && self.place[0].is_none();
        Ok(is_lost.then(|| self.ended(number)))
    }

    /// A step that ends where the tool is now, and cuts nothing.
    fn ended(&self, block: usize) -> Step {
        let scale = self.unit * self.across.share();
        Step { block, word: None, is_on: false, unit: self.unit, scale, r: self.place[0], cut: None, is_plain: false }
    }

    fn set(&mut self, setting: Setting, block: &Block) -> Result<(), Problem> {
        match setting {
            Setting::Across(across) => self.across = across,
            Setting::Plane(plane) => self.plane = plane,
            Setting::Aside(is_aside) => self.is_aside = is_aside,
            Setting::Unit(unit) => self.unit = unit,
            Setting::AbsoluteCentres(is_absolute) => self.has_absolute_centres = is_absolute,
            Setting::Absolute(is_absolute) => {
                self.counted(Counts::Modes, block.word(b'G').unwrap_or(&block.words[0]))?;
                self.is_absolute = is_absolute;
            }
            Setting::Zero(zero) => {
                if self.zero.is_some_and(|other| other != zero) {
                    let word = block.word(b'G').unwrap_or(&block.words[0]);
                    let help = "write the program from one zero: [program] of the model knows one";
                    return Err(word.problem("a second zero comes into force", help));
                }
                if self.zero.is_none() {
                    self.place = self.work.axes.nowhere();
                }
                self.zero = Some(zero);
            }
        }
        Ok(())
    }

    /// Takes note of the way in which the program counts on.
    fn counted(&mut self, by: Counts, word: &Word) -> Result<(), Problem> {
        if self.counts.is_some_and(|other| other != by) {
            let message = "the program counts on by U or W, and has G90 or G91, which are other things on one control";
            return Err(word.problem(message, "count on by one of them alone"));
        }
        self.counts = Some(by);
        Ok(())
    }

    fn refuse_cycles(&self, orders: &Orders, path: &[&Word]) -> Result<(), Problem> {
        let Some(first) = path.first() else { return Ok(()) };
        if orders.once == Some(Once::Limit) {
            let help = "set zeros at the control: a place beside G50 or G92 moves the zero or cuts a thread";
            return Err(first.problem("this moves the zero or cuts a thread", help));
        }
        if orders.may_be_a_cycle && orders.motion.is_none() {
            let help = "write G90 or G94 in a block of its own, or a G1 beside it";
            return Err(first.problem("on controls with the G codes of system A this is a cycle", help));
        }
        Ok(())
    }

    /// Where a block ends on an axis, the word that says so, and whether that counts on.
    fn target(&mut self, block: &Block, axis: usize, unit: f64) -> Result<(Option<f64>, Option<usize>, bool), Problem> {
        let Axes { letters, steps, .. } = self.work.axes;
        let find = |letter: u8| block.words.iter().position(|word| word.letter == letter);
        let (own, on) = (find(letters[axis]), steps.get(axis).and_then(|letter| find(*letter)));
        let is_doubled = |at: usize| block.words[at + 1..].iter().any(|word| word.letter == block.words[at].letter);
        let (at, is_on) = match (own, on) {
            (None, None) => return Ok((self.place[axis], None, false)),
            (Some(_), Some(on)) => {
                return Err(block.words[on].problem("an axis is told twice in the block", "keep one of both words"));
            }
            (Some(own), None) => (own, !self.is_absolute),
            (None, Some(on)) => {
                self.counted(Counts::Words, &block.words[on])?;
                (on, true)
            }
        };
        let word = &block.words[at];
        if is_doubled(at) {
            return Err(word.problem("an axis is told twice in the block", "keep one of both words"));
        }
        let is_skipped = block.skip.is_some();
        if is_on && self.is_unsure[axis] && !is_skipped {
            let help = "write this word as an absolute place, or take the block with `/` out";
            return Err(word.problem("this counts on from a block that may be skipped", help));
        }
        self.is_unsure[axis] = is_skipped || (is_on && self.is_unsure[axis]);
        let zero = self.work.zero.in_axes()[axis];
        let end =
            if is_on { self.place[axis].map(|now| now + word.value * unit) } else { Some(zero + word.value * unit) };
        Ok((end, Some(at), is_on))
    }

    fn step(&mut self, number: usize, block: &Block, motion: Motion, is_plain: bool) -> Result<Step, Problem> {
        let before = self.place;
        let scale = self.unit * self.across.share();
        let (r, word, is_on) = self.target(block, 0, scale)?;
        let (mut to, mut is_told, mut counts_on) = (self.place, false, is_on);
        to[0] = r;
        for (axis, to) in to.iter_mut().enumerate().take(self.work.axes.letters.len()).skip(1) {
            let (end, along, is_along_on) = self.target(block, axis, self.unit)?;
            *to = end;
            is_told |= along.is_some();
            counts_on |= is_along_on;
        }
        self.place = to;
        let cut = match motion {
            Motion::Rapid => None,
            _ => Some(self.cut(block, motion, before)?),
        };
        let is_plain = is_plain && motion == Motion::Line && !counts_on && is_told;
        Ok(Step { word, is_on, cut, is_plain, ..self.ended(number) })
    }

    fn cut(&self, block: &Block, motion: Motion, before: [Option<f64>; 3]) -> Result<Cut, Problem> {
        let place = |[r, x, y]: [Option<f64>; 3]| Some(Spot::of_axes([r?, x?, y?]));
        let (Some(from), Some(to)) = (place(before), place(self.place)) else {
            let help = "tell all places in absolute words before: after a tool change, a way to a machine's place or a new zero \
                        the program's place is not known";
            return Err(block.words[0].problem("nobody can tell where this cut begins or ends", help));
        };
        let shape = match motion {
            Motion::Arc { is_clockwise } => self.arc(block, (from, to), is_clockwise)?,
            _ => Shape::Line,
        };
        Ok(Cut { from, to, shape, is_aside: self.is_aside })
    }

    fn arc(&self, block: &Block, (from, to): (Spot, Spot), is_clockwise: bool) -> Result<Shape, Problem> {
        let (first, axes) = (&block.words[0], &self.work.axes);
        if self.plane != axes.plane {
            let plane = axes.plane_name();
            let message = format!("the arc lies in a plane other than {plane}");
            return Err(first.problem(message, &format!("write {plane} before it")));
        }
        if !axes.has_arcs_across() && (from.r - to.r).abs() > LEVEL {
            let message = "the arc climbs: a helix has no one height";
            return Err(first.problem(message, "write it as straight pieces, or let it run at one height"));
        }
        let of_plane = |spot: Spot| axes.of_plane.map(|axis| spot.in_axes()[axis]);
        let ends = [from, to].map(of_plane);
        let (radius, words) = (block.word(b'R'), axes.centres.map(|letter| block.word(letter)));
        let (written, centre) = match (radius, words.iter().any(Option::is_some)) {
            (Some(radius), false) => {
                (Centre::Radius, arc::centre(ends[0], ends[1], radius.value * self.unit, is_clockwise))
            }
            (None, true) => {
                let of = |word: Option<&Word>| word.map_or(0.0, |word| word.value * self.unit);
                let (written, origin) = match self.has_absolute_centres {
                    true => (Centre::Absolute, of_plane(self.work.zero)),
                    false => (Centre::FromStart, ends[0]),
                };
                (written, Some([origin[0] + of(words[0]), origin[1] + of(words[1])]))
            }
            _ => {
                let [a, b] = axes.centre_names();
                return Err(first.problem("the arc has no centre, or two", &format!("write R, or {a} and {b}")));
            }
        };
        // On a mill a circle may end where it began.
        let is_way = ends[0] != ends[1] || !axes.has_arcs_across();
        let sound = centre.filter(|centre| is_way && arc::is_round(ends[0], ends[1], *centre));
        sound.map(|centre| Shape::Arc { is_clockwise, centre, written }).ok_or_else(|| {
            let help = match axes.machine {
                Machine::Lathe => {
                    "I is a radius even where X is a diameter; is X a diameter here? [program] of the model says x = \"radius\" else"
                }
                Machine::Mill => "I and J lead from the start of the arc to its centre, unless G90.1 says otherwise",
            };
            first.problem("the ends of the arc are not on one circle about its centre", help)
        })
    }
}
