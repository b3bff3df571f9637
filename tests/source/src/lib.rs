//! The source of the workspace, read as Rust: figures, imports and names. A crate of its own, so
//! that figures need no engine.
//!
//! ```text
//! tokens     a file as the lexer of Rust sees it, without comments
//! functions  length and weight of every function
//! counts     what is counted in a file
//! habits     what is written how often
//! figures    the table that `tests/house` prints
//! paths      paths within a crate, as they are written
//! imports    which file uses which, re-exports followed
//! circles    circles of imports
//! names      types that are named twice, riddles
//! documents  files that a document names
//! ```

pub mod circles;
pub mod counts;
pub mod documents;
pub mod figures;
pub mod functions;
pub mod habits;
pub mod imports;
pub mod names;
pub mod paths;
pub mod tokens;

use std::fs;
use std::path::{Path, PathBuf};
use syn::{Attribute, ImplItem, Item};

/// A file of Rust.
pub struct Source {
    /// The root of its workspace.
    pub root: PathBuf,
    /// Path from the root of the workspace, with `/` between folders.
    pub path: String,
    /// The text of the file.
    pub text: String,
    /// All that the file says.
    pub syntax: syn::File,
    /// The same without items that only tests compile; empty for a file of tests.
    pub production: syn::File,
}

impl Source {
    /// Reads a text as the file at `path`.
    ///
    /// # Panics
    /// If the text is not Rust.
    pub fn new(path: &str, text: &str) -> Self {
        let syntax = syn::parse_file(text).unwrap_or_else(|error| {
            let line = error.span().start().line;
            panic!("{path}:{line}: {error}")
        });
        let mut production = syntax.clone();
        if is_test_file(path) {
            production.items.clear();
        }
        keep_production(&mut production.items);
        Self {
            root: workspace(),
            path: path.into(),
            text: text.into(),
            syntax,
            production,
        }
    }

    /// Whether only tests compile the file.
    pub fn is_test(&self) -> bool {
        is_test_file(&self.path)
    }
}

/// The root of this workspace.
pub fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All Rust files in a folder of this workspace and below, in order of their paths.
pub fn sources(folder: &str) -> Vec<Source> {
    sources_of(&workspace(), folder)
}

/// The same of the workspace at `root`.
pub fn sources_of(root: &Path, folder: &str) -> Vec<Source> {
    files_of(root, folder)
        .iter()
        .filter(|path| path.ends_with(".rs"))
        .map(|path| {
            let text = fs::read_to_string(root.join(path)).expect("a file of UTF-8 text");
            let root = root.to_path_buf();
            Source {
                root,
                ..Source::new(path, &text)
            }
        })
        .collect()
}

/// Paths of all files in a folder of this workspace and below, in order.
pub fn files_below(folder: &str) -> Vec<String> {
    files_of(&workspace(), folder)
}

/// The same of the workspace at `root`.
fn files_of(root: &Path, folder: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_string()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root.join(&folder)).expect("a folder of the workspace") {
            let entry = entry.expect("a readable folder");
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                folders.push(path);
            } else {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// `tests.rs`, `x_tests.rs` and whatever lies in a folder `tests`.
fn is_test_file(path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or(path);
    name == "tests.rs" || name.ends_with("_tests.rs") || path.split('/').any(|part| part == "tests")
}

/// Removes the items that only tests compile, in modules and implementations, too.
fn keep_production(items: &mut Vec<Item>) {
    items.retain(|item| !is_test_only(attributes(item)));
    for item in items {
        match item {
            Item::Mod(module) => {
                if let Some((_, content)) = &mut module.content {
                    keep_production(content);
                }
            }
            Item::Impl(block) => block.items.retain(|item| match item {
                ImplItem::Fn(function) => !is_test_only(&function.attrs),
                _ => true,
            }),
            _ => {}
        }
    }
}

/// `#[test]`, or `#[cfg(..)]` with `test` or `doctest` in it.
fn is_test_only(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let path = attribute.path();
        path.is_ident("test") || path.is_ident("cfg") && asks_for_tests(attribute)
    })
}

fn asks_for_tests(condition: &Attribute) -> bool {
    let words = tokens::tokens(&condition.meta);
    let is_test = |word: &str| word == "test" || word == "doctest";
    words.iter().any(|token| is_test(&token.text))
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn production_leaves_tests_out() {
        let source = Source::new(
            "plugin/src/a.rs",
            "fn kept() {}
             #[cfg(test)] fn helper() {}
             impl A { #[cfg(test)] fn look(&self) {} fn stays(&self) {} }
             mod inner { #[test] fn law() {} fn stays_too() {} }
             #[cfg(all(test, unix))] mod tests { fn a() {} }",
        );
        let names: Vec<String> = functions::functions(&source.production)
            .into_iter()
            .map(|function| function.name)
            .collect();
        assert_eq!(names, ["kept", "stays", "stays_too"]);
        assert_eq!(functions::functions(&source.syntax).len(), 7);
    }

    #[test]
    fn files_of_tests_are_told_by_their_names() {
        for path in [
            "a/tests.rs",
            "a/mesh_tests.rs",
            "plugin/src/io/tests/png.rs",
        ] {
            assert!(Source::new(path, "fn a() {}").is_test(), "{path}");
        }
        assert!(!Source::new("a/contests.rs", "fn a() {}").is_test());
    }
}
