//! Questions and answers through pipes.

use crate::program::{begun, planet};
use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

const QUERY: [&str; 4] = ["query", "planet.pangaea", "--level", "4"];

#[test]
fn each_line_is_answered_before_the_next_one_is_asked() {
    let folder = planet();
    let mut child = begun(folder.path(), &QUERY, Stdio::piped());
    let mut input = child.stdin.take().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut hear = || lines.next().unwrap().unwrap();
    assert!(hear().starts_with("lat,lon,height_m,"));
    for i in 0..5 {
        writeln!(input, "{i},{i}").unwrap();
        assert!(hear().starts_with(&format!("{i},{i},")));
    }
    drop(input);
    assert!(lines.next().is_none());
    assert!(child.wait().unwrap().success());
}

#[test]
fn it_ends_when_its_reader_is_gone_though_the_input_is_open() {
    let folder = planet();
    let mut child = begun(folder.path(), &QUERY, Stdio::piped());
    let mut input = child.stdin.take().unwrap();
    writeln!(input, "1,2").unwrap();
    let mut output = BufReader::new(child.stdout.take().unwrap());
    output.read_line(&mut String::new()).unwrap();
    drop(output);
    // Were it to wait for the end of the input, this would never end.
    assert!(child.wait().unwrap().success());
    drop(input);
}

#[test]
fn many_lines_are_left_when_the_reader_is_gone() {
    let folder = planet();
    // The finest level: all of them would take minutes.
    let mut child = begun(folder.path(), &QUERY[..2], Stdio::piped());
    let mut input = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || {
        let line = |i: i32| format!("{},{}\n", i * 7919 % 150 - 75, i * 7 % 360);
        (0..400_000).try_for_each(|i| input.write_all(line(i % 10_000).as_bytes()))
    });
    let mut output = BufReader::new(child.stdout.take().unwrap());
    for _ in 0..2 {
        output.read_line(&mut String::new()).unwrap();
    }
    drop(output);
    assert!(child.wait().unwrap().success());
    assert!(writer.join().unwrap().is_err(), "it read all lines");
}
