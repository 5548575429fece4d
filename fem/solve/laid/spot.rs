//! Where something presses on a part.

/// A face of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The flat one on which it lies.
    Underside,
    /// The other one, which may have steps.
    Top,
}

/// Direction of a force and of what is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Way {
    /// Down onto the supports.
    Down,
    /// Along the part, away from its beginning.
    Along,
}

/// A length of a face over which a force is spread evenly, or over which the mean is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The face.
    pub face: Face,
    /// Its middle, m from the part's end.
    pub at: f64,
    /// Length, m; 0 for a place. It matters to a plane body alone, into which a force at a place sinks without end.
    pub width: f64,
    /// The direction.
    pub way: Way,
}

impl Spot {
    /// A place, downwards.
    pub fn point(face: Face, at: f64) -> Self {
        Self { face, at, width: 0.0, way: Way::Down }
    }

    /// The same length of the face along the part.
    #[must_use]
    pub fn along(self) -> Self {
        Self { way: Way::Along, ..self }
    }

    /// Begin and end, m.
    pub fn ends(&self) -> (f64, f64) {
        (self.at - 0.5 * self.width, self.at + 0.5 * self.width)
    }
}
