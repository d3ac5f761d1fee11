//! Energies, powers and momenta of a system, computed only from difference quotients of positions: independent of the velocities and
//! derivatives of the model.

use super::numbers::{cross, dot, quadratic_slope, slope, slopes, unit};
use super::system::{Numbers, State, System};
use dalembert_model::{Body, Force, Inertia, Material, Torque, Trace};
use symbolic::Sym;

/// Positions and axes with their rates, in components along the ground's axes.
struct Kinematics {
    places: Vec<f64>,
    rates: Vec<f64>,
    points: usize,
}

impl Kinematics {
    /// Returns the kinematics at a state whose speeds are replaced by `u`.
    fn of(system: &System<'_, '_>, state: &State, u: &[f64]) -> Self {
        let start = State { u: u.to_vec(), ..state.clone() };
        let places = |at: &State| system.at(&system.places, at, &[]);
        let rates = slopes(|length| places(&system.moved(&start, &vec![0.0; u.len()], length)));
        Kinematics { places: places(&start), rates, points: system.model().points.len() }
    }

    fn place(&self, point: usize) -> &[f64] {
        &self.places[3 * point..3 * point + 3]
    }

    fn velocity(&self, point: usize) -> &[f64] {
        &self.rates[3 * point..3 * point + 3]
    }

    fn axis(&self, frame: usize, axis: usize) -> &[f64] {
        let first = 3 * (self.points + 3 * frame + axis);
        &self.places[first..first + 3]
    }

    /// Returns the angular velocity w = sum e x e' / 2 over the three axes of a frame.
    fn turning(&self, frame: usize) -> Vec<f64> {
        let first = 3 * (self.points + 3 * frame);
        let axes = (first..first + 9).step_by(3);
        axes.fold(vec![0.0; 3], |sum, at| {
            let turned = cross(&self.places[at..at + 3], &self.rates[at..at + 3]);
            sum.iter().zip(turned).map(|(sum, part)| sum + part / 2.0).collect()
        })
    }

    /// Returns the velocity of the point as a point of the body: v_centre + w x r.
    fn material(&self, trace: &Trace<'_>, at: Material) -> Vec<f64> {
        let body = at.body.map(|body| &trace.model.bodies[body.0]);
        let Some(Body { frame: Some(frame), centre: Some(centre), .. }) = body else {
            return self.velocity(at.point.0).to_vec();
        };
        let arm: Vec<f64> = self.place(at.point.0).iter().zip(self.place(centre.0)).map(|(p, c)| p - c).collect();
        let carried = cross(&self.turning(frame.0), &arm);
        self.velocity(centre.0).iter().zip(carried).map(|(own, carried)| own + carried).collect()
    }
}

/// Energies, powers, momenta and inertial forces of a system.
pub struct Mechanics<'s, 't, 'm> {
    pub system: &'s System<'t, 'm>,
    /// Mass and six moments of inertia of each body.
    masses: Numbers,
    energies: Numbers,
    loads: Numbers,
}

impl<'s, 't, 'm> Mechanics<'s, 't, 'm> {
    pub fn of(system: &'s System<'t, 'm>) -> Self {
        let (trace, model) = (system.trace, system.model());
        let scalar = |id: Option<dalembert_model::ScalarId>| id.map_or(Sym::ZERO, |id| trace.scalar(id));
        let masses = model.bodies.iter().flat_map(|body| {
            let moments = match &body.inertia {
                None => [None; 6],
                Some(Inertia::Axial(moment)) => [None, None, Some(*moment), None, None, None],
                Some(Inertia::OfShaft { moment, axis }) => {
                    std::array::from_fn(|entry| (entry == *axis).then_some(*moment))
                }
                Some(Inertia::Tensor { entries, .. }) => *entries,
            };
            [scalar(body.mass)].into_iter().chain(moments.map(scalar)).collect::<Vec<_>>()
        });
        let masses = system.numbers(&masses.collect::<Vec<_>>());
        let given = &model.energies;
        let energies = system.numbers(&[given.kinetic, given.potential, given.dissipation].map(scalar));
        let ground = |id: dalembert_model::VectorId| trace.express(trace.vector(id), dalembert_model::FrameId::GROUND);
        let forces = model.forces.iter().flat_map(|force| match force {
            Force::On { is, .. } => ground(*is),
            Force::Between { is, .. } => [scalar(Some(*is)), Sym::ZERO, Sym::ZERO],
        });
        let torques = model.torques.iter().flat_map(|torque| match torque {
            Torque::On { is, .. } | Torque::Between { is, .. } => ground(*is),
        });
        let gravity = model.gravity.map_or([Sym::ZERO; 3], ground);
        let along = model.generalised.iter().map(|force| trace.scalar(force.is));
        let loads = system.numbers(&forces.chain(torques).chain(gravity).chain(along).collect::<Vec<_>>());
        Mechanics { system, masses, energies, loads }
    }

