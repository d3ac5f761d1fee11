//! Section 7.2: statements 4 to 7 with weight (Gamma > 0), tested by the original relations (6.5), and not only by the
//! relations (7.4) and (7.7), which follow from them.

use super::alphabet::{cyclic, letter, number, one};
use super::gyrostats;
use super::letters::Letters;
use super::relations::{Relations, coefficients_of, no_speed, scaling, unit, zeros};
use claims::{Condition, Line, Page};
use nalgebra::Vector3;
use symbolic::Sym;
use systems::gyrostat::stationary::Stationary;

use Condition::{Equal, NonZero, Zero};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("7.2. Conditions with weight: statements 4 to 6");
    let f = Relations::new(s);
    statement4(page, s, &f);
    relations(page, s, &f);
    statement5(page, s, &f);
    statement6(page, s, &f);
    page.section("7.2. Conditions with weight: statement 7, the cone");
    statement7(page, s, &f);
    degree(page, s, &f);
}

fn statement4(page: &mut Page, s: &Letters, f: &Relations) {
    let rest = f.all.map(|x| x.substitute(&[(s.omega0, Sym::ZERO)]));
    page.claim("statement4", "rest", r"For $\Gamma\ne0$ and $\omega^0=0$, (6.5) holds if $e\times\nu=0$")
        .given(zeros(f.weight))
        .by_combination((0..3).map(|i| (Zero(rest[i]), vec![], vec![(i, s.big_gamma)])));
    page.claim("statement4", "only-if", r"For $\Gamma\ne0$ and $\omega^0=0$, (6.5) holds only if $e\times\nu=0$")
        .given(zeros(rest))
        .given([NonZero(s.big_gamma)])
        .by_combination((0..3).map(|i| (Zero(f.weight[i]), vec![3], vec![(i, one())])));
    let both = s.unit_vertical.clone().unit_vector(s.e.into());
    page.claim(
        "statement4",
        "vertical",
        r"$(e\cdot\nu)^2 = 1 - |e\times\nu|^2$, so that the centre of mass is above or below $O$ where $e\times\nu=0$",
    )
    .in_words()
    .under(&both)
    .follows([Equal(s.e.dot(&s.nu).powi(2), one() - f.weight.dot(&f.weight))]);
}

/// Claims on (7.4) to (7.8).
fn relations(page: &mut Page, s: &Letters, f: &Relations) {
    let g = s.in_axes_of_a_star();
    let [x, y, z, _] = g.by_momentum(&s.stationary(s.omega_field, Sym::ZERO));
    let moments = -Vector3::new(x, y, z);
    page.claim("eq7.4", "first-power", r"(7.4) is (6.5) multiplied by $e_i$ and added, divided by $\omega^0$")
        .under(&s.unit_axis)
        .holds([Line::equation(s.e.dot(&moments) / s.omega0, s.omega0 * f.s - f.spin * f.pi, Sym::ZERO)]);
    page.claim("eq7.5", "s", r"(7.5) is $S^* = e\cdot(A^*\nu\times\nu)$").holds([Line::formula(
        s.e.dot(&f.tilt),
        letter("S⋆"),
        f.s,
    )]);
    page.claim("eq7.6", "pi", r"(7.6) is $\Pi^* = \nu\cdot(l\times e)$").holds([Line::formula(
        s.nu.dot(&s.l.cross(&s.e)),
        letter("Π⋆"),
        f.pi,
    )]);
    page.claim("eq7.7", "second-power", r"(7.7) is (6.5) multiplied by $l_i$ and added")
        .under(&s.unit_axis)
        .holds([Line::equation(s.l.dot(&moments), s.omega0.powi(2) * f.v + s.big_gamma * f.pi, Sym::ZERO)]);
    page.claim(
        "eq7.8",
        "identically-zero",
        r"$S^*\equiv0$ if and only if $(A_2^*-A_3^*)e_1 = (A_3^*-A_1^*)e_2 = (A_1^*-A_2^*)e_3 = 0$",
    )
    .follows(coefficients_of(s, f.s, s.e));
}

/// The left-hand sides of (7.4) and (7.7).
fn derived(s: &Letters, f: &Relations) -> [Sym; 2] {
    [s.omega0 * f.s - f.spin * f.pi, s.omega0.powi(2) * f.v + s.big_gamma * f.pi]
}

