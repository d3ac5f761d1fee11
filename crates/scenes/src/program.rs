//! Programs of expressions of a time and a state, or the reason for which there is none.

use crate::compiled_system::NotCompiled;
use simulation::Program;
use symbolic::{Sym, Tape};

/// The program of a function of a time and a state of n numbers, of any length.
///
/// # Errors
/// [`NotCompiled::Undefined`] with the letter, or the division by zero, that has no value.
pub(crate) fn recorded(
    n: usize,
    mut function: impl FnMut(Sym, &[Sym]) -> Vec<Sym> + Send,
) -> Result<Program, NotCompiled> {
    if let Some(program) = Program::of(n, &mut function) {
        return Ok(program);
    }
    // a program of any length fails for one reason alone: its tape
    let mut reason = None;
    Program::of(n, |time, state| {
        let values = function(time, state);
        reason = Tape::record(&[state, &[time]].concat(), &values).err();
        Vec::new()
    });
    Err(reason.map_or(NotCompiled::TooLong, |reason| NotCompiled::Undefined { reason: reason.to_string() }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_without_a_value_is_named() {
        let found = recorded(1, |_, state| vec![state[0] + Sym::symbol("stranger")]);
        assert!(matches!(found, Err(NotCompiled::Undefined { reason }) if reason.contains("stranger")));
        assert!(recorded(1, |time, state| vec![state[0] + time]).is_ok());
    }
}
