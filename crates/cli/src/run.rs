//! `dalembert run`: one scene, one method.

use crate::arguments::{Format, tolerance, whole};
use crate::csv;
use crate::ending::{Ending, print, warn};
use crate::interrupt::Interrupt;
use crate::output::{self, Writes};
use crate::progress::Progress;
use crate::rough;
use crate::summary::Summary;
use clap::Args;
use derivations::machines::AnyMachine;
use derivations::scene::{AnyScene, Axes, Choice, Family, NoModel, Scene, Smooth, methods};
use integrators::Method;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How a scene is to be run; what is left out, the scene says.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene, a TOML file; the folder `scenes` holds examples
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Method of integration, such as dormand_prince_8 or runge_kutta_4:20000
    #[arg(long, value_parser = method)]
    pub method: Option<Method>,
    /// Error allowed in a step, relative, and absolute in SI units
    #[arg(long = "tol", value_name = "T", value_parser = tolerance, allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
    /// Another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// The equations in the axes of A (first) or of A* (second); results are in the axes of the data either way
    #[arg(long)]
    pub form: Option<Axes>,
    /// Writes the trajectory as a table, each column with its unit: time, states, rotor's speed; of a mechanism time, states, work
    /// and what follows from them; with rough contacts time, coordinates, velocities, works
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Writes how the end depends on the start as a table: a row for each state at the end, a column for each at the start
    #[arg(long, value_name = "FILE.csv")]
    pub transition: Option<PathBuf>,
    /// Replaces the files of --out and --transition even where `run` did not write what stands there
    #[arg(long)]
    pub force: bool,
    /// How to print the summary; JSON is one object: time, state, work, invariants, model, method
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// Instants of the trajectory beside its start
    #[arg(long, value_name = "N", value_parser = whole::<u32>(1..=1_000_000))]
    pub samples: Option<u32>,
    /// Stops a run that takes longer, and keeps what there is
    #[arg(long, default_value_t = 300, value_parser = whole::<u32>(1..=86_400))]
    pub seconds: u32,
}

/// What the long help adds: names of methods and models.
pub fn help() -> String {
    let column = |name: &str, what: &str| format!("  {name:<22} {what}\n");
    let methods: String = methods::list().map(|(name, what)| column(&name, what)).collect();
    let models: String = AnyMachine::LIST.iter().map(|(name, what)| column(name, what)).collect();
    format!("Methods:\n{methods}\nModels:\n{models}")
}

fn method(text: &str) -> Result<Method, String> {
    methods::method(text).map_err(|(_, accepted)| accepted)
}

/// Runs the scene, writes the trajectory where one is asked for, prints the summary.
pub fn run(asked: &Asked) -> Result<Ending, Ending> {
    if asked.force && asked.out.is_none() && asked.transition.is_none() {
        return Err(Ending::refused(
            "--force is about what --out and --transition replace; it is accepted with one of them",
        ));
    }
    match AnyScene::open(&asked.scene)? {
        AnyScene::Rough(_) if asked.transition.is_some() => Err(Ending::refused(format!(
            "--transition does not apply to {}: across stick and slip the end has no derivative by the start",
            asked.scene.display()
        ))),
        AnyScene::Rough(scene) => rough::run(&scene, asked),
        AnyScene::Driven(scene) => {
            let scene = with_model(*scene, asked.model.as_deref(), &asked.scene)?;
            one_form(&scene, asked.form.is_some(), &asked.scene)?;
            follow(&scene, asked, (!scene.on_bench()).then(|| asked.form.unwrap_or_default()))
        }
        AnyScene::Mechanism(scene) => {
            refuse("a mechanism", asked.model.is_some(), asked.form.is_some(), &asked.scene)?;
            follow(&*scene, asked, None)
        }
    }
}

/// Machines and forms are for systems with a motor.
pub fn refuse(what: &str, model: bool, form: bool, path: &Path) -> Result<(), Ending> {
    let given = [("--model", model), ("--form", form)];
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((option, _)) => Err(Ending::refused(format!(
            "{option} does not apply to {}: {what} has no machine, and one form of its equations; leave it out",
            path.display()
        ))),
    }
}

