//! Prints the figures of a workspace's code: `tests/house`.

use pangaea_source::figures::{Measured, figures};
use pangaea_source::workspace;
use std::path::PathBuf;

const CRATES: [&str; 3] = ["plugin/src", "shaders/src", "demo/src"];

fn main() {
    let root = std::env::args_os().nth(1);
    let root = root.map_or_else(workspace, PathBuf::from);
    if let Some(folder) = CRATES.iter().find(|folder| !root.join(folder).is_dir()) {
        eprintln!("{} has no folder {folder}", root.display());
        std::process::exit(2);
    }
    let crates = CRATES.map(|folder| Measured::read(&root, folder));
    let [plugin, shaders, demo] = [0, 1, 2].map(|i| figures(&crates[i..=i]));
    let columns = [plugin, shaders, demo, figures(&crates)];
    print_row("", &[CRATES[0], CRATES[1], CRATES[2], "all"]);
    for (i, (name, _)) in columns[0].iter().enumerate() {
        let values: Vec<&str> = columns.iter().map(|column| column[i].1.as_str()).collect();
        print_row(name, &values);
    }
}

fn print_row(name: &str, values: &[&str]) {
    let cells: Vec<String> = values.iter().map(|value| format!("{value:>14}")).collect();
    println!("{name:<40}{}", cells.concat());
}
