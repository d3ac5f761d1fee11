//! Polynomials in one unknown with rational coefficients, as far as a refutation needs them.

use field::Rational;
use num_traits::Zero;
use symbolic::{Sym, coefficients};

/// Coefficients from the constant upwards; the last is not zero.
pub(crate) struct Univariate(Vec<Rational>);

impl Univariate {
    /// `None` where the expression is no polynomial in the unknown with rational coefficients.
    pub fn of(expression: Sym, unknown: Sym) -> Option<Self> {
        let mut dense = Vec::new();
        for (exponents, coefficient) in coefficients(expression, &[unknown]).ok()? {
            let place = *exponents.first()? as usize;
            dense.resize(dense.len().max(place + 1), Rational::zero());
            dense[place] = coefficient.as_constant()?;
        }
        Some(Univariate(dense).trimmed())
    }

    /// The greatest common divisor, by Euclid; zero where all are zero.
    pub fn common_divisor(all: Vec<Self>) -> Self {
        all.into_iter().fold(Univariate(Vec::new()), |mut a, mut b| {
            while !b.0.is_empty() {
                let rest = a.remainder(&b);
                (a, b) = (b, rest);
            }
            a
        })
    }

    /// Whether every root, real or not, is zero: a single power of the unknown.
    pub fn has_no_root_but_zero(&self) -> bool {
        self.0.iter().filter(|c| !c.is_zero()).count() == 1
    }

    fn trimmed(mut self) -> Self {
        while self.0.last().is_some_and(|c| c.is_zero()) {
            self.0.pop();
        }
        self
    }

    fn remainder(self, divisor: &Self) -> Self {
        let mut rest = self;
        while let (Some(&lead), Some(&by)) = (rest.0.last(), divisor.0.last())
            && rest.0.len() >= divisor.0.len()
        {
            let shift = rest.0.len() - divisor.0.len();
            for (i, &c) in divisor.0.iter().enumerate() {
                rest.0[shift + i] -= c * (lead / by);
            }
            rest.0.pop();
            rest = rest.trimmed();
        }
        rest
    }
}
