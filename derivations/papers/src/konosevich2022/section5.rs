//! Section 5: the second form, in the principal axes of A*, and its singularity D = 0.

use super::alphabet::{cyclic, letter, one, tensor, vector};
use super::gyrostats;
use super::letters::Letters;
use super::section2::formulas;
use claims::{Condition, Line, Page, Point};
use field::Rational;
use mechanics::rotation::{determinant, quaternion};
use nalgebra::{Matrix3, Vector3};
use symbolic::{Hypotheses, Sym};
use systems::gyrostat::MotionInstant;
use systems::gyrostat::forms::{Form, SecondForm};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("5. Second form of the equations");
    second_form(page, s);
    rotor(page, s);
    determinant_identity(page, s);
    singular(page, s);
    agree(page, s);
}

/// D as printed in (5.4).
pub fn singularity(s: &Letters) -> Sym {
    let (a, l) = (s.a_star, s.l);
    one() - s.axial * l.x.powi(2) / a.x - s.axial * l.y.powi(2) / a.y - s.axial * l.z.powi(2) / a.z
}

/// The right-hand sides of (5.2).
fn right(s: &Letters) -> Vector3<Sym> {
    let (a, w, l, nu, e) = (s.a_star, s.w, s.l, s.nu, s.e);
    cyclic(|_, j, k| {
        (a[j] - a[k]) * w[j] * w[k]
            + s.axial * (s.dgamma + s.omega_field) * (l[j] * w[k] - l[k] * w[j])
            + s.big_gamma * (e[j] * nu[k] - e[k] * nu[j])
    })
}

fn second_form(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a_star();
    let (a, l) = (s.a_star, s.l);
    let [x, _] = g.angular_momentum(s.w, s.dphi);
    page.claim("eq5.1", "momentum", "$x$ in the principal axes of $A^*$ has the components (5.1)")
        .under(&s.unit_axis)
        .holds(formulas(vector("x"), x, cyclic(|i, _, _| a[i] * s.w[i] + s.axial * s.dphi * l[i])));
    let motion = s.motion_from_field();
    for (slug, says, residual) in [
        (
            "carrier",
            "The theorem of angular momentum gives (5.2), the second form of the carrier's equations",
            g.by_momentum(&motion),
        ),
        (
            "by-appell",
            "Appell's equations, from the acceleration energy of the mass points, give (5.2), the second form of the carrier's equations",
            g.by_appell(&motion),
        ),
    ] {
        page.claim("eq5.2", slug, says).under(&s.unit_axis).holds(
            (0..3).map(|i| Line::equation(residual[i], a[i] * s.dw[i] + s.axial * s.ddgamma * l[i], right(s)[i])),
        );
    }
    let form = SecondForm::new(s.a_star, l, s.axial, s.e * s.big_gamma);
    let (dw, ddphi) = form.accelerations(s.w, s.nu, s.dphi, s.torque);
    let motion = MotionInstant { angular_acceleration: dw, rotor_acceleration: ddphi, ..s.motion() };
    page.claim("eq5.2", "runs", "In the second form, the accelerations that the program integrates satisfy the angular momentum equations of the mass points")
        .under(&s.unit_axis)
        .follows(g.by_momentum(&motion).map(Condition::Zero));
}

/// The rotor's equation after elimination of the carrier's accelerations, derived from the equations of the mass
/// points.
fn eliminated(s: &Letters) -> Sym {
    let [r1, r2, r3, rotor] = s.in_axes_of_a_star().by_momentum(&s.motion_from_field());
    let at_rest = s.dw.map(|dw| (dw, Sym::ZERO));
    let solved: Vec<(Sym, Sym)> = [r1, r2, r3]
        .into_iter()
        .enumerate()
        .map(|(i, residual)| (s.dw[i], -(residual.substitute(at_rest.as_slice()) / s.a_star[i])))
        .collect();
    rotor.substitute(&solved)
}

