//! Fused multiply-add operations, which round once.

use super::{Operation, Register, Tape};

impl Tape {
    /// Returns the program in which each product that only one sum or difference reads is fused with it. In a field with fused operations
    /// this saves a rounding, on a processor with such instructions also an instruction. No other operation changes its order.
    pub fn fused(&self) -> Tape {
        let readings = self.readings();
        // products whose sum did not occur yet
        let mut products: Vec<Option<[Register; 2]>> = vec![None; self.registers];
        let mut next = self.inputs + self.constants.len();
        let mut fused: Vec<(usize, Operation)> = Vec::with_capacity(self.operations.len());
        let mut taken = vec![false; self.registers];
        for &operation in &self.operations {
            let terms = match operation {
                // the product that is computed later is fused, since the other operand must be available
                Operation::Sum(a, b) | Operation::Difference(a, b) => [a.max(b), a.min(b)].map(Some),
                _ => [None; 2],
            };
            let found = terms.into_iter().flatten().find_map(|term| Some((term, products[term as usize].take()?)));
            let whole = found.map(|(term, product)| {
                taken[term as usize] = true;
                operation.around(term, product)
            });
            if let Operation::Product(a, b) | Operation::Multiple(a, b) = operation
                && readings[next] == 1
            {
                products[next] = Some([a, b]);
            }
            fused.push((next, whole.unwrap_or(operation)));
            next += operation.results();
        }
        fused.retain(|(register, _)| !taken[*register]);
        Tape { once: true, ..self.renumbered(&fused) }
    }

    /// Returns how often each register is read; an output counts as one reading.
    pub(super) fn readings(&self) -> Vec<u32> {
        let mut readings = vec![0; self.registers];
        let operands = self.operations.iter().flat_map(|operation| operation.reads());
        operands.chain(self.outputs.iter().copied()).for_each(|register| readings[register as usize] += 1);
        readings
    }

    /// Returns a tape of the given (register, operation) pairs, with registers renumbered without gaps.
    pub(super) fn renumbered(&self, kept: &[(usize, Operation)]) -> Tape {
        let first = self.inputs + self.constants.len();
        let mut number: Vec<Register> = (0..self.registers as Register).collect();
        let mut next = first;
        let mut operations = Vec::with_capacity(kept.len());
        for &(register, operation) in kept {
            operations.push(operation.through(|old| number[old as usize]));
            for result in 0..operation.results() {
                number[register + result] = (next + result) as Register;
            }
            next += operation.results();
        }
        let outputs = self.outputs.iter().map(|&output| number[output as usize]).collect();
        Tape { operations, outputs, registers: next, ..self.clone() }
    }
}

impl Operation {
    /// Fuses a sum or difference with the product in its register `term`.
    fn around(self, term: Register, product: [Register; 2]) -> Self {
        match self {
            Operation::Sum(a, b) => Operation::ProductAnd(product, if term == a { b } else { a }),
            Operation::Difference(a, b) if term == a => Operation::ProductLess(product, b),
            Operation::Difference(a, _) => Operation::LessProduct(product, a),
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Operation, Tape};
    use crate::Sym;

    fn steps(outputs: &[Sym]) -> Vec<Operation> {
        let inputs = ["a", "b", "c", "d"].map(Sym::symbol);
        Tape::record(&inputs, outputs).expect("it has values").fused().steps().to_vec()
    }

    #[test]
    fn a_product_that_one_sum_reads_is_computed_in_it() {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(Sym::symbol);
        assert_eq!(steps(&[a * b + c]), [Operation::ProductAnd([0, 1], 2)]);
        assert_eq!(steps(&[a * b - c]), [Operation::ProductLess([0, 1], 2)]);
        assert_eq!(steps(&[c - a * b]), [Operation::LessProduct([0, 1], 2)]);
        // only one of two products is fused
        assert_eq!(steps(&[a * b + c * d]), [Operation::Product(0, 1), Operation::ProductAnd([2, 3], 4)]);
    }

    #[test]
    fn a_product_that_is_read_twice_is_computed_once() {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(Sym::symbol);
        let product = Operation::Product(0, 1);
        assert_eq!(steps(&[a * b + c, a * b + d]), [product, Operation::Sum(2, 4), Operation::Sum(3, 4)]);
        assert_eq!(steps(&[a * b, a * b + c]), [product, Operation::Sum(2, 4)]);
    }
}
