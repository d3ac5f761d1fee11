//! Coordinates without inertia: the charge of a capacitor behind a resistor, a point between an elastic and a viscous element.
//!
//! No acceleration stands in the law of such a coordinate: r(q, u, t) = 0, inertia less forces, is an equation of speeds, or of positions.
//! It becomes a constraint of the system. In
//!
//!   r = J lambda ,    J = dr/du
//!
//! its multiplier vanishes along every motion, so that it moves the coordinate and acts on nothing. Where constraints tie several such
//! coordinates, as Kirchhoff's law ties the currents of a node, the combinations that these leave have a law each.

use crate::arena::Scalar;
use crate::equations::{Equation, Level, constraints_of, vanishes};
use crate::parts::Combination;
use crate::{Constraint, Fault, Model, QuasiVelocities, Trace, Zero};
use field::{Rational, Scalar as _};
use symbolic::{Sym, apart};

/// Gives a model a constraint for each law without accelerations; the faults of quasi-velocities that are then too many.
pub(super) fn settle(model: &mut Model) -> Vec<Fault> {
    let (open, found) = apart(|| {
        let trace = Trace::of(model);
        let open = open(&trace);
        let found = if open.is_empty() { Vec::new() } else { combinations(&trace, &open) };
        (open, found)
    });
    for combination in found {
        let [(first, _), others @ ..] = combination.as_slice() else { continue };
        let coordinate = &model.coordinates[*first];
        let name = match others {
            [] => format!("law of {}", coordinate.name),
            _ => {
                let names = combination.iter().map(|(place, _)| model.coordinates[*place].name.as_str());
                format!("law of {}", names.collect::<Vec<_>>().join(", "))
            }
        };
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
    model.determining = apart(|| determining(&Trace::of(model), &open));
    model.inertialess = open;
    if model.laws.is_empty() || model.quasi_velocities.is_empty() {
        return Vec::new();
    }
    apart(|| QuasiVelocities::of(&Trace::of(model)).err().unwrap_or_default())
}

/// The coordinates on whose speeds no inertia depends.
fn open(trace: &Trace<'_>) -> Vec<usize> {
    let moved = trace.kinetic_and_coenergy().symbols_of();
    (0..trace.model.coordinates.len()).filter(|&place| !moved.contains(&trace.speeds[place])).collect()
}

/// The laws, and the constraints of speeds that hold one without inertia.
fn determining(trace: &Trace<'_>, open: &[usize]) -> Vec<usize> {
    let holds = |one: &Equation| one.level == Level::Speed && open.iter().any(|&place| one.row[place] != Sym::ZERO);
    let own = constraints_of(trace).into_iter().filter(|one| one.law.is_some() || holds(one));
    let mut places: Vec<usize> = own.map(|one| one.of[0]).collect();
    places.dedup();
    places
}

/// The combinations of laws that hold no acceleration and no multiplier, and that determine a motion.
fn combinations(trace: &Trace<'_>, open: &[usize]) -> Vec<Combination> {
    let rows =
        constraints_of(trace).into_iter().map(|one| open.iter().map(|&place| one.row[place].as_constant()).collect());
    let Some(rows) = rows.collect::<Option<Vec<Vec<Rational>>>>() else { return Vec::new() };
    let found = null_space(rows, open.len());
    let combined = found.into_iter().map(|factors| -> Option<Combination> {
        let all = open.iter().copied().zip(whole(&factors)?);
        Some(all.filter(|(_, factor)| *factor != 0).collect())
    });
    let Some(combined) = combined.collect::<Option<Vec<Combination>>>() else { return Vec::new() };
    let laws: Vec<Sym> = combined.iter().map(|combination| trace.law(combination)).collect();
    match determines(trace, &combined, &laws) {
        true => combined,
        false => Vec::new(),
    }
}

/// Whether every law changes with a speed or a position along its own combination, and holds no condition and no reaction of a contact.
fn determines(trace: &Trace<'_>, combined: &[Combination], laws: &[Sym]) -> bool {
    let reactions =
        (0..trace.model.contacts.len()).flat_map(|contact| [0, 1].map(|part| trace.reaction(contact, part)));
    let chosen: Vec<Sym> = trace.switches.iter().copied().chain(reactions).collect();
    combined.iter().zip(laws).all(|(combination, law)| {
        let along = |derivative: &dyn Fn(usize) -> Sym| {
            combination.iter().fold(Sym::ZERO, |sum, &(place, factor)| sum + Sym::int(factor) * derivative(place))
        };
        let held = law.symbols_of();
        let is_steady = !held.iter().any(|symbol| chosen.contains(symbol));
        let by_speed = along(&|place| trace.by_speed(*law, place));
        let by_place = along(&|place| trace.by_coordinate(*law, place));
        is_steady && (!vanishes(by_speed) || !held.iter().any(|one| trace.speeds.contains(one)) && !vanishes(by_place))
    })
}

/// A basis of what rows take to zero.
fn null_space(mut rows: Vec<Vec<Rational>>, columns: usize) -> Vec<Vec<Rational>> {
    let is_zero = |value: Rational| value.sign() == Some(0);
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(found) = (done..rows.len()).find(|&row| !is_zero(rows[row][column])) else { continue };
        rows.swap(done, found);
        let pivot = rows[done][column];
        rows[done].iter_mut().for_each(|entry| *entry /= pivot);
        let own = rows[done].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(place, _)| *place != done) {
            let factor = row[column];
            row.iter_mut().zip(&own).for_each(|(entry, own)| *entry -= factor * *own);
        }
        pivots.push(column);
    }
    let free = (0..columns).filter(|column| !pivots.contains(column));
    free.map(|column| {
        let mut vector = vec![Rational::new(0, 1); columns];
        vector[column] = Rational::new(1, 1);
        for (row, &pivot) in pivots.iter().enumerate() {
            vector[pivot] = -rows[row][column];
        }
        vector
    })
    .collect()
}

/// The same direction by whole numbers; none where they are large.
fn whole(factors: &[Rational]) -> Option<Vec<i64>> {
    let denominator = |factor: &Rational| i64::try_from(factor.to_big()?.denominator().clone()).ok();
    let common = factors.iter().try_fold(1_i64, |common, factor| {
        let own = denominator(factor)?;
        if common % own == 0 { Some(common) } else { common.checked_mul(own) }
    })?;
    let scaled = |factor: &Rational| {
        let scaled = (*factor * Rational::new(common, 1)).to_big()?;
        i64::try_from(scaled.numerator().clone()).ok()
    };
    factors.iter().map(scaled).collect()
}
