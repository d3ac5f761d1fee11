//! Stability of a steady motion: by the energy where it is conserved, otherwise by the linear equations.

use super::conditions::Case;
use super::definiteness::signs;
use super::degenerate::Degenerate;
use super::differentiability::joins_smoothly;
use super::equations::SteadyEquations;
use super::friction::Friction;
use super::inertia::Inertia;
use super::jumps::at_jump;
use super::kept_contacts::{with_kept_contacts, without_outputs};
use super::quasi_velocities::state_names;
use super::search::Boxes;
use super::spectrum::{EnclosedSpectrum, EnclosedVerdict, NotEnclosed};
use crate::conservation::keeps_energy;
use crate::linearisation::{Linear, Stability, VariedEquations, law_at_rest};
use algebra::boxes::Equations;
use field::Interval;
use model::{Model, Sides};

/// The stability of a steady motion, as far as it is decided.
#[derive(Clone, Debug)]
pub enum SteadyStability {
    /// The amended potential has a strict minimum in all directions that constraints allow: stable, except for drift of cyclic coordinates (Lagrange
    /// and Dirichlet, Routh). This potential is V minus the kinetic energy at rest in frames that turn at a given rate (Jacobi), plus the
    /// kinetic energy of cyclic coordinates at constant momenta.
    Minimum,
    /// The potential energy has a strict minimum, and dampers dissipate energy: stable (Lagrange and Dirichlet).
    MinimumWithLoss,
    /// The potential energy decreases in this number of directions, at rest and without gyroscopic forces: unstable.
    Falls(usize),
    /// The amended potential decreases in an odd number of directions: unstable for any gyroscopic forces (Thomson and Tait).
    FallsOdd(usize),
    /// A condition of the law is zero at the motion; the contents are what is known of the searched side.
    AtCondition(Option<OnSide>),
    /// The law has a kink at the motion, and the potential energy has a strict minimum on each side. Its gradient does not jump, so that the minimum
    /// is strict in all directions: stable (Lagrange and Dirichlet).
    MinimumOnSides,
    /// The law has a kink at a position of rest, and on one of its two sides the potential energy decreases in this number of directions:
    /// unstable. With one coordinate, dampers may act, and the force at rest takes the place of the energy.
    ///
    /// Proof: let v be an eigenvector of M^-1 V'' of this side with a negative eigenvalue. Unless v is tangent to the kink, v or -v points into the
    /// side, and motions that leave the equilibrium in this direction (its unstable manifold) stay there. If all such v are tangent, V'' of
    /// the other side, which differs by a multiple of n n^T with the normal n, has them as eigenvectors, too: motions grow along v on both sides.
    FallsOnSide(usize),
    /// Dry friction resists every motion and is strictly below its limits: after a small push the system comes to rest nearby.
    HeldByFriction,
    /// Dry friction with negative coefficients supplies energy to every motion: unstable.
    FedByFriction,
    /// The mass matrix is singular, so that the named coordinates do not describe the position; neither equilibrium nor stability follows from the
    /// equations.
    Singular(Vec<String>),
    /// Decided, if at all, by eigenvalues of the linear equations.
    Linear(Box<Eigenvalues>),
    /// A contact without friction presses. A small push may open it, which the linear equations of the closed contact ignore; none of their
    /// eigenvalues has a positive real part.
    InTouch(Box<Eigenvalues>),
    /// The linear equations do not exist, for the given reason.
    Unknown(String),
}

/// Eigenvalues at a motion: numerical ones, and enclosures.
#[derive(Clone, Debug)]
pub struct Eigenvalues {
    /// The linear equations with numerical eigenvalues.
    pub linear: Linear,
    /// The enclosed eigenvalues, or the reason for which there are none.
    pub enclosed: Result<EnclosedSpectrum, NotEnclosed>,
}

impl Eigenvalues {
    /// The stability by numerical eigenvalues: the centres of the discs, if there are any.
    pub fn by_numbers(&self) -> Stability {
        let centres = self.enclosed.as_ref().ok().and_then(EnclosedSpectrum::by_centres);
        centres.unwrap_or(self.linear.stability)
    }
}

/// The potential energy on one side of a kink.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OnSide {
    /// The number of directions in which it decreases from the position of rest.
    pub falls: usize,
    /// Whether the condition is zero on a smooth surface through the motion.
    pub is_regular: bool,
}

