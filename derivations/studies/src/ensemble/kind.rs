//! The law of a scene with a symbol for every datum, recorded once for all members of an ensemble.

use crate::scene::Setup;
use crate::scene::state::principal;
use integrators::BatchSeries;
use motor::{Bench, Machine, Motor};
use nalgebra::{Matrix3, Vector3};
use series::Equations;
use simulation::ensemble::{BATCH_SIZE, batch_series};
use simulation::{Axes, Expandable};
use symbolic::{Sym, Tape, Untapeable, apart};
use systems::gyrostat::driven::Driven;
use systems::gyrostat::forms::{FirstForm, Form, SecondForm};

/// The law of systems that differ in their numbers only. The parameters are those of the form (principal moments, l,
/// A', Ge in its axes) or A' of a bench, followed by those of the machine in its order.
#[derive(Clone, Debug)]
pub struct Kind {
    law: Expandable,
    invariants: Tape,
}

/// The names of possible integrals; the machine of a member determines which of them are conserved.
pub const INVARIANTS: [&str; 4] = ["vertical_length", "vertical_momentum", "jacobi", "rotor_momentum"];
/// The units of [`INVARIANTS`].
pub const INVARIANT_UNITS: [&str; 4] = ["1", "N m s", "J", "N m s"];

impl Kind {
    /// Records the law of a system with a machine with given numbers of windings.
    ///
    /// # Errors
    /// [`Untapeable`] where the law cannot be recorded.
    pub fn record(system: &Setup, machine: &Motor, axes: Axes) -> Result<Self, Untapeable> {
        apart(|| recorded(system, machine, axes, false))
    }

    /// As [`Self::record`], with a load as the last parameter: a torque against the rotor's rotation, N m.
    ///
    /// # Errors
    /// [`Untapeable`] where the law cannot be recorded.
    pub fn under_load(system: &Setup, machine: &Motor, axes: Axes) -> Result<Self, Untapeable> {
        apart(|| recorded(system, machine, axes, true))
    }

    /// The number of parameters of a member.
    pub fn parameters(&self) -> usize {
        self.law.parameters()
    }

    /// The number of states of a member.
    pub fn states(&self) -> usize {
        self.law.states()
    }

    /// Taylor series of a batch of members, of the given order.
    pub fn series(&self, order: usize) -> Option<Box<dyn BatchSeries<BATCH_SIZE> + '_>> {
        batch_series(&self.law, order)
    }

    /// The program for the values of [`INVARIANTS`], from the states followed by the parameters.
    pub fn invariants(&self) -> symbolic::Program<'_, f64> {
        self.invariants.over()
    }
}

/// The axes of the form as columns, and the parameters of the system without those of the machine.
pub fn form_parameters(system: &Setup, axes: Axes) -> (Option<Matrix3<f64>>, Vec<f64>) {
    match system {
        Setup::Gyrostat(bodies) => {
            let principal = principal(axes, bodies);
            let (moments, axis, axial, weight) = bodies.form_data(&principal);
            let parameters = moments.iter().chain(&axis).chain([&axial]).chain(&weight).copied().collect();
            (Some(principal.axes), parameters)
        }
        Setup::Bench { axial } => (None, vec![*axial]),
    }
}

fn recorded(system: &Setup, machine: &Motor, axes: Axes, loaded: bool) -> Result<Kind, Untapeable> {
    let mut names = Names { made: Vec::new() };
    match system {
        Setup::Gyrostat(_) => {
            let [moments, axis] = [names.three(), names.three()];
            let (axial, weight) = (names.one(), names.three());
            let machine = machine.over(|_, _| names.one());
            let load = names.load(loaded);
            match axes {
                Axes::First => gyrostat(FirstForm::new(moments, axis, axial, weight), machine, load, &names.made),
                Axes::Second => gyrostat(SecondForm::new(moments, axis, axial, weight), machine, load, &names.made),
            }
        }
        Setup::Bench { .. } => {
            let axial = names.one();
            let machine = machine.over(|_, _| names.one());
            let load = names.load(loaded);
            let bench = Bench { machine, axial };
            let state = states(bench.dimension());
            let none = [Sym::ZERO; 2];
            let kept = [none[0], none[1], bench.jacobi(&state), bench.rotor_momentum(&state)];
            kind(&state, &names.made, kept, |dy| bench.rates_under(load, &state, dy))
        }
    }
}

fn gyrostat(
    form: impl Form<Sym>,
    machine: impl Machine<Sym>,
    load: Sym,
    parameters: &[Sym],
) -> Result<Kind, Untapeable> {
    let law = Driven::new(form, machine);
    let state = states(law.dimension());
    let kept =
        [law.vertical_length(&state), law.vertical_momentum(&state), law.jacobi(&state), law.rotor_momentum(&state)];
    kind(&state, parameters, kept, |dy| law.rates_under(load, &state, dy))
}

fn kind(state: &[Sym], parameters: &[Sym], kept: [Sym; 4], law: impl Fn(&mut [Sym])) -> Result<Kind, Untapeable> {
    let mut rates = vec![Sym::ZERO; state.len()];
    law(&mut rates);
    let inputs = [state, parameters].concat();
    Ok(Kind {
        law: Expandable::record(&Equations { state, time: None, parameters, rates: &rates, solve: None })?,
        invariants: Tape::record(&inputs, &kept)?,
    })
}

fn states(count: usize) -> Vec<Sym> {
    (0..count).map(|i| Sym::symbol(&format!("y{i}"))).collect()
}

/// A source of new symbols.
struct Names {
    made: Vec<Sym>,
}

impl Names {
    fn one(&mut self) -> Sym {
        let next = Sym::symbol(&format!("p{}", self.made.len()));
        self.made.push(next);
        next
    }

    fn load(&mut self, loaded: bool) -> Sym {
        if loaded { self.one() } else { Sym::ZERO }
    }

    fn three(&mut self) -> Vector3<Sym> {
        Vector3::from([self.one(), self.one(), self.one()])
    }
}
