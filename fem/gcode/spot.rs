//! Places of the tool.

/// A place of the tool on the part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    /// Along the part, m.
    pub x: f64,
    /// Beside the middle of its breadth, m; 0 on a lathe.
    pub y: f64,
    /// Its level: a radius on a lathe, a height on a mill, m.
    pub r: f64,
}

impl Spot {
    /// The coordinates of axes by their positions: across, along, beside.
    pub fn of_axes([r, x, y]: [f64; 3]) -> Self {
        Self { x, y, r }
    }

    /// By the positions of axes: across, along, beside.
    pub fn in_axes(self) -> [f64; 3] {
        [self.r, self.x, self.y]
    }

    /// On the straight way to another, at a share of it.
    pub fn toward(self, other: Self, share: f64) -> Self {
        let on = |from: f64, to: f64| from + share * (to - from);
        Self { x: on(self.x, other.x), y: on(self.y, other.y), r: on(self.r, other.r) }
    }
}
