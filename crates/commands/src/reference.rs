//! `dalembert reference`: a scene's solution to all digits that two methods share, kept in a file.

use crate::arguments::Format;
use crate::clock;
use crate::exit::{Exit, print};
use crate::output::{Form, Output, Writes};
use clap::Args;
use integrators::{ENOUGH_DIGITS, Method};
use reader::Family;
use simulation::references::Event;
use simulation::references::Owner;
use simulation::work_precision::Hybrid;
use simulation::{Axes, Choice, Stored, references};
use std::fmt::Write;
use std::path::PathBuf;
use studies::AnyScene;

/// Arguments of `reference`.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The file of the reference; the default is `references/SCENE.reference` in the scene's folder, where charts look for it
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replaces the file even where `reference` did not write what stands there
    #[arg(long)]
    pub force: bool,
    /// An earlier end than that of the scene, s, for a scene whose motion ends
    #[arg(long, value_name = "T")]
    pub until: Option<f64>,
}

/// Computes the reference, prints it, and writes it where charts and the report look for it. Another computer may give a digit more
/// or less: an existing reference is replaced by a better one only.
pub fn reference(asked: &Asked) -> Result<Exit, Exit> {
    let scene = AnyScene::open(&asked.scene)?;
    let smooth = scene.smooth();
    if let Some(hybrid) = smooth.hybrid() {
        return across_events(hybrid, smooth.title(), asked);
    }
    let mut problem = smooth.problem(Axes::default());
    if let Some(end) = asked.until {
        if !(end > 0.0 && end <= problem.span) {
            return Err(Exit::refused(format!(
                "--until {end}: a time above 0 and up to {} s is accepted",
                problem.span
            )));
        }
        problem.span = end;
    }
    let output = output(asked)?;
    let run = problem.simulate(&following(smooth.run().choice()), |_| ());
    if run.left.is_some() || run.ends_before(problem.span) {
        let told = || smooth.told(&smooth.run().choice(), &run).diagnosis.unwrap_or_default();
        let (why, last) = (run.stopped().unwrap_or_else(told), run.outcome.time);
        let accepted = format!("--until with a time up to {last} s is accepted");
        return Err(Exit::refused(format!("{}: {why}; {accepted}", asked.scene.display())));
    }
    match problem.reference(clock::left()) {
        Ok(found) => {
            let [one, other] = found.methods;
            let enough = lacking(found.is_trusted());
            print(&format!("{}\n{one} and {other} share {:.1} digits{enough}\n", smooth.title(), found.digits))?;
            if !found.is_trusted() {
                return Ok(Exit::Stopped);
            }
            keep(output, &problem, &Stored::of(&problem, found, Vec::new()), asked)
        }
        Err(failure) => {
            clock::keeps_nothing();
            print(&format!("{}\nno reference: {failure}\n", smooth.title()))?;
            Ok(Exit::Stopped)
        }
    }
}

/// The end of the sentence about too few digits.
fn lacking(is_trusted: bool) -> String {
    if is_trusted { String::new() } else { format!(": no reference, which needs {ENOUGH_DIGITS}") }
}

/// The destination of the reference, checked before the work.
fn output(asked: &Asked) -> Result<Output, Exit> {
    let writes = Writes { command: "reference", force: asked.force, reads: vec![&asked.scene] };
    writes.output(&place(asked), &[Form::Reference])
}

/// The path of the reference.
fn place(asked: &Asked) -> PathBuf {
    asked.out.clone().unwrap_or_else(|| references::place(&asked.scene))
}

/// Computes the reference of a motion across events, and prints these too.
fn across_events(scene: &dyn Hybrid, title: &str, asked: &Asked) -> Result<Exit, Exit> {
    if asked.until.is_some() {
        return Err(Exit::refused(format!(
            "{} has a law that changes at events, which its own run determines: it is followed to its end, and --until is not accepted",
            asked.scene.display()
        )));
    }
    let output = output(asked)?;
    let found = match scene.exact(clock::left()) {
        Ok(found) => found,
        Err(unknown) => {
            clock::keeps_nothing();
            print(&format!("{title}\nno reference: {unknown}\n"))?;
            return Ok(Exit::Stopped);
        }
    };
    let ([one, other], digits) = (found.reference.methods, found.reference.digits);
    let enough = lacking(found.reference.is_trusted());
    let mut text = format!("{title}\n{one} and {other} share {digits:.1} digits{enough}\n");
    for event @ Event { what, regime, .. } in &found.events {
        // writing to a string cannot fail
        let _ = writeln!(text, "t = {} s  {what}", event.instant(digits.max(0.0) as usize));
        if !regime.is_empty() {
            let _ = writeln!(text, "    -> {regime}");
        }
    }
    print(&text)?;
    if !found.reference.is_trusted() {
        return Ok(Exit::Stopped);
    }
    let owner = scene.owner();
    keep(output, &*owner, &Stored::of(&*owner, found.reference, found.events), asked)
}

/// The method that searches for the end of a law: constant steps may leave the law's domain where the motion does not.
pub fn following(own: Choice) -> Choice {
    match own.method.steps() {
        None => own,
        Some(_) => Choice { method: Method::RadauIIA { stages: 5 }, tolerance: 1e-9, ..own },
    }
}

/// Writes a reference, unless one of the same motion exists on which the methods agree to as many digits.
fn keep(output: Output, owner: &dyn Owner, made: &Stored, asked: &Asked) -> Result<Exit, Exit> {
    let path = place(asked);
    // reading a pipe would wait for a writer
    let there = path.is_file().then(|| std::fs::read_to_string(&path).ok()).flatten();
    let there = there.and_then(|text| Stored::read(&text).ok());
    let of_this = |there: &Stored| there.reference.times == made.reference.times && there.belongs_to(owner);
    match there.filter(of_this).map(|there| there.reference.digits) {
        Some(digits) if digits >= made.reference.digits && !asked.force => {
            print(&format!("{} is kept: its methods share {digits:.1} digits\n", path.display()))?;
        }
        _ => {
            // the command as it is given, so that it makes the file again
            let until = asked.until.map_or_else(String::new, |until| format!(" --until {until}"));
            output.write_text(&made.write(&format!("{}{until}", asked.scene.display())))?.tell(Format::Text)?;
        }
    }
    Ok(Exit::Done)
}
