//! Computes beside Python: other Python threads go on, Ctrl-C stops what is computed, and a fault of the program becomes
//! an exception.

use std::any::Any;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use fem::process::Failure;
use fem::progress::Progress;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::error::{Error, fault};

/// Time between two looks at whether Python was interrupted.
const LOOK_EVERY: Duration = Duration::from_millis(50);
/// Time that a stopped computation has to end. One that takes longer is left behind, and ends by itself.
const PATIENCE: Duration = Duration::from_millis(500);
/// As much as the main thread of a program has.
const STACK: usize = 8 << 20;

/// The threads that compute, and the process to which they belong: a process that is forked has none of them.
static THREADS: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// A computation that may take so many seconds.
pub fn within(seconds: Option<f64>) -> Arc<Progress> {
    // A limit that is no time is none.
    Arc::new(Progress::within(seconds.and_then(|s| Duration::try_from_secs_f64(s).ok())))
}

/// What is behind a lock, whatever went wrong in whoever held it before.
pub fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Computes on another thread, without the GIL.
///
/// # Errors
/// That of the computation; `KeyboardInterrupt`, or whatever else a signal handler raises; `fem.Fault` where the program
/// itself goes wrong.
pub fn compute<T: Send + 'static>(
    py: Python,
    progress: &Arc<Progress>,
    work: impl FnOnce(&Arc<Progress>) -> Result<T, Error> + Send + 'static,
) -> PyResult<T> {
    compute_watched(py, progress, |_| Ok(()), work)
}

/// As [`compute`]; `watch` is called now and then meanwhile, and what it raises stops the computation.
///
/// # Errors
/// Those of [`compute`], and that of `watch`.
pub fn compute_watched<T: Send + 'static>(
    py: Python,
    progress: &Arc<Progress>,
    watch: impl Fn(Python) -> PyResult<()>,
    work: impl FnOnce(&Arc<Progress>) -> Result<T, Error> + Send + 'static,
) -> PyResult<T> {
    let (threads, own) = (threads().map_err(|error| error.raised(py))?, progress.clone());
    let (done, result) = channel();
    let run = move || {
        // Where nobody waits any more, nobody is told.
        let _ = done.send(threads.install(|| work(&own)));
    };
    let worker = thread::Builder::new().spawn(run).map_err(|e| refused(&e).raised(py))?;
    let result = Mutex::new(result);
    let wait = |limit| locked(&result).recv_timeout(limit);
    let mut interrupted: Option<(PyErr, Instant)> = None;
    loop {
        match (py.detach(|| wait(LOOK_EVERY)), &interrupted) {
            // What a stopped computation gives is no result.
            (Ok(_) | Err(RecvTimeoutError::Disconnected), Some((interrupt, _))) => return Err(interrupt.clone_ref(py)),
            (Ok(found), None) => return found.map_err(|error| error.raised(py)),
            (Err(RecvTimeoutError::Disconnected), None) => {
                return Err(fault(py, worker.join().err().as_deref().map_or("", said)));
            }
            (Err(RecvTimeoutError::Timeout), Some((interrupt, since))) if since.elapsed() >= PATIENCE => {
                return Err(interrupt.clone_ref(py));
            }
            (Err(RecvTimeoutError::Timeout), _) => {
                let looked = py.check_signals().and_then(|()| if interrupted.is_none() { watch(py) } else { Ok(()) });
                if let (Err(interrupt), None) = (looked, &interrupted) {
                    progress.stop();
                    interrupted = Some((interrupt, Instant::now()));
                }
            }
        }
    }
}

/// The threads of this process. Nobody forks meanwhile: the GIL is held.
fn threads() -> Result<Arc<ThreadPool>, Error> {
    let mut known = locked(&THREADS);
    let process = std::process::id();
    if let Some((owner, threads)) = &*known
        && *owner == process
    {
        return Ok(threads.clone());
    }
    let threads = Arc::new(ThreadPoolBuilder::new().stack_size(STACK).build().map_err(|e| refused(&e))?);
    // Those of another process cannot be ended from here.
    if let Some(others) = known.replace((process, threads.clone())) {
        std::mem::forget(others);
    }
    Ok(threads)
}

fn refused(error: &dyn std::error::Error) -> Error {
    let message = format!("there is no thread to compute on: {error}");
    Error::from(Failure { message, help: "end other programs, or raise the limit of processes".into() })
}

/// The message of a panic.
fn said(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<&str>().copied();
    text.or_else(|| payload.downcast_ref::<String>().map(String::as_str)).unwrap_or_default()
}
