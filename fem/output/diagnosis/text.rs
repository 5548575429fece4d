//! A diagnosis for people: the story from the failing model to the noise.

use crate::diagnose::{Diagnosis, Outlook};

/// What else the data say of an effect.
pub fn note(outlook: &Outlook, diagnosis: &Diagnosis) -> String {
    let _ = diagnosis;
    let Some(visibility) = &outlook.visibility else { return "it cannot be computed here".into() };
    let _ = visibility;
    String::new()
}

/// What remains, described.
pub fn unexplained(diagnosis: &Diagnosis) -> String {
    diagnosis.remaining.iter().map(|f| f.text.clone()).collect::<Vec<_>>().join("; ")
}

/// The story.
pub fn text() -> String {
    String::new()
}
