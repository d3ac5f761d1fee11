//! Systems of papers whose equations of motion are derived for reading, from every crate that is linked.

use std::fmt;
use symbolic::Sym;

/// A principle of mechanics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Principle {
    /// Angular momentum of the mass points.
    Momentum,
    /// Appell's equations from the acceleration energy.
    Appell,
    /// Boltzmann and Hamel: Lagrange in quasi-velocities.
    Hamel,
    /// Lagrange of the second kind.
    Lagrange,
    /// Lagrange and Maxwell, with charges as coordinates: for motors.
    Maxwell,
    /// Newton's and Euler's equations projected onto partial velocities.
    VirtualPower,
    /// The least constraint.
    Gauss,
}

/// An equation: accelerations, or rates of currents, stand on the left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equation {
    pub left: Sym,
    pub right: Sym,
}

/// A system with a name, and its equations by each principle that it is derived by.
#[derive(Clone, Copy, Debug)]
pub struct Derivation {
    pub name: &'static str,
    /// A summary in one line, for lists.
    pub summary: &'static str,
    /// The principles that apply; the first is taken where none is asked for.
    pub principles: &'static [Principle],
    /// The equations by a principle of the list, made in the calling thread.
    pub equations: fn(Principle) -> Result<Vec<Equation>, NotDerived>,
}

inventory::collect!(Derivation);

/// A reason for which nothing was derived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotDerived {
    /// There is no such system.
    UnknownSystem(String),
    /// The principle does not apply to the system.
    Inapplicable { system: &'static str, accepted: &'static [Principle] },
    /// The normal form was given up.
    TooLarge(String),
}

/// Every system with a name, in the order of their names.
pub fn derivations() -> Vec<&'static Derivation> {
    let mut all: Vec<&Derivation> = inventory::iter::<Derivation>().collect();
    all.sort_by_key(|derivation| derivation.name);
    all
}

/// The equations of a system by a principle, or by the first that applies.
///
/// # Errors
/// [`NotDerived`] says which systems or principles would be accepted.
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
