//! Scenes with a motor with a supply: the work of the supply is an additional state, and the power balance an invariant
//! of the run.

use super::{Scene, Setup};
use motor::{Bench, Powered, WithSuppliedWork, is_fed};
use simulation::events::of_leading;
use simulation::problem::{Invariant, Problem};
use simulation::{Axes, CompiledLaw, Law};
use std::sync::Arc;
use systems::gyrostat::driven::Driven;

impl Scene {
    /// The problem in the axes of a form. If the machine has a supply, the last state is the work on E - W p, and the
    /// balance of both is one of the invariants.
    pub fn metered(&self, axes: Axes) -> Problem {
        let plain = self.problem(axes);
        let Some((law, balance)) = self.fed(axes) else {
            return plain;
        };
        let Problem { mut state, span, invariants, mut columns, row, margins, .. } = plain;
        let own = state.len();
        state.push(0.0);
        columns.push("work".to_owned());
        let of_own = |Invariant { name, value, .. }: Invariant| {
            let value = move |time: f64, y: &[f64]| value(time, &y[..own]);
            Invariant { name, value: Box::new(value), size: None }
        };
        let mut invariants: Vec<Invariant> = invariants.into_iter().map(of_own).collect();
        invariants.push(balance);
        let row = move |time: f64, y: &[f64]| {
            let mut row = row(time, &y[..own]);
            row.push(y[own]);
            row
        };
        let (row, margins) = (Box::new(row), of_leading(margins, own));
        Problem { law, state, metered: 1, span, invariants, residual: None, columns, row, margins, switching: None }
    }

    /// The law with the work of the supply as a state, and the balance; `None` if the machine has no supply.
    fn fed(&self, axes: Axes) -> Option<(Arc<dyn Law>, Invariant)> {
        let machine = self.machine.clone();
        is_fed(&machine).then(|| match (&self.system, axes) {
            (Setup::Gyrostat(bodies), Axes::First) => metered(Driven::new(bodies.first_form().0, machine)),
            (Setup::Gyrostat(bodies), Axes::Second) => metered(Driven::new(bodies.second_form().0, machine)),
            (Setup::Bench { axial }, _) => metered(Bench { machine, axial: *axial }),
        })
    }
}

fn metered(law: impl Powered + Send + Sync + 'static) -> (Arc<dyn Law>, Invariant) {
    let law = Arc::new(WithSuppliedWork(law));
    let balancing = Arc::clone(&law);
    let balance = Invariant { name: "jacobi_less_work", value: Box::new(move |_, y| balancing.balance(y)), size: None };
    (Arc::new(CompiledLaw::of(law)), balance)
}
