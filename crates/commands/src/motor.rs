//! `dalembert motor`: a synchronous motor under load: its synchronous and asynchronous motions, and the starts from which it synchronises.

use crate::arguments::Format;
use crate::exit::{Exit, print};
use crate::run::with_model;
use crate::studies::synchronism::onset;
use reader::Family;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;
use studies::scene::{Scene, Setup};
use studies::stationary::motor::{Angle, MotorStates};
use studies::synchronism::basin::Share;
use studies::synchronism::branches::{Slipping, Standing};
use studies::synchronism::loaded::{Loaded, giving_way, with_bars};
use studies::synchronism::maps::{alone, over_starts};
use studies::synchronism::pull_in::PullIn;

/// Arguments of `motor`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file with a synchronous motor, on a bench or in a gyrostat
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Replaces the motor by another model; its data are computed from the scene
    #[arg(long)]
    pub model: Option<String>,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// The numbers of bars that are compared, in addition to the scene's own number.
const BARS: [usize; 5] = [0, 1, 2, 3, 8];
/// The loads of the table, as fractions of the pull-out torque.
const LOADS: [f64; 8] = [0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.05];
/// The numbers of initial angles and of initial slips.
const STARTS: (usize, usize) = (8, 6);
/// The duration of the run from each start, in units of 1/ω, where ω is the angular frequency of small oscillations.
const SWINGS: f64 = 200.0;

/// The results for a motor with a given number of bars.
struct Case {
    /// The number of bars; `None` for a motor without a count of bars.
    bars: Option<usize>,
    /// The axial moment of inertia, kg m².
    axial: f64,
    in_gyrostat: bool,
    pull_in: Result<Option<PullIn>, String>,
    /// The limit of the load for asynchronous motions as their period tends to infinity, N m.
    limit: Option<f64>,
    /// Asynchronous motions without an additional load.
    unloaded: Vec<Slipping>,
    shares: Result<Vec<Share>, String>,
}

/// Results that depend neither on the number of bars nor on the body that carries the motor.
struct Common {
    motor: Loaded,
    in_step: Vec<Standing>,
    /// Enclosures of the synchronous angles without an additional load.
    angles: Vec<Angle>,
    pull_out: Standing,
    /// The additional loads of the table, N m.
    loads: Vec<f64>,
    /// The duration of the run from each start, s.
    span: f64,
}

/// Prints the synchronous and asynchronous motions at several loads, and the fractions of starts that synchronise.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    let scene = with_model(Scene::open(&asked.scene)?, asked.model.as_deref(), &asked.scene)?;
    let refused = |reason: String| Exit::refused(format!("{}: {reason}", asked.scene.display()));
    let motor = Loaded::of(&scene).map_err(|reason| refused(reason.to_string()))?;
    let in_step = motor.in_step();
    let pull_out = Loaded::pull_out(&in_step).cloned();
    let pull_out =
        pull_out.ok_or_else(|| refused("its angles in step could not be followed to the pull-out".into()))?;
    let angles = match MotorStates::of(&scene.machine).map_err(|reason| refused(reason.to_string()))? {
        MotorStates::InStep { angles, .. } => angles,
        _ => Vec::new(),
    };
    let room = pull_out.load.max(0.0);
    let loads = LOADS.iter().map(|share| share * room).collect();
    let common = Common { span: SWINGS / motor.facts.frequency, motor, in_step, angles, pull_out, loads };
    let bench = alone(&scene);
    let mut motors: Vec<(Option<usize>, Scene)> = match scene.given.count("bars") {
        None => vec![(None, bench.clone())],
        Some(own) => {
            let mut bars = BARS.to_vec();
            bars.push(own);
            bars.sort_unstable();
            bars.dedup();
            bars.into_iter().filter_map(|bars| Some((Some(bars), with_bars(&bench, bars)?))).collect()
        }
    };
    if let Setup::Gyrostat(_) = scene.system {
        let own = scene.given.count("bars");
        let same = own.and_then(|bars| with_bars(&scene, bars)).unwrap_or_else(|| scene.clone());
        motors.push((own, same));
    }
    // each motor has its own thread, since an expression graph belongs to one thread
    let cases: Vec<Case> = std::thread::scope(|scope| {
        let running: Vec<_> = motors.iter().map(|(bars, scene)| scope.spawn(|| case(*bars, scene, &common))).collect();
        running.into_iter().filter_map(|case| case.join().ok().flatten()).collect()
    });
    print(&match asked.format {
        Format::Text => text(&scene, &common, &cases),
        Format::Json => format!("{:#}\n", object(&scene, &common, &cases)),
    })?;
    let complete = cases.len() == motors.len() && cases.iter().all(|case| case.pull_in.is_ok() && case.shares.is_ok());
    Ok(if complete { Exit::Done } else { Exit::Stopped })
}

