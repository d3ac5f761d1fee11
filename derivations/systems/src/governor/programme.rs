//! The programme: where the wheel must be so that the second shaft keeps its speed, and what pushes it there.
//!
//! With omega2' = 0 Appell's equation of omega2 loses its acceleration: it is a condition on rho', affine in it. That of
//! rho gives the force. The condition of speed is no constraint of contact: nothing pushes on the second shaft to keep it.

use super::Governor;
use field::{Analytic, Base, Over, Tangent};
use mechanics::constrained::PointSystem;
use mechanics::constrained::appell::residual;
use mechanics::constrained::motion::Motion;

impl<P: Base> Governor<P> {
    /// dS'/dp' - Q' for p = (omega2, rho') at the rates p'; all angles are zero, which no equation can see.
    pub fn balance<S: Over<P> + Analytic>(&self, time: S, rho: S, p: [S; 2], rates: [S; 2]) -> [S; 2] {
        let zero = S::zero();
        let motion: Motion<S, 7, 2> = Motion::at(self, time, [zero, zero, zero, rho], p);
        let force = self.force(&motion.state);
        residual(self, &motion, force, rates)
    }

    /// rho' that keeps omega2, m/s: not finite where the lever or the speed vanishes.
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

    /// rho'' along the programme, m/s^2.
    pub fn programme_acceleration<S: Over<P> + Analytic>(&self, time: S, rho: S, speed: S) -> S
    where
        Tangent<S>: Over<P>,
        Tangent<Tangent<S>>: Over<P>,
    {
        let drift = self.programme(time, rho, speed);
        self.programme(Tangent::variable(time), Tangent::moving(rho, drift), Tangent::fixed(speed)).slope
    }

    /// u along the programme, N: what is missing in the wheel's equation, beside the push that the data give already.
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
