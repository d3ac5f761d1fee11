//! `dalembert chart`: speed against accuracy of one scene.

use crate::arguments::{Axis, Chart};
use crate::ending::{Ending, print, save};
use crate::pictures::{self, reason};
use crate::report;
use crate::run::with_model;
use derivations::scene::{Measured, Scene, Trials};
use std::fmt::Write;
use std::path::Path;
use std::time::Duration;

/// Measures every method, prints the table, draws the chart where one is asked for.
pub fn chart(asked: &Chart) -> Result<Ending, Ending> {
    let scene = Scene::open(&asked.scene)?;
    let scene = with_model(scene, asked.model.as_deref(), &asked.scene)?;
    let allowed = Duration::from_secs(asked.seconds.into());
    let trials = Trials { allowed, ..Trials::default() };
    match scene.measure(asked.form, &trials) {
        Ok(measured) => {
            print(&table(&scene, &measured))?;
            if let Some(path) = &asked.out {
                save(path, &drawn(&scene, &measured, asked, path))?;
            }
            Ok(Ending::Done)
        }
        Err(failure) => {
            print(&format!("{}\n\nno reference: {failure}\n", scene.title))?;
            Ok(Ending::Stopped)
        }
    }
}

/// A page where the file's name asks for one, else one picture.
fn drawn(scene: &Scene, measured: &Measured, asked: &Chart, path: &Path) -> String {
    let [counted, timed] = pictures::work_precision(scene, measured);
    if path.extension().is_some_and(|extension| extension == "html" || extension == "htm") {
        return report::of_scene(scene, vec![counted, timed], pictures::measured_by(scene, measured));
    }
    let mut chart = match asked.x {
        Axis::Evaluations => counted,
        Axis::Time => timed,
    };
    chart.title = scene.title.clone();
    chart.svg()
}

/// A line for each run, method by method.
fn table(scene: &Scene, measured: &Measured) -> String {
    let reference = &measured.reference;
    let mut text = format!(
        "{}\n\nreference: {} and {} agree to {:.1} digits\n\n",
        scene.title, reference.methods[0], reference.methods[1], reference.digits
    );
    let dimension = scene.names().len() as u64;
    let mut points: Vec<_> = measured.points.iter().collect();
    // stable: the tolerances of a method, and its numbers of steps, stay in their order
    points.sort_by_key(|point| pictures::family(point.method));
    // writing to a string cannot fail
    let _ =
        writeln!(text, "{:<28} {:>9} {:>12} {:>11} {:>12}", "method", "tolerance", "evaluations", "time, ms", "error");
    for point in points {
        let tolerance = point.tolerance.map_or_else(String::new, |tolerance| format!("{tolerance:.0e}"));
        let time = point.time.map_or_else(String::new, |time| format!("{:.3}", time.seconds * 1e3));
        let error =
            point.error.as_ref().map_or_else(|failure| reason(failure).to_owned(), |error| format!("{error:.1e}"));
        let evaluations = pictures::evaluations(point, dimension);
        let method = point.method.to_string();
        let _ = writeln!(text, "{method:<28} {tolerance:>9} {evaluations:>12} {time:>11} {error:>12}");
    }
    text
}
