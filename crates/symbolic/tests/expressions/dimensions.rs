//! Dimensions of expressions.

use dalembert_symbolic::{Dimension, Mismatch, Sym, dimension, symbols};
use field::{Analytic, Rational, Scalar};

fn lookup(name: &str) -> Option<Dimension> {
    match name {
        "m" => Some(Dimension::mass()),
        "x" | "y" => Some(Dimension::length()),
        "t" => Some(Dimension::time()),
        "g" => Some(Dimension::of(0, 1, -2, 0)),
        "theta" => Some(Dimension::none()),
        "M2" => Some(Dimension::of(1, 2, -2, 0)),
        _ => None,
    }
}

#[test]
fn products_roots_and_laws_have_their_dimensions() {
    let [m, x, g, theta, t] = symbols(["m", "x", "g", "theta", "t"]);
    let energy = Dimension::of(1, 2, -2, 0);
    assert_eq!(dimension(m * g * x * theta.circle().cos, &lookup), Ok(Some(energy)));
    assert_eq!(dimension((x / g).sqrt(), &lookup), Ok(Some(Dimension::time())));
    assert_eq!(dimension(x.sqrt(), &lookup), Ok(Some(Dimension::length().power(Rational::new(1, 2)))));
    assert_eq!(Dimension::length().power(Rational::new(1, 2)).to_string(), "m^(1/2)");
    let law = Sym::function("M2", theta / t);
    assert_eq!(dimension(law, &lookup), Ok(Some(energy)));
    assert_eq!(dimension(law.diff(t) * t, &lookup), Ok(Some(energy)));
    assert_eq!(energy.to_string(), "kg m^2 s^-2");
    assert_eq!(Dimension::none().to_string(), "1");
}

#[test]
fn a_sum_of_unlike_terms_names_both() {
    let [m, x, theta] = symbols(["m", "x", "theta"]);
    let error = dimension(m + x * theta, &lookup).unwrap_err();
    assert_eq!(error.to_string(), "`m` has the dimension kg and `x*theta` has m");
    assert!(matches!(dimension(x.circle().cos, &lookup), Err(Mismatch::Argument { .. })));
    assert_eq!(dimension(Sym::symbol("q"), &lookup), Err(Mismatch::Unknown(Sym::symbol("q"))));
}

#[test]
fn zero_is_of_every_dimension() {
    let [m, x] = symbols(["m", "x"]);
    assert_eq!(dimension(Sym::int(0), &lookup), Ok(None));
    assert_eq!(dimension(m * (x - x) + x, &lookup), Ok(Some(Dimension::length())));
}
