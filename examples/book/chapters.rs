//! The chapters of the book in their order, and the files that they bring along.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Path, PathBuf};

use super::{Made, markdown};

/// Where the order of the chapters is written, from the root of the repository.
pub const CONTENTS: &str = "docs/SUMMARY.md";

/// A line of the contents: a chapter, or the heading of a part.
pub struct Chapter {
    /// The line of `SUMMARY.md` up to the path: `- [Title](`; the whole line where there is no path.
    lead: String,
    /// The page, from the root of the repository; none of a heading.
    pub path: Option<PathBuf>,
}

impl Chapter {
    /// A chapter `deep` spaces inside.
    pub fn new(title: &str, path: &Path, deep: usize) -> Self {
        Self { lead: format!("{:deep$}- [{title}](", ""), path: Some(path.to_path_buf()) }
    }
}

/// The contents as they are written by hand.
pub struct Contents {
    text: String,
}

impl Contents {
    /// Reads the contents of a repository.
    pub fn read(root: &Path) -> Result<Self, Box<dyn Error>> {
        Ok(Self { text: std::fs::read_to_string(root.join(CONTENTS))? })
    }

    /// The chapters; `made` gives those that stand where a line is `<!-- NAME -->`, which is so many spaces inside.
    pub fn with(
        &self,
        mut made: impl FnMut(&str, usize) -> Result<Vec<Chapter>, Box<dyn Error>>,
    ) -> Result<Vec<Chapter>, Box<dyn Error>> {
        let mut chapters = Vec::new();
        for line in self.text.lines() {
            let inner = line.trim();
            if let Some(name) = inner.strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->")) {
                chapters.extend(made(name, line.len() - line.trim_start().len())?);
            } else if let Some((lead, link)) = line.split_once("](") {
                let link = link.strip_suffix(')').ok_or_else(|| format!("{CONTENTS}: no link ends {line}"))?;
                let path = markdown::target(Path::new(CONTENTS), link);
                chapters.push(Chapter { lead: format!("{lead}]("), path: Some(path) });
            } else {
                chapters.push(Chapter { lead: line.into(), path: None });
            }
        }
        Ok(chapters)
    }
}

/// The contents as mdBook reads them.
pub fn summary(chapters: &[Chapter]) -> String {
    let line = |chapter: &Chapter| match &chapter.path {
        Some(path) => format!("{}{})\n", chapter.lead, path.display()),
        None => format!("{}\n", chapter.lead),
    };
    chapters.iter().map(line).collect()
}

/// The files of the repository that chapters are, and that these link to.
pub fn copied(root: &Path, chapters: &[Chapter], made: &[Made]) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let is_made = |path: &Path| made.iter().any(|m| m.path == path);
    let pages: BTreeSet<&Path> = chapters.iter().filter_map(|c| c.path.as_deref()).collect();
    let mut files: BTreeSet<PathBuf> = BTreeSet::new();
    for page in pages.iter().filter(|page| !is_made(page)) {
        let text = std::fs::read_to_string(root.join(page)).map_err(|e| format!("{}: {e}", page.display()))?;
        files.insert(page.to_path_buf());
        for link in markdown::links(&text) {
            let target = markdown::target(page, link);
            let place = format!("{}: {link}", page.display());
            if pages.contains(&*target) {
                continue;
            }
            if target.extension().is_some_and(|e| e == "md") {
                return Err(format!("{place} is no chapter of the book; {CONTENTS} lists them").into());
            }
            if !root.join(&target).is_file() {
                return Err(format!("{place} is no file").into());
            }
            files.insert(target);
        }
    }
    Ok(files.into_iter().collect())
}
