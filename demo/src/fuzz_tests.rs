//! Damaged command lines and lists of points: each is refused in words or understood.

use crate::cli::{Cli, Command};
use crate::query::places::places_in;
use clap::Parser;
use pangaea_tests::fuzz::{Format, fuzz};

/// Between two arguments of a command line.
const SEPARATOR: char = '\n';

const WORDS: &[&str] = &[
    "\n",
    "=",
    "--",
    "-",
    "--help",
    "--at",
    "--seed",
    "--samples",
    "--scenario",
    "--until",
    "NaN",
    "inf",
    "-1",
    "1e400",
    "18446744073709551616",
    ",",
    "é",
    "\u{0}",
    "\u{feff}",
    "91",
    "361",
];

fn bytes(texts: &[&str]) -> Vec<Vec<u8>> {
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}

#[test]
fn damaged_command_lines_are_refused_or_understood() {
    let good = [
        "--seed\n7\n--samples\n500\n--plates\n9\n--land\n0.5",
        "generate\n--seed=7\n--until\n20\n--out\nfolder\n--threads=2",
        "render\n--camera=-33,-70,1e6,90,-10\n--overlay\nplates\n--out=a.png",
        "export\na.pangaea\n--region=-33,-70,60\n--out\na.tif\n--pixels=64",
        "query\na.pangaea\n--at\n-33,-70\n--level\n12",
        "bench\n--samples\n100,2000",
        "relief\na.pangaea",
        "views\n--size\n640x480",
    ];
    let format = Format {
        name: "command lines",
        good: bytes(&good),
        words: WORDS,
    };
    fuzz(&format, |line| {
        let line = String::from_utf8_lossy(line);
        match Cli::try_parse_from(["pangaea"].into_iter().chain(line.split(SEPARATOR))) {
            Err(error) => assert!(!error.render().to_string().is_empty()),
            Ok(cli) => assert_valid(&cli),
        }
    });
}

/// Asserts that the numbers of an accepted command line are within their limits.
fn assert_valid(cli: &Cli) {
    match &cli.command {
        Some(Command::Query(args)) => {
            assert!(
                args.at
                    .iter()
                    .all(|at| at.lat.abs() <= 90.0 && at.lon.abs() <= 360.0)
            );
            assert!(args.level <= 17);
        }
        Some(Command::Generate(args)) => assert!(args.growth.until() > 0.0),
        // A recipe is checked as a whole, and refused or not.
        None => drop(cli.start.recipe.checked()),
        Some(_) => {}
    }
}

#[test]
fn damaged_lists_of_points_are_refused_or_places() {
    let format = Format {
        name: "lists of points",
        good: bytes(&[
            "\u{feff}10,20\n\n -33 , -70.5\r\n0,360",
            "90,180\n-90,-180\n",
            "",
        ]),
        words: WORDS,
    };
    fuzz(&format, |text| {
        match places_in(text).collect::<Result<Vec<_>, _>>() {
            Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
            Ok(places) => {
                assert!(
                    places
                        .iter()
                        .all(|at| at.lat.abs() <= 90.0 && at.lon.abs() <= 360.0)
                );
            }
        }
    });
}
