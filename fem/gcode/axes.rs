//! What sets one machine's programs apart from another's: its axes, the plane of its arcs, and what a word across the
//! part says.

/// A machine whose programs are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Machine {
    /// A lathe: its tool makes a profile.
    Lathe,
    /// A mill: its cutter makes a top, by tracks beside each other.
    Mill,
}

/// The axes of a machine. The first is that across the part, whose words are corrected; the others run along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    /// Of which machine, for what its codes order.
    pub machine: Machine,
    /// Letters of their words, in capitals.
    pub letters: &'static [u8],
    /// Letters of words of the same axes that count on from where the tool stands; none where G91 alone does.
    pub steps: &'static [u8],
    /// The plane of arcs, by its G code in tenths.
    pub plane: u32,
    /// Its axes, by their positions: that to the right and that upwards, as clockwise is seen.
    pub of_plane: [usize; 2],
    /// Letters of the words of a centre, of both.
    pub centres: [u8; 2],
    /// Whether people write the word across before those along.
    pub is_across_first: bool,
    /// What the level of its surface is.
    pub level: Level,
}

/// How the level of a surface is told to people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// A radius, measured as a diameter.
    Radius,
    /// A height.
    Height,
}

/// The axes of a lathe: X across, Z along; arcs in G18.
pub const LATHE: Axes = Axes {
    machine: Machine::Lathe,
    letters: b"XZ",
    steps: b"UW",
    plane: 180,
    of_plane: [1, 0],
    centres: *b"KI",
    is_across_first: true,
    level: Level::Radius,
};

/// The axes of a mill: Z across, X and Y along; arcs in G17.
pub const MILL: Axes = Axes {
    machine: Machine::Mill,
    letters: b"ZXY",
    steps: b"",
    plane: 170,
    of_plane: [1, 2],
    centres: *b"IJ",
    is_across_first: false,
    level: Level::Height,
};

impl Axes {
    /// Where the tool is while nobody knows: level, along, beside; a lathe has nothing beside.
    pub fn nowhere(&self) -> [Option<f64>; 3] {
        [None, None, (self.letters.len() < 3).then_some(0.0)]
    }

    /// The name of the plane of its arcs.
    pub fn plane_name(&self) -> String {
        format!("G{}", self.plane / 10)
    }

    /// The letters of a centre, in the order of the alphabet.
    pub fn centre_names(&self) -> [char; 2] {
        let mut names = self.centres.map(char::from);
        names.sort_unstable();
        names
    }

    /// Whether the level changes along an arc.
    pub fn has_arcs_across(&self) -> bool {
        self.of_plane.contains(&0)
    }
}

impl Level {
    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Self::Radius => "radius",
            Self::Height => "height",
        }
    }

    /// What people measure instead of it, and by how much that is larger.
    pub fn measured(self) -> (&'static str, f64) {
        match self {
            Self::Radius => ("diameter", 2.0),
            Self::Height => ("height", 1.0),
        }
    }
}

/// What a word across the part says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// A diameter.
    Diameter,
    /// A radius.
    Radius,
    /// A height.
    Height,
}

impl Across {
    /// Level for each unit of a word.
    pub fn share(self) -> f64 {
        match self {
            Self::Diameter => 0.5,
            Self::Radius | Self::Height => 1.0,
        }
    }
}
