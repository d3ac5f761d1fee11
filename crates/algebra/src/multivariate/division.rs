//! Exact division of polynomials.

use super::modular::Image;
use super::{Budget, Coefficient, Limit, Monomial, Poly, monomial};
use std::collections::BinaryHeap;

/// The number of pairs of terms from which on a modular image first tests whether the division can be exact.
const ASK_IMAGE: usize = 200;

impl<C: Coefficient, const W: usize> Poly<C, W> {
    /// self / divisor; `None` where the division leaves a remainder.
    ///
    /// # Errors
    /// [`Limit`] where a limit of the computation is exceeded.
    pub fn exact_quotient(&self, divisor: &Self, budget: &Budget) -> Result<Option<Self>, Limit> {
        match (self.terms.as_slice(), divisor.terms.as_slice()) {
            ([], _) => return Ok(Some(Self::zero())),
            (_, []) => return Ok(None),
            (_, [(m, c)]) => return Ok(self.over_monomial(m).and_then(|quotient| quotient.over_constant(c))),
            ([.., last], [.., divisor_last]) if monomial::quotient(&last.0, &divisor_last.0).is_none() => {
                return Ok(None);
            }
            _ => {}
        }
        if monomial::quotient(&self.degrees(), &divisor.degrees()).is_none() {
            return Ok(None);
        }
        if self.len() * divisor.len() >= ASK_IMAGE && !self.image_allows(divisor) {
            return Ok(None);
        }
        self.long_division(divisor, budget)
    }

    /// Whether the modular image of the divisor divides that of `self`, in the divisor's generator of lowest degree.
    fn image_allows(&self, divisor: &Self) -> bool {
        let degrees = divisor.degrees();
        let Some((generator, _)) = monomial::support(&degrees).min_by_key(|&(_, degree)| degree) else {
            return true;
        };
        let image = Image::of(divisor, generator);
        image.degree().is_none() || Image::of(self, generator).remainder(&image).degree().is_none()
    }

    /// Long division by descending terms. A heap has, for every term of the divisor but the first, its product with the
    /// next term of the quotient that is not yet subtracted.
    fn long_division(&self, divisor: &Self, budget: &Budget) -> Result<Option<Self>, Limit> {
        let (lead, lead_coefficient) = &divisor.terms[0];
        let rest = &divisor.terms[1..];
        let mut quotient: Vec<(Monomial<W>, C)> = Vec::new();
        let mut next: Vec<usize> = vec![0; rest.len()];
        let mut heap: BinaryHeap<(Monomial<W>, usize)> = BinaryHeap::new();
        let mut dividend = self.terms.iter().peekable();
        loop {
            let monomial = match (dividend.peek(), heap.peek()) {
                (None, None) => break,
                (Some(term), None) => term.0,
                (None, Some(product)) => product.0,
                (Some(term), Some(product)) => term.0.max(product.0),
            };
            let mut coefficient = match dividend.next_if(|term| term.0 == monomial) {
                Some(term) => term.1.clone(),
                None => C::of(0),
            };
            while let Some(&(top, row)) = heap.peek() {
                if top != monomial {
                    break;
                }
                heap.pop();
                budget.spend(1)?;
                let product = rest[row].1.times(&quotient[next[row]].1)?;
                coefficient = coefficient.plus(&product.negated())?;
                next[row] += 1;
                if let Some(following) = quotient.get(next[row]) {
                    heap.push((monomial::product(&rest[row].0, &following.0)?, row));
                }
            }
            if coefficient.is_zero() {
                continue;
            }
            let (Some(m), Some(c)) =
                (monomial::quotient(&monomial, lead), coefficient.exact_quotient(lead_coefficient))
            else {
                return Ok(None);
            };
            for (row, term) in rest.iter().enumerate() {
                if next[row] == quotient.len() {
                    heap.push((monomial::product(&term.0, &m)?, row));
                }
            }
            quotient.push((m, c));
        }
        Ok(Some(Poly { terms: quotient }))
    }
}
