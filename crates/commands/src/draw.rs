//! `dalembert draw`: a sketch of a system, drawn from its model: still, or animated along a run.

use crate::clock;
use crate::exit::{Exit, placed, print, warn};
use crate::output::{Form, Format, Provenance, Writes};
use crate::progress::Progress;
use crate::sketch::{Interval, Motion, followed, most_pictures, sketch};
use ::scenes::geometry::{Figure, Geometry};
use ::scenes::{ModelScene, SystemText, Task, start_of};
use charts::Sketch;
use model::Model;
use reader::Issue;
use simulation::{Choice, IvpScene};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Arguments of `draw`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file with points, bodies or frames; values of parameters are those of the file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The file of the picture; the default is standard output
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
    /// Replaces the file of --out even if `draw` did not write it
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Animates the motion of a run as a loop, without a script: the whole run, or its beginning if the whole run needs more than
    /// 300 pictures
    #[arg(long, conflicts_with = "time")]
    pub animate: bool,
    /// The part of the run that --animate shows, in seconds
    #[arg(long, value_name = "FROM..TO", value_parser = span, requires = "animate", allow_hyphen_values = true)]
    pub span: Option<Interval>,
    /// The instant of a run that is drawn, in seconds; the default is the start
    #[arg(long, value_name = "S", value_parser = instant, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// The direction of view: from the system to the eye, along x, y and z of the ground
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    pub view: Option<Direction>,
}

/// A direction of view, a unit vector from the system to the eye.
#[derive(Clone, Copy, Debug)]
pub struct Direction([f64; 3]);

fn direction(text: &str) -> Result<Direction, String> {
    let parts: Option<Vec<f64>> = text.split(',').map(finite).collect();
    let direction = parts.and_then(|parts| <[f64; 3]>::try_from(parts).ok()).and_then(|direction| {
        let length = direction.iter().fold(0.0, |length: f64, part| length.hypot(*part));
        (length > 0.0 && length.is_finite()).then(|| Direction(direction.map(|part| part / length)))
    });
    direction.ok_or_else(|| "three numbers that are not all zero, such as 1,-2,0.5, are accepted".to_owned())
}

fn span(text: &str) -> Result<Interval, String> {
    let ends = text.split_once("..").and_then(|(from, to)| Some((finite(from)?, finite(to)?)));
    let interval = ends.filter(|(from, to)| *from >= 0.0 && to > from).map(|(from, to)| Interval { from, to });
    interval
        .ok_or_else(|| "two times of the run in seconds, the earlier first, such as 2..2.5, are accepted".to_owned())
}

fn instant(text: &str) -> Result<f64, String> {
    let time = finite(text).filter(|time| *time >= 0.0);
    time.ok_or_else(|| "a time from 0 to the end of the run, in seconds, is accepted".to_owned())
}

fn finite(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}

/// The largest accepted distance from the origin in metres; its square is far below the largest double.
const FARTHEST: f64 = 1e100;

/// Draws the system at its start, at an instant of its run, or animated.
pub fn draw(asked: &Args) -> Result<Exit, Exit> {
    let writes = Writes { command: "draw", force: asked.force, reads: vec![&asked.scene] };
    let output = writes.optional(asked.out.as_deref(), &[Form::Picture])?;
    let provenance = Provenance::of(writes.maker(), &asked.scene);
    let text = SystemText::read(&asked.scene)?;
    let towards = asked.view.map(|Direction(direction)| direction);
    let work = Progress::new("draw");
    let (drawn, ending) = match (asked.animate, asked.time) {
        (false, None) => {
            let (title, model) = ::scenes::parse_titled(&text.name, &text.text, Task::Run)?;
            text.check_run(&model)?;
            (still_of(&asked.scene, (&title, model), towards)?, Exit::Done)
        }
        (false, Some(time)) => (at_time(&asked.scene, &text, time, towards)?, Exit::Done),
        (true, _) => moving(&asked.scene, &text, (asked.span, towards))?,
    };
    drop(work);
    let picture = drawn.svg();
    match output {
        Some(output) => output.write_text(&(provenance.markup() + &picture))?.tell(Format::Text)?,
        None => print(&format!("{picture}\n"))?,
    }
    Ok(ending)
}

/// The sketch of a system at its start, without a run.
///
/// # Errors
/// The text has a fault, or no start satisfies its constraints.
pub fn still(path: &Path, text: &SystemText, towards: Option<[f64; 3]>) -> Result<Sketch, Exit> {
    let (title, model) = ::scenes::parse_titled(&text.name, &text.text, Task::Run)?;
    still_of(path, (&title, model), towards)
}

