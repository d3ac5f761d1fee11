//! Section 7.1: statement 3 without weight (Gamma = 0), tested by the relations (6.5).

use super::alphabet::{cyclic, letter, one};
use super::gyrostats;
use super::letters::Letters;
use super::relations::{Relations, coefficients_of, no_speed, scaling, unit, zeros};
use claims::{Condition, Line, Page};
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;
use systems::gyrostat::{Carrier, Gyrostat, Rotor};

use Condition::{Equal, NonZero, Zero};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("7.1. Conditions without weight");
    let f = Relations::new(s);
    functions(page, s, &f);
    statement3(page, s, &f);
    formula_for_w0(page, s, &f);
    staude(page, s);
}

fn functions(page: &mut Page, s: &Letters, f: &Relations) {
    page.claim(
        "eq7.1",
        "v-and-delta",
        r"In components, $V^* = l\cdot(A^*\nu\times\nu)$ and $\Delta^* = |A^*\nu\times\nu|^2$ are (7.1)",
    )
    .holds([
        Line::formula(s.l.dot(&f.tilt), letter("V⋆"), f.v),
        Line::formula(f.tilt.dot(&f.tilt), letter("Δ⋆"), f.delta),
    ]);
    let balanced = [(s.big_gamma, Sym::ZERO)];
    page.claim(
        "eq7.2",
        "necessary",
        r"If $\Gamma=0$, the relations (6.5) multiplied by $l_i$ and added have the sum $\omega^{0\,2}V^*$, so that $V^*=0$ where $\omega^0\ne0$",
    )
    .given(zeros(f.all.map(|x| x.substitute(&balanced))))
    .given([NonZero(s.omega0)])
    .by_combination([(Zero(f.v), vec![3, 3], vec![(0, s.l.x), (1, s.l.y), (2, s.l.z)])]);
    page.claim("eq7.3", "identically-zero", r"$V^*\equiv0$ if and only if $(A_2^*-A_3^*)l_1 = (A_3^*-A_1^*)l_2 = (A_1^*-A_2^*)l_3 = 0$, since these are its coefficients")
        .follows(coefficients_of(s, f.v, s.l));
}

fn statement3(page: &mut Page, s: &Letters, f: &Relations) {
    let balanced = [(s.big_gamma, Sym::ZERO)];
    let at_rest = [(s.big_gamma, Sym::ZERO), (s.omega0, Sym::ZERO)];
    page.claim(
        "statement3A",
        "rest",
        r"Without weight $\omega^0=0$ satisfies (6.5) for every $\nu$, which is variant 1 of statement 3A",
    )
    .in_words()
    .follows(f.all.iter().map(|x| Zero(x.substitute(&at_rest))));
    page.claim(
        "statement3A",
        "rotation",
        r"Without weight (6.5) gives $\omega^{0\,2}V^*=0$: either the carrier rests (variant 1) or (7.2) holds (variant 2), and there is no third case",
    )
    .given(zeros(f.all.map(|x| x.substitute(&balanced))))
    .by_combination([(Zero(s.omega0.powi(2) * f.v), vec![], vec![(0, s.l.x), (1, s.l.y), (2, s.l.z)])]);
    statement3b(page, s, f);
    statement3c(page, s, f);
}

