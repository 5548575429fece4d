//! Runs the program on a case and judges what it does.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Files, and the command that reads them.
#[derive(Clone, Debug)]
pub struct Case {
    pub files: Vec<(String, Vec<u8>)>,
    pub command: Vec<String>,
}

/// What no input may bring about.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// Killed by a signal, or an exit status that is none of 0, 1 and 2.
    Status(String),
    /// A number that is none, on a page that was printed with status 0.
    NoNumber(String),
    /// Longer computed than it may.
    Endless,
    /// More memory than it may take, kB.
    Memory(u64),
    /// More told than anybody reads, bytes.
    Told(usize),
}

/// What a run may take.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    pub time: Duration,
    /// kB.
    pub memory: u64,
}

/// Most that an error may tell, bytes.
const MOST_TOLD: usize = 60_000;

impl Case {
    /// Reads a case from its folder: `command` has a word on each line, all else are files.
    pub fn load(folder: &Path) -> Self {
        let mut files = Vec::new();
        let mut command = Vec::new();
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_string();
            let content = std::fs::read(&path).unwrap();
            match name.as_str() {
                "command" => command = String::from_utf8(content).unwrap().lines().map(str::to_string).collect(),
                "README.md" => {}
                _ => files.push((name, content)),
            }
        }
        assert!(!command.is_empty(), "{} has no command", folder.display());
        Self { files, command }
    }

    /// Keeps a case in a folder of its own.
    pub fn keep(&self, folder: &Path) {
        std::fs::create_dir_all(folder).unwrap();
        std::fs::write(folder.join("command"), self.command.join("\n") + "\n").unwrap();
        for (name, content) in &self.files {
            std::fs::write(folder.join(name), content).unwrap();
        }
    }

    /// Runs the command in a place of its own, and gives its exit status.
    ///
    /// # Errors
    /// It has done what no input may bring about.
    pub fn run(&self, limits: Limits) -> Result<i32, Fault> {
        let place = tempfile::tempdir().unwrap();
        for (name, content) in &self.files {
            std::fs::write(place.path().join(name), content).unwrap();
        }
        // Beside the place, where the command finds nothing.
        let told = tempfile::tempdir().unwrap();
        let [out, err]: [PathBuf; 2] = ["out", "err"].map(|name| told.path().join(name));
        let program = std::env::var_os("FEM_FUZZ_PROGRAM").unwrap_or_else(|| env!("CARGO_BIN_EXE_fem").into());
        let mut child = Command::new(program)
            .args(&self.command)
            .current_dir(place.path())
            .stdin(Stdio::null())
            .stdout(std::fs::File::create(&out).unwrap())
            .stderr(std::fs::File::create(&err).unwrap())
            .env("NO_COLOR", "1")
            .spawn()
            .unwrap();
        let start = Instant::now();
        let mut memory = 0;
        let status = loop {
            if let Some(status) = child.try_wait().unwrap() {
                break status;
            }
            memory = memory.max(resident(child.id()));
            let fault = match () {
                () if computed(child.id()) > limits.time || start.elapsed() > 10 * limits.time => Some(Fault::Endless),
                () if memory > limits.memory => Some(Fault::Memory(memory)),
                () => None,
            };
            if let Some(fault) = fault {
                child.kill().unwrap();
                child.wait().unwrap();
                return Err(fault);
            }
            std::thread::sleep(Duration::from_millis(if start.elapsed().as_millis() < 50 { 2 } else { 10 }));
        };
        let [mut out, err] = [out, err].map(|path| String::from_utf8_lossy(&std::fs::read(path).unwrap()).into_owned());
        for (_, content) in &self.files {
            // What the user has called so is no number of the program's.
            for name in String::from_utf8_lossy(content).split('"').skip(1).step_by(2).filter(|n| has_no_number(n)) {
                out = out.replace(name, "");
            }
        }
        judge(status.code(), &out, &err).map_or(Ok(status.code().unwrap_or_default()), Err)
    }
}

/// Most memory that a program has had so far, kB; 0 where the system does not say.
fn resident(process: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|l| l.split_whitespace().next()).and_then(|kb| kb.parse().ok()).unwrap_or(0)
}

/// Time that a program has computed for so far, which other programs do not lengthen; none where the system does not
/// say.
fn computed(process: u32) -> Duration {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
    // The name in parentheses may hold anything; user and system time are the 12th and 13th field behind it.
    let fields = stat.rsplit(')').next().unwrap_or_default().split_whitespace();
    let ticks: u64 = fields.skip(11).take(2).filter_map(|field| field.parse::<u64>().ok()).sum();
    Duration::from_millis(10 * ticks)
}

/// Judges an exit status and what was printed.
pub fn judge(status: Option<i32>, out: &str, err: &str) -> Option<Fault> {
    let panicked = err.contains("panicked at");
    if panicked || !matches!(status, Some(0..=2)) {
        let line =
            err.lines().skip_while(|l| panicked && !l.contains("panicked at")).take(2).collect::<Vec<_>>().join(" ");
        return Some(Fault::Status(format!("{status:?}: {line}")));
    }
    if err.len() > MOST_TOLD {
        return Some(Fault::Told(err.len()));
    }
    let line = out.lines().find(|line| has_no_number(line));
    line.filter(|_| status == Some(0)).map(|line| Fault::NoNumber(line.trim().to_string()))
}

/// Whether a word of the text stands for a number that is none.
fn has_no_number(text: &str) -> bool {
    let is_none = |word: &str| ["nan", "inf", "infinity"].contains(&word.to_lowercase().as_str());
    text.split(|c: char| !c.is_alphanumeric() && c != '_').any(is_none)
}
