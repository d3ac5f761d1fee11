//! Section 7: the combination V of integrals, its quadratic form, and conditions for definiteness.

use super::alphabet::{exact, int, letter, letters};
use super::top::{TopLetters, field, half, perturbations, perturbed, unperturbed};
use algebra::linear;
use claims::{Condition, Page};
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &TopLetters) {
    page.section("7. The function V and the permanent rotation of constant mass");
    let bundle = Bundle::new(s);
    bundle.first_order(page);
    bundle.form(page);
    bundle.definite(page);
    inequality(page, s);
    linearised(page, s);
}

/// The terms of V: N = C r_0 + nu, the coefficient of x_4^2 in the form, the discriminant.
#[derive(Clone, Copy, Debug)]
pub struct Bundle {
    tide: Sym,
    integrals: [Sym; 3],
    length: Sym,
}

/// The symbols A, C, C r_0 + nu.
pub fn body() -> [Sym; 3] {
    let [a, c, nu, r0] = letters(["A", "C", "ν", "r₀"]);
    [a, c, c * r0 + nu]
}

fn weight() -> Sym {
    let [m, g, z] = letters(["M", "g", "zc"]);
    m * g * z
}

impl Bundle {
    pub fn new(s: &TopLetters) -> Self {
        let gamma = s.at.vertical;
        Bundle { tide: s.tide, integrals: s.printed_integrals(), length: gamma.dot(&gamma) - int(1) }
    }

    /// V for a coefficient of f_3 and a value of omega^2; f_3 means r - r_0, as its dimension requires.
    fn value(&self, of_axial: Sym, square: Sym) -> Sym {
        let ([a, c, n], [f1, f2, _]) = (body(), self.integrals);
        let f3 = letter("r") - letter("r₀");
        f1 - n / a * f2
            + of_axial * f3
            + c / a * (c - a) * f3 * f3
            + (n * n / (int(2) * a) + int(3) * square * (a - c) - weight()) * self.length
            + int(3) / int(4) * square * (a - c) * self.length * self.length
    }

    /// V with the correct coefficients, minus its value at the permanent rotation, in terms of x.
    pub fn corrected(&self) -> Sym {
        let [a, c, n] = body();
        let v = perturbed(self.value(c * (n / a - int(2) * letter("r₀")), self.tide / int(3)));
        v - unperturbed(v)
    }

    /// The coefficient (C r_0 + nu)^2/(2A) + 3 omega^2 (A - C) - M g z_c with omega^2 = g/R.
    pub fn of_directions(&self) -> Sym {
        let [a, c, n] = body();
        n * n / (int(2) * a) + self.tide * (a - c) - weight()
    }

    /// The coefficient `of_directions` without the Newtonian field: (C r_0 + nu)^2/(2A) - M g z_c.
    pub fn without_field(&self) -> Sym {
        let [a, _, n] = body();
        n * n / (int(2) * a) - weight()
    }

    /// The coefficient of f_4^2, 3/4 omega^2 (A - C).
    pub fn of_length(&self) -> Sym {
        let [a, c, _] = body();
        self.tide * (a - c) / int(4)
    }

    /// The discriminant (C r_0 + nu)^2 - 4A (M g z_c - 3 omega^2 (A - C)).
    pub fn discriminant(&self) -> Sym {
        let [a, c, n] = body();
        n * n - int(4) * a * (weight() - self.tide * (a - c))
    }

    /// The quadratic form of V.
    pub fn quadratic(&self) -> Sym {
        let ([a, c, n], [x1, x2, x3, x4, x5, x6]) = (body(), perturbations());
        a * (x1 * x1 + x2 * x2) + c * c / a * x3 * x3 + self.of_directions() * (x4 * x4 + x5 * x5 + x6 * x6)
            - n * (x1 * x4 + x2 * x5)
            - n * c / a * x3 * x6
    }

