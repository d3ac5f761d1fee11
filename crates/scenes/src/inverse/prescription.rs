//! Values of prescribed motions at an instant, with three derivatives by time.

use super::NoForces;
use crate::compiled_system::values;
use crate::layout::Layout;
use crate::linearisation::Point;
use crate::motions::PrescribedMotion;
use crate::program::recorded;
use field::{Analytic, Circle};
use model::{Model, ScalarId, Trace, turned_further};
use nalgebra::DVector;
use simulation::Program;
use symbolic::substitute_all;

/// Prescribed coordinates and orientations as functions of time, with three derivatives.
pub(super) struct Prescribed {
    motions: Vec<PrescribedMotion>,
    pub layout: Layout,
    /// Indices of the outputs whose zeros express prescribed speeds.
    pub speeds: Vec<usize>,
    /// The program for all values, then all first, second and third derivatives.
    program: Program,
}

impl Prescribed {
    /// Compiles the prescribed motions.
    ///
    /// # Errors
    /// [`NoForces::NotOfTime`] if a motion depends on the state; [`NoForces::NotCompiled`] if it has no value.
    pub fn of(model: &Model, motions: &[PrescribedMotion]) -> Result<Self, NoForces> {
        let mut wrong = None;
        let expressions = |motion: &PrescribedMotion| match motion {
            PrescribedMotion::Coordinate { is, .. } => vec![*is],
            PrescribedMotion::Turns { turns, .. } => turns.iter().map(|(_, is)| *is).collect(),
            PrescribedMotion::Speed { .. } => Vec::new(),
        };
        let program = recorded(0, |time, _| {
            let trace = Trace::of(model);
            let moving = [&trace.coordinates, &trace.speeds, &trace.accelerations];
            let moves = |is: &ScalarId| {
                let symbols = trace.scalar(*is).symbols_of();
                symbols.iter().any(|symbol| moving.iter().any(|letters| letters.contains(symbol)))
            };
            wrong = motions.iter().position(|motion| expressions(motion).iter().any(moves));
            if wrong.is_some() {
                return Vec::new();
            }
            let positions: Vec<_> = motions.iter().flat_map(expressions).map(|is| trace.scalar(is)).collect();
            let speeds: Vec<_> = positions.iter().map(|&position| trace.rate_of(position)).collect();
            let accelerations: Vec<_> = speeds.iter().map(|&speed| trace.rate_of(speed)).collect();
            let third: Vec<_> = accelerations.iter().map(|&acceleration| trace.rate_of(acceleration)).collect();
            substitute_all(&[positions, speeds, accelerations, third].concat(), &values(&trace, time, &[]))
        });
        let speeds = motions.iter().filter_map(|motion| match motion {
            PrescribedMotion::Speed { output } => Some(*output),
            PrescribedMotion::Coordinate { .. } | PrescribedMotion::Turns { .. } => None,
        });
        let (layout, speeds) = (Layout::of(model), speeds.collect());
        match (wrong, program) {
            (Some(place), _) => Err(NoForces::NotOfTime {
                coordinate: match motions[place] {
                    PrescribedMotion::Coordinate { place, .. } => model.coordinates[place].name.clone(),
                    PrescribedMotion::Turns { frame, .. } => model.frames[model.free[frame].0].name.clone(),
                    PrescribedMotion::Speed { output } => model.outputs[output].name.clone(),
                },
            }),
            (None, Ok(program)) => Ok(Prescribed { motions: motions.to_vec(), layout, speeds, program }),
            (None, Err(why)) => Err(NoForces::NotCompiled(why)),
        }
    }

    /// True if the motion of this speed's coordinate is prescribed.
    pub fn has(&self, speed: usize) -> bool {
        self.motions.iter().any(|motion| match motion {
            PrescribedMotion::Coordinate { place, .. } => *place == speed,
            PrescribedMotion::Turns { frame, .. } => {
                let first = self.layout.turning().nth(*frame).map_or(usize::MAX, |(first, _)| first);
                (first..first.saturating_add(3)).contains(&speed)
            }
            PrescribedMotion::Speed { .. } => false,
        })
    }

