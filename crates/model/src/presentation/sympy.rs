//! A whole system as a module for SymPy: letters as symbols, coordinates as functions of the time.

use super::identifiers::identifiers;
use super::matrix_form::MatrixForm;
use crate::Trace;
use std::fmt::Write;
use symbolic::Sym;

/// Words of Python, what the module imports, and what it defines.
const WORDS: &str = "False None True and as assert async await break class continue def del elif else except finally for from global \
    if import in is lambda nonlocal not or pass raise return try while with print Derivative Function Matrix Piecewise Rational Subs Symbol \
    atan2 cos exp log pi sin sqrt tanh t q values mass_matrix inertia forces jacobian bias multipliers constraints equations";

/// The module.
///
/// # Errors
/// Where a frame is free.
pub fn sympy(trace: &Trace<'_>, form: &MatrixForm) -> Result<String, String> {
    super::no_free_frame(trace)?;
    let conditions: Vec<Sym> = form.switches.iter().map(|(letter, _)| *letter).collect();
    let letters: Vec<Sym> = [&form.parameters, &form.coordinates, &form.multipliers, &form.inputs, &conditions]
        .into_iter()
        .flatten()
        .copied()
        .collect();
    let names = identifiers(&letters, WORDS);
    let (parameters, rest) = names.split_at(form.parameters.len());
    let (coordinates, rest) = rest.split_at(form.coordinates.len());
    let multipliers = &rest[..form.multipliers.len()];
    let switches = &names[names.len() - conditions.len()..];
    // rates are derivatives of functions, under names that no letter has
    let rate = |order: usize| -> Vec<String> {
        let name = |name: &String| format!("{name}{}", "_dot".repeat(order));
        let all = coordinates.iter().map(name);
        all.map(|mut name| {
            while names.contains(&name) {
                name.push('_');
            }
            name
        })
        .collect()
    };
    let (speeds, accelerations) = (rate(1), rate(2));
    let olds = letters.iter().chain(&form.speeds).chain(&form.accelerations);
    let news = names.iter().chain(&speeds).chain(&accelerations).map(|name| Sym::symbol(name));
    let form = form.renamed(&olds.copied().zip(news).collect::<Vec<_>>()).for_reading();

    let mut text = String::from(
        "# mass_matrix*q'' + inertia = forces + jacobian.T*multipliers, jacobian*q'' + bias = 0, constraints = 0\n\
         # jacobian: derivatives of each constraint's rate by the speeds; a positive multiplier acts along its row\n\
         from sympy import Derivative, Function, Matrix, Piecewise, Rational, Subs, Symbol, atan2, cos, exp, log, pi, sin, sqrt, tanh\n\n\
         t = Symbol(\"t\")\n",
    );
    for (letter, name) in letters.iter().zip(&names).take(names.len() - switches.len()) {
        let _ = match coordinates.contains(name) {
            true => writeln!(text, "{name} = Function({:?})(t)", letter.to_string()),
            false => writeln!(text, "{name} = Symbol({:?})", letter.to_string()),
        };
    }
    for (k, name) in coordinates.iter().enumerate() {
        let _ = writeln!(text, "{} = {name}.diff(t)\n{} = {name}.diff(t, 2)", speeds[k], accelerations[k]);
    }
    for (name, (_, condition)) in switches.iter().zip(&form.switches) {
        let _ = writeln!(text, "{name} = Piecewise((1, {} > 0), (0, True))", condition.sympy());
    }
    let _ = writeln!(text, "\nvalues = {{");
    for (name, parameter) in parameters.iter().zip(&trace.model.parameters) {
        let _ = match parameter.value {
            Some(value) => writeln!(text, "    {name}: {value:?},  # {}", parameter.unit),
            None => writeln!(text, "    # {name} has no value: {}", parameter.written),
        };
    }
    let _ = writeln!(text, "}}\n\nq = Matrix([{}])", coordinates.join(", "));
    let sympy = |values: &[Sym]| values.iter().map(|value| value.sympy()).collect::<Vec<_>>().join(", ");
    let rows = |rows: &mut dyn Iterator<Item = &Vec<Sym>>| -> String {
        rows.map(|row| format!("    [{}],\n", sympy(row))).collect()
    };
    let column = |values: &[Sym]| values.iter().map(|value| format!("    {},\n", value.sympy())).collect::<String>();
    let _ = writeln!(text, "mass_matrix = Matrix([\n{}])", rows(&mut form.mass.iter()));
    let _ = writeln!(text, "inertia = Matrix([\n{}])", column(&form.inertia));
    let _ = writeln!(text, "forces = Matrix([\n{}])", column(&form.forces));
    if form.constraints.is_empty() {
        text += "\nequations = mass_matrix*q.diff(t, 2) + inertia - forces\n";
        return Ok(text);
    }
    let zeros: Vec<Sym> = form.constraints.iter().map(|held| held.zero).collect();
    let biases: Vec<Sym> = form.constraints.iter().map(|held| held.bias).collect();
    let _ = writeln!(text, "constraints = Matrix([\n{}])", column(&zeros));
    let _ = writeln!(text, "jacobian = Matrix([\n{}])", rows(&mut form.constraints.iter().map(|held| &held.row)));
    let _ = writeln!(text, "bias = Matrix([\n{}])", column(&biases));
    let _ = writeln!(text, "multipliers = Matrix([{}])", multipliers.join(", "));
    text += "\nequations = mass_matrix*q.diff(t, 2) + inertia - forces - jacobian.T*multipliers\n";
    Ok(text)
}
