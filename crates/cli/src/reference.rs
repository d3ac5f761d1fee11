//! `dalembert reference`: a scene's solution to all digits that two methods share, kept in a file.

use crate::arguments::{Format, whole};
use crate::ending::{Ending, print};
use crate::output::{Form, Output, Writes};
use clap::Args;
use derivations::friction::RoughScene;
use derivations::friction::exact::{Event, Regimes};
use derivations::scene::{AnyScene, Axes, Family, Smooth, Stored, stored};
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;

/// Whose solution is to be known to all digits.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Where it is kept; without it where charts look for it: `references/SCENE.reference` in the scene's folder
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replaces the file even where `reference` did not write what stands there
    #[arg(long)]
    pub force: bool,
    /// Ends sooner than the scene, s: for one whose motion ends
    #[arg(long, value_name = "T")]
    pub until: Option<f64>,
    /// Time allowed
    #[arg(long, default_value_t = 300, value_parser = whole::<u32>(1..=86_400))]
    pub seconds: u32,
}

/// Computes it, says what it is, and writes it where charts and the report look for it.
pub fn reference(asked: &Asked) -> Result<Ending, Ending> {
    let scene = AnyScene::open(&asked.scene)?;
    let smooth: &dyn Smooth = match &scene {
        AnyScene::Rough(rough) => return across_events(rough, asked),
        AnyScene::Driven(scene) => &**scene,
        AnyScene::Mechanism(scene) => &**scene,
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
    let output = output(asked)?;
    let run = problem.simulate(&smooth.run().choice(), |_| ());
    if run.left.is_some() {
        let (why, last) = (run.stopped().unwrap_or_default(), run.outcome.time);
        let accepted = format!("--until with a time up to {last} s is accepted");
        return Err(Ending::refused(format!("{}: {why}; {accepted}", asked.scene.display())));
    }
    match problem.reference(Duration::from_secs(asked.seconds.into())) {
        Ok(found) => {
            let [one, other] = found.methods;
            print(&format!("{}\n{one} and {other} share {:.1} digits\n", smooth.title(), found.digits))?;
            if !found.is_trusted() {
                return Ok(Ending::Stopped);
            }
            let scene = asked.scene.display().to_string();
            output.write_text(&Stored::of(&problem, found, Vec::new()).write(&scene))?.tell(Format::Text)?;
            Ok(Ending::Done)
        }
        Err(failure) => {
            print(&format!("{}\nno reference: {failure}\n", smooth.title()))?;
            Ok(Ending::Stopped)
        }
    }
}

/// Where it is kept, before the work.
fn output(asked: &Asked) -> Result<Output, Ending> {
    let writes = Writes { command: "reference", force: asked.force, reads: vec![&asked.scene] };
    let path = asked.out.clone().unwrap_or_else(|| stored::place(&asked.scene));
    writes.output(&path, &[Form::Reference])
}

/// The same of a motion with rough contacts, with its events.
fn across_events(scene: &RoughScene, asked: &Asked) -> Result<Ending, Ending> {
    if asked.until.is_some() {
        return Err(Ending::refused(format!(
            "{} has rough contacts, whose regimes its own run tells: it is followed to its end, and --until is not accepted",
            asked.scene.display()
        )));
    }
    let output = output(asked)?;
    let found = match scene.exact(Duration::from_secs(asked.seconds.into())) {
        Ok(found) => found,
        Err(unknown) => {
            print(&format!("{}\nno reference: {unknown}\n", scene.title))?;
            return Ok(Ending::Stopped);
        }
    };
    let ([one, other], digits) = (found.reference.methods, found.reference.digits);
    let mut text = format!("{}\n{one} and {other} share {digits:.1} digits\n", scene.title);
    for event @ Event { what, regime, .. } in &found.events {
        // writing to a string cannot fail
        let _ = writeln!(text, "t = {} s  {what}", event.instant(digits.max(0.0) as usize));
        if !regime.is_empty() {
            let _ = writeln!(text, "    -> {regime}");
        }
    }
    print(&text)?;
    if !found.reference.is_trusted() {
        return Ok(Ending::Stopped);
    }
    let kept = Stored::of(&Regimes::of(scene), found.reference, found.events);
    output.write_text(&kept.write(&asked.scene.display().to_string()))?.tell(Format::Text)?;
    Ok(Ending::Done)
}
