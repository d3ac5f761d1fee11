//! Check that loads between bodies are objective: a common displacement or velocity of all bodies does not change them.
//!
//! If the coordinates allow a common rigid motion of all bodies along an axis or about it, let d be its speeds. A load between two bodies
//! must not change if d is added to the speeds, or if positions and speeds are displaced along d.

use super::states::{Expressions, States};
use crate::layout::Layout;
use claims::finding::PropertyVerdict;
use model::{Force, FrameId, Material, Model, ScalarId, Torque, Trace, VectorId};
use nalgebra::{DMatrix, DVector};
use symbolic::{Sym, apart, substitute_all};

/// The number of states at which the loads are compared.
const STATES: usize = 12;

/// Largest residual, relative to the velocities, for which speeds count as a common rigid motion of all bodies.
const ALIKE: f64 = 1e-9;

/// The relative change above which a load counts as changed.
const CHANGES: f64 = 1e-6;

/// Displacement of positions, m or rad, for difference quotients.
const SMALL: f64 = 1e-5;

/// A load between two bodies, neither of which is the ground.
enum Load<'m> {
    Force(&'m [Material; 2], ScalarId),
    Torque(&'m [FrameId; 2], VectorId),
}

impl Load<'_> {
    /// All loads between two moving bodies: forces, then torques.
    fn all<'m>(trace: &Trace<'m>) -> Vec<Load<'m>> {
        let model: &'m Model = trace.model;
        let moves = |point: &Material| !trace.velocity(point.point).is_zero();
        let forces = model.forces.iter().filter_map(|force| match force {
            Force::Between { points, is } if points.iter().all(moves) => Some(Load::Force(points, *is)),
            _ => None,
        });
        let torques = model.torques.iter().filter_map(|torque| match torque {
            Torque::Between { frames, is } if !frames.contains(&FrameId::GROUND) => Some(Load::Torque(frames, *is)),
            _ => None,
        });
        forces.chain(torques).collect()
    }

    fn title(&self, model: &Model) -> String {
        match self {
            Load::Force([first, second], _) => {
                let name = |material: &Material| match material.body {
                    Some(body) => format!("`{}`", model.bodies[body.0].name),
                    None => format!("the point `{}`", model.points[material.point.0].name),
                };
                format!("the force between {} and {}", name(first), name(second))
            }
            Load::Torque([first, second], _) => {
                let name = |frame: &FrameId| model.frames[frame.0].name.as_str();
                format!("the torque between `{}` and `{}`", name(first), name(second))
            }
        }
    }
}

/// The compiled expressions of the check: positions of the centres of mass, derivatives of velocities by speeds, loads; all in axes of
/// the ground.
struct Compared {
    expressions: Expressions,
    layout: Layout,
    /// Number of velocities: of centres of mass, then angular velocities; each has three components.
    rows: usize,
    centres: usize,
    speeds: usize,
    forces: usize,
}

/// The verdict for all loads between bodies, at [`STATES`] states and for six rigid motions.
pub(super) fn verdict(model: &Model) -> PropertyVerdict {
    apart(|| {
        let trace = Trace::of(model);
        let loads = Load::all(&trace);
        if loads.is_empty() {
            return PropertyVerdict::DoesNotApply("no load acts between two bodies other than the ground".to_owned());
        }
        let Some(compared) = Compared::of(&trace, &loads) else {
            return PropertyVerdict::Undecided("the loads have no values".to_owned());
        };
        let mut states = States::about_start(&trace);
        let (mut moved, mut found) = (false, None);
        for _ in 0..STATES {
            let (time, state) = states.next(0.3);
            for motion in 0..6 {
                let Some(changed) = compared.changed(time, &state, motion) else { continue };
                moved = true;
                found = found.or(changed);
            }
        }
        match found {
            _ if !moved => {
                PropertyVerdict::DoesNotApply("its bodies cannot move along together: the ground holds them".to_owned())
            }
            None => PropertyVerdict::Tested(
                "moved along together, in place or in speed, its bodies exert the same loads on each other".to_owned(),
            ),
            Some((load, what)) => PropertyVerdict::Fails(format!(
                "{} changes if all bodies move together: it depends on {what} relative to the ground",
                loads[load].title(model)
            )),
        }
    })
}

