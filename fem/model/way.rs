//! Ways to the keys of a document's tables, by paths such as `workpiece.segments[1].diameter`.

use toml_edit::{InlineTable, Item, Table, TableLike, Value};

/// A key on the way to another, and the number of an entry, from 0, where a list of tables stands behind it.
pub type Step = (String, Option<usize>);

/// The way to the value, or else to the table, at a path such as `workpiece.segments[1].diameter`. Keys may have dots
/// themselves: every one is tried that the path begins with.
pub fn way(table: &dyn TableLike, path: &str, is_table: bool) -> Option<Vec<Step>> {
    table.iter().find_map(|(key, item)| {
        let rest = path.strip_prefix(key)?;
        let (entry, rest) = match rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
            Some((number, rest)) => (Some(number.parse().ok()?), rest),
            None => (None, rest),
        };
        let mut steps = vec![(key.to_string(), entry)];
        let within = entry_of(item, entry);
        if rest.is_empty() {
            return (within.is_some() == is_table && (is_table || entry.is_none())).then_some(steps);
        }
        steps.extend(way(within?, rest.strip_prefix('.')?, is_table)?);
        Some(steps)
    })
}

/// A table, or one of a list of tables.
pub fn entry_of(item: &Item, number: Option<usize>) -> Option<&dyn TableLike> {
    match (item, number) {
        (item, None) => item.as_table_like(),
        (Item::ArrayOfTables(list), Some(number)) => list.get(number).map(|table| table as &dyn TableLike),
        (item, Some(number)) => item.as_array()?.get(number)?.as_inline_table().map(|table| table as &dyn TableLike),
    }
}

/// The same, to be changed.
fn entry_of_mut(item: &mut Item, number: Option<usize>) -> Option<&mut dyn TableLike> {
    match (item, number) {
        (item, None) => item.as_table_like_mut(),
        (Item::ArrayOfTables(list), Some(number)) => list.get_mut(number).map(|table| table as &mut dyn TableLike),
        (item, Some(number)) => {
            item.as_array_mut()?.get_mut(number)?.as_inline_table_mut().map(|table| table as &mut dyn TableLike)
        }
    }
}

/// Puts a value behind a key, which may be new; `None` where its table is missing.
pub fn set(tables: &mut Table, path: &str, mut value: Value) -> Option<()> {
    let new = || {
        let (above, key) = path.rsplit_once('.').unwrap_or(("", path));
        if key.is_empty() || key.contains(['[', ']']) {
            return None;
        }
        let mut steps = if above.is_empty() { Vec::new() } else { way(tables, above, true)? };
        steps.push((key.to_string(), None));
        Some(steps)
    };
    let steps = way(tables, path, false).or_else(new)?;
    let ((key, _), above) = steps.split_last()?;
    let mut table: &mut dyn TableLike = tables;
    for (key, entry) in above {
        table = entry_of_mut(table.get_mut(key)?, *entry)?;
    }
    match table.get_mut(key) {
        Some(item) => {
            if let Some(old) = item.as_value() {
                value.decor_mut().clone_from(old.decor());
            }
            *item = Item::Value(value);
        }
        None => drop(table.insert(key, Item::Value(value))),
    }
    Some(())
}

/// Puts a value at a path, making the tables on the way that are missing; `None` where there is no such way.
pub fn write(tables: &mut dyn TableLike, path: &str, value: &Value) -> Option<()> {
    let steps = way(tables, path, false).or_else(|| way(tables, path, true));
    let Some(((key, entry), above)) = steps.as_ref().and_then(|steps| steps.split_last()) else {
        // The longest part of the way that is there, and one key more.
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        if first.is_empty() || (first.contains('[') && way(tables, first, true).is_none()) {
            return None;
        }
        if rest.is_empty() {
            // A table at the top of a file stands by itself.
            tables.insert(
                first,
                match value {
                    Value::InlineTable(own) => Item::Table(own.clone().into_table()),
                    other => Item::Value(other.clone()),
                },
            );
            return Some(());
        }
        let (key, number) = way(tables, first, true).and_then(|mut steps| steps.pop()).unwrap_or((first.into(), None));
        if tables.get(&key).is_none() {
            tables.insert(&key, Item::Value(Value::InlineTable(InlineTable::new())));
        }
        return write(entry_of_mut(tables.get_mut(&key)?, number)?, rest, value);
    };
    let mut table: &mut dyn TableLike = tables;
    for (key, entry) in above {
        table = entry_of_mut(table.get_mut(key)?, *entry)?;
    }
    let item = table.get_mut(key)?;
    match (entry_of_mut(item, *entry), value) {
        (Some(there), Value::InlineTable(own)) => {
            own.iter().try_for_each(|(key, value)| write_key(there, key, value))?;
        }
        (Some(_), _) if entry.is_some() => return None,
        _ => *item = Item::Value(value.clone()),
    }
    Some(())
}

