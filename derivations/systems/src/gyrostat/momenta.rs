//! The gyrostat in its momenta: Hamilton's equations on se(3)* with a rotor, split into explicit sub-flows.
//!
//! With x the angular momentum about O, v the vertical, p = A' (w.l + phi') the rotor's spin and U(g) the energy of its
//! magnets in the field that turns with W,
//!
//!   H = 1/2 (x - p l).A^-1 (x - p l) + p^2/(2 A') - W p - Ge.v + U(g) ,
//!
//!   x' = x x dH/dx + v x dH/dv ,   v' = v x dH/dx ,   g' = dH/dp ,   p' = -dH/dg + friction .
//!
//! For any H, v.v and x.v are conserved (Casimir functions), and a torque between rotor and carrier changes neither. The sum
//! is split into squares (in an inertia tensor's principal axes: Reich 1994, McLachlan 1993):
//!
//! | term | flow |
//! |---|---|
//! | 1/2 m_k y_k^2, y = x - q l | x and v rotate about axis k with the constant speed m_k y_k, and g by -l_k times it |
//! | 1/2 s (n.y)^2 | the rotation about n, if the tensor is not diagonal in the form's axes |
//! | p^2/(2 A') - W p | g grows linearly; the term commutes with all others and is combined with one of them |
//! | -Ge.v + U(g) with windings and friction | v and g are constant; x, p and the currents change, see [`motor::Kick`] |
//!
//! Here q = p for a free rotor, and q = A' phi' for one with prescribed speed: then p is no variable, and x is the
//! total angular momentum less a constant along l.

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
    /// m_k
    pub mobility: Vector3<P>,
    /// n, of any length
    pub oblique: Vector3<P>,
    /// s, zero where three squares are enough
    pub share: P,
    /// l
    pub axis: Vector3<P>,
    /// A'
    pub axial: P,
    /// Ge
    pub weight: Vector3<P>,
}

/// The state of the sub-flows.
#[derive(Clone, Debug, PartialEq)]
pub struct Point<S: Scalar> {
    /// x
    pub momentum: Vector3<S>,
    /// v
    pub vertical: Vector3<S>,
    /// g, q and the fluxes
    pub rotor: RotorPoint<S>,
}

/// H over a field, with derived data, for its sub-flows.
#[derive(Clone, Copy, Debug)]
pub struct Flows<S: Scalar> {
    momenta: Momenta<S>,
    /// n / |n|, and s n.n
    unit: Vector3<S>,
    oblique_mobility: S,
    /// 1/A', and zero for a rotor with prescribed speed
    rotor_mobility: S,
    /// W
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

    /// d(g')/dp at fixed x: the response of the slip to an impulse on the rotor.
    pub fn compliance(&self) -> S {
        let l = self.momenta.axis;
        self.rotor_mobility + l.dot(&self.angular_velocity(l))
    }

    /// dH/dx, linear in y.
    fn angular_velocity(&self, y: Vector3<S>) -> Vector3<S> {
        y.component_mul(&self.momenta.mobility) + self.unit * (self.oblique_mobility * self.unit.dot(&y))
    }

    /// (w, g'); the slip of a rotor with prescribed speed has no meaning.
    pub fn velocities(&self, at: &Point<S>) -> (Vector3<S>, S) {
        let w = self.angular_velocity(at.momentum - self.momenta.axis * at.rotor.momentum);
        (w, at.rotor.momentum * self.rotor_mobility - self.frame_speed - w.dot(&self.momenta.axis))
    }

    /// The flow of p^2/(2 A') - W p, which is combined with the first square.
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

    /// The flow at constant v and g: the weight changes x, the machine the rest. Returns the residual of the equation that
    /// is solved by iteration.
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

    /// The flow of a piece, in the order push, squares. Returns the residual, as the push does.
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

    /// The point from a state (w, v, rotor, currents) of the law.
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

    /// The state of the law from a point.
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

/// The sub-flows of a gyrostat with a machine: the push, then the squares.
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

/// Data of a piece that depend on the time step.
#[derive(Clone, Debug)]
pub enum Substep<S> {
    Push(Kick<S>),
    Turn(S),
}

impl<F: Form<f64>, M: Machine<f64>> Driven<f64, F, M> {
    /// The sub-flows over a field, by programs if given; `None` where the flow of the [`Kick`] is not known.
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
