//! Recombination of sines and cosines that were expanded by the addition theorems:
//!
//!   cos a cos b - sin a sin b = cos (a + b) ,   sin a cos b + cos a sin b = sin (a + b) .
//!
//! Proofs and runs use the expanded products. The recombined form is for interval arithmetic: an interval enclosure is narrower if a sum of angles
//! occurs once. Polynomials are brought to normal form first, which cancels a rotation followed by its inverse.

use crate::Sym;
use crate::analytic::linear_terms;
use crate::graph::Node;
use crate::prove::{Hypotheses, normal};
use field::{Circle, Rational};
use num_traits::Zero;
use rustc_hash::FxHashMap;

/// Sums with more terms are not recombined.
const MOST_TERMS: usize = 48;

/// Expressions with more operations are not brought to normal form.
const MOST_OPERATIONS: usize = 2_000;

/// Returns the expressions with sines and cosines of sums of angles recombined wherever the products of an addition theorem occur in one sum.
/// The values are unchanged where the given expressions are defined.
pub fn with_sums_of_angles(expressions: &[Sym]) -> Vec<Sym> {
    let written: Vec<Sym> = expressions.iter().map(|each| written_out(*each)).collect();
    rewritten(&written, FxHashMap::default(), |node, made| match node {
        Node::Sum(..) | Node::Difference(..) => put_together(made),
        _ => made,
    })
}

/// Brings polynomials in symbols, cosines and sines to normal form, also those inside roots, functions and quotients.
fn written_out(expression: Sym) -> Sym {
    let is_closed = |node: Node| match node {
        Node::Root(_) | Node::Elementary(..) | Node::Function(..) => true,
        Node::Quotient(_, below) => below.as_constant().is_none(),
        _ => false,
    };
    let parts = Sym::reached(&[expression], |_, node| !is_closed(node) && !node.is_leaf());
    if parts.len() > MOST_OPERATIONS {
        return expression;
    }
    let closed: Vec<Sym> = parts.into_iter().filter(|each| is_closed(each.node())).collect();
    // these names contain a space, which no name of a system does
    let letters: Vec<Sym> = (0..closed.len()).map(|k| Sym::symbol(&format!("closed {k}"))).collect();
    let hidden: Vec<(Sym, Sym)> = closed.iter().copied().zip(letters.iter().copied()).collect();
    let Ok(form) = normal(expression.substitute(&hidden), &Hypotheses::none()) else { return expression };
    let inside = closed.iter().map(|each| each.node().rebuild(*each, |part| written_out(*part)));
    form.to_sym().substitute(&letters.into_iter().zip(inside).collect::<Vec<_>>())
}

/// Substitutes like [`substitute_all`](crate::substitute_all), but leaves sines and cosines of new sums unexpanded: cos (a - b) stays.
pub fn substitute_in_angles(expressions: &[Sym], replacements: &[(Sym, Sym)]) -> Vec<Sym> {
    rewritten(expressions, replacements.iter().rev().copied().collect(), |_, made| made)
}

fn rewritten(expressions: &[Sym], mut new: FxHashMap<Sym, Sym>, last: impl Fn(Node, Sym) -> Sym) -> Vec<Sym> {
    for each in Sym::ascending(expressions) {
        if !new.contains_key(&each) {
            let node = each.node();
            let made = match node {
                Node::Cos(a) => point(new[&a]).cos,
                Node::Sin(a) => point(new[&a]).sin,
                _ => node.rebuild(each, |a| new[a]),
            };
            new.insert(each, last(node, made));
        }
    }
    expressions.iter().map(|each| new[each]).collect()
}

/// Returns (cos, sin) of an angle, unexpanded, with its terms collected and their order normalised.
fn point(angle: Sym) -> Circle<Sym> {
    let mut terms = linear_terms(angle);
    terms.sort_unstable_by_key(|(term, _)| *term);
    let is_turned_back = terms.first().is_some_and(|(_, factor)| factor.sign() == Some(-1));
    let sum = terms.into_iter().fold(Sym::ZERO, |sum, (term, factor)| {
        sum + Sym::constant(if is_turned_back { -factor } else { factor }) * term
    });
    if sum == Sym::ZERO {
        return Circle { cos: Sym::ONE, sin: Sym::ZERO };
    }
    let Circle { cos, sin } = sum.circle_as_written();
    Circle { cos, sin: if is_turned_back { -sin } else { sin } }
}

/// Combines pairs of terms by the addition theorems until no pair is left.
fn put_together(sum: Sym) -> Sym {
    let mut terms = linear_terms(sum);
    if terms.len() > MOST_TERMS {
        return sum;
    }
    let mut gains = false;
    while let Some((i, j, one)) = pair(&terms) {
        gains = true;
        terms.remove(j);
        terms.remove(i);
        match terms.iter_mut().find(|(known, _)| *known == one.0) {
            Some((_, factor)) => *factor += one.1,
            None => terms.push(one),
        }
        terms.retain(|(_, factor)| !factor.is_zero());
    }
    if !gains {
        return sum;
    }
    terms.into_iter().fold(Sym::ZERO, |sum, (term, factor)| sum + Sym::constant(factor) * term)
}

