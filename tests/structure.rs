//! The structure of the code: imports go one way, a word has one meaning, documents are true.

use pangaea_source::documents::{Named, relative_links};
use pangaea_source::functions::functions;
use pangaea_source::habits::Habits;
use pangaea_source::imports::{Import, Modules};
use pangaea_source::names::{riddles, types_named_twice};
use pangaea_source::{Source, files_below, sources, workspace};
use std::fmt::Display;

/// The folders with the code of the workspace's crates.
const CRATES: [&str; 3] = ["plugin/src", "shaders/src", "demo/src"];

fn everything() -> Vec<Source> {
    CRATES.iter().flat_map(|folder| sources(folder)).collect()
}

/// One entry to a line.
fn list<T: Display>(entries: impl IntoIterator<Item = T>) -> String {
    entries
        .into_iter()
        .map(|entry| format!("\n  {entry}"))
        .collect()
}

fn modules(folder: &str) -> Modules {
    Modules::new(folder, &sources(folder))
}

fn assert_none(imports: &[Import], complaint: &str) {
    assert!(
        imports.is_empty(),
        "{} {complaint}:{}",
        imports.len(),
        list(imports)
    );
}

#[test]
fn the_plugin_imports_in_the_order_of_its_root() {
    let later = modules("plugin/src").from_later(&[]);
    assert_none(
        &later,
        "imports from modules that come later in plugin/src/lib.rs",
    );
}

#[test]
fn no_passes_of_the_ground_import_each_other_in_a_circle() {
    let circles = modules("shaders/src").circles();
    assert_none(&circles.concat(), "imports close circles of files");
}

#[test]
fn no_files_of_the_plugin_import_each_other_in_a_circle() {
    let circles = modules("plugin/src").circles();
    assert_none(&circles.concat(), "imports close circles of files");
}

#[test]
fn no_files_of_the_program_import_each_other_in_a_circle() {
    let circles = modules("demo/src").circles();
    assert_none(&circles.concat(), "imports close circles of files");
}

#[test]
fn no_folders_import_each_other_in_a_circle() {
    for folder in CRATES {
        let circles = modules(folder).top_circles();
        assert_none(&circles.concat(), "imports close circles of top modules");
    }
}

#[test]
fn no_type_is_named_twice() {
    let twice = types_named_twice(&everything());
    let places = twice
        .iter()
        .map(|(name, places)| format!("{name}: {}", places.join(", ")));
    assert!(twice.is_empty(), "types of one name:{}", list(places));
}

/// Named closures of more than two lines, as `path:line`.
fn long_closures(source: &Source) -> Vec<String> {
    let lines = Habits::of(&source.syntax).closures.into_iter();
    lines
        .map(|line| format!("{}:{line}", source.path))
        .collect()
}

#[test]
fn closures_with_names_are_short() {
    let found: Vec<String> = everything().iter().flat_map(long_closures).collect();
    assert!(found.is_empty(), "should be functions:{}", list(found));
}

/// Functions that are too heavy, as `path:line: name`.
fn heavy_functions(source: &Source) -> Vec<String> {
    let mut heavy = functions(&source.syntax);
    heavy.retain(|function| function.is_too_heavy());
    let places = heavy.iter();
    places
        .map(|function| format!("{}:{}: {}", source.path, function.line, function.name))
        .collect()
}

#[test]
fn no_function_is_too_heavy() {
    let found: Vec<String> = everything().iter().flat_map(heavy_functions).collect();
    assert!(found.is_empty(), "over 400 tokens:{}", list(found));
}

#[test]
fn documentation_states_instead_of_asking() {
    let found: Vec<String> = everything().iter().flat_map(riddles).collect();
    assert!(
        found.is_empty(),
        "{} lines begin with \"What\":{}",
        found.len(),
        list(found)
    );
}

fn text(name: &str) -> String {
    std::fs::read_to_string(workspace().join(name)).expect("a document of the workspace")
}

fn document(name: &str) -> Named {
    Named::read(&text(name))
}

#[test]
fn documents_name_files_that_exist() {
    for name in ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let missing = document(name).missing;
        assert!(
            missing.is_empty(),
            "{name} names what is not there:{}",
            list(missing)
        );
    }
}

/// A registry shows a README without the files beside it.
#[test]
fn published_documents_have_no_relative_links() {
    for name in ["plugin/README.md", "shaders/README.md"] {
        let text = text(name);
        let linked: Vec<&str> = relative_links(&text).collect();
        assert!(linked.is_empty(), "{name} links to:{}", list(linked));
    }
}

/// A file of code that is not the root of a folder, whose place the folder's name tells.
fn needs_a_place(path: &str) -> bool {
    const ROOTS: [&str; 3] = ["/mod.rs", "/lib.rs", "/main.rs"];
    let is_code = path.ends_with(".rs") && !path.ends_with("tests.rs");
    is_code && !path.contains("/tests/") && ROOTS.iter().all(|root| !path.ends_with(root))
}

/// The top modules of the plugin in the order of the map's rows.
fn mapped_modules() -> Vec<String> {
    let map = text("ARCHITECTURE.md");
    let (_, part) = map.split_once("\n### plugin/src\n").expect("the map");
    let rows = part.lines().skip_while(|line| !line.starts_with("|---"));
    let rows = rows.skip(1).take_while(|line| line.starts_with('|'));
    let cells = rows.filter_map(|row| row.split('|').nth(1));
    let names = cells.flat_map(|cell| cell.split('`').skip(1).step_by(2).collect::<Vec<_>>());
    // A name without a folder goes on in that of the name before.
    let mut folder = "";
    let mut modules = Vec::new();
    for name in names {
        let is_top = workspace().join("plugin/src").join(name).exists();
        if is_top {
            folder = name.split('/').next().unwrap_or(name);
        }
        modules.push(folder.trim_end_matches(".rs").to_string());
    }
    modules.dedup();
    modules
}

#[test]
fn the_map_of_the_code_has_the_order_of_the_root() {
    let code = modules("plugin/src");
    let mut declared = code.top_modules().to_vec();
    // Names of other modules, in the root itself.
    declared.retain(|module| module != "prelude");
    assert_eq!(mapped_modules(), declared);
}

#[test]
fn the_map_of_the_code_names_every_file_or_its_folder() {
    let map = document("ARCHITECTURE.md");
    let folders = ["plugin/src", "shaders/src/amplify", "demo/src"];
    let mut files = folders.map(files_below).concat();
    files.retain(|path| needs_a_place(path) && !map.covers(path));
    assert!(
        files.is_empty(),
        "ARCHITECTURE.md does not name:{}",
        list(files)
    );
}
