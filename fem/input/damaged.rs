//! Damaged files that a library gives up on by a panic. Any other panic is a fault of the program, and ends it at once: files
//! appear whole or not at all, and hidden folders are swept by the next run.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};

thread_local! {
    /// Whether this thread reads what may make a library panic.
    static IS_EXPECTED: Cell<bool> = const { Cell::new(false) };
}

/// What `read` makes of a file; `None` where it panics. It runs on this thread alone, and what it holds is thrown away then.
pub fn unless_damaged<T>(read: impl FnOnce() -> T) -> Option<T> {
    let before = IS_EXPECTED.replace(true);
    let read = catch_unwind(AssertUnwindSafe(read));
    IS_EXPECTED.set(before);
    read.ok()
}

/// Makes every panic end the program, after its message, but for those of damaged files, of which nothing is told here.
pub fn end_at_faults() {
    let told = take_hook();
    set_hook(Box::new(move |panic| {
        if !IS_EXPECTED.get() {
            told(panic);
            std::process::abort();
        }
    }));
}
