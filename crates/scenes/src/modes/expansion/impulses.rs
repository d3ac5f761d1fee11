//! Speeds that return conditions to zero.

use super::super::Case;
use super::super::jet::{Jet, ROUNDING};
use super::{Expansion, Expansions, ROUNDINGS, solved};
use num_traits::{One, Zero};

/// Newton's method from what an integration has left.
const IMPULSES: usize = 3;

impl Expansions {
    /// Takes from the speeds what conditions have moved off zero while they were held: impulses of the forces that hold them, so that
    /// constraints stay as they are.
    pub fn return_to_zero(&self, time: f64, state: &mut [f64], mode: &[Case], slack: f64) {
        let held = self.held(mode);
        for _ in 0..IMPULSES {
            let clock = Jet::<1>::constant(time, 0.0);
            let part = |value: &f64| Jet::constant(*value, ROUNDINGS * ROUNDING * value.abs());
            let parts: Vec<Jet<1>> = state.iter().map(part).collect();
            let Some(Expansion { conditions, switches, .. }) = self.run(clock, &parts, mode, &[]) else { return };
            if held.iter().all(|&switch| conditions[switch].sign_of(0, slack) == 0.0) {
                return;
            }
            // what one switch adds, from 0 to 1
            let added: Vec<Vec<Jet<1>>> = held
                .iter()
                .map(|&switch| {
                    let [off, on] = [Jet::zero(), Jet::one()].map(|value| {
                        let mut switches = switches.clone();
                        switches[switch] = value;
                        self.values(clock, &parts, &switches, &[])
                    });
                    on.iter().zip(off).map(|(on, off)| *on - off).collect()
                })
                .collect();
            let first = self.states + mode.len();
            let rows = held.iter().map(|condition| added.iter().map(|added| added[first + condition]).collect());
            let right = held.iter().map(|&condition| -conditions[condition]).collect();
            let Some(impulses) = solved(rows.collect(), right) else { return };
            for (impulse, added) in impulses.iter().zip(&added) {
                for (part, rate) in state.iter_mut().zip(added) {
                    *part += impulse.terms[0] * rate.terms[0];
                }
            }
        }
    }
}
