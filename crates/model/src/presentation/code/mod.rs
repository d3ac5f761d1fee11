//! Export of a whole system to code: M, h - Q, J and c as straight-line functions of time, state and parameters; accelerations and
//! multipliers by a linear solver with pivoting; and the rates of the state.
//!
//! A free frame has four coordinates, a quaternion, listed after the other coordinates, and three speeds, its angular velocity along its own axes.

mod c;
mod casadi;
mod exchange;
mod letters;
mod modelica;
mod python;
mod rust;

pub use casadi::casadi;
pub use exchange::exchange;
pub use modelica::modelica;

use super::axes::along;
use super::conditions::left_out;
use super::contacts::open_letters;
use super::matrix_form::MatrixForm;
use crate::Trace;
use letters::Letters;
use symbolic::{Language, Statements, Sym};

/// The program in a target language: sizes, names and statements.
struct Program {
    /// The number of coordinates.
    positions: usize,
    /// The number of speeds.
    n: usize,
    /// The number of scalar constraints.
    m: usize,
    parameters: Vec<Named>,
    /// The state at the start, if the code contains it.
    start: Option<Vec<f64>>,
    /// The names of the coordinates and speeds, in order.
    coordinates: Vec<String>,
    speeds: Vec<String>,
    /// Whether the system has a free frame.
    turns: bool,
    /// The definition of each quasi-velocity; empty if the speeds are not quasi-velocities.
    meanings: Vec<String>,
    /// The name and the axis of each constraint.
    constraints: Vec<(String, Option<String>)>,
    /// Sentences on the parts of the model that the code omits.
    left_out: Vec<String>,
    /// Conditions, each of which makes a component of s one where it holds, else zero.
    conditions: Vec<Condition>,
    /// M, h - Q, J, c.
    terms: Statements,
    /// The statements for the constraints f.
    zeros: Statements,
    /// The statements for q'.
    position_rates: Statements,
}

/// A condition: a comparison of an expression with zero.
struct Condition {
    /// Statements that lead to the expression.
    lines: Vec<String>,
    /// The comparison: `r3 > 0.0`.
    holds: String,
}

/// A parameter, or an input without a value.
struct Named {
    name: String,
    letter: String,
    /// The coherent SI unit.
    unit: String,
    value: Option<f64>,
}

/// Exports the system to code.
///
/// # Errors
/// An expression divides by the constant zero, or a constant is beyond the range of double precision.
pub fn code(trace: &Trace<'_>, form: &MatrixForm, language: Language) -> Result<String, String> {
    written(trace, form, language, None)
}

/// Exports the system to code, with the state at the start (coordinates, then speeds) as a constant.
///
/// # Errors
/// The errors of [`code`].
pub fn code_from(trace: &Trace<'_>, form: &MatrixForm, language: Language, start: &[f64]) -> Result<String, String> {
    written(trace, form, language, Some(start))
}

fn written(trace: &Trace<'_>, form: &MatrixForm, language: Language, start: Option<&[f64]>) -> Result<String, String> {
    let program = || {
        let mut program = Program::of(trace, form, language)?;
        program.start = start.map(<[f64]>::to_vec);
        if start.is_some() {
            program.close_inputs(trace);
        }
        Ok::<Program, String>(program)
    };
    Ok(match language {
        Language::C => c::written(&program()?),
        Language::Python => python::written(&program()?),
        Language::Rust => rust::written(&program()?),
        Language::Modelica => {
            let zero = trace.model.start_state();
            modelica::modelica(trace, form, "System", start.unwrap_or(&zero))?
        }
    })
}

impl Program {
    fn of(trace: &Trace<'_>, form: &MatrixForm, language: Language) -> Result<Program, String> {
        let letters = Letters::of(trace, form, language);
        let Letters { names, quoted, .. } = &letters;
        let statements = |expressions: &[Sym]| letters.statements(expressions);
        let zeros: Vec<Sym> = form.constraints.iter().map(|held| held.zero).collect();
        let units = trace.model.parameters.iter().map(|parameter| (parameter.unit.clone(), parameter.value));
        let units = units.chain(open_letters(trace).into_iter().map(|(_, unit)| (unit, None)));
        let parameters = names.iter().zip(quoted).zip(units);
        let meanings = trace.model.quasi_velocities.iter().zip(form.quasi.iter().flat_map(|quasi| &quasi.definitions));
        let cosines: Vec<(Sym, Sym)> = form.cosines.iter().map(|cosine| (cosine.value, cosine.letter)).collect();
        let in_letters = |is: Sym| is.substitute(&cosines).decimal_text();
        let meanings = meanings.map(|(speed, is)| format!("{} = {}", speed.name, in_letters(*is)));
        let meanings: Vec<String> = meanings.collect();
        // the line of the first of nine cosines represents all nine
        let used = form.cosines.iter().filter(|cosine| {
            let letter = cosine.letter.to_string();
            letter.ends_with(".Rxx") && meanings.iter().any(|line| line.contains(letter.trim_end_matches("xx")))
        });
        let told = used.map(|cosine| format!("{} = {}, and so on: direction cosines", cosine.letter, cosine.meaning));
        let told: Vec<String> = told.collect();
        let texts = |letters: &[Sym]| letters.iter().map(Sym::to_string).collect::<Vec<_>>();
        let named = |((name, letter), (unit, value)): ((&String, &String), (String, Option<f64>))| Named {
            name: name.clone(),
            letter: letter.clone(),
            unit,
            value,
        };
        let condition = |(place, (_, is)): (usize, &(Sym, Sym))| {
            let Statements { lines, outputs } = statements(&[*is])?;
            Ok::<_, String>(Condition { lines, holds: format!("{} {} 0.0", outputs[0], form.relation(place)) })
        };
        Ok(Program {
            positions: form.positions.len(),
            n: form.speeds.len(),
            m: form.constraints.len(),
            coordinates: texts(&form.positions),
            speeds: texts(&form.speeds),
            turns: !trace.model.free.is_empty(),
            meanings: [meanings, told].concat(),
            constraints: form.constraints.iter().map(|held| (held.name.clone(), held.axis.clone())).collect(),
            left_out: left_out(trace, form),
            terms: statements(&terms(form))?,
            zeros: statements(&zeros)?,
            position_rates: statements(&form.position_rates)?,
            conditions: (form.switches.iter().enumerate()).map(condition).collect::<Result<_, _>>()?,
            parameters: parameters.map(named).collect(),
            start: None,
        })
    }
}

