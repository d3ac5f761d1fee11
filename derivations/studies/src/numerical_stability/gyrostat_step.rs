//! A step of a gyrostat in the coordinates of `Surface`, over floats, Taylor models and enclosed numbers.

use super::casimir_leaf::{Step, Surface};
use crate::model_reduction::Lumped;
use algebra::real::{Model, Ordered, Rounded};
use field::{Analytic, Base, Over, Rational, Scalar, Tangent};
use integrators::Splitting;
use motor::{Kick, Law, Motor, Rule, decay_quotient};
use systems::gyrostat::forms::SecondForm;
use systems::gyrostat::momenta::{Flows, Point, Substep};

/// The operations of a scalar type that a step needs beyond arithmetic.
pub(super) trait Decaying: Base + Over<f64> + Analytic {
    /// The quotient (exp(-a) - exp(-b))/(b - a).
    fn between_decays(a: Self, b: Self) -> Self;
    /// Whether the number is known to be positive.
    fn is_positive(&self) -> bool;
}

impl Decaying for f64 {
    fn between_decays(a: f64, b: f64) -> f64 {
        decay_quotient(a, b)
    }

    fn is_positive(&self) -> bool {
        *self > 0.0
    }
}

impl<C: Rounded, const N: usize> Decaying for Model<C, N> {
    fn between_decays(a: Self, b: Self) -> Self {
        Model::between_decays(&a, &b).unwrap_or(Self::constant(f64::NAN))
    }

    fn is_positive(&self) -> bool {
        self.sign() == Some(1)
    }
}

/// A form with a motor on the surface of the integrals.
pub(super) struct OnSurface<P: Base> {
    pub form: SecondForm<P>,
    pub machine: Lumped<P, Motor<P>>,
    pub surface: Surface<P>,
    pub law: Law,
    /// The collocation rule for a nonlinear torque, with the floats of the run.
    pub rule: Rule<f64>,
}

impl<P: Decaying> OnSurface<P> {
    /// A step of a given length, s. `rests`: the state is an equilibrium of every sub-flow, and its enclosure is not
    /// widened by the flows.
    pub fn step(&self, splitting: Splitting, length: P, rests: bool) -> Box<Step<'_, Tangent<P>>> {
        let quotient = |a: Tangent<P>, b: Tangent<P>| Tangent::fixed(P::between_decays(a.value, b.value));
        let flows = Flows::<Tangent<P>>::new(&self.form, &self.machine);
        let number = <Tangent<P> as Over<f64>>::lift;
        let Rule { nodes, weights, matrix } = self.rule;
        let rule =
            Rule { nodes: nodes.map(number), weights: weights.map(number), matrix: matrix.map(|row| row.map(number)) };
        let substep = |(piece, share): (usize, f64)| {
            let length = Tangent::fixed(length) * number(share);
            let of_push = || Kick::new(&self.machine, self.law, length, flows.compliance(), quotient, rule);
            (piece, if piece == 0 { Substep::Push(of_push()) } else { Substep::Turn(length) })
        };
        let schedule = splitting.schedule::<f64>(1 + flows.squares());
        let lapses: Vec<(usize, Substep<Tangent<P>>)> = schedule.into_iter().map(substep).collect();
        Box::new(move |at| {
            let start = self.surface.point(at)?;
            let mut point = start.clone();
            for (piece, substep) in &lapses {
                flows.flow(&self.machine, *piece, substep, &mut point);
                if rests {
                    hold(&start, &mut point);
                }
            }
            self.surface.coordinates(&point, |x| x.value.is_positive())
        })
    }
}

/// Restores the values of an equilibrium, but not the derivatives.
fn hold<P: Scalar>(rest: &Point<Tangent<P>>, at: &mut Point<Tangent<P>>) {
    at.momentum.zip_apply(&rest.momentum, |moved, rest| moved.value = rest.value);
    at.vertical.zip_apply(&rest.vertical, |moved, rest| moved.value = rest.value);
    at.rotor.angle.value = rest.rotor.angle.value;
    at.rotor.momentum.value = rest.rotor.momentum.value;
    at.rotor.fluxes.iter_mut().zip(&rest.rotor.fluxes).for_each(|(moved, rest)| moved.value = rest.value);
}

/// The enclosure of a fraction; an undefined one is unbounded.
pub(super) fn enclosed<C: Rounded, const N: usize>(value: Rational) -> Model<C, N> {
    Model::constant(0.0).fraction(value).unwrap_or(Model::constant(f64::NAN))
}
