//! The system of the general theory: three coordinates with masses, a geometric and a kinematic constraint, both
//! arbitrary to second order at the considered position and possibly violated there.
//!
//! The position is the origin. The equations of motion depend on f(q, t) through its value and derivatives up to second
//! order; on phi(q, q', t) through its value, its first derivatives and, in the velocities, its second ones. All of
//! these are symbols.

use super::alphabet::{indexed, letter};
use field::Over;
use mechanics::constrained::multipliers::{Reaction, leading_to};
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use symbolic::Sym;

/// The system with both constraints.
#[derive(Clone, Copy, Debug)]
pub struct General;

fn named<S: Over<Sym>>(name: impl AsRef<str>) -> S {
    S::lift(letter(name.as_ref()))
}

fn lifted<S: Over<Sym>, const N: usize>(pattern: &str) -> [S; N] {
    indexed(pattern).map(S::lift)
}

/// The quadratic form of symbolic second derivatives, sum over i <= j.
fn quadratic<S: Over<Sym>>(stem: &str, x: [S; 3]) -> S {
    let mut sum = S::zero();
    for i in 0..3 {
        sum += (named::<S>(format!("{stem}{0}{0}", i + 1)) * x[i] * x[i]).half();
        for j in i + 1..3 {
            sum += named::<S>(format!("{stem}{}{}", i + 1, j + 1)) * x[i] * x[j];
        }
    }
    sum
}

fn linear<S: Over<Sym>>(coefficients: [S; 3], x: [S; 3]) -> S {
    (0..3).fold(S::zero(), |sum, i| sum + coefficients[i] * x[i])
}

impl PointSystem<3> for General {
    type Given = Sym;

    fn masses<S: Over<Sym>>(&self) -> [S; 3] {
        lifted("m#")
    }

    fn force<S: Over<Sym>>(&self, _at: &State<S, 3>) -> [S; 3] {
        lifted("X#")
    }
}

impl Constrained<3, 2> for General {
    fn constraints<S: Over<Sym>>(&self, at: &State<S, 3>) -> [Constraint<S>; 2] {
        let (t, q, v) = (at.time, at.place, at.velocity);
        let mixed: [S; 3] = std::array::from_fn(|i| named(format!("f{}t", i + 1)));
        let f = named::<S>("f")
            + named::<S>("ft") * t
            + (named::<S>("ftt") * t * t).half()
            + linear(lifted("f#"), q)
            + linear(mixed, q) * t
            + quadratic("f", q);
        let phi = named::<S>("ϕ")
            + named::<S>("ϕt") * t
            + linear(lifted("ϕx#"), q)
            + linear(lifted("ϕ#"), v)
            + quadratic("ϕ", v);
        [Constraint::Geometric(f), Constraint::Kinematic(phi)]
    }
}

/// The state at the origin, with the symbols q_i' as velocities.
pub fn instant() -> State<Sym, 3> {
    State { time: Sym::ZERO, place: [Sym::ZERO; 3], velocity: indexed("q̇#") }
}

/// Accelerations and multipliers for given rates of the constraints; undefined, so that claims fail, if they cannot be
/// solved.
pub fn led(wanted: [Sym; 2]) -> Reaction<Sym, 3, 2> {
    let undefined = Reaction { acceleration: [Sym::UNDEFINED; 3], multipliers: [Sym::UNDEFINED; 2] };
    leading_to(&General, &instant(), indexed("X#"), wanted).unwrap_or(undefined)
}
