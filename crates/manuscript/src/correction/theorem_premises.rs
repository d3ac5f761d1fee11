//! The premises of a theorem, each solved for a letter; squares are replaced by roots with given signs, and several relations for one letter are combined.

use claims::{Condition, Page, Verdict};
use symbolic::{Hypotheses, Node, Sym, coefficients, normal};

/// The premises as values of letters.
pub(super) struct Premises {
    pub hypotheses: Hypotheses,
    /// Divisors that no premise excludes from vanishing.
    pub divisors: Vec<Sym>,
}

impl Premises {
    /// The rules of a theorem together with its equalities, each solved for a symbol in which it is linear, preferably for the unknown `asked`.
    pub fn of(rules: &Hypotheses, given: &[Condition], asked: Sym) -> Self {
        let (mut hypotheses, mut divisors) = (rules.clone(), Vec::new());
        let together = together(given, asked);
        if let Some(Solution { value, divisor }) = together {
            hypotheses = hypotheses.given(asked, value);
            divisors.extend((!is_apart(divisor, given)).then_some(divisor));
        }
        let stands_together = |zero: Sym| together.is_some() && zero.symbols_of().contains(&asked);
        for condition in given {
            let (Condition::Zero(_) | Condition::Equal(..)) = condition else { continue };
            if stands_together(condition.expression()) {
                continue;
            }
            let rooted = rooted(*condition, given);
            // an equality that gives the square of a letter
            if let (Condition::Equal(square, value), None) = (condition, rooted)
                && let Node::Power(lead, power) = square.node()
                && lead.symbol_name().is_some()
                && normal(*value, &hypotheses).is_ok_and(|value| !value.to_sym().symbols_of().contains(&lead))
            {
                let with = hypotheses.clone().rule(lead, power, *value);
                if with.check().is_ok() {
                    hypotheses = with;
                    continue;
                }
            }
            let zero = rooted.unwrap_or(condition.expression());
            let Ok(zero) = normal(zero, &hypotheses).map(|form| form.numerator()) else { continue };
            let mut symbols = zero.symbols_of();
            symbols.sort_by_key(|symbol| *symbol != asked);
            let solved = |symbol: Sym| Some((symbol, solution(zero, symbol)?));
            let all: Vec<(Sym, Solution)> = symbols.into_iter().filter_map(solved).collect();
            let is_apart = |factor: Sym| is_apart(factor, given);
            let chosen = all.iter().find(|(_, solution)| is_apart(solution.divisor));
            let Some(&(symbol, Solution { value, divisor })) =
                chosen.or_else(|| all.first().filter(|(symbol, _)| *symbol == asked))
            else {
                continue;
            };
            let with = hypotheses.clone().given(symbol, value);
            if with.check().is_ok() {
                hypotheses = with;
                divisors.extend((!is_apart(divisor)).then_some(divisor));
            }
        }
        Premises { hypotheses, divisors }
    }
}

/// The value of the unknown from several relations that are linear in it. Each relation is multiplied by its coefficient of the unknown, so that
/// the coefficient in their sum is a sum of squares.
fn together(given: &[Condition], asked: Sym) -> Option<Solution> {
    asked.symbol_name()?;
    let zeros = given.iter().filter(|one| matches!(one, Condition::Zero(_) | Condition::Equal(..)));
    let linear = zeros.filter_map(|one| solution(one.expression(), asked)).collect::<Vec<_>>();
    // a single relation with a coefficient that does not vanish is sufficient
    if linear.len() < 2 || linear.iter().any(|one| is_apart(one.divisor, given)) {
        return None;
    }
    let sum = |of: &dyn Fn(&Solution) -> Sym| linear.iter().fold(Sym::ZERO, |sum, one| sum + of(one));
    let divisor = sum(&|one| one.divisor * one.divisor);
    Some(Solution { value: sum(&|one| one.divisor * one.divisor * one.value) / divisor, divisor })
}

/// The difference of the roots if a condition states that two squares are equal and the signs of both roots are given.
fn rooted(condition: Condition, given: &[Condition]) -> Option<Sym> {
    let Condition::Equal(left, right) = condition else { return None };
    let (left, right) = (root(left)?, root(right)?);
    Some(if sign(left, given)? == sign(right, given)? { left - right } else { left + right })
}

/// A square root of an expression that is written as a square, without regard to its sign.
fn root(square: Sym) -> Option<Sym> {
    match square.node() {
        Node::Power(of, power) if power % 2 == 0 => Some(of.powi(power as i32 / 2)),
        Node::Product(a, b) if a == b => Some(a),
        Node::Product(a, b) => Some(root(a)? * root(b)?),
        Node::Quotient(a, b) => Some(root(a)? / root(b)?),
        _ => (square == Sym::ONE).then_some(Sym::ONE),
    }
}

/// The sign of a product of quantities with given signs; `None` if it is not determined.
fn sign(of: Sym, given: &[Condition]) -> Option<i32> {
    let stated = given.iter().find_map(|condition| match condition {
        Condition::Positive(positive) => {
            normal(of / *positive, &Hypotheses::none()).ok()?.as_constant()?.sign().filter(|sign| *sign != 0)
        }
        _ => None,
    });
    stated.or_else(|| match of.node() {
        Node::Product(a, b) | Node::Quotient(a, b) => Some(sign(a, given)? * sign(b, given)?),
        _ => None,
    })
}

/// The value of a symbol, and the divisor in it.
#[derive(Clone, Copy)]
struct Solution {
    value: Sym,
    divisor: Sym,
}

/// The value of a symbol at which an expression vanishes that is linear in it.
fn solution(zero: Sym, symbol: Sym) -> Option<Solution> {
    let terms = coefficients(zero, &[symbol]).ok()?;
    let of = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
    let divisor = of(1).filter(|_| terms.iter().all(|(exponents, _)| exponents[0] <= 1))?;
    Some(Solution { value: -of(0).unwrap_or(Sym::ZERO) / divisor, divisor })
}

/// Whether a factor never vanishes: a number, a quantity that differs from zero by a premise, or a product of such factors.
fn is_apart(factor: Sym, given: &[Condition]) -> bool {
    if factor.as_constant().is_some() {
        return true;
    }
    let is_stated = |part: Sym| {
        given.iter().any(|condition| match *condition {
            Condition::NonZero(of) | Condition::Positive(of) => {
                normal(part / of, &Hypotheses::none()).is_ok_and(|ratio| ratio.as_constant().is_some())
            }
            _ => false,
        })
    };
    let leaves: Vec<Sym> = factor.leaves_of().into_iter().filter(|leaf| leaf.as_constant().is_none()).collect();
    let is_one_product = coefficients(factor, &leaves).is_ok_and(|terms| terms.len() == 1);
    if is_stated(factor) || is_one_product && leaves.iter().all(|leaf| is_stated(*leaf)) {
        return true;
    }
    let mut page = Page::of("print", |_| None);
    let premises = given.iter().copied().filter(|one| !matches!(one, Condition::Zero(_) | Condition::Equal(..)));
    page.claim("print", "divisor", "").given(premises).by_signs([Condition::NonZero(factor)]);
    page.judge().iter().all(|judged| judged.verdict == Verdict::Proved)
}
