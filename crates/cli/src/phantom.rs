//! `dalembert phantom`: for which steps a method's map says of a stationary motion what is true.

use crate::arguments::Phantom as Asked;
use crate::ending::{Ending, print};
use crate::run::with_model;
use derivations::phantom::chart::Chart;
use derivations::phantom::splittings::SplitRuns;
use derivations::phantom::survey::steps;
use derivations::scene::{Family, Scene};
use integrators::Splitting;

/// Prints it.
pub fn show(asked: &Asked) -> Result<Ending, Ending> {
    let scene = with_model(Scene::open(&asked.scene)?, asked.model.as_deref(), &asked.scene)?;
    let chart = Chart::of(&scene, asked.omega0)
        .map_err(|reason| Ending::refused(format!("{}: {reason}", asked.scene.display())))?;
    let turning = match scene.on_bench() {
        true => String::new(),
        false => format!("angular velocity about the vertical: {} rad/s\n", asked.omega0),
    };
    let mut text = chart.text();
    for (place, motion) in chart.all.motions.iter().enumerate() {
        let near = SplitRuns::near(&scene, motion);
        text += &format!("\n{} {motion}\n", place + 1);
        for splitting in Splitting::ALL {
            text += &format!("  {:<20} {}\n", splitting.name(), near.course(splitting, &steps()).told());
        }
    }
    print(&format!("{}\n{turning}{text}", scene.title))?;
    let known = chart.rows.iter().all(|rows| !rows.is_empty() && rows.iter().all(|row| row.steps.is_some()));
    Ok(if known { Ending::Done } else { Ending::Stopped })
}
