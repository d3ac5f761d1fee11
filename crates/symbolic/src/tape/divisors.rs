//! Singularities of a program: zeros of its divisors and radicands, and the discontinuities of its angles.

use super::{Operation, Register, Tape};
use field::Elementary;

impl Tape {
    /// Returns a program whose outputs are the distinct divisors, then the radicands, then the angles atan2(y, x), and the number of each. Returns `None`
    /// if there are none, except constant divisors.
    pub fn singular_places(&self) -> Option<(Tape, [usize; 3])> {
        let mut lists: [Vec<Register>; 3] = [const { Vec::new() }; 3];
        let mut result = (self.inputs + self.constants.len()) as Register;
        for operation in &self.operations {
            let found = match *operation {
                Operation::Quotient(_, divisor) => Some((0, divisor)),
                Operation::Root(radicand) => Some((1, radicand)),
                Operation::Elementary(Elementary::Atan2, ..) => Some((2, result)),
                _ => None,
            };
            result += operation.results() as Register;
            if let Some((list, register)) = found
                && !lists[list].contains(&register)
            {
                lists[list].push(register);
            }
        }
        let counts = lists.each_ref().map(Vec::len);
        let needed = Tape { outputs: lists.concat(), ..self.clone() };
        (!needed.outputs.is_empty()).then(|| (needed.by_factors(), counts))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Tape;
    use crate::Sym;
    use field::{Analytic, Elementary, Scalar};

    #[test]
    fn each_divisor_radicand_and_angle_is_computed_once_and_nothing_beside() {
        let [a, b, c] = ["a", "b", "c"].map(Sym::symbol);
        let outputs = [
            a / (b - c),
            c / (b - c),
            a * c * c / Sym::int(3),
            a / b,
            (a + c).sqrt(),
            b * (a + c).sqrt(),
            b.elementary(Elementary::Atan2, c) * a,
        ];
        let tape = Tape::record(&[a, b, c], &outputs).expect("it has values");
        let (watched, counts) = tape.singular_places().expect("it divides");
        assert_eq!((counts, watched.operations()), ([2, 1, 1], 3));
        let mut values = [0.0; 4];
        watched.over::<f64>().evaluate(&[1.0, 5.0, 3.0], &mut values);
        values[..2].sort_by(f64::total_cmp);
        assert_eq!(values, [2.0, 5.0, 4.0, 5.0_f64.atan2(3.0)]);
        assert_eq!(Tape::record(&[a], &[a / Sym::int(2)]).expect("it has values").singular_places(), None);
    }
}
