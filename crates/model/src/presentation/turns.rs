//! Expressions of direction cosines, which are not independent of each other.

use super::{simplified, simplified_as_defined};
use crate::equations::vanishes;
use field::{Rational, Scalar};
use symbolic::Sym;

/// The quaternion and the direction cosines of a free frame.
pub(crate) type FreeTurn = ([Sym; 4], [[Sym; 3]; 3]);

/// Longer expressions stay as they are.
const MOST_READ: usize = 150;

/// An expression in normal form in which direction cosines stay together, as short as is found.
pub(crate) fn short_form(expression: Sym, turns: &[FreeTurn]) -> Sym {
    if Sym::operations_of(&[expression]) > MOST_READ {
        return expression;
    }
    let lettered: Vec<Lettered> = turns.iter().enumerate().map(|(number, turn)| Lettered::of(number, turn)).collect();
    let of = |pairs: fn(&Lettered) -> Vec<(Sym, Sym)>| lettered.iter().flat_map(pairs).collect::<Vec<_>>();
    let in_letters = expression.substitute(&of(|turn| turn.pairs(|letter, cosine| (cosine, letter))));
    let short = lettered.iter().fold(in_letters, |known, turn| turn.shorter(known));
    simplified_as_defined(short).substitute(&of(|turn| turn.pairs(|letter, cosine| (letter, cosine))))
}

/// A free frame's turn with letters for its direction cosines.
struct Lettered<'t> {
    turn: &'t FreeTurn,
    letters: [[Sym; 3]; 3],
}

impl<'t> Lettered<'t> {
    fn of(number: usize, turn: &'t FreeTurn) -> Self {
        // names that no system has
        let letter = |row: usize, column: usize| Sym::symbol(&format!("cosine {number} {row} {column}"));
        Lettered { turn, letters: std::array::from_fn(|row| std::array::from_fn(|column| letter(row, column))) }
    }

    fn pairs(&self, pair: impl Fn(Sym, Sym) -> (Sym, Sym)) -> Vec<(Sym, Sym)> {
        let all = self.letters.iter().flatten().zip(self.turn.1.iter().flatten());
        all.map(|(&letter, &cosine)| pair(letter, cosine)).collect()
    }

    /// An expression over letters as c + sum c_ij R_ij in the direction cosines R of this frame, where it is one and this is shorter:
    /// products of them may be cofactors, R_yy R_zz - R_yz R_zy = R_xx, or R R^T = 1 may remove them.
    ///
    /// Values at ten turns by right and half angles give the coefficients, and random points of prime fields decide.
    fn shorter(&self, expression: Sym) -> Sym {
        let symbols = expression.symbols_of();
        let occurs = |letter: &Sym| symbols.contains(letter);
        if !self.turn.0.iter().chain(self.letters.iter().flatten()).any(occurs) {
            return expression;
        }
        let by_cosines = self.pairs(|letter, cosine| (letter, cosine));
        let turned = expression.substitute(&by_cosines);
        let at = |quaternion: [i64; 4]| {
            let values: Vec<(Sym, Sym)> = self.turn.0.into_iter().zip(quaternion.map(Sym::int)).collect();
            turned.substitute(&values)
        };
        let unturned = at([1, 0, 0, 0]);
        if vanishes(turned - unturned) {
            return unturned;
        }
        let (quarter, half) = (Sym::constant(Rational::new(1, 4)), Sym::constant(Rational::new(1, 2)));
        let about = [at([0, 1, 0, 0]), at([0, 0, 1, 0]), at([0, 0, 0, 1])];
        let mean = simplified((unturned + about[0] + about[1] + about[2]) * quarter);
        let mut sum = mean;
        for axis in 0..3 {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let own = (unturned + about[axis] - about[next] - about[last]) * quarter;
            // a quarter turn about the axis, and a half turn about the line between the two others
            let [mut quarter_turn, mut half_turn] = [[1, 0, 0, 0], [0, 0, 0, 0]];
            (quarter_turn[1 + axis], half_turn[1 + next], half_turn[1 + last]) = (1, 1, 1);
            let skew = at(quarter_turn) - mean - own;
            let even = at(half_turn) - mean + own;
            for (coefficient, row, column) in
                [(own, axis, axis), ((even + skew) * half, last, next), ((even - skew) * half, next, last)]
            {
                sum += simplified(coefficient) * self.letters[row][column];
            }
        }
        let size = |each: Sym| Sym::operations_of(&[each]);
        let is_shorter = size(sum) < size(expression) && vanishes(turned - sum.substitute(&by_cosines));
        if is_shorter { sum } else { expression }
    }
}
