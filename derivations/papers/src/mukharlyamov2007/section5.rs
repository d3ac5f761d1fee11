//! Section 5: redundant variables with energies of their own, (11)-(15), and the stability of their equations.

use super::alphabet::{exact, indexed, int, letter, letters};
use super::general::{General, instant, led};
use claims::{Condition, Line, Page};
use field::{Scalar, Tangent};
use mechanics::constrained::PointSystem;
use mechanics::constrained::programmed::violation;
use mechanics::constrained::rates::jacobian;
use mechanics::differentiate::{along, gradient, unit};
use mechanics::lagrange::lagrange;
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page) {
    page.section("5. Redundant variables");
    displacements(page);
    principle(page);
    expansion(page);
    let model = Model::new();
    model.motion(page);
    model.perturbations(page);
    multipliers(page);
    page.section("5. Stability of the perturbations");
    stability(page);
}

/// Claims on (11).
fn displacements(page: &mut Page) {
    let at = instant();
    let rows = jacobian(&General, &at);
    let by_velocity: [[Sym; 2]; 3] = std::array::from_fn(|i| {
        let moving = mechanics::constrained::State { velocity: along(at.velocity, unit(i)), ..at.fixed() };
        violation(&General, &moving).rate.map(|rate| rate.slope)
    });
    page.claim("eq11", "displacements", r"(11) is $\delta y^\kappa=\frac{\partial\dot y^\kappa}{\partial\dot q^i}\delta q^i$: for a geometric constraint the variation $\frac{\partial f}{\partial q^i}\delta q^i$, for a kinematic one Chetaev's")
        .in_words()
        .follows((0..3).flat_map(|i| [Equal(by_velocity[i][0], rows[0][i]), Equal(by_velocity[i][1], rows[1][i])]));
}

/// Claims on the principle for coordinates q and redundant y: E_i and E_y are d/dt dT/dq' - dT/dq - ... for each of
/// them.
fn principle(page: &mut Page) {
    let [e1, e2, ey, f1, f2, lambda] = letters(["E1", "E2", "Ey", "f1", "f2", "λ"]);
    let work = [Zero(e1 + f1 * ey), Zero(e2 + f2 * ey)];
    page.claim("eq12", "principle", r"D'Alembert's and Lagrange's principle, $\sum E_i\delta q^i+E_y\delta y=0$ for all displacements (11), gives $E_i=-\frac{\partial\dot y}{\partial\dot q^i}E_y$. This is (12) with $\lambda=-E_y$, where $E=\frac{d}{dt}\frac{\partial T}{\partial\dot q}-\frac{\partial T}{\partial q}+\frac{\partial P}{\partial q}+\frac{\partial D}{\partial\dot q}-Q$")
        .given(work)
        .given([Equal(lambda, -ey)])
        .by_combination([
            (Equal(e1, f1 * lambda), vec![], vec![(0, int(1)), (2, -f1)]),
            (Equal(e2, f2 * lambda), vec![], vec![(1, int(1)), (2, -f2)]),
        ]);
    page.claim(
        "eq13",
        "principle",
        r"(13), $E_y=0$, follows from d'Alembert's and Lagrange's principle together with (12)",
    )
    .given(work)
    .given([Equal(e1, f1 * lambda), Equal(e2, f2 * lambda), NonZero(f1)])
    .why(r"$y$ is varied with $q$ by (11), so that the principle has no equation of its own for $y$.")
    .refuted([Zero(ey)], exact([("E1", -1, 1), ("E2", 0, 1), ("Ey", 1, 1), ("f1", 1, 1), ("f2", 0, 1), ("λ", -1, 1)]));
    page.claim("eq13", "principle-corrected", r"The principle with (12) gives $E_y=-\lambda$: the multipliers act on $y$ as well. (13) would mean $\lambda=0$, no constraint. It is a programme for $y$, a postulate, and the forces $f_i^\kappa\lambda_\kappa$ are a control, given forces in the principle, and not reactions")
        .given(work)
        .given([Equal(e1, f1 * lambda), NonZero(f1)])
        .by_combination([(Equal(ey, -lambda), vec![3], vec![(0, int(1)), (2, int(-1))])]);
    page.correct();
    let force = letter("R1");
    page.claim("eq13", "control", r"With control forces $R_i$ among the given ones, the principle is $E_i-R_i+\frac{\partial\dot y}{\partial\dot q^i}E_y=0$, and (13) leaves $E_i=R_i$. This is (12) with $R_i=f_i\lambda$ at the engineer's disposal")
        .given([Zero(e1 - force + f1 * ey), Zero(ey)])
        .by_combination([(Equal(e1, force), vec![], vec![(0, int(1)), (1, -f1)])]);
}

