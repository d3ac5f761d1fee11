//! Blocks of directions for directional derivatives, and the operations that are nonzero in them.

use super::sums::Sums;
use std::ops::Range;

/// The number of directions in a block.
pub(super) const LANES: usize = 16;

/// A block of directions.
#[derive(Debug)]
pub(super) struct Block {
    /// The inputs with respect to which the block differentiates.
    pub inputs: Range<usize>,
    /// The sums between inputs and outputs that depend on these inputs.
    pub moved: Vec<Range<u32>>,
    /// The outputs that depend on these inputs.
    pub outputs: Vec<Range<u32>>,
    /// The locations that the previous block has filled and this one does not.
    pub stale: Vec<Range<u32>>,
}

/// The blocks of all inputs but the last, in cyclic order, and a block of the last input alone.
pub(super) fn blocks(sums: &Sums) -> Vec<Block> {
    let (inputs, first_output) = (sums.inputs, sums.count() - sums.outputs);
    let states = inputs.saturating_sub(1);
    let of_state = (0..states).step_by(LANES).map(|first| first..(first + LANES).min(states));
    let parts: Vec<Range<usize>> = of_state.chain(std::iter::once(states..inputs)).collect();
    let depends: Vec<Vec<bool>> = parts.iter().map(|part| dependence(sums, part)).collect();
    let of_states = parts.len() - 1;
    let block = |(place, part): (usize, Range<usize>)| {
        let own = &depends[place];
        let is_moved = |sum: usize| own[inputs + sum];
        let stale = match place < of_states {
            true => {
                let before = &depends[(place + of_states - 1) % of_states];
                ranges(inputs..inputs + first_output, |place| before[place] && !own[place])
            }
            false => Vec::new(),
        };
        Block {
            moved: ranges(0..first_output, is_moved),
            outputs: ranges(first_output..sums.count(), is_moved),
            stale,
            inputs: part,
        }
    };
    parts.iter().cloned().enumerate().map(block).collect()
}

/// For each location, whether it depends on the given inputs.
fn dependence(sums: &Sums, part: &Range<usize>) -> Vec<bool> {
    let mut depends: Vec<bool> = (0..sums.inputs).map(|input| part.contains(&input)).collect();
    for sum in 0..sums.count() {
        depends.push(sums.sources(sum).iter().any(|&source| depends[source as usize]));
    }
    depends
}

/// The ranges of indices for which a predicate is true.
fn ranges(of: Range<usize>, holds: impl Fn(usize) -> bool) -> Vec<Range<u32>> {
    let mut all: Vec<Range<u32>> = Vec::new();
    for place in of.filter(|&place| holds(place)) {
        let place = place as u32;
        match all.last_mut() {
            Some(last) if last.end == place => last.end += 1,
            _ => all.push(place..place + 1),
        }
    }
    all
}
