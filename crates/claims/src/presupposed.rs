//! What a verdict rests on: the conditions that are given, and everything that was divided by.

use crate::proof::one_sign;
use crate::{Condition, Judged};
use symbolic::{Hypotheses, Node, Sym, normal};

/// Shown as it stands up to this; a longer expression is told by its letters.
const READABLE: usize = 420;

impl Judged {
    /// Lists a given condition; signs have a list of their own.
    pub(crate) fn presuppose(&mut self, condition: Condition) {
        let stated = told(condition);
        let list = if matches!(condition, Condition::Positive(_)) { &mut self.signs } else { &mut self.requires };
        if !list.contains(&stated) {
            list.push(stated);
        }
    }

    /// Lists what was divided by, but for what cannot vanish by the given signs, or by its own.
    pub(crate) fn divided_by(&mut self, divisors: &[Sym], given: &[Condition]) {
        for &divisor in divisors {
            let divisor = match divisor.node() {
                Node::Root(inside) => inside,
                _ => divisor,
            };
            if !differs_from_zero(divisor, given) {
                self.presuppose(Condition::NonZero(divisor));
            }
        }
    }
}

/// Whether the given conditions exclude that it vanishes.
fn differs_from_zero(divisor: Sym, given: &[Condition]) -> bool {
    let excluded = given.iter().filter_map(|condition| match condition {
        Condition::NonZero(e) | Condition::Positive(e) => Some(*e),
        Condition::Zero(_) | Condition::Equal(..) => None,
    });
    let excluded: Vec<Sym> = excluded.collect();
    let positive: Vec<Sym> = given
        .iter()
        .filter_map(|condition| match condition {
            Condition::Positive(e) if e.symbol_name().is_some() => Some(*e),
            _ => None,
        })
        .collect();
    let multiple = |e: &Sym| {
        let ratio = normal(divisor / *e, &Hypotheses::none());
        ratio.is_ok_and(|ratio| ratio.as_constant().is_some())
    };
    one_sign(divisor, &positive, &|symbol| excluded.contains(symbol)).is_some() || excluded.iter().any(multiple)
}

/// In text and LaTeX.
pub(crate) fn told(condition: Condition) -> (String, String) {
    let text = condition.to_string();
    if text.chars().count() <= READABLE {
        return (text, condition.latex());
    }
    let letters = condition.expression().symbols_of();
    let names: Vec<String> = letters.iter().map(Sym::to_string).collect();
    let latex: Vec<String> = letters.iter().map(|letter| letter.latex()).collect();
    let (relation, sign) = match condition {
        Condition::Zero(_) | Condition::Equal(..) => ("= 0", "= 0"),
        Condition::NonZero(_) => ("!= 0", "\\neq 0"),
        Condition::Positive(_) => ("> 0", "> 0"),
    };
    let of = format!("an expression of {} characters in", text.chars().count());
    (format!("[{of} {}] {relation}", names.join(" ")), format!(r"[\text{{{of} }}{}] {sign}", latex.join(r"\;")))
}
