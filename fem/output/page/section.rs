//! A part of the page.

/// A part of the page, with a place in its table of contents.
pub struct Section {
    /// Name by which links lead to it.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// Pieces of HTML.
    pub blocks: Vec<String>,
}
