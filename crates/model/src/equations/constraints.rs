//! Constraints as linear equations for the accelerations.

use super::vanishes;
use crate::arena::Scalar;
use crate::{Constraint, FrameId, Trace, Vector, Zero};
use std::ops::Range;
use symbolic::Sym;

/// The level of a constraint: on positions or on speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    Position,
    Speed,
}

/// A scalar constraint f = 0.
#[derive(Clone, Debug)]
pub struct Equation {
    /// The name in the model; empty if there is none.
    pub name: String,
    /// The index of the constraint in the model, and the index of the component of a vector constraint.
    pub of: [usize; 2],
    /// The symbol of the multiplier lambda.
    pub multiplier: Sym,
    /// The level, positions or speeds.
    pub level: Level,
    /// The expression f.
    pub zero: Sym,
    /// df/dt for a constraint of positions, f for one of speeds.
    pub rate: Sym,
    /// The row of J: the derivatives of `rate` with respect to the speeds.
    pub row: Vec<Sym>,
    /// The entry of c: the time derivative of `rate` at zero accelerations, plus the gain terms of a stabilised constraint.
    pub bias: Sym,
    /// The gains of a stabilised constraint (Baumgarte), which may be violated at the start: for positions the gain of f' comes first.
    pub gains: Option<Vec<Sym>>,
    /// For the law of coordinates without inertia: the combination of equations of motion as (speed, factor). It contains no acceleration, and its
    /// multiplier is zero.
    pub law: Option<Vec<(usize, i64)>>,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

impl Equation {
    /// Returns the name of the equation in sentences, such as "constraint 2 `rolling`"; `place` is its index.
    pub fn title(&self, place: usize) -> String {
        let name = if self.name.is_empty() { String::new() } else { format!(" `{}`", self.name) };
        format!("constraint {}{name}", place + 1)
    }
}

/// One scalar equation of a constraint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScalarConstraint {
    pub zero: Sym,
    /// The axis of the component, for a vector constraint.
    pub axis: Option<Vector>,
    /// The frame and the number of this axis.
    pub place: Option<(FrameId, usize)>,
    /// The index among the components that do not vanish identically.
    pub component: usize,
}

/// Returns the scalar equations of a constraint: the constraint itself, or the components of a vector that do not vanish identically. Redundant ones
/// are omitted.
pub(crate) fn held_of(trace: &Trace<'_>, place: usize) -> Vec<ScalarConstraint> {
    let mut held = match trace.model.constraints[place].zero {
        Zero::Scalar(zero) => {
            vec![ScalarConstraint { zero: trace.scalar(zero), axis: None, place: None, component: 0 }]
        }
        Zero::Vector(zero) => independent(trace, trace.vector(zero)),
    };
    held.retain(|held| !trace.model.is_implied([place, held.component]));
    held
}

/// Returns the expressions of omitted constraints of positions, which follow from the others near the start and vanish along every motion.
pub fn implied(trace: &Trace<'_>) -> Vec<Sym> {
    let of = |[place, component]: [usize; 2]| match trace.model.constraints[place].zero {
        Zero::Scalar(zero) => Some(trace.scalar(zero)),
        Zero::Vector(zero) => {
            let all = independent(trace, trace.vector(zero));
            all.into_iter().find(|held| held.component == component).map(|held| held.zero)
        }
    };
    trace.model.implied.iter().filter_map(|one| of(one.of)).collect()
}

/// Returns one equation for each scalar constraint, and for each component of a vector constraint that does not vanish identically.
pub fn equations(trace: &Trace<'_>) -> Vec<Equation> {
    let mut all = Vec::new();
    for (place, constraint) in trace.model.constraints.iter().enumerate() {
        for held in held_of(trace, place) {
            all.push(equation(trace, constraint, [place, held.component], held.zero));
        }
    }
    all
}

/// Returns the components of a vector that do not vanish identically, in the axes in which there are fewest: those of its frame or of one of its parent
/// frames. A vector along a line has one component in suitable axes, and two dependent ones in axes that rotate relative to the line.
///
/// If several frames give equally few components, the frame of the vector is used. For a vector of velocities it is the outermost frame, since
/// there a redundant component, such as the vertical one of rolling next to a contact, is redundant everywhere.
pub(crate) fn independent(trace: &Trace<'_>, vector: Vector) -> Vec<ScalarConstraint> {
    let above = |frame: &FrameId| trace.model.frames[frame.0].parent.map(|(parent, _)| parent);
    let frames = std::iter::successors(Some(vector.frame), above);
    let held = frames.map(|frame| {
        let components = trace.express(vector, frame).into_iter().enumerate();
        let held = components.filter(|(_, zero)| !vanishes(*zero)).enumerate();
        let held = held.map(|(component, (axis, zero))| ScalarConstraint {
            zero,
            axis: Some(Vector::axis(frame, axis)),
            place: Some((frame, axis)),
            component,
        });
        held.collect::<Vec<_>>()
    });
    let mut held: Vec<Vec<ScalarConstraint>> = held.collect();
    if held.first().is_some_and(|own| own.iter().any(|one| trace.level_of(one.zero) == Level::Speed)) {
        held.reverse();
    }
    held.into_iter().min_by_key(Vec::len).unwrap_or_default()
}

impl Trace<'_> {
    /// Returns the symbol of a multiplier. Its name contains a space, hence no name of a system equals it.
    pub(crate) fn multiplier([constraint, component]: [usize; 2]) -> Sym {
        Sym::symbol(&format!("multiplier {constraint}.{component}"))
    }

    /// Returns the level of a constraint f = 0: speed if f depends on speeds.
    pub(crate) fn level_of(&self, zero: Sym) -> Level {
        let symbols = zero.symbols_of();
        match self.speeds.iter().any(|speed| symbols.contains(speed)) {
            true => Level::Speed,
            false => Level::Position,
        }
    }
}

fn equation(trace: &Trace<'_>, constraint: &Constraint, of: [usize; 2], zero: Sym) -> Equation {
    let Constraint { name, gains, at, .. } = constraint;
    let level = trace.level_of(zero);
    let rate = if level == Level::Position { trace.rate_of(zero) } else { zero };
    let row: Vec<Sym> = (0..trace.speeds.len()).map(|i| trace.by_speed(rate, i)).collect();
    let at_rest: Vec<(Sym, Sym)> = trace.accelerations.iter().map(|&symbol| (symbol, Sym::ZERO)).collect();
    let mut bias = trace.rate_of(rate).substitute(&at_rest);
    let below: &[Sym] = if level == Level::Position { &[rate, zero] } else { &[zero] };
    let gains = gains.as_ref().map(|gains| gains.iter().map(|&gain| trace.scalar(gain)).collect::<Vec<Sym>>());
    for (&gain, &lower) in gains.iter().flatten().zip(below) {
        bias += gain * lower;
    }
    let name = name.clone().unwrap_or_default();
    let multiplier = Trace::multiplier(of);
    let law = match constraint.zero {
        Zero::Scalar(zero) => match trace.model.arena.scalar_at(zero) {
            Some(Scalar::Law { number }) => Some(trace.model.laws[*number].clone()),
            _ => None,
        },
        Zero::Vector(_) => None,
    };
    Equation { name, of, multiplier, level, zero, rate, row, bias, gains, law, at: at.clone() }
}
