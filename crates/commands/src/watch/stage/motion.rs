//! The stage that runs a scene.

use super::system::entry;
use super::{Broken, sketch};
use crate::clock;
use crate::pictures;
use crate::summary::Summary;
use crate::watch::told::Told;
use ::scenes::ModelScene;
use charts::page::live::{self, Part};
use reader::Family;
use simulation::models::holds_model;
use simulation::run::most_samples;
use simulation::{Axes, Choice, IvpScene, Trajectory};
use std::path::Path;
use studies::AnyScene;

/// Reports the sketch of the scene; if its text has a run, runs it and reports charts and summary.
pub(super) fn tell(path: &Path, text: &str) -> Result<(), Broken> {
    let name = path.display().to_string();
    if holds_model(text) {
        sketch::tell_still(path, text)?;
        if entry(text, "run", |_| ()).is_none() {
            return Ok(Told::part(Part::Motion, String::new()).write()?);
        }
        let scene = ModelScene::parse(&name, text)?;
        let run = tell_run(&scene, None, text)?;
        let moving = sketch::along(&scene, &run).map(|moving| Told::part(Part::Sketch, moving));
        return Ok(moving.map_or(Ok(()), |moving| moving.write())?);
    }
    let any = AnyScene::parse(&name, text)?;
    let form = matches!(&any, AnyScene::Driven(scene) if !scene.on_bench()).then_some(Axes::First);
    tell_run(any.smooth(), form, text)?;
    Ok(Told::part(Part::Sketch, String::new()).write()?)
}

fn tell_run(scene: &dyn IvpScene, form: Option<Axes>, text: &str) -> Result<Trajectory, Broken> {
    let own = scene.run().choice();
    let choice = Choice { allowed: clock::left(), ..own };
    let problem = scene.metered(choice.axes);
    if let Some(why) = problem.outside(0.0, &problem.state) {
        return Err(Broken::Refused(format!("the law does not hold at the start: {why}")));
    }
    let most = most_samples(problem.columns.len());
    if choice.samples > most {
        let columns = problem.columns.len();
        return Err(Broken::Refused(format!(
            "samples {}: a row of this run has {columns} numbers; a whole number from 1 to {most} is accepted",
            choice.samples
        )));
    }
    let run = problem.simulate_while(&choice, |_| clock::goes_on());
    let told = scene.told(&choice, &run);
    let completed = ::scenes::completed_start_of(text);
    let summary =
        Summary { scene, choice: &choice, form, trajectory: &run, told: &told, beside: None, completed: &completed };
    let sheet = pictures::sheet(scene, &run);
    Told::part(Part::Motion, live::motion(&sheet, &summary.text())).write()?;
    Ok(run)
}
