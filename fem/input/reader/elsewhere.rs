//! What stands in other tables of a file: a key may name it by its path.

use toml_edit::TableLike;

use super::super::written::text_of;
use super::{Ground, Reader};

impl Reader<'_> {
    /// Paths, from this table on, of the values that are texts or numbers, in the order of the file; those in lists of tables
    /// have none.
    pub fn paths(&self) -> Vec<String> {
        let mut paths = Vec::new();
        if let Ground::Given(table, _) = &self.ground {
            add_paths(*table, "", &mut paths);
        }
        paths
    }

    /// The text or number at a path from this table on, as text.
    pub fn text_at(&self, path: &str) -> Option<String> {
        let Ground::Given(table, _) = &self.ground else { return None };
        let (tables, key) = path.rsplit_once('.').unwrap_or(("", path));
        let mut names = tables.split('.').filter(|name| !name.is_empty());
        let table = names.try_fold(*table, |table, name| table.get(name)?.as_table_like())?;
        text_of(table.get(key)?)
    }

    /// The value (SI) that is taken in the place of the one at a path of the file.
    pub fn instead_at(&self, path: &str) -> Option<f64> {
        let instead = &self.findings.instead;
        instead.entered.get(path).or_else(|| instead.tried.get(path)).copied()
    }
}

fn add_paths(table: &dyn TableLike, before: &str, paths: &mut Vec<String>) {
    for (key, item) in table.iter() {
        let path = if before.is_empty() { key.to_string() } else { format!("{before}.{key}") };
        match item.as_table_like() {
            Some(table) => add_paths(table, &path, paths),
            None => paths.extend(text_of(item).map(|_| path)),
        }
    }
}
