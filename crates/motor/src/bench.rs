//! A motor on a bench: the housing is fixed.

use super::{Machine, stored_energy, torque_and_current_rates};
use field::{Analytic, Base, Over};
use integrators::Ode;

/// A motor on a bench, with the moment of inertia A' of its rotor.
#[derive(Clone, Copy, Debug)]
pub struct Bench<P, M> {
    pub machine: M,
    /// The rotor's moment of inertia A', kg m^2.
    pub axial: P,
}

impl<P: Base, M: Machine<P>> Bench<P, M> {
    /// The number of states: those of the rotor, then the currents.
    pub fn dimension(&self) -> usize {
        self.machine.rotor().dimension() + self.machine.windings()
    }

    /// Writes the rates of the rotor, A' g'' = M, and of the currents.
    pub fn rates<S: Over<P> + Analytic>(&self, y: &[S], dy: &mut [S]) {
        self.rates_under(S::zero(), y, dy);
    }

    /// As [`Self::rates`], with a load torque (N m) against the rotation: A' g'' = M - load.
    pub fn rates_under<S: Over<P> + Analytic>(&self, load: S, y: &[S], dy: &mut [S]) {
        let (rotor, currents) = y.split_at(self.machine.rotor().dimension());
        let (rotor_rates, current_rates) = dy.split_at_mut(self.machine.rotor().dimension());
        let (angle, slip) = self.machine.rotor().angle_and_slip(rotor);
        let torque = torque_and_current_rates(&self.machine, angle, slip, currents, current_rates) - load;
        self.machine.rotor().write(slip, torque / S::lift(self.axial), rotor_rates);
    }

    /// The rotor's angular momentum A' phi', N m s.
    pub fn rotor_momentum<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let (_, slip) = self.machine.rotor().angle_and_slip(&y[..self.machine.rotor().dimension()]);
        S::lift(self.axial) * (slip + S::lift(self.machine.frame_speed()))
    }

    /// The energy 1/2 A' phi'^2 plus that of the circuits, J.
    pub fn energy<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let (rotor, currents) = y.split_at(self.machine.rotor().dimension());
        let (angle, _) = self.machine.rotor().angle_and_slip(rotor);
        let momentum = self.rotor_momentum(y);
        (momentum * momentum / S::lift(self.axial)).half() + stored_energy(&self.machine, angle, currents)
    }

    /// The Jacobi integral E - W p, the energy in the frame of the stator's field: without supply and sliding windings
    /// its loss is heat. J.
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
