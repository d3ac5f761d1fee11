//! Hamilton's equations of the gyrostat, on se(3)* extended by a rotor, split into explicit sub-flows.
//!
//! Let x be the angular momentum about O, v the vertical, p = A' (w.l + phi') the rotor's angular momentum about its
//! axis, and U(g) the energy of its magnets in the field that rotates at W. Then
//!
//!   H = 1/2 (x - p l).A^-1 (x - p l) + p^2/(2 A') - W p - Ge.v + U(g) ,
//!
//!   x' = x x dH/dx + v x dH/dv ,   v' = v x dH/dx ,   g' = dH/dp ,   p' = -dH/dg + friction .
//!
//! For every H, v.v and x.v are conserved (Casimir functions), and a torque between rotor and carrier changes neither
//! of them. The sum H is split into squares (in the principal axes of an inertia tensor: Reich 1994, McLachlan 1993)
//! and further terms:
//!
//! | term | flow |
//! |---|---|
//! | 1/2 m_k y_k^2, y = x - q l | x and v rotate about axis k with the constant speed m_k y_k, and g by -l_k times it |
//! | 1/2 s (n.y)^2 | the rotation about n, if the tensor is not diagonal in the form's axes |
//! | p^2/(2 A') - W p | g grows linearly; the term commutes with all others and is combined with one of them |
//! | -Ge.v + U(g) with windings and friction | v and g are constant; x, p and the currents change, see [`motor::Kick`] |
//!
//! Here q = p for a free rotor, and q = A' phi' for a rotor with prescribed speed. In the second case p is not a
//! variable, and x is the total angular momentum minus a constant vector along l.

use super::driven::Driven;
use super::forms::Form;
use field::{Analytic, Base, Over, Scalar};
use integrators::{Pieces, Real};
use mechanics::rotation::{turned_about, turned_along};
use motor::{
    DecayRates, FixedAngleMachine, Kick, Law, Machine, Point as RotorPoint, Programmed, Programs, RotorState, Rule,
    Separable, decay_quotient, has_known_flow, kick, solved,
};
use nalgebra::Vector3;
use simulation::Running;

/// The data of H, in the axes of a form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Momenta<P: Scalar> {
    /// The coefficients m_k.
    pub mobility: Vector3<P>,
    /// The vector n, of arbitrary length.
    pub oblique: Vector3<P>,
    /// The coefficient s; zero if three squares suffice.
    pub share: P,
    /// The unit vector l of the rotor's axis.
    pub axis: Vector3<P>,
    /// The rotor's moment of inertia A' about its axis.
    pub axial: P,
    /// The vector Ge of the weight.
    pub weight: Vector3<P>,
}

/// The state of the sub-flows.
#[derive(Clone, Debug, PartialEq)]
pub struct Point<S: Scalar> {
    /// The angular momentum x.
    pub momentum: Vector3<S>,
    /// The unit vector v of the vertical.
    pub vertical: Vector3<S>,
    /// The angle g, the momentum q and the fluxes.
    pub rotor: RotorPoint<S>,
}

/// The Hamiltonian H with derived data for its sub-flows.
#[derive(Clone, Copy, Debug)]
pub struct Flows<S: Scalar> {
    momenta: Momenta<S>,
    /// The unit vector n / |n|; `oblique_mobility` is s n.n.
    unit: Vector3<S>,
    oblique_mobility: S,
    /// The factor 1/A'; zero for a rotor with prescribed speed.
    rotor_mobility: S,
    /// The angular velocity W of the field.
    frame_speed: S,
}

impl<S: Analytic> Flows<S> {
    /// The sub-flows of a form with a machine.
    pub fn new<P: Base>(form: &impl Form<P>, machine: &impl Machine<P>) -> Self
    where
        S: Over<P>,
    {
        let kept = machine.rotor() == RotorState::Prescribed;
        let Momenta { mobility, oblique, share, axis, axial, weight } = form.momenta(kept);
        let momenta = Momenta {
            mobility: mobility.map(S::lift),
            oblique: oblique.map(S::lift),
            share: S::lift(share),
            axis: axis.map(S::lift),
            axial: S::lift(axial),
            weight: weight.map(S::lift),
        };
        let square = momenta.oblique.dot(&momenta.oblique);
        Flows {
            momenta,
            unit: momenta.oblique / square.sqrt(),
            oblique_mobility: momenta.share * square,
            rotor_mobility: if kept { S::zero() } else { S::one() / momenta.axial },
            frame_speed: S::lift(machine.frame_speed()),
        }
    }

