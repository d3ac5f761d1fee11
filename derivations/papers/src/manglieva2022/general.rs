//! The systems of the general theory: coordinates with masses, under constraints that are arbitrary to second order.
//!
//! At a position, taken as the origin, the equations of motion depend on a geometric constraint through its derivatives
//! up to second order, and on a kinematic one through those of first order. These derivatives are symbols. A proof for
//! them is valid for every smooth constraint whose gradient allows it to be solved for the given coordinate.

use super::alphabet::{indexed, letter};
use field::{Analytic, Over};
use mechanics::constrained::combining::Combined;
use mechanics::constrained::motion::Motion;
use mechanics::constrained::multipliers::{Reaction, multipliers};
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};
use mechanics::definite::NotDefinite;
use symbolic::Sym;

/// Three coordinates and the implicit constraint f(x, t) = 0.
#[derive(Clone, Copy, Debug)]
pub struct Surface;

/// Three coordinates and the explicit constraint x1 = F(x2, x3, t).
#[derive(Clone, Copy, Debug)]
pub struct Resolved;

/// Four coordinates with x1 = F(x2, x3, x4, t) and the nonlinear velocity constraint x2' = Phi(x, x3', x4', t).
#[derive(Clone, Copy, Debug)]
pub struct Mixed;

fn lifted<S: Over<Sym>, const N: usize>(pattern: &str) -> [S; N] {
    indexed(pattern).map(S::lift)
}

/// A function with symbolic first and second derivatives at the origin, named after it.
fn to_second_order<S: Over<Sym>, const N: usize>(name: &str, numbers: [usize; N], time: S, x: [S; N]) -> S {
    let named = |suffix: String| S::lift(letter(&format!("{name}{suffix}")));
    let mut sum = named("t".into()) * time + (named("tt".into()) * time * time).half();
    for (k, (&i, &xi)) in numbers.iter().zip(&x).enumerate() {
        sum += named(i.to_string()) * xi + named(format!("{i}t")) * xi * time;
        sum += (named(format!("{i}{i}")) * xi * xi).half();
        for (&j, &xj) in numbers.iter().zip(&x).skip(k + 1) {
            sum += named(format!("{i}{j}")) * xi * xj;
        }
    }
    sum
}

macro_rules! massive {
    ($system:ty, $n:literal) => {
        impl PointSystem<$n> for $system {
            type Given = Sym;

            fn masses<S: Over<Sym>>(&self) -> [S; $n] {
                lifted("m#")
            }

            fn force<S: Over<Sym>>(&self, _at: &State<S, $n>) -> [S; $n] {
                lifted("X#")
            }
        }
    };
}
massive!(Surface, 3);
massive!(Resolved, 3);
massive!(Mixed, 4);

impl Constrained<3, 1> for Surface {
    fn constraints<S: Over<Sym>>(&self, at: &State<S, 3>) -> [Constraint<S>; 1] {
        [Constraint::Geometric(to_second_order("f", [1, 2, 3], at.time, at.place))]
    }
}

impl Constrained<3, 1> for Resolved {
    fn constraints<S: Over<Sym>>(&self, at: &State<S, 3>) -> [Constraint<S>; 1] {
        let [x1, x2, x3] = at.place;
        [Constraint::Geometric(x1 - to_second_order("F", [2, 3], at.time, [x2, x3]))]
    }
}

impl Charted<3, 2, 2> for Resolved {
    fn place<S: Over<Sym> + Analytic>(&self, time: S, q: [S; 2]) -> [S; 3] {
        [to_second_order("F", [2, 3], time, q), q[0], q[1]]
    }

    fn rates<S: Over<Sym> + Analytic>(&self, _time: S, _q: [S; 2], p: [S; 2]) -> [S; 2] {
        p
    }
}

