//! Steady motions of systems with free frames, by two sets of angles; each set is regular where the other is singular.
//!
//! Let e be the axis of the parent about which the law is invariant, such as the vertical, and s an axis of the frame: the axis of a body of
//! revolution, otherwise the axis with the same letter as e. The first set
//!
//!   R = R_e R_a R_s :    c = e . R s ,
//!
//! is regular where |c| is not 1. If s has the same letter as e, these are Euler's angles with c = cos(nutation), and the second set is that of
//! Tait and Bryan. Otherwise the sets are exchanged, and c is the sine of an elevation. If the frame rotates steadily about e, and about s if
//! nothing depends on this spin, only these two angles of the first set change. If s is parallel to e, both rotations coincide.

use super::frame_angles::{Angles, Factor, Set};
use super::quasi_velocities::without_part;
use super::{Case, NoSteadyMotions, Range, SteadyMotion, SteadyMotions, SteadySearch, Unknown};
use crate::branch::settled;
use crate::changing_laws::changes;
use crate::readiness::independent_start;
use field::Analytic;
use model::{FrameAngles, FrameId, Model, Source, Trace};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use symbolic::Sym;

/// The largest number of free frames; each frame doubles the number of searches.
const MOST_FRAMES: usize = 2;

/// Overlap of both sets, as an angle in radians.
const OVERLAP: f64 = 0.01;

/// Least distance from singular orientations of a set, as an angle in radians.
const LEAST: f64 = 1e-3;

/// Motions whose values differ by less are equal; in SI units and relative to the values.
const SAME: f64 = 1e-7;

/// A lower bound for a product P of sines and cosines: for |P| if `is_positive` is `None`, for P if true, for -P if false.
#[derive(Clone, Debug, PartialEq)]
pub struct Steep {
    factors: Vec<(String, Factor)>,
    least: f64,
    is_positive: Option<bool>,
}

/// A model with angles in the place of its free frames, and the ranges of angles for which this set is used.
#[derive(Clone, Debug)]
pub struct Orientation {
    pub model: Model,
    /// The options of the search for this set of angles.
    pub asked: SteadySearch,
    frames: Vec<Angles>,
    /// Descriptions of these ranges.
    held: Vec<String>,
}

/// The axis e of the parents; for each frame the axis s, and whether nothing depends on the rotation about s.
struct Axes {
    parent: usize,
    own: Vec<(usize, bool)>,
}

impl Orientation {
    /// The models with all combinations of sets of angles for the free frames of a model that was elaborated from `source`.
    ///
    /// # Errors
    /// If there are too many free frames, or a part of the text uses the free rotation itself.
    pub fn all(source: &Source, model: &Model, asked: &SteadySearch) -> Result<Vec<Self>, NoSteadyMotions> {
        let count = model.free.len();
        if count > MOST_FRAMES {
            let why = format!("{count} frames turn freely, and angles are tried for {MOST_FRAMES}");
            return Err(NoSteadyMotions::FreeFrame { why });
        }
        let axes = Axes::of(source, model)?;
        let mut sets: Vec<Vec<Set>> = vec![Vec::new()];
        for &(own, is_spinning) in &axes.own {
            let each = Set::all((axes.parent, own), is_spinning);
            sets = sets
                .iter()
                .flat_map(|before| each.iter().map(|set| [&before[..], std::slice::from_ref(set)].concat()))
                .collect();
        }
        let mut all = Vec::new();
        for sets in sets {
            let mut own = Self::with(source, model, &sets)?;
            if own.take(model, &sets, asked) {
                all.push(own);
            }
        }
        Ok(all)
    }

    fn with(source: &Source, original: &Model, sets: &[Set]) -> Result<Self, NoSteadyMotions> {
        let mut source = source.clone();
        source.outputs.clear();
        let texts = sets.iter().map(|set| FrameAngles { axes: set.axes, names: set.names.map(str::to_owned) });
        source.angles = texts.collect();
        let read = Model::of(&source).and_then(settled);
        let mut model = read.map_err(|faults| {
            let why = faults.first().map_or_else(String::new, |fault| format!("{}: {}", fault.title, fault.label));
            NoSteadyMotions::FreeFrame { why }
        })?;
        for (own, given) in model.parameters.iter_mut().zip(&original.parameters) {
            own.clone_from(given);
        }
        model.close_inputs();
        let plain = model.coordinates.len() - 3 * sets.len();
        let frame = |(at, set): (usize, &Set)| {
            let own = &original.frames[original.free[at].0];
            let parent = own.parent.map_or(FrameId::GROUND, |(parent, _)| parent);
            let parent = original.frames[parent.0].name.clone();
            Angles { parent, frame: own.name.clone(), axes: set.axes, names: set.names, first: plain + 3 * at }
        };
        let frames = sets.iter().enumerate().map(frame).collect();
        Ok(Orientation { model, asked: SteadySearch::default(), frames, held: Vec::new() })
    }

