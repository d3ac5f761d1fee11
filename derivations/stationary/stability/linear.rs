//! The first approximation at a stationary motion, and the energy that judges it, by differentiation.
//!
//! The state, in deviations from the stationary motion: w, v, the rotor's angle and speed as far as the machine knows them,
//! the currents. With x = dT/dw and p' = dT/dphi' the law is
//!
//!   x' + w x x = Ge x v ,   v' = v x w ,   p'' = M ,   and the windings' own ;
//!
//! it keeps v.v and x.v, and p' where no moment acts. What is neither kept nor fed is the energy as the turning field sees
//! it, E - W p' (with the work of the constant load). With the multipliers w0 and lambda it is stationary:
//!
//!   G = E - W p' - w0 x.v + 1/2 lambda v.v ,    lambda = w0 x.v + Ge.v .

use crate::machines::{Machine, RotorState, drive, stored_energy};
use crate::stationary::energies::Energies;
use field::{Base, Circle, Over, Scalar, Tangent};
use mechanics::momentum::absolute_rate;
use nalgebra::Vector3;

/// A stationary motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<S> {
    /// w0, rad/s
    pub speed: S,
    /// v
    pub vertical: Vector3<S>,
    /// W: phi', rad/s; a machine that knows the angle is in step with its field
    pub rotor_speed: S,
    /// g
    pub angle: Circle<S>,
}

/// Where what stands in a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    pub rotor: RotorState,
    pub windings: usize,
}

/// The matrices at a stationary motion.
#[derive(Clone, Debug)]
pub struct Linear<S> {
    /// A of y' = A y.
    pub rates: Vec<Vec<S>>,
    /// The second derivatives of G.
    pub energy: Vec<Vec<S>>,
    /// What is missing for it to be a motion: zero at a stationary motion.
    pub missing: Vec<S>,
    /// The differentials of what is conserved, as [`Integral`] lists it.
    pub integrals: Vec<Vec<S>>,
    /// What dG/dt takes from the slip: -dm/dg', N m s, and from each current: R, ohm.
    pub damping: Vec<S>,
}

/// What every motion conserves: a zero root of the first approximation each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integral {
    /// |v| = 1.
    Vertical,
    /// x.v, the angular momentum about the vertical.
    Momentum,
    /// The rotor's own momentum, where nothing acts on it.
    RotorMomentum,
}

impl Layout {
    /// Of a machine.
    pub fn of<P: Base, M: Machine<P>>(machine: &M) -> Self {
        Layout { rotor: M::ROTOR, windings: machine.windings() }
    }

    /// The number of states.
    pub fn size(self) -> usize {
        6 + self.rotor.dimension() + self.windings
    }

    fn angle(self) -> Option<usize> {
        (self.rotor == RotorState::AngleAndSpeed).then_some(6)
    }

    fn slip(self) -> Option<usize> {
        self.rotor.dimension().checked_sub(1).map(|last| 6 + last)
    }
}

/// A state as the laws want it.
pub(super) struct State<S> {
    pub w: Vector3<S>,
    pub v: Vector3<S>,
    pub rotor_speed: S,
    pub slip: S,
    pub angle: Circle<S>,
    pub currents: Vec<S>,
}

impl<S: Scalar> Place<S> {
    /// The same place with constant coordinates.
    fn fixed(&self) -> Place<Tangent<S>> {
        let Place { speed, vertical, rotor_speed, angle } = self;
        Place {
            speed: Tangent::fixed(*speed),
            vertical: vertical.map(Tangent::fixed),
            rotor_speed: Tangent::fixed(*rotor_speed),
            angle: angle.map(Tangent::fixed),
        }
    }

    /// The state at deviations that are zero with a slope.
    fn state<P: Base>(&self, layout: Layout, frame_speed: P, slopes: &[S]) -> State<Tangent<S>>
    where
        S: Over<P>,
    {
        let slope = |place: Option<usize>| place.map_or(S::zero(), |place| slopes[place]);
        let vector = |from: usize| Vector3::from_fn(|i, _| slopes[from + i]);
        let moving = |value: Vector3<S>, slope: Vector3<S>| value.zip_map(&slope, Tangent::moving);
        let in_step = layout.angle().is_some();
        let slip = if in_step { S::zero() } else { self.rotor_speed - S::lift(frame_speed) };
        let first = layout.size() - layout.windings;
        State {
            w: moving(self.vertical * self.speed, vector(0)),
            v: moving(self.vertical, vector(3)),
            rotor_speed: Tangent::moving(self.rotor_speed, slope(layout.slip())),
            slip: Tangent::moving(slip, slope(layout.slip())),
            angle: self.angle.moving(slope(layout.angle())),
            currents: slopes[first..].iter().map(|&slope| Tangent::moving(S::zero(), slope)).collect(),
        }
    }
}

impl<P: Base> Energies<P> {
    /// (x, p'): the angular momentum about O and that of the rotor about its axis.
    pub fn momenta<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> (Vector3<S>, S) {
        let mixed = self.mixed.map(S::lift);
        let all = self.tensor.map(S::lift) * w + mixed * rotor_speed;
        (all, mixed.dot(&w) + S::lift(self.axial) * rotor_speed)
    }
}

