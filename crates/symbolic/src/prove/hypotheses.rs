//! Hypotheses of a statement: relations between its symbols.

use crate::Sym;
use crate::graph::Node;
use field::{Circle, Scalar};
use num_traits::One;
use std::fmt;

/// Relations between symbols under which a statement is decided.
///
/// A relation is either a *rule* g^k -> tail, which rewrites a power of a symbol by lower terms, or a symbol *given* by an
/// expression. Rules with different leading symbols and one admissible term order are a Groebner basis, hence the
/// normal form modulo the rules is canonical. A set of rules without such an order is rejected. The rules sin^2 -> 1 - cos^2
/// for every angle and r^2 -> a for every root r = sqrt(a) always apply.
#[derive(Clone, Debug, Default)]
pub struct Hypotheses {
    pub(super) rules: Vec<Rule>,
    pub(super) given: Vec<(Sym, Sym)>,
    pub(super) spheres: Vec<Vec<Sym>>,
    statements: Vec<(Sym, Sym)>,
    refused: Option<Refused>,
}

/// The rule lead^power -> tail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rule {
    pub lead: Sym,
    pub power: u32,
    pub tail: Sym,
}

/// The reason why hypotheses do not define a canonical normal form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused(pub String);

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the hypotheses are refused: {}", self.0)
    }
}

impl std::error::Error for Refused {}

impl Hypotheses {
    /// Returns the empty set of hypotheses.
    pub fn none() -> Self {
        Self::default()
    }

    /// Whether nothing is assumed.
    pub(crate) fn is_none(&self) -> bool {
        self.rules.is_empty()
            && self.given.is_empty()
            && self.spheres.is_empty()
            && self.statements.is_empty()
            && self.refused.is_none()
    }

    /// Adds the hypothesis that a vector has length one. The square of its last component is rewritten.
    pub fn unit_vector<const N: usize>(mut self, vector: [Sym; N]) -> Self {
        let Some((&last, others)) = vector.split_last() else {
            return self;
        };
        let tail = others.iter().fold(Sym::one(), |rest, &each| rest - each.powi(2));
        let square = vector.iter().map(|each| each.powi(2)).reduce(|sum, each| sum + each);
        self.spheres.push(vector.to_vec());
        self.add_rule(last, 2, tail, (square.unwrap_or(Sym::ZERO), Sym::one()))
    }

    /// Adds the hypothesis cos^2 + sin^2 = 1 for a pair of expressions.
    pub fn on_circle(self, point: Circle<Sym>) -> Self {
        self.unit_vector([point.cos, point.sin])
    }

    /// Adds the rule lead^power = tail, for a symbol `lead` and a polynomial `tail` of lower degree in `lead`.
    pub fn rule(self, lead: Sym, power: u32, tail: Sym) -> Self {
        self.add_rule(lead, power, tail, (lead.powi(power as i32), tail))
    }

    /// Adds the hypothesis symbol = expression. The expression must not contain the symbol.
    pub fn given(mut self, symbol: Sym, expression: Sym) -> Self {
        let value = expression.substitute(&self.given);
        if !matches!(symbol.node(), Node::Symbol(_)) {
            return self.refuse(format!("`{symbol}` is given by an expression but is not a symbol"));
        }
        if value.symbols_of().contains(&symbol) {
            return self.refuse(format!("`{symbol}` is given by an expression that contains it"));
        }
        if self.given.iter().any(|(known, _)| *known == symbol) {
            return self.refuse(format!("`{symbol}` is given twice"));
        }
        if self.rules.iter().any(|rule| rule.lead == symbol) {
            return self.refuse(format!("`{symbol}` is given by an expression, and its powers are rewritten"));
        }
        for (_, known) in &mut self.given {
            *known = known.substitute(&[(symbol, value)]);
        }
        self.given.push((symbol, value));
        self.statements.push((symbol, expression));
        self
    }

    /// Returns the hypotheses as equations (left, right), in the order in which they were added.
    pub fn statements(&self) -> &[(Sym, Sym)] {
        &self.statements
    }

    /// Checks that the rules define a canonical normal form: different leading symbols, one admissible order.
    ///
    /// # Errors
    /// [`Refused`] describes the rules that conflict.
    pub fn check(&self) -> Result<(), Refused> {
        match &self.refused {
            Some(refused) => Err(refused.clone()),
            None => super::generators::Generators::check(self),
        }
    }

    pub(super) fn refusal(&self) -> Option<&Refused> {
        self.refused.as_ref()
    }

    fn add_rule(mut self, lead: Sym, power: u32, tail: Sym, statement: (Sym, Sym)) -> Self {
        let written = format!("{} = {}", statement.0, statement.1);
        if !matches!(lead.node(), Node::Symbol(_)) || power == 0 {
            return self.refuse(format!("the left side of `{written}` is not a power of a symbol"));
        }
        if self.given.iter().any(|(known, _)| *known == lead) {
            return self.refuse(format!("`{lead}` is given by an expression, and its powers are rewritten"));
        }
        if let Some(Rule { power, tail, .. }) = self.rules.iter().find(|rule| rule.lead == lead).copied() {
            let other = lead.powi(power as i32);
            return self.refuse(format!(
                "`{other} = {tail}` and `{written}` both rewrite powers of `{lead}`; their leading terms are not coprime"
            ));
        }
        self.rules.push(Rule { lead, power, tail });
        self.statements.push(statement);
        self
    }

    /// Stores the reason of a rejection, unless an earlier one is stored.
    fn refuse(mut self, reason: String) -> Self {
        self.refused.get_or_insert(Refused(reason));
        self
    }
}

/// Returns the rule sin^2 -> 1 - cos^2.
pub(super) fn circle_rule(cos: Sym, sin: Sym) -> Rule {
    Rule { lead: sin, power: 2, tail: Sym::int(1) - cos.powi(2) }
}
