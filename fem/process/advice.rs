//! What to do beside the command.

/// Something to do, as a process knows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// What, and what comes of it: a sentence.
    pub text: String,
    /// The setting that it changes, by its path in the model file, with what it is and what it should be, SI.
    pub setting: Option<(&'static str, f64, f64)>,
    /// What it takes off the largest error, m.
    pub gain: Option<f64>,
    /// Time that it costs, s.
    pub time: Option<f64>,
}

impl Advice {
    /// A sentence.
    pub fn new(text: impl Into<String>) -> Self {
        Self { text: text.into(), setting: None, gain: None, time: None }
    }

    /// Changes a setting of the model (SI).
    #[must_use]
    pub fn setting(self, path: &'static str, from: f64, to: f64) -> Self {
        Self { setting: Some((path, from, to)), ..self }
    }

    /// Takes something off the largest error, m.
    #[must_use]
    pub fn gaining(self, gain: f64) -> Self {
        Self { gain: Some(gain), ..self }
    }

    /// Takes time, s.
    #[must_use]
    pub fn taking(self, time: f64) -> Self {
        Self { time: Some(time), ..self }
    }
}