fn rotor(page: &mut Page, s: &Letters) {
    let (a, w, l, nu, e) = (s.a_star, s.w, s.l, s.nu, s.e);
    let weighted = |v: Vector3<Sym>| l.x / a.x * v.x + l.y / a.y * v.y + l.z / a.z * v.z;
    let inertial = cyclic(|_, j, k| (a[j] - a[k]) * w[j] * w[k]);
    let left = s.axial * singularity(s) * s.ddgamma;
    let right = -(s.axial * weighted(inertial))
        - s.axial.powi(2) * (s.dgamma + s.omega_field) * weighted(l.cross(&w))
        - s.axial * s.big_gamma * weighted(e.cross(&nu))
        + s.torque;
    let derived = eliminated(s);
    page.claim("eq5.3", "rotor", "The rotor's equation with the carrier's accelerations eliminated is (5.3)")
        .under(&s.unit_axis)
        .holds([Line::equation(derived, left, right)]);
    page.claim(
        "section5.1",
        "elimination",
        r"(5.3) is the rotor's equation (4.5) with $\dot\omega_i$ from (5.2) put in",
    )
    .in_words()
    .under(&s.unit_axis)
    .follows([Condition::Equal(
        derived,
        s.axial * s.ddgamma
            + s.axial * cyclic(|i, _, _| l[i] * (self::right(s)[i] - s.axial * s.ddgamma * l[i]) / a[i]).sum()
            - s.torque,
    )]);
    page.claim("eq5.4", "coefficient", r"The coefficient of $\ddot\gamma$ in (5.3) is $A'D$")
        .reading(r"The text has $AD$ here; (5.3) shows the prime.")
        .under(&s.unit_axis)
        .holds([Line::formula(derived.diff(s.ddgamma) / s.axial, letter("D"), singularity(s))]);
}

fn determinant_identity(page: &mut Page, s: &Letters) {
    let tensor = s.in_axes_of_a_star().reduced_tensor();
    let (a, l) = (s.a_star, s.l);
    page.claim(
        "section5.2-det",
        "components",
        r"The components are $\tilde A_{ii} = A^*_i - A'l_i^2$ and $\tilde A_{ij} = -A'l_il_j$",
    )
    .under(&s.unit_axis)
    .follows((0..3).flat_map(|i| {
        let j = (i + 1) % 3;
        [
            Condition::Equal(tensor[(i, i)], a[i] - s.axial * l[i].powi(2)),
            Condition::Equal(tensor[(i, j)], -(s.axial * l[i] * l[j])),
            Condition::Equal(tensor[(j, i)], -(s.axial * l[i] * l[j])),
        ]
    }));
    let product = a.x * a.y * a.z;
    let name = letter("det Ã");
    page.claim("section5.2-det", "determinant", r"The determinant is $\det\tilde A = A_1^*A_2^*A_3^*D$")
        .under(&s.unit_axis)
        .holds([Line::formula(determinant(&tensor), name, product * singularity(s))]);
    // e_i = l_i sqrt(A'), so e_i e_j = A' l_i l_j
    let scaled = Matrix3::from_fn(|i, j| {
        let dyad = s.axial * l[i] * l[j] / a[i];
        if i == j { one() - dyad } else { -dyad }
    });
    page.claim(
        "section5.2-det",
        "scaled",
        r"$\det\tilde A$ is $A_1^*A_2^*A_3^*$ times the printed determinant, with $\varepsilon_i = l_i\sqrt{A'}$",
    )
    .under(&s.unit_axis)
    .holds([Line::formula(determinant(&tensor), name, product * determinant(&scaled))]);
}

