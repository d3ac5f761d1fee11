//! The premises of a verdict: the given conditions, and all divisors of its proof.

use crate::proof::one_sign;
use crate::{Condition, Judged};
use symbolic::{Hypotheses, Node, Sym, normal};

/// The largest length in characters of an expression that is shown; for a longer one only its letters are listed.
const READABLE: usize = 420;

impl Judged {
    /// Adds a condition to the premises; conditions about signs have a list of their own.
    pub(crate) fn presuppose(&mut self, condition: Condition) {
        let stated = told(condition);
        let is_sign = matches!(condition, Condition::Positive(_) | Condition::NotNegative(_));
        let list = if is_sign { &mut self.signs } else { &mut self.requires };
        if !list.contains(&stated) {
            list.push(stated);
        }
    }

    /// Adds divisors of the proof to the premises, short ones first. Divisors that cannot vanish are left out: by the given signs, by
    /// their own form, or as a power of a divisor in the list.
    pub(crate) fn divided_by(&mut self, divisors: &[Sym], given: &[Condition]) {
        let mut divisors: Vec<Sym> = divisors.iter().map(|divisor| radicand(*divisor)).collect();
        // ordered by length, then by text, since their own order depends on earlier expressions
        divisors.sort_by_cached_key(|divisor| {
            let text = divisor.to_string();
            (text.chars().count(), text)
        });
        let mut known = given.to_vec();
        for divisor in divisors {
            if !differs_from_zero(divisor, &known) {
                let condition = Condition::NonZero(divisor);
                known.push(condition);
                self.presuppose(condition);
            }
        }
    }
}

/// The radicand of a root, which vanishes exactly where the root does; any other divisor unchanged.
fn radicand(divisor: Sym) -> Sym {
    match divisor.node() {
        Node::Root(inside) => inside,
        _ => divisor,
    }
}

/// The largest power of a non-zero expression that is compared with a divisor.
const MOST_POWER: i32 = 4;

/// Whether the known conditions imply that the divisor does not vanish.
fn differs_from_zero(divisor: Sym, known: &[Condition]) -> bool {
    let excluded = known.iter().filter_map(|condition| match condition {
        Condition::NonZero(e) | Condition::Positive(e) => Some(*e),
        Condition::Zero(_) | Condition::Equal(..) | Condition::NotNegative(_) => None,
    });
    let excluded: Vec<Sym> = excluded.collect();
    let positive: Vec<Sym> = known
        .iter()
        .filter_map(|condition| match condition {
            Condition::Positive(e) if e.symbol_name().is_some() => Some(*e),
            _ => None,
        })
        .collect();
    let letters = divisor.symbols_of();
    let power = |e: &Sym| {
        e.symbols_of() == letters
            && (1..=MOST_POWER).any(|n| {
                let ratio = normal(divisor / e.powi(n), &Hypotheses::none());
                ratio.is_ok_and(|ratio| ratio.as_constant().is_some())
            })
    };
    one_sign(divisor, &positive, &|symbol| excluded.contains(symbol)).is_some() || excluded.iter().any(power)
}

/// The condition as text and as LaTeX.
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
        Condition::NotNegative(_) => (">= 0", "\\geq 0"),
    };
    let of = format!("an expression of {} characters in", text.chars().count());
    (format!("[{of} {}] {relation}", names.join(" ")), format!(r"[\text{{{of} }}{}] {sign}", latex.join(r"\;")))
}
