//! Theorems on one-step maps for y' = z y: growing, constant and decaying modes.

mod alphabet;

use alphabet::{dimension, letters};
use claims::{Condition, Line, Page, Paper};
use field::{Rational, Scalar};
use integrators::{Family, Splitting, nodal};
use studies::numerical_stability::methods::{OneStep, course};
use studies::numerical_stability::oscillator::step;
use studies::stabilisation::schemes::Scheme;
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, Positive};

/// The entry of the page in the ledger.
pub const PAPER: Paper = Paper {
    key: "numerical_stability",
    title: "Numerical stability: the map of a step beside the motion",
    citation: "The workbench's own page. The stability function and A-stability are those of G. Dahlquist (1963); collocation after E. Hairer, G. Wanner: Solving ordinary differential equations II (1991), IV.3 and IV.5.",
    summary: r"Near a stationary motion $\dot x=Ax$ a Runge-Kutta method has the matrix $R(hA)$, and a mode $\mu$ fades, stays or grows under it as $|R(h\mu)|$ is below, at or above one. Euler lets grow at every step what stays; the classical Runge-Kutta method damps it up to $h|\mu|=2\sqrt2$; backward Euler and Radau IIA damp it always, and hide a mode that grows from some step on: phantom stability. The midpoint rule and Gauss with two and three stages are correct at every step on every motion. The command `dalembert numerical-stability` gives for a scene's motions every threshold, isolated.",
    entries: &["function", "axis", "grows", "correct", "splitting"],
    page,
};

const EULER: OneStep = OneStep::Classical(Scheme::Euler);
const RUNGE_KUTTA_4: OneStep = OneStep::Classical(Scheme::RungeKutta4);
const MIDPOINT: OneStep = OneStep::Classical(Scheme::ImplicitMidpoint);
const BACKWARD_EULER: OneStep = OneStep::Classical(Scheme::BackwardEuler);
const fn gauss(stages: u8) -> OneStep {
    OneStep::Collocation(Family::Gauss, stages)
}
const fn radau(stages: u8) -> OneStep {
    OneStep::Collocation(Family::RadauIIA, stages)
}

pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, dimension);
    page.section("Numerical stability: the step on one mode");
    functions(&mut page);
    page.section("Numerical stability: modes that stay");
    axis(&mut page);
    page.section("Numerical stability: modes that grow or fade");
    plane(&mut page);
    page.section("Numerical stability: kick and drift");
    kick_and_drift(&mut page);
    page
}

fn n(value: i64) -> Sym {
    Sym::int(value)
}

/// The stability function R of each method.
fn functions(page: &mut Page) {
    let [z, c, r] = letters(["z", "c", "R"]);
    let mut say = |slug: &'static str, says: &str, method: OneStep, printed: Sym| {
        page.claim("function", slug, says).holds([Line::formula(method.run(z), r, printed)]);
    };
    say("euler", "A step of Euler on $y'=zy$ has the factor $R$ below", EULER, z + n(1));
    say(
        "runge-kutta-4",
        "A step of the classical Runge-Kutta method on $y'=zy$ has the factor $R$ below, the series of the exponential up to $z^4$",
        RUNGE_KUTTA_4,
        n(1) + z + z.powi(2) / n(2) + z.powi(3) / n(6) + z.powi(4) / n(24),
    );
    say(
        "midpoint",
        "A step of the implicit midpoint rule, which is Gauss with one stage, on $y'=zy$ has the factor $R$ below",
        MIDPOINT,
        (n(2) + z) / (n(2) - z),
    );
    say(
        "backward-euler",
        "A step of backward Euler, which is Radau IIA with one stage, on $y'=zy$ has the factor $R$ below",
        BACKWARD_EULER,
        n(1) / (n(1) - z),
    );
    let squares = |z: Sym| n(12) + n(6) * z + z.powi(2);
    say(
        "gauss-2",
        "A step of Gauss with two stages on $y'=zy$ has the factor $R$ below",
        gauss(2),
        squares(z) / squares(-z),
    );
    let cubes = |z: Sym| n(120) + n(60) * z + n(12) * z.powi(2) + z.powi(3);
    say(
        "gauss-3",
        "A step of Gauss with three stages on $y'=zy$ has the factor $R$ below",
        gauss(3),
        cubes(z) / cubes(-z),
    );
    say(
        "radau-2",
        "A step of Radau IIA with two stages on $y'=zy$ has the factor $R$ below",
        radau(2),
        (n(6) + n(2) * z) / (n(6) - n(4) * z + z.powi(2)),
    );
    say(
        "radau-3",
        "A step of Radau IIA with three stages on $y'=zy$ has the factor $R$ below",
        radau(3),
        (n(60) + n(24) * z + n(3) * z.powi(2)) / (n(60) - n(36) * z + n(9) * z.powi(2) - z.powi(3)),
    );
    let defect = [Family::Gauss, Family::RadauIIA].into_iter().flat_map(|family| {
        (1..=3).map(move |stages: u8| {
            let u = course(family, stages, c, z);
            let power = i32::from(stages) + 1;
            Equal(u.diff(c) - z * u, -z.powi(power) * nodal(family, stages.into(), c))
        })
    });
    page.claim("function", "collocation", r"For collocation with $N$ the polynomial of the nodes, $u=\sum_kN^{(k)}z^{s-k}$ has degree $s$ and $u'-zu=-z^{s+1}N$, which vanishes at the nodes, so that $R=u(1)/u(0)$. The methods are Gauss and Radau IIA with one to three stages")
        .in_words()
        .follows(defect);
    let one = |method: OneStep| method.run(z);
    page.claim(
        "function",
        "one-stage",
        "With one stage the collocation methods are the midpoint rule and backward Euler",
    )
    .in_words()
    .follows([Equal(one(gauss(1)), one(MIDPOINT)), Equal(one(radau(1)), one(BACKWARD_EULER))]);
}

