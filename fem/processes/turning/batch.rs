//! The table `[batch]`: parts, cycle, and what happens between parts.

use super::events::{Correction, Events, InsertChange, Pause};
use super::log;
use crate::input::Reader;
use crate::units::{MICRO, TIME};

/// Parts, cycle (s) and events of the batch.
pub fn read(model: &Reader, cutting_time: f64) -> (usize, f64, Events) {
    let batch = model.optional_table("batch", "the parts turned one after the other", |t| {
        let parts = t.count("parts", "how many parts").between(1, 1_000_000).or(1);
        let cycle = t
            .quantity("cycle_time", TIME, "from the start of one part to the start of the next")
            .positive()
            .or(cutting_time);
        if cycle < cutting_time * (1.0 - 1e-9) {
            let message = format!(
                "the cycle time of {:.4} is shorter than the cut, which takes {:.4}",
                TIME.shown(cycle),
                TIME.shown(cutting_time)
            );
            t.problem("cycle_time", message, "lengthen the cycle, or feed faster");
        }
        (parts, cycle, read_events(t, parts, cycle))
    });
    batch.unwrap_or((1, cutting_time, Events::default()))
}

/// The lists of `[batch]` and its log, of a batch of `parts` that begin a `cycle` (s) after one another.
fn read_events(t: &Reader, parts: usize, cycle: f64) -> Events {
    let pauses = t.list("pauses", "breaks between parts", |t, _| {
        let after = read_after(t, parts, "part after which the machine rests");
        Pause { after, duration: t.quantity("duration", TIME, "how long it rests").positive().required() }
    });
    let corrections = t.list("corrections", "corrections of the tool's offset between parts", |t, _| {
        let after = read_after(t, parts, "part after which the offset was corrected");
        Correction { after, diameter: t.quantity("diameter", MICRO, "change of all later diameters").required() }
    });
    let inserts = t.list("inserts", "changes of the insert, with which its wear begins anew", |t, _| {
        let after = read_after(t, parts, "part after which the insert was changed");
        let diameter = t.quantity("diameter", MICRO, "by how much the new edge leaves diameters larger").or(0.0);
        InsertChange { after, diameter }
    });
    let mut events = Events { pauses, corrections, inserts };
    for list in ["corrections", "inserts"] {
        if let Some(after) = events.twice(list) {
            t.problem(list, format!("two of `{list}` stand after part {after}"), "keep one of them");
        }
    }
    log::read(t, parts, cycle, &mut events);
    events.sort();
    events
}

/// The part after which something happens, within the batch.
fn read_after(t: &Reader, parts: usize, about: &'static str) -> usize {
    let after = t.count("after", about).between(1, 1_000_000).required();
    if after > parts {
        t.problem("after", format!("`after` is {after}"), format!("it must be a whole number from 1 to {parts}"));
    }
    after
}
