//! Prints the figures of the workspace's code: `tests/house`.

use pangaea_tests::source::figures::figures;

const CRATES: [&str; 3] = ["plugin/src", "shaders/src", "demo/src"];

fn main() {
    let columns = [
        figures(&CRATES[..1]),
        figures(&CRATES[1..2]),
        figures(&CRATES[2..]),
        figures(&CRATES),
    ];
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
