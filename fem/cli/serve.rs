//! `fem report --serve`: a page that renews itself when a file that it was made of changes. It is served to this
//! computer alone.

use std::collections::BTreeMap;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, SystemTime};

use tiny_http::{Header, Method, Request, Response, Server};

use super::args;
use super::error::Error;
use super::say::say;
use super::story::{Depth, written};
use crate::input::Problem;
use crate::output::trouble;

/// Time between two looks at the files.
const LOOK: Duration = Duration::from_millis(250);

/// The page as it is now.
#[derive(Default)]
struct Shown {
    /// Counts the pages.
    version: u64,
    html: String,
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
    let address = SocketAddr::from((Ipv4Addr::LOCALHOST, args.port));
    let server = Server::http(address).map_err(|error| {
        let problem = Problem::new(format!("port {} cannot be served: {error}", args.port));
        Error::Request(problem.help("name another one with --port, or none for any that is free"))
    })?;
    let port = server.server_addr().to_ip().map_or(args.port, |a| a.port());
    let shown = Shared::default();
    // Before the page is made: what is written meanwhile is not in it.
    let seen = stamps(args, &shown);
    renew(args, Depth::Compared, &shown);
    say!("http://127.0.0.1:{port}/ shows the page and renews it when a file changes; Ctrl-C ends it");
    let (owned, told) = (args.clone(), shown.clone());
    thread::spawn(move || watch(&owned, &told, seen));
    for request in server.incoming_requests() {
        answer(request, &locked(&shown), port);
    }
    Ok(())
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

/// When each file was last written, and how long it is; nothing of one that cannot be read.
type Stamps = BTreeMap<PathBuf, Option<(SystemTime, u64)>>;

fn stamps(args: &args::Report, shown: &Shared) -> Stamps {
    let stamp = |path: &PathBuf| {
        let about = || {
            let about = std::fs::metadata(path).ok()?;
            Some((about.modified().ok()?, about.len()))
        };
        (path.clone(), about())
    };
    let named = locked(shown).files.clone();
    args.models.iter().chain(&args.with).chain(&named).map(stamp).collect()
}

/// Puts the next page in place: the report, or what is wrong with its files.
fn renew(args: &args::Report, depth: Depth, shown: &Shared) {
    let version = locked(shown).version + 1;
    let made = written(args, depth, Some(version), &args.limit.progress());
    let mut shown = locked(shown);
    shown.version = version;
    match made {
        Ok(made) => (shown.html, shown.files) = (made.html, made.files),
        Err(error) => shown.html = trouble(&error.text(false), version),
    }
}

/// Answers a browser. Pages of other sites that send their readers here by a name of their own get nothing.
fn answer(request: Request, shown: &Shown, port: u16) {
    let host = request.headers().iter().find(|h| h.field.equiv("Host")).map(|h| h.value.as_str().to_string());
    let is_own = host.is_some_and(|h| h == format!("127.0.0.1:{port}") || h == format!("localhost:{port}"));
    let (status, kind, text) = match (is_own, request.method(), request.url()) {
        (true, Method::Get, "/") => (200, "text/html; charset=utf-8", shown.html.clone()),
        (true, Method::Get, "/version") => (200, "text/plain; charset=utf-8", shown.version.to_string()),
        (true, ..) => (404, "text/plain; charset=utf-8", "there is nothing but the page at /\n".to_string()),
        (false, ..) => (403, "text/plain; charset=utf-8", "this page is for this computer alone\n".to_string()),
    };
    let header = |name: &str, value: &str| Header::from_bytes(name, value).ok();
    let headers = [header("Content-Type", kind), header("Cache-Control", "no-store")];
    let response = Response::from_string(text).with_status_code(status);
    let response = headers.into_iter().flatten().fold(response, |response, h| response.with_header(h));
    // A browser that has gone away is no error.
    let _ = request.respond(response);
}
