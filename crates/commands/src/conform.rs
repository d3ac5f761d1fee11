//! `dalembert conform`: checks of the physical laws that every motor and every system should obey.

use crate::arguments::Format;
use crate::exit::{Exit, print};
use ::scenes::{Task, read_titled};
use claims::finding::{Finding, PropertyVerdict};
use motor::{NoModel, catalogue, text};
use reader::{Family, read_text};
use serde_json::{Value, json};
use simulation::models::holds_model;
use std::path::Path;
use studies::conformance::{conform, page, sample};
use studies::scene::Scene;

/// Arguments of `conform`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A motor by its name, with the data of a small motor; or a scene, a TOML file, with a built-in motor, or with a motor or system
    /// written in the file
    #[arg(value_name = "MACHINE|SCENE.toml")]
    pub motor: String,
    /// Replaces the motor by another model; its data are computed from the scene
    #[arg(long)]
    pub model: Option<String>,
    /// Output format; JSON is one object: motor, checks, each with check, verdict, says (a sentence)
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Prints every check with its verdict.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    let path = Path::new(&asked.motor);
    let is_system = || read_text(path).is_ok_and(|text| holds_model(&text));
    let (title, findings) = if asked.motor.ends_with(".toml") && is_system() {
        if asked.model.is_some() {
            let why = "--model does not apply to a system that is written in its file; it is accepted with a gyrostat or a bench";
            return Err(Exit::refused(why.to_owned()));
        }
        let (title, model) = read_titled(path, Task::Write)?;
        (title, ::scenes::conformance::conform(&model))
    } else if asked.motor.ends_with(".toml") {
        let scene = Scene::open(Path::new(&asked.motor))?;
        let scene = match &asked.model {
            None => scene,
            Some(model) => scene.with_model(model).map_err(Exit::refused)?,
        };
        (format!("{}: {}", scene.machine.name(), scene.title), conform(&scene.machine))
    } else {
        if asked.model.is_some() {
            return Err(Exit::refused(format!(
                "--model does not apply to `{}`, which is a machine by its name; it is accepted with a scene",
                asked.motor
            )));
        }
        let unknown = || match asked.motor.as_str() {
            text::NAME => Exit::refused(NoModel::NoLaws),
            name => Exit::refused(NoModel::Unknown { name: name.to_owned() }),
        };
        let machine = sample(&asked.motor).ok_or_else(unknown)?;
        let summary = catalogue::entry(machine.name()).map_or("", |entry| entry.summary);
        (format!("{}: {summary}", machine.name()), conform(&machine))
    };
    print(&match asked.format {
        Format::Text => page(&title, &findings),
        Format::Json => format!("{:#}\n", object(&title, &findings)),
    })?;
    // an undecided property counts as a failure
    let open = |finding: &Finding| matches!(finding.verdict, PropertyVerdict::Fails(_) | PropertyVerdict::Undecided(_));
    Ok(if findings.iter().any(open) { Exit::Stopped } else { Exit::Done })
}

fn object(title: &str, findings: &[Finding]) -> Value {
    let checks = findings
        .iter()
        .map(|Finding { check, verdict }| json!({ "check": check, "verdict": verdict.name(), "says": verdict.says() }));
    json!({ "motor": title, "checks": checks.collect::<Vec<_>>() })
}
