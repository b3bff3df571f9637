//! Which file imports which.
//!
//! A path `crate::a::B`, `super::B` or `self::b::C` is followed to the file that defines its end,
//! through re-exports and private imports of modules on the way. Imports of tests do not count.

use super::Source;
use super::tokens::{Token, tokens};
use std::collections::{BTreeMap, BTreeSet};
use syn::{Item, UseTree};

/// A file that uses another one of its crate.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Import {
    /// Path of the file that imports.
    pub from: String,
    /// Line of the import.
    pub line: usize,
    /// The path as it is written.
    pub text: String,
    /// Path of the file that defines what is imported.
    pub to: String,
}

impl std::fmt::Display for Import {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            from,
            line,
            text,
            to,
        } = self;
        write!(out, "{from}:{line}: {text} (in {to})")
    }
}

/// The modules of one crate.
pub struct Modules {
    root: String,
    modules: BTreeMap<ModulePath, Module>,
}

/// Names from the root of a crate, which is the empty path.
type ModulePath = Vec<String>;

#[derive(Default)]
struct Module {
    file: String,
    /// Modules declared in it, in order.
    children: Vec<String>,
    /// Where the names come from that it imports.
    imported: BTreeMap<String, ModulePath>,
    /// Modules of which it imports all names.
    globs: Vec<ModulePath>,
    /// Names of the items that it defines.
    defined: BTreeSet<String>,
    /// Paths into the crate: line, as written, from the root.
    paths: Vec<(usize, String, ModulePath)>,
}

/// Re-exports that are followed at most.
const LONGEST_CHAIN: usize = 8;

impl Modules {
    /// Reads the files of a crate, whose root is `folder/lib.rs` or `folder/main.rs`.
    pub fn new(folder: &str, sources: &[Source]) -> Self {
        let production = sources.iter().filter(|source| !source.is_test());
        let modules = production
            .map(|source| {
                let path = module_path(folder, &source.path);
                let module = Module::read(&path, source);
                (path, module)
            })
            .collect();
        Self {
            root: folder.into(),
            modules,
        }
    }

    /// All imports of one file by another, in order of files and lines. The root imports and
    /// declares everything, so what it uses is left out.
    pub fn imports(&self) -> Vec<Import> {
        let mut found = BTreeSet::new();
        for module in self.modules.values().filter(|module| !self.is_root(module)) {
            for (line, text, path) in &module.paths {
                let Some(target) = self.find(path, LONGEST_CHAIN) else {
                    continue;
                };
                if target.file != module.file && !self.is_root(target) {
                    found.insert(Import {
                        from: module.file.clone(),
                        line: *line,
                        text: text.clone(),
                        to: target.file.clone(),
                    });
                }
            }
        }
        found.into_iter().collect()
    }

    /// Imports by a child of the module `parent` from a child that is declared later in it.
    pub fn from_later(&self, parent: &[&str]) -> Vec<Import> {
        let parent: ModulePath = parent.iter().map(ToString::to_string).collect();
        let order = &self.modules[&parent].children;
        let place = |file: &str| {
            let path = module_path(&self.root, file);
            let child = path.strip_prefix(parent.as_slice())?.first()?;
            order.iter().position(|name| name == child)
        };
        let mut imports = self.imports();
        imports.retain(|import| match (place(&import.from), place(&import.to)) {
            (Some(from), Some(to)) => to > from,
            _ => false,
        });
        imports
    }

    /// Circles of files, each as the imports within it. A module and what lies in its folder are
    /// one house: imports between them close no circle.
    pub fn circles(&self) -> Vec<Vec<Import>> {
        let mut imports = self.imports();
        imports.retain(|import| {
            let from = module_path(&self.root, &import.from);
            let to = module_path(&self.root, &import.to);
            !from.starts_with(&to) && !to.starts_with(&from)
        });
        circles(&imports, |file| file.to_string())
    }

    /// Circles among the modules that the root declares.
    pub fn top_circles(&self) -> Vec<Vec<Import>> {
        circles(&self.imports(), |file| {
            module_path(&self.root, file)
                .first()
                .cloned()
                .unwrap_or_default()
        })
    }

    fn is_root(&self, module: &Module) -> bool {
        module_path(&self.root, &module.file).is_empty()
    }

    /// The module that defines the end of a path.
    fn find(&self, path: &[String], chain: usize) -> Option<&Module> {
        let depth = (0..=path.len())
            .rev()
            .find(|&depth| self.modules.contains_key(&path[..depth]))?;
        let module = &self.modules[&path[..depth]];
        let Some(name) = path.get(depth) else {
            return Some(module);
        };
        if chain == 0 || module.defined.contains(name) {
            return Some(module);
        }
        if let Some(source) = module.imported.get(name) {
            return self.find(source, chain - 1);
        }
        let mut sources = module
            .globs
            .iter()
            .map(|glob| [glob.as_slice(), &[name.clone()]].concat());
        let behind_glob = sources.find_map(|path| {
            let target = self.find(&path, chain - 1)?;
            target.defined.contains(name).then_some(target)
        });
        behind_glob.or(Some(module))
    }
}

