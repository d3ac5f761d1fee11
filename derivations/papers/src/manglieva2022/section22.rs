//! Section 2.2: Gauss' principle with friction, (2.10)-(2.22).

use super::alphabet::{indexed, int, letter, letters, tidy};
use super::general::{Mixed, dot, first_kind, mixed, with_friction};
use claims::{Condition, Line, Page};
use mechanics::constrained::State;
use mechanics::constrained::gauss;
use mechanics::constrained::rates::rates;
use mechanics::constrained::redundant::{Split, accelerations};
use mechanics::differentiate::{fixed, gradient};
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page) {
    page.section("2.2. Gauss' principle with friction");
    differentiated(page);
    variations(page);
    measures(page);
    least(page);
}

type Four = [Sym; 4];

/// Claims on (2.10)-(2.13).
fn differentiated(page: &mut Page) {
    let (place, velocity, second): (Four, Four, Four) = ([Sym::ZERO; 4], indexed("ẋ#"), indexed("ẍ#"));
    let [geometric, steered] = rates(&Mixed, &State { time: Sym::ZERO, place, velocity }, second);
    let [_, v2, v3, v4] = velocity;
    let v = [v2, v3, v4];
    let mut rest = letter("Ftt");
    for (i, &vi) in v.iter().enumerate() {
        rest += int(2) * letter(&format!("F{}t", i + 2)) * vi;
        for (j, &vj) in v.iter().enumerate() {
            rest += letter(&format!("F{}{}", i.min(j) + 2, i.max(j) + 2)) * vi * vj;
        }
    }
    let [_, f2, f3, f4]: Four = indexed("F#");
    let [a1, a2, a3, a4] = second;
    page.claim(
        "eq2.10",
        "differentiated",
        "(2.1) differentiated twice is linear in the accelerations, for $f=x_1-F(x_2,x_3,x_4,t)$, where $A$ is the rest",
    )
    .holds([Line::equation(geometric, a1 - f2 * a2 - f3 * a3 - f4 * a4, rest)]);
    let [p3, p4, p33, p34, p44] = letters(["Φ3", "Φ4", "Φ33", "Φ34", "Φ44"]);
    let by_place: Four = indexed("Φx#");
    page.claim(
        "eq2.11",
        "differentiated",
        r"(2.2) differentiated once is linear in the accelerations, for $\varphi=\dot x_2-\Phi$",
    )
    .holds([Line::equation(
        steered,
        a2 - (p3 + p33 * v3 + p34 * v4) * a3 - (p4 + p34 * v3 + p44 * v4) * a4,
        dot(by_place, velocity) + letter("Φt"),
    )]);
    let possible: Four = indexed("ẍ′#");
    let [rest, turned] = letters(["Af", "Bφ"]);
    page.claim("eq2.12", "possible", "(2.12) are the accelerations that (2.1) allows").defines([Line::equation(
        Sym::ZERO,
        dot(indexed("f#"), possible) + rest,
        Sym::ZERO,
    )]);
    page.claim("eq2.13", "possible", "(2.13) are the accelerations that (2.2) allows").defines([Line::equation(
        Sym::ZERO,
        dot(indexed("φ#"), possible) + turned,
        Sym::ZERO,
    )]);
}

