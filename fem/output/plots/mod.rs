//! Charts of a prediction, a comparison, a cause: chosen by what the coordinates are, whatever the process.

mod about;
mod corrected;
mod law;
mod layout;
mod measured;
mod positioning;
mod predicted;
mod residuals;

pub use corrected::corrected;
pub use law::{Said, law};
pub use measured::{Judged, Rows, agreement, measured};
pub use predicted::{changes, parts, predicted, signatures};
pub use residuals::{along, maps};
