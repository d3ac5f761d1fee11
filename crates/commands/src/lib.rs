//! The commands of the program `dalembert`, for all motors and papers that a program links.
//!
//! This crate is for programs with motors, systems or papers of their own. Such a program links its crates and calls [`run()`]:
//!
//! ```no_run
//! use std::process::ExitCode;
//!
//! fn main() -> ExitCode {
//!     dalembert_commands::run()
//! }
//! ```
//!
//! # Overview
//! * `arguments`: the command line; the options of each command are in the file of the command;
//! * `report`, `ledger` with `judge`, `review`, `derive`, `draw`, `linearise`, `inverse`, `regulate`, `bodies`, `run`, `ensemble`, `regimes`, `stationary`,
//!   `numerical-stability`, `motor`, `conform`, `new`, `failures`, `chart`, `choose`, `reference`, `scenes`: one file for each command;
//! * `export`: a system for other simulators;
//! * `watch`: a page that is updated whenever a file is saved;
//! * `summary`, `csv`, `pictures`, `sphere`: output of a run as text, JSON, a table and the data of pictures;
//! * `speed`: the errors and costs of all methods on a scene as pictures, tables and advice;
//! * `job_pool`: independent jobs on all processors;
//! * `values`, `timings`: exact values and measured times as text;
//! * `exit`: exit codes, and output into a pipe that may be closed; `atomic_write`: atomic writing of files; `output`: the
//!   files that a command may write and replace;
//! * [`charted`], [`chosen_model`], [`steady_motions`], [`forces_along`], [`regulator`], [`consistent_regimes`], [`reference_solution`],
//!   [`finding_object`], [`unjudged_object`]: results of commands as values, for other programs;
//! * `clock`: the deadline and Ctrl-C; `progress`: the progress bar.

mod arguments;
mod atomic_write;
mod bodies;
mod chart;
mod choose;
mod claim_row;
mod clock;
mod conform;
mod csv;
mod derive;
mod draw;
mod ensemble;
mod exit;
mod export;
mod failures;
mod inverse;
mod job_pool;
mod ledger;
mod linearise;
mod motor;
mod named_value;
mod new;
mod numerical_stability;
mod output;
mod pictures;
mod progress;
mod prove;
mod reference;
mod regimes;
mod region_map;
mod regulate;
mod report;
mod review;
mod run;
mod scenes;
mod sketch;
mod spectrum;
mod speed;
mod sphere;
mod stability;
mod stability_map;
mod stationary;
mod studies;
mod summary;
mod timings;
mod values;
mod watch;

pub use chart::{Charted, charted};
pub use choose::{ChosenModel, chosen_model};
pub use inverse::{ForceTable, Wanted as WantedForces, forces_along};
pub use ledger::paper_file::{object as finding_object, unjudged_object};
pub use reference::{ReferenceResult, reference_solution};
pub use regimes::{RegimesResult, consistent_regimes};
pub use regulate::{RegulatorResult, regulator};
pub use stationary::model::{SteadyMotionsResult, steady_motions};

use arguments::{Arguments, Command};
use clap::CommandFactory;
use clap_complete::Shell;
use exit::Exit;
use std::process::ExitCode;

/// Runs the command that the arguments of the process specify, and returns the exit code of the process.
pub fn run() -> ExitCode {
    let arguments = match Arguments::read(std::env::args_os()) {
        Ok(arguments) => arguments,
        Err(said) => return exit::print_instead(&said).tell(),
    };
    if arguments.quiet {
        exit::be_quiet();
    }
    ::scenes::register(|warning| {
        if !exit::is_quiet() {
            exit::warn(warning);
        }
    });
    let (command, keeps, seconds) = arguments.timed();
    clock::start(command, keeps, seconds);
    let work = progress::Progress::new(command);
    let ending = match arguments.command {
        None => report(&arguments.report),
        Some(Command::Run(asked)) => run::run(&asked),
        Some(Command::Chart(asked)) => chart::chart(&asked),
        Some(Command::Choose(asked)) => choose::show(&asked),
        Some(Command::Reference(asked)) => reference::reference(&asked),
        Some(Command::Ensemble(asked)) => ensemble::run(&asked),
        Some(Command::Ledger(asked)) => ledger::list(&asked),
        Some(Command::Judge(asked)) => ledger::paper_file::judge(&asked),
        Some(Command::Review(asked)) => review::review(&asked),
        Some(Command::Derive(asked)) => derive::derive(&asked),
        Some(Command::Draw(asked)) => draw::draw(&asked),
        Some(Command::Export(asked)) => export::export(&asked),
        Some(Command::Inverse(asked)) => inverse::show(&asked),
        Some(Command::Linearise(asked)) => linearise::linearise(&asked),
        Some(Command::Regulate(asked)) => regulate::show(&asked),
        Some(Command::Prove(asked)) => prove::prove(&asked),
        Some(Command::Watch(asked)) => watch::watch(&asked),
        Some(Command::Bodies(asked)) => bodies::show(&asked),
        Some(Command::Stationary(asked)) => stationary::show(&asked),
        Some(Command::NumericalStability(asked)) => numerical_stability::show(&asked),
        Some(Command::Motor(asked)) => motor::show(&asked),
        Some(Command::Conform(asked)) => conform::show(&asked),
        Some(Command::New(asked)) => new::write(&asked),
        Some(Command::Regimes(asked)) => regimes::show(&asked),
        Some(Command::Failures(asked)) => failures::list(&asked),
        Some(Command::Scenes(asked)) => scenes::list(&asked),
        Some(Command::Completions { shell }) => exit::print(&completions(shell)).map(|()| Exit::Done),
    };
    drop(work);
    ending.unwrap_or_else(|refused| refused).tell()
}

/// The completion script for a shell.
fn completions(shell: Shell) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "dalembert", &mut script);
    String::from_utf8_lossy(&script).into_owned()
}

/// Writes the report, the task of the program without a command.
fn report(asked: &report::Args) -> Result<Exit, Exit> {
    let files = scenes::files(&asked.scenes)?;
    report::write(asked, &files)
}