fn statement5(page: &mut Page, s: &Letters, f: &Relations) {
    let vanishing = cyclic(|i, j, k| (s.a_star[j] - s.a_star[k]) * s.e[i]);
    page.claim("statement5", "condition", r"Under (7.8) $S^*\equiv0$, and (7.4) becomes $A'\Omega\,\Pi^* = 0$")
        .in_words()
        .given(zeros(vanishing))
        .by_combination([(
            Equal(derived(s, f)[0], -(f.spin * f.pi)),
            vec![],
            vec![(0, s.omega0 * s.nu.y * s.nu.z), (1, s.omega0 * s.nu.z * s.nu.x), (2, s.omega0 * s.nu.x * s.nu.y)],
        )]);
    let example = gyrostats::across();
    page.claim(
        "statement5",
        "only-parallel",
        format!(r"Under (7.8) a rotation needs $\Pi^*\equiv0$, that is $l\parallel e$ ({})", example.name),
    )
    .given(zeros(vanishing))
    .given(zeros(f.all))
    .given([NonZero(s.omega0), NonZero(s.big_gamma)])
    .given(unit(s))
    .why(r"(7.4) asks only that $\Pi^*$ vanish at the given $\nu$.")
    .refuted(zeros(s.l.cross(&s.e)), example.point(s));
    let along_first = [(s.e.x, one()), (s.e.y, Sym::ZERO), (s.e.z, Sym::ZERO), (s.a_star.z, s.a_star.y)];
    let stretch = s.omega0.powi(2) * (s.a_star.x - s.a_star.y) * s.nu.x + s.big_gamma;
    let vector = Vector3::new(stretch, Sym::ZERO, Sym::ZERO) + s.l * (f.spin * s.omega0);
    page.claim("statement5", "degenerate-motions", r"Under (7.8) the axes can be numbered so that $A_2^*=A_3^*$, $e=\xi_1$, equal moments included. Then (6.5) is $([\omega^{0\,2}(A_1^*-A_2^*)\nu_1+\Gamma]\,e + A'\Omega\omega^0l)\times\nu = 0$. With equal moments $\nu$ is parallel to $\Gamma e + A'\Omega\omega^0l$, which gives two directions for each $\omega^0$ at which that vector is not zero, whatever the angle between $l$ and $e$")
        .in_words()
        .follows((0..3).map(|i| Equal(f.all[i].substitute(&along_first), vector.cross(&s.nu)[i])));
    page.correct();

    let sign = letter("l⁰");
    let parallel: Vec<(Sym, Sym)> = (0..3).map(|i| (s.l[i], sign * s.e[i])).collect();
    let with_parallel = derived(s, f).map(|x| x.substitute(&parallel));
    page.claim(
        "statement5",
        "derived-relations",
        r"Under (7.8) and $l = l^0e$ (7.4) and (7.7) hold for all $\nu$ and $\omega^0$",
    )
    .in_words()
    .given(zeros(vanishing))
    .by_combination(with_parallel.map(|relation| {
        let scale = if relation == with_parallel[0] { s.omega0 } else { sign * s.omega0.powi(2) };
        (
            Zero(relation),
            vec![],
            vec![(0, scale * s.nu.y * s.nu.z), (1, scale * s.nu.z * s.nu.x), (2, scale * s.nu.x * s.nu.y)],
        )
    }));
    let example = gyrostats::along();
    page.claim(
        "statement5",
        "original-conditions",
        format!(
            r"Under (7.8) and $l\parallel e$ every $\nu$ and $\omega^0$ give a rotation, that is (6.5) holds ({})",
            example.name
        ),
    )
    .given(zeros(vanishing))
    .given(zeros(s.l - s.e))
    .given(unit(s))
    .why(
        r"$e$ and $l$ are parallel, so (7.4) and (7.7) are two copies of one projection and say nothing of the others.",
    )
    .refuted(zeros(f.all), example.point(s));
    let factor = (s.a_star.x - s.a_star.y) * s.omega0.powi(2) * s.nu.x + f.spin * s.omega0 * sign + s.big_gamma;
    let axes: Vec<(Sym, Sym)> =
        along_first.into_iter().chain([(s.l.x, sign), (s.l.y, Sym::ZERO), (s.l.z, Sym::ZERO)]).collect();
    page.claim("statement5", "original-corrected", r"Where $A_2^*=A_3^*$, $e=\xi_1$, $l=l^0e$, (6.5) is $[(A_1^*-A_2^*)\nu_1\omega^{0\,2} + A'\Omega l^0\omega^0 + \Gamma]\,e\times\nu = 0$. Then either $\nu=\pm e$ with any $\omega^0$, or $\omega^0$ is a zero of the bracket")
        .in_words()
        .follows((0..3).map(|i| {
            let direction = [Sym::ZERO, -s.nu.z, s.nu.y][i];
            Equal(f.all[i].substitute(&axes), factor * direction)
        }));
    page.correct();
}

