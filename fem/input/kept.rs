//! Results that a model keeps from one reading of its tables to the next: a search reads them again with
//! other values, and files, meshes and solutions that do not depend on those stay as they are.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Everything that one model keeps. Clones share it.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    /// By its type; edited models share it.
    results: Arc<Mutex<HashMap<TypeId, Entry>>>,
    /// By its type, of these tables alone.
    readings: Arc<Mutex<HashMap<TypeId, Entry>>>,
    /// What tables were read as, by their paths.
    tables: Arc<Mutex<HashMap<String, Entry>>>,
}

type Entry = Arc<dyn Any + Send + Sync>;

/// A panic while a map was held leaves it whole: entries are added in one step each.
fn lock<K>(map: &Mutex<HashMap<K, Entry>>) -> MutexGuard<'_, HashMap<K, Entry>> {
    map.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The entry of a type, empty at first.
fn entry<T: Any + Default + Send + Sync>(of: &Mutex<HashMap<TypeId, Entry>>) -> Arc<T> {
    let mut all = lock(of);
    let entry = all.entry(TypeId::of::<T>()).or_insert_with(|| Arc::new(T::default()));
    entry.clone().downcast().unwrap_or_default()
}

impl Kept {
    /// The entry of this type, empty at first.
    pub fn get<T: Any + Default + Send + Sync>(&self) -> Arc<T> {
        entry(&self.results)
    }

    /// The same of an entry that depends on what the tables hold.
    pub fn of_tables<T: Any + Default + Send + Sync>(&self) -> Arc<T> {
        entry(&self.readings)
    }

    /// The same for a model with other tables: what was read of those is forgotten.
    #[must_use]
    pub fn with_other_tables(&self) -> Self {
        Self { results: self.results.clone(), ..Self::default() }
    }

    /// What the table of this path was read as.
    pub(super) fn table<T: Any + Send + Sync>(&self, path: &str) -> Option<Arc<T>> {
        lock(&self.tables).get(path)?.clone().downcast().ok()
    }

    /// Keeps what the table of this path was read as.
    pub(super) fn keep_table<T: Any + Send + Sync>(&self, path: &str, read: T) {
        lock(&self.tables).insert(path.to_string(), Arc::new(read));
    }
}

/// The results of the questions that were asked last, at most `MOST`.
#[derive(Debug)]
pub struct Cache<K, V, const MOST: usize>(Mutex<Vec<(K, Arc<V>)>>);

impl<K, V, const MOST: usize> Default for Cache<K, V, MOST> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

/// Caches are equal, whatever they hold: it changes no result.
impl<K, V, const MOST: usize> PartialEq for Cache<K, V, MOST> {
    fn eq(&self, _other: &Self) -> bool {
        true
    }
}

impl<K: PartialEq, V, const MOST: usize> Cache<K, V, MOST> {
    /// The result for a question, found by `find` where it is not known.
    ///
    /// # Errors
    /// That of `find`; nothing is kept then.
    pub fn get_or<E>(&self, question: K, find: impl FnOnce(&K) -> Result<V, E>) -> Result<Arc<V>, E> {
        // A panic while the list was held leaves it whole: entries are added and removed in one step each.
        let list = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        {
            let mut list = list();
            // The last is the likeliest, and what is asked for again stays.
            if let Some(place) = list.iter().rposition(|(known, _)| *known == question) {
                list[place..].rotate_left(1);
                if let Some((_, known)) = list.last() {
                    return Ok(known.clone());
                }
            }
        }
        // Found without the list, which others need meanwhile; two that find the same do no harm.
        let found = Arc::new(find(&question)?);
        let mut list = list();
        if list.len() >= MOST {
            list.remove(0);
        }
        list.push((question, found.clone()));
        Ok(found)
    }
}
