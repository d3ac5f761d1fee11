//! Additional results: power balance, a nonincreasing function, integrals, and steady motions as critical points.

use super::alphabet::{cyclic, letter, number, one, vector};
use super::letters::Letters;
use claims::{Condition, Page};
use field::Tangent;
use mechanics::differentiate::along;
use mechanics::momentum::absolute_rate;
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;

use Condition::{Equal, Positive, Zero};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Beyond the paper: integrals, critical points");
    integrals(page, s);
    critical_points(page, s);
    bounds(page, s);
}

/// Claims on the integrals that every machine conserves.
fn integrals(page: &mut Page, s: &Letters) {
    let g = s.general();
    let moving = Vector3::from(along(s.w.into(), s.dw.into()));
    let rotor = Tangent::moving(s.dphi, s.ddphi);
    let [x, _] = g.angular_momentum(moving, rotor);
    let nu = Vector3::from(along(s.nu.into(), s.nu.cross(&s.w).into()));
    page.claim("beyond-integrals", "vertical", r"$\nu\cdot\nu$ is conserved: its rate along (4.6) vanishes")
        .in_words()
        .follows([Zero(nu.dot(&nu).slope)]);
    let residual = g.by_momentum(&s.motion());
    let carried = s.nu.dot(&Vector3::new(residual[0], residual[1], residual[2]));
    page.claim("beyond-integrals", "momentum", r"The angular momentum about the vertical, $x\cdot\nu$, is conserved for every machine: its rate is the product of $\nu$ with the residual of the carrier's equations, in which $M$ does not occur")
        .in_words()
        .under(&s.unit_axis)
        .follows([Equal(x.dot(&nu).slope, carried)]);
    let still = absolute_rate(x, s.w).dot(&s.nu) - carried;
    page.claim(
        "beyond-integrals",
        "no-weight",
        r"$\nu\cdot(\dot x+\omega\times x)$ is the product of $\nu$ with the residual of the carrier's equations, for the moment of the weight has no vertical part, $\nu\cdot(\Gamma e\times\nu)=0$",
    )
    .in_words()
    .under(&s.unit_axis)
    .follows([Zero(still - g.weight().cross(&s.nu).dot(&s.nu))]);
}

/// Claims: stationary directions are the critical points of a function on the sphere.
fn critical_points(page: &mut Page, s: &Letters) {
    let potential = (s.a_star.component_mul(&s.nu).dot(&s.nu) * s.omega0.powi(2)) / number(2, 1)
        + s.axial * s.omega_field * s.omega0 * s.l.dot(&s.nu)
        + s.big_gamma * s.e.dot(&s.nu);
    let slope = s.nu.map(|n| potential.diff(n));
    let tangential = slope.cross(&s.nu);
    page.claim("beyond-critical", "gradient", r"(6.5) is $\operatorname{grad}U\times\nu=0$ with $U(\nu;\omega^0) = \frac12\omega^{0\,2}\,\nu\cdot A^*\nu + A'\Omega\omega^0\,l\cdot\nu + \Gamma\,e\cdot\nu$. The stationary directions for a given $\omega^0$ are the critical points of $U$ on the sphere (at least two, where a continuous function has its greatest and its least value)")
        .in_words()
        .follows((0..3).map(|i| Equal(tangential[i], s.conditions()[i])));
    // (a_i - lambda) nu_i + d_i = 0, |nu| = 1
    let lambda = letter("λ");
    let a = vector("α");
    let d = vector("δ");
    let squares = cyclic(|i, _, _| (a[i] - lambda).powi(2));
    let others = |i: usize| squares[(i + 1) % 3] * squares[(i + 2) % 3];
    let sextic =
        squares.x * squares.y * squares.z - d.x.powi(2) * others(0) - d.y.powi(2) * others(1) - d.z.powi(2) * others(2);
    let plus = cyclic(|i, _, _| (a[i] - lambda) * s.nu[i] + d[i]);
    let minus = cyclic(|i, _, _| (a[i] - lambda) * s.nu[i] - d[i]);
    let norm = s.nu.dot(&s.nu) - one();
    page.claim("beyond-critical", "sextic", r"With $\alpha_i = \omega^{0\,2}A_i^*$, $\delta = A'\Omega\omega^0l+\Gamma e$ and the multiplier $\lambda$, $(\alpha_i-\lambda)\nu_i + \delta_i = 0$ and $|\nu|=1$ give a sextic in $\lambda$. Where all $\delta_i\ne0$ each root has the one direction $\nu_i = \delta_i/(\lambda-\alpha_i)$, so that there are at most six")
        .given([Zero(plus.x), Zero(plus.y), Zero(plus.z), Zero(norm)])
        .by_combination([(
            Zero(sextic),
            vec![],
            vec![
                (0, minus.x * others(0)),
                (1, minus.y * others(1)),
                (2, minus.z * others(2)),
                (3, -(squares.x * squares.y * squares.z)),
            ],
        )]);
}

/// Bounds of D from the data: a lower bound through the smallest principal moment a of A, in principal axes of A with
/// A_i = a + d_i.
fn bounds(page: &mut Page, s: &Letters) {
    let least = letter("a");
    let d = vector("d");
    let l2 = s.l.map(|c| c.powi(2));
    let compliance = (0..3).fold(Sym::ZERO, |sum, i| sum + l2[i] / (least + d[i]));
    let all = Matrix3::from_diagonal(&Vector3::from_fn(|i, _| least + d[i])) + s.l * s.l.transpose() * s.axial;
    let reduced = (least + d[0]) * (least + d[1]) * (least + d[2]);
    page.claim(
        "beyond-singular",
        "reciprocal",
        r"$1/D = 1 + A'\,l\cdot A^{-1}l$, in the principal axes of $A$ with moments $a+d_i$, where $D=\det A/\det A^*$",
    )
    .in_words()
    .follows([Equal(mechanics::rotation::determinant(&all) / reduced, one() + s.axial * compliance)]);
    let room = l2.sum() / least - compliance;
    page.claim("beyond-singular", "lower-bound", r"$D \ge a/(a+A')$ with the least principal moment $a$ of $A$, by beyond-singular/reciprocal: $|l|^2/a - l\cdot A^{-1}l = \sum l_i^2d_i/(a(a+d_i))$, whose terms are not negative where the moments are $a+d_i\ge a>0$")
        .in_words()
        .given([Positive(least)])
        .follows([Equal(room, (0..3).fold(Sym::ZERO, |sum, i| sum + l2[i] * d[i] / (least * (least + d[i]))))]);
}
