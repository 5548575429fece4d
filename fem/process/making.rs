//! What a change of a setting means to whoever makes the parts: how long they take, and what a model cannot say of it.

/// How long the parts of a model take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Making {
    /// All parts with everything between them, s.
    pub whole: f64,
    /// What one part is under the tool, s.
    pub part: f64,
    /// The key that says how long it is from one part to the next. What lies beside the cut in it, loading and unloading,
    /// stays as long when the cut becomes longer or shorter.
    pub cycle: &'static str,
}

/// Why a model cannot say what a change of a quantity does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoLaw {
    /// The reason, which goes on from the quantity.
    pub reason: &'static str,
    /// What to write.
    pub help: &'static str,
}
