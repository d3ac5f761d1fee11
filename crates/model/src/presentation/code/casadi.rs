//! Export to CasADi: the rates as a function of CasADi symbols, which CasADi can differentiate and optimise.

use super::{Program, indented};
use crate::Trace;
use crate::presentation::matrix_form::MatrixForm;
use std::fmt::Write;
use symbolic::Language;

/// Returns a Python module with the rates and the constraints as CasADi functions, and the start.
///
/// # Errors
/// The errors of [`super::code`].
pub fn casadi(trace: &Trace<'_>, form: &MatrixForm, start: &[f64]) -> Result<String, String> {
    let mut program = Program::of(trace, form, Language::Python)?;
    program.close_inputs(trace);
    let Program { positions, n, m, parameters, conditions, terms, zeros, position_rates, .. } = &program;
    let mut text = program.heading("#");
    text += "import casadi\n";
    let functions = program.functions();
    if !functions.is_empty() {
        let _ = writeln!(text, "from casadi import {}", functions.join(", "));
    }
    text += "\n";
    let names: Vec<String> = parameters.iter().map(|named| format!("{:?}", named.letter)).collect();
    let values = parameters.iter().map(|named| match named.value {
        Some(value) => format!("    {:?}: {value:?},  # {}\n", named.letter, named.unit),
        None => format!("    {:?}: float(\"nan\"),  # {}: without a value\n", named.letter, named.unit),
    });
    let _ = writeln!(text, "PARAMETERS = {{\n{}}}\nSTART = {start:?}  # y = (q, u)\n", values.collect::<String>());
    let _ = writeln!(
        text,
        "t = casadi.SX.sym(\"t\")\nq = casadi.SX.sym(\"q\", {positions})\nu = casadi.SX.sym(\"u\", {n})\n\
         letters = casadi.SX.sym(\"p\", {})\np = dict(zip([{}], casadi.vertsplit(letters)))\n\n\ndef terms():\n    \
         \"\"\"M, h - Q, J, c, f and the rates of q.\"\"\"",
        parameters.len(),
        names.join(", "),
    );
    if !conditions.is_empty() {
        text += "    s = []\n";
    }
    for condition in conditions {
        let _ =
            writeln!(text, "{}    s.append(casadi.if_else({}, 1.0, 0.0))", indented(&condition.lines), condition.holds);
    }
    let column = |outputs: &[String]| format!("casadi.vertcat({})", outputs.join(", "));
    // the outputs are listed by rows, while CasADi fills matrices by columns
    let rows = |outputs: &[String], rows: usize| match rows {
        0 => format!("casadi.SX(0, {n})"),
        _ => format!("casadi.reshape({}, {n}, {rows}).T", column(outputs)),
    };
    let (mass, rest) = terms.outputs.split_at(n * n);
    let (load, rest) = rest.split_at(*n);
    let (jacobian, bias) = rest.split_at(m * n);
    // each list of statements uses the same result names, hence the results are stored before the next list
    for (statements, assigned) in [
        (
            terms,
            vec![
                format!("mass = casadi.SX({})", rows(mass, *n)),
                format!("load = casadi.SX({})", column(load)),
                format!("jacobian = casadi.SX({})", rows(jacobian, *m)),
                format!("bias = casadi.SX({})", column(bias)),
            ],
        ),
        (zeros, vec![format!("zeros = casadi.SX({})", column(&zeros.outputs))]),
        (position_rates, vec![format!("moved = casadi.SX({})", column(&position_rates.outputs))]),
    ] {
        text += &indented(&[&statements.lines[..], &assigned].concat());
    }
    let _ = writeln!(text, "    return mass, load, jacobian, bias, zeros, moved\n\n{FUNCTIONS}");
    Ok(text)
}

const FUNCTIONS: &str = "
mass, load, jacobian, bias, zeros, moved = terms()
n, m = load.shape[0], zeros.shape[0]
matrix = casadi.blockcat([[mass, -jacobian.T], [jacobian, casadi.SX(m, m)]]) if m else mass
solution = casadi.solve(matrix, -casadi.vertcat(load, bias) if m else -load)

# dy/dt of y = (q, u), the accelerations and the multipliers, and f, zero where the constraints hold
y = casadi.vertcat(q, u)
rates = casadi.Function(\"rates\", [t, y, letters], [casadi.vertcat(moved, solution[:n])], [\"t\", \"y\", \"p\"], [\"dy\"])
accelerations = casadi.Function(\"accelerations\", [t, y, letters], [solution[:n], solution[n:]])
constraints = casadi.Function(\"constraints\", [t, y, letters], [zeros])


def values(**others):
    \"\"\"The letters p with the values of the scene, or others.\"\"\"
    return casadi.DM([others.get(name, value) for name, value in PARAMETERS.items()])
";
