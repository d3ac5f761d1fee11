//! The relations (6.5) in vector form, for the statements of section 7.
//!
//! F = w0^2 G + A' W w0 u + Gamma n with G = A*nu x nu, u = l x nu, n = e x nu; all three vectors are orthogonal to nu,
//! and
//! V* = l.G, S* = e.G, Pi* = nu.(l x e) = -e.u = l.n, Delta* = G.G.

use super::alphabet::{cyclic, letter, one};
use super::gyrostats::Example;
use super::letters::Letters;
use claims::{Condition, Draft, Page};
use nalgebra::Vector3;
use symbolic::Sym;

use Condition::{Equal, Zero};

/// The relations (6.5) and their vectors.
pub struct Relations {
    /// The vector F.
    pub all: Vector3<Sym>,
    /// The vector F / w0 for Gamma = 0.
    pub balanced: Vector3<Sym>,
    pub tilt: Vector3<Sym>,
    pub axis: Vector3<Sym>,
    pub weight: Vector3<Sym>,
    pub v: Sym,
    pub s: Sym,
    pub pi: Sym,
    pub delta: Sym,
    /// The product A' W.
    pub spin: Sym,
}

impl Relations {
    /// The relations in the paper's symbols.
    pub fn new(s: &Letters) -> Self {
        let spin = s.axial * s.omega_field;
        let (tilt, axis) = (s.tilt(), s.l.cross(&s.nu));
        Relations {
            all: s.conditions(),
            balanced: tilt * s.omega0 + axis * spin,
            tilt,
            axis,
            weight: s.e.cross(&s.nu),
            v: s.v_star(),
            s: s.s_star(),
            pi: s.pi_star(),
            delta: s.delta_star(),
            spin,
        }
    }
}

/// The condition that three components vanish.
pub fn zeros(v: Vector3<Sym>) -> [Condition; 3] {
    [Zero(v.x), Zero(v.y), Zero(v.z)]
}

/// The condition |nu| = 1 at a point.
pub fn unit(s: &Letters) -> [Condition; 1] {
    [Zero(s.nu.dot(&s.nu) - one())]
}

/// The conditions that a quadratic form has the three given coefficients of nu2 nu3, nu3 nu1, nu1 nu2, and no others.
pub fn coefficients_of(s: &Letters, form: Sym, d: Vector3<Sym>) -> Vec<Condition> {
    let (a, n) = (s.a_star, s.nu);
    let coefficients = cyclic(|i, j, k| (a[j] - a[k]) * d[i]);
    let mixed = (0..3).map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        Equal(form.diff(n[j]).diff(n[k]), coefficients[i])
    });
    let squares = (0..3).map(|i| Zero(form.diff(n[i]).diff(n[i])));
    mixed.chain(squares).collect()
}

/// Refutes "there is an angular velocity" by an example whose direction admits none.
pub fn no_speed<'a>(draft: Draft<'a>, s: &Letters, f: &Relations, example: &Example) -> &'a mut Page {
    draft.without_root(zeros(f.all), s.omega0, example.point(s))
}

/// The condition form(t nu) = t^degree form(nu).
pub fn scaling(s: &Letters, form: Sym, degree: i32) -> Condition {
    let t = letter("t");
    let scaled: Vec<(Sym, Sym)> = s.nu.iter().map(|&n| (n, t * n)).collect();
    Equal(form.substitute(&scaled), t.powi(degree) * form)
}
