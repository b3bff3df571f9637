//! Habits of writing that are counted.

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Expr, ExprAssign, Local, Pat};

/// A named closure of more lines should be a function.
const CLOSURE_LINES: usize = 2;
/// A tuple of more parts is no pair of things that belong together.
const TUPLE_PARTS: usize = 2;

/// How often a file does what we avoid.
#[derive(Debug, Default)]
pub struct Habits {
    /// Lines of named closures of more than two lines, which should be functions.
    pub closures: Vec<usize>,
    /// Tuples of more than two values that are taken apart at once.
    pub tuples: usize,
    /// Lints that are switched off.
    pub exceptions: usize,
}

impl Habits {
    /// Those of a file.
    pub fn of(file: &syn::File) -> Self {
        let mut habits = Self::default();
        habits.visit_file(file);
        habits
    }
}

impl<'ast> Visit<'ast> for Habits {
    fn visit_local(&mut self, local: &'ast Local) {
        if let Some(init) = &local.init {
            let (first, last) = (local.span().start().line, local.span().end().line);
            let is_named =
                matches!(local.pat, Pat::Ident(_)) && matches!(*init.expr, Expr::Closure(_));
            if is_named && last - first + 1 > CLOSURE_LINES {
                self.closures.push(first);
            }
            let is_tuple = matches!(local.pat, Pat::Tuple(_)) && is_large_tuple(&init.expr);
            self.tuples += usize::from(is_tuple);
        }
        visit::visit_local(self, local);
    }

    fn visit_expr_assign(&mut self, assign: &'ast ExprAssign) {
        let is_tuple = matches!(*assign.left, Expr::Tuple(_)) && is_large_tuple(&assign.right);
        self.tuples += usize::from(is_tuple);
        visit::visit_expr_assign(self, assign);
    }

    fn visit_attribute(&mut self, attribute: &'ast syn::Attribute) {
        let path = attribute.path();
        self.exceptions += usize::from(path.is_ident("allow") || path.is_ident("expect"));
    }
}

fn is_large_tuple(value: &Expr) -> bool {
    matches!(value, Expr::Tuple(tuple) if tuple.elems.len() > TUPLE_PARTS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_closures_and_large_tuples_are_counted() {
        let habits = Habits::of(
            &syn::parse_file(
                "#[allow(dead_code)]
             fn f() {
                let short = |x: u8| x;
                let long = |x: u8| {
                    x + 1
                };
                let pair = list.map(|x| {
                    x
                });
                let (a, b) = (1, 2);
                let (a, b, c) = (1, 2, 3);
                (a, b, c) = (3, 2, 1);
                let (a, b, c) = three();
            }",
            )
            .unwrap(),
        );
        assert_eq!(habits.closures, [4]);
        assert_eq!((habits.tuples, habits.exceptions), (2, 1));
    }
}
