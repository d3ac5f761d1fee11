//! The linearisation at a steady motion, and the second variation of the energy, by differentiation.
//!
//! The state, in deviations from the steady motion, is w, v, the rotor's angle and speed if they are states of the
//! machine, and the currents. With x = dT/dw and p' = dT/dphi' the law is
//!
//!   x' + w x x = Ge x v ,   v' = v x w ,   p'' = M ,   and the windings' own ;
//!
//! It conserves v.v and x.v, and p' if no torque acts. The energy in the frame of the rotating field, E - W p' (with
//! the work of the constant load), never increases, unless a supply or sliding conductors change it. With the
//! multipliers w0 and lambda it has a critical point at the motion:
//!
//!   G = E - W p' - w0 x.v + 1/2 lambda v.v ,    lambda = w0 x.v + Ge.v .

use super::state::{Layout, State, StationaryState, twice_moved};
use crate::stationary::energies::Energies;
use field::{Base, Over, Scalar, Tangent};
use mechanics::momentum::absolute_rate;
use motor::{Machine, stored_energy, torque_and_current_rates};
use nalgebra::Vector3;

/// The matrices at a steady motion.
#[derive(Clone, Debug)]
pub struct Linear<S> {
    /// A of y' = A y.
    pub rates: Vec<Vec<S>>,
    /// The second derivatives of G.
    pub energy: Vec<Vec<S>>,
    /// The residuals of the law, which are zero at a steady motion.
    pub missing: Vec<S>,
    /// The differentials of the integrals, in the order of [`Integral`].
    pub integrals: Vec<Vec<S>>,
    /// x, N m s, and its differential, component by component.
    pub momentum: Vec<S>,
    pub turning: Vec<Vec<S>>,
    /// The coefficients of the dissipation: -dm/dg' (N m s) of the slip, and R (ohm) of each current.
    pub damping: Vec<S>,
}

/// The integrals of every motion, each with a zero eigenvalue of the linearisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integral {
    /// |v| = 1.
    Vertical,
    /// x.v, the angular momentum about the vertical.
    Momentum,
    /// The rotor's own angular momentum, if no torque acts on it.
    RotorMomentum,
    /// The angular momentum about an axis of symmetry.
    Axis,
    /// |x|^2 of a gyrostat without weight, if it is independent of the others.
    Size,
}

impl<P: Base> Energies<P> {
    /// (x, p'): the angular momentum about O and that of the rotor about its axis.
    pub fn momenta<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> (Vector3<S>, S) {
        let mixed = self.mixed.map(S::lift);
        let all = self.tensor.map(S::lift) * w + mixed * rotor_speed;
        (all, mixed.dot(&w) + S::lift(self.axial) * rotor_speed)
    }
}

/// The residuals of the equations of motion for given rates.
pub fn missing<P: Base, S: Over<P>, M: Machine<P>>(
    energies: &Energies<P>,
    machine: &M,
    state: &State<S>,
    rates: &[S],
) -> Vec<S> {
    let layout = Layout::of(machine);
    let rate = |place: Option<usize>| place.map_or(S::zero(), |place| rates[place]);
    let vector = |from: usize| Vector3::from_fn(|i, _| rates[from + i]);
    let moving = state.w.zip_map(&vector(0), Tangent::moving);
    let (all, spin) = energies.momenta(moving, Tangent::moving(state.rotor_speed, rate(layout.slip())));
    let carrier = absolute_rate(all, state.w) - energies.weight.map(S::lift).cross(&state.v);
    let vertical = vector(3) + state.w.cross(&state.v);
    let mut missing: Vec<S> = carrier.iter().chain(vertical.iter()).copied().collect();
    if let Some(angle) = layout.angle() {
        missing.push(rates[angle] - state.slip);
    }
    if layout.slip().is_some() {
        let mut currents = vec![S::zero(); layout.windings];
        let torque = torque_and_current_rates(machine, state.angle, state.slip, &state.currents, &mut currents);
        missing.push(spin.slope - torque);
        let own = &rates[layout.size() - layout.windings..];
        missing.extend(own.iter().zip(currents).map(|(rate, law)| *rate - law));
    }
    missing
}

/// The first variation of the residuals, for deviations from a steady motion and their rates.
pub fn variation<P: Base, S: Over<P>, M: Machine<P>>(
    energies: &Energies<P>,
    machine: &M,
    place: &StationaryState<S>,
    deviations: &[S],
    rates: &[S],
) -> Vec<S> {
    let rates: Vec<Tangent<S>> = rates.iter().map(|&slope| Tangent::moving(S::zero(), slope)).collect();
    let state = place.state(machine, deviations);
    missing(energies, machine, &state, &rates).into_iter().map(|one| one.slope).collect()
}

