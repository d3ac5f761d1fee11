//! The options of a search: ranges of unknowns, and its limits.

use super::orientations::Steep;
use super::quasi_velocities::rates_by_name;
use super::refusal::NoSteadyMotions;
use field::Interval;
use model::{Model, Source};
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
    pub(super) const TURN: Range = Range { from: -PI - 0.617, to: PI - 0.6169 };

    /// A little to both sides of a value.
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
    pub(super) fn names(&self) -> Vec<&str> {
        self.ranges.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// With each range wider by a part of its width on both sides.
    pub(super) fn wider(&self, part: f64) -> Self {
        let mut own = self.clone();
        for (_, range) in &mut own.ranges {
            let aside = part * (range.to - range.from);
            *range = Range { from: range.from - aside, to: range.to + aside };
        }
        own
    }

    /// With a quasi-velocity that is the rate of one coordinate by the name of this rate.
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

    /// The speed of a cyclic coordinate that is given as one number.
    pub(super) fn speed(&self, name: &str) -> Option<f64> {
        self.range(name).filter(|range| range.is_point()).map(|range| range.from)
    }

    /// Whether each name is one of those that may have a range.
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

/// The distance from a state, relative to one in SI units and to the value, within which a steady motion counts as the one of this state.
pub(super) const ASIDE: f64 = 1e-6;
