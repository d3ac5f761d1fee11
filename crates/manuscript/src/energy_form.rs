//! The quadratic part of the energy about a steady motion of a conservative system, by Routh's reduction.
//!
//! Let q be the coordinates that are constant on the motion and v the constant speeds. The linear equations
//!
//!   M q'' + G q' + K q + N v' + H v = 0 ,   d/dt (N^T q' + P q + J v) = 0
//!
//! become, for constant momenta of the constant speeds,
//!
//!   (M - N J^-1 N^T) q'' + (G - N J^-1 P - H J^-1 N^T) q' + (K - H J^-1 P) q = 0 .
//!
//! Let the matrix of q'' be positive definite, that of q' antisymmetric and that of q symmetric. Then the matrix of q is the Hessian of the amended
//! potential energy, which includes the kinetic energy at these momenta. The motion is stable if this energy has a minimum (J. L. Lagrange; P. G.
//! Lejeune Dirichlet, J. reine angew. Math. 32 (1846), 85-88; E. J. Routh). Without gyroscopic terms, a negative value of the quadratic form implies an
//! eigenvalue with a positive real part, so that the motion is unstable (A. M. Lyapunov).

use crate::determinant::determinant;
use crate::linear_motion::LinearMotion;
use crate::motion::Motion;
use model::Trace;
use symbolic::linear::solve;
use symbolic::{Hypotheses, Sym, decide, normal};

/// The quadratic forms of the kinetic and of the amended potential energy, given by minors of their matrices.
pub(crate) struct EnergyForm {
    /// Leading principal minors of the matrix of the kinetic energy.
    pub inertia: Vec<Sym>,
    /// Leading principal minors of the Hessian of the potential energy.
    pub potential: Vec<Sym>,
    /// All principal minors of this Hessian.
    pub principal: Vec<Sym>,
    pub is_gyroscopic: bool,
    /// Whether there are constant speeds, whose momenta are conserved.
    pub has_momenta: bool,
    /// Whether the equations of motion are Lagrange's equations with energies that do not depend on time, so that the energy is conserved exactly.
    pub is_lagrangian: bool,
}

impl EnergyForm {
    /// The quadratic forms; `None` if the linear equations do not belong to a conservative system.
    pub fn of(linear: &LinearMotion, motion: &Motion<'_, '_>) -> Option<Self> {
        let LinearMotion { resting, inertia, damping, stiffness, equations } = linear;
        let turning: Vec<usize> = (0..equations.len()).filter(|place| !resting.contains(place)).collect();
        let is_zero = |entry: Sym| decide(entry, &motion.hypotheses).is_zero();
        let keeps = |&c: &usize| {
            resting.iter().all(|&j| is_zero(stiffness[c][j])) && turning.iter().all(|&d| is_zero(damping[c][d]))
        };
        if resting.is_empty() || !turning.iter().all(keeps) {
            return None;
        }
        let own: Vec<Vec<Sym>> = turning.iter().map(|&c| turning.iter().map(|&d| inertia[c][d]).collect()).collect();
        // the changes of the constant speeds at constant momenta
        let speeds = |rows: &[Vec<Sym>], j: usize| -> Option<Vec<Sym>> {
            let right: Vec<Sym> = turning.iter().map(|&c| rows[c][j]).collect();
            if turning.is_empty() { Some(right) } else { Some(solve(&own, &right, &Hypotheses::none()).ok()?.values()) }
        };
        let with = |i: usize, rows: &[Vec<Sym>], values: &[Sym]| {
            turning.iter().zip(values).fold(Sym::ZERO, |sum, (&c, &value)| sum + rows[i][c] * value)
        };
        let size = resting.len();
        let mut forms = [(); 3].map(|()| vec![vec![Sym::ZERO; size]; size]);
        for (column, &j) in resting.iter().enumerate() {
            let (by_rates, by_places) = (speeds(inertia, j)?, speeds(damping, j)?);
            for (row, &i) in resting.iter().enumerate() {
                let entries = [
                    inertia[i][j] - with(i, inertia, &by_rates),
                    damping[i][j] - with(i, inertia, &by_places) - with(i, damping, &by_rates),
                    stiffness[i][j] - with(i, damping, &by_places),
                ];
                for (form, entry) in forms.iter_mut().zip(entries) {
                    form[row][column] = normal(entry, &motion.hypotheses).ok()?.to_sym();
                }
            }
        }
        let [masses, gyroscopic, hessian] = forms;
        let pairs = || (0..size).flat_map(|i| (0..=i).map(move |j| (i, j)));
        let is_conservative = pairs().all(|(i, j)| {
            is_zero(masses[i][j] - masses[j][i])
                && is_zero(hessian[i][j] - hessian[j][i])
                && is_zero(gyroscopic[i][j] + gyroscopic[j][i])
        });
        if !is_conservative {
            return None;
        }
        let minor = |of: &[Vec<Sym>], chosen: &[usize]| {
            let rows: Vec<Vec<Sym>> = chosen.iter().map(|&i| chosen.iter().map(|&j| of[i][j]).collect()).collect();
            normal(determinant(&rows), &motion.hypotheses).ok().map(|form| form.to_sym())
        };
        let leading = |of: &[Vec<Sym>]| {
            (1..=size).map(|count| minor(of, &(0..count).collect::<Vec<_>>())).collect::<Option<Vec<Sym>>>()
        };
        let subsets = (1usize..1 << size).map(|set| (0..size).filter(|k| set >> k & 1 == 1).collect::<Vec<_>>());
        Some(EnergyForm {
            inertia: leading(&masses)?,
            potential: leading(&hessian)?,
            principal: subsets.map(|chosen| minor(&hessian, &chosen)).collect::<Option<_>>()?,
            is_gyroscopic: pairs().any(|(i, j)| !is_zero(gyroscopic[i][j])),
            has_momenta: !turning.is_empty(),
            is_lagrangian: is_lagrangian(motion.trace, equations, &turning),
        })
    }
}

/// Whether the equations of motion are Lagrange's equations with energies that depend neither on time nor on the coordinates `turning`.
fn is_lagrangian(trace: &Trace<'_>, equations: &[Sym], turning: &[usize]) -> bool {
    let lagrangian = trace.kinetic_and_coenergy() - trace.potential_energy();
    let is_zero = |expression: Sym| decide(expression, &Hypotheses::none()).is_zero();
    let is_own = |(k, &equation): (usize, &Sym)| {
        is_zero(trace.rate_of(trace.by_speed(lagrangian, k)) - trace.by_coordinate(lagrangian, k) - equation)
    };
    let form = normal(lagrangian, &Hypotheses::none()).map_or(lagrangian, |form| form.to_sym());
    let known = [&trace.parameters, &trace.coordinates, &trace.speeds];
    // an input may depend on time
    let is_fixed = |symbol: &Sym| *symbol == trace.pi || known.iter().any(|list| list.contains(symbol));
    form.symbols_of().iter().all(is_fixed)
        && turning.iter().all(|&k| is_zero(trace.by_coordinate(lagrangian, k)))
        && equations.iter().enumerate().all(is_own)
}
