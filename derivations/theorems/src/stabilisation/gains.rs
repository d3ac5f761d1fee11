//! The region of gains for which constraint stabilisation with discrete time steps is stable, and the gains with the
//! fastest decay.
//!
//! beta = h b and kappa = h^2 k are the dimensionless gains of y'' + b y' + k y = 0 for the step size h.

use super::alphabet::{letter, letters};
use claims::{Condition, Line, Page};
use field::{Rational, Scalar};
use studies::stabilisation::schemes::{Scheme, deadbeat_damping, inside_unit_circle};
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page) {
    page.section("Gains in steps: geometric constraints");
    unit_circle(page);
    regions(page);
    page.section("Gains in steps: kinematic constraints");
    kinematic(page);
    page.section("Gains in steps: the best");
    best(page);
}

fn transition(scheme: Scheme, beta: Sym, kappa: Sym) -> [[Sym; 2]; 2] {
    scheme.transition(beta, kappa).unwrap_or([[Sym::UNDEFINED; 2]; 2])
}

fn unit_circle(page: &mut Page) {
    let [t, d, w] = letters(["T", "D", "w"]);
    // the companion matrix of l^2 - T l + D
    let [s1, s2, s3] = inside_unit_circle([[t, -d], [Sym::int(1), Sym::ZERO]]);
    let one = Sym::int(1);
    let root = (one + w) / (one - w);
    page.claim("inside", "half-plane", r"$\lambda=(1+w)/(1-w)$ takes the left half-plane of $w$ to the disc $|\lambda|<1$, and $\lambda^2-T\lambda+D$ to $(1+T+D)w^2+2(1-D)w+(1-T+D)$ over $(1-w)^2$. By Routh and Hurwitz both roots are inside if and only if the three coefficients $1+T+D$, $2(1-D)$, $1-T+D$ have one sign, which is the positive one, for their sum is 4")
        .given([NonZero(one - w)])
        .follows([
            Equal((root.powi(2) - t * root + d) * (one - w).powi(2), s3 * w.powi(2) + Sym::int(2) * s1 * w + s2),
            Equal(s3 + Sym::int(2) * s1 + s2, Sym::int(4)),
        ]);
}

/// Three lines of the page: the expressions, multiplied by a factor, that are positive if and only if a violation
/// decays.
fn conditions(scheme: Scheme, factor: Sym, printed: [Sym; 3]) -> Vec<Line> {
    let [beta, kappa] = letters(["β", "κ"]);
    let found = inside_unit_circle(transition(scheme, beta, kappa));
    let names = letters(["s1", "s2", "s3"]);
    (0..3).map(|k| Line::formula(found[k], names[k], printed[k] / factor)).collect()
}

