//! The keys of the tables `[measurement.NAME]`.

use crate::noise::{Acts, MeasurementEffect, Size, effects};

/// A key of such a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// What it holds.
    pub about: &'static str,
    /// How it is written, without quotes; empty where it is seldom needed.
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
/// The period of a wave.
pub const PERIOD: Key =
    Key { name: "period", about: "length of one wave, in a unit of that coordinate", example: "90 mm" };
/// The observable on which an effect acts.
pub const OBSERVABLE: Key =
    Key { name: "observable", about: "the observable on which it acts, where a file has several", example: "" };
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

/// The key of the size of an effect.
pub fn size_key(effect: &MeasurementEffect) -> Key {
    let example = match (effect.size, effect.acts) {
        (Size::OfObservable(..), Acts::Rounds) => "1 um",
        (Size::OfObservable(..), _) => "0.7 um",
        (Size::Number(..), Acts::Weighs) => "10",
        (Size::Number(..), _) => "2",
        (Size::Quantity(parameter), _) if parameter.kind.unit.is_empty() => "1.02",
        (Size::Quantity(..), _) => "30 s",
        (Size::File(..), _) => "covariance.csv",
    };
    Key { name: effect.size.key(), about: effect.size.about(), example }
}

/// The keys of an effect's table, those of sizes last.
pub fn keys(effect: &MeasurementEffect) -> Vec<Key> {
    let is = |other: &MeasurementEffect| effect == other;
    let is_shared = matches!(effect.acts, Acts::Shared(_));
    let groups = is(&effects::ZERO_SHIFT) || is(&effects::DISCREPANCY) || is(&effects::ALIGNMENT);
    let of_one = is_shared || matches!(effect.acts, Acts::Weighs | Acts::Rounds | Acts::Reads);
    let mut keys = Vec::new();
    for (has, key) in [
        (groups, BY),
        (is(&effects::ALIGNMENT) || is(&effects::WAVE), ALONG),
        (is(&effects::WAVE), PERIOD),
        (of_one, OBSERVABLE),
        (matches!(effect.acts, Acts::Weighs), ROWS),
        (is(&effects::JUMP), FROM),
        (matches!(effect.acts, Acts::Weighs) || is(&effects::JUMP), IN_FILE),
        (is(&effects::ALIGNMENT), size_key(&effects::ALIGNMENT_OFFSET)),
        (true, size_key(effect)),
        (matches!(effect.acts, Acts::Given), UNIT),
    ] {
        if has {
            keys.push(key);
        }
    }
    keys
}

/// The keys of an effect's table that hold a size.
pub fn size_keys(effect: &MeasurementEffect) -> Vec<&'static str> {
    let offset = (*effect == effects::ALIGNMENT).then(|| effects::ALIGNMENT_OFFSET.size.key());
    offset.into_iter().chain([effect.size.key()]).collect()
}
