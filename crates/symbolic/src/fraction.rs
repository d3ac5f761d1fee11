//! Quotients of polynomials in one unknown, evaluated by Horner's rule.
//!
//! f = p(x)/q(x) costs deg p + deg q multiplications and additions, and one division. The derivative costs as many again:
//!
//!   f' = (p' - f q') / q .
//!
//! Several points are evaluated together, for vector registers.

use crate::{Hypotheses, Sym, Tape, normal, univariate};
use field::{Over, Rational, Tangent};
use num_traits::Zero;

/// A quotient of two polynomials over a field.
#[derive(Clone, Debug, PartialEq)]
pub struct Fraction<S> {
    above: Polynomial<S>,
    /// The denominator; `None` if it is one.
    below: Option<Polynomial<S>>,
}

/// The coefficients in descending order of powers: the leading one, then the others down to the constant.
#[derive(Clone, Debug, PartialEq)]
struct Polynomial<S> {
    leading: S,
    others: Vec<S>,
}

impl Fraction<Rational> {
    /// Converts an expression in one unknown. Returns `None` if the expression is not a quotient of polynomials, if a coefficient overflows `f64`, or if
    /// the quotient needs more operations than the given expression, which would then also have a smaller rounding error.
    pub fn record(expression: Sym, unknown: Sym) -> Option<Self> {
        let written = Tape::record(&[unknown], &[expression]).ok()?;
        let form = normal(expression, &Hypotheses::none()).ok()?;
        let above = univariate(form.numerator(), unknown).ok()?;
        let below = univariate(form.denominator(), unknown).ok()?;
        // normalises the denominator q to be monic
        let scale = *below.last()?;
        let [above, below] = [above, below].map(|all| Polynomial::new(all.into_iter().map(|each| each / scale)));
        let below = Some(below).filter(|below| !below.others.is_empty());
        let fraction = Fraction { above, below };
        (fraction.steps() <= written.operations() && fraction.is_held()).then_some(fraction)
    }

    /// Converts the coefficients to the field `S`.
    pub fn over<S: Over<f64>>(&self) -> Fraction<S> {
        Fraction { above: self.above.over(), below: self.below.as_ref().map(Polynomial::over) }
    }

    fn is_held(&self) -> bool {
        let mut all = [&self.above]
            .into_iter()
            .chain(&self.below)
            .flat_map(|each| [&each.leading].into_iter().chain(&each.others));
        all.all(|coefficient| coefficient.to_f64().is_finite())
    }
}

impl<S> Fraction<S> {
    /// Returns the number of multiply-add operations and divisions.
    fn steps(&self) -> usize {
        self.above.others.len() + self.below.as_ref().map_or(0, |below| 1 + below.others.len())
    }

    /// Returns the number of additions, multiplications and divisions of one value.
    pub fn flops(&self) -> usize {
        2 * self.steps() - usize::from(self.below.is_some())
    }
}

impl<S: Over<f64>> Fraction<S> {
    /// Returns f(x).
    #[inline(always)]
    pub fn value(&self, at: S) -> S {
        let above = self.above.value(at);
        match &self.below {
            Some(below) => above / below.value(at),
            None => above,
        }
    }

    /// Returns f and f' at several points.
    #[inline(always)]
    pub fn moving<const N: usize>(&self, at: &[S; N]) -> [Tangent<S>; N] {
        let above = self.above.moving(at);
        match &self.below {
            Some(below) => {
                let below = below.moving(at);
                std::array::from_fn(|i| {
                    let (p, q) = (above[i], below[i]);
                    let reciprocal = S::one() / q.value;
                    let value = p.value * reciprocal;
                    Tangent::moving(value, p.slope.less_product(value, q.slope) * reciprocal)
                })
            }
            None => above,
        }
    }
}

impl Polynomial<Rational> {
    /// Creates a polynomial from its coefficients, the constant first.
    fn new(coefficients: impl DoubleEndedIterator<Item = Rational>) -> Self {
        let mut falling = coefficients.rev();
        Polynomial { leading: falling.next().unwrap_or_else(Rational::zero), others: falling.collect() }
    }

