//! `fem report --serve`: a page that renews itself when a file that it was made of changes. It is served to this
//! computer alone.

use std::collections::BTreeMap;
use std::io;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use axum::Router;
use axum::body::Bytes;
use axum::extract::State;
use axum::http::{HeaderMap, Method, StatusCode, Uri};
use axum::response::Response;

use super::args;
use super::error::Error;
use super::look;
use super::say::say;
use crate::ask::Depth;
use crate::input::{Problem, Stamp, stamp};
use crate::output::trouble;
use crate::workbench::{Gate, guarded};

/// Time between two looks at the files.
const LOOK: Duration = Duration::from_millis(250);

/// The page is one file, and asks for nothing but whether it is still true.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; connect-src 'self'; \
                      img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// The page as it is now.
#[derive(Default)]
struct Shown {
    /// Counts the pages.
    version: u64,
    html: Bytes,
    /// What is wrong with the files since; the last good page stays.
    trouble: Option<String>,
    /// Files of which the last good page was made.
    files: Vec<PathBuf>,
}

type Shared = Arc<Mutex<Shown>>;

fn locked(shown: &Shared) -> MutexGuard<'_, Shown> {
    // A page is put in whole: a panic elsewhere leaves the last one.
    shown.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Serves the page until the program is stopped.
pub fn serve(args: &args::Report) -> Result<(), Error> {
    // Connections wait for each other's bytes nowhere: one thread is enough for all of them.
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    runtime.and_then(|runtime| runtime.block_on(served(args))).map_err(|error| unserved(args.port, &error))
}

/// A port cannot be served.
pub fn unserved(port: u16, error: &io::Error) -> Error {
    let problem = Problem::new(format!("port {port} cannot be served: {error}"));
    Error::from(problem.help("name another one with --port, or none for any that is free"))
}

async fn served(args: &args::Report) -> io::Result<()> {
    let (listener, gate, port) = Gate::open(args.port).await?;
    let shown = Shared::default();
    // Before the page is made: what is written meanwhile is not in it.
    let seen = stamps(args, &shown);
    renew(args, Depth::Compared, &shown);
    say!("http://127.0.0.1:{port}/ shows the page and renews it when a file changes; Ctrl-C ends it");
    let (owned, told) = (args.clone(), shown.clone());
    thread::spawn(move || watch(&owned, &told, seen));
    axum::serve(listener, Router::new().fallback(answer).with_state((shown, gate))).await
}

/// Makes the page anew whenever a file changes: compared at once, then diagnosed.
fn watch(args: &args::Report, shown: &Shared, mut seen: Stamps) {
    loop {
        if !args.with.is_empty() {
            renew(args, Depth::Diagnosed, shown);
        }
        loop {
            thread::sleep(LOOK);
            let now = stamps(args, shown);
            // A file that the last page was the first to name was not looked at before.
            let is_other = |(path, stamp)| seen.get(path).is_some_and(|before| before != stamp);
            let has_changed = now.iter().any(is_other);
            seen = now;
            if has_changed {
                break;
            }
        }
        renew(args, Depth::Compared, shown);
    }
}

/// That of each file; none of one that cannot be read.
type Stamps = BTreeMap<PathBuf, Option<Stamp>>;

fn stamps(args: &args::Report, shown: &Shared) -> Stamps {
    let stamp = |path: &PathBuf| (path.clone(), stamp(path));
    let named = locked(shown).files.clone();
    args.models.iter().chain(&args.with).chain(&named).map(stamp).collect()
}

/// Puts the next page in place; where the files are wrong, the last good one stays and what is wrong is told beside it.
fn renew(args: &args::Report, depth: Depth, shown: &Shared) {
    let version = locked(shown).version + 1;
    let made = args.page(depth, Some(version), &args.limit.progress());
    let mut shown = locked(shown);
    match made {
        Ok(made) => {
            (shown.version, shown.trouble) = (version, None);
            (shown.html, shown.files) = (made.html.into(), made.files);
        }
        Err(error) => {
            let told = error.text(look::plain_marks());
            if shown.files.is_empty() {
                (shown.version, shown.html) = (version, trouble(&told, version).into());
            }
            shown.trouble = Some(told);
        }
    }
}

/// Answers a browser.
async fn answer(State((shown, gate)): State<(Shared, Gate)>, method: Method, uri: Uri, headers: HeaderMap) -> Response {
    let (page, text) = ("text/html; charset=utf-8", "text/plain; charset=utf-8");
    let shown = locked(&shown);
    let (status, kind, body) = match (gate.admits(&headers), method, uri.path()) {
        (true, Method::GET, "/") => (StatusCode::OK, page, shown.html.clone()),
        // The version on a line of its own, and beneath it what is wrong.
        (true, Method::GET, "/version") => {
            let trouble = shown.trouble.as_ref().map_or(String::new(), |told| format!("\n{told}"));
            (StatusCode::OK, text, format!("{}{trouble}", shown.version).into())
        }
        (true, ..) => (StatusCode::NOT_FOUND, text, "there is nothing but the page at /\n".into()),
        (false, ..) => (StatusCode::FORBIDDEN, text, "this page is for this computer alone\n".into()),
    };
    guarded(status, kind, POLICY, body)
}
