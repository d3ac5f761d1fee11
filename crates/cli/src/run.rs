//! `dalembert run`: one scene, one method.

use crate::arguments::{Format, Run};
use crate::csv;
use crate::ending::{Ending, print};
use crate::progress::Progress;
use crate::rough;
use crate::summary::Summary;
use derivations::scene::{AnyScene, Choice, NoModel, Scene};
use std::path::Path;
use std::time::Duration;

/// Runs the scene, writes the trajectory where one is asked for, prints the summary.
pub fn run(asked: &Run) -> Result<Ending, Ending> {
    let scene = match AnyScene::open(&asked.scene)? {
        AnyScene::Driven(scene) => *scene,
        AnyScene::Rough(scene) => return rough::run(&scene, asked),
    };
    let scene = with_model(scene, asked.model.as_deref(), &asked.scene)?;
    let choice = choice(&scene, asked);
    let table = csv::Table::open(asked.out.as_deref())?;

    let mut progress = Progress::new(&scene.title);
    let trajectory = scene.simulate(&choice, |fraction| progress.set(fraction));
    drop(progress);

    table.write(&trajectory.names, &trajectory.times, &trajectory.rows)?;
    let summary = Summary { scene: &scene, choice: &choice, trajectory: &trajectory };
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
fn choice(scene: &Scene, asked: &Run) -> Choice {
    let own = scene.choice();
    Choice {
        method: asked.method.unwrap_or(own.method),
        tolerance: asked.tolerance.unwrap_or(own.tolerance),
        axes: asked.form.unwrap_or_default(),
        samples: asked.samples.map_or(own.samples, |samples| samples as usize),
        allowed: Duration::from_secs(asked.seconds.into()),
    }
}
