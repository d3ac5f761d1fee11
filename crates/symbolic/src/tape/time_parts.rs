//! Functions of the last input alone (usually the time) within a tape, and their ranges over intervals.

use super::{Operation, Register, Tape};
use field::{Analytic, Circle, Elementary, Interval, Scalar, Tangent};

/// The dependence of a register on the inputs.
#[derive(Clone, Copy, PartialEq)]
enum Dependence {
    Constant,
    /// A linear function of the last input.
    Line,
    /// A nonlinear function of the last input alone.
    Curve,
    Others,
}

impl Tape {
    /// Returns the nonlinear functions of the last input alone: terms of sums, coefficients of other inputs, and elementary functions and
    /// quotients inside these. Each is a tape with all inputs and one output.
    pub fn parts_of_last_input(&self) -> Vec<Tape> {
        let mut depends = vec![Dependence::Others; self.registers];
        if let Some(last) = self.inputs.checked_sub(1) {
            depends[last] = Dependence::Line;
        }
        let first = self.inputs + self.constants.len();
        depends[self.inputs..first].fill(Dependence::Constant);
        let mut wanted = vec![false; self.registers];
        let mut next = first;
        for &operation in &self.operations {
            let of = |register: Register| depends[register as usize];
            let found = dependence(operation, of);
            let is_term = found == Dependence::Others || !is_product(operation);
            for register in operation.reads().filter(|_| is_term) {
                wanted[register as usize] = true;
            }
            let is_own = matches!(operation, Operation::Elementary(..) | Operation::Quotient(..));
            for register in next..next + operation.results() {
                depends[register] = found;
                wanted[register] = is_own;
            }
            next += operation.results();
        }
        self.outputs.iter().for_each(|&output| wanted[output as usize] = true);
        let places = (first..next).filter(|&place| wanted[place] && depends[place] == Dependence::Curve);
        places.map(|place| Tape { outputs: vec![place as Register], ..self.clone() }.by_factors()).collect()
    }

    /// Returns an enclosure of the range of the first output over an interval of the last input; the output must not depend on other inputs. Each operation uses the
    /// narrower of two enclosures: its interval evaluation, and the mean value form about the midpoint.
    pub fn range_over_last_input(&self, over: Interval) -> Interval {
        let mut ranges = vec![Tangent::fixed(Interval::EVERYTHING); self.registers];
        let mut middles = vec![Interval::EVERYTHING; self.registers];
        if let Some(last) = self.inputs.checked_sub(1) {
            ranges[last] = Tangent::variable(over);
            middles[last] = Interval::point(over.middle());
        }
        for (place, value) in (self.inputs..).zip(self.constants::<Interval>()) {
            (ranges[place], middles[place]) = (Tangent::fixed(value), value);
        }
        let away = over - Interval::point(over.middle());
        let mut next = self.inputs + self.constants.len();
        for &operation in &self.operations {
            let made = over_tangents(operation, |register| ranges[register as usize]);
            let at_middle = over_values(operation, |register| middles[register as usize]);
            for (k, (found, middle)) in made.into_iter().zip(at_middle).take(operation.results()).enumerate() {
                let by_slope = middle + found.slope * away;
                let value = found.value.and(by_slope).unwrap_or(found.value);
                (ranges[next + k], middles[next + k]) = (Tangent::moving(value, found.slope), middle);
            }
            next += operation.results();
        }
        self.outputs.first().map_or(Interval::EVERYTHING, |&output| ranges[output as usize].value)
    }
}

/// Returns the dependence of a result from those of its operands.
fn dependence(operation: Operation, of: impl Fn(Register) -> Dependence) -> Dependence {
    use Dependence::{Constant, Curve, Line, Others};
    let all: Vec<Dependence> = operation.reads().map(of).collect();
    let is = |one: Dependence| all.contains(&one);
    let is_linear = match operation {
        Operation::Product(..) | Operation::Multiple(..) => all[0] == Constant || all[1] == Constant,
        Operation::ProductAnd(..) | Operation::ProductLess(..) | Operation::LessProduct(..) => {
            all[0] == Constant || all[1] == Constant
        }
        Operation::Quotient(..) | Operation::Part(..) => all[1] == Constant,
        Operation::Sum(..) | Operation::Difference(..) | Operation::Negation(_) => true,
        Operation::Root(_) | Operation::Circle(_) | Operation::Elementary(..) => false,
    };
    match () {
        () if is(Others) => Others,
        () if !is(Curve) && !is(Line) => Constant,
        () if is(Curve) || !is_linear => Curve,
        () => Line,
    }
}

/// Returns whether an operation passes a factor on to its result, so that only the whole term of a sum is examined.
fn is_product(operation: Operation) -> bool {
    match operation {
        Operation::Product(..)
        | Operation::Multiple(..)
        | Operation::Quotient(..)
        | Operation::Part(..)
        | Operation::Negation(_)
        | Operation::Root(_)
        | Operation::Circle(_)
        | Operation::Elementary(..) => true,
        Operation::Sum(..)
        | Operation::Difference(..)
        | Operation::ProductAnd(..)
        | Operation::ProductLess(..)
        | Operation::LessProduct(..) => false,
    }
}

