//! `dalembert run`: integrates a scene with one method.

use crate::arguments::{Format, tolerance, whole};
use crate::exit::{Exit, print, warn};
use crate::output::{self, Form, Provenance, Writes};
use crate::pictures;
use crate::progress::Progress;
use crate::summary::Summary;
use crate::{clock, csv};
use ::scenes::completed_start;
use integrators::{Method, StepHalvingCheck};
use motor::{NoModel, catalogue};
use reader::Family;
use simulation::models::Modelled;
use simulation::run::most_samples;
use simulation::{Axes, Choice, IvpScene, RunNotes, methods};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use studies::AnyScene;
use studies::model_reduction::{Hierarchy, ReducedScene, Simplification, SimplifiedScene};
use studies::scene::Scene;

/// Arguments of `run`. For arguments that are left out, the values of the scene apply.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file; the folder `scenes` holds examples
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Method of integration, such as dormand_prince_8 or runge_kutta_4:20000
    #[arg(long, value_parser = method)]
    pub method: Option<Method>,
    /// Allowed error of each state x in a step: T*|x| + T, in SI units
    #[arg(long = "tol", value_name = "T", value_parser = tolerance, allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
    /// Replaces the motor by another model; its data are computed from the scene. Or a reduced model, as `choose` names it: for a system with
    /// [coordinates] "without P", "rigid P", "quasi-steady X", "fixed X", "equal X=Y", "linear", "unfollowed X" (leaves out the equation of X),
    /// with a parameter P or states X, Y; the handbook's chapter on smaller models explains them
    #[arg(long)]
    pub model: Option<String>,
    /// For gyrostats, the axes of the equations; first: principal axes of the inertia tensor A (rotor's inertia left out); second: principal
    /// axes of A* (rotor's inertia included). Results are in the axes of the data
    #[arg(long)]
    pub form: Option<Axes>,
    /// Writes the trajectory as a table, or as NumPy arrays, with the scene, its hash, the method and the tolerance. Each column has its unit:
    /// time, states, the rotor's speed; for a system with [coordinates] time, states, outputs, energies, work
    #[arg(long, value_name = "FILE.csv|FILE.npz")]
    pub out: Option<PathBuf>,
    /// Writes the transition matrix, the derivatives of the end state with respect to the start state, as a table: a row for each state at the
    /// end, a column for each state at the start
    #[arg(long, value_name = "FILE.csv")]
    pub transition: Option<PathBuf>,
    /// Draws the run on one sheet: its columns against time, each with its unit, quantities that should stay zero (the change of the
    /// energy, the residual of constraints), and speeds over coordinates
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
    /// Replaces the files of --out, --plot and --transition even if `run` did not write them
    #[arg(long)]
    pub force: bool,
    /// Output format of the summary; JSON is one object: time, state, work, invariants, model, method; null for a number that is not
    /// defined
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// Number of instants of the trajectory after the start; the default is `samples` of the scene
    #[arg(long, value_name = "N", value_parser = whole::<u32>(1..=1_000_000))]
    pub samples: Option<u32>,
}

/// The last part of the long help: names of methods and models.
pub fn help() -> String {
    let column = |name: &str, what: &str| format!("  {name:<22} {what}\n");
    let methods: String = methods::list().map(|(name, what)| column(&name, what)).collect();
    let models: String = catalogue::entries().into_iter().map(|entry| column(entry.name, entry.summary)).collect();
    format!("Methods:\n{methods}\n  {SPLITTINGS}\n\nModels of motors, values of --model:\n{models}")
}

fn method(text: &str) -> Result<Method, String> {
    methods::method(text).map_err(|(_, accepted)| accepted)
}

