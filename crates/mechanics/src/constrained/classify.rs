//! Classification of a system's constraints.
//!
//! * *redundant*: follows from the others;
//! * *rheonomic*: depends on time explicitly;
//! * *nonlinear*: kinematic and not linear in the velocities;
//! * *holonomic in disguise*: kinematic, and integrable together with the others (Frobenius);
//! * *nonholonomic*: kinematic, and not integrable.
//!
//! The last two are properties of the constraints together, and are therefore counted: a constraint may be integrable
//! only because of another one.

pub use super::distribution::{Obstruction, Unclassified};
use super::distribution::{Place, reach, solve};
use super::{Constrained, Constraint, State};
use std::fmt;
use symbolic::Sym;

/// The classification of the constraints of a system, which are given by their indices.
#[derive(Clone, Debug, PartialEq)]
pub struct Class {
    pub redundant: Vec<usize>,
    pub rheonomic: Vec<usize>,
    pub nonlinear: Vec<usize>,
    /// The number of independent geometric constraints.
    pub geometric: usize,
    /// The number of kinematic constraints, linear in the velocities, that are integrable.
    pub in_disguise: usize,
    /// The number of kinematic constraints that are not integrable.
    pub nonholonomic: usize,
    /// A Lie bracket that proves nonintegrability.
    pub obstruction: Option<Obstruction>,
}

/// The kind of a system, by all its constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Geometric constraints only.
    Holonomic,
    /// Kinematic constraints, all of them integrable.
    HolonomicInDisguise,
    /// Some kinematic constraint is not integrable.
    Nonholonomic,
    /// Some kinematic constraint is nonlinear in the velocities: Frobenius' theorem does not apply to it.
    Nonlinear,
}

impl Class {
    /// The kind of the system.
    pub fn kind(&self) -> Kind {
        match self {
            _ if !self.nonlinear.is_empty() => Kind::Nonlinear,
            _ if self.nonholonomic > 0 => Kind::Nonholonomic,
            _ if self.in_disguise > 0 => Kind::HolonomicInDisguise,
            _ => Kind::Holonomic,
        }
    }
}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.kind() {
            Kind::Holonomic => "holonomic",
            Kind::HolonomicInDisguise => "holonomic in disguise",
            Kind::Nonholonomic => "nonholonomic",
            Kind::Nonlinear => "nonlinear in the velocities",
        };
        write!(f, "{kind}: {} geometric", self.geometric)?;
        for (count, name) in [(self.in_disguise, "integrable"), (self.nonholonomic, "not integrable")] {
            if count > 0 {
                write!(f, ", {count} kinematic and {name}")?;
            }
        }
        let lists = [(&self.nonlinear, "nonlinear"), (&self.rheonomic, "rheonomic"), (&self.redundant, "redundant")];
        for (list, name) in lists.into_iter().filter(|(list, _)| !list.is_empty()) {
            let numbers: Vec<String> = list.iter().map(|k| (k + 1).to_string()).collect();
            write!(f, "; {name}: constraint {}", numbers.join(", "))?;
        }
        Ok(())
    }
}

/// The classification at a general position: x as expressions in symbols (and in `time`) that satisfy the geometric
/// constraints.
///
/// # Errors
/// [`Unclassified`] where the zero test of an expression fails, or the constraints contradict each other.
pub fn classify<Q, const N: usize, const C: usize>(
    system: &Q,
    time: Sym,
    place: [Sym; N],
) -> Result<Class, Unclassified>
where
    Q: Constrained<N, C, Given = Sym>,
{
    // names that no system uses
    let [x, dx] = ["x", "x'"].map(|stem| -> [Sym; N] { std::array::from_fn(|i| Sym::symbol(&format!("{stem}[{i}]"))) });
    let at =
        Place { coordinates: std::iter::once(time).chain(x).collect(), values: x.into_iter().zip(place).collect() };
    let constraints = system.constraints(&State { time, place: x, velocity: dx });
    let at_rest: Vec<(Sym, Sym)> = dx.into_iter().map(|speed| (speed, Sym::ZERO)).collect();
    let mut class = Class {
        redundant: Vec::new(),
        rheonomic: Vec::new(),
        nonlinear: Vec::new(),
        geometric: 0,
        in_disguise: 0,
        nonholonomic: 0,
        obstruction: None,
    };
    let (mut geometric, mut kinematic) = (Vec::new(), Vec::new());
    for (k, constraint) in constraints.into_iter().enumerate() {
        if !at.vanishes(constraint.value().diff(time))? {
            class.rheonomic.push(k);
        }
        match constraint {
            Constraint::Geometric(f) => geometric.push((k, at.coordinates.iter().map(|&c| f.diff(c)).collect())),
            Constraint::Kinematic(phi) => {
                let slopes = dx.map(|speed| phi.diff(speed));
                if is_linear(&at, &slopes, dx)? {
                    let row = std::iter::once(phi).chain(slopes).map(|entry| entry.substitute(&at_rest));
                    kinematic.push((k, row.collect()));
                } else {
                    class.nonlinear.push(k);
                }
            }
        }
    }
    class.geometric = solve(&at, &geometric)?.rank();
    let all: Vec<(usize, Vec<Sym>)> = geometric.into_iter().chain(kinematic).collect();
    let solved = solve(&at, &all)?;
    let (reached, obstruction) = reach(&at, &solved.fields(N + 1))?;
    class.redundant = solved.redundant.clone();
    class.in_disguise = N + 1 - reached - class.geometric;
    class.nonholonomic = solved.rank() - (N + 1 - reached);
    class.obstruction = obstruction;
    Ok(class)
}

/// Whether dphi/dx' does not depend on x'.
fn is_linear<const N: usize>(place: &Place, slopes: &[Sym; N], dx: [Sym; N]) -> Result<bool, Unclassified> {
    for slope in slopes {
        for speed in dx {
            if !place.vanishes(slope.diff(speed))? {
                return Ok(false);
            }
        }
    }
    Ok(true)
}
