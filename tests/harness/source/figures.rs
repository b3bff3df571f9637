//! The figures of a house of code: how long, how dense, how explained, how tied.

use super::functions::{Function, functions};
use super::imports::Modules;
use super::names::{is_doc_line, riddles, types_named_twice};
use super::tokens::{Token, tokens};
use super::{Source, sources, workspace};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Expr, ExprAssign, Local, Pat};

/// A function of more tokens is too heavy, unless it is a table.
pub const HEAVY_TOKENS: usize = 400;
/// A line of more columns is too long.
pub const COLUMNS: usize = 100;
/// A named closure of more lines should be a function.
const CLOSURE_LINES: usize = 2;
/// A tuple of more parts is no pair of things that belong together.
const TUPLE_PARTS: usize = 2;

/// Names of the figures and their values, for some files.
pub type Figures = Vec<(&'static str, String)>;

/// The figures of the files in folders of the workspace, each the root of a crate.
pub fn figures(folders: &[&str]) -> Figures {
    let crates: Vec<Vec<Source>> = folders.iter().map(|folder| sources(folder)).collect();
    let modules: Vec<Modules> = folders
        .iter()
        .zip(&crates)
        .map(|(folder, sources)| Modules::new(folder, sources))
        .collect();
    let all: Vec<Source> = crates.into_iter().flatten().collect();
    let mut figures = sizes(&all);
    figures.extend(weights(&all));
    figures.extend(words(&all));
    figures.extend(habits(&all));
    figures.extend(ties(&modules));
    figures
}

/// Files and functions in lines.
fn sizes(sources: &[Source]) -> Figures {
    let files: Vec<usize> = sources
        .iter()
        .map(|source| source.text.lines().count())
        .collect();
    let all = all_functions(sources);
    vec![
        ("files", files.len().to_string()),
        ("lines", files.iter().sum::<usize>().to_string()),
        ("file lines: median, p90, max", spread(files)),
        ("functions", all.len().to_string()),
        (
            "function lines",
            spread(all.iter().map(|function| function.lines).collect()),
        ),
    ]
}

/// Functions in tokens.
fn weights(sources: &[Source]) -> Figures {
    let all = all_functions(sources);
    let is_heavy = |function: &&Function| function.tokens > HEAVY_TOKENS;
    let heavy = all
        .iter()
        .filter(is_heavy)
        .filter(|function| !function.is_table)
        .count();
    let tables = all.iter().filter(is_heavy).count() - heavy;
    let (mut count, mut lines) = (0, 0);
    for source in sources {
        let tokens = tokens(&source.syntax);
        count += tokens.len();
        lines += code_lines(&tokens).len();
    }
    vec![
        (
            "function tokens",
            spread(all.iter().map(|function| function.tokens).collect()),
        ),
        ("functions over 400 tokens", percent(heavy, all.len())),
        ("tables over 400 tokens", tables.to_string()),
        (
            "tokens per line of code",
            format!("{:.1}", ratio(count, lines)),
        ),
    ]
}

/// Documentation and comments.
fn words(sources: &[Source]) -> Figures {
    let [mut lines, mut docs, mut comments] = [0; 3];
    for source in sources {
        let code = code_lines(&tokens(&source.syntax));
        for (i, line) in source.text.lines().enumerate() {
            let is_comment = !code.contains(&(i + 1)) && line.trim_start().starts_with("//");
            lines += 1;
            docs += usize::from(is_comment && is_doc_line(line));
            comments += usize::from(is_comment && !is_doc_line(line));
        }
    }
    vec![
        ("lines of documentation", percent(docs, lines)),
        ("lines of plain comment", percent(comments, lines)),
        ("doc-tests", total(sources, doc_tests)),
        (
            "documentation that begins with \"What\"",
            total(sources, |s| riddles(s).len()),
        ),
        (
            "TODO, FIXME",
            total(sources, |s| count_words(&s.text, &["TODO", "FIXME"])),
        ),
        ("lines over 100 columns", total(sources, long_lines)),
    ]
}

/// What is written how often.
fn habits(sources: &[Source]) -> Figures {
    vec![
        (
            "named closures over 2 lines",
            total(sources, |s| habits_of(s).closures),
        ),
        (
            "tuple let and assignments over 2",
            total(sources, |s| habits_of(s).tuples),
        ),
        ("pub items", total(sources, public_items)),
        (
            "tests",
            total(sources, |s| {
                count_runs(&tokens(&s.syntax), &["#", "[", "test", "]"])
            }),
        ),
        (
            "allow and expect attributes",
            total(sources, |s| habits_of(s).exceptions),
        ),
        ("unwrap and expect outside tests", total(sources, unwraps)),
        (
            "types named twice",
            types_named_twice(sources).len().to_string(),
        ),
    ]
}

/// Circles of imports.
fn ties(crates: &[Modules]) -> Figures {
    let count = |circles: fn(&Modules) -> usize| crates.iter().map(circles).sum::<usize>();
    vec![
        (
            "circles among top folders",
            count(|modules| modules.top_circles().len()).to_string(),
        ),
        (
            "circles among files",
            count(|modules| modules.circles().len()).to_string(),
        ),
    ]
}

fn all_functions(sources: &[Source]) -> Vec<Function> {
    sources
        .iter()
        .flat_map(|source| functions(&source.syntax))
        .collect()
}

/// Lines on which there is a token.
fn code_lines(tokens: &[Token]) -> BTreeSet<usize> {
    tokens
        .iter()
        .flat_map(|token| token.line..=token.last_line)
        .collect()
}

/// Fences of documentation that `cargo test` compiles, those of an included README among them.
fn doc_tests(source: &Source) -> usize {
    let docs = source.text.lines().filter(|line| is_doc_line(line));
    let own: Vec<&str> = docs.map(|line| line.trim_start()[3..].trim()).collect();
    let folder = Path::new(&source.path).parent().unwrap_or(Path::new(""));
    let included = source.text.lines().filter_map(|line| {
        let name = line
            .strip_prefix("#[doc = include_str!(\"")?
            .strip_suffix("\")]")?;
        fs::read_to_string(workspace().join(folder).join(name)).ok()
    });
    rust_fences(&own.join("\n")) + included.map(|text| rust_fences(&text)).sum::<usize>()
}

fn rust_fences(markdown: &str) -> usize {
    let mut inside = false;
    let mut count = 0;
    for language in markdown
        .lines()
        .filter_map(|line| line.trim().strip_prefix("```"))
    {
        let words: Vec<&str> = language.split(',').map(str::trim).collect();
        let is_rust = ["", "rust", "no_run", "should_panic", "compile_fail"].contains(&words[0]);
        count += usize::from(!inside && is_rust && !words.contains(&"ignore"));
        inside = !inside;
    }
    count
}

fn public_items(source: &Source) -> usize {
    const ITEMS: [&str; 12] = [
        "fn", "struct", "enum", "union", "trait", "type", "const", "static", "mod", "macro",
        "unsafe", "async",
    ];
    let tokens = tokens(&source.syntax);
    let pairs = tokens.windows(2);
    pairs
        .filter(|pair| pair[0].text == "pub" && ITEMS.contains(&pair[1].text.as_str()))
        .count()
}

fn unwraps(source: &Source) -> usize {
    let tokens = tokens(&source.production);
    count_runs(&tokens, &[".", "unwrap", "("]) + count_runs(&tokens, &[".", "expect", "("])
}

fn count_runs(tokens: &[Token], run: &[&str]) -> usize {
    let is_run = |window: &&[Token]| window.iter().map(|token| &token.text).eq(run);
    tokens.windows(run.len()).filter(is_run).count()
}

fn count_words(text: &str, words: &[&str]) -> usize {
    words.iter().map(|word| text.matches(word).count()).sum()
}

fn long_lines(source: &Source) -> usize {
    source
        .text
        .lines()
        .filter(|line| line.chars().count() > COLUMNS)
        .count()
}

#[derive(Default)]
struct Habits {
    closures: usize,
    tuples: usize,
    exceptions: usize,
}

fn habits_of(source: &Source) -> Habits {
    let mut habits = Habits::default();
    habits.visit_file(&source.syntax);
    habits
}

impl<'ast> Visit<'ast> for Habits {
    fn visit_local(&mut self, local: &'ast Local) {
        if let Some(init) = &local.init {
            let (first, last) = (local.span().start().line, local.span().end().line);
            let is_named =
                matches!(local.pat, Pat::Ident(_)) && matches!(*init.expr, Expr::Closure(_));
            self.closures += usize::from(is_named && last - first + 1 > CLOSURE_LINES);
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

/// Median, 90th percentile and maximum.
fn spread(mut values: Vec<usize>) -> String {
    values.sort_unstable();
    let Some(&most) = values.last() else {
        return "-".into();
    };
    let at = |tenths: usize| values[values.len() * tenths / 10];
    format!("{}, {}, {most}", at(5), at(9))
}

fn total(sources: &[Source], count: impl Fn(&Source) -> usize) -> String {
    sources.iter().map(count).sum::<usize>().to_string()
}

fn percent(part: usize, whole: usize) -> String {
    format!("{:.1} %", 100.0 * ratio(part, whole))
}

fn ratio(part: usize, whole: usize) -> f64 {
    part as f64 / whole.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(text: &str) -> Source {
        Source::new("plugin/src/a.rs", text)
    }

    #[test]
    fn named_closures_and_large_tuples_are_counted() {
        let habits = habits_of(&one("#[allow(dead_code)]
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
            }"));
        assert_eq!(
            (habits.closures, habits.tuples, habits.exceptions),
            (1, 2, 1)
        );
    }

    #[test]
    fn lines_of_strings_are_no_comments() {
        let figures = words(&[one(
            "// why\n/// Doc.\nconst A: &str = \"\n// text\n/// text\n\";\n\n\n\n\n",
        )]);
        assert_eq!(figures[0].1, "10.0 %");
        assert_eq!(figures[1].1, "10.0 %");
    }

    #[test]
    fn doc_tests_are_fences_of_rust() {
        let text = "/// ```\n/// a\n/// ```\n/// ```text\n/// ```\n/// ```no_run\n/// ```\n\
                    /// ```ignore\n/// ```\nfn f() {}";
        assert_eq!(doc_tests(&one(text)), 2);
    }

    #[test]
    fn unwraps_of_tests_do_not_count() {
        let text = "fn f() { a.unwrap(); b.unwrap_or(1); assert!(c.expect(\"\")); }
                    #[cfg(test)] mod tests { #[test] fn g() { a.unwrap() } }";
        assert_eq!(unwraps(&one(text)), 2);
        assert_eq!(
            public_items(&one("pub fn f() {} pub(crate) fn g() {} pub use a::b;")),
            1
        );
    }

    #[test]
    fn percentiles_are_those_of_the_sorted_values() {
        assert_eq!(spread((1..=100).rev().collect()), "51, 91, 100");
        assert_eq!(spread(Vec::new()), "-");
    }
}