/// Returns M by rows, h - Q, J by rows, and c.
fn terms(form: &MatrixForm) -> Vec<Sym> {
    let mass = form.mass.iter().flatten().copied();
    let loads = form.inertia.iter().zip(&form.forces).map(|(&inertia, &force)| inertia - force);
    let rows = form.constraints.iter().flat_map(|held| held.row.iter().copied());
    let biases = form.constraints.iter().map(|held| held.bias);
    mass.chain(loads).chain(rows).chain(biases).collect()
}

impl Program {
    /// Gives inputs without a value the initial value zero.
    fn close_inputs(&mut self, trace: &Trace<'_>) {
        self.parameters[trace.model.parameters.len()..].iter_mut().for_each(|input| input.value = Some(0.0));
    }

    /// Returns whether every parameter has a value.
    fn has_values(&self) -> bool {
        self.parameters.iter().all(|named| named.value.is_some())
    }

    /// Elementary functions that the statements call, in alphabetical order.
    fn functions(&self) -> Vec<&'static str> {
        let lists = [&self.terms.lines, &self.zeros.lines, &self.position_rates.lines];
        let lists = lists.into_iter().chain(self.conditions.iter().map(|condition| &condition.lines));
        let lines: Vec<&str> = lists.flatten().flat_map(|line| line.lines()).collect();
        let is_called = |name: &&str| lines.iter().any(|line| line.contains(&format!("= {name}(")));
        ["atan2", "cos", "exp", "log", "sin", "sqrt", "tanh"].into_iter().filter(is_called).collect()
    }

    /// Returns the first lines of a file as comments.
    fn heading(&self, comment: &str) -> String {
        let q = format!("q = ({})", self.coordinates.join(", "));
        let turned = match self.turns {
            false => q,
            true => format!(
                "{q}: of a free frame the quaternion q0 + q1 i + q2 j + q3 k, q0 = 1 where it stands as its parent"
            ),
        };
        let speeds = self.speeds.join(", ");
        let mut lines = match (self.turns, self.meanings.is_empty()) {
            (false, true) => vec![
                "M q'' + h = Q + J^T lambda, J q'' + c = 0; u = q'. A positive lambda acts along its row of J."
                    .to_owned(),
                turned,
            ],
            (true, true) => vec![
                "M u' + h = Q + J^T lambda, J u' + c = 0. A positive lambda acts along its row of J.".to_owned(),
                turned,
                format!("u = ({speeds}): of a free frame the angular velocity along its own axes"),
            ],
            (_, false) if self.m == 0 => {
                vec!["M u' + h = Q, q' by u.".to_owned(), turned, format!("u = ({speeds}): quasi-velocities")]
            }
            (_, false) => vec![
                "M u' + h = Q + J^T lambda, J u' + c = 0, q' by u. A positive lambda acts along its row of J."
                    .to_owned(),
                turned,
                format!("u = ({speeds}): quasi-velocities"),
            ],
        };
        // a quasi-velocity that is the rate of a coordinate needs no definition
        lines.extend(
            self.meanings.iter().filter(|line| line.split_once(" = ").is_none_or(|(name, is)| name != is)).cloned(),
        );
        let name = |(k, name): (usize, &String)| match name.as_str() {
            "" => format!("{}", k + 1),
            name => format!("{} ({name})", k + 1),
        };
        let name = |(k, (own, axis)): (usize, &(String, Option<String>))| name((k, own)) + &along(axis.as_deref());
        if self.m > 0 {
            let names: Vec<String> = self.constraints.iter().enumerate().map(name).collect();
            lines.push(format!("constraints: {}", names.join(", ")));
        }
        lines.extend_from_slice(&self.left_out);
        lines.into_iter().map(|line| format!("{comment} {line}\n")).collect()
    }
}

/// Returns assignments of outputs to the entries of an array.
fn assigned(array: &str, outputs: &[String]) -> Vec<String> {
    outputs.iter().enumerate().map(|(k, output)| format!("{array}[{k}] = {output};")).collect()
}

/// Returns lines with indentation.
fn indented(lines: &[String]) -> String {
    lines.iter().flat_map(|line| line.lines()).map(|line| format!("    {}\n", line.trim_start())).collect()
}
