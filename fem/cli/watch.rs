//! Watches a command: shows a progress bar when it takes long, and ends it cleanly on Ctrl-C.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::look;
use crate::output::files;
use crate::progress::Progress;

/// Removes partial files on Ctrl-C and ends with the status that shells expect.
pub fn stop_cleanly() {
    // Without a handler the program still works, and leaves at worst a hidden partial file when stopped.
    let _ = ctrlc::set_handler(|| {
        files::abandon();
        std::process::exit(130);
    });
}

/// Progress bar on stderr, if the work takes longer than a second and stderr is a terminal.
pub struct Bar {
    finished: Arc<AtomicBool>,
    watcher: thread::JoinHandle<()>,
}

/// Watches the progress from a thread of its own.
pub fn show(progress: &Arc<Progress>) -> Bar {
    let finished = Arc::new(AtomicBool::new(false));
    let (done, progress) = (finished.clone(), progress.clone());
    let watcher = thread::spawn(move || {
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(1) {
            if done.load(Ordering::Relaxed) {
                return;
            }
            thread::park_timeout(Duration::from_millis(50));
        }
        draw(&progress, &done);
    });
    Bar { finished, watcher }
}

fn draw(progress: &Progress, done: &AtomicBool) {
    // A dumb terminal cannot go back to draw a bar anew.
    let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    let bar = if is_dumb { ProgressBar::hidden() } else { ProgressBar::new(1) };
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {eta} left") {
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

impl Bar {
    /// Takes the bar away.
    pub fn finish(self) {
        self.finished.store(true, Ordering::Relaxed);
        self.watcher.thread().unpark();
        // The watcher only draws, so that its failure changes nothing.
        let _ = self.watcher.join();
    }
}
