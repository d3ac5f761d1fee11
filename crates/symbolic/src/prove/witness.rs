//! Exact points at which an expression does not vanish.

use super::generators::Generators;
use super::hypotheses::Hypotheses;
use super::normal::normal_form;
use crate::Sym;
use crate::analytic::linear_terms;
use crate::graph::{Name, Node};
use field::{Analytic, Elementary, Rational, Scalar};
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;
use std::fmt;

/// A point that satisfies the hypotheses, and the value of the expression there.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// Symbols, cosines and sines, roots and functions with their values: rational numbers, or square roots of these if the hypotheses
    /// allow no rational values.
    pub point: Vec<(Sym, Sym)>,
    /// The value of the expression at the point, different from zero.
    pub value: Sym,
    /// Cosines and sines whose arguments also have a value at the point. As functions they are algebraically independent of their
    /// arguments, which suffices for the refutation; but their values are not those of the printed arguments.
    pub formal: Vec<Sym>,
}

impl fmt::Display for Witness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at ", self.value)?;
        for (place, (leaf, value)) in self.point.iter().enumerate() {
            write!(f, "{}{leaf} = {value}", if place > 0 { ", " } else { "" })?;
        }
        Ok(())
    }
}

/// The number of points tried with rational values only, and the total number including values with roots.
const RATIONAL_POINTS: u32 = 400;
const POINTS: u32 = 600;

/// Searches a point at which the expression is defined and not zero, among small numbers in a fixed order.
pub(super) fn search(expression: Sym, hypotheses: &Hypotheses) -> Option<Witness> {
    let inside = expression.substitute(&hypotheses.given);
    let mut all = vec![inside];
    all.extend(hypotheses.rules.iter().map(|rule| rule.lead));
    let generators = Generators::of(&all, hypotheses).ok()?;
    if !angles_are_free(&generators) {
        return None;
    }
    let target = generators.rewrite(inside);
    (0..POINTS).find_map(|attempt| {
        let numbers = Numbers { state: attempt, attempt };
        let point = Point::at(&generators, hypotheses, numbers, attempt < RATIONAL_POINTS)?;
        point.witness(target, hypotheses, &generators)
    })
}

/// Returns whether the values of all cosines and sines can be chosen freely and all functions have exact values. The cosine of a number, cos 1, has no exact
/// value, and angles that are different multiples of one term depend on each other.
fn angles_are_free(generators: &Generators) -> bool {
    let mut steps: FxHashMap<Sym, Sym> = FxHashMap::default();
    generators.leaves.iter().all(|leaf| match leaf.node() {
        // the value of an elementary function depends on that of its argument
        Node::Elementary(..) => false,
        Node::Cos(angle) | Node::Sin(angle) => linear_terms(angle).into_iter().all(|(term, _)| {
            term != Sym::ONE && !holds_direction(term) && *steps.entry(term).or_insert(angle) == angle
        }),
        _ => true,
    })
}

/// Returns whether an angle contains atan2, whose sine and cosine depend on its arguments.
fn holds_direction(angle: Sym) -> bool {
    Sym::ascending(&[angle]).iter().any(|part| matches!(part.node(), Node::Elementary(Elementary::Atan2, ..)))
}

/// Small numbers in a fixed order, different for every attempt and slowly growing; positive in the first attempts, since most
/// quantities of mechanics are positive.
struct Numbers {
    state: u32,
    attempt: u32,
}

impl Numbers {
    fn next(&mut self) -> Rational {
        self.state = self.state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let draw = i64::from(self.state >> 8);
        let size = i64::from(3 + self.attempt / 8);
        let numerator = 1 + draw % size;
        match self.attempt {
            0..4 => Rational::new(numerator, 1),
            4..8 => Rational::new(numerator, 1 + draw / 64 % 3),
            _ => {
                let sign = draw / 4096 % 8;
                // a value of zero makes many terms vanish, hence zeros are rare
                let numerator = if sign == 0 { 0 } else { numerator * (1 - 2 * (sign % 2)) };
                Rational::new(numerator, 1 + draw / 64 % (1 + size / 2))
            }
        }
    }
}

impl Numbers {
    /// Returns the tangent of half an angle; in the first attempts the angle is acute.
    fn half_tangent(&mut self) -> Rational {
        let number = self.next();
        if self.attempt < 8 { Rational::one() / (Rational::one() + number) } else { number }
    }
}

/// A point: the values of the generators.
struct Point {
    values: FxHashMap<Sym, Sym>,
}

