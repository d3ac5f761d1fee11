//! Constraints as equations between accelerations.

use super::vanishes;
use crate::arena::Scalar;
use crate::{Constraint, FrameId, Trace, Vector, Zero};
use std::ops::Range;
use symbolic::Sym;

/// Whether a constraint is on positions or on speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    Position,
    Speed,
}

/// A scalar constraint f = 0.
#[derive(Clone, Debug)]
pub struct Equation {
    /// The name in the model; empty where there is none.
    pub name: String,
    /// The constraint in the model, and the component of a vector.
    pub of: [usize; 2],
    /// lambda, the symbol of its multiplier.
    pub multiplier: Sym,
    pub level: Level,
    /// f.
    pub zero: Sym,
    /// df/dt of a constraint of positions; f itself of one of speeds.
    pub rate: Sym,
    /// The row of J: the derivatives of that by the speeds.
    pub row: Vec<Sym>,
    /// c: the next rate at zero accelerations, with the gains of a constraint that is led to zero.
    pub bias: Sym,
    /// Gains of a constraint that is led to zero and may start elsewhere: of f' first, of positions.
    pub gains: Option<Vec<Sym>>,
    /// The combination of equations of motion, speeds with factors, for a law without inertia; it holds no acceleration, and its
    /// multiplier is zero.
    pub law: Option<Vec<(usize, i64)>>,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

impl Equation {
    /// The name in sentences, by its place among all: constraint 2 `rolling`.
    pub fn title(&self, place: usize) -> String {
        let name = if self.name.is_empty() { String::new() } else { format!(" `{}`", self.name) };
        format!("constraint {}{name}", place + 1)
    }
}

/// A scalar equation of a constraint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScalarConstraint {
    pub zero: Sym,
    /// The axis along which it is a component, of a vector.
    pub axis: Option<Vector>,
    /// The frame and the number of that axis.
    pub place: Option<(FrameId, usize)>,
    /// The place among the components of a vector that do not vanish.
    pub component: usize,
}

/// The equations of a constraint by its place: itself, or each component of a vector that does not vanish identically; none that
/// follows from others.
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

/// The constraints of positions that follow from others near the start, where they are left out: expressions that vanish along every motion.
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

/// One for each scalar, and for each component of a vector that does not vanish identically.
pub fn equations(trace: &Trace<'_>) -> Vec<Equation> {
    let mut all = Vec::new();
    for (place, constraint) in trace.model.constraints.iter().enumerate() {
        for held in held_of(trace, place) {
            all.push(equation(trace, constraint, [place, held.component], held.zero));
        }
    }
    all
}

/// The components of a vector that do not vanish, in the axes in which the most of them do: those of its frame, or of one that this
/// turns in. A vector along a line has one there, and two that depend on each other in axes that turn.
///
/// Among axes with equally many those of its own frame are taken; of a vector of velocities those of the frame that all others turn in, since
/// there a component that follows from other constraints, as the vertical one of rolling beside a contact, does so everywhere.
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
    /// The symbol of the multiplier of a constraint's equation: no name of a system can be this one.
    pub(crate) fn multiplier([constraint, component]: [usize; 2]) -> Sym {
        Sym::symbol(&format!("multiplier {constraint}.{component}"))
    }

    /// Whether a scalar depends on speeds.
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
