//! Section 1.3, task 2: the uniform ladder integrated, (1.108)-(1.110).

use super::alphabet::{int, letter, letters, tidy};
use super::ladder::LadderLetters;
use claims::{Condition, Line, Page};
use field::{Circle, Tangent};
use symbolic::{Hypotheses, Sym};

use Condition::Equal;

pub fn claims(page: &mut Page, s: &LadderLetters) {
    page.section("1.3. Task 2, the quadrature");
    let u = Uniform::new(s);
    first_order(page, s, &u);
    variation(page, s, &u);
    solution(page, s, &u);
    reactions(page, s, &u);
}

/// The uniform ladder with the friction coefficient f at both ends, in the paper's symbols a and b.
struct Uniform {
    f: Sym,
    a: Sym,
    /// a - 2/3.
    inertia: Sym,
    b: Sym,
    /// The exponent af/(a - 2/3) of the homogeneous solution.
    growth: Sym,
    /// The acceleration alpha'' of the motion.
    derived: Sym,
    /// The values a = 2/(1 + f^2), b = -2af/(a - 2/3).
    names: Hypotheses,
}

impl Uniform {
    fn new(s: &LadderLetters) -> Self {
        let [f, a, b] = letters(["f", "a", "b"]);
        let inertia = a - int(2) / int(3);
        let growth = a * f / inertia;
        let names = Hypotheses::none().given(a, int(2) / (int(1) + f.powi(2))).given(b, -(int(2) * a * f / inertia));
        Uniform { f, a, inertia, b, growth, derived: tidy(s.uniform(s.acceleration())), names }
    }

    /// (af^2 - 1) sin + af cos.
    fn load<S: field::Scalar>(&self, lift: impl Fn(Sym) -> S, point: Circle<S>) -> S {
        lift(self.a * self.f.powi(2) - int(1)) * point.sin + lift(self.a * self.f) * point.cos
    }

    /// ((af^2 - 1) b + af) sin + (baf - (af^2 - 1)) cos.
    fn integrated<S: field::Scalar>(&self, lift: impl Fn(Sym) -> S, point: Circle<S>) -> S {
        let (weight, wedge) = (self.a * self.f.powi(2) - int(1), self.a * self.f);
        lift(weight * self.b + wedge) * point.sin + lift(self.b * wedge - weight) * point.cos
    }

    /// A symbol for e^{b alpha} as a dual number along alpha.
    fn exponential(&self, name: Sym) -> Tangent<Sym> {
        Tangent::moving(name, self.b * name)
    }
}

fn along_alpha(s: &LadderLetters) -> Circle<Tangent<Sym>> {
    s.point.moving(int(1))
}

fn first_order(page: &mut Page, s: &LadderLetters, u: &Uniform) {
    let slope = letter("dα̇/dα");
    let derived = u.inertia * (s.dalpha * slope - u.derived);
    page.claim(
        "eq1.108",
        "first-order",
        r"(1.107) for the uniform ladder is (1.108), with $\ddot\alpha=\dot\alpha\,d\dot\alpha/d\alpha$ and $a=2/(1+f^2)$",
    )
    .under(&u.names)
    .holds([Line::equation(
        derived,
        u.inertia * s.dalpha * slope,
        u.a * u.f * s.dalpha.powi(2) - s.g / s.l * u.load(|x| x, s.point),
    )]);
}

