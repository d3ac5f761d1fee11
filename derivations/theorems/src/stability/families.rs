//! Circles of steady motions: the quantities that are common to all members.

use super::letters::kept;
use claims::{Condition, Page};
use nalgebra::{Matrix3, Vector3};
use papers::konosevich2022::Letters;
use studies::stationary::stability::reduced::Reduced;

use Condition::Equal;

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Stability: circles of motions");
    let [equal, own] = [s.a_star.x, s.a_star.z];
    let tensor = Matrix3::from_diagonal(&Vector3::new(equal, equal, own));
    let circle = Reduced { tensor, multiplier: s.omega0.powi(2) * equal, ..kept(s) };
    let [_, _, b] = circle.polynomial();
    let stiff = s.omega0.powi(2) * (equal - own);
    let across = s.nu.cross(&circle.coupling()).z;
    page.claim("family", "sign", r"On a circle of motions $A_1^*=A_2^*$ and $\lambda=\omega^{0\,2}A_1^*$, with the rotor's axis anywhere, the last coefficient of $\det A^*p_c$ is $b=\omega^{0\,2}(A_1^*-A_3^*)\,((\nu\times\kappa)\cdot\xi_3)^2$. Where $A_1^*<A_3^*$ each member with $b\ne0$ is unstable at constant speed (for $A_1^*>A_3^*$ see stability/family/energy)")
        .in_words()
        .follows([Equal(b, stiff * across.powi(2))]);
    let y = super::alphabet::vector("δν");
    let weight = circle.weight();
    page.claim("family", "energy", r"On a circle of motions $A_1^*=A_2^*$ and $\lambda=\omega^{0\,2}A_1^*$ the form of a tilt at fixed vertical momentum is $Q=\omega^{0\,2}(A_1^*-A_3^*)\,\delta\nu_3^2+(\kappa\cdot\delta\nu)^2/\nu\cdot A^*\nu$, a sum of two squares whose coefficients are positive where $A_1^*>A_3^*$, so that no tilt lowers the energy there")
        .in_words()
        .follows([Equal(
            (circle.energy() * y).dot(&y),
            stiff * y.z.powi(2) + circle.coupling().dot(&y).powi(2) / weight,
        )]);
}
