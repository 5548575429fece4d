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
use crate::input::end_at_faults;
use crate::output::files;
use crate::progress::Progress;

/// Time after which a bar is drawn, and between two lines where nobody sees a bar.
const BAR_AFTER: Duration = Duration::from_secs(1);
const LINE_EVERY: Duration = Duration::from_secs(5);

/// Removes partial files on Ctrl-C and ends with the status that shells expect; ends at once at a fault of its own; and
/// computes on one thread where the system gives no more.
pub fn prepare() {
    end_at_faults();
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
    let (mut next, mut outlook) = (if is_seen { BAR_AFTER } else { LINE_EVERY }, Outlook::default());
    while !done.load(Ordering::Relaxed) {
        thread::park_timeout(Duration::from_millis(100));
        outlook.look(progress, start.elapsed());
        if start.elapsed() < next || done.load(Ordering::Relaxed) {
            continue;
        }
        if is_seen {
            return draw(progress, done, start, outlook);
        }
        say!("{}", outlook.line(start.elapsed()));
        next += LINE_EVERY;
    }
}

/// Forecast of the time left. A search that finds something looks further, and until it has ended nobody knows how far.
#[derive(Default)]
struct Outlook {
    /// Announced units, and when they were last more than before.
    total: u64,
    grown: Duration,
    /// Finished units, and when they were last fewer.
    finished: u64,
    advanced: Duration,
}

impl Outlook {
    /// Time for which what is announced must have stayed the same.
    const SETTLED: Duration = Duration::from_secs(3);
    /// Times that a unit may take of what the finished ones took: beyond it they are no measure of the rest.
    const PATIENCE: f64 = 1.5;

    fn look(&mut self, progress: &Progress, so_far: Duration) {
        let (finished, total) = progress.read();
        if total > self.total {
            (self.total, self.grown) = (total, so_far);
        }
        if finished > self.finished {
            (self.finished, self.advanced) = (finished, so_far);
        }
    }

    /// Part that is done, and time that is left, s, where they can be told.
    fn left(&self, so_far: Duration) -> Option<(f64, f64)> {
        let Self { finished, total, .. } = *self;
        // Nothing is known of what comes: neither before the first part of it, nor behind the last.
        let is_known = finished > 0 && finished < total && so_far >= self.grown + Self::SETTLED;
        let usual = self.advanced.as_secs_f64() / finished as f64;
        let is_usual = so_far.saturating_sub(self.advanced).as_secs_f64() <= Self::PATIENCE * usual;
        let part = finished as f64 / total as f64;
        (is_known && is_usual).then(|| (part, so_far.as_secs_f64() * (1.0 / part - 1.0)))
    }

    /// How far a computation is: `computing for 10 s, 40 % done, about 15 s left`.
    fn line(&self, so_far: Duration) -> String {
        let told = match self.left(so_far) {
            Some((part, left)) => format!(", {:.0} % done, about {left:.0} s left", 100.0 * part),
            None => "; how much is left shows as it goes".into(),
        };
        format!("computing for {:.0} s{told}", so_far.as_secs_f64())
    }
}

fn draw(progress: &Progress, done: &AtomicBool, start: Instant, mut outlook: Outlook) {
    // A dumb terminal cannot go back to draw a bar anew.
    let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    let bar = if is_dumb { ProgressBar::hidden() } else { ProgressBar::new(1) };
    if let Ok(style) = ProgressStyle::with_template("{bar:40}  {msg}") {
        bar.set_style(if look::is_ascii() { style.progress_chars("#>-") } else { style });
    }
    while !done.load(Ordering::Relaxed) {
        let (finished, total) = progress.read();
        outlook.look(progress, start.elapsed());
        bar.set_length(total);
        bar.set_position(finished);
        bar.set_message(outlook.line(start.elapsed()));
        thread::park_timeout(Duration::from_millis(100));
    }
    bar.finish_and_clear();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_tells_what_is_known() {
        let (progress, mut outlook) = (Progress::default(), Outlook::default());
        let second = Duration::from_secs;
        let unknown = "computing for 5 s; how much is left shows as it goes";
        assert_eq!(outlook.line(second(5)), unknown);
        progress.expect(4);
        progress.advance(1);
        outlook.look(&progress, second(4));
        assert_eq!(outlook.line(second(8)), "computing for 8 s, 25 % done, about 24 s left");
        // One that takes longer than those before it says nothing of the others.
        let late = "computing for 11 s; how much is left shows as it goes";
        assert_eq!(outlook.line(second(11)), late);
        // A search that looks further does not know how far.
        progress.expect(1);
        outlook.look(&progress, second(5));
        assert_eq!(outlook.line(second(5)), unknown);
        assert_eq!(outlook.line(second(9)), "computing for 9 s, 20 % done, about 36 s left");
    }
}
