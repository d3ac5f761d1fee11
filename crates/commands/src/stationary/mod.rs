//! `dalembert stationary`: all steady motions of a scene, with a proof that none is missing, and their stability: for
//! gyrostats with their motors, and for any system that is defined in its file.

mod along;
mod branches;
mod cases;
pub mod combinations;
mod families;
mod json;
mod map;
pub mod model;
mod motor;
mod plane;
pub mod refusals;
pub mod steady_box;
mod text;
pub mod verdict;

use self::steady_box::{SteadyBox, named_range};
use crate::arguments::{Format, finite};
use crate::clock;
use crate::exit::{Exit, print};
use crate::run::with_model;
use ::scenes::steady_motions::Range;
use mechanics::steady_rotations::Undecided;
use reader::{Family, read_text};
use simulation::models::holds_model;
use std::path::PathBuf;
use studies::scene::Scene;
use studies::stationary::motions::{NoAnswer, Stationary};

/// Arguments of `stationary`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Steady motions with this angular velocity about the vertical, rad/s
    #[arg(long, value_name = "W", value_parser = finite, allow_negative_numbers = true, conflicts_with_all = ["momentum", "cone"])]
    pub omega0: Option<f64>,
    /// Steady motions with this angular momentum about the vertical, N m s; without --omega0, --momentum and --cone, the momentum at the
    /// scene's start
    #[arg(long, value_name = "P", value_parser = finite, allow_negative_numbers = true, conflicts_with = "cone")]
    pub momentum: Option<f64>,
    /// The number of steady motions for every angular velocity, and the angular velocities at which two merge. Named after
    /// Staude's cone of the axes of steady rotations of a heavy body
    #[arg(long)]
    pub cone: bool,
    /// Given twice: a stability map over two values in SI units, such as load and carrier.centre.3. The map shows the rotation about the rotor's
    /// axis if this is a common principal axis of the bodies, else every steady motion
    #[arg(long, value_name = "DATUM=FROM..TO", value_parser = ranged, num_args = 1, conflicts_with_all = ["momentum", "cone"])]
    pub map: Vec<Ranged>,
    /// For --map: the rotor's axis points upwards
    #[arg(long, requires = "map")]
    pub upright: bool,
    /// For --map: every steady motion, not only the rotation about the rotor's axis
    #[arg(long, requires = "map", conflicts_with = "upright")]
    pub every: bool,
    /// The file of the picture: of a map by --map or two --along, or of the branches of steady motions along one parameter
    #[arg(long, value_name = "FILE.svg", visible_alias = "picture")]
    pub out: Option<PathBuf>,
    /// Replaces the file of --out even if `stationary` did not write it
    #[arg(long, requires = "out")]
    pub force: bool,
    #[command(flatten)]
    pub steady: SteadyBox,
    /// The steady motions of a system described in its file, at values of a parameter in SI units, or of the speed of a cyclic coordinate, with
    /// the values at which they change. Given twice: a map of the numbers of steady motions and of stable ones over both
    #[arg(long, value_name = "NAME=FROM..TO", value_parser = named_range, num_args = 1, conflicts_with_all = ["omega0", "momentum", "cone", "map"])]
    pub along: Vec<(String, Range)>,
    /// The number of values for --along; the default is 41, and 24 in each direction of a map
    #[arg(long, value_name = "N", value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(2..=100_000), requires = "along")]
    pub values: Option<usize>,
    /// Replaces the motor by another model; its data are computed from the scene
    #[arg(long)]
    pub model: Option<String>,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// A datum of the scene with a range of values.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranged {
    pub name: String,
    /// The range in SI units.
    pub range: [f64; 2],
}

fn ranged(text: &str) -> Result<Ranged, String> {
    let accepted = || "a datum with its range such as load=-0.1..0.1 is accepted".to_owned();
    let (name, range) = text.split_once('=').ok_or_else(accepted)?;
    let (from, to) = range.split_once("..").ok_or_else(accepted)?;
    let (from, to) = (finite(from)?, finite(to)?);
    if from >= to {
        return Err(format!("{from} is not below {to}; FROM must be below TO"));
    }
    Ok(Ranged { name: name.to_owned(), range: [from, to] })
}

