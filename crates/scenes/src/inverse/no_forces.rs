//! Errors of inverse dynamics.

use crate::compiled_system::NotCompiled;
use crate::readiness::without_law;
use model::Model;
use reader::Issue;
use std::fmt;

/// The reason for which a motion has no forces, or they are not unique. Times are in s; residuals are texts with a unit.
#[derive(Clone, Debug, PartialEq)]
pub enum NoForces {
    NotCompiled(NotCompiled),
    /// A prescribed motion is not an expression of time and parameters.
    NotOfTime {
        coordinate: String,
    },
    /// An unknown is neither a parameter nor an input of forces.
    NotForce {
        name: String,
    },
    /// The forces are not linear in the unknown.
    NotLinear {
        parameter: String,
    },
    /// The constraints do not determine the coordinates that are not prescribed.
    Open {
        coordinates: Vec<String>,
        time: f64,
    },
    /// A constraint does not hold along the prescribed motion.
    Unmet {
        constraint: String,
        residual: String,
        time: f64,
    },
    /// The prescribed motion does not satisfy the stabilised equation of a programmed constraint.
    NotLed {
        constraint: String,
        /// The stabilised equation, whose left side must be zero.
        equation: &'static str,
        residual: String,
        time: f64,
    },
    /// A current is prescribed, but no current is free to be chosen.
    NoOpenCurrent,
    /// The law of a current contains its rate and no unknown: the current depends on its start.
    OfItsStart {
        current: String,
    },
    /// No currents give the force that the motion needs in an equation.
    NoCurrent {
        equation: String,
        residual: String,
        time: f64,
    },
    /// The motion does not determine these currents.
    OpenCurrents {
        currents: Vec<String>,
        time: f64,
    },
    /// No equation depends on an unknown at this instant.
    Idle {
        unknown: String,
        time: f64,
    },
    /// The matrix of unknowns and multipliers has fewer independent rows than equations.
    Underactuated {
        rank: usize,
        equations: usize,
        time: f64,
    },
    /// Several forces give the motion.
    NotUnique {
        rank: usize,
        unknowns: usize,
        time: f64,
    },
    NotFinite {
        time: f64,
    },
}

impl fmt::Display for NoForces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotCompiled(why) => write!(f, "{why}"),
            Self::NotOfTime { coordinate } => {
                write!(f, "the motion of `{coordinate}` must be an expression of t and of parameters")
            }
            Self::NotForce { name } => {
                write!(f, "`{name}` is neither a parameter nor an input of forces: an unknown must be one")
            }
            Self::NotLinear { parameter } => write!(f, "the forces are not linear in `{parameter}`"),
            Self::Open { coordinates, time } => write!(
                f,
                "at t = {time} s the constraints do not determine {}: prescribe more coordinates",
                coordinates.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
            ),
            Self::Unmet { constraint, residual, time } => {
                write!(f, "at t = {time} s the prescribed motion leaves {residual} of {constraint}, which must be zero")
            }
            Self::NotLed { constraint, equation, residual, time } => write!(
                f,
                "{constraint} is programmed, and the prescribed motion does not follow it: at t = {time} s {equation} is {residual}, and not \
                 zero; a file without this constraint has forces for any motion"
            ),
            Self::NoOpenCurrent => {
                write!(
                    f,
                    "a current is prescribed, and an equation or another prescription determines the charge of each"
                )
            }
            Self::OfItsStart { current } => write!(
                f,
                "the law of `{current}` contains its rate and no unknown: this current depends on the motion before, and the motion at an instant does \
                 not determine it"
            ),
            Self::NoCurrent { equation, residual, time } => write!(
                f,
                "at t = {time} s no currents are found that give this motion: the equation of forces along `{equation}` leaves {residual}"
            ),
            Self::OpenCurrents { currents, time } => write!(
                f,
                "at t = {time} s the motion does not determine the currents {}: other ones give the same forces",
                currents.join(", ")
            ),
            Self::Idle { unknown, time } => write!(
                f,
                "at t = {time} s no equation of motion holds `{unknown}`: its factor is zero there, and nothing determines it"
            ),
            Self::Underactuated { rank, equations, time } => write!(
                f,
                "at t = {time} s the system is underactuated: {rank} of {equations} equations can be satisfied by the unknowns and reactions; \
                 more unknowns are needed"
            ),
            Self::NotUnique { rank, unknowns, time } => write!(
                f,
                "at t = {time} s {unknowns} unknowns and reactions have the rank {rank}: several forces give this motion; fewer \
                 unknowns are needed"
            ),
            Self::NotFinite { time } => write!(f, "at t = {time} s the equations have no finite value"),
        }
    }
}

impl NoForces {
    /// The issue with its position in the file, and with accepted alternatives.
    pub fn at(&self, model: &Model) -> Issue {
        let of_name = |name: &str| {
            let coordinates = model.coordinates.iter().map(|one| (&one.name, &one.at));
            let parameters = model.parameters.iter().map(|one| (&one.name, &one.at));
            let inputs = model.inputs.iter().map(|one| (&one.name, &one.at));
            let mut all = coordinates.chain(parameters).chain(inputs);
            all.find(|(own, _)| *own == name).map_or(0..0, |(_, at)| at.clone())
        };
        let (place, accepted) = match self {
            Self::NotCompiled(why) => return without_law(model, why, "no forces can be found"),
            Self::NotOfTime { coordinate } => {
                (of_name(coordinate), "a motion such as --motion \"theta = 0.5*sin(t*(2 rad/s))\"")
            }
            Self::NotForce { name } => {
                (of_name(name), "--unknown with a parameter or an input of the file that forces hold")
            }
            Self::NotLinear { parameter } => {
                (of_name(parameter), "an unknown that is a factor of forces, such as their size")
            }
            Self::Open { coordinates, .. } => (
                of_name(coordinates.first().map_or("", String::as_str)),
                "--motion for each coordinate that constraints leave open",
            ),
            Self::Unmet { .. } => {
                (0..0, "motions that meet every constraint; fewer --motion, where constraints give the rest")
            }
            Self::NotLed { .. } => (0..0, "a motion on which the programmed constraint goes to zero by its gains"),
            Self::NoOpenCurrent => (0..0, "--motion for coordinates alone"),
            Self::OfItsStart { .. } => {
                (0..0, "--unknown with the supply of this winding; without it `run` has the current from its start")
            }
            Self::NoCurrent { .. } => (
                0..0,
                "a motion that the machines can give; currents under [start] near those that are sought; as many currents as forces, \
                 where several coordinates move",
            ),
            Self::OpenCurrents { .. } => (
                0..0,
                "--motion for a current in addition, such as --motion \"id = 0\" or --motion \"motor.i_f = (2 A)\"",
            ),
            Self::Idle { unknown, .. } => {
                (of_name(unknown), "an unknown force that acts on the prescribed motion at every instant")
            }
            Self::Underactuated { .. } => (0..0, "as many --unknown forces as the motion has degrees of freedom"),
            Self::NotUnique { .. } => (0..0, "fewer --unknown forces, or constraints that are independent"),
            Self::NotFinite { .. } => (0..0, "a motion along which every force and every constraint has a value"),
        };
        let label = if place.is_empty() { "in this file" } else { "this one" };
        Issue::at(place, self.to_string(), label).accepted(accepted)
    }
}