    /// Adopts the start and the searched ranges; returns false if the ranges are given for angles of another set.
    fn take(&mut self, original: &Model, sets: &[Set], asked: &SteadySearch) -> bool {
        self.asked = SteadySearch { steep: Vec::new(), ..asked.clone() };
        for (number, (angles, set)) in self.frames.iter().zip(sets).enumerate() {
            let of = |name: &str, primes: &str| format!("{}.{name}{primes}", angles.frame);
            let range = |name: String| asked.ranges.iter().rev().find(|(own, _)| *own == name).map(|(_, range)| *range);
            let is_asked = |names: [&str; 3]| names.into_iter().any(|name| range(of(name, "")).is_some());
            let is_doubled = set.is_positive == Some(false) && is_asked(set.names);
            if is_asked(set.other) || is_doubled {
                return false;
            }
            let main = angles.as_main(set);
            let start = main.start(original, number, set.is_spinning);
            let rates: [f64; 3] = std::array::from_fn(|k| start[3 + k].value);
            // rates about the axis of the parent, and about the axis of the frame if it is no coordinate of this set
            let (main_names, first) = (main.names, of(set.names[0], "'"));
            let about = range(of(main_names[0], "'")).or_else(|| range(first.clone()));
            let spin = if set.is_spinning { range(of(main_names[2], "'")) } else { None };
            // ranges of rates are given by names of one set, which other sets do not have
            let turning = [of(set.names[0], "'")].into_iter().chain(set.other.map(|name| of(name, "'")));
            let turning: Vec<String> = turning.collect();
            self.asked.ranges.retain(|(own, _)| !turning.contains(own));
            if set.is_main {
                self.model.start.extend(start);
                self.asked.ranges.extend(about.map(|about| (first, about)));
            } else {
                // both axes are parallel or opposite, so that only the sum or difference of the rates matters
                let point = |value: f64| Range { from: value, to: value };
                let about_ends = about.unwrap_or(point(rates[0]));
                let spin_ends = spin.unwrap_or(point(if set.is_spinning { rates[2] } else { 0.0 }));
                let own = range(first.clone()).map(|own| [own.from, own.to]);
                let ends = match set.is_positive {
                    _ if own.is_some() => own.unwrap_or_default(),
                    Some(false) => [about_ends.from - spin_ends.to, about_ends.to - spin_ends.from],
                    _ => [about_ends.from + spin_ends.from, about_ends.to + spin_ends.to],
                };
                let mut start = angles.start(original, number, false);
                start[3].value = ends[0];
                self.model.start.extend(start);
                self.asked.ranges.retain(|(own, _)| *own != of(main_names[2], "'"));
                let is_cyclic = || symbolic::apart(|| without_part(&self.model)).is_ok_and(|own| own[angles.first]);
                if range(first.clone()).is_some() || (about.is_some() || spin.is_some()) && is_cyclic() {
                    self.asked.ranges.push((first, Range { from: ends[0], to: ends[1] }));
                }
            }
            let steep = |factors: &[(usize, Factor)], least: f64, is_positive: Option<bool>| Steep {
                factors: factors.iter().map(|&(at, factor)| (of(set.names[at], ""), factor)).collect(),
                least,
                is_positive,
            };
            // excludes singular orientations of the set
            self.asked.steep.push(steep(&[(1, set.regular)], LEAST.sin(), None));
            if is_asked(set.names) {
                continue;
            }
            let narrow = if set.is_spinning { 2.0 * LEAST } else { FRAC_PI_4 };
            let aside = match (set.is_main, set.is_spinning) {
                (true, true) => FRAC_PI_2 - LEAST,
                (true, false) => FRAC_PI_2 - FRAC_PI_4 + OVERLAP,
                (false, _) => narrow + LEAST,
            };
            let middle = if set.has_angle_from_axis { FRAC_PI_2 } else { 0.0 };
            self.asked.ranges.push((of(set.names[1], ""), Range { from: middle - aside, to: middle + aside }));
            if !set.is_main {
                self.asked.steep.push(steep(&set.alignment, narrow.cos(), set.is_positive));
                let letter = |at: usize| ["x", "y", "z"][at];
                let from = format!("{}.{}", angles.parent, letter(set.axes[0]));
                let from = match set.is_positive {
                    None => format!("{from} or its opposite"),
                    Some(true) => from,
                    Some(false) => format!("the opposite of {from}"),
                };
                self.held.push(format!(
                    "{}.{} is at most {:.3} deg from {from}",
                    angles.frame,
                    letter(set.own),
                    narrow.to_degrees()
                ));
            }
        }
        // the search needs no start
        let _ = independent_start(&mut self.model);
        true
    }

