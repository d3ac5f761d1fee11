//! An arbitrary system at one instant: N masses and C constraints J x'' + beta = 0, all of them symbols.

use super::alphabet::letter;
use field::Over;
use mechanics::constrained::multipliers::{Reaction, multipliers};
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use symbolic::Sym;

/// The masses, the rows of J, and the terms beta, which contain no accelerations.
#[derive(Clone, Copy, Debug)]
pub struct AnySystem<const N: usize, const C: usize> {
    pub masses: [Sym; N],
    pub rows: [[Sym; N]; C],
    pub rest: [Sym; C],
}

impl<const N: usize, const C: usize> AnySystem<N, C> {
    /// The system with a distinct symbol for every datum.
    pub fn new() -> Self {
        AnySystem {
            masses: numbered("m"),
            rows: std::array::from_fn(|k| std::array::from_fn(|i| letter(&format!("J{}{}", k + 1, i + 1)))),
            rest: numbered("β"),
        }
    }

    /// Lagrange's equations of the first kind under a force; the result is undefined if they cannot be solved.
    pub fn under(&self, force: [Sym; N]) -> Reaction<Sym, N, C> {
        let rest = [Sym::ZERO; N];
        let at = State { time: letter("t"), place: rest, velocity: rest };
        let undefined = Reaction { acceleration: [Sym::UNDEFINED; N], multipliers: [Sym::UNDEFINED; C] };
        multipliers(self, &at, force).unwrap_or(undefined)
    }

    /// The product J v.
    pub fn along_rows(&self, v: [Sym; N]) -> [Sym; C] {
        self.rows.map(|row| dot(row, v))
    }

    /// The product M^-1 v.
    pub fn per_mass(&self, v: [Sym; N]) -> [Sym; N] {
        std::array::from_fn(|i| v[i] / self.masses[i])
    }

    /// The reaction J^T lambda.
    pub fn reaction(&self, multipliers: [Sym; C]) -> [Sym; N] {
        std::array::from_fn(|i| (0..C).fold(Sym::ZERO, |sum, k| sum + multipliers[k] * self.rows[k][i]))
    }

    /// The matrix J M^-1 J^T.
    pub fn matrix(&self) -> [[Sym; C]; C] {
        self.rows.map(|a| self.rows.map(|b| dot(a, self.per_mass(b))))
    }
}

impl<const N: usize, const C: usize> PointSystem<N> for AnySystem<N, C> {
    type Given = Sym;

    fn masses<S: Over<Sym>>(&self) -> [S; N] {
        self.masses.map(S::lift)
    }

    fn force<S: Over<Sym>>(&self, _at: &State<S, N>) -> [S; N] {
        [S::zero(); N]
    }
}

impl<const N: usize, const C: usize> Constrained<N, C> for AnySystem<N, C> {
    fn constraints<S: Over<Sym>>(&self, at: &State<S, N>) -> [Constraint<S>; C] {
        std::array::from_fn(|k| {
            let moved = (0..N).fold(S::zero(), |sum, i| sum + S::lift(self.rows[k][i]) * at.velocity[i]);
            Constraint::Kinematic(moved + S::lift(self.rest[k]) * at.time)
        })
    }
}

/// The symbols x1, x2, ... with the given stem in place of x.
pub fn numbered<const N: usize>(stem: &str) -> [Sym; N] {
    std::array::from_fn(|i| letter(&format!("{stem}{}", i + 1)))
}

/// The scalar product a.b.
pub fn dot<const N: usize>(a: [Sym; N], b: [Sym; N]) -> Sym {
    (0..N).fold(Sym::ZERO, |sum, i| sum + a[i] * b[i])
}
