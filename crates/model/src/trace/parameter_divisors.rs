//! Divisors that depend on parameters only.

use super::Trace;
use crate::ScalarId;
use crate::arena::{Part, Scalar};
use symbolic::Sym;

impl Trace<'_> {
    /// Returns the divisors in the expressions of the model that depend on parameters only, such as 2 C in q^2/(2 C).
    pub fn parameter_divisors(&self) -> Vec<Sym> {
        let parts = self.model.arena.parts.iter();
        let divisors = parts.filter_map(|part| match part {
            Part::Scalar(Scalar::Quotient(_, ScalarId(divisor))) => Some(self.scalar(ScalarId(*divisor))),
            _ => None,
        });
        divisors.filter(|divisor| self.is_of_parameters(*divisor)).collect()
    }

    fn is_of_parameters(&self, value: Sym) -> bool {
        let symbols = value.symbols_of();
        !symbols.is_empty() && symbols.iter().all(|symbol| self.parameters.contains(symbol) || *symbol == self.pi)
    }
}