    /// Descriptions of the angles and of the orientations for which they are used.
    pub fn in_words(&self) -> Vec<String> {
        let letter = |at: usize| ["x", "y", "z"][at];
        let frames = self.frames.iter().map(|own| {
            let turns = own.axes.iter().zip(own.names);
            let turns: Vec<String> =
                turns.map(|(&at, name)| format!("{}.{name} about {}", own.frame, letter(at))).collect();
            format!("{} turns by {}", own.frame, turns.join(", "))
        });
        frames.chain(self.held.iter().cloned()).collect()
    }
}

impl Axes {
    /// The axis of the parents on which the law depends least, the first of several; for each frame an axis about which nothing depends on the
    /// rotation, otherwise the axis with the same letter.
    fn of(source: &Source, model: &Model) -> Result<Self, NoSteadyMotions> {
        let count = model.free.len();
        let mut best: Option<(usize, Axes)> = None;
        for parent in [2, 1, 0] {
            let (mut about, mut own) = (0, vec![(parent, false); count]);
            for axis in [parent, (parent + 1) % 3, (parent + 2) % 3] {
                let sets: Vec<Set> = (0..count).map(|_| Set::main((parent, axis), false)).collect();
                let found = Orientation::with(source, model, &sets)?;
                let idle = symbolic::apart(|| without_part(&found.model))?;
                for (own, angles) in own.iter_mut().zip(&found.frames) {
                    about += usize::from(axis == parent && idle[angles.first]);
                    if !own.1 && idle[angles.first + 2] {
                        *own = (axis, true);
                    }
                }
            }
            let worth = 4 * about + own.iter().filter(|(_, is_spinning)| *is_spinning).count();
            if best.as_ref().is_none_or(|(known, _)| worth > *known) {
                best = Some((worth, Axes { parent, own }));
            }
        }
        Ok(best.map_or(Axes { parent: 2, own: vec![(2, false); count] }, |(_, axes)| axes))
    }
}

impl Orientation {
    /// The axis of the parent about which the first angle of the first frame turns, as a unit vector in components of this frame.
    pub fn vertical(&self, motion: &SteadyMotion) -> Vector3<f64> {
        let Some(angles) = self.frames.first() else { return Vector3::zeros() };
        let own = std::array::from_fn(|k| motion.state[angles.first + k]);
        angles.matrix(own).row(angles.axes[0]).transpose()
    }

    /// Coordinates, speeds, direction cosines and angular velocities of a motion, which do not depend on the set of angles.
    fn seen(&self, found: &SteadyMotions, motion: &SteadyMotion) -> Vec<f64> {
        let n = motion.state.len() / 2;
        let plain = self.frames.first().map_or(n, |angles| angles.first);
        let of_frames = self.frames.iter().flat_map(|angles| angles.seen(motion, self.is_whole(angles, found)));
        motion.state[..plain].iter().chain(&motion.state[n..n + plain]).copied().chain(of_frames).collect()
    }
}

/// A set of angles, and the motions in each combination of cases of the conditions.
pub type InOrientation = (Orientation, Vec<(Vec<Case>, SteadyMotions)>);

