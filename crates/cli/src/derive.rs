//! `dalembert derive`: equations of motion by a chosen principle, or a scene's right-hand side as code.

use crate::arguments::{Derive, Equations, PrincipleName};
use crate::ending::{Ending, print};
use derivations::derive::{Equation, Principle, derive as equations_of};
use derivations::scene::{Family, Scene};
use std::path::Path;
use symbolic::Language;

/// Prints the equations.
pub fn derive(asked: &Derive) -> Result<Ending, Ending> {
    if asked.system.ends_with(".toml") {
        return code(asked);
    }
    let equations = equations_of(&asked.system, asked.principle.map(Principle::from)).map_err(Ending::refused)?;
    let line = |equation: &Equation| match asked.format.unwrap_or(Equations::Text) {
        Equations::Text => Ok(format!("{} = {}\n", equation.left, equation.right)),
        Equations::Latex => Ok(format!("{} = {}\n", equation.left.latex(), equation.right.latex())),
        Equations::C | Equations::Python | Equations::Rust => {
            Err(Ending::refused("code is written for a scene, which has numbers for its data: give a SCENE.toml"))
        }
    };
    print(&equations.iter().map(line).collect::<Result<String, Ending>>()?)?;
    Ok(Ending::Done)
}

/// Prints a scene's rates and Jacobian as functions.
fn code(asked: &Derive) -> Result<Ending, Ending> {
    let (language, comment, needs) = match asked.format.unwrap_or(Equations::C) {
        Equations::C => (Language::C, "//", "#include <math.h>\n\n"),
        Equations::Python => (Language::Python, "#", "from math import cos, sin, sqrt\n\n\n"),
        Equations::Rust => (Language::Rust, "//", "\n"),
        Equations::Text | Equations::Latex => {
            return Err(Ending::refused("a scene is written as code: --format c, python or rust is accepted"));
        }
    };
    if asked.principle.is_some() {
        return Err(Ending::refused("a scene's code is of the form that runs; `--form first` or `second` is accepted"));
    }
    let scene = Scene::open(Path::new(&asked.system))?;
    let (rates, jacobian) = (scene.tape(asked.form), scene.jacobian_tape(asked.form));
    let (rates, jacobian) = (rates.map_err(Ending::refused)?, jacobian.map_err(Ending::refused)?);
    let start: Vec<String> = scene.state(asked.form).iter().map(|y| format!("{y:?}")).collect();
    print(&format!(
        "{comment} The states y: {}; in the axes of the {} form.\n{comment} At the start: {}\n{comment} `rates` is dy/dt, \
         `jacobian` its derivatives by y, row after row.\n{needs}{}\n{}",
        scene.names().join(", "),
        asked.form,
        start.join(", "),
        rates.source(language, "rates"),
        jacobian.source(language, "jacobian"),
    ))?;
    Ok(Ending::Done)
}

impl From<PrincipleName> for Principle {
    fn from(name: PrincipleName) -> Self {
        match name {
            PrincipleName::Momentum => Principle::Momentum,
            PrincipleName::Appell => Principle::Appell,
            PrincipleName::Hamel => Principle::Hamel,
            PrincipleName::Lagrange => Principle::Lagrange,
            PrincipleName::Maxwell => Principle::Maxwell,
        }
    }
}
