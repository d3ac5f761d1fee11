//! Steady motions of systems with frames that turn freely: by two sets of angles, each regular where the other is not.
//!
//! With the axis e of the parent about which the law asks for nothing, and the next ones a and b,
//!
//!   R = R_e R_a(nutation) R_e(spin) :     e . R e = cos nutation ,
//!   R = R_e R_a(pitch) R_b(roll) :        e . R e = cos pitch cos roll ,
//!
//! the first (Euler) is regular where e . R e is not one in size, the second (Tait, Bryan) where e . R e is not zero. A motion in which the
//! frame turns about e alone at a constant speed rests in both but for the first angle.

use super::quasi_velocities::without_part;
use super::{Asked, Case, NoSteadyMotions, Range, SteadyMotion, SteadyMotions};
use crate::branch::settled;
use crate::changing_laws::changes;
use crate::readiness::independent_start;
use model::{FrameAngles, Model, Source, StartValue};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_4, PI};

/// Names of the angles of both sets.
const EULER: [&str; 3] = ["precession", "nutation", "spin"];
const TAIT_BRYAN: [&str; 3] = ["yaw", "pitch", "roll"];

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

/// The angles of one frame.
#[derive(Clone, Debug)]
struct Angles {
    frame: String,
    /// Those of the parent and of the frames between.
    axes: [usize; 3],
    names: [&'static str; 3],
    /// The place of the first angle among the coordinates.
    first: usize,
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
            .map(|(at, (frame, (axes, names)))| Angles { frame: frame.clone(), axes, names, first: plain + 3 * at })
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

impl Angles {
    /// The angles and their rates at the start of a model in which the frame turns freely.
    fn start(&self, original: &Model, number: usize, is_spinning: bool) -> Vec<StartValue> {
        let state = original.start_state();
        let at = original.free_position(number);
        let quaternion = nalgebra::Quaternion::new(state[at], state[at + 1], state[at + 2], state[at + 3]);
        let matrix = *UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix().matrix();
        let angles = self.of(&matrix);
        let first = original.positions() + original.free_speed(number);
        let own = Vector3::new(state[first], state[first + 1], state[first + 2]);
        let turning = matrix * own;
        // at a pole the rates are those of a frame that rests
        let rates = match is_spinning {
            true => self.turns(angles).lu().solve(&turning).unwrap_or_default(),
            false => Vector3::new(turning[self.axes[0]], 0.0, 0.0),
        };
        let value = |order: usize, values: [f64; 3]| {
            values.into_iter().enumerate().map(move |(k, value)| StartValue {
                coordinate: self.first + k,
                order,
                value,
                is_guess: true,
            })
        };
        value(0, angles).chain(value(1, rates.into())).collect()
    }

    /// The angles of a rotation.
    fn of(&self, matrix: &Matrix3<f64>) -> [f64; 3] {
        let [e, a, last] = self.axes;
        let b = 3 - e - a;
        let entry = |row: usize, column: usize| matrix[(row, column)];
        match last == e {
            true => {
                [entry(a, e).atan2(-entry(b, e)), entry(e, e).clamp(-1.0, 1.0).acos(), entry(e, a).atan2(entry(e, b))]
            }
            false => [
                (-entry(a, b)).atan2(entry(b, b)),
                entry(e, b).clamp(-1.0, 1.0).asin(),
                (-entry(e, a)).atan2(entry(e, e)),
            ],
        }
    }

    fn turn(&self, place: usize, angle: f64) -> Matrix3<f64> {
        *Rotation3::from_axis_angle(&Vector3::ith_axis(self.axes[place]), angle).matrix()
    }

    /// The rotation.
    fn matrix(&self, angles: [f64; 3]) -> Matrix3<f64> {
        (0..3).fold(Matrix3::identity(), |own, place| own * self.turn(place, angles[place]))
    }

    /// The angular velocities of the three rates, along the axes of the parent.
    fn turns(&self, angles: [f64; 3]) -> Matrix3<f64> {
        let mut own = Matrix3::identity();
        let columns: Vec<Vector3<f64>> = (0..3)
            .map(|place| {
                let column = own * Vector3::ith(self.axes[place], 1.0);
                own *= self.turn(place, angles[place]);
                column
            })
            .collect();
        Matrix3::from_columns(&columns)
    }

    /// The axes of the parent by those of the frame, the first alone where the first angle is none of the motion's, and the angular velocity.
    fn seen(&self, motion: &SteadyMotion, is_whole: bool) -> Vec<f64> {
        let n = motion.state.len() / 2;
        let of = |from: usize| -> [f64; 3] { std::array::from_fn(|k| motion.state[from + self.first + k]) };
        let (angles, rates) = (of(0), Vector3::from(of(n)));
        let matrix = self.matrix(angles);
        let turning = matrix.transpose() * (self.turns(angles) * rates);
        let rows = (0..3).filter(|row| is_whole || *row == self.axes[0]);
        rows.flat_map(|row| matrix.row(row).iter().copied().collect::<Vec<_>>())
            .chain(turning.iter().copied())
            .collect()
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
        let of_frames = self.frames.iter().flat_map(|angles| {
            let first = format!("{}.{}", angles.frame, angles.names[0]);
            angles.seen(motion, !found.cyclic.contains(&first))
        });
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
}

#[cfg(test)]
mod tests {
    use super::*;

    /// R is put together again from its angles, and the rates give the angular velocity, for every first axis and both sets.
    #[test]
    fn angles_of_a_rotation_give_it_again() {
        let rotation = *Rotation3::from_euler_angles(0.3, -0.8, 1.9).matrix();
        for e in 0..3 {
            let (a, b) = ((e + 1) % 3, (e + 2) % 3);
            for (axes, names) in [([e, a, e], EULER), ([e, a, b], TAIT_BRYAN)] {
                let own = Angles { frame: "F".to_owned(), axes, names, first: 0 };
                let angles = own.of(&rotation);
                assert!((own.matrix(angles) - rotation).amax() < 1e-14, "{axes:?}");
                let by = |h: f64| own.matrix([angles[0] + 0.3 * h, angles[1] - 0.2 * h, angles[2] + 0.7 * h]);
                let rate = (by(1e-6) - by(-1e-6)) / 2e-6 * rotation.transpose();
                let w = own.turns(angles) * Vector3::new(0.3, -0.2, 0.7);
                assert!((rate - w.cross_matrix()).amax() < 1e-9, "{axes:?}");
            }
        }
    }
}
