//! Distribution of the forces that keep dependent conditions at zero among their switches.
//!
//! The motion of a block that sticks between two walls does not determine the friction of each wall: with more held conditions than
//! speeds g' = a + B s = 0 has many solutions s, all with equal motion. The solution with the least sum of (s - 1/2)^2 is chosen, thus
//! with the least sum of squares of `sign`: s = 1/2 + B^T l, limited to 0 and 1. It is unique and continuous in a.

use super::super::jet::Jet;
use super::super::mode::Case;
use super::{Expansions, solved};
use num_traits::Zero;

/// Derivatives of the rates of conditions (rows) by switches (columns).
pub(in super::super) type Slopes<const N: usize> = Vec<Vec<Jet<N>>>;

impl Expansions {
    /// The derivatives of the rates of conditions by switches, including the effect of the reactions `reactions`, which depend on the
    /// switches.
    pub(super) fn slopes_of<const N: usize>(
        &self,
        cases: usize,
        values: &[Jet<N>],
        tied: &[Option<[Jet<N>; 2]>],
        reactions: &[usize],
    ) -> Option<Slopes<N>> {
        let switches: Vec<usize> = (0..cases).collect();
        let mut slopes = self.slopes_by(values, tied, &switches, &switches);
        if reactions.is_empty() || cases == 0 {
            return Some(slopes);
        }
        let moved = self.slopes_by(values, tied, reactions, &switches);
        let back = self.slopes_by(values, tied, &switches, reactions);
        let rates: Vec<usize> = reactions.iter().map(|letter| self.letters() + letter).collect();
        let moved_rates = self.slopes_by(values, tied, &rates, &switches);
        for switch in 0..cases {
            let right = |row: usize| [-moved[row][switch], -moved_rates[row][switch]];
            let changes = self.solved_for((values, tied), reactions, right)?.0;
            for (row, back) in slopes.iter_mut().zip(&back) {
                let through = back.iter().zip(&changes).map(|(slope, change)| *slope * *change);
                row[switch] = through.fold(row[switch], |sum, term| sum + term);
            }
        }
        Some(slopes)
    }

    /// The switches of the least-squares distribution, from switches that keep the held conditions at zero with 1/2 for each shared
    /// switch.
    pub(super) fn shared<const N: usize>(
        &self,
        mode: &[Case],
        slopes: &Slopes<N>,
        switches: &[Jet<N>],
    ) -> Option<Vec<Jet<N>>> {
        let mut parts = switches.to_vec();
        let own = |switch: &usize| self.mirrored[*switch].is_none();
        let of = |wanted: fn(Case) -> bool| (0..mode.len()).filter(own).filter(move |&switch| wanted(mode[switch]));
        let implied: Vec<usize> = of(|case| matches!(case, Case::Shared | Case::Spent { .. })).collect();
        if implied.is_empty() {
            return Some(parts);
        }
        let held: Vec<usize> = of(|case| case == Case::Held).collect();
        let free: Vec<usize> = of(|case| matches!(case, Case::Held | Case::Shared)).collect();
        let half = Jet::constant(0.5, 0.0);
        let sum = |terms: &mut dyn Iterator<Item = Jet<N>>| terms.fold(Jet::zero(), |sum, term| sum + term);
        let gram = |a: usize, b: usize| sum(&mut free.iter().map(|&switch| slopes[a][switch] * slopes[b][switch]));
        let rows = held.iter().map(|&a| held.iter().map(|&b| gram(a, b)).collect()).collect();
        let needed = |a: usize| sum(&mut free.iter().map(|&switch| slopes[a][switch] * (switches[switch] - half)));
        let right = held.iter().map(|&a| needed(a)).collect();
        let factors = solved(rows, right)?;
        for &switch in free.iter().chain(&implied) {
            let pull = |(&row, factor): (&usize, &Jet<N>)| slopes[row][switch] * *factor;
            parts[switch] = half + sum(&mut held.iter().zip(&factors).map(pull));
        }
        Some(parts)
    }
}