    /// The number of squares.
    pub fn squares(&self) -> usize {
        if self.momenta.share.is_zero() { 3 } else { 4 }
    }

    /// The derivative d(g')/dp at fixed x: the response of the slip to an impulsive torque on the rotor.
    pub fn compliance(&self) -> S {
        let l = self.momenta.axis;
        self.rotor_mobility + l.dot(&self.angular_velocity(l))
    }

    /// The derivative dH/dx, which is linear in y.
    fn angular_velocity(&self, y: Vector3<S>) -> Vector3<S> {
        y.component_mul(&self.momenta.mobility) + self.unit * (self.oblique_mobility * self.unit.dot(&y))
    }

    /// The velocities (w, g'); for a rotor with prescribed speed the second one has no meaning.
    pub fn velocities(&self, at: &Point<S>) -> (Vector3<S>, S) {
        let w = self.angular_velocity(at.momentum - self.momenta.axis * at.rotor.momentum);
        (w, at.rotor.momentum * self.rotor_mobility - self.frame_speed - w.dot(&self.momenta.axis))
    }

    /// The flow of p^2/(2 A') - W p, which is combined with the flow of the first square.
    fn drift(&self, length: S, at: &mut Point<S>) {
        at.rotor.angle += length * (at.rotor.momentum * self.rotor_mobility - self.frame_speed);
    }

    /// The flow of the square of component k.
    #[inline]
    pub fn turn(&self, k: usize, length: S, at: &mut Point<S>) {
        let l = self.momenta.axis[k];
        let angle = length * self.momenta.mobility[k] * (at.momentum[k] - l * at.rotor.momentum);
        let half = angle.half().circle();
        at.momentum = turned_about(at.momentum, k, half);
        at.vertical = turned_about(at.vertical, k, half);
        at.rotor.angle -= l * angle;
        if k == 0 {
            self.drift(length, at);
        }
    }

    /// The flow of the square along n.
    pub fn turn_oblique(&self, length: S, at: &mut Point<S>) {
        let y = at.momentum - self.momenta.axis * at.rotor.momentum;
        let angle = length * self.oblique_mobility * self.unit.dot(&y);
        let half = angle.half().circle();
        at.momentum = turned_along(at.momentum, self.unit, half);
        at.vertical = turned_along(at.vertical, self.unit, half);
        at.rotor.angle -= self.momenta.axis.dot(&self.unit) * angle;
    }

    /// The flow at constant v and g: the weight changes x, the machine changes the rest. Returns the residual of the
    /// equation that is solved by iteration.
    #[inline]
    pub fn push<P: Base, A: FixedAngleMachine<P, S>>(&self, machine: &A, by: &Kick<S>, at: &mut Point<S>) -> S
    where
        S: Over<P>,
    {
        let torque = self.momenta.weight.cross(&at.vertical);
        let mut left = S::zero();
        if machine.machine().rotor() != RotorState::Prescribed {
            let (_, slip) = self.velocities(at);
            let pull = -self.momenta.axis.dot(&self.angular_velocity(torque));
            left = kick(machine, by, slip, pull, &mut at.rotor);
        }
        at.momentum += torque * by.length;
        left
    }

    /// The flow of a part of H, where part 0 is the flow at constant v and g and the squares follow. Returns the
    /// residual of the iteration, as [`push`](Self::push) does.
    #[inline]
    pub fn flow<P: Base, A: FixedAngleMachine<P, S>>(
        &self,
        machine: &A,
        piece: usize,
        substep: &Substep<S>,
        at: &mut Point<S>,
    ) -> S
    where
        S: Over<P>,
    {
        match (piece, substep) {
            (_, Substep::Push(kick)) => return self.push(machine, kick, at),
            (1, Substep::Turn(length)) => self.turn(0, *length, at),
            (2, Substep::Turn(length)) => self.turn(1, *length, at),
            (3, Substep::Turn(length)) => self.turn(2, *length, at),
            (_, Substep::Turn(length)) => self.turn_oblique(*length, at),
        }
        S::zero()
    }

