//! Interval constraint propagation through a tape, forwards and backwards: narrows a box to the part that may contain zeros of all outputs (HC4; Benhamou et al. 1999).

use super::{Operation, Tape};
use field::{Analytic, Circle, Elementary, Interval, Scalar};
use std::f64::consts::PI;

/// A tape over intervals, with its registers.
#[derive(Debug)]
pub struct Propagation<'a> {
    tape: &'a Tape,
    constants: Vec<Interval>,
    registers: Vec<Interval>,
    /// For each register that is a negation, the register of its operand.
    negated: Vec<Option<usize>>,
    /// Whether a range became substantially narrower in this pass.
    narrows: bool,
}

/// The largest number of passes over a box, each forwards and backwards.
const PASSES: usize = 6;

/// Another pass follows if a range became narrower than this part of itself.
const WORTH: f64 = 0.7;

impl<'a> Propagation<'a> {
    pub fn of(tape: &'a Tape) -> Self {
        let constants = tape.constants();
        let mut negated = vec![None; tape.registers];
        let mut next = tape.inputs + constants.len();
        for &operation in &tape.operations {
            if let Operation::Negation(operand) = operation {
                negated[next] = Some(operand as usize);
            }
            next += operation.results();
        }
        Propagation { tape, constants, registers: vec![Interval::EVERYTHING; tape.registers], negated, narrows: false }
    }

    /// Narrows a box of inputs to the part that may contain common zeros of the outputs. Returns false if it contains none.
    ///
    /// The ranges of intermediate results persist while the box is narrowed. A range such as that of the difference of two inputs is
    /// information that no box of inputs contains.
    pub fn narrow(&mut self, inputs: &mut [Interval]) -> bool {
        let Tape { inputs: given, operations, outputs, .. } = self.tape;
        self.registers.fill(Interval::EVERYTHING);
        self.registers[..*given].copy_from_slice(&inputs[..*given]);
        let first = given + self.constants.len();
        self.registers[*given..first].copy_from_slice(&self.constants);
        for _ in 0..PASSES {
            let mut next = first;
            for &operation in operations {
                if !self.forwards(operation, next) {
                    return false;
                }
                next += operation.results();
            }
            let zero = Interval::point(0.0);
            if !outputs.iter().all(|&output| self.meet(output as usize, zero)) {
                return false;
            }
            self.narrows = false;
            for &operation in operations.iter().rev() {
                next -= operation.results();
                if !self.backwards(operation, next) {
                    return false;
                }
            }
            if !self.narrows {
                break;
            }
        }
        inputs[..*given].copy_from_slice(&self.registers[..*given]);
        true
    }

    fn forwards(&mut self, operation: Operation, result: usize) -> bool {
        let value = |register: u32| self.registers[register as usize];
        let found = match operation {
            Operation::Product(a, b) if a == b => value(a).squared(),
            // roots and logarithms are restricted to their domain, since no zeros exist outside
            Operation::Root(a) => match value(a).and(not_negative()) {
                Some(part) => part.sqrt(),
                None => return false,
            },
            Operation::Elementary(Elementary::Ln, a, _) => match value(a).and(not_negative()) {
                Some(part) if part.high() > 0.0 => logarithm(part),
                _ => return false,
            },
            Operation::Elementary(function, a, b) => value(a).elementary(function, value(b)),
            Operation::Circle(a) => {
                let Circle { cos, sin } = value(a).circle();
                return self.meet(result, cos) && self.meet(result + 1, sin);
            }
            other => other.of_field(value).unwrap_or(Interval::EVERYTHING),
        };
        self.meet(result, found)
    }

    /// Intersects the range of a register with another range; false if the intersection is empty.
    fn meet(&mut self, register: usize, range: Interval) -> bool {
        self.meet_any(register, [Some(range), None])
    }

    /// Intersects the range of a register with the union of two ranges, and stores the hull; false if both intersections are empty.
    fn meet_any(&mut self, register: usize, ranges: [Option<Interval>; 2]) -> bool {
        let own = self.registers[register];
        let [one, other] = ranges.map(|range| range.and_then(|range| own.and(range)));
        let left = match (one, other) {
            (Some(one), Some(other)) => one.hull(other),
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => return false,
        };
        let ends = |of: Interval| usize::from(of.low().is_finite()) + usize::from(of.high().is_finite());
        self.narrows |= left.width() < WORTH * own.width() || ends(left) > ends(own);
        self.registers[register] = left;
        true
    }

