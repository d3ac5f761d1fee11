//! `dalembert run`: one scene, one method.

use crate::arguments::{Format, Run};
use crate::csv;
use crate::ending::{Ending, print};
use crate::progress::Progress;
use crate::regimes;
use crate::summary::Summary;
use derivations::scene::{AnyScene, Choice, NoModel, Scene};
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::time::Duration;

/// Runs the scene, writes the trajectory where one is asked for, prints the summary.
pub fn run(asked: &Run) -> Result<Ending, Ending> {
    let scene = match AnyScene::open(&asked.scene)? {
        AnyScene::Driven(scene) => *scene,
        AnyScene::Rough(scene) => return regimes::run(&scene, asked),
    };
    let scene = with_model(scene, asked.model.as_deref(), &asked.scene)?;
    let choice = choice(&scene, asked);
    // before the work, so that a wrong name does not cost it
    let table = match &asked.out {
        Some(path) => Some((path, File::create(path).map_err(|error| Ending::unwritable(path, &error))?)),
        None => None,
    };

    let mut progress = Progress::new(&scene.title);
    let trajectory = scene.simulate(&choice, |fraction| progress.set(fraction));
    drop(progress);

    if let Some((path, file)) = table {
        csv::write(&trajectory, &mut BufWriter::new(file)).map_err(|error| Ending::unwritable(path, &error))?;
    }
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
        axes: asked.form,
        samples: asked.samples.map_or(own.samples, |samples| samples as usize),
        allowed: Duration::from_secs(asked.seconds.into()),
    }
}