/// Claims on (2.14)-(2.17).
fn variations(page: &mut Page) {
    let (gradient, steered): (Four, Four) = (indexed("f#"), indexed("φ#"));
    let (true_ones, possible): (Four, Four) = (indexed("ẍ#"), indexed("ẍ′#"));
    let (masses, given, friction): (Four, Four, Four) = (indexed("m#"), indexed("X#"), indexed("R#"));
    let released: Four = indexed("a#");
    let [rest, turned, lambda, u] = letters(["Af", "Bφ", "λ", "u"]);
    let varied: Four = std::array::from_fn(|i| true_ones[i] - possible[i]);
    let admissible = || {
        [
            Zero(dot(gradient, true_ones) + rest),
            Zero(dot(steered, true_ones) + turned),
            Zero(dot(gradient, possible) + rest),
            Zero(dot(steered, possible) + turned),
        ]
    };
    page.claim("eq2.14", "variations", r"$\delta\ddot x=\ddot x-\ddot x'$ satisfies the conditions on virtual displacements, those of $f$ and those of $\varphi$").reading(r"The text names (2.9), (2.12), (2.13) as the source; (2.10)-(2.13) are read, from which it follows.")
        .given(admissible())
        .by_combination([
            (Zero(dot(gradient, varied)), vec![], vec![(0, int(1)), (2, int(-1))]),
            (Zero(dot(steered, varied)), vec![], vec![(1, int(1)), (3, int(-1))]),
        ]);
    let missing: Four = std::array::from_fn(|i| masses[i] * true_ones[i] - given[i] - friction[i]);
    let motion = || (0..4).map(|i| Equal(missing[i], lambda * gradient[i] + u * steered[i]));
    page.claim(
        "eq2.15",
        "general-equation",
        r"$\sum(m\ddot x-X-R^\tau)(\ddot x-\ddot x')=0$ follows from the equations of motion (2.8)",
    )
    .given(admissible())
    .given(motion())
    .by_combination([(
        Zero(dot(missing, varied)),
        vec![],
        [(0, lambda), (2, -lambda), (1, u), (3, -u)].into_iter().chain((0..4).map(|i| (4 + i, varied[i]))).collect(),
    )]);
    let free: Four = std::array::from_fn(|i| masses[i] * released[i] - given[i] - friction[i]);
    page.claim(
        "eq2.16",
        "released",r"$\sum(ma-X-R^\tau)(\ddot x-\ddot x')=0$ holds for the system released from its constraints, which moves under $X$ and $R^\tau$ alone",
    )
    .given(free.map(Zero))
    .by_combination([(Zero(dot(free, varied)), vec![], (0..4).map(|i| (i, varied[i])).collect())]);
    let weighted: Four = std::array::from_fn(|i| masses[i] * (true_ones[i] - released[i]));
    page.claim(
        "eq2.17",
        "difference",
        r"$\sum m(\ddot x-a)(\ddot x-\ddot x')=0$ is the difference of (2.15) and (2.16)",
    )
    .given([Zero(dot(missing, varied)), Zero(dot(free, varied))])
    .by_combination([(Zero(dot(weighted, varied)), vec![], vec![(0, int(1)), (1, int(-1))])]);
}

/// The measure 1/2 sum m (a - b)^2.
fn measure(a: Four, b: Four) -> Sym {
    let masses: Four = indexed("m#");
    (0..4).fold(Sym::ZERO, |sum, i| sum + masses[i] * (a[i] - b[i]).powi(2)) / int(2)
}

/// Claims on (2.18)-(2.20).
fn measures(page: &mut Page) {
    let (masses, true_ones, possible, released): (Four, Four, Four, Four) =
        (indexed("m#"), indexed("ẍ#"), indexed("ẍ′#"), indexed("a#"));
    let product = (0..4)
        .fold(Sym::ZERO, |sum, i| sum + masses[i] * ((true_ones[i] - released[i]) * (true_ones[i] - possible[i])));
    let expanded = (0..4).fold(Sym::ZERO, |sum, i| {
        let (x, y, a) = (true_ones[i], possible[i], released[i]);
        let squares = |p: Sym, q: Sym| p.powi(2) - int(2) * p * q + q.powi(2);
        sum + masses[i] / int(2) * (squares(x, y) - squares(y, a) + squares(a, x))
    });
    let as_printed = {
        let [[x], [y], [a]] = [indexed::<1>("ẍ#"), indexed("ẍ′#"), indexed("a#")];
        let [[speed], [other], [place]] = [indexed::<1>("ẋ#"), indexed("ẋ′#"), indexed("x′#")];
        let two = int(2);
        let squares = (speed.powi(2) - two * speed * other + place.powi(2))
            - (other.powi(2) - two * other * a + a.powi(2))
            + (a.powi(2) - two * speed * a + x.powi(2));
        Line::equation(Sym::ZERO, masses[0] * ((x - a) * (x - y)), masses[0] / int(2) * squares)
    };
    page.claim("eq2.18", "identity", "The product is the sum of squares (2.18) for each coordinate as printed, with single dots or none over most letters on the right")
        .why("Dots are missing: the printed squares are those of velocities and places, not of accelerations.")
        .reading("The source shows single dots, or none, on the right and two on the left. As everywhere, lost dots are judged as printed and restored in the correction.")
        .fails([as_printed]);
    page.claim(
        "eq2.18",
        "identity-corrected",
        "The product is the sum of squares (2.18) with accelerations throughout",
    )
    .follows([Equal(product, expanded)]);
    page.correct();
    let [d_true, possible_free, between] = letters(["AdD", "AμD", "Adμ"]);
    let named = [
        Equal(d_true, measure(true_ones, released)),
        Equal(possible_free, measure(released, possible)),
        Equal(between, measure(true_ones, possible)),
        Zero(product),
    ];
    page.claim("eq2.19", "measures", r"$A_{d\mu}+A_{dD}-A_{\mu D}=0$ for the measures of deviation between true ($d$), possible ($\mu$) and released ($D$) accelerations").reading(r"The source prints $A_{\mu g}$ for the measure between possible and released accelerations; $A_{\mu D}$ is read.")
        .given(named)
        .by_combination([(
            Zero(between + d_true - possible_free),
            vec![],
            vec![(0, int(1)), (1, int(-1)), (2, int(1)), (3, int(1))],
        )]);
    let difference = measure(true_ones, possible);
    let [d1, d2, d3, d4]: Four = indexed("δẍ#");
    let shifted: Vec<(Sym, Sym)> =
        possible.into_iter().zip([d1, d2, d3, d4]).zip(true_ones).map(|((possible, d), x)| (possible, x - d)).collect();
    page.claim(
        "eq2.20",
        "differences",
        r"(2.20) are the differences $A_{\mu D}-A_{dD}=A_{d\mu}$ and $A_{\mu D}-A_{d\mu}=A_{dD}$",
    )
    .given([Zero(between + d_true - possible_free)])
    .by_combination([
        (Equal(possible_free - d_true, between), vec![], vec![(0, int(-1))]),
        (Equal(possible_free - between, d_true), vec![], vec![(0, int(-1))]),
    ]);
    page.claim("eq2.20", "strict",r"$A_{d\mu}>0$ where $\ddot x'=\ddot x-\delta\ddot x$ with $\delta\ddot x\ne0$, so that $A_{dD}<A_{\mu D}$ by (2.20)")
        .given(masses.map(Positive))
        .given([NonZero(d1)])
        .by_signs([Positive(tidy(difference.substitute(&shifted)))]);
}

