//! Length and weight of functions.

use super::tokens::tokens;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Block, Expr, ImplItemFn, ItemFn, Signature, Stmt, TraitItemFn};

/// A function of more tokens is too heavy, unless it is a table.
const HEAVY_TOKENS: usize = 400;

/// A function that has a body.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// Its first line, from 1.
    pub line: usize,
    /// Lines from the signature to the closing brace.
    pub lines: usize,
    /// Tokens of signature and body.
    pub tokens: usize,
    /// Its body is one expression without a branch, a loop or a closure: rows of data.
    pub is_table: bool,
}

impl Function {
    /// Whether it holds more than one can keep in mind.
    pub fn is_too_heavy(&self) -> bool {
        self.tokens > HEAVY_TOKENS && !self.is_table
    }

    /// Whether it is a table of as much.
    pub fn is_heavy_table(&self) -> bool {
        self.tokens > HEAVY_TOKENS && self.is_table
    }
}

/// All functions of a file, also those inside of others.
pub fn functions(file: &syn::File) -> Vec<Function> {
    let mut finder = Finder(Vec::new());
    finder.visit_file(file);
    finder.0
}

struct Finder(Vec<Function>);

impl Finder {
    fn add(&mut self, signature: &Signature, body: &Block) {
        let first = signature.span().start().line;
        self.0.push(Function {
            name: signature.ident.to_string(),
            line: first,
            lines: body.span().end().line - first + 1,
            tokens: tokens(signature).len() + tokens(body).len(),
            is_table: is_table(body),
        });
    }
}

impl<'ast> Visit<'ast> for Finder {
    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.add(&item.sig, &item.block);
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        self.add(&item.sig, &item.block);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        if let Some(body) = &item.default {
            self.add(&item.sig, body);
        }
        visit::visit_trait_item_fn(self, item);
    }
}

fn is_table(body: &Block) -> bool {
    struct Logic(bool);
    impl<'ast> Visit<'ast> for Logic {
        fn visit_expr(&mut self, expression: &'ast Expr) {
            self.0 |= matches!(
                expression,
                Expr::If(_) | Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) | Expr::Closure(_)
            );
            visit::visit_expr(self, expression);
        }
    }
    let [Stmt::Expr(expression, None)] = body.stmts.as_slice() else {
        return false;
    };
    let mut logic = Logic(false);
    logic.visit_expr(expression);
    !logic.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Vec<Function> {
        functions(&syn::parse_file(text).unwrap())
    }

    #[test]
    fn lines_and_tokens_are_counted_from_the_signature_on() {
        let found = of("/// Doc.\n#[inline]\npub fn f(x: u8) -> u8 {\n    // why\n    x + 1\n}\n");
        let [f] = &found[..] else { panic!("{found:?}") };
        assert_eq!((f.name.as_str(), f.line, f.lines), ("f", 3, 4));
        // fn f ( x : u8 ) -> u8 { x + 1 }
        assert_eq!(f.tokens, 14);
    }

    #[test]
    fn methods_defaults_and_inner_functions_count_and_declarations_do_not() {
        let found = of("trait T { fn a(); fn b() {} } impl T for u8 { fn a() { fn c() {} } }");
        let names: Vec<&str> = found
            .iter()
            .map(|function| function.name.as_str())
            .collect();
        assert_eq!(names, ["b", "a", "c"]);
    }

    #[test]
    fn a_table_is_one_expression_without_logic() {
        let tables = [
            "[1, 2, 3]",
            "match x { 0 => \"a\", _ => \"b\" }",
            "vec![1, 2]",
        ];
        for body in tables {
            assert!(of(&format!("fn f() {{ {body} }}"))[0].is_table, "{body}");
        }
        for body in [
            "let a = 1; [a]",
            "if x { 1 } else { 2 }",
            "list.map(|x| x)",
            "1;",
        ] {
            assert!(!of(&format!("fn f() {{ {body} }}"))[0].is_table, "{body}");
        }
    }
}
