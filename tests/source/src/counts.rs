//! What is counted in a file.

use super::Source;
use super::names::is_doc_line;
use super::tokens::Token;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A line of more columns is too long.
const COLUMNS: usize = 100;

/// Lines on which there is a token.
pub fn code_lines(tokens: &[Token]) -> BTreeSet<usize> {
    tokens
        .iter()
        .flat_map(|token| token.line..=token.last_line)
        .collect()
}

/// Fences of documentation that `cargo test` compiles, those of an included README among them.
pub fn doc_tests(source: &Source) -> usize {
    let docs = source.text.lines().filter(|line| is_doc_line(line));
    let own: Vec<&str> = docs.map(|line| line.trim_start()[3..].trim()).collect();
    let folder = Path::new(&source.path).parent().unwrap_or(Path::new(""));
    let included = source.text.lines().filter_map(|line| {
        let name = line
            .strip_prefix("#[doc = include_str!(\"")?
            .strip_suffix("\")]")?;
        fs::read_to_string(source.root.join(folder).join(name)).ok()
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

/// Items that are `pub`, re-exports aside.
pub fn public_items(tokens: &[Token]) -> usize {
    const ITEMS: [&str; 12] = [
        "fn", "struct", "enum", "union", "trait", "type", "const", "static", "mod", "macro",
        "unsafe", "async",
    ];
    tokens
        .windows(2)
        .filter(|pair| pair[0].text == "pub" && ITEMS.contains(&pair[1].text.as_str()))
        .count()
}

/// Calls of `unwrap` and `expect`.
pub fn unwraps(tokens: &[Token]) -> usize {
    count_runs(tokens, &[".", "unwrap", "("]) + count_runs(tokens, &[".", "expect", "("])
}

/// How often some tokens follow one another.
pub fn count_runs(tokens: &[Token], run: &[&str]) -> usize {
    let is_run = |window: &&[Token]| window.iter().map(|token| &token.text).eq(run);
    tokens.windows(run.len()).filter(is_run).count()
}

/// How often words stand in a text.
pub fn count_words(text: &str, words: &[&str]) -> usize {
    words.iter().map(|word| text.matches(word).count()).sum()
}

/// Lines of more than 100 columns.
pub fn long_lines(source: &Source) -> usize {
    source
        .text
        .lines()
        .filter(|line| line.chars().count() > COLUMNS)
        .count()
}

#[cfg(test)]
mod tests {
    use super::super::tokens::tokens;
    use super::*;

    #[test]
    fn doc_tests_are_fences_of_rust() {
        let text = "/// ```\n/// a\n/// ```\n/// ```text\n/// ```\n/// ```no_run\n/// ```\n\
                    /// ```ignore\n/// ```\nfn f() {}";
        assert_eq!(doc_tests(&Source::new("plugin/src/a.rs", text)), 2);
    }

    #[test]
    fn unwraps_of_tests_do_not_count() {
        let text = "fn f() { a.unwrap(); b.unwrap_or(1); assert!(c.expect(\"\")); }
                    #[cfg(test)] mod tests { #[test] fn g() { a.unwrap() } }";
        assert_eq!(unwraps(&tokens(&Source::new("a.rs", text).production)), 2);
        assert_eq!(
            public_items(&tokens(
                &Source::new("a.rs", "pub fn f() {} pub(crate) fn g() {} pub use a::b;").syntax
            )),
            1
        );
    }
}
