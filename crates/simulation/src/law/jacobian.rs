//! The Jacobian of a law: as straight-line code, or, for long laws, by directional derivatives in several directions at
//! once.

use crate::law::compiled_law::{Differentiable, SymbolicLaw};
use crate::law::directions::DirectionalProgram;
use crate::law::trace::{TracedOde, traced};
use integrators::JacobianFn;
use native::Code;
use std::sync::{Arc, OnceLock};
use symbolic::{Program, Sym, Tape};

/// The largest number of operations of a law whose derivatives are compiled to straight-line code. Measured for chains
/// of links, in ns per Jacobian and ms of preparation, straight-line against directional: 5 links in a plane (431
/// operations) 430 and 570 ns, 15 and 6 ms; 7 in a plane (665) 1,430 and 900, 27 and 8; 5 in space (879) 1,790 and 920,
/// 32 and 14; 10 in space (2,635) 8,310 and 5,000, 168 and 25.
const LONGEST_WRITTEN: usize = 600;

/// The derivatives of a law with respect to state and time, from exact symbolic differentiation.
pub struct JacobianProgram {
    law: Arc<dyn SymbolicLaw>,
    directional: DirectionalProgram,
    /// Selected when first needed.
    form: OnceLock<Form>,
}

enum Form {
    /// df_i / dy_j, row by row, and df_i / dt. `None` where they cannot be recorded: the law is then evaluated over
    /// dual numbers.
    Written(Option<Box<[Line; 2]>>),
    Directional,
}

/// Straight-line code with the state and the time as inputs.
#[derive(Debug)]
struct Line {
    tape: Tape,
    /// `None` where there is no code generator for this machine: the tape is then interpreted.
    code: Option<Code>,
}

impl JacobianProgram {
    /// The Jacobian program of a law.
    pub fn of(law: Arc<dyn SymbolicLaw>) -> Self {
        JacobianProgram { directional: DirectionalProgram::of(Arc::clone(&law)), law, form: OnceLock::new() }
    }

    /// The Jacobian by a differential that is shorter than that of the rates.
    pub fn with_differential(self, directional: DirectionalProgram) -> Self {
        JacobianProgram { directional, ..self }
    }

    fn form(&self) -> &Form {
        self.form.get_or_init(|| {
            traced(&*self.law, |TracedOde { state, time, rates }| {
                if Sym::operations_of(rates) > LONGEST_WRITTEN {
                    return Form::Directional;
                }
                let by_state = rates.iter().flat_map(|rate| state.iter().map(|&by| rate.diff(by))).collect();
                let by_time = rates.iter().map(|rate| rate.diff(*time)).collect();
                let inputs = [&state[..], &[*time]].concat();
                Form::Written(
                    Line::of(&inputs, by_state).zip(Line::of(&inputs, by_time)).map(|lines| Box::new(lines.into())),
                )
            })
        })
    }
}

impl Line {
    fn of(inputs: &[Sym], outputs: Vec<Sym>) -> Option<Self> {
        let tape = Tape::record(inputs, &outputs).ok()?.arranged();
        Some(Line { code: Code::of(&tape), tape })
    }
}

impl Differentiable for JacobianProgram {
    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        match self.form() {
            Form::Written(None) => None,
            Form::Written(Some(lines)) => {
                let [by_state, by_time] = &**lines;
                Some(Box::new(Lines { by_state: by_state.into(), by_time: by_time.into() }))
            }
            Form::Directional => self.directional.jacobian_fn(),
        }
    }
}

struct Lines<'a> {
    by_state: Running<'a>,
    by_time: Running<'a>,
}

impl JacobianFn for Lines<'_> {
    fn code_size(&self) -> Option<usize> {
        match self.by_state {
            Running::Code(code) => Some(code.size()),
            Running::Followed(..) => None,
        }
    }

    fn matrix(&mut self, t: f64, y: &[f64], matrix: &mut [f64]) {
        self.by_state.run(t, y, matrix);
    }

    fn by_time(&mut self, t: f64, y: &[f64], slopes: &mut [f64]) {
        self.by_time.run(t, y, slopes);
    }
}

/// A line in the form in which it is evaluated.
enum Running<'a> {
    Code(&'a Code),
    /// Interpreted, with a buffer for the inputs.
    Followed(Program<'a, f64>, Vec<f64>),
}

impl<'a> From<&'a Line> for Running<'a> {
    fn from(Line { tape, code }: &'a Line) -> Self {
        match code {
            Some(code) => Running::Code(code),
            None => Running::Followed(tape.over_rounded(), vec![0.0; tape.inputs()]),
        }
    }
}

impl Running<'_> {
    fn run(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        match self {
            // the length of the state is correct by construction
            Running::Code(code) => code.run(y, t, values).unwrap_or(()),
            Running::Followed(program, inputs) => {
                inputs.iter_mut().zip(y.iter().chain([&t])).for_each(|(input, given)| *input = *given);
                program.evaluate(inputs, values);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Line, Running};
    use field::Scalar;
    use symbolic::Sym;

    #[test]
    fn without_machine_code_slopes_have_the_same_bits() {
        let [x, y, t] = ["x", "y", "t"].map(Sym::symbol);
        let line = Line::of(&[x, y, t], vec![x * y + t, Sym::int(3), x / (t * t + y), y]).expect("it has values");
        let followed = Line { tape: line.tape.clone(), code: None };
        let [own, table] = [&line, &followed].map(|each| {
            let mut values = [0.0_f64; 4];
            Running::from(each).run(0.3, &[0.7, 1.9], &mut values);
            values.map(f64::to_bits)
        });
        assert_eq!(own, table);
    }
}
