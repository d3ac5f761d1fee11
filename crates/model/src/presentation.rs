//! Equations of motion for reading: accelerations on the left, everything else on the right, each term in normal form.

use crate::equations::{Equation, Equations, Level, constraints_of as equations_of};
use crate::principles::{NotApplicable, Principle};
use crate::{FrameId, PointId, Trace, Vector};
use num_traits::Zero;
use symbolic::{Hypotheses, Sym, normal};

/// An equation: left = right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readable {
    pub left: Sym,
    pub right: Sym,
}

/// The equations of a model by a principle, then its constraints: M u' = -h + J^T lambda, f = 0. A multiplier is named after its
/// constraint, `lambda1` where that has no name.
///
/// # Errors
/// Where the principle does not apply to the model.
pub fn readable(trace: &Trace<'_>, principle: Principle) -> Result<Vec<Readable>, NotApplicable> {
    let equations = Equations::by(principle, trace)?;
    let multipliers: Vec<Sym> = (1..=equations.constraints.len()).map(|k| Sym::symbol(&format!("lambda{k}"))).collect();
    let mut all = Vec::new();
    for (row, bias) in equations.mass.iter().zip(&equations.bias) {
        let inertia =
            row.iter().zip(&trace.accelerations).map(|(&mass, &acceleration)| simplified(mass) * acceleration);
        let left = inertia.fold(Sym::ZERO, |sum, term| sum + term);
        let place = all.len();
        let reactions = equations.constraints.iter().zip(&multipliers);
        let reactions = reactions.map(|(constraint, &lambda)| simplified(constraint.row[place]) * lambda);
        let right = reactions.fold(simplified(-*bias), |sum, term| if term.is_zero() { sum } else { sum + term });
        all.push(Readable { left, right });
    }
    all.extend(
        equations.constraints.iter().map(|constraint| Readable { left: simplified(constraint.zero), right: Sym::ZERO }),
    );
    Ok(all)
}

/// The vectors that the model is made of, each on a line: of every frame its angular velocity, of every named point its position,
/// velocity and acceleration, in the axes in which they were formed.
pub fn vectors(trace: &Trace<'_>) -> Vec<String> {
    let model = trace.model;
    let written = |vector: Vector| {
        let frame = &model.frames[vector.frame.0].name;
        let parts = vector.components.iter().zip(["x", "y", "z"]).filter(|(component, _)| !component.is_zero());
        let parts: Vec<String> = parts
            .map(|(component, axis)| match simplified(*component) {
                one if one == Sym::ONE => format!("{frame}.{axis}"),
                other if other.to_string().contains(' ') => format!("({other})*{frame}.{axis}"),
                other => format!("{other}*{frame}.{axis}"),
            })
            .collect();
        if parts.is_empty() { "0".to_owned() } else { parts.join(" + ") }
    };
    let frames = model
        .frames
        .iter()
        .enumerate()
        .skip(1)
        .map(|(at, frame)| format!("angular_velocity({}) = {}", frame.name, written(trace.turning(FrameId(at)))));
    let points = model.points.iter().enumerate().filter(|(_, point)| !point.name.is_empty() && point.base.is_some());
    let points = points.flat_map(|(at, point)| {
        let (name, at) = (&point.name, PointId(at));
        [
            format!("{name} - O = {}", written(trace.position(at))),
            format!("velocity({name}) = {}", written(trace.velocity(at))),
            format!("acceleration({name}) = {}", written(trace.acceleration(at))),
        ]
    });
    frames.chain(points).collect()
}

/// The kind of every constraint, each on a line: of positions or of speeds; in the speeds linear, affine or nonlinear; with the time or
/// without.
pub fn constraints(trace: &Trace<'_>) -> Vec<String> {
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let kind = |(k, constraint): (usize, Equation)| {
        let moves =
            constraint.row.iter().any(|slope| slope.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol)));
        let kind = match constraint.level {
            Level::Position => "of positions",
            Level::Speed if moves => "of speeds, nonlinear",
            Level::Speed if simplified(constraint.zero.substitute(&at_rest)).is_zero() => "of speeds, linear",
            Level::Speed => "of speeds, affine",
        };
        let knows_time = constraint.zero.symbols_of().contains(&trace.time);
        let time = if knows_time { ", with the time" } else { "" };
        format!("{}: {kind}{time}", constraint.title(k))
    };
    equations_of(trace).into_iter().enumerate().map(kind).collect()
}

/// Expressions with more operations are left as they are.
const MOST_SIMPLIFIED: usize = 2_000;

pub(crate) fn simplified(expression: Sym) -> Sym {
    if Sym::operations_of(&[expression]) > MOST_SIMPLIFIED {
        return expression;
    }
    normal(expression, &Hypotheses::none()).map_or(expression, |form| form.to_sym())
}