/// Prints the steady motions.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    if read_text(&asked.scene).is_ok_and(|text| holds_model(&text)) {
        refuse_others(asked)?;
        return match &asked.along[..] {
            [] if asked.out.is_some() => Err(Exit::refused(
                "--out: a picture is drawn along a parameter; --along NAME=FROM..TO is accepted with it, once or twice",
            )),
            [] => model::show(asked),
            [along] => along::show(asked, along),
            [first, second] => plane::show(asked, [first, second]),
            _ => Err(Exit::refused("--along is accepted once or twice: along one parameter, or as a map over two")),
        };
    }
    if !asked.along.is_empty() {
        return Err(Exit::refused(
            "--along is about a system that is written in its file; --map goes over data of this one",
        ));
    }
    asked.steady.refuse("--omega0, --momentum and --map say which motions of this one")?;
    let scene = with_model(Scene::open(&asked.scene)?, asked.model.as_deref(), &asked.scene)?;
    if !asked.map.is_empty() {
        return map::show(asked, &scene);
    }
    if asked.out.is_some() {
        return Err(Exit::refused(
            "--out: the picture is that of a map; --map A=FROM..TO --map B=FROM..TO is accepted with it",
        ));
    }
    let refused = |reason: NoAnswer| Exit::refused(format!("{}: {reason}", asked.scene.display()));
    let all = Stationary::of(&scene).map_err(refused)?;
    if matches!(asked.format, Format::Text) {
        clock::publish(format!("{}\n{}", scene.title, motor::text(&all.motor)));
    }
    if asked.cone {
        let census = all.census();
        print(&match asked.format {
            Format::Text => format!("{}\n{}{}", scene.title, motor::text(&all.motor), text::counts(&all, &census)),
            Format::Json => format!("{:#}\n", json::census(&scene, &all, &census)),
        })?;
        return Ok(if census.iter().all(Result::is_ok) { Exit::Done } else { Exit::Stopped });
    }
    let (given, answers) = match (asked.omega0, asked.momentum) {
        (Some(w), _) => (Given::Speed(w), all.at_speed(w).map_err(refused)?),
        (None, p) => {
            let p = p.unwrap_or_else(|| all.momentum_at_start());
            (Given::Momentum(p), all.at_momentum(p).map_err(refused)?)
        }
    };
    print(&match asked.format {
        Format::Text => text::all(&scene, &all, given, &answers),
        Format::Json => format!("{:#}\n", json::all(&scene, &all, given, &answers)),
    })?;
    let complete = answers.iter().all(|answer| answer.certificate.is_complete());
    Ok(if complete { Exit::Done } else { Exit::Stopped })
}

/// Refuses options that apply only to gyrostats where the system is defined in its file.
fn refuse_others(asked: &Args) -> Result<(), Exit> {
    let given = [
        ("--omega0", asked.omega0.is_some()),
        ("--momentum", asked.momentum.is_some()),
        ("--cone", asked.cone),
        ("--map", !asked.map.is_empty()),
        ("--model", asked.model.is_some()),
    ];
    match given.iter().find(|(_, is_given)| *is_given) {
        None => Ok(()),
        Some((option, _)) => Err(Exit::refused(format!(
            "{option} is about the built-in gyrostats; of a system that is written in its file --range NAME=FROM..TO says where motions are sought"
        ))),
    }
}

/// The quantity that all motions have in common: the angular velocity about the vertical, rad/s, or the angular momentum about it, N m s.
#[derive(Clone, Copy)]
enum Given {
    Speed(f64),
    Momentum(f64),
}

fn why(reason: Undecided) -> &'static str {
    match reason {
        Undecided::Curve => "motions with this momentum form curves",
        Undecided::TooFine => "motions lie closer together than 8192 bits tell apart",
    }
}
