//! Owner of an effect: a machine keeps its own from test to test.

/// Owner of an effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Belongs {
    /// This test alone: its work, its tool, its setting, its time of day.
    Test,
    /// The machine as every test of the process sees it.
    Machine,
    /// A unit of the machine, which tests of other processes may see as well.
    Unit(&'static str, UnitRole),
    /// The unit that the model says it tests; this test alone where it says none.
    Tested(UnitRole),
}

/// Role of an effect in its unit. Effects of one role have the same law and the same parameters, in whatever process
/// they are met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitRole {
    /// It yields in proportion, y = Q/k.
    Spring,
    /// It closes by the contact law, y = c·Qⁿ.
    Contact,
    /// Friction holds it.
    Friction,
    /// Clearance is taken up.
    Gap,
    /// Its like presses against it.
    Preload,
}
