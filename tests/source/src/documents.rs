//! Files that a Markdown document names.

use super::workspace;
use std::collections::BTreeSet;

/// Where paths without a heading of their own begin.
const HOME: &str = "plugin/src";

/// The paths that a document names, from the root of the workspace.
#[derive(Debug, Default)]
pub struct Named {
    /// Files and folders that exist; a folder ends with `/`.
    pub found: BTreeSet<String>,
    /// Those that do not, with the line that names them.
    pub missing: Vec<String>,
}

impl Named {
    /// Reads code spans such as `` `io/digest.rs` `` or `` `io/` `` and the targets of links. A path
    /// counts from the folder of a path before it in the line, from the folder that the last
    /// heading names, from that of the plugin or from the root.
    pub fn read(markdown: &str) -> Self {
        let mut named = Self::default();
        let mut home = HOME.to_string();
        for (i, line) in lines_outside_fences(markdown) {
            if let Some(heading) = line.strip_prefix('#') {
                let folder = heading.trim_start_matches('#').trim();
                let is_folder = workspace().join(folder).is_dir();
                home = if is_folder { folder } else { HOME }.to_string();
            }
            named.read_line(line, i + 1, &home);
        }
        named
    }

    fn read_line(&mut self, line: &str, number: usize, home: &str) {
        let mut homes = vec![String::new(), HOME.into(), home.into()];
        for span in links(line).chain(code_spans(line).filter(is_path)) {
            let found = homes.iter().rev().find_map(|home| existing(home, span));
            let Some(path) = found else {
                self.missing.push(format!("line {number}: {span}"));
                continue;
            };
            homes.extend(path.rsplit_once('/').map(|(folder, _)| folder.to_string()));
            self.found.insert(path);
        }
    }

    /// Whether the document names a file, its folder, or the module that it belongs to.
    pub fn covers(&self, path: &str) -> bool {
        let folders = path.match_indices('/').map(|(i, _)| &path[..i]);
        let mut within = folders.filter(|folder| folder.contains("/src/"));
        self.found.contains(path) || within.any(|folder| self.names_module(folder))
    }

    fn names_module(&self, folder: &str) -> bool {
        let names = [format!("{folder}/"), format!("{folder}.rs")];
        names.iter().any(|name| self.found.contains(name))
    }
}

/// Targets of a document's links that count from its own folder.
pub fn relative_links(markdown: &str) -> impl Iterator<Item = &str> {
    lines_outside_fences(markdown).flat_map(|(_, line)| links(line))
}

/// A path below `home` if there is such a file or folder.
fn existing(home: &str, span: &str) -> Option<String> {
    let path = format!("{home}/{span}");
    let path = path.trim_start_matches('/');
    workspace().join(path).exists().then(|| path.to_string())
}

/// A name of a Rust file or of a folder.
fn is_path(span: &&str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || "_./".contains(c);
    span.chars().all(plain) && (span.ends_with(".rs") || span.ends_with('/')) && span.len() > 1
}

/// Texts between backticks.
fn code_spans(line: &str) -> impl Iterator<Item = &str> {
    line.split('`').skip(1).step_by(2)
}

/// Targets of links to files of the workspace.
fn links(line: &str) -> impl Iterator<Item = &str> {
    let targets = line
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split_once(')'));
    targets
        .map(|(target, _)| target.split('#').next().unwrap_or(target))
        .filter(|target| !target.is_empty() && !target.contains(':'))
}

fn lines_outside_fences(markdown: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut inside = false;
    markdown.lines().enumerate().filter(move |(_, line)| {
        let is_fence = line.trim_start().starts_with("```");
        inside ^= is_fence;
        !inside && !is_fence
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_count_from_the_heading_and_from_the_path_before() {
        let text = "# Map\n| `io/digest.rs`, `mod.rs` | `Vec<T>`, a/b |\n## demo/src\n| `main.rs` |\n\
                    [tests](tests/README.md) [far](https://a.b/c.rs)\n```\n`none.rs`\n```";
        let named = Named::read(text);
        let expected = [
            "demo/src/main.rs",
            "plugin/src/io/digest.rs",
            "plugin/src/io/mod.rs",
            "tests/README.md",
        ];
        assert!(named.found.iter().eq(expected.iter()), "{named:?}");
        assert!(named.missing.is_empty(), "{named:?}");
    }

    #[test]
    fn missing_files_are_told_with_their_lines() {
        let named = Named::read("text\n`io/nothing.rs`\n[a](docs/none.md)");
        assert_eq!(
            named.missing,
            ["line 2: io/nothing.rs", "line 3: docs/none.md"]
        );
    }

    #[test]
    fn relative_links_are_told_from_those_of_the_web_and_of_the_page() {
        let text = "[a](b.md#c) [d](https://e.f/g) [h](#i)\n```\n[j](k.md)\n```";
        assert!(relative_links(text).eq(["b.md"]));
    }

    #[test]
    fn a_folder_covers_its_files_and_a_module_its_parts() {
        let named = Named::read("`io/dem/`, `params.rs`, `plugin/`");
        assert!(named.covers("plugin/src/io/dem/hgt.rs"));
        assert!(named.covers("plugin/src/params/switches.rs"));
        assert!(!named.covers("plugin/src/io/digest.rs"));
    }
}
