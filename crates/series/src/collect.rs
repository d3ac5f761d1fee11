//! Collection of products by a common factor.

use super::form::{Atom, Form};
use rustc_hash::{FxHashMap, FxHashSet};
use symbolic::{Node, Sym};

/// The smallest number of products with a common factor that are collected.
const WORTH: usize = 3;

/// The number of uses of each product of two quantities.
pub(super) type Uses = FxHashMap<(Atom, Atom), u32>;

/// The factor that occurs in the most products without other uses, and the sum of its partners: x_f times (sum c_i
/// x_i).
pub(super) fn common_factor(form: &Form, uses: &Uses) -> Option<(Atom, Form)> {
    let own = |pair: &(Atom, Atom)| uses.get(pair).is_some_and(|&count| count == 1);
    let pairs: Vec<(Atom, Atom)> = form.products.keys().copied().filter(own).collect();
    let mut counts: FxHashMap<Atom, usize> = FxHashMap::default();
    for &(a, b) in &pairs {
        *counts.entry(a).or_default() += 1;
        if b != a {
            *counts.entry(b).or_default() += 1;
        }
    }
    // ties are resolved by index: the choice does not depend on hashing
    let (factor, _) = counts.into_iter().max_by_key(|&(atom, count)| (count, std::cmp::Reverse(atom)))?;
    let mut sum = Form::default();
    for &(a, b) in pairs.iter().filter(|&&(a, b)| a == factor || b == factor) {
        let partner = if a == factor { b } else { a };
        sum.add_atom(partner, form.products[&(a, b)].0);
    }
    (sum.linear.len() >= WORTH).then_some((factor, sum))
}

/// The sums that are not part of a single larger sum only.
pub(super) fn whole_sums(order: &[Sym], outputs: &[Sym]) -> FxHashSet<Sym> {
    let outputs: FxHashSet<Sym> = outputs.iter().copied().collect();
    let is_sum = |each: Sym| matches!(each.node(), Node::Sum(..) | Node::Difference(..));
    let mut parents: FxHashMap<Sym, u32> = FxHashMap::default();
    let mut in_sums: FxHashMap<Sym, u32> = FxHashMap::default();
    for &each in order {
        for child in each.node().children() {
            *parents.entry(child).or_default() += 1;
            if is_sum(each) || matches!(each.node(), Node::Negation(_)) {
                *in_sums.entry(child).or_default() += 1;
            }
        }
    }
    let partial = |each: Sym| parents.get(&each) == Some(&1) && in_sums.get(&each) == Some(&1);
    order.iter().copied().filter(|&each| is_sum(each) && (outputs.contains(&each) || !partial(each))).collect()
}

/// The expressions that are part of a single larger expression only, and no outputs.
pub(super) fn parts_of_one(order: &[Sym], outputs: &[Sym]) -> FxHashSet<Sym> {
    let mut parents: FxHashMap<Sym, u32> = FxHashMap::default();
    // an output is needed besides the expression of which it is a part
    let needed =
        order.iter().flat_map(|each| each.node().children()).chain(outputs.iter().flat_map(|&each| [each, each]));
    needed.for_each(|part| *parents.entry(part).or_default() += 1);
    let is_read =
        |each: &Sym| !matches!(each.node(), Node::Symbol(_) | Node::Cos(_) | Node::Sin(_) | Node::Elementary(..));
    let once = parents.into_iter().filter(|(each, count)| *count == 1 && is_read(each));
    once.map(|(each, _)| each).collect()
}