    /// Claims on the terms of first order, which must cancel.
    fn first_order(&self, page: &mut Page) {
        let ([a, c, n], [_, _, x3, _, _, x6]) = (body(), perturbations());
        let slope = |v: Sym, x: Sym| unperturbed(perturbed(v).diff(x));
        let r0 = letter("r₀");
        let printed = self.value(int(2) * c * (n / a - r0), self.tide);
        page.claim(
            "section7-lyapunov",
            "printed",
            r"$V$ as printed, with $\omega^2=3g/R$, has no terms of the first order in $x$",
        )
        .reading(r"$f_3=r-r_0$ is read in $V$, not $C(r-r_0)$ of (17): the terms with $f_3$ have the dimension of the others then alone.")
        .why(r"A factor 2 is missing in the coefficient of $f_3$, and $\omega^2=3g/R$ counts the field three times; $\omega^2=g/R$ is right.")
        .refuted(
            [Zero(slope(printed, x3)), Zero(slope(printed, x6))],
            exact([
                ("A", 2, 1),
                ("C", 1, 1),
                ("ν", 0, 1),
                ("r₀", 1, 1),
                ("M", 1, 1),
                ("zc", 1, 1),
                ("g", 1, 1),
                ("R", 3, 1),
            ]),
        );
        let right = self.corrected();
        page.claim("section7-lyapunov", "corrected", r"$V$ with $\omega^2=g/R$ and the coefficient $2C\left(\frac{Cr_0+\nu}{2A}-r_0\right)$ of $f_3=r-r_0$ has no terms of the first order in $x$")
            .in_words()
            .follows(perturbations().map(|x| Zero(unperturbed(right.diff(x)))));
        page.correct();
        page.claim("section7-lyapunov", "excess", r"$V$ as printed has the terms of the first order $\frac CA(Cr_0+\nu)x_3+4\frac{3g}R(A-C)x_6$. With $\omega^2=3g/R$ it counts the field three times")
                .in_words()
            .follows([Equal(slope(printed, x3), c * n / a), Equal(slope(printed, x6), int(4) * self.tide * (a - c))]);
    }

    /// Claims on the quadratic form and the terms of higher order.
    fn form(&self, page: &mut Page) {
        let ([a, c, _], [_, _, _, x4, x5, x6]) = (body(), perturbations());
        let square = x4 * x4 + x5 * x5 + x6 * x6;
        let left = int(1) / int(4) * self.tide * (a - c) * square * (square + int(4) * x6);
        page.claim("section7-lyapunov", "form", r"$V$ corrected is $A(x_1^2+x_2^2)+\frac{C^2}Ax_3^2+\kappa(x_4^2+x_5^2+x_6^2)-(Cr_0+\nu)(x_1x_4+x_2x_5)-\frac{C(Cr_0+\nu)}Ax_3x_6$ and terms of the third order, with the printed $\kappa=\frac1{2A}(Cr_0+\nu)^2+3\omega^2(A-C)-Mgz_c$")
            .in_words()
            .follows([Equal(self.corrected(), self.quadratic() + left)]);
    }

    /// Claims on the definiteness of the form, by completing squares.
    fn definite(&self, page: &mut Page) {
        let ([a, c, n], [x1, x2, x3, x4, x5, x6]) = (body(), perturbations());
        let shift = |x: Sym, y: Sym, by: Sym| (x - by * y).powi(2);
        let rest = self.discriminant() / (int(4) * a);
        let squares = a * (shift(x1, x4, n / (a + a)) + shift(x2, x5, n / (a + a)))
            + (c * x3 - half(n * x6)).powi(2) / a
            + rest * (x4 * x4 + x5 * x5 + x6 * x6);
        page.claim("section7-lyapunov", "squares", r"The quadratic form of $V$ corrected is $A\left(x_1-\frac{N}{2A}x_4\right)^2+A\left(x_2-\frac N{2A}x_5\right)^2+\frac1A\left(Cx_3-\frac N2x_6\right)^2+\frac{D}{4A}(x_4^2+x_5^2+x_6^2)$ with $N=Cr_0+\nu$, $D=N^2-4A\left(Mgz_c-\frac{3g}R(A-C)\right)$. It is positive definite if and only if $D>0$")
            .in_words()
            .given([Positive(a), Positive(c)])
            .follows([Equal(self.quadratic(), squares)]);
        let bowed = [(x1, half(n * x4 / a)), (x2, Sym::ZERO), (x3, Sym::ZERO), (x5, Sym::ZERO), (x6, Sym::ZERO)];
        page.claim(
            "section7-lyapunov",
            "only-if",
            r"Where $D\le0$ the quadratic form of $V$ corrected is not positive definite. At $x_1=\frac N{2A}x_4$, $x_4\ne0$, the other $x$ zero, its value is $\frac D{4A}x_4^2$",
        )
        .in_words()
        .given([Positive(a)])
        .follows([Equal(self.quadratic().substitute(&bowed), rest * x4 * x4)]);
        let v = self.corrected();
        page.claim("section7-stability", "constant", r"For constant $A$, $C$, $Mz_c$, $\dot V=0$ along (21) corrected. Where $D>0$, $V$ is a positive definite integral and the permanent rotation is stable in $p,q,r,\gamma$ by Lyapunov's theorem (not proved here)")
            .in_words()
            .follows([Zero(self.along(v))]);
    }

