//! Export to Python with NumPy: a dictionary of parameters, and functions that return arrays.

use super::{Program, indented};
use std::fmt::Write;

pub(super) fn written(program: &Program) -> String {
    let Program { positions, n, m, parameters, conditions, terms, zeros, position_rates, start, .. } = program;
    let mut text = program.heading("#");
    text += "import numpy as np\n";
    let named = |name: &'static str| if name == "atan2" { "arctan2 as atan2" } else { name };
    let functions: Vec<&str> = program.functions().into_iter().map(named).collect();
    if !functions.is_empty() {
        let _ = writeln!(text, "from numpy import {}", functions.join(", "));
    }
    text += "\nPARAMETERS = {\n";
    for named in parameters {
        let _ = match named.value {
            Some(value) => writeln!(text, "    {:?}: {value:?},  # {}", named.letter, named.unit),
            None => writeln!(text, "    # {:?} has no value: {}", named.letter, named.unit),
        };
    }
    text += "}\n";
    if let Some(start) = start {
        let _ = writeln!(text, "# y = (q, u) at the start\nSTART = np.array({start:?})");
    }
    let mut chosen = String::new();
    if !conditions.is_empty() {
        chosen += "    s = []\n";
    }
    for condition in conditions {
        let _ = writeln!(chosen, "{}    s.append(1.0 if {} else 0.0)", indented(&condition.lines), condition.holds);
    }
    let lines = |lines: &[String]| format!("{chosen}{}", indented(lines));
    let array = |outputs: &[String]| format!("np.array([{}])", outputs.join(", "));
    let rows = |outputs: &[String], rows: usize| format!("{}.reshape({rows}, {n})", array(outputs));
    let (mass, rest) = terms.outputs.split_at(n * n);
    let (load, rest) = rest.split_at(*n);
    let (jacobian, bias) = rest.split_at(m * n);
    let _ = writeln!(
        text,
        "\n\ndef terms(t, q, u, p=PARAMETERS):\n    \"\"\"M, h - Q, J and c.\"\"\"\n{}    mass = {}\n    load = {}\n    jacobian = {}\n    bias = {}\n    \
         return mass, load, jacobian, bias\n\n",
        lines(&terms.lines),
        rows(mass, *n),
        array(load),
        rows(jacobian, *m),
        array(bias),
    );
    let _ = writeln!(
        text,
        "def constraints(t, q, u, p=PARAMETERS):\n    \"\"\"f, zero where the constraints hold.\"\"\"\n{}    return {}\n\n",
        lines(&zeros.lines),
        array(&zeros.outputs),
    );
    let _ = writeln!(
        text,
        "{SOLVE}\n\ndef rates(t, y, p=PARAMETERS):\n    \"\"\"dy/dt of y = (q, u), for an integrator.\"\"\"\n    q, u = y[:{positions}], y[{positions}:]\n\
         {}    moved = {}\n    return np.concatenate([moved, accelerations(t, q, u, p)[0]])",
        indented(&position_rates.lines),
        array(&position_rates.outputs),
    );
    text
}

const SOLVE: &str = "\
def accelerations(t, q, u, p=PARAMETERS):
    \"\"\"u' and lambda; LinAlgError where they are not determined.\"\"\"
    mass, load, jacobian, bias = terms(t, q, u, p)
    n, m = len(load), len(bias)
    matrix = np.block([[mass, -jacobian.T], [jacobian, np.zeros((m, m))]])
    solution = np.linalg.solve(matrix, -np.concatenate([load, bias]))
    return solution[:n], solution[n:]
";
