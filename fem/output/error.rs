//! How writing fails.

use std::path::PathBuf;

use super::vtk::VtkError;

/// Writing failed.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The file system refused.
    #[error("{} cannot be written: {error}", path.display())]
    File {
        /// Which file.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// A shape cannot be written as VTK.
    #[error("{} cannot be written: {error}", path.display())]
    Shape {
        /// Which file.
        path: PathBuf,
        /// Why.
        error: VtkError,
    },
    /// A file stands in its place that the program did not write, or that was changed since.
    #[error("{} is there already, and not as this program wrote it", path.display())]
    Exists {
        /// Which file.
        path: PathBuf,
    },
    /// It would stand where a file is that was read.
    #[error("{} is itself what is read", path.display())]
    Read {
        /// Which file.
        path: PathBuf,
    },
}
