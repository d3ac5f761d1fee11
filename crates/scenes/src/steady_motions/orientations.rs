//! Steady motions of systems with frames that turn freely: by two sets of angles, each regular where the other is not.
//!
//! With the axis e of the parent about which the law asks for nothing, and the next ones a and b,
//!
//!   R = R_e R_a(nutation) R_e(spin) :     e . R e = cos nutation ,
//!   R = R_e R_a(pitch) R_b(roll) :        e . R e = cos pitch cos roll ,
//!
//! the first (Euler) is regular where e . R e is not one in size, the second (Tait, Bryan) where e . R e is not zero. A motion in which the
//! frame turns about e alone at a constant speed rests in both but for the first angle.

use super::frame_angles::{Angles, EULER, TAIT_BRYAN};
use super::quasi_velocities::without_part;
use super::{Asked, Case, NoSteadyMotions, Range, SteadyMotion, SteadyMotions, Unknown};
use crate::branch::settled;
use crate::changing_laws::changes;
use crate::readiness::independent_start;
use field::Analytic;
use model::{FrameAngles, FrameId, Model, Source, Trace};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_4, PI};
use symbolic::Sym;

/// Frames that turn freely, at most: each doubles the number of searches.
const MOST_FRAMES: usize = 2;

/// An angle by which both sets overlap.
const OVERLAP: f64 = 0.01;

/// The nutation from which on Euler's angles serve where nothing depends on the spin.
const LEAST_NUTATION: f64 = 1e-3;

/// Numbers of two motions that differ by no more are those of one.
const SAME: f64 = 1e-7;

/// Two angles, the product of whose cosines is at least so large in size.
#[derive(Clone, Debug, PartialEq)]
pub struct Steep {
    pub angles: [String; 2],
    pub least: f64,
}

/// A set of angles of each free frame, with its model, and where motions are sought by it.
#[derive(Clone, Debug)]
pub struct Orientation {
    pub model: Model,
    pub asked: Asked,
    frames: Vec<Angles>,
}

impl Orientation {
    /// All sets for the free frames of a model that was read from a source.
    ///
    /// # Errors
    /// There are too many free frames, or a part of the text asks for the free turn itself.
    pub fn all(source: &Source, model: &Model, asked: &Asked) -> Result<Vec<Self>, NoSteadyMotions> {
        let frames: Vec<String> = model.free.iter().map(|frame| model.frames[frame.0].name.clone()).collect();
        if frames.len() > MOST_FRAMES {
            let why = format!("{} frames turn freely, and angles are tried for {MOST_FRAMES}", frames.len());
            return Err(NoSteadyMotions::FreeFrame { why });
        }
        let with = |axis: usize, is_euler: &[bool]| Self::with(source, model, &frames, (axis, is_euler));
        let euler = vec![true; frames.len()];
        // the first axis of those about which the law asks for the least
        let mut best: Option<(usize, Self, Vec<bool>)> = None;
        for axis in [2, 1, 0] {
            let own = with(axis, &euler)?;
            let idle = symbolic::apart(|| without_part(&own.model))?;
            let count = |idle: &[bool]| idle.iter().filter(|is_idle| **is_idle).count();
            if best.as_ref().is_none_or(|(.., known)| count(&idle) > count(known)) {
                best = Some((axis, own, idle));
            }
        }
        let Some((axis, own, idle)) = best else { return Ok(Vec::new()) };
        let spins: Vec<bool> = own.frames.iter().map(|angles| idle[angles.first + 2]).collect();
        let mut all = Vec::new();
        for set in 0..1 << frames.len() {
            let is_euler: Vec<bool> = (0..frames.len()).map(|at| set >> at & 1 == 0).collect();
            let mut own = with(axis, &is_euler)?;
            own.begin(model, &spins);
            if own.take(asked, &spins) {
                all.push(own);
            }
        }
        Ok(all)
    }

