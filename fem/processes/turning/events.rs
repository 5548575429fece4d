//! Events of a batch, what a shop does between parts: the machine rests, the operator corrects the tool's offset,
//! an insert is changed.
//!
//! A correction moves the tool once and for all: every later part is cut by it larger or smaller, beside what the
//! machine answers to the other depth. A new insert begins to wear anew, and sits off by something of its own while
//! it cuts. Every part is clamped anew anyway: a clamping is no event.

use crate::input::Problem;

/// A rest of the machine after a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pause {
    /// Part number, from 1.
    pub after: usize,
    /// s.
    pub duration: f64,
}

/// A correction of the tool's offset after a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    /// Part number, from 1.
    pub after: usize,
    /// By how much later diameters are larger, m.
    pub diameter: f64,
}

/// A new insert after a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InsertChange {
    /// Part number, from 1.
    pub after: usize,
    /// By how much diameters are larger while it cuts, for it sits off, m.
    pub diameter: f64,
}

/// All events of a batch, each kind by rising part numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    /// Several after one part add up.
    pub pauses: Vec<Pause>,
    /// One after a part at most.
    pub corrections: Vec<Correction>,
    /// One after a part at most.
    pub inserts: Vec<InsertChange>,
}

impl Events {
    /// Adds one, unless one of its kind stands after that part already.
    ///
    /// # Errors
    /// It does.
    pub fn add(&mut self, event: Event) -> Result<(), Problem> {
        match event {
            Event::Pause(pause) => self.pauses.push(pause),
            Event::Correction(correction) => self.corrections.push(correction),
            Event::Insert(insert) => self.inserts.push(insert),
        }
        let list = event.list();
        match self.twice(list) {
            Some(after) => {
                let message = format!("two of `{list}` stand after part {after}");
                Err(Problem::new(message).help("keep one of them, in the log or in [batch]"))
            }
            None => Ok(()),
        }
    }

    /// A part after which two of a kind stand that does not add up.
    pub fn twice(&self, list: &str) -> Option<usize> {
        let mut after: Vec<usize> = match list {
            "corrections" => self.corrections.iter().map(|c| c.after).collect(),
            "inserts" => self.inserts.iter().map(|i| i.after).collect(),
            _ => Vec::new(),
        };
        after.sort_unstable();
        after.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
    }

    /// Puts every kind in order.
    pub fn sort(&mut self) {
        self.pauses.sort_by_key(|p| p.after);
        self.corrections.sort_by_key(|c| c.after);
        self.inserts.sort_by_key(|i| i.after);
    }
}

/// One of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The machine rests.
    Pause(Pause),
    /// The offset is corrected.
    Correction(Correction),
    /// The insert is changed.
    Insert(InsertChange),
}

impl Event {
    /// The list of `[batch]` in which it could stand.
    fn list(self) -> &'static str {
        match self {
            Self::Pause(_) => "pauses",
            Self::Correction(_) => "corrections",
            Self::Insert(_) => "inserts",
        }
    }
}
