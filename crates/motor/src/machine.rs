//! The trait of a motor: energies and laws of force, from which everything else is derived.

use field::{Analytic, Base, Circle, Divisor, Over, Scalar};

/// The part of the rotor's motion that is state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotorState {
    /// The speed is prescribed and the torque is the reaction that keeps it.
    Prescribed,
    /// The laws depend on the speed only.
    Speed,
    /// The laws depend on the angle to the stator's field too.
    AngleAndSpeed,
}

/// An electric motor between the carrier (stator) and the rotor, friction included.
///
/// The rotor's angle g is measured from the stator's field, which turns with the speed W ([`frame_speed`]):
/// g = phi - W t. The windings carry the currents i_k. With the fluxes that the stator's field sends through them,
/// psi_k(g), the coenergy of the circuits is
///
///   K = sum_k (1/2 L_k i_k^2 + i_k psi_k(g)) - U(g) .
///
/// On windings that move with the rotor charges are coordinates, and Lagrange's equations (Maxwell) hold. A commutator
/// keeps a current in its place while the conductors turn through it, and Park's axes turn while the conductors rest: such
/// currents are quasi-velocities, no charges belong to them, and the equations are Hamel's (Kron). Their further terms are
/// the voltages c_k(i) phi', with c_k affine in the currents, and the torque that balances their power:
///
///   d/dt (dK/di_k) = v_k(g) - R_k i_k - c_k(i) phi' ,    M = dK/dg + sum_k i_k c_k(i) + m(g', phi') .
///
/// The rotor therefore takes phi' sum i_k c_k from the circuits, and the field gives W dK/dg:
///
///   M phi' + d/dt (U + sum_k 1/2 L_k i_k^2) = W dK/dg + phi' m + sum_k v_k i_k - sum_k R_k i_k^2 .
///
/// [`frame_speed`]: Machine::frame_speed
pub trait Machine<P: Base> {
    /// The rotor's variables that the laws depend on.
    fn rotor(&self) -> RotorState;

    /// W, rad/s.
    fn frame_speed(&self) -> P;

    /// The number of windings on the rotor.
    #[inline(always)]
    fn windings(&self) -> usize {
        0
    }

    /// The name of the winding's current among the states: x of the excitation, i1, i2, ... of bars.
    fn current_name(&self, winding: usize) -> String {
        if winding == 0 { "x".into() } else { format!("i{winding}") }
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

    /// v_k(g), V: the voltage of a supply at a winding; `None` where the winding is short-circuited.
    #[inline(always)]
    fn supply<S: Over<P>>(&self, _winding: usize, _angle: Circle<S>) -> Option<S> {
        None
    }

    /// c_k(i), V s or N m/A: the voltage against the current per speed phi' of the rotor through which brushes or axes see the
    /// conductors slide; affine in the currents, none where they see no sliding.
    #[inline(always)]
    fn motional<S: Over<P>>(&self, _winding: usize, _currents: &[S]) -> Option<S> {
        None
    }

    /// U(g), J: the energy of a permanently magnetised rotor in the stator's field.
    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, _angle: Circle<S>) -> S {
        S::zero()
    }

    /// m(g', phi'), N m: the torque that does not come from an energy of the angle, such as friction and the torque of
    /// slip.
    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S;
}

/// The constants of a winding.
#[derive(Clone, Copy, Debug)]
pub struct Circuit<P> {
    /// R, ohm
    resistance: P,
    /// L, H
    inductance: Divisor<P>,
}

impl<P: Base> Circuit<P> {
    /// The constants of one winding of a machine.
    #[inline(always)]
    pub fn of(machine: &impl Machine<P>, winding: usize) -> Self {
        let inductance = Divisor::new(machine.inductance(winding));
        Circuit { resistance: machine.resistance(winding), inductance }
    }

    /// u = R i + psi'(g) g', V.
    #[inline(always)]
    fn opposing<S: Over<P>>(self, current: S, coupling: S, slip: S) -> S {
        let resisted = S::lift(self.resistance) * current;
        resisted.and_product(coupling, slip)
    }

    /// di/dt = -u/L for all voltages against the current together.
    #[inline(always)]
    fn rate<S: Over<P>>(self, opposing: S) -> S {
        -opposing.divided_by(self.inductance)
    }
}

