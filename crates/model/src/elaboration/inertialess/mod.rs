//! Coordinates without inertia, such as the charge of a capacitor behind a resistor, or a point between an elastic and a viscous element.
//!
//! The law of such a coordinate contains no acceleration: r(q, u, t) = 0, inertia minus forces, is an equation for speeds or positions. It
//! becomes a constraint of the system. In
//!
//!   r = J lambda ,    J = dr/du
//!
//! the multiplier lambda vanishes along every motion, hence the constraint exerts no force. If constraints couple several such
//! coordinates, as Kirchhoff's current law couples the currents at a node, each remaining free combination has one law.
//!
//! A law that contains a condition or the voltage of a diode has a different solution in each case. It does not become a constraint: the
//! speeds that it determines, and those coupled to them, are algebraic unknowns of each case.

mod directions;
mod groups;

use crate::arena::Scalar;
use crate::equations::{Equation, Level, constraints_of, vanishes};
use crate::parts::Combination;
use crate::{Constraint, Contact, Fault, Model, QuasiVelocities, Trace, UnsolvedLaw, Zero};
use directions::{basis, speed_free, whole};
use field::{Rational, Scalar as _};
use groups::groups;
use std::borrow::Cow;
use symbolic::{Sym, apart};

/// Adds a constraint to the model for each law without accelerations. Returns the faults of quasi-velocities that are then too many.
pub(super) fn settle(model: &mut Model) -> Vec<Fault> {
    let (open, found) = apart(|| {
        let trace = Trace::of(model);
        let open = open(&trace);
        let laws = if open.is_empty() { Laws::default() } else { Laws::of(&trace, &open) };
        (open, laws)
    });
    model.algebraic_speeds = found.algebraic;
    model.unsolved_law = found.unsolved;
    model.changing_laws = found.changing;
    found.found.into_iter().for_each(|combination| keep(model, combination));
    model.determining = apart(|| determining(&Trace::of(model), &open));
    model.inertialess = open;
    if model.laws.is_empty() || model.quasi_velocities.is_empty() {
        return Vec::new();
    }
    apart(|| QuasiVelocities::of(&Trace::of(model)).err().unwrap_or_default())
}

/// Adds a combination of laws as a constraint.
fn keep(model: &mut Model, combination: Combination) {
    let Some(&(first, _)) = combination.first() else { return };
    let names: Vec<&str> = combination.iter().map(|(place, _)| model.coordinates[*place].name.as_str()).collect();
    let name = format!("law of {}", names.join(", "));
    let coordinate = &model.coordinates[first];
    let dimension = super::loads::joule() / coordinate.dimension;
    let at = coordinate.at.clone();
    let number = model.laws.len();
    model.laws.push(combination);
    let zero = model.arena.scalar(Scalar::Law { number }, Some(dimension));
    model.constraints.push(Constraint {
        name: Some(name),
        zero: Zero::Scalar(zero),
        dimension,
        gains: None,
        gains_at: at.clone(),
        at,
    });
}

/// Returns the model with its case-dependent laws as constraints, valid while no condition changes.
pub(crate) fn with_changing_laws(model: &Model) -> Cow<'_, Model> {
    if model.changing_laws.is_empty() {
        return Cow::Borrowed(model);
    }
    let mut with = model.clone();
    std::mem::take(&mut with.changing_laws).into_iter().for_each(|combination| keep(&mut with, combination));
    Cow::Owned(with)
}

/// Returns the coordinates whose speeds occur in no kinetic energy or co-energy.
fn open(trace: &Trace<'_>) -> Vec<usize> {
    let moved = trace.kinetic_and_coenergy().symbols_of();
    (0..trace.model.coordinates.len()).filter(|&place| !moved.contains(&trace.speeds[place])).collect()
}

/// Returns the indices of the constraints that determine coordinates without inertia: their laws, and constraints of speeds that contain their speeds.
fn determining(trace: &Trace<'_>, open: &[usize]) -> Vec<usize> {
    let holds = |one: &Equation| one.level == Level::Speed && open.iter().any(|&place| one.row[place] != Sym::ZERO);
    let own = constraints_of(trace).into_iter().filter(|one| one.law.is_some() || holds(one));
    let mut places: Vec<usize> = own.map(|one| one.of[0]).collect();
    places.dedup();
    places
}

/// The laws without accelerations, classified.
#[derive(Default)]
struct Laws {
    /// Combinations that are constraints; their multipliers vanish.
    found: Vec<Combination>,
    /// Combinations that depend on the case, or are coupled with such ones, and contain speeds or switches.
    changing: Vec<Combination>,
    /// Coordinates whose speeds are determined by the combinations in `changing`.
    algebraic: Vec<usize>,
    /// A coordinate whose case-dependent law cannot be solved.
    unsolved: Option<(usize, UnsolvedLaw)>,
}

impl Laws {
    fn of(trace: &Trace<'_>, open: &[usize]) -> Self {
        // constraints do not contain reactions
        let (impulses, others): (Vec<usize>, Vec<usize>) =
            open.iter().copied().partition(|place| trace.model.impulses.contains(place));
        let mut laws = Laws::among(trace, &impulses, &[]);
        let rows = if others.is_empty() { Vec::new() } else { constraints_of(trace) };
        let rows = rows.into_iter().map(|one| others.iter().map(|&place| one.row[place].as_constant()).collect());
        if let Some(rows) = rows.collect::<Option<Vec<Vec<Rational>>>>() {
            let of_others = Laws::among(trace, &others, &rows);
            laws.found.extend(of_others.found);
            laws.changing.extend(of_others.changing);
            laws.algebraic.extend(of_others.algebraic);
            laws.algebraic.sort_unstable();
            laws.unsolved = laws.unsolved.or(of_others.unsolved);
        }
        laws
    }

