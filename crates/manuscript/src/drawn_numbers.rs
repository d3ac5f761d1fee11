//! Trial points: small rational numbers for letters, and rational points of the circle for angles.

use crate::half_turn::is_half_turn;
use crate::refutation::Refutation;
use claims::Condition;
use field::Rational;
use symbolic::{Node, Sym};

/// A generator of trial points in a fixed order.
pub(crate) struct Draw<'a> {
    pub leaves: Vec<Sym>,
    /// Letters below square roots, for which squares are also drawn.
    below_roots: Vec<Sym>,
    conditions: &'a [Condition],
}

impl<'a> Draw<'a> {
    /// The generator for the letters of expressions; `None` where one of them depends on others.
    pub fn of(expressions: impl Iterator<Item = Sym>, conditions: &'a [Condition]) -> Option<Self> {
        let (mut leaves, mut below_roots): (Vec<Sym>, Vec<Sym>) = (Vec::new(), Vec::new());
        let mut open: Vec<Sym> = expressions.flat_map(Sym::leaves_of).collect();
        while let Some(leaf) = open.pop() {
            if let Node::Root(inside) = leaf.node() {
                below_roots.extend(inside.leaves_of());
                open.extend(inside.leaves_of());
            } else if !leaves.contains(&leaf) && !is_half_turn(leaf) {
                leaves.push(leaf);
            }
        }
        leaves.reverse();
        let is_plain = |leaf: &Sym| match leaf.node() {
            Node::Symbol(_) => true,
            Node::Cos(angle) | Node::Sin(angle) => angle.symbol_name().is_some() && !leaves.contains(&angle),
            _ => false,
        };
        leaves.iter().all(is_plain).then_some(Draw { leaves, below_roots, conditions })
    }

    /// The first trial point that `completed` can complete and `is_asked` accepts.
    pub fn find(
        &self,
        points: u32,
        completed: impl Fn(Vec<(Sym, Sym)>) -> Option<Vec<(Sym, Sym)>>,
        is_asked: impl Fn(&[(Sym, Sym)]) -> bool,
    ) -> Option<Refutation> {
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            i64::from(state >> 8)
        };
        (0..points).find_map(|attempt| {
            let size = i64::from(2 + attempt / 64);
            let mut point: Vec<(Sym, Sym)> = Vec::new();
            for &leaf in &self.leaves {
                let (draw, below) = (next(), 1 + next() % (1 + size / 4));
                let is_positive = self.conditions.contains(&Condition::Positive(leaf));
                let above = if is_positive { 1 + draw % size } else { draw % (2 * size + 1) - size };
                let number = Rational::new(above, below);
                // a square makes the square root rational
                let is_squared = self.below_roots.contains(&leaf) && attempt % 2 == 1;
                let number = if is_squared { number * number } else { number };
                let (Node::Cos(angle) | Node::Sin(angle)) = leaf.node() else {
                    point.push((leaf, Sym::constant(number)));
                    continue;
                };
                let cos = Sym::from_node(Node::Cos(angle));
                if point.iter().all(|(known, _)| *known != cos) {
                    let (one, two) = (Rational::new(1, 1), Rational::new(2, 1));
                    let norm = one + number * number;
                    point.push((cos, Sym::constant((one - number * number) / norm)));
                    point.push((Sym::from_node(Node::Sin(angle)), Sym::constant(two * number / norm)));
                }
            }
            let point = completed(point).filter(|point| is_asked(point))?;
            Some(Refutation { point, is_formal: false })
        })
    }
}
