//! `dalembert linearise`: the linear equations of a system that is written in its file, about a point or along its run.

use crate::clock;
use crate::ending::{Ending, print};
use crate::progress::Progress;
use ::scenes::linearisation::{Linearisation, NotLinear, Stability, Standing, VariedEquations, eigenvalues, points};
use ::scenes::{ModelScene, equilibrium_of, read_model, start_of};
use clap::{Args, ValueEnum};
use derivations::scene::SceneError;
use derivations::scene::file::read_text;
use model::Model;
use serde_json::json;
use std::fmt::Write;
use std::path::PathBuf;

/// What is linearised, and about which point.
#[derive(Args, Debug)]
pub struct Asked {
    /// A file with `[coordinates]`
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The point: the start of the file, or an equilibrium near it
    #[arg(long, value_enum, default_value_t)]
    pub about: About,
    /// Instants of the run in seconds, instead of a point: 0,0.5,2
    #[arg(long, value_name = "T,T", value_delimiter = ',', value_parser = instant, conflicts_with = "about")]
    pub times: Vec<f64>,
    /// A parameter that is an input; may be repeated
    #[arg(long = "input", value_name = "NAME")]
    pub inputs: Vec<String>,
    /// How to print the matrices; CSV has a row for each entry
    #[arg(long, value_enum, default_value_t)]
    pub format: Form,
}

/// A point of a system.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum About {
    /// As the file gives it, completed so that constraints hold
    #[default]
    Start,
    /// A point of rest, found from the coordinates at the start
    Equilibrium,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Form {
    #[default]
    Text,
    Json,
    Csv,
}

fn instant(text: &str) -> Result<f64, String> {
    let time = text.trim().parse().ok().filter(|time: &f64| time.is_finite() && *time >= 0.0);
    time.ok_or_else(|| "a time that is not negative, in seconds, such as 0.5 is accepted".to_owned())
}

/// The linear equations about one point.
struct Found {
    linear: Linearisation,
    standing: Standing,
    /// Real and imaginary parts.
    eigenvalues: Vec<[f64; 2]>,
    stability: Stability,
}

/// Prints the matrices, the eigenvalues and what they say.
pub fn linearise(asked: &Asked) -> Result<Ending, Ending> {
    let refused = |why: String| Ending::refused(format!("{}: {why}", asked.scene.display()));
    let mut model = read_model(&asked.scene)?;
    let inputs = inputs(&mut model, &asked.inputs).map_err(refused)?;
    let _progress = Progress::new("the linear equations");
    let instances = instances(&model, asked)?;
    let equations = VariedEquations::of(&model, &inputs).map_err(|why| refused(why.to_string()))?;
    let mut all = Vec::with_capacity(instances.len());
    for (time, state) in instances {
        let no_linear = |why: NotLinear| refused(format!("at t = {time} s {why}"));
        let linear = equations.linearised(&model, equations.point(&model, time, &state)).map_err(no_linear)?;
        let standing = equations.standing(&model, &linear).map_err(no_linear)?;
        let eigenvalues = eigenvalues(&linear.a);
        let stability = Stability::of(&eigenvalues, standing != Standing::Moving);
        let eigenvalues = eigenvalues.values.iter().map(|value| [value.re, value.im]).collect();
        all.push(Found { linear, standing, eigenvalues, stability });
    }
    let names = Names::of(&model, &inputs);
    print(&match asked.format {
        Form::Text => all.iter().map(|found| text(&names, found)).collect::<Vec<_>>().join("\n"),
        Form::Json => {
            format!("{:#}\n", json!({ "points": all.iter().map(|found| object(&names, found)).collect::<Vec<_>>() }))
        }
        Form::Csv => csv(&names, &all),
    })?;
    Ok(Ending::Done)
}

/// The places of parameters that are inputs; one without a value is taken about zero.
fn inputs(model: &mut Model, names: &[String]) -> Result<Vec<usize>, String> {
    let mut places = Vec::new();
    for name in names {
        let Some(place) = model.parameters.iter().position(|parameter| parameter.name == *name) else {
            let known: Vec<&str> = model.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
            return Err(match units::nearest(name, known.iter().copied()) {
                Some(nearest) => format!("no parameter is called `{name}`; is `{nearest}` meant?"),
                None => format!("no parameter is called `{name}`; there are: {}", known.join(", ")),
            });
        };
        model.parameters[place].value.get_or_insert(0.0);
        if !places.contains(&place) {
            places.push(place);
        }
    }
    Ok(places)
}

/// Times with the states then.
fn instances(model: &Model, asked: &Asked) -> Result<Vec<points::Instance>, Ending> {
    let refused = |why: String| Ending::refused(format!("{}: {why}", asked.scene.display()));
    if !asked.times.is_empty() {
        let scene = ModelScene::parse(&asked.scene.display().to_string(), &read_text(&asked.scene)?)?;
        let along = points::along(&scene, &asked.times, clock::left());
        return along.map_err(|failure| refused(format!("the run does not reach these times: {failure}")));
    }
    let state = match asked.about {
        About::Start => start_of(model),
        About::Equilibrium => equilibrium_of(model),
    };
    match state {
        Ok(state) => Ok(vec![(0.0, state)]),
        Err(issue) => {
            let (path, text) = (asked.scene.display().to_string(), read_text(&asked.scene)?);
            Err(SceneError { path, text, issues: vec![issue] }.into())
        }
    }
}

/// Names of what rows and columns are.
struct Names<'a> {
    coordinates: Vec<&'a str>,
    inputs: Vec<&'a str>,
    outputs: Vec<&'a str>,
}

