//! This project's part in the comparison with other tools, started by `run.py`: it loads one scene and prints one line
//! per measurement.
//!
//! `cargo bench --bench peers -- SCENE.toml [--model NAME] [--code FOLDER]` writes the scene's code into the folder and
//! prints the reference solution. It then answers requests: `METHOD TOLERANCE` by the nanoseconds of a run (median of
//! several) and its final state; `METHOD in double-double TOLERANCE` by those of a run in double-double arithmetic;
//! `setup`, `rates`, `jacobian`, `num-dual` by nanoseconds; `operations` by the numbers of additions and
//! multiplications in the right-hand side and in its Jacobian, not counting sine and cosine; `peak` by the largest
//! number of these operations per nanosecond on this processor.

use dalembert_derivations::studies::AnyScene;
use field::{DoubleDouble, Over};
use integrators::{Dual8, Jacobian, Ode, Outcome, Real, Span, System, Tolerance, integrate, integrate_in, reference};
use reader::Family;
use scenes::ModelScene;
use simulation::{Axes, Problem, TracedOde, methods, traced};
use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::io::{self, BufRead, Write};
use std::path::Path;
use std::time::{Duration, Instant};
use symbolic::{Language, Sym, Tape};

#[path = "../peak/mod.rs"]
mod peak;
mod residual;

const AXES: Axes = Axes::Second;
const CALLS: u32 = 20_000;
/// The greatest number of repetitions of a run; fewer if a time limit is reached.
const RUNS: usize = 25;
const PATIENCE: Duration = Duration::from_millis(10);

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let after = |flag: &str| arguments.iter().skip_while(|each| *each != flag).nth(1);
    let Some(path) = arguments.iter().find(|argument| argument.ends_with(".toml")) else {
        println!("a scene is needed: cargo bench --bench peers -- benches/peers/six_bars.toml");
        return Ok(());
    };
    scenes::register(|_| ());
    let mut scene = AnyScene::open(Path::new(path)).map_err(|error| error.render(false))?;
    if let (Some(model), AnyScene::Driven(driven)) = (after("--model"), &mut scene) {
        **driven = driven.clone().with_model(model).map_err(|error| error.to_string())?;
    }
    let code = Exported::of(&scene)?;
    if let Some(folder) = after("--code") {
        code.write(Path::new(folder))?;
        if let AnyScene::Model(_) = &scene
            && let Ok(read) = ModelScene::parse(path, &fs::read_to_string(path)?)
            && let Some(text) = residual::header(&read.model)
        {
            fs::write(Path::new(folder).join("dae.h"), format!("#include <math.h>\n\n{text}"))?;
        }
    }
    let begin = Instant::now();
    let problem = problem(&scene);
    let law: &dyn System = &*problem.law;
    black_box(law.jacobian_fn().is_some());
    let setup = begin.elapsed().as_nanos();
    let span = Span::new(0.0, problem.span, &problem.state);
    let exact = reference(law, &span)?;
    let lifted: Vec<DoubleDouble> = problem.state.iter().map(|y| DoubleDouble::lift(*y)).collect();
    let finer = Span::new(0.0, problem.span, &lifted);
    // for the other tools time is a component of the state
    let row = |state: &mut dyn Iterator<Item = f64>, time: f64| {
        let time = code.knows_time.then_some(time);
        state.chain(time).map(|y| format!("{y:?}")).collect::<Vec<_>>().join(" ")
    };
    println!("{:.1} {:?}", exact.digits, span.end);
    println!("{}", row(&mut exact.states.iter().flatten().map(|y| y.hi()), span.end));
    println!("{}", row(&mut exact.sizes.iter().copied(), span.end));
    println!("{}", row(&mut problem.state.iter().copied(), 0.0));
    for line in io::stdin().lock().lines() {
        let line = line?;
        match line.rsplit_once(' ') {
            Some((name, tolerance)) => {
                let plain = name.strip_suffix(" in double-double");
                let method = methods::method(plain.unwrap_or(name));
                let method = method.map_err(|(wrong, accepted)| format!("{wrong}; {accepted}"))?;
                let tolerance = Tolerance::both(tolerance.parse()?);
                let (took, state) = if plain.is_some() {
                    repeated(|| integrate_in(law, method, &tolerance, &finer, &mut ()))
                } else {
                    repeated(|| integrate(law, method, &tolerance, &span, &mut ()))
                };
                let ended = if state.is_empty() { String::new() } else { row(&mut state.into_iter(), span.end) };
                println!("{took} {ended}");
            }
            None if line == "setup" => println!("{setup}"),
            None if line == "operations" => {
                println!("{} {}", code.rates.flops(), code.jacobian.flops());
            }
            None if line == "peak" => println!("{}", peak::flops_per_nanosecond()),
            None => println!("{}", evaluations(law, &problem.state, &line)?),
        }
        io::stdout().flush()?;
    }
    Ok(())
}

