//! Constant factors: divisions by constants become multiplications, and signs are moved into constant factors.

use super::{Operation, Register, Tape};
use field::Rational;
use num_traits::One;

/// An operation, or its replacement.
#[derive(Clone, Copy)]
enum Step {
    AsItWas(Operation),
    /// A product with a constant, which may be new.
    Multiple(Rational, Register),
}

impl Step {
    fn results(self) -> usize {
        match self {
            Step::AsItWas(operation) => operation.results(),
            Step::Multiple(..) => 1,
        }
    }

    fn reads(self, read: impl FnMut(Register)) {
        match self {
            Step::AsItWas(operation) => operation.reads().for_each(read),
            Step::Multiple(_, of) => std::iter::once(of).for_each(read),
        }
    }
}

impl Tape {
    /// Replaces divisions by a constant by products with its reciprocal. The negative of a product with a constant, and a product of a constant with
    /// a negative, become products with the negative constant.
    pub(super) fn by_factors(&self) -> Tape {
        let readings = self.readings();
        let value = |register: Register| self.constants[register as usize - self.inputs];
        // for each register: the product with a constant that it is, and the register whose negative it is
        let mut factors: Vec<Option<(Rational, Register)>> = vec![None; self.registers];
        let mut negatives: Vec<Option<Register>> = vec![None; self.registers];
        let mut next = self.inputs + self.constants.len();
        let mut steps: Vec<(usize, Step)> = Vec::with_capacity(self.operations.len());
        for &operation in &self.operations {
            let factor = match operation {
                Operation::Part(a, divisor) => Some((Rational::one() / value(divisor), a)),
                Operation::Multiple(constant, a) => Some((value(constant), a)),
                Operation::Negation(a) if readings[a as usize] == 1 => {
                    factors[a as usize].map(|(constant, of)| (-constant, of))
                }
                _ => None,
            };
            let factor = factor.map(|(constant, of)| match negatives[of as usize] {
                Some(positive) => (-constant, positive),
                None => (constant, of),
            });
            if let Operation::Negation(a) = operation {
                negatives[next] = Some(a);
            }
            factors[next] = factor;
            steps.push((next, factor.map_or(Step::AsItWas(operation), |(constant, of)| Step::Multiple(constant, of))));
            next += operation.results();
        }
        self.of_steps(steps)
    }

    /// Removes steps and constants that no output needs, and adds new constants.
    fn of_steps(&self, mut steps: Vec<(usize, Step)>) -> Tape {
        let first = self.inputs + self.constants.len();
        let mut needed = vec![false; self.registers];
        self.outputs.iter().for_each(|output| needed[*output as usize] = true);
        for (register, step) in steps.iter().rev() {
            if needed[*register..register + step.results()].contains(&true) {
                step.reads(|read| needed[read as usize] = true);
            }
        }
        steps.retain(|(register, step)| needed[*register..register + step.results()].contains(&true));
        let was = (0..self.constants.len()).filter(|place| needed[self.inputs + place]);
        let mut constants: Vec<Rational> = was.map(|place| self.constants[place]).collect();
        for (_, step) in &steps {
            if let Step::Multiple(constant, _) = step
                && !constants.contains(constant)
            {
                constants.push(*constant);
            }
        }
        let place = |constant: Rational| constants.iter().position(|known| *known == constant).unwrap_or(0);
        let moved = |register: Register| match (register as usize).checked_sub(self.inputs) {
            None => register,
            Some(constant) if constant < self.constants.len() => {
                (self.inputs + place(self.constants[constant])) as Register
            }
            Some(_) => (register as usize - first + self.inputs + constants.len()) as Register,
        };
        let operation = |step: &Step| match *step {
            Step::AsItWas(operation) => operation.through(moved),
            Step::Multiple(constant, of) => Operation::Multiple((self.inputs + place(constant)) as Register, moved(of)),
        };
        let operations: Vec<(usize, Operation)> =
            steps.iter().map(|(register, step)| (moved(*register as Register) as usize, operation(step))).collect();
        let whole = Tape {
            inputs: self.inputs,
            rounded: constants.iter().map(|value| crate::evaluate::constant(*value)).collect(),
            operations: Vec::new(),
            outputs: self.outputs.iter().map(|output| moved(*output)).collect(),
            registers: self.registers - self.constants.len() + constants.len(),
            once: self.once,
            constants: constants.clone(),
        };
        whole.renumbered(&operations)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Operation, Tape};
    use crate::Sym;
    use field::Scalar;

    #[test]
    fn signs_become_those_of_factors() {
        let [a, b] = ["a", "b"].map(Sym::symbol);
        let three = Sym::int(3);
        let outputs = [-(a * three) + b, three * -a, -(a / Sym::int(8)), -a / Sym::int(8), -a];
        let tape = Tape::record(&[a, b], &outputs).expect("it has values").by_factors();
        let negations = tape.steps().iter().filter(|step| matches!(step, Operation::Negation(_)));
        assert_eq!(negations.count(), 1, "one output is the negative itself");
        let mut values = [0.0; 5];
        tape.over::<f64>().evaluate(&[5.0, 7.0], &mut values);
        assert_eq!(values, [-8.0, -15.0, -0.625, -0.625, -5.0]);
    }
}