/// The modulus on the imaginary axis: |R(i y)|^2 = R(i y) R(-i y).
fn axis(page: &mut Page) {
    let [z, y, m] = letters(["z", "y", "m"]);
    let rules = Hypotheses::none().rule(z, 2, -y.powi(2));
    let size = |method: OneStep| method.run(z) * method.run(-z);
    let mut say = |slug: &'static str, says: &str, method: OneStep, printed: Sym| {
        page.claim("axis", slug, says).under(&rules).holds([Line::formula(size(method), m, printed)]);
    };
    let square = y.powi(2);
    say("euler", r"Euler makes an undamped mode, $z=\mathrm iy$, grow at every step", EULER, n(1) + square);
    say(
        "runge-kutta-4",
        r"The classical Runge-Kutta method damps an undamped mode, $z=\mathrm iy$, for $0<y<2\sqrt2$ and makes it grow beyond",
        RUNGE_KUTTA_4,
        n(1) - y.powi(6) * (n(8) - square) / n(576),
    );
    say(
        "backward-euler",
        r"Backward Euler damps an undamped mode, $z=\mathrm iy$, at every step",
        BACKWARD_EULER,
        n(1) / (n(1) + square),
    );
    let two = n(36) + n(4) * square;
    say(
        "radau-2",
        r"Radau IIA with two stages damps an undamped mode, $z=\mathrm iy$, at every step",
        radau(2),
        two / (two + y.powi(4)),
    );
    let three = n(3600) + n(216) * square + n(9) * y.powi(4);
    say(
        "radau-3",
        r"Radau IIA with three stages damps an undamped mode, $z=\mathrm iy$, at every step",
        radau(3),
        three / (three + y.powi(6)),
    );
    page.claim("axis", "symmetric", r"The midpoint rule and Gauss with two and three stages keep an undamped mode, $|R(\mathrm iy)|=1$, at every step")
        .in_words()
        .under(&rules)
        .follows([MIDPOINT, gauss(2), gauss(3)].map(|method| Equal(size(method), n(1))));
}

/// The square |R(a + i b)|^2, by the powers of a + i b.
fn size(method: OneStep, [a, b]: [Sym; 2]) -> Sym {
    let square = |coefficients: &[Rational]| {
        let (mut power, mut sum) = ([n(1), n(0)], [n(0), n(0)]);
        for c in coefficients {
            let c = Sym::constant(*c);
            sum = [sum[0] + c * power[0], sum[1] + c * power[1]];
            power = [a * power[0] - b * power[1], a * power[1] + b * power[0]];
        }
        sum[0].powi(2) + sum[1].powi(2)
    };
    method.function().map_or(Sym::UNDEFINED, |function| square(&function.numerator) / square(&function.denominator))
}

