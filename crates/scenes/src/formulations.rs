//! Formulations of a model with constraints: index 1 with projection, index 1 without, Baumgarte's stabilisation, and index 2 of Gear,
//! Gupta and Leimkuhler (1985).
//!
//! The last is a DAE of index 2 with the speeds u, the rates q' = T(q) u of the coordinates, the rows J_g of position constraints, and an
//! additional multiplier mu for each of these:
//!
//!   q' = T (u + M^-1 J_g^T mu),   M u' + h = J^T lambda,   0 = f(q, t),   0 = df/dt, 0 = phi(q, u, t) .

use crate::changing_laws::changes;
use crate::compiled_system::CompiledSystem;
use crate::elimination::MOST_WRITTEN;
use crate::letters::Letters;
use crate::modes::Mode;
use integrators::Index2Dae;
use model::equations::{Equation, Equations, Level, Pushes, constraints_of};
use model::{Model, Trace};
use simulation::work_precision::{Configuration, Formulation, SharedIndex2Dae, Standing, Treated};
use simulation::{CompiledDae, Problem};
use std::sync::Arc;
use symbolic::{Sym, apart, substitute_all};

/// The formulation of the file, then every other formulation with an equal motion. `meets` tells whether the start of the problem
/// satisfies the constraints of a model: if it violates stabilised constraints, no other formulation has an equal motion.
pub(crate) fn formulations(
    model: &Arc<Model>,
    problem: impl Fn() -> Problem,
    meets: impl Fn(&Model) -> bool,
) -> Vec<Configuration> {
    let constraints = &model.constraints;
    let led = constraints.iter().filter(|constraint| constraint.gains.is_some()).count();
    let own = match led {
        _ if constraints.is_empty() => Formulation::Minimal,
        led if led == constraints.len() => Formulation::Given,
        _ => Formulation::Projected,
    };
    let mut ways = vec![Configuration::of(own, "", Standing::Own, problem())];
    if constraints.is_empty() || changes(model) {
        return ways;
    }
    let reduced = Arc::new(model.led_at(None));
    // the decay of violated stabilised constraints is part of the motion
    if led > 0 && !meets(&reduced) {
        return ways;
    }
    let compiled = |model: &Arc<Model>| CompiledSystem::of(model, &Mode::off(model)).ok().map(Arc::new);
    let (led_at_a_rate, held) = (Arc::new(model.led_at(Some(Formulation::RATE))), HeldModel::of(&reduced));
    let held = held.map(|held| Arc::new(CompiledDae::new(held)) as Arc<dyn SharedIndex2Dae>);
    let (reduced, led_at_a_rate) = (compiled(&reduced), compiled(&led_at_a_rate));
    let others = [
        (Formulation::Projected, reduced.as_ref().filter(|_| led > 0).map(|system| system.projected(system.law()))),
        (Formulation::IndexReduced, reduced.map(|system| system.law())),
        (Formulation::Led, led_at_a_rate.map(|system| system.law())),
    ];
    let others = others.map(|(formulation, law)| (formulation, law.map(Treated::Free)));
    let others = others.into_iter().chain([(Formulation::Held, held.map(Treated::Held))]);
    let others = others.filter_map(|(formulation, law)| Some((formulation, law?)));
    ways.extend(others.map(|(formulation, law)| Configuration {
        law,
        ..Configuration::of(formulation, "", Standing::Exact, problem())
    }));
    ways
}

/// A model as a DAE of index 2 with constraints f = 0 and df/dt = 0.
struct HeldModel {
    model: Arc<Model>,
    /// The number of position constraints, and of all constraints.
    counts: [usize; 2],
}

impl HeldModel {
    /// The DAE of a model; `None` if the accelerations cannot be eliminated, or their expressions would be too long.
    fn of(model: &Arc<Model>) -> Option<Self> {
        if model.speeds() + model.constraints.len() > MOST_WRITTEN {
            return None;
        }
        apart(|| {
            let trace = Trace::of(model);
            let equations = Equations::of(&trace);
            equations.pushes().ok()?;
            let counts = [positions(&equations.constraints).count(), equations.constraints.len()];
            Some(HeldModel { model: Arc::clone(model), counts })
        })
    }

    /// The vector a and the columns of B in y' = a(t, y) + B(t, y) z for a state y and multipliers z = (mu, lambda).
    fn affine(&self, t: Sym, y: &[Sym]) -> Option<Vec<Vec<Sym>>> {
        let trace = Trace::of(&self.model);
        let equations = Equations::of(&trace);
        let Pushes { free, columns } = equations.pushes().ok()?;
        let moved = |speeds: &[Sym]| {
            let by: Vec<(Sym, Sym)> = trace.speeds.iter().copied().zip(speeds.iter().copied()).collect();
            substitute_all(&trace.position_rates, &by)
        };
        let rests = vec![Sym::ZERO; free.len()];
        let of_positions =
            positions(&equations.constraints).map(|place| [moved(&columns[place]), rests.clone()].concat());
        let of_all = columns.iter().map(|column| [moved(&rests), column.clone()].concat());
        let own = [trace.position_rates.clone(), free].concat();
        let all: Vec<Vec<Sym>> = [own].into_iter().chain(of_positions).chain(of_all).collect();
        let all = Letters::with_data(t, y).put_into(&trace, &all.concat());
        Some(all.chunks_exact(y.len()).map(<[Sym]>::to_vec).collect())
    }
}

/// Indices of the position constraints.
fn positions(constraints: &[Equation]) -> impl Iterator<Item = usize> {
    let levels = constraints.iter().enumerate();
    levels.filter(|(_, constraint)| constraint.level == Level::Position).map(|(place, _)| place)
}

impl Index2Dae<Sym> for HeldModel {
    fn sizes(&self) -> (usize, usize) {
        (self.model.positions() + self.model.speeds(), self.counts.iter().sum())
    }

    fn rates(&self, t: Sym, y: &[Sym], z: &[Sym], dy: &mut [Sym]) {
        let mut columns = vec![Sym::ZERO; y.len() * z.len()];
        self.parts(t, y, dy, &mut columns);
        for (column, &multiplier) in columns.chunks_exact(y.len()).zip(z) {
            dy.iter_mut().zip(column).for_each(|(rate, &part)| *rate += part * multiplier);
        }
    }

    fn parts(&self, t: Sym, y: &[Sym], dy: &mut [Sym], columns: &mut [Sym]) {
        match self.affine(t, y).as_deref() {
            Some([free, of_multipliers @ ..]) => {
                dy.copy_from_slice(free);
                columns.copy_from_slice(&of_multipliers.concat());
            }
            _ => dy.fill(Sym::UNDEFINED),
        }
    }

    fn constraints(&self, t: Sym, y: &[Sym], g: &mut [Sym]) {
        let trace = Trace::of(&self.model);
        let all = constraints_of(&trace);
        let zeros = positions(&all).map(|place| all[place].zero);
        let values: Vec<Sym> = zeros.chain(all.iter().map(|constraint| constraint.rate)).collect();
        g.copy_from_slice(&Letters::with_data(t, y).put_into(&trace, &values));
    }
}
