//! Prescribed motions as numbers at an instant, with two rates.

use super::NoForces;
use crate::compiled_system::values;
use crate::layout::Layout;
use crate::linearisation::Point;
use crate::motions::Motion;
use crate::program::recorded;
use derivations::taped::Program;
use model::{Model, ScalarId, Trace, turned_further};
use symbolic::substitute_all;

/// Prescribed coordinates and turns as functions of the time, with two rates.
pub(super) struct Prescribed {
    motions: Vec<Motion>,
    pub layout: Layout,
    /// Values, rates, second rates.
    program: Program,
}

impl Prescribed {
    /// # Errors
    /// Where a motion asks for something that moves.
    pub fn of(model: &Model, motions: &[Motion]) -> Result<Self, NoForces> {
        let mut wrong = None;
        let expressions = |motion: &Motion| match motion {
            Motion::Coordinate { is, .. } => vec![*is],
            Motion::Turns { turns, .. } => turns.iter().map(|(_, is)| *is).collect(),
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
            substitute_all(&[positions, speeds, accelerations].concat(), &values(&trace, time, &[]))
        });
        match (wrong, program) {
            (Some(place), _) => Err(NoForces::NotOfTime {
                coordinate: match motions[place] {
                    Motion::Coordinate { place, .. } => model.coordinates[place].name.clone(),
                    Motion::Turns { frame, .. } => model.frames[model.free[frame].0].name.clone(),
                },
            }),
            (None, Ok(program)) => Ok(Prescribed { motions: motions.to_vec(), layout: Layout::of(model), program }),
            (None, Err(why)) => Err(NoForces::NotCompiled(why)),
        }
    }

    /// Whether a speed is prescribed.
    pub fn has(&self, speed: usize) -> bool {
        self.motions.iter().any(|motion| match motion {
            Motion::Coordinate { place, .. } => *place == speed,
            Motion::Turns { frame, .. } => {
                let first = self.layout.turning().nth(*frame).map_or(usize::MAX, |(first, _)| first);
                (first..first.saturating_add(3)).contains(&speed)
            }
        })
    }

    /// Into the coordinates, speeds and accelerations of a point.
    pub fn put(&self, point: &mut Point) {
        let expressions = |motion: &Motion| match motion {
            Motion::Coordinate { .. } => 1,
            Motion::Turns { turns, .. } => turns.len(),
        };
        let count: usize = self.motions.iter().map(expressions).sum();
        let mut numbers = vec![f64::NAN; 3 * count];
        self.program.run(point.time, &[], &mut numbers);
        let mut rates = (0..count).map(|k| [numbers[k], numbers[count + k], numbers[2 * count + k]]);
        for motion in &self.motions {
            match motion {
                Motion::Coordinate { place, .. } => {
                    let [value, rate, second] = rates.next().unwrap_or([f64::NAN; 3]);
                    point.coordinates[*place] = value;
                    point.speeds[*place] = rate;
                    point.accelerations[*place] = second;
                }
                Motion::Turns { frame, turns } => {
                    let Some((speed, coordinate)) = self.layout.turning().nth(*frame) else { continue };
                    let turned = Turned::by(turns.iter().map(|(axis, _)| *axis).zip(rates.by_ref()));
                    point.coordinates.as_mut_slice()[coordinate..coordinate + 4].copy_from_slice(&turned.quaternion);
                    point.speeds.as_mut_slice()[speed..speed + 3].copy_from_slice(&turned.speeds);
                    point.accelerations.as_mut_slice()[speed..speed + 3].copy_from_slice(&turned.accelerations);
                }
            }
        }
    }
}

/// The motion of a frame by turns one after the other, in its own axes.
struct Turned {
    quaternion: [f64; 4],
    speeds: [f64; 3],
    accelerations: [f64; 3],
}

impl Turned {
    /// Each turn about an axis e by an angle with two rates:
    ///
    ///   w = R^T w + e theta',    w' = R^T w' - e theta' x R^T w + e theta''
    fn by(turns: impl Iterator<Item = (usize, [f64; 3])>) -> Self {
        let mut turned = Turned { quaternion: [1.0, 0.0, 0.0, 0.0], speeds: [0.0; 3], accelerations: [0.0; 3] };
        for (axis, [angle, rate, second]) in turns {
            let mut along = [0.0; 3];
            along[axis] = angle;
            turned.quaternion = turned_further(turned.quaternion, along);
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let (sin, cos) = angle.sin_cos();
            let back = |vector: [f64; 3]| {
                let mut seen = vector;
                seen[next] = cos * vector[next] + sin * vector[last];
                seen[last] = cos * vector[last] - sin * vector[next];
                seen
            };
            (turned.speeds, turned.accelerations) = (back(turned.speeds), back(turned.accelerations));
            turned.accelerations[next] += rate * turned.speeds[last];
            turned.accelerations[last] -= rate * turned.speeds[next];
            turned.accelerations[axis] += second;
            turned.speeds[axis] += rate;
        }
        turned
    }
}