fn regions(page: &mut Page) {
    let [b, k] = letters(["β", "κ"]);
    let n = Sym::int;
    let one = n(1);
    page.claim("euler", "region", r"With Euler's method, $\beta=hb$, $\kappa=h^2k$, the error of the constraint decays if and only if $0<\kappa<\beta<2+\kappa/2$. The region is a triangle with the corners $(0,0)$, $(2,0)$, $(4,4)$")
        .holds(conditions(Scheme::Euler, one, [b - k, k, n(4) - n(2) * b + k]));
    page.claim("euler", "undamped", r"With Euler's method and a restoring gain alone, $\beta=0<\kappa$, the error of the constraint does not decay, since $1-D<0$")
        .in_words()
        .given([Positive(k)])
        .by_signs([Positive(-inside_unit_circle(transition(Scheme::Euler, Sym::ZERO, k))[0])]);
    let p1 = n(576) * b - n(288) * b.powi(2) + n(96) * b.powi(3) - n(24) * b.powi(4) + k * (n(24) * b.powi(3))
        - k.powi(2) * (n(12) * b.powi(2) + n(24) * b)
        + k.powi(3) * (n(4) * b + n(8))
        - k.powi(4);
    let p2 = k
        * (n(576) - n(288) * b + n(96) * b.powi(2) - n(24) * b.powi(3) + k * (n(12) * b.powi(2) + n(24) * b - n(48))
            - k.powi(2) * (n(4) * b + n(8))
            + k.powi(3));
    let p3 = n(2304) - n(1152) * b + n(576) * b.powi(2) - n(192) * b.powi(3) + n(48) * b.powi(4)
        - k * (n(576) - n(288) * b + n(96) * b.powi(2) + n(24) * b.powi(3))
        + k.powi(2) * (n(48) + n(24) * b + n(12) * b.powi(2))
        - k.powi(3) * (n(8) + n(4) * b)
        + k.powi(4);
    page.claim("runge-kutta", "region", r"With the classical Runge-Kutta method, $\beta=hb$, $\kappa=h^2k$, the error of the constraint decays if and only if $s_1$, $s_2$, $s_3$ are positive")
        .holds(conditions(Scheme::RungeKutta4, n(576), [p1, p2, p3]));
    page.claim("runge-kutta", "undamped", r"With the classical Runge-Kutta method without damping, $\beta=0$, the value $s_1=1-D$ is positive for $0<\kappa<8$ only, and of the third order in $\kappa$")
        .holds([Line::formula(
            inside_unit_circle(transition(Scheme::RungeKutta4, Sym::ZERO, k))[0],
            letter("s1"),
            k.powi(3) * (n(8) - k) / n(576),
        )]);
    let den = one + b + k;
    page.claim("backward-euler", "region", r"With backward Euler, $\beta=hb$, $\kappa=h^2k$, the error of the constraint decays where $s_1$, $s_2$, $s_3$ are positive")
        .holds(conditions(Scheme::BackwardEuler, den, [b + k, k, n(4) + n(2) * b + k]));
    let den = n(4) + n(2) * b + k;
    page.claim("midpoint", "region", r"With the implicit midpoint rule, $\beta=hb$, $\kappa=h^2k$, the error of the constraint decays if and only if $\beta>0$ and $\kappa>0$ (where the denominator is positive). The discrete error decays exactly where the continuous one does")
        .holds(conditions(Scheme::ImplicitMidpoint, den, [n(4) * b, n(4) * k, n(16)]));
    for (entry, scheme) in [("backward-euler", Scheme::BackwardEuler), ("midpoint", Scheme::ImplicitMidpoint)] {
        page.claim(
            entry,
            "all-gains",
            format!(
                r"Every pair of positive gains, at every step, lets the error of the constraint decay with {}",
                scheme.name()
            ),
        )
        .in_words()
        .given([Positive(b), Positive(k)])
        .by_signs(inside_unit_circle(transition(scheme, b, k)).map(Positive));
    }
    let outside = inside_unit_circle(transition(Scheme::BackwardEuler, -b, n(2) * b));
    page.claim("backward-euler", "hides", r"Backward Euler hides a growing error: with the gains $-\beta<0$ and $\kappa=2\beta$ the error of its steps decays at every $\beta>0$, while $\ddot y+b\dot y+ky=0$ with $b<0$ has growing solutions")
        .in_words()
        .given([Positive(b)])
        .by_signs(outside.map(Positive));
}

/// The factor by which one step multiplies the solution of y' = -b y.
fn factor(scheme: Scheme, beta: Sym) -> Sym {
    scheme.step([[-beta]], [Sym::int(1)]).map_or(Sym::UNDEFINED, |[y]| y)
}

