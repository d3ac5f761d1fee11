//! A motor with a law of its own, known to every scene that this program reads.
//!
//! It turns a fan, in step with the field: the load angle g settles where U'(g) is the torque of air and bearings.

mod salient_pole;

use scenes::ModelScene;
use simulation::Smooth;
use std::process::ExitCode;

fn main() -> ExitCode {
    let scene = match ModelScene::parse("fan.toml", include_str!("../fan.toml")) {
        Ok(scene) => scene,
        Err(faults) => {
            eprintln!("{faults}");
            return ExitCode::FAILURE;
        }
    };
    let choice = scene.run().choice();
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    if let Some(stopped) = trajectory.stopped() {
        eprintln!("{stopped}");
        return ExitCode::FAILURE;
    }
    for (name, value) in trajectory.names.iter().zip(&trajectory.last) {
        println!("{name:16} {value:.9}");
    }
    ExitCode::SUCCESS
}