    /// Narrows the operands by the result and the other operands.
    fn backwards(&mut self, operation: Operation, result: usize) -> bool {
        let [a, b, _] = operation.operands().map(|register| register as usize);
        let [x, y, r] = [self.registers[a], self.registers[b], self.registers[result]];
        match operation {
            // equal operands need formulas of their own, a + a = r and a - (-a) = r, which derivatives of squares contain
            Operation::Sum(..) if a == b => self.meet(a, r / Interval::point(2.0)),
            Operation::Difference(..) if self.negated[a] == Some(b) => self.meet(b, -r / Interval::point(2.0)),
            Operation::Sum(..) => self.meet(a, r - y) && self.meet(b, r - x),
            Operation::Difference(..) => self.meet(a, r + y) && self.meet(b, x - r),
            Operation::Product(..) if a == b => match r.and(not_negative()) {
                Some(square) => {
                    let root = square.sqrt();
                    self.meet_any(a, [Some(root), Some(-root)])
                }
                None => false,
            },
            Operation::Product(..) | Operation::Multiple(..) => {
                self.meet_any(a, r.factors(y)) && self.meet_any(b, r.factors(x))
            }
            Operation::Quotient(..) | Operation::Part(..) => self.meet(a, r * y) && self.meet(b, x / r),
            Operation::Negation(_) => self.meet(a, -r),
            Operation::Root(_) => match r.and(not_negative()) {
                Some(root) => self.meet(a, root.squared()),
                None => false,
            },
            Operation::Elementary(Elementary::Ln, ..) => {
                self.meet(a, r.elementary(Elementary::Exp, r).and(not_negative()).unwrap_or(not_negative()))
            }
            Operation::Elementary(Elementary::Exp, ..) => match r.and(not_negative()) {
                Some(power) if power.high() > 0.0 => self.meet(a, logarithm(power)),
                _ => false,
            },
            Operation::Circle(_) => {
                let point = Circle { cos: r, sin: self.registers[result + 1] };
                match angles(x, point) {
                    Some(left) => self.meet(a, left),
                    None => false,
                }
            }
            Operation::Elementary(..)
            | Operation::ProductAnd(..)
            | Operation::ProductLess(..)
            | Operation::LessProduct(..) => true,
        }
    }
}

/// Returns the domain of the square root.
fn not_negative() -> Interval {
    Interval::new(0.0, f64::INFINITY)
}

/// Returns the logarithm of the positive part of a range without negative numbers.
fn logarithm(range: Interval) -> Interval {
    let of = |end: f64| Interval::point(end).elementary(Elementary::Ln, Interval::point(1.0));
    let low = if range.low() > 0.0 { of(range.low()).low() } else { f64::NEG_INFINITY };
    Interval::new(low, if range.high().is_finite() { of(range.high()).high() } else { f64::INFINITY })
}

/// Wider angle ranges, in radians, are not narrowed.
const MOST_TURNS: f64 = 64.0;

/// Narrows a range of angles to those whose cosine and sine lie in the given ranges; `None` if there are none.
fn angles(range: Interval, Circle { cos, sin }: Circle<Interval>) -> Option<Interval> {
    if range.width() > MOST_TURNS {
        return Some(range);
    }
    let left = by_cosine(range, cos)?;
    let quarter = Interval::point(PI / 2.0) + Interval::new(-1e-15, 1e-15);
    by_cosine(left - quarter, sin).and_then(|turned| (turned + quarter).and(left))
}

