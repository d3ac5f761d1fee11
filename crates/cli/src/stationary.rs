//! `dalembert stationary`: all stationary motions of a scene, with the certificate that none is missing, and whether each is
//! stable.

use crate::arguments::{Format, finite};
use crate::ending::{Ending, print};
use crate::run::with_model;
use crate::stability;
use clap::Args;
use derivations::scene::{Family, Scene};
use derivations::stationary::energies::Kept;
use derivations::stationary::motions::{Answer, Certificate, Found, NoAnswer, Stationary};
use derivations::stationary::motor::{Angle, Motor, Slip};
use mechanics::uniform::{Census, Kind, Shape, Undecided};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;

/// Which stationary motions are to be found.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Those with this angular velocity about the vertical, rad/s
    #[arg(long, value_name = "W", value_parser = finite, allow_negative_numbers = true, conflicts_with_all = ["momentum", "cone"])]
    pub omega0: Option<f64>,
    /// Those with this angular momentum about the vertical, N m s; without any of the three, that of the scene's start
    #[arg(long, value_name = "P", value_parser = finite, allow_negative_numbers = true, conflicts_with = "cone")]
    pub momentum: Option<f64>,
    /// How many there are for every angular velocity, and where two merge
    #[arg(long)]
    pub cone: bool,
    /// Another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Prints them.
pub fn show(asked: &Asked) -> Result<Ending, Ending> {
    let scene = with_model(Scene::open(&asked.scene)?, asked.model.as_deref(), &asked.scene)?;
    let refused = |reason: NoAnswer| Ending::refused(format!("{}: {reason}", asked.scene.display()));
    let all = Stationary::of(&scene).map_err(refused)?;
    if asked.cone {
        let census = all.census();
        print(&match asked.format {
            Format::Text => format!("{}\n{}{}", scene.title, motor(&all.motor), counts(&all, &census)),
            Format::Json => format!("{:#}\n", census_object(&scene, &all, &census)),
        })?;
        return Ok(if census.iter().all(Result::is_ok) { Ending::Done } else { Ending::Stopped });
    }
    let (given, answers) = match (asked.omega0, asked.momentum) {
        (Some(w), _) => (Given::Speed(w), all.at_speed(w).map_err(refused)?),
        (None, p) => {
            let p = p.unwrap_or_else(|| all.momentum_at_start());
            (Given::Momentum(p), all.at_momentum(p).map_err(refused)?)
        }
    };
    print(&match asked.format {
        Format::Text => text(&scene, &all, given, &answers),
        Format::Json => format!("{:#}\n", object(&scene, &all, given, &answers)),
    })?;
    let complete = answers.iter().all(|answer| answer.certificate.is_complete());
    Ok(if complete { Ending::Done } else { Ending::Stopped })
}

/// What all motions have in common.
#[derive(Clone, Copy)]
enum Given {
    Speed(f64),
    Momentum(f64),
}

fn text(scene: &Scene, all: &Stationary<'_>, given: Given, answers: &[Answer]) -> String {
    let mut out = format!("{}\n{}", scene.title, motor(&all.motor));
    // writing to a String cannot fail
    let _ = match given {
        Given::Speed(w) => writeln!(out, "angular velocity about the vertical: {w} rad/s"),
        Given::Momentum(p) => writeln!(out, "angular momentum about the vertical: {p} N m s"),
    };
    for answer in answers {
        let _ = writeln!(out, "\n{}: {}", kept(all.kept, answer.value), certificate(answer));
        if !answer.found.is_empty() {
            let head = ["v1", "v2", "v3", "w0, rad/s", "phi', rad/s", "x.v, N m s", "residual"];
            let head = head.map(|name| format!("{name:>13}")).concat();
            let _ = writeln!(out, "  W           {head}");
        }
        for (place, found) in answer.found.iter().enumerate() {
            out += &line(place + 1, found);
            out += &stability::text(&all.motor, &found.stability);
        }
    }
    out
}

fn line(place: usize, found: &Found) -> String {
    let numbers = [
        found.enclosed[0].to_f64(),
        found.enclosed[1].to_f64(),
        found.enclosed[2].to_f64(),
        found.speed,
        found.rotor_speed,
        found.momentum,
    ];
    let numbers = numbers.map(|x| format!("{x:>13.8}")).concat();
    let mut out = format!("  {place} {:<10}{numbers}{:>13.1e}\n", kind(found.kind), found.residual);
    if let Some([low, high]) = found.multiplier {
        let _ = writeln!(out, "    lambda alone in [{low:.6e}, {high:.6e}] N m");
    }
    let family = match (found.shape, found.circle) {
        (Shape::Circle { .. }, Some((radius, axis))) => format!(
            "a family: the circle of radius {radius:.8} about the axis ({:.8}, {:.8}, {:.8}), its centre is given",
            axis.x, axis.y, axis.z
        ),
        (Shape::Sphere, _) => "a family: every direction".to_owned(),
        (Shape::Pair { .. }, _) => "one of two on both sides of a principal plane".to_owned(),
        _ => return out,
    };
    let _ = writeln!(out, "    {family}");
    out
}

