//! Which file of `fem/` uses which other, read from its text: `use` lines and paths, re-exports followed to
//! the file that defines the name. Test code is left out, and so are the re-exports themselves: a door
//! names what lies behind it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A module path: `["process", "ring"]`; empty for the crate.
type Module = Vec<String>;

/// The files of a crate and what they use.
pub struct Sources {
    /// Text of every module's file, test code left out.
    files: BTreeMap<Module, (PathBuf, String)>,
    /// Names that a module re-exports, and the paths that they stand for.
    doors: BTreeMap<(Module, String), Module>,
}

impl Sources {
    pub fn read(root: &Path) -> Self {
        let mut files = BTreeMap::new();
        for path in super::sources(root) {
            let inside = path.strip_prefix(root).unwrap().with_extension("");
            let mut module: Module = inside.iter().map(|part| part.to_str().unwrap().to_string()).collect();
            if module.last().is_some_and(|last| ["mod", "lib"].contains(&last.as_str())) {
                module.pop();
            }
            if module.last().is_some_and(|last| ["main", "tests"].contains(&last.as_str())) {
                continue;
            }
            let text = without_tests(&std::fs::read_to_string(&path).unwrap());
            files.insert(module, (inside, text));
        }
        let mut sources = Self { files, doors: BTreeMap::new() };
        sources.doors = sources.all_doors();
        sources
    }

    fn all_doors(&self) -> BTreeMap<(Module, String), Module> {
        let mut doors = BTreeMap::new();
        for (module, (_, text)) in &self.files {
            for statement in statements(text, "pub use ").into_iter().chain(statements(text, "pub(crate) use ")) {
                for (path, name) in leaves(&statement) {
                    doors.insert((module.clone(), name), self.absolute(module, &path));
                }
            }
            // A private `use` opens the name to the module's children.
            for statement in statements(text, "use ") {
                for (path, name) in leaves(&statement) {
                    doors.entry((module.clone(), name)).or_insert_with(|| self.absolute(module, &path));
                }
            }
        }
        doors
    }

    /// Every use of one file by another.
    pub fn uses(&self) -> BTreeMap<PathBuf, BTreeSet<PathBuf>> {
        let mut uses: BTreeMap<PathBuf, BTreeSet<PathBuf>> = BTreeMap::new();
        for (module, (file, text)) in &self.files {
            let own = uses.entry(file.clone()).or_default();
            let mut paths: Vec<Module> = Vec::new();
            for statement in statements(text, "use ") {
                paths.extend(leaves(&statement).into_iter().map(|(path, _)| path));
            }
            paths.extend(inline(text, &self.children(module)));
            for path in paths {
                if let Some(target) = self.file_of(&self.absolute(module, &path))
                    && target != file
                {
                    own.insert(target.clone());
                }
            }
        }
        uses
    }

    fn children(&self, module: &Module) -> Vec<String> {
        let child = |m: &Module| m.len() == module.len() + 1 && m.starts_with(module);
        self.files.keys().filter(|m| child(m)).map(|m| m[module.len()].clone()).collect()
    }

    /// A path as it is written in a module, from the crate on; empty where it leads out of the crate.
    fn absolute(&self, module: &Module, path: &[String]) -> Module {
        let mut at = match path.first().map(String::as_str) {
            Some("crate") => Vec::new(),
            Some("super" | "self") => module.clone(),
            Some(first) if self.children(module).iter().any(|c| c == first) => module.clone(),
            _ => return vec!["?".into()],
        };
        for step in path {
            match step.as_str() {
                "crate" | "self" => {}
                "super" => drop(at.pop()),
                step => at.push(step.to_string()),
            }
        }
        at
    }

    /// The file that defines what an absolute path names.
    fn file_of(&self, path: &[String]) -> Option<&PathBuf> {
        let mut at: Module = Vec::new();
        for (i, step) in path.iter().enumerate() {
            let next = [&at[..], std::slice::from_ref(step)].concat();
            if self.files.contains_key(&next) {
                at = next;
            } else if let Some(door) = self.doors.get(&(at.clone(), step.clone())) {
                let rest = [&door[..], &path[i + 1..]].concat();
                // A name that stands for itself leads nowhere.
                return if rest == path { None } else { self.file_of(&rest) };
            } else {
                break;
            }
        }
        if path.first().is_some_and(|first| first == "?") { None } else { self.files.get(&at).map(|(file, _)| file) }
    }
}

