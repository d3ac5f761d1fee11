//! All steady motions of a model in a box: equilibria, and motions in which only cyclic coordinates move, at constant speeds. The search is
//! complete: [`algebra::boxes`] excludes boxes in which an equation has no zero, proves zeros, and reports the undecided rest.

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

/// A steady motion: the only one in a box about it.
#[derive(Clone, Debug)]
pub struct SteadyMotion {
    /// Unknowns, as narrowly as rounding allows.
    pub enclosure: Vec<[f64; 2]>,
    /// The whole state.
    pub state: Vec<f64>,
    /// Quasi-velocities among the independent speeds.
    pub quasi_velocities: Vec<(String, f64)>,
    pub stability: SteadyStability,
    /// The conditions that may be zero there, by their places in the combination of cases.
    pub at_conditions: Vec<usize>,
}

/// A member of a family.
#[derive(Clone, Debug)]
pub struct Member {
    /// Unknowns, to rounding.
    pub values: Vec<f64>,
    pub state: Vec<f64>,
    /// The linear equations there, as numbers.
    pub linear: Option<Linear>,
    /// The eigenvalues without cyclic coordinates by enclosures, where the member moves, so that equations at one instant say nothing.
    pub enclosed: Option<EnclosedSpectrum>,
    /// Coordinates that have no inertia there, so that they do not describe the position.
    pub without_inertia: Vec<String>,
}

/// All steady motions of a search, with its undecided regions.
#[derive(Clone, Debug, Default)]
pub struct SteadyMotions {
    pub unknowns: Vec<Unknown>,
    /// The number of coordinates and speeds: unknowns from this place on are shares of friction, or of a law between two sides.
    pub state_size: usize,
    /// Coordinates and speeds with given values.
    pub given: Vec<(String, f64)>,
    /// Coordinates that occur nowhere.
    pub cyclic: Vec<String>,
    /// Those of them that occur at other values of the parameters.
    pub cyclic_by_values: Vec<String>,
    pub motions: Vec<SteadyMotion>,
    /// Whether the loads have a potential energy, however they are written.
    pub have_potential: bool,
    /// Whether frames that turn at a given rate give kinetic energy to what rests in them: Jacobi's integral is kept.
    pub are_in_turning_frames: bool,
    /// Families of motions, with the stability of some members of each.
    pub families: Vec<(Family, Vec<Member>)>,
    /// Given speeds that may have any other value: there are motions for each value.
    pub free_speeds: Vec<String>,
    /// Boxes in which there may be further motions.
    pub undecided: Vec<Vec<[f64; 2]>>,
    /// Undecided boxes grouped into regions.
    pub regions: Vec<Region>,
    /// The share of undecided boxes in the whole box.
    pub undecided_part: f64,
    /// Undecided boxes at the zero of conditions that are reported in a combination for both sides.
    pub elsewhere: usize,
    /// The number of examined boxes.
    pub examined: usize,
    /// Places at which the coordinates are singular, where the motions are listed without these: the unknowns there.
    pub singular_places: Vec<Vec<[f64; 2]>>,
}

impl SteadyMotions {
    /// All steady motions in a box; the search calls `goes_on` regularly and ends if it returns false.
    ///
    /// # Errors
    /// The reason for which steady motions are not searched for.
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

    /// Steady motions in each combination of cases of the conditions of a law.
    ///
    /// # Errors
    /// The reason for which steady motions are not searched for.
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

    /// States of the model with the integrals of quasi-velocities become those of the original one.
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
        // boxes that were not looked at may lie on an excluded side
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
                // friction stops a motion that has a kinetic energy
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

    /// Nothing is known where there was no time to search.
    fn not_searched() -> Self {
        SteadyMotions { undecided: vec![Vec::new()], undecided_part: 1.0, ..SteadyMotions::default() }
    }

    /// The motions at which the coordinates describe the position; others are counted alone.
    fn without_singular_places(mut self) -> Self {
        let is_singular = |motion: &SteadyMotion| matches!(motion.stability, SteadyStability::Singular(_));
        let (singular, regular): (Vec<SteadyMotion>, Vec<SteadyMotion>) =
            std::mem::take(&mut self.motions).into_iter().partition(is_singular);
        self.motions = regular;
        self.singular_places.extend(singular.into_iter().map(|motion| motion.enclosure));
        self
    }

    /// Whether there is no steady motion, and nothing is undecided.
    pub fn is_empty(&self) -> bool {
        self.motions.is_empty() && self.families.is_empty() && self.is_complete()
    }

    /// Whether every steady motion of the box is among them.
    pub fn is_complete(&self) -> bool {
        self.undecided.is_empty()
    }
}

/// Values that differ by rounding alone sort as one.
fn rounded(value: f64) -> f64 {
    (value * 1e9).round() + 0.0
}
