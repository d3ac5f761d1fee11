//! Inequalities between functions of one letter that are equal at a bound of the letter: `sin(x) < x` for `x > 0`, since `1 - cos(x) >= 0`.

use crate::circle_signs::circle_signs;
use crate::half_turn::{is_half_turn, sign_of_number};
use crate::natural_domain::natural_domain;
use crate::real_signs;
use claims::Condition;
use symbolic::{Hypotheses, Node, Sym, decide, normal};

/// The largest order of derivatives that are examined.
const DEPTH: usize = 4;

/// Whether an expression is proved nonnegative for all values of a letter above a lower bound, because it is at the bound and its derivative is above.
/// `None` without a proof, otherwise whether the expression is positive.
pub(crate) fn shows(expression: Sym, conditions: &[Condition]) -> Option<bool> {
    let letters = expression.symbols_of().into_iter().filter(|letter| !is_half_turn(*letter));
    letters.filter_map(|letter| Interval::of(letter, conditions)).find_map(|interval| interval.grows(expression, DEPTH))
}

/// The interval of a letter that conditions allow.
struct Interval<'a> {
    letter: Sym,
    from: Sym,
    is_open: bool,
    conditions: &'a [Condition],
}

impl<'a> Interval<'a> {
    /// The interval of a letter; `None` without a lower bound, or if conditions other than bounds contain the letter.
    fn of(letter: Sym, conditions: &'a [Condition]) -> Option<Self> {
        let own = || conditions.iter().filter(|condition| condition.expression().symbols_of().contains(&letter));
        let bound = |condition: &Condition| {
            let (of, is_open) = match *condition {
                Condition::Positive(of) => (of, true),
                Condition::NotNegative(of) => (of, false),
                _ => return None,
            };
            let slope = of.diff(letter).as_constant()?.sign()?;
            let is_bound = of
                .leaves_of()
                .into_iter()
                .all(|leaf| leaf == letter || is_half_turn(leaf) || leaf.as_constant().is_some());
            is_bound.then(|| (slope, letter - of / of.diff(letter), is_open))
        };
        let bounds = own().map(bound).collect::<Option<Vec<_>>>()?;
        let mut lower = bounds.into_iter().filter(|(slope, ..)| *slope > 0);
        match (lower.next(), lower.next()) {
            (Some((_, from, is_open)), None) => Some(Interval { letter, from: plain(from)?, is_open, conditions }),
            _ => None,
        }
    }

    /// Whether an expression is nonnegative at the bound and its derivative nonnegative above it.
    fn grows(&self, expression: Sym, depth: usize) -> Option<bool> {
        let is_continuous = |condition: Condition| {
            let of = condition.expression();
            let is_apart = || circle_signs(&[expression], self.conditions).contains(&Condition::Positive(of));
            matches!(condition, Condition::NonZero(_))
                && is_apart()
                && self.at_bound(of).and_then(sign_of_number).is_some_and(|sign| sign != 0)
        };
        let has_root = Sym::ascending(&[expression]).into_iter().any(|part| matches!(part.node(), Node::Root(_)));
        if has_root || !natural_domain(&[expression]).into_iter().all(is_continuous) {
            return None;
        }
        let there = self.at_bound(expression)?;
        let elsewhere: Vec<Condition> = self
            .conditions
            .iter()
            .copied()
            .filter(|one| !one.expression().symbols_of().contains(&self.letter))
            .collect();
        let at_bound = match there == Sym::ZERO {
            true => false,
            false => sign_of_number(there)
                .map(|sign| sign > 0)
                .filter(|is_up| *is_up)
                .or_else(|| real_signs::shows(there, &elsewhere).map(|shown| shown.is_strict))?,
        };
        let slope = plain(expression.diff(self.letter))?;
        let by_signs = || real_signs::shows(slope, self.conditions).map(|shown| shown.is_strict);
        let is_strict = by_signs().or_else(|| if depth == 0 { None } else { self.grows(slope, depth - 1) })?;
        // zeros of the derivative at single points do not prevent strict growth
        let is_alone = expression.symbols_of().into_iter().all(|letter| letter == self.letter || is_half_turn(letter));
        let parts = is_strict || is_alone && !decide(slope, &Hypotheses::none()).is_zero();
        Some(at_bound || self.is_open && parts)
    }

    fn at_bound(&self, expression: Sym) -> Option<Sym> {
        plain(expression.substitute(&[(self.letter, self.from)]))
    }
}

fn plain(expression: Sym) -> Option<Sym> {
    normal(crate::half_turn::with_exact_turns(expression), &Hypotheses::none()).ok().map(|form| form.to_sym())
}
