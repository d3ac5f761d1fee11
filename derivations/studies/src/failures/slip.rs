//! A slipping contact with a given direction of friction, without a check of the contact regime.

use field::{Analytic, Over, Scalar, Tangent};
use integrators::{JacobianFn, Ode};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Direction, Face, Mode, Seen};

use super::slopes::ByTangents;

/// The friction law, opposite to the sliding velocity v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Friction {
    /// Friction of slip in this direction, independent of v.
    Granted(Direction),
    /// The smoothed law -f N v/sqrt(v^2 + e^2).
    Sign { smooth: f64 },
}

/// A system with one closed contact, y = (x, x').
#[derive(Clone, Copy, Debug)]
pub struct Slip<Q, const N: usize, const C: usize> {
    pub system: Q,
    pub friction: Friction,
}

impl<Q: Contacts<N, C, 1, Given = f64>, const N: usize, const C: usize> Slip<Q, N, C> {
    /// Accelerations, and normal and tangential reactions; `None` where the constraints are dependent.
    pub fn motion<S: Over<f64> + Analytic>(&self, at: &State<S, N>) -> Option<([S; N], [S; 2])> {
        let mut seen = Seen::<S, N, 1>::of::<_, C>(&self.system, at, self.system.force(at)).ok()?;
        let direction = match self.friction {
            Friction::Granted(direction) => direction,
            Friction::Sign { smooth } => {
                let along = sliding(&self.system, at);
                seen.dry.friction[0] *= along / (along.squared() + S::lift(smooth).squared()).sqrt();
                Direction::Forwards
            }
        };
        let reactions = Cramer::of(&seen.dry, &[Mode::Slip(direction, Face::Front)]).reactions();
        let [reaction] = reactions;
        Some((seen.acceleration(&reactions), reaction))
    }
}

/// The sliding velocity at the contact.
fn sliding<Q, S, const N: usize, const C: usize>(system: &Q, at: &State<S, N>) -> S
where
    Q: Contacts<N, C, 1>,
    S: Over<Q::Given>,
{
    let moving = std::array::from_fn(|i| Tangent::moving(at.place[i], at.velocity[i]));
    let [contact] = system.contacts(Tangent::moving(at.time, S::one()), moving);
    contact.along.slope
}

/// The coordinates and velocities of an integrated state.
pub fn parts<S: Scalar, const N: usize>(time: S, y: &[S]) -> State<S, N> {
    State { time, place: std::array::from_fn(|i| y[i]), velocity: std::array::from_fn(|i| y[N + i]) }
}

impl<Q, S, const N: usize, const C: usize> Ode<S> for Slip<Q, N, C>
where
    Q: Contacts<N, C, 1, Given = f64>,
    S: Over<f64> + Analytic,
{
    fn dimension(&self) -> usize {
        2 * N
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let at = parts::<S, N>(t, y);
        let Some((acceleration, _)) = self.motion(&at) else {
            dy.fill(S::zero() / S::zero());
            return;
        };
        dy[..N].copy_from_slice(&at.velocity);
        dy[N..].copy_from_slice(&acceleration);
    }
}

impl<Q, const N: usize, const C: usize> integrators::System for Slip<Q, N, C>
where
    Q: Contacts<N, C, 1, Given = f64> + Sync,
{
    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        Some(Box::new(ByTangents::of(self)))
    }
}