/// Claims on the zeros of D. D is invariant; here the first axis is along l, and A = C C^T with C upper triangular.
fn singular(page: &mut Page, s: &Letters) {
    let c = |index: &str| Sym::named(&format!("C{index}"), &format!("C_{{{index}}}"));
    let axial = s.axial;
    let root = Matrix3::new(c("11"), c("12"), c("13"), Sym::ZERO, c("22"), c("23"), Sym::ZERO, Sym::ZERO, c("33"));
    let reduced = root * root.transpose();
    let axis = Vector3::new(one(), Sym::ZERO, Sym::ZERO);
    let full = reduced + axis * axis.transpose() * axial;
    let d = determinant(&reduced) / determinant(&full);
    let positive = [c("11"), c("22"), c("33"), axial].map(Condition::Positive);
    page.claim(
        "section5.2-singular",
        "regular",
        "If $A$ is positive definite, $0 < D < 1$. Here $A = CC^T$ in axes with the first along $l$",
    )
    .given(positive)
    .by_signs([Condition::Positive(d), Condition::Positive(one() - d)]);
    page.claim("section5.2-singular", "bound", r"$D \le a/(a + A')$, where $a = l\cdot Al = l\cdot A^0l + m'|h\times l|^2$ is the moment of inertia about the rotor's axis without the rotor's own. With $A = CC^T$ in axes with the first along $l$ the difference is $A'(C_{12}^2+C_{13}^2)/((a+A')(C_{11}^2+A'))$, and $C_{12}=C_{13}=0$ where $l$ is a principal axis")
        .in_words()
        .given(positive)
        .follows([Condition::Equal(
            reduced[(0, 0)] / (reduced[(0, 0)] + axial) - d,
            axial * (c("12").powi(2) + c("13").powi(2))
                / ((reduced[(0, 0)] + axial) * (c("11").powi(2) + axial)),
        )]);
    let g = s.general();
    page.claim(
        "section5.2-singular",
        "bound-data",
        r"Expressed by the data of the bodies, $l\cdot A\,l = l\cdot A^0l + m'|h\times l|^2$",
    )
    .in_words()
    .under(&s.unit_axis)
    .follows([Condition::Equal(
        s.l.dot(&(g.reduced_tensor() * s.l)),
        s.l.dot(&(g.carrier.inertia * s.l)) + s.m_rotor * s.h.cross(&s.l).dot(&s.h.cross(&s.l)),
    )]);
    page.claim("section5.2-singular", "by-definition", r"The principal components of $A$ are positive by definition, so $D \neq 0$ for every body $S^0$")
        .given([Condition::Equal(letter("l1"), one())])
        .why(r"The carrier may be a thin rod along the rotor's axis through $O$ (moments 0, 1, 1), on which the rotor's centre lies. $A$ then has the moment 0 about $l$, $A^*$ has $A'$ there, and $D = 0$. The statement needs that the carrier has inertia about the rotor's axis: as that inertia goes to zero, so does $D$.")
        .refuted([Condition::NonZero(singularity(s))], rod(s));
    let u = vector("u");
    page.claim("section5.2-singular", "when", r"$u\cdot Au = u\cdot A^0u + m'|h\times u|^2 + B'|l\times u|^2$ for every $u$, a sum of three terms that are not negative. With $m'>0$, $B'>0$ the sum vanishes for a $u\ne0$ where all three terms do: $u\parallel l$, $h\times l=0$, $l\cdot A^0l=0$. The mass of the carrier then lies on the rotor's axis through $O$")
        .in_words()
        .under(&s.unit_axis)
        .follows([Condition::Equal(
            u.dot(&(g.reduced_tensor() * u)),
            u.dot(&(g.carrier.inertia * u))
                + s.m_rotor * s.h.cross(&u).dot(&s.h.cross(&u))
                + s.transverse * s.l.cross(&u).dot(&s.l.cross(&u)),
        )]);
    page.correct();
}

fn rod(s: &Letters) -> Point {
    let rod = gyrostats::rod();
    let components = |names: Vector3<Sym>, values: Vector3<Rational>| (0..3).map(move |i| (names[i], values[i]));
    let axial = [(s.axial, rod.rotor.axial)];
    Point::of(components(s.l, rod.rotor.axis).chain(axial).chain(components(s.a_star, rod.full_tensor().diagonal())))
}