/// What is missing for rates to be those of a motion: vanishes along every motion.
pub(super) fn missing<P: Base, S: Over<P>, M: Machine<P>>(
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
        let moment = drive(machine, state.angle, state.slip, &state.currents, &mut currents);
        missing.push(spin.slope - moment);
        let own = &rates[layout.size() - layout.windings..];
        missing.extend(own.iter().zip(currents).map(|(rate, law)| *rate - law));
    }
    missing
}

/// The first variation of what is missing, for deviations from a stationary motion and their rates.
pub(super) fn variation<P: Base, S: Over<P>, M: Machine<P>>(
    energies: &Energies<P>,
    machine: &M,
    place: &Place<S>,
    deviations: &[S],
    rates: &[S],
) -> Vec<S> {
    let rates: Vec<Tangent<S>> = rates.iter().map(|&slope| Tangent::moving(S::zero(), slope)).collect();
    let state = place.state(Layout::of(machine), machine.frame_speed(), deviations);
    missing(energies, machine, &state, &rates).into_iter().map(|one| one.slope).collect()
}

/// E - W p' - w0 x.v + 1/2 lambda v.v, J.
fn energy<P: Base, S: Over<P>, M: Machine<P>>(
    energies: &Energies<P>,
    machine: &M,
    place: &Place<S>,
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
    /// At a stationary motion. `free`: no moment ever acts on the rotor.
    pub fn at<P: Base, M: Machine<P>>(energies: &Energies<P>, machine: &M, place: &Place<S>, free: bool) -> Self
    where
        S: Over<P>,
    {
        let layout = Layout::of(machine);
        let (size, frame) = (layout.size(), machine.frame_speed());
        let unit = |j: usize| -> Vec<S> { (0..size).map(|i| if i == j { S::one() } else { S::zero() }).collect() };
        let rest = vec![S::zero(); size];
        // variation = mass * rates - force * deviations
        let of_rates = |j: usize| variation(energies, machine, place, &rest, &unit(j));
        let of_state = |j: usize| variation(energies, machine, place, &unit(j), &rest);
        let mass = transposed((0..size).map(of_rates).collect());
        let force = transposed((0..size).map(|j| of_state(j).into_iter().map(|slope| -slope).collect()).collect());
        let still: Vec<Tangent<S>> = rest.iter().map(|&zero| Tangent::fixed(zero)).collect();
        let missing = missing(energies, machine, &place.state(layout, frame, &rest), &still);
        let (all, _) = energies.momenta(place.vertical * place.speed, place.rotor_speed);
        let multiplier = place.speed * all.dot(&place.vertical) + energies.weight.map(S::lift).dot(&place.vertical);
        let second = |i: usize, j: usize| {
            let inner = place.state(layout, frame, &unit(i));
            let twice = twice_moved(&inner, &place.fixed(), layout, frame, &unit(j));
            let (place, multiplier) = (place.fixed().fixed(), Tangent::fixed(Tangent::fixed(multiplier)));
            energy(energies, machine, &place, multiplier, &twice).slope.slope
        };
        let mut integrals = vec![Vec::new(); if free { 3 } else { 2 }];
        for j in 0..size {
            let state = place.state(layout, frame, &unit(j));
            let (all, spin) = energies.momenta(state.w, state.rotor_speed);
            let values = [state.v.dot(&state.v).half(), all.dot(&state.v), spin];
            integrals.iter_mut().zip(values).for_each(|(integral, value)| integral.push(value.slope));
        }
        let slip = if layout.angle().is_some() { S::zero() } else { place.rotor_speed - S::lift(frame) };
        let moment = machine.moment_law(Tangent::variable(slip), Tangent::variable(place.rotor_speed));
        let resistances = (0..layout.windings).map(|k| S::lift(machine.resistance(k)));
        let damping = layout.slip().map(|_| -moment.slope).into_iter().chain(resistances).collect();
        Linear {
            rates: resolved(mass, force),
            energy: (0..size).map(|i| (0..size).map(|j| second(i, j)).collect()).collect(),
            missing: missing.into_iter().map(|one| one.value).collect(),
            integrals,
            damping,
        }
    }
}

/// A state that moves in one direction, moved in another.
fn twice_moved<P: Base, S: Over<P>>(
    inner: &State<Tangent<S>>,
    place: &Place<Tangent<S>>,
    layout: Layout,
    frame_speed: P,
    slopes: &[S],
) -> State<Tangent<Tangent<S>>> {
    let outer: Vec<Tangent<S>> = slopes.iter().map(|&slope| Tangent::fixed(slope)).collect();
    let outer = place.state(layout, frame_speed, &outer);
    let add = |a: Tangent<S>, b: Tangent<Tangent<S>>| Tangent::moving(a, b.slope);
    State {
        w: inner.w.zip_map(&outer.w, add),
        v: inner.v.zip_map(&outer.v, add),
        rotor_speed: add(inner.rotor_speed, outer.rotor_speed),
        slip: add(inner.slip, outer.slip),
        angle: inner.angle.moving(layout.angle().map_or(Tangent::fixed(S::zero()), |at| Tangent::fixed(slopes[at]))),
        currents: inner.currents.iter().zip(outer.currents).map(|(&a, b)| add(a, b)).collect(),
    }
}

fn transposed<S: Copy>(columns: Vec<Vec<S>>) -> Vec<Vec<S>> {
    (0..columns.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

/// X with M X = F. The masses are definite, so that no pivot vanishes.
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
