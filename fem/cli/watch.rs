//! Watches a command: tells how far it is when it takes long, and ends it cleanly on Ctrl-C.

use std::io::IsTerminal;
use std::num::NonZero;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::look;
use super::say::say;
use crate::output::files;
use crate::progress::Progress;

/// Time after which a bar is drawn, and between two lines where nobody sees a bar.
const BAR_AFTER: Duration = Duration::from_secs(1);
const LINE_EVERY: Duration = Duration::from_secs(5);

/// Removes partial files on Ctrl-C and ends with the status that shells expect; and computes on one thread where
/// the system gives no more.
pub fn prepare() {
    // Without a handler the program still works, and leaves at worst a hidden partial file when stopped.
    let _ = ctrlc::set_handler(|| {
        files::abandon();
        std::process::exit(130);
    });
    let pool = rayon::ThreadPoolBuilder::new();
    let pool = if are_to_be_had() { pool } else { pool.num_threads(1).use_current_thread() };
    // What cannot be had now either is told by whatever needs it.
    let _ = pool.build_global();
}

/// Whether the system gives a thread for every core. It is tried beforehand, for a pool that failed is not built again.
fn are_to_be_had() -> bool {
    let cores = thread::available_parallelism().map_or(1, NonZero::get);
    let threads: Vec<_> = (0..cores).map_while(|_| thread::Builder::new().spawn(thread::park).ok()).collect();
    let all = threads.len() == cores;
    for thread in threads {
        thread.thread().unpark();
        // It does nothing that could fail.
        let _ = thread.join();
    }
    all
}

/// Computes while another thread tells how far it is: by a bar in a terminal, else by a line every few seconds.
pub fn watched<T>(progress: &Arc<Progress>, compute: impl FnOnce() -> T) -> T {
    let finished = Arc::new(AtomicBool::new(false));
    let (done, own) = (finished.clone(), progress.clone());
    // Where no thread is to be had, nobody watches.
    let watcher = thread::Builder::new().spawn(move || watch(&own, &done)).ok();
    let result = compute();
    finished.store(true, Ordering::Relaxed);
    if let Some(watcher) = watcher {
        watcher.thread().unpark();
        // The watcher only tells, so that its failure changes nothing.
        let _ = watcher.join();
    }
    result
}

fn watch(progress: &Progress, done: &AtomicBool) {
    let start = Instant::now();
    let is_seen = std::io::stderr().is_terminal();
    let mut next = if is_seen { BAR_AFTER } else { LINE_EVERY };
    while !done.load(Ordering::Relaxed) {
        thread::park_timeout(Duration::from_millis(100));
        if start.elapsed() < next || done.load(Ordering::Relaxed) {
            continue;
        }
        if is_seen {
            return draw(progress, done);
        }
        say!("{}", line(progress, start.elapsed()));
        next += LINE_EVERY;
    }
}

/// How far a computation is: `computing for 10 s, 40 % done, about 15 s left`.
fn line(progress: &Progress, so_far: Duration) -> String {
    let (finished, total) = progress.read();
    let so_far = so_far.as_secs_f64();
    let left = so_far * (total as f64 / finished as f64 - 1.0);
    let told = match (finished, total) {
        // Nothing is known of what comes: neither before the first part of it, nor behind the last.
        (finished, total) if finished == 0 || finished >= total => String::new(),
        _ => format!(
            ", {:.0} % of what is known to come is done, about {left:.0} s left",
            100.0 * (so_far / (so_far + left))
        ),
    };
    format!("computing for {so_far:.0} s{told}")
}

fn draw(progress: &Progress, done: &AtomicBool) {
    // A dumb terminal cannot go back to draw a bar anew.
    let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    let bar = if is_dumb { ProgressBar::hidden() } else { ProgressBar::new(1) };
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {elapsed} so far, {eta} left") {
        bar.set_style(if look::is_ascii() { style.progress_chars("#>-") } else { style });
    }
    while !done.load(Ordering::Relaxed) {
        let (finished, total) = progress.read();
        bar.set_length(total);
        bar.set_position(finished);
        thread::park_timeout(Duration::from_millis(100));
    }
    bar.finish_and_clear();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_tells_what_is_known() {
        let progress = Progress::default();
        assert_eq!(line(&progress, Duration::from_secs(5)), "computing for 5 s");
        progress.expect(4);
        progress.advance(1);
        let told = "computing for 5 s, 25 % of what is known to come is done, about 15 s left";
        assert_eq!(line(&progress, Duration::from_secs(5)), told);
    }
}
