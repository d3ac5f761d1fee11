//! Section 7: the control torques (19), their singularity, their parts, and the force function (20).

use super::alphabet::{dot, indexed, int, letter, letters};
use super::top::{TopLetters, half, vector};
use claims::{Condition, Line, Page};
use field::{Scalar, Tangent};
use nalgebra::Vector3;
use symbolic::{Hypotheses, Sym, linear};
use systems::variable_top::{Attitude, poisson, prescribing, rates};

use Condition::{Equal, NonZero, Zero};

pub fn claims(page: &mut Page, s: &TopLetters) {
    page.section("7. The inverse problem: moments");
    solution(page, s);
    kinematics(page, s);
    moments(page, s);
    force_function(page, s);
    page.section("7. The inverse problem: where the axis does not nod");
    singular(page, s);
    permanent(page, s);
}

/// Claims on (19) from (18).
fn solution(page: &mut Page, s: &TopLetters) {
    let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (s.at.spin.into(), s.at.vertical.into());
    let h = letters(["h₁", "h₂", "h₃"]);
    let [h1, h2, h3] = h;
    let rows = [[p, q, r], [g1, g2, g3], [Sym::ZERO, Sym::ZERO, Sym::ONE]];
    let found = linear::solve(&rows, &h, &Hypotheses::none()).map_or(vec![Sym::UNDEFINED; 3], |s| s.values());
    let [x, y, z] = letters(["X̃", "Ỹ", "Z̃"]);
    let delta = s.delta();
    page.claim("eq19", "first", r"Cramer's rule gives $\tilde X$ and $\tilde Z$ of (19) from (18)").holds([
        Line::formula(found[0], x, (g2 * h1 - q * h2 + (q * g3 - r * g2) * h3) / delta),
        Line::formula(found[2], z, h3),
    ]);
    page.claim("eq19", "second", r"(19) gives $\tilde Y$ as printed, from (18)")
        .why(r"$\gamma_3h_1$ stands where $\gamma_1h_1$ should stand.")
        .fails([Line::formula(found[1], y, (p * h2 - g3 * h1 + (r * g1 - p * g3) * h3) / delta)]);
    page.claim(
        "eq19",
        "second-corrected",
        r"$\tilde Y$ by Cramer's rule from (18) has $\gamma_1h_1$ in the place of $\gamma_3h_1$",
    )
    .holds([Line::formula(found[1], y, (p * h2 - g1 * h1 + (r * g1 - p * g3) * h3) / delta)]);
    page.correct();
}

/// Claims on Gamma.
fn kinematics(page: &mut Page, s: &TopLetters) {
    let (gamma, free): (Vector3<Sym>, Vector3<Sym>) = (s.at.vertical, indexed::<3>("Γ#").into());
    let c: Vector3<Sym> = indexed::<3>("cᵞ#").into();
    let along = letter("k₄₄") * letter("f₄");
    let square = gamma.dot(&gamma);
    let general = gamma.cross(&c) + gamma * (along / square);
    page.claim("eq19", "vertical", r"$\Gamma_1=c_3\gamma_2-c_2\gamma_3+\gamma_1\gamma^{-2}k_{44}f_4$ and its permutations solve $\gamma\cdot\Gamma=k_{44}f_4$, for every $c$ (by (18) corrected, $\frac12k_{44}f_4$)")
        .in_words()
        .given([NonZero(square)])
        .follows([Equal(gamma.dot(&general), along)]);
    let turned = gamma.cross(&free.cross(&gamma));
    page.claim("eq19", "vertical-all", r"Every solution of $\gamma\cdot\Gamma=k_{44}f_4$ has the form of (19), with $c=\gamma^{-2}\,\Gamma\times\gamma$")
        .given([NonZero(square), Equal(gamma.dot(&free), along)])
        .by_combination(
            (0..3).map(|i| (Equal(free[i], (turned[i] + gamma[i] * along) / square), vec![0], vec![(1, gamma[i])])),
        );
}