    /// The rate of a function of x along (21), with constant parameters.
    pub fn along(&self, v: Sym) -> Sym {
        let moving = field(&TopLetters::default()).map(perturbed);
        perturbations().iter().zip(moving).fold(Sym::ZERO, |sum, (&x, rate)| sum + v.diff(x) * rate)
    }
}

/// Claims on the first of the four inequalities.
fn inequality(page: &mut Page, s: &TopLetters) {
    let [a, c, n] = body();
    let with = |square: Sym| n * n - int(4) * a * (weight() - int(3) * square * (a - c));
    page.claim("section7-stability", "first", r"$(Cr_0+\nu)^2-4A(Mgz_c-3\omega^2(A-C))>0$ with $\omega^2=3g/R$ makes $V$ positive definite, that is $D>0$")
        .given([Positive(a), Positive(c), Positive(a - c), Positive(with(s.tide))])
        .reading("The text has $4a$ for $4A$.")
        .why(r"$\omega^2=3g/R$ counts the field three times: with $A>C$ the condition is weaker than $D>0$, which has $\omega^2=g/R$.")
        .refuted(
            [Positive(with(s.tide / int(3)))],
            exact([
                ("A", 2, 1), ("C", 1, 1), ("ν", 0, 1), ("r₀", 1, 1), ("M", 1, 1), ("zc", 1, 1), ("g", 2, 1), ("R", 6, 1),
            ]),
        );
    let [m, g, z] = letters(["M", "g", "zc"]);
    let delta = letter("Δ");
    let (critical, _) = linear_matrix(s);
    let above = (n * n - delta * delta) / (int(4) * a) + s.tide * (a - c);
    let below = (n * n + delta * delta) / (int(4) * a) + s.tide * (a - c);
    let at = |heavy: Sym| critical.substitute(&[(m, heavy / (g * z))]);
    let (sigma, r0) = (letter("σ"), letter("r₀"));
    let (middle, width) = (n / (a + a) - r0, delta / (a + a));
    page.claim("section7-stability", "first-corrected", r"$D>0$ is the condition, with $\omega^2=g/R$. The linearised equations have the characteristic polynomial $\left(\sigma^2+(\theta+\rho)^2\right)\left(\sigma^2+(\theta-\rho)^2\right)$ where $D=\Delta^2$, and $\left((\sigma-\rho)^2+\theta^2\right)\left((\sigma+\rho)^2+\theta^2\right)$ where $D=-\Delta^2$, $\theta=\frac{Cr_0+\nu}{2A}-r_0$, $\rho=\frac\Delta{2A}$: where $D<0$ some solution grows as $e^{\rho t}$")
        .in_words()
        .given([NonZero(a), NonZero(g * z)])
        .follows([
            Equal(
                at(above),
                (sigma.powi(2) + (middle + width).powi(2)) * (sigma.powi(2) + (middle - width).powi(2)),
            ),
            Equal(
                at(below),
                ((sigma - width).powi(2) + middle.powi(2)) * ((sigma + width).powi(2) + middle.powi(2)),
            ),
        ]);
    page.correct();
}

/// The characteristic matrix sigma - L of the linearised equations in x1, x2, x4, x5: its determinant; and the rates of
/// x3, x6, which are zero.
fn linear_matrix(s: &TopLetters) -> (Sym, [Sym; 2]) {
    let x = perturbations();
    let found = field(s).map(perturbed);
    let slope = |i: usize, j: usize| unperturbed(found[i].diff(x[j]));
    let places = [0, 1, 3, 4];
    let sigma = letter("σ");
    let rows = places.map(|i| places.map(|j| if i == j { sigma - slope(i, j) } else { -slope(i, j) }));
    let determinant = linear::determinant(&rows).unwrap_or(Sym::UNDEFINED);
    let sum = |i: usize| (0..6).fold(Sym::ZERO, |sum, j| sum + slope(i, j) * x[j]);
    (determinant, [sum(2), sum(5)])
}

/// Claims on the other two perturbations to first order.
fn linearised(page: &mut Page, s: &TopLetters) {
    let (_, others) = linear_matrix(s);
    page.claim(
        "section7-stability",
        "neutral",
        "The linearised equations keep $x_3$ and $x_6$, so that two zero roots come in addition to the four of section7-stability/first-corrected",
    )
    .in_words()
    .under(&Hypotheses::none())
    .follows(others.map(Zero));
}
