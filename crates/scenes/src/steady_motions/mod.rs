//! All steady motions of a model in a box: equilibria, and motions in which only cyclic coordinates change, at constant speeds.
//!
//! The search is complete: [`algebra::boxes`] excludes boxes in which an equation has no zero, proves zeros, and reports undecided boxes.

mod admission;
mod along;
mod angle_sums;
mod borders;
mod circles;
mod condition_zeros;
mod conditions;
mod decision;
mod definiteness;
mod degenerate;
mod dependence;
mod determinacy;
mod differentiability;
mod dissipation;
mod energy_row;
mod equations;
mod families;
mod frame_angles;
mod friction;
mod given_values;
mod idle_conditions;
mod inertia;
mod jumps;
mod kept_contacts;
mod kinks;
mod momenta;
mod open_sides;
mod options;
mod orientations;
mod plane;
mod potential;
mod quasi_velocities;
mod refusal;
mod region;
mod rows;
mod search;
mod spectrum;
mod stability;
mod surplus;
mod tapes;
mod values;

pub use along::{Along, Bifurcation, Change, Sample};
pub use conditions::{Case, conditions_of};
pub use equations::Unknown;
pub use families::Family;
pub use friction::Friction;
pub use kept_contacts::with_kept_contacts;
pub use options::{Range, SteadySearch};
pub use orientations::{InOrientation, Orientation, Steep};
pub use plane::{Direction, PlaneCell, middles};
pub use potential::keeps_energy_near_rest;
pub use refusal::NoSteadyMotions;
pub use region::{Near, Region};
pub use spectrum::{
    Boundary, Crossings, EigenvalueDisc, EnclosedSpectrum, EnclosedVerdict, ExactAlong, Judged, NotEnclosed, Routh,
    Side, ZeroReason,
};
pub use stability::{Eigenvalues, OnSide, SteadyStability};

use crate::linearisation::{Linear, Standing, VariedEquations};
use algebra::boxes::Zero;
use circles::{is_same, turns_to_zero};
use decision::{Decision, is_in_range, part};
use degenerate::Degenerate;
use equations::SteadyEquations;
use field::Interval;
use inertia::Inertia;
use model::Model;
use options::ASIDE;
use quasi_velocities::Extended;
use search::Boxes;
use stability::judged;

/// A steady motion, proved to be the only one in a box about it.
#[derive(Clone, Debug)]
pub struct SteadyMotion {
    /// An interval that contains each unknown, in SI units, of a width near rounding errors.
    pub enclosure: Vec<[f64; 2]>,
    /// The state: coordinates, then speeds, in SI units.
    pub state: Vec<f64>,
    /// Names and values of quasi-velocities among the independent speeds.
    pub quasi_velocities: Vec<(String, f64)>,
    /// The stability, as far as it is decided.
    pub stability: SteadyStability,
    /// The indices, in the combination of cases, of conditions that may be zero at the motion.
    pub at_conditions: Vec<usize>,
}

/// A motion of a family, in numbers.
#[derive(Clone, Debug)]
pub struct Member {
    /// The unknowns in SI units, up to rounding.
    pub values: Vec<f64>,
    pub state: Vec<f64>,
    /// The linear equations at the motion.
    pub linear: Option<Linear>,
    /// Enclosed eigenvalues without cyclic coordinates, if the linear equations depend on time, so that their eigenvalues at one instant mean
    /// nothing.
    pub enclosed: Option<EnclosedSpectrum>,
    /// The names of coordinates that are singular at the motion, since they have no inertia there.
    pub without_inertia: Vec<String>,
}

/// The steady motions found by a search, and its undecided regions.
#[derive(Clone, Debug, Default)]
pub struct SteadyMotions {
    /// The unknowns of the search, in the order of all enclosures.
    pub unknowns: Vec<Unknown>,
    /// The number of coordinates and speeds. Unknowns with larger or equal indices are fractions of friction, or factors of conditions.
    pub state_size: usize,
    /// Names and values of coordinates and speeds that are fixed.
    pub given: Vec<(String, f64)>,
    /// The names of cyclic coordinates, which occur in no equation.
    pub cyclic: Vec<String>,
    /// The names of coordinates that are cyclic only for the given values of parameters.
    pub cyclic_by_values: Vec<String>,
    /// The isolated motions.
    pub motions: Vec<SteadyMotion>,
    /// Whether the loads have a potential energy, also if they are written as forces.
    pub have_potential: bool,
    /// Whether frames turn at a given rate, so that Jacobi's integral T2 + V - T0 takes the place of the energy.
    pub are_in_turning_frames: bool,
    /// Families of motions, each with some of its members.
    pub families: Vec<(Family, Vec<Member>)>,
    /// The names of given speeds that influence nothing: there are steady motions for each of their values.
    pub free_speeds: Vec<String>,
    /// Boxes, in SI units, that may contain further motions.
    pub undecided: Vec<Vec<[f64; 2]>>,
    /// The undecided boxes, grouped into connected regions.
    pub regions: Vec<Region>,
    /// The volume of undecided boxes as a fraction of the searched box.
    pub undecided_part: f64,
    /// The number of undecided boxes at zeros of conditions that are reported in another combination.
    pub elsewhere: usize,
    /// The number of examined boxes.
    pub examined: usize,
    /// The enclosures of motions at which coordinates are singular, if these were removed from `motions`.
    pub singular_places: Vec<Vec<[f64; 2]>>,
}

