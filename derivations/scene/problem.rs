//! A scene as an initial value problem, its types forgotten: what any method runs.

use super::law_end::Margins;
use super::state::outputs;
use super::switching::{Switching, integrate};
use super::{Axes, Scene, System};
use crate::machines::{Bench, Conserved, Motor, compiled};
use crate::systems::gyrostat::Gyrostat;
use crate::systems::gyrostat::driven::Driven;
use crate::systems::gyrostat::forms::Form;
use integrators::{End, Failure, Method, Observer, Outcome, Span, Tolerance};
use simulation::Law;
use std::sync::Arc;

/// A law with its state at time zero, what it conserves, and what a run shows of it.
pub struct Problem {
    pub law: Arc<dyn Law>,
    /// As the law has it: of a gyrostat in the axes of the form.
    pub state: Vec<f64>,
    /// s, from time zero.
    pub span: f64,
    pub invariants: Vec<Invariant>,
    /// The names of a row.
    pub columns: Vec<String>,
    /// What is shown of a state at a time.
    pub row: Box<Row>,
    /// How far a state is from where the law ends.
    pub margins: Box<Margins>,
    /// Of a law that changes at events: then `law` is the one of the start.
    pub switching: Option<Arc<dyn Switching>>,
}

impl Problem {
    /// The motion across the events of a switching, by a method. A motion that ends before its span is another course.
    pub fn across(
        &self,
        switching: &dyn Switching,
        (method, tolerance): (Method, &Tolerance),
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> Outcome<f64> {
        let (outcome, left) = integrate((switching, &self.margins), (method, tolerance), span, observer);
        match left {
            None => outcome,
            Some(_) => Outcome { end: End::Stopped(Failure::OtherCourse { at: outcome.time }), ..outcome },
        }
    }
}

type Function = dyn Fn(f64, &[f64]) -> f64 + Send + Sync;
pub(crate) type Row = dyn Fn(f64, &[f64]) -> Vec<f64> + Send + Sync;

/// A function of time and state that keeps its first value.
pub struct Invariant {
    pub name: &'static str,
    pub value: Box<Function>,
}

impl Scene {
    /// The problem in the axes of a form.
    pub fn problem(&self, axes: Axes) -> Problem {
        let (law, invariants) = match &self.system {
            System::Gyrostat(bodies) => gyrostatic(bodies, self.machine.clone(), axes),
            System::Bench { axial } => on_bench(self.machine.clone(), *axial),
        };
        Problem {
            law,
            state: self.state(axes),
            span: self.run.span,
            invariants,
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
    Invariant { name, value: Box::new(move |_, y| value(&law, y)) }
}
