//! A step of a gyrostat in the coordinates of `Surface`, over floats and over Taylor models, its motor forgotten.

use super::surface::{Step, Surface};
use crate::ladder::Lumped;
use crate::machines::{Kick, Law, Machine, Quantity, Rule, Source, decay_quotient, text::Laws};
use crate::scene::{MachineData, NoModel};
use crate::systems::gyrostat::forms::SecondForm;
use crate::systems::gyrostat::momenta::{Flows, Lapse, Point};
use field::{Analytic, Base, Over, Rational, Scalar, Tangent};
use integrators::Splitting;
use std::sync::Arc;
use symbolic::real::{Ordered, TaylorModel};

/// A step of a length, s, over both fields.
pub(super) trait Steps {
    fn over_floats(&self, splitting: Splitting, step: f64) -> Box<Step<'_, Tangent<f64>>>;
    fn over_models(&self, splitting: Splitting, step: &TaylorModel) -> Box<Step<'_, Tangent<TaylorModel>>>;
    /// From a state that every piece keeps: its enclosure does not widen on the way.
    fn at_rest(&self, splitting: Splitting, step: &TaylorModel) -> Box<Step<'_, Tangent<TaylorModel>>>;
}

/// The same gyrostat with its data in both fields.
pub(super) struct Both<M, N> {
    pub floats: OnSurface<f64, M>,
    pub models: OnSurface<TaylorModel, N>,
}

/// A form with a motor on the surface of the integrals.
pub(super) struct OnSurface<P: Base, M> {
    pub form: SecondForm<P>,
    pub machine: Lumped<P, M>,
    pub surface: Surface<P>,
}

impl<P: Base, M: Machine<P>> OnSurface<P, M> {
    fn step<'a, S: Over<P> + Over<f64> + Analytic>(
        &'a self,
        splitting: Splitting,
        step: S,
        asked: Asked<S>,
    ) -> Box<Step<'a, S>> {
        let Asked { quotient, positive, between } = asked;
        let flows = Flows::<S>::new(&self.form, &self.machine);
        // a moment that is linear needs no collocation
        let rule = Rule { nodes: [S::zero(); 4], weights: [S::zero(); 4], matrix: [[S::zero(); 4]; 4] };
        let lapse = |(piece, share): (usize, f64)| {
            let length = step * <S as Over<f64>>::lift(share);
            let of_push = || Kick::new(&self.machine, Law::Linear, length, flows.compliance(), quotient, rule);
            (piece, if piece == 0 { Lapse::Push(of_push()) } else { Lapse::Turn(length) })
        };
        let schedule = splitting.schedule::<f64>(1 + flows.squares());
        let lapses: Vec<(usize, Lapse<S>)> = schedule.into_iter().map(lapse).collect();
        Box::new(move |at| {
            let start = self.surface.point(at)?;
            let mut point = start.clone();
            for (piece, lapse) in &lapses {
                flows.flow(&self.machine, *piece, lapse, &mut point);
                between(&start, &mut point);
            }
            self.surface.coordinates(&point, positive)
        })
    }
}

/// What a step wants to know of its field.
struct Asked<S: Scalar> {
    /// (exp(-a) - exp(-b))/(b - a)
    quotient: fn(S, S) -> S,
    positive: fn(&S) -> bool,
    /// Done after each flow, from the start.
    between: fn(&Point<S>, &mut Point<S>),
}

fn of_models() -> Asked<Tangent<TaylorModel>> {
    let quotient = |a: Tangent<TaylorModel>, b: Tangent<TaylorModel>| {
        let known = TaylorModel::between_decays(&a.value, &b.value);
        Tangent::fixed(known.unwrap_or(TaylorModel::constant(f64::NAN)))
    };
    Asked { quotient, positive: |x| x.value.sign() == Some(1), between: |_, _| {} }
}

/// Puts the values of a state that rests back; the slopes stay.
fn hold(rest: &Point<Tangent<TaylorModel>>, at: &mut Point<Tangent<TaylorModel>>) {
    at.momentum.zip_apply(&rest.momentum, |moved, rest| moved.value = rest.value);
    at.vertical.zip_apply(&rest.vertical, |moved, rest| moved.value = rest.value);
    at.rotor.angle.value = rest.rotor.angle.value;
    at.rotor.momentum.value = rest.rotor.momentum.value;
    at.rotor.fluxes.iter_mut().zip(&rest.rotor.fluxes).for_each(|(moved, rest)| moved.value = rest.value);
}

impl<M: Machine<f64>, N: Machine<TaylorModel>> Steps for Both<M, N> {
    fn over_floats(&self, splitting: Splitting, step: f64) -> Box<Step<'_, Tangent<f64>>> {
        let quotient = |a: Tangent<f64>, b: Tangent<f64>| Tangent::fixed(decay_quotient(a.value, b.value));
        let asked = Asked { quotient, positive: |x: &Tangent<f64>| x.value > 0.0, between: |_, _| {} };
        self.floats.step(splitting, Tangent::fixed(step), asked)
    }

    fn over_models(&self, splitting: Splitting, step: &TaylorModel) -> Box<Step<'_, Tangent<TaylorModel>>> {
        self.models.step(splitting, Tangent::fixed(*step), of_models())
    }

    fn at_rest(&self, splitting: Splitting, step: &TaylorModel) -> Box<Step<'_, Tangent<TaylorModel>>> {
        self.models.step(splitting, Tangent::fixed(*step), Asked { between: hold, ..of_models() })
    }
}

/// The data of a machine, its decimals enclosed.
pub(super) struct Enclosed<'a>(pub &'a MachineData, pub &'static str);

impl Source<TaylorModel> for Enclosed<'_> {
    type Error = NoModel;

    fn quantity(&mut self, quantity: &Quantity) -> Result<TaylorModel, NoModel> {
        let decimal = Rational::decimal(self.0.number(self.1, quantity)?);
        Ok(TaylorModel::constant(0.0).fraction(decimal).unwrap_or(TaylorModel::constant(f64::NAN)))
    }

    fn count(&mut self, name: &'static str, meaning: &'static str) -> Result<usize, NoModel> {
        self.0.count(self.1, name, meaning)
    }

    fn laws(&mut self) -> Option<Arc<Laws>> {
        self.0.laws.clone()
    }
}
