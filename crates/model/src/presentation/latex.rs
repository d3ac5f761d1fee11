//! Export to LaTeX: every equation of a system, as one text or one by one.

use super::conditions::{Condition, conditions, left_out};
use super::matrix_form::MatrixForm;
use super::with_counts;
use crate::Trace;
use symbolic::Sym;

/// One equation in LaTeX: left and right side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typeset {
    pub left: String,
    pub right: String,
}

/// Returns groups of equations: the form, quasi-velocities, rates of coordinates that are not speeds, symbols in these,
/// direction cosines of free frames, parameters, M, h, Q, constraints with multipliers, constraints that all quasi-velocities satisfy, conditions.
pub fn equations(trace: &Trace<'_>, form: &MatrixForm) -> Vec<Vec<Typeset>> {
    form.tell_letters_apart();
    let equation = |left: String, right: String| Typeset { left, right: with_counts(&right) };
    let held = !form.constraints.is_empty();
    let reactions = if held { r" + \mathbf{J}^{T} \boldsymbol{\lambda}" } else { "" };
    // the speeds of free frames are not rates of coordinates
    let (rate, vector_name, shown) = match form.has_own_speeds() {
        false => (r"\ddot{\mathbf{q}}", r"\mathbf{q}", &form.coordinates),
        true => (r"\dot{\mathbf{u}}", r"\mathbf{u}", &form.speeds),
    };
    let letters: Vec<String> = shown.iter().map(|letter| letter.latex()).collect();
    let mut first = vec![
        equation(format!(r"\mathbf{{M}} {rate} + \mathbf{{h}}"), format!(r"\mathbf{{Q}}{reactions}")),
        equation(vector_name.to_owned(), format!("({})^T", letters.join(", "))),
    ];
    if held {
        first.insert(1, equation(format!(r"\mathbf{{J}} {rate} + \mathbf{{c}}"), r"\mathbf{0}".to_owned()));
    }
    let meanings = form.quasi.iter().flat_map(|quasi| form.speeds.iter().zip(&quasi.definitions));
    let meanings = meanings.filter(|(speed, is)| speed != is);
    let meanings = meanings.map(|(speed, is)| equation(speed.latex(), is.decimal_latex())).collect();
    let turned = form.positions.iter().zip(&form.position_rates).skip(form.plain());
    let turned = turned.map(|(part, rate)| equation(format!(r"\dot{{{}}}", part.latex()), rate.decimal_latex()));
    let turned = turned.filter(|Typeset { left, right }| left != right).collect();
    let coefficients = form.quasi.iter().flat_map(|quasi| &quasi.coefficients).flat_map(|each| {
        [(each.letter, each.is), (each.rate, each.rate_is)]
            .map(|(letter, is)| equation(letter.latex(), is.decimal_latex()))
    });
    let coefficients = coefficients.collect();
    let cosines = form.cosines.iter().map(|cosine| equation(cosine.letter.latex(), cosine.value.decimal_latex()));
    let cosines = cosines.collect();
    let known = trace.model.parameters.iter().zip(&form.parameters).filter(|(parameter, _)| parameter.value.is_some());
    let parameters = known.map(|(parameter, letter)| equation(letter.latex(), quantity(&parameter.written))).collect();
    // c_1 and M may also be parameters of the system
    let n = form.speeds.len();
    let most = n.max(form.constraints.len());
    let entry = |name: &str| match form.free_letter(&[form.free_name(&[name, ""]), ""], most) {
        "" => format!(r"\mathbf{{{name}}}"),
        free => free.to_owned(),
    };
    let matrix = |name: &str, rows: Vec<(String, Sym)>| -> Vec<Typeset> {
        let name = entry(name);
        let written = rows.into_iter().filter(|(_, value)| *value != Sym::ZERO);
        written.map(|(place, value)| equation(format!("{name}_{{{place}}}"), value.decimal_latex())).collect()
    };
    let comma = if most > 9 { "," } else { "" };
    let pair = |i: usize, j: usize| format!("{}{comma}{}", i + 1, j + 1);
    let upper = (0..n).flat_map(|i| (i..n).map(move |j| (i, j)));
    let mass = matrix("M", upper.map(|(i, j)| (pair(i, j), form.mass[i][j])).collect());
    let vector = |name: &str, values: &[Sym]| {
        matrix(name, values.iter().enumerate().map(|(i, v)| ((i + 1).to_string(), *v)).collect())
    };
    let mut held_to = Vec::new();
    for (k, held) in form.constraints.iter().enumerate() {
        let along = held.axis.as_ref().map_or_else(String::new, |axis| format!(r" \quad \text{{along {axis}}}"));
        let zero = held.zero.decimal_latex() + &along.replace('_', r"\_");
        held_to.push(equation(format!("0 = {}_{{{}}}", entry("f"), k + 1), zero));
    }
    for (k, held) in form.constraints.iter().enumerate() {
        held_to.extend(matrix("J", held.row.iter().enumerate().map(|(i, value)| (pair(k, i), *value)).collect()));
        held_to.extend(matrix("c", vec![((k + 1).to_string(), held.bias)]));
    }
    let met = form.quasi.iter().flat_map(|quasi| &quasi.met);
    let met = met.map(|held| equation("0".to_owned(), held.zero.decimal_latex())).collect();
    let chosen = conditions(trace, form).into_iter().map(|Condition { number, letter, is, told }| {
        let bracket = letter.latex();
        let is = format!(r"{} \quad \text{{{}}}", is.decimal_latex(), told.replace('^', r"\^{}"));
        [
            equation(bracket, format!(r"1 \text{{ where condition {number} is positive, else }} 0")),
            equation(format!(r"\text{{condition {number}}}"), is),
        ]
    });
    let chosen: Vec<Typeset> = chosen.flatten().collect();
    let (inertia, forces) = (vector("h", &form.inertia), vector("Q", &form.forces));
    let groups =
        vec![first, meanings, turned, coefficients, cosines, parameters, mass, inertia, forces, held_to, met, chosen];
    groups.into_iter().filter(|group| !group.is_empty()).collect()
}