/// The function Phi: quadratic in the velocities, linear in all else.
fn steering<S: Over<Sym>>(time: S, x: [S; 4], v: [S; 2]) -> S {
    let named = |name: &str| S::lift(letter(name));
    let places: [S; 4] = lifted("Φx#");
    let linear = (0..4).fold(named("Φ") + named("Φt") * time, |sum, i| sum + places[i] * x[i]);
    linear
        + named("Φ3") * v[0]
        + named("Φ4") * v[1]
        + (named("Φ33") * v[0] * v[0]).half()
        + named("Φ34") * v[0] * v[1]
        + (named("Φ44") * v[1] * v[1]).half()
}

impl Constrained<4, 2> for Mixed {
    fn constraints<S: Over<Sym>>(&self, at: &State<S, 4>) -> [Constraint<S>; 2] {
        let ([x1, x2, x3, x4], [_, v2, v3, v4]) = (at.place, at.velocity);
        [
            Constraint::Geometric(x1 - to_second_order("F", [2, 3, 4], at.time, [x2, x3, x4])),
            Constraint::Kinematic(v2 - steering(at.time, at.place, [v3, v4])),
        ]
    }
}

/// The chart q = (x2, x3, x4), p = (x3', x4').
impl Charted<4, 3, 2> for Mixed {
    fn place<S: Over<Sym> + Analytic>(&self, time: S, q: [S; 3]) -> [S; 4] {
        [to_second_order("F", [2, 3, 4], time, q), q[0], q[1], q[2]]
    }

    fn rates<S: Over<Sym> + Analytic>(&self, time: S, q: [S; 3], p: [S; 2]) -> [S; 3] {
        [steering(time, self.place(time, q), p), p[0], p[1]]
    }
}

/// The motion on the explicit surface at the origin, with the symbols x2', x3' as velocities.
pub fn on_surface() -> Motion<Sym, 3, 2> {
    let [_, v2, v3] = indexed("ẋ#");
    Motion::at(&Resolved, Sym::ZERO, [Sym::ZERO; 2], [v2, v3])
}

/// The motion of the mixed system at the origin, with the symbols x3', x4' as p.
pub fn mixed() -> Motion<Sym, 4, 2> {
    let [_, _, v3, v4] = indexed("ẋ#");
    Motion::at(&Mixed, Sym::ZERO, [Sym::ZERO; 3], [v3, v4])
}

/// Friction by the extended method: m times the combination of the fields with the symbols mu_1, mu_2.
pub fn friction<const N: usize>(fields: [[Sym; N]; 2]) -> [Sym; N] {
    let masses: [Sym; N] = indexed("m#");
    let [mu1, mu2] = indexed("μ#");
    std::array::from_fn(|i| masses[i] * (mu1 * fields[0][i] + mu2 * fields[1][i]))
}

/// The sum of the given forces and friction.
pub fn with_friction<const N: usize>(fields: [[Sym; N]; 2]) -> [Sym; N] {
    let (given, friction): ([Sym; N], _) = (indexed("X#"), friction(fields));
    std::array::from_fn(|i| given[i] + friction[i])
}

/// Accelerations and multipliers by Lagrange's equations of the first kind under a force; undefined if they cannot be
/// solved.
pub fn first_kind<Q: Constrained<N, C, Given = Sym>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<Sym, N>,
    force: [Sym; N],
) -> Reaction<Sym, N, C> {
    let undefined = Reaction { acceleration: [Sym::UNDEFINED; N], multipliers: [Sym::UNDEFINED; C] };
    multipliers(system, at, force).unwrap_or(undefined)
}

/// The scalar product of a and b.
pub fn dot<const N: usize>(a: [Sym; N], b: [Sym; N]) -> Sym {
    (0..N).fold(Sym::ZERO, |sum, i| sum + a[i] * b[i])
}

/// The parts of a reaction; undefined in case of a zero pivot, which cannot occur for independent rows.
pub fn or_undefined<const N: usize, const C: usize>(
    combined: Result<Combined<Sym, N, C>, NotDefinite>,
) -> Combined<Sym, N, C> {
    combined.unwrap_or(Combined {
        multipliers: [Sym::UNDEFINED; C],
        of_constraints: [Sym::UNDEFINED; N],
        of_friction: [Sym::UNDEFINED; N],
    })
}
