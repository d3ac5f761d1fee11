//! Which outputs stand side by side, and their sums of multiples of monomials.
//!
//! As they come, eight neighbours are stored at once, but rarely have their monomials in common, and a Jacobian's row is half
//! constants. Those that are alike stand side by side instead where that takes less: then each goes to its place by itself, over
//! the constants, which are copied.

use super::monomials::{Known, Monomials};
use super::{Lanes, WIDTH};
use std::collections::{BTreeMap, BTreeSet};

/// A polynomial: exponents and coefficients.
pub(super) type Output = Vec<(Vec<u32>, f64)>;

/// All sums, eight at a time.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    pub all: Vec<Block>,
    /// Of all blocks: the places of the monomials, and their coefficients in each output.
    pub places: Vec<u32>,
    pub factors: Vec<Lanes>,
    /// What every output has where nothing moves; nothing if the eight of a block are neighbours.
    pub constants: Vec<f64>,
}

/// Eight outputs.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Where they go. Of neighbours the first counts: the end of a row may reach into the next, which is written after it.
    pub to: [u32; WIDTH],
    pub constants: Lanes,
    /// Where its terms end.
    pub end: usize,
}

/// A lane that goes nowhere.
const NOWHERE: u32 = u32::MAX;

impl Blocks {
    /// Of outputs in rows of equal length.
    pub fn of(outputs: &[Output], columns: usize, monomials: &Monomials) -> Self {
        let numbers: Vec<usize> = (0..outputs.len()).collect();
        let rows = numbers.chunks(columns.max(1));
        let neighbours = rows.flat_map(|row| row.chunks(WIDTH).map(<[usize]>::to_vec)).collect();
        let neighbours = Self::gathered(outputs, neighbours, monomials);
        if neighbours.all.len() < 2 {
            return neighbours;
        }
        let mut alike = Self::gathered(outputs, alike(outputs, monomials), monomials);
        alike.constants = outputs.iter().map(|output| monomials.constant(output)).collect();
        if alike.cost() < neighbours.cost() { alike } else { neighbours }
    }

    fn gathered(outputs: &[Output], eights: Vec<Vec<usize>>, monomials: &Monomials) -> Self {
        let mut blocks = Blocks { all: Vec::new(), places: Vec::new(), factors: Vec::new(), constants: Vec::new() };
        for eight in eights {
            let (mut constants, mut to) = (Lanes([0.0; WIDTH]), [NOWHERE; WIDTH]);
            let mut lanes: BTreeMap<Known, Lanes> = BTreeMap::new();
            for (lane, &number) in eight.iter().enumerate() {
                to[lane] = number as u32;
                for (exponents, value) in &outputs[number] {
                    let own = match monomials.place(exponents) {
                        Some(known) => lanes.entry(known).or_insert(Lanes([0.0; WIDTH])),
                        None => &mut constants,
                    };
                    own.0[lane] = *value;
                }
            }
            blocks.places.extend(lanes.keys().map(|known| known.place));
            blocks.factors.extend(lanes.values());
            blocks.all.push(Block { to, constants, end: blocks.places.len() });
        }
        blocks
    }

    /// Whether the eight of a block are neighbours.
    pub fn are_neighbours(&self) -> bool {
        self.constants.is_empty()
    }

    pub fn terms(&self) -> usize {
        self.places.len()
    }

    /// Additions and multiplications, lanes that hold nothing left out.
    pub fn flops(&self) -> usize {
        let filled = |lanes: &Lanes| lanes.0.iter().filter(|value| **value != 0.0).count();
        self.factors.iter().map(|lanes| 2 * filled(lanes)).sum()
    }

    /// In instructions, roughly: of a term four, of a block ten, and two to put a number in its place.
    fn cost(&self) -> usize {
        let alone = if self.are_neighbours() { 0 } else { 2 * WIDTH * self.all.len() + self.constants.len() / 4 };
        4 * self.terms() + 10 * self.all.len() + alone
    }
}

/// What moves, by eights: to the one with most monomials those that bring fewest new ones, the longest of them first.
fn alike(outputs: &[Output], monomials: &Monomials) -> Vec<Vec<usize>> {
    let own = |output: &Output| -> BTreeSet<Known> {
        output.iter().filter_map(|(exponents, _)| monomials.place(exponents)).collect()
    };
    let moving = outputs.iter().map(own).enumerate().filter(|(_, own)| !own.is_empty());
    let mut left: Vec<(usize, BTreeSet<Known>)> = moving.collect();
    left.sort_by_key(|(number, own)| (std::cmp::Reverse(own.len()), *number));
    let mut eights = Vec::new();
    while !left.is_empty() {
        let (first, mut shared) = left.remove(0);
        let mut eight = vec![first];
        while eight.len() < WIDTH {
            let new = |own: &BTreeSet<Known>| own.difference(&shared).count();
            let Some(next) = (0..left.len()).min_by_key(|&place| new(&left[place].1)) else { break };
            let (number, own) = left.remove(next);
            shared.extend(own);
            eight.push(number);
        }
        eights.push(eight);
    }
    eights
}