fn kinematic(page: &mut Page) {
    let [b, rho] = letters(["β", "ρ"]);
    let n = Sym::int;
    let one = n(1);
    let cubic = |b: Sym| b.powi(3) - n(4) * b.powi(2) + n(12) * b - n(24);
    page.claim("kinematic", "factors", r"For a kinematic constraint, $\dot\varphi=-b\varphi$, $\beta=hb$, a step of Euler, of backward Euler and of the midpoint rule has the factor $\rho$ below, in this order. With Euler the error decays for $0<\beta<2$, with the others for every $\beta>0$")
        .holds([
            Line::formula(factor(Scheme::Euler, b), rho, one - b),
            Line::formula(factor(Scheme::BackwardEuler, b), rho, one / (one + b)),
            Line::formula(factor(Scheme::ImplicitMidpoint, b), rho, (n(2) - b) / (n(2) + b)),
        ]);
    let kutta = factor(Scheme::RungeKutta4, b);
    page.claim("kinematic", "runge-kutta", r"For a kinematic constraint, $\dot\varphi=-b\varphi$, $\beta=hb$, the classical Runge-Kutta method has $24\rho=(\beta^2-2\beta+2)^2+4(\beta-2)^2+4>0$ and $24(1-\rho)=-\beta(\beta^3-4\beta^2+12\beta-24)$, so that the error decays where $\beta>0$ and the cubic is negative")
        .in_words()
        .follows([
            Equal(n(24) * kutta, (b.powi(2) - n(2) * b + n(2)).powi(2) + n(4) * (b - n(2)).powi(2) + n(4)),
            Equal(n(24) * (one - kutta), -b * cubic(b)),
        ]);
    let at = |digits: i64| Sym::constant(Rational::new(digits, 1_000_000_000));
    page.claim("kinematic", "root", r"The cubic $\beta^3-4\beta^2+12\beta-24$ rises everywhere, since three times its derivative is $(3\beta-4)^2+20$. It has one zero $\beta_*$, and is negative below it")
        .in_words()
        .follows([Equal(n(3) * cubic(b).diff(b), (n(3) * b - n(4)).powi(2) + n(20))]);
    page.claim("kinematic", "root-below", r"The cubic $\beta^3-4\beta^2+12\beta-24$ is negative at $2.785293563$ and positive at $2.785293564$, so that its zero is $\beta_*=2.785293563\ldots$")
        .in_words()
        .by_signs([Positive(-cubic(at(2_785_293_563))), Positive(cubic(at(2_785_293_564)))]);
}

fn square([[a, b], [c, d]]: [[Sym; 2]; 2]) -> [Sym; 4] {
    [a * a + b * c, a * b + b * d, c * a + d * c, c * b + d * d]
}

fn best(page: &mut Page) {
    let [b, k] = letters(["β", "κ"]);
    let n = Sym::int;
    page.claim("best", "euler", "For Euler with $hb=2$, $h^2k=1$ the square of the step's matrix is zero, so that an error is gone after two steps")
        .in_words()
        .follows(square(transition(Scheme::Euler, n(2), n(1))).map(Zero));
    page.claim("best", "midpoint", "For the midpoint rule with $hb=4$, $h^2k=4$ the square of the step's matrix is zero, so that an error is gone after two steps")
        .in_words()
        .follows(square(transition(Scheme::ImplicitMidpoint, n(4), n(4))).map(Zero));
    // z^2 + beta z + kappa divides 1 + z + z^2/2 + z^3/6 + z^4/24
    let sextic =
        -(n(13824) - n(6912) * k + n(1728) * k.powi(2) - n(384) * k.powi(3) + n(72) * k.powi(4) - n(12) * k.powi(5));
    let rules = Hypotheses::none().rule(k, 6, sextic);
    let [[p, q], [r, s]] = transition(Scheme::RungeKutta4, deadbeat_damping(k), k);
    page.claim("best", "runge-kutta", r"For Runge-Kutta with $\kappa^6-12\kappa^5+72\kappa^4-384\kappa^3+1728\kappa^2-6912\kappa+13824=0$ and $\beta=\kappa(24-4\kappa)/(24-\kappa^2)$ the step's matrix is zero, so that an error is gone after one step")
        .note(r"The real solutions are near $(\beta,\kappa)=(3.45889,3.78125)$ and $(0.54111,6.34710)$; $z^2+\beta z+\kappa$ divides $1+z+z^2/2+z^3/6+z^4/24$.")
        .in_words()
        .under(&rules)
        .follows([p, q, r, s].map(Zero));
    let [t, d] = letters(["T", "D"]);
    let [[p, q], [r, s]] = transition(Scheme::BackwardEuler, b, b.powi(2) / n(4));
    let root = n(2) / (n(2) + b);
    page.claim("best", "backward-euler", r"For backward Euler, critically damped ($\beta^2=4\kappa$), trace and determinant of a step are those of the double root $2/(2+\beta)$, which falls with $\beta$")
        .holds([Line::formula(p + s, t, n(2) * root), Line::formula(p * s - q * r, d, root.powi(2))]);
}
