//! The trait of a motor: energies and force laws, from which everything else is derived.

use field::{Analytic, Base, Circle, Divisor, Over, Scalar};

/// The variables of the rotor that are states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RotorState {
    /// None: the speed is prescribed, and the torque is the reaction.
    Prescribed,
    /// The speed: the laws do not depend on the angle.
    Speed,
    /// The angle relative to the stator's field, and the speed.
    AngleAndSpeed,
}

/// An electric motor between the carrier (stator) and the rotor, including friction.
///
/// The rotor's angle g is measured from the stator's field, which rotates with the speed W ([`frame_speed`]): g = phi -
/// W t. The windings carry the currents i_k. With the flux linkages psi_k(g) due to the stator's field the co-energy of
/// the circuits is
///
///   K = sum_k (1/2 L_k i_k^2 + i_k psi_k(g)) - U(g) .
///
/// For windings that move with the rotor, charges are generalised coordinates and Lagrange's equations (Maxwell) hold.
/// A commutator keeps a current at a fixed position while the conductors move through it, and Park's axes rotate while
/// the conductors are at rest: such currents are quasi-velocities without charges, and Hamel's equations hold (Kron).
/// The additional terms are the voltages c_k(i) phi', with c_k affine in the currents, and the torque that balances
/// their power:
///
///   d/dt (dK/di_k) = v_k(g) - R_k i_k - c_k(i) phi' ,    M = dK/dg + sum_k i_k c_k(i) + m(g', phi') .
///
/// The power balance of the rotor follows; W dK/dg is the power supplied by the field:
///
///   M phi' + d/dt (U + sum_k 1/2 L_k i_k^2) = W dK/dg + phi' m + sum_k v_k i_k - sum_k R_k i_k^2 .
///
/// [`frame_speed`]: Machine::frame_speed
pub trait Machine<P: Base> {
    /// The variables of the rotor on which the laws depend.
    fn rotor(&self) -> RotorState;

    /// The frame speed W, rad/s.
    fn frame_speed(&self) -> P;

    /// The number of windings on the rotor.
    #[inline(always)]
    fn windings(&self) -> usize {
        0
    }

    /// The name of the winding's current among the states; x for the excitation and i1, i2, ... for bars by default.
    fn current_name(&self, winding: usize) -> String {
        if winding == 0 { "x".into() } else { format!("i{winding}") }
    }

    /// The inductance L_k, H.
    #[inline(always)]
    fn inductance(&self, _winding: usize) -> P {
        P::one()
    }

    /// The resistance R_k, ohm.
    #[inline(always)]
    fn resistance(&self, _winding: usize) -> P {
        P::zero()
    }

    /// The flux linkage psi_k(g), Wb.
    #[inline(always)]
    fn linkage<S: Over<P>>(&self, _winding: usize, _angle: Circle<S>) -> S {
        S::zero()
    }

    /// The voltage v_k(g) of a supply, V; `None` where the winding is short-circuited.
    #[inline(always)]
    fn supply<S: Over<P>>(&self, _winding: usize, _angle: Circle<S>) -> Option<S> {
        None
    }

    /// The coefficient c_k(i) of the motional voltage, V s or N m/A: the voltage against the current per speed phi' due
    /// to conductors that slide past brushes or axes. Affine in the currents; `None` without sliding conductors.
    #[inline(always)]
    fn motional<S: Over<P>>(&self, _winding: usize, _currents: &[S]) -> Option<S> {
        None
    }

    /// The energy U(g) of a permanently magnetised rotor in the stator's field, J.
    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, _angle: Circle<S>) -> S {
        S::zero()
    }

    /// The torque m(g', phi') without potential, N m: friction, and torques that depend on the slip.
    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S;
}

/// The constants of a winding.
#[derive(Clone, Copy, Debug)]
pub struct Circuit<P> {
    /// The resistance R, ohm.
    resistance: P,
    /// The inductance L, H.
    inductance: Divisor<P>,
}

impl<P: Base> Circuit<P> {
    /// The constants of one winding of a machine.
    #[inline(always)]
    pub fn of(machine: &impl Machine<P>, winding: usize) -> Self {
        let inductance = Divisor::new(machine.inductance(winding));
        Circuit { resistance: machine.resistance(winding), inductance }
    }

    /// The opposing voltage u = R i + psi'(g) g', V.
    #[inline(always)]
    fn opposing<S: Over<P>>(self, current: S, coupling: S, slip: S) -> S {
        let resisted = S::lift(self.resistance) * current;
        resisted.and_product(coupling, slip)
    }

    /// The rate di/dt = -u/L for the sum u of all opposing voltages, A/s.
    #[inline(always)]
    fn rate<S: Over<P>>(self, opposing: S) -> S {
        -opposing.divided_by(self.inductance)
    }
}

/// Returns the torque M (N m), and writes the rates of the currents (A/s) to `current_rates`, by the Lagrange-Maxwell
/// equations.
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

/// As [`torque_and_current_rates`], with precomputed circuits of the windings in order.
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

/// The energy U(g) + sum 1/2 L_k i_k^2 of the rotor's circuits, J.
pub fn stored_energy<P: Base, S: Over<P>>(machine: &impl Machine<P>, angle: Circle<S>, currents: &[S]) -> S {
    let windings = currents.iter().enumerate();
    windings.fold(machine.field_energy(angle), |sum, (k, &i)| sum + (S::lift(machine.inductance(k)) * i * i).half())
}

/// The Joule heat sum R_k i_k^2, W.
pub fn joule_heat<P: Base, S: Over<P>>(machine: &impl Machine<P>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(S::zero(), |sum, (k, &i)| sum + S::lift(machine.resistance(k)) * i * i)
}

/// The power sum v_k i_k of the supplies, W.
pub fn electrical_power<P: Base, S: Over<P>>(machine: &impl Machine<P>, angle: Circle<S>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(S::zero(), |sum, (k, &i)| match machine.supply(k, angle) {
        Some(voltage) => sum + voltage * i,
        None => sum,
    })
}

/// The torque sum c_k i_k of sliding conductors, N m.
pub fn motional_torque<P: Base, S: Over<P>>(machine: &impl Machine<P>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(S::zero(), |sum, (k, &i)| match machine.motional(k, currents) {
        Some(motional) => sum + motional * i,
        None => sum,
    })
}

/// Whether any winding has a supply or sliding conductors: then currents need not vanish at rest, and E - W p is not
/// dissipated only.
pub fn is_fed<P: Base>(machine: &impl Machine<P>) -> bool {
    let none = vec![P::zero(); machine.windings()];
    (0..none.len()).any(|k| machine.supply(k, Circle::<P>::zero()).is_some() || machine.motional(k, &none).is_some())
}

/// The names of the states of a machine: those of its rotor, then its currents.
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

    /// The angle g as a point of the unit circle, and g', from the rotor's part of the state; zero for a variable that
    /// is not part of the state.
    #[inline(always)]
    pub fn angle_and_slip<S: Analytic>(self, state: &[S]) -> (Circle<S>, S) {
        match (self, state) {
            (Self::AngleAndSpeed, [angle, slip, ..]) => (angle.circle(), *slip),
            (Self::Speed, [slip, ..]) => (Circle::zero(), *slip),
            _ => (Circle::zero(), S::zero()),
        }
    }

    /// Writes the rates of the rotor's part of the state from the slip and its rate.
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
