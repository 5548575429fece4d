//! Tables within tables: one that must be there, one that may be left out, lists, tables by name.

use serde_json::json;
use toml_edit::{Item, Value};

use super::{Ground, Problem, Reader};
use crate::input::{Name, did_you_mean};

/// Whether a table's name is a known one, or that of a further table of its kind: `zero-shift-2`.
pub fn is_one_of(name: &str, known: &str) -> bool {
    let is_number = |rest: &str| rest.strip_prefix('-').is_some_and(|n| n.parse::<u32>().is_ok_and(|n| n > 1));
    name.strip_prefix(known).is_some_and(|rest| rest.is_empty() || is_number(rest))
}

/// The names of a table and of further ones of its kind: `zero-shift`, `zero-shift-2`, `zero-shift-3`, ….
pub fn numbered(name: &str) -> impl Iterator<Item = String> + use<'_> {
    std::iter::once(name.to_string()).chain((2..).map(move |number| format!("{name}-{number}")))
}

/// The names that tables of the user's choice may have.
pub struct Names<'n> {
    /// Those that are known, for the schema.
    pub known: &'n [Name],
    /// The key that marks a table as the user's own.
    pub mark: &'static str,
    /// The name to keep, given one and whether its table is marked.
    pub find: &'n dyn Fn(&str, bool) -> Result<Name, Problem>,
}

