//! What a motor is: energies and laws of force. Everything else is derived.

use field::{Analytic, Base, Circle, Divisor, Over, Scalar};
use integrators::Ode;

/// How much of the rotor's motion is state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotorState {
    /// The speed is prescribed and the moment is the reaction that keeps it.
    Prescribed,
    /// The laws know the speed only.
    Speed,
    /// The laws know the angle to the stator's field too.
    AngleAndSpeed,
}

/// An electric motor between the carrier (stator) and the rotor, friction included.
///
/// The rotor's angle g is measured from the stator's field, which turns with the speed W ([`frame_speed`]):
/// g = phi' - W t. The windings of the rotor carry the currents i_k. With the fluxes that the stator's field sends
/// through them, psi_k(g), the coenergy of the rotor's circuits is
///
///   K = sum_k (1/2 L_k i_k^2 + i_k psi_k(g)) - U(g) ,
///
/// and Lagrange's equations with charges as coordinates (Maxwell) give moment and currents:
///
///   M = dK/dg + m(g', phi') ,    d/dt (dK/di_k) = -R_k i_k .
///
/// [`frame_speed`]: Machine::frame_speed
pub trait Machine<P: Base> {
    /// What the laws need to know of the rotor.
    const ROTOR: RotorState;

    /// W, rad/s.
    fn frame_speed(&self) -> P;

    /// The number of windings on the rotor.
    #[inline(always)]
    fn windings(&self) -> usize {
        0
    }

    /// L_k, H.
    #[inline(always)]
    fn inductance(&self, _winding: usize) -> P {
        P::one()
    }

    /// R_k, ohm.
    #[inline(always)]
    fn resistance(&self, _winding: usize) -> P {
        P::zero()
    }

    /// psi_k(g), Wb.
    #[inline(always)]
    fn linkage<S: Over<P>>(&self, _winding: usize, _angle: Circle<S>) -> S {
        S::zero()
    }

    /// U(g), J: the energy of a rotor magnetised for ever in the stator's field.
    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, _angle: Circle<S>) -> S {
        S::zero()
    }

    /// m(g', phi'), N m: what does not come from an energy of the angle, such as friction and the moment of slip.
    fn moment_law<S: Over<P>>(&self, slip: S, speed: S) -> S;
}

/// What of a winding is known before it moves.
#[derive(Clone, Copy, Debug)]
pub struct Circuit<P> {
    /// R, ohm
    resistance: P,
    /// L, H
    inductance: Divisor<P>,
}

impl<P: Base> Circuit<P> {
    /// Of one winding of a machine.
    #[inline(always)]
    pub fn of(machine: &impl Machine<P>, winding: usize) -> Self {
        let inductance = Divisor::new(machine.inductance(winding));
        Circuit { resistance: machine.resistance(winding), inductance }
    }

    /// di/dt = -(R i + psi'(g) g')/L.
    #[inline(always)]
    fn rate<S: Over<P>>(self, current: S, coupling: S, slip: S) -> S {
        let resisted = S::lift(self.resistance) * current;
        -resisted.and_product(coupling, slip).divided_by(self.inductance)
    }
}

/// M and the rates of the currents by Lagrange-Maxwell; the rates are written to `current_rates`.
#[inline(always)]
pub fn drive<P: Base, S: Over<P>>(
    machine: &impl Machine<P>,
    angle: Circle<S>,
    slip: S,
    currents: &[S],
    current_rates: &mut [S],
) -> S {
    let circuits = (0..machine.windings()).map(|winding| Circuit::of(machine, winding));
    drive_circuits(machine, circuits, angle, slip, currents, current_rates)
}

/// The same with the circuits of its windings, in order.
#[inline(always)]
pub fn drive_circuits<P: Base, S: Over<P>>(
    machine: &impl Machine<P>,
    circuits: impl Iterator<Item = Circuit<P>>,
    angle: Circle<S>,
    slip: S,
    currents: &[S],
    current_rates: &mut [S],
) -> S {
    let varied = angle.moving(S::one());
    let speed = slip + S::lift(machine.frame_speed());
    let mut moment = machine.moment_law(slip, speed) - machine.field_energy(varied).slope;
    for (k, ((&current, rate), circuit)) in currents.iter().zip(current_rates).zip(circuits).enumerate() {
        let coupling = machine.linkage(k, varied).slope;
        moment = moment.and_product(current, coupling);
        *rate = circuit.rate(current, coupling, slip);
    }
    moment
}

/// U(g) + sum 1/2 L_k i_k^2, J: what the circuits of the rotor store and can give back.
pub fn stored_energy<P: Base, S: Over<P>>(machine: &impl Machine<P>, angle: Circle<S>, currents: &[S]) -> S {
    let windings = currents.iter().enumerate();
    windings.fold(machine.field_energy(angle), |sum, (k, &i)| sum + (S::lift(machine.inductance(k)) * i * i).half())
}

