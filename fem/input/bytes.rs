//! Files as bytes and as text, of bounded size and known encoding.

#[cfg(unix)]
use std::fs::OpenOptions;
use std::fs::{File, Metadata};
use std::io::Read;
use std::path::Path;
use std::string::FromUtf8Error;
use std::sync::Arc;
use std::time::SystemTime;
#[cfg(unix)]
use std::time::{Duration, Instant};

use chardetng::{EncodingDetector, Iso2022JpDetection, Utf8Detection};
use encoding_rs::{BIG5, EUC_JP, Encoding, GBK, SHIFT_JIS, WINDOWS_1250, WINDOWS_1251, WINDOWS_1252};
use sha2::{Digest, Sha256};

use super::line_ends::one_line;
use super::visible::on_one_line;
use super::{InputError, Problem, Source};

impl Source {
    /// Reads a file of UTF-8 text of at most `limit` bytes.
    ///
    /// # Errors
    /// The file cannot be read, is larger than `limit`, or is not UTF-8 (the error points at the first bad
    /// byte).
    pub fn read(path: &Path, limit: u64) -> Result<Self, InputError> {
        Self::decoded(path, limit, |_| None, |e| Err(not_text(e.as_bytes(), e.utf8_error().valid_up_to())))
    }

    /// Reads a table as an instrument or a spreadsheet writes it, of at most `limit` bytes: UTF-8; UTF-16 with a byte
    /// order mark; else a code page, by the letters that stand in it and the words that are `understood` then. `binary` makes a text of the bytes of files that hold
    /// more than text, as far as it knows them. Gives the name of a code page other than the western one too.
    ///
    /// # Errors
    /// The file cannot be read, is larger than `limit`, or is no text.
    pub fn read_exported(
        path: &Path,
        limit: u64,
        binary: impl FnOnce(&[u8]) -> Option<Result<String, Problem>>,
        understood: impl Fn(&str) -> usize,
    ) -> Result<(Self, Option<&'static str>), InputError> {
        let mut name = None;
        let source = Self::decoded(path, limit, binary, |e| {
            let encoding = code_page(e.as_bytes(), understood);
            name = (encoding != WINDOWS_1252).then(|| encoding.name());
            // The mark of UTF-16 is heeded.
            let text = encoding.decode(e.as_bytes()).0.into_owned();
            // Characters 15 and 20 part the values of measuring machines (AQDEF).
            let is_part = |c: char| matches!(c, '\u{f}' | '\u{14}');
            match text.chars().any(|c| c.is_control() && !c.is_whitespace() && !is_part(c)) {
                true => Err(Problem::new("this is no text").help("save it as CSV, or as .xlsx or .ods")),
                false => Ok(text),
            }
        })?;
        Ok((source, name))
    }

    /// Reads a file, and decodes in another way what is not UTF-8, or is known by its bytes.
    fn decoded(
        path: &Path,
        limit: u64,
        binary: impl FnOnce(&[u8]) -> Option<Result<String, Problem>>,
        other: impl FnOnce(FromUtf8Error) -> Result<String, Problem>,
    ) -> Result<Self, InputError> {
        let name: Arc<str> = path.display().to_string().into();
        if let Err(problem) = one_line(&name) {
            return Err(InputError::one(Self::new(on_one_line(&name), ""), problem));
        }
        let text = read(path, limit).and_then(|bytes| {
            let sha256: [u8; 32] = Sha256::digest(&bytes).into();
            let text = binary(&bytes).unwrap_or_else(|| String::from_utf8(bytes).or_else(other));
            text.map(|text| (text, sha256))
        });
        match text {
            Ok((text, sha256)) => Ok(Self { sha256: Some(sha256), ..Self::new(name, text) }),
            Err(problem) => Err(InputError::one(Self::new(name, ""), problem)),
        }
    }
}

/// The code page of a text that is not UTF-8. Signs of units stand alike in western, Greek and Cyrillic ones, so that a text
/// without other letters is western; else the words that are understood tell, and where they do not, frequencies of letters.
fn code_page(bytes: &[u8], understood: impl Fn(&str) -> usize) -> &'static Encoding {
    let is_sign =
        |byte: &u8| byte.is_ascii() || matches!(byte, 0xA0 | 0xB0 | 0xB1 | 0xB2 | 0xB3 | 0xB5 | 0xB7 | 0xD8 | 0xF8);
    let has_mark = bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF");
    if has_mark {
        return WINDOWS_1252;
    }
    let mut detector = EncodingDetector::new(Iso2022JpDetection::Deny);
    detector.feed(&bytes[..bytes.len().min(LONGEST_JUDGED)], true);
    let by_letters = || detector.guess(None, Utf8Detection::Deny);
    let likely = if bytes.iter().all(is_sign) { WINDOWS_1252 } else { by_letters() };
    let head = &bytes[..bytes.len().min(LONGEST_HEAD)];
    let words = |encoding: &'static Encoding| understood(&encoding.decode_without_bom_handling(head).0);
    let others = CODE_PAGES.iter().copied().filter(|page| *page != likely);
    let mut best = (words(likely), likely);
    for page in others {
        let found = words(page);
        if found > best.0 {
            best = (found, page);
        }
    }
    best.1
}

/// Code pages of the languages whose words are known.
const CODE_PAGES: &[&Encoding] = &[WINDOWS_1252, WINDOWS_1250, WINDOWS_1251, GBK, SHIFT_JIS, BIG5, EUC_JP];

/// Bytes at the beginning in which words are looked for.
const LONGEST_HEAD: usize = 10_000;

