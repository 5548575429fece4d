//! What spindle and tool stand on: a structure of the user's own, in the plane of the axis and the radial force.
//!
//! The cut parts them: under its radial force P the tool leaves the work by c·P, with c the compliance between the two nodes.
//! Of a blank that is out of round the part C·c/(1 + C·c) is copied, C being the force per depth of cut, as by a tool of the stiffness
//! 1/c [seed 002 (27)].

use std::sync::Arc;

use crate::input::Reader;
use crate::process::structure::{Draft, Drawn, Shares};
use crate::solve::structure::Freedom;

/// The machine around a ring.
#[derive(Clone, Debug)]
pub struct Base {
    drawn: Arc<Drawn>,
    /// What parts under a newton of the cut: the tool, and the spindle the other way if it stands on the structure.
    pushed: Vec<(Freedom, f64)>,
    compliance: f64,
}

impl Base {
    /// Reads the structure, if there is one.
    pub fn read(model: &Reader) -> Option<Self> {
        let about = "the machine around the ring: beams and joints in the plane of axis and radial force";
        let (drawn, pushed) = Draft::read(model, about, read_places)?;
        let drawn = drawn.of_springs(model, "around a ring")?;
        let moved = drawn.factored.under(&pushed);
        let compliance = pushed.iter().map(|(at, force)| force * moved[at.number()]).sum();
        Some(Self { drawn: Arc::new(drawn), pushed, compliance })
    }

    /// How far tool and spindle part under a newton between them, m/N.
    pub fn compliance(&self) -> f64 {
        self.compliance
    }

    /// Which of its parts give way, largest first, in words.
    pub fn told(&self) -> String {
        let mut shares = Shares::new(&self.drawn);
        shares.add(&self.drawn.factored.displaced(&self.pushed, &[], &[]), 1.0);
        shares.told(0)
    }
}

fn read_places(t: &Reader, draft: &mut Draft) -> Option<Vec<(Freedom, f64)>> {
    let node = |key: &'static str, about: &'static str| draft.holder(t, key, about, "it stands");
    let tool = node("tool", "the node that holds the tool");
    let is_asked = t.has("spindle") || t.is_described();
    let spindle = is_asked.then(|| node("spindle", "the node that holds the chuck; it stands firm if left out"));
    let mut pushed = vec![(tool?, 1.0)];
    if let Some(spindle) = spindle {
        let spindle = spindle?;
        if spindle == pushed[0].0 {
            let help = "draw what lies between them: a machine on which nothing parts them is none";
            t.problem("spindle", "tool and spindle are held by one node, which nothing parts", help);
        }
        pushed.push((spindle, -1.0));
    }
    Some(pushed)
}