/// The torque M and the rates of the currents by Lagrange-Maxwell; the rates are written to `current_rates`.
#[inline(always)]
pub fn torque_and_current_rates<P: Base, S: Over<P>>(
    machine: &impl Machine<P>,
    angle: Circle<S>,
    slip: S,
    currents: &[S],
    current_rates: &mut [S],
) -> S {
    let circuits = (0..machine.windings()).map(|winding| Circuit::of(machine, winding));
    torque_and_circuit_rates(machine, circuits, angle, slip, currents, current_rates)
}

/// [`torque_and_current_rates`] with the circuits of the windings, in order.
#[inline(always)]
pub fn torque_and_circuit_rates<P: Base, S: Over<P>>(
    machine: &impl Machine<P>,
    circuits: impl Iterator<Item = Circuit<P>>,
    angle: Circle<S>,
    slip: S,
    currents: &[S],
    current_rates: &mut [S],
) -> S {
    let varied = angle.varied();
    let speed = slip + S::lift(machine.frame_speed());
    let mut torque = machine.torque_law(slip, speed) - machine.field_energy(varied).slope;
    for (k, ((&current, rate), circuit)) in currents.iter().zip(current_rates).zip(circuits).enumerate() {
        let coupling = machine.linkage(k, varied).slope;
        torque = torque.and_product(current, coupling);
        let mut opposing = circuit.opposing(current, coupling, slip);
        if let Some(motional) = machine.motional(k, currents) {
            torque = torque.and_product(current, motional);
            opposing = opposing.and_product(motional, speed);
        }
        if let Some(supply) = machine.supply(k, angle) {
            opposing -= supply;
        }
        *rate = circuit.rate(opposing);
    }
    torque
}

/// U(g) + sum 1/2 L_k i_k^2, J: the energy stored in the circuits of the rotor.
pub fn stored_energy<P: Base, S: Over<P>>(machine: &impl Machine<P>, angle: Circle<S>, currents: &[S]) -> S {
    let windings = currents.iter().enumerate();
    windings.fold(machine.field_energy(angle), |sum, (k, &i)| sum + (S::lift(machine.inductance(k)) * i * i).half())
}

/// sum R_k i_k^2, W: the heat of the windings.
pub fn joule_heat<P: Base, S: Over<P>>(machine: &impl Machine<P>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(S::zero(), |sum, (k, &i)| sum + S::lift(machine.resistance(k)) * i * i)
}

/// sum v_k i_k, W: the power of the supplies into the windings.
pub fn electrical_power<P: Base, S: Over<P>>(machine: &impl Machine<P>, angle: Circle<S>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(S::zero(), |sum, (k, &i)| match machine.supply(k, angle) {
        Some(voltage) => sum + voltage * i,
        None => sum,
    })
}

/// sum c_k i_k, N m: the torque of the windings in which conductors slide.
pub fn motional_torque<P: Base, S: Over<P>>(machine: &impl Machine<P>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(S::zero(), |sum, (k, &i)| match machine.motional(k, currents) {
        Some(motional) => sum + motional * i,
        None => sum,
    })
}

/// Whether a winding has a supply or slides: then currents need not rest at zero, and E - W p is fed.
pub fn is_fed<P: Base>(machine: &impl Machine<P>) -> bool {
    let none = vec![P::zero(); machine.windings()];
    (0..none.len()).any(|k| machine.supply(k, Circle::<P>::zero()).is_some() || machine.motional(k, &none).is_some())
}

/// The names of the states of a machine: of its rotor, then its currents.
pub fn state_names<P: Base>(machine: &impl Machine<P>) -> Vec<String> {
    let rotor: &[&str] = match machine.rotor() {
        RotorState::Prescribed => &[],
        RotorState::Speed => &["slip"],
        RotorState::AngleAndSpeed => &["angle", "slip"],
    };
    let currents = (0..machine.windings()).map(|k| machine.current_name(k));
    rotor.iter().map(|&name| name.into()).chain(currents).collect()
}

impl RotorState {
    /// The number of states of the rotor.
    pub const fn dimension(self) -> usize {
        match self {
            Self::Prescribed => 0,
            Self::Speed => 1,
            Self::AngleAndSpeed => 2,
        }
    }

    /// (g as a point of the circle, g') from the rotor's part of the state; a part that is no state is zero.
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