impl Point {
    /// Chooses a point. Free generators get numbers, vectors of length one and angles rational points of the sphere or circle. Every other rule is
    /// solved for its leading generator, which gets the root.
    fn at(generators: &Generators, hypotheses: &Hypotheses, mut numbers: Numbers, rational: bool) -> Option<Self> {
        let mut values: FxHashMap<Sym, Sym> = FxHashMap::default();
        for sphere in &hypotheses.spheres {
            let is_given = |each: &Sym| hypotheses.given.iter().any(|(symbol, _)| symbol == each);
            if sphere.iter().any(|each| values.contains_key(each) || is_given(each)) {
                continue;
            }
            let free: Vec<Rational> = sphere[1..].iter().map(|_| numbers.next()).collect();
            let norm = free.iter().fold(Rational::zero(), |sum, t| sum + *t * *t);
            let first = (norm - Rational::one()) / (norm + Rational::one());
            let others = free.iter().map(|t| Rational::int(2) * *t / (norm + Rational::one()));
            let coordinates = others.chain([first]);
            values.extend(sphere.iter().copied().zip(coordinates.map(Sym::constant)));
        }
        for &leaf in &generators.leaves {
            if let Node::Sin(angle) = leaf.node() {
                let t = numbers.half_tangent();
                let norm = Rational::one() + t * t;
                values.insert(leaf, Sym::constant((t + t) / norm));
                values.insert(Sym::from_node(Node::Cos(angle)), Sym::constant((Rational::one() - t * t) / norm));
            }
        }
        let led = |leaf: &Sym| generators.rules.iter().any(|rule| rule.lead == *leaf);
        for &leaf in &generators.leaves {
            if !values.contains_key(&leaf) && !led(&leaf) {
                // the cosine of an angle whose sine does not occur must lie between -1 and 1
                let bounded = match leaf.node() {
                    Node::Cos(_) => {
                        let t = numbers.half_tangent();
                        (Rational::one() - t * t) / (Rational::one() + t * t)
                    }
                    _ => numbers.next(),
                };
                values.insert(leaf, Sym::constant(bounded));
            }
        }
        let mut point = Point { values };
        for rule in generators.rules.iter().rev().filter(|rule| rule.power <= 2) {
            let tail = point.exact(generators.rewrite(rule.tail), generators)?;
            if let Some(&value) = point.values.get(&rule.lead) {
                let holds = value.powi(rule.power as i32) == tail;
                if holds { continue } else { return None }
            }
            let value = if rule.power == 1 { tail } else { Sym::constant(tail.as_constant()?).sqrt() };
            let value = point.with_sign(rule.lead, value, generators)?;
            let of_number = rule.tail.as_constant().is_some();
            if value == Sym::UNDEFINED || (rational && !of_number && value.as_constant().is_none()) {
                return None;
            }
            point.values.insert(rule.lead, value);
        }
        generators.leaves.iter().all(|leaf| point.values.contains_key(leaf)).then_some(point)
    }

    /// Gives the value of a root its sign: the generator of sqrt(N/D) is D sqrt(N/D), which has the sign of D.
    fn with_sign(&self, lead: Sym, value: Sym, generators: &Generators) -> Option<Sym> {
        match lead.node() {
            Node::Product(denominator, _) => {
                let denominator = self.exact(generators.rewrite(denominator), generators)?.as_constant()?;
                match denominator.sign()? {
                    0 => None,
                    -1 => Some(-value),
                    _ => Some(value),
                }
            }
            _ => Some(value),
        }
    }

    /// Returns the exact value of an expression at the point.
    fn exact(&self, expression: Sym, generators: &Generators) -> Option<Sym> {
        let rational = self.rational(expression, generators);
        if let Some(value) = rational {
            return value.is_defined().then(|| Sym::constant(value));
        }
        let mut new: FxHashMap<Sym, Sym> = FxHashMap::default();
        for each in generators.inside(expression) {
            let value = match self.values.get(&each) {
                Some(&value) => value,
                None => each.node().rebuild(each, |a| new[a]),
            };
            new.insert(each, value);
        }
        Some(normal_form(new[&expression], &Hypotheses::none()).ok()?.to_sym())
    }

    fn rational(&self, expression: Sym, generators: &Generators) -> Option<Rational> {
        let mut values: FxHashMap<Sym, Rational> = FxHashMap::default();
        for each in generators.inside(expression) {
            let of = |a| values[&a];
            let value = match (self.values.get(&each), each.node()) {
                (Some(value), _) => value.as_constant()?,
                (None, Node::Sum(a, b)) => of(a) + of(b),
                (None, Node::Difference(a, b)) => of(a) - of(b),
                (None, Node::Product(a, b)) => of(a) * of(b),
                (None, Node::Quotient(a, b)) => of(a) / of(b),
                (None, Node::Negation(a)) => -of(a),
                (None, Node::Power(a, n)) => num_traits::pow(of(a), n as usize),
                (None, _) => each.as_constant()?,
            };
            values.insert(each, value);
        }
        Some(values[&expression])
    }

    /// Returns whether no function occurs at two arguments that are equal at the point.
    fn functions_are_single_valued(&self, generators: &Generators) -> bool {
        let mut seen: Vec<(Name, u32, Sym)> = Vec::new();
        generators.leaves.iter().all(|leaf| {
            let Node::Function(name, order, argument) = leaf.node() else { return true };
            let known =
                argument.substitute(&self.values.iter().map(|(&leaf, &value)| (leaf, value)).collect::<Vec<_>>());
            let value = normal_form(known, &Hypotheses::none()).map_or(known, |form| form.to_sym());
            let call = (name, order, value);
            let new = !seen.contains(&call);
            seen.push(call);
            new
        })
    }

    fn witness(self, target: Sym, hypotheses: &Hypotheses, generators: &Generators) -> Option<Witness> {
        let value = self.exact(target, generators).filter(|value| !value.is_zero())?;
        if !self.functions_are_single_valued(generators) {
            return None;
        }
        let mut point = Vec::new();
        let mut formal = Vec::new();
        let of_a_number = |leaf: &Sym| matches!(leaf.node(), Node::Root(square) if square.as_constant().is_some());
        for &leaf in generators.leaves.iter().filter(|leaf| !of_a_number(leaf)) {
            point.push((leaf, self.values[&leaf]));
            if let Node::Cos(angle) | Node::Sin(angle) = leaf.node()
                && angle.symbols_of().iter().any(|symbol| generators.index.contains_key(symbol))
            {
                formal.push(leaf);
            }
        }
        for &(symbol, expression) in &hypotheses.given {
            if let Ok(rest) = Generators::of(&[expression], hypotheses)
                && rest.leaves.iter().all(|leaf| generators.index.contains_key(leaf))
            {
                point.push((symbol, self.exact(generators.rewrite(rest.rewrite(expression)), generators)?));
            }
        }
        Some(Witness { point, value, formal })
    }
}
