//! Writes the sources of the book: the pages of this repository, and a page for every process, effect and table of
//! validation, made from the registry. `cargo run --example book && mdbook build target/book`
//!
//! What is written by hand stays where it is, and its links work in the repository as in the book: the sources have
//! the folders of the repository. `docs/SUMMARY.md` says in which order the chapters stand, and where those that are
//! made come in.

mod chapters;
mod effect;
mod hosts;
mod instrument;
mod markdown;
mod process;
#[cfg(test)]
mod tests;
mod validation;

use std::error::Error;
use std::path::{Path, PathBuf};

use chapters::{Chapter, Contents};

/// A file of the book that is made: its path from the root of the repository, and its text.
struct Made {
    path: PathBuf,
    text: String,
}

/// Chapters that are made, each with its page and the pictures on it.
type Pages = Vec<(Chapter, Vec<Made>)>;

/// Everything of the book, by paths from the root of the repository.
struct Book {
    /// Its chapters in their order, with how deep they stand.
    chapters: Vec<Chapter>,
    /// Files that the repository has.
    copied: Vec<PathBuf>,
    /// Files that are made.
    made: Vec<Made>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = std::env::args_os().nth(1).map_or_else(|| root.join("target/book"), PathBuf::from);
    let book = Book::of(root)?;
    book.write(root, &folder)?;
    println!("written {}: {} chapters; now: mdbook build {0}", folder.display(), book.chapters.len());
    Ok(())
}

impl Book {
    /// The book of a repository.
    fn of(root: &Path) -> Result<Self, Box<dyn Error>> {
        let contents = Contents::read(root)?;
        let mut made = Vec::new();
        let chapters = contents.with(|name, deep| {
            let pages = match name {
                "processes" => process::all(deep)?,
                "measurement" => instrument::all(deep),
                "validation" => validation::all(deep),
                _ => return Err(format!("docs/SUMMARY.md: nothing is made for <!-- {name} -->").into()),
            };
            let (chapters, files): (Vec<_>, Vec<_>) = pages.into_iter().unzip();
            made.extend(files.into_iter().flatten());
            Ok(chapters)
        })?;
        let copied = chapters::copied(root, &chapters, &made)?;
        Ok(Self { chapters, copied, made })
    }

    /// Writes the sources into a folder, which they have for themselves.
    fn write(&self, root: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
        let sources = folder.join("src");
        if sources.exists() {
            std::fs::remove_dir_all(&sources)?;
        }
        std::fs::create_dir_all(&sources)?;
        for name in ["book.toml", "book.css"] {
            std::fs::copy(root.join("docs").join(name), folder.join(name))?;
        }
        let place = |path: &Path| -> std::io::Result<PathBuf> {
            let place = sources.join(path);
            std::fs::create_dir_all(place.parent().unwrap_or(&sources))?;
            Ok(place)
        };
        for path in &self.copied {
            std::fs::copy(root.join(path), place(path)?)?;
        }
        for Made { path, text } in &self.made {
            std::fs::write(place(path)?, text)?;
        }
        std::fs::write(sources.join("SUMMARY.md"), chapters::summary(&self.chapters))?;
        Ok(())
    }
}
