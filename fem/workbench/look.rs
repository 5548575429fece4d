//! Files that are changed elsewhere while they are open: the page follows, and a wrong file keeps what was.

use super::session::Session;
use crate::input::text_of;

impl Session {
    /// Looks at the files that are open.
    pub fn look(&mut self) {
        if self.now.model.is_some() {
            self.look_at_model();
            self.look_at_measurements();
        }
    }

    fn look_at_model(&mut self) {
        let Some(model) = &self.now.model else { return };
        let (name, own) = (self.now.file.clone(), model.text());
        if !self.disk.is_other(self.folder.path(), &name) {
            return;
        }
        let path = self.folder.path().join(&name);
        let text = text_of(&path);
        self.disk.found(&name, !text.is_empty());
        if text.is_empty() {
            let how = match path.metadata() {
                Ok(about) if about.is_file() => "empty now",
                Ok(_) => "no file any more",
                Err(_) => "gone",
            };
            return self.tell(Some(format!("{name} is {how}, and what was open stays: save it to write it again")));
        }
        if text == own || self.disk.has(&name, &text) {
            self.disk.note(&name, text);
            // Mended again.
            return self.tell(None);
        }
        if !self.is_saved() {
            // Looked at again until one of both is gone.
            self.disk.forget(&name);
            let how = "save it under another name, or undo what was done here to see that";
            return self.tell(Some(format!("{name} was changed elsewhere, and something is not saved here: {how}")));
        }
        match self.read_model(&name) {
            Ok(model) => {
                self.disk.note(&name, text);
                self.trouble = None;
                self.change(format!("{name} was changed elsewhere"), None, model, true);
            }
            Err(refusal) => {
                self.tell(Some(format!("{name} is wrong now, and what was open stays: {}", refusal.text())));
            }
        }
    }

    fn look_at_measurements(&mut self) {
        let names = self.now.files.clone();
        let folder = self.folder.path().to_path_buf();
        // Each is asked, so that all are known from then on.
        let changed: Vec<&String> = names.iter().filter(|name| self.disk.is_other(&folder, name)).collect();
        let Some(first) = changed.first() else { return };
        let opened = self.open_data(&names, Some(self.now.reading.clone()));
        let told = opened
            .err()
            .map(|refusal| format!("{first} is wrong now, and what was read of it stays: {}", refusal.text()));
        self.tell(told);
    }

    /// Tells what is wrong with a file, if that is something else than before.
    fn tell(&mut self, trouble: Option<String>) {
        if self.trouble != trouble {
            self.trouble = trouble;
            self.version += 1;
        }
    }
}