/// Claims: both forms describe one motion; first with full tensors in common axes, then each in its own axes.
fn agree(page: &mut Page, s: &Letters) {
    let tensor = tensor("A");
    let full = tensor + s.l * s.l.transpose() * s.axial;
    let weight = s.e * s.big_gamma;
    let first = |a: Matrix3<Sym>,
                 w: Vector3<Sym>,
                 dw: Vector3<Sym>,
                 l: Vector3<Sym>,
                 weight: Vector3<Sym>,
                 nu: Vector3<Sym>| {
        let x = a * w + l * (s.axial * (w.dot(&l) + s.dphi));
        a * dw - x.cross(&w) - weight.cross(&nu) + l * s.torque
    };
    let second = |a: Matrix3<Sym>| {
        let x = a * s.w + s.l * (s.axial * s.dphi);
        a * s.dw + s.l * (s.axial * s.ddphi) - x.cross(&s.w) - weight.cross(&s.nu)
    };
    let rotor = s.axial * (s.l.dot(&s.dw) + s.ddphi) - s.torque;
    let gap = second(full) - first(tensor, s.w, s.dw, s.l, weight, s.nu) - s.l * rotor;
    page.claim("forms-agree", "common-axes", "The second form minus the first form minus $l$ times the rotor's equation is zero, with full symmetric tensors in arbitrary common axes, all parameters and $M$ free")
        .follows(gap.iter().map(|&x| Condition::Zero(x)));

    // own axes: those of A* are rotated by R relative to those of A
    let q = ["q0", "q1", "q2", "q3"].map(letter);
    let norm = q.iter().fold(Sym::ZERO, |sum, &c| sum + c.powi(2));
    let turn = quaternion(q);
    let back = turn.transpose();
    let covariant = turn * first(back * tensor * turn, back * s.w, back * s.dw, back * s.l, back * weight, back * s.nu);
    let here = first(tensor, s.w, s.dw, s.l, weight, s.nu);
    page.claim("forms-agree", "rotated", "The first form written in axes turned by any rotation $R(q)$, then turned back, is the first form. Each form may therefore stand in its own principal axes")
        .in_words()
        .given([Condition::NonZero(norm)])
        .follows((0..3).map(|i| Condition::Equal(covariant[i], here[i])));
    let printed_first = cyclic(|i, j, k| {
        s.a[i] * s.dw[i]
            - ((s.a[j] - s.a[k]) * s.w[j] * s.w[k]
                + s.axial * (s.w.dot(&s.l) + s.dphi) * (s.l[j] * s.w[k] - s.l[k] * s.w[j])
                + s.big_gamma * (s.e[j] * s.nu[k] - s.e[k] * s.nu[j])
                - s.l[i] * s.torque)
    });
    let in_own = first(Matrix3::from_diagonal(&s.a), s.w, s.dw, s.l, weight, s.nu);
    let printed_second = cyclic(|i, _, _| s.a_star[i] * s.dw[i] + s.axial * s.ddgamma * s.l[i] - right(s)[i]);
    let speed = [(s.dphi, s.dgamma + s.omega_field), (s.ddphi, s.ddgamma)];
    let second_own = second(Matrix3::from_diagonal(&s.a_star)).map(|x| x.substitute(&speed));
    page.claim(
        "forms-agree",
        "own-axes",
        r"The two forms with full tensors become (4.3) and (5.2) as printed where the tensors are diagonal",
    )
    .in_words()
    .follows((0..3).flat_map(|i| {
        [Condition::Equal(in_own[i], printed_first[i]), Condition::Equal(second_own[i], printed_second[i])]
    }));
    explicit(page, s, tensor);
}

/// Claims: the solved accelerations of both forms are equal as rational functions, with full tensors and arbitrary
/// data.
fn explicit(page: &mut Page, s: &Letters, tensor: Matrix3<Sym>) {
    let full = tensor + s.l * s.l.transpose() * s.axial;
    let weight = s.e * s.big_gamma;
    let x = tensor * s.w + s.l * (s.axial * (s.w.dot(&s.l) + s.dphi));
    let gain = x.cross(&s.w) + weight.cross(&s.nu);
    let first = mechanics::rotation::inverse(&tensor) * (gain - s.l * s.torque);
    let inverse = mechanics::rotation::inverse(&full);
    let response = inverse * s.l;
    let d = one() - s.axial * s.l.dot(&response);
    let ddphi = (s.torque / s.axial - response.dot(&gain)) / d;
    let second = inverse * gain - response * (s.axial * ddphi);
    page.claim(
        "forms-agree",
        "explicit",
        r"$\dot\omega$ solved from the first and from the second form is the same rational function of all parameters",
    )
    .under(&Hypotheses::none())
    .follows((0..3).map(|i| Condition::Equal(first[i], second[i])));
}