/// `6 of 6; none missing: ...`
fn certificate(answer: &Answer) -> String {
    let Certificate { degree, roots, again, morse, undecided } = &answer.certificate;
    let families = answer.found.iter().filter(|one| matches!(one.shape, Shape::Circle { .. } | Shape::Sphere)).count();
    let isolated = answer.found.len() - families;
    let number = |n: usize, name: &str| format!("{n} {name}{}", if n == 1 { "" } else { "s" });
    let mut out = number(isolated, "motion");
    if families > 0 {
        let _ = write!(
            out,
            " and {} of motions",
            if families == 1 { "a family".to_owned() } else { format!("{families} families") }
        );
    }
    if !answer.certificate.is_complete() {
        let reasons: Vec<&str> = undecided.iter().map(why).collect();
        let _ = write!(out, "; that none is missing is NOT proved: {}", reasons.join("; "));
        return out;
    }
    let _ = write!(out, "; none missing: {} of a polynomial of degree {degree}, isolated", number(*roots, "real root"));
    if again.is_some() {
        out += " by Descartes' rule and counted again by Sturm's theorem";
    }
    let beyond = answer.found.iter().filter(|one| !matches!(one.shape, Shape::Point)).count();
    if beyond > 0 {
        let _ = write!(out, ", and {beyond} at eigenvalues that the weight and the rotor do not see");
    }
    match morse {
        Some(sum) => {
            let _ = write!(out, "; minima - saddles + maxima = {sum}");
        }
        None if again.is_some() => out += "; two motions merge here",
        None => {}
    }
    out
}

fn why(reason: &Undecided) -> &'static str {
    match reason {
        Undecided::Curve => "motions with this momentum form curves",
        Undecided::Several => "several angular velocities go with one multiplier",
        Undecided::Axis(0) => "a motion about the first principal axis is not excluded",
        Undecided::Axis(1) => "a motion about the second principal axis is not excluded",
        Undecided::Axis(_) => "a motion about the third principal axis is not excluded",
        Undecided::TwoFields => "the rotor's speed and a principal moment are both irrational",
        Undecided::Rests => "the carrier may rest in any direction with this momentum of the rotor",
    }
}

fn kept(kept: Kept, value: f64) -> String {
    match kept {
        Kept::RelativeSpeed => format!("rotor at {value} rad/s"),
        Kept::Momentum => format!("rotor with the momentum {value} N m s, which it keeps"),
    }
}

/// The rotor's side: speeds, angles, what the motor bears.
fn motor(motor: &Motor) -> String {
    let slope = |slope: i32| match slope {
        0 => "both merge here: pull-out",
        s if s < 0 => "the moment drives back to it",
        _ => "the moment drives away from it",
    };
    let mut out = String::new();
    let _ = match motor {
        Motor::Free => writeln!(out, "motor: none; any speed of the rotor is stationary"),
        Motor::Kept { speed } => writeln!(out, "motor: keeps the rotor at {} rad/s", speed.to_f64()),
        Motor::InStep { speed, angles, bears } => {
            let fed = if angles.iter().all(|angle| angle.currents.is_empty()) { ", without currents" } else { "" };
            let _ = writeln!(out, "motor: in step with its field at {} rad/s{fed}", speed.to_f64());
            if bears.is_some_and(|bears| bears.least == bears.greatest) {
                let _ = writeln!(out, "  no angle: in step nothing holds the rotor, it can only slip");
                return out;
            }
            if angles.is_empty() {
                let _ = writeln!(
                    out,
                    "  no angle: friction asks for more than the field gives; there is no stationary motion"
                );
            }
            for angle in angles {
                let _ = writeln!(
                    out,
                    "  gamma0 = {:.12} rad{}: {}",
                    angle.radians(),
                    currents(&angle.currents),
                    slope(angle.slope)
                );
            }
            match bears {
                Some(bears) => writeln!(
                    out,
                    "  pull-out: the angles merge where a further load on the rotor reaches {} N m against the field or {} N m with it",
                    bears.greatest, -bears.least
                ),
                None => Ok(()),
            }
        }
        Motor::Slipping { speeds, extremes } => {
            let _ = writeln!(out, "motor: by its slip, without an angle");
            for slip in speeds {
                let _ = writeln!(
                    out,
                    "  phi' = {:.12} rad/s{}: {}",
                    slip.speed.to_f64(),
                    currents(&slip.currents),
                    slope(slip.slope)
                );
            }
            for extreme in extremes {
                let _ = writeln!(
                    out,
                    "  pull-out: two speeds merge at {:.6} rad/s where a further load on the rotor reaches {:.6e} N m",
                    extreme.speed, extreme.moment
                );
            }
            Ok(())
        }
    };
    out
}

/// Those that a supply feeds.
fn currents(of: &[f64]) -> String {
    let each: Vec<String> = of.iter().map(|current| format!("{current:.6e}")).collect();
    if each.is_empty() { String::new() } else { format!(" with the currents {} A", each.join(", ")) }
}

