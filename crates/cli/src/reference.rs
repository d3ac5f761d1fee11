//! `dalembert reference`: a scene's solution to all digits that two methods share, kept in a file.

use crate::arguments::Reference;
use crate::ending::{Ending, print, save};
use derivations::scene::{AnyScene, Axes, Family, Stored, stored};
use std::time::Duration;

/// Computes it, says what it is, and writes it where charts and the report look for it.
pub fn reference(asked: &Reference) -> Result<Ending, Ending> {
    let scene = AnyScene::open(&asked.scene)?;
    let Some(smooth) = scene.smooth() else {
        return Err(Ending::refused(format!(
            "{} has rough contacts, so that its motion is many problems; a scene of a system with a motor or of a mechanism \
             is accepted",
            asked.scene.display()
        )));
    };
    let mut problem = smooth.problem(Axes::default());
    if let Some(end) = asked.until {
        if !(end > 0.0 && end <= problem.span) {
            return Err(Ending::refused(format!(
                "--until {end}: a time above 0 and up to {} s is accepted",
                problem.span
            )));
        }
        problem.span = end;
    }
    match problem.reference(Duration::from_secs(asked.seconds.into())) {
        Ok(found) => {
            let [one, other] = found.methods;
            print(&format!("{}\n{one} and {other} share {:.1} digits\n", smooth.title(), found.digits))?;
            if !found.is_trusted() {
                return Ok(Ending::Stopped);
            }
            let scene = asked.scene.display().to_string();
            let path = asked.out.clone().unwrap_or_else(|| stored::place(&asked.scene));
            save(&path, &Stored::of(&problem, found).write(&scene))?;
            Ok(Ending::Done)
        }
        Err(failure) => {
            print(&format!("{}\nno reference: {failure}\n", smooth.title()))?;
            Ok(Ending::Stopped)
        }
    }
}
