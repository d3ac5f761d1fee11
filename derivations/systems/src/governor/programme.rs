//! The programme: the motion of the wheel for which the speed of the second shaft is constant, and the control force it
//! requires.
//!
//! With omega2' = 0, Appell's equation for omega2 contains no acceleration: it is a condition on rho', and affine in
//! it. The equation for rho then gives the force. The condition of constant speed is not a contact constraint, hence no
//! reaction acts on the second shaft.

use super::Governor;
use field::{Analytic, Base, Over, Tangent};
use mechanics::constrained::PointSystem;
use mechanics::constrained::appell::residual;
use mechanics::constrained::motion::Motion;

impl<P: Base> Governor<P> {
    /// The residuals dS'/dp' - Q' of Appell's equations for p = (omega2, rho') at the rates p'. All angles are set to
    /// zero, since no equation depends on them.
    pub fn balance<S: Over<P> + Analytic>(&self, time: S, rho: S, p: [S; 2], rates: [S; 2]) -> [S; 2] {
        let zero = S::zero();
        let motion: Motion<S, 7, 2> = Motion::at(self, time, [zero, zero, zero, rho], p);
        let force = self.force(&motion.state);
        residual(self, &motion, force, rates)
    }

    /// The rate rho', m/s, for which omega2 is constant; not finite if the lever arm or the speed is zero.
    pub fn programme<S: Over<P> + Analytic>(&self, time: S, rho: S, speed: S) -> S
    where
        Tangent<S>: Over<P>,
    {
        let zero = Tangent::fixed(S::zero());
        let drift = Tangent::variable(S::zero());
        let [condition, _] =
            self.balance(Tangent::fixed(time), Tangent::fixed(rho), [Tangent::fixed(speed), drift], [zero, zero]);
        -condition.value / condition.slope
    }

    /// The acceleration rho'' along the programme, m/s^2.
    pub fn programme_acceleration<S: Over<P> + Analytic>(&self, time: S, rho: S, speed: S) -> S
    where
        Tangent<S>: Over<P>,
        Tangent<Tangent<S>>: Over<P>,
    {
        let drift = self.programme(time, rho, speed);
        self.programme(Tangent::variable(time), Tangent::moving(rho, drift), Tangent::fixed(speed)).slope
    }

    /// The control force u along the programme, N, in addition to the force `push` of the data: the residual of the
    /// equation for rho.
    pub fn control_force<S: Over<P> + Analytic>(&self, time: S, rho: S, speed: S) -> S
    where
        Tangent<S>: Over<P>,
        Tangent<Tangent<S>>: Over<P>,
    {
        let drift = self.programme(time, rho, speed);
        let rates = [S::zero(), self.programme_acceleration(time, rho, speed)];
        let [_, missing] = self.balance(time, rho, [speed, drift], rates);
        missing + S::lift(self.push)
    }
}
