//! What must hold of the book before mdBook sees it.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use fem::noise::effects;
use fem::processes::ALL;

use super::{Book, Made, effect, markdown};

/// Texts of all files of the book by their paths; none of those that are not Markdown.
fn files(root: &Path, book: &Book) -> BTreeMap<PathBuf, Option<String>> {
    let is_page = |path: &Path| path.extension().is_some_and(|e| e == "md");
    let read = |path: &PathBuf| is_page(path).then(|| std::fs::read_to_string(root.join(path)).unwrap());
    let copied = book.copied.iter().map(|path| (path.clone(), read(path)));
    let made = book.made.iter().map(|Made { path, text }| (path.clone(), is_page(path).then(|| text.clone())));
    copied.chain(made).collect()
}

#[test]
fn the_book_is_whole() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let book = Book::of(root).unwrap();
    let files = files(root, &book);
    let chapters: Vec<&PathBuf> = book.chapters.iter().filter_map(|c| c.path.as_ref()).collect();
    let once: BTreeSet<&PathBuf> = chapters.iter().copied().collect();
    assert_eq!(once.len(), chapters.len(), "a chapter stands twice in the contents");

    // Every page is a chapter, and every chapter a page.
    for (path, text) in &files {
        assert!(text.is_none() || once.contains(path), "{} is no chapter", path.display());
    }
    for chapter in &chapters {
        assert!(files.contains_key(*chapter), "{} does not exist", chapter.display());
    }
    let docs = std::fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().file_name());
    for page in docs.filter(|name| name.to_string_lossy().ends_with(".md") && name != "SUMMARY.md") {
        assert!(once.contains(&Path::new("docs").join(&page)), "docs/{} is no chapter", page.display());
    }

    // Every process and effect has its page, and its picture where there is something to see.
    for process in ALL {
        assert!(once.contains(&PathBuf::from(format!("docs/processes/{}.md", process.name()))));
        for effect in &process.effects() {
            let page = effect::path(process.name(), &effect.name);
            assert!(once.contains(&page), "{} has no page", effect.name);
            assert!(files.contains_key(&page.with_extension("svg")), "{} has no picture", effect.name);
        }
    }
    for effect in effects::all() {
        assert!(once.contains(&effect::path("measurement", effect.name)), "{} has no page", effect.name);
    }

    // Every link leads to a file of the book, and to a heading of it.
    let mut count = 0;
    for (path, text) in &files {
        for link in text.iter().flat_map(|text| markdown::links(text)) {
            let target = markdown::target(path, link);
            let found = files.get(&target).unwrap_or_else(|| panic!("{}: {link}", path.display()));
            if let Some((_, anchor)) = link.split_once('#') {
                let headings = markdown::anchors(found.as_ref().unwrap());
                assert!(headings.iter().any(|h| h == anchor), "{}: {link} is none of {headings:?}", path.display());
            }
            count += 1;
        }
    }
    assert!(count > 500, "only {count} links were found");
}

#[test]
fn typical_values_are_of_effects_that_exist() {
    let mut count = 0;
    for [process, effect, value, source] in effect::typical_rows() {
        let process = ALL.iter().find(|p| p.name() == process).unwrap_or_else(|| panic!("{process}"));
        assert!(process.effects().iter().any(|e| e.name == effect), "{effect}");
        assert!(!value.is_empty() && !source.is_empty(), "{effect}");
        count += 1;
    }
    assert!(count > 0);
}

#[test]
fn markdown_is_read_and_written() {
    assert_eq!(markdown::plain("a*b_c `d*e` <f>"), "a\\*b\\_c `d*e` \\<f>");
    assert_eq!(markdown::plain("`a|b`"), "`a\\|b`");
    let page = "[a](x.md) `[b](y.md)`\n```text\n[c](z.md)\n```\n[`d`](w.md#e) <https://f>\n[g](https://h)";
    let mut links = markdown::links(page);
    links.sort_unstable();
    assert_eq!(links, ["w.md#e", "x.md"]);
    assert_eq!(markdown::anchors("# A b/1\n```\n# no\n```\n## `c-d` E"), ["a-b1", "c-d-e"]);
    assert_eq!(markdown::target(Path::new("docs/a/b.md"), "../../tests/c.md#d"), Path::new("tests/c.md"));
    assert_eq!(markdown::target(Path::new("docs/a.md"), "#d"), Path::new("docs/a.md"));
}
