//! The generators of the polynomial ring of an expression: symbols, cosines and sines, roots, functions.
//!
//! Arguments are brought to normal form first. Therefore cos(a*b) and cos(b*a) are one generator, and the root of a sum of squares that equals 1 under the
//! hypotheses is 1.

use super::failure::Failure;
use super::hypotheses::{Hypotheses, Refused, Rule, circle_rule};
use super::normal::normal_form;
use crate::Sym;
use crate::analytic::{circle_in_steps, least_common_multiple, linear_terms, small_quotient};
use crate::graph::Node;
use crate::print::natural_key;
use field::{Analytic, Elementary};
use num_traits::One;
use rustc_hash::{FxHashMap, FxHashSet};

pub(crate) struct Generators {
    /// The generators, sorted by name.
    pub leaves: Vec<Sym>,
    pub index: FxHashMap<Sym, usize>,
    /// The rules whose leading generators occur. A rule precedes those that rewrite its tail.
    pub rules: Vec<Rule>,
    aliases: FxHashMap<Sym, Sym>,
}

impl Generators {
    pub fn of(expressions: &[Sym], hypotheses: &Hypotheses) -> Result<Self, Failure> {
        if let Some(refused) = hypotheses.refusal() {
            return Err(Failure::Hypotheses(refused.to_string()));
        }
        let mut gathering = Gathering::new(hypotheses);
        gathering.survey(expressions)?;
        gathering.visit(expressions)?;
        let mut leaves: Vec<Sym> = gathering.found.into_iter().collect();
        if leaves.len() > 1 {
            leaves.sort_by_cached_key(|leaf| natural_key(&leaf.symbol_name().unwrap_or_else(|| leaf.to_string())));
        }
        let index = leaves.iter().enumerate().map(|(place, &leaf)| (leaf, place)).collect();
        let mut generators = Generators { leaves, index, rules: Vec::new(), aliases: gathering.aliases };
        generators.rules = generators.ordered(gathering.rules).map_err(|refused| Failure::Hypotheses(refused.0))?;
        Ok(generators)
    }

    /// Checks that the rules of the hypotheses alone have an admissible order.
    pub fn check(hypotheses: &Hypotheses) -> Result<(), Refused> {
        let leads: Vec<Sym> = hypotheses.rules.iter().map(|rule| rule.lead).collect();
        match Self::of(&leads, hypotheses) {
            Err(Failure::Hypotheses(reason)) => Err(Refused(reason)),
            _ => Ok(()),
        }
    }

    /// Rewrites the expression in terms of the generators.
    pub fn rewrite(&self, expression: Sym) -> Sym {
        if self.aliases.is_empty() {
            return expression;
        }
        rewrite(expression, &self.aliases, &|each| self.index.contains_key(&each))
    }

    /// Sorts the rules so that no rule reintroduces a power which an earlier rule removed. Every rule then decreases the
    /// lexicographic order of the leading generators.
    fn ordered(&self, mut rules: Vec<Rule>) -> Result<Vec<Rule>, Refused> {
        if rules.len() < 2 {
            return Ok(rules);
        }
        let leads: FxHashSet<Sym> = rules.iter().map(|rule| rule.lead).collect();
        let mut uses: FxHashMap<Sym, Vec<Sym>> = FxHashMap::default();
        for rule in &rules {
            let inside = self.inside(self.rewrite(rule.tail));
            uses.insert(
                rule.lead,
                inside.into_iter().filter(|each| leads.contains(each) && *each != rule.lead).collect(),
            );
        }
        let mut sorted = Vec::with_capacity(rules.len());
        while !rules.is_empty() {
            let free = |lead: Sym| !rules.iter().any(|other| uses[&other.lead].contains(&lead));
            match rules.iter().position(|rule| free(rule.lead)) {
                Some(place) => sorted.push(rules.remove(place)),
                None => {
                    let named: Vec<String> = rules.iter().map(|rule| rule.lead.to_string()).collect();
                    return Err(Refused(format!(
                        "the rules for {} rewrite each other in a circle, so that no order makes all of them fall",
                        named.join(", ")
                    )));
                }
            }
        }
        Ok(sorted)
    }