/// The stability at an enclosure of unknowns and reactions; `state` is a state in it, `degenerate` the order of a zero of higher order.
pub(super) fn judged(
    model: &Model,
    equations: &SteadyEquations,
    boxes: &mut Boxes<'_>,
    (enclosure, state): (&[Interval], &[f64]),
    degenerate: Option<&Degenerate>,
) -> SteadyStability {
    let n = model.speeds();
    let inertia = Inertia::of(equations, boxes, enclosure, n);
    if let Inertia::Singular(places) = &inertia {
        return SteadyStability::Singular(names(model, places));
    }
    let friction = equations.friction.as_ref().filter(|_| inertia.is_positive());
    match friction.map(|own| own.at_motion(&enclosure[..equations.unknowns.len()])) {
        Some(Friction::Resists) => return SteadyStability::HeldByFriction,
        Some(Friction::Feeds) => return SteadyStability::FedByFriction,
        _ => {}
    }
    if equations.is_at_condition && !is_without_jumps(model, equations) {
        let rests = state[n..].iter().all(|speed| *speed == 0.0) && equations.cyclic.is_empty();
        let jumps = rests && inertia.is_positive();
        let decided = if jumps { at_jump(model, equations, boxes, (enclosure, n)) } else { None };
        return decided.unwrap_or(SteadyStability::AtCondition(None));
    }
    // first derivatives do not decide a degenerate motion: each side is judged alone
    let is_open = boxes.lies_aside(enclosure) != Some(true)
        && (degenerate.is_some() || !is_smooth(model, equations, boxes, enclosure));
    // coordinates fixed by the user may change: the energy then decides nothing
    let is_whole =
        equations.coordinates == equations.unknowns.len() && equations.coordinates + equations.cyclic.len() == n;
    let keeps_energy = equations.energy_integral.is_some() || keeps_energy(model);
    // the amended potential presumes constant momenta of cyclic coordinates
    let keeps_momenta =
        equations.cyclic_places.iter().all(|place| equations.kept_momenta.iter().any(|(kept, _)| kept == place));
    if is_whole && keeps_energy && keeps_momenta && inertia.is_positive() {
        let is_gyroscopic = equations.energy_integral.is_some_and(|integral| integral.is_gyroscopic);
        let rests = state[n..].iter().all(|speed| *speed == 0.0) && !is_gyroscopic;
        let falls = match degenerate {
            Some(own) => own.falls(equations, boxes).filter(|_| rests),
            None => falls(equations, boxes, enclosure),
        };
        if is_open {
            let is_regular = equations.reactions == 0 && boxes.has_regular_sides(enclosure);
            let side = falls.filter(|falls| *falls == 0 || rests).map(|falls| OnSide { falls, is_regular });
            return SteadyStability::AtCondition(side);
        }
        match falls {
            Some(0) => return SteadyStability::Minimum,
            Some(falls) if rests => return SteadyStability::Falls(falls),
            Some(falls) if falls % 2 == 1 => return SteadyStability::FallsOdd(falls),
            _ => {}
        }
    }
    let is_least = is_whole && equations.decays && equations.cyclic.is_empty() && inertia.is_positive();
    let is_least = is_least
        && match degenerate {
            Some(own) => own.falls(equations, boxes) == Some(0),
            None => falls(equations, boxes, enclosure) == Some(0),
        };
    if is_open {
        let side = match inertia.is_positive() {
            true if is_least => {
                let is_regular = equations.reactions == 0 && boxes.has_regular_sides(enclosure);
                Some(OnSide { falls: 0, is_regular })
            }
            true => drives_away(equations, boxes, enclosure, n),
            false => None,
        };
        return SteadyStability::AtCondition(side);
    }
    let Some(kept) = with_kept_contacts(model, &equations.cases) else {
        return SteadyStability::Unknown(OF_CONTACTS.to_owned());
    };
    let kept = without_outputs(&kept);
    let kept = law_at_rest(&kept, state);
    // values of inputs are kept as expressions, so that their derivatives count
    let varied = match VariedEquations::with_inputs(&kept, &[], &[]) {
        Ok(varied) => varied,
        Err(why) => return SteadyStability::Unknown(why.to_string()),
    };
    match varied.about(0.0, state) {
        Ok(linear) => {
            let enclosed = EnclosedSpectrum::of(&kept, equations, &varied, (enclosure, state), keeps_energy);
            let verdict = enclosed.as_ref().map(EnclosedSpectrum::verdict);
            let grows = matches!(verdict, Ok(EnclosedVerdict::Unstable(_)));
            let fades = matches!(verdict, Ok(EnclosedVerdict::Asymptotic)) && !presses(model, equations);
            if is_least && !(grows || fades) {
                return SteadyStability::MinimumWithLoss;
            }
            let found = Box::new(Eigenvalues { linear, enclosed });
            // instability of the closed contact is instability of the system, since the contact presses in a neighbourhood
            if presses(model, equations) && !grows {
                SteadyStability::InTouch(found)
            } else {
                SteadyStability::Linear(found)
            }
        }
        Err(why) => SteadyStability::Unknown(why.to_string()),
    }
}

/// The reason for which a sliding contact is not judged.
const OF_CONTACTS: &str = "friction depends on normal forces, which may change when contacts slide";

/// The names of the coordinates with the given indices.
pub(super) fn names(model: &Model, places: &[usize]) -> Vec<String> {
    let all = state_names(model);
    places.iter().map(|&place| all[place].clone()).collect()
}

