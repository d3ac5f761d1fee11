//! The pieces of a motor on a bench for splitting methods: a kick at a constant angle, and a drift at a constant
//! angular momentum.

use super::{
    Bench, DecayRates, FixedAngleMachine, Kick, Law, Machine, Point, Programmed, Programs, Rule, decay_quotient,
    has_known_flow, kick, solved,
};
use crate::Separable;
use field::{Analytic, Base, Over, Scalar};
use integrators::{Pieces, Real};
use simulation::Running;

/// A rotor on a bench, with the flows of both pieces.
#[derive(Clone, Copy, Debug)]
pub struct BenchFlows<S> {
    /// The rotor's moment of inertia A', kg m^2.
    pub axial: S,
    /// The frame speed W, rad/s.
    pub frame_speed: S,
}

impl<S: Analytic> BenchFlows<S> {
    /// The slip g' = p/A' - W, rad/s.
    pub fn slip(&self, point: &Point<S>) -> S {
        point.momentum / self.axial - self.frame_speed
    }

    /// The change of slip per unit of angular impulse, 1/(kg m^2).
    pub fn compliance(&self) -> S {
        S::one() / self.axial
    }

    /// The flow of the kick at a constant angle. Returns the residual of the equation that is solved by iteration.
    #[inline]
    pub fn push<P: Base, A: FixedAngleMachine<P, S>>(&self, machine: &A, by: &Kick<S>, point: &mut Point<S>) -> S
    where
        S: Over<P>,
    {
        kick(machine, by, self.slip(point), S::zero(), point)
    }

    /// The flow of the drift over a time `length` (s) at a constant angular momentum.
    #[inline]
    pub fn drift(&self, length: S, point: &mut Point<S>) {
        point.angle += length * self.slip(point);
    }
}

/// The pieces of H = p^2/(2 A') - W p + U(g) with the circuits.
struct BenchPieces<'a, S: Scalar, M> {
    machine: &'a M,
    acting: Programmed<'a, S, M>,
    flows: BenchFlows<S>,
    law: Law,
    rule: Rule<S>,
    decay_rates: DecayRates<S>,
}

impl<S: Real + Running, M: Machine<f64>> Pieces<S> for BenchPieces<'_, S, M> {
    type Point = Point<S>;
    type Substep = Kick<S>;

    fn pieces(&self) -> usize {
        2
    }

    fn enter(&self, y: &[S]) -> Point<S> {
        let state = self.machine.rotor();
        let (rotor, currents) = y.split_at(state.dimension());
        let (_, slip) = state.angle_and_slip(rotor);
        Point::enter(self.machine, rotor, self.flows.axial * (slip + self.flows.frame_speed), currents)
    }

    fn leave(&self, point: &Point<S>, y: &mut [S]) {
        point.leave(&self.acting, self.flows.slip(point), y);
    }

    fn substep(&self, _piece: usize, length: S) -> Kick<S> {
        Kick::new(self.machine, self.law, length, self.flows.compliance(), decay_quotient, self.rule)
    }

    fn decay_rate(&self, point: &Point<S>) -> f64 {
        self.decay_rates.fastest(self.machine, self.flows.slip(point))
    }

    fn flow(&self, piece: usize, substep: &Kick<S>, point: &mut Point<S>) -> bool {
        if piece == 0 {
            return solved(self.flows.push(&self.acting, substep, point));
        }
        self.flows.drift(substep.length, point);
        true
    }
}

impl<M: Machine<f64> + Sync> Separable for Bench<f64, M> {
    fn programs(&self) -> Programs {
        Programs::of(&self.machine)
    }

    fn pieces_by<'a, S: Real + Running>(&'a self, programs: Option<&'a Programs>) -> Option<impl Pieces<S> + 'a> {
        let machine = &self.machine;
        let known = has_known_flow(machine);
        let flows = BenchFlows { axial: S::lift(self.axial), frame_speed: S::lift(machine.frame_speed()) };
        known.then(|| {
            let law = Law::of(machine);
            let (acting, decay_rates) =
                (Programmed::new(machine, programs), DecayRates::of(machine, law, flows.compliance()));
            BenchPieces { machine, acting, flows, law, rule: Rule::gauss(), decay_rates }
        })
    }
}