impl MatrixForm {
    /// Distinguishes symbols with equal LaTeX, such as `lambda_` and `lambda`: the later one, with its rates, is set with its name as in the file.
    fn tell_letters_apart(&self) {
        let letters = [&self.parameters, &self.inputs, &self.positions, &self.speeds, &self.accelerations];
        let mut known: Vec<(String, String, bool)> = Vec::new();
        for letter in std::iter::once(&self.time).chain(letters.into_iter().flatten()) {
            let name = letter.to_string();
            let base = name.trim_end_matches('\'');
            if known.iter().all(|(own, ..)| own != base) {
                let own = Sym::symbol(base).latex();
                let is_taken = known.iter().any(|(_, latex, _)| *latex == own);
                let latex = if is_taken { format!(r"\mathrm{{{}}}", base.replace('_', r"\_")) } else { own };
                known.push((base.to_owned(), latex, is_taken));
            }
            let renamed = known.iter().find(|(own, _, is_taken)| own == base && *is_taken);
            if let Some((_, latex, _)) = renamed {
                let dots = match name.len() - base.len() {
                    0 => latex.clone(),
                    1 => format!(r"\dot{{{latex}}}"),
                    _ => format!(r"\ddot{{{latex}}}"),
                };
                Sym::named(&name, &dots);
            }
        }
    }
}

/// Returns the groups of equations as text, each in an `align` environment of the package `amsmath`.
pub fn latex(trace: &Trace<'_>, form: &MatrixForm) -> String {
    let group = |group: Vec<Typeset>| {
        let lines: Vec<String> = group.iter().map(|Typeset { left, right }| format!("  {left} &= {right}")).collect();
        format!("\\begin{{align}}\n{}\n\\end{{align}}\n", lines.join(" \\\\\n"))
    };
    let left_out = left_out(trace, form).into_iter().map(|line| format!("% {line}\n"));
    equations(trace, form).into_iter().map(group).chain(left_out).collect()
}

/// Converts a quantity to LaTeX: `2 kg m^2` with an upright unit, `deg` as the degree sign.
fn quantity(written: &str) -> String {
    let (number, unit) = written.split_once(' ').unwrap_or((written, ""));
    let number = match number.split_once(['e', 'E']) {
        Some((digits, power)) => format!(r"{digits}\cdot 10^{{{}}}", power.trim_start_matches('+')),
        None => number.to_owned(),
    };
    match unit {
        "" | "1" => number,
        "deg" | "°" => format!(r"{number}^\circ"),
        _ => format!(r"{number}\,\mathrm{{{}}}", unit.replace([' ', '*'], r"\,").replace('%', r"\%")),
    }
}
