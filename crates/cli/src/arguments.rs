//! What can be asked on the command line.

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use derivations::machines::AnyMachine;
use derivations::scene::{Axes, methods, run::check_tolerance};
use integrators::Method;
use std::path::PathBuf;

/// Derives, proves and runs equations of motion.
///
/// Without a command: the main job. Every paper's statements are judged, every scene is run and charted, and one page
/// is written that needs nothing else to be read.
///
/// Exit codes: 0 all is well; 1 a run stopped before its end; 2 the input is not acceptable.
#[derive(Debug, Parser)]
#[command(name = "dalembert", version, args_conflicts_with_subcommands = true)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Option<Command>,
    #[command(flatten)]
    pub report: Report,
    /// Results and errors only: no progress, no names of files that were written
    #[arg(long, short, global = true)]
    pub quiet: bool,
}

/// The main job, where no command is given.
#[derive(Args, Debug)]
pub struct Report {
    /// Where the scene files are
    #[arg(long, value_name = "FOLDER", default_value = "scenes")]
    pub scenes: PathBuf,
    /// The page
    #[arg(long, value_name = "FILE.html", default_value = "report/index.html")]
    pub out: PathBuf,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Runs a scene and prints its last state, the work done and the invariants
    #[command(after_long_help = run_help())]
    Run(Run),
    /// Measures every method on a scene: speed against accuracy
    Chart(Chart),
    /// The smallest model, and the cheapest method for it, that meet a tolerance in the outputs that matter
    Choose(Choose),
    /// A scene's solution to the digits that two methods share, and the file that keeps it
    Reference(Reference),
    /// Runs many members of a scene whose table `ensemble` says what varies; a run that was killed is continued
    Ensemble(Ensemble),
    /// Every claim of the papers with its verdict
    Ledger(Ledger),
    /// What changed in the reviewed pages: which term of which equation, what it means, which claims and runs moved
    Review(Review),
    /// Equations of motion by a chosen principle
    Derive(Derive),
    /// What the bodies of a scene come to: both inertia tensors, principal axes, centre of mass, weight
    Bodies(Bodies),
    /// All stationary motions of a scene's gyrostat with its motor, and why none is missing
    Stationary(Stationary),
    /// For which steps each method tells a scene's stationary motions stable or unstable as they are, and for which not
    Phantom(Phantom),
    /// A synchronous motor under load: pull-out, pull-in, what lies between, and which starts come into step
    Motor(Motor),
    /// Every consistent regime of a scene with rough contacts at its start, with all margins
    Regimes(Regimes),
    /// Every way in which methods fail: theory's threshold beside the measured one, what survives, advice
    Failures(Failures),
    /// Lists the scenes of a folder, each with its title
    Scenes(Scenes),
    /// A script that completes commands and options in a shell: `dalembert completions bash > FILE`
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// Whose regimes are to be found.
#[derive(Args, Debug)]
pub struct Regimes {
    /// The scene, a TOML file; the folder `scenes/friction` holds examples
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Which scenes are to be listed.
#[derive(Args, Debug)]
pub struct Scenes {
    /// Where the scene files are
    #[arg(default_value = "scenes")]
    pub folder: PathBuf,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Which claims are to be listed.
#[derive(Args, Debug)]
pub struct Ledger {
    /// Claims whose id contains this, such as konosevich2022/eq5.3 or statement3
    #[arg(default_value = "")]
    pub filter: String,
    /// Claims with this verdict only: refuted, undefined, undecided, proved, enclosed, tested, definition, open
    #[arg(long)]
    pub verdict: Option<String>,
    /// Text is a page as the tests lock it; JSON has one object a claim: id, paper, equation, verdict, statement,
    /// requires, counterexample, correction
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// What the pages are compared with.
#[derive(Args, Debug)]
pub struct Review {
    /// The commit to compare with; pages that wait for a review, `.snap.new`, are compared with those that stand
    #[arg(long, value_name = "COMMIT", default_value = "HEAD")]
    pub against: String,
    /// How to print the changes
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Whose bodies are to be looked at.
#[derive(Args, Debug)]
pub struct Bodies {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Which stationary motions are to be found.
#[derive(Args, Debug)]
pub struct Stationary {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Those with this angular velocity about the vertical, rad/s
    #[arg(long, value_name = "W", value_parser = finite, allow_negative_numbers = true, conflicts_with_all = ["momentum", "cone"])]
    pub omega0: Option<f64>,
    /// Those with this angular momentum about the vertical, N m s; without any of the three, that of the scene's start
    #[arg(long, value_name = "P", value_parser = finite, allow_negative_numbers = true, conflicts_with = "cone")]
    pub momentum: Option<f64>,
    /// How many there are for every angular velocity, and where two merge
    #[arg(long)]
    pub cone: bool,
    /// Another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Whose motions methods are to be judged on.
#[derive(Args, Debug)]
pub struct Phantom {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The angular velocity of the motions about the vertical, rad/s
    #[arg(long, value_name = "W", value_parser = finite, allow_negative_numbers = true, default_value_t = 0.0)]
    pub omega0: f64,
    /// Another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// How to print it; JSON is one object: scene, model, omega0, motions
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Whose motor is to be loaded.
#[derive(Args, Debug)]
pub struct Motor {
    /// The scene, a TOML file with a synchronous motor, on a bench or in a gyrostat
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// How to print it
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Which ways to fail are to be measured.
#[derive(Args, Debug)]
pub struct Failures {
    /// Those whose name contains this, such as windings or pull-out
    #[arg(default_value = "")]
    pub name: String,
    /// Where the scene files are
    #[arg(long, value_name = "FOLDER", default_value = "scenes")]
    pub scenes: PathBuf,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// What is to be derived, and how.
#[derive(Args, Debug)]
pub struct Derive {
    /// The system: gyrostat, motor; or a scene, SCENE.toml, whose right-hand side and Jacobian are written as code
    #[arg(value_name = "SYSTEM|SCENE.toml")]
    pub system: String,
    /// The principle; without it the first that applies
    #[arg(long, value_enum)]
    pub principle: Option<PrincipleName>,
    /// How to print the equations: text, LaTeX and MathML for a system; SymPy, C, Python and Rust for a system or a scene
    #[arg(long, value_enum)]
    pub format: Option<Equations>,
    /// For a scene: the equations in the axes of A (first) or of A* (second)
    #[arg(long, default_value_t)]
    pub form: Axes,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum PrincipleName {
    /// Angular momentum of the mass points
    Momentum,
    /// Appell, from the acceleration energy
    Appell,
    /// Boltzmann and Hamel, in quasi-velocities
    Hamel,
    /// Lagrange of the second kind, in Euler's angles
    Lagrange,
    /// Lagrange and Maxwell, for motors
    Maxwell,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Equations {
    /// For reading
    Text,
    Latex,
    /// One element for each equation
    Mathml,
    /// Equations over symbols of their own; of a scene the rates and the Jacobian over the symbols of its states
    Sympy,
    /// Straight-line code, every common part once; of a system the left sides less the right ones
    C,
    Python,
    Rust,
}

/// How a scene is to be run; what is left out, the scene says.
#[derive(Args, Debug)]
pub struct Run {
    /// The scene, a TOML file; the folder `scenes` holds examples
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Method of integration, such as dormand_prince_8 or runge_kutta_4:20000
    #[arg(long, value_parser = method)]
    pub method: Option<Method>,
    /// Error allowed in a step, relative, and absolute in SI units
    #[arg(long = "tol", value_name = "T", value_parser = tolerance)]
    pub tolerance: Option<f64>,
    /// Another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// The equations in the axes of A (first) or of A* (second); results are in the axes of the data either way
    #[arg(long)]
    pub form: Option<Axes>,
    /// Writes the trajectory as a table: time, states, rotor's speed; of a mechanism time, states, work and what follows
    /// from them; with rough contacts time, coordinates, velocities, works
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Writes how the end depends on the start as a table: a row for each state at the end, a column for each at the start
    #[arg(long, value_name = "FILE.csv")]
    pub transition: Option<PathBuf>,
    /// How to print the summary; JSON is one object: time, state, work, invariants, model, method
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// Instants of the trajectory beside its start
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub samples: Option<u32>,
    /// Stops a run that takes longer, and keeps what there is
    #[arg(long, default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub seconds: u32,
}

/// Which members are to be run, and where the results go.
#[derive(Args, Debug)]
pub struct Ensemble {
    /// The scene with a table `ensemble`; the folder `scenes/ensembles` holds an example
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The table of results, a row for each member; one that is there is continued. Without it: the scene's name, here
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Threads; without it as many as there are processors. The results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

/// Whose solution is to be known to all digits.
#[derive(Args, Debug)]
pub struct Reference {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Where it is kept; without it where charts look for it: `references/SCENE.reference` in the scene's folder
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Ends sooner than the scene, s: for one whose motion ends
    #[arg(long, value_name = "T")]
    pub until: Option<f64>,
    /// Time allowed
    #[arg(long, default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub seconds: u32,
}

/// What is to be met, and in what.
#[derive(Args, Debug)]
pub struct Choose {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Largest error allowed, relative to the size of each output
    #[arg(long = "tol", value_name = "T", value_parser = tolerance, default_value = "1e-6")]
    pub tolerance: f64,
    /// What matters, by the names of a run's columns; without it the outputs of the scene
    #[arg(long, value_name = "A,B", value_delimiter = ',')]
    pub outputs: Vec<String>,
    /// The model that is taken for exact: another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// Draws error against the cost of every model
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
    /// How to print the receipt
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// Time allowed for taking times, and again for where to switch between models
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=3600))]
    pub seconds: u32,
}

/// What is to be measured and drawn.
#[derive(Args, Debug)]
pub struct Chart {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Draws the chart: one picture as .svg, or a page with both as .html; or writes every run as a table, .csv
    #[arg(long, value_name = "FILE.svg|FILE.html|FILE.csv")]
    pub out: Option<PathBuf>,
    /// How to print the results: text is for reading, JSON has one object for every run
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// What the work of a picture is counted in
    #[arg(long, value_enum, default_value_t)]
    pub x: Axis,
    /// Another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// The equations in the axes of A (first) or of A* (second)
    #[arg(long)]
    pub form: Option<Axes>,
    /// Time allowed for the reference, and again for the measurements
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=3600))]
    pub seconds: u32,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Axis {
    /// An integer, the same on every computer
    #[default]
    Evaluations,
    /// A ratio to the fastest run
    Time,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Format {
    /// For reading
    #[default]
    Text,
    /// For programs
    Json,
}

fn method(text: &str) -> Result<Method, String> {
    methods::method(text).map_err(|(_, accepted)| accepted)
}

fn finite(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|value: &f64| value.is_finite())
        .ok_or_else(|| "a finite number such as 6.5 is accepted".to_owned())
}

fn tolerance(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number such as 1e-8 is accepted".to_owned())?;
    check_tolerance(value).map_err(|wrong| format!("{wrong}; from 1e-14 to below 1 is accepted"))?;
    Ok(value)
}

fn run_help() -> String {
    let column = |name: &str, what: &str| format!("  {name:<22} {what}\n");
    let methods: String = methods::list().map(|(name, what)| column(&name, what)).collect();
    let models: String = AnyMachine::LIST.iter().map(|(name, what)| column(name, what)).collect();
    format!("Methods:\n{methods}\nModels:\n{models}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::{RngSeed, TestRunner};

    /// What stands on command lines, and what does not.
    const WORDS: &[&str] = &[
        "run",
        "chart",
        "reference",
        "ensemble",
        "ledger",
        "derive",
        "bodies",
        "stationary",
        "motor",
        "regimes",
        "scenes",
        "completions",
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
    fn any_command_line_is_taken_or_refused_with_a_reason() {
        let cases = std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(2000);
        let seed = RngSeed::Fixed(1743);
        let config = ProptestConfig { cases, rng_seed: seed, failure_persistence: None, ..ProptestConfig::default() };
        let word = prop_oneof![9 => prop::sample::select(WORDS).prop_map(str::to_owned), 1 => any::<String>()];
        let outcome = TestRunner::new(config).run(&prop::collection::vec(word, 0..7), |words| {
            if let Err(refused) = Arguments::try_parse_from(std::iter::once("dalembert".to_owned()).chain(words)) {
                prop_assert!(!refused.to_string().trim().is_empty());
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{error}"));
    }
}
