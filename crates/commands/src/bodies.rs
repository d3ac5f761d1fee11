//! `dalembert bodies`: mass properties of the gyrostat of a scene, from its physical data.

use crate::arguments::Format;
use crate::exit::{Exit, print};
use nalgebra::{Matrix3, Vector3};
use reader::Family;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;
use studies::scene::{Scene, Setup};
use systems::gyrostat::Gyrostat;

/// Arguments of `bodies`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Prints both inertia tensors, their principal moments of inertia and principal axes, the rotation between these axes, and the weight.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    let scene = Scene::open(&asked.scene)?;
    let Setup::Gyrostat(bodies) = &scene.system else {
        return Err(Exit::refused(format!(
            "{} has no bodies but a rotor on a bench; a scene with system = \"gyrostat\" is accepted",
            asked.scene.display()
        )));
    };
    print(&match asked.format {
        Format::Text => text(bodies),
        Format::Json => format!("{:#}\n", object(bodies)),
    })?;
    Ok(Exit::Done)
}

fn text(bodies: &Gyrostat<f64>) -> String {
    let derived = bodies.derived();
    let mut out = String::from("In the axes of the data; kg m^2, m, N m.\n");
    // writing to a String cannot fail
    let mut tensor = |name: &str, tensor: &Matrix3<f64>| {
        let _ = writeln!(out, "\n{name}");
        for row in tensor.row_iter() {
            let _ = writeln!(out, "  {:>12.5e} {:>12.5e} {:>12.5e}", row[0], row[1], row[2]);
        }
    };
    tensor("A, tensor without the rotor's moment about its axis", &bodies.reduced_tensor());
    tensor("A*, tensor of all masses", &bodies.full_tensor());
    tensor("principal axes of A (columns)", &derived.reduced.axes);
    tensor("principal axes of A* (columns)", &derived.full.axes);
    tensor("axes of A* in the axes of A (columns)", &derived.rotation);
    let mut line = |name: &str, v: &Vector3<f64>| {
        let _ = writeln!(out, "{name:<24} {:>12.5e} {:>12.5e} {:>12.5e}", v.x, v.y, v.z);
    };
    line("\nprincipal moments of A", &derived.reduced.moments);
    line("principal moments of A*", &derived.full.moments);
    line("c, centre of mass", &derived.centre);
    line("e, its direction", &derived.direction);
    let _ = writeln!(out, "{:<24} {:>12.5e}", "Gamma = m g |c|", derived.gamma);
    let _ = writeln!(out, "{:<24} {:>12.5e}", "D = det A / det A*", derived.singularity);
    out
}

fn object(bodies: &Gyrostat<f64>) -> Value {
    let derived = bodies.derived();
    let rows = |m: &Matrix3<f64>| m.row_iter().map(|r| vec![r[0], r[1], r[2]]).collect::<Vec<_>>();
    json!({
        "A": { "tensor": rows(&bodies.reduced_tensor()), "moments": derived.reduced.moments.as_slice(),
               "axes": rows(&derived.reduced.axes) },
        "A*": { "tensor": rows(&bodies.full_tensor()), "moments": derived.full.moments.as_slice(),
                "axes": rows(&derived.full.axes) },
        "rotation": rows(&derived.rotation),
        "c": derived.centre.as_slice(),
        "e": derived.direction.as_slice(),
        "Gamma": derived.gamma,
        "D": derived.singularity,
    })
}
