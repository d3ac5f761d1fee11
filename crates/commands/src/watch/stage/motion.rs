//! The run of a scene.

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

/// Runs the scene as its text says, and tells its charts and its summary.
pub(super) fn tell(path: &Path, text: &str) -> Result<(), Broken> {
    let name = path.display().to_string();
    match holds_model(text) {
        true => {
            let scene = ModelScene::parse(&name, text)?;
            tell_run(&scene, None, text, |run| sketch::along(&scene, run))
        }
        false => {
            let any = AnyScene::parse(&name, text)?;
            let form = matches!(&any, AnyScene::Driven(scene) if !scene.on_bench()).then_some(Axes::First);
            tell_run(any.smooth(), form, text, |_| String::new())
        }
    }
}

fn tell_run(
    scene: &dyn IvpScene,
    form: Option<Axes>,
    text: &str,
    sketched: impl FnOnce(&Trajectory) -> String,
) -> Result<(), Broken> {
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
    Ok(Told::part(Part::Sketch, sketched(&run)).write()?)
}