    fn over<S: Over<f64>>(&self) -> Polynomial<S> {
        Polynomial { leading: nearest(self.leading), others: self.others.iter().copied().map(nearest).collect() }
    }
}

/// Rounds a rational number to the field `S`, with up to twice the digits of `f64`.
fn nearest<S: Over<f64>>(value: Rational) -> S {
    let high = value.to_f64();
    let low = value - Rational::exactly(high);
    S::lift(high) + S::lift(low.to_f64())
}

impl<S: Over<f64>> Polynomial<S> {
    #[inline(always)]
    fn value(&self, at: S) -> S {
        self.others.iter().fold(self.leading, |value, next| next.and_product(value, at))
    }

    #[inline(always)]
    fn moving<const N: usize>(&self, at: &[S; N]) -> [Tangent<S>; N] {
        let (mut values, mut slopes) = ([self.leading; N], [S::zero(); N]);
        for next in &self.others {
            for i in 0..N {
                slopes[i] = values[i].and_product(slopes[i], at[i]);
                values[i] = next.and_product(values[i], at[i]);
            }
        }
        std::array::from_fn(|i| Tangent::moving(values[i], slopes[i]))
    }
}

#[cfg(test)]
mod tests {
    use super::Fraction;
    use crate::Sym;
    use field::{Analytic, DoubleDouble, Over, Tangent};

    /// A quotient of quadratic polynomials plus a linear term, similar to the torque-speed law of a motor.
    fn law<S: Over<f64>>(x: S) -> S {
        let ratio = -x / S::lift(30.0);
        ratio * S::lift(0.02) / (ratio * ratio + S::lift(0.2) * S::lift(0.2)) - S::lift(0.1) * (x + S::lift(30.0))
    }

    const PLACES: [f64; 4] = [-60.0, -5.9, 0.0, 31.0];

    #[test]
    fn values_and_slopes_at_several_places_are_those_of_the_law_to_all_digits_of_the_field() {
        let x = Sym::symbol("x");
        let fraction = Fraction::record(law(x), x).expect("no longer than the law");
        let slow = PLACES.map(|place| law(Tangent::variable(DoubleDouble::lift(place))));
        let exact = fraction.over::<DoubleDouble>().moving(&PLACES.map(DoubleDouble::lift));
        let plain = fraction.over::<f64>();
        for (n, plainly) in plain.moving(&PLACES).into_iter().enumerate() {
            for (ours, theirs) in [(exact[n].value, slow[n].value), (exact[n].slope, slow[n].slope)] {
                assert!((ours - theirs).hi().abs() < 1e-30, "{ours:?} for {theirs:?}");
            }
            let exact = &slow[n];
            let alone = plain.value(PLACES[n]);
            for (ours, exact) in [(plainly.value, exact.value), (plainly.slope, exact.slope), (alone, exact.value)] {
                assert!((ours - exact.hi()).abs() < 1e-15 * exact.hi().abs().max(1.0), "{ours} for {exact:?}");
            }
        }
    }

    #[test]
    fn what_is_shorter_or_better_rounded_as_it_is_written_is_no_fraction() {
        let [x, y] = crate::symbols(["x", "y"]);
        assert_eq!(Fraction::record((x - Sym::ONE).powi(20), x), None);
        assert_eq!(Fraction::record(x.sqrt(), x), None);
        assert_eq!(Fraction::record(x / y, x), None);
        assert_eq!(Fraction::record(x * Sym::lift(1e300) * Sym::lift(1e300), x), None);
    }

    #[test]
    fn a_polynomial_is_divided_by_nothing() {
        let x = Sym::symbol("x");
        let fraction = Fraction::record(x * x - Sym::lift(0.5) * x, x).expect("no longer than as it is written");
        assert_eq!(fraction.flops(), 4);
        assert_eq!(fraction.over::<f64>().value(3.0), 7.5);
        assert_eq!(fraction.over::<f64>().moving(&[3.0])[0].slope, 5.5);
    }
}
