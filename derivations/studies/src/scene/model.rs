//! Scenes with a motor as models: carrier and rotor as bodies, the motor as a drive between them.
//!
//! The integrated law has only the vertical of the carrier's orientation, and the rotor's angle from the field; the
//! model has a free frame and the charges of the windings. Commands on equations use the model.

use super::{bodies, start};
use model::{BodySource, ConstraintSource, DriveSource, Entry, InertiaSource, Source, Text};
use motor::{Machine, Motor, state_names};
use reader::{Issue, Table};
use scenes::{NamedSystem, submit, text};
use systems::gyrostat::Gyrostat;

submit! { NamedSystem { name: "gyrostat", summary: "a heavy gyrostat with a fixed point and a motor that drives its rotor", runs: false, source: gyrostat } }
submit! { NamedSystem { name: "bench", summary: "a motor alone, its housing at rest", runs: false, source: bench } }

/// The name of the drive, whose symbols are `motor.angle`, `motor.speed`, `motor.x`.
const DRIVE: &str = "motor";

fn gyrostat(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Source> {
    source(top, issues, false)
}

fn bench(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Source> {
    source(top, issues, true)
}

/// Reads the tables of a scene with a motor, and builds the model.
fn source(top: &mut Table<'_>, issues: &mut Vec<Issue>, on_bench: bool) -> Option<Source> {
    top.read_allowed();
    let mut source = match on_bench {
        true => of_rotor(bodies::bench(top, issues)?),
        false => of_bodies(&bodies::gyrostat(top, issues)?),
    };
    let machine = motor::machine_table::read(top, issues)?;
    let start = start::read(top, issues, on_bench, Some(&machine))?;
    source.start.extend([entry("phi", start.rotor_angle, "rad"), entry("phi'", start.rotor_speed, "rad/s")]);
    if !on_bench {
        let v = start.vertical;
        let turned = format!("{:?} rad about x, then {:?} rad about y", v.y.asin(), (-v.x).atan2(v.z));
        source.start.push(("C", turned.as_str()).into());
        let rates = ["C.wx", "C.wy", "C.wz"].into_iter().zip(start.angular_velocity.iter());
        source.start.extend(rates.map(|(name, &rate)| entry(name, rate, "rad/s")));
    }
    drive(&mut source, &machine, on_bench);
    let names = state_names(&machine);
    let currents = names[names.len() - machine.windings()..].iter().zip(&start.currents);
    source.start.extend(currents.map(|(name, &current)| entry(&format!("{DRIVE}.{name}"), current, "A")));
    Some(source)
}

/// The rotor alone, about a fixed axis.
fn of_rotor(axial: f64) -> Source {
    let rotor = BodySource {
        name: "rotor".into(),
        turns: Some("phi".into()),
        inertia: Some(InertiaSource::Axial("A".into())),
        ..BodySource::default()
    };
    Source {
        parameters: vec![entry("A", axial, "kg m^2")],
        coordinates: vec![("phi", "rad").into()],
        bodies: vec![rotor],
        ..Source::default()
    }
}

/// The carrier, which turns freely about O, and the rotor in it.
fn of_bodies(bodies: &Gyrostat<f64>) -> Source {
    let Gyrostat { carrier, rotor, gravity } = bodies;
    let axis = rotor.axis;
    let vector = |name: &str, vector: &nalgebra::Vector3<f64>, unit: &str| -> Vec<Entry> {
        (0..3).map(|k| entry(&format!("{name}{}", k + 1), vector[k], unit)).collect()
    };
    let tensor = [("J11", 0, 0), ("J22", 1, 1), ("J33", 2, 2), ("J12", 0, 1), ("J13", 0, 2), ("J23", 1, 2)];
    let mut parameters = vec![entry("m0", carrier.mass, "kg")];
    parameters.extend(vector("c", &carrier.centre, "m"));
    parameters.extend(tensor.map(|(name, i, j)| entry(name, carrier.inertia[(i, j)], "kg m^2")));
    parameters.push(entry("m1", rotor.mass, "kg"));
    parameters.extend(vector("h", &rotor.centre, "m"));
    // the axis is z of T, rotated by alpha about z of the carrier, then by beta about y
    parameters.push(entry("alpha", axis.y.atan2(axis.x), "rad"));
    parameters.push(entry("beta", axis.x.hypot(axis.y).atan2(axis.z), "rad"));
    parameters.push(entry("A", rotor.axial, "kg m^2"));
    parameters.push(entry("B", rotor.transverse, "kg m^2"));
    parameters.push(entry("g", *gravity, "m/s^2"));
    let about_centre = [
        "J11 - m0*(c2^2 + c3^2)",
        "J22 - m0*(c3^2 + c1^2)",
        "J33 - m0*(c1^2 + c2^2)",
        "J12 + m0*c1*c2",
        "J13 + m0*c1*c3",
        "J23 + m0*c2*c3",
    ];
    let of_rotor = ["B", "B", "A"].map(|moment| Some(Text::from(moment)));
    let [xx, yy, zz] = of_rotor;
    let body = |name: &str, frame: &str, centre: &str, mass: &str, axes: &str, entries: [Option<Text>; 6]| BodySource {
        name: name.into(),
        frame: Some(frame.into()),
        centre: Some(centre.into()),
        mass: Some(mass.into()),
        inertia: Some(InertiaSource::Tensor { axes: Some(axes.into()), entries: Box::new(entries) }),
        turns: None,
    };
    Source {
        parameters,
        coordinates: vec![("phi", "rad").into()],
        frames: vec![
            ("C", "N free").into(),
            ("S", "C turned alpha about z").into(),
            ("T", "S turned beta about y").into(),
            ("R", "T turned phi about z").into(),
        ],
        points: vec![("G0", "O + c1*C.x + c2*C.y + c3*C.z").into(), ("G1", "O + h1*C.x + h2*C.y + h3*C.z").into()],
        bodies: vec![
            body("carrier", "C", "G0", "m0", "C", about_centre.map(|text| Some(text.into()))),
            body("rotor", "R", "G1", "m1", "T", [xx, yy, zz, None, None, None]),
        ],
        // N.z points downwards
        gravity: Some("g*N.z".into()),
        outputs: vec![("v1", "C.x . N.z").into(), ("v2", "C.y . N.z").into(), ("v3", "C.z . N.z").into()],
        ..Source::default()
    }
}

/// Adds the motor between carrier and rotor, or the constraint of a prescribed speed.
fn drive(source: &mut Source, machine: &Motor, on_bench: bool) {
    if let Some(speed) = machine.prescribed_speed() {
        source.parameters.push(entry("W", speed, "rad/s"));
        source.constraints.push(ConstraintSource { zero: vec!["phi' - W".into()], ..ConstraintSource::default() });
        return;
    }
    let mut drive = DriveSource { name: Some(DRIVE.into()), ..DriveSource::default() };
    match on_bench {
        true => drive.turns = Some("phi".into()),
        false => drive.between = Some(["T".into(), "R".into()]),
    }
    source.parameters.extend(text::driven_by(&mut drive, machine, 0));
    source.drives.push(drive);
}

/// A parameter with its value and unit.
fn entry(name: &str, value: f64, unit: &str) -> Entry {
    (name, format!("{value:?} {unit}").as_str()).into()
}