/// Finds two terms that an addition theorem combines. Returns their indices (i < j) and the term that replaces them, with its coefficient.
fn pair(terms: &[(Sym, Rational)]) -> Option<(usize, usize, (Sym, Rational))> {
    let factors: Vec<(Vec<Sym>, Rational)> = terms.iter().map(|&(term, factor)| factors(term, factor)).collect();
    (0..terms.len()).find_map(|j| {
        (0..j).find_map(|i| {
            let (first, second) = (factors[i].1, factors[j].1);
            let is_same = first == second;
            if !is_same && first != -second {
                return None;
            }
            let (common, [one, other]) = parted(&factors[i].0, &factors[j].0)?;
            // the sign of the result is that of the term with two cosines, or with the cosine of the second angle
            let (angles, of_cosine) = turned(one, other)?;
            let ([a, b], swapped) = angles;
            let first = if swapped { second } else { first };
            let angle = if is_same == of_cosine { a - b } else { a + b };
            let Circle { cos, sin } = point(angle);
            let whole = common.into_iter().fold(if of_cosine { cos } else { sin }, |product, factor| product * factor);
            let whole = linear_terms(whole);
            match &whole[..] {
                [(term, factor)] => Some((i, j, (*term, first * *factor))),
                _ => None,
            }
        })
    })
}

/// Splits a product into its factors and its numerical factor.
fn factors(term: Sym, mut number: Rational) -> (Vec<Sym>, Rational) {
    let (mut open, mut found) = (vec![term], Vec::new());
    while let Some(next) = open.pop() {
        match next.node() {
            Node::Product(a, b) => open.extend([a, b]),
            Node::Negation(a) => {
                number = -number;
                open.push(a);
            }
            _ => match next.as_constant() {
                Some(value) => number *= value,
                None => found.push(next),
            },
        }
    }
    (found, number)
}

/// Splits two products into their common factors and two remaining factors each; `None` if other numbers of factors remain.
fn parted(one: &[Sym], other: &[Sym]) -> Option<(Vec<Sym>, [[Sym; 2]; 2])> {
    let (mut common, mut own, mut left) = (Vec::new(), Vec::new(), other.to_vec());
    for factor in one {
        match left.iter().position(|known| known == factor) {
            Some(at) => common.push(left.swap_remove(at)),
            None => own.push(*factor),
        }
    }
    Some((common, [own.try_into().ok()?, left.try_into().ok()?]))
}

/// Recognises the two products of an addition theorem. Returns the two angles, whether the second product is the first of the theorem, and whether the theorem
/// is that of the cosine.
fn turned(one: [Sym; 2], other: [Sym; 2]) -> Option<(([Sym; 2], bool), bool)> {
    let cosine = |of: Sym| if let Node::Cos(a) = of.node() { Some(a) } else { None };
    let sine = |of: Sym| if let Node::Sin(a) = of.node() { Some(a) } else { None };
    let both = |of: [Sym; 2], is: &dyn Fn(Sym) -> Option<Sym>| Some([is(of[0])?, is(of[1])?]);
    let alike = |a: [Sym; 2], b: [Sym; 2]| a == b || a == [b[1], b[0]];
    for (first, second, swapped) in [(one, other, false), (other, one, true)] {
        if let (Some(a), Some(b)) = (both(first, &cosine), both(second, &sine))
            && alike(a, b)
        {
            return Some(((a, swapped), true));
        }
    }
    let mixed = |of: [Sym; 2]| match (sine(of[0]), cosine(of[1])) {
        (Some(a), Some(b)) => Some([a, b]),
        _ => Some([sine(of[1])?, cosine(of[0])?]),
    };
    let ([a, b], [c, d]) = (mixed(one)?, mixed(other)?);
    (a == d && b == c).then_some((([a, b], false), false))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbols;
    use field::Analytic;

    #[test]
    fn expanded_circle_points_of_sums_are_put_together_with_what_they_are_multiplied_by() {
        let [a, b, c, l] = symbols(["a", "b", "c", "l"]);
        let sum = a + b - c;
        let Circle { cos, sin } = sum.circle();
        let found = with_sums_of_angles(&[l * cos + a, a - l * sin, (a - b).circle().sin, (b - a).circle().cos]);
        let [turned, back] = [point(sum), point(a - b)];
        let told: Vec<String> = found.iter().map(Sym::to_string).collect();
        assert!(told[0].contains(&turned.cos.to_string()) && told[1].contains(&turned.sin.to_string()), "{told:?}");
        assert_eq!(found[2..], [back.sin, back.cos]);
        for (expanded, found) in [l * cos + a, a - l * sin].into_iter().zip(found) {
            let value = |of: Sym| {
                let number = |name: &str| {
                    Some(match name {
                        "a" => 0.3,
                        "b" => 1.1,
                        "c" => -0.7,
                        _ => 2.5,
                    })
                };
                of.evaluate_analytic::<f64>(&number).expect("it has a value")
            };
            assert!((value(expanded) - value(found)).abs() < 1e-14, "{expanded} {found}");
        }
    }

    #[test]
    fn turns_there_and_back_are_gone() {
        let [a, b, l] = symbols(["a", "b", "l"]);
        let Circle { cos, sin } = a.circle();
        // a length along a turned axis, in the turned frame and back
        let (x, y) = ((a + b).circle().cos * l, (a + b).circle().sin * l);
        let (own, across) = (cos * x + sin * y, cos * y - sin * x);
        let back = (cos * own - sin * across).sqrt() / (l + sin * own + cos * across);
        let sum = (a + b).circle_as_written();
        assert_eq!(with_sums_of_angles(&[back])[0], (sum.cos * l).sqrt() / (sum.sin * l + l));
    }

    #[test]
    fn letters_for_sums_leave_no_products() {
        let [a, b, p, q] = symbols(["a", "b", "p", "q"]);
        let rows = with_sums_of_angles(&[(a + b).circle().cos + a.circle().sin]);
        let found = substitute_in_angles(&rows, &[(a, p), (b, q - p)]);
        assert_eq!(found[0], q.circle().cos + p.circle().sin);
    }
}
