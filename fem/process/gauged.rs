//! Readings that an instrument makes of a whole profile.

use super::Rows;

/// Makes readings of values.
type Read = Box<dyn Fn(&[f64]) -> Vec<f64>>;

/// Rows that an instrument reads off others: a diameter off two radii, a filtered deviation off those beside it.
pub struct Gauged {
    /// The rows of the profile.
    pub profile: Rows,
    read: Read,
}

impl Gauged {
    /// Readings of a profile by `read`, which makes the value of each (SI) of those of the profile's rows.
    pub fn new(profile: Rows, read: impl Fn(&[f64]) -> Vec<f64> + 'static) -> Self {
        Self { profile, read: Box::new(read) }
    }

    /// The readings, given the values of the profile's rows, SI.
    pub fn read(&self, profile: &[f64]) -> Vec<f64> {
        (self.read)(profile)
    }
}
