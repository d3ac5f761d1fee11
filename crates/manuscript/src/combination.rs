//! A printed equation of motion as a linear combination of the equations of the model.

use crate::display::Told;
use crate::motion::Motion;
use model::equations::Equations;
use symbolic::linear::solve;
use symbolic::{Hypotheses, Sym, normal};

/// The largest number of equations of a model for which the combination is printed.
const MOST_SPEEDS: usize = 4;

/// The largest length of a factor in characters.
const READABLE: usize = 120;

/// A sentence with the linear combination of the model's equations that equals a printed equation: `1/(m*l^2) times the equation of theta`. `None`
/// if the equations contain reactions of constraints, or the sentence is too long.
pub(crate) fn told_combination(printed: Sym, motion: &Motion<'_, '_>, told: Told<'_, '_, '_>) -> Option<String> {
    let trace = motion.trace;
    let Equations { mass, constraints, .. } = Equations::of(trace);
    if !constraints.is_empty() || mass.len() > MOST_SPEEDS {
        return None;
    }
    let slopes: Vec<Sym> = (0..mass.len()).map(|j| trace.by_acceleration(printed, j)).collect();
    let factors = solve(&mass, &slopes, &Hypotheses::none()).ok()?.values();
    let mut parts = Vec::new();
    for (k, factor) in factors.into_iter().enumerate() {
        let form = normal(motion.reduced(factor), &Hypotheses::none()).ok()?;
        if form.is_zero() {
            continue;
        }
        let own = told.0.told(form.to_sym()).to_string();
        if own.chars().count() > READABLE {
            return None;
        }
        parts.push(match own.as_str() {
            "1" => format!("the equation of {}", trace.direction(k)),
            _ => format!("{own} times the equation of {}", trace.direction(k)),
        });
    }
    (!parts.is_empty()).then(|| parts.join(" plus "))
}
