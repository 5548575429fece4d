//! What spindle and tool stand on: a structure of the user's own, in the plane of the axis and the radial force.
//!
//! The cut parts them: under its radial force P the tool leaves the work by c·P, with c the compliance between the two nodes.
//! Of a blank that is out of round the part C·c/(1 + C·c) is copied, C being the force per depth of cut, as by a tool of the stiffness
//! 1/c [seed 002 (27)]. Where a joint is no spring, how far they part is counted from what the mean force of the cut leaves.

use std::sync::Arc;

use crate::input::Reader;
use crate::process::Failure;
use crate::process::structure::{Draft, Drawn, Place, Places, Shares};

/// The machine around a ring.
#[derive(Clone, Debug)]
pub struct Base {
    drawn: Arc<Drawn>,
    /// What parts under a newton of the cut: the tool, and the spindle the other way if it stands on the structure.
    pushed: Place,
    places: Places,
    /// Mean radial force of the cut, N; 0 where nothing depends on it.
    force: f64,
    /// How far tool and spindle part under it, m, and how much more under a newton more, m/N.
    parted: [f64; 2],
}

impl Base {
    /// Reads the structure, if there is one, under the mean radial force of the cut (N), if that is said.
    pub fn read(model: &Reader, force: Option<f64>) -> Option<Self> {
        let about = "the machine around the ring: beams and joints in the plane of axis and radial force";
        let read = Draft::read(model, about, read_places);
        let seat = read.as_ref().and_then(|(drawn, _)| Some(&drawn.joints[drawn.seats.first()?.spring]));
        match (seat, force) {
            (Some(name), None) => {
                let message =
                    format!("`structure.{name}` is no spring, and how hard the cut presses on it is not said");
                model.problem_in("structure", name, message, "add radial_force = \"200 N\" to [cut], its mean");
                return None;
            }
            (None, Some(_)) if !model.is_described() && (read.is_some() || !model.has("structure")) => {
                let message = "`radial_force` is for joints of a [structure] that are no springs, and there are none";
                model.problem_in(
                    "cut",
                    "radial_force",
                    message,
                    "leave it out: force_per_depth says how the force changes",
                );
            }
            _ => {}
        }
        let (drawn, pushed) = read?;
        let places = Places::new(&drawn, std::slice::from_ref(&pushed), std::slice::from_ref(&pushed));
        let force = force.unwrap_or(0.0);
        let mut base = Self { drawn: Arc::new(drawn), pushed, places, force, parted: [0.0; 2] };
        match base.under(force) {
            Ok(parted) => base.parted = parted,
            // Values that are sought come with a search.
            Err(_) if force.is_nan() || !base.places.are_known() => base.parted = [f64::NAN; 2],
            Err(Failure { message, help }) => {
                model.problem("structure", message, help);
                return None;
            }
        }
        Some(base)
    }

    /// How far tool and spindle part under a newton more between them than in the mean, m/N.
    pub fn compliance(&self) -> f64 {
        self.parted[1]
    }

    /// Mean radial force of the cut (N), where what parts is not as large as the force; `None` where it is.
    pub fn mean_force(&self) -> Option<f64> {
        (!self.places.are_linear()).then_some(self.force)
    }

    /// How much farther tool and spindle part under a force (N) than under that of the cut in the mean, m, and how much more
    /// under a newton more, m/N.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn farther(&self, force: f64) -> Result<[f64; 2], Failure> {
        let [parted, rate] = self.under(force)?;
        Ok([parted - self.parted[0], rate])
    }

    fn under(&self, force: f64) -> Result<[f64; 2], Failure> {
        let pushed = self.places.under(&[(0, force)]).map_err(|error| self.drawn.failure(error))?;
        Ok([pushed.moved()[0], pushed.rates()[(0, 0)]])
    }

    /// Which of its parts give way to a little more force, largest first, in words.
    pub fn told(&self) -> String {
        let mut shares = Shares::new(&self.drawn);
        let seats = self.places.under(&[(0, self.force)]).map(|pushed| pushed.seat_rates().as_slice().to_vec());
        let feet = self.drawn.feet(&seats.unwrap_or_default());
        shares.add(&self.drawn.factored.displaced(&self.pushed, &[], &feet), 1.0);
        shares.told(0)
    }
}

fn read_places(t: &Reader, draft: &mut Draft) -> Option<Place> {
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