    /// Returns T at a state with the speeds `u`; masses are evaluated at the state `masses`.
    pub fn kinetic(&self, state: &State, u: &[f64], masses: &State) -> f64 {
        let start = State { u: u.to_vec(), ..state.clone() };
        let given = self.system.at(&self.energies, &start, &[])[0];
        let moving = Kinematics::of(self.system, state, u);
        self.momenta(&moving, masses).iter().fold(given, |sum, (body, linear, angular)| {
            let body = &self.system.model().bodies[*body];
            let carried = body.centre.map_or(0.0, |centre| dot(linear, moving.velocity(centre.0)));
            let turned = body.frame.map_or(0.0, |frame| dot(angular, &moving.turning(frame.0)));
            sum + (carried + turned) / 2.0
        })
    }

    /// Returns the index, linear momentum and angular momentum of every body.
    fn momenta(&self, moving: &Kinematics, masses: &State) -> Vec<(usize, Vec<f64>, Vec<f64>)> {
        let values = self.system.at(&self.masses, masses, &[]);
        let bodies = self.system.model().bodies.iter().zip(values.chunks(7)).enumerate();
        let of = |(place, (body, values)): (usize, (&Body, &[f64]))| {
            let linear = body.centre.map(|centre| moving.velocity(centre.0).iter().map(|v| values[0] * v).collect());
            let angular = body.frame.filter(|_| body.inertia.is_some()).map(|frame| {
                let axes = match &body.inertia {
                    Some(Inertia::Tensor { axes, .. }) => axes.0,
                    _ => frame.0,
                };
                let [xx, yy, zz, xy, xz, yz] = std::array::from_fn(|k| values[k + 1]);
                let turning = moving.turning(frame.0);
                let w: Vec<f64> = (0..3).map(|axis| dot(&turning, moving.axis(axes, axis))).collect();
                let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
                (0..3).fold(vec![0.0; 3], |sum: Vec<f64>, axis| {
                    let along = dot(&rows[axis], &w);
                    sum.iter().zip(moving.axis(axes, axis)).map(|(sum, e)| sum + along * e).collect()
                })
            });
            (place, linear.unwrap_or(vec![0.0; 3]), angular.unwrap_or(vec![0.0; 3]))
        };
        bodies.map(of).collect()
    }

    /// Returns V at a state; masses are evaluated at the state `masses`.
    pub fn potential(&self, state: &State, masses: &State) -> f64 {
        let given = self.system.at(&self.energies, state, &[])[1];
        let Some(gravity) = self.gravity(state).filter(|_| self.system.trace.uniform_gravity().is_some()) else {
            return given;
        };
        let places = self.system.at(&self.system.places, state, &[]);
        let masses = self.system.at(&self.masses, masses, &[]);
        let bodies = self.system.model().bodies.iter().zip(masses.chunks(7));
        bodies.fold(given, |sum, (body, values)| match (body.centre, body.mass) {
            (Some(centre), Some(_)) => sum - values[0] * dot(&gravity, &places[3 * centre.0..3 * centre.0 + 3]),
            _ => sum,
        })
    }

    fn gravity(&self, state: &State) -> Option<Vec<f64>> {
        self.system.model().gravity?;
        let first = 3 * (self.system.model().forces.len() + self.system.model().torques.len());
        Some(self.system.at(&self.loads, state, &[])[first..first + 3].to_vec())
    }

    /// Returns dT/du of the speed with index `i`; masses are evaluated at the state `masses`.
    pub fn momentum(&self, state: &State, i: usize, masses: &State) -> f64 {
        quadratic_slope(|length| {
            let mut u = state.u.clone();
            u[i] += length;
            self.kinetic(state, &u, masses)
        })
    }

    /// Returns T + V if `is_whole`, else sum u dT/du - T + V; masses are evaluated at the state `masses`.
    pub fn energy(&self, is_whole: bool, state: &State, masses: &State) -> f64 {
        let kinetic = self.kinetic(state, &state.u, masses);
        let potential = self.potential(state, masses);
        if is_whole {
            return kinetic + potential;
        }
        let scaled = |length: f64| state.u.iter().map(|u| (1.0 + length) * u).collect::<Vec<f64>>();
        quadratic_slope(|length| self.kinetic(state, &scaled(length), masses)) - kinetic + potential
    }

