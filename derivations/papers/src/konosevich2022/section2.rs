//! Section 2: the mechanical part: angular momentum, the two inertia tensors, the rotor.

use super::alphabet::{cyclic, letter, tensor, vector};
use super::letters::Letters;
use claims::{Condition, Line, Page};
use mechanics::differentiate::gradient;
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("2. The mechanical part");
    let g = s.general();
    let (w, l, h) = (s.w, s.l, s.h);
    let [momentum, spin] = g.angular_momentum(w, s.dphi);
    let x = vector("x");
    let a0 = g.carrier.inertia;
    let centre_part = h.cross(&w.cross(&h)) * s.m_rotor;
    let across = l.cross(&w.cross(&l)) * s.transverse;

    page.claim(
        "eq2.1",
        "components",
        r"(2.1) names the components of $\omega, \nu, l, h, c^0$ in axes fixed in the carrier",
    )
    .defines([]);

    let printed = a0 * w + centre_part + l * (s.axial * (w.dot(&l) + s.dphi)) + across;
    page.claim(
        "eq2.2",
        "momentum",
        "The angular momentum about $O$, integrated over all mass points, has the components (2.2)",
    )
    .under(&s.unit_axis)
    .holds(formulas(x, momentum, printed));
    let by_energy: [Sym; 3] =
        gradient(|[a, b, c]| g.kinetic_energy(Vector3::new(a, b, c), field::Tangent::fixed(s.dphi)), w.into());
    page.claim(
        "eq2.2",
        "from-energy",
        r"$\partial T/\partial\omega$ of the kinetic energy of the bodies is (2.2), the angular momentum about $O$",
    )
    .under(&s.unit_axis)
    .holds(formulas(x, by_energy.into(), printed));

    let along = l * l.transpose() * s.axial;
    let (full, named) = (g.full_tensor(), tensor("A⋆"));
    let [momentum, _] = s.with_reduced_tensor(named - along).angular_momentum(w, s.dphi);
    page.claim(
        "eq2.3",
        "momentum-full",
        r"$x = A^*\omega + A'\dot\varphi' l$, where $A^*$ is the tensor of all mass points",
    )
    .under(&s.unit_axis)
    .holds(formulas(x, momentum, named * w + l * (s.axial * s.dphi)));
    let full_printed = a0 * w + centre_part + l * (s.axial * w.dot(&l)) + across;
    page.claim("eq2.4", "full-tensor", r"(2.4) is $A^*\omega$ expressed by the data of the bodies")
        .under(&s.unit_axis)
        .holds(formulas(x, full * w, full_printed));

    let (reduced, named) = (g.reduced_tensor(), tensor("A"));
    let [momentum, _] = s.with_reduced_tensor(named).angular_momentum(w, s.dphi);
    let p = w.dot(&l) + s.dphi;
    page.claim("eq2.5", "momentum-reduced", r"(2.5) is $x = A\omega + A'p'l$").under(&s.unit_axis).holds(formulas(
        x,
        momentum,
        named * w + l * (s.axial * p),
    ));
    page.claim(
        "eq2.6",
        "reduced-tensor",
        r"(2.6) is $A\omega$ expressed by the data of the bodies, without the rotor's moment of inertia about its own axis",
    )
    .under(&s.unit_axis)
    .holds(formulas(x, reduced * w, a0 * w + centre_part + across));
    let axial_spin = (w + l * s.dphi).dot(&l);
    page.claim("eq2.7", "absolute-spin", "$p'$ is the projection of the rotor's absolute angular velocity on $l$")
        .under(&s.unit_axis)
        .holds([Line::formula(axial_spin, letter("p′"), w.x * l.x + w.y * l.y + w.z * l.z + s.dphi)]);
    page.claim("eq2.7", "spin-momentum", r"The rotor's own angular momentum along $l$ is $A'p'$")
        .under(&s.unit_axis)
        .holds([Line::formula(spin.dot(&l), letter("x1"), s.axial * p)]);

    components(page, s, "full", full, s.axial);
    components(page, s, "reduced", reduced, Sym::ZERO);
    rotor(page, s);
}

/// Claims on (2.8), and on (2.8) without the terms in A'.
fn components(page: &mut Page, s: &Letters, slug: &'static str, tensor: Matrix3<Sym>, axial: Sym) {
    let g = s.general();
    let (l, h, a0) = (s.l, s.h, g.carrier.inertia);
    let diagonal = cyclic(|i, j, k| {
        a0[(i, i)]
            + s.m_rotor * (h[j].powi(2) + h[k].powi(2))
            + s.transverse * (l[j].powi(2) + l[k].powi(2))
            + axial * l[i].powi(2)
    });
    let mixed = cyclic(|i, j, _| a0[(i, j)] - s.m_rotor * h[i] * h[j] + (axial - s.transverse) * l[i] * l[j]);
    let names = super::alphabet::tensor(if slug == "full" { "A⋆" } else { "A" });
    let says = if slug == "full" { "$A^*$ are (2.8)" } else { "$A$ are (2.8) without the terms in $A'$" };
    page.claim("eq2.8", slug, format!("The components of {says}, in the order 11, 12, 22, 23, 33, 31"))
        .under(&s.unit_axis)
        .holds((0..3).flat_map(|i| {
            let j = (i + 1) % 3;
            [
                Line::formula(tensor[(i, i)], names[(i, i)], diagonal[i]),
                Line::formula(tensor[(i, j)], names[(i, j)], mixed[i]),
            ]
        }));
    if slug == "full" {
        page.claim("eq2.8", "symmetric", "The components 21, 32 and 13 of $A^*$ equal 12, 23 and 31")
            .under(&s.unit_axis)
            .follows((0..3).map(|i| {
                let j = (i + 1) % 3;
                Condition::Equal(tensor[(j, i)], mixed[i])
            }));
    }
}

/// Claims on (2.9) and (2.10), by two derivations.
fn rotor(page: &mut Page, s: &Letters) {
    let g = s.general();
    let motion = s.motion();
    let by_momentum = g.by_momentum(&motion)[3];
    let by_appell = g.by_appell(&motion)[3];
    let axial_acceleration = s.dw.x * s.l.x + s.dw.y * s.l.y + s.dw.z * s.l.z;
    let dp = letter("ṗ′");
    let with_dp = by_momentum.substitute(&[(s.ddphi, dp - axial_acceleration)]);
    page.claim(
        "eq2.9",
        "rotor",
        r"The rotor's equation about $l$ is (2.9), with $\ddot\varphi' = \dot p' - \dot\omega\cdot l$ from (2.7)",
    )
    .under(&s.unit_axis)
    .holds([Line::equation(with_dp, s.axial * dp, s.torque)]);
    for (slug, residual, route) in [
        ("by-momentum", by_momentum, "The angular momentum of the rotor gives"),
        ("by-appell", by_appell, "Appell's equations give"),
    ] {
        page.claim("eq2.10", slug, format!("{route} (2.10), the equation of the rotor's rotation"))
            .under(&s.unit_axis)
            .holds([Line::equation(residual, s.axial * (axial_acceleration + s.ddphi), s.torque)]);
    }
}

/// Three component formulas of a claim.
pub fn formulas(names: Vector3<Sym>, derived: Vector3<Sym>, printed: Vector3<Sym>) -> Vec<Line> {
    (0..3).map(|i| Line::formula(derived[i], names[i], printed[i])).collect()
}