    /// Writes the prescribed coordinates, speeds and accelerations at the time of `point` into the point. Returns the third derivatives
    /// of the coordinates, zero for those that are not prescribed.
    pub fn put(&self, point: &mut Point) -> DVector<f64> {
        let expressions = |motion: &PrescribedMotion| match motion {
            PrescribedMotion::Coordinate { .. } => 1,
            PrescribedMotion::Turns { turns, .. } => turns.len(),
            PrescribedMotion::Speed { .. } => 0,
        };
        let count: usize = self.motions.iter().map(expressions).sum();
        let mut numbers = vec![f64::NAN; 4 * count];
        self.program.run(point.time, &[], &mut numbers);
        let mut rates = (0..count).map(|k| std::array::from_fn(|order| numbers[order * count + k]));
        let mut third = DVector::zeros(point.speeds.len());
        for motion in &self.motions {
            match motion {
                PrescribedMotion::Coordinate { place, .. } => {
                    let own: [f64; 4] = rates.next().unwrap_or([f64::NAN; 4]);
                    point.coordinates[*place] = own[0];
                    point.speeds[*place] = own[1];
                    point.accelerations[*place] = own[2];
                    third[*place] = own[3];
                }
                PrescribedMotion::Speed { .. } => {}
                PrescribedMotion::Turns { frame, turns } => {
                    let Some((speed, coordinate)) = self.layout.turning().nth(*frame) else { continue };
                    let turned = Turned::by(turns.iter().map(|(axis, _)| *axis).zip(rates.by_ref()));
                    point.coordinates.as_mut_slice()[coordinate..coordinate + 4].copy_from_slice(&turned.quaternion);
                    point.speeds.as_mut_slice()[speed..speed + 3].copy_from_slice(&turned.speeds);
                    point.accelerations.as_mut_slice()[speed..speed + 3].copy_from_slice(&turned.accelerations);
                    third.as_mut_slice()[speed..speed + 3].copy_from_slice(&turned.third);
                }
            }
        }
        third
    }
}

/// The motion of a frame that is rotated by successive turns about its own axes.
struct Turned {
    /// The orientation as a unit quaternion, scalar part first.
    quaternion: [f64; 4],
    /// The angular velocity in the frame's own axes, rad/s, then its first and second derivative.
    speeds: [f64; 3],
    accelerations: [f64; 3],
    third: [f64; 3],
}

impl Turned {
    /// Composes turns, each about an axis e (given by its index) by an angle with three derivatives. A vector a of the frame before the
    /// turn has the components b = R^T a in the turned frame, with the rate
    ///
    ///   b' = R^T a' - e theta' x b ,
    ///
    /// and the angular velocity becomes R^T w + e theta'.
    fn by(turns: impl Iterator<Item = (usize, [f64; 4])>) -> Self {
        let mut turned =
            Turned { quaternion: [1.0, 0.0, 0.0, 0.0], speeds: [0.0; 3], accelerations: [0.0; 3], third: [0.0; 3] };
        for (axis, [angle, rate, second, third]) in turns {
            let mut along = [0.0; 3];
            along[axis] = angle;
            turned.quaternion = turned_further(turned.quaternion, along);
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let Circle { cos, sin } = angle.circle();
            let back = |vector: [f64; 3]| {
                let mut seen = vector;
                seen[next] = cos * vector[next] + sin * vector[last];
                seen[last] = cos * vector[last] - sin * vector[next];
                seen
            };
            // adds -e x `of` times `by`
            let carried = |vector: &mut [f64; 3], by: f64, of: [f64; 3]| {
                vector[next] += by * of[last];
                vector[last] -= by * of[next];
            };
            let (speeds, accelerations) = (back(turned.speeds), back(turned.accelerations));
            let mut first = accelerations;
            carried(&mut first, rate, speeds);
            // R^T w'' - e theta' x R^T w' - e theta'' x b - e theta' x b'
            let mut jerk = back(turned.third);
            carried(&mut jerk, rate, accelerations);
            carried(&mut jerk, second, speeds);
            carried(&mut jerk, rate, first);
            (turned.speeds, turned.accelerations, turned.third) = (speeds, first, jerk);
            turned.speeds[axis] += rate;
            turned.accelerations[axis] += second;
            turned.third[axis] += third;
        }
        turned
    }
}