/// Returns the results of an operation over intervals; only cosine with sine has a second result.
fn over_values(operation: Operation, of: impl Fn(Register) -> Interval) -> [Interval; 2] {
    let one = match operation {
        Operation::Product(a, b) if a == b => of(a).squared(),
        Operation::Root(a) => of(a).sqrt(),
        Operation::Elementary(function, a, b) => of(a).elementary(function, of(b)),
        Operation::Circle(a) => {
            let Circle { cos, sin } = of(a).circle();
            return [cos, sin];
        }
        other => other.of_field(of).unwrap_or(Interval::EVERYTHING),
    };
    [one, Interval::EVERYTHING]
}

/// Returns the results of an operation over intervals, with their derivatives.
fn over_tangents(operation: Operation, of: impl Fn(Register) -> Tangent<Interval>) -> [Tangent<Interval>; 2] {
    let [first, second] = over_values(operation, |register| of(register).value);
    let slope = match operation {
        Operation::Root(a) => of(a).slope / (Interval::int(2) * first),
        Operation::Circle(a) => {
            let slope = of(a).slope;
            return [Tangent::moving(first, -(second * slope)), Tangent::moving(second, first * slope)];
        }
        Operation::Elementary(function, a, b) => {
            let [by_a, by_b] = function.slopes(of(a).value, of(b).value, first);
            let own = by_a * of(a).slope;
            if function == Elementary::Atan2 { own + by_b * of(b).slope } else { own }
        }
        other => other.of_field(of).map_or(Interval::EVERYTHING, |tangent| tangent.slope),
    };
    [Tangent::moving(first, slope), Tangent::fixed(Interval::EVERYTHING)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Sym, symbols};

    #[test]
    fn the_terms_of_the_last_input_are_found_and_lines_are_none() {
        let [x, t] = symbols(["x", "t"]);
        let pulse = (-(t - Sym::int(4)) * (t - Sym::int(4)) * Sym::int(100)).elementary(Elementary::Exp, t);
        let parts = |outputs: &[Sym]| Tape::record(&[x, t], outputs).expect("it has values").parts_of_last_input();
        assert_eq!(parts(&[x * t + Sym::int(3) * t, x]).len(), 0);
        assert_eq!(parts(&[x * pulse]).len(), 1);
        // the cosine and the pulse are separate terms; their sum contains another input
        assert!(parts(&[t.circle().cos + pulse + x]).len() >= 2);
        assert!(parts(&[t.circle().cos * t + t * t * t + x]).len() >= 2);
    }

    #[test]
    fn ranges_hold_every_function_over_short_intervals() {
        let [x, t] = symbols(["x", "t"]);
        let turns = (Sym::int(3) * t).circle();
        let functions = [
            turns.cos,
            turns.sin,
            (t * t + Sym::ONE).sqrt(),
            (t - Sym::int(2)).elementary(Elementary::Tanh, t),
            (t + Sym::ONE).elementary(Elementary::Ln, t),
            t.elementary(Elementary::Atan2, t + Sym::ONE),
            t / (t * t + Sym::ONE),
        ];
        for function in functions {
            let tape = Tape::record(&[x, t], &[function]).expect("it has values");
            let mut program = tape.over::<f64>();
            for step in 0..200 {
                let low = 0.02 * f64::from(step);
                let range = tape.range_over_last_input(Interval::new(low, low + 0.02));
                assert!(range.width() < 0.1, "{function} {low} {range:?}");
                for part in 0..=4 {
                    let mut value = [0.0];
                    program.evaluate(&[0.0, low + 0.005 * f64::from(part)], &mut value);
                    assert!(range.low() - 1e-13 <= value[0] && value[0] <= range.high() + 1e-13, "{function} {low}");
                }
            }
        }
    }

    #[test]
    fn ranges_hold_all_values_and_powers_written_out_stay_narrow() {
        let [x, t] = symbols(["x", "t"]);
        // (t - 4)^2 expanded: its terms are much larger than the sum
        let square = t * t - Sym::int(8) * t + Sym::int(16);
        let pulse = (-square * Sym::int(10_000)).elementary(Elementary::Exp, t);
        let tape = Tape::record(&[x, t], &[pulse]).expect("it has values");
        for step in 0..200 {
            let low = 0.04 * f64::from(step);
            let over = Interval::new(low, low + 0.04);
            let range = tape.range_over_last_input(over);
            for part in 0..=8 {
                let at = low + 0.005 * f64::from(part);
                let value = (-1e4 * (at - 4.0) * (at - 4.0)).exp();
                assert!(range.low() <= value + 1e-9 && range.high() >= value - 1e-9, "{at} {value} {range:?}");
            }
            assert!((low - 4.0).abs() < 0.2 || range.high() < 1e-6, "{low} {range:?}");
        }
    }
}