/// The function G = E - W p' - w0 x.v + 1/2 lambda v.v, J.
fn energy<P: Base, S: Over<P>, M: Machine<P>>(
    energies: &Energies<P>,
    machine: &M,
    place: &StationaryState<S>,
    multiplier: S,
    state: &State<S>,
) -> S {
    let (all, spin) = energies.momenta(state.w, state.rotor_speed);
    let kinetic = (all.dot(&state.w) + spin * state.rotor_speed).half();
    let weight = energies.weight.map(S::lift).dot(&state.v);
    kinetic - weight + stored_energy(machine, state.angle, &state.currents)
        - place.rotor_speed * spin
        - place.speed * all.dot(&state.v)
        + (multiplier * state.v.dot(&state.v)).half()
}

impl<S: Scalar> Linear<S> {
    /// The linearisation at a steady motion. `free`: no torque ever acts on the rotor.
    pub fn at<P: Base, M: Machine<P>>(
        energies: &Energies<P>,
        machine: &M,
        place: &StationaryState<S>,
        free: bool,
    ) -> Self
    where
        S: Over<P>,
    {
        let layout = Layout::of(machine);
        let size = layout.size();
        let unit = |j: usize| -> Vec<S> { (0..size).map(|i| if i == j { S::one() } else { S::zero() }).collect() };
        let rest = vec![S::zero(); size];
        // variation = mass * rates - force * deviations
        let of_rates = |j: usize| variation(energies, machine, place, &rest, &unit(j));
        let of_state = |j: usize| variation(energies, machine, place, &unit(j), &rest);
        let mass = transposed((0..size).map(of_rates).collect());
        let force = transposed((0..size).map(|j| of_state(j).into_iter().map(|slope| -slope).collect()).collect());
        let still: Vec<Tangent<S>> = rest.iter().map(|&zero| Tangent::fixed(zero)).collect();
        let missing = missing(energies, machine, &place.state(machine, &rest), &still);
        let (all, _) = energies.momenta(place.vertical * place.speed, place.rotor_speed);
        let multiplier = place.speed * all.dot(&place.vertical) + energies.weight.map(S::lift).dot(&place.vertical);
        let second = |i: usize, j: usize| {
            let twice = twice_moved(&place.state(machine, &unit(i)), &place.fixed(), machine, &unit(j));
            let (place, multiplier) = (place.fixed().fixed(), Tangent::fixed(Tangent::fixed(multiplier)));
            energy(energies, machine, &place, multiplier, &twice).slope.slope
        };
        let mut integrals = vec![Vec::new(); if free { 3 } else { 2 }];
        let mut turning = vec![Vec::new(); 3];
        for j in 0..size {
            let state = place.state(machine, &unit(j));
            let (all, spin) = energies.momenta(state.w, state.rotor_speed);
            let values = [state.v.dot(&state.v).half(), all.dot(&state.v), spin];
            integrals.iter_mut().zip(values).for_each(|(integral, value)| integral.push(value.slope));
            turning.iter_mut().zip(all.iter()).for_each(|(row, component)| row.push(component.slope));
        }
        let slip =
            if layout.angle().is_some() { S::zero() } else { place.rotor_speed - S::lift(machine.frame_speed()) };
        let torque = machine.torque_law(Tangent::variable(slip), Tangent::variable(place.rotor_speed));
        let resistances = (0..layout.windings).map(|k| S::lift(machine.resistance(k)));
        let damping = layout.slip().map(|_| -torque.slope).into_iter().chain(resistances).collect();
        Linear {
            rates: resolved(mass, force),
            energy: (0..size).map(|i| (0..size).map(|j| second(i, j)).collect()).collect(),
            missing: missing.into_iter().map(|one| one.value).collect(),
            integrals,
            momentum: all.iter().copied().collect(),
            turning,
            damping,
        }
    }
}

fn transposed<S: Copy>(columns: Vec<Vec<S>>) -> Vec<Vec<S>> {
    (0..columns.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

/// The solution X of M X = F. The mass matrix is definite: no pivot vanishes.
fn resolved<S: Scalar>(mut mass: Vec<Vec<S>>, mut force: Vec<Vec<S>>) -> Vec<Vec<S>> {
    let size = mass.len();
    for k in 0..size {
        let (pivot, known) = (mass[k].clone(), force[k].clone());
        for i in (0..size).filter(|&i| i != k) {
            let factor = mass[i][k] / pivot[k];
            if factor.is_zero() {
                continue;
            }
            mass[i].iter_mut().zip(&pivot).for_each(|(a, &p)| *a -= factor * p);
            force[i].iter_mut().zip(&known).for_each(|(a, &p)| *a -= factor * p);
        }
    }
    force.iter().zip(&mass).enumerate().map(|(k, (row, own))| row.iter().map(|&x| x / own[k]).collect()).collect()
}