    /// Returns the expression and its subexpressions down to the generators. Operands precede the operations on them.
    pub fn inside(&self, expression: Sym) -> Vec<Sym> {
        Sym::reached(&[expression], |each, node| !node.is_leaf() && !self.index.contains_key(&each))
    }
}

fn rewrite(expression: Sym, aliases: &FxHashMap<Sym, Sym>, generator: &impl Fn(Sym) -> bool) -> Sym {
    let mut new: FxHashMap<Sym, Sym> = FxHashMap::default();
    for each in Sym::reached(&[expression], |each, node| !node.is_leaf() && !generator(each)) {
        let value = match aliases.get(&each) {
            Some(&alias) => rewrite(alias, aliases, generator),
            None if each.node().is_leaf() || generator(each) => each,
            None => each.node().rebuild(each, |a| new[a]),
        };
        new.insert(each, value);
    }
    new[&expression]
}

/// Returns cos = x/r or sin = y/r of the angle atan2(y, x), with r = sqrt(x^2 + y^2); `None` for other angles.
fn of_direction(leaf: Sym) -> Option<Sym> {
    let (Node::Cos(angle) | Node::Sin(angle)) = leaf.node() else { return None };
    let Node::Elementary(Elementary::Atan2, y, x) = angle.node() else { return None };
    let along = if matches!(leaf.node(), Node::Cos(_)) { x } else { y };
    Some(along / (x * x + y * y).sqrt())
}

struct Gathering<'a> {
    hypotheses: &'a Hypotheses,
    found: FxHashSet<Sym>,
    aliases: FxHashMap<Sym, Sym>,
    rules: Vec<Rule>,
    /// Normal forms of arguments.
    normal: FxHashMap<Sym, Sym>,
    /// The number of equal parts into which each angle is divided: for x/2 and x/3 the parts of x are x/6.
    parts: FxHashMap<Sym, i64>,
}

impl<'a> Gathering<'a> {
    fn new(hypotheses: &'a Hypotheses) -> Self {
        Gathering {
            hypotheses,
            found: FxHashSet::default(),
            aliases: FxHashMap::default(),
            rules: Vec::new(),
            normal: FxHashMap::default(),
            parts: FxHashMap::default(),
        }
    }

    /// Determines the common parts of all angles, including those inside arguments.
    fn survey(&mut self, expressions: &[Sym]) -> Result<(), Failure> {
        let tails = self.hypotheses.rules.iter().map(|rule| rule.tail);
        let all: Vec<Sym> = expressions.iter().copied().chain(tails).collect();
        for each in Sym::ascending(&all) {
            if let Node::Cos(angle) | Node::Sin(angle) = each.node()
                && !matches!(angle.node(), Node::Symbol(_))
            {
                for (term, coefficient) in linear_terms(self.canonical(angle)?) {
                    let denominator = small_quotient(coefficient).map_or(1, |(_, denominator)| denominator);
                    let parts = self.parts.entry(term).or_insert(1);
                    // above a limit the angles have no common part: proofs remain valid, but refutations become impossible
                    *parts = least_common_multiple(*parts, denominator).unwrap_or(*parts);
                }
            }
        }
        Ok(())
    }

