//! What files have, as far as a session has read or written them.

use std::collections::HashMap;
use std::path::Path;

use super::refusal::Refusal;
use crate::input::{Stamp, stamp, text_of};

/// Texts of models and stamps of files, each by the name of the file.
#[derive(Default)]
pub struct Disk {
    texts: HashMap<String, String>,
    stamps: HashMap<String, Option<Stamp>>,
    /// A file of a model that is no longer there.
    gone: Option<String>,
    /// What somebody else has written, of which it was told that it would be written over.
    warned: Option<String>,
}

impl Disk {
    /// A file has this text.
    pub fn note(&mut self, name: &str, text: String) {
        self.texts.insert(name.to_string(), text);
        self.gone = None;
    }

    /// Whether a file has this text, as far as is known.
    pub fn has(&self, name: &str, text: &str) -> bool {
        self.gone.as_deref() != Some(name) && self.texts.get(name).is_some_and(|own| own == text)
    }

    /// Notes whether a file is there.
    pub fn found(&mut self, name: &str, is_there: bool) {
        self.gone = (!is_there).then(|| name.to_string());
    }

    /// Whether a file is another one than when this was asked last, if ever.
    pub fn is_other(&mut self, folder: &Path, name: &str) -> bool {
        let now = stamp(&folder.join(name));
        self.stamps.insert(name.to_string(), now).is_none_or(|before| before != now)
    }

    /// It is to be looked at again.
    pub fn forget(&mut self, name: &str) {
        self.stamps.insert(name.to_string(), None);
    }

    /// Whether the file of a model is still what is known of it, or was said to be written over all the same.
    ///
    /// # Errors
    /// Somebody else has written it, and this is the first time that it is said.
    pub fn check(&mut self, folder: &Path, name: &str) -> Result<(), Refusal> {
        let text = text_of(&folder.join(name));
        if text.is_empty() || self.texts.get(name) == Some(&text) || self.warned.as_ref() == Some(&text) {
            return Ok(());
        }
        self.warned = Some(text);
        let problem = format!("{name} was changed elsewhere since it was read");
        Err(Refusal::new(problem, "save under another name, or save once more to write over it"))
    }
}
