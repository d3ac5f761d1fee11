//! Export to SymPy: a Python module with parameters as symbols, and coordinates as functions of the time.

use super::conditions::left_out;
use super::cosines::Cosine;
use super::identifiers::identifiers;
use super::matrix_form::{HeldEquation, MatrixForm};
use crate::Trace;
use std::fmt::Write;
use symbolic::{Sym, substitute_all};

/// Reserved names: keywords of Python, imported names, and names that the module defines.
const WORDS: &str = "False None True and as assert async await break class continue def del elif else except finally for from global \
    if import in is lambda nonlocal not or pass raise return try while with print Derivative Function Matrix Piecewise Rational Subs Symbol \
    atan2 cos exp log pi sin sqrt tanh t q values mass_matrix inertia forces jacobian bias multipliers constraints equations";

/// Additional reserved names if the speeds are not only rates of coordinates.
const WORDS_OF_TURNS: &str = "u kinematics";

/// Returns the module.
///
/// A free frame has four coordinates, a quaternion; these and its angular velocity along its own axes are separate functions of time.
///
/// # Errors
/// An expression is too long to be printed.
pub fn sympy(trace: &Trace<'_>, form: &MatrixForm) -> Result<String, String> {
    let own = form.plain();
    let turns = form.has_own_speeds();
    let free = &form.speeds[own..];
    let conditions: Vec<Sym> = form.switches.iter().map(|(letter, _)| *letter).collect();
    let cosines: Vec<Sym> = form.cosines.iter().map(|cosine| cosine.letter).collect();
    let coefficients = form.quasi.iter().flat_map(|quasi| &quasi.coefficients);
    let coefficients: Vec<Sym> = coefficients.flat_map(|each| [each.letter, each.rate]).collect();
    let assigned = coefficients.len() + cosines.len() + conditions.len();
    let letters: Vec<Sym> = [
        &form.parameters[..],
        &form.positions,
        free,
        &form.multipliers,
        &form.inputs,
        &coefficients,
        &cosines,
        &conditions,
    ]
    .concat();
    let words = if turns { format!("{WORDS} {WORDS_OF_TURNS}") } else { WORDS.to_owned() };
    let names = identifiers(&letters, &words);
    let (parameters, rest) = names.split_at(form.parameters.len());
    let (coordinates, rest) = rest.split_at(form.positions.len());
    let (turning, rest) = rest.split_at(free.len());
    let multipliers = &rest[..form.multipliers.len()];
    let switches = &names[names.len() - conditions.len()..];
    // rates are derivatives of functions, with unused names
    let rate = |order: usize, of: &[String]| -> Vec<String> {
        let name = |name: &String| format!("{name}{}", "_dot".repeat(order));
        let all = of.iter().map(name);
        all.map(|mut name| {
            while names.contains(&name) {
                name.push('_');
            }
            name
        })
        .collect()
    };
    let speeds = [rate(1, &coordinates[..own]), turning.to_vec()].concat();
    let accelerations = [rate(2, &coordinates[..own]), rate(1, turning)].concat();
    let olds = letters.iter().chain(&form.speeds[..own]).chain(&form.accelerations);
    let news = names.iter().chain(&speeds[..own]).chain(&accelerations).map(|name| Sym::symbol(name));
    let renamed: Vec<(Sym, Sym)> = olds.copied().zip(news).collect();
    let moved = substitute_all(&form.position_rates[own..], &renamed);
    let form = form.renamed(&renamed).for_reading();
    form.is_written_out()?;

    let rate = if turns { "u'" } else { "q''" };
    let law = match form.multipliers.is_empty() {
        true => format!("# mass_matrix*{rate} + inertia = forces\n"),
        false => format!(
            "# mass_matrix*{rate} + inertia = forces + jacobian.T*multipliers, jacobian*{rate} + bias = 0, constraints = 0\n\
             # jacobian: derivatives of each constraint's rate with respect to the speeds; a positive multiplier acts along its row\n"
        ),
    };
    let mut text = format!(
        "{law}\
         from sympy import Derivative, Function, Matrix, Piecewise, Rational, Subs, Symbol, atan2, cos, exp, log, pi, sin, sqrt, tanh\n\n\
         t = Symbol(\"t\")\n",
    );
    let titled = |(k, held): (usize, &HeldEquation)| {
        held.axis.as_ref().map(|axis| format!("# multiplier {}: the reaction along {axis}\n", k + 1))
    };
    text.extend(form.constraints.iter().enumerate().filter_map(titled));
    text.extend(left_out(trace, &form).into_iter().map(|line| format!("# {line}\n")));
    for (letter, name) in letters.iter().zip(&names).take(names.len() - assigned) {
        let _ = match coordinates.contains(name) || turning.contains(name) {
            true => writeln!(text, "{name} = Function({:?})(t)", letter.to_string()),
            false => writeln!(text, "{name} = Symbol({:?})", letter.to_string()),
        };
    }
    for (k, name) in coordinates[..own].iter().enumerate() {
        let _ = writeln!(text, "{} = {name}.diff(t)\n{} = {name}.diff(t, 2)", speeds[k], accelerations[k]);
    }
    for (name, rate) in turning.iter().zip(&accelerations[own..]) {
        let _ = writeln!(text, "{rate} = {name}.diff(t)");
    }
    for Cosine { letter, meaning, value } in &form.cosines {
        let _ = writeln!(text, "{letter} = {}  # {meaning}", value.sympy());
    }
    // the rates depend on all coefficients
    let coefficients = form.quasi.iter().flat_map(|quasi| &quasi.coefficients);
    let rates = coefficients.clone().map(|each| (each.rate, each.rate_is));
    for (letter, is) in coefficients.map(|each| (each.letter, each.is)).chain(rates) {
        let _ = writeln!(text, "{letter} = {}", is.sympy());
    }
    for (place, (name, (_, condition))) in switches.iter().zip(&form.switches).enumerate() {
        let _ = writeln!(text, "{name} = Piecewise((1, {} {} 0), (0, True))", condition.sympy(), form.relation(place));
    }
    let _ = writeln!(text, "\nvalues = {{");
    for (name, parameter) in parameters.iter().zip(&trace.model.parameters) {
        let _ = match parameter.value {
            Some(value) => writeln!(text, "    {name}: {value:?},  # {}", parameter.unit),
            None => writeln!(text, "    # {name} has no value: {}", parameter.written),
        };
    }
    let _ = writeln!(text, "}}\n\nq = Matrix([{}])", coordinates.join(", "));
    let accelerations = if turns { "u.diff(t)" } else { "q.diff(t, 2)" };
    if turns {
        let rates = coordinates[own..].iter().zip(&moved);
        let rates: String = rates.map(|(name, rate)| format!("    {name}.diff(t) - ({}),\n", rate.sympy())).collect();
        let (of_speeds, of_rates) = match form.quasi {
            None => (
                "speeds; of a free frame its angular velocity along its own axes",
                "the rates of each free frame's quaternion by its angular velocity",
            ),
            Some(_) => ("quasi-velocities", "kinematic equations, the rates of all coordinates by quasi-velocities"),
        };
        for (name, is) in
            trace.model.quasi_velocities.iter().zip(form.quasi.iter().flat_map(|quasi| &quasi.definitions))
        {
            let _ = writeln!(text, "# {} = {}", name.name, is.decimal_text());
        }
        let _ = writeln!(
            text,
            "# {of_speeds}\nu = Matrix([{}])\n# zero: {of_rates}\nkinematics = Matrix([\n{rates}])",
            speeds.join(", "),
        );
    }
    let sympy = |values: &[Sym]| values.iter().map(|value| value.sympy()).collect::<Vec<_>>().join(", ");
    let rows = |rows: &mut dyn Iterator<Item = &Vec<Sym>>| -> String {
        rows.map(|row| format!("    [{}],\n", sympy(row))).collect()
    };
    let column = |values: &[Sym]| values.iter().map(|value| format!("    {},\n", value.sympy())).collect::<String>();
    let _ = writeln!(text, "mass_matrix = Matrix([\n{}])", rows(&mut form.mass.iter()));
    let _ = writeln!(text, "inertia = Matrix([\n{}])", column(&form.inertia));
    let _ = writeln!(text, "forces = Matrix([\n{}])", column(&form.forces));
    if form.multipliers.is_empty() {
        let _ = writeln!(text, "\nequations = mass_matrix*{accelerations} + inertia - forces");
        return Ok(text);
    }
    let zeros: Vec<Sym> = form.constraints.iter().map(|held| held.zero).collect();
    let biases: Vec<Sym> = form.constraints.iter().map(|held| held.bias).collect();
    let _ = writeln!(text, "constraints = Matrix([\n{}])", column(&zeros));
    let _ = writeln!(text, "jacobian = Matrix([\n{}])", rows(&mut form.constraints.iter().map(|held| &held.row)));
    let _ = writeln!(text, "bias = Matrix([\n{}])", column(&biases));
    let _ = writeln!(text, "multipliers = Matrix([{}])", multipliers.join(", "));
    let _ = writeln!(text, "\nequations = mass_matrix*{accelerations} + inertia - forces - jacobian.T*multipliers");
    Ok(text)
}

impl MatrixForm {
    /// Checks that all expressions of the form can be printed.
    ///
    /// # Errors
    /// An expression is too long to be printed.
    fn is_written_out(&self) -> Result<(), String> {
        let long = self
            .expressions()
            .map(|one| one.sympy())
            .find_map(|text| text.strip_prefix("# ").map(|text| text.trim_end().to_owned()));
        match long {
            None => Ok(()),
            Some(text) => {
                Err(format!("{text} is too long for SymPy; c, python and rust write these equations as code"))
            }
        }
    }
}
