//! A motor whose laws are expressions in a scene file:
//!
//! ```toml
//! [machine]
//! model = "text"
//! field_speed = "150 rad/s"
//! field_energy = "-b0*cos(g)"            # U(g), J
//! torque_law = "-mu*g' - f*phi'"         # m(g', phi'), N m
//!
//! [machine.parameters]
//! b0 = "0.15 N m"
//!
//! [[machine.winding]]
//! inductance = "l1"
//! resistance = "r1"
//! flux = "a1*cos(g)"                     # psi_k(g), Wb; where the field goes through it
//! supply = "v0*sin(g)"                   # v_k(g), V; where there is one
//! motional = "k*iq"                      # c_k(i), V s, affine in the currents; where conductors slide: the voltage per speed
//!                                        # against the supply (back-EMF), L i' = v - R i - c phi'
//! current = "id"                         # its name; without it x, i1, i2, ...
//! ```

mod law;
mod names;

use crate::text::{FIELD_SPEED, KnownMotion, NAME};
use crate::{Expressions, Laws, Motor, RotorState, Winding, runaway};
use law::{Kind, Reader};
use names::Names;
use reader::{Allowed, At, Bound, Issue, NO_MUTUAL_INDUCTANCE, Quantity, Table};
use std::ops::Range;
use std::sync::Arc;
use symbolic::Sym;

/// The largest numbers of windings and of parameters.
const WINDINGS: usize = 100;
const PARAMETERS: usize = 200;

const FIELD_ENERGY: Kind = Kind {
    key: "field_energy",
    meaning: "energy U(g) of the rotor in the field",
    unit: "J",
    motion: KnownMotion::Angle,
};
const TORQUE_LAW: Kind = Kind {
    key: "torque_law",
    meaning: "torque m(g', phi') of friction and slip",
    unit: "N m",
    motion: KnownMotion::Speeds,
};
const FLUX: Kind = Kind {
    key: "flux",
    meaning: "flux psi(g) of the stator's field through the winding",
    unit: "Wb",
    motion: KnownMotion::Angle,
};
const INDUCTANCE: Kind =
    Kind { key: "inductance", meaning: "inductance of the winding", unit: "H", motion: KnownMotion::Rest };
const RESISTANCE: Kind =
    Kind { key: "resistance", meaning: "resistance of the winding", unit: "ohm", motion: KnownMotion::Rest };
const SUPPLY: Kind =
    Kind { key: "supply", meaning: "voltage v(g) of the supply", unit: "V", motion: KnownMotion::Angle };
const MOTIONAL: Kind = Kind {
    key: "motional",
    meaning: "voltage c(i) per speed against the supply (back-EMF), L di/dt = v - R i - c phi'",
    unit: "V s",
    motion: KnownMotion::Currents,
};

/// The positions of a winding's data in the file.
struct Places {
    inductance: Range<usize>,
    resistance: Range<usize>,
    motional: Option<Range<usize>>,
}

/// Reads the rest of the table `[machine]` of a motor given by text.
pub(super) fn read(mut table: Table<'_>, issues: &mut Vec<Issue>) -> Option<Motor> {
    let mut wrong = Vec::new();
    let (span, allowed) = (table.span(), table.allowed());
    let speed = table.scalar(&FIELD_SPEED.name, &FIELD_SPEED.meaning, &FIELD_SPEED.unit);
    let mut names = Names::new(speed.value);
    let mut tables = table.tables("winding", "windings are tables, [[machine.winding]] each");
    names.read_currents(&mut tables);
    match table.optional_table("parameters") {
        Some(mut parameters) => {
            names.read_parameters(&mut parameters);
            wrong.extend(parameters.finish());
        }
        None if table.keys().iter().any(|key| units::nearest(&key.value, ["parameters"]).is_some()) => {
            names.lose_parameters();
        }
        None => {}
    }
    let mut laws = Reader::new(&names);
    let energy = laws.optional(&mut table, FIELD_ENERGY);
    let torque = laws.law(&mut table, TORQUE_LAW);
    let mut windings = Vec::new();
    for (mut winding, current) in tables.into_iter().zip(&names.currents) {
        windings.extend(read_winding(&mut winding, current, &mut laws));
        wrong.extend(winding.finish());
    }
    wrong.extend(laws.mismatches());
    if windings.len() > WINDINGS || names.given.len() > PARAMETERS {
        let title = format!("{} windings and {} parameters", windings.len(), names.given.len());
        let most = format!("at most {WINDINGS} windings and {PARAMETERS} parameters are accepted");
        wrong.push(Issue::at(span.clone(), title, "too many").accepted(most));
    }
    wrong.extend(table.finish());
    let sound = wrong.is_empty();
    issues.extend(wrong);
    let At { value: torque, span: torque_span } = torque.filter(|_| sound)?;
    let energy = energy.map_or(Sym::ZERO, |law| law.value);
    let (places, windings): (Vec<Places>, Vec<_>) = windings.into_iter().unzip();
    let found = issues.len();
    if !allowed.separate_fluxes {
        issues.extend(shared_flux(&windings, &places));
    }
    let (quantities, values): (Vec<Quantity>, Vec<f64>) =
        names.given.into_iter().map(|(quantity, _, value)| (quantity, value)).unzip();
    let expressions = Expressions {
        rotor: if Expressions::know_angle(energy, &windings) { RotorState::AngleAndSpeed } else { RotorState::Speed },
        frame_speed: Sym::symbol(&FIELD_SPEED.name),
        energy,
        torque,
        windings,
        settled: Vec::new(),
    };
    let laws = match Laws::new(NAME, quantities, Vec::new(), &expressions) {
        Ok(laws) => laws,
        Err(long) => {
            issues.push(Issue::at(span, format!("a law has {long}"), "in this table").accepted("a shorter law"));
            return None;
        }
    };
    let numbers = laws.numbers(values.clone());
    if numbers.iter().any(|number| !number.is_finite()) {
        let issue = Issue::at(span, "a number of the laws is not finite", "a root or quotient of these parameters");
        issues.push(issue.accepted("parameters whose roots and quotients exist"));
        return None;
    }
    for (k, Places { inductance, resistance, .. }) in places.into_iter().enumerate() {
        issues.extend(beyond("inductance", "H", Bound::Positive, laws.inductance(k, &numbers), inductance, allowed));
        issues.extend(beyond(
            "resistance",
            "ohm",
            Bound::Resistance,
            laws.resistance(k, &numbers),
            resistance,
            allowed,
        ));
    }
    let motor = Motor::new(Arc::new(laws), values, allowed);
    if !allowed.negative_friction
        && let [Some(backwards), Some(_)] = runaway(&motor)
    {
        let label = format!(
            "its power is {:.4} W at phi' = {:.4} rad/s, and more at higher speeds",
            backwards.power, backwards.at
        );
        let title = "the torque law drives the rotor ever harder in both directions";
        issues.push(Issue::at(torque_span, title, label).accepted(Bound::Friction.accepted(-1.0)));
    }
    (issues.len() == found).then_some(motor)
}

