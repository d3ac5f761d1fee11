//! Expressions are printed in the form in which they were entered, as text and as LaTeX.

use dalembert_symbolic::{Sym, symbols};
use field::{Analytic, Scalar};

fn both(expression: Sym) -> (String, String) {
    (expression.to_string(), expression.latex())
}

#[test]
fn sums_and_products_keep_their_order_and_signs() {
    let [l2, l3, o2, o3] = symbols(["l2", "l3", "omega2", "omega3"]);
    let cross = l2 * o3 - l3 * o2;
    assert_eq!(both(cross), ("l2*omega3 - l3*omega2".into(), r"l_2\omega_3 - l_3\omega_2".into()));
    assert_eq!(both(-cross), ("-(l2*omega3 - l3*omega2)".into(), r"-(l_2\omega_3 - l_3\omega_2)".into()));
    assert_eq!((l2 - (l3 - o2)).to_string(), "l2 - (l3 - omega2)");
    assert_eq!((l2 + (l3 - o2)).to_string(), "l2 + l3 - omega2");
    assert_eq!((l2 - -o2 * l3).to_string(), "l2 + omega2*l3");
    assert_eq!((l2 * (l3 * o2)).to_string(), "l2*l3*omega2");
    assert_eq!((-l2 * -l3).to_string(), "l2*l3");
    assert_eq!((Sym::int(-2) * l2).to_string(), "-2*l2");
    assert_eq!((l2 * (-l3)).to_string(), "-l2*l3");
}

#[test]
fn quotients_and_powers_have_the_parentheses_they_need() {
    let [a, b, c] = symbols(["a", "b", "c"]);
    assert_eq!(both(a * b / c), ("a*b/c".into(), r"\frac{ab}{c}".into()));
    assert_eq!((a / (b * c)).to_string(), "a/(b*c)");
    assert_eq!((a / b / c).to_string(), "a/b/c");
    assert_eq!((a / (b / c)).to_string(), "a/(b/c)");
    assert_eq!(((a + b) / c).to_string(), "(a + b)/c");
    assert_eq!((-(a / b)).to_string(), "-a/b");
    assert_eq!(((-a) / b).to_string(), "-a/b");
    assert_eq!(((a - b) / (a + b)).latex(), r"\frac{a - b}{a + b}");
    assert_eq!(both(a * a * b), ("a^2*b".into(), "a^2b".into()));
    assert_eq!((a + b).powi(12).latex(), "(a + b)^{12}");
    assert_eq!((a / b).powi(2).to_string(), "(a/b)^2");
    assert_eq!(both(Sym::ratio(1, 2) * a), ("1/2*a".into(), r"\frac{1}{2}a".into()));
    assert_eq!((a * Sym::ratio(-1, 2)).to_string(), "-a*1/2");
    assert_eq!((a * (b - c) * (-a)).to_string(), "-a*(b - c)*a");
}

#[test]
fn names_angles_roots_and_functions_have_their_latex() {
    let star = Sym::named("A1s", r"A_1^{*}");
    let rate = Sym::named("domega1", r"\dot\omega_1");
    assert_eq!(both(star * rate), ("A1s*domega1".into(), r"A_1^{*}\dot\omega_1".into()));
    assert_eq!((star * star).latex(), r"(A_1^{*})^2");
    let [theta, x, u] = symbols(["theta", "x", "u_d"]);
    let point = theta.circle();
    assert_eq!(both(point.cos * point.cos * x), ("cos(theta)^2*x".into(), r"\cos^2 \theta\,x".into()));
    assert_eq!((theta * x).latex(), r"\theta x");
    assert_eq!(((x * theta).circle().sin).latex(), r"\sin(x\theta)");
    assert_eq!(both((x + u).sqrt()), ("sqrt(x + u_d)".into(), r"\sqrt{x + u_d}".into()));
    let law = Sym::function("M2", x);
    assert_eq!(both(law.diff(x).diff(x)), ("M2''(x)".into(), "M_2''(x)".into()));
    assert_eq!(Sym::symbol("speed").latex(), r"\mathrm{speed}");
    let [mass, l] = ["mass", "l"].map(Sym::symbol);
    assert_eq!((Sym::int(3) * mass * l * l).latex(), r"3\,\mathrm{mass}\,l^2");
}

#[test]
fn expressions_too_long_to_read_are_named_by_their_size() {
    let x = Sym::symbol("x");
    let tower = (0..40).fold(x, |sum, _| (sum + Sym::int(1)) * sum);
    assert!(tower.to_string().starts_with("(an expression of"));
}

#[test]
fn sympy_reads_names_numbers_and_functions_as_its_own() {
    let [rate, prime, weight] = ["γ̇", "φ′", "λ2"].map(Sym::symbol);
    assert_eq!((rate.squared() - Sym::ratio(1, 2) * prime).sympy(), "gammadot**2 - Rational(1, 2)*phiprime");
    assert_eq!((rate / prime).powi(3).sympy(), "(gammadot/phiprime)**3");
    assert_eq!(((-rate) * weight.circle().cos).sympy(), "-gammadot*cos(lamda2)");
    assert_eq!((rate + prime).sqrt().sympy(), "sqrt(gammadot + phiprime)");
    assert_eq!([Sym::symbol("2x"), Sym::symbol("a b")].map(|name| name.sympy()), ["_2x", "a_b"]);
    let law = Sym::function("M", weight);
    assert_eq!(law.sympy(), "Function('M')(lamda2)");
    assert_eq!(law.diff(weight).sympy(), "Subs(Derivative(Function('M')(_x), (_x, 1)), _x, lamda2)");
}
