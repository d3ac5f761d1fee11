//! A motor on its bench in pieces: the kick at a resting angle, and the drift at a constant spin.

use super::{
    Bench, Kick, Law, Machine, Point, Rule, decay_quotient, fading_slip, fastest_current, has_known_flow, kick, solved,
};
use crate::separated::Separable;
use field::Scalar;
use integrators::{Pieces, Real};

/// H = p^2/(2 A') - W p + U(g) and the circuits, in two pieces.
struct BenchPieces<'a, S: Scalar, M> {
    machine: &'a M,
    /// A' and W
    axial: S,
    frame_speed: S,
    law: Law,
    rule: Rule<S>,
    /// The largest r_k.
    fastest: S,
}

impl<S: Real, M: Machine<f64>> BenchPieces<'_, S, M> {
    fn slip(&self, point: &Point<S>) -> S {
        point.momentum / self.axial - self.frame_speed
    }
}

impl<S: Real, M: Machine<f64>> Pieces<S> for BenchPieces<'_, S, M> {
    type Point = Point<S>;
    type Lapse = Kick<S>;

    fn pieces(&self) -> usize {
        2
    }

    fn enter(&self, y: &[S]) -> Point<S> {
        let (rotor, currents) = y.split_at(M::ROTOR.dimension());
        let (_, slip) = M::ROTOR.angle_and_slip(rotor);
        Point::enter(self.machine, rotor, self.axial * (slip + self.frame_speed), currents)
    }

    fn leave(&self, point: &Point<S>, y: &mut [S]) {
        point.leave(self.machine, self.slip(point), y);
    }

    fn lapse(&self, _piece: usize, length: S) -> Kick<S> {
        Kick::new(self.machine, self.law, length, S::one() / self.axial, decay_quotient, self.rule)
    }

    fn fading(&self, point: &Point<S>) -> f64 {
        let slip = fading_slip(self.machine, S::one() / self.axial, self.slip(point));
        self.fastest.approx().max(slip.approx())
    }

    fn flow(&self, piece: usize, lapse: &Kick<S>, point: &mut Point<S>) -> bool {
        let slip = self.slip(point);
        if piece == 0 {
            return solved(kick(self.machine, lapse, slip, S::zero(), point));
        }
        point.angle += lapse.length * slip;
        true
    }
}

impl<M: Machine<f64>> Separable for Bench<f64, M> {
    fn pieces<S: Real>(&self) -> Option<impl Pieces<S>> {
        let machine = &self.machine;
        let known = has_known_flow(machine);
        known.then(|| BenchPieces {
            machine,
            axial: S::lift(self.axial),
            frame_speed: S::lift(machine.frame_speed()),
            law: Law::of(machine),
            rule: Rule::gauss(),
            fastest: fastest_current(machine),
        })
    }
}
