//! `dalembert derive`: equations of motion by a chosen principle, or a scene's right-hand side, in many notations.

mod notation;

use crate::exit::{Exit, print, warn};
use ::scenes::{Task, read_model, start_of, starting, without_implied};
use claims::derivation::{Principle, derive as equations_of};
use clap::{Args, ValueEnum};
use model::{Fault, MatrixForm, Model, QuasiPrinciple, QuasiVelocities, Trace, constraints, vectors};
use notation::{of_scene, written};
use reader::read_text;
use simulation::Axes;
use simulation::models::{has_model, holds_model};
use std::path::Path;
use symbolic::Language;

/// What is to be derived, and how.
#[derive(Args, Debug)]
pub struct Asked {
    /// The system: gyrostat, motor; a file with `[coordinates]`, whose equations of motion are written; or another scene, SCENE.toml,
    /// whose right-hand side and Jacobian are written as code
    #[arg(value_name = "SYSTEM|SCENE.toml")]
    pub system: String,
    /// The principle; without it the first that applies
    #[arg(long, value_enum)]
    pub principle: Option<PrincipleName>,
    /// How to print the equations; of a scene text, LaTeX and MathML have its motor, the others its rates and Jacobian
    #[arg(long, value_enum)]
    pub format: Option<Equations>,
    /// For a scene's code: the equations in the axes of A (first) or of A* (second); without it the first
    #[arg(long)]
    pub form: Option<Axes>,
    /// Of a file with `[coordinates]`: first the angular velocity of every frame, the position, velocity and acceleration of every point, and the kind of every constraint
    #[arg(long)]
    pub echo: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum PrincipleName {
    /// Angular momentum of the mass points
    Momentum,
    /// Appell, from the acceleration energy
    Appell,
    /// Boltzmann and Hamel, in quasi-velocities
    Hamel,
    /// Lagrange of the second kind; with multipliers of the constraints (first kind) where a file has these
    #[value(alias = "lagrange-1", alias = "lagrange-2")]
    Lagrange,
    /// Lagrange and Maxwell, for motors
    Maxwell,
    /// Newton's and Euler's equations of every body, projected onto partial velocities (Jourdain, Kane)
    #[value(alias = "kane", alias = "jourdain")]
    VirtualPower,
    /// Gauss, from the least constraint
    Gauss,
    /// Newton's and Euler's equations of every body with the loads of its joints
    NewtonEuler,
    /// Hamilton's canonical equations, back along the speeds
    Hamilton,
    /// Maggi: Lagrange's equations along the quasi-velocities of the file, or along independent rates
    Maggi,
    /// Shulgin: the kinetic energy knows the constraints, along independent rates
    Shulgin,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Equations {
    /// For reading
    Text,
    Latex,
    /// One element for each equation
    Mathml,
    /// Equations over symbols of their own; of a scene the rates and the Jacobian over the symbols of its states
    Sympy,
    /// Straight-line code, every common part once; of a system the left sides less the right ones
    C,
    Python,
    Rust,
}

/// Prints the equations.
pub fn derive(asked: &Asked) -> Result<Exit, Exit> {
    let path = Path::new(&asked.system);
    // of a scene with a motor its motor is shown, and by a principle the equations of the whole
    let of_whole = asked.echo || asked.principle.is_some();
    let is_model = is_held(path, if of_whole { has_model } else { holds_model });
    if asked.echo && !is_model {
        return Err(Exit::refused("--echo is about the vectors of a file with a system; leave it out"));
    }
    let text = match asked.system.ends_with(".toml") {
        true if is_model => of_model(asked, path)?,
        true => of_scene(asked)?,
        false => {
            refuse_form(asked, "equations are in the axes of no form")?;
            let principle = asked.principle.map(built_in).transpose()?;
            let equations = equations_of(&asked.system, principle).map_err(Exit::refused)?;
            written(&equations, asked.format.unwrap_or(Equations::Text))?
        }
    };
    print(&text)?;
    Ok(Exit::Done)
}

/// Whether a file can be read and its text is of a kind.
fn is_held(path: &Path, kind: fn(&str) -> bool) -> bool {
    read_text(path).is_ok_and(|text| kind(&text))
}

/// The equations of motion of a system that is written in its file.
fn of_model(asked: &Asked, path: &Path) -> Result<String, Exit> {
    refuse_form(asked, "a system that is written in its file has one form")?;
    let mut model = read_model(path, Task::Write)?;
    // what follows from other constraints is no part of the equations
    without_implied(path, &mut model)?;
    let file = read_text(path)?;
    if let Some(principle) = quasi_principle(asked, &model) {
        let is_own = !model.quasi_velocities.is_empty() && principle != QuasiPrinciple::Shulgin;
        if !is_own {
            if model.constraints.is_empty() {
                return Err(Exit::refused(format!(
                    "--principle {0} does not apply to {1}: without constraints its equations are those of lagrange; accepted is \
                     --principle lagrange, or a system with constraints",
                    principle.name(),
                    path.display()
                )));
            }
            // rates are independent there
            if let Ok(state) = start_of(&model) {
                model = starting(&model, &state);
            }
            model = model.along_independent_rates();
        }
        return in_quasi_velocities(asked, &model, &file, principle);
    }
    let principle = match asked.principle {
        None if model.energies.kinetic.is_some() => model::principles::Principle::Lagrange,
        Some(PrincipleName::Lagrange) => model::principles::Principle::Lagrange,
        Some(PrincipleName::Appell) => model::principles::Principle::Appell,
        Some(PrincipleName::Gauss) => model::principles::Principle::Gauss,
        Some(PrincipleName::NewtonEuler) => model::principles::Principle::NewtonEuler,
        Some(PrincipleName::Hamel) => model::principles::Principle::Hamel,
        Some(PrincipleName::Hamilton) => model::principles::Principle::Hamilton,
        Some(PrincipleName::Momentum | PrincipleName::Maxwell) => {
            return Err(Exit::refused(
                "for a system that is written in its file the principle may be: virtual-power, lagrange, appell, gauss, newton-euler, \
                 hamel, hamilton, maggi, shulgin",
            ));
        }
        _ => model::principles::Principle::VirtualPower,
    };
    // what is written there means nothing outside of its graph
    symbolic::apart(|| {
        let trace = Trace::of(&model);
        let form = MatrixForm::of(&trace, principle).map_err(Exit::refused)?.in_file(&model, &file);
        Ok(echoed(asked, &trace) + &matrix_form(&trace, &form, asked.format.unwrap_or(Equations::Text))?)
    })
}

/// The principle of equations along quasi-velocities; the others keep the rates of all coordinates.
fn quasi_principle(asked: &Asked, model: &Model) -> Option<QuasiPrinciple> {
    let has_own = !model.quasi_velocities.is_empty();
    match asked.principle {
        Some(PrincipleName::Maggi) => Some(QuasiPrinciple::Maggi),
        Some(PrincipleName::Shulgin) => Some(QuasiPrinciple::Shulgin),
        _ if !has_own => None,
        None if model.energies.kinetic.is_some() || model.energies.coenergy.is_some() => Some(QuasiPrinciple::Hamel),
        None | Some(PrincipleName::VirtualPower) => Some(QuasiPrinciple::VirtualPower),
        Some(PrincipleName::Appell) => Some(QuasiPrinciple::Appell),
        Some(PrincipleName::Hamel) => Some(QuasiPrinciple::Hamel),
        Some(_) => None,
    }
}

/// Equations of more operations have letters for the slopes of speeds, where these make them fewer by a quarter.
const MOST_WITHOUT_LETTERS: f64 = 12_000.0;

/// The equations of motion in the quasi-velocities of a file.
fn in_quasi_velocities(asked: &Asked, model: &Model, file: &str, principle: QuasiPrinciple) -> Result<String, Exit> {
    symbolic::apart(|| {
        let trace = Trace::of(model);
        let start = start_of(model).ok();
        let written = |quasi: Result<QuasiVelocities<'_, '_>, Vec<Fault>>| {
            // judged when the file was read
            let quasi = quasi.map_err(|_| Exit::refused("its quasi-velocities are not independent"))?;
            let form = MatrixForm::in_quasi_velocities(&trace, &quasi, principle).map_err(Exit::refused)?;
            let form = match &start {
                Some(start) => form.with_start(&trace, start),
                None => form,
            };
            Ok::<MatrixForm, Exit>(form.in_file(model, file))
        };
        let mut form = written(QuasiVelocities::of(&trace))?;
        let is_code = matches!(asked.format, Some(Equations::C | Equations::Python | Equations::Rust));
        let operations = form.written_operations();
        if principle != QuasiPrinciple::Hamel && !is_code && operations > MOST_WITHOUT_LETTERS {
            let named = written(QuasiVelocities::named(&trace))?;
            if 4.0 * named.written_operations() < 3.0 * operations {
                form = named;
            }
        }
        let mut divisors = form.quasi.iter().flat_map(|quasi| &quasi.divisors);
        if divisors.any(|divisor| divisor.vanishes_at_start == Some(true)) {
            warn(&format!(
                "warning: {}: the quasi-velocities do not determine the speeds at the start: these equations have no value there",
                asked.system
            ));
        }
        Ok(echoed(asked, &trace) + &matrix_form(&trace, &form, asked.format.unwrap_or(Equations::Text))?)
    })
}

/// Vectors and kinds of constraints, where they are asked for.
fn echoed(asked: &Asked, trace: &Trace<'_>) -> String {
    if asked.echo { [vectors(trace), constraints(trace)].concat().join("\n") + "\n\n" } else { String::new() }
}

/// Longer equations are code alone: a megabyte of text has two hundred thousand operations.
const MOST_WRITTEN: f64 = 1_000_000.0;

/// A system in matrix form in a notation.
fn matrix_form(trace: &Trace<'_>, form: &MatrixForm, format: Equations) -> Result<String, Exit> {
    let code = |language| model::code(trace, form, language).map_err(Exit::refused);
    let is_code = matches!(format, Equations::C | Equations::Python | Equations::Rust);
    if !is_code && !form.is_read() {
        return Err(Exit::refused(format!(
            "in these quasi-velocities the equations have {:.0e} operations, too many to be read; `--format c`, `python` and `rust` \
             write them as code, and `--principle lagrange` writes them in the rates of coordinates",
            form.written_operations()
        )));
    }
    let read = || {
        let read = form.for_reading();
        match read.written_operations() {
            operations if operations > MOST_WRITTEN => Err(Exit::refused(format!(
                "these equations have {operations:.0e} operations where they are written out, too many to be read; `--format c`, `python` \
                 and `rust` write every common part once; `[speeds]` makes equations of chains shorter"
            ))),
            _ => Ok(read),
        }
    };
    match format {
        Equations::Text => Ok(model::text(trace, &read()?)),
        Equations::Latex => Ok(model::latex(trace, &read()?)),
        Equations::Mathml => {
            let equations = model::typeset(trace, &read()?).into_iter().flatten();
            let typeset = equations.map(|each| charts::mathml(&format!("{} = {}", each.left, each.right)));
            let lines: Vec<String> = typeset.collect::<Result<_, _>>().map_err(Exit::refused)?;
            Ok(lines.join("\n") + "\n")
        }
        Equations::Sympy => model::sympy(trace, form).map_err(Exit::refused),
        Equations::C => code(Language::C),
        Equations::Python => code(Language::Python),
        Equations::Rust => code(Language::Rust),
    }
}

/// Forms are of a scene's code alone.
fn refuse_form(asked: &Asked, why: &str) -> Result<(), Exit> {
    match asked.form {
        None => Ok(()),
        Some(_) => Err(Exit::refused(format!(
            "--form does not apply to `derive {}` in this format: {why}; it is accepted for the code of a scene",
            asked.system
        ))),
    }
}

/// The principle of a system that the program brings along.
fn built_in(name: PrincipleName) -> Result<Principle, Exit> {
    Ok(match name {
        PrincipleName::Momentum => Principle::Momentum,
        PrincipleName::Appell => Principle::Appell,
        PrincipleName::Hamel => Principle::Hamel,
        PrincipleName::Lagrange => Principle::Lagrange,
        PrincipleName::Maxwell => Principle::Maxwell,
        PrincipleName::VirtualPower => Principle::VirtualPower,
        PrincipleName::Gauss => Principle::Gauss,
        PrincipleName::NewtonEuler | PrincipleName::Hamilton | PrincipleName::Maggi | PrincipleName::Shulgin => {
            return Err(Exit::refused(
                "newton-euler, hamilton, maggi and shulgin are for a system that is written in its file; a gyrostat follows momentum, appell, hamel \
                 or lagrange, a motor maxwell",
            ));
        }
    })
}
