//! All steady motions of a model in a box: equilibria, and motions in which only cyclic coordinates move, at constant speeds. The search is
//! complete: [`algebra::boxes`] excludes boxes in which an equation has no zero, proves zeros, and reports the undecided rest.

mod admission;
mod along;
mod angle_sums;
mod borders;
mod circles;
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
mod idle_conditions;
mod inertia;
mod kinks;
mod momenta;
mod open_sides;
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
use model::{Model, Source};
use quasi_velocities::Extended;
use search::Boxes;
use stability::judged;
use std::f64::consts::PI;
use std::sync::Arc;
use units::nearest;

/// A range of an unknown, in SI units; one number where both ends are the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    pub from: f64,
    pub to: f64,
}

impl Range {
    /// A whole turn whose ends are not angles at which symmetric systems have equilibria.
    const TURN: Range = Range { from: -PI - 0.617, to: PI - 0.6169 };

    /// A little to both sides of a value.
    fn about(value: f64) -> Range {
        let aside = ASIDE * (1.0 + value.abs());
        Range { from: value - aside, to: value + aside }
    }

    fn is_point(self) -> bool {
        self.from == self.to
    }

    fn interval(self) -> Interval {
        Interval::new(self.from, self.to)
    }
}

/// The options of a search for steady motions.
#[derive(Clone, Debug, Default)]
pub struct SteadySearch {
    /// Ranges of coordinates, and of speeds of cyclic ones, by their names.
    pub ranges: Vec<(String, Range)>,
    /// The largest number of boxes to examine.
    pub boxes: usize,
    /// Products of sines and cosines that must not be small.
    pub steep: Vec<Steep>,
    /// The text of the model, for frames that turn freely, along a parameter.
    pub text: Option<Arc<Source>>,
}

impl SteadySearch {
    fn range(&self, name: &str) -> Option<Range> {
        self.ranges.iter().rev().find(|(own, _)| own == name).map(|(_, range)| *range)
    }

    /// The speed of a cyclic coordinate that is given as one number.
    fn speed(&self, name: &str) -> Option<f64> {
        self.range(name).filter(|range| range.is_point()).map(|range| range.from)
    }

    /// Whether each name is one of those that may have a range.
    fn checked<'a>(&self, accepted: impl Iterator<Item = &'a str>) -> Result<(), NoSteadyMotions> {
        let accepted: Vec<&str> = accepted.collect();
        match self.ranges.iter().find(|(name, _)| !accepted.contains(&name.as_str())) {
            None => Ok(()),
            Some((name, _)) => Err(NoSteadyMotions::Unknown {
                name: name.clone(),
                nearest: nearest(name, accepted.iter().copied()).map(str::to_owned),
                accepted: accepted.into_iter().map(str::to_owned).collect(),
            }),
        }
    }
}

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
    /// Places at which the coordinates are singular, where the motions are listed without these.
    pub singular_places: usize,
}

/// The distance from a state, relative to one in SI units and to the value, within which a steady motion counts as the one of this state.
const ASIDE: f64 = 1e-6;

impl SteadyMotions {
    /// All steady motions in a box; the search calls `goes_on` regularly and ends if it returns false.
    ///
    /// # Errors
    /// The reason for which steady motions are not searched for.
    pub fn of(model: &Model, asked: &SteadySearch, mut goes_on: impl FnMut() -> bool) -> Result<Self, NoSteadyMotions> {
        let names: Vec<&str> = asked.ranges.iter().map(|(name, _)| name.as_str()).collect();
        let extended = Extended::of(model, &names, None);
        let model = extended.as_ref().map_or(model, |extended| &extended.model);
        let equations = SteadyEquations::of(model, asked)?;
        Ok(Self::found(model, (equations, extended.as_ref()), asked, &mut goes_on))
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
        let combinations = admission::combinations(model, asked)?;
        let each = combinations.into_iter().map(|cases| {
            if !goes_on() {
                return Ok((cases, Self::not_searched()));
            }
            let equations = SteadyEquations::in_cases(model, asked, &cases)?;
            Ok((cases, Self::found(model, (equations, None), asked, &mut goes_on)))
        });
        Ok(kinks::joined(model, each.collect::<Result<_, NoSteadyMotions>>()?))
    }

    fn found(
        model: &Model,
        (equations, extended): (SteadyEquations, Option<&Extended>),
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
        let original = |state: Vec<f64>| match extended {
            Some(extended) => extended.original(&state),
            None => (state, Vec::new()),
        };
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
                let (state, quasi_velocities) = original(state);
                let mut at_conditions: Vec<usize> =
                    boxes.open_sides(&zero.enclosure).into_iter().map(|side| equations.side_places[side]).collect();
                at_conditions.retain(|place| *place != equations::NO_CASE);
                at_conditions.dedup();
                SteadyMotion { enclosure, state, quasi_velocities, stability, at_conditions }
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
                    Member { values, state: original(state).0, linear, enclosed, without_inertia }
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
            singular_places: 0,
        }
    }

    /// Nothing is known where there was no time to search.
    fn not_searched() -> Self {
        SteadyMotions { undecided: vec![Vec::new()], undecided_part: 1.0, ..SteadyMotions::default() }
    }

    /// The motions at which the coordinates describe the position; others are counted alone.
    fn without_singular_places(mut self) -> Self {
        let all = self.motions.len();
        self.motions.retain(|motion| !matches!(motion.stability, SteadyStability::Singular(_)));
        self.singular_places += all - self.motions.len();
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