fn statement6(page: &mut Page, s: &Letters, f: &Relations) {
    let [first, second] = derived(s, f);
    page.claim("statement6", "necessary", r"Where $S^*=0$, (7.4) and (7.7) give $\Pi^*=0$ and $V^*=0$")
        .given([Zero(first), Zero(second), Zero(f.s), NonZero(f.spin), NonZero(s.omega0)])
        .by_combination([
            (Zero(f.pi), vec![3], vec![(0, number(-1, 1)), (2, s.omega0)]),
            (Zero(f.v), vec![4, 4, 3], vec![(1, f.spin), (0, s.big_gamma), (2, -(s.big_gamma * s.omega0))]),
        ]);
    page.claim(
        "statement6",
        "derived-relations",
        r"Where $S^*=\Pi^*=V^*=0$, every $\omega^0$ satisfies (7.4) and (7.7)",
    )
    .in_words()
    .given([Zero(f.s), Zero(f.pi), Zero(f.v)])
    .by_combination([
        (Zero(first), vec![], vec![(0, s.omega0), (1, -f.spin)]),
        (Zero(second), vec![], vec![(2, s.omega0.powi(2)), (1, s.big_gamma)]),
    ]);
    let example = gyrostats::plane();
    page.claim(
        "statement6",
        "original-conditions",
        format!(r"Where $S^*=\Pi^*=V^*=0$ every $\omega^0$ gives a rotation, that is (6.5) holds ({})", example.name),
    )
    .given([Zero(f.s), Zero(f.pi), Zero(f.v)])
    .given(unit(s))
    .reading(r"The text has lost a formula before `but $S^*=0$`; it is read as $S^*\not\equiv0$, which the paragraph before statement 6 says in words.")
    .why(r"(7.4) and (7.7) hold there identically, and leave one component of (6.5) undecided.")
    .refuted(zeros(f.all), example.point(s));
    let n = f.weight;
    let quadratic = |v: Vector3<Sym>| v.dot(&n);
    page.claim("statement6", "original-corrected", r"Where $S^*=\Pi^*=0$ and $n = e\times\nu\ne0$, (6.5) is one equation, $|n|^2F = (F\cdot n)\,n$. Then $\omega^0$ is a root of $(G\cdot n)\,\omega^{0\,2} + A'\Omega(u\cdot n)\,\omega^0 + \Gamma|n|^2 = 0$ with $G=A^*\nu\times\nu$, $u=l\times\nu$, which has at most two values")
        .in_words()
        .given([Zero(f.s), Zero(f.pi)])
        .by_combination((0..3).map(|i| {
            let value = quadratic(f.tilt) * s.omega0.powi(2) + f.spin * quadratic(f.axis) * s.omega0 + s.big_gamma * n.dot(&n);
            // |n|^2 F - (F.n) n = n x (F x n), F x n = e (F.nu) - nu (F.e) = -nu (F.e), F.e = w0 (w0 S - A'W Pi)
            let direction = -n.cross(&s.nu)[i];
            (
                Equal(n.dot(&n) * f.all[i], value * n[i]),
                vec![],
                vec![(0, direction * s.omega0.powi(2)), (1, -(direction * f.spin * s.omega0))],
            )
        }));
    page.correct();
}