fn statement3b(page: &mut Page, s: &Letters, f: &Relations) {
    let vanishing = cyclic(|i, j, k| (s.a_star[j] - s.a_star[k]) * s.l[i]);
    page.claim(
        "statement3B",
        "identity",
        r"Under (7.3) the condition (7.2) restricts nothing: $V^* = \sum(A_2^*-A_3^*)l_1\,\nu_2\nu_3$",
    )
    .given(zeros(vanishing))
    .by_combination([(Zero(f.v), vec![], vec![(0, s.nu.y * s.nu.z), (1, s.nu.z * s.nu.x), (2, s.nu.x * s.nu.y)])]);
    for (slug, example) in
        [("any-direction", gyrostats::spherical()), ("any-direction-symmetric", gyrostats::symmetric())]
    {
        let draft = page
            .claim(
                "statement3B",
                slug,
                format!(
                    r"Under (7.3) every direction is an axis of rotation: (6.5) has a solution $\omega^0\ne0$ ({})",
                    example.name
                ),
            )
            .given(zeros(vanishing))
            .given([Zero(s.big_gamma), NonZero(f.spin)])
            .given(unit(s))
            .why(r"(7.2) is one projection of (6.5), along $l$. Under (7.3) it is empty, and the other components of (6.5) decide.");
        no_speed(draft, s, f, &example);
        if slug == "any-direction" {
            page.claim("statement3B", "spherical", r"With equal moments (6.5) is $\omega^0A'\Omega\,l\times\nu = 0$, so that the rotor's axis is the only axis of rotation (for the converse see statement3E/parallel)")
                .given([Zero(s.a_star.x - s.a_star.y), Zero(s.a_star.y - s.a_star.z), NonZero(s.omega0), NonZero(f.spin)])
                .given(zeros(f.all.map(|x| x.substitute(&[(s.big_gamma, Sym::ZERO)]))))
                .by_combination((0..3).map(|i| {
                    // w0 A' W u_i = F_i - w0^2 G_i, and G_i = (A_j - A_k) nu_j nu_k
                    let n = s.nu;
                    let w2 = s.omega0.powi(2);
                    let cofactors = match i {
                        0 => vec![(4, one()), (1, -(w2 * n.y * n.z))],
                        1 => vec![(5, one()), (0, w2 * n.z * n.x), (1, w2 * n.z * n.x)],
                        _ => vec![(6, one()), (0, -(w2 * n.x * n.y))],
                    };
                    (Zero(f.axis[i]), vec![2, 3], cofactors)
                }));
        } else {
            let along_first = [
                (s.big_gamma, Sym::ZERO),
                (s.l.x, one()),
                (s.l.y, Sym::ZERO),
                (s.l.z, Sym::ZERO),
                (s.a_star.z, s.a_star.y),
            ];
            let factor = (s.a_star.x - s.a_star.y) * s.omega0 * s.nu.x + f.spin;
            page.claim("statement3B", "symmetric", r"With $A_2^*=A_3^*\ne A_1^*$, $l=\xi_1$ (6.5) is $\omega^0[(A_1^*-A_2^*)\omega^0\nu_1 + A'\Omega]\,(0,-\nu_3,\nu_2) = 0$. A direction with $\nu_1\ne0$ that is not the axis has exactly one $\omega^0\ne0$, the bracket's zero. A direction across the axis has none, and on the axis every $\omega^0$ is a solution")
        .in_words()
                .follows((0..3).map(|i| {
                    let direction = [Sym::ZERO, -s.nu.z, s.nu.y][i];
                    Equal(f.all[i].substitute(&along_first), s.omega0 * factor * direction)
                }));
        }
        page.correct();
    }
}

fn statement3c(page: &mut Page, s: &Letters, f: &Relations) {
    page.claim(
        "statement3C",
        "cone",
        r"Where (7.3) fails, $V^*=0$ is a cone of the second order: $V^*$ is a quadratic form that is not zero",
    )
    .follows(coefficients_of(s, f.v, s.l).into_iter().chain([scaling(s, f.v, 2)]));
    let example = gyrostats::principal_axis();
    let draft = page
        .claim("statement3C", "every-axis", format!(r"About every axis of the cone there is a rotation with some $\omega^0\neq0$ ({})", example.name))
        .given([Zero(f.v), Zero(s.big_gamma), NonZero(f.spin)])
        .given(unit(s))
        .why(r"The principal axes lie on every such cone, since $V^*$ has no squares; none of them is an axis of rotation unless it is the rotor's.");
    no_speed(draft, s, f, &example);
    page.claim("statement3C", "which-axes", r"On the cone, where $\Delta^*\ne0$, $\omega^0 = -A'\Omega\,G\cdot(l\times\nu)/\Delta^*$ satisfies $\omega^0G + A'\Omega\,l\times\nu = 0$ with $G=A^*\nu\times\nu$, by which it is zero only where $l\parallel\nu$ (for $\Delta^*=0$ see statement3E)")
        .in_words()
        .given([Zero(f.v), NonZero(f.delta), Equal(s.omega0 * f.delta, -(f.spin * f.tilt.dot(&f.axis)))])
        .by_combination((0..3).map(|i| {
            // Delta (w0 G + A'W u) = A'W V (G x nu) + G (w0 Delta + A'W G.u)
            (Zero(f.balanced[i]), vec![1], vec![(0, f.spin * f.tilt.cross(&s.nu)[i]), (2, f.tilt[i])])
        }));
    page.correct();
}

