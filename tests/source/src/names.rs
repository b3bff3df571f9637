//! Names that are used twice, and documentation that begins like a riddle.

use super::Source;
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeMap;
use syn::visit::{self, Visit};
use syn::{Ident, ItemEnum, ItemStruct, ItemTrait, ItemType, ItemUnion, Macro};

/// Names of types that stand more than once outside tests, with the places of their definitions.
pub fn types_named_twice<'a>(
    sources: impl IntoIterator<Item = &'a Source>,
) -> BTreeMap<String, Vec<String>> {
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for source in sources {
        let mut finder = Types(Vec::new());
        finder.visit_file(&source.production);
        for (name, line) in finder.0 {
            let place = format!("{}:{line}", source.path);
            places.entry(name).or_default().push(place);
        }
    }
    places.retain(|_, places| places.len() > 1);
    places
}

/// Names and lines of structs, enums, unions, traits and aliases, and of structs and enums that
/// macros are given or make.
struct Types(Vec<(String, usize)>);

impl Types {
    fn add(&mut self, name: &Ident) {
        self.0.push((name.to_string(), name.span().start().line));
    }

    /// Names that stand behind `struct` or `enum`; `$name` is none.
    fn add_tokens(&mut self, tokens: TokenStream) {
        let mut is_announced = false;
        for token in tokens {
            match token {
                TokenTree::Group(group) => self.add_tokens(group.stream()),
                TokenTree::Ident(name) if is_announced => self.add(&name),
                TokenTree::Ident(word) if word == "struct" || word == "enum" => {
                    is_announced = true;
                    continue;
                }
                _ => {}
            }
            is_announced = false;
        }
    }
}

impl<'ast> Visit<'ast> for Types {
    fn visit_item_struct(&mut self, item: &'ast ItemStruct) {
        self.add(&item.ident);
        visit::visit_item_struct(self, item);
    }

    fn visit_item_enum(&mut self, item: &'ast ItemEnum) {
        self.add(&item.ident);
        visit::visit_item_enum(self, item);
    }

    fn visit_item_union(&mut self, item: &'ast ItemUnion) {
        self.add(&item.ident);
        visit::visit_item_union(self, item);
    }

    fn visit_item_trait(&mut self, item: &'ast ItemTrait) {
        self.add(&item.ident);
        visit::visit_item_trait(self, item);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        self.add_tokens(call.tokens.clone());
    }

    fn visit_item_type(&mut self, item: &'ast ItemType) {
        self.add(&item.ident);
        visit::visit_item_type(self, item);
    }
}

/// Whether a line of source is documentation.
pub fn is_doc_line(line: &str) -> bool {
    let line = line.trim_start();
    line.starts_with("///") && !line.starts_with("////") || line.starts_with("//!")
}

/// Lines of documentation whose sentence or paragraph begins with "What ", as `path:line`.
pub fn riddles(source: &Source) -> Vec<String> {
    let lines = source.text.lines().enumerate();
    lines
        .filter(|(_, line)| is_doc_line(line) && line.trim_start()[3..].starts_with(" What "))
        .map(|(i, line)| format!("{}:{}: {}", source.path, i + 1, line.trim()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_type_is_named_once_outside_tests() {
        let sources = [
            Source::new(
                "a.rs",
                "struct Row;\n#[cfg(test)] struct Probe;\nenum Kind {}",
            ),
            Source::new("b.rs", "struct Probe;\n\nfn f() { type Row = u8; }"),
        ];
        let twice = types_named_twice(&sources);
        assert_eq!(twice.len(), 1);
        assert_eq!(twice["Row"], ["a.rs:1", "b.rs:3"]);
    }

    #[test]
    fn types_in_macros_count() {
        let text = "named! { #[derive(Debug)] pub enum Kind { A = \"a\", } }
                    macro_rules! rows { ($name:ident) => { struct Row; struct $name; } }
                    fn f() { vec![0]; }
                    pub struct Row;
                    enum Kind {}";
        let twice = types_named_twice(&[Source::new("a.rs", text)]);
        let found: Vec<_> = twice
            .iter()
            .map(|(name, at)| (&name[..], at.join(" ")))
            .collect();
        let expected = [("Kind", "a.rs:1 a.rs:5"), ("Row", "a.rs:2 a.rs:4")];
        assert_eq!(found, expected.map(|(name, at)| (name, at.to_string())));
    }

    #[test]
    fn riddles_are_found_in_documentation_alone() {
        let text =
            "//! What this is.\n/// The width.\n/// What covers it.\n// What now?\nfn f() {}";
        let source = Source::new("a.rs", text);
        let lines = ["a.rs:1: //! What this is.", "a.rs:3: /// What covers it."];
        assert_eq!(riddles(&source), lines);
    }
}
