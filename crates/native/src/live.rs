//! The number of values in use at once, which determines how many are spilled to the stack.

use super::pieces::place;
use symbolic::Tape;

/// The largest number, over all steps of a tape, of computed values that are still to be read or written as outputs.
pub fn most_live(tape: &Tape) -> usize {
    let given = tape.inputs() + tape.rounded().len();
    let computed = tape.registers().saturating_sub(given);
    let mut needed = vec![false; computed];
    let mut live = 0;
    for at in tape.results().iter().filter_map(|result| place(*result, given)) {
        live += usize::from(!std::mem::replace(&mut needed[at], true));
    }
    let (mut most, mut next) = (live, computed);
    for step in tape.steps().iter().rev() {
        let first = next - step.results();
        live -= needed[first..next].iter().filter(|needed| **needed).count();
        next = first;
        for at in step.operands().into_iter().filter_map(|register| place(register, given)) {
            live += usize::from(!std::mem::replace(&mut needed[at], true));
        }
        most = most.max(live);
    }
    most
}
