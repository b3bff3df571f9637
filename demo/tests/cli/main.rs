//! The commands as a user types them: exit codes, messages, and what is in the files.
//!
//! ```text
//! program      runs the program, and what it must do where it refuses
//! options      numbers, names and help
//! recipes      presets and scenarios
//! generate     the files of a planet
//! measures     info and bench
//! maps         maps of a planet file
//! scenarios    commands of a planet, written and played again
//! files        written all or none: what is in the way, what stays
//! inputs       what a command reads is not written over
//! interrupts   signals, and a full disk
//! pipes        questions and answers through pipes
//! explorer     what is refused before a window opens
//! export       squares of the ground
//! climate      maps of a user
//! terrain      planets of maps alone
//! query        points of the ground
//! relief       relief statistics, beside those of real tiles
//! ```

mod program;

mod options;

mod recipes;

mod generate;

mod measures;

mod maps;

mod scenarios;

mod files;

mod inputs;

#[cfg(unix)]
mod interrupts;

#[cfg(unix)]
mod pipes;

mod explorer;

mod export;

mod climate;

mod terrain;

mod query;

mod relief;