/// The sketch of a model at its start. Parameters without values are set to one, inputs to zero.
fn still_of(path: &Path, (title, mut model): (&str, Model), towards: Option<[f64; 3]>) -> Result<Sketch, Exit> {
    let open = close(&mut model)?;
    let start = start_of(&model).map_err(|issue| placed(path, issue))?;
    let geometry = geometry(path, &Arc::new(model), &start)?;
    let mut drawn = sketch(title, &geometry, &[geometry.first_figure(&start)], towards);
    if !open.is_empty() {
        drawn.note += &format!(" Parameters without a value are drawn as 1: {}.", open.join(", "));
    }
    Ok(drawn)
}

/// Sets parameters without values to one and inputs without values to zero; returns the names of these parameters.
fn close(model: &mut Model) -> Result<Vec<String>, Exit> {
    model.close_inputs();
    let open = model.parameters.iter().filter(|parameter| parameter.value.is_none());
    let open: Vec<(String, f64)> = open.map(|parameter| (parameter.name.clone(), 1.0)).collect();
    model.set_values(&open).map_err(Exit::refused)?;
    Ok(open.into_iter().map(|(name, _)| name).collect())
}

/// The points, bodies and frames of a model at a state: coordinates, then speeds, in the order of the model and in SI units. `path` is named in messages.
///
/// # Errors
/// A place has no value, lies too far from the origin, or the system has no points, frames or bodies.
fn geometry(path: &Path, model: &Arc<Model>, state: &[f64]) -> Result<Geometry, Exit> {
    let refused = |why: String| Exit::refused(format!("{}: {why}", path.display()));
    let geometry = Geometry::of(model, state).map_err(|why| refused(format!("its places have no values: {why}")))?;
    let figure = geometry.figure(0.0, state);
    if let Some(place) = far_place(&geometry, &figure) {
        return Err(placed(path, too_far(&geometry, place, state)));
    }
    if !geometry.is_seen() {
        let accepted = "a system with [points], [frames] or [bodies] is accepted";
        let why =
            "there is nothing to draw: its energies and forces are written in coordinates alone, which have no places";
        return Err(refused(format!("{why}; {accepted}")));
    }
    if !figure.has_values() {
        let accepted = "a start from which positions are numbers is accepted";
        return Err(refused(format!("a position has no value at the start; {accepted}")));
    }
    Ok(geometry)
}

/// The index of the first point that is too far from the origin.
fn far_place(geometry: &Geometry, figure: &Figure) -> Option<usize> {
    let is_far = |place: &usize| figure.places[*place].iter().any(|part| part.abs() > FARTHEST);
    (0..geometry.names.len()).find(is_far)
}

/// The message about a point that is too far from the origin. It refers to the coordinate that is responsible, if there is exactly one.
fn too_far(geometry: &Geometry, place: usize, state: &[f64]) -> Issue {
    let model = &geometry.model;
    let at = geometry.figure(0.0, state).places[place];
    let size = at.iter().fold(0.0, |size: f64, part| size.max(part.abs()));
    let name = match geometry.names[place].as_str() {
        "" => "a place".to_owned(),
        name => format!("`{name}`"),
    };
    let title = format!("{name} is {size:e} m from the origin at the start");
    let accepted = format!("a start and parameters by which positions are below {FARTHEST:e} m are accepted");
    let without = |coordinate: &usize| {
        let mut other = state.to_vec();
        other[*coordinate] = 0.0;
        far_place(geometry, &geometry.figure(0.0, &other)).is_none()
    };
    let coordinate = (0..model.coordinates.len().min(state.len())).find(without);
    match coordinate.map(|coordinate| (&model.coordinates[coordinate], state[coordinate])) {
        Some((coordinate, value)) => {
            let unit = if coordinate.unit == "1" { String::new() } else { format!(" {}", coordinate.unit) };
            Issue::at(coordinate.at.clone(), title, format!("it is {value:e}{unit} at the start")).accepted(accepted)
        }
        None => Issue { span: None, title, label: String::new(), help: Some(accepted) },
    }
}

/// The scene of a text, ready to run.
fn scene(text: &SystemText) -> Result<ModelScene, Exit> {
    Ok(ModelScene::parse(&text.name, &text.text)?)
}

fn choice(scene: &ModelScene, samples: usize) -> Choice {
    Choice { samples, allowed: clock::left(), ..scene.run().choice() }
}

