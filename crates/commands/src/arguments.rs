//! The command line: subcommands, their arguments, and parsers of values.

use crate::clock::Keeps;
pub use crate::output::Format;
use crate::{
    bodies, chart, choose, conform, derive, draw, ensemble, export, failures, inverse, ledger, linearise, motor, new,
    numerical_stability, prove, reference, regimes, regulate, report, review, run, scenes, stationary, watch,
};
use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use clap_complete::Shell;
use simulation::run::check_tolerance;
use std::ffi::OsString;
use std::fmt::Display;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// Derives and runs equations of motion, proves that principles agree, and judges the claims of papers.
///
/// Without a command the report is made: every paper's statements are judged, every scene is run and charted, and all of it is
/// written into one self-contained page.
///
/// Exit codes: 0: success. 1: the result is negative or incomplete. 2: the input is not acceptable. 130: Ctrl-C ended the command.
///
/// Exit code 1 in detail: the time limit was reached; a run stopped before its end, has undefined values, or failed a check; `ensemble`: every
/// member stopped; `ensemble --missing`: members are missing; `judge`, `ledger`: a verdict is not the expected one; `prove`: a principle does
/// not agree, a comparison is undecided, or terms are missing with --mistake; `conform`: a law is violated or undecided; `regimes`: the
/// regimes at the start are not determined; `failures`: theory and runs disagree, or a scene was not measured; `choose`: no method meets the
/// tolerance; `reference`: two methods do not agree; `stationary`, `motor`, `linearise`, `numerical-stability`: parts of the search are
/// undecided; the report: a file could not be read or computed.
///
/// At the time limit, or at Ctrl-C, `run`, `ensemble`, `chart` and `reference` keep their results
/// so far; a second Ctrl-C ends them at once.
///
/// Output files are written atomically. The extension determines the format: .csv, .npz, .svg, .html, .reference or .fmu. Missing folders
/// are made. An existing file is replaced only if the command wrote it, or with --force; a file that the command reads is never
/// replaced.
#[derive(Debug, Parser)]
#[command(
    name = "dalembert",
    version,
    override_usage = "dalembert [-q] [--seconds <N>] [OPTIONS OF THE REPORT]\n       dalembert [-q] [--seconds <N>] <COMMAND>"
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Results and errors only: no progress, no names of files that were written
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Time limit in seconds, after which the command ends and keeps its results so far. The default is 300, and 30 for `chart`; `ensemble`,
    /// `watch`, `review` without a file, and the report have no limit by default
    #[arg(long, global = true, value_name = "N", value_parser = whole::<u32>(1..=86_400))]
    pub seconds: Option<u32>,
    #[command(flatten, next_help_heading = "Options of the report, without a command")]
    pub report: report::Args,
}

impl Arguments {
    /// Reads a command line, whose first word is the name of the program.
    ///
    /// # Errors
    /// A message of the parser. An option of the report before a command is refused, since the command would ignore it.
    pub fn read<T: Into<OsString> + Clone>(words: impl IntoIterator<Item = T>) -> Result<Self, clap::Error> {
        let mut parser = Self::command();
        let matches = parser.try_get_matches_from_mut(words)?;
        let is_given = |option: &&&str| matches.value_source(option) == Some(ValueSource::CommandLine);
        if let (Some(name), Some(option)) = (matches.subcommand_name(), REPORT_OPTIONS.iter().find(is_given)) {
            let said = format!(
                "`--{option}` before `{name}` is an option of the report, which is made without a command; options of `{name}` stand after it"
            );
            return Err(parser.error(ErrorKind::ArgumentConflict, said));
        }
        Self::from_arg_matches(&matches).map_err(|error| error.format(&mut parser))
    }

