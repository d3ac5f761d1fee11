//! The gyrostat driven by a motor, as a system of first-order equations.

use super::forms::Form;
use super::vectors::cross;
use field::{Analytic, Base, Batch, Over, Tangent};
use integrators::Ode;
use motor::{
    Circuit, Machine, Powered, RotorState, state_names, stored_energy, supplied_power, torque_and_circuit_rates,
};
use nalgebra::Vector3;
use std::marker::PhantomData;

/// A form of the equations of motion, combined with a machine. The state is (w, v, rotor, currents) in the axes of the
/// form; the rotor's part is (g, g'), (g') or empty, depending on [`RotorState`].
#[derive(Clone, Debug)]
pub struct Driven<P, F, M> {
    pub form: F,
    pub machine: M,
    circuits: Vec<Circuit<P>>,
    field: PhantomData<P>,
}

impl<P: Base, F: Form<P>, M: Machine<P>> Driven<P, F, M> {
    /// Combines a form and a machine.
    pub fn new(form: F, machine: M) -> Self {
        let circuits = (0..machine.windings()).map(|k| Circuit::of(&machine, k)).collect();
        Driven { form, machine, circuits, field: PhantomData }
    }

    /// The number of components of the state: 6, the rotor's, and the currents.
    pub fn dimension(&self) -> usize {
        6 + self.machine.rotor().dimension() + self.machine.windings()
    }

    /// The names of the components of the state, in order.
    pub fn names(&self) -> Vec<String> {
        let mut names: Vec<String> = ["w1", "w2", "w3", "v1", "v2", "v3"].map(String::from).into();
        names.extend(state_names(&self.machine));
        names
    }

    /// The right-hand side of the equations. It allocates no memory.
    #[inline(always)]
    pub fn rates<S: Over<P> + Analytic>(&self, y: &[S], dy: &mut [S]) {
        self.rates_under(S::zero(), y, dy);
    }

    /// The right-hand side under a load torque, N m, between carrier and rotor, opposite to the rotor's rotation.
    #[inline(always)]
    pub fn rates_under<S: Over<P> + Analytic>(&self, load: S, y: &[S], dy: &mut [S]) {
        let (w, v) = (Vector3::new(y[0], y[1], y[2]), Vector3::new(y[3], y[4], y[5]));
        let known = self.machine.rotor();
        let rotor_end = 6 + known.dimension();
        let (angle, slip) = known.angle_and_slip(&y[6..rotor_end]);
        let rotor_speed = slip + S::lift(self.machine.frame_speed());
        let (mechanical, current_rates) = dy.split_at_mut(rotor_end);
        let circuits = self.circuits.iter().copied();
        let torque =
            torque_and_circuit_rates(&self.machine, circuits, angle, slip, &y[rotor_end..], current_rates) - load;
        let w_rate = if known == RotorState::Prescribed {
            self.form.prescribed(w, v, rotor_speed).0
        } else {
            let (w_rate, rotor_acceleration) = self.form.accelerations(w, v, rotor_speed, torque);
            known.write(slip, rotor_acceleration, &mut mechanical[6..]);
            w_rate
        };
        let v_rate = cross(v, w);
        for i in 0..3 {
            mechanical[i] = w_rate[i];
            mechanical[3 + i] = v_rate[i];
        }
    }

    /// The square v.v, which is constant and equal to 1.
    pub fn vertical_length<S: Over<P>>(&self, y: &[S]) -> S {
        let v = Vector3::new(y[3], y[4], y[5]);
        v.dot(&v)
    }

    /// The angular momentum x.v about the vertical, which is conserved with every machine.
    pub fn vertical_momentum<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let v = Vector3::new(y[3], y[4], y[5]);
        self.form.momentum(Vector3::new(y[0], y[1], y[2]), self.rotor_speed(y)).dot(&v)
    }

    /// The energy of bodies, weight and circuits.
    pub fn energy<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let known = self.machine.rotor();
        let rotor_end = 6 + known.dimension();
        let (w, v) = (Vector3::new(y[0], y[1], y[2]), Vector3::new(y[3], y[4], y[5]));
        let (angle, _) = known.angle_and_slip(&y[6..rotor_end]);
        self.form.energy(w, v, self.rotor_speed(y)) + stored_energy(&self.machine, angle, &y[rotor_end..])
    }

    /// The rotor's angular momentum about its axis, p = dE/dphi' = A' (w.l + phi').
    pub fn rotor_momentum<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let (w, v) = (Vector3::new(y[0], y[1], y[2]), Vector3::new(y[3], y[4], y[5]));
        let speed = Tangent::variable(self.rotor_speed(y));
        self.form.energy(w.map(Tangent::fixed), v.map(Tangent::fixed), speed).slope
    }

    /// The energy E - W p in the frame of the stator's field: without a supply and sliding contacts its loss is the
    /// heat.
    pub fn jacobi<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        self.energy(y) - S::lift(self.machine.frame_speed()) * self.rotor_momentum(y)
    }

    /// The rotor's relative speed phi' = g' + W.
    pub fn rotor_speed<S: Over<P> + Analytic>(&self, y: &[S]) -> S {
        let known = self.machine.rotor();
        let (_, slip) = known.angle_and_slip(&y[6..6 + known.dimension()]);
        slip + S::lift(self.machine.frame_speed())
    }
}

impl<S: Over<f64> + Analytic, F: Form<f64>, M: Machine<f64>> Ode<S> for Driven<f64, F, M> {
    fn dimension(&self) -> usize {
        Driven::dimension(self)
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        Driven::rates(self, y, dy);
    }
}

impl<F: Form<f64>, M: Machine<f64>> Powered for Driven<f64, F, M> {
    fn dimension(&self) -> usize {
        Driven::dimension(self)
    }

    fn rates<S: Over<f64> + Analytic>(&self, y: &[S], dy: &mut [S]) {
        Driven::rates(self, y, dy);
    }

    fn jacobi<S: Over<f64> + Analytic>(&self, y: &[S]) -> S {
        Driven::jacobi(self, y)
    }

    fn power<S: Over<f64> + Analytic>(&self, y: &[S]) -> S {
        supplied_power(&self.machine, &y[6..])
    }
}

/// A batch of gyrostats, each with its own data.
impl<const L: usize, const FUSED: bool, F, M> Ode<Batch<L, FUSED>> for Driven<Batch<L, FUSED>, F, M>
where
    F: Form<Batch<L, FUSED>>,
    M: Machine<Batch<L, FUSED>>,
{
    fn dimension(&self) -> usize {
        Driven::dimension(self)
    }

    #[inline(always)]
    fn rates(&self, _t: Batch<L, FUSED>, y: &[Batch<L, FUSED>], dy: &mut [Batch<L, FUSED>]) {
        Driven::rates(self, y, dy);
    }
}
