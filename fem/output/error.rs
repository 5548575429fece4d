//! How writing fails.

use std::io;
use std::path::{Path, PathBuf};

use super::vtk::VtkError;

/// Writing failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The file system refused.
    #[error("{} cannot be written: {error}", path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Reason.
        error: io::Error,
    },
    /// A shape cannot be written as VTK.
    #[error("{} cannot be written: {error}", path.display())]
    Shape {
        /// Path of the file.
        path: PathBuf,
        /// Reason.
        #[doc(hidden)]
        error: VtkError,
    },
    /// A file stands in its place.
    #[error("{} is there already", path.display())]
    Exists {
        /// Path of the file.
        path: PathBuf,
    },
    /// A file stands among results that is not known to be one of them.
    #[error("{} is there already; it was changed since, or this account did not write it", path.display())]
    NotOwn {
        /// Path of the file.
        path: PathBuf,
    },
    /// Something stands in its place that is no file, such as a device or a pipe.
    #[error("{} is no file, and stays as it is", path.display())]
    Special {
        /// Where.
        path: PathBuf,
    },
    /// The way to it leads over a link that may have come with the files of others.
    #[error("{} is a link{}, and links are not written through here", path.display(), target.as_ref().map_or(String::new(), |t| format!(" to {}", t.display())))]
    Link {
        /// Path of the link.
        path: PathBuf,
        /// Its target, where that exists.
        target: Option<PathBuf>,
    },
    /// Another run of the program writes it.
    #[error("{} is held by another run of fem", path.display())]
    Busy {
        /// Path of the file.
        path: PathBuf,
    },
    /// It would stand where a file is that was read.
    #[error("{} is itself what is read", path.display())]
    Read {
        /// Path of the file.
        path: PathBuf,
    },
}

impl OutputError {
    /// Makes an error of the file system one of a path, in the system's own words: names of partial files stay out of
    /// them.
    pub fn at(path: &Path) -> impl Fn(io::Error) -> Self + use<> {
        let path = path.to_path_buf();
        move |error| {
            let error = error.raw_os_error().map_or(error, io::Error::from_raw_os_error);
            Self::File { path: path.clone(), error }
        }
    }
}
