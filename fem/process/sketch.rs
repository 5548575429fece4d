//! A machine to scale in a plane, with what holds it, what acts on it, and how it gives way. Plain data, SI units, no
//! knowledge of any file format.

/// A drawing of a machine.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sketch {
    /// Subject, in a few words.
    pub title: String,
    /// From the back to the front.
    pub parts: Vec<Part>,
}

/// A piece of a [`Sketch`]; places in m.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// A body by the lines around it, each closed; what a second line encloses is a hole.
    Body(Vec<Vec<[f64; 2]>>),
    /// A line that is bent: places, and the displacement of each.
    Bent(Vec<([f64; 2], [f64; 2])>),
    /// A spring between a place and what stands still.
    Spring {
        /// Where it holds.
        at: [f64; 2],
        /// Away from what it holds; of unit length.
        away: [f64; 2],
        /// Beside it.
        label: String,
    },
    /// A rigid support.
    Support {
        /// Where it holds.
        at: [f64; 2],
        /// Away from what it holds; of unit length.
        away: [f64; 2],
        /// Beside it.
        label: String,
    },
    /// A force on a place, N.
    Force {
        /// Where it acts.
        at: [f64; 2],
        /// Its components.
        force: [f64; 2],
        /// Beside it.
        label: String,
    },
}

impl Part {
    /// A body between two corners.
    pub fn rectangle([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> Self {
        Self::Body(vec![vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]]])
    }
}