/// Claims on the expansions of T, P and D.
fn expansion(page: &mut Page) {
    let [y, dy, c, dy_1, dyy, mixed] = letters(["y", "ẏ", "c₀", "Dy", "Dyy", "Dyẏ"]);
    // D - D0 to second order; the stated conditions leave three coefficients free
    let d = dy_1 * y + (dyy * y * y + c * dy * dy).half() + mixed * y * dy;
    let origin = [(y, Sym::ZERO), (dy, Sym::ZERO)];
    let at_rest = |e: Sym| e.substitute(&origin);
    page.claim("eq13", "expansion", r"From $D=D^0$, $\frac{\partial D}{\partial\dot y}=0$, $\frac{\partial^2D}{\partial\dot y^2}=c$ at $y=\dot y=0$ follows $D=D^0+\frac12c\dot y^2+D^{(3)}$, without a term $y\dot y$")
        .in_words()
        .why(r"The assumptions leave $\frac{\partial^2D}{\partial y\partial\dot y}$ free, as they do not for $T$.")
        .refuted(
            [Zero(at_rest(d.diff(y).diff(dy)))],
            exact([("Dy", 0, 1), ("Dyy", 0, 1), ("Dyẏ", 1, 1), ("c₀", 1, 1)]),
        );
    let force = letter("Fy");
    page.claim("eq13", "expansion-corrected", r"The force of $D$ is $-\frac{\partial D}{\partial\dot y}=-c\dot y-D_{,y\dot y}y$. The condition $\frac{\partial^2D}{\partial y\partial\dot y}=0$ is to be assumed too, as it is of $T$. The terms $\frac{\partial D}{\partial y}$ and $\frac{\partial^2D}{\partial y^2}$ do not enter")
        .holds([Line::formula(-d.diff(dy), force, -(c * dy) - mixed * y)]);
    page.correct();
}

/// Two coordinates and one redundant variable, with energies arbitrary to the relevant order.
struct Model {
    velocity: [Sym; 3],
    acceleration: [Sym; 3],
    /// The expressions d/dt dL/dq' - dL/dq + dD/dq' for q1, q2, y at q = 0.
    left: [Sym; 3],
}

impl Model {
    fn new() -> Self {
        type Twice = Tangent<Tangent<Sym>>;
        let fixed = |s: Sym| -> Twice { Tangent::fixed(Tangent::fixed(s)) };
        let [q1, q2, y] = letters(["q1", "q2", "y"]);
        let (velocity, acceleration) = (letters(["q̇1", "q̇2", "ẏ"]), letters(["q̈1", "q̈2", "ÿ"]));
        // a function to first order in the coordinates
        let first = |value: &str, by: [&str; 2], [x1, x2]: [Twice; 2]| {
            let [at, by1, by2] = [letter(value), letter(by[0]), letter(by[1])].map(fixed);
            at + by1 * x1 + by2 * x2
        };
        let lagrangian = |[x1, x2, y]: [Twice; 3], [v1, v2, dy]: [Twice; 3]| {
            let x = [x1, x2];
            let kinetic = first("m1", ["m11", "m12"], x) * v1 * v1
                + first("m2", ["m21", "m22"], x) * v2 * v2
                + first("a", ["a1", "a2"], x) * dy * dy;
            let potential = fixed(letter("P1")) * x1 + fixed(letter("P2")) * x2;
            kinetic.half() - potential - (first("k", ["k1", "k2"], x) * y * y).half()
        };
        let conservative = lagrange(lagrangian, [q1, q2, y], velocity, acceleration);
        let friction = gradient(
            |[v1, v2, dy]: [Tangent<Sym>; 3]| {
                let [d, c, c1, c2] = letters(["d", "c₀", "c1", "c2"]).map(Tangent::fixed);
                (d * (v1 * v1 + v2 * v2) + (c + c1 * v1 + c2 * v2) * dy * dy).half()
            },
            velocity,
        );
        let origin = [(q1, Sym::ZERO), (q2, Sym::ZERO)];
        let left = std::array::from_fn(|i| (conservative[i] + friction[i]).substitute(&origin));
        Model { velocity, acceleration, left }
    }