/// Claims on the steps of the variation of constants, with symbols for the exponentials and their rates along alpha.
fn variation(page: &mut Page, s: &LadderLetters, u: &Uniform) {
    let [constant, rate] = letters(["C₁", "C₁′"]);
    // G stands for e^{k alpha}, with k = af/(a - 2/3) of the homogeneous equation
    let grown = letter("G");
    let moving = Tangent::moving(grown, u.growth * grown);
    let varied = Tangent::moving(constant, rate) * moving;
    let homogeneous = Tangent::fixed(constant) * moving;
    page.claim(
        "section1.3-ladder-quadrature",
        "homogeneous",
        r"$\dot\alpha=C_1G$, $G=e^{af\alpha/(a-2/3)}$, solves (1.108) without its load",
    )
    .under(&u.names)
    .follows([Equal(u.inertia * homogeneous.value * homogeneous.slope, u.a * u.f * homogeneous.value.powi(2))]);
    page.claim(
        "section1.3-ladder-quadrature",
        "varied",
        r"If $C_1$ varies, $d\dot\alpha/d\alpha$ contains $C_1'$, where $G=e^{af\alpha/(a-2/3)}$",
    )
    .under(&u.names)
    .holds([Line::formula(varied.slope, letter("dα̇/dα"), rate * grown + constant * u.a * u.f / u.inertia * grown)]);
    let left =
        u.inertia * varied.value * (varied.slope - u.derived.substitute(&[(s.dalpha, varied.value)]) / varied.value);
    let load = -(s.g / s.l * u.load(|x| x, s.point));
    page.claim(
        "section1.3-ladder-quadrature",
        "constant",r"The equation for $C_1$ has $e^{+2af\alpha/(a-2/3)}=G^2$ on the right as printed, with $G=e^{af\alpha/(a-2/3)}$",
    ).why(r"$C_1C_1^{\prime}G^2$ stands on the left, so the right side is divided by $G^2$; the integrals that follow have the right exponent.")
    .under(&u.names)
    .fails([Line::equation(left / grown.powi(2), u.inertia * constant * rate, load * grown.powi(2))]);
    page.claim(
        "section1.3-ladder-quadrature",
        "constant-corrected",
        r"The equation for $C_1$ has $e^{b\alpha}=e^{-2af\alpha/(a-2/3)}=G^{-2}$ on the right",
    )
    .under(&u.names)
    .holds([Line::equation(left / grown.powi(2), u.inertia * constant * rate, load / grown.powi(2))]);
    page.correct();
    let point = along_alpha(s);
    let exponential = u.exponential(letter("E"));
    let fixed = |x: Sym| Tangent::fixed(x);
    let norm = fixed(int(1) + u.b.powi(2));
    let sine = (fixed(u.b) * point.sin - point.cos) * exponential / norm;
    let cosine = (point.sin + fixed(u.b) * point.cos) * exponential / norm;
    page.claim(
        "section1.3-ladder-quadrature",
        "integrals",r"The closed forms of $I_1=\int e^{b\alpha}\sin\alpha\,d\alpha$ and $I_2=\int e^{b\alpha}\cos\alpha\,d\alpha$ have these integrands as derivatives",
    )
    .in_words()
    .under(&u.names)
    .follows([
        Equal(sine.slope, exponential.value * s.point.sin),
        Equal(cosine.slope, exponential.value * s.point.cos),
    ]);
    let integral = u.integrated(fixed, point) * exponential / norm;
    page.claim("section1.3-ladder-quadrature", "constant-integrated",r"$\frac12(a-\frac23)(C_1^2-\tilde C)$ by $I_1$ and $I_2$ has the derivative $(a-\frac23)C_1C_1^{\prime}$ of the equation with $e^{b\alpha}$").in_words().under(&u.names)
        .follows([Equal(-(s.g / s.l) * integral.slope, load * exponential.value)]);
}

