//! `pangaea`: the explorer, and headless commands that grow, draw and measure planets.

#![allow(unreachable_pub, reason = "nothing outside can reach into a program")]
#![allow(
    clippy::disallowed_methods,
    reason = "pictures and forms are no part of a planet's state"
)]

mod error;
mod values;

mod cli;
#[cfg(unix)]
mod ending;
mod inputs;
mod interrupt;
mod landscape;
#[cfg(unix)]
mod memory;
mod output;

mod dem;
mod progress;
mod threads;

mod floor;

mod headless;

mod growth;
mod source;

mod bench;
mod ground;
mod maps;

mod generate;
mod info;

mod export;
mod query;
mod relief;

mod offscreen;
mod picture;

mod explorer;

#[cfg(test)]
mod fuzz_tests;

use bevy_pangaea::io::planet_files;
use clap::{Parser, error::ErrorKind};
use cli::{Cli, Command};
use error::CliError;
use inputs::Inputs;
use source::load_planet;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse(&error),
    };
    exit(prepare(&cli).and_then(|()| run(&cli)))
}

/// Gets ready for the end of memory, and starts the threads of parallel work.
fn prepare(cli: &Cli) -> Result<(), CliError> {
    #[cfg(unix)]
    ending::start(output::abandon)?;
    threads::start(cli.command.as_ref().and_then(Command::threads))
}

fn run(cli: &Cli) -> Result<(), CliError> {
    match &cli.command {
        None => explore(cli),
        Some(Command::Generate(args)) => generate::generate(args),
        Some(Command::Maps(args)) => maps::maps(args),
        Some(Command::Render(args)) => picture::render(args),
        Some(Command::Views(args)) => picture::views(args),
        Some(Command::Bench(args)) => bench::bench(args),
        Some(Command::Info(args)) => info::info(args),
        Some(Command::Export(args)) => export::export(args),
        Some(Command::Relief(args)) => relief::relief(args),
        Some(Command::Query(args)) => query::query(args),
    }
}

/// Opens the explorer. Files are read and paths tried first: a command line is refused on the
/// terminal, not in a window.
fn explore(cli: &Cli) -> Result<(), CliError> {
    let recipe = cli.start.recipe.checked()?;
    if let Some(path) = &cli.capture {
        let opened = cli.start.open.as_deref().map(planet_files);
        let preset = cli.start.recipe.preset.clone();
        let inputs = Inputs::new(opened.into_iter().flatten().chain(preset));
        output::check_file(path, &inputs)?;
    }
    let open = match &cli.start.open {
        Some(path) => Some((Box::new(load_planet(path)?), path.clone())),
        None => None,
    };
    explorer::run(explorer::Options {
        recipe,
        open,
        frames: cli.frames,
        capture: cli.capture.clone(),
    })
    .map_err(CliError::Failed)
}

fn exit(result: Result<(), CliError>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Where memory ends in another thread, what fails here is told there.
            if memory::has_last_word() {
                output::say(&format!("error: {error}"));
            }
            error.exit_code()
        }
    }
}

/// Help and version go to stdout; anything else is one line on stderr.
fn refuse(error: &clap::Error) -> ExitCode {
    let text = error.render().to_string();
    if let ErrorKind::DisplayHelp | ErrorKind::DisplayVersion = error.kind() {
        return exit(output::print(&text));
    }
    // The first paragraph is the problem; usage and hints follow.
    let problem: Vec<&str> = text
        .lines()
        .take_while(|line| !line.trim().is_empty())
        .map(str::trim)
        .collect();
    output::say(&problem.join(" "));
    ExitCode::from(2)
}
