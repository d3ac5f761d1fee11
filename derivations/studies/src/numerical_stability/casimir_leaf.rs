//! The surface |v| = 1, x.v = P on which a gyrostat's steps stay, in coordinates.
//!
//! Every flow keeps v.v and x.v, so that of the matrix of a step at a fixed point their gradients are left eigenvectors: two
//! multipliers are exactly one, whatever the step, and those on the surface are the others. With v_a the largest component of v, its
//! neighbours b and c, the coordinates are
//!
//!   (x_b, x_c, v_b, v_c) ,    v_a = +-(1 - v_b^2 - v_c^2)^1/2 ,    x_a = (P - x_b v_b - x_c v_c)/v_a ,
//!
//! then g, p and the fluxes as far as they are states. A rotor that nothing moves keeps p: that is one more multiplier, and no
//! coordinate.

use field::{Analytic, Base, Over, Scalar};
use motor::{Conserved, Machine, Point as RotorPoint, RotorState};
use nalgebra::Vector3;
use systems::gyrostat::forms::Form;
use systems::gyrostat::momenta::{Flows, Point};

/// A step in these coordinates; `None` where it leads off the half on which they hold.
pub(super) type Step<'a, S> = dyn Fn(&[S]) -> Option<Vec<S>> + 'a;

/// Where the integrals have their values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Surface<P> {
    /// a, and the sign of v_a
    largest: usize,
    upwards: bool,
    /// P
    along: P,
    /// p where it is kept
    kept: Option<P>,
    knows_angle: bool,
}

impl Surface<f64> {
    /// Through a state (w, v, rotor, ..) of the law.
    pub fn at(form: &impl Form<f64>, machine: &impl Machine<f64>, state: &[f64]) -> Self {
        let Point { momentum, vertical, rotor } = entered(form, machine, state);
        let kept = machine.rotor() == RotorState::Prescribed || Conserved::by(machine).spin;
        Surface {
            largest: vertical.iamax(),
            upwards: vertical[vertical.iamax()] > 0.0,
            along: momentum.dot(&vertical),
            kept: kept.then_some(rotor.momentum),
            knows_angle: machine.rotor() == RotorState::AngleAndSpeed,
        }
    }

    /// The coordinates of that state, without currents.
    pub fn start(&self, form: &impl Form<f64>, machine: &impl Machine<f64>, state: &[f64]) -> Vec<f64> {
        self.chosen(&entered(form, machine, state))
    }

    /// The same with its data in another field.
    pub fn map<P>(&self, number: impl Fn(f64) -> P) -> Surface<P> {
        let Surface { largest, upwards, along, kept, knows_angle } = *self;
        Surface { largest, upwards, along: number(along), kept: kept.map(number), knows_angle }
    }
}

fn entered(form: &impl Form<f64>, machine: &impl Machine<f64>, state: &[f64]) -> Point<f64> {
    let mut state = state[..6 + machine.rotor().dimension()].to_vec();
    state.resize(state.len() + machine.windings(), 0.0);
    Flows::<f64>::new(form, machine).enter(form, machine, &state)
}

impl<P: Base> Surface<P> {
    /// The state with these coordinates; `None` where there are too few.
    pub fn point<S: Over<P> + Analytic>(&self, at: &[S]) -> Option<Point<S>> {
        let [a, b, c] = [0, 1, 2].map(|k| (self.largest + k) % 3);
        let (mut momentum, mut vertical) = (Vector3::repeat(S::zero()), Vector3::repeat(S::zero()));
        let (carrier, mut rotor) = at.split_at_checked(4)?;
        (momentum[b], momentum[c], vertical[b], vertical[c]) = (carrier[0], carrier[1], carrier[2], carrier[3]);
        let size = (S::one() - vertical[b].squared() - vertical[c].squared()).sqrt();
        vertical[a] = if self.upwards { size } else { -size };
        let across = momentum[b] * vertical[b] + momentum[c] * vertical[c];
        momentum[a] = (S::lift(self.along) - across) / vertical[a];
        let mut next = || rotor.split_off_first().copied();
        let angle = if self.knows_angle { next()? } else { S::zero() };
        let spin = if let Some(kept) = self.kept { S::lift(kept) } else { next()? };
        Some(Point { momentum, vertical, rotor: RotorPoint { angle, momentum: spin, fluxes: rotor.to_vec() } })
    }

    /// The coordinates of a state on the surface; `None` where v_a may have another sign. `positive`: whether a number is.
    pub fn coordinates<S: Scalar>(&self, point: &Point<S>, positive: fn(&S) -> bool) -> Option<Vec<S>> {
        let size = point.vertical[self.largest];
        positive(&if self.upwards { size } else { -size }).then(|| self.chosen(point))
    }

    /// The coordinates of a state, or of deviations.
    pub fn chosen<S: Scalar>(&self, point: &Point<S>) -> Vec<S> {
        let Point { momentum, vertical, rotor } = point;
        let [b, c] = [1, 2].map(|k| (self.largest + k) % 3);
        let carrier = [momentum[b], momentum[c], vertical[b], vertical[c]];
        let angle = self.knows_angle.then_some(rotor.angle);
        let spin = self.kept.is_none().then_some(rotor.momentum);
        carrier.into_iter().chain(angle).chain(spin).chain(rotor.fluxes.iter().copied()).collect()
    }
}