/// The contributions to 2 h_1, h_2, h_3 of the rates of A, C and M z_c.
fn by_variation(s: &TopLetters) -> [Sym; 3] {
    let of = |top| rates(&top, &s.at, s.aim, Vector3::zeros(), poisson(&s.at));
    let (varying, constant) = (of(s.top), of(s.constant()));
    [
        constant.energy - varying.energy,
        constant.vertical_momentum - varying.vertical_momentum,
        constant.axial_momentum - varying.axial_momentum,
    ]
}

/// Claims on M_x, M_y, M_z and X, Y, Z.
fn moments(page: &mut Page, s: &TopLetters) {
    let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (s.at.spin.into(), s.at.vertical.into());
    let [da, dc, m, dm, z, dz, g] = letters(["Ȧ", "Ċ", "M", "Ṁ", "zc", "żc", "g"]);
    let [twice, _, _] = by_variation(s);
    let spinning = -da * (p * p + q * q) - dc * r * r;
    page.claim("section7-moments", "h1", r"$2\tilde h_1$ is the expression printed below (19)")
        .why(r"The factor 2 of the whole is missing in the last term, and $\dot M$ in the third.")
        .fails([Line::formula(
            twice,
            letter("2h̃₁"),
            spinning - int(2) * m * g * g3 * dz + half(s.tide * (da - dc) * g3 * g3),
        )]);
    let right = spinning - int(2) * g * g3 * (m * dz + dm * z) + s.tide * (da - dc) * g3 * g3;
    page.claim("section7-moments", "h1-corrected", r"The rates of $A$, $C$ and $Mz_c$ give $2\tilde h_1$: the last term is twice the printed one, and $\dot M$ occurs")
        .holds([Line::formula(twice, letter("2h̃₁"), right)]);
    page.correct();

    let needed = prescribing(&s.top, &s.at, s.aim, [Sym::ZERO; 3]).unwrap_or(Vector3::repeat(Sym::UNDEFINED));
    let field = s.now().moment_of_field(s.at.vertical);
    let others = needed - field;
    let [mx, my, mz] = letters(["Mx", "My", "Mz"]);
    let (h1, delta) = (half(right), s.delta());
    page.claim("section7-moments", "others", r"The moments are $M_x=\gamma_2\tilde h_1/\Delta$, $M_y=p\tilde h_1/\Delta$, $M_z=0$ as printed, with $\Delta=p\gamma_2-q\gamma_1$ and the right $\tilde h_1$")
        .why(r"In $M_y$, $p$ stands where $-\gamma_1$ should stand, and $\tilde h_2$, $\tilde h_3$, the changes of $f_2$, $f_3$ with $A$ and $C$, are left out.")
        .fails([
            Line::formula(others.x, mx, g2 * h1 / delta),
            Line::formula(others.y, my, p * h1 / delta),
            Line::formula(others.z, mz, Sym::ZERO),
        ]);
    let (h2, h3) = (-da * (p * g1 + q * g2) - dc * r * g3, -dc * (r - s.aim));
    page.claim("section7-moments", "others-corrected", r"These moments, added to $X$, $Y$, $Z$, keep $f_1,f_2,f_3$ while $A$, $C$, $Mz_c$ change, with $\tilde h_2=-\dot A(p\gamma_1+q\gamma_2)-\dot Cr\gamma_3$ and $\tilde h_3=-\dot C(r-r_0)$. With constant $A$, $C$ they are $\gamma_2\tilde h_1/\Delta$, $-\gamma_1\tilde h_1/\Delta$, $0$")
        .holds([
            Line::formula(others.x, mx, (g2 * h1 - q * h2 + (q * g3 - r * g2) * h3) / delta),
            Line::formula(others.y, my, (p * h2 - g1 * h1 + (r * g1 - p * g3) * h3) / delta),
            Line::formula(others.z, mz, h3),
        ]);
    page.correct();

    let [a, c] = letters(["A", "C"]);
    let names = letters(["X", "Yᴹ", "Z"]);
    let printed =
        [m * g * z * g2 + s.tide * (c - a) * g2 * g3, -(m * g * z * g1) + s.tide * (a - c) * g3 * g1, Sym::ZERO];
    page.claim("section7-moments", "field", r"$X$, $Y$, $Z$ are the moments of the force function, $\operatorname{grad}U\times\gamma$ (the text calls them projections of the force)")
        .holds((0..3).map(|i| Line::formula(field[i], names[i], printed[i])));
    let constant = prescribing(&s.constant(), &s.at, s.aim, [Sym::ZERO; 3]);
    let constant = constant.unwrap_or(Vector3::repeat(Sym::UNDEFINED));
    page.claim(
        "section7-moments",
        "constant",
        r"For constant $A$, $C$, $Mz_c$ the moments that keep the integrals are $X$, $Y$, $Z$ as printed, because $\Delta$ cancels",
    )
    .in_words()
    .given([NonZero(delta)])
    .follows((0..3).map(|i| Equal(constant[i], printed[i])));
}

