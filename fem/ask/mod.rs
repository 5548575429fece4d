//! Questions about models and measurements, with types of their own in, and answers out. Nothing is printed, and no
//! file of the user's is written but the rows of a study; progress, and a wish to stop, are handed in. The command
//! line, the Python module and anything else that shows answers are faces on this room.

mod catalogue;
mod comparison;
mod compensation;
mod completion;
mod correction;
mod error;
mod importing;
mod next;
mod page;
mod planning;
mod program;
mod reading;
mod revision;
mod run;
mod start;
mod study;

pub use catalogue::catalogue;
pub use comparison::{compare_all, refuse_mixed};
pub use compensation::compensate;
pub use completion::{completed, extended, fit, fitted, mended, notes, steps, usual_said, with_usual};
pub use correction::{action, correct, remedies};
pub use error::{Error, Marks};
pub use importing::look;
pub use next::{Added, Change, Log};
pub use page::{Depth, Made, Page};
pub use planning::plan;
pub use program::program;
pub use reading::{read, read_all};
pub use revision::revised;
pub use run::{predict, run};
pub use start::{STORY, StartingFile, starting_file, starting_files, starting_variant};
pub use study::{Study, do_jobs, study};