    /// Returns the power of all loads without a potential: loads at the state, velocities of their points for the speeds `u`.
    pub fn power(&self, state: &State, u: &[f64], solved: &[f64]) -> f64 {
        let (trace, model) = (self.system.trace, self.system.model());
        let moving = Kinematics::of(self.system, state, u);
        let loads = self.system.at(&self.loads, state, solved);
        let mut power = 0.0;
        for (force, load) in model.forces.iter().zip(loads.chunks(3)) {
            power += match force {
                Force::On { at, .. } => dot(load, &moving.material(trace, *at)),
                Force::Between { points: [first, second], .. } => {
                    let line: Vec<f64> =
                        (0..3).map(|k| moving.place(second.point.0)[k] - moving.place(first.point.0)[k]).collect();
                    let (one, other) = (moving.material(trace, *first), moving.material(trace, *second));
                    load[0] * (dot(&line, &other) - dot(&line, &one)) / dot(&line, &line).sqrt()
                }
            };
        }
        let first = 3 * model.forces.len();
        for (torque, load) in model.torques.iter().zip(loads[first..].chunks(3)) {
            power += match torque {
                Torque::On { frame, .. } => dot(load, &moving.turning(frame.0)),
                Torque::Between { frames: [one, other], .. } => {
                    dot(load, &moving.turning(other.0)) - dot(load, &moving.turning(one.0))
                }
            };
        }
        if let Some(gravity) = self.gravity(state).filter(|_| trace.uniform_gravity().is_none()) {
            let masses = self.system.at(&self.masses, state, &[]);
            for (body, values) in model.bodies.iter().zip(masses.chunks(7)) {
                power += body.centre.map_or(0.0, |centre| values[0] * dot(&gravity, moving.velocity(centre.0)));
            }
        }
        let first = first + 3 * model.torques.len() + 3;
        for (force, load) in model.generalised.iter().zip(&loads[first..]) {
            let dalembert_model::Along::Speed(speed) = force.along else {
                panic!("these systems have no quasi-velocities")
            };
            power += load * u[speed];
        }
        let resisted = |length: f64| {
            let speeds = state.u.iter().zip(u).map(|(own, u)| own + length * u).collect();
            self.system.at(&self.energies, &State { u: speeds, ..state.clone() }, &[])[2]
        };
        power - slope(resisted)
    }

    /// Returns for each speed the inertial forces, and these minus all applied forces, projected on the partial velocities of the speed.
    pub fn inertia_less_forces(&self, state: &State, solved: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = state.u.len();
        let momenta = |at: &State| -> Vec<f64> {
            let all = self.momenta(&Kinematics::of(self.system, at, &at.u), state);
            all.into_iter().flat_map(|(_, linear, angular)| [linear, angular].concat()).collect()
        };
        let rates = slopes(|length| momenta(&self.system.later(state, length)));
        let at_rest = Kinematics::of(self.system, state, &vec![0.0; n]);
        let still = self.power(state, &vec![0.0; n], solved);
        let of = |i: usize| {
            let moving = Kinematics::of(self.system, state, &unit(n, i));
            let bodies = self.system.model().bodies.iter().zip(rates.chunks(6));
            let inertia: f64 = bodies
                .map(|(body, rates)| {
                    let along = |one: &[f64], other: &[f64], rates: &[f64]| dot(one, rates) - dot(other, rates);
                    let carried = body.centre.map_or(0.0, |centre| {
                        along(moving.velocity(centre.0), at_rest.velocity(centre.0), &rates[..3])
                    });
                    let turned = body
                        .frame
                        .map_or(0.0, |frame| along(&moving.turning(frame.0), &at_rest.turning(frame.0), &rates[3..]));
                    carried + turned
                })
                .sum();
            let falls = slope(|length| self.potential(&self.system.displaced(state, &unit(n, i), length), state));
            (inertia, inertia + falls - (self.power(state, &unit(n, i), solved) - still))
        };
        (0..n).map(of).unzip()
    }

    /// Returns whether some body moves although all speeds are zero.
    pub fn is_carried(&self, state: &State) -> bool {
        self.kinetic(state, &vec![0.0; state.u.len()], state).abs() > 1e-9
    }
}