/// Returns the smallest interval that contains all angles of a range whose cosine lies in `cosine`; `None` if there are none.
fn by_cosine(range: Interval, cosine: Interval) -> Option<Interval> {
    let within = cosine.and(Interval::new(-1.0, 1.0))?;
    // accounts for rounding errors of the arccosine and of multiples of 2 pi
    let slack = 1e-14 * (1.0 + range.size());
    let [near, far] = [within.high().acos() - slack, within.low().acos() + slack];
    let turns = |angle: f64| angle / (2.0 * PI);
    let (first, last) = ((turns(range.low()) - 1.0).floor() as i64, (turns(range.high()) + 1.0).ceil() as i64);
    let mut all: Option<Interval> = None;
    for turn in first..=last {
        let at = 2.0 * PI * turn as f64;
        for arc in [Interval::new(at + near, at + far), Interval::new(at - far, at - near)] {
            if let Some(part) = arc.and(range) {
                all = Some(all.map_or(part, |all| all.hull(part)));
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Sym, symbols};

    #[test]
    fn ranges_are_narrowed_to_where_zeros_may_be_and_never_beyond() {
        let [x, y, a] = symbols(["x", "y", "a"]);
        // x = 2 cos a, y = x^2 - 1, a in [-1, 1]
        let tape =
            Tape::record(&[x, y, a], &[x - Sym::int(2) * a.circle().cos, y - x * x + Sym::ONE]).expect("it has values");
        let mut propagation = Propagation::of(&tape);
        let mut at = [Interval::new(-9.0, 9.0), Interval::new(-9.0, 9.0), Interval::new(-1.0, 1.0)];
        assert!(propagation.narrow(&mut at) && propagation.narrow(&mut at));
        assert!(
            at[0].low() > 1.08 && at[0].high() < 2.000_001 && at[1].low() > 0.16 && at[1].high() < 3.000_001,
            "{at:?}"
        );
        for step in 0..=20 {
            let angle = -1.0 + 0.1 * f64::from(step);
            let x = 2.0 * angle.cos();
            assert!(at[0].contains(x) && at[1].contains(x * x - 1.0) && at[2].contains(angle));
        }
        // propagates from the result to the angle
        let mut at = [Interval::new(1.9, 2.5), Interval::new(-9.0, 9.0), Interval::new(-3.0, 3.0)];
        assert!(propagation.narrow(&mut at));
        assert!(at[2].size() < 0.32 && at[2].contains(0.31), "{at:?}");
        let mut none = [Interval::new(2.1, 2.5), Interval::new(-9.0, 9.0), Interval::new(-3.0, 3.0)];
        assert!(!propagation.narrow(&mut none));
    }

    #[test]
    fn where_a_root_or_a_logarithm_has_no_value_there_is_no_zero() {
        let [x] = symbols(["x"]);
        let root = Tape::record(&[x], &[Sym::ONE - x.sqrt()]).expect("it has values");
        let logarithm = Tape::record(&[x], &[x.elementary(Elementary::Ln, x) + Sym::ONE]).expect("it has values");
        let third = (x.elementary(Elementary::Ln, x) / Sym::int(3)).elementary(Elementary::Exp, x) - Sym::int(2);
        let power = Tape::record(&[x], &[third]).expect("it has values");
        for (tape, zero) in [(&root, 1.0), (&logarithm, (-1.0_f64).exp()), (&power, 8.0)] {
            let mut propagation = Propagation::of(tape);
            assert!(!propagation.narrow(&mut [Interval::new(-9.0, -1e-9)]));
            let mut at = [Interval::new(-9.0, 9.0)];
            assert!(propagation.narrow(&mut at) && at[0].contains(zero) && at[0].width() < 1e-9, "{at:?}");
        }
    }

    #[test]
    fn a_factor_of_known_sign_is_bounded_by_a_product_away_from_zero_whatever_the_other() {
        let [x, y] = symbols(["x", "y"]);
        // x y = 2, y in [-1, 1], x >= 0
        let tape = Tape::record(&[x, y], &[x * y - Sym::int(2)]).expect("it has values");
        let mut propagation = Propagation::of(&tape);
        let mut at = [Interval::new(0.0, f64::INFINITY), Interval::new(-1.0, 1.0)];
        assert!(propagation.narrow(&mut at));
        assert!(at[0].low() > 1.999_999 && at[0].low() <= 2.0 && at[0].high() == f64::INFINITY, "{at:?}");
        assert!(propagation.narrow(&mut at) && at[1].low() > -1e-9, "{at:?}");
        // 2 (x - y) = 0 and (x - y)^2 + x^2 = 4: the difference is known before x and y are
        let less = x - y;
        let tape = Tape::record(&[x, y], &[less + less, less * less + x * x - Sym::int(4)]).expect("it has values");
        let mut at = [Interval::new(0.1, 9.0), Interval::new(-9.0, 9.0)];
        assert!(Propagation::of(&tape).narrow(&mut at) && at[0].low() > 1.999_999, "{at:?}");
        // x^2 = 4, x >= -1
        let tape = Tape::record(&[x], &[x * x - Sym::int(4)]).expect("it has values");
        let mut at = [Interval::new(-1.0, 9.0)];
        assert!(Propagation::of(&tape).narrow(&mut at) && at[0].low() > 1.999_999, "{at:?}");
    }
}