/// sum R_k i_k^2, W: what the windings turn into heat.
pub fn heat<P: Base, S: Over<P>>(machine: &impl Machine<P>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(S::zero(), |sum, (k, &i)| sum + S::lift(machine.resistance(k)) * i * i)
}

/// The names of the states of a machine: of its rotor, then its currents (x for the excitation, i1, i2, ... the bars).
pub fn state_names<P: Base, M: Machine<P>>(machine: &M) -> Vec<String> {
    let rotor: &[&str] = match M::ROTOR {
        RotorState::Prescribed => &[],
        RotorState::Speed => &["slip"],
        RotorState::AngleAndSpeed => &["angle", "slip"],
    };
    let currents = (0..machine.windings()).map(|k| if k == 0 { "x".into() } else { format!("i{k}") });
    rotor.iter().map(|&name| name.into()).chain(currents).collect()
}

/// A motor alone on a bench: its rotor with moment of inertia A' and a housing at rest.
#[derive(Clone, Copy, Debug)]
pub struct Bench<P, M> {
    pub machine: M,
    /// A', kg m^2
    pub axial: P,
}

impl<P: Base, M: Machine<P>> Bench<P, M> {
    /// The number of states: of the rotor, then the currents.
    pub fn dimension(&self) -> usize {
        M::ROTOR.dimension() + self.machine.windings()
    }

    /// A' g'' = M and the currents.
    #[inline(always)]
    pub fn rates<S: Over<P> + Analytic>(&self, y: &[S], dy: &mut [S]) {
        self.rates_under(S::zero(), y, dy);
    }

    /// A' g'' = M - load and the currents, with a further moment of the load against the rotor's turning, N m.
    #[inline(always)]
    pub fn rates_under<S: Over<P> + Analytic>(&self, load: S, y: &[S], dy: &mut [S]) {
        let (rotor, currents) = y.split_at(M::ROTOR.dimension());
        let (rotor_rates, current_rates) = dy.split_at_mut(M::ROTOR.dimension());
        let (angle, slip) = M::ROTOR.angle_and_slip(rotor);
        let moment = drive(&self.machine, angle, slip, currents, current_rates) - load;
        M::ROTOR.write(slip, moment / S::lift(self.axial), rotor_rates);
    }

    /// A' phi', the rotor's angular momentum.
    pub fn rotor_momentum<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let (_, slip) = M::ROTOR.angle_and_slip(&y[..M::ROTOR.dimension()]);
        S::lift(self.axial) * (slip + S::lift(self.machine.frame_speed()))
    }

    /// 1/2 A' phi'^2 and the energy of the circuits.
    pub fn energy<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let (rotor, currents) = y.split_at(M::ROTOR.dimension());
        let (angle, _) = M::ROTOR.angle_and_slip(rotor);
        let momentum = self.rotor_momentum(y);
        (momentum * momentum / S::lift(self.axial)).half() + stored_energy(&self.machine, angle, currents)
    }

    /// E - W p, the energy as seen from the stator's field: what it loses is heat.
    pub fn jacobi<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        self.energy(y) - S::lift(self.machine.frame_speed()) * self.rotor_momentum(y)
    }
}

impl<S: Over<f64> + Analytic, M: Machine<f64>> Ode<S> for Bench<f64, M> {
    fn dimension(&self) -> usize {
        Bench::dimension(self)
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        Bench::rates(self, y, dy);
    }
}

impl RotorState {
    /// How many numbers the state of the rotor has.
    pub const fn dimension(self) -> usize {
        match self {
            Self::Prescribed => 0,
            Self::Speed => 1,
            Self::AngleAndSpeed => 2,
        }
    }

    /// (g as a point of the circle, g') from the rotor's part of the state; what is not state is zero.
    #[inline(always)]
    pub fn angle_and_slip<S: Analytic>(self, state: &[S]) -> (Circle<S>, S) {
        match (self, state) {
            (Self::AngleAndSpeed, [angle, slip, ..]) => (angle.circle(), *slip),
            (Self::Speed, [slip, ..]) => (Circle::zero(), *slip),
            _ => (Circle::zero(), S::zero()),
        }
    }

    /// The rates of the rotor's part of the state. (Angle and speed for speed and acceleration: the state itself.)
    #[inline(always)]
    pub fn write<S: Scalar>(self, slip: S, acceleration: S, rates: &mut [S]) {
        match (self, rates) {
            (Self::AngleAndSpeed, [angle_rate, slip_rate, ..]) => {
                *angle_rate = slip;
                *slip_rate = acceleration;
            }
            (Self::Speed, [slip_rate, ..]) => *slip_rate = acceleration,
            _ => {}
        }
    }
}