/// Claims on (2.21)-(2.22).
fn least(page: &mut Page) {
    let (masses, given, friction, second): (Four, Four, Four, Four) =
        (indexed("m#"), indexed("X#"), indexed("R#"), indexed("ẍ#"));
    let released: Four = std::array::from_fn(|i| (given[i] + friction[i]) / masses[i]);
    let half = int(1) / int(2);
    let printed = half * (0..4).fold(Sym::ZERO, |sum, i| sum + masses[i] * (second[i] - released[i]).powi(2));
    let [d_true, between, possible_free] = letters(["AdD", "Adμ", "AμD"]);
    page.claim("eq2.21", "function", r"The function that the true accelerations make least is $A_{d\mu}$ as printed, the measure between true and possible accelerations")
        .why(r"The printed right side is a measure from the released accelerations, not from the possible ones.")
        .reading(r"With the letters $\ddot x_\gamma$ of the true accelerations the right side is the constant $A_{dD}$, the value of the minimum. Read as the function that is minimised, its accelerations are the possible ones, $\ddot x'_\gamma$, and its name is $A_{\mu D}$.")
        .fails([Line::formula(measure(second, indexed("ẍ′#")), between, printed)]);
    let possible: Four = indexed("ẍ′#");
    page.claim("eq2.21", "function-corrected", r"The function to be made least is $A_{\mu D}$ of the possible accelerations, with $a_\gamma=(X_\gamma+R^\tau_\gamma)/m_\gamma$. At $\ddot x'=\ddot x$ its value is $A_{dD}$")
        .holds([(possible, possible_free), (second, d_true)].map(|(at, name)| {
            let pushed = std::array::from_fn(|i| given[i] + friction[i]);
            let squares = (0..4).fold(Sym::ZERO, |sum, i| sum + masses[i] * (at[i] - released[i]).powi(2));
            Line::formula(gauss::constraint(masses, pushed, at), name, half * squares)
        }));
    page.correct();

    let force: Four = std::array::from_fn(|i| given[i] + friction[i]);
    let slopes = gradient(|second| gauss::constraint(fixed(masses), fixed(force), second), second);
    let (by_place, by_velocity): (Four, Four) = (indexed("f#"), indexed("φ#"));
    let [lambda, u] = letters(["λ", "u"]);
    page.claim("eq2.22", "stationary",r"The function (2.21) is stationary under (2.10), (2.11), with multipliers $\lambda$, $u$, where (2.8) holds").reading(r"The source prints $F_\gamma$ for $X_\gamma$; $X_\gamma$ is read. $R^\tau_\gamma$ stands for the sum of friction.")
        .holds((0..4).map(|i| {
            Line::equation(
                (slopes[i] - lambda * by_place[i] - u * by_velocity[i]) / masses[i],
                second[i],
                int(1) / masses[i] * (given[i] + lambda * by_place[i] + u * by_velocity[i] + friction[i]),
            )
        }));

    let motion = mixed();
    let force = with_friction(motion.fields);
    let first = first_kind(&Mixed, &motion.state, force);
    let Some(split) = Split::<4, 2, 2>::new([0, 1]) else { return };
    let Ok(admissible) = accelerations(&Mixed, &split, &motion.state) else { return };
    let found = gauss::least(masses, force, &admissible).unwrap_or([Sym::UNDEFINED; 4]);
    page.claim("section2.2-gauss", "minimum","Under (2.10) and (2.11) with fixed friction the function (2.21) is least at the accelerations of (2.8) (four coordinates, one geometric and one nonlinear kinematic constraint)")
        .follows((0..4).map(|i| Equal(found[i], first.acceleration[i])));
}