fn case(bars: Option<usize>, scene: &Scene, common: &Common) -> Option<Case> {
    let in_gyrostat = matches!(scene.system, Setup::Gyrostat(_));
    let motor = match &scene.system {
        Setup::Gyrostat(bodies) => Loaded::new(&scene.machine, giving_way(bodies)),
        Setup::Bench { .. } => Loaded::of(scene),
    };
    let motor = motor.ok()?;
    let found = motor.out_of_step();
    let unloaded = found.as_ref().ok().and_then(|all| motor.slipping_under(0.0, all).ok()).unwrap_or_default();
    let limit = found.as_ref().ok().and_then(|all| all.limit);
    let pull_in = found.map(|all| all.pull_in(common.pull_out.load)).map_err(|failure| failure.to_string());
    let shares = over_starts(scene, &common.loads, STARTS, common.span).map_err(|reason| reason.to_string());
    Some(Case { bars, axial: motor.axial, in_gyrostat, pull_in, limit, unloaded, shares })
}

/// An angle in degrees, from radians.
fn degrees(angle: f64) -> f64 {
    angle.to_degrees()
}

fn text(scene: &Scene, common: &Common, cases: &[Case]) -> String {
    let Common { motor, pull_out, .. } = common;
    let facts = &motor.facts;
    let mut out = format!("{}\n", scene.title);
    // writing to a String cannot fail
    let _ = writeln!(
        out,
        "{}: field {} rad/s, holds {:.6} N m; friction at synchronism {:.6} N m; oscillates about it with {:.4} rad/s\n\
         loads are additional torques against the rotation of the rotor, in either direction, N m",
        motor.machine.name(),
        facts.field_speed,
        facts.hold,
        facts.friction,
        facts.frequency
    );
    let _ = writeln!(out, "\nin step, the same on the bench and in a gyrostat, with any number of bars");
    for angle in &common.angles {
        let held = if angle.slope < 0 { "holds" } else { "does not hold" };
        let _ = writeln!(out, "  without load at {:>14.9} deg   {held}", degrees(angle.radians()));
    }
    let _ = writeln!(
        out,
        "  pull-out: both angles merge at {:.6} deg under a load of {:.12} N m",
        degrees(pull_out.angle),
        pull_out.load
    );
    let _ = writeln!(
        out,
        "\nout of step: from the pull-in on the rotor can slip for ever; up to the pull-out the start decides, below zero even without load"
    );
    let _ =
        writeln!(out, "  {:<30}{:>14}{:>12}{:>14}   slipping begins", "", "pull-in, N m", "of pull-out", "long turns");
    for case in cases {
        let _ = match &case.pull_in {
            Ok(Some(found)) => writeln!(
                out,
                "  {:<30}{:>14.9}{:>12.4}{:>14}   {}",
                name(case),
                found.load,
                found.load / pull_out.load,
                case.limit.map_or_else(|| "-".to_owned(), |load| format!("{load:.9}")),
                onset(found.by)
            ),
            Ok(None) => writeln!(out, "  {:<30}{:>14}", name(case), "never"),
            Err(reason) => writeln!(out, "  {:<30}  not known: {reason}", name(case)),
        };
    }
    if let Some(case) = cases.iter().find(|case| case.in_gyrostat) {
        let _ = writeln!(
            out,
            "  in the gyrostat the pull-in is that of a rotor as light as the carrier lets it be, {:.6e} kg m^2: exact where it stands\n  \
             upright, elsewhere without what the carrier's own motion does; the starts below are run with all of it",
            case.axial
        );
    }
    for case in cases.iter().filter(|case| !case.unloaded.is_empty()) {
        let _ = writeln!(out, "  without load, {}:", name(case));
        for one in &case.unloaded {
            let _ = writeln!(
                out,
                "    slips at {:.4} rad/s, a turn in {:.5} s, multiplier {:.4}: {}",
                one.slip(),
                one.period,
                one.multiplier,
                if one.stable() { "stable" } else { "unstable" }
            );
        }
    }
    let _ = writeln!(
        out,
        "\nstarts in step: of {} angles x {} slips from standstill to synchronism, {:.2} s; median time to it, s",
        STARTS.0, STARTS.1, common.span
    );
    let heads: String = common.loads.iter().map(|load| format!("{load:>15.5}")).collect();
    let _ = writeln!(out, "  {:<30}{heads}", "load, N m");
    for case in cases {
        let _ = match &case.shares {
            Ok(shares) => writeln!(out, "  {:<30}{}", name(case), shares.iter().map(share).collect::<String>()),
            Err(reason) => writeln!(out, "  {:<30}  not known: {reason}", name(case)),
        };
    }
    out
}

