//! Notes on work under way, in the user's state folder: hidden folders of unfinished files, and the moves from them
//! into place. A note is locked as long as its program lives, so that whoever comes next can bring to the end what a
//! killed one has begun, and sweep what it has left. Nothing that stands beside the files of others is believed.

use std::fs::{File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use cap_fs_ext::DirExt;
use serde_json::{Value, json};

use super::account::{Account, digits};
use super::replace::{Move, Over, Plan};
use super::way;
use super::written::Entry;

const SCHEMA: &str = "fem-work/1";
/// Prefix and suffix of a hidden folder's name, around its digits.
const PREFIX: &str = ".fem-";
const SUFFIX: &str = ".partial";
/// Where a link stands in place of a file.
const LINK: &str = "link";

/// A note.
pub struct Work {
    file: File,
    path: PathBuf,
}

impl Work {
    /// Notes a hidden folder before it is made.
    ///
    /// # Errors
    /// The state folder cannot be written or locked, or the path is no text.
    pub fn begin(account: &Account, hidden: &Path) -> io::Result<Self> {
        let hidden = hidden.to_str().ok_or(io::ErrorKind::InvalidInput)?;
        let folder = account.works();
        std::fs::create_dir_all(&folder)?;
        let path = folder.join(format!("{}.jsonl", digits()?));
        let file = OpenOptions::new().append(true).create_new(true).open(&path)?;
        let mut work = Self { file, path };
        work.file.lock()?;
        work.note(&json!({ "schema": SCHEMA, "host": host(), "hidden": hidden }))?;
        Ok(work)
    }

    /// Notes what goes into place, before the first of it does.
    ///
    /// # Errors
    /// The state folder cannot be written, or a path is no text.
    pub fn places(&mut self, folder: &Path, plan: &Plan) -> io::Result<()> {
        let no_text = || io::Error::from(io::ErrorKind::InvalidInput);
        let all =
            |entries: &[Entry]| entries.iter().map(Entry::to_json).collect::<Option<Vec<_>>>().ok_or_else(no_text);
        let over = |over: &Over| match over {
            Over::Nothing => Some(Value::Null),
            Over::File(entry) => entry.to_json(),
            Over::Link => Some(LINK.into()),
        };
        let one = |m: &Move| Some(json!({ "new": m.new.to_json()?, "over": over(&m.over)? }));
        let moves = plan.moves.iter().map(one).collect::<Option<Vec<_>>>().ok_or_else(no_text)?;
        let folder = folder.to_str().ok_or_else(no_text)?;
        self.note(&json!({ "folder": folder, "moves": moves, "leave": all(&plan.leave)? }))
    }

    /// Where it stands.
    pub fn path(&self) -> &Path {
        &self.path
    }

    fn note(&mut self, value: &Value) -> io::Result<()> {
        self.file.write_all(format!("{value}\n").as_bytes())
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        // A note that stays is of a folder that is gone, and goes with the next sweep.
        let _ = std::fs::remove_file(&self.path);
    }
}

/// Name of a hidden folder.
pub fn hidden() -> io::Result<String> {
    Ok(format!("{PREFIX}{}{SUFFIX}", digits()?))
}

/// Whether a name is one of a hidden folder.
pub fn is_hidden(name: &str) -> bool {
    let digits = name.strip_prefix(PREFIX).and_then(|rest| rest.strip_suffix(SUFFIX));
    digits.is_some_and(|digits| digits.len() == 24 && digits.bytes().all(|byte| byte.is_ascii_hexdigit()))
}

/// This computer: a state folder may be shared with others, whose folders are not to be found here.
fn host() -> String {
    #[cfg(unix)]
    return rustix::system::uname().nodename().to_string_lossy().into_owned();
    #[cfg(not(unix))]
    std::env::var("COMPUTERNAME").unwrap_or_default()
}

/// The account of whoever runs the program, once what dead programs left is swept; `None` where there is no state folder,
/// and nothing is known to be the program's own.
pub fn account() -> Option<Account> {
    let account = Account::open().ok()?;
    sweep(&account);
    Some(account)
}

/// Brings to the end what dead programs have begun to put into place, and removes their hidden folders.
fn sweep(account: &Account) {
    let Ok(notes) = std::fs::read_dir(account.works()) else { return };
    for note in notes.flatten() {
        let path = note.path();
        if !note.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let Ok(mut file) = File::open(&path) else { continue };
        // Held by a program that lives, or by none that locks can tell of.
        if file.try_lock().is_err() {
            continue;
        }
        let mut text = String::new();
        let whole = |line: &str| line.ends_with('\n').then(|| serde_json::from_str(line).ok()).flatten();
        let read = file.read_to_string(&mut text);
        let mut lines = text.split_inclusive('\n').map(whole);
        // One that has just been made is empty.
        let Some(Some(begun)) = lines.next().filter(|_| read.is_ok()) else { continue };
        let begun: Value = begun;
        if begun["schema"] != SCHEMA || begun["host"] != host() {
            continue;
        }
        let placing = lines.next().flatten();
        if begun["hidden"].as_str().is_some_and(|hidden| end(Path::new(hidden), placing.as_ref())) {
            let _ = std::fs::remove_file(path);
        }
    }
}

/// Ends what stands in a hidden folder, and tells whether nothing is left of it. Where it cannot be reached, such as on a
/// disk that is not there now, it stays noted.
fn end(hidden: &Path, placing: Option<&Value>) -> bool {
    let (Some(above), Some(name)) = (hidden.parent(), hidden.file_name()) else { return true };
    if !name.to_str().is_some_and(is_hidden) {
        return true;
    }
    let Ok(above) = way::open(above) else { return false };
    let Ok(new) = above.open_dir_nofollow(name) else { return above.symlink_metadata(name).is_err() };
    if let Some((folder, plan)) = placing.and_then(plan_of) {
        let into =
            folder.parent().zip(folder.file_name()).map(|(above, name)| way::open(above)?.open_dir_nofollow(name));
        if let Some(Ok(into)) = into {
            let _ = plan.carry_out(&new, &into);
        }
    }
    above.remove_dir_all(name).is_ok()
}

fn plan_of(placing: &Value) -> Option<(PathBuf, Plan)> {
    let over = |over: &Value| match over {
        Value::Null => Some(Over::Nothing),
        over if over == LINK => Some(Over::Link),
        over => Entry::of_json(over).map(Over::File),
    };
    let one = |m: &Value| Some(Move { new: Entry::of_json(&m["new"])?, over: over(&m["over"])? });
    let moves = placing["moves"].as_array()?.iter().map(one).collect::<Option<_>>()?;
    let leave = placing["leave"].as_array()?.iter().map(Entry::of_json).collect::<Option<_>>()?;
    Some((placing["folder"].as_str()?.into(), Plan { moves, leave }))
}
