//! The side by which a ring is held.

/// The side by which the jaws hold the ring; the other one is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// They squeeze it, and the bore is cut.
    Outside,
    /// They spread it from its bore, and the outside is cut.
    Inside,
}

impl Grip {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] = &[("outside", Self::Outside), ("inside", Self::Inside)];

    /// 1 where the jaws press inwards, −1 where outwards.
    pub fn inwards(self) -> f64 {
        match self {
            Self::Outside => 1.0,
            Self::Inside => -1.0,
        }
    }
}
