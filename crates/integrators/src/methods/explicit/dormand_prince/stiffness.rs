//! Stiffness detection: decides whether stability, not accuracy, limits the step size of an explicit pair.

use crate::System;
use crate::law::jacobian::Jacobian;
use crate::newton::SpectralRadius;
use crate::run::budgeted_rhs::BudgetedRhs;

/// Interval of regular tests, in accepted steps.
const EVERY: u64 = 100;

/// The eigenvalues are computed after this many steps that seem limited by stability. [`OTHERS`] other steps in a row
/// reset the count.
const LIMITED: u32 = 15;
const OTHERS: u32 = 6;

/// A step counts as limited by stability if it is at least this fraction of the longest stable step for an upper bound
/// of the largest eigenvalue.
const OF_STABLE: f64 = 0.5;

/// The largest number of states for which eigenvalues are computed: the matrix products are too expensive for larger
/// systems.
const MOST_STATES: usize = 400;

/// Hairer's test for stiffness, applied at every hundredth step. After a step that seems limited by stability it is
/// applied at every step, until fifteen in all seem limited, or six others occur in a row.
///
/// The estimated Lipschitz number is at least the modulus of the largest eigenvalue, and may be much larger: for x'' =
/// -w^2 x it is w^2, the eigenvalue w. The eigenvalues are therefore computed before a run is ended as stiff. If they
/// show no stiffness, the test pauses for a number of steps that doubles each time.
pub(super) struct Stiffness<'a> {
    system: &'a dyn System,
    accepted: u64,
    limited: u32,
    others: u32,
    /// The test pauses up to this number of accepted steps; the pause doubles whenever the eigenvalues show no
    /// stiffness.
    rests_until: u64,
    rest: u64,
    /// A confirmation remains valid up to this number of accepted steps, if the run continues in spite of stiffness.
    confirmed_until: u64,
}

impl<'a> Stiffness<'a> {
    pub fn of(system: &'a dyn System) -> Self {
        Stiffness { system, accepted: 0, limited: 0, others: 0, rests_until: 0, rest: EVERY, confirmed_until: 0 }
    }

    /// Counts an accepted step. Returns whether the test is due.
    pub fn is_due(&mut self) -> bool {
        self.accepted += 1;
        self.accepted >= self.rests_until && (self.accepted.is_multiple_of(EVERY) || self.limited > 0)
    }

    /// Records the result of a test. Returns whether the problem seems stiff.
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

    /// Whether the eigenvalues at the end of a step limit its size: `stable` bounds |h lambda| for modes that do not
    /// grow, `step` is h in s, and `tau` is the time of the run at the end of the step.
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
        // a NaN radius does not refute stiffness
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
