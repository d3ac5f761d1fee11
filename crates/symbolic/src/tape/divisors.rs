//! What a program divides by.

use super::{Operation, Register, Tape};

impl Tape {
    /// The program of its divisors alone, each once; none where it divides by constants only.
    pub fn divisors(&self) -> Option<Tape> {
        let mut outputs: Vec<Register> = Vec::new();
        for operation in &self.operations {
            if let Operation::Quotient(_, divisor) = *operation
                && !outputs.contains(&divisor)
            {
                outputs.push(divisor);
            }
        }
        let needed = Tape { outputs, ..self.clone() };
        (!needed.outputs.is_empty()).then(|| needed.by_factors())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Tape;
    use crate::Sym;
    use field::Scalar;

    #[test]
    fn each_divisor_is_computed_once_and_nothing_beside() {
        let [a, b, c] = ["a", "b", "c"].map(Sym::symbol);
        let outputs = [a / (b - c), c / (b - c), a * c * c / Sym::int(3), a / b];
        let tape = Tape::record(&[a, b, c], &outputs).expect("it has values");
        let divisors = tape.divisors().expect("it divides");
        assert_eq!((divisors.outputs(), divisors.operations()), (2, 1));
        let mut values = [0.0; 2];
        divisors.over::<f64>().evaluate(&[1.0, 5.0, 3.0], &mut values);
        values.sort_by(f64::total_cmp);
        assert_eq!(values, [2.0, 5.0]);
        assert_eq!(Tape::record(&[a], &[a / Sym::int(2)]).expect("it has values").divisors(), None);
    }
}
