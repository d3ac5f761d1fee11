//! `dalembert derive`: equations of motion by a chosen principle.

use crate::arguments::{Derive, Equations, PrincipleName};
use crate::ending::{Ending, print};
use derivations::derive::{Equation, Principle, derive as equations_of};

/// Prints the equations.
pub fn derive(asked: &Derive) -> Result<Ending, Ending> {
    let equations = equations_of(&asked.system, asked.principle.map(Principle::from)).map_err(Ending::refused)?;
    let line = |equation: &Equation| match asked.format {
        Equations::Text => format!("{} = {}\n", equation.left, equation.right),
        Equations::Latex => format!("{} = {}\n", equation.left.latex(), equation.right.latex()),
    };
    print(&equations.iter().map(line).collect::<String>())?;
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