/// Runs the scene, writes the requested files, and prints the summary.
pub fn run(asked: &Args) -> Result<Exit, Exit> {
    if asked.force && asked.out.is_none() && asked.transition.is_none() && asked.plot.is_none() {
        return Err(Exit::refused(
            "--force is about what --out, --plot and --transition replace; it is accepted with one of them",
        ));
    }
    match AnyScene::open(&asked.scene)? {
        AnyScene::Driven(scene) => {
            let (machine, smaller) = machine_and_smaller(asked.model.as_deref());
            let scene = with_model(*scene, machine, &asked.scene)?;
            one_form(&scene, asked.form.is_some(), &asked.scene)?;
            let form = (!scene.on_bench()).then(|| asked.form.unwrap_or_default());
            let Some(name) = smaller else { return follow(&scene, asked, form) };
            without_transition(asked)?;
            let axes: &[Axes] = if scene.on_bench() { &[Axes::First] } else { &[Axes::First, Axes::Second] };
            let ladders = axes.iter().map(|axes| Hierarchy::of_scene(&scene, *axes)).collect();
            let reduced = ReducedScene::of(&scene, ladders, name).map_err(|known| {
                let path = asked.scene.display();
                Exit::refused(format!("{path}: no smaller model is called \"{name}\"; known: {}", known.join(", ")))
            })?;
            follow(&reduced, asked, form)
        }
        AnyScene::Model(scene) => {
            refuse("a system that is written in its file", false, asked.form.is_some(), &asked.scene)?;
            let choice = choice(scene.run(), asked);
            if matches!(choice.method, Method::Split { .. }) {
                return Err(no_pieces(&choice, &asked.scene));
            }
            match asked.model.as_deref() {
                None => follow(&*scene, asked, None),
                Some(name) => {
                    without_transition(asked)?;
                    smaller(&scene, name, asked)
                }
            }
        }
    }
}

/// Runs a reduced model of a system that is defined in its file: one of its hierarchy, or one without some of its elements.
fn smaller(scene: &Arc<dyn Modelled>, name: &str, asked: &Args) -> Result<Exit, Exit> {
    if let Ok(known) = ReducedScene::of(&**scene, vec![Hierarchy::of_model(&**scene)], name) {
        return follow(&known, asked, None);
    }
    let found = Simplification::parse(name).and_then(|simplification| SimplifiedScene::of(scene, &simplification));
    let found = found.map_err(|why| Exit::refused(format!("{}: --model \"{name}\": {why}", asked.scene.display())))?;
    follow(&found, asked, None)
}

/// The model of the motor and the reduced model in a name: `multi_current`, `lumped windings`, or both separated by a semicolon.
fn machine_and_smaller(name: Option<&str>) -> (Option<&str>, Option<&str>) {
    match name.map(|name| (name, name.split_once(';'))) {
        None => (None, None),
        Some((_, Some((machine, smaller)))) => (Some(machine.trim()), Some(smaller.trim())),
        // the name of a model of a motor is one word
        Some((name, None)) if name.trim().contains(' ') => (None, Some(name.trim())),
        Some((name, None)) => (Some(name), None),
    }
}

/// Refuses --transition for a reduced model, which lacks some of the states of the matrix.
fn without_transition(asked: &Args) -> Result<(), Exit> {
    match asked.transition {
        None => Ok(()),
        Some(_) => Err(Exit::refused(
            "--transition is about the states of the scene's own model; leave the smaller --model out, or --transition",
        )),
    }
}

/// Refuses --model and --form for a scene without a motor.
pub fn refuse(what: &str, model: bool, form: bool, path: &Path) -> Result<(), Exit> {
    let given = [("--model", model), ("--form", form)];
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((option, _)) => Err(Exit::refused(format!(
            "{option} does not apply to {}: {what} has no machine, and one form of its equations; leave it out",
            path.display()
        ))),
    }
}

/// Refuses --form for a motor alone, whose equations have only one form.
pub fn one_form(scene: &Scene, form: bool, path: &Path) -> Result<(), Exit> {
    match form && scene.on_bench() {
        false => Ok(()),
        true => Err(Exit::refused(format!(
            "--form does not apply to {}: a motor on a bench has no carrier, and one form of its equations; leave it out",
            path.display()
        ))),
    }
}

