//! `dalembert derive`: equations of motion by a chosen principle, or the right-hand side of a scene, in many notations.

mod notation;

use crate::exit::{Exit, print, warn};
use ::scenes::SystemText;
use ::scenes::derivation::{Derived, NamedPrinciple, NotDerived, Notation, derived};
use claims::derivation::{Principle, derive as equations_of};
use clap::ValueEnum;
use model::{constraints, vectors};
use notation::{of_scene, written};
use reader::read_text;
use simulation::Axes;
use simulation::models::{has_model, holds_model};
use std::path::Path;
use symbolic::Language;

/// Arguments of `derive`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The system: `gyrostat`, `motor`; a file with `[coordinates]`, of which the equations of motion are printed; or another scene, SCENE.toml,
    /// of which the right-hand side and the Jacobian are printed as code
    #[arg(value_name = "SYSTEM|SCENE.toml")]
    pub system: String,
    /// The principle; the default is the first one of this list that applies
    #[arg(long, value_enum)]
    pub principle: Option<PrincipleName>,
    /// Format of the equations; for a scene with a built-in motor, text, LaTeX and MathML show the equations of the motor, the other formats the
    /// rates and the Jacobian of the scene
    #[arg(long, value_enum)]
    pub format: Option<Equations>,
    /// For the code of a gyrostat: the equations in the principal axes of A (first) or of A* (second); the default is the first
    #[arg(long)]
    pub form: Option<Axes>,
    /// For a file with `[coordinates]`: prints before the equations the angular velocity of every frame, the position, velocity and
    /// acceleration of every point, and the kind of every constraint
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
    /// Lagrange of the second kind; with multipliers (first kind) if the file has constraints
    #[value(alias = "lagrange-1", alias = "lagrange-2")]
    Lagrange,
    /// Lagrange and Maxwell, for motors
    Maxwell,
    /// Newton's and Euler's equations of every body, projected onto partial velocities (Jourdain, Kane)
    #[value(alias = "kane", alias = "jourdain")]
    VirtualPower,
    /// Gauss, from the principle of least constraint
    Gauss,
    /// Newton's and Euler's equations of every body with the loads of its joints
    NewtonEuler,
    /// Hamilton's canonical equations, written in the speeds instead of the momenta
    Hamilton,
    /// Maggi: Lagrange's equations along the quasi-velocities of the file, or along independent rates
    Maggi,
    /// Shulgin: the constraints are inserted into the kinetic energy, with correcting terms, along independent rates
    Shulgin,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Equations {
    /// For reading
    Text,
    /// LaTeX for a paper
    Latex,
    /// One element for each equation
    Mathml,
    /// Equations over SymPy symbols; for a scene the rates and the Jacobian over the symbols of its states
    Sympy,
    /// Code without branches, each common subexpression once; for a system the left sides minus the right sides
    C,
    /// As c, in Python
    Python,
    /// As c, in Rust
    Rust,
}

/// Prints the equations.
pub fn derive(asked: &Args) -> Result<Exit, Exit> {
    let path = Path::new(&asked.system);
    // for a scene with a motor, only the motor is shown; with --echo or --principle the equations of the whole system
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

/// Whether a file can be read and its text has a given property.
fn is_held(path: &Path, kind: fn(&str) -> bool) -> bool {
    read_text(path).is_ok_and(|text| kind(&text))
}

/// The equations of motion of a system that is defined in its file.
fn of_model(asked: &Args, path: &Path) -> Result<String, Exit> {
    refuse_form(asked, "a system that is written in its file has one form")?;
    let principle = asked.principle.map(in_file).transpose()?;
    let format = asked.format.unwrap_or(Equations::Text);
    let is_code = matches!(format, Equations::C | Equations::Python | Equations::Rust);
    let written = derived(&SystemText::read(path)?, principle, is_code, |derived| {
        let echo = match asked.echo {
            true => [vectors(derived.trace), constraints(derived.trace)].concat().join("\n") + "\n\n",
            false => String::new(),
        };
        let equations = match format {
            Equations::Text => derived.written(Notation::Text),
            Equations::Latex => derived.written(Notation::Latex),
            Equations::Mathml => mathml(derived),
            Equations::Sympy => derived.written(Notation::Sympy),
            Equations::C => derived.written(Notation::Code(Language::C)),
            Equations::Python => derived.written(Notation::Code(Language::Python)),
            Equations::Rust => derived.written(Notation::Code(Language::Rust)),
        };
        (derived.vanishes_at_start, equations.map(|equations| echo + &equations))
    });
    let (vanishes_at_start, written) = written.map_err(|why| match why {
        NotDerived::Text(error) => Exit::from(error),
        NotDerived::Refused(why) => Exit::refused(why),
    })?;
    if vanishes_at_start {
        warn(&format!(
            "warning: {}: the quasi-velocities do not determine the speeds at the start: these equations have no value there",
            asked.system
        ));
    }
    written.map_err(Exit::refused)
}

/// The equations as MathML, one element each.
fn mathml(derived: &Derived<'_, '_>) -> Result<String, String> {
    let equations = model::typeset(derived.trace, &derived.for_reading()?).into_iter().flatten();
    let typeset = equations.map(|each| charts::mathml(&format!("{} = {}", each.left, each.right)));
    let lines: Vec<String> = typeset.collect::<Result<_, _>>().map_err(|why| why.to_string())?;
    Ok(lines.join("\n") + "\n")
}

/// The principle for a system that is defined in its file.
fn in_file(name: PrincipleName) -> Result<NamedPrinciple, Exit> {
    let named = name.to_possible_value().and_then(|value| NamedPrinciple::of_name(value.get_name()).ok());
    // some principles exist only for built-in systems
    named.ok_or_else(|| {
        let names: Vec<&str> = NamedPrinciple::all().into_iter().map(NamedPrinciple::name).collect();
        let own = name.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned());
        Exit::refused(format!(
            "`{own}` applies to built-in systems only; for a system in its file: {}",
            names.join(", ")
        ))
    })
}

/// Refuses --form, which is accepted only for the code of a scene.
fn refuse_form(asked: &Args, why: &str) -> Result<(), Exit> {
    match asked.form {
        None => Ok(()),
        Some(_) => Err(Exit::refused(format!(
            "--form does not apply to `derive {}` in this format: {why}; it is accepted for the code of a scene",
            asked.system
        ))),
    }
}

/// The principle for one of the built-in systems.
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
