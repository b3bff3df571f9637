//! Which file imports which.
//!
//! A path `crate::a::B`, `super::B` or `self::b::C` is followed to the file that defines its end,
//! through re-exports and private imports of modules on the way. Imports of tests do not count.

use super::Source;
use super::circles::circles;
use super::paths::{UsedPath, used_paths};
use super::tokens::tokens;
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
    /// Paths into the crate as they are written, and from the root.
    paths: Vec<(UsedPath, ModulePath)>,
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
            for (used, path) in &module.paths {
                let Some(target) = self.find(path, LONGEST_CHAIN) else {
                    continue;
                };
                if target.file != module.file && !self.is_root(target) {
                    found.insert(Import {
                        from: module.file.clone(),
                        line: used.line,
                        text: used.names.join("::"),
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
        let place = |file: &str| self.place(&parent, file);
        let mut imports = self.imports();
        imports.retain(|import| match (place(&import.from), place(&import.to)) {
            (Some(from), Some(to)) => to > from,
            _ => false,
        });
        imports
    }

    /// The place of the child that a file belongs to in the declarations of `parent`.
    fn place(&self, parent: &[String], file: &str) -> Option<usize> {
        let path = module_path(&self.root, file);
        let child = path.strip_prefix(parent)?.first()?;
        let mut order = self.modules.get(parent)?.children.iter();
        order.position(|name| name == child)
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

    /// Modules that the root declares, in order.
    pub fn top_modules(&self) -> &[String] {
        let root = self.modules.get(&ModulePath::new());
        root.map_or(&[], |root| root.children.as_slice())
    }

    fn is_root(&self, module: &Module) -> bool {
        module_path(&self.root, &module.file).is_empty()
    }

    /// The module that defines the end of a path; imports are followed `chain` times at most.
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
        match module.imported.get(name) {
            Some(source) => self.find(source, chain - 1),
            None => self.find_in_globs(module, name, chain).or(Some(module)),
        }
    }

    /// The module that defines a name and all of whose names `module` imports.
    fn find_in_globs(&self, module: &Module, name: &String, chain: usize) -> Option<&Module> {
        module.globs.iter().find_map(|glob| {
            let path = [glob.as_slice(), core::slice::from_ref(name)].concat();
            let target = self.find(&path, chain - 1)?;
            target.defined.contains(name).then_some(target)
        })
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
        for used in used_paths(&tokens(&source.production)) {
            if let Some(absolute) = absolute(path, &used.names) {
                module.paths.push((used, absolute));
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
        assert_eq!(crate_.top_modules(), ["low", "high"]);
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