/// Claims on (20) from Newton's law for a mass point, to second order in its distance from the fixed point divided by
/// R.
fn force_function(page: &mut Page, s: &TopLetters) {
    type Twice = Tangent<Tangent<Sym>>;
    let fixed = |x: Sym| -> Twice { Tangent::fixed(Tangent::fixed(x)) };
    let [mass, radius, strength] = letters(["m", "R", "μ"]);
    let (place, gamma): (Vector3<Sym>, Vector3<Sym>) = (indexed::<3>("ξ#").into(), s.at.vertical);
    let scale: Twice = Tangent::moving(Tangent::variable(Sym::ZERO), Tangent::fixed(Sym::ONE));
    let from_centre = gamma.map(|g| fixed(radius * g)) + place.map(|x| fixed(x) * scale);
    let square = from_centre.dot(&from_centre);
    // two Newton steps for 1/sqrt from 1/R: exact to third order
    let step = |w: Twice| w * (Twice::int(3) - square * w * w) / Twice::int(2);
    let inverse = step(step(fixed(Sym::ONE / radius)));
    let series = inverse.value.value + inverse.value.slope + half(inverse.slope.slope);
    let across = place.dot(&place);
    let about = |axis: Vector3<Sym>| mass * (across - axis.dot(&place) * axis.dot(&place));
    let constant = strength * mass / radius + strength * mass * across / radius.powi(3);
    let printed = -(strength * mass / radius.powi(2) * gamma.dot(&place))
        - int(3) / int(2) * (strength / radius.powi(3)) * about(gamma);
    page.claim("eq20", "newton", r"Each mass point has $U=-\frac{\mu_1m}{R^2}\,\xi\cdot\gamma-\frac32\frac{\mu_1}{R^3}J_\gamma$ in the field of a centre at the distance $R$, to the second order in $\xi/R$ and up to what does not contain $\gamma$. $J_\gamma$ is its moment of inertia about $\gamma$, $A\gamma_1^2+B\gamma_2^2+C\gamma_3^2$ for the body, so that (20) is the sum")
        .under(&s.unit)
        .holds([Line::formula(strength * mass * series - constant, letter("U"), printed)]);
    let (now, [a, c, m, z]) = (s.now(), letters(["A", "C", "M", "zc"]));
    let [g1, g2, g3]: [Sym; 3] = gamma.into();
    let gravity = [(letter("g"), strength / radius.powi(2))];
    page.claim(
        "eq20",
        "body",
        r"The program's force function of the body is (20) with $g=\mu_1/R^2$, $x_c=y_c=0$, $A=B$",
    )
    .defines([Line::formula(
        now.force_function(gamma).substitute(&gravity),
        letter("U"),
        -(strength * m / radius.powi(2) * (z * g3))
            - int(3) / int(2) * (strength / radius.powi(3)) * (a * g1 * g1 + a * g2 * g2 + c * g3 * g3),
    )]);
}