    /// The name of the command, whether it keeps partial results, and its time limit in seconds (`None`: no limit).
    pub fn timed(&self) -> (&'static str, Keeps, Option<u32>) {
        use Keeps::{Nothing, Part};
        let (name, keeps, usual) = match &self.command {
            None => ("dalembert", Nothing, None),
            Some(Command::Run(_)) => ("run", Part, Some(USUAL)),
            Some(Command::Chart(_)) => ("chart", Part, Some(30)),
            Some(Command::Choose(_)) => ("choose", Nothing, Some(USUAL)),
            Some(Command::Reference(_)) => ("reference", Part, Some(USUAL)),
            Some(Command::Ensemble(_)) => ("ensemble", Part, None),
            Some(Command::Ledger(_)) => ("ledger", Nothing, Some(USUAL)),
            Some(Command::Judge(_)) => ("judge", Nothing, Some(USUAL)),
            Some(Command::Review(asked)) if asked.file.is_some() => ("review", Part, Some(USUAL)),
            Some(Command::Review(_)) => ("review", Nothing, None),
            Some(Command::Derive(_)) => ("derive", Nothing, Some(USUAL)),
            Some(Command::Draw(_)) => ("draw", Nothing, Some(USUAL)),
            Some(Command::Export(_)) => ("export", Nothing, Some(USUAL)),
            Some(Command::Inverse(_)) => ("inverse", Nothing, Some(USUAL)),
            Some(Command::Linearise(_)) => ("linearise", Nothing, Some(USUAL)),
            Some(Command::Regulate(_)) => ("regulate", Nothing, Some(USUAL)),
            Some(Command::Prove(_)) => ("prove", Nothing, Some(USUAL)),
            Some(Command::Bodies(_)) => ("bodies", Nothing, Some(USUAL)),
            Some(Command::Stationary(_)) => ("stationary", Part, Some(USUAL)),
            Some(Command::NumericalStability(_)) => ("numerical-stability", Part, Some(USUAL)),
            Some(Command::Motor(_)) => ("motor", Nothing, Some(USUAL)),
            Some(Command::Conform(_)) => ("conform", Nothing, Some(USUAL)),
            Some(Command::New(_)) => ("new", Nothing, Some(USUAL)),
            Some(Command::Regimes(_)) => ("regimes", Nothing, Some(USUAL)),
            Some(Command::Failures(_)) => ("failures", Nothing, Some(USUAL)),
            Some(Command::Scenes(_)) => ("scenes", Nothing, Some(USUAL)),
            Some(Command::Watch(asked)) => ("watch", asked.keeps(), None),
            Some(Command::Completions { .. }) => ("completions", Nothing, Some(USUAL)),
        };
        (name, keeps, self.seconds.or(usual))
    }
}

/// The options of [`report::Args`].
const REPORT_OPTIONS: [&str; 4] = ["scenes", "papers", "out", "force"];

/// The default time limit in seconds.
const USUAL: u32 = 300;

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Runs a scene and prints its last state, the work done and the invariants
    #[command(after_long_help = run::help())]
    Run(run::Args),
    /// Measures every method on a scene: speed against accuracy
    Chart(chart::Args),
    /// Finds the smallest model and the cheapest method that give the outputs of a scene to a tolerance
    Choose(choose::Args),
    /// Computes a reference solution of a scene, to the digits on which two methods agree, and keeps it in a file
    Reference(reference::Args),
    /// Runs a scene many times; the table [ensemble] of the scene names the values that vary. If the command is repeated, it continues the table
    Ensemble(ensemble::Args),
    /// Every claim of the papers with its verdict
    Ledger(ledger::Args),
    /// Judges every claim of a paper's file: prints each formula, how it was read, and whether it is true of the paper's model
    #[command(after_long_help = ledger::paper_file::HELP)]
    Judge(ledger::paper_file::Args),
    /// Compares two versions of a system, of a paper or of snapshots: changed terms of equations, changed verdicts and changed runs
    Review(review::Args),
    /// Equations of motion by a chosen principle
    Derive(derive::Args),
    /// A sketch of a system, drawn from its model: bodies, joints, springs, surfaces; still, or moving as a run does
    Draw(draw::Args),
    /// Writes a system with [coordinates] for other programs: a unit of FMI 3.0 or 2.0, a Modelica model, code
    #[command(after_long_help = export::HELP)]
    Export(export::Args),
    /// Proves that every principle gives the same equations of motion, for a system with [coordinates]
    Prove(prove::Args),
    /// Linear equations of a system with [coordinates] about a point or along a run: A, B, C, D, eigenvalues, stability
    #[command(alias = "linearize")]
    Linearise(linearise::Args),
    /// A page in the browser that is updated whenever a file is saved: equations, verdicts, the run, sliders, the claims of a paper
    Watch(watch::Args),
    /// The forces under which a system with [coordinates] moves as prescribed
    Inverse(inverse::Args),
    /// The optimal regulator of a system with [coordinates], by Riccati's equation, and its run on the nonlinear model
    Regulate(regulate::Args),
    /// The mass properties of a scene's bodies: both inertia tensors, principal axes, centre of mass, weight
    Bodies(bodies::Args),
    /// All steady motions of a system within given ranges, each with its stability: equilibria, and motions with constant speeds
    Stationary(stationary::Args),
    /// The step sizes for which each method preserves the stability or instability of a steady motion
    NumericalStability(numerical_stability::Args),
    /// A synchronous motor under load: pull-out and pull-in torque, its motions at loads between the two, the starts from which it synchronises
    Motor(motor::Args),
    /// Checks physical laws that every motor must obey, each with a verdict: power balance, passivity, independence of the frame, reaction on the
    /// housing, rest, stiffness, units
    Conform(conform::Args),
    /// Writes a new motor: its file, its entry in the list of motors, a scene and a test; or a scene with its laws as text
    New(new::Args),
    /// Every possible state of the contacts of a scene at its start (sticking, sliding, separation), with the distance of each from its limit
    Regimes(regimes::Args),
    /// Cases in which methods fail: the limit of each by theory and by runs, methods that do not fail, advice
    Failures(failures::Args),
    /// Lists the scenes of a folder, each with its title
    Scenes(scenes::Args),
    /// A script that completes commands and options in a shell: `dalembert completions bash > FILE`
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// Parses a finite number.
///
/// # Errors
/// The text is not a number, or the number is infinite; the message names the accepted form.
pub fn finite(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|value: &f64| value.is_finite())
        .ok_or_else(|| "a finite number such as 6.5 is accepted".to_owned())
}