/// The median time of several runs in nanoseconds, and their final state; empty if the runs do not reach the end.
fn repeated<S: Real>(run: impl Fn() -> Outcome<S>) -> (u128, Vec<f64>) {
    let clocked = || {
        let begin = Instant::now();
        let outcome = run();
        (begin.elapsed().as_nanos(), outcome)
    };
    let begin = Instant::now();
    let (first, outcome) = clocked();
    let mut times = vec![first];
    while times.len() < RUNS && begin.elapsed() < PATIENCE {
        times.push(clocked().0);
    }
    times.sort_unstable();
    let state = if outcome.reached() { outcome.state.iter().map(|y| y.approx()).collect() } else { Vec::new() };
    (times[times.len() / 2], state)
}

/// The problem of a scene: for a gyrostat in the axes in which its law is shortest, otherwise as written in the file.
fn problem(scene: &AnyScene) -> Problem {
    match scene {
        AnyScene::Driven(driven) => driven.problem(AXES),
        AnyScene::Model(model) => model.problem(Axes::First),
    }
}

/// The right-hand side and its Jacobian, for the other tools.
struct Exported {
    rates: Tape,
    jacobian: Tape,
    /// Whether the law depends on time, which is then the last component of the state.
    knows_time: bool,
}

impl Exported {
    fn of(scene: &AnyScene) -> Result<Self, Box<dyn Error>> {
        Ok(match scene {
            AnyScene::Driven(driven) => {
                let (rates, jacobian) = (driven.tape(AXES)?, driven.jacobian_tape(AXES)?);
                Exported { rates, jacobian, knows_time: false }
            }
            AnyScene::Model(model) => traced(&*model.symbolic_law(), |TracedOde { state, time, rates }| {
                let knows_time = rates.iter().any(|rate| rate.symbols_of().contains(time));
                let clock = |one: Sym| knows_time.then_some(one);
                let state: Vec<Sym> = state.iter().copied().chain(clock(*time)).collect();
                let rates: Vec<Sym> = rates.iter().copied().chain(clock(Sym::ONE)).collect();
                let slopes: Vec<Sym> = rates.iter().flat_map(|rate| state.iter().map(|&by| rate.diff(by))).collect();
                let (rates, jacobian) = (Tape::record(&state, &rates)?, Tape::record(&state, &slopes)?);
                Ok::<_, symbolic::Untapeable>(Exported { rates, jacobian, knows_time })
            })?,
        })
    }

    /// Writes the code, and the rounding errors of its constants.
    fn write(&self, folder: &Path) -> Result<(), Box<dyn Error>> {
        let Exported { rates, jacobian, .. } = self;
        let both = |language| format!("{}\n{}", rates.source(language, "rates"), jacobian.source(language, "jacobian"));
        fs::write(folder.join("rates.h"), format!("#include <math.h>\n\n{}", both(Language::C)))?;
        fs::write(
            folder.join("exported.py"),
            format!("from math import cos, sin, sqrt\n\n\n{}", both(Language::Python)),
        )?;
        let lost = rates.constants::<DoubleDouble>().into_iter().map(|c| format!("{:?} {:?}\n", c.hi(), c.lo()));
        fs::write(folder.join("lost.txt"), lost.collect::<String>())?;
        Ok(())
    }
}

/// Nanoseconds per evaluation; each evaluation depends on the one before.
fn evaluations(law: &dyn System, start: &[f64], what: &str) -> Result<f64, String> {
    let n = start.len();
    let (mut y, mut rates, mut matrix) = (start.to_vec(), vec![0.0; n], vec![0.0; n * n]);
    let dual: &dyn Ode<Dual8> = law;
    let mut jacobian = match what {
        "rates" | "jacobian" => Jacobian::of(law),
        "num-dual" => Jacobian::new(dual),
        _ => {
            return Err(format!(
                "`{what}` is not known: setup, rates, jacobian, num-dual, operations, peak, or a method and a tolerance"
            ));
        }
    };
    let begin = Instant::now();
    for _ in 0..CALLS {
        if what == "rates" {
            Ode::<f64>::rates(law, 0.0, &y, &mut rates);
            y[0] = start[0] + 1e-15 * rates[0];
        } else {
            jacobian.matrix(0.0, &y, &mut matrix);
            y[0] = start[0] + 1e-15 * matrix[1];
        }
    }
    Ok(begin.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS))
}