    /// The point for a state (w, v, rotor, currents) of the law.
    pub fn enter<P: Base>(&self, form: &impl Form<P>, machine: &impl Machine<P>, y: &[S]) -> Point<S>
    where
        S: Over<P>,
    {
        let (w, vertical) = (Vector3::new(y[0], y[1], y[2]), Vector3::new(y[3], y[4], y[5]));
        let known = machine.rotor();
        let (rotor, currents) = y[6..].split_at(known.dimension());
        let (_, slip) = known.angle_and_slip(rotor);
        let rotor_speed = slip + self.frame_speed;
        let absolute = if known == RotorState::Prescribed { S::zero() } else { w.dot(&self.momenta.axis) };
        Point {
            momentum: form.momentum(w, rotor_speed),
            vertical,
            rotor: RotorPoint::enter(machine, rotor, self.momenta.axial * (absolute + rotor_speed), currents),
        }
    }

    /// The state of the law for a point.
    #[inline]
    pub fn leave<P: Base, A: FixedAngleMachine<P, S>>(&self, machine: &A, at: &Point<S>, y: &mut [S])
    where
        S: Over<P>,
    {
        let (w, slip) = self.velocities(at);
        for k in 0..3 {
            y[k] = w[k];
            y[3 + k] = at.vertical[k];
        }
        at.rotor.leave(machine, slip, &mut y[6..]);
    }
}

/// The sub-flows of a gyrostat with a machine: the flow at constant v and g, then the squares.
#[derive(Clone, Debug)]
pub struct GyrostatPieces<'a, S: Scalar, F, M> {
    form: &'a F,
    machine: &'a M,
    acting: Programmed<'a, S, M>,
    flows: Flows<S>,
    law: Law,
    rule: Rule<S>,
    decay_rates: DecayRates<S>,
}

impl<S: Real + Running, F: Form<f64>, M: Machine<f64>> Pieces<S> for GyrostatPieces<'_, S, F, M> {
    type Point = Point<S>;
    type Substep = Substep<S>;

    fn pieces(&self) -> usize {
        1 + self.flows.squares()
    }

    fn enter(&self, y: &[S]) -> Point<S> {
        self.flows.enter(self.form, self.machine, y)
    }

    fn leave(&self, point: &Point<S>, y: &mut [S]) {
        self.flows.leave(&self.acting, point, y);
    }

    fn substep(&self, piece: usize, length: S) -> Substep<S> {
        if piece > 0 {
            return Substep::Turn(length);
        }
        let compliance = self.flows.compliance();
        Substep::Push(Kick::new(self.machine, self.law, length, compliance, decay_quotient, self.rule))
    }

    fn decay_rate(&self, point: &Point<S>) -> f64 {
        if self.machine.rotor() == RotorState::Prescribed {
            return 0.0;
        }
        let (_, slip) = self.flows.velocities(point);
        self.decay_rates.fastest(self.machine, slip)
    }

    #[inline]
    fn flow(&self, piece: usize, substep: &Substep<S>, point: &mut Point<S>) -> bool {
        solved(self.flows.flow(&self.acting, piece, substep, point))
    }
}

/// The data of a sub-flow that depend on the time step.
#[derive(Clone, Debug)]
pub enum Substep<S> {
    Push(Kick<S>),
    Turn(S),
}

impl<F: Form<f64>, M: Machine<f64>> Driven<f64, F, M> {
    /// The sub-flows, with compiled programs if these are given; `None` if the flow of the [`Kick`] is not known.
    pub fn in_momenta<'a, S: Real>(&'a self, programs: Option<&'a Programs>) -> Option<GyrostatPieces<'a, S, F, M>> {
        let Driven { form, machine, .. } = self;
        let flows = Flows::new(form, machine);
        has_known_flow(machine).then(|| {
            let law = Law::of(machine);
            let (acting, decay_rates) =
                (Programmed::new(machine, programs), DecayRates::of(machine, law, flows.compliance()));
            GyrostatPieces { form, machine, acting, flows, law, rule: Rule::gauss(), decay_rates }
        })
    }
}

impl<F: Form<f64>, M: Machine<f64> + Sync> Separable for Driven<f64, F, M> {
    fn programs(&self) -> Programs {
        Programs::of(&self.machine)
    }

    fn pieces_by<'a, S: Real + Running>(&'a self, programs: Option<&'a Programs>) -> Option<impl Pieces<S> + 'a> {
        self.in_momenta(programs)
    }
}
