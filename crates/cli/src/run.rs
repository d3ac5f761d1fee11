//! `dalembert run`: one scene, one method.

use crate::arguments::{Format, Run};
use crate::csv;
use crate::ending::{Ending, print};
use crate::progress::Progress;
use crate::rough;
use crate::summary::Summary;
use derivations::scene::{AnyScene, Axes, Choice, Family, NoModel, Scene, Smooth};
use std::path::Path;
use std::time::Duration;

/// Runs the scene, writes the trajectory where one is asked for, prints the summary.
pub fn run(asked: &Run) -> Result<Ending, Ending> {
    match AnyScene::open(&asked.scene)? {
        AnyScene::Rough(_) if asked.transition.is_some() => Err(Ending::refused(format!(
            "--transition does not apply to {}: across stick and slip the end has no derivative by the start",
            asked.scene.display()
        ))),
        AnyScene::Rough(scene) => rough::run(&scene, asked),
        AnyScene::Driven(scene) => {
            let scene = with_model(*scene, asked.model.as_deref(), &asked.scene)?;
            follow(&scene, asked, Some(asked.form.unwrap_or_default()))
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

/// Runs one initial value problem.
fn follow(scene: &dyn Smooth, asked: &Run, form: Option<Axes>) -> Result<Ending, Ending> {
    let choice = choice(scene.run(), asked);
    let table = csv::Table::open(asked.out.as_deref())?;
    let matrix = csv::Table::open(asked.transition.as_deref())?;

    let mut progress = Progress::new(scene.title());
    let problem = scene.problem(choice.axes);
    let trajectory = problem.simulate(&choice, |fraction| progress.set(fraction));
    drop(progress);

    table.write(&trajectory.names, &trajectory.times, &trajectory.rows)?;
    if let Some(path) = &asked.transition
        && trajectory.outcome.reached()
    {
        let rows = problem.transition(choice.tolerance);
        let rows = rows.map_err(|failure| Ending::refused(format!("{}: {failure}", path.display())))?;
        matrix.write_matrix(&problem.columns[..rows.len()], &rows)?;
    }
    let told = scene.told(&choice, &trajectory);
    let summary = Summary { scene, choice: &choice, form, trajectory: &trajectory, told: &told };
    print(&match asked.format {
        Format::Text => summary.text(),
        Format::Json => summary.json(),
    })?;
    Ok(if trajectory.outcome.reached() { Ending::Done } else { Ending::Stopped })
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
fn choice(own: &derivations::scene::Run, asked: &Run) -> Choice {
    let own = own.choice();
    Choice {
        method: asked.method.unwrap_or(own.method),
        tolerance: asked.tolerance.unwrap_or(own.tolerance),
        axes: asked.form.unwrap_or_default(),
        samples: asked.samples.map_or(own.samples, |samples| samples as usize),
        allowed: Duration::from_secs(asked.seconds.into()),
    }
}
