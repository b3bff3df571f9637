//! `pangaea`: the explorer, and headless commands that grow, draw and measure planets.

#![allow(unreachable_pub, reason = "nothing outside can reach into a program")]
#![allow(
    clippy::disallowed_methods,
    reason = "what is drawn or typed is no part of a planet's state"
)]

mod cli;
mod climate;
mod error;
mod values;

mod course;
mod headless;
mod interrupt;
mod output;
mod progress;

mod bench;
mod generate;
mod info;

mod ground;

mod export;
mod query;
mod relief;

mod offscreen;
mod picture;

mod explorer;

#[cfg(test)]
mod fuzz_tests;

use bevy_pangaea::io::load;
use clap::{Parser, error::ErrorKind};
use cli::{Cli, Command};
use error::CliError;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse(&error),
    };
    let result = match &cli.command {
        None => explore(&cli),
        Some(Command::Generate(args)) => generate::generate(args),
        Some(Command::Render(args)) => picture::render(args),
        Some(Command::Views(args)) => picture::views(args),
        Some(Command::Bench(args)) => bench::bench(args),
        Some(Command::Info(args)) => info::info(args),
        Some(Command::Export(args)) => export::export(args),
        Some(Command::Relief(args)) => relief::relief(args),
        Some(Command::Query(args)) => query::query(args),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => fail(&error),
    }
}

/// Opens the explorer. Files are read and tried first: a window is no place to refuse the command
/// line.
fn explore(cli: &Cli) -> Result<(), CliError> {
    let recipe = cli.start.recipe.checked()?;
    if let Some(path) = &cli.capture {
        output::check_file(path)?;
    }
    let open = match &cli.start.open {
        Some(path) => Some((Box::new(load(path)?), path.clone())),
        None => None,
    };
    let frames = cli.frames.map(|frames| frames as u32);
    explorer::run(explorer::Options {
        recipe,
        open,
        frames,
        capture: cli.capture.clone(),
    })
    .map_err(CliError::Failed)
}

fn fail(error: &CliError) -> ExitCode {
    output::say(&format!("error: {error}"));
    error.exit_code()
}

/// Help and version go to stdout; anything else is one line on stderr.
fn refuse(error: &clap::Error) -> ExitCode {
    if matches!(
        error.kind(),
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion
    ) {
        return output::print(&error.render().to_string())
            .map_or_else(|error| fail(&error), |()| ExitCode::SUCCESS);
    }
    let text = error.render().to_string();
    // The first paragraph is the problem; usage and hints follow.
    let problem: Vec<&str> = text
        .lines()
        .take_while(|line| !line.trim().is_empty())
        .map(str::trim)
        .collect();
    output::say(&problem.join(" "));
    ExitCode::from(2)
}