    /// Claims on (14).
    fn motion(&self, page: &mut Page) {
        let [v1, v2, dy] = self.velocity;
        let [m1, m11, m12, m21, d, c1, a1, k1, p1, push, f1, lambda, y] =
            letters(["m1", "m11", "m12", "m21", "d", "c1", "a1", "k1", "P1", "Q1", "f1", "λ", "y"]);
        let inertial = -((m11 * v1 * v1).half() + m12 * v1 * v2 - (m21 * v2 * v2).half());
        let second = (a1 * dy * dy - k1 * y * y - c1 * dy * dy).half();
        let right = inertial - p1 - d * v1 + push + f1 * lambda + second;
        page.claim("eq14", "motion", r"(12) has the form (14) with accelerations, the multiplier with $M^{-1}J^T$, and terms of the second order in $y,\dot y$, which are $\frac12(a_{,i}\dot y^2-k_{,i}y^2-c_{,\dot\imath}\dot y^2)$. The system has two coordinates and energies arbitrary to the first order")
            .holds([Line::equation(self.left[0] - push - f1 * lambda, m1 * self.acceleration[0], right)]);
        let still = [(y, Sym::ZERO), (dy, Sym::ZERO)];
        page.claim("eq14", "no-first-order", r"(14) has no terms of the first order in $y$ and $\dot y$, for two coordinates and energies arbitrary to the first order")
            .in_words()
            .follows(self.left[..2].iter().flat_map(|e| [y, dy].map(|of| Zero(e.diff(of).substitute(&still)))));
    }

    /// Claims on (15).
    fn perturbations(&self, page: &mut Page) {
        let [v1, v2, dy] = self.velocity;
        let [y, a, a1, a2, c, c1, c2, k] = letters(["y", "a", "a1", "a2", "c₀", "c1", "c2", "k"]);
        let (friction, change) = (c + c1 * v1 + c2 * v2, a1 * v1 + a2 * v2);
        let (damping, stiffness) = (-((friction + change) / a), -(k / a));
        page.claim("eq15", "perturbations", r"(13) has the form (15), with $b=-a^{-1}(c+\dot a)$ and $k^\kappa_\mu=-a^{-1}k$. Both are minus what the names suggest, and $\dot a=a_{,i}\dot q^i$ stands in $b$")
            .note(r"In $dy^\kappa/dt=\dot y^\kappa$ the index goes to $m$ only, as in (10): a kinematic constraint has no $y$, and its row of $k_{\mu\nu}$ is zero.")
            .holds([Line::equation(self.left[2] / a, self.acceleration[2], damping * dy + stiffness * y)]);
        let b = (-(friction + change) / a).substitute(&[(c1, Sym::ZERO), (c2, Sym::ZERO)]);
        page.claim("eq15", "inertia", r"A positive friction $c$ is not enough for stability of (15). There are $a$, $c>0$ with a positive coefficient $b$ of $\dot y$, where the inertia $a$ falls fast enough")
            .given([Positive(a), Positive(c)])
            .exists([Positive(b)], exact([("a", 1, 1), ("c₀", 1, 1), ("a1", -2, 1), ("a2", 0, 1), ("q̇1", 1, 1), ("q̇2", 0, 1)]));
        let [a0, s, t, w] = letters(["a", "s", "t", "W"]);
        let inertia = a0 - s * t;
        let square = w * a0 / inertia;
        // b of (15) with c = s/2 and a' = -s
        let falling = [(c, s / int(2)), (c1, Sym::ZERO), (c2, Sym::ZERO), (v1, Sym::ONE), (a1, -s), (a2, Sym::ZERO)];
        let growth = -(self.left[2].diff(dy) / a).substitute(&falling).substitute(&[(a, inertia)]);
        page.claim("eq15", "grows", r"A kinematic constraint with $a=a_0-st$ and $c=s/2>0$ has by (15) $\dot y^2=Wa_0/(a_0-st)$, which grows without bound as $t\to a_0/s$")
            .in_words()
            .given([NonZero(inertia)])
            .follows([Zero(square.diff(t) - int(2) * growth * square)]);
    }
}

