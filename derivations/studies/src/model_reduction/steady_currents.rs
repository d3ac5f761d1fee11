//! The reduced model of a machine with a supply: its currents have their steady values.

use super::quasi_steady::counted;
use super::reduced_model::{Fill, Lower};
use super::{Loss, ReducedModel};
use field::{Analytic, Over};
use motor::{Machine, RotorState, steady_currents};
use simulation::SymbolicLaw;
use std::sync::Arc;
use symbolic::symbols;

/// The reduced model in which all windings have the steady currents for the present angle and speed.
pub fn reduced_model<M>(machine: &M, written: &Arc<dyn SymbolicLaw>, start: &[f64]) -> Option<ReducedModel>
where
    M: Machine<f64> + Clone + Send + Sync + 'static,
{
    let windings = machine.windings();
    let mechanical = start.len() - windings;
    let rotor = mechanical - machine.rotor().dimension();
    let [angle, slip] = symbols(["g", "s"]);
    steady_currents(machine, angle.circle(), slip)?;
    let fill = Resting { machine: machine.clone(), rotor, currents: mechanical };
    let lower = Lower::keeping(written, (0..mechanical).collect(), fill);
    let slowest = (0..windings).map(|k| machine.inductance(k) / machine.resistance(k)).fold(0.0, f64::max);
    let (angled, frame_speed) = (machine.rotor() == RotorState::AngleAndSpeed, machine.frame_speed());
    let parameter = if angled { "(L/R) |slip|" } else { "(L/R) |slip'|/|phi'|" };
    let dropped = format!(
        "of {}: their transients; all are those that would rest at the present angle and speed",
        counted(windings, "current")
    );
    let z0 = start[..mechanical].to_vec();
    let mut reduced = ReducedModel::new("currents at rest", &dropped, Loss::Small { parameter }, lower, z0)?;
    reduced.small = Some(Box::new(move |z, dz| match angled {
        true => Some(slowest * z[rotor + 1].abs()),
        false => Some(slowest * (dz[rotor] / (z[rotor] + frame_speed)).abs()).filter(|small| small.is_finite()),
    }));
    Some(reduced)
}

/// The steady currents as functions of angle and speed.
struct Resting<M> {
    machine: M,
    /// The indices where the rotor's state and the currents begin.
    rotor: usize,
    currents: usize,
}

impl<M: Machine<f64> + Send + Sync + 'static> Fill for Resting<M> {
    fn fill<S: Over<f64> + Analytic>(&self, y: &mut [S]) {
        let (angle, slip) = self.machine.rotor().angle_and_slip(&y[self.rotor..self.currents]);
        if let Some(resting) = steady_currents(&self.machine, angle, slip) {
            y[self.currents..].copy_from_slice(&resting);
        }
    }
}
