//! Splitting of a long tape into pieces, each compiled to one function: the time of code generation and the stack frame
//! grow with the piece.

use std::ops::Range;
use symbolic::{Register, Tape};

/// The number of operations of a piece, if the tape is split.
const LENGTH: usize = 256;

/// The largest number of operations of a tape that is not split.
const WHOLE: usize = 1 << 11;

/// A split tape, and the values passed between its pieces.
pub struct Pieces {
    pub ranges: Vec<Range<usize>>,
    /// The index of each computed register in the common buffer, if a later piece reads it.
    pub kept: Vec<Option<usize>>,
    /// The piece that computes each computed register.
    pub made_in: Vec<usize>,
    /// The length of that buffer.
    pub room: usize,
}

impl Pieces {
    /// One piece if the tape is short and at most `most_live` values are in use at once; otherwise several.
    pub fn of(tape: &Tape, most_live: usize) -> Self {
        let steps = tape.steps().len();
        let whole = steps <= WHOLE && super::live::most_live(tape) <= most_live;
        Self::cut(tape, if whole { steps.max(1) } else { LENGTH })
    }

    /// Splits the tape into pieces of `length` operations.
    pub fn cut(tape: &Tape, length: usize) -> Self {
        let steps = tape.steps();
        let ranges: Vec<_> =
            (0..steps.len().max(1)).step_by(length).map(|first| first..(first + length).min(steps.len())).collect();
        let made_in: Vec<usize> = (steps.iter().enumerate())
            .flat_map(|(at, step)| std::iter::repeat_n(at / length, step.results()))
            .collect();
        let given = tape.inputs() + tape.rounded().len();
        let mut is_read_later = vec![false; made_in.len()];
        for (at, step) in steps.iter().enumerate() {
            for computed in step.operands().into_iter().filter_map(|register| place(register, given)) {
                is_read_later[computed] |= made_in[computed] < at / length;
            }
        }
        let mut room = 0;
        let kept = is_read_later.into_iter().map(|is| {
            is.then(|| {
                room += 1;
                room - 1
            })
        });
        Pieces { ranges, kept: kept.collect(), made_in, room }
    }
}

/// The index of a register among the computed ones, which come after inputs and constants.
pub fn place(register: Register, given: usize) -> Option<usize> {
    (register as usize).checked_sub(given)
}
