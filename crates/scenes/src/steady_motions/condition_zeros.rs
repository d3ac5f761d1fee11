//! Tests whether expressions vanish wherever a condition is zero, for conditions that are linear in no letter, such as sin(x) in abs(sin(x)).
//!
//! The zeros of the condition on lines in the direction of one letter are found by bisection, and the expressions are evaluated there. Expressions
//! that are zero up to rounding at all these points are identified as zero, which is not a proof.

use crate::spread_values::spread;
use symbolic::{Sym, Tape};

/// Number of points through which lines are laid for each letter.
const POINTS: u32 = 16;

/// Number of intervals of a line; in each, one change of sign is found.
const PARTS: u32 = 48;

/// Number of zeros after which the test of a letter ends.
const ENOUGH: usize = 24;

/// With fewer zeros the test fails.
const LEAST: usize = 3;

/// Largest number of bisections.
const HALVINGS: usize = 200;

/// A value below this multiple of the values nearby counts as zero.
const ROUNDING: f64 = 1e-9;

/// Whether all expressions vanish where `condition` is zero, tested along each letter of the condition; with `with_slopes` also their derivatives
/// by this letter. `others` are the letters of other conditions (1 where they hold, otherwise 0) with their values.
pub(super) fn vanish_there(all: &[Sym], condition: Sym, others: &[(Sym, Sym)], with_slopes: bool) -> bool {
    let mut zeros = 0;
    for letter in condition.symbols_of() {
        let slopes = all.iter().map(|own| own.diff(letter)).filter(|_| with_slopes);
        let own: Vec<Sym> = all.iter().copied().chain(slopes).collect();
        match Lines::of(&own, (condition, letter), others).and_then(|mut lines| lines.zeros()) {
            Some(found) => zeros += found,
            None => return false,
        }
    }
    zeros >= LEAST
}

/// Lines in the direction of one letter, on which a condition and expressions are evaluated.
struct Lines {
    inputs: Vec<Sym>,
    along: usize,
    /// The condition, then the other conditions, as functions of all inputs.
    conditions: Tape,
    /// The indices among the inputs of the letters of the other conditions.
    cases: Vec<usize>,
    expressions: Tape,
}

impl Lines {
    fn of(all: &[Sym], (condition, letter): (Sym, Sym), others: &[(Sym, Sym)]) -> Option<Self> {
        let values: Vec<Sym> = [condition].into_iter().chain(others.iter().map(|(_, value)| *value)).collect();
        let mut inputs: Vec<Sym> = Vec::new();
        for own in all.iter().chain(&values).flat_map(|own| own.symbols_of()).chain(others.iter().map(|(own, _)| *own))
        {
            if !inputs.contains(&own) {
                inputs.push(own);
            }
        }
        let place = |letter: Sym| inputs.iter().position(|own| *own == letter);
        Some(Lines {
            along: place(letter)?,
            cases: others.iter().filter_map(|(own, _)| place(*own)).collect(),
            conditions: Tape::record(&inputs, &values).ok()?,
            expressions: Tape::record(&inputs, all).ok()?,
            inputs,
        })
    }

    /// The number of zeros found, at all of which the expressions vanish; `None` if one does not.
    fn zeros(&mut self) -> Option<usize> {
        let mut found = 0;
        for point in 1..=POINTS {
            let base: Vec<f64> = self.inputs.iter().map(|own| spread(&own.to_string(), point)).collect();
            let reach = 4.0 * (1.0 + base[self.along].abs());
            let place = |part: u32| base[self.along] + reach * (2.0 * f64::from(part) / f64::from(PARTS) - 1.0);
            for part in 0..PARTS {
                let ends = [place(part), place(part + 1)];
                let Some(zero) = self.zero_between(&base, ends) else { continue };
                if !self.vanish_at(&base, zero, ends) {
                    return None;
                }
                found += 1;
                if found >= ENOUGH {
                    return Some(found);
                }
            }
        }
        Some(found)
    }

    fn condition(&self, base: &[f64], at: f64) -> f64 {
        let mut inputs = base.to_vec();
        inputs[self.along] = at;
        let mut values = vec![f64::NAN; self.conditions.outputs()];
        self.conditions.over::<f64>().evaluate(&inputs, &mut values);
        values[0]
    }

    /// The zero between two points at which the condition has different signs; `None` if the signs agree, or at a pole.
    fn zero_between(&self, base: &[f64], [mut low, mut high]: [f64; 2]) -> Option<f64> {
        let ends = [low, high].map(|at| self.condition(base, at));
        let changes_sign = ends[0] * ends[1] < 0.0;
        if !changes_sign {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if self.condition(base, middle) * ends[0] > 0.0 { low = middle } else { high = middle }
        }
        let size = ends[0].abs().max(ends[1].abs());
        [low, high].into_iter().find(|at| self.condition(base, *at).abs() <= ROUNDING * size)
    }

    /// Whether every expression at a zero is small compared with its values nearby.
    fn vanish_at(&self, base: &[f64], zero: f64, ends: [f64; 2]) -> bool {
        let mut program = self.expressions.over::<f64>();
        let mut values = |at: f64| {
            let mut inputs = base.to_vec();
            inputs[self.along] = at;
            let mut conditions = vec![f64::NAN; self.conditions.outputs()];
            // values of conditions contain no letters of other conditions
            self.conditions.over::<f64>().evaluate(&inputs, &mut conditions);
            for (&case, value) in self.cases.iter().zip(&conditions[1..]) {
                inputs[case] = if *value > 0.0 { 1.0 } else { 0.0 };
            }
            let mut all = vec![f64::NAN; self.expressions.outputs()];
            program.evaluate(&inputs, &mut all);
            all
        };
        let (there, nearby) = (values(zero), ends.map(&mut values));
        there.iter().enumerate().all(|(k, value)| {
            let scale = nearby.iter().map(|own| own[k].abs()).fold(value.abs(), f64::max);
            scale == 0.0 || value.abs() <= ROUNDING * scale
        })
    }
}

#[cfg(test)]
mod tests {
    use super::vanish_there;
    use field::Analytic;
    use symbolic::{Sym, symbols};

    #[test]
    fn a_jump_vanishes_with_its_condition_and_a_constant_one_does_not() {
        let [x, y, k] = symbols(["x", "y", "k"]);
        let sine = x.circle().sin;
        assert!(vanish_there(&[k * sine], sine, &[], false));
        assert!(!vanish_there(&[k * sine], sine, &[], true));
        assert!(vanish_there(&[k * sine * sine], sine, &[], true));
        assert!(!vanish_there(&[k * sine, k], sine, &[], false));
        assert!(!vanish_there(&[k * (sine - Sym::ONE)], sine, &[], false));
        let circle = x * x + y * y - Sym::ONE;
        assert!(vanish_there(&[circle * k * x], circle, &[], false));
        assert!(!vanish_there(&[x * x - y], circle, &[], false));
        // the condition has no zero
        assert!(!vanish_there(&[Sym::ZERO], x * x + Sym::ONE, &[], false));
    }
}
