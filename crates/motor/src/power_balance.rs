//! A motor's run with the supplied work as an additional state: a change of E - W p beyond this work is a numerical
//! error.

use super::integrals::feed;
use super::{Bench, Machine, RotorState, joule_heat};
use field::{Analytic, Base, Over};
use integrators::Ode;

/// A law with its Jacobi integral E - W p and the power on it.
pub trait Powered {
    /// The number of states.
    fn dimension(&self) -> usize;
    /// y' = f(y); must not allocate.
    fn rates<S: Over<f64> + Analytic>(&self, y: &[S], dy: &mut [S]);
    /// The Jacobi integral E - W p, J.
    fn jacobi<S: Over<f64> + Analytic>(&self, y: &[S]) -> S;
    /// The power d/dt (E - W p) along a motion, W; must not allocate.
    fn power<S: Over<f64> + Analytic>(&self, y: &[S]) -> S;
}

/// The power m g' - sum R_k i_k^2 + sum v_k i_k - W sum c_k i_k of friction, heat, supply and sliding windings on E - W
/// p, in W, from the machine's part of a state.
pub fn supplied_power<P: Base, S: Over<P> + Analytic>(machine: &impl Machine<P>, state: &[S]) -> S {
    let known = machine.rotor();
    let (rotor, currents) = state.split_at(known.dimension());
    if known == RotorState::Prescribed {
        return S::zero();
    }
    let (angle, slip) = known.angle_and_slip(rotor);
    let frame_speed = S::lift(machine.frame_speed());
    let friction = machine.torque_law(slip, slip + frame_speed) * slip;
    friction - joule_heat(machine, currents) + feed(machine, angle, currents)
}

/// A law with the supplied work as an additional last state, J.
#[derive(Clone, Debug)]
pub struct WithSuppliedWork<L>(pub L);

impl<L: Powered> WithSuppliedWork<L> {
    /// E - W p minus the supplied work, J: constant along an exact motion.
    pub fn balance(&self, y: &[f64]) -> f64 {
        y.split_last().map_or(f64::NAN, |(work, y)| self.0.jacobi(y) - work)
    }
}

impl<S: Over<f64> + Analytic, L: Powered> Ode<S> for WithSuppliedWork<L> {
    fn dimension(&self) -> usize {
        self.0.dimension() + 1
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        if let ([y @ .., _], [dy @ .., work]) = (y, dy) {
            self.0.rates(y, dy);
            *work = self.0.power(y);
        }
    }
}

impl<M: Machine<f64>> Powered for Bench<f64, M> {
    fn dimension(&self) -> usize {
        Bench::dimension(self)
    }

    fn rates<S: Over<f64> + Analytic>(&self, y: &[S], dy: &mut [S]) {
        Bench::rates(self, y, dy);
    }

    fn jacobi<S: Over<f64> + Analytic>(&self, y: &[S]) -> S {
        Bench::jacobi(self, y)
    }

    fn power<S: Over<f64> + Analytic>(&self, y: &[S]) -> S {
        supplied_power(&self.machine, y)
    }
}
