//! The equations of motion, solved for the accelerations, in two sets of axes.
//!
//! Let x be the angular momentum about O, and Ge the vector of the weight:
//!
//! | form | axes | momentum | equations |
//! |---|---|---|---|
//! | first | principal axes of A | x = A w + A' p' l, p' = w.l + phi' | A w' = x x w + Ge x v - M l |
//! | second | principal axes of A* | x = A* w + A' phi' l | A* w' + A' phi'' l = x x w + Ge x v |
//!
//! In both forms A' (l.w' + phi'') = M. The second form divides by D = 1 - A' l.(A*^-1 l).

use super::Gyrostat;
use super::momenta::Momenta;
use super::tensors::Principal;
use super::vectors::{by_component, dot, less, less_dot, lift, plus, two_crosses};
use field::{Base, Divisor, Over, Scalar};
use nalgebra::{Matrix3, Vector3};

/// A form of the equations of motion, solved for the accelerations; its data refer to its own axes.
pub trait Form<P: Base> {
    /// The accelerations (w', phi'') under the torque M on the rotor.
    fn accelerations<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S, torque: S) -> (Vector3<S>, S);

    /// The acceleration w' at constant rotor speed (phi'' = 0), and the torque M that is necessary for it.
    fn prescribed<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S) -> (Vector3<S>, S);

    /// The angular momentum x about O.
    fn momentum<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> Vector3<S>;

    /// The mechanical energy T - Ge.v.
    fn energy<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S) -> S;

    /// The data of the Hamiltonian, as a function of the momenta; `kept`: the rotor's speed is prescribed.
    fn momenta(&self, kept: bool) -> Momenta<P>;
}

/// The data of a form, in its own axes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Data<P: Scalar> {
    /// The principal moments of the form's tensor.
    moments: Vector3<P>,
    /// Their reciprocals.
    mobility: Vector3<P>,
    /// The unit vector l of the rotor's axis.
    axis: Vector3<P>,
    /// The rotor's moment of inertia A' about its axis.
    axial: Divisor<P>,
    /// The vector Gamma e of the weight.
    weight: Vector3<P>,
}

impl<P: Base> Data<P> {
    fn new(moments: Vector3<P>, axis: Vector3<P>, axial: P, weight: Vector3<P>) -> Self {
        let mobility = moments.map(|a| P::one() / a);
        Data { moments, mobility, axis, axial: Divisor::new(axial), weight }
    }

    /// The rate x x w + Ge x v of the form's momentum in the rotating axes.
    #[inline(always)]
    fn gain<S: Over<P>>(&self, momentum: Vector3<S>, w: Vector3<S>, v: Vector3<S>) -> Vector3<S> {
        two_crosses(momentum, w, lift(self.weight), v)
    }
}

/// The paper's first form, in the principal axes of A.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstForm<P: Scalar> {
    data: Data<P>,
    /// The factor 1 / (1/A' + l.(A^-1 l)), by which the other torques determine the torque that a prescribed speed
    /// requires.
    reaction: P,
}

/// The paper's second form, in the principal axes of A*.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondForm<P: Scalar> {
    data: Data<P>,
    /// The vector A*^-1 l.
    response: Vector3<P>,
    /// The factor 1 / D.
    inverse_d: P,
}

impl<P: Base> FirstForm<P> {
    /// The form from the principal moments of A and the vectors l, Ge in its principal axes.
    pub fn new(moments: Vector3<P>, axis: Vector3<P>, axial: P, weight: Vector3<P>) -> Self {
        let data = Data::new(moments, axis, axial, weight);
        let reaction = P::one() / (P::one() / axial + axis.dot(&axis.component_mul(&data.mobility)));
        FirstForm { data, reaction }
    }
}

impl<P: Base> SecondForm<P> {
    /// The form from the principal moments of A* and the vectors l, Ge in its principal axes.
    pub fn new(moments: Vector3<P>, axis: Vector3<P>, axial: P, weight: Vector3<P>) -> Self {
        let data = Data::new(moments, axis, axial, weight);
        let response = axis.component_mul(&data.mobility);
        SecondForm { data, response, inverse_d: P::one() / (P::one() - axial * axis.dot(&response)) }
    }
}

