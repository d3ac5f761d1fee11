//! Evaluation at a random point of a prime field.

use super::MOST_IN_VAIN;
use super::prime_field::{Field, Random};
use super::program::{Part, Program};
use crate::Sym;
use crate::graph::{Name, Node};
use field::Elementary;
use rustc_hash::{FxHashMap, FxHashSet};

/// Evaluates all parts of a program at a random point; `None` if a denominator vanishes or a root does not exist. Bit k of `signs` selects the sign of
/// the k-th root; without `signs`, roots count as functions.
pub(super) fn values(program: &Program, field: &Field, random: &mut Random, signs: Option<u32>) -> Option<Vec<u64>> {
    let mut roots: FxHashMap<u64, u64> = FxHashMap::default();
    let mut values: Vec<u64> = Vec::with_capacity(program.parts.len());
    let mut circle: FxHashMap<u64, (u64, u64)> = FxHashMap::default();
    let mut functions: FxHashMap<(Opaque, u64, u64), u64> = FxHashMap::default();
    for &Part { is, node, arguments } in &program.parts {
        let mut point = |angle: u64, random: &mut Random| -> Option<(u64, u64)> {
            if let Some(&known) = circle.get(&angle) {
                return Some(known);
            }
            let t = random.below(field.0);
            let square = field.times(t, t);
            let inverse = field.inverse(field.plus(1, square))?;
            let found = (field.times(field.minus(1, square), inverse), field.times(field.plus(t, t), inverse));
            circle.insert(angle, found);
            Some(found)
        };
        let [a, b] = arguments.map(|place| values.get(place).copied().unwrap_or(0));
        let value = match node {
            Node::Constant(_) => field.reduced(is.as_constant()?)?,
            Node::Symbol(_) => random.below(field.0),
            Node::Root(_) => match (signs, roots.get(&a)) {
                (None, _) => *functions.entry((Opaque::Root, a, 0)).or_insert_with(|| random.below(field.0)),
                (Some(_), Some(&known)) => known,
                (Some(signs), None) => {
                    let root = field.root(a)?;
                    let is_other = signs >> roots.len() & 1 == 1;
                    let root = if is_other { field.minus(0, root) } else { root };
                    roots.insert(a, root);
                    root
                }
            },
            Node::Elementary(which, ..) => {
                let key = (Opaque::Elementary(which), a, b);
                *functions.entry(key).or_insert_with(|| random.below(field.0))
            }
            Node::Function(name, order, _) => {
                let key = (Opaque::Named(name, order), a, 0);
                *functions.entry(key).or_insert_with(|| random.below(field.0))
            }
            Node::Sum(..) => field.plus(a, b),
            Node::Difference(..) => field.minus(a, b),
            Node::Product(..) => field.times(a, b),
            Node::Quotient(..) => field.times(a, field.inverse(b)?),
            Node::Negation(_) => field.minus(0, a),
            Node::Power(_, n) => field.power(a, n.into()),
            Node::Cos(_) => point(a, random)?.0,
            Node::Sin(_) => point(a, random)?.1,
        };
        values.push(value);
    }
    Some(values)
}

/// Returns the number of roots with different arguments.
pub(super) fn different_roots(program: &Program) -> usize {
    let arguments: Vec<usize> =
        program.parts.iter().filter(|part| matches!(part.node, Node::Root(_))).map(|part| part.arguments[0]).collect();
    if arguments.len() < 2 {
        return arguments.len();
    }
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let drawn = (0..MOST_IN_VAIN).find_map(|_| {
        let field = Field(random.prime(false));
        let drawn = values(program, &field, &mut random, None);
        random.next();
        drawn
    });
    match drawn {
        Some(values) => arguments.iter().map(|&place| values[place]).collect::<FxHashSet<u64>>().len(),
        None => arguments.len(),
    }
}

/// A function whose values count as independent of its argument.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Opaque {
    Root,
    Elementary(Elementary),
    Named(Name, u32),
}

/// Returns whether no integer combination of the angles vanishes: their values at random points form a matrix of full rank.
pub(super) fn angles_are_independent(program: &Program, random: &mut Random) -> bool {
    let mut angles: Vec<Sym> = Vec::new();
    for part in &program.parts {
        if let Node::Cos(angle) | Node::Sin(angle) = part.node
            && !angles.contains(&angle)
        {
            angles.push(angle);
        }
    }
    if angles.len() < 2 {
        return true;
    }
    let inside = Program::of(&angles);
    let field = Field(random.prime(false));
    let mut distinct: Vec<usize> = Vec::new();
    let mut rows: Vec<Vec<u64>> = Vec::new();
    let mut in_vain = 0;
    while rows.len() < angles.len() && in_vain < MOST_IN_VAIN {
        let Some(values) = values(&inside, &field, random, None) else {
            in_vain += 1;
            continue;
        };
        if rows.is_empty() {
            // equal angles count once
            let mut known = Vec::new();
            for &angle in &inside.results {
                if !known.contains(&values[angle]) {
                    known.push(values[angle]);
                    distinct.push(angle);
                }
            }
        }
        rows.push(distinct.iter().map(|&angle| values[angle]).collect());
        rows.truncate(distinct.len());
        if rows.len() == distinct.len() {
            break;
        }
    }
    rows.len() == distinct.len() && field.has_full_rank(rows)
}
