//! The options of a search for steady motions: ranges of unknowns, and limits.

use super::orientations::Steep;
use super::quasi_velocities::rates_by_name;
use super::refusal::NoSteadyMotions;
use field::Interval;
use model::{Model, Source};
use std::f64::consts::PI;
use std::sync::Arc;
use units::nearest;

/// The range of an unknown in SI units; a fixed value if both ends are equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The lower end.
    pub from: f64,
    /// The upper end.
    pub to: f64,
}

impl Range {
    /// One turn in radians; its ends avoid angles at which symmetric systems have equilibria.
    pub(super) const TURN: Range = Range { from: -PI - 0.617, to: PI - 0.6169 };

    /// A narrow range about a value.
    pub(super) fn about(value: f64) -> Range {
        let aside = ASIDE * (1.0 + value.abs());
        Range { from: value - aside, to: value + aside }
    }

    pub(super) fn is_point(self) -> bool {
        self.from == self.to
    }

    pub(super) fn interval(self) -> Interval {
        Interval::new(self.from, self.to)
    }
}

/// The options of a search for steady motions.
#[derive(Clone, Debug, Default)]
pub struct SteadySearch {
    /// Ranges by the names of coordinates and of speeds of cyclic coordinates; the last range of a name counts.
    pub ranges: Vec<(String, Range)>,
    /// The largest number of boxes that the search examines.
    pub boxes: usize,
    /// Lower bounds for products of sines and cosines, which exclude singular orientations.
    pub steep: Vec<Steep>,
    /// The source of the model; needed for free frames if motions are followed along a parameter.
    pub text: Option<Arc<Source>>,
}

impl SteadySearch {
    pub(super) fn names(&self) -> Vec<&str> {
        self.ranges.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// The options with each range widened on both sides by a fraction of its width.
    pub(super) fn wider(&self, part: f64) -> Self {
        let mut own = self.clone();
        for (_, range) in &mut own.ranges {
            let aside = part * (range.to - range.from);
            *range = Range { from: range.from - aside, to: range.to + aside };
        }
        own
    }

    /// The options in which a quasi-velocity that equals the rate of a coordinate has the name of this rate.
    pub(super) fn by_coordinates(&self, model: &Model) -> Self {
        let mut own = self.clone();
        let is_named = |name: &String| model.quasi_velocities.iter().any(|own| own.name == *name);
        if own.ranges.iter().any(|(name, _)| is_named(name)) {
            let rates = rates_by_name(model);
            for (name, _) in &mut own.ranges {
                if let Some((_, rate)) = rates.iter().find(|(own, _)| own == name) {
                    name.clone_from(rate);
                }
            }
        }
        own
    }

    pub(super) fn range(&self, name: &str) -> Option<Range> {
        self.ranges.iter().rev().find(|(own, _)| own == name).map(|(_, range)| *range)
    }

    /// The fixed value of a speed; `None` if it has no range, or a range of positive width.
    pub(super) fn speed(&self, name: &str) -> Option<f64> {
        self.range(name).filter(|range| range.is_point()).map(|range| range.from)
    }

    /// Refuses names with ranges that are not among the accepted ones.
    pub(super) fn checked<'a>(&self, accepted: impl Iterator<Item = &'a str>) -> Result<(), NoSteadyMotions> {
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

/// Half the width of a range about a state, within which a steady motion counts as that of the state; in SI units and relative to the value.
pub(super) const ASIDE: f64 = 1e-6;
