//! Compilation of expressions of time and state, with the reason for a failure.

use crate::compiled_system::NotCompiled;
use simulation::Program;
use symbolic::{Sym, Tape};

/// Compiles a function of the time and of a state of n numbers; the number of its values is free.
///
/// # Errors
/// [`NotCompiled::Undefined`] for a letter without a value or a division by zero, [`NotCompiled::TooLong`] for any other failure.
pub(crate) fn recorded(
    n: usize,
    mut function: impl FnMut(Sym, &[Sym]) -> Vec<Sym> + Send,
) -> Result<Program, NotCompiled> {
    if let Some(program) = Program::of(n, &mut function) {
        return Ok(program);
    }
    // the compilation does not say why it failed; the tape does
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
