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
    evaluations: AtomicU64,
    profile: Mutex<Profile>,
}

/// Stretches of a computation, each with what it took less what stretches within it took.
#[derive(Debug, Default)]
struct Profile {
    stretches: Vec<Stretch>,
    /// Those that are open, the innermost last: number, start, evaluations at the start; time and evaluations of what
    /// lay within.
    open: Vec<(usize, Instant, u64, Duration, u64)>,
}

/// Cost of a stretch of a computation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Name of the work.
    pub name: &'static str,
    /// How often.
    pub times: u64,
    /// Evaluations of the model.
    pub evaluations: u64,
    /// Time on the clock.
    pub time: Duration,
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

    /// Counts an evaluation of the model.
    #[doc(hidden)]
    pub fn evaluated(&self) {
        self.evaluations.fetch_add(1, Ordering::Relaxed);
    }

    /// Does a stretch of work, and notes what it takes. Stretches follow each other or lie within each other; those of
    /// several threads at once would be told wrongly.
    #[doc(hidden)]
    pub fn stretch<T>(&self, name: &'static str, work: impl FnOnce() -> T) -> T {
        self.begin(name);
        let result = work();
        self.end();
        result
    }

    fn begin(&self, name: &'static str) {
        let mut profile = self.profile.lock().unwrap_or_else(PoisonError::into_inner);
        let Profile { stretches, open } = &mut *profile;
        let number = stretches.iter().position(|s| s.name == name).unwrap_or_else(|| {
            stretches.push(Stretch { name, times: 0, evaluations: 0, time: Duration::ZERO });
            stretches.len() - 1
        });
        stretches[number].times += 1;
        open.push((number, Instant::now(), self.evaluations.load(Ordering::Relaxed), Duration::ZERO, 0));
    }

    fn end(&self) {
        let mut profile = self.profile.lock().unwrap_or_else(PoisonError::into_inner);
        let Profile { stretches, open } = &mut *profile;
        let Some((number, start, before, time_within, evaluations_within)) = open.pop() else { return };
        let (time, evaluations) = (start.elapsed(), self.evaluations.load(Ordering::Relaxed) - before);
        stretches[number].time += time.saturating_sub(time_within);
        stretches[number].evaluations += evaluations - evaluations_within;
        if let Some((.., time_of_parent, evaluations_of_parent)) = open.last_mut() {
            *time_of_parent += time;
            *evaluations_of_parent += evaluations;
        }
    }

    /// Cost of each stretch, in the order in which they first began.
    #[doc(hidden)]
    pub fn profile(&self) -> Vec<Stretch> {
        self.profile.lock().unwrap_or_else(PoisonError::into_inner).stretches.clone()
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

    /// Steps left undone for want of time, in no order.
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