impl Compared {
    fn of(trace: &Trace<'_>, loads: &[Load<'_>]) -> Option<Self> {
        let (model, n) = (trace.model, trace.speeds.len());
        let ground = |vector: model::Vector| trace.express(vector, FrameId::GROUND);
        let centres: Vec<_> =
            model.bodies.iter().filter(|body| body.mass.is_some()).filter_map(|body| body.centre).collect();
        let frames: Vec<_> =
            model.bodies.iter().filter(|body| body.inertia.is_some()).filter_map(|body| body.frame).collect();
        let places = centres.iter().flat_map(|&centre| ground(trace.position(centre)));
        let linear = centres.iter().map(|&centre| trace.velocity(centre));
        let turning = frames.iter().map(|&frame| trace.turning(frame));
        let slopes = linear.chain(turning).flat_map(|vector| {
            (0..n).flat_map(|speed| ground(trace.vector_by_speed(vector, speed))).collect::<Vec<Sym>>()
        });
        let forces: Vec<Sym> = (loads.iter())
            .filter_map(|load| match load {
                Load::Force(_, is) => Some(trace.scalar(*is)),
                Load::Torque(..) => None,
            })
            .collect();
        let torques = loads.iter().filter_map(|load| match load {
            Load::Torque(_, is) => Some(ground(trace.vector(*is))),
            Load::Force(..) => None,
        });
        let all: Vec<Sym> = places.chain(slopes).chain(forces.iter().copied()).chain(torques.flatten()).collect();
        let (rows, centres, count) = (centres.len() + frames.len(), centres.len(), forces.len());
        let expressions = Expressions::of(trace, &substitute_all(&all, &trace.solid()))?;
        Some(Compared { expressions, layout: Layout::of(model), rows, centres, speeds: n, forces: count })
    }

    /// The speeds of a common rigid motion of all bodies with unit velocity: translation along axis `motion` for `motion` < 3, else
    /// rotation about axis `motion - 3` through the origin. `None` if the coordinates do not allow such a motion.
    fn together(&self, values: &[f64], motion: usize) -> Option<DVector<f64>> {
        let (place, slopes) = values.split_at(3 * self.centres);
        let n = self.speeds;
        let mut axis = [0.0; 3];
        axis[motion % 3] = 1.0;
        let wanted = |row: usize| -> [f64; 3] {
            match (row < self.centres, motion < 3) {
                (true, true) => axis,
                (true, false) => {
                    let [x, y, z] = [place[3 * row], place[3 * row + 1], place[3 * row + 2]];
                    [axis[1] * z - axis[2] * y, axis[2] * x - axis[0] * z, axis[0] * y - axis[1] * x]
                }
                (false, true) => [0.0; 3],
                (false, false) => axis,
            }
        };
        let right = DVector::from_iterator(3 * self.rows, (0..self.rows).flat_map(wanted));
        let matrix = DMatrix::from_fn(3 * self.rows, n, |row, speed| slopes[(row / 3 * n + speed) * 3 + row % 3]);
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let solved = matrix.clone().svd(true, true).solve(&right, 1e-12).ok()?;
        let left = (&matrix * &solved - &right).amax();
        (left <= ALIKE * right.amax().max(1.0) && solved.amax() > 0.0).then_some(solved)
    }

    fn loads<'v>(&self, values: &'v [f64]) -> &'v [f64] {
        &values[3 * self.centres + 3 * self.rows * self.speeds..]
    }

    /// The first load that a common rigid motion changes, and whether it depends on a velocity or on a place. The outer `None`: the
    /// bodies have no such motion.
    #[allow(clippy::type_complexity)]
    fn changed(&self, time: f64, state: &[f64], motion: usize) -> Option<Option<(usize, &'static str)>> {
        let here = self.expressions.at(time, state);
        let along = self.together(&here, motion)?;
        let displaced = |state: &[f64], order: usize, by: f64, along: &DVector<f64>| {
            let mut moved = state.to_vec();
            for speed in 0..self.speeds {
                self.layout.displace(&mut moved, (speed, order), by * along[speed]);
            }
            moved
        };
        let faster = self.expressions.at(time, &displaced(state, 1, 1.0, &along));
        if let Some(load) = self.differs(self.loads(&here), self.loads(&faster), 1.0, [0.0; 3]) {
            return Some(Some((load, "a velocity")));
        }
        // the rate of d along the state's own motion, by a difference quotient
        let speeds = DVector::from_fn(self.speeds, |speed, _| state[self.layout.positions() + speed]);
        let step = SMALL / (1.0 + speeds.amax());
        let on = displaced(state, 0, step, &speeds);
        let later = self.together(&self.expressions.at(time, &on), motion)?;
        let rates = (later - &along) / step;
        let at = |by: f64| displaced(&displaced(state, 0, by, &along), 1, by, &rates);
        let (ahead, behind) = (self.expressions.at(time, &at(SMALL)), self.expressions.at(time, &at(-SMALL)));
        let mut turned = [0.0; 3];
        if motion >= 3 {
            turned[motion - 3] = 1.0;
        }
        let found = self.differs(self.loads(&behind), self.loads(&ahead), 2.0 * SMALL, turned);
        Some(found.map(|load| (load, "a place")))
    }

    /// The first load that differs between two states whose distance is `way`. `turned` is the rotation of the bodies: torques are
    /// vectors that turn with them.
    fn differs(&self, one: &[f64], other: &[f64], way: f64, turned: [f64; 3]) -> Option<usize> {
        let tolerance = |size: f64| CHANGES.max(SMALL * f64::from(u8::from(way < 1.0))) * (size + f64::MIN_POSITIVE);
        let forces = (0..self.forces).find(|&load| {
            let change = (other[load] - one[load]).abs() / way;
            !change.is_nan() && change > tolerance(one[load].abs() + other[load].abs())
        });
        let torques = || {
            let vectors = one[self.forces..].chunks_exact(3).zip(other[self.forces..].chunks_exact(3));
            let found = vectors.enumerate().find(|(_, (one, other))| {
                let size: f64 = one.iter().chain(*other).map(|part| part.abs()).sum();
                (0..3).any(|axis| {
                    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                    let by_turn = turned[next] * one[last] - turned[last] * one[next];
                    let change = ((other[axis] - one[axis]) / way - by_turn).abs();
                    !change.is_nan() && change > tolerance(size) * if way < 1.0 { 10.0 } else { 1.0 }
                })
            });
            found.map(|(place, _)| self.forces + place)
        };
        forces.or_else(torques)
    }
}