fn statement7(page: &mut Page, s: &Letters, f: &Relations) {
    let [first, second] = derived(s, f);
    let surface = s.big_gamma * f.s.powi(2) + f.spin.powi(2) * f.pi * f.v;
    page.claim("eq7.9", "nonzero", r"$S^*\ne0$, $\omega^0\ne0$ and (7.4) give $\Pi^*\neq0$")
        .given([Zero(first), NonZero(f.s), NonZero(s.omega0)])
        .nonvanishing(f.pi, f.spin, vec![1, 2], vec![(0, number(-1, 1))]);
    page.claim("eq7.10", "velocity", r"(7.10) is (7.4) solved for $\omega^0$")
        .given([Zero(first), NonZero(f.s)])
        .by_combination([(Equal(s.omega0, f.spin * f.pi / f.s), vec![1], vec![(0, one())])]);
    page.claim("eq7.11", "surface", r"(7.11), the surface of the directions, is (7.10) in (7.7), divided by $\Pi^*$")
        .given([Zero(first), Zero(second), NonZero(f.pi)])
        .by_combination([(
            Zero(surface),
            vec![2],
            vec![(1, f.s.powi(2)), (0, -(f.v * (s.omega0 * f.s + f.spin * f.pi)))],
        )]);
    page.claim("eq7.12", "velocity-again", r"(7.12) gives the angular velocity of (7.10) by $S^*/V^*$")
        .given([Zero(first), Zero(second), NonZero(f.pi), NonZero(f.spin), NonZero(f.v)])
        .by_combination([(
            Equal(s.omega0, -(s.big_gamma / f.spin * (f.s / f.v))),
            vec![2, 3, 4],
            vec![(1, f.s), (0, -(s.omega0 * f.v))],
        )]);
    let code = Stationary { moments: s.a_star, axis: s.l, spin: f.spin, weight: s.e * s.big_gamma };
    let (numerator, denominator) = code.speed(s.nu);
    let missing = code.residual_torque(s.nu, s.omega0);
    page.claim(
        "eq7.11",
        "runs",
        r"The program's surface is $\Gamma$ times (7.11), its angular velocity is (7.10) with $\Gamma$ in both terms of the fraction, and its missing moment is the left side of (6.5)",
    )
    .in_words()
    .follows(
        [
            Equal(code.surface(s.nu), s.big_gamma * surface),
            Equal(numerator, s.big_gamma * f.spin * f.pi),
            Equal(denominator, s.big_gamma * f.s),
        ]
        .into_iter()
        .chain((0..3).map(|i| Equal(missing[i], f.all[i]))),
    );
    let velocity = f.spin * f.pi / f.s;
    page.claim(
        "statement7",
        "sufficient",
        r"Where $S^*\ne0$ and (7.11) holds, $\omega^0$ of (7.10) satisfies the original (6.5), so that $\nu$ is an axis of rotation",
    )
    .in_words()
    .given([Zero(surface), NonZero(f.s)])
    .by_combination(
        (0..3).map(|i| (Zero(f.all[i].substitute(&[(s.omega0, velocity)])), vec![1, 1], vec![(0, f.weight[i])])),
    );
    page.claim(
        "statement7",
        "necessary",
        r"A rotation satisfies (7.4) and (7.7), by (6.5). Where $S^*\ne0$ it satisfies (7.10) and (7.11) by the claims eq7.10/velocity and eq7.11/surface",
    )
    .given(zeros(f.all))
    .given([NonZero(s.omega0)])
    .by_combination([
        (Zero(first), vec![3], vec![(0, s.e.x), (1, s.e.y), (2, s.e.z)]),
        (Zero(second), vec![], vec![(0, s.l.x), (1, s.l.y), (2, s.l.z)]),
    ]);
    page.claim("statement7", "formulas-defined", r"The formulas (7.10) and (7.12) are both defined where $S^*\ne0$, $\Gamma\ne0$ and (7.11) holds: $V^*\neq0$ by (7.11)")
        .given([Zero(surface), NonZero(f.s), NonZero(s.big_gamma)])
        .nonvanishing(f.v, -(f.spin.powi(2) * f.pi), vec![2, 1, 1], vec![(0, number(-1, 1))]);
}

/// Claims on the surface (7.11) and its cone.
fn degree(page: &mut Page, s: &Letters, f: &Relations) {
    page.claim(
        "section7.2-degree",
        "homogeneous",
        r"(7.11) is the sum of a form of degree 4, $\Gamma S^{*2}$, and one of degree 3, $(A'\Omega)^2\Pi^*V^*$",
    )
    .follows([scaling(s, f.s.powi(2), 4), scaling(s, f.pi * f.v, 3)]);
    let odd = f.spin.powi(2) * f.pi * f.v;
    let even = s.big_gamma * f.s.powi(2);
    let rule = &s.unit_vertical;
    let norm = s.nu.dot(&s.nu);
    page.claim("section7.2-degree", "cone", r"The cone over the spherical line and its mirror image has degree 8: $\Gamma^2S^{*4} - (A'\Omega)^4|\nu|^2\Pi^{*2}V^{*2}$ is on the sphere the product of the left side of (7.11) at $\nu$ and at $-\nu$")
        .in_words()
        .under(rule)
        .follows([
            Equal((even + odd) * (even - odd), even.powi(2) - odd.powi(2) * norm),
            scaling(s, even.powi(2) - odd.powi(2) * norm, 8),
        ]);
    let example = gyrostats::on_the_line();
    let draft = page
        .claim("section7.2-degree", "every-point", format!(r"Every point of the spherical line is a semi-axis of rotation ({})", example.name))
        .given([Zero(even + odd), NonZero(s.big_gamma), NonZero(f.spin)])
        .given(unit(s))
        .why(r"The six principal directions lie on the line whatever the data, since $S^*$ and $V^*$ have no squares. Where $S^*=0$ statement 6 decides.");
    no_speed(draft, s, f, &example);
    page.claim("section7.2-degree", "which-points", r"The points of the spherical line with $S^*\ne0$ are axes of rotation (statement7/sufficient). Those with $S^*=0$ have $\Pi^*V^*=0$, and a rotation needs both to vanish (statement6/necessary)")
        .given([Zero(even + odd), Zero(f.s), NonZero(f.spin)])
        .by_combination([(
            Zero(f.pi * f.v),
            vec![2, 2],
            vec![(0, one()), (1, -(s.big_gamma * f.s))],
        )]);
    page.correct();
}