impl<'a> Reader<'a> {
    /// A table that must be there.
    pub fn table<T>(&self, key: impl Into<Name>, about: &'static str, read: impl FnOnce(&Reader<'a>) -> T) -> T {
        let key = key.into();
        let ground = match self.item(key.clone()) {
            Some(item) => self.ground_of(&key, item, "a table"),
            None => {
                self.missing(&key, &format!("[{key}]"), about);
                Ground::Absent
            }
        };
        self.read_child(&key, about, ground, true, read)
    }

    /// A table that may be left out.
    pub fn optional_table<T>(
        &self,
        key: &'static str,
        about: &'static str,
        read: impl FnOnce(&Reader<'a>) -> T,
    ) -> Option<T> {
        let ground = match self.item(key) {
            Some(item) => self.ground_of(key, item, "a table"),
            None => Ground::Absent,
        };
        let given = !matches!(ground, Ground::Absent) || matches!(self.ground, Ground::Described);
        given.then(|| self.read_child(key, about, ground, false, read))
    }

    fn read_child<T>(
        &self,
        key: &str,
        about: &str,
        ground: Ground<'a>,
        required: bool,
        read: impl FnOnce(&Reader<'a>) -> T,
    ) -> T {
        let described = matches!(self.ground, Ground::Described);
        let reader = self.child(if described { Ground::Described } else { ground }, key);
        let value = read(&reader);
        reader.finish();
        if described {
            self.describe(key, || reader.shape.take().into_schema(about), required);
        }
        value
    }

    /// A list of tables, empty where the key is absent. `read` also gets the position, from 0.
    pub fn list<T>(&self, key: &'static str, about: &'static str, read: impl Fn(&Reader<'a>, usize) -> T) -> Vec<T> {
        if matches!(self.ground, Ground::Described) {
            let reader = self.child(Ground::Described, key);
            let example = read(&reader, 0);
            let items = reader.shape.take().into_schema(about);
            self.describe(key, || json!({ "type": "array", "description": about, "items": items }), false);
            return vec![example];
        }
        let Some(item) = self.item(key) else { return Vec::new() };
        let mut grounds = Vec::new();
        match item {
            Item::Value(Value::Array(array)) => {
                for value in array {
                    match value.as_inline_table() {
                        Some(table) => grounds.push(Ground::Given(table, value.span())),
                        None => self.refuse(
                            Problem::new(format!("an entry of `{key}`: expected a table, found {}", value.type_name()))
                                .help("write { key = value, … }")
                                .at(value.span()),
                        ),
                    }
                }
            }
            Item::ArrayOfTables(tables) => grounds.extend(tables.iter().map(|t| Ground::Given(t, t.span()))),
            _ => self.refuse(
                Problem::new(format!("`{key}`: expected a list, found {}", item.type_name()))
                    .help(format!("write {key} = [{{ … }}]"))
                    .at(item.span()),
            ),
        }
        let mut values = Vec::with_capacity(grounds.len());
        for (i, ground) in grounds.into_iter().enumerate() {
            let reader = self.child(ground, &format!("{key}[{i}]"));
            values.push(read(&reader, i));
            reader.finish();
        }
        values
    }

    /// A table, or a list of tables, of which it is the only one: `[model]` or `[[model]]`.
    pub fn one_or_list<T>(
        &self,
        key: &'static str,
        about: &'static str,
        read: impl Fn(&Reader<'a>, usize) -> T,
    ) -> Vec<T> {
        let is_table = matches!(self.item(key), Some(Item::Table(_) | Item::Value(Value::InlineTable(_))));
        if is_table {
            return self.optional_table(key, about, |t| read(t, 0)).into_iter().collect();
        }
        self.list(key, about, read)
    }

    /// Tables with names of the user's choice: `[effects.NAME]`. Each is read with its name.
    pub fn named_tables<T>(
        &self,
        key: &'static str,
        about: &'static str,
        names: Names,
        read: impl Fn(&Name, &Reader<'a>) -> T,
    ) -> Vec<T> {
        let item = self.item(key);
        let parent = match (&self.ground, item) {
            (Ground::Described, _) => self.child(Ground::Described, key),
            (_, Some(item)) => self.child(self.ground_of(key, item, "a table of tables"), key),
            (_, None) => return Vec::new(),
        };
        let mut values = Vec::new();
        for name in parent.names(&names) {
            let ground = match parent.item(name.clone()) {
                Some(item) => parent.ground_of(&name, item, "a table"),
                None => Ground::Described,
            };
            parent.read_child(&name, about, ground, false, |reader| values.push(read(&name, reader)));
        }
        if matches!(self.ground, Ground::Described) {
            let schema = || {
                let mut schema = parent.shape.take().into_schema(about);
                schema["additionalProperties"] = json!({
                    "type": "object",
                    "required": [names.mark],
                    "properties": { names.mark: { "type": "string" } },
                    "additionalProperties": { "type": ["string", "number"] },
                });
                schema
            };
            self.describe(key, schema, false);
        }
        values
    }

    /// All keys of this table that are not asked for before, nor `later`, each a table with a name of the user's choice,
    /// read with its name.
    pub fn own_tables<T>(
        &self,
        later: &[&str],
        about: &'static str,
        read: impl Fn(&Name, &Reader<'a>) -> T,
    ) -> Vec<(Name, T)> {
        let each = |name: Name| (name.clone(), self.table(name.clone(), about, |t| read(&name, t)));
        if matches!(self.ground, Ground::Described) {
            let example = each(Name::new(""));
            self.describe_further("");
            return vec![example];
        }
        self.further().into_iter().filter(|name| !later.contains(&name.as_str())).map(each).collect()
    }

    /// Makes what is described behind a key the schema of names of the user's choice.
    pub(in crate::input) fn describe_further(&self, key: &str) {
        let mut shape = self.shape.borrow_mut();
        shape.further = shape.properties.remove(key);
        shape.required.retain(|required| required != key);
    }

    /// Tables with names of a list within a table that may hold other keys too, which somebody else reads
    /// ([`Reader::part`] was called before): `[measurement.NAME]`, and further ones as `[measurement.NAME-2]`.
    /// Each is read with the name of the list, and its own.
    pub fn tables_within<T>(
        &self,
        key: &'static str,
        about: &'static str,
        known: &[&'static str],
        read: impl Fn(&'static str, &str, &Reader<'a>) -> T,
    ) -> Vec<T> {
        let is_read = self.asked.borrow().iter().any(|name| *name == key);
        let mut values = Vec::new();
        if matches!(self.ground, Ground::Described) {
            let parent = self.child(Ground::Described, key);
            for name in known {
                parent
                    .read_child(name, about, Ground::Described, false, |reader| values.push(read(name, name, reader)));
            }
            let own = parent.shape.take().into_schema(about);
            let mut shape = self.shape.borrow_mut();
            match shape.properties.get_mut(key).and_then(|s| s["properties"].as_object_mut()) {
                Some(there) => there.extend(own["properties"].as_object().cloned().unwrap_or_default()),
                None => drop(shape.properties.insert(key.to_string(), own)),
            }
            let further = format!("^({})-[1-9][0-9]*$", known.join("|"));
            shape.properties[key]["patternProperties"] = json!({ further: { "type": "object" } });
            return values;
        }
        let Some(item) = self.item(key) else { return values };
        let Ground::Given(table, span) = self.ground_of(key, item, "a table of tables") else { return values };
        let parent = self.child(Ground::Given(table, span), key);
        for (name, item) in table.iter() {
            if !item.is_table_like() && is_read {
                continue;
            }
            let span = table.key(name).and_then(|k| k.span());
            let Some(known) = known.iter().copied().find(|known| is_one_of(name, known)) else {
                let meant = did_you_mean(name, known.iter().copied(), '`');
                let problem = Problem::new(format!("`{name}` is no effect of the measurement known here"));
                parent.refuse(problem.help(format!("{meant}known are {}", known.join(", "))).at(span));
                continue;
            };
            let ground = parent.ground_of(name, item, "a table");
            parent.read_child(name, about, ground, false, |reader| values.push(read(known, name, reader)));
        }
        values
    }

    /// The names in the order in which the file has them (all that are known, where there is no file).
    fn names(&self, names: &Names) -> Vec<Name> {
        let Ground::Given(table, _) = &self.ground else { return names.known.to_vec() };
        let mut found = Vec::new();
        for (name, item) in table.iter() {
            let is_marked = item.as_table_like().is_some_and(|t| t.contains_key(names.mark));
            match (names.find)(name, is_marked) {
                Ok(name) => found.push(name),
                Err(problem) => self.refuse(problem.at(table.key(name).and_then(|k| k.span()))),
            }
        }
        found
    }

    /// A key that holds either a name or a table: a material. `read` gets the name, if there is one, and a
    /// reader of the table, with every key absent where there is none.
    pub fn name_or_table<T>(
        &self,
        key: &'static str,
        about: &'static str,
        names: &[&str],
        read: impl FnOnce(Option<&str>, &Reader<'a>) -> T,
    ) -> T {
        let mut name = None;
        let ground = match self.item(key) {
            Some(item) if item.as_str().is_some() => {
                name = item.as_str();
                Ground::Absent
            }
            Some(item) => self.ground_of(key, item, "a name or a table"),
            None => {
                self.missing(key, &format!("{key} = \"{}\"", names.first().unwrap_or(&"")), about);
                Ground::Absent
            }
        };
        let described = matches!(self.ground, Ground::Described);
        let reader = self.child(if described { Ground::Described } else { ground }, key);
        let value = read(name, &reader);
        reader.finish();
        if described {
            let table = reader.shape.take().into_schema(about);
            self.describe(
                key,
                || json!({ "description": about, "anyOf": [{ "enum": names }, { "type": "string" }, table] }),
                true,
            );
        }
        value
    }

    /// The table that stands behind a key in place of a value, read by `read`; `None` where the key holds no
    /// table. In the schema it is an alternative to what has been described behind the key.
    pub(in crate::input) fn table_instead<T>(
        &self,
        key: &Name,
        about: &str,
        read: impl FnOnce(&Reader<'a>) -> T,
    ) -> Option<T> {
        let ground = match &self.ground {
            Ground::Described => Ground::Described,
            Ground::Given(own, _) if own.get(key).is_some_and(Item::is_table_like) => {
                self.ground_of(key, self.item(key.clone())?, "a table")
            }
            Ground::Given(..) | Ground::Absent => return None,
        };
        let reader = self.child(ground, key);
        let value = read(&reader);
        reader.finish();
        if let Some(own) = self.shape.borrow_mut().properties.get_mut(key.as_str()) {
            *own = json!({ "description": about, "anyOf": [own.take(), reader.shape.take().into_schema(about)] });
        }
        Some(value)
    }

    fn ground_of(&self, key: &str, item: &'a Item, expected: &str) -> Ground<'a> {
        match item.as_table_like() {
            Some(table) => Ground::Given(table, item.span()),
            None => {
                self.refuse(
                    Problem::new(format!("`{key}` is no table")).help(format!("it must be {expected}")).at(item.span()),
                );
                Ground::Absent
            }
        }
    }
}
