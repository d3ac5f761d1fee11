//! `dalembert chart`: speed against accuracy of one scene.

use crate::arguments::{Axis, Chart};
use crate::ending::{Ending, print, save};
use crate::pictures::{self, reason};
use crate::report;
use crate::run::{refuse, with_model};
use derivations::scene::{AnyScene, Family, Measured, Smooth, Trials};
use std::fmt::Write;
use std::path::Path;
use std::time::Duration;

/// Measures every method, prints the table, draws the chart where one is asked for.
pub fn chart(asked: &Chart) -> Result<Ending, Ending> {
    let scene = match AnyScene::open(&asked.scene)? {
        AnyScene::Driven(scene) => {
            AnyScene::Driven(Box::new(with_model(*scene, asked.model.as_deref(), &asked.scene)?))
        }
        other => other,
    };
    let Some(smooth) = scene.smooth() else {
        return Err(Ending::refused(format!(
            "{} has rough contacts, and its errors would be those of its events; a scene of a system with a motor or of a \
             mechanism is accepted",
            asked.scene.display()
        )));
    };
    if matches!(scene, AnyScene::Mechanism(_)) {
        refuse("a mechanism", asked.model.is_some(), asked.form.is_some(), &asked.scene)?;
    }
    let allowed = Duration::from_secs(asked.seconds.into());
    let trials = Trials { allowed, ..Trials::default() }.with(smooth.run().method);
    let problem = smooth.problem(asked.form.unwrap_or_default());
    match problem.measure(&trials) {
        Ok(measured) => {
            print(&table(smooth, &measured))?;
            if let Some(path) = &asked.out {
                save(path, &drawn(smooth, &measured, asked, path))?;
            }
            Ok(Ending::Done)
        }
        Err(failure) => {
            let run = problem.simulate(&smooth.run().choice(), |_| ());
            let diagnosis = smooth.told(&smooth.run().choice(), &run).diagnosis;
            let diagnosis = diagnosis.map_or_else(String::new, |diagnosis| format!("{diagnosis}\n"));
            print(&format!("{}\n\nno reference: {failure}\n{diagnosis}", smooth.title()))?;
            Ok(Ending::Stopped)
        }
    }
}

/// A page where the file's name asks for one, else one picture.
fn drawn(scene: &dyn Smooth, measured: &Measured, asked: &Chart, path: &Path) -> String {
    let [counted, timed] = pictures::work_precision(measured);
    if path.extension().is_some_and(|extension| extension == "html" || extension == "htm") {
        return report::of_scene(scene, vec![counted, timed], pictures::measured_by(measured));
    }
    let mut chart = match asked.x {
        Axis::Evaluations => counted,
        Axis::Time => timed,
    };
    chart.title = scene.title().to_owned();
    chart.svg()
}

/// A line for each run, method by method.
fn table(scene: &dyn Smooth, measured: &Measured) -> String {
    let reference = &measured.reference;
    let mut text = format!(
        "{}\n\nreference: {} and {} agree to {:.1} digits\n\n",
        scene.title(),
        reference.methods[0],
        reference.methods[1],
        reference.digits
    );
    let states = reference.sizes.len() as u64;
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
        let evaluations = pictures::evaluations(point, states);
        let method = point.method.to_string();
        let _ = writeln!(text, "{method:<28} {tolerance:>9} {evaluations:>12} {time:>11} {error:>12}");
    }
    text
}