/// Runs an initial value problem, writes the requested files, and prints the summary.
fn follow(scene: &dyn IvpScene, asked: &Args, form: Option<Axes>) -> Result<Exit, Exit> {
    let choice = choice(scene.run(), asked);
    if asked.tolerance.is_some() && asked.transition.is_none() && choice.method.steps().is_some() {
        return Err(Exit::refused(format!(
            "--tol does not apply to {}, whose steps are constant; leave it out, or name a method that follows a tolerance",
            choice.method
        )));
    }
    let problem = scene.metered(choice.axes);
    if let Some(why) = problem.outside(0.0, &problem.state) {
        let accepted = "a start from which its law holds is accepted";
        return Err(Exit::refused(format!(
            "{}: the law does not hold at the start: {why}; {accepted}",
            asked.scene.display()
        )));
    }
    let headed = |names: &[String]| names.iter().map(|name| csv::headed(name, &scene.unit(name))).collect::<Vec<_>>();
    let writes = writes(asked);
    let provenance = Provenance::of(writes.maker(), &asked.scene).of_run(&choice);
    let provenance = asked.model.iter().fold(provenance, |told, model| told.with("model", model));
    let provenance = asked.form.iter().fold(provenance, |told, form| told.with("form", form));
    let table = csv::Table::at(&writes, asked.out.as_deref(), &headed(&problem.columns), provenance.clone())?;
    let plot = writes.optional(asked.plot.as_deref(), &[Form::Picture])?;
    if asked.transition.is_some() && scene.hybrid().is_some() {
        let why = "the law of this system changes at events: its transition matrix is not computed yet";
        return Err(Exit::refused(format!("--transition: {why}; leave it out")));
    }
    let states = asked.transition.as_ref().map(|_| scene.problem(choice.axes));
    let states = states.map(|states| headed(&states.columns[..states.state.len().min(states.columns.len())]));
    let matrix =
        csv::Matrix::at(&writes, asked.transition.as_deref(), &states.unwrap_or_default(), provenance.clone())?;
    output::apart(table.output(), matrix.output())?;
    output::apart(table.output(), plot.as_ref())?;
    output::apart(matrix.output(), plot.as_ref())?;

    let (columns, most) = (problem.columns.len(), most_samples(problem.columns.len()));
    if choice.samples > most {
        let option = if asked.samples.is_some() { "--samples" } else { "samples" };
        return Err(Exit::refused(format!(
            "{option} {}: a row of this run has {columns} numbers; a whole number from 1 to {most} is accepted",
            choice.samples
        )));
    }
    let mut progress = Progress::new(scene.title());
    let trajectory = problem.simulate_while(&choice, |fraction| {
        progress.set(fraction);
        clock::goes_on()
    });
    drop(progress);
    let completed = completed_start(&asked.scene);
    let text = |told: &RunNotes, beside: Option<StepHalvingCheck>| {
        let (choice, trajectory, completed) = (&choice, &trajectory, &completed);
        let summary = Summary { scene, choice, form, trajectory, told, beside, completed };
        match asked.format {
            Format::Text => summary.text(),
            Format::Json => summary.json(),
        }
    };

    // files are written before the checks below, which may take longer than the run and may be interrupted
    let table = table.write(&trajectory.times, &trajectory.rows, (trajectory.outcome.time, &trajectory.last));
    let plot = plot
        .map(|plot| plot.write_text(&(provenance.markup() + &pictures::sheet(scene, &trajectory).svg())))
        .transpose();
    clock::publish(text(&RunNotes::default(), None));
    let told = phase("what theory says of the run", || scene.told(&choice, &trajectory));
    clock::publish(text(&told, None));
    let beside =
        phase("the run with half of its step", || problem.check_by_step_halving(&choice, &trajectory, clock::goes_on));
    clock::publish(text(&told, beside));
    // a run with undefined values, or one that left the validity of its law, is not a result
    let spoilt = told.failures.iter().any(|failure| failure.kind.spoils());
    let is_kept = trajectory.undefined().is_empty() && trajectory.lost().is_none() && !spoilt;
    let serves = beside.is_none_or(|beside| beside.verdict.serves()) && is_kept;
    let reached = trajectory.outcome.reached() && trajectory.left.is_none();
    let mut ending = if reached && serves { Exit::Done } else { Exit::Stopped };
    let mut depends = Ok(None);
    if let Some(path) = &asked.transition {
        let not_written = |why: &str| warn(&format!("{} is not written: {why}", path.display()));
        let is_whole = trajectory.outcome.reached() && !trajectory.ends_before(problem.span);
        let passes = choice.through_singular_positions && !trajectory.passages.is_empty();
        let rows = (is_whole && !passes).then(|| {
            let problem = scene.problem(choice.axes);
            phase("the transition matrix", || problem.transition(choice.tolerance))
        });
        match rows {
            None if passes => {
                not_written("the run may pass singular positions, where the linear equations have no solution");
                ending = Exit::Stopped;
            }
            None => not_written("the run did not reach its end"),
            Some(Ok(rows)) => depends = matrix.write(&rows),
            Some(Err(failure)) if failure.is_broken_off() => {
                not_written(failure.name());
                ending = Exit::Stopped;
            }
            Some(Err(failure)) => depends = Err(Exit::refused(format!("{}: {failure}", path.display()))),
        }
    }
    print(&text(&told, beside))?;
    // the summary is printed even if a file cannot be written
    for written in [table?, plot?, depends?].into_iter().flatten() {
        written.tell(asked.format)?;
    }
    Ok(ending)
}

