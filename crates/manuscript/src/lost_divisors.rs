//! Divisors that hypotheses hide.
//!
//! Constraints and equations of motion give values such as x' = N/D. An expression without D holds on all motions if the motions with D ≠ 0 are dense.
//! Hypotheses restrict the motions; they may make N zero, so that the divisor D disappears, or make D itself zero. Example: a bead on the circle
//! x² + y² = R² has x' = -y y'/x; with y' = 0 it is at rest, except possibly at x = 0.

use crate::inertia::inertia_determinant;
use crate::motion::Motion;
use crate::natural_domain::written_divisors;
use symbolic::{Hypotheses, Identity, Sym, decide, identified, normal, substitute_all};

/// The requirements of a proof in addition to its own divisors.
pub(crate) enum Lost {
    /// These divisors must not vanish.
    Divisors(Vec<Sym>),
    /// A divisor vanishes under the hypotheses, for this reason.
    Zero(String),
}

impl Motion<'_, '_> {
    /// The hidden divisors of the values in an expression.
    pub fn lost_divisors(&self, expression: Sym) -> Lost {
        let Some(given) = self.before_hypotheses else { return Lost::Divisors(Vec::new()) };
        if self.divisors.iter().any(|&divisor| self.is_zero(divisor)) {
            return Lost::Zero("a divisor of the hypotheses is zero where all of them hold".to_owned());
        }
        let (mut now, mut lost) = (expression, Vec::new());
        let mut by_equations = false;
        for (place, round) in self.rounds.iter().enumerate().take(given) {
            let symbols = now.symbols_of();
            let later =
                |of: Sym| self.rounds[place + 1..].iter().fold(of, |of, round| substitute_all(&[of], &round.values)[0]);
            for (_, value) in round.values.iter().filter(|(symbol, _)| symbols.contains(symbol)) {
                by_equations |= round.by.is_none();
                // without a normal form, the written divisors of a long value are used
                let written = |of: Sym| written_divisors(of).into_iter().fold(Sym::ONE, |product, one| product * one);
                let below =
                    |of: Sym| normal(of, &Hypotheses::none()).map_or_else(|_| written(of), |form| form.denominator());
                let divisor = later(below(*value));
                if divisor.as_constant().is_some_and(|value| value.sign() != Some(0)) {
                    continue;
                }
                if self.is_zero(divisor) {
                    let why = "constraints or equations of motion, solved for what the formula has, divide by zero where the hypotheses hold";
                    return Lost::Zero(why.to_owned());
                }
                let is_kept = below(below(later(*value)) / divisor).as_constant().is_some();
                if !is_kept && !lost.contains(&divisor) {
                    lost.push(divisor);
                }
            }
            now = substitute_all(&[now], &round.values)[0];
        }
        if by_equations && self.has_no_inertia() {
            return Lost::Zero(
                "where the hypotheses hold, the equations of motion determine no acceleration along some direction"
                    .to_owned(),
            );
        }
        Lost::Divisors(lost)
    }

    /// Whether the determinant of the equations for accelerations vanishes under the hypotheses.
    fn has_no_inertia(&self) -> bool {
        inertia_determinant(self.trace).is_some_and(|determinant| {
            let reduced = self.reduced(determinant);
            reduced != determinant && self.is_zero(determinant)
        })
    }

    fn is_zero(&self, expression: Sym) -> bool {
        let reduced = self.reduced(expression);
        match identified(&[reduced]) {
            Identity::Identified { .. } => true,
            Identity::NotZero if self.hypotheses.statements().is_empty() => false,
            _ => decide(reduced, &self.hypotheses).is_zero(),
        }
    }
}
