//! Coordinates on the Casimir leaf |v| = 1, x.v = P, which a gyrostat's steps preserve.
//!
//! Every flow conserves v.v and x.v. Their gradients are left eigenvectors of the matrix of a step at a fixed point: two
//! multipliers are exactly one at every step size, and the others belong to the leaf. With v_a the largest component of v and b, c
//! the next indices, the coordinates are
//!
//!   (x_b, x_c, v_b, v_c) ,    v_a = +-(1 - v_b^2 - v_c^2)^1/2 ,    x_a = (P - x_b v_b - x_c v_c)/v_a ,
//!
//! followed by g, p and the fluxes if they are states. A conserved rotor momentum p gives one more unit multiplier, and
//! is no coordinate.

use field::{Analytic, Base, Over, Scalar};
use motor::{Conserved, Machine, Point as RotorPoint, RotorState};
use nalgebra::Vector3;
use systems::gyrostat::forms::Form;
use systems::gyrostat::momenta::{Flows, Point};

/// A step in these coordinates; `None` where it leaves the half of the leaf on which they are defined.
pub(super) type Step<'a, S> = dyn Fn(&[S]) -> Option<Vec<S>> + 'a;

/// The leaf with given values of the integrals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Surface<P> {
    /// The index a of the largest component of v; `upwards` is its sign.
    largest: usize,
    upwards: bool,
    /// The angular momentum about the vertical P = x.v.
    along: P,
    /// The rotor momentum p, if conserved.
    kept: Option<P>,
    knows_angle: bool,
}

impl Surface<f64> {
    /// The leaf through a state (w, v, rotor, ..) of the law.
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

    /// The coordinates of a state of the law, without currents.
    pub fn start(&self, form: &impl Form<f64>, machine: &impl Machine<f64>, state: &[f64]) -> Vec<f64> {
        self.chosen(&entered(form, machine, state))
    }

    /// The leaf with its data in another scalar type.
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
    /// The state with these coordinates; `None` where coordinates are missing.
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

    /// The coordinates of a state on the leaf; `None` where v_a may have the other sign. `positive` tests a number.
    pub fn coordinates<S: Scalar>(&self, point: &Point<S>, positive: fn(&S) -> bool) -> Option<Vec<S>> {
        let size = point.vertical[self.largest];
        positive(&if self.upwards { size } else { -size }).then(|| self.chosen(point))
    }

    /// The components that are coordinates, of a state or of a deviation.
    pub fn chosen<S: Scalar>(&self, point: &Point<S>) -> Vec<S> {
        let Point { momentum, vertical, rotor } = point;
        let [b, c] = [1, 2].map(|k| (self.largest + k) % 3);
        let carrier = [momentum[b], momentum[c], vertical[b], vertical[c]];
        let angle = self.knows_angle.then_some(rotor.angle);
        let spin = self.kept.is_none().then_some(rotor.momentum);
        carrier.into_iter().chain(angle).chain(spin).chain(rotor.fluxes.iter().copied()).collect()
    }
}