    fn with(
        source: &Source,
        original: &Model,
        frames: &[String],
        (axis, is_euler): (usize, &[bool]),
    ) -> Result<Self, NoSteadyMotions> {
        let mut source = source.clone();
        source.outputs.clear();
        source.angles.clear();
        let next = |by: usize| (axis + by) % 3;
        let sets = is_euler.iter().map(|is_euler| match is_euler {
            true => ([axis, next(1), axis], EULER),
            false => ([axis, next(1), next(2)], TAIT_BRYAN),
        });
        let sets: Vec<([usize; 3], [&str; 3])> = sets.collect();
        source
            .angles
            .extend(sets.iter().map(|(axes, names)| FrameAngles { axes: *axes, names: names.map(str::to_owned) }));
        let read = Model::of(&source).and_then(settled);
        let mut model = read.map_err(|faults| {
            let why = faults.first().map_or_else(String::new, |fault| format!("{}: {}", fault.title, fault.label));
            NoSteadyMotions::FreeFrame { why }
        })?;
        for (own, given) in model.parameters.iter_mut().zip(&original.parameters) {
            own.clone_from(given);
        }
        model.close_inputs();
        let plain = model.coordinates.len() - 3 * frames.len();
        let own = frames.iter().zip(sets).enumerate();
        let frames: Vec<Angles> = own
            .map(|(at, (frame, (axes, names)))| {
                let parent = original.frames[original.free[at].0].parent.map_or(FrameId::GROUND, |(parent, _)| parent);
                let parent = original.frames[parent.0].name.clone();
                Angles { parent, frame: frame.clone(), axes, names, first: plain + 3 * at }
            })
            .collect();
        Ok(Orientation { model, asked: Asked::default(), frames })
    }

    /// Begins where the frames begin that turn freely. A speed about the axis of the parent is the component of the angular velocity along it,
    /// the same for both sets, unless the spin is a motion of its own.
    fn begin(&mut self, original: &Model, spins: &[bool]) {
        for (number, (angles, &is_spinning)) in self.frames.iter().zip(spins).enumerate() {
            self.model.start.extend(angles.start(original, number, is_spinning && angles.names == EULER));
        }
        // a start that is missing is no obstacle
        let _ = independent_start(&mut self.model);
    }

    /// Takes the ranges that are asked for; false where these are of other sets.
    fn take(&mut self, asked: &Asked, spins: &[bool]) -> bool {
        self.asked = Asked { steep: Vec::new(), ..asked.clone() };
        for (angles, is_spinning) in self.frames.iter().zip(spins) {
            let name = |at: usize| format!("{}.{}", angles.frame, angles.names[at]);
            let is_euler = angles.names == EULER;
            let other = if is_euler { TAIT_BRYAN } else { EULER };
            let is_asked = |names: [&str; 3], primes: &str| {
                let all = names.map(|own| format!("{}.{own}{primes}", angles.frame));
                asked.ranges.iter().any(|(name, _)| all.contains(name))
            };
            if is_asked(other, "") || !is_euler && is_asked([EULER[1], EULER[2], EULER[2]], "'") {
                return false;
            }
            // the speed about the axis of the parent is the same
            let first = (format!("{}.{}'", angles.frame, other[0]), format!("{}'", name(0)));
            for (own, _) in &mut self.asked.ranges {
                if *own == first.0 {
                    own.clone_from(&first.1);
                }
            }
            let mut within = |at: usize, from: f64, to: f64| {
                if !self.asked.ranges.iter().any(|(own, _)| *own == name(at)) {
                    self.asked.ranges.push((name(at), Range { from, to }));
                }
            };
            match (is_euler, is_spinning) {
                (true, true) => within(1, LEAST_NUTATION, PI - LEAST_NUTATION),
                (true, false) => within(1, FRAC_PI_4 - OVERLAP, PI - FRAC_PI_4 + OVERLAP),
                (false, _) if is_asked(angles.names, "") => {}
                (false, _) => {
                    let most = if *is_spinning { 2.0 * LEAST_NUTATION } else { FRAC_PI_4 };
                    within(1, -most - LEAST_NUTATION, most + LEAST_NUTATION);
                    self.asked.steep.push(Steep { angles: [name(1), name(2)], least: most.cos() });
                }
            }
        }
        true
    }

