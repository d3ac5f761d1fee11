//! Simplification of expressions in direction cosines, which are not independent of each other.

use super::{simplified, simplified_as_defined};
use crate::equations::vanishes;
use field::{Rational, Scalar};
use symbolic::Sym;

/// The quaternion of a free frame, and its direction cosines, parent axes by own axes.
pub(crate) type FreeTurn = ([Sym; 4], [[Sym; 3]; 3]);

/// Longer expressions are unchanged.
const MOST_READ: usize = 150;

/// Returns an expression in normal form in which direction cosines are treated as symbols, simplified by their relations.
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

/// The rotation of a free frame, with symbols for its direction cosines.
struct Lettered<'t> {
    turn: &'t FreeTurn,
    letters: [[Sym; 3]; 3],
}

impl<'t> Lettered<'t> {
    fn of(number: usize, turn: &'t FreeTurn) -> Self {
        // names of systems contain no spaces
        let letter = |row: usize, column: usize| Sym::symbol(&format!("cosine {number} {row} {column}"));
        Lettered { turn, letters: std::array::from_fn(|row| std::array::from_fn(|column| letter(row, column))) }
    }

    fn pairs(&self, pair: impl Fn(Sym, Sym) -> (Sym, Sym)) -> Vec<(Sym, Sym)> {
        let all = self.letters.iter().flatten().zip(self.turn.1.iter().flatten());
        all.map(|(&letter, &cosine)| pair(letter, cosine)).collect()
    }

    /// Rewrites an expression as c + sum c_ij R_ij in the direction cosines R of this frame, if it has this form and becomes shorter:
    /// products of cosines may be cofactors, R_yy R_zz - R_yz R_zy = R_xx, or cancel by R R^T = 1.
    ///
    /// The coefficients follow from the values at ten rotations by 0, 90 and 180 degrees. Random points of prime fields then decide whether the result is equal.
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
            // a rotation by 90 degrees about the axis, and one by 180 degrees about the bisector of the other two axes
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
