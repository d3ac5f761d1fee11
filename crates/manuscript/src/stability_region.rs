//! Sufficient and necessary conditions for the stability of a steady motion: by the eigenvalues of its linear equations, and by the energy of a
//! conservative system.

use crate::condition_products;
use crate::energy_form::EnergyForm;
use crate::linear_motion::{Characteristic, LinearMotion};
use crate::motion::Motion;
use crate::signs::shows;
use claims::Condition;
use field::Rational;
use symbolic::Sym;

/// The theorem behind a sufficient criterion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Theorem {
    /// All eigenvalues have negative real parts (Hurwitz).
    Hurwitz,
    /// All eigenvalues are simple and on the imaginary axis.
    EvenPowers,
    /// The potential energy has a minimum (Lagrange, Dirichlet).
    Minimum,
}

impl Theorem {
    pub fn is_of_roots(self) -> bool {
        self != Theorem::Minimum
    }

    /// The kind of stability that the theorem proves.
    pub fn kind(self) -> &'static str {
        if self == Theorem::Hurwitz { "asymptotically stable" } else { "stable" }
    }
}

/// A sufficient criterion: the motion is stable if all conditions are positive.
pub(crate) struct Criterion {
    pub theorem: Theorem,
    pub conditions: Vec<Sym>,
}

/// The conditions on parameters under which a steady motion is stable.
pub(crate) struct Region {
    pub criteria: Vec<Criterion>,
    /// If one of these is negative, an eigenvalue has a positive real part.
    pub necessary: Vec<Sym>,
    pub is_gyroscopic: bool,
    /// Whether the nonlinear equations conserve the energy.
    pub is_lagrangian: bool,
    has_momenta: bool,
    /// The characteristic polynomial, if there are conditions on its roots.
    pub roots: Option<Characteristic>,
    /// The quadratic forms of the energy, for a conservative system.
    pub energy: Option<EnergyForm>,
}

impl Region {
    /// The conditions from the linear equations about a motion.
    ///
    /// # Errors
    /// Neither the eigenvalues nor the energy give conditions.
    pub fn of(linear: &LinearMotion, motion: &Motion<'_, '_>, known: &[Condition]) -> Result<Self, String> {
        let is_positive = |of: &Sym| {
            shows(*of, motion, known).is_some_and(|shown| shown.is_strict) || condition_products::show(*of, true, known)
        };
        let energy = EnergyForm::of(linear, motion).filter(|form| form.inertia.iter().all(is_positive));
        let roots = linear.characteristic(motion).and_then(|found| Ok((conditions_of(&found.coefficients)?, found)));
        let has = |of: fn(&EnergyForm) -> bool| energy.as_ref().is_some_and(of);
        let mut region = Region {
            criteria: Vec::new(),
            necessary: Vec::new(),
            is_gyroscopic: has(|form| form.is_gyroscopic),
            is_lagrangian: has(|form| form.is_lagrangian),
            has_momenta: has(|form| form.has_momenta),
            roots: None,
            energy: None,
        };
        let why = match roots {
            Ok((criterion, characteristic)) => {
                region.necessary = criterion.conditions.clone();
                region.criteria.push(criterion);
                region.roots = Some(characteristic);
                None
            }
            Err(why) => Some(why),
        };
        if let Some(EnergyForm { potential, principal, is_gyroscopic, .. }) = &energy {
            // a minimum of the energy proves more than eigenvalues on the imaginary axis
            region.criteria.insert(0, Criterion { theorem: Theorem::Minimum, conditions: potential.clone() });
            if !is_gyroscopic {
                region.necessary.clone_from(principal);
            }
        }
        region.energy = energy;
        match why {
            Some(why) if region.criteria.is_empty() || region.necessary.is_empty() => Err(why),
            _ => Ok(region),
        }
    }

    /// The sentence on stability under the conditions of a theorem.
    pub fn told(&self, theorem: Theorem) -> String {
        match theorem {
            Theorem::Hurwitz => "all roots have negative real parts, so that the motion is asymptotically stable".to_owned(),
            Theorem::EvenPowers => {
                "the roots are on the imaginary axis, each of its own, so that the motion is stable in the first approximation alone"
                    .to_owned()
            }
            Theorem::Minimum if self.is_lagrangian => {
                let (with, theorem) = match self.has_momenta {
                    true => (", with the kinetic energy of the momenta that are kept, ", "Routh, Lagrange, Dirichlet"),
                    false => (" ", "Lagrange, Dirichlet"),
                };
                format!(
                    "the potential energy{with}has a minimum, since the minors of its Hessian are positive, so that the motion is stable ({theorem})"
                )
            }
            Theorem::Minimum => {
                "the linear equations keep a positive form, whose minors are positive, so that the motion is stable in the first approximation"
                    .to_owned()
            }
        }
    }

    /// The sentence on stability at a point at which a criterion holds; `by_roots` restricts it to the criterion by eigenvalues.
    pub fn told_stable(&self, by_roots: bool) -> String {
        let of_roots = self.criteria.iter().find(|one| one.theorem.is_of_roots()).filter(|_| by_roots);
        match of_roots {
            Some(criterion) => format!("the motion is {} in the first approximation", criterion.theorem.kind()),
            None => self.told(Theorem::Minimum),
        }
    }
}

/// The conditions on a polynomial, given by ascending powers: for even powers only, that the squares of its roots are negative and simple, otherwise Hurwitz's.
fn conditions_of(all: &[Sym]) -> Result<Criterion, String> {
    let number = |value: i64| Sym::constant(Rational::new(value, 1));
    let is_even = all.iter().skip(1).step_by(2).all(|odd| *odd == Sym::ZERO);
    let conditions = match (all, is_even) {
        ([], _) | ([_], _) => return Err("no root is left beside zero".to_owned()),
        ([c, _, a], true) => vec![*a * *c],
        ([e, _, c, _, a], true) => {
            vec![*a * *c, *a * *e, *c * *c - number(4) * *a * *e]
        }
        ([d, _, c, _, b, _, a], true) => {
            let (a, b, c, d) = (*a, *b, *c, *d);
            let discriminant = number(18) * a * b * c * d - number(4) * b * b * b * d + b * b * c * c
                - number(4) * a * c * c * c
                - number(27) * a * a * d * d;
            vec![a * b, a * c, a * d, discriminant]
        }
        ([b, a], _) => vec![*a * *b],
        ([c, b, a], _) => vec![*a * *b, *a * *c],
        ([d, c, b, a], _) => vec![*a * *b, *a * *d, *b * *c - *a * *d],
        ([e, d, c, b, a], _) => {
            vec![*a * *b, *a * *c, *a * *e, *a * (*d * (*b * *c - *a * *d) - *b * *b * *e)]
        }
        _ => return Err(format!("the characteristic polynomial has the degree {}, which is too high", all.len() - 1)),
    };
    let theorem = if is_even { Theorem::EvenPowers } else { Theorem::Hurwitz };
    Ok(Criterion { theorem, conditions })
}
