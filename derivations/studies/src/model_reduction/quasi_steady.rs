//! Reduced models with quasi-steady currents: the full law with algebraic values in place of their equations.

use super::currents::Current;
use super::reduced_model::{Fill, Lower};
use super::{Loss, ReducedModel, steady_currents};
use field::{Analytic, Over};
use motor::{Machine, RotorState, is_fed};
use simulation::SymbolicLaw;
use std::sync::Arc;

/// The reduced models, beginning with those that replace only the fastest windings.
pub(super) fn models<M>(machine: &M, written: &Arc<dyn SymbolicLaw>, start: &[f64]) -> Vec<ReducedModel>
where
    M: Machine<f64> + Clone + Send + Sync + 'static,
{
    let windings = machine.windings();
    if is_fed(machine) {
        return steady_currents::reduced_model(machine, written, start).into_iter().collect();
    }
    if windings == 0 || machine.rotor() != RotorState::AngleAndSpeed {
        return Vec::new();
    }
    let time_constant = |k: usize| machine.inductance(k) / machine.resistance(k);
    let mut order: Vec<usize> = (0..windings).collect();
    order.sort_by(|&a, &b| time_constant(a).total_cmp(&time_constant(b)));
    // windings with equal time constants, within rounding, form one class
    let ends = (1..=windings)
        .filter(|&end| end == windings || time_constant(order[end]) > (1.0 + 1e-9) * time_constant(order[end - 1]));
    let mut models = Vec::new();
    for end in ends {
        let mut slaved = order[..end].to_vec();
        slaved.sort_unstable();
        let all = end == windings;
        let kinds = if all {
            &[Current::AtPresentSlip, Current::Resistive, Current::Absent][..]
        } else {
            &[Current::AtPresentSlip, Current::Resistive]
        };
        let suitable = kinds.iter().filter(|kind| slaved.iter().all(|&k| kind.suits(machine, k)));
        models.extend(suitable.filter_map(|&kind| without(machine, written, start, &slaved, kind)));
    }
    models
}

/// The reduced model in which these windings have quasi-steady currents of one kind.
fn without<M>(
    machine: &M,
    written: &Arc<dyn SymbolicLaw>,
    start: &[f64],
    slaved: &[usize],
    kind: Current,
) -> Option<ReducedModel>
where
    M: Machine<f64> + Clone + Send + Sync + 'static,
{
    let mechanical = start.len() - machine.windings();
    let rotor = mechanical - machine.rotor().dimension();
    let followed: Vec<usize> = (0..machine.windings()).filter(|k| !slaved.contains(k)).collect();
    let kept: Vec<usize> = (0..mechanical).chain(followed.iter().map(|k| mechanical + k)).collect();
    let z0: Vec<f64> = kept.iter().map(|&place| start[place]).collect();
    let slowest = slaved.iter().map(|&k| machine.inductance(k) / machine.resistance(k)).fold(0.0, f64::max);
    let name = match (followed.is_empty(), kind) {
        (true, Current::AtPresentSlip) => "currents at the present slip",
        (true, Current::Resistive) => "resistive currents",
        (true, Current::Absent) => "no currents",
        (false, Current::Resistive) => "fast windings resistive",
        (false, _) => "fast windings at the present slip",
    };
    let dropped = format!("of {}: {}", counted(slaved.len(), "current"), kind.dropped());
    let fill = Slaved { machine: machine.clone(), rotor, currents: mechanical, slaved: slaved.to_vec(), kind };
    let loss = Loss::Small { parameter: kind.parameter() };
    let lower = Lower::keeping(written, kept, fill);
    let mut reduced = ReducedModel::new(name, &dropped, loss, lower, z0)?;
    reduced.small = Some(Box::new(move |z, dz| kind.value(slowest, z[rotor + 1], dz[rotor + 1])));
    Some(reduced)
}

/// Quasi-steady currents as functions of angle and slip.
struct Slaved<M> {
    machine: M,
    /// The indices where the rotor's state and the currents begin.
    rotor: usize,
    currents: usize,
    slaved: Vec<usize>,
    kind: Current,
}

impl<M: Machine<f64> + Send + Sync + 'static> Fill for Slaved<M> {
    fn fill<S: Over<f64> + Analytic>(&self, y: &mut [S]) {
        let (angle, slip) = self.machine.rotor().angle_and_slip(&y[self.rotor..self.currents]);
        for &k in &self.slaved {
            y[self.currents + k] = self.kind.of(&self.machine, k, angle, slip);
        }
    }
}

pub(super) fn counted(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what}"),
        _ => format!("{count} {what}s"),
    }
}
