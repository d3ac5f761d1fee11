//! Closed forms: rotation about a principal axis that contains the rotor's axis and the centre of mass, and rest.

use super::alphabet::letter;
use super::letters::kept;
use claims::{Condition, Page};
use field::Scalar;
use mechanics::rotation::determinant;
use nalgebra::Vector3;
use papers::konosevich2022::Letters;
use studies::stationary::stability::reduced::Reduced;
use symbolic::Sym;

use Condition::{Equal, Zero};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Stability: closed forms");
    let axis = |i: usize| Vector3::from_fn(|j, _| Sym::int(i64::from(i == j)));
    let z = letter("z");
    let h = letter("H");
    let [a1, a2, a3] = [s.a_star.x, s.a_star.y, s.a_star.z];
    let upright = Reduced { vertical: axis(2), spin: axis(2) * h, ..kept(s) };
    let lambda = upright.multiplier;
    let [h1, h2] = [a1, a2].map(|a| lambda - s.omega0.powi(2) * a);
    let n = h + s.omega0 * (a3 - a1 - a2);
    page.claim("axis", "polynomial", r"With rotor, centre of mass and vertical along one principal axis of $A^*$, the third, and $h=A'\Omega$, $\det K=A_3^*z^2\,(A_1^*A_2^*z^4+(A_1^*H_1+A_2^*H_2+n^2)z^2+H_1H_2)$. Here $n=h+\omega^0(A_3^*-A_1^*-A_2^*)$, $H_i=\omega^{0\,2}(A_3^*-A_i^*)+\omega^0h\pm\Gamma$, $+$ hanging, $-$ upright. The form $Q$ on the plane across the axis is $H_1\delta\nu_1^2+H_2\delta\nu_2^2$")
        .in_words()
        .follows([
            Equal(
                determinant(&upright.pencil(z)),
                a3 * z.powi(2) * (a1 * a2 * z.powi(4) + (a1 * h1 + a2 * h2 + n.powi(2)) * z.powi(2) + h1 * h2),
            ),
            Equal(upright.energy()[(0, 0)], h1),
            Equal(upright.energy()[(1, 1)], h2),
            Zero(upright.energy()[(0, 1)]),
        ]);
    let gamma = s.big_gamma;
    page.claim(
        "axis",
        "multiplier",
        r"With rotor, centre of mass and vertical along one principal axis of $A^*$, the third, $\lambda=\nu\cdot(\omega^0x+\Gamma e)=\omega^{0\,2}A_3^*+\omega^0h\pm\Gamma$, $+$ hanging, $-$ upright",
    )
    .in_words()
    .follows([Equal(
        ((upright.tensor * upright.vertical * s.omega0 + upright.spin) * s.omega0 + axis(2) * gamma)
            .dot(&upright.vertical),
        s.omega0.powi(2) * a3 + s.omega0 * h + gamma,
    )]);
    let reduced = Reduced {
        tensor: upright.tensor - axis(2) * axis(2).transpose() * s.axial,
        spin: axis(2) * (h + s.axial * s.omega0),
        ..upright
    };
    page.claim("axis", "free-rotor", r"With rotor, centre of mass and vertical along one principal axis of $A^*$, the third, $A_3^*\det K_f=(A_3^*-A')\det K$ for the free rotor: $p_f=p_c$, so that by stability/motor/between every motor has the roots of $p_c$")
        .in_words()
        .follows([Equal(determinant(&reduced.pencil(z)) * a3, determinant(&upright.pencil(z)) * (a3 - s.axial))]);
    balanced(page, s, z);
    rest(page, s, z, h, axis);
}

/// The case without weight: x is along the vertical.
fn balanced(page: &mut Page, s: &Letters, z: Sym) {
    let any = kept(s);
    let spin = s.nu * (any.multiplier / s.omega0) - any.tensor * s.nu * s.omega0;
    let [det, a, b] = Reduced { spin, ..any }.polynomial();
    page.claim("balanced", "precession", r"Without weight, $\Gamma=0$, where $x=\lambda\nu/\omega^0$, $p_c$ is divisible by $z^2+\omega^{0\,2}$. The identity holds for any tensor, and so for $p_f$. By stability/motor/between every motor has the roots $\pm i\omega^0$, a constant tilt in space")
        .in_words()
        .under(&s.unit_vertical)
        .follows([Equal(
            det * z.powi(4) + a * z.powi(2) + b,
            (z.powi(2) + s.omega0.powi(2)) * (det * z.powi(2) + b / s.omega0.powi(2)),
        )]);
}

