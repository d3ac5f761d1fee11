//! `dalembert reference`: computes the solution of a scene to the digits on which two methods agree, and keeps it in a file.

use crate::arguments::Format;
use crate::clock;
use crate::exit::{Exit, print};
use crate::output::{Form, Output, Writes};
use field::DoubleDouble;
use integrators::{ENOUGH_DIGITS, Method, Reference};
use reader::Family;
use serde_json::{Value, json};
use simulation::references::{Event, Exact, Owner};
use simulation::{Axes, Choice, IvpScene, Problem, Stored, references};
use std::fmt::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use studies::AnyScene;

/// Arguments of `reference`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The file of the reference; the default is `references/SCENE.reference` in the scene's folder, where charts search for it
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Replaces the file even if `reference` did not write it
    #[arg(long)]
    pub force: bool,
    /// The end in seconds, earlier than that of the scene, for a scene whose motion ends before its span
    #[arg(long, value_name = "T")]
    pub until: Option<f64>,
}

/// Computes the reference, prints it, and writes it to the file where charts and the report look for it. Since another computer may obtain a digit
/// more or less, an existing reference is replaced only by one with more digits.
pub fn reference(asked: &Args) -> Result<Exit, Exit> {
    let scene = AnyScene::open(&asked.scene)?;
    let smooth = scene.smooth();
    let mut problem = smooth.problem(Axes::default());
    match (asked.until, smooth.hybrid()) {
        (None, _) => {}
        (Some(_), Some(_)) => {
            return Err(Exit::refused(format!(
                "{} has a law that changes at events, which its own run determines: it is followed to its end, and --until is not accepted",
                asked.scene.display()
            )));
        }
        (Some(end), None) if end > 0.0 && end <= problem.span => problem.span = end,
        (Some(end), None) => {
            return Err(Exit::refused(format!(
                "--until {end}: a time above 0 and up to {} s is accepted",
                problem.span
            )));
        }
    }
    let writes = Writes { command: "reference", force: asked.force, reads: vec![&asked.scene] };
    let output = writes.output(&place(asked), &[Form::Reference])?;
    let found = match found(smooth, &problem, clock::left()) {
        Ok(found) => found,
        Err(Unknown::EndsBefore { why, last }) => {
            let accepted = format!("--until with a time up to {last} s is accepted");
            return Err(Exit::refused(format!("{}: {why}; {accepted}", asked.scene.display())));
        }
        Err(Unknown::Other(why)) => {
            clock::keeps_nothing();
            print(&format!("{}\nno reference: {why}\n", smooth.title()))?;
            return Ok(Exit::Stopped);
        }
    };
    print(&text(smooth.title(), &found))?;
    let Exact { reference, events } = found;
    match smooth.hybrid() {
        _ if !reference.is_trusted() => Ok(Exit::Stopped),
        None => keep(output, &problem, &Stored::of(&problem, reference, events), asked),
        Some(hybrid) => {
            let owner = hybrid.owner();
            keep(output, &*owner, &Stored::of(&*owner, reference, events), asked)
        }
    }
}

/// A reference as text, and as a JSON object in which numbers are texts with all digits.
#[derive(Debug)]
pub struct ReferenceResult {
    pub text: String,
    pub object: Value,
}

/// The motion of a scene to the digits on which two methods agree; `allowed` limits the time of the computation.
///
/// # Errors
/// The reason for which the motion is not known to enough digits, as a sentence.
pub fn reference_solution(scene: &dyn IvpScene, allowed: Duration) -> Result<ReferenceResult, String> {
    let problem = scene.problem(Axes::default());
    let found = found(scene, &problem, allowed).map_err(|unknown| match unknown {
        Unknown::EndsBefore { why, last } => format!("{why}; a `span` up to {last} s is accepted"),
        Unknown::Other(why) => format!("no reference: {why}"),
    })?;
    let text = text(scene.title(), &found);
    if !found.reference.is_trusted() {
        return Err(text.lines().last().unwrap_or_default().to_owned());
    }
    let Exact { reference, events } = found;
    let Reference { times, states, digits, sizes, methods: [one, other], .. } = &reference;
    let row = |state: &[DoubleDouble]| -> Vec<String> {
        state.iter().zip(sizes).map(|(number, size)| references::decimals(*number, *size, *digits)).collect()
    };
    let names = &problem.columns[..problem.state.len()];
    let event = |event: &Event| {
        let time = references::decimals(event.time, event.time.hi(), *digits);
        json!({ "time": time, "what": event.what, "regime": event.regime, "state": row(&event.state) })
    };
    let object = json!({
        "title": scene.title(),
        "digits": digits,
        "methods": [one.to_string(), other.to_string()],
        "names": names,
        "units": names.iter().map(|name| scene.unit(name)).collect::<Vec<_>>(),
        "sizes": sizes,
        "times": times,
        "states": states.iter().map(|state| row(state)).collect::<Vec<_>>(),
        "events": events.iter().map(event).collect::<Vec<_>>(),
    });
    Ok(ReferenceResult { text, object })
}

