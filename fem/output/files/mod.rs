//! Files that appear whole: single ones written beside their place and renamed, those of a run all together. A file
//! that this program did not write stays, unless the user says otherwise.

mod account;
mod appended;
mod beside;
mod guard;
mod page;
mod replace;
mod single;
mod stage;
mod way;
mod work;
mod written;

pub use appended::Appended;
pub use beside::abandon;
pub use guard::Guard;
pub use page::{page_guard, sealed, write_page};
pub use single::write;
pub use stage::Stage;

pub(crate) use written::LIST;

pub(super) use account::Account;
pub(crate) use account::digits;
pub(super) use way::{Way, open as folder_at, reader};
pub(super) use written::read_plain;