/// The refusal of a splitting method for a law without sub-flows.
fn no_pieces(choice: &Choice, path: &Path) -> Exit {
    let others = methods::list().map(|(name, _)| name).filter(|name| {
        let numbered = name.replace("STEPS", "1");
        !matches!(methods::method(&numbered), Ok(Method::Split { .. }))
    });
    Exit::refused(format!(
        "{} does not apply to {}: {SPLITTINGS}; accepted are {}",
        methods::written(choice.method),
        path.display(),
        others.collect::<Vec<_>>().join(", ")
    ))
}

/// A sentence on the scenes to which splitting methods apply.
const SPLITTINGS: &str = "splittings (strang, blanes_moan_4, blanes_moan_6, kahan_li_8) apply to gyrostats and motors whose law has pieces \
                          with known flows, and not to a system that is written in its file";

/// Runs a part of a command that may take long, with a progress bar.
fn phase<T>(label: &str, work: impl FnOnce() -> T) -> T {
    let _progress = Progress::new(label);
    work()
}

/// The files that `run` may write and replace.
pub fn writes(asked: &Args) -> Writes<'_> {
    Writes { command: "run", force: asked.force, reads: vec![&asked.scene] }
}

/// The scene with the requested model of the motor; unchanged without a request.
///
/// # Errors
/// The model is unknown, or the scene lacks data for it.
pub fn with_model(scene: Scene, model: Option<&str>, path: &Path) -> Result<Scene, Exit> {
    let Some(model) = model else { return Ok(scene) };
    scene.with_model(model).map_err(|error| {
        let made = match error {
            NoModel::Missing { .. } => format!("; it suffices for {}", scene.given.models().join(", ")),
            _ => String::new(),
        };
        Exit::refused(format!("{}: {error}{made}", path.display()))
    })
}

/// The settings of the scene, replaced by those of the command line where given.
fn choice(own: &simulation::Run, asked: &Args) -> Choice {
    let own = own.choice();
    Choice {
        method: asked.method.unwrap_or(own.method),
        tolerance: asked.tolerance.unwrap_or(own.tolerance),
        axes: asked.form.unwrap_or_default(),
        samples: asked.samples.map_or(own.samples, |samples| samples as usize),
        allowed: clock::left(),
        through_singular_positions: own.through_singular_positions,
    }
}
