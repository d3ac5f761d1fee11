//! Equations of the built-in systems, and right-hand sides of scenes, in many notations.

use super::{Args, Equations, refuse_form};
use crate::exit::Exit;
use crate::run::one_form;
use claims::derivation::Equation;
use motor::reading::equations_of;
use reader::Family;
use std::path::Path;
use studies::scene::Scene;
use symbolic::{Language, Sym, Tape};

/// Equations in a notation.
pub(super) fn written(equations: &[Equation], format: Equations) -> Result<String, Exit> {
    let lines = |line: &dyn Fn(&Equation) -> String| equations.iter().map(|each| line(each) + "\n").collect();
    let latex = |each: &Equation| format!("{} = {}", each.left.decimal_latex(), each.right.decimal_latex());
    match format {
        Equations::Text => Ok(lines(&|each| format!("{} = {}", each.left.decimal_text(), each.right.decimal_text()))),
        Equations::Latex => Ok(lines(&latex)),
        Equations::Mathml => {
            let typeset = equations.iter().map(|each| charts::mathml(&latex(each)).map(|math| math + "\n"));
            typeset.collect::<Result<_, _>>().map_err(Exit::refused)
        }
        Equations::Sympy => Ok(sympy(equations)),
        Equations::C => residuals(equations, &C),
        Equations::Python => residuals(equations, &PYTHON),
        Equations::Rust => residuals(equations, &RUST),
    }
}

/// The letters of all equations, in the order of their first occurrence.
fn letters(equations: &[Equation]) -> Vec<Sym> {
    let mut letters = Vec::new();
    for letter in equations.iter().flat_map(|each| [each.left, each.right]).flat_map(Sym::symbols_of) {
        if !letters.contains(&letter) {
            letters.push(letter);
        }
    }
    letters
}

/// A Python module with the letters as SymPy symbols and the list `equations`.
fn sympy(equations: &[Equation]) -> String {
    let names: Vec<String> = letters(equations).into_iter().filter_map(Sym::identifier).collect();
    let mut text = format!(
        "from sympy import Eq, Rational, cos, sin, sqrt, symbols\n\n{} = symbols(\"{}\")\nequations = [\n",
        names.join(", "),
        names.join(" ")
    );
    for Equation { left, right } in equations {
        text += &format!("    Eq({}, {}),\n", left.sympy(), right.sympy());
    }
    text + "]\n"
}

/// A language for straight-line code: the sign of its comments, and the lines before the functions.
struct Written {
    language: Language,
    comment: &'static str,
    needs: &'static str,
}

const C: Written = Written { language: Language::C, comment: "//", needs: "#include <math.h>\n\n" };
const PYTHON: Written =
    Written { language: Language::Python, comment: "#", needs: "from math import cos, sin, sqrt\n\n\n" };
const RUST: Written = Written { language: Language::Rust, comment: "//", needs: "\n" };

/// The code of a function whose values are the left sides minus the right sides of the equations.
fn residuals(equations: &[Equation], written: &Written) -> Result<String, Exit> {
    let letters = letters(equations);
    let sides: Vec<Sym> = equations.iter().map(|each| each.left - each.right).collect();
    let tape = Tape::record(&letters, &sides).map_err(Exit::refused)?;
    in_doubles(&tape)?;
    let names: Vec<String> = letters.iter().map(Sym::to_string).collect();
    let Written { language, comment, needs } = written;
    let code = tape.source(*language, "residuals");
    Ok(format!("{comment} The letters y: {}.\n{comment} Left sides less right sides.\n{needs}{code}", names.join(", ")))
}

/// Refuses a law with a constant outside the range of double precision, in place of which the code would contain infinity or zero.
fn in_doubles(tape: &Tape) -> Result<(), Exit> {
    tape.beyond_range().map_or(Ok(()), |constant| {
        let mut digits = constant.to_string();
        if digits.len() > 40 {
            digits.truncate(40);
            digits += "...";
        }
        Err(Exit::refused(format!(
            "a constant of the law is beyond the range of double precision, {digits}; data whose products and quotients lie \
             between 1e-307 and 1e308 are accepted"
        )))
    })
}

/// The equations of the motor of a scene, or the code for the rates and the Jacobian of the scene.
pub(super) fn of_scene(asked: &Args) -> Result<String, Exit> {
    let format = asked.format.unwrap_or(Equations::Text);
    let sympy = Written { needs: "from sympy import cos, sin, sqrt, symbols\n\n\n", ..PYTHON };
    let Written { language, comment, needs } = match format {
        Equations::C => C,
        Equations::Python => PYTHON,
        Equations::Sympy => sympy,
        Equations::Rust => RUST,
        Equations::Text | Equations::Latex | Equations::Mathml => {
            refuse_form(asked, "the motor's torque and currents are the same in every form")?;
            if asked.principle.is_some() {
                return Err(Exit::refused(
                    "--principle does not apply to the motor of a scene, which follows Maxwell; leave it out",
                ));
            }
            let scene = Scene::open(Path::new(&asked.system))?;
            let motor = equations_of(&scene.machine).map_err(Exit::refused)?;
            return written(&motor, format);
        }
    };
    if asked.principle.is_some() {
        return Err(Exit::refused("a scene's code is of the form that runs; `--form first` or `second` is accepted"));
    }
    let scene = Scene::open(Path::new(&asked.system))?;
    one_form(&scene, asked.form.is_some(), Path::new(&asked.system))?;
    let form = asked.form.unwrap_or_default();
    let (rates, jacobian) = (scene.tape(form), scene.jacobian_tape(form));
    let (rates, jacobian) = (rates.map_err(Exit::refused)?, jacobian.map_err(Exit::refused)?);
    in_doubles(&rates).and_then(|()| in_doubles(&jacobian))?;
    let start: Vec<String> = scene.state(form).iter().map(|y| format!("{y:?}")).collect();
    let mut text = format!(
        "{comment} The states y: {}; in the axes of the {} form.\n{comment} At the start: {}\n{comment} `rates` is dy/dt, \
         `jacobian` its derivatives by y, row after row.\n{needs}{}\n{}",
        scene.names().join(", "),
        form,
        start.join(", "),
        rates.source(language, "rates"),
        jacobian.source(language, "jacobian"),
    );
    if format == Equations::Sympy {
        text += &format!("\n\ny = symbols(\"y:{}\")\nequations = rates(y)\n", rates.inputs());
    }
    Ok(text)
}