/// Claims on (1.109).
fn solution(page: &mut Page, s: &LadderLetters, u: &Uniform) {
    let (fixed, point) = (|x: Sym| Tangent::fixed(x), along_alpha(s));
    let constant = letter("C̃");
    let exponential = u.exponential(letter("E"));
    let factor = int(2) * s.g / (s.l * (int(1) + u.b.powi(2)) * (int(2) / int(3) - u.a));
    let forced = fixed(factor) * u.integrated(fixed, point);
    let [name] = letters(["d(α̇²)/dα"]);
    // d(alpha'^2)/dalpha = 2 alpha'' of the motion, with alpha'^2 by the formula
    let motion = |square: Sym| {
        let [spin] = letters(["Q"]);
        let linear = u.derived.substitute(&[(s.dalpha, Sym::ZERO)]);
        let growth = (u.derived - linear) / s.dalpha.powi(2) * spin;
        int(2) * (linear + tidy(growth)).substitute(&[(spin, square)])
    };
    let printed = forced + fixed(constant) * exponential;
    page.claim("eq1.109", "square",r"$\dot\alpha^2$ is (1.109) as printed, with $\tilde Ce^{b\alpha}$. Its derivative along $\alpha$ is compared with $2\ddot\alpha$ of the motion").reading(r"The source prints $g^2$ in the factor; $g^2/l$ is no square of an angular velocity, so $2g$ is read.").why(r"The homogeneous solution is $e^{-b\alpha}$: the sign of the exponent is wrong.").under(&u.names)
        .fails([Line::formula(motion(printed.value), name, printed.slope)]);
    let corrected = forced + fixed(constant) / exponential;
    page.claim("eq1.109", "square-corrected",r"$\dot\alpha^2=\frac{2g}{l(1+b^2)(\frac23-a)}[\dots]+\tilde Ce^{-b\alpha}$ solves the equation of motion for every $\tilde C$").under(&u.names)
        .holds([Line::formula(motion(corrected.value), name, corrected.slope)]);
    page.correct();

    let [start, speed, begun, now] = letters(["α₀", "α̇₀", "E₀", "E"]);
    let at_start = |expression: Sym| {
        let point = field::Analytic::circle(start);
        expression.substitute(&[(s.point.cos, point.cos), (s.point.sin, point.sin), (now, begun)])
    };
    let initial = speed.powi(2) - at_start(forced.value);
    // the constant for which the correct formula gives alpha'_0 at alpha_0
    let begins = at_start(corrected.value) - speed.powi(2);
    let derived = -(begins.substitute(&[(constant, Sym::ZERO)]) / begins.diff(constant));
    page.claim(
        "eq1.109",
        "constant",
        r"As printed, the constant from the initial state is $\tilde C=e^{-b\alpha_0}[\dot\alpha_0^2-\dots]$",
    )
    .reading(r"The source prints $e^{-b\alpha}$ without the index; $\alpha_0$ is read.")
    .why(r"The sign of the exponent is wrong, as in $\dot\alpha^2$.")
    .under(&u.names)
    .fails([Line::formula(derived, constant, initial / begun)]);
    page.claim(
        "eq1.109",
        "constant-corrected",
        r"The constant from the initial state is $\tilde C=e^{b\alpha_0}[\dot\alpha_0^2-\dots]$",
    )
    .under(&u.names)
    .holds([Line::formula(derived, constant, initial * begun)]);
    page.correct();
}

/// Claims on (1.110).
fn reactions(page: &mut Page, s: &LadderLetters, u: &Uniform) {
    let (c, sin, l, g, f) = (s.point.cos, s.point.sin, s.l, s.g, u.f);
    let derived = s.normal_reactions().map(|push| tidy(s.uniform(push)).substitute(&[(s.ddalpha, u.derived)]));
    let [at_a, at_b] = letters(["RAn", "RBn"]);
    let spin = s.dalpha.powi(2);
    let both = int(1) + f.powi(2);
    let (a, inertia) = (u.a, u.inertia);
    let wall = |wedge: Sym| {
        s.m / both
            * (((a * l * f / inertia - f * l) * c - (a * l * f.powi(2) / inertia + l) * sin) * spin
                - g / inertia * (c - f * sin) * ((a * f.powi(2) - int(1)) * sin + wedge * c)
                + f * g)
    };
    page.claim("eq1.110", "wall", r"$R_A^n$, expressed by the angle, is (1.110) as printed, with $a\cos\alpha$")
        .why(r"The factor $f$ is missing in front of $a\cos\alpha$. (1.108) has it.")
        .under(&u.names)
        .fails([Line::formula(derived[0], at_a, wall(a))]);
    page.claim("eq1.110", "wall-corrected", r"$R_A^n$, expressed by the angle, is (1.110) with $af\cos\alpha$")
        .under(&u.names)
        .holds([Line::formula(derived[0], at_a, wall(a * f))]);
    page.correct();
    let floor = |pull: Sym| s.m / both * (pull * spin + g / inertia * (sin + f * c) * u.load(|x| x, s.point) + g);
    let coefficients = |below: Sym| [(a / below - int(1)) * l * f * sin, (a * f.powi(2) / below + int(1)) * l * c];
    let [first, second] = coefficients(int(2));
    page.claim(
        "eq1.110",
        "floor",
        r"$R_B^n$, expressed by the angle, is (1.110) as printed, with $\frac a2$, $\frac{af^2}2$ and a plus before the second",
    )
    .why(r"The denominators $a-\frac23$ are cut down to 2; with them restored the plus is still wrong.")
    .under(&u.names)
    .fails([Line::formula(derived[1], at_b, floor(-first + second))]);
    let [first, second] = coefficients(inertia);
    page.claim(
        "eq1.110",
        "floor-corrected",
        r"$R_B^n$, expressed by the angle, is (1.110) with $a-\frac23$ below and both terms subtracted",
    )
    .under(&u.names)
    .holds([Line::formula(derived[1], at_b, floor(-first - second))]);
    page.correct();
}