/// For a system with one coordinate and any damping: the result `OnSide` with one unstable direction, if the force at rest drives away on the
/// searched side. M p^2 + d p - dR/dq = 0 then has one positive root p for every d.
fn drives_away(equations: &SteadyEquations, boxes: &mut Boxes<'_>, enclosure: &[Interval], n: usize) -> Option<OnSide> {
    let is_one = n == 1 && equations.coordinates == 1 && enclosure.len() == 1;
    if !is_one {
        return None;
    }
    let mut slope = [Interval::EVERYTHING];
    boxes.slopes(enclosure, &mut slope);
    let is_regular = boxes.has_regular_sides(enclosure);
    (slope[0].low() > 0.0).then_some(OnSide { falls: 1, is_regular })
}

/// The indices of conditions and contacts with `Case::Between`.
fn held(equations: &SteadyEquations) -> impl Iterator<Item = usize> {
    equations.cases.iter().enumerate().filter(|(_, case)| **case == Case::Between).map(|(place, _)| place)
}

/// Whether a contact that can open is closed.
fn presses(model: &Model, equations: &SteadyEquations) -> bool {
    let may_open = |place: usize| {
        let contact = place.checked_sub(model.switches.len()).and_then(|own| model.contacts.get(own));
        contact.is_some_and(|contact| contact.sides == Sides::One)
    };
    held(equations).any(may_open)
}

/// Whether the law is continuously differentiable at all conditions that are zero, and closed contacts are smooth. If such a contact presses,
/// V - V0 >= N gap + (a positive definite form) about a minimum on its surface, and impacts add no energy.
fn is_without_jumps(model: &Model, equations: &SteadyEquations) -> bool {
    let (conditions, contacts): (Vec<usize>, Vec<usize>) =
        held(equations).partition(|place| *place < model.switches.len());
    contacts.iter().all(|place| !equations.rubbing.contains(place))
        && joins_smoothly(model, &equations.cases, &conditions)
}

/// Whether the law is continuously differentiable at the conditions that may be zero in an enclosure, and all others have their required signs.
pub(super) fn is_smooth(
    model: &Model,
    equations: &SteadyEquations,
    boxes: &mut Boxes<'_>,
    enclosure: &[Interval],
) -> bool {
    let sides = boxes.open_sides(enclosure);
    let places: Vec<usize> = sides.iter().map(|&side| equations.side_places[side]).collect();
    boxes.lies_aside_but_for(enclosure, &sides) == Some(true)
        && !places.is_empty()
        && joins_smoothly(model, &equations.cases, &places)
}

/// The number of directions in which the amended potential decreases; `None` if undecided. The matrix
///
///   | V'' - lambda f'' - T''   f'^T   p'^T |
///   | f'                        0     0    |
///   | p'                        0    -M_c  |
///
/// with the momenta p of cyclic coordinates and their masses M_c has one positive eigenvalue for each constraint and each direction in which
/// this potential increases. It has one negative eigenvalue for each constraint, each cyclic coordinate and each direction of decrease.
///
/// A contact presses along the unit vector n = f'/|f'| with the force N = lambda |f'|. The derivative of N n differs from lambda f'' by a
/// product of f' with another vector, whose symmetric part is zero in every direction along the surface.
fn falls(equations: &SteadyEquations, boxes: &mut Boxes<'_>, enclosure: &[Interval]) -> Option<usize> {
    let (own, positions, cyclic) = (enclosure.len(), equations.unknowns.len(), equations.cyclic.len());
    let mut slopes = vec![Interval::EVERYTHING; own * own];
    boxes.slopes(enclosure, &mut slopes);
    let tape = equations.momenta.as_ref()?;
    let mut momenta = vec![Interval::EVERYTHING; tape.outputs()];
    tape.over::<Interval>().evaluate(&enclosure[..positions], &mut momenta);
    let (by_unknowns, masses) = momenta.split_at(cyclic * positions);
    let size = own + cyclic;
    let zero = Interval::point(0.0);
    let half = Interval::point(0.5);
    let entry = |row: usize, column: usize| match (row < own, column < own) {
        // residuals are forces: minus the derivatives of the energy
        (true, true) if row < positions && column < positions => {
            -(slopes[row * own + column] + slopes[column * own + row]) * half
        }
        (true, true) => slopes[row.max(column) * own + row.min(column)],
        (true, false) if row < positions => by_unknowns[(column - own) * positions + row],
        (false, true) if column < positions => by_unknowns[(row - own) * positions + column],
        (false, false) => -masses[(row - own) * cyclic + column - own],
        _ => zero,
    };
    let matrix: Vec<Interval> = (0..size * size).map(|at| entry(at / size, at % size)).collect();
    let [negative, _] = signs(&matrix, size)?;
    negative.checked_sub(equations.reactions + cyclic)
}
