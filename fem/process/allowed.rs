//! What a drawing allows the observable of a process: limits at every place, and a form.

use std::collections::BTreeMap;

use super::{Characteristic, Requirement, range};
use crate::input::Reader;
use crate::tolerance::Limits;
use crate::units::Kind;

/// Words of a process for what a drawing allows.
#[derive(Clone, Copy, Debug)]
pub struct AllowedWords {
    /// Key of the limits in `[tolerance]`, and of what shows them.
    pub within: &'static str,
    /// What they are limits of.
    pub about: &'static str,
    /// Key of the form, and what it is, where the process has one.
    pub form: Option<(&'static str, &'static str)>,
    /// Kind of the observable.
    pub kind: Kind,
}

/// Limits of an observable at every place, and of its largest less its smallest value. SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Allowed {
    /// Limits at every place, with what was written.
    pub within: Option<(Limits, String)>,
    /// Largest less smallest value of a part.
    pub form: Option<f64>,
}

impl Allowed {
    /// Reads it from `[tolerance]`.
    pub fn read(t: &Reader, words: &AllowedWords) -> Self {
        let limits = Limits::read(t, words.within, words.about, words.kind, None);
        let form =
            words.form.and_then(|(key, about)| t.quantity(key, words.kind, about).chosen().positive().optional());
        Self { within: limits.zip(t.written(words.within).map(str::to_string)), form }
    }

    /// What is asked: limits, then the form.
    pub fn requirements(&self, words: &AllowedWords) -> Vec<Requirement> {
        let within = self.within.as_ref().map(|(limits, written)| Requirement {
            key: words.within,
            label: format!("{}, {written}", words.within),
            kind: words.kind,
            limits: *limits,
        });
        let form = words.form.zip(self.form).map(|((key, _), width)| Requirement {
            key,
            label: key.into(),
            kind: words.kind,
            limits: Limits::up_to(width),
        });
        within.into_iter().chain(form).collect()
    }

    /// What rows show of each part, given the observable of every row and the part that it belongs to; `None` where it is no
    /// row of what is asked.
    pub fn characteristics(
        &self,
        values: &[f64],
        part: impl Fn(usize) -> Option<Option<usize>>,
    ) -> Vec<Characteristic> {
        let mut parts: BTreeMap<Option<usize>, Vec<f64>> = BTreeMap::new();
        for (row, value) in values.iter().enumerate() {
            if let Some(part) = part(row) {
                parts.entry(part).or_default().push(*value);
            }
        }
        let of = |(part, own): (Option<usize>, Vec<f64>)| {
            let (low, high) = range(own);
            let within = self.within.as_ref().map(|_| [low, high]);
            let form = self.form.map(|_| [high - low; 2]);
            let all = within.into_iter().chain(form).enumerate();
            all.map(move |(requirement, range)| Characteristic { requirement, part, range }).collect::<Vec<_>>()
        };
        parts.into_iter().flat_map(of).collect()
    }
}
