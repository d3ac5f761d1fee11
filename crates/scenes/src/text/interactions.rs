//! The tables of interactions between bodies: forces, torques, contacts, diodes, freewheels and drives.

use super::machines::machine;
use super::{placed, text_of};
use model::{ContactSource, DriveSource, Entry, LoadSource, OneWay, OneWaySource, Text, WindingSource};
use reader::{Issue, Table};

pub(super) fn loads(top: &mut Table<'_>, name: &str) -> Vec<LoadSource> {
    let needed = format!("[[{name}]] in double brackets is accepted, since a system may have several");
    let mut loads = Vec::new();
    for mut table in top.tables(name, &needed) {
        let own_name = text_of(&mut table, "name", "name");
        let on = text_of(&mut table, "on", "\"disc at G\"");
        let along = if name == "force" { text_of(&mut table, "along", "coordinate") } else { None };
        let between = pair(&mut table, "[\"a at P\", \"b at Q\"]");
        let is = table.text("is", "value: a vector, or a scalar along a line");
        let is = placed(&table, &is);
        let at = table.span();
        let sound = !table.has_issues();
        top.absorb(table);
        if sound {
            loads.push(LoadSource { name: own_name, on, along, between, is, at });
        }
    }
    loads
}

/// The key `between = ["a", "b"]` of a table; `None` if it is missing or has a fault.
fn pair(table: &mut Table<'_>, example: &str) -> Option<[Text; 2]> {
    let pair = table.texts("between", example);
    match pair.as_slice() {
        [] => None,
        [first, second] => Some([placed(table, first), placed(table, second)]),
        _ => {
            let issue = Issue::at(table.span(), "`between` has two places", format!("{} stand here", pair.len()));
            table.report(issue.accepted(format!("between = {example}")));
            None
        }
    }
}

/// The drives of a file, and the data of their motors as additional parameters.
pub(super) fn drives(top: &mut Table<'_>) -> (Vec<DriveSource>, Vec<Entry>) {
    let (mut drives, mut parameters) = (Vec::new(), Vec::new());
    for mut table in top.tables("drive", "[[drive]] in double brackets is accepted, since a system may have several") {
        if let Some(model) = table.optional_text("model", "model of the motor").filter(|model| model.value != "text") {
            let issue = Issue::at(model.span.clone(), "the model of a motor stands in [drive.machine]", "not here");
            table.report(issue.accepted(
                "[drive.machine] with `model` and its data; or [[drive.winding]] and `torque` of this drive",
            ));
        }
        let mut text = |key: &str, needed: &str| text_of(&mut table, key, needed);
        let mut drive = DriveSource {
            name: text("name", "name"),
            turns: text("turns", "angle of the shaft"),
            ratio: text("ratio", "turns of the motor for one of the shaft"),
            inertia: text("inertia", "moment of inertia of the rotor"),
            torque: text("torque", "torque on the motor"),
            ..DriveSource::default()
        };
        drive.between = pair(&mut table, "[\"carriage\", \"wheel\"]");
        for mut winding in table.tables("winding", "windings are tables, [[drive.winding]] each") {
            let mut text = |key: &str, needed: &str| text_of(&mut winding, key, needed);
            let source = WindingSource {
                current: text("current", "name of the current"),
                resistance: text("resistance", "resistance"),
                supply: text("supply", "voltage"),
                motional: text("motional", "voltage per speed against the supply"),
                ..WindingSource::default()
            };
            let inductance = winding.text("inductance", "inductance, of positions");
            let (inductance, at) = (placed(&winding, &inductance), winding.span());
            table.absorb(winding);
            drive.windings.push(WindingSource { inductance, at, ..source });
        }
        if !drive.windings.is_empty()
            && let Some(place) = table.place_of("machine")
        {
            let issue =
                Issue::at(place, "a drive has windings of its own, or a machine with its windings", "beside windings");
            table.report(issue.accepted("one of [[drive.winding]] and [drive.machine]"));
        }
        parameters.extend(machine(&mut table, &mut drive));
        drive.at = table.span();
        let sound = !table.has_issues();
        top.absorb(table);
        if sound {
            drives.push(drive);
        }
    }
    (drives, parameters)
}

pub(super) fn contacts(top: &mut Table<'_>) -> Vec<ContactSource> {
    let mut contacts = Vec::new();
    for mut table in
        top.tables("contact", "[[contact]] in double brackets is accepted, since a system may have several")
    {
        let mut text = |key: &str, needed: &str| text_of(&mut table, key, needed);
        let mut contact = ContactSource {
            name: text("name", "name"),
            of: text("of", "\"ladder at B\""),
            with: text("with", "body that is touched"),
            between: text("between", "\"slider, N along x\""),
            through: text("through", "point of the plane"),
            normal: text("normal", "direction in which the gap grows, a vector"),
            gap: text("gap", "gap, a length"),
            sides: text("sides", "\"one\" or \"both\""),
            friction: text("friction", "coefficient of friction"),
            restitution: text("restitution", "coefficient of restitution"),
            impact: text("impact", "\"newton\", \"poisson\" or \"moreau\""),
            touching: false,
            at: 0..0,
        };
        contact.touching = table.flag("touching", "the start is completed so that it touches");
        contact.at = table.span();
        let sound = !table.has_issues();
        top.absorb(table);
        if sound {
            contacts.push(contact);
        }
    }
    contacts
}

/// The diodes of a file, then its freewheels.
pub(super) fn one_ways(top: &mut Table<'_>) -> Vec<OneWaySource> {
    let mut one_ways = Vec::new();
    for (is, key, needed) in [
        (OneWay::Diode, "current", "current that does not fall below zero, \"q'\""),
        (OneWay::Freewheel, "speed", "speed that does not fall below zero, \"a'\""),
    ] {
        let several = format!("[[{}]] in double brackets is accepted, since a system may have several", is.name());
        for mut table in top.tables(is.name(), &several) {
            let name = text_of(&mut table, "name", "name");
            let speed = table.text(key, needed);
            let speed = placed(&table, &speed);
            let drop = text_of(&mut table, "drop", "forward voltage, torque or force while it conducts or runs free");
            let at = table.span();
            let sound = !table.has_issues();
            top.absorb(table);
            if sound {
                one_ways.push(OneWaySource { is, name, speed, drop, at });
            }
        }
    }
    one_ways
}