/// Claims on the case p gamma_2 = q gamma_1.
fn singular(page: &mut Page, s: &TopLetters) {
    let ([p, q, r], [g1, g2, g3]): ([Sym; 3], [Sym; 3]) = (s.at.spin.into(), s.at.vertical.into());
    let ([x, y, z], [h1, h2, h3]) = (letters(["X̃", "Ỹ", "Z̃"]), letters(["h₁", "h₂", "h₃"]));
    let delta = s.delta();
    page.claim("eq19", "denominator", r"$p\gamma_2-q\gamma_1=-\dot\gamma_3$. (19) therefore does not exist where the inclination of the axis is stationary, with axis, vertical and angular velocity in one plane")
        .in_words()
        .follows([Equal(delta, -poisson(&s.at).z)]);
    page.claim("eq19", "compatible", r"Where $p\gamma_2=q\gamma_1$ (18) has a solution only if $p(h_2-\gamma_3h_3)=\gamma_1(h_1-rh_3)$ and $q(h_2-\gamma_3h_3)=\gamma_2(h_1-rh_3)$")
        .given([
            Equal(p * x + q * y + r * z, h1),
            Equal(g1 * x + g2 * y + g3 * z, h2),
            Equal(z, h3),
            Zero(delta),
        ])
        .by_combination([
            (
                Equal(p * (h2 - g3 * h3), g1 * (h1 - r * h3)),
                vec![],
                vec![(0, g1), (1, -p), (2, p * g3 - r * g1), (3, y)],
            ),
            (
                Equal(q * (h2 - g3 * h3), g2 * (h1 - r * h3)),
                vec![],
                vec![(0, g2), (1, -q), (2, q * g3 - r * g2), (3, -x)],
            ),
        ]);
    page.claim("eq19", "not-unique", r"Where $p\gamma_2=q\gamma_1$ a solution of (18) is not the only one. Moments along $(-q,p,0)$ and $(-\gamma_2,\gamma_1,0)$, across the plane of axis, vertical and angular velocity, change neither $f_1$ nor $f_2$")
        .given([Zero(delta)])
        .by_combination([
            (Zero(dot([p, q], [-g2, g1])), vec![], vec![(0, int(-1))]),
            (Zero(dot([g1, g2], [-q, p])), vec![], vec![(0, int(1))]),
        ]);
}

/// Claims on the permanent rotation p = q = gamma_1 = gamma_2 = 0, gamma_3 = 1, r = r_0, under any torque.
fn permanent(page: &mut Page, s: &TopLetters) {
    let zero = Sym::ZERO;
    let at = Attitude { spin: Vector3::new(zero, zero, s.aim), vertical: Vector3::new(zero, zero, Sym::ONE) };
    let moment = vector(["X̃", "Ỹ", "Z̃"]);
    let found = rates(&s.top, &at, s.aim, moment, poisson(&at));
    let [da, dc, g] = letters(["Ȧ", "Ċ", "g"]);
    let [_, change] = s.static_moment();
    let names = letters(["ḟ₁", "ḟ₂", "ḟ₃"]);
    page.claim("eq19", "permanent", r"On the permanent rotation (22), $p=q=\gamma_1=\gamma_2=0$, (19) is 0/0. $X$, $Y$ do not enter at all, $\dot f_2-\dot f_3=\dot Cr_0$ and $\dot f_1-2r_0\dot f_3=\dot Cr_0^2+2g(Mz_c)^{\textstyle\cdot}-\frac{3g}R(\dot A-\dot C)$ whatever the moments. There are therefore integrals (17) only if $\dot Cr_0=0$ and $2g(Mz_c)^{\textstyle\cdot}=\frac{3g}R(\dot A-\dot C)$")
        .holds([
            Line::equation(
                names[1] - names[2] - found.vertical_momentum + found.axial_momentum,
                names[1] - names[2],
                dc * s.aim,
            ),
            Line::equation(
                names[0] - int(2) * s.aim * names[2] - found.energy + int(2) * s.aim * found.axial_momentum,
                names[0] - int(2) * s.aim * names[2],
                dc * s.aim * s.aim + int(2) * g * change - s.tide * (da - dc),
            ),
        ]);
}
