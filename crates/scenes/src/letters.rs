//! Substitution for the symbols of a model in compiled functions: by inputs, or by constant values.

use field::{Over, Rational};
use model::{HALF_TURN, Model, Trace};
use symbolic::{Sym, substitute_all};

/// Symbols for the inputs of a compiled function: the state, the time, the parameters of a model, in this order.
pub(crate) struct Inputs {
    /// Coordinates, then speeds.
    pub state: Vec<Sym>,
    pub time: Sym,
    /// All parameters of the model.
    pub parameters: Vec<Sym>,
}

impl Inputs {
    /// Fresh symbols for all inputs.
    pub fn of(model: &Model) -> Self {
        let named =
            |letter: &str, count: usize| (0..count).map(|i| Sym::symbol(&format!("{letter}{i}"))).collect::<Vec<_>>();
        let (state, parameters) = (named("y", model.positions() + model.speeds()), named("p", model.parameters.len()));
        Inputs { state, time: Sym::symbol("t"), parameters }
    }

    /// The substitution of the model's symbols by these inputs.
    pub fn letters(&self) -> Letters<'_> {
        Letters::with_parameters(self.time, &self.state, &self.parameters)
    }

    /// All inputs, in order.
    pub fn all(&self) -> Vec<Sym> {
        [&self.state[..], &[self.time], &self.parameters].concat()
    }
}

/// The substitution for time, coordinates, speeds and parameters of a model.
#[derive(Clone, Copy)]
pub(crate) struct Letters<'a> {
    time: Sym,
    /// Coordinates, then speeds.
    state: &'a [Sym],
    parameters: Parameters<'a>,
}

#[derive(Clone, Copy)]
enum Parameters<'a> {
    /// These expressions.
    Inputs(&'a [Sym]),
    /// Constants: the exact values of the floats.
    Floats,
    /// Constants: the shortest decimals that round to the floats, which are usually the numbers of the file.
    Decimals,
}

impl<'a> Letters<'a> {
    /// Time and state as inputs, parameters as constants, for runs.
    pub fn with_data(time: Sym, state: &'a [Sym]) -> Self {
        Letters { time, state, parameters: Parameters::Floats }
    }

    /// Time and state as inputs, parameters as decimals, for exact decisions.
    pub fn with_decimals(time: Sym, state: &'a [Sym]) -> Self {
        Letters { time, state, parameters: Parameters::Decimals }
    }

    /// Time, state and parameters as inputs.
    pub fn with_parameters(time: Sym, state: &'a [Sym], parameters: &'a [Sym]) -> Self {
        Letters { time, state, parameters: Parameters::Inputs(parameters) }
    }

    /// Substitutes the symbols of a trace in expressions.
    pub fn put_into(&self, trace: &Trace<'_>, expressions: &[Sym]) -> Vec<Sym> {
        substitute_all(expressions, &self.known(trace))
    }

    /// Pairs of each symbol of a trace and its replacement.
    pub fn known(&self, trace: &Trace<'_>) -> Vec<(Sym, Sym)> {
        let mut known: Vec<(Sym, Sym)> = vec![(trace.time, self.time), (trace.pi, half_turn())];
        known.extend(trace.coordinates.iter().chain(&trace.speeds).copied().zip(self.state.iter().copied()));
        let constants = |exact: fn(f64) -> Rational| {
            let values = trace.model.parameters.iter().map(move |parameter| parameter.value.map(exact));
            trace.parameters.iter().zip(values).filter_map(|(&letter, value)| Some((letter, Sym::lift(value?))))
        };
        match self.parameters {
            Parameters::Inputs(inputs) => {
                known.extend(trace.parameters.iter().copied().zip(inputs.iter().copied()));
            }
            Parameters::Floats => known.extend(constants(Rational::exactly)),
            Parameters::Decimals => known.extend(constants(Rational::decimal)),
        }
        // masses that depend on the state or the time
        let (letters, solid): (Vec<Sym>, Vec<Sym>) = trace.solid().into_iter().unzip();
        let solid = substitute_all(&solid, &known);
        known.extend(letters.into_iter().zip(solid));
        known
    }
}

/// Pi as the exact sum of several floats.
fn half_turn() -> Sym {
    HALF_TURN.into_iter().map(|part| Sym::lift(Rational::exactly(part))).fold(Sym::ZERO, |sum, part| sum + part)
}