impl SteadyMotions {
    /// All steady motions in a box. The search calls `goes_on` regularly and ends when it returns false.
    ///
    /// # Errors
    /// If the search does not support the model, a name in `asked` is unknown, or an unknown has no range.
    pub fn of(model: &Model, asked: &SteadySearch, mut goes_on: impl FnMut() -> bool) -> Result<Self, NoSteadyMotions> {
        let asked = &asked.by_coordinates(model);
        let extended = Extended::of(model, &asked.names(), None);
        let model = extended.as_ref().map_or(model, |extended| &extended.model);
        let equations = SteadyEquations::of(model, asked)?;
        let found = Self::found(model, equations, asked, &mut goes_on);
        let mut found = found.with_free_values(model, asked, &[], &mut goes_on);
        extended.iter().for_each(|extended| found.restore(extended));
        Ok(found)
    }

    /// The steady motions in each combination of cases of the conditions and contacts of a law.
    ///
    /// # Errors
    /// As for [`SteadyMotions::of`]; also if there are too many combinations.
    pub fn of_cases(
        model: &Model,
        asked: &SteadySearch,
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<Vec<(Vec<Case>, Self)>, NoSteadyMotions> {
        let asked = &asked.by_coordinates(model);
        let extended = Extended::of(model, &asked.names(), None);
        let model = extended.as_ref().map_or(model, |extended| &extended.model);
        let combinations = admission::combinations(model, asked)?;
        let each = combinations.into_iter().map(|cases| {
            if !goes_on() {
                return Ok((cases, Self::not_searched()));
            }
            let equations = SteadyEquations::in_cases(model, asked, &cases)?;
            let found = Self::found(model, equations, asked, &mut goes_on);
            let found = found.with_free_values(model, asked, &cases, &mut goes_on);
            Ok((cases, found))
        });
        let mut all = kinks::joined(model, each.collect::<Result<_, NoSteadyMotions>>()?);
        if let Some(extended) = &extended {
            all.iter_mut().for_each(|(_, found)| found.restore(extended));
        }
        Ok(all)
    }

    /// Replaces states of the model extended by integrals of quasi-velocities by those of the original model.
    fn restore(&mut self, extended: &Extended) {
        for motion in &mut self.motions {
            (motion.state, motion.quasi_velocities) = extended.original(&motion.state);
        }
        for member in self.families.iter_mut().flat_map(|(_, members)| members) {
            member.state = extended.original(&member.state).0;
        }
    }

    fn found(
        model: &Model,
        equations: SteadyEquations,
        asked: &SteadySearch,
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Self {
        let domain: Vec<Interval> = equations.unknowns.iter().map(|unknown| unknown.range.interval()).collect();
        let mut boxes = Boxes::of(&equations, &equations.tapes);
        let Decision { mut found, families, mut undecided_part } =
            Decision::of(&equations, &mut boxes, &domain, asked.boxes, &mut *goes_on);
        let mut zeros = Vec::new();
        for zero in std::mem::take(&mut found.zeros) {
            match boxes.fulfils_all(&zero.enclosure) {
                Some(true) => zeros.push(zero),
                Some(false) => {}
                None => found.undecided.push(zero.enclosure[..domain.len()].to_vec()),
            }
        }
        // boxes that were not examined may violate a required sign
        found.undecided.retain(|at| boxes.lies_aside(&equations.with_reactions(at)) != Some(false));
        undecided_part = undecided_part.min(part(&found.undecided, &domain));
        let mut regions = region::regions(&equations, &zeros, &found.undecided);
        let mut zeros: Vec<(Zero, Option<Degenerate>)> = zeros.into_iter().map(|zero| (zero, None)).collect();
        regions.retain(|region| {
            let Some(own) = Degenerate::of(&equations, region) else { return true };
            let alone: Vec<Interval> = region.hull.iter().map(|&[low, high]| Interval::new(low, high)).collect();
            found.undecided.retain(|at| !at.iter().zip(&alone).all(|(at, alone)| at.is_part_of(*alone)));
            undecided_part = part(&found.undecided, &domain);
            zeros.push((Zero { enclosure: vec![Interval::point(own.at)], alone }, Some(own)));
            false
        });
        let mut inside: Vec<(Zero, Option<Degenerate>)> = Vec::new();
        for zero in zeros {
            if is_in_range(&equations.unknowns, &zero.0)
                && boxes.lies_aside(&zero.0.enclosure) != Some(false)
                && inside.iter().all(|(known, _)| !is_same(&equations.unknowns, known, &zero.0))
            {
                inside.push(zero);
            }
        }
        let mut motions: Vec<SteadyMotion> = inside
            .into_iter()
            .map(|(zero, degenerate)| {
                let mut enclosure = Vec::new();
                for (unknown, at) in equations.unknowns.iter().zip(&zero.enclosure) {
                    let turns = if unknown.is_circle { turns_to_zero(at.middle()) } else { 0.0 };
                    enclosure.push([at.low() + turns, at.high() + turns]);
                }
                let state = equations.state_at(enclosure.iter().map(|[low, high]| 0.5 * (low + high)));
                let stability = judged(model, &equations, &mut boxes, (&zero.enclosure, &state), degenerate.as_ref());
                let mut at_conditions: Vec<usize> =
                    boxes.open_sides(&zero.enclosure).into_iter().map(|side| equations.side_places[side]).collect();
                at_conditions.retain(|place| *place != equations::NO_CASE);
                at_conditions.dedup();
                SteadyMotion { enclosure, state, quasi_velocities: Vec::new(), stability, at_conditions }
            })
            .collect();
        motions.sort_by(|a, b| {
            a.state
                .iter()
                .zip(&b.state)
                .map(|(a, b)| rounded(*a).total_cmp(&rounded(*b)))
                .find(|order| order.is_ne())
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        let varied = match families.is_empty() {
            true => None,
            false => VariedEquations::with_inputs(model, &[], &[]).ok(),
        };
        let families = families
            .into_iter()
            .map(|family| {
                let mut has_inertia = true;
                let member = |values: &Vec<f64>| {
                    let state = equations.state_at(values.iter().copied().take(equations.unknowns.len()));
                    let at: Vec<Interval> = values.iter().map(|value| Interval::point(*value)).collect();
                    let inertia = Inertia::of(&equations, &mut boxes, &at, model.speeds());
                    has_inertia &= inertia.is_positive();
                    let without_inertia = match inertia {
                        Inertia::Singular(places) => stability::names(model, &places),
                        Inertia::Positive | Inertia::Open => Vec::new(),
                    };
                    let linear = varied.as_ref().filter(|_| without_inertia.is_empty() && goes_on());
                    let linear = linear.and_then(|own| own.about(0.0, &state).ok());
                    let moves = linear.as_ref().is_some_and(|own| own.standing == Standing::Moving);
                    let enclosed = moves.then(|| EnclosedSpectrum::near(model, &state, &mut *goes_on).ok()).flatten();
                    let values = values[..equations.unknowns.len()].to_vec();
                    Member { values, state, linear, enclosed, without_inertia }
                };
                let members = family.members.iter().map(member).collect();
                // friction stops a motion only if it has a kinetic energy
                let friction = family.friction.map(|own| if has_inertia { own } else { Friction::Open });
                (Family { friction, ..family }, members)
            })
            .collect();
        let ends = |at: Vec<Interval>| at.into_iter().map(|at| [at.low(), at.high()]).collect();
        let SteadyEquations { unknowns, state, given, cyclic, cyclic_by_values, energy_integral, free_speeds, .. } =
            equations;
        SteadyMotions {
            unknowns,
            state_size: state.len(),
            given,
            cyclic,
            cyclic_by_values,
            have_potential: energy_integral.is_some(),
            are_in_turning_frames: energy_integral.is_some_and(|own| own.is_of_jacobi),
            motions,
            families,
            free_speeds,
            undecided: found.undecided.into_iter().map(ends).collect(),
            regions,
            undecided_part,
            elsewhere: 0,
            examined: found.examined,
            singular_places: Vec::new(),
        }
    }

    /// The result of a search for which no time was left: everything is undecided.
    fn not_searched() -> Self {
        SteadyMotions { undecided: vec![Vec::new()], undecided_part: 1.0, ..SteadyMotions::default() }
    }

    /// Moves motions at which coordinates are singular from `motions` to `singular_places`.
    fn without_singular_places(mut self) -> Self {
        let is_singular = |motion: &SteadyMotion| matches!(motion.stability, SteadyStability::Singular(_));
        let (singular, regular): (Vec<SteadyMotion>, Vec<SteadyMotion>) =
            std::mem::take(&mut self.motions).into_iter().partition(is_singular);
        self.motions = regular;
        self.singular_places.extend(singular.into_iter().map(|motion| motion.enclosure));
        self
    }

    /// Whether the search proved that there is no steady motion.
    pub fn is_empty(&self) -> bool {
        self.motions.is_empty() && self.families.is_empty() && self.is_complete()
    }

    /// Whether all steady motions in the box were found.
    pub fn is_complete(&self) -> bool {
        self.undecided.is_empty()
    }
}

/// A value rounded so that rounding errors do not influence the order of motions.
fn rounded(value: f64) -> f64 {
    (value * 1e9).round() + 0.0
}