/// The sketch of a run at an instant, in seconds.
fn at_time(path: &Path, text: &SystemText, time: f64, towards: Option<[f64; 3]>) -> Result<Sketch, Exit> {
    let scene = scene(text)?;
    let span = scene.run.span;
    if time > span {
        let accepted = format!("a time from 0 to {span} s is accepted");
        return Err(Exit::refused(format!("{}: --time {time}: the run ends at {span} s; {accepted}", path.display())));
    }
    let geometry = geometry(path, &scene.model, &scene.start)?;
    let figure = if time > 0.0 {
        let mut problem = scene.problem_with_mode_values();
        problem.span = time;
        let run = problem.simulate_while(&choice(&scene, 1), |_| clock::goes_on());
        if let Some(why) = run.stopped().filter(|_| run.outcome.time < time) {
            let reached = run.outcome.time;
            return Err(Exit::refused(format!(
                "{}: --time {time}: the run stopped at {reached} s: {why}; a time from 0 to {reached} s is accepted",
                path.display()
            )));
        }
        let reached = run.outcome.time;
        if reached < time * (1.0 - 1e-12) {
            return Err(Exit::refused(format!(
                "{}: --time {time}: an event ends the run at {reached} s; a time from 0 to {reached} s is accepted",
                path.display()
            )));
        }
        let of_mode = run.last.get(run.names.len()..).unwrap_or_default();
        geometry.figure_with(time, &run.outcome.state, of_mode)
    } else {
        geometry.first_figure(&scene.start)
    };
    let mut drawn = sketch(&scene.title, &geometry, &[figure], towards);
    drawn.note = format!("At {time} s. {}", drawn.note);
    Ok(drawn)
}

/// The animated sketch of a run, or of the requested part of it.
fn moving(
    path: &Path,
    text: &SystemText,
    (asked, towards): (Option<Interval>, Option<[f64; 3]>),
) -> Result<(Sketch, Exit), Exit> {
    let scene = scene(text)?;
    let span = scene.run.span;
    let interval = asked.unwrap_or(Interval { from: 0.0, to: span });
    if interval.to > span {
        let (Interval { from, to }, accepted) = (interval, format!("a part of 0..{span} is accepted"));
        return Err(Exit::refused(format!(
            "{}: --span {from}..{to}: the run ends at {span} s; {accepted}",
            path.display()
        )));
    }
    let geometry = geometry(path, &scene.model, &scene.start)?;
    let most = most_pictures(&sketch("", &geometry, &[geometry.figure(0.0, &scene.start)], towards));
    let mut progress = Progress::new(&scene.title);
    let followed = followed(&scene, &geometry, (interval, most), |fraction| {
        progress.set(fraction);
        clock::goes_on()
    });
    drop(progress);
    let Some(Motion { figures, part, run }) = followed else {
        let from = short(interval.from);
        return Err(Exit::refused(format!(
            "{}: the run ends before {from} s; a part of the run before it is accepted",
            path.display()
        )));
    };
    let ended = run.stopped().map(|why| format!("the run stopped at {} s: {why}", short(run.outcome.time)));
    let mut drawn = sketch(&scene.title, &geometry, &figures, towards);
    if let Some([from, to]) = part {
        let shown =
            format!("Shown is the part from {} s to {} s of a run of {} s", short(from), short(to), short(span));
        drawn.note +=
            &format!(" {shown}: a longer part would need too many pictures. Another part is drawn by --span.");
    }
    let Some(told) = ended else { return Ok((drawn, Exit::Done)) };
    drawn.note += &format!(" The motion ends early: {told}.");
    warn(&format!("{}: {told}; the motion up to there is drawn", path.display()));
    Ok((drawn, Exit::Stopped))
}

fn short(time: f64) -> String {
    charts::significant(time, 4)
}

#[cfg(test)]
mod tests {
    use super::{direction, span};

    #[test]
    fn a_view_is_three_numbers_that_are_not_all_zero() {
        assert!(direction("1, -2,0.5").is_ok() && direction("0,0,1e-200").is_ok());
        for wrong in ["", "1,2", "0,0,0", "1,2,3,4", "a,b,c", "1,2,nan", "inf,0,0"] {
            assert!(direction(wrong).is_err_and(|told| told.contains("1,-2,0.5")), "{wrong}");
        }
    }

    #[test]
    fn a_span_is_two_times_in_order() {
        assert!(span("0..1").is_ok() && span("0.5 .. 2e1").is_ok());
        for wrong in ["", "1", "2..1", "-1..2", "1..1", "a..b", "0..inf", "0-1"] {
            assert!(span(wrong).is_err_and(|told| told.contains("2..2.5")), "{wrong}");
        }
    }
}
