//! Angles that occur only in sines and cosines: a range of one turn contains all their values.

use super::Unknown;
use algebra::boxes::Zero;
use field::Interval;
use std::collections::HashSet;
use std::f64::consts::PI;
use symbolic::{Node, Sym};

/// Whether an expression is 2 pi periodic in an angle: the angle occurs only in sines and cosines, with integer factors.
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

/// The multiple of 2 pi whose addition brings an angle into the interval from -pi to pi.
pub(super) fn turns_to_zero(angle: f64) -> f64 {
    let turns = (angle / (2.0 * PI)).round() * -2.0 * PI;
    // -pi becomes pi
    if angle + turns < -PI + 1e-9 { turns + 2.0 * PI } else { turns }
}

/// Whether two zeros differ only by whole turns of angles: one of them, after these turns, lies in the box in which the other is unique.
pub(super) fn is_same(unknowns: &[Unknown], known: &Zero, other: &Zero) -> bool {
    let is_same = |(k, (at, alone)): (usize, (&Interval, &Interval))| {
        let turns = match unknowns.get(k) {
            Some(unknown) if unknown.is_circle => ((alone.middle() - at.middle()) / (2.0 * PI)).round() * 2.0 * PI,
            _ => 0.0,
        };
        (*at + Interval::new(turns.next_down(), turns.next_up())).is_part_of(*alone)
    };
    other.enclosure.iter().zip(&known.alone).enumerate().all(is_same)
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