/// The number of starts that synchronise, `?` with the number of undecided starts, and the time, as a cell of the table.
fn share(share: &Share) -> String {
    let time = share.time.map_or_else(|| "-".to_owned(), |time| format!("{time:.2}"));
    let open = if share.undecided() > 0 { format!("?{}", share.undecided()) } else { String::new() };
    format!("{:>15}", format!("{}{open} {time:>5}", share.in_step))
}

fn name(case: &Case) -> String {
    let place = if case.in_gyrostat { "in the gyrostat" } else { "on the bench" };
    match case.bars {
        None => place.to_owned(),
        Some(1) => format!("{place}, 1 bar"),
        Some(bars) => format!("{place}, {bars} bars"),
    }
}

fn object(scene: &Scene, common: &Common, cases: &[Case]) -> Value {
    let Common { motor, in_step, pull_out, .. } = common;
    let facts = &motor.facts;
    let each = cases.iter().map(|case| {
        let pull_in = case.pull_in.as_ref().ok().and_then(Option::as_ref);
        let shares = case.shares.as_ref().ok().map(|shares| {
            let one = |share: &Share| {
                json!({ "load": share.load, "starts": share.starts, "in_step": share.in_step, "slipping": share.slipping,
                        "undecided": share.undecided(), "time": share.time })
            };
            shares.iter().map(one).collect::<Vec<_>>()
        });
        let slipping = |one: &Slipping| json!({ "slip": one.slip(), "period": one.period, "multiplier": one.multiplier });
        json!({
            "place": if case.in_gyrostat { "gyrostat" } else { "bench" }, "bars": case.bars, "axial": case.axial,
            "pull_in": pull_in.map(|found| found.load), "onset": pull_in.map(|found| onset(found.by)),
            "long_turns": case.limit,
            "unloaded": case.unloaded.iter().map(slipping).collect::<Vec<_>>(), "shares": shares,
        })
    });
    json!({
        "scene": scene.title, "model": motor.machine.name(), "field_speed": facts.field_speed, "hold": facts.hold,
        "friction": facts.friction, "frequency": facts.frequency,
        "pull_out": { "load": pull_out.load, "angle": pull_out.angle },
        "in_step": in_step.iter().map(|one| json!({ "angle": one.angle, "load": one.load, "growth": one.growth, "fold": one.fold })).collect::<Vec<_>>(),
        "motors": each.collect::<Vec<_>>(),
    })
}
