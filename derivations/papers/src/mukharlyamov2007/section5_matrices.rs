//! Section 5, several constraints: a Lyapunov function of (15) with symmetric positive definite matrices.
//!
//! Every step is an identity in the entries of 3 x 3 matrices that does not depend on their dimension. A positive
//! definite c is G D G', where the triangular G has a unit diagonal and D is positive, and a = G (M diag(alpha) M') G'
//! likewise.

use super::alphabet::{dot, indexed, int, letter, letters};
use claims::{Condition, Page};
use field::Scalar;
use mechanics::definite::solve;
use symbolic::Sym;

use Condition::{Equal, Positive, Zero};

const N: usize = 3;
type Vector = [Sym; N];
type Matrix = [[Sym; N]; N];

pub fn claims(page: &mut Page) {
    page.section("5. Stability of the perturbations: several constraints");
    function(page);
    gain(page);
}

/// A symmetric matrix of symbols.
fn symmetric(pattern: &str) -> Matrix {
    let entry = |i: usize, j: usize| {
        let indices = [i.min(j) + 1, i.max(j) + 1].map(|index| index.to_string());
        letter(&pattern.replacen('#', &indices[0], 1).replacen('#', &indices[1], 1))
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// A lower triangular matrix with a unit diagonal.
fn triangle(names: [&str; 3]) -> Matrix {
    let [b, c, d] = letters(names);
    let (one, none) = (int(1), Sym::ZERO);
    [[one, none, none], [b, one, none], [c, d, one]]
}

fn transposed(m: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

fn of(m: &Matrix, x: Vector) -> Vector {
    m.map(|row| dot(row, x))
}

/// The quadratic form x'Mx.
fn form(m: &Matrix, x: Vector) -> Sym {
    dot(x, of(m, x))
}

/// The product L diag(d) L'.
fn product(l: &Matrix, d: Vector) -> Matrix {
    let entry = |i: usize, j: usize| (0..N).fold(Sym::ZERO, |sum, k| sum + l[i][k] * d[k] * l[j][k]);
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// Claims on V and its rate.
fn function(page: &mut Page) {
    let [a, c, k] = ["aʸ##", "cʸ##", "kʸ##"].map(symmetric);
    let (y, dy, ddy): (Vector, Vector, Vector) = (indexed("y#"), indexed("ẏ#"), indexed("ÿ#"));
    let eps = letter("ε");
    let v = (form(&a, dy) + form(&k, y) + eps * form(&c, y)).half() + eps * dot(y, of(&a, dy));
    let rest = |x: Vector| form(&c, x) - eps * form(&a, x);
    let rate = (0..N).fold(Sym::ZERO, |sum, i| sum + v.diff(y[i]) * dy[i] + v.diff(dy[i]) * ddy[i]);
    let motion = |i: usize| dot(a[i], ddy) + dot(c[i], dy) + dot(k[i], y);
    page.claim("section5-stability", "matrices-rate", r"For three constraints, $a\ddot y+c\dot y+ky=0$ with constant symmetric matrices, $V=\frac12\dot y'a\dot y+\frac12y'ky+\varepsilon y'a\dot y+\frac\varepsilon2y'cy$ has $\dot V=-\dot y'(c-\varepsilon a)\dot y-\varepsilon y'ky$, for every $\varepsilon$")
        .in_words()
        .given((0..N).map(|i| Zero(motion(i))))
        .by_combination([(
            Equal(rate, -rest(dy) - eps * form(&k, y)),
            vec![],
            (0..N).map(|i| (i, dy[i] + eps * y[i])).collect(),
        )]);
    let moved: Vector = std::array::from_fn(|i| dy[i] + eps * y[i]);
    page.claim("section5-stability", "matrices-definite", r"The function $V$ of section5-stability/matrices-rate is $V=\frac12(\dot y+\varepsilon y)'a(\dot y+\varepsilon y)+\frac12y'ky+\frac\varepsilon2y'(c-\varepsilon a)y$. Where $a$, $k$, $c-\varepsilon a$ are positive definite and $\varepsilon>0$, so are $V$ and $-\dot V$")
        .in_words()
        .follows([Equal(v, (form(&a, moved) + form(&k, y) + eps * rest(y)).half())]);
}

/// Claims on a bound of the gain epsilon.
fn gain(page: &mut Page) {
    let (lower, inner) = (triangle(["g21", "g31", "g32"]), triangle(["n21", "n31", "n32"]));
    let (d, alpha): (Vector, Vector) = (indexed("d#"), indexed("α#"));
    let x: Vector = indexed("y#");
    let columns = product(&inner, alpha);
    let a: Matrix = {
        let half: Matrix = std::array::from_fn(|i| of(&columns, lower[i]));
        std::array::from_fn(|i| of(&lower, half[i]))
    };
    let c = product(&lower, d);
    let trace = (0..N).fold(Sym::ZERO, |sum, i| sum + columns[i][i] / d[i]);
    let turned = of(&transposed(&lower), x);
    let pairs = [(0, 1), (0, 2), (1, 2)];
    let squares = (0..N).fold(Sym::ZERO, |sum, j| {
        pairs.into_iter().fold(sum, |sum, (i, k)| {
            let across = d[i] * turned[i] * inner[k][j] - d[k] * turned[k] * inner[i][j];
            sum + alpha[j] * across.powi(2) / (d[i] * d[k])
        })
    });
    let solved = (0..N).fold(Sym::ZERO, |sum, i| {
        let right: Vector = std::array::from_fn(|row| a[row][i]);
        let column = solve(c, right).unwrap_or([Sym::UNDEFINED; N]);
        sum + column[i]
    });
    let positive = d.into_iter().chain(alpha).map(Positive);
    page.claim("section5-stability", "matrices-gain", r"An $\varepsilon>0$ with $c-\varepsilon a$ positive definite exists, here for three constraints. With $\tau=\mathrm{tr}(c^{-1}a)$ the form $\tau\,x'cx-x'ax$ is a sum of squares for all positive definite $a=GM\,\mathrm{diag}(\alpha)M'G'$, $c=G\,\mathrm{diag}(d)G'$. So $x'(c-\varepsilon a)x\ge(1-\varepsilon\tau)x'cx$, and every $0<\varepsilon<1/\tau$ will do. By Lyapunov's theorem (not proved here), the perturbations of (15) are then asymptotically stable for constant symmetric positive definite $a,c,k$")
        .in_words()
        .given(positive)
        .follows([Equal(solved, trace), Equal(trace * form(&c, x) - form(&a, x), squares)]);
}
