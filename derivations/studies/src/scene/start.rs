//! The initial state of a scene.

use super::bodies::normalised;
use motor::{Machine, Motor};
use nalgebra::Vector3;
use reader::{Issue, Table};

/// The largest deviation of the vertical's length from one.
const ROUNDING: f64 = 1e-12;

/// The initial state, in the axes of the data.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// The angular velocity w of the carrier, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// The unit vector v of the vertical, downwards.
    pub vertical: Vector3<f64>,
    /// The angle g of the rotor relative to the stator's field, rad.
    pub rotor_angle: f64,
    /// The speed phi' of the rotor relative to the carrier, rad/s.
    pub rotor_speed: f64,
    /// The currents of the windings, A; empty if all are zero.
    pub currents: Vec<f64>,
}

/// Reads the table `[start]`.
pub fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>, on_bench: bool, machine: Option<&Motor>) -> Option<Start> {
    let mut table = top.table("start", "the initial state");
    let (mut angular_velocity, mut vertical) = (Vector3::zeros(), Vector3::z());
    if !on_bench {
        angular_velocity = table.vector("angular_velocity", "angular velocity of the carrier", "rad/s").value;
        let given = table.vector("vertical", "unit vector of the vertical, downwards", "1");
        vertical = given.value;
        let length = vertical.norm();
        if table.exists() && !table.has_issue_at(&given.span) && (length - 1.0).abs() > ROUNDING {
            let issue = Issue::at(given.span, "`vertical` is no unit vector", format!("its length is {length}"));
            table.report(issue.accepted(normalised(&vertical)));
        }
    }
    let rotor_angle = table.optional_scalar("rotor_angle", "angle of the rotor against the stator's field", "rad");
    let rotor_speed = rotor_speed(&mut table, machine);
    let currents = currents(&mut table, machine);
    let sound = table.exists() && !table.has_issues();
    issues.extend(table.finish());
    sound.then(|| Start {
        angular_velocity,
        vertical,
        rotor_angle: rotor_angle.map_or(0.0, |angle| angle.value),
        rotor_speed,
        currents,
    })
}

/// Reads the currents: one for each winding, or none if all are zero.
fn currents(table: &mut Table<'_>, machine: Option<&Motor>) -> Vec<f64> {
    let meaning =
        "row of currents, one for each winding, in the order of the states; of an excitation less its constant part";
    // without a machine the number of windings is unknown
    let Some(windings) = machine.map(Machine::windings) else {
        table.known(&["currents"]);
        return Vec::new();
    };
    match table.optional_row("currents", meaning, windings.max(1), "A") {
        Some(given) if windings == 0 => {
            let issue = Issue::at(given.span, "`currents` of a machine without windings", "it has no currents");
            table.report(issue.accepted("leave it out"));
            Vec::new()
        }
        given => given.map_or_else(Vec::new, |given| given.value),
    }
}

/// Reads the rotor's speed; a machine that prescribes it admits no other.
fn rotor_speed(table: &mut Table<'_>, machine: Option<&Motor>) -> f64 {
    const KEY: (&str, &str, &str) = ("rotor_speed", "speed of the rotor relative to the carrier", "rad/s");
    // without a machine it is unknown whether a speed is needed
    let Some(machine) = machine else {
        return table.optional_scalar(KEY.0, KEY.1, KEY.2).map_or(0.0, |given| given.value);
    };
    let Some(kept) = machine.prescribed_speed() else {
        return table.scalar(KEY.0, KEY.1, KEY.2).value;
    };
    match table.optional_scalar(KEY.0, KEY.1, KEY.2) {
        Some(given) if !table.has_issue_at(&given.span) && (given.value - kept).abs() > ROUNDING * kept.abs() => {
            let label = format!("it is {} rad/s, and the machine keeps {kept} rad/s", given.value);
            let issue = Issue::at(given.span, "`rotor_speed` contradicts the machine", label);
            table.report(issue.accepted("leave it out"));
            kept
        }
        _ => kept,
    }
}

impl super::Scene {
    /// Whether the machine prescribes the rotor's speed.
    pub(super) fn keeps_speed(&self) -> bool {
        self.machine.prescribed_speed().is_some()
    }
}