/// A parser of integers within a range.
/// The parser returns a message with the range for any other text.
pub fn whole<N>(range: RangeInclusive<N>) -> impl Fn(&str) -> Result<N, String> + Clone
where
    N: FromStr + PartialOrd + Display + Clone,
{
    move |text| {
        let value = text.parse().ok().filter(|value| range.contains(value));
        value.ok_or_else(|| format!("a whole number from {} to {} is accepted", range.start(), range.end()))
    }
}

/// Parses a tolerance, the error that a method may make in one step.
///
/// # Errors
/// The number is below 1e-14, or not below 1.
pub fn tolerance(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number such as 1e-8 is accepted".to_owned())?;
    check_tolerance(value).map_err(|wrong| format!("{wrong}; from 1e-14 to below 1 is accepted"))?;
    Ok(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::{RngSeed, TestRunner};

    /// Words of random command lines: commands, options, values, and words that no command accepts.
    const WORDS: &[&str] = &[
        "run",
        "chart",
        "reference",
        "ensemble",
        "ledger",
        "judge",
        "derive",
        "bodies",
        "stationary",
        "motor",
        "conform",
        "new",
        "numerical-stability",
        "choose",
        "review",
        "failures",
        "regimes",
        "scenes",
        "completions",
        "watch",
        "help",
        "--help",
        "-h",
        "--version",
        "-q",
        "--quiet",
        "--scenes",
        "--out",
        "--format",
        "--method",
        "--tol",
        "--model",
        "--form",
        "--samples",
        "--seconds",
        "--threads",
        "--omega0",
        "--momentum",
        "--cone",
        "--map",
        "--upright",
        "--until",
        "--x",
        "--principle",
        "--verdict",
        "--transition",
        "--",
        "-",
        "--out=",
        "json",
        "text",
        "first",
        "taylor",
        "gauss:99",
        "runge_kutta_4:0",
        "runge_kutta_4:99999999999",
        "0",
        "-1",
        "1e-9",
        "1e999",
        "nan",
        "inf",
        "-inf",
        "4294967296",
        "99999999999999999999",
        "",
        "scenes/spin_up.toml",
        "γ̇",
        "\u{0}",
        "\u{202e}",
        "--\u{e9}",
    ];

    #[test]
    fn options_before_a_command_are_its_own_or_refused() {
        let read = |words: &[&str]| Arguments::read(words.iter().map(|word| (*word).to_owned()));
        assert!(read(&["dalembert", "-q", "ledger"]).is_ok_and(|read| read.quiet && read.command.is_some()));
        assert!(read(&["dalembert", "--seconds", "5", "ledger"]).is_ok_and(|read| read.seconds == Some(5)));
        assert!(read(&["dalembert", "--out", "a.html"]).is_ok_and(|read| read.command.is_none()));
        let refused = read(&["dalembert", "--out", "a.html", "ledger"]).map_err(|error| error.to_string());
        assert!(refused.is_err_and(|why| why.contains("`--out` before `ledger` is an option of the report")));
    }

    #[test]
    fn any_command_line_is_taken_or_refused_with_a_reason() {
        let cases = std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(2000);
        let seed = RngSeed::Fixed(1743);
        let config = ProptestConfig { cases, rng_seed: seed, failure_persistence: None, ..ProptestConfig::default() };
        let word = prop_oneof![9 => prop::sample::select(WORDS).prop_map(str::to_owned), 1 => any::<String>()];
        let outcome = TestRunner::new(config).run(&prop::collection::vec(word, 0..7), |words| {
            if let Err(refused) = Arguments::read(std::iter::once("dalembert".to_owned()).chain(words)) {
                prop_assert!(!refused.to_string().trim().is_empty());
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{error}"));
    }
}
