//! Exact values of cosines and sines at multiples of pi/12, recognised from rounded constants: cos(pi/4) = sqrt(2)/2,
//! cos(pi/2) = 0.

use field::Rational;
use std::collections::HashSet;
use symbolic::{Node, Sym, substitute_all};

/// A constant closer than this to an exact value is its rounding.
const ROUNDING: f64 = 5e-16;

/// The expression with every constant that is a rounded cosine or sine of a multiple of pi/12 replaced by its exact
/// value in square roots.
pub(crate) fn with_exact_turns(expression: Sym) -> Sym {
    let mut constants: Vec<Sym> = Vec::new();
    let (mut open, mut seen) = (vec![expression], HashSet::new());
    while let Some(next) = open.pop() {
        if seen.insert(next) {
            if matches!(next.node(), Node::Constant(_)) {
                constants.push(next);
            }
            open.extend(next.node().children());
        }
    }
    let exact = |constant: Sym| Some((constant, exact(constant.as_constant()?)?));
    let known: Vec<(Sym, Sym)> = constants.into_iter().filter_map(exact).collect();
    substitute_all(&[expression], &known)[0]
}

/// The exact value of a rounded constant; `None` for a short decimal, or if there is no such value.
fn exact(constant: Rational) -> Option<Sym> {
    let value = constant.to_f64();
    let is_float = Rational::exactly(value) == constant && Rational::decimal(value) != constant;
    if !is_float || value.abs() > 1.0 {
        return None;
    }
    let angle = |k: &i64| (std::f64::consts::PI * *k as f64 / 12.0).cos();
    let k = (0..=12).find(|k| (angle(k) - value).abs() <= ROUNDING)?;
    Some(Sym::of_twelfths(k).cos)
}

#[cfg(test)]
mod tests {
    use super::with_exact_turns;
    use field::{Circle, Rational, Scalar};
    use symbolic::Sym;

    #[test]
    fn rounded_parts_of_a_turn_are_recognised_and_other_numbers_stay() {
        let lift = |value: f64| Sym::constant(Rational::exactly(value));
        let x = Sym::symbol("x");
        for (part, whole, expected) in [(1, 8, "sqrt(2)/2*x"), (3, 8, "-sqrt(2)/2*x"), (1, 4, "0"), (1, 6, "1/2*x")] {
            let point: Circle<f64> = Circle::turn(part, whole);
            assert_eq!(with_exact_turns(lift(point.cos) * x).to_string(), expected);
        }
        let seventh: Circle<f64> = Circle::turn(1, 14);
        for other in [0.35, 0.5, 0.707, 1e-3, 3.0, seventh.cos] {
            assert_eq!(with_exact_turns(lift(other) * x), lift(other) * x);
        }
        assert_eq!(with_exact_turns(Sym::ratio(1, 3) * x), Sym::ratio(1, 3) * x);
    }
}