fn plane(page: &mut Page) {
    let [a, b, m] = letters(["a", "b", "m"]);
    let square = a.powi(2) + b.powi(2);
    let mut say = |entry: &'static str, slug: &'static str, says: &str, method: OneStep, printed: Sym| {
        page.claim(entry, slug, says).holds([Line::formula(size(method, [a, b]), m, printed)]);
    };
    say(
        "grows",
        "euler",
        r"Euler makes a decaying mode, $z=h\mu=a+\mathrm ib$ with $a<0$, grow for $h>-2\,\mathrm{Re}\,\mu/|\mu|^2$, and never hides a growing one, $a>0$",
        EULER,
        n(1) + n(2) * a + square,
    );
    say(
        "grows",
        "backward-euler",
        r"Backward Euler hides a growing mode, $z=h\mu=a+\mathrm ib$ with $a>0$, for $h>2\,\mathrm{Re}\,\mu/|\mu|^2$ (phantom stability), and lets every decaying mode decay, $a<0$",
        BACKWARD_EULER,
        n(1) / (n(1) - n(2) * a + square),
    );
    let below =
        n(36) - n(48) * a + n(16) * square + n(12) * (a.powi(2) - b.powi(2)) - n(8) * a * square + square.powi(2);
    say(
        "grows",
        "radau-2",
        r"Radau IIA with two stages hides a growing mode, $z=h\mu=a+\mathrm ib$ with $a>0$, where $|z|^4>72a-24a^2+8a|z|^2$",
        radau(2),
        n(1) + (n(72) * a - n(24) * a.powi(2) + n(8) * a * square - square.powi(2)) / below,
    );
    let modulus = |re: Sym, im: Sym| re.powi(2) + im.powi(2);
    say(
        "correct",
        "midpoint",
        r"The midpoint rule never hides a growing mode and never makes a decaying one grow, because $|R|^2-1$ has the sign of $a$, $z=h\mu=a+\mathrm ib$, at every step",
        MIDPOINT,
        n(1) + n(8) * a / modulus(n(2) - a, b),
    );
    say(
        "correct",
        "gauss-2",
        r"Gauss with two stages never hides a growing mode and never makes a decaying one grow, because $|R|^2-1$ has the sign of $a$, $z=h\mu=a+\mathrm ib$, at every step",
        gauss(2),
        n(1) + n(24) * a * (n(12) + square)
            / modulus(n(12) - n(6) * a + a.powi(2) - b.powi(2), n(2) * a * b - n(6) * b),
    );
    let cubed = [a.powi(3) - n(3) * a * b.powi(2), n(3) * a.powi(2) * b - b.powi(3)];
    say(
        "correct",
        "gauss-3",
        r"Gauss with three stages never hides a growing mode and never makes a decaying one grow, because $|R|^2-1$ has the sign of $a$, $z=h\mu=a+\mathrm ib$, at every step",
        gauss(3),
        n(1) + n(48) * a * (n(600) + n(70) * a.powi(2) + n(30) * b.powi(2) + square.powi(2))
            / modulus(
                n(120) - n(60) * a + n(12) * (a.powi(2) - b.powi(2)) - cubed[0],
                n(24) * a * b - n(60) * b - cubed[1],
            ),
    );
    real(page);
}

/// The step size beyond which Radau IIA with three stages damps a growing real mode.
fn real(page: &mut Page) {
    let [z, a] = letters(["z", "a"]);
    let cubic = |z: Sym| z.powi(3) - n(12) * z.powi(2) + n(12) * z - n(120);
    let below = n(60) - n(36) * z + n(9) * z.powi(2) - z.powi(3);
    page.claim("grows", "radau-3-real", r"For Radau IIA with three stages on a real mode, $z=h\mu$, $(R^2-1)N^2 = -z\,((z-3)^2+51)(z^3-12z^2+12z-120)$ with the denominator $N=60-36z+9z^2-z^3$ of $R$. A growing mode, $z>0$, is therefore hidden where $z^3-12z^2+12z-120>0$")
        .in_words()
        .follows([Equal(
            (radau(3).run(z).powi(2) - n(1)) * below.powi(2),
            -(z * ((z - n(3)).powi(2) + n(51)) * cubic(z)),
        )]);
    let [low, high] = [11_842_355, 11_842_356].map(|value| Sym::constant(Rational::new(value, 1_000_000)));
    page.claim(
        "grows",
        "radau-3-root",
        "$z^3-12z^2+12z-120$ has one positive root, between $z_1=11.842355$ and $z_2=11.842356$. For $a>0$ it is negative at $z_1a/(1+a)$, that is on $(0,z_1)$, negative at $z_1$, positive at $z_2$ and at $z_2+a$, and its derivative is positive at $z_1+a$",
    )
    .in_words()
    .given([Positive(a)])
    .by_signs([
        Positive(-cubic(low * a / (n(1) + a))),
        Positive(-cubic(low)),
        Positive(cubic(high)),
        Positive(cubic(high + a)),
        Positive(cubic(z).diff(z).substitute(&[(z, low + a)])),
    ]);
}

/// The splitting methods for q'' = -k q.
fn kick_and_drift(page: &mut Page) {
    let [kappa, t] = letters(["κ", "T"]);
    let [[p, q], [r, s]] = step(Splitting::Strang, kappa);
    page.claim("splitting", "strang", r"A step of Strang's splitting of $\ddot q=-kq$ into kick and drift has the trace $T$ below, $\kappa=h^2k$. With the determinant one (numerical_stability/splitting/area) the eigenvalues are a pair on the unit circle, not real, if and only if $|T|<2$, that is $0<\kappa<4$")
        .holds([Line::formula(p + s, t, n(2) - kappa)]);
    page.claim(
        "splitting",
        "area",
        r"The determinant of a step of Strang's splitting of $\ddot q=-kq$ into kick and drift is one",
    )
    .in_words()
    .follows([Equal(p * s - q * r, n(1))]);
}