impl SteadyMotions {
    /// All steady motions for several sets of angles; a motion that two sets describe is listed in the first.
    ///
    /// # Errors
    /// If the search is not supported for a set, or unknowns have no range.
    pub fn of_orientations(
        all: Vec<Orientation>,
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<Vec<InOrientation>, NoSteadyMotions> {
        let (mut known, mut told): (Vec<Vec<f64>>, Vec<_>) = (Vec::new(), Vec::new());
        // unknowns without range are collected over all sets for one message
        let mut missing: Vec<String> = Vec::new();
        for own in all {
            let found = match changes(&own.model) {
                true => Self::of_cases(&own.model, &own.asked, &mut goes_on),
                false => Self::of(&own.model, &own.asked, &mut goes_on).map(|found| vec![(Vec::new(), found)]),
            };
            let found = match found {
                Err(NoSteadyMotions::WithoutRange { names }) => {
                    missing.extend(names.into_iter().filter(|name| !missing.contains(name)).collect::<Vec<_>>());
                    continue;
                }
                found => found?,
            };
            let before = known.clone();
            let found = found.into_iter().map(|(cases, mut found)| {
                let seen: Vec<Vec<f64>> = found.motions.iter().map(|motion| own.seen(&found, motion)).collect();
                let is_known = |own: &Vec<f64>| {
                    before.iter().any(|other| {
                        own.len() == other.len()
                            && own.iter().zip(other).all(|(a, b)| (a - b).abs() <= SAME * (1.0 + a.abs()))
                    })
                };
                let mut keep = seen.iter().map(|own| !is_known(own)).collect::<Vec<_>>().into_iter();
                found.motions.retain(|_| keep.next().unwrap_or(true));
                known.extend(seen);
                (cases, found)
            });
            let found = found.collect();
            told.push((own, found));
        }
        if !missing.is_empty() {
            return Err(NoSteadyMotions::WithoutRange { names: missing });
        }
        Ok(told)
    }

    /// The motions of all sets of angles, with direction cosines instead of angles.
    pub(super) fn united_orientations(all: Vec<InOrientation>) -> Self {
        let by_cosines = |(own, cases): InOrientation| {
            let mut found = Self::united(cases);
            let unknowns = own.cosines(&found);
            for place in 0..found.motions.len() {
                found.motions[place].state = own.seen(&found, &found.motions[place]);
            }
            for motion in &mut found.motions {
                motion.enclosure = unknowns.iter().map(|unknown| [motion.state[unknown.place]; 2]).collect();
            }
            found.unknowns = unknowns;
            (Vec::new(), found)
        };
        Self::united(all.into_iter().map(by_cosines).collect())
    }
}

impl Orientation {
    /// The unknowns of a search with direction cosines instead of angles, in the order of [`Orientation::seen`].
    fn cosines(&self, found: &SteadyMotions) -> Vec<Unknown> {
        let n = found.state_size / 2;
        let plain = self.frames.first().map_or(n, |angles| angles.first);
        let kept = found.unknowns.iter().filter(|unknown| unknown.place % n < plain);
        let mut all: Vec<Unknown> = kept
            .map(|unknown| Unknown { place: unknown.place % n + unknown.place / n * plain, ..unknown.clone() })
            .collect();
        let mut place = 2 * plain;
        for angles in &self.frames {
            let rows = angles.rows(self.is_whole(angles, found));
            for (row, column) in rows.flat_map(|row| (0..3).map(move |column| (row, column))) {
                let axis = |at: usize| ["x", "y", "z"][at];
                let name = format!("{}.{} . {}.{}", angles.parent, axis(row), angles.frame, axis(column));
                // contains all direction cosines
                let range = Range { from: -2.0, to: 2.0 };
                all.push(Unknown { name, place, is_circle: false, range });
                place += 1;
            }
            // the three components of the angular velocity
            place += 3;
        }
        all
    }

    fn is_whole(&self, angles: &Angles, found: &SteadyMotions) -> bool {
        !found.cyclic.contains(&format!("{}.{}", angles.frame, angles.names[0]))
    }
}

/// For each lower bound an expression that must not be negative.
pub(super) fn steep(trace: &Trace<'_>, names: &[String], asked: &SteadySearch, is_cyclic: &[bool]) -> Vec<Sym> {
    let each = asked.steep.iter().filter_map(|steep| {
        let mut product = Sym::ONE;
        for (name, factor) in &steep.factors {
            let place = names.iter().position(|own| own == name).filter(|&place| !is_cyclic[place])?;
            let circle = trace.coordinates[place].circle();
            product *= if *factor == Factor::Sine { circle.sin } else { circle.cos };
        }
        let least = Sym::constant(field::Rational::exactly(steep.least));
        Some(match steep.is_positive {
            None => product * product - least * least,
            Some(true) => product - least,
            Some(false) => -product - least,
        })
    });
    each.collect()
}