fn counts(all: &Stationary<'_>, census: &[Result<Census, Undecided>]) -> String {
    let mut out = String::new();
    for (case, census) in all.cases.iter().zip(census) {
        let _ =
            writeln!(out, "\n{}: the number of stationary motions for every w0", kept(all.kept, case.value.to_f64()));
        match census {
            Ok(census) => {
                for stretch in &census.stretches {
                    let families = if stretch.families > 0 {
                        format!(" and {} families", stretch.families)
                    } else {
                        String::new()
                    };
                    let _ = writeln!(
                        out,
                        "  {:>16.9} < w0 < {:<16.9} {}{families}",
                        stretch.from, stretch.to, stretch.isolated
                    );
                }
                out += "  none missing: every angular velocity at which two motions merge is a common root of two polynomials, isolated;\n  \
                        between two of them, and zero, the number is constant and was counted once, exactly\n";
            }
            Err(reason) => {
                let _ = writeln!(out, "  not known: {}", why(reason));
            }
        }
    }
    out
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Minimum => "minimum",
        Kind::Saddle => "saddle",
        Kind::Maximum => "maximum",
        Kind::Degenerate => "merging",
    }
}

fn shape(shape: Shape) -> &'static str {
    match shape {
        Shape::Point => "point",
        Shape::Pair { .. } => "one of a pair",
        Shape::Circle { .. } => "circle",
        Shape::Sphere => "sphere",
    }
}

fn object(scene: &Scene, all: &Stationary<'_>, given: Given, answers: &[Answer]) -> Value {
    let (name, value) = match given {
        Given::Speed(w) => ("omega0", w),
        Given::Momentum(p) => ("momentum", p),
    };
    let each = answers.iter().map(|answer| {
        let Certificate { degree, roots, again, morse, undecided } = &answer.certificate;
        json!({
            kept_name(all.kept): answer.value,
            "complete": answer.certificate.is_complete(),
            "certificate": { "degree": degree, "real_roots": roots, "by_sturm": again, "morse": morse,
                             "undecided": undecided.iter().map(why).collect::<Vec<_>>() },
            "motions": answer.found.iter().map(|found| motion(&all.motor, found)).collect::<Vec<_>>(),
        })
    });
    json!({ "scene": scene.title, "model": scene.machine.name(), "motor": motor_object(&all.motor), name: value,
            "cases": each.collect::<Vec<_>>() })
}

fn kept_name(kept: Kept) -> &'static str {
    match kept {
        Kept::RelativeSpeed => "rotor_speed",
        Kept::Momentum => "rotor_momentum",
    }
}

fn motion(motor: &Motor, found: &Found) -> Value {
    let boxed: Vec<[f64; 2]> = found.enclosed.iter().map(|x| x.ends()).collect();
    let circle = found.circle.map(|(radius, axis)| json!({ "radius": radius, "axis": axis.as_slice() }));
    json!({
        "shape": shape(found.shape), "kind": kind(found.kind), "multiplier": found.multiplier,
        "direction": found.enclosed.each_ref().map(|x| x.to_f64()), "box": boxed, "circle": circle,
        "omega0": found.speed, "rotor_speed": found.rotor_speed, "momentum": found.momentum, "residual": found.residual,
        "stability": stability::objects(motor, &found.stability),
    })
}

fn motor_object(motor: &Motor) -> Value {
    let slip = |slip: &Slip| json!({ "speed": slip.speed.to_f64(), "slope": slip.slope, "currents": slip.currents });
    let angle = |angle: &Angle| json!({ "angle": angle.radians(), "slope": angle.slope, "currents": angle.currents });
    match motor {
        Motor::Free => json!({ "kind": "free" }),
        Motor::Kept { speed } => json!({ "kind": "kept", "speed": speed.to_f64() }),
        Motor::InStep { speed, angles, bears } => json!({
            "kind": "in_step", "speed": speed.to_f64(), "angles": angles.iter().map(angle).collect::<Vec<_>>(),
            "bears": bears.map(|bears| [bears.least, bears.greatest]),
        }),
        Motor::Slipping { speeds, extremes } => json!({
            "kind": "slipping",
            "speeds": speeds.iter().map(slip).collect::<Vec<_>>(),
            "extremes": extremes.iter().map(|e| json!({ "speed": e.speed, "moment": e.moment })).collect::<Vec<_>>(),
        }),
    }
}

fn census_object(scene: &Scene, all: &Stationary<'_>, census: &[Result<Census, Undecided>]) -> Value {
    let finite = |w: f64| w.is_finite().then_some(w);
    let each = all.cases.iter().zip(census).map(|(case, census)| {
        let stretches = census.as_ref().ok().map(|census| {
            let stretch = |s: &mechanics::uniform::Stretch| {
                json!({ "from": finite(s.from), "to": finite(s.to), "isolated": s.isolated, "families": s.families })
            };
            census.stretches.iter().map(stretch).collect::<Vec<_>>()
        });
        json!({ kept_name(all.kept): case.value.to_f64(), "complete": census.is_ok(), "stretches": stretches })
    });
    json!({ "scene": scene.title, "model": scene.machine.name(), "motor": motor_object(&all.motor),
            "cone": each.collect::<Vec<_>>() })
}
