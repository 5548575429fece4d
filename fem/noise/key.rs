//! The keys of the tables `[measurement.NAME]`.

/// A key of such a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// Its content, in a few words.
    pub about: &'static str,
    /// Example of a value, without quotes; empty where the key is seldom needed.
    pub example: &'static str,
}

/// The coordinates that group the rows.
pub const BY: Key = Key {
    name: "by",
    about: "coordinates, or `file`, whose levels have a zero each, parted by commas; one zero for all where left out",
    example: "run",
};
/// The coordinate along which a part lies askew.
pub const ALONG: Key = Key {
    name: "along",
    about: "the coordinate along which it lies askew or a wave runs, or the angle around it",
    example: "position",
};
/// The period of a wave, in the unit of the coordinate that it runs along.
pub const PERIOD: Key =
    Key { name: "period", about: "length of one wave, in a unit of that coordinate", example: "90 mm" };
/// The observable on which an effect acts.
pub const OBSERVABLE: Key =
    Key { name: "observable", about: "the observable on which it acts, where a file has several", example: "" };
/// Where the range of a sensor begins.
pub const LOW: Key = Key {
    name: "low",
    about: "least value between which and `high` the curve of the sensor is told, in a unit of what is observed",
    example: "0 mm",
};
/// Where the range of a sensor ends.
pub const HIGH: Key = Key { name: "high", about: "largest value of that range", example: "2 mm" };
/// The rows that are wrong.
pub const ROWS: Key =
    Key { name: "rows", about: "the rows that are wrong, counted from 1 and parted by commas", example: "12, 40" };
/// The first row of a step.
pub const FROM: Key = Key { name: "from", about: "the first row of the step, counted from 1", example: "46" };
/// The file whose rows are named.
pub const IN_FILE: Key = Key {
    name: "file",
    about: "of several files the one whose rows these are; counted through all of them where left out",
    example: "",
};
/// The unit of a file of covariances.
pub const UNIT: Key = Key { name: "unit", about: "the unit whose square the entries of the file have", example: "um" };
