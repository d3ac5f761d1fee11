//! Stability of a steady motion: by the energy where it is conserved, else by the linear equations.

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

/// The stability of a steady motion, as far as it is known.
#[derive(Clone, Debug)]
pub enum SteadyStability {
    /// The potential energy, in frames that turn at a given rate less the kinetic energy at rest in them (Jacobi), and amended by the kinetic energy of cyclic coordinates at the momenta that they have there, has a strict minimum in
    /// every direction that constraints leave: stable in all but cyclic coordinates (Lagrange and Dirichlet, Routh).
    Minimum,
    /// The potential energy has a strict minimum, and dampers lessen the energy: stable (Lagrange and Dirichlet).
    MinimumWithLoss,
    /// At rest without gyroscopic forces, and the potential energy falls in so many directions: unstable, since frequencies there are
    /// imaginary.
    Falls(usize),
    /// The amended potential energy decreases in an odd number of directions: unstable with any gyroscopic forces (Thomson and Tait).
    FallsOdd(usize),
    /// A condition of the law is zero there, and so much is known of the side of it that was searched.
    AtCondition(Option<OnSide>),
    /// The law has a kink there, and the potential energy has a strict minimum on each of its sides: a strict minimum, since its slope does
    /// not jump (Lagrange and Dirichlet).
    MinimumOnSides,
    /// The law has a kink there, at rest, and on one of its two sides the potential energy falls in so many directions: unstable. With one
    /// coordinate it is that of the force at rest, and dampers may act.
    ///
    /// An eigenvector v of M^-1 V'' of that side with a negative eigenvalue, along which energy falls, or -v, leads into the side, unless it
    /// is tangent to the kink; motions that leave the equilibrium along it (its unstable manifold) stay on the side, whose law alone acts.
    /// If all of them are tangent, V'' of the other side, which differs by a multiple of n n^T with the normal n, has the same ones, so that
    /// motions grow along them on both.
    FallsOnSide(usize),
    /// Dry friction resists every motion, and no share of it is used up: after a small push the system comes to rest nearby.
    HeldByFriction,
    /// Dry friction with negative coefficients feeds every motion.
    FedByFriction,
    /// The mass matrix is singular there, so that these coordinates do not describe the position: the equations hold without force, and
    /// neither equilibrium nor stability follows.
    Singular(Vec<String>),
    /// By eigenvalues of the linear equations.
    Linear(Box<Eigenvalues>),
    /// A contact without friction presses there. A small push may open it, of which the linear equations of motions in touch, with these
    /// eigenvalues, know nothing: none of them grows.
    InTouch(Box<Eigenvalues>),
    /// There are no linear equations.
    Unknown(String),
}

/// Eigenvalues at a motion, as numbers and in discs.
#[derive(Clone, Debug)]
pub struct Eigenvalues {
    pub linear: Linear,
    pub enclosed: Result<EnclosedSpectrum, NotEnclosed>,
}

impl Eigenvalues {
    /// The stability by numbers: by the centres of discs, where there are some.
    pub fn by_numbers(&self) -> Stability {
        let centres = self.enclosed.as_ref().ok().and_then(EnclosedSpectrum::by_centres);
        centres.unwrap_or(self.linear.stability)
    }
}

/// The potential energy of one side of a kink.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OnSide {
    /// The number of directions in which it falls at rest.
    pub falls: usize,
    /// Whether the condition is zero on a smooth surface through the motion.
    pub is_regular: bool,
}

/// The stability at an enclosure of unknowns and reactions; `state` is a state within it.
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
    // the first derivatives say nothing at a degenerate motion: each side is judged alone
    let is_open = boxes.lies_aside(enclosure) != Some(true)
        && (degenerate.is_some() || !is_smooth(model, equations, boxes, enclosure));
    // a coordinate held fixed by the user may move: then the energy test decides nothing
    let is_whole =
        equations.coordinates == equations.unknowns.len() && equations.coordinates + equations.cyclic.len() == n;
    let keeps_energy = equations.energy_integral.is_some() || keeps_energy(model);
    // the amended potential is taken at the momenta of cyclic coordinates: these must be kept
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
    // inputs have their values, with all derivatives of these
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
            // motions in touch that grow are motions of the system: near the motion the contact presses
            if presses(model, equations) && !grows {
                SteadyStability::InTouch(found)
            } else {
                SteadyStability::Linear(found)
            }
        }
        Err(why) => SteadyStability::Unknown(why.to_string()),
    }
}

/// The reason for which the motion of a contact that slides is not judged.
const OF_CONTACTS: &str = "friction depends on normal forces, which may change when contacts slide";

/// The places of speeds as names.
pub(super) fn names(model: &Model, places: &[usize]) -> Vec<String> {
    let all = state_names(model);
    places.iter().map(|&place| all[place].clone()).collect()
}

/// The side of a kink of a system with one coordinate, damped or fed, where the force at rest drives away: M p^2 + d p - dR/dq = 0 has one
/// positive root p then, whatever d is.
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

/// The conditions and contacts that are held at zero, by their places.
fn held(equations: &SteadyEquations) -> impl Iterator<Item = usize> {
    equations.cases.iter().enumerate().filter(|(_, case)| **case == Case::Between).map(|(place, _)| place)
}

/// Whether a contact is in touch that may open.
fn presses(model: &Model, equations: &SteadyEquations) -> bool {
    let may_open = |place: usize| {
        let contact = place.checked_sub(model.switches.len()).and_then(|own| model.contacts.get(own));
        contact.is_some_and(|contact| contact.sides == Sides::One)
    };
    held(equations).any(may_open)
}

/// Whether the law has no kink at any condition that is held at zero, as that of dry friction without force, and contacts in touch are smooth.
/// Where such a contact presses, V - V0 >= N gap + (a positive definite form) about a minimum on its surface, and impacts add no energy.
fn is_without_jumps(model: &Model, equations: &SteadyEquations) -> bool {
    let (conditions, contacts): (Vec<usize>, Vec<usize>) =
        held(equations).partition(|place| *place < model.switches.len());
    contacts.iter().all(|place| !equations.rubbing.contains(place))
        && joins_smoothly(model, &equations.cases, &conditions)
}

/// Whether the law is once continuously differentiable at the conditions that may be zero in an enclosure, and everything else lies aside.
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

/// The number of directions in which the amended potential energy decreases; none if this is not decided. The matrix
///
///   | V'' - lambda f'' - T''   f'^T   p'^T |
///   | f'                        0     0    |
///   | p'                        0    -M_c  |
///
/// where a contact presses along the unit vector n = f'/|f'| with the force N = lambda |f'|. The derivative of N n differs from lambda f'' by
/// a product of f' with another vector, whose symmetric part is zero in every direction along the surface. The matrix
///
/// with the momenta p of cyclic coordinates and their masses M_c has a positive eigenvalue for each constraint and each direction in
/// which that energy increases, and a negative one for each constraint, each cyclic coordinate and each direction in which it decreases.
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
        // residuals are forces: less the derivatives of the energy
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