/// Puts a value behind a key of a table, whose name may have dots.
fn write_key(table: &mut dyn TableLike, key: &str, value: &Value) -> Option<()> {
    match (table.get_mut(key).and_then(Item::as_table_like_mut), value) {
        (Some(there), Value::InlineTable(own)) => own.iter().try_for_each(|(key, own)| write_key(there, key, own)),
        _ => {
            table.insert(key, Item::Value(value.clone()));
            Some(())
        }
    }
}

/// Leaves out what stands at a path.
pub fn erase(tables: &mut dyn TableLike, path: &str) {
    let steps = way(tables, path, false).or_else(|| way(tables, path, true));
    let Some(((key, entry), above)) = steps.as_ref().and_then(|steps| steps.split_last()) else { return };
    let mut table: &mut dyn TableLike = tables;
    for (key, entry) in above {
        match table.get_mut(key).and_then(|item| entry_of_mut(item, *entry)) {
            Some(within) => table = within,
            None => return,
        }
    }
    match (entry, table.get_mut(key)) {
        (None, _) => drop(table.remove(key)),
        (Some(number), Some(Item::ArrayOfTables(list))) if *number < list.len() => drop(list.remove(*number)),
        (Some(number), Some(item)) => {
            if let Some(list) = item.as_array_mut().filter(|list| *number < list.len()) {
                let gone = list.remove(*number);
                // What is first now stands where the first one stood.
                if let Some(first) = list.get_mut(0).filter(|_| *number == 0) {
                    first.decor_mut().clone_from(gone.decor());
                }
            }
        }
        (Some(_), None) => {}
    }
}

/// Puts a table of a list, at a path such as `workpiece.segments[1]`, there a second time; `None` where there is none.
pub fn copy(tables: &mut dyn TableLike, path: &str) -> Option<()> {
    let steps = way(tables, path, true)?;
    let ((key, number), above) = steps.split_last()?;
    let number = (*number)?;
    let mut table: &mut dyn TableLike = tables;
    for (key, entry) in above {
        table = entry_of_mut(table.get_mut(key)?, *entry)?;
    }
    match table.get_mut(key)? {
        Item::ArrayOfTables(list) => {
            // The copy stands at the place of its original in the file, where tables within both would stand among
            // each other.
            let own = list.get(number).filter(|own| !own.iter().any(|(_, item)| item.is_table()))?.clone();
            let mut all: Vec<Table> = list.iter().cloned().collect();
            all.insert(number + 1, own);
            *list = all.into_iter().collect();
        }
        item => {
            let list = item.as_array_mut()?;
            let own = list.get(number)?.clone();
            list.insert_formatted(number + 1, own);
            // What stands on one line has a blank behind each comma.
            let after = list.get_mut(number + 1)?;
            if after.decor().prefix().and_then(|own| own.as_str()).is_none_or(str::is_empty) {
                after.decor_mut().set_prefix(" ");
            }
        }
    }
    Some(())
}

/// Gives a table of a list other keys; `None` where there is none, or the keys are none.
pub fn replace(tables: &mut dyn TableLike, path: &str, value: &Value) -> Option<()> {
    let steps = way(tables, path, true)?;
    let mut table: &mut dyn TableLike = tables;
    for (key, entry) in &steps {
        table = entry_of_mut(table.get_mut(key)?, *entry)?;
    }
    let own = value.as_inline_table()?;
    let gone: Vec<String> = table.iter().map(|(key, _)| key.to_string()).filter(|key| !own.contains_key(key)).collect();
    gone.iter().for_each(|key| drop(table.remove(key)));
    own.iter().for_each(|(key, value)| drop(table.insert(key, Item::Value(value.clone()))));
    Some(())
}