/// Files that use each other in a ring, if any: each ring once, from its first file on.
pub fn circles(uses: &BTreeMap<PathBuf, BTreeSet<PathBuf>>) -> Vec<Vec<PathBuf>> {
    let reach = |from: &PathBuf| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(file) = open.pop() {
            for next in uses.get(&file).into_iter().flatten() {
                if seen.insert(next.clone()) {
                    open.push(next.clone());
                }
            }
        }
        seen
    };
    let reached: BTreeMap<&PathBuf, BTreeSet<PathBuf>> = uses.keys().map(|file| (file, reach(file))).collect();
    let mut rings: Vec<Vec<PathBuf>> = Vec::new();
    for (file, all) in reached.iter().filter(|(file, all)| all.contains(**file)) {
        if rings.iter().all(|ring| !ring.contains(file)) {
            rings.push(all.iter().filter(|other| reached[other].contains(*file)).cloned().collect());
        }
    }
    rings
}

/// The text without comments and without what `#[cfg(test)]` marks.
fn without_tests(text: &str) -> String {
    let mut kept = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim() != "#[cfg(test)]" {
            if !line.trim_start().starts_with("//") {
                kept.push_str(line);
                kept.push('\n');
            }
            continue;
        }
        let indent = line.len() - line.trim_start().len();
        let first = lines.next().unwrap_or_default();
        if !first.trim_end().ends_with([';', '}']) {
            let end = format!("{}}}", " ".repeat(indent));
            lines.by_ref().find(|l| *l == end);
        }
    }
    kept
}

/// The statements that begin a line with `start`, each without it and up to its semicolon.
fn statements(text: &str, start: &str) -> Vec<String> {
    let begins = text.match_indices(start).filter(|(i, _)| text[..*i].rsplit('\n').next().unwrap().trim().is_empty());
    begins.map(|(i, _)| text[i + start.len()..].split(';').next().unwrap().to_string()).collect()
}

/// The paths of a tree such as `a::{b, c::d as e}`, each with the name that it brings in.
fn leaves(tree: &str) -> Vec<(Module, String)> {
    let tree = tree.trim();
    if let Some(open) = tree.find('{') {
        let prefix: Module =
            tree[..open].split("::").map(str::trim).filter(|s| !s.is_empty()).map(Into::into).collect();
        let inside = &tree[open + 1..tree.rfind('}').unwrap()];
        let (mut depth, mut parts) = (0, vec![String::new()]);
        for c in inside.chars() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 0 => parts.push(String::new()),
                _ => {}
            }
            if !(c == ',' && depth == 0) {
                parts.last_mut().unwrap().push(c);
            }
        }
        let of = |part: &String| leaves(part).into_iter().map(|(p, name)| ([&prefix[..], &p[..]].concat(), name));
        return parts.iter().filter(|p| !p.trim().is_empty()).flat_map(of).collect();
    }
    let (path, name) = tree.split_once(" as ").unwrap_or((tree, ""));
    let path: Module =
        path.split("::").map(|s| s.trim().to_string()).filter(|s| !["*", "self"].contains(&&**s)).collect();
    let name = if name.is_empty() { path.last().cloned().unwrap_or_default() } else { name.trim().to_string() };
    vec![(path, name)]
}

/// Paths that stand in the code: from `crate`, from `super`, or from a child module.
fn inline(text: &str, children: &[String]) -> Vec<Module> {
    let code: String = text.lines().filter(|l| !l.trim_start().starts_with("use ")).collect::<Vec<_>>().join("\n");
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut paths = Vec::new();
    for (i, _) in code.match_indices("::") {
        let start = code[..i].rfind(|c| !is_word(c)).map_or(0, |j| j + 1);
        let first = &code[start..i];
        let is_first = !code[..start].ends_with("::") && !code[..start].ends_with("use ");
        if is_first && (["crate", "super"].contains(&first) || children.iter().any(|c| c == first)) {
            let end = code[start..].find(|c| !is_word(c) && c != ':').map_or(code.len(), |j| start + j);
            paths.push(code[start..end].split("::").filter(|s| !s.is_empty()).map(Into::into).collect());
        }
    }
    paths
}
