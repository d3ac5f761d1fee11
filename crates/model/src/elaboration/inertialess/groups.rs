//! Groups of coupled coordinates without inertia, whose speeds are determined together.

use crate::Trace;
use field::Rational;
use symbolic::Sym;

/// Returns the group number of each coordinate. Coordinates are coupled by constraints, by speeds in their laws, or, in a law without speeds, by
/// positions.
pub(super) fn groups(trace: &Trace<'_>, laws: &[Sym], open: &[usize], rows: &[Vec<Rational>]) -> Vec<usize> {
    let mut groups: Vec<usize> = (0..open.len()).collect();
    let mut join = |members: Vec<usize>| {
        let Some(&first) = members.first() else { return };
        let joined: Vec<usize> = members.iter().map(|&member| groups[member]).collect();
        let into = groups[first];
        groups.iter_mut().filter(|group| joined.contains(group)).for_each(|group| *group = into);
    };
    for row in rows {
        join((0..open.len()).filter(|&column| row[column].sign() != Some(0)).collect());
    }
    for (own, law) in laws.iter().enumerate() {
        let held = law.symbols_of();
        let holds = |letters: &[Sym]| (0..open.len()).filter(|&k| held.contains(&letters[open[k]])).collect::<Vec<_>>();
        let by_speeds = holds(&trace.speeds);
        let others = if by_speeds.is_empty() { holds(&trace.coordinates) } else { by_speeds };
        join([vec![own], others].concat());
    }
    groups
}
