//! The figures of a house of code: how long, how dense, how explained, how tied.

use super::counts::{
    code_lines, count_runs, count_words, doc_tests, long_lines, public_items, unwraps,
};
use super::functions::{Function, functions};
use super::habits::Habits;
use super::imports::Modules;
use super::names::{is_doc_line, riddles, types_named_twice};
use super::tokens::{Token, tokens};
use super::{Source, sources_of};
use std::path::Path;

/// Names of the figures and their values, for some files.
pub type Figures = Vec<(&'static str, String)>;

/// A crate whose files were read and taken apart once.
pub struct Measured {
    files: Vec<File>,
    modules: Modules,
}

struct File {
    source: Source,
    tokens: Vec<Token>,
    /// Tokens that are not of tests.
    production: Vec<Token>,
    functions: Vec<Function>,
    habits: Habits,
}

impl Measured {
    /// Reads the files in a folder of the workspace at `root`, where a crate has its own root.
    pub fn read(root: &Path, folder: &str) -> Self {
        let sources = sources_of(root, folder);
        let modules = Modules::new(folder, &sources);
        let files = sources.into_iter().map(File::new).collect();
        Self { files, modules }
    }
}

impl File {
    fn new(source: Source) -> Self {
        Self {
            tokens: tokens(&source.syntax),
            production: tokens(&source.production),
            functions: functions(&source.syntax),
            habits: Habits::of(&source.syntax),
            source,
        }
    }
}

/// The figures of some crates together.
pub fn figures(crates: &[Measured]) -> Figures {
    let files: Vec<&File> = crates.iter().flat_map(|one| &one.files).collect();
    let mut figures = sizes(&files);
    figures.extend(weights(&files));
    figures.extend(words(&files));
    figures.extend(habits(&files));
    figures.extend(ties(crates));
    figures
}

/// Files and functions in lines.
fn sizes(files: &[&File]) -> Figures {
    let lines: Vec<usize> = files
        .iter()
        .map(|file| file.source.text.lines().count())
        .collect();
    let functions: Vec<usize> = all_functions(files)
        .map(|function| function.lines)
        .collect();
    vec![
        ("files", lines.len().to_string()),
        ("lines", lines.iter().sum::<usize>().to_string()),
        ("file lines: median, p90, max", spread(lines)),
        ("functions", functions.len().to_string()),
        ("function lines", spread(functions)),
    ]
}

/// Functions in tokens.
fn weights(files: &[&File]) -> Figures {
    let tokens: Vec<usize> = all_functions(files)
        .map(|function| function.tokens)
        .collect();
    let tables = all_functions(files).filter(|function| function.is_heavy_table());
    let tables = tables.count();
    let heavy = all_functions(files).filter(|function| function.is_too_heavy());
    let heavy = percent(heavy.count(), tokens.len());
    let count = files.iter().map(|file| file.tokens.len()).sum();
    let lines = files
        .iter()
        .map(|file| code_lines(&file.tokens).len())
        .sum();
    vec![
        ("function tokens", spread(tokens)),
        ("functions over 400 tokens", heavy),
        ("tables over 400 tokens", tables.to_string()),
        (
            "tokens per line of code",
            format!("{:.1}", ratio(count, lines)),
        ),
    ]
}

/// Documentation and comments.
fn words(files: &[&File]) -> Figures {
    let [mut lines, mut docs, mut comments] = [0; 3];
    for file in files {
        let code = code_lines(&file.tokens);
        for (i, line) in file.source.text.lines().enumerate() {
            let is_comment = !code.contains(&(i + 1)) && line.trim_start().starts_with("//");
            lines += 1;
            docs += usize::from(is_comment && is_doc_line(line));
            comments += usize::from(is_comment && !is_doc_line(line));
        }
    }
    let marks = |file: &File| count_words(&file.source.text, &["TODO", "FIXME"]);
    vec![
        ("lines of documentation", percent(docs, lines)),
        ("lines of plain comment", percent(comments, lines)),
        ("doc-tests", total(files, |file| doc_tests(&file.source))),
        (
            "documentation that begins with \"What\"",
            total(files, |file| riddles(&file.source).len()),
        ),
        ("TODO, FIXME", total(files, marks)),
        (
            "lines over 100 columns",
            total(files, |file| long_lines(&file.source)),
        ),
    ]
}

/// What is written how often.
fn habits(files: &[&File]) -> Figures {
    let tests = |file: &File| count_runs(&file.tokens, &["#", "[", "test", "]"]);
    let twice = types_named_twice(files.iter().map(|file| &file.source));
    vec![
        (
            "named closures over 2 lines",
            total(files, |file| file.habits.closures.len()),
        ),
        (
            "tuple let and assignments over 2",
            total(files, |file| file.habits.tuples),
        ),
        ("pub items", total(files, |file| public_items(&file.tokens))),
        ("tests", total(files, tests)),
        (
            "allow and expect attributes",
            total(files, |file| file.habits.exceptions),
        ),
        (
            "unwrap and expect outside tests",
            total(files, |file| unwraps(&file.production)),
        ),
        ("types named twice", twice.len().to_string()),
    ]
}

/// Circles of imports.
fn ties(crates: &[Measured]) -> Figures {
    let count = |circles: fn(&Modules) -> usize| {
        let all = crates.iter().map(|one| circles(&one.modules));
        all.sum::<usize>().to_string()
    };
    vec![
        (
            "circles among top folders",
            count(|modules| modules.top_circles().len()),
        ),
        (
            "circles among files",
            count(|modules| modules.circles().len()),
        ),
    ]
}

fn all_functions<'a>(files: &'a [&File]) -> impl Iterator<Item = &'a Function> {
    files.iter().flat_map(|file| &file.functions)
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

fn total(files: &[&File], count: impl Fn(&File) -> usize) -> String {
    files
        .iter()
        .map(|file| count(file))
        .sum::<usize>()
        .to_string()
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

    fn one(text: &str) -> File {
        File::new(Source::new("plugin/src/a.rs", text))
    }

    #[test]
    fn lines_of_strings_are_no_comments() {
        let figures = words(&[&one(
            "// why\n/// Doc.\nconst A: &str = \"\n// text\n/// text\n\";\n\n\n\n\n",
        )]);
        assert_eq!(figures[0].1, "10.0 %");
        assert_eq!(figures[1].1, "10.0 %");
    }

    #[test]
    fn percentiles_are_those_of_the_sorted_values() {
        assert_eq!(spread((1..=100).rev().collect()), "51, 91, 100");
        assert_eq!(spread(Vec::new()), "-");
    }
}
