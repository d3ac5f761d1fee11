//! The Jacobian of a law as straight-line code, for the implicit methods.

use crate::law::compiled_law::{Differentiable, SymbolicLaw};
use crate::law::trace::{TracedOde, traced};
use integrators::JacobianFn;
use native::Code;
use std::sync::{Arc, OnceLock};
use symbolic::{Program, Sym, Tape};

/// The derivatives of a law by state and time: its expressions, differentiated exactly.
pub struct JacobianProgram {
    law: Arc<dyn SymbolicLaw>,
    /// df_i / dy_j, row after row, and df_i / dt. Made when they are first asked for; `None` where they cannot be recorded:
    /// then the law is run over dual numbers.
    lines: OnceLock<Option<[Line; 2]>>,
}

/// Straight-line code of a state and the time, as long as it may be.
#[derive(Debug)]
struct Line {
    tape: Tape,
    /// `None` where this machine cannot be written for: then the tape is followed.
    code: Option<Code>,
}

impl JacobianProgram {
    /// The derivatives of a law.
    pub fn of(law: Arc<dyn SymbolicLaw>) -> Self {
        JacobianProgram { law, lines: OnceLock::new() }
    }

    fn lines(&self) -> Option<&[Line; 2]> {
        let made = self.lines.get_or_init(|| {
            traced(&*self.law, |TracedOde { state, time, rates }| {
                let by_state = rates.iter().flat_map(|rate| state.iter().map(|&by| rate.diff(by))).collect();
                let by_time = rates.iter().map(|rate| rate.diff(*time)).collect();
                let inputs = [&state[..], &[*time]].concat();
                Some([Line::of(&inputs, by_state)?, Line::of(&inputs, by_time)?])
            })
        });
        made.as_ref()
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
        let [by_state, by_time] = self.lines()?;
        Some(Box::new(Lines { by_state: by_state.into(), by_time: by_time.into() }))
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

/// A line as it runs.
enum Running<'a> {
    Code(&'a Code),
    /// With room for the inputs.
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
            // made for a state of this length
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
