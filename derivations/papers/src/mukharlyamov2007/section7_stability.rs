//! Section 7: consequences of the inequalities for a body of variable mass.

use super::alphabet::{int, letter};
use super::section7_lyapunov::{Bundle, body};
use super::top::{TopLetters, field, perturbations, perturbed, varying};
use claims::{Condition, Page, Point};
use field::Scalar;
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &TopLetters) {
    page.section("7. Stability with variable mass");
    let bundle = Bundle::new(s);
    not_asymptotic(page, s);
    rate(page, &bundle);
    definite(page, &bundle);
}

/// A hanging body that loses mass, at an instant, with a perturbation.
fn instant<const N: usize>(state: [(&'static str, i64, i64); N]) -> Vec<(&'static str, i64, i64)> {
    [("A", 2, 1), ("C", 1, 1), ("ν", 5, 1), ("r₀", 1, 1), ("M", 1, 1), ("zc", -1, 1), ("g", 1, 1), ("R", 3, 1)]
        .into_iter()
        .chain([("Ȧ", -1, 1), ("Ċ", -1, 1), ("Ṁ", -2, 1), ("żc", 0, 1)])
        .chain(state)
        .collect()
}

fn point(values: Vec<(&str, i64, i64)>) -> Point {
    Point::named(values.into_iter().map(|(name, top, bottom)| (name.to_string(), field::Rational::new(top, bottom))))
}

/// The four inequalities with omega^2 = g/R and 4A.
fn printed(bundle: &Bundle) -> [Sym; 4] {
    let [a, c, n] = body();
    [
        bundle.discriminant(),
        -varying(a),
        -varying(c * c / a),
        varying(a) * varying(bundle.of_directions()) - varying(n) * varying(n) / int(4),
    ]
}

/// Claims: the constant axial speed excludes asymptotic stability.
fn not_asymptotic(page: &mut Page, s: &TopLetters) {
    let bundle = Bundle::new(s);
    let [x1, x2, x3, x4, x5, x6] = perturbations();
    let on_axis = |e: Sym| e.substitute(&[x1, x2, x4, x5, x6].map(|x| (x, Sym::ZERO)));
    let rates = field(s).map(|rate| on_axis(perturbed(rate)));
    page.claim("section7-stability", "asymptotic", r"Under the four inequalities the rotation is asymptotically stable: a perturbation $x_3$ of the axial speed decays, $x_3\dot x_3<0$")
        .reading("The text says stable with respect to (21); the particular integrals (22) are meant.")
        .why(r"$C\dot r=0$ in (21): every perturbation of $r$ stays.")
        .given(printed(&bundle).map(Positive))
        .given([NonZero(x3)])
        .refuted([Positive(-(x3 * rates[2]))], point(instant([("ω3", 1, 1)])));
    page.claim("section7-stability", "asymptotic-corrected", r"The rotation is never asymptotically stable, for any $A(t)$, $C(t)$, $Mz_c(t)$. (21) has the motion $p=q=\gamma_1=\gamma_2=0$, $\gamma_3=1$ with every constant $r$, and $\dot r=0$ on all motions")
        .in_words()
        .follows(rates.into_iter().chain([perturbed(field(s)[2])]).map(Zero));
    page.correct();
}

/// Claims on dV/dt along (21) with variable parameters.
fn rate(page: &mut Page, bundle: &Bundle) {
    let ([a, c, n], [x1, x2, x3, x4, x5, x6]) = (body(), perturbations());
    let directions = bundle.of_directions();
    let form = varying(a) * (x1 * x1 + x2 * x2)
        + varying(c * c / a) * x3 * x3
        + varying(directions) * (x4 * x4 + x5 * x5 + x6 * x6)
        - varying(n) * (x1 * x4 + x2 * x5)
        - varying(n * c / a) * x3 * x6;
    page.claim("section7-stability", "rate", r"Along (21) with varying $A$, $C$, $Mz_c$ and no other moments $\dot V=\frac{\partial V}{\partial t}$, exactly, and its quadratic form is $\dot A(x_1^2+x_2^2)+\left(\frac{C^2}A\right)^{\textstyle\cdot}x_3^2+\dot\kappa(x_4^2+x_5^2+x_6^2)-\dot N(x_1x_4+x_2x_5)-\left(\frac{NC}A\right)^{\textstyle\cdot}x_3x_6$. On $|\gamma|=1$ the part beyond it, $\frac34(\omega^2(A-C))^{\textstyle\cdot}(f_4^2-4x_6^2)$, is $-3(\omega^2(A-C))^{\textstyle\cdot}x_6^2$")
        .in_words()
        .follows([Zero(bundle.along(bundle.corrected())), Equal(varying(bundle.quadratic()), form)]);
    let length = x4 * x4 + x5 * x5 + x6 * x6 + x6 + x6;
    let [_, da, de, last] = printed(bundle).map(|inequality| -inequality);
    let lean = varying(n) / (da + da);
    let on_sphere =
        da * ((x1 - lean * x4).powi(2) + (x2 - lean * x5).powi(2)) + de * x3 * x3 - last / da * (x4 * x4 + x5 * x5);
    page.claim("section7-stability", "on-the-sphere", r"On motions with $f_4=0$, $x_6=-\frac12(x_4^2+x_5^2+x_6^2)$ is of the second order, and the quadratic form of $\dot V$ is $\dot A\left(x_1-\frac{\dot N}{2\dot A}x_4\right)^2+\dot A\left(x_2-\frac{\dot N}{2\dot A}x_5\right)^2+\left(\frac{C^2}A\right)^{\textstyle\cdot}x_3^2+\frac1{\dot A}\left(\dot A\dot\kappa-\frac14\dot N^2\right)(x_4^2+x_5^2)$ with $N=Cr_0+\nu$. It is negative definite if and only if the last three printed inequalities hold")
        .in_words()
        .given([Zero(length), NonZero(varying(a))])
        .by_combination([
            (Equal(x6, -(x4 * x4 + x5 * x5 + x6 * x6).half()), vec![], vec![(0, int(1) / int(2))]),
            (Equal(form.substitute(&[(x6, Sym::ZERO)]), on_sphere), vec![], vec![]),
        ]);
}

/// Claims on the definiteness of dV/dt.
fn definite(page: &mut Page, bundle: &Bundle) {
    let ([a, c, n], [x1, x2, x3, x4, x5, x6]) = (body(), perturbations());
    let form = varying(bundle.quadratic());
    let (da, de, dk) = (varying(a), varying(c * c / a), varying(bundle.of_directions()));
    let (dn, dm) = (varying(n), varying(n * c / a));
    let states = [("ω1", 0, 1), ("ω2", 0, 1), ("ω3", 1, 1), ("η4", 0, 1), ("η5", 0, 1), ("η6", 1, 1)];
    page.claim("section7-stability", "fifth", r"The four inequalities make the quadratic form of $\dot V$ negative in all six perturbations, $f_4\ne0$ included")
        .given(printed(bundle).map(Positive))
        .why(r"$x_3$ and $x_6$ are coupled by $\left(\frac{NC}A\right)^{\textstyle\cdot}x_3x_6$, which none of the four inequalities bounds.")
        .refuted([Positive(-form)], point(instant(states)));
    let shift = |x: Sym, y: Sym, by: Sym| (x - by * y).powi(2);
    let squares = da * (shift(x1, x4, dn / (da + da)) + shift(x2, x5, dn / (da + da)))
        + de * shift(x3, x6, dm / (de + de))
        + (dk - dn * dn / (int(4) * da)) * (x4 * x4 + x5 * x5)
        + (dk - dm * dm / (int(4) * de)) * x6 * x6;
    page.claim("section7-stability", "fifth-corrected", r"The quadratic form of $\dot V$ in six perturbations needs a fifth inequality, $\left(\frac{C^2}A\right)^{\textstyle\cdot}\dot\kappa-\frac14\left(\left(\frac{NC}A\right)^{\textstyle\cdot}\right)^2>0$. It is a sum of squares whose coefficients $\dot A$, $\left(\frac{C^2}A\right)^{\textstyle\cdot}$, $\dot\kappa-\frac{\dot N^2}{4\dot A}$ and that of $x_6^2$ are negative if and only if the last three printed inequalities and the fifth hold")
        .in_words()
        .given([NonZero(da), NonZero(de)])
        .follows([Equal(form, squares)]);
    page.correct();
    stable(page, bundle);
    let [t, h, bound] = ["t", "h", "bᴬ"].map(letter);
    let [least, excess] = ["A₀", "A₁"].map(letter);
    let rate = (least + excess / (int(1) + t / h)).diff(t);
    let late = (-rate).substitute(&[(t, excess / bound)]);
    page.claim("section7-stability", "uniform", r"$\dot A<0$ need not stay away from zero. With $A=A_0+A_1/(1+t/h)$, which tends to $A_0$ as the paper assumes, $-\dot A$ is below every bound $b>0$ at the time $A_1/b$. Since $\dot V=\dot Ax_1^2$ where the other $x$ vanish (section7-stability/rate), $\dot V$ is then not negative definite in Lyapunov's sense, uniformly in $t$")
        .in_words()
        .given([excess, h, bound].map(Positive))
        .by_signs([Positive(bound - late)]);
}

/// Claims on stability by V, under the corrected conditions.
fn stable(page: &mut Page, bundle: &Bundle) {
    let ([a, c, n], [x1, x2, x3, x4, x5, x6]) = (body(), perturbations());
    let (da, de, dn, dm) = (varying(a), varying(c * c / a), varying(n), varying(n * c / a));
    let shift = |x: Sym, y: Sym, by: Sym| (x - by * y).powi(2);
    let across = varying(bundle.of_directions()) - dn * dn / (int(4) * da);
    let along = varying(bundle.without_field()) - dm * dm / (int(4) * de);
    let squares = da * (shift(x1, x4, dn / (da + da)) + shift(x2, x5, dn / (da + da)))
        + de * shift(x3, x6, dm / (de + de))
        + across * (x4 * x4 + x5 * x5)
        + along * x6 * x6;
    let length = x4 * x4 + x5 * x5 + x6 * x6 + x6 + x6;
    page.claim("section7-stability", "stable", r"On $|\gamma|=1$ along (21) corrected $\dot V=\dot A\left(x_1-\frac{\dot N}{2\dot A}x_4\right)^2+\dot A\left(x_2-\frac{\dot N}{2\dot A}x_5\right)^2+\dot E\left(x_3-\frac{\dot F}{2\dot E}x_6\right)^2+\left(\dot\kappa-\frac{\dot N^2}{4\dot A}\right)(x_4^2+x_5^2)+\left(\dot\chi-\frac{\dot F^2}{4\dot E}\right)x_6^2$ with $E=\frac{C^2}A$, $F=\frac{NC}A$, $\chi=\frac{N^2}{2A}-Mgz_c$. Where $\dot A<0$, $\dot E<0$, $\dot A\dot\kappa\ge\frac14\dot N^2$, $\dot E\dot\chi\ge\frac14\dot F^2$, $V$ never grows; with $D(t)$ above a positive number the rotation is stable by Lyapunov's theorem (not proved here)")
        .in_words()
        .given([NonZero(da), NonZero(de), Zero(length)])
        .by_combination([(
            Equal(varying(bundle.corrected()), squares),
            vec![],
            vec![(2, varying(bundle.of_length()) * (x4 * x4 + x5 * x5 + x6 * x6 + x6 + x6))],
        )]);
}
