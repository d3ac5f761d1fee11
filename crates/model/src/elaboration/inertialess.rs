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
use symbolic::{Sym, apart, substitute_all};

/// Gives a model a constraint for each law without accelerations; the faults of quasi-velocities that are then too many.
pub(super) fn settle(model: &mut Model) -> Vec<Fault> {
    let (open, found) = apart(|| {
        let trace = Trace::of(model);
        let open = open(&trace);
        let laws = if open.is_empty() { Laws::default() } else { Laws::of(&trace, &open) };
        (open, laws)
    });
    model.piecewise_laws = found.piecewise;
    for combination in found.found {
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

/// Laws that hold no acceleration.
#[derive(Default)]
struct Laws {
    /// Combinations without multipliers that determine a motion.
    found: Vec<Combination>,
    /// Coordinates whose laws hold a condition, or the reaction of a contact.
    piecewise: Vec<usize>,
}

impl Laws {
    fn of(trace: &Trace<'_>, open: &[usize]) -> Self {
        let rows = constraints_of(trace).into_iter();
        let rows = rows.map(|one| open.iter().map(|&place| one.row[place].as_constant()).collect());
        let Some(rows) = rows.collect::<Option<Vec<Vec<Rational>>>>() else { return Laws::default() };
        let own: Vec<Sym> = open.iter().map(|&place| trace.law(&[(place, 1)])).collect();
        let directions = basis(&rows, &speed_free(trace, &own, open), open.len());
        let mut laws = Laws::default();
        for factors in directions {
            let Some(factors) = whole(&factors) else { continue };
            let all = open.iter().copied().zip(factors);
            let combination: Combination = all.filter(|(_, factor)| *factor != 0).collect();
            match kind(trace, &combination) {
                Kind::Determines => laws.found.push(combination),
                Kind::Piecewise => laws.piecewise.extend(combination.iter().map(|(place, _)| *place)),
                Kind::DeterminesNothing => {}
            }
        }
        laws
    }
}

enum Kind {
    Determines,
    /// It holds a condition, or the reaction of a contact.
    Piecewise,
    DeterminesNothing,
}

/// Whether a law changes with a speed or a position along its own combination.
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
    } else if !vanishes(by_speed()) || is_of_places() && !vanishes(by_place()) {
        Kind::Determines
    } else {
        Kind::DeterminesNothing
    }
}

/// Rows that take a direction to zero where no law changes with the speeds along it: slopes of laws at points of whole numbers; none
/// where they have no such value.
fn speed_free(trace: &Trace<'_>, laws: &[Sym], open: &[usize]) -> Option<Vec<Vec<Rational>>> {
    let slopes: Vec<Vec<Sym>> =
        laws.iter().map(|law| open.iter().map(|&place| trace.by_speed(*law, place)).collect()).collect();
    let mut letters: Vec<Sym> = slopes.iter().flatten().flat_map(|slope| slope.symbols_of()).collect();
    letters.sort_by_key(|letter| letter.to_string());
    letters.dedup();
    let at = |point: i64| -> Option<Vec<Vec<Rational>>> {
        let values =
            letters.iter().zip(1_i64..).map(|(&letter, place)| (letter, Sym::int(3 + (7 * place * point) % 101)));
        let values: Vec<(Sym, Sym)> = values.collect();
        let row = |row: &Vec<Sym>| substitute_all(row, &values).into_iter().map(Sym::as_constant).collect();
        slopes.iter().map(row).collect()
    };
    Some([1, 5, 13].map(at).into_iter().collect::<Option<Vec<_>>>()?.concat())
}

/// A basis of what rows take to zero, directions along which more rows vanish first.
fn basis(rows: &[Vec<Rational>], more: &Option<Vec<Vec<Rational>>>, columns: usize) -> Vec<Vec<Rational>> {
    let all = null_space(rows.to_vec(), columns);
    let first = more.as_ref().map(|more| null_space([rows, more].concat(), columns)).unwrap_or_default();
    let mut chosen: Vec<Vec<Rational>> = Vec::new();
    for direction in first.into_iter().chain(all) {
        chosen.push(direction);
        if columns - null_space(chosen.clone(), columns).len() < chosen.len() {
            chosen.pop();
        }
    }
    chosen
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
