//! What stands in other tables of a file: a key may name it by its path.

use toml_edit::{Item, TableLike, Value};

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
        match table.get(key)?.as_value()? {
            Value::String(text) => Some(text.value().clone()),
            Value::Integer(number) => Some(number.value().to_string()),
            Value::Float(number) => Some(number.value().to_string()),
            _ => None,
        }
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
        match item {
            Item::Value(Value::String(_) | Value::Integer(_) | Value::Float(_)) => paths.push(path),
            _ => item.as_table_like().into_iter().for_each(|table| add_paths(table, &path, paths)),
        }
    }
}
