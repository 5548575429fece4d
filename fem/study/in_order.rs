//! Work on all threads, handed on in the order of its numbers.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Condvar, Mutex, PoisonError};

use crate::progress::Progress;

/// Most results that wait for an earlier one.
const MOST_WAITING: u64 = 4096;

/// State shared by all threads.
struct State<T, E, S> {
    /// The next number to be worked on, and to be handed on.
    next: u64,
    due: u64,
    waiting: BTreeMap<u64, T>,
    sink: S,
    failed: Option<E>,
}

/// Does the work of every number and hands the results on in order, whatever the number of threads; ends early,
/// between two numbers, where the time is over. Returns the number with which to go on.
///
/// # Errors
/// The first error of `sink`, after which no more is done.
pub fn in_order<T: Send, E: Send>(
    numbers: Range<u64>,
    progress: &Progress,
    work: impl Fn(u64) -> T + Sync,
    sink: impl FnMut(T) -> Result<(), E> + Send,
) -> Result<u64, E> {
    progress.expect(numbers.end.saturating_sub(numbers.start));
    let state =
        Mutex::new(State { next: numbers.start, due: numbers.start, waiting: BTreeMap::new(), sink, failed: None });
    let freed = Condvar::new();
    let threads = rayon::current_num_threads().max(1);
    let workers = threads.min(usize::try_from(numbers.end.saturating_sub(numbers.start)).unwrap_or(threads)).max(1);
    let own = || {
        let lock = || state.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            let mut shared = lock();
            while shared.next >= shared.due + MOST_WAITING && shared.failed.is_none() {
                shared = freed.wait(shared).unwrap_or_else(PoisonError::into_inner);
            }
            if shared.next >= numbers.end || shared.failed.is_some() || progress.is_over() {
                return;
            }
            let number = shared.next;
            shared.next += 1;
            drop(shared);
            let result = work(number);
            progress.advance(1);
            let shared = &mut *lock();
            shared.waiting.insert(number, result);
            while let Some(result) = shared.waiting.remove(&shared.due) {
                shared.due += 1;
                if shared.failed.is_none() {
                    shared.failed = (shared.sink)(result).err();
                }
            }
            freed.notify_all();
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..workers {
            // A worker computes what is parallel within its work by itself, as far as there is work for all: so
            // none waits for another.
            let spawned = std::thread::Builder::new().spawn_scoped(scope, || {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads / workers).use_current_thread();
                let _pool = pool.build();
                own();
            });
            if spawned.is_err() {
                // Where the system gives no more threads, those that there are do the work.
                break;
            }
        }
    });
    // Nothing is left unless no thread at all was to be had.
    own();
    let state = state.into_inner().unwrap_or_else(PoisonError::into_inner);
    state.failed.map_or(Ok(state.due), Err)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn results_come_in_order_and_once() {
        let mut seen = Vec::new();
        let work = |i: u64| {
            if i.is_multiple_of(7) {
                std::thread::sleep(Duration::from_micros(200));
            }
            i * i
        };
        let next = in_order(5..10_000, &Progress::default(), work, |r| {
            seen.push(r);
            Ok::<(), ()>(())
        });
        assert_eq!(next, Ok(10_000));
        assert!(seen.into_iter().eq((5..10_000).map(|i| i * i)));
    }

    #[test]
    fn an_error_of_the_sink_ends_the_work() {
        let told = in_order(0..1_000_000, &Progress::default(), |i| i, |i| if i < 10 { Ok(()) } else { Err(i) });
        assert_eq!(told, Err(10));
    }

    #[test]
    fn no_time_is_no_work() {
        let over = Progress::within(Some(Duration::ZERO));
        assert_eq!(in_order(3..9, &over, |i| i, |_| Ok::<(), ()>(())), Ok(3));
    }
}
