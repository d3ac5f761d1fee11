//! Reordering of a program for speed: results change only by rounding, and are equal bit for bit on all processors.

use super::{Operation, Register, Tape};

/// Returns the approximate latency of an operation in processor cycles. Only the order of these numbers matters.
fn wait(operation: Operation) -> u32 {
    match operation {
        Operation::Circle(_) | Operation::Elementary(..) => 45,
        Operation::Quotient(..) | Operation::Part(..) | Operation::Root(_) => 15,
        _ => 4,
    }
}

/// A term of a sum: its register, whether it is subtracted, and the time in cycles at which it is available.
#[derive(Clone, Copy)]
struct Term {
    register: Register,
    negative: bool,
    ready: u32,
}

impl Tape {
    /// Returns the program reordered for processors with instruction-level parallelism. Divisions by constants become multiplications, long sums
    /// are formed pairwise, with the terms that are available first, and products are fused with sums
    /// ([`Self::fused`]).
    pub fn arranged(&self) -> Tape {
        self.by_factors().by_pairs().fused()
    }

    /// Forms sums of more than two terms pairwise.
    fn by_pairs(&self) -> Tape {
        let first = self.inputs + self.constants.len();
        let readings = self.readings();
        let mut ready = vec![0; self.registers];
        // sums that only another sum reads: their terms, and the registers of their partial sums
        let mut open: Vec<Option<(Vec<Term>, Vec<Register>)>> = vec![None; self.registers];
        let absorbed = self.absorbed(&readings);
        let mut ordered: Vec<(usize, Operation)> = Vec::with_capacity(self.operations.len());
        let mut next = first;
        for &operation in &self.operations {
            let wait = wait(operation);
            match operation {
                Operation::Sum(a, b) | Operation::Difference(a, b) => {
                    let subtracted = matches!(operation, Operation::Difference(..));
                    let (mut terms, mut room) = (Vec::new(), vec![next as Register]);
                    for (register, negative) in [(a, false), (b, subtracted)] {
                        match open[register as usize].take() {
                            Some((inner, registers)) => {
                                terms.extend(
                                    inner.into_iter().map(|it| Term { negative: it.negative != negative, ..it }),
                                );
                                room.extend(registers);
                            }
                            None => terms.push(Term { register, negative, ready: ready[register as usize] }),
                        }
                    }
                    if absorbed[next] {
                        open[next] = Some((terms, room));
                    } else {
                        ready[next] = paired(terms, room, &mut ordered, wait);
                    }
                }
                _ => {
                    let latest = operation.operands().map(|operand| ready[operand as usize]).into_iter().max();
                    for result in 0..operation.results() {
                        ready[next + result] = latest.unwrap_or(0) + wait;
                    }
                    ordered.push((next, operation));
                }
            }
            next += operation.results();
        }
        self.renumbered(&ordered)
    }

    /// Returns for each register whether it is read exactly once, by a sum or difference.
    fn absorbed(&self, readings: &[u32]) -> Vec<bool> {
        let mut absorbed = vec![false; self.registers];
        for operation in &self.operations {
            if let Operation::Sum(a, b) | Operation::Difference(a, b) = *operation {
                [a, b].into_iter().for_each(|term| absorbed[term as usize] = readings[term as usize] == 1);
            }
        }
        absorbed
    }
}

/// Emits the operations of a sum: the two terms that are available first are added, until one term is left. At least one term is not
/// subtracted. Returns the time at which the sum is available.
fn paired(mut terms: Vec<Term>, mut room: Vec<Register>, ordered: &mut Vec<(usize, Operation)>, wait: u32) -> u32 {
    // the last partial sum must be in the register that other operations read
    room.reverse();
    let mut places = room.into_iter();
    while terms.len() > 1 {
        terms.sort_by_key(|term| (std::cmp::Reverse(term.ready), std::cmp::Reverse(term.register)));
        let (Some(a), Some(b), Some(register)) = (terms.pop(), terms.pop(), places.next()) else { break };
        let operation = match (a.negative, b.negative) {
            (false, true) => Operation::Difference(a.register, b.register),
            (true, false) => Operation::Difference(b.register, a.register),
            _ => Operation::Sum(a.register, b.register),
        };
        ordered.push((register as usize, operation));
        terms.push(Term { register, negative: a.negative && b.negative, ready: a.ready.max(b.ready) + wait });
    }
    terms.first().map_or(0, |term| term.ready)
}

#[cfg(test)]
mod tests {
    use super::super::{Operation, Tape};
    use crate::Sym;
    use field::{Analytic, Scalar};

    fn values(tape: &Tape, inputs: [f64; 4]) -> Vec<f64> {
        let mut values = vec![0.0; tape.outputs()];
        tape.over::<f64>().evaluate(&inputs, &mut values);
        values
    }

    fn record(outputs: &[Sym]) -> Tape {
        let inputs = ["a", "b", "c", "d"].map(Sym::symbol);
        Tape::record(&inputs, outputs).expect("it has values").arranged()
    }

    #[test]
    fn four_terms_are_two_pairs() {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(Sym::symbol);
        let pairs = [Operation::Sum(0, 1), Operation::Difference(2, 3), Operation::Sum(4, 5)];
        assert_eq!(record(&[a + b + c - d]).steps(), pairs);
        let less = record(&[a - (b - (c - d)), b - a]);
        assert_eq!(values(&less, [1.0, 20.0, 300.0, 4000.0]), [1.0 - (20.0 - (300.0 - 4000.0)), 19.0]);
    }

    #[test]
    fn a_sum_that_is_read_twice_is_a_term_of_its_own() {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(Sym::symbol);
        let tape = record(&[(a + b) * c, a + b + d]);
        assert_eq!(values(&tape, [1.0, 20.0, 300.0, 4000.0]), [21.0 * 300.0, 4021.0]);
    }

    #[test]
    fn what_comes_late_is_added_last() {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(Sym::symbol);
        let late = record(&[a.circle().cos + b + c + d]);
        let last = late.steps().last().copied();
        assert_eq!(last.map(|it| it.operands()[0].min(it.operands()[1])), Some(4), "the cosine waits for nothing");
    }

    #[test]
    fn a_constant_divisor_becomes_a_factor() {
        let [a, b, c, _] = ["a", "b", "c", "d"].map(Sym::symbol);
        let eighth = record(&[a / Sym::int(8) + b, c / Sym::int(8)]);
        assert!(eighth.steps().iter().all(|step| !matches!(step, Operation::Part(..))));
        assert_eq!(values(&eighth, [4.0, 1.0, 2.0, 0.0]), [1.5, 0.25]);
    }
}
