//! The Jacobian that the implicit methods use, sums of multiples of monomials, is that of dual numbers: for every machine
//! and form, away from the start.

use derivations::differentiated::Differentiated;
use derivations::machines::{AnyMachine, Catalogued, ForMachine};
use derivations::papers::konosevich2022::gyrostats;
use derivations::recorded::Recorded;
use derivations::systems::gyrostat::driven::Driven;
use derivations::systems::gyrostat::forms::Form;
use integrators::{Directions, Jacobian, Ode, System};
use physical::machines::Bars;
use physical::rounded;
use std::sync::Arc;

mod physical;

/// Whether the machine has a Jacobian of monomials, after comparing it.
struct Compare<F>(F);

impl<F: Form<f64> + Send + Sync + 'static> ForMachine for Compare<F> {
    type Output = bool;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> bool {
        let law = Arc::new(Driven::new(self.0, machine));
        let system = Differentiated::new(Recorded::new(Arc::clone(&law)), law);
        let n = Ode::<f64>::dimension(&system);
        let dual: &dyn Ode<Directions> = &system;
        let (mut ours, mut theirs) = (vec![f64::NAN; n * n], vec![f64::NAN; n * n]);
        for turn in 0..5 {
            let y: Vec<f64> = (0..n).map(|i| 2.0 * ((7 * turn + 3 * i) as f64).sin()).collect();
            Jacobian::of(&system).matrix(0.0, &y, &mut ours);
            Jacobian::new(dual).matrix(0.0, &y, &mut theirs);
            let size = theirs.iter().fold(1.0, |most: f64, entry| most.max(entry.abs()));
            for (place, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
                let difference = (ours - theirs).abs();
                assert!(difference < 1e-14 * size, "row {}, column {}: {ours} for {theirs}", place / n, place % n);
            }
        }
        system.slopes().is_some()
    }
}

#[test]
fn the_jacobian_of_monomials_is_that_of_dual_numbers() {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    let mut with = Vec::new();
    for (name, _) in AnyMachine::LIST {
        for bars in [1, 6] {
            let Some(Ok(machine)) = AnyMachine::read(name, &mut Bars(bars)) else { panic!("{name} is in the list") };
            let first = machine.clone().apply(Compare(g.first_form().0));
            if first && machine.apply(Compare(g.second_form().0)) {
                with.push(*name);
            }
        }
    }
    // else nothing was compared
    assert!(with.contains(&"synchronous") && with.contains(&"multi_current"), "{with:?}");
}