/// The reason for which a motion is not known to enough digits.
enum Unknown {
    /// The motion ends before its span; the last accepted span is `last`, s.
    EndsBefore {
        why: String,
        last: f64,
    },
    Other(String),
}

/// The motion as two methods compute it, including its events.
fn found(scene: &dyn IvpScene, problem: &Problem, allowed: Duration) -> Result<Exact, Unknown> {
    if let Some(hybrid) = scene.hybrid() {
        return hybrid.exact(allowed).map_err(|why| Unknown::Other(why.to_string()));
    }
    let begun = Instant::now();
    let choice = scene.run().choice();
    let run = problem.simulate(&following(choice), |_| ());
    if run.left.is_some() || run.ends_before(problem.span) {
        let told = || scene.told(&choice, &run).diagnosis.unwrap_or_default();
        return Err(Unknown::EndsBefore { why: run.stopped().unwrap_or_else(told), last: run.outcome.time });
    }
    let reference = problem.reference(allowed.saturating_sub(begun.elapsed()));
    let reference = reference.map_err(|failure| Unknown::Other(failure.to_string()))?;
    Ok(Exact { reference, events: Vec::new() })
}

/// The methods with the number of digits on which they agree, and the events.
fn text(title: &str, Exact { reference, events }: &Exact) -> String {
    let ([one, other], digits) = (reference.methods, reference.digits);
    let enough = match reference.is_trusted() {
        true => String::new(),
        false => format!(": no reference, which needs {ENOUGH_DIGITS}"),
    };
    let mut text = format!("{title}\n{one} and {other} agree to {digits:.1} digits{enough}\n");
    for event @ Event { what, regime, .. } in events {
        // writing to a string cannot fail
        let _ = writeln!(text, "t = {} s  {what}", event.instant(digits.max(0.0) as usize));
        if !regime.is_empty() {
            let _ = writeln!(text, "    -> {regime}");
        }
    }
    text
}

/// The path of the file of the reference.
fn place(asked: &Args) -> PathBuf {
    asked.out.clone().unwrap_or_else(|| references::place(&asked.scene))
}

/// The method for a run that determines where the motion ends. A method with constant steps is replaced, since it may leave the domain of the law
/// where the motion does not.
pub fn following(own: Choice) -> Choice {
    // a reference requires a motion that the equations determine uniquely
    let own = Choice { through_singular_positions: false, ..own };
    match own.method.steps() {
        None => own,
        Some(_) => Choice { method: Method::RadauIIA { stages: 5 }, tolerance: 1e-9, ..own },
    }
}

/// Writes a reference, unless the file contains one of the same motion with at least as many digits.
fn keep(output: Output, owner: &dyn Owner, made: &Stored, asked: &Args) -> Result<Exit, Exit> {
    let path = place(asked);
    // opening a pipe would wait for a writer
    let there = path.is_file().then(|| std::fs::read_to_string(&path).ok()).flatten();
    let there = there.and_then(|text| Stored::read(&text).ok());
    let of_this = |there: &Stored| there.reference.times == made.reference.times && there.belongs_to(owner);
    match there.filter(of_this).map(|there| there.reference.digits) {
        Some(digits) if digits >= made.reference.digits && !asked.force => {
            print(&format!("{} is kept: its methods agree to {digits:.1} digits\n", path.display()))?;
        }
        _ => {
            // the comment contains the command that makes this file again
            let until = asked.until.map_or_else(String::new, |until| format!(" --until {until}"));
            output.write_text(&made.write(&format!("{}{until}", asked.scene.display())))?.tell(Format::Text)?;
        }
    }
    Ok(Exit::Done)
}
