//! Systems of papers whose derived equations of motion a user can print, from all linked crates.

use std::fmt;
use symbolic::Sym;

/// A principle of mechanics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Principle {
    /// The balance of angular momentum of mass points.
    Momentum,
    /// Appell's equations from the acceleration energy.
    Appell,
    /// The equations of Boltzmann and Hamel: Lagrange's equations in quasi-velocities.
    Hamel,
    /// Lagrange's equations of the second kind.
    Lagrange,
    /// Lagrange's equations with charges as coordinates (Maxwell), for motors.
    Maxwell,
    /// Newton's and Euler's equations projected onto partial velocities.
    VirtualPower,
    /// Gauss' principle of least constraint.
    Gauss,
}

/// An equation; accelerations, or time derivatives of currents, are on the left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equation {
    pub left: Sym,
    pub right: Sym,
}

/// A named system with its equations by each of its principles.
#[derive(Clone, Copy, Debug)]
pub struct Derivation {
    pub name: &'static str,
    /// A summary in one line.
    pub summary: &'static str,
    /// The principles that apply to the system; the first is the default.
    pub principles: &'static [Principle],
    /// Derives the equations by a principle of the list, in the calling thread.
    pub equations: fn(Principle) -> Result<Vec<Equation>, NotDerived>,
}

inventory::collect!(Derivation);

/// The reason for which no equations were derived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotDerived {
    /// No system has this name.
    UnknownSystem(String),
    /// The principle does not apply to the system.
    Inapplicable { system: &'static str, accepted: &'static [Principle] },
    /// The computation of the normal form was given up.
    TooLarge(String),
}

/// All named systems, ordered by name.
pub fn derivations() -> Vec<&'static Derivation> {
    let mut all: Vec<&Derivation> = inventory::iter::<Derivation>().collect();
    all.sort_by_key(|derivation| derivation.name);
    all
}

/// The equations of a system by a principle; with `None`, by its default principle.
///
/// # Errors
/// [`NotDerived`], for an unknown system (with its name), a principle that does not apply (with those that do), or an expression that is too large.
pub fn derive(system: &str, principle: Option<Principle>) -> Result<Vec<Equation>, NotDerived> {
    let known = derivations().into_iter().find(|derivation| derivation.name == system);
    let Some(&Derivation { name, principles, equations, .. }) = known else {
        return Err(NotDerived::UnknownSystem(system.into()));
    };
    match principle.or_else(|| principles.first().copied()) {
        Some(principle) if principles.contains(&principle) => equations(principle),
        _ => Err(NotDerived::Inapplicable { system: name, accepted: principles }),
    }
}

impl Principle {
    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Momentum => "momentum",
            Self::Appell => "appell",
            Self::Hamel => "hamel",
            Self::Lagrange => "lagrange",
            Self::Maxwell => "maxwell",
            Self::VirtualPower => "virtual-power",
            Self::Gauss => "gauss",
        }
    }
}

impl fmt::Display for NotDerived {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownSystem(name) => {
                let known: Vec<&str> = derivations().iter().map(|derivation| derivation.name).collect();
                write!(f, "there is no system `{name}`; there are: {}", known.join(", "))
            }
            Self::Inapplicable { system, accepted } => {
                let accepted: Vec<&str> = accepted.iter().map(|principle| principle.name()).collect();
                write!(f, "for `{system}` the principle may be: {}", accepted.join(", "))
            }
            Self::TooLarge(reason) => write!(f, "the equations have no normal form: {reason}"),
        }
    }
}

impl std::error::Error for NotDerived {}