impl Module {
    fn read(path: &[String], source: &Source) -> Self {
        let mut module = Self {
            file: source.path.clone(),
            ..Self::default()
        };
        for item in &source.production.items {
            if let Item::Mod(child) = item {
                module.children.push(child.ident.to_string());
            }
        }
        for item in &source.production.items {
            if let Item::Use(import) = item {
                module.import(path, &mut Vec::new(), &import.tree);
            }
            module.defined.extend(name(item));
        }
        for (line, text, names) in paths(&tokens(&source.production)) {
            if let Some(absolute) = absolute(path, &names) {
                module.paths.push((line, text, absolute));
            }
        }
        module
    }

    /// Notes the names that a tree of imports brings.
    fn import(&mut self, here: &[String], before: &mut Vec<String>, tree: &UseTree) {
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.import(here, before, &path.tree);
                before.pop();
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.import(here, before, tree);
                }
            }
            UseTree::Glob(_) => self.globs.extend(self.source(here, before)),
            UseTree::Name(leaf) => {
                let name = leaf.ident.to_string();
                self.import_as(here, before, &name, &name);
            }
            UseTree::Rename(leaf) => {
                let (name, alias) = (leaf.ident.to_string(), leaf.rename.to_string());
                self.import_as(here, before, &name, &alias);
            }
        }
    }

    fn import_as(&mut self, here: &[String], before: &[String], name: &str, alias: &str) {
        let mut path = before.to_vec();
        if name != "self" {
            path.push(name.into());
        }
        if let Some(source) = self.source(here, &path) {
            self.imported.insert(alias.into(), source);
        }
    }

    /// A path of an import from the root; `None` for another crate's.
    fn source(&self, here: &[String], path: &[String]) -> Option<ModulePath> {
        if path
            .first()
            .is_some_and(|first| self.children.contains(first))
        {
            return Some([here, path].concat());
        }
        absolute(here, path)
    }
}

/// The path of a module whose file is `file`, in a crate with its root in `folder`.
fn module_path(folder: &str, file: &str) -> ModulePath {
    let below = file.strip_prefix(folder).unwrap_or(file);
    let below = below.trim_start_matches('/').trim_end_matches(".rs");
    let mut names: ModulePath = below.split('/').map(str::to_string).collect();
    let last = names.last().map_or("", String::as_str);
    if last == "mod" || names.len() == 1 && (last == "lib" || last == "main") {
        names.pop();
    }
    names
}

/// A path that begins with `crate`, `self` or `super` in the module `here`, from the root.
fn absolute(here: &[String], path: &[String]) -> Option<ModulePath> {
    let (first, mut rest) = path.split_first()?;
    let mut base = here.to_vec();
    match first.as_str() {
        "crate" => base.clear(),
        "self" => {}
        "super" => {
            base.pop()?;
            while let Some((first, after)) = rest.split_first()
                && first == "super"
            {
                base.pop()?;
                rest = after;
            }
        }
        _ => return None,
    }
    base.extend(rest.iter().cloned());
    Some(base)
}

/// All paths that begin with `crate`, `self` or `super`: line, text, names. Those of a group have
/// each an entry.
fn paths(tokens: &[Token]) -> Vec<(usize, String, Vec<String>)> {
    let mut found = Vec::new();
    let mut i = 0;
    while i + 1 < tokens.len() {
        let begins = matches!(tokens[i].text.as_str(), "crate" | "self" | "super");
        if begins && tokens[i + 1].text == "::" {
            let mut names = Vec::new();
            i = tree(tokens, i, &mut names, &mut found);
        } else {
            i += 1;
        }
    }
    found
}

/// Reads one path or tree of paths from token `i` on, and returns the token after it.
fn tree(
    tokens: &[Token],
    mut i: usize,
    names: &mut Vec<String>,
    found: &mut Vec<(usize, String, Vec<String>)>,
) -> usize {
    let depth = names.len();
    let text = |i: usize| tokens.get(i).map_or("", |token| token.text.as_str());
    let line = tokens.get(i).map_or(0, |token| token.line);
    while is_name(text(i)) {
        names.push(text(i).into());
        i += 1;
        if text(i) != "::" || !(is_name(text(i + 1)) || text(i + 1) == "{") {
            break;
        }
        i += 1;
    }
    if text(i) == "{" && i > 0 && text(i - 1) == "::" {
        i += 1;
        while i < tokens.len() && text(i) != "}" {
            i = match text(i) {
                "," | "*" => i + 1,
                "as" => i + 2,
                _ => tree(tokens, i, names, found),
            };
        }
        i += 1;
    } else if names.len() > depth {
        // `a::{self}` is `a` itself.
        let itself = names.len() > 1 && names.last().is_some_and(|last| last == "self");
        let path = &names[..names.len() - usize::from(itself)];
        found.push((line, path.join("::"), path.to_vec()));
    } else {
        i += 1;
    }
    names.truncate(depth);
    i
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// The name of an item that can be imported.
fn name(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        _ => return None,
    };
    Some(ident.to_string())
}

