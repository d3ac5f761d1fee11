//! Angles that occur as points of a circle alone: a whole turn holds everything.

use std::collections::HashSet;
use symbolic::{Node, Sym};

/// Whether an expression is the same after a whole turn of an angle: it occurs in cosines and sines of whole multiples alone.
pub(super) fn is_periodic(expression: Sym, angle: Sym) -> bool {
    let mut open: HashSet<Sym> = HashSet::from([angle]);
    for each in Sym::ascending(&[expression]) {
        let is_closed = |a: Sym| {
            let terms = a.linear_terms();
            terms.iter().all(|(term, factor)| match *term == angle {
                true => factor.to_big().is_some_and(|factor| factor.denominator().is_one()),
                false => !term.symbols_of().contains(&angle),
            })
        };
        let is_open = match each.node() {
            Node::Cos(a) | Node::Sin(a) => open.contains(&a) && !is_closed(a),
            node => node.children().any(|child| open.contains(&child)),
        };
        if is_open {
            open.insert(each);
        }
    }
    !open.contains(&expression)
}

#[cfg(test)]
mod tests {
    use super::is_periodic;
    use field::{Analytic, Scalar};
    use symbolic::symbols;

    #[test]
    fn angles_in_points_of_a_circle_are_periodic_and_turned_springs_are_not() {
        let [a, b, k] = symbols(["a", "b", "k"]);
        assert!(is_periodic((a + b).circle().cos * k + a.circle().sin, a));
        assert!(is_periodic((a + a - b).circle().sin, a));
        assert!(is_periodic(b * k, a));
        assert!(!is_periodic(k * a + a.circle().cos, a));
        assert!(!is_periodic(a.half().circle().cos, a));
        assert!(!is_periodic((a * b).circle().cos, a));
    }
}