    fn visit(&mut self, expressions: &[Sym]) -> Result<(), Failure> {
        for each in Sym::ascending_to_leaves(expressions) {
            if self.found.contains(&each) || self.aliases.contains_key(&each) {
                continue;
            }
            match each.node() {
                Node::Symbol(_) => self.symbol(each)?,
                Node::Cos(angle) | Node::Sin(angle) => self.coordinate(each, angle)?,
                Node::Root(square) => self.root(each, square)?,
                Node::Elementary(function, a, b) => {
                    let canonical = self.canonical(a)?.elementary(function, self.canonical(b)?);
                    self.found.insert(canonical);
                    self.alias(each, canonical);
                }
                Node::Function(name, order, argument) => {
                    let canonical = Sym::function_of_order(name, order, self.canonical(argument)?);
                    self.found.insert(canonical);
                    self.alias(each, canonical);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn symbol(&mut self, symbol: Sym) -> Result<(), Failure> {
        self.found.insert(symbol);
        let hypotheses = self.hypotheses;
        for rule in hypotheses.rules.iter().filter(|rule| rule.lead == symbol) {
            let tail = if hypotheses.given.is_empty() { rule.tail } else { rule.tail.substitute(&hypotheses.given) };
            self.rules.push(Rule { tail, ..*rule });
            self.visit(&[tail])?;
        }
        Ok(())
    }

    fn canonical(&mut self, argument: Sym) -> Result<Sym, Failure> {
        if let Node::Symbol(_) | Node::Constant(_) = argument.node() {
            return Ok(argument);
        }
        if let Some(&known) = self.normal.get(&argument) {
            return Ok(known);
        }
        let canonical = normal_form(argument, self.hypotheses)?.to_sym();
        self.normal.insert(argument, canonical);
        Ok(canonical)
    }

    fn alias(&mut self, each: Sym, expression: Sym) {
        if each != expression {
            self.aliases.insert(each, expression);
        }
    }

    /// Expresses a cosine or sine through those of canonical angles.
    fn coordinate(&mut self, each: Sym, angle: Sym) -> Result<(), Failure> {
        let canonical = self.canonical(angle)?;
        let point = circle_in_steps(canonical, |term, denominator| match self.parts.get(&term) {
            Some(parts) if parts % denominator == 0 => *parts,
            _ => denominator,
        });
        let expression = if matches!(each.node(), Node::Cos(_)) { point.cos } else { point.sin };
        for leaf in Sym::ascending_to_leaves(&[expression]) {
            if let Some(algebraic) = of_direction(leaf) {
                if self.aliases.insert(leaf, algebraic).is_none() {
                    self.visit(&[algebraic])?;
                }
                continue;
            }
            if let Node::Sin(canonical) | Node::Cos(canonical) = leaf.node()
                && self.found.insert(leaf)
                && matches!(leaf.node(), Node::Sin(_))
            {
                let cos = Sym::from_node(Node::Cos(canonical));
                self.found.insert(cos);
                self.rules.push(circle_rule(cos, leaf));
            }
        }
        self.alias(each, expression);
        Ok(())
    }

    /// Rewrites sqrt(c N/D) = sqrt(c) s/D, with a positive constant c and the generator s = D sqrt(N/D), whose square N D is a
    /// polynomial.
    fn root(&mut self, each: Sym, square: Sym) -> Result<(), Failure> {
        if square.as_constant().is_some() {
            self.found.insert(each);
            self.rules.push(Rule { lead: each, power: 2, tail: square });
            return Ok(());
        }
        let form = normal_form(square, self.hypotheses)?;
        if let Some(constant) = form.as_constant() {
            let root = Sym::constant(constant).sqrt();
            self.visit(&[root])?;
            self.alias(each, root);
            return Ok(());
        }
        let front = Sym::constant(form.content()).sqrt();
        let (numerator, denominator) = (form.primitive_numerator(), form.primitive_denominator());
        let leaf = denominator * Sym::from_node(Node::Root(numerator / denominator));
        self.found.insert(leaf);
        self.rules.push(Rule { lead: leaf, power: 2, tail: numerator * denominator });
        self.visit(&[front, numerator, denominator])?;
        self.alias(each, if denominator.is_one() { front * leaf } else { front * (leaf / denominator) });
        Ok(())
    }
}