impl<P: Base> Form<P> for FirstForm<P> {
    #[inline(always)]
    fn accelerations<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S, torque: S) -> (Vector3<S>, S) {
        let axis = lift(self.data.axis);
        let free = less(self.data.gain(self.momentum(w, rotor_speed), w, v), axis, torque);
        let w_rate = by_component(free, lift(self.data.mobility));
        (w_rate, less_dot(torque.divided_by(self.data.axial), axis, w_rate))
    }

    #[inline(always)]
    fn prescribed<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S) -> (Vector3<S>, S) {
        let (free, free_rotor) = self.accelerations(w, v, rotor_speed, S::zero());
        let torque = -free_rotor * S::lift(self.reaction);
        let oblique = by_component(self.data.axis, self.data.mobility);
        (less(free, lift(oblique), torque), torque)
    }

    #[inline(always)]
    fn momentum<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> Vector3<S> {
        let axis = lift(self.data.axis);
        let absolute_spin = dot(w, axis) + rotor_speed;
        plus(by_component(w, lift(self.data.moments)), axis, S::lift(self.data.axial.value()) * absolute_spin)
    }

    fn energy<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S) -> S {
        let absolute_spin = w.dot(&self.data.axis.map(S::lift)) + rotor_speed;
        let own = w.dot(&w.component_mul(&self.data.moments.map(S::lift)));
        let spin = S::lift(self.data.axial.value()) * absolute_spin * absolute_spin;
        (own + spin).half() - self.data.weight.map(S::lift).dot(&v)
    }

    /// For a prescribed speed A*^-1 = A^-1 - n n^T / (1/A' + l.n) with n = A^-1 l (Sherman and Morrison).
    fn momenta(&self, kept: bool) -> Momenta<P> {
        let Data { mobility, axis, axial, weight, .. } = self.data;
        let oblique = axis.component_mul(&mobility);
        Momenta {
            mobility,
            oblique,
            share: if kept { -self.reaction } else { P::zero() },
            axis,
            axial: axial.value(),
            weight,
        }
    }
}

impl<P: Base> Form<P> for SecondForm<P> {
    #[inline(always)]
    fn accelerations<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S, torque: S) -> (Vector3<S>, S) {
        let axial = S::lift(self.data.axial.value());
        let response = lift(self.response);
        let free = self.data.gain(self.momentum(w, rotor_speed), w, v);
        let rotor_acceleration = less_dot(torque.divided_by(self.data.axial), response, free) * S::lift(self.inverse_d);
        let w_rate = less(by_component(free, lift(self.data.mobility)), response, axial * rotor_acceleration);
        (w_rate, rotor_acceleration)
    }

    #[inline(always)]
    fn prescribed<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S) -> (Vector3<S>, S) {
        let free = self.data.gain(self.momentum(w, rotor_speed), w, v);
        let w_rate = by_component(free, lift(self.data.mobility));
        (w_rate, S::lift(self.data.axial.value()) * dot(w_rate, lift(self.data.axis)))
    }

    #[inline(always)]
    fn momentum<S: Over<P>>(&self, w: Vector3<S>, rotor_speed: S) -> Vector3<S> {
        let own = by_component(w, lift(self.data.moments));
        plus(own, lift(self.data.axis), S::lift(self.data.axial.value()) * rotor_speed)
    }

    fn energy<S: Over<P>>(&self, w: Vector3<S>, v: Vector3<S>, rotor_speed: S) -> S {
        let own = w.dot(&w.component_mul(&self.data.moments.map(S::lift)));
        let axial = S::lift(self.data.axial.value());
        let mixed = axial * rotor_speed * w.dot(&self.data.axis.map(S::lift));
        (own + axial * rotor_speed * rotor_speed).half() + mixed - self.data.weight.map(S::lift).dot(&v)
    }

    /// For a free rotor A^-1 = A*^-1 + (A'/D) n n^T with n = A*^-1 l (Sherman and Morrison).
    fn momenta(&self, kept: bool) -> Momenta<P> {
        let Data { mobility, axis, axial, weight, .. } = self.data;
        let share = if kept { P::zero() } else { axial.value() * self.inverse_d };
        Momenta { mobility, oblique: self.response, share, axis, axial: axial.value(), weight }
    }
}

impl Gyrostat<f64> {
    /// The first form, and its axes (columns) in the axes of the data.
    pub fn first_form(&self) -> (FirstForm<f64>, Matrix3<f64>) {
        let principal = self.derived().reduced;
        let (moments, axis, axial, weight) = self.form_data(&principal);
        (FirstForm::new(moments, axis, axial, weight), principal.axes)
    }

    /// The second form, and its axes (columns) in the axes of the data.
    pub fn second_form(&self) -> (SecondForm<f64>, Matrix3<f64>) {
        let principal = self.derived().full;
        let (moments, axis, axial, weight) = self.form_data(&principal);
        (SecondForm::new(moments, axis, axial, weight), principal.axes)
    }

    /// The data of a form: the principal moments of its tensor, and l, A', Ge in its principal axes.
    pub fn form_data(&self, principal: &Principal) -> (Vector3<f64>, Vector3<f64>, f64, Vector3<f64>) {
        let own = self.in_axes(&principal.axes);
        (principal.moments, own.rotor.axis, own.rotor.axial, own.weight())
    }
}
