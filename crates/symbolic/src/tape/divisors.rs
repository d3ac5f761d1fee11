//! Places at which a program may have no value, or jump: zeros of its divisors and of its radicands.

use super::{Operation, Register, Tape};

impl Tape {
    /// The program of its divisors, each once, then of what it takes roots of, with the number of the divisors; none where it divides by
    /// constants only and has no roots.
    pub fn divisors_and_radicands(&self) -> Option<(Tape, usize)> {
        let mut lists: [Vec<Register>; 2] = [Vec::new(), Vec::new()];
        for operation in &self.operations {
            let (list, register) = match *operation {
                Operation::Quotient(_, divisor) => (0, divisor),
                Operation::Root(radicand) => (1, radicand),
                _ => continue,
            };
            if !lists[list].contains(&register) {
                lists[list].push(register);
            }
        }
        let divisors = lists[0].len();
        let needed = Tape { outputs: lists.concat(), ..self.clone() };
        (!needed.outputs.is_empty()).then(|| (needed.by_factors(), divisors))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Tape;
    use crate::Sym;
    use field::{Analytic, Scalar};

    #[test]
    fn each_divisor_and_each_radicand_is_computed_once_and_nothing_beside() {
        let [a, b, c] = ["a", "b", "c"].map(Sym::symbol);
        let outputs = [a / (b - c), c / (b - c), a * c * c / Sym::int(3), a / b, (a + c).sqrt(), b * (a + c).sqrt()];
        let tape = Tape::record(&[a, b, c], &outputs).expect("it has values");
        let (watched, divisors) = tape.divisors_and_radicands().expect("it divides");
        assert_eq!((watched.outputs(), divisors, watched.operations()), (3, 2, 2));
        let mut values = [0.0; 3];
        watched.over::<f64>().evaluate(&[1.0, 5.0, 3.0], &mut values);
        values[..2].sort_by(f64::total_cmp);
        assert_eq!(values, [2.0, 5.0, 4.0]);
        assert_eq!(Tape::record(&[a], &[a / Sym::int(2)]).expect("it has values").divisors_and_radicands(), None);
    }
}
