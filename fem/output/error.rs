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
    /// It would stand where a file is that was read.
    #[error("{} is itself what is read", path.display())]
    Read {
        /// Which file.
        path: PathBuf,
    },
}
