//! Stiffness detection: whether stability, not accuracy, limits the steps of an explicit pair.

use crate::System;
use crate::law::jacobian::Jacobian;
use crate::newton::SpectralRadius;
use crate::run::budgeted_rhs::BudgetedRhs;

/// The interval of steps at which one is examined, where none seemed to be limited.
const EVERY: u64 = 100;

/// Steps that seem to be limited, after which the eigenvalues are computed, and other steps in a row after which the count begins anew.
const LIMITED: u32 = 15;
const OTHERS: u32 = 6;

/// A step that stability limits is at least this part of the longest stable one for the fastest mode, by an upper bound of its
/// eigenvalue.
const OF_STABLE: f64 = 0.5;

/// Larger systems are not examined by eigenvalues: their products cost too much.
const MOST_STATES: usize = 400;

/// Hairer's test for stiffness: at every hundredth step, and from one that stability seems to have limited at each, until fifteen in all
/// have been such, or six others in a row were not.
///
/// The Lipschitz number that a step shows is at least the eigenvalue of the fastest mode, and may be much larger: for x'' = -w^2 x it is
/// w^2, the eigenvalue w. The eigenvalues are therefore computed before a run is given up. Where they deny stiffness, the test rests twice
/// as long as before.
pub(super) struct Stiffness<'a> {
    system: &'a dyn System,
    accepted: u64,
    limited: u32,
    others: u32,
    /// The number of steps before which nothing is examined, and its growth where the eigenvalues deny stiffness.
    rests_until: u64,
    rest: u64,
    /// The number of steps before which a confirmation holds: a run may go on in spite of it.
    confirmed_until: u64,
}

impl<'a> Stiffness<'a> {
    pub fn of(system: &'a dyn System) -> Self {
        Stiffness { system, accepted: 0, limited: 0, others: 0, rests_until: 0, rest: EVERY, confirmed_until: 0 }
    }

    /// Counts an accepted step; returns whether it is to be examined.
    pub fn is_due(&mut self) -> bool {
        self.accepted += 1;
        self.accepted >= self.rests_until && (self.accepted.is_multiple_of(EVERY) || self.limited > 0)
    }

    /// Counts a step that was examined; returns whether the problem seems stiff.
    pub fn found(&mut self, limited: bool) -> bool {
        if limited {
            (self.limited, self.others) = (self.limited + 1, 0);
        } else {
            self.others += 1;
            if self.others == OTHERS {
                self.limited = 0;
            }
        }
        self.limited >= LIMITED
    }

    /// Whether a step is as long as the eigenvalues at its end allow: |h lambda| is at most `stable` for a mode that does not grow.
    pub fn is_confirmed(
        &mut self,
        (stable, step): (f64, f64),
        (meter, tau): (&BudgetedRhs<f64>, f64),
        state: &[f64],
    ) -> bool {
        let n = state.len();
        if n > MOST_STATES || self.accepted < self.confirmed_until {
            return true;
        }
        let mut matrix = vec![0.0; n * n];
        Jacobian::of(self.system).matrix(meter.time(tau), state, &mut matrix);
        meter.count_jacobian();
        let radius = SpectralRadius::new(n).radius(&matrix);
        // a radius that is NaN denies nothing
        let is_denied = step * radius < OF_STABLE * stable;
        if is_denied {
            (self.limited, self.others) = (0, 0);
            self.rests_until = self.accepted + self.rest;
            self.rest *= 2;
        } else {
            self.confirmed_until = self.accepted + EVERY;
        }
        !is_denied
    }
}
