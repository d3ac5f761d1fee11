//! Elimination of intermediate quantities with at most one source or at most one reader: each is substituted into its readers. This reduces the number of
//! sums without increasing their total length. Products of weights are then computed once for all directions.

use super::{Differential, Weighted};
use crate::Sym;
use std::collections::VecDeque;

/// The sums, and for each quantity the sums that contain it (its readers).
pub(super) struct Graph {
    inputs: usize,
    outputs: usize,
    /// The sum of each quantity by index; empty for inputs and for eliminated quantities.
    sums: Vec<Vec<Weighted>>,
    readers: Vec<Vec<usize>>,
}

impl Graph {
    pub fn of(Differential { inputs, sums, outputs }: &Differential) -> Self {
        let places = inputs + sums.len();
        let sums: Vec<Vec<Weighted>> = std::iter::repeat_n(Vec::new(), *inputs).chain(sums.iter().cloned()).collect();
        let mut readers = vec![Vec::new(); places];
        for (place, sum) in sums.iter().enumerate() {
            sum.iter().for_each(|term| readers[term.source].push(place));
        }
        Graph { inputs: *inputs, outputs: *outputs, sums, readers }
    }

    pub fn reduced(mut self) -> Differential {
        let between = self.inputs..self.sums.len() - self.outputs;
        let mut open: VecDeque<usize> = between.clone().collect();
        while let Some(place) = open.pop_front() {
            let (sources, readers) = (self.sums[place].len(), self.readers[place].len());
            if sources > 1 && readers > 1 {
                continue;
            }
            let around: Vec<usize> =
                self.sums[place].iter().map(|term| term.source).chain(self.readers[place].iter().copied()).collect();
            self.eliminate(place);
            open.extend(around.into_iter().filter(|place| between.contains(place)));
        }
        self.finish()
    }

    /// Substitutes a quantity into its readers.
    fn eliminate(&mut self, place: usize) {
        let own = std::mem::take(&mut self.sums[place]);
        own.iter().for_each(|term| self.readers[term.source].retain(|reader| *reader != place));
        for reader in std::mem::take(&mut self.readers[place]) {
            let at = self.sums[reader].iter().position(|term| term.source == place);
            let Some(at) = at else { continue };
            let Weighted { weight, .. } = self.sums[reader].remove(at);
            for term in &own {
                self.add(reader, Weighted { source: term.source, weight: weight * term.weight });
            }
        }
    }

    fn add(&mut self, reader: usize, term: Weighted) {
        match self.sums[reader].iter_mut().find(|known| known.source == term.source) {
            Some(known) => known.weight += term.weight,
            None => {
                self.sums[reader].push(term);
                self.readers[term.source].push(reader);
            }
        }
    }

    /// Returns the remaining sums, renumbered without gaps.
    fn finish(self) -> Differential {
        let first_output = self.sums.len() - self.outputs;
        let mut places = vec![0; self.sums.len()];
        let mut sums: Vec<Vec<Weighted>> = Vec::new();
        for (place, mut sum) in self.sums.into_iter().enumerate() {
            if place < self.inputs {
                places[place] = place;
            } else if place >= first_output || !sum.is_empty() {
                sum.retain(|term| term.weight != Sym::ZERO);
                sum.iter_mut().for_each(|term| term.source = places[term.source]);
                sum.sort_by_key(|term| term.source);
                places[place] = self.inputs + sums.len();
                sums.push(sum);
            }
        }
        Differential { inputs: self.inputs, sums, outputs: self.outputs }
    }
}