/// The issue of a winding's datum that is outside its bound.
fn beyond(what: &str, unit: &str, bound: Bound, value: f64, place: Range<usize>, allowed: Allowed) -> Option<Issue> {
    let issue = Issue::at(place, format!("`{what}` of a winding {}", bound.broken()), format!("it is {value} {unit}"));
    (!bound.holds(value, allowed)).then(|| issue.accepted(bound.accepted(value)))
}

/// The issue of windings that share flux: if conductors of one winding slide through the flux of several others, these
/// induce voltages in each other, which the laws do not include.
fn shared_flux(windings: &[Winding<Sym, Sym>], places: &[Places]) -> Option<Issue> {
    let sharing = windings.iter().zip(places).filter_map(|(winding, places)| {
        let leaves = winding.motional?.leaves_of();
        let held = |each: &&Winding<Sym, Sym>| leaves.contains(&Sym::symbol(&each.current));
        let held: Vec<&str> = windings.iter().filter(held).map(|each| each.current.as_str()).collect();
        Some((held, places.motional.clone()?)).filter(|(held, _)| held.len() > 1)
    });
    let mut sharing = sharing.peekable();
    let (held, place) = sharing.next()?;
    let more = match sharing.count() {
        0 => String::new(),
        1 => "; likewise in one more winding".to_owned(),
        more => format!("; likewise in {more} more windings"),
    };
    let (first, second) = (held[0], held[1]);
    let label = format!(
        "`{first}` and `{second}` make one flux here, so M d({second})/dt is a voltage in the winding of `{first}` and M d({first})/dt in \
         that of `{second}`: they would be lost{more}"
    );
    let accepted = format!(
        "{NO_MUTUAL_INDUCTANCE}. `allow = [\"{}\"]` at the top of the file says of currents in one `motional` that they do not \
         induce in each other",
        Allowed::SEPARATE_FLUXES
    );
    Some(Issue::at(place, "`motional` holds the flux of windings with mutual inductance", label).accepted(accepted))
}

/// Reads a winding whose current has this name, with the positions of its data; `None` where it is faulty, which is
/// reported.
fn read_winding(table: &mut Table<'_>, current: &str, laws: &mut Reader<'_>) -> Option<(Places, Winding<Sym, Sym>)> {
    let flux = laws.optional(table, FLUX);
    let inductance = laws.law(table, INDUCTANCE);
    let resistance = laws.law(table, RESISTANCE);
    let supply = laws.optional(table, SUPPLY);
    let motional = laws.optional(table, MOTIONAL);
    let (inductance, resistance) = (inductance?, resistance?);
    let places = Places {
        inductance: inductance.span,
        resistance: resistance.span,
        motional: motional.as_ref().map(|law| law.span.clone()),
    };
    let winding = Winding {
        current: current.to_owned(),
        flux: flux.map_or(Sym::ZERO, |law| law.value),
        supply: supply.map(|law| law.value),
        motional: motional.map(|law| law.value),
        inductance: inductance.value,
        resistance: resistance.value,
    };
    Some((places, winding))
}