/// The groups of files, named by `room`, that reach each other, as the imports among them: the first
/// of one file by another.
fn circles(imports: &[Import], room: impl Fn(&str) -> String) -> Vec<Vec<Import>> {
    let mut next: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for import in imports {
        let (from, to) = (room(&import.from), room(&import.to));
        if from != to {
            next.entry(from).or_default().insert(to);
        }
    }
    let reach: BTreeMap<&String, BTreeSet<&String>> = next
        .keys()
        .map(|start| (start, reachable(&next, start)))
        .collect();
    let meet = |a: &String, b: &String| {
        let goes = |a, b| reach.get(a).is_some_and(|far| far.contains(b));
        goes(a, b) && goes(b, a)
    };
    let mut pairs = BTreeSet::new();
    let mut out: Vec<Vec<Import>> = Vec::new();
    for import in imports {
        let (from, to) = (room(&import.from), room(&import.to));
        if from == to || !meet(&from, &to) {
            continue;
        }
        if !pairs.insert((&import.from, &import.to)) {
            continue;
        }
        let circle = out
            .iter_mut()
            .find(|circle| meet(&room(&circle[0].from), &from));
        match circle {
            Some(circle) => circle.push(import.clone()),
            None => out.push(vec![import.clone()]),
        }
    }
    out
}

/// All that can be reached from `start` in one step or more.
fn reachable<'a>(
    next: &'a BTreeMap<String, BTreeSet<String>>,
    start: &str,
) -> BTreeSet<&'a String> {
    let mut seen = BTreeSet::new();
    let mut open: Vec<&String> = next.get(start).into_iter().flatten().collect();
    while let Some(place) = open.pop() {
        if seen.insert(place) {
            open.extend(next.get(place).into_iter().flatten());
        }
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::*;

    fn modules(files: &[(&str, &str)]) -> Modules {
        let sources: Vec<Source> = files
            .iter()
            .map(|(path, text)| Source::new(&format!("src/{path}"), text))
            .collect();
        Modules::new("src", &sources)
    }

    fn arrows(imports: &[Import]) -> Vec<(&str, &str)> {
        imports
            .iter()
            .map(|import| (&import.from[4..], &import.to[4..]))
            .collect()
    }

    #[test]
    fn paths_are_read_with_their_groups_and_lines() {
        let file = syn::parse_file(
            "use crate::a::{B, c::{self, D as E}, f::*};\nfn g() { super::super::h::<u8>(); }",
        )
        .unwrap();
        let found: Vec<(usize, String)> = paths(&tokens(&file))
            .into_iter()
            .map(|(line, text, _)| (line, text))
            .collect();
        let expected = [
            (1, "crate::a::B"),
            (1, "crate::a::c"),
            (1, "crate::a::c::D"),
            (1, "crate::a::f"),
            (2, "super::super::h"),
        ];
        assert_eq!(found, expected.map(|(line, text)| (line, text.to_string())));
    }

    #[test]
    fn imports_are_followed_to_the_file_that_defines_them() {
        let crate_ = modules(&[
            (
                "lib.rs",
                "mod a; mod b; pub mod prelude { pub use crate::a::Deep; }",
            ),
            (
                "a/mod.rs",
                "mod deep; pub use deep::Deep; pub use deep::*; pub fn own() {}",
            ),
            ("a/deep.rs", "pub struct Deep; pub struct Other;"),
            (
                "b.rs",
                "use crate::a::{own, Deep};\nfn f() { crate::a::Other; }",
            ),
            ("b_tests.rs", "use crate::a::own;"),
        ]);
        let imports = crate_.imports();
        let expected = [
            ("b.rs", "a/deep.rs"),
            ("b.rs", "a/mod.rs"),
            ("b.rs", "a/deep.rs"),
        ];
        assert_eq!(arrows(&imports), expected);
        assert_eq!(
            imports[2].to_string(),
            "src/b.rs:2: crate::a::Other (in src/a/deep.rs)"
        );
    }

    #[test]
    fn later_modules_are_told_by_the_order_of_declarations() {
        let crate_ = modules(&[
            ("lib.rs", "mod low; mod high;"),
            ("low.rs", "use crate::high::up;"),
            ("high.rs", "pub fn up() {} fn f() { crate::low::down() }"),
        ]);
        assert_eq!(arrows(&crate_.from_later(&[])), [("low.rs", "high.rs")]);
    }

    #[test]
    fn siblings_close_circles_and_a_module_and_its_folder_do_not() {
        let crate_ = modules(&[
            ("lib.rs", "mod a; mod b; mod c;"),
            ("a.rs", "use crate::b::B; pub struct A;"),
            ("b.rs", "use crate::c::C; pub struct B;"),
            (
                "c.rs",
                "mod part; use crate::a::A; pub struct C; pub use part::Part;",
            ),
            ("c/part.rs", "use super::C; pub struct Part;"),
        ]);
        let circles = crate_.circles();
        assert_eq!(circles.len(), 1);
        let expected = [("a.rs", "b.rs"), ("b.rs", "c.rs"), ("c.rs", "a.rs")];
        assert_eq!(arrows(&circles[0]), expected);
        assert_eq!(crate_.top_circles().len(), 1);
    }
}
