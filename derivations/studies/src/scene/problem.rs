//! A scene with a motor as an initial value problem.

use super::state::outputs;
use super::{Scene, Setup};
use motor::{Bench, Conserved, Motor, compiled};
use simulation::{Axes, Invariant, Law, Problem};
use std::sync::Arc;
use systems::gyrostat::Gyrostat;
use systems::gyrostat::driven::Driven;
use systems::gyrostat::forms::Form;

impl Scene {
    /// The problem in the axes of a form.
    pub fn problem(&self, axes: Axes) -> Problem {
        let (law, invariants) = match &self.system {
            Setup::Gyrostat(bodies) => gyrostatic(bodies, self.machine.clone(), axes),
            Setup::Bench { axial } => on_bench(self.machine.clone(), *axial),
        };
        Problem {
            law,
            state: self.state(axes),
            metered: 0,
            span: self.run.span,
            invariants,
            residual: None,
            columns: outputs(self.on_bench(), &self.machine),
            row: Box::new(self.row(axes)),
            margins: Box::new(|_, _, _| Vec::new()),
            switching: None,
        }
    }
}

type Lawful = (Arc<dyn Law>, Vec<Invariant>);

fn gyrostatic(bodies: &Gyrostat<f64>, machine: Motor, axes: Axes) -> Lawful {
    match axes {
        Axes::First => driven(bodies.first_form().0, machine),
        Axes::Second => driven(bodies.second_form().0, machine),
    }
}

fn driven(form: impl Form<f64> + Send + Sync + 'static, machine: Motor) -> Lawful {
    let conserved = Conserved::by(&machine);
    let law = Arc::new(Driven::new(form, machine));
    let mut invariants = vec![
        of(&law, "vertical_length", |law, y| law.vertical_length(y)),
        of(&law, "vertical_momentum", |law, y| law.vertical_momentum(y)),
    ];
    if conserved.jacobi {
        invariants.push(of(&law, "jacobi", |law, y| law.jacobi(y)));
    }
    if conserved.spin {
        invariants.push(of(&law, "rotor_momentum", |law, y| law.rotor_momentum(y)));
    }
    (Arc::new(compiled(&law)), invariants)
}

fn on_bench(machine: Motor, axial: f64) -> Lawful {
    let conserved = Conserved::by(&machine);
    let law = Arc::new(Bench { machine, axial });
    let mut invariants = Vec::new();
    if conserved.jacobi {
        invariants.push(of(&law, "jacobi", |law, y| law.jacobi(y)));
    }
    if conserved.spin {
        invariants.push(of(&law, "rotor_momentum", |law, y| law.rotor_momentum(y)));
    }
    (Arc::new(compiled(&law)), invariants)
}

fn of<L: Send + Sync + 'static>(law: &Arc<L>, name: &'static str, value: fn(&L, &[f64]) -> f64) -> Invariant {
    let law = Arc::clone(law);
    Invariant { name, value: Box::new(move |_, y| value(&law, y)), size: None }
}