/// A motor alone has one form of its equations.
pub fn one_form(scene: &Scene, form: bool, path: &Path) -> Result<(), Ending> {
    match form && scene.on_bench() {
        false => Ok(()),
        true => Err(Ending::refused(format!(
            "--form does not apply to {}: a motor on a bench has no carrier, and one form of its equations; leave it out",
            path.display()
        ))),
    }
}

/// Runs one initial value problem.
fn follow(scene: &dyn Smooth, asked: &Asked, form: Option<Axes>) -> Result<Ending, Ending> {
    let choice = choice(scene.run(), asked);
    if asked.tolerance.is_some() && asked.transition.is_none() && choice.method.steps().is_some() {
        return Err(Ending::refused(format!(
            "--tol does not apply to {}, whose steps are constant; leave it out, or name a method that follows a tolerance",
            choice.method
        )));
    }
    let problem = scene.metered(choice.axes);
    let headed = |names: &[String]| names.iter().map(|name| csv::headed(name, &scene.unit(name))).collect::<Vec<_>>();
    let writes = writes(asked);
    let table = csv::Table::at(&writes, asked.out.as_deref(), &headed(&problem.columns))?;
    let states = asked.transition.as_ref().map(|_| scene.problem(choice.axes));
    let states = states.map(|states| headed(&states.columns[..states.state.len().min(states.columns.len())]));
    let matrix = csv::Matrix::at(&writes, asked.transition.as_deref(), &states.unwrap_or_default())?;
    output::apart(table.output(), matrix.output())?;

    let mut progress = Progress::new(scene.title());
    let interrupt = Interrupt::watched();
    let trajectory = problem.simulate_while(&choice, |fraction| {
        progress.set(fraction);
        interrupt.goes_on()
    });
    let beside = problem.beside(&choice, &trajectory, || interrupt.goes_on());
    drop(progress);

    let table = table.write(&trajectory.times, &trajectory.rows);
    let mut depends = Ok(None);
    if let Some(path) = &asked.transition {
        if trajectory.outcome.reached() {
            let rows = scene.problem(choice.axes).transition(choice.tolerance);
            let rows = rows.map_err(|failure| Ending::refused(format!("{}: {failure}", path.display())));
            depends = rows.and_then(|rows| matrix.write(&rows));
        } else {
            warn(&format!("{} is not written: the run did not reach its end", path.display()));
        }
    }
    let told = scene.told(&choice, &trajectory);
    let summary = Summary { scene, choice: &choice, form, trajectory: &trajectory, told: &told, beside };
    print(&match asked.format {
        Format::Text => summary.text(),
        Format::Json => summary.json(),
    })?;
    // what was computed is told in any case
    for written in [table?, depends?].into_iter().flatten() {
        written.tell(asked.format)?;
    }
    Ok(match () {
        () if trajectory.outcome.reached() => Ending::Done,
        () if trajectory.broken_off() => Ending::Interrupted,
        () => Ending::Stopped,
    })
}

/// What a run may write.
pub fn writes(asked: &Asked) -> Writes<'_> {
    Writes { command: "run", force: asked.force, reads: vec![&asked.scene] }
}

/// The scene with the machine that is asked for, where one is.
pub fn with_model(scene: Scene, model: Option<&str>, path: &Path) -> Result<Scene, Ending> {
    let Some(model) = model else { return Ok(scene) };
    scene.with_model(model).map_err(|error| {
        let made = match error {
            NoModel::Missing { .. } => format!("; it suffices for {}", scene.machine_data.ladder().join(", ")),
            _ => String::new(),
        };
        Ending::refused(format!("{}: {error}{made}", path.display()))
    })
}

/// The scene's own choices, but for those that are made on the command line.
fn choice(own: &derivations::scene::Run, asked: &Asked) -> Choice {
    let own = own.choice();
    Choice {
        method: asked.method.unwrap_or(own.method),
        tolerance: asked.tolerance.unwrap_or(own.tolerance),
        axes: asked.form.unwrap_or_default(),
        samples: asked.samples.map_or(own.samples, |samples| samples as usize),
        allowed: Duration::from_secs(asked.seconds.into()),
    }
}