impl<'a> Names<'a> {
    fn of(model: &'a Model, inputs: &[usize]) -> Self {
        Names {
            coordinates: model.coordinates.iter().map(|coordinate| coordinate.name.as_str()).collect(),
            inputs: inputs.iter().map(|&place| model.parameters[place].name.as_str()).collect(),
            outputs: model.outputs.iter().map(|output| output.name.as_str()).collect(),
        }
    }

    /// Of the components of x.
    fn states(&self, linear: &Linearisation) -> Vec<String> {
        let coordinates = linear.coordinates.iter().map(|&place| self.coordinates[place].to_owned());
        coordinates.chain(linear.speeds.iter().map(|&place| format!("{}'", self.coordinates[place]))).collect()
    }

    /// Of rows and columns of a matrix.
    fn sides(&self, linear: &Linearisation, matrix: &str) -> (Vec<String>, Vec<String>) {
        let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let states = self.states(linear);
        let rows = if matrix == "A" || matrix == "B" { states.clone() } else { owned(&self.outputs) };
        (rows, if matrix == "A" || matrix == "C" { states } else { owned(&self.inputs) })
    }
}

fn standing(standing: Standing) -> &'static str {
    match standing {
        Standing::Equilibrium => "equilibrium",
        Standing::Steady => "steady motion",
        Standing::Moving => "moving point",
    }
}

fn text(names: &Names<'_>, found: &Found) -> String {
    let Found { linear, eigenvalues, stability, .. } = found;
    let mut text = format!("t = {} s, {}\n", linear.point.time, standing(found.standing));
    let point = &linear.point;
    let values = [("", &point.coordinates), ("'", &point.speeds), ("''", &point.accelerations)];
    for (k, name) in names.coordinates.iter().enumerate() {
        let line = values.map(|(primes, values)| format!("{name}{primes} = {}", number(values[k]).trim()));
        let _ = writeln!(text, "  {}", line.join(", "));
    }
    let _ = writeln!(text, "x = ({})", names.states(linear).join(", "));
    let dependent = names.coordinates.iter().enumerate().filter(|(place, _)| !linear.coordinates.contains(place));
    let fixed_speeds = (0..names.coordinates.len()).filter(|place| !linear.speeds.contains(place));
    let fixed: Vec<String> = dependent
        .map(|(_, name)| (*name).to_owned())
        .chain(fixed_speeds.map(|place| format!("{}'", names.coordinates[place])))
        .collect();
    if !fixed.is_empty() {
        let _ = writeln!(text, "by the constraints: {}", fixed.join(", "));
    }
    for (matrix, rows) in linear.matrices() {
        let (left, above) = names.sides(linear, matrix);
        if left.is_empty() || above.is_empty() {
            continue;
        }
        let wide = left.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        let largest = rows.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
        let heading: String = above.iter().map(|name| format!(" {name:>19}")).collect();
        let _ = writeln!(text, "{matrix}\n  {:wide$}{heading}", "");
        for (name, row) in left.iter().zip(rows) {
            let entries: String = row.iter().map(|value| format!(" {}", number(shown(*value, largest)))).collect();
            let _ = writeln!(text, "  {name:wide$}{entries}");
        }
    }
    text += "eigenvalues\n";
    for [re, im] in eigenvalues {
        let _ = match im {
            0.0 => writeln!(text, "  {}", number(*re)),
            im if *im < 0.0 => writeln!(text, "  {} - {} i", number(*re), number(-im).trim()),
            im => writeln!(text, "  {} + {} i", number(*re), number(*im).trim()),
        };
    }
    let _ = writeln!(text, "{stability}");
    text
}

/// What is left of an entry by rounding alone reads as zero.
fn shown(value: f64, largest: f64) -> f64 {
    if value.abs() < 1e-14 * largest { 0.0 } else { value }
}

/// Twelve digits, in a column.
fn number(value: f64) -> String {
    let value = if value == 0.0 { 0.0 } else { value };
    let text = match value.abs() {
        size if size == 0.0 || (1e-4..1e6).contains(&size) => {
            let places = if size == 0.0 { 0 } else { 11 - size.log10().floor() as i32 };
            let fixed = format!("{value:.*}", places.max(0) as usize);
            if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
        }
        _ => format!("{value:.11e}"),
    };
    format!("{text:>19}")
}

fn object(names: &Names<'_>, found: &Found) -> serde_json::Value {
    let Found { linear, eigenvalues, stability, .. } = found;
    let mut object = json!({
        "time": linear.point.time,
        "point": standing(found.standing),
        "coordinates": linear.point.coordinates.as_slice(),
        "speeds": linear.point.speeds.as_slice(),
        "accelerations": linear.point.accelerations.as_slice(),
        "states": names.states(linear),
        "inputs": names.inputs,
        "outputs": names.outputs,
        "eigenvalues": eigenvalues,
        "stability": stability.to_string(),
    });
    for (name, rows) in linear.matrices() {
        object[name] = json!(rows);
    }
    object
}

/// A row for each entry of a matrix, then for each eigenvalue.
fn csv(names: &Names<'_>, all: &[Found]) -> String {
    let mut text = "time [s],matrix,row,column,value\n".to_owned();
    for Found { linear, eigenvalues, .. } in all {
        let time = linear.point.time;
        for (matrix, rows) in linear.matrices() {
            let (left, above) = names.sides(linear, matrix);
            for (row, values) in left.iter().zip(rows) {
                for (column, value) in above.iter().zip(values) {
                    let _ = writeln!(text, "{time:?},{matrix},{row},{column},{value:?}");
                }
            }
        }
        for (place, value) in eigenvalues.iter().enumerate() {
            for (part, value) in ["real", "imaginary"].into_iter().zip(value) {
                let _ = writeln!(text, "{time:?},eigenvalue,{},{part},{value:?}", place + 1);
            }
        }
    }
    text
}