/// Claims on statements 3D and 3E.
fn formula_for_w0(page: &mut Page, s: &Letters, f: &Relations) {
    let bracket = f.tilt.dot(&f.axis);
    let premises = || zeros(f.balanced).into_iter().chain([NonZero(f.delta), NonZero(s.omega0)]).collect::<Vec<_>>();
    let example = gyrostats::opposite_sign();
    page.claim("statement3D", "formula", format!(r"Statement 3D gives $\omega^0 = +\frac{{A'\Omega}}{{\Delta^*}}[(A_2^*-A_3^*)\nu_2\nu_3(l_2\nu_3-l_3\nu_2)+\dots]$, with the sign as printed ({})", example.name))
        .given(premises())
        .given([Zero(s.big_gamma), Zero(f.v)])
        .given(unit(s))
        .why(r"The relations read $\omega^0G + A'\Omega\,l\times\nu = 0$; multiplied by $G$ they give a minus sign. The bodies' equations of motion at the example confirm the corrected sign exactly.")
        .refuted([Equal(s.omega0, f.spin / f.delta * bracket)], example.point(s));
    page.claim(
        "statement3D",
        "formula-corrected",
        r"$\omega^0 = -\frac{A'\Omega}{\Delta^*}\,G\cdot(l\times\nu)$ with $G=A^*\nu\times\nu$ is the only $\omega^0\ne0$ that satisfies (6.5) without weight",
    )
    .given(premises())
    .by_combination([(
        Equal(s.omega0, -(f.spin / f.delta * bracket)),
        vec![3],
        vec![(0, f.tilt.x), (1, f.tilt.y), (2, f.tilt.z)],
    )]);
    page.correct();
    let turned: Vec<(Sym, Sym)> = s.nu.iter().map(|&n| (n, -n)).collect();
    page.claim(
        "statement3D",
        "opposite-direction",
        r"Under $\nu\to-\nu$ the product $G\cdot(l\times\nu)$ changes its sign, while $\Delta^*$ and $V^*$ do not. Therefore $\omega^0$ of statement 3D changes its sign",
    )
    .in_words()
    .follows([
        Equal(bracket.substitute(&turned), -bracket),
        Equal(f.delta.substitute(&turned), f.delta),
        Equal(f.v.substitute(&turned), f.v),
    ]);
    page.claim(
        "statement3E",
        "parallel",
        r"Where $\Delta^*=0$, the sum of the squares of $G=A^*\nu\times\nu$, and $l\times\nu=0$, every $\omega^0$ satisfies $\omega^0G + A'\Omega\,l\times\nu=0$",
    )
    .in_words()
    .given(zeros(f.tilt))
    .given(zeros(f.axis))
    .by_combination((0..3).map(|i| (Zero(f.balanced[i]), vec![], vec![(i, s.omega0), (3 + i, f.spin)])));
    page.claim(
        "statement3E",
        "not-parallel",
        r"Where $\Delta^*=0$, so that $G=A^*\nu\times\nu=0$, a rotation without weight needs $l\times\nu=0$",
    )
    .given(zeros(f.tilt))
    .given(zeros(f.balanced))
    .given([NonZero(f.spin)])
    .by_combination((0..3).map(|i| (Zero(f.axis[i]), vec![6], vec![(3 + i, one()), (i, -s.omega0)])));
}

/// Claims on the cone of Staude, from the bodies without a rotor.
fn staude(page: &mut Page, s: &Letters) {
    let zero = Vector3::repeat(Sym::ZERO);
    let (mass, gravity) = (letter("m⁰"), letter("g"));
    let body = Gyrostat {
        carrier: Carrier {
            mass,
            centre: s.e * (s.big_gamma / (mass * gravity)),
            inertia: Matrix3::from_diagonal(&s.a),
        },
        rotor: Rotor { mass: Sym::ZERO, centre: zero, axis: s.l, axial: Sym::ZERO, transverse: Sym::ZERO },
        gravity,
    };
    let [x, y, z, _] = body.by_momentum(&s.stationary(Sym::ZERO, Sym::ZERO));
    let moments: Vec<(Sym, Sym)> = (0..3).map(|i| (s.a_star[i], s.a[i])).collect();
    let to_weight: Vec<(Sym, Sym)> = (0..3).map(|i| (s.l[i], s.e[i])).collect();
    let cone = s.v_star().substitute(&to_weight).substitute(&moments);
    page.claim("section7.1-staude", "analogy", r"A heavy body without rotor (moments here $A_i$) rotates uniformly only about axes of the cone that $V^*$ becomes with $l\to e$: $e\cdot(6.5) = \omega^{0\,2}\,V^*|_{l\to e}$")
        .in_words()
        .under(&s.unit_axis)
        .follows([Equal(-s.e.dot(&Vector3::new(x, y, z)), s.omega0.powi(2) * cone)]);
}