/// Bytes by which a code page is found.
const LONGEST_JUDGED: usize = 1_000_000;

/// When a file was last written, and how long it is: another one is another text.
pub type Stamp = (SystemTime, u64);

/// The stamp of a file; none of one that cannot be read.
pub fn stamp(path: &Path) -> Option<Stamp> {
    let about = std::fs::metadata(path).ok()?;
    Some((about.modified().ok()?, about.len()))
}

/// Refuses a pipe or a device that stands in a folder. What the program was started with, `/dev/stdin` or a substituted process,
/// somebody writes to.
///
/// # Errors
/// It is one.
pub fn no_pipe(path: &Path, about: &Metadata) -> Result<(), Problem> {
    match about.is_file() || about.is_dir() || is_handed_in(path) {
        true => Ok(()),
        false => Err(Problem::new("this is a pipe or a device").help("name a file")),
    }
}

fn is_handed_in(path: &Path) -> bool {
    let ways = ["/dev/stdin", "/dev/fd", "/proc/self/fd"];
    ways.iter().any(|way| path.starts_with(way)) || path.canonicalize().is_err()
}

/// Opens a file to be read. What has become a pipe since it was looked at is not waited for.
#[cfg(unix)]
fn opened(path: &Path, about: &Metadata, limit: u64) -> std::io::Result<Vec<u8>> {
    use std::os::unix::fs::{FileTypeExt, OpenOptionsExt};
    let mut bytes = Vec::with_capacity(about.len() as usize + 1);
    if is_handed_in(path) {
        File::open(path)?.take(limit).read_to_end(&mut bytes)?;
        return Ok(bytes);
    }
    let file =
        OpenOptions::new().read(true).custom_flags(rustix::fs::OFlags::NONBLOCK.bits().cast_signed()).open(path)?;
    let kind = file.metadata()?.file_type();
    let mut file = file.take(limit);
    match (kind.is_file(), kind.is_fifo()) {
        (true, _) => drop(file.read_to_end(&mut bytes)?),
        (_, true) => from_writer(&mut file, &mut bytes)?,
        _ => return Err(std::io::Error::other("it is a device, and no file")),
    }
    Ok(bytes)
}

#[cfg(not(unix))]
fn opened(path: &Path, about: &Metadata, limit: u64) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::with_capacity(about.len() as usize + 1);
    File::open(path)?.take(limit).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Reads a pipe that is opened without waiting: one to which nobody has written for a while nobody may ever write to.
#[cfg(unix)]
fn from_writer(pipe: &mut impl Read, bytes: &mut Vec<u8>) -> std::io::Result<()> {
    const PATIENCE: Duration = Duration::from_secs(3);
    let (begun, mut piece) = (Instant::now(), vec![0; 1 << 16]);
    loop {
        match pipe.read(&mut piece) {
            Ok(0) if !bytes.is_empty() => return Ok(()),
            Ok(0) if begun.elapsed() > PATIENCE => {
                return Err(std::io::Error::other("it is a pipe, and nobody writes to it"));
            }
            Ok(0) => std::thread::sleep(PAUSE),
            Ok(count) => bytes.extend(&piece[..count]),
            // A writer has it open, and is not ready.
            Err(error) if error.kind() == std::io::ErrorKind::WouldBlock => std::thread::sleep(PAUSE),
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

/// Pause between two looks at a pipe.
#[cfg(unix)]
const PAUSE: Duration = Duration::from_millis(5);

/// Reads at most `limit` bytes.
///
/// # Errors
/// The file cannot be read, is larger, or is none.
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, Problem> {
    let io = |e: std::io::Error| Problem::new(format!("the file cannot be read: {e}")).help(unreadable(&e));
    let metadata = std::fs::metadata(path).map_err(io)?;
    if metadata.is_dir() {
        return Err(Problem::new("this is a directory").help("name the file in it"));
    }
    if metadata.len() > limit {
        let (size, limit) = (metadata.len() as f64 / 1e6, limit as f64 / 1e6);
        let message = format!("the file has {size:.1} MB; at most {limit:.0} MB are read");
        return Err(Problem::new(message).help("is it the right file?"));
    }
    // What is no file has no length to be judged by.
    let bytes = opened(path, &metadata, limit + 1).map_err(io)?;
    if bytes.len() as u64 > limit {
        let message = format!("there are more than {:.0} MB to read", limit as f64 / 1e6);
        return Err(Problem::new(message).help("is it the right file?"));
    }
    Ok(bytes)
}

/// The text of a file; none of one that cannot be read, is a pipe, or no text.
pub fn text_of(path: &Path) -> String {
    /// Largest file that is looked at.
    const LARGEST: u64 = 64_000_000;
    std::fs::metadata(path)
        .is_ok_and(|about| about.is_file())
        .then(|| read(path, LARGEST).ok())
        .flatten()
        .and_then(|bytes| String::from_utf8(bytes).ok())
        .unwrap_or_default()
}

/// The problem of a file that is not UTF-8 from byte `valid` on.
pub(super) fn not_text(bytes: &[u8], valid: usize) -> Problem {
    let line = 1 + bytes[..valid].iter().filter(|b| **b == b'\n').count();
    let message = format!("the file is not UTF-8 text: line {line} holds a byte that is not");
    Problem::new(message).help("save it as UTF-8")
}

fn unreadable(error: &std::io::Error) -> &'static str {
    match error.kind() {
        std::io::ErrorKind::NotFound => "check the path; for a first model, `fem new PROCESS` writes one",
        std::io::ErrorKind::PermissionDenied => "check the file's permissions",
        _ => "check the path",
    }
}
