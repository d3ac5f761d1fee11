//! The table `[drive.machine]`: a motor model of the program by its name, or with `model = "text"` a law in the letters of a motor.
//!
//! The laws of a motor depend on the angle g = p - W t from its field to its rotor, with the angle p of the rotor and the speed W of the field.
//! They are evaluated once with the quantities of the drive as letters, which gives expressions as in a file: the torque and, for each winding,
//! the equation of its circuit,
//!
//!   torque m(g', p') - dU/dg ,    L i' = v + W psi' - R i - (psi' + c) p' .

use field::Analytic;
use model::{DriveSource, Entry, Text, WindingSource};
use motor::text::NAME;
use motor::{Machine, Motor, catalogue, machine_table};
use reader::{Issue, Quantity, Table};
use symbolic::{Sym, apart};

/// Reads `[drive.machine]` and adds its laws to the drive. Returns its data as parameters, such as `motor_voltage` for the drive `motor`.
pub(super) fn machine(table: &mut Table<'_>, drive: &mut DriveSource) -> Vec<Entry> {
    table.known(&["machine"]);
    let Some(at) = table.place_of("machine").map(|at| at.start) else { return Vec::new() };
    if let Some(issue) = unknown(table) {
        table.report(issue);
        return Vec::new();
    }
    let mut issues = Vec::new();
    let found = machine_table::read(table, &mut issues);
    issues.into_iter().for_each(|issue| table.report(issue));
    found.map_or_else(Vec::new, |motor| driven_by(drive, &motor, at))
}

/// Adds the laws of a motor to a drive. Returns its data as parameters, such as `motor_voltage` for the drive `motor`; all texts have the place
/// `at` in the file.
pub fn driven_by(drive: &mut DriveSource, motor: &Motor, at: usize) -> Vec<Entry> {
    let name = drive.name.as_ref().map_or("drive", |name| name.text.as_str()).to_owned();
    let written = |text: String| Text::at(text, at);
    let laws = apart(|| texts(&name, motor));
    drive.torque = match drive.torque.take() {
        Some(own) => Some(Text { text: format!("({}) + ({})", own.text, laws.torque), ..own }),
        None => Some(written(laws.torque)),
    };
    drive.windings.extend(laws.windings.into_iter().map(|winding| WindingSource {
        current: Some(written(winding.current)),
        inductance: written(winding.inductance),
        resistance: Some(written(winding.resistance)),
        supply: winding.supply.map(written),
        motional: winding.motional.map(written),
        at: at..at,
    }));
    let datum = |(quantity, value): (&Quantity, f64)| Entry {
        name: written(letter(&name, &quantity.name)),
        value: written(match &*quantity.unit {
            "1" => format!("{value:?}"),
            unit => format!("{value:?} {unit}"),
        }),
    };
    motor.data().map(datum).collect()
}

/// The fault of an unknown name, or of a motor that prescribes the speed; the reader of the table reports a missing name.
fn unknown(table: &mut Table<'_>) -> Option<Issue> {
    if !table.is_table("machine") {
        return None;
    }
    let mut machine = table.optional_table("machine")?;
    let model = machine.text("model", "name of the machine");
    let name = model.value.as_str();
    let is_prescribed =
        |name: &str| catalogue::sampled(name, |_| 1.0, 1).is_some_and(|motor| motor.prescribed_speed().is_some());
    if is_prescribed(name) {
        let title = format!("`{name}` keeps the speed of its rotor under every load");
        let issue = Issue::at(model.span, title, "this is a constraint, no motor");
        return Some(issue.accepted("[[constraint]] zero = \"theta' - w\" in the place of this drive"));
    }
    if name.is_empty() || name == NAME || catalogue::entry(name).is_some() {
        return None;
    }
    let known = catalogue::entries().into_iter().map(|entry| entry.name).filter(|known| !is_prescribed(known));
    let known: Vec<&str> = known.chain([NAME]).collect();
    let list = known.join(", ");
    let accepted = match units::nearest(name, known) {
        Some(nearest) => format!("is `{nearest}` meant? Known: {list}"),
        None => format!("known: {list}"),
    };
    Some(Issue::at(model.span, format!("unknown machine `{name}`"), "not known").accepted(accepted))
}

/// The name of the parameter for a datum of a motor.
fn letter(drive: &str, datum: &str) -> String {
    format!("{drive}_{datum}")
}

/// The laws of a motor as texts.
struct Texts {
    torque: String,
    windings: Vec<Circuit>,
}

struct Circuit {
    current: String,
    inductance: String,
    resistance: String,
    supply: Option<String>,
    motional: Option<String>,
}

/// The laws of a motor in the drive of this name, as texts.
fn texts(drive: &str, motor: &Motor) -> Texts {
    let machine = motor.over(|quantity, _| Sym::symbol(&letter(drive, &quantity.name)));
    let of_drive = |part: &str| Sym::symbol(&format!("{}.{part}", drive));
    let (speed, field_speed) = (of_drive("speed"), machine.frame_speed());
    let turned = field_speed * Sym::symbol("t");
    let angle = (of_drive("angle") - turned).circle();
    let varied = angle.varied();
    let torque = machine.torque_law(speed - field_speed, speed) - machine.field_energy(varied).slope;
    let currents: Vec<Sym> = (0..machine.windings()).map(|winding| of_drive(&machine.current_name(winding))).collect();
    let some = |law: Sym| (law != Sym::ZERO).then(|| law.to_string());
    let circuit = |winding: usize| {
        let by_angle = machine.linkage(winding, varied).slope;
        let supply = machine.supply(winding, angle).unwrap_or(Sym::ZERO);
        let motional = machine.motional(winding, &currents).unwrap_or(Sym::ZERO);
        Circuit {
            current: machine.current_name(winding),
            inductance: machine.inductance(winding).to_string(),
            resistance: machine.resistance(winding).to_string(),
            supply: some(supply + field_speed * by_angle),
            motional: some(by_angle + motional),
        }
    };
    Texts { torque: torque.to_string(), windings: (0..machine.windings()).map(circuit).collect() }
}
