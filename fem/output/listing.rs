//! Lists within a sentence.

use std::fmt::Display;

/// The first of some items, and how many more there are; never one more, which would take no less room.
pub fn listed(items: &[impl Display], most: usize) -> String {
    let shown = if items.len() <= most.saturating_add(1) { items.len() } else { most };
    let all = items.iter().take(shown).map(ToString::to_string).collect::<Vec<_>>().join(", ");
    match items.len() - shown {
        0 => all,
        more => format!("{all} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_counted() {
        assert_eq!(listed(&["a", "b", "c", "d"], 2), "a, b and 2 more");
        assert_eq!(listed(&["a", "b", "c"], 2), "a, b, c");
        assert_eq!(listed(&[0.5], 2), "0.5");
        assert_eq!(listed(&[""; 0], 2), "");
    }
}
