//! Paths in code that begin with `crate`, `self` or `super`, those of imports and those in between.

use super::tokens::Token;

/// A path as it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UsedPath {
    /// Line of its last part, from 1.
    pub line: usize,
    /// Its names, `crate`, `self` or `super` first.
    pub names: Vec<String>,
}

/// All paths of some code in order. Those of a group `a::{b, c}` have an entry each.
pub fn used_paths(tokens: &[Token]) -> Vec<UsedPath> {
    let mut reader = Reader {
        tokens,
        at: 0,
        found: Vec::new(),
    };
    while reader.at < tokens.len() {
        if matches!(reader.text(0), "crate" | "self" | "super") && reader.text(1) == "::" {
            reader.tree(&mut Vec::new());
        } else {
            reader.at += 1;
        }
    }
    reader.found
}

struct Reader<'a> {
    tokens: &'a [Token],
    at: usize,
    found: Vec<UsedPath>,
}

impl Reader<'_> {
    /// The token after `ahead` others.
    fn text(&self, ahead: usize) -> &str {
        self.tokens
            .get(self.at + ahead)
            .map_or("", |token| &token.text)
    }

    /// Reads one path, or several that go on from `names`.
    fn tree(&mut self, names: &mut Vec<String>) {
        let depth = names.len();
        let line = self.tokens[self.at].line;
        while is_name(self.text(0)) {
            names.push(self.text(0).into());
            self.at += 1;
            if self.text(0) != "::" || !(is_name(self.text(1)) || self.text(1) == "{") {
                break;
            }
            self.at += 1;
        }
        // `a::<T>` is a path and no tree; a brace without `::` is a block.
        if self.text(0) == "{" && self.tokens[self.at - 1].text == "::" {
            self.group(names);
        } else if names.len() > depth {
            // `a::{self}` is `a` itself.
            let itself = names.len() > 1 && names.last().is_some_and(|last| last == "self");
            let names = names[..names.len() - usize::from(itself)].to_vec();
            self.found.push(UsedPath { line, names });
        } else {
            self.at += 1;
        }
        names.truncate(depth);
    }

    fn group(&mut self, names: &mut Vec<String>) {
        self.at += 1;
        while self.at < self.tokens.len() && self.text(0) != "}" {
            match self.text(0) {
                "," | "*" => self.at += 1,
                "as" => self.at += 2,
                _ => self.tree(names),
            }
        }
        self.at += 1;
    }
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

#[cfg(test)]
mod tests {
    use super::super::tokens::tokens;
    use super::*;

    #[test]
    fn paths_are_read_with_their_groups_and_lines() {
        let text = "use crate::a::{B, c::{self, D as E}, f::*};
                    fn g() { super::super::h::<u8>(); if self::i {} }";
        let found: Vec<(usize, String)> = used_paths(&tokens(&syn::parse_file(text).unwrap()))
            .into_iter()
            .map(|path| (path.line, path.names.join("::")))
            .collect();
        let expected = [
            (1, "crate::a::B"),
            (1, "crate::a::c"),
            (1, "crate::a::c::D"),
            (1, "crate::a::f"),
            (2, "super::super::h"),
            (2, "self::i"),
        ];
        assert_eq!(found, expected.map(|(line, text)| (line, text.to_string())));
    }
}