/// Claims on the series of the multipliers.
fn multipliers(page: &mut Page) {
    let rows = jacobian(&General, &instant());
    let masses: [Sym; 3] = General.masses();
    let wanted: [Sym; 2] = indexed("Y#");
    let (all, first) = (led(wanted).multipliers, led([Sym::ZERO; 2]).multipliers);
    let pushed = rows.map(|a| {
        (0..3).fold(Sym::ZERO, |sum, i| {
            let by = (0..2).fold(Sym::ZERO, |sum, k| sum + (all[k] - first[k]) * rows[k][i]);
            sum + a[i] * by / masses[i]
        })
    });
    page.claim("eq15", "multipliers", r"$\lambda=\lambda^{(0)}+\lambda^{(1)}+\dots$: with $\lambda^{(0)}$ from $\ddot f=0$ ($\dot\varphi=0$), at the place and velocity as they are, the rest is $(JM^{-1}J^T)^{-1}Y$ exactly, of the orders that $Y$ has in $y,\dot y$")
        .in_words()
        .follows((0..2).map(|k| Equal(pushed[k], wanted[k])));
}

/// Claims on the stability of a y'' + c y' + k y = 0.
fn stability(page: &mut Page) {
    page.claim("section5-stability", "necessary", "Stabilisation of the constraints (5) means asymptotic stability of the trivial solution of (15). This condition is necessary and sufficient by definition, as long as the multipliers exist")
        .note("Lyapunov's theorem on a part of the variables needs what the sentence lists ($V$ positive definite, its derivative negative definite, an infinitely small upper limit, all in $y,\\dot y$) and that $q,\\dot q$ exist for all time. An infinitely small upper limit means that $V$ admits an upper bound that tends to zero with $y,\\dot y$.")
        .defines([]);
    let [a, c, k, y, dy] = letters(["a", "c₀", "k", "y", "ẏ"]);
    let rate = |v: Sym| v.diff(y) * dy - v.diff(dy) * (c * dy + k * y) / a;
    let energy = (a * dy * dy + k * y * y).half();
    page.claim("section5-stability", "energy", r"The energy $\frac12(a\dot y^2+ky^2)$ that (13) suggests has no negative definite derivative along (15): its derivative $-c\dot y^2$ vanishes where $\dot y=0$, $y\ne0$")
        .given([Positive(a), Positive(c), Positive(k), NonZero(y)])
        .exists([Zero(rate(energy))], exact([("a", 1, 1), ("c₀", 1, 1), ("k", 1, 1), ("y", 1, 1), ("ẏ", 0, 1)]));
    let v = energy + (c * y * dy).half() + c * c * y * y / (int(4) * a);
    page.claim("section5-stability", "function", r"$V=\frac12a\dot y^2+\frac12ky^2+\frac12cy\dot y+\frac{c^2}{4a}y^2$ has along (15) with constant $a,c,k>0$ the negative definite derivative $\dot V=-\frac c2\dot y^2-\frac{ck}{2a}y^2$")
        .given([Positive(a), Positive(c), Positive(k)])
        .follows([Equal(rate(v), -(c * dy * dy).half() - (c * k * y * y / a).half())]);
    let square = dy + c * y / (int(2) * a);
    page.claim("section5-stability", "definite", r"The function $V$ of section5-stability/function is positive definite for $a,c,k>0$: $V=\frac a2\left(\dot y+\frac c{2a}y\right)^2+\left(\frac k2+\frac{c^2}{8a}\right)y^2$")
        .given([Positive(a), Positive(c), Positive(k)])
        .follows([Equal(v, (a * square * square).half() + (k.half() + c * c / (int(8) * a)) * y * y)]);
}