    /// The angles in words.
    pub fn in_words(&self) -> Vec<String> {
        let axis = |at: usize| ["x", "y", "z"][at];
        let frames = self.frames.iter().map(|own| {
            let turns =
                own.axes.iter().zip(own.names).map(|(&at, name)| format!("{}.{name} about {}", own.frame, axis(at)));
            let steep =
                self.asked.steep.iter().find(|steep| steep.angles[0] == format!("{}.{}", own.frame, own.names[1]));
            let held = steep.map_or_else(String::new, |steep| {
                format!(
                    " and {}.{} at most {:.3} deg from that of its parent or from its opposite",
                    own.frame,
                    axis(own.axes[0]),
                    steep.least.acos().to_degrees()
                )
            });
            format!("{} turns by {}{held}", own.frame, turns.collect::<Vec<_>>().join(", "))
        });
        frames.collect()
    }
}

impl Orientation {
    /// The axis of the parent of the first frame about which its first angle turns, by the axes of the frame.
    pub fn vertical(&self, motion: &SteadyMotion) -> Vector3<f64> {
        let Some(angles) = self.frames.first() else { return Vector3::zeros() };
        let own = std::array::from_fn(|k| motion.state[angles.first + k]);
        angles.matrix(own).row(angles.axes[0]).transpose()
    }

    /// Coordinates, speeds and orientations of a motion, in numbers that do not depend on the set.
    fn seen(&self, found: &SteadyMotions, motion: &SteadyMotion) -> Vec<f64> {
        let n = motion.state.len() / 2;
        let plain = self.frames.first().map_or(n, |angles| angles.first);
        let of_frames = self.frames.iter().flat_map(|angles| angles.seen(motion, self.is_whole(angles, found)));
        motion.state[..plain].iter().chain(&motion.state[n..n + plain]).copied().chain(of_frames).collect()
    }
}

impl SteadyMotions {
    /// All by sets of angles, each with the cases of its conditions; a motion that two sets have is told in the first.
    ///
    /// # Errors
    /// Why none are sought.
    pub fn of_orientations(
        all: Vec<Orientation>,
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<Vec<(Orientation, Vec<(Vec<Case>, Self)>)>, NoSteadyMotions> {
        let (mut known, mut told): (Vec<Vec<f64>>, Vec<_>) = (Vec::new(), Vec::new());
        for own in all {
            let found = match changes(&own.model) {
                true => Self::of_cases(&own.model, &own.asked, &mut goes_on)?,
                false => vec![(Vec::new(), Self::of(&own.model, &own.asked, &mut goes_on)?)],
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
        Ok(told)
    }

    /// The motions of all sets of angles, by direction cosines in the place of angles.
    pub(super) fn united_orientations(all: Vec<(Orientation, Vec<(Vec<Case>, Self)>)>) -> Self {
        let by_cosines = |(own, cases): (Orientation, Vec<(Vec<Case>, Self)>)| {
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
    /// The unknowns of a search with direction cosines in the place of angles, by their places in what is seen of a motion.
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
                // no motion leaves it
                let range = Range { from: -2.0, to: 2.0 };
                all.push(Unknown { name, place, is_circle: false, range });
                place += 1;
            }
            // the angular velocity
            place += 3;
        }
        all
    }

    fn is_whole(&self, angles: &Angles, found: &SteadyMotions) -> bool {
        !found.cyclic.contains(&format!("{}.{}", angles.frame, angles.names[0]))
    }
}

/// The square of the product of the cosines of two angles less its least value, for each such pair.
pub(super) fn steep(trace: &Trace<'_>, names: &[String], asked: &Asked) -> Vec<Sym> {
    let pairs = asked.steep.iter().filter_map(|steep| {
        let cosine =
            |name: &String| names.iter().position(|own| own == name).map(|k| trace.coordinates[k].circle().cos);
        let product = cosine(&steep.angles[0])? * cosine(&steep.angles[1])?;
        Some(product * product - Sym::constant(field::Rational::exactly(steep.least * steep.least)))
    });
    pairs.collect()
}
