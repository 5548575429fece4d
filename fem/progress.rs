//! The progress of a computation, for whoever watches, and the time that it may take.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Counts finished units of work. Computing code adds; a watcher on another thread reads. Where there is a time
/// limit, code asks before every step that may be left out, and what was left out is remembered. Whoever does not want
/// the result any more stops it.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    total: AtomicU64,
    deadline: Option<Instant>,
    stopped: AtomicBool,
    undone: Mutex<Vec<String>>,
}

impl Progress {
    /// A computation that may take so long from now on.
    pub fn within(limit: Option<Duration>) -> Self {
        // A limit beyond what a clock can tell is none.
        Self { deadline: limit.and_then(|limit| Instant::now().checked_add(limit)), ..Self::default() }
    }

    /// Announces `units` more of work.
    pub fn expect(&self, units: u64) {
        self.total.fetch_add(units, Ordering::Relaxed);
    }

    /// Reports `units` as finished.
    pub fn advance(&self, units: u64) {
        self.done.fetch_add(units, Ordering::Relaxed);
    }

    /// Finished and announced units.
    pub fn read(&self) -> (u64, u64) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed))
    }

    /// Whether there is a time limit.
    pub fn is_limited(&self) -> bool {
        self.deadline.is_some()
    }

    /// Asks the computation to end as soon as it can: nobody waits for its result.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Whether it was asked to end; what it gives then is no result.
    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// Whether the time is over.
    pub fn is_over(&self) -> bool {
        self.is_stopped() || self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Whether there is time for a step that may be left out; where there is none, `what` is left undone.
    pub fn permits(&self, what: &str) -> bool {
        if !self.is_over() {
            return true;
        }
        let mut undone = self.undone.lock().unwrap_or_else(PoisonError::into_inner);
        if undone.iter().all(|known| known != what) {
            undone.push(what.to_string());
        }
        false
    }

    /// What was left undone for want of time, in no order.
    pub fn left_undone(&self) -> Vec<String> {
        self.undone.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_there_is_no_time_for_is_remembered_once() {
        let endless = Progress::default();
        assert!(endless.permits("a") && !endless.is_over() && endless.left_undone().is_empty());
        let over = Progress::within(Some(Duration::ZERO));
        assert!(over.is_over() && !over.permits("a") && !over.permits("b") && !over.permits("a"));
        assert_eq!(over.left_undone(), ["a", "b"]);
        assert!(!Progress::within(Some(Duration::MAX)).is_over());
        endless.stop();
        assert!(endless.is_over() && !endless.permits("c"));
    }
}
