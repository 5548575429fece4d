//! A line on stderr.

/// Prints a line to stderr; nobody is left to be told where that cannot be written.
macro_rules! say {
    ($($what:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), "{}", crate::input::visible(&format!($($what)*)));
    }};
}
pub(super) use say;
