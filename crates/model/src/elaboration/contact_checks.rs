//! Checks of contacts after the whole model is known.

use crate::equations::vanishes;
use crate::trace::Vector;
use crate::{Contact, Fault, Force, FrameId, Model, Sides, Trace};
use symbolic::{Identity, Sym, apart, identified};

/// The reason why a contact is invalid.
#[derive(Clone, Copy)]
enum Wrong {
    /// A guide along an axis moves out of the plane N.x, N.y, or a force perpendicular to this plane loads it.
    Line,
    /// A point of the plane moves with coordinates, but the plane belongs to no body.
    Carried,
    /// The rate of the gap is not proportional to the normal velocity.
    Askew,
    /// No speed changes the gap of a unilateral contact.
    Fixed,
    /// The speed of a diode or freewheel is identically zero, or not linear in the speeds.
    Bent,
}

/// Returns a fault for each invalid contact.
pub(super) fn checked(model: &Model) -> Result<(), Vec<Fault>> {
    let wrong: Vec<Option<Wrong>> = apart(|| {
        let trace = Trace::of(model);
        model.contacts.iter().map(|contact| wrong(&trace, contact)).collect()
    });
    let faults = wrong.into_iter().enumerate().filter_map(|(place, wrong)| Some(fault(model, place, wrong?)));
    let faults: Vec<Fault> = faults.collect();
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

fn wrong(trace: &Trace<'_>, contact: &Contact) -> Option<Wrong> {
    if contact.one_way.is_some() {
        let slopes = (0..trace.speeds.len()).map(|k| trace.by_speed(trace.scalar(contact.gap), k));
        let slopes: Vec<Sym> = slopes.filter(|slope| varies(*slope)).collect();
        let bends = |slope: &Sym| slope.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol));
        return (slopes.is_empty() || slopes.iter().any(bends)).then_some(Wrong::Bent);
    }
    let normal = trace.vector(contact.normal);
    let velocity = trace.vector(contact.velocity);
    if contact.is_line && is_in_space(trace, contact, [normal, velocity]) {
        return Some(Wrong::Line);
    }
    let by_speeds = |scalar: Sym| -> Vec<Sym> { (0..trace.speeds.len()).map(|k| trace.by_speed(scalar, k)).collect() };
    let moves = |scalar: Sym| by_speeds(scalar).into_iter().any(varies);
    if contact.with.is_none()
        && let Some(through) = contact.through
        && trace.velocity(through).components.into_iter().any(moves)
    {
        return Some(Wrong::Carried);
    }
    let gap_rate = trace.rate_of(trace.scalar(contact.gap));
    if !moves(gap_rate) {
        return (contact.sides == Sides::One).then_some(Wrong::Fixed);
    }
    let (rows, along) = (by_speeds(gap_rate), by_speeds(trace.dot(velocity, normal)));
    let mut pairs = (0..rows.len()).flat_map(|one| (0..one).map(move |other| (one, other)));
    let is_askew = pairs.any(|(one, other)| is_not_zero(rows[one] * along[other] - rows[other] * along[one]));
    is_askew.then_some(Wrong::Askew)
}

/// Returns whether the point of a guide moves out of the plane N.x, N.y, or a load perpendicular to this plane acts on a guide with friction.
fn is_in_space(trace: &Trace<'_>, contact: &Contact, own: [Vector; 2]) -> bool {
    let model = trace.model;
    let across = |vector: Vector| varies(trace.dot(vector, Vector::axis(FrameId::GROUND, 2)));
    let pressed = || {
        let loads = model.forces.iter().filter_map(|force| match force {
            Force::On { is, .. } => Some(*is),
            Force::Between { .. } => None,
        });
        loads.chain(model.gravity).any(|load| across(trace.vector(load)))
    };
    own.into_iter().any(across) || contact.friction.is_some() && pressed()
}

fn varies(expression: Sym) -> bool {
    expression != Sym::ZERO && !vanishes(expression)
}

/// Returns whether an expression is proved to differ from zero.
fn is_not_zero(expression: Sym) -> bool {
    expression != Sym::ZERO && matches!(identified(&[expression]), Identity::NotZero)
}

fn fault(model: &Model, place: usize, wrong: Wrong) -> Fault {
    let contact = &model.contacts[place];
    let title = contact.title(place);
    let (title, label, accepted) = match wrong {
        Wrong::Line => (
            format!(
                "guides along a line in space are not supported yet: {title} is pressed, or moves, across the plane of N.x and N.y"
            ),
            "not supported yet",
            "forces and motions in the plane of N.x and N.y; in space a plane that holds on both sides: of = \"bead\", normal, through, sides = \"both\"",
        ),
        Wrong::Carried => (
            format!("the plane of {title} moves with the coordinates, and no body has it"),
            "`through` is a point that moves",
            "`with` names the body that is touched: with = \"wedge\"",
        ),
        Wrong::Askew => (
            format!("the gap of {title} does not grow along its normal"),
            "its rate is not the velocity along the normal",
            "the normal of a curve is the gradient of its gap: gap = \"y - a*x^2\", normal = \"N.y - 2*a*x*N.x\"",
        ),
        Wrong::Bent => (
            format!("{title} has a speed that is linear in rates of coordinates"),
            "this one is not, or holds none",
            "a current of charges: current = \"q'\"; a speed: speed = \"a' - n*b'\"",
        ),
        Wrong::Fixed => (
            format!("no motion changes the gap of {title}"),
            "the coordinates keep it as it is",
            "a coordinate that moves the point along the normal; or sides = \"both\", a guide",
        ),
    };
    Fault::at(contact.at.clone(), title, label, accepted)
}
