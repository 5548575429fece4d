//! Runs the program as a user does.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A directory of its own and a user's state folder, gone after the test.
pub struct Place(tempfile::TempDir, tempfile::TempDir);

/// In a good file, replaced by, part of the message, part of the remedy.
pub type Mistake = (&'static str, &'static str, &'static str, &'static str);

/// What the program answered.
#[derive(Debug)]
pub struct Answer {
    pub status: i32,
    pub out: String,
    pub err: String,
}

impl Place {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// The state folder of the program.
    pub fn state(&self) -> PathBuf {
        self.1.path().join("fem")
    }

    /// Writes a file.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// SHA-256 of a file as the system's own tool says it.
    pub fn sha256(&self, name: &str) -> String {
        let told = Command::new("sha256sum").arg(self.path(name)).output().unwrap().stdout;
        String::from_utf8(told).unwrap().split_whitespace().next().unwrap().to_string()
    }

    /// `fem ARGS` in this directory.
    pub fn fem(&self, args: &[&str]) -> Answer {
        answer(self.command(args).output().unwrap())
    }

    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fem"));
        command
            .args(args)
            .current_dir(self.0.path())
            .stdin(Stdio::null())
            .env("XDG_STATE_HOME", self.1.path())
            .env("NO_COLOR", "1")
            .env("COLUMNS", "100")
            .env("LC_ALL", "C.UTF-8");
        command
    }

    /// Every mistake in a file that is otherwise good is refused by `fem COMMAND FILE`, with its message
    /// and its remedy.
    pub fn refuses(&self, (command, file): (&str, &str), good: &str, mistakes: &[Mistake]) {
        for (from, to, message, remedy) in mistakes {
            assert!(good.contains(from), "{from}");
            self.write(file, good.replacen(from, to, 1));
            self.is_refused(&[command, file], to, (message, remedy));
        }
    }

    /// Holds what a command refuses against its message and its remedy, whatever the width of the frame around them.
    pub fn is_refused(&self, args: &[&str], what: &str, (message, remedy): (&str, &str)) {
        let answer = self.fem(args);
        let told = answer.err.split_whitespace().filter(|word| *word != "│").collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, 2, "{what}: {told}");
        assert!(told.contains(message) && told.contains(remedy), "{what}: {told}");
    }

    /// The numbers of a column of a CSV file, by the beginning of its name.
    pub fn column(&self, file: &str, name: &str) -> Vec<f64> {
        let text = self.read(file);
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let header: Vec<&str> = lines.next().unwrap().split(',').collect();
        let at = header.iter().position(|h| h.starts_with(name)).unwrap_or_else(|| panic!("{name} in {header:?}"));
        lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
    }

    /// Every file below, by its path from here, sorted.
    pub fn files(&self) -> Vec<String> {
        let mut found = Vec::new();
        list(self.0.path(), self.0.path(), &mut found);
        found.sort();
        found
    }
}

fn list(root: &Path, directory: &Path, found: &mut Vec<String>) {
    for entry in std::fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            list(root, &path, found);
        } else {
            found.push(path.strip_prefix(root).unwrap().display().to_string());
        }
    }
}

pub fn answer(output: Output) -> Answer {
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    // Whether a computation takes so long that it tells how far it is, is a matter of the machine.
    let told = text(output.stderr).split_inclusive('\n').filter(|l| !l.starts_with("computing for ")).collect();
    // A program killed by a signal has no status; -1 is none that it gives.
    Answer { status: output.status.code().unwrap_or(-1), out: text(output.stdout), err: told }
}

/// A model that comes with the program.
pub fn model(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(name)).unwrap()
}

/// The words of a command line with single quotes.
pub fn words(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quoted = false;
    for c in line.trim().chars() {
        match c {
            '\'' => quoted = !quoted,
            ' ' if !quoted => words.push(String::new()),
            c => words.last_mut().unwrap().push(c),
        }
    }
    words
}
