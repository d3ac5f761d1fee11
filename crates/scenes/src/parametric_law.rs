//! The equations of motion with all parameters as inputs: one compiled law for all members of an ensemble.

use crate::compiled_system::{NotCompiled, outputs, outputs_of_solved, rates};
use crate::conservation::conserves;
use crate::elimination::{Elimination, is_tree};
use crate::implicit::{Inertia, linear_equations, recurrence_of};
use crate::letters::Inputs;
use crate::modes::Mode;
use algebra::linear::{Factors, Pattern};
use model::{Model, Trace};
use series::Equations;
use simulation::Expandable;
use symbolic::linear::Solve;
use symbolic::{Sym, Tape, Untapeable, apart};

/// The law and the outputs of a model as functions of state, time and parameters.
#[derive(Debug)]
pub(crate) struct ParametricLaw {
    pub law: Expandable,
    /// Computes the outputs, the kinetic and the potential energy from state, time and parameters; if `unknowns` is given, also from
    /// accelerations and multipliers.
    outputs: Tape,
    unknowns: Option<Unknowns>,
    /// Whether the total energy is constant for all values of the parameters.
    pub keeps_energy: bool,
}

/// The linear equations for accelerations and multipliers, if outputs depend on these.
#[derive(Debug)]
struct Unknowns {
    /// Computes the entries of the matrix, then the right side, from state, time and parameters.
    terms: Tape,
    pattern: Pattern,
    speeds: usize,
}

/// Number of unknowns from which Taylor series solve the linear equations numerically. A batch solves its members one by one, so the
/// limit is higher than for a single run.
const LEAST_SOLVED: usize = 16;

impl ParametricLaw {
    /// Compiles the law from the same trace as a single run; parameters need no values.
    pub fn of(model: &Model) -> Result<Self, NotCompiled> {
        match Elimination::of(model) {
            // whether inertia is missing is decided with the parameter values of the file
            Elimination::Written if Inertia::of(model) == Inertia::Held => ParametricLaw::solved(model),
            Elimination::Written => match ParametricLaw::written(model) {
                // coordinates without inertia may be determined by constraints
                Err(NotCompiled::Massless { .. }) if !model.constraints.is_empty() => ParametricLaw::solved(model),
                other => other,
            },
            Elimination::Solved => ParametricLaw::solved(model),
        }
    }

    fn written(model: &Model) -> Result<Self, NotCompiled> {
        apart(|| {
            let inputs = Inputs::of(model);
            let rates = rates(model, &Mode::default(), inputs.letters())?;
            let is_long = model.speeds() + model.constraints.len() >= LEAST_SOLVED && !is_tree(model);
            let law = match is_long {
                true => recurrence_of(&Trace::of(model), &inputs, inputs.letters(), &inputs.parameters),
                false => {
                    let moves = rates.iter().any(|rate| rate.symbols_of().contains(&inputs.time));
                    Expandable::record(&Equations {
                        state: &inputs.state,
                        time: moves.then_some(inputs.time),
                        parameters: &inputs.parameters,
                        rates: &rates,
                        solve: None,
                    })
                }
            };
            let law = law.map_err(undefined)?;
            let outputs =
                Tape::record(&inputs.all(), &outputs(model, &Mode::default(), inputs.letters())).map_err(undefined)?;
            Ok(ParametricLaw { law, outputs, unknowns: None, keeps_energy: conserves(model) })
        })
    }

    fn solved(model: &Model) -> Result<Self, NotCompiled> {
        apart(|| {
            let (inputs, trace) = (Inputs::of(model), Trace::of(model));
            let law = recurrence_of(&trace, &inputs, inputs.letters(), &inputs.parameters).map_err(undefined)?;
            let Solve { unknowns, pattern, entries, right } = linear_equations(&trace, inputs.letters());
            let shown = outputs_of_solved(model, inputs.letters(), &unknowns);
            let are_asked = shown.iter().any(|each| each.symbols_of().iter().any(|symbol| unknowns.contains(symbol)));
            let all: Vec<Sym> = [inputs.all(), unknowns].concat();
            let outputs = Tape::record(&all, &shown).map_err(undefined)?;
            let terms = Tape::record(&inputs.all(), &[entries, right].concat()).map_err(undefined)?;
            let unknowns = Unknowns { terms, pattern, speeds: model.speeds() };
            let keeps_energy = conserves(model);
            Ok(ParametricLaw { law, outputs, unknowns: are_asked.then_some(unknowns), keeps_energy })
        })
    }

    /// The values of the outputs, then the kinetic and the potential energy (J).
    pub fn outputs(&self, time: f64, state: &[f64], parameters: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.outputs.outputs()];
        let mut inputs = [state, &[time], parameters].concat();
        if let Some(unknowns) = &self.unknowns {
            inputs.extend(unknowns.at(&inputs));
        }
        inputs.resize(self.outputs.inputs(), f64::NAN);
        self.outputs.over().evaluate(&inputs, &mut values);
        values
    }
}

impl Unknowns {
    /// The accelerations, then the multipliers; NaN where the matrix is singular.
    fn at(&self, inputs: &[f64]) -> Vec<f64> {
        let mut terms = vec![f64::NAN; self.terms.outputs()];
        self.terms.over().evaluate(inputs, &mut terms);
        let mut found = terms.split_off(self.pattern.places().len());
        let mut factors = Factors::new(&self.pattern);
        match factors.factor(&terms) {
            Ok(()) => factors.solve(&mut found),
            Err(_) => found.fill(f64::NAN),
        }
        found[self.speeds..].iter_mut().for_each(|multiplier| *multiplier = -*multiplier);
        found
    }
}

fn undefined(reason: Untapeable) -> NotCompiled {
    NotCompiled::Undefined { reason: reason.to_string() }
}
