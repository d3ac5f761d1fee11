//! Section 1.3, task 2: the frictionless ladder: motion, reactions, and where it leaves the wall.

use super::alphabet::{exact, int, letter, tidy};
use super::ladder::LadderLetters;
use claims::{Condition, Line, Page};
use field::Tangent;
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &LadderLetters) {
    page.section("1.3. Task 2, the smooth ladder");
    let (c, sin, l, m, g) = (s.point.cos, s.point.sin, s.l, s.m, s.g);
    let smooth = [(s.at_wall, Sym::ZERO), (s.at_floor, Sym::ZERO)];
    let uniform = [(s.inertia, m * l.powi(2) / int(3))];
    let balance = s.balance().substitute(&smooth);
    page.claim(
        "section1.3-ladder-ideal",
        "motion",
        "For $f=0$ the equation of motion of the ladder has the weight $P=mg$ alone",
    )
    .holds([Line::equation(balance, (m * l.powi(2) + s.inertia) * s.ddalpha, m * g * l * sin)]);
    let acceleration = tidy(s.acceleration().substitute(&smooth).substitute(&uniform));
    let quarter = int(3) * g / (int(4) * l);
    page.claim("section1.3-ladder-ideal", "uniform", r"The smooth uniform ladder moves by its weight alone")
        .holds([Line::formula(acceleration, s.ddalpha, quarter * sin)]);
    let half = int(1) / int(2);
    let energy =
        Tangent::fixed(half) * Tangent::moving(s.dalpha, acceleration) * Tangent::moving(s.dalpha, acceleration)
            + Tangent::fixed(quarter) * s.point.moving(s.dalpha).cos;
    page.claim(
        "section1.3-ladder-ideal",
        "energy",
        r"Along the motion $\frac12\dot\alpha^2+\frac{3g}{4l}\cos\alpha$ is constant",
    )
    .in_words()
    .follows([Zero(energy.slope)]);
    let [wall, floor] =
        s.normal_reactions().map(|push| push.substitute(&smooth).substitute(&[(s.ddalpha, acceleration)]));
    let three = int(3) / int(4);
    let spin = s.dalpha.powi(2);
    page.claim(
        "section1.3-ladder-ideal",
        "reactions",
        "The normal reactions of wall and floor on the smooth ladder have the printed values",
    )
    .holds([
        Line::formula(wall, letter("RAn"), m * (three * g * c * sin - l * sin * spin)),
        Line::formula(floor, letter("RBn"), m * g - m * (three * g * sin.powi(2) + l * c * spin)),
    ]);
    let start = field::Analytic::circle(letter("α₀")).cos;
    let premises = [
        Positive(m),
        Positive(g),
        Positive(l),
        NonZero(sin),
        Zero(tidy(wall)),
        Equal(spin, int(2) * quarter * (start - c)),
    ];
    page.claim(
        "section1.3-ladder-ideal",
        "detachment",
        r"As printed, from rest at $\alpha_0$ the ladder leaves the wall, $R_A^n=0$, at $\cos\alpha=2\cos\alpha_0$",
    )
    .why(r"A factor 3 is missing. Besides, $\cos\alpha<\cos\alpha_0$ while the ladder slides down.")
    .given(premises)
    .refuted(
        [Equal(c, int(2) * start)],
        exact([
            ("m", 1, 1),
            ("g", 5, 1),
            ("l", 1, 1),
            ("cos α₀", 9, 10),
            ("cos α", 3, 5),
            ("sin α", 4, 5),
            ("α̇", 3, 2),
        ]),
    );
    // m sin (3/4 g c - l spin) = 0 and spin = 3g/2l (c0 - c)
    page.claim(
        "section1.3-ladder-ideal",
        "detachment-corrected",
        r"From rest at $\alpha_0$ the ladder leaves the wall, $R_A^n=0$, at $\cos\alpha=\frac23\cos\alpha_0$",
    )
    .given(premises)
    .by_combination([(
        Equal(c, int(2) / int(3) * start),
        vec![0, 1, 3],
        vec![(4, int(4) / int(9)), (5, int(4) / int(9) * m * l * sin)],
    )]);
    page.correct();
}
