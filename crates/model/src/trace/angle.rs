//! Sines and cosines of angles that contain multiples of pi: cos(pi/6) is sqrt(3)/2, cos(theta + pi/2) is -sin(theta).

use field::{Analytic, Circle, Rational};
use symbolic::Sym;

/// Returns the symbol of pi in expressions of a model.
pub(super) fn pi() -> Sym {
    Sym::symbol("pi")
}

/// Returns (cos, sin) of an angle, exact for multiples of pi/12.
pub(super) fn circle(angle: Sym) -> Circle<Sym> {
    let pi = pi();
    let part = angle.diff(pi).as_constant().filter(|part| part.sign() != Some(0));
    let Some((part, point)) = part.and_then(|part| Some((part, exact(part)?))) else { return angle.circle() };
    let rest = angle.substitute(&[(pi, Sym::ZERO)]);
    // excludes angles in which pi is a factor of another term
    if (angle - rest).linear_terms() != [(pi, part)] {
        return angle.circle();
    }
    rest.circle() + point
}

/// Returns exact (cos, sin) of `part` times pi if this is a multiple of pi/12.
fn exact(part: Rational) -> Option<Circle<Sym>> {
    let twelfths = (part * Rational::new(12, 1)).to_big().filter(|big| big.denominator().is_one())?;
    Some(Sym::of_twelfths(i64::try_from(twelfths.numerator()).ok()?))
}

#[cfg(test)]
mod tests {
    use super::{circle, pi};
    use field::{Analytic, Scalar};
    use symbolic::{Hypotheses, Sym, decide};

    #[test]
    fn multiples_of_pi_have_exact_circle_points() {
        for twelfths in -30_i64..30 {
            let angle = pi() * Sym::ratio(twelfths, 12);
            let point = circle(angle);
            let value =
                |part: Sym| part.evaluate_analytic(&|name| (name == "pi").then_some(std::f64::consts::PI)).unwrap();
            let expected = twelfths as f64 * std::f64::consts::PI / 12.0;
            assert!((value(point.cos) - expected.cos()).abs() < 1e-14, "{twelfths}");
            assert!((value(point.sin) - expected.sin()).abs() < 1e-14, "{twelfths}");
        }
        assert_eq!(circle(pi() / Sym::int(2)).cos, Sym::ZERO);
    }

    #[test]
    fn a_quarter_turn_is_taken_out_of_a_sum() {
        let x = Sym::symbol("x");
        let turned = circle(x + pi() / Sym::int(2));
        assert!(decide(turned.cos + x.circle().sin, &Hypotheses::none()).is_zero());
        let product = circle(x * pi());
        assert_eq!(product, (x * pi()).circle());
    }
}