    /// Classifies the laws of the coordinates `open`; `rows` are the coefficients of their speeds in the constraints.
    fn among(trace: &Trace<'_>, open: &[usize], rows: &[Vec<Rational>]) -> Self {
        let own: Vec<Sym> = open.iter().map(|&place| trace.law(&[(place, 1)])).collect();
        let directions = basis(rows, &speed_free(trace, &own, open), open.len());
        let groups = groups(trace, &own, open, rows);
        let mut laws = Laws::default();
        let mut changing: Vec<usize> = Vec::new();
        let (mut all, mut piecewise): (Vec<(usize, Combination, Kind)>, Vec<Combination>) = Default::default();
        for factors in directions {
            let Some(factors) = whole(&factors) else { continue };
            let held = open.iter().copied().zip(factors).zip(&groups).filter(|((_, factor), _)| *factor != 0);
            let (combination, own): (Combination, Vec<usize>) = held.unzip();
            let Some(&group) = own.first() else { continue };
            let kind = kind(trace, &combination);
            if matches!(kind, Kind::Piecewise) {
                changing.push(group);
                piecewise.push(combination.clone());
            }
            all.push((group, combination, kind));
        }
        for (group, combination, kind) in all {
            let is_changing = changing.contains(&group);
            if is_changing {
                laws.algebraic.extend(combination.iter().map(|(place, _)| *place));
            }
            match kind {
                Kind::DeterminesByPlaces => laws.found.push(combination),
                Kind::Determines if !is_changing => laws.found.push(combination),
                Kind::Determines | Kind::Piecewise => laws.changing.push(combination),
                Kind::DeterminesNothing => {}
            }
        }
        laws.algebraic.sort_unstable();
        laws.algebraic.dedup();
        laws.unsolved = unsolved(trace, &laws.algebraic, &piecewise);
        laws
    }
}

enum Kind {
    Determines,
    /// The law contains no speeds, and determines positions.
    DeterminesByPlaces,
    /// The law contains a condition or the reaction of a contact.
    Piecewise,
    DeterminesNothing,
}

/// Determines whether a law depends on its own speeds, on its own positions, or on neither.
fn kind(trace: &Trace<'_>, combination: &Combination) -> Kind {
    let law = trace.law(combination);
    let along = |derivative: &dyn Fn(usize) -> Sym| {
        combination.iter().fold(Sym::ZERO, |sum, &(place, factor)| sum + Sym::int(factor) * derivative(place))
    };
    let held = law.symbols_of();
    let mut chosen = trace.switches.iter().copied().chain(trace.reactions());
    let by_speed = || along(&|place| trace.by_speed(law, place));
    let by_place = || along(&|place| trace.by_coordinate(law, place));
    let is_of_places = || !held.iter().any(|one| trace.speeds.contains(one));
    if chosen.any(|symbol| held.contains(&symbol)) {
        Kind::Piecewise
    } else if !vanishes(by_speed()) {
        Kind::Determines
    } else if is_of_places() && !vanishes(by_place()) {
        Kind::DeterminesByPlaces
    } else {
        Kind::DeterminesNothing
    }
}

/// Returns the first coordinate with an algebraic speed whose law cannot be solved for it, and the reason.
fn unsolved(trace: &Trace<'_>, algebraic: &[usize], piecewise: &[Combination]) -> Option<(usize, UnsolvedLaw)> {
    let model = trace.model;
    let speeds: Vec<Sym> = algebraic.iter().map(|&place| trace.speeds[place]).collect();
    let knows = |expression: Sym, letters: &[Sym]| expression.symbols_of().iter().any(|one| letters.contains(one));
    let one_ways = (0..model.contacts.len()).filter(|&k| model.contacts[k].one_way.is_some());
    let one_ways = one_ways.map(|contact| trace.reaction(contact, 0));
    let touches = |contact: &Contact, own: &[Sym]| {
        let scalars = contact.slides.iter().copied().chain(contact.friction).chain(contact.restitution);
        let held = scalars.map(|scalar| trace.scalar(scalar)).chain([trace.gap_rate(contact)]);
        contact.one_way.is_none() && held.into_iter().any(|scalar| knows(scalar, own))
    };
    let constraints = if algebraic.is_empty() { Vec::new() } else { constraints_of(trace) };
    let own = algebraic.iter().find_map(|&place| {
        let law = trace.law(&[(place, 1)]);
        // reactions are computed by Newton's method, hence their laws may be nonlinear
        let is_reaction = model.impulses.contains(&place);
        let bends = |&other: &usize| !is_reaction && knows(trace.by_speed(law, other), &speeds);
        if model.contacts.iter().any(|contact| touches(contact, &[trace.speeds[place]])) {
            Some((place, UnsolvedLaw::Contact))
        } else if constraints.iter().any(|one| one.gains.is_some() && one.row[place] != Sym::ZERO) {
            Some((place, UnsolvedLaw::Programmed))
        } else if algebraic.iter().any(bends) {
            Some((place, UnsolvedLaw::Nonlinear))
        } else {
            None
        }
    });
    // a switch whose condition contains a speed counts as an unknown
    let is_of_speeds = |place: usize| knows(trace.scalar(model.switches[place]), &speeds);
    let follows = (0..trace.switches.len()).filter(|&place| is_of_speeds(place)).map(|place| trace.switches[place]);
    let unknown: Vec<Sym> = speeds.iter().copied().chain(one_ways).chain(follows).collect();
    own.or_else(|| {
        let of_positions = piecewise.iter().find(|combination| !knows(trace.law(combination), &unknown))?;
        Some((of_positions.first()?.0, UnsolvedLaw::OfPositions))
    })
}