fn rest(page: &mut Page, s: &Letters, z: Sym, h: Sym, axis: impl Fn(usize) -> Vector3<Sym>) {
    let [a1, a2, a3] = [s.a_star.x, s.a_star.y, s.a_star.z];
    let gamma = s.big_gamma;
    let still = |multiplier: Sym, spin: Vector3<Sym>| Reduced {
        speed: Sym::ZERO,
        vertical: axis(2),
        multiplier,
        spin,
        ..kept(s)
    };
    let any = Reduced { vertical: s.nu, spin: s.l * h, speed: Sym::ZERO, multiplier: gamma, ..kept(s) };
    let y = super::alphabet::vector("δν");
    let weight = any.weight();
    page.claim("rest", "hanging", r"For a gyrostat hanging at rest, $\omega^0=0$, $\nu=e$, with the axes of $A^*$ anywhere, $Q=\Gamma|\delta\nu|^2+(A'\Omega\,l\cdot\delta\nu)^2/\nu\cdot A^*\nu$ is positive for $\Gamma>0$, at every speed of the rotor. Upright, $\nu=-e$, it has $-\Gamma$ in the place of $\Gamma$, and $Q<0$ for a tilt across $l$ and $\nu$")
        .in_words()
        .follows([Equal(
            (any.stiffness() * y).dot(&y) + any.coupling().dot(&y).powi(2) / weight,
            gamma * y.dot(&y) + (h * s.l.dot(&y)).powi(2) / weight,
        )]);
    let across = still(-gamma, axis(0) * h);
    page.claim("rest", "across", r"For a gyrostat upright at rest on a principal axis with the rotor across it, along the first, $\det K=z^2(A_1^*z^2-\Gamma)(A_2^*A_3^*z^2+h^2-\Gamma A_3^*)$. The root $z=\sqrt{\Gamma/A_1^*}>0$ exists at every speed of the rotor, $h=A'\Omega$")
        .in_words()
        .follows([Equal(
            determinant(&across.pencil(z)),
            z.powi(2) * (a1 * z.powi(2) - gamma) * (a2 * a3 * z.powi(2) + h.powi(2) - gamma * a3),
        )]);
    let along = still(-gamma, axis(2) * h);
    page.claim("rest", "along", r"A gyrostat upright at rest with the rotor along the vertical has $p_c=z^4+\dfrac{h^2-\Gamma(A_1^*+A_2^*)}{A_1^*A_2^*}z^2+\dfrac{\Gamma^2}{A_1^*A_2^*}$, $h=A'\Omega$")
        .in_words()
        .follows([Equal(
            determinant(&along.pencil(z)),
            a3 * z.powi(2)
                * (a1 * a2 * z.powi(4) + (h.powi(2) - gamma * (a1 + a2)) * z.powi(2) + gamma.powi(2)),
        )]);
    let [r1, r2] = [1, 2].map(|i| Sym::named(&format!("√A⋆{i}"), &format!(r"\sqrt{{A^*_{i}}}")));
    let fast = h.powi(2) - gamma * (r1.powi(2) + r2.powi(2));
    page.claim("rest", "fast", r"For a gyrostat upright at rest with the rotor along the vertical, the discriminant $(h^2-\Gamma(A_1^*+A_2^*))^2-4\Gamma^2A_1^*A_2^*$ of $p_c$ in $z^2$ is $(h^2-\Gamma(\sqrt{A_1^*}+\sqrt{A_2^*})^2)(h^2-\Gamma(\sqrt{A_1^*}-\sqrt{A_2^*})^2)$. Both $z^2$ are negative and different if and only if $h^2>\Gamma(\sqrt{A_1^*}+\sqrt{A_2^*})^2$, $h=A'\Omega$")
        .in_words()
        .follows([Equal(
            fast.powi(2) - Sym::int(4) * (gamma * r1 * r2).powi(2),
            (h.powi(2) - gamma * (r1 + r2).powi(2)) * (h.powi(2) - gamma * (r1 - r2).powi(2)),
        )]);
}
