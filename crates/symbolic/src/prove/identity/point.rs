//! Values at a random point of a field.

use super::MOST_IN_VAIN;
use super::prime_field::{Field, Random};
use crate::Sym;
use crate::graph::{Name, Node};
use field::Elementary;
use rustc_hash::FxHashMap;

/// The values at a random point; none where a denominator vanishes. Roots have these signs, one bit each, or are taken as functions.
pub(super) fn values(
    nodes: &[Sym],
    field: &Field,
    random: &mut Random,
    signs: Option<u32>,
) -> Option<FxHashMap<Sym, u64>> {
    let mut roots = 0;
    let mut values: FxHashMap<Sym, u64> = FxHashMap::default();
    let mut circle: FxHashMap<u64, (u64, u64)> = FxHashMap::default();
    let mut functions: FxHashMap<(Opaque, u64, u64), u64> = FxHashMap::default();
    for &each in nodes {
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
        let of = |a: &Sym| values[a];
        let value = match each.node() {
            Node::Constant(_) => field.reduced(each.as_constant()?)?,
            Node::Root(a) if signs.is_some() => {
                let root = field.root(of(&a))?;
                let is_other = signs.is_some_and(|signs| signs >> roots & 1 == 1);
                roots += 1;
                if is_other { field.minus(0, root) } else { root }
            }
            Node::Symbol(_) => random.below(field.0),
            Node::Root(a) => *functions.entry((Opaque::Root, of(&a), 0)).or_insert_with(|| random.below(field.0)),
            Node::Elementary(which, a, b) => {
                let key = (Opaque::Elementary(which), of(&a), of(&b));
                *functions.entry(key).or_insert_with(|| random.below(field.0))
            }
            Node::Function(name, order, a) => {
                let key = (Opaque::Named(name, order), of(&a), 0);
                *functions.entry(key).or_insert_with(|| random.below(field.0))
            }
            Node::Sum(a, b) => field.plus(of(&a), of(&b)),
            Node::Difference(a, b) => field.minus(of(&a), of(&b)),
            Node::Product(a, b) => field.times(of(&a), of(&b)),
            Node::Quotient(a, b) => field.times(of(&a), field.inverse(of(&b))?),
            Node::Negation(a) => field.minus(0, of(&a)),
            Node::Power(a, n) => field.power(of(&a), n.into()),
            Node::Cos(a) => point(of(&a), random)?.0,
            Node::Sin(a) => point(of(&a), random)?.1,
        };
        values.insert(each, value);
    }
    Some(values)
}

/// A function whose values are taken for independent of its argument.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Opaque {
    Root,
    Elementary(Elementary),
    Named(Name, u32),
}

/// Whether no sum of angles by whole numbers vanishes: their values at as many random points make a matrix of full rank.
pub(super) fn angles_are_independent(nodes: &[Sym], random: &mut Random) -> bool {
    let mut angles: Vec<Sym> = Vec::new();
    for each in nodes {
        if let Node::Cos(angle) | Node::Sin(angle) = each.node()
            && !angles.contains(&angle)
        {
            angles.push(angle);
        }
    }
    if angles.len() < 2 {
        return true;
    }
    let inside = Sym::ascending(&angles);
    let field = Field(random.prime(false));
    let mut distinct: Vec<Sym> = Vec::new();
    let mut rows: Vec<Vec<u64>> = Vec::new();
    let mut in_vain = 0;
    while rows.len() < angles.len() && in_vain < MOST_IN_VAIN {
        let Some(values) = values(&inside, &field, random, None) else {
            in_vain += 1;
            continue;
        };
        if rows.is_empty() {
            // those that are the same are one
            let mut known = Vec::new();
            for &angle in &angles {
                if !known.contains(&values[&angle]) {
                    known.push(values[&angle]);
                    distinct.push(angle);
                }
            }
        }
        rows.push(distinct.iter().map(|angle| values[angle]).collect());
        rows.truncate(distinct.len());
        if rows.len() == distinct.len() {
            break;
        }
    }
    rows.len() == distinct.len() && field.has_full_rank(rows)
}
