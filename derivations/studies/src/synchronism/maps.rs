//! Maps of pull-in: the fraction of initial states that reach synchronism, over load and damping, or over load and
//! number of bars.

use super::basin::{NoShares, Share, Starts, shares};
use super::loaded::{Loaded, with_damping};
use crate::scene::{Scene, Setup};

/// One row of the map of the motor without currents: the outcomes of the initial states under each load.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The dimensionless damping f / sqrt(A' b).
    pub damping: f64,
    pub shares: Vec<Share>,
    /// The least load, N m, with a stable slipping motion, if it is known.
    pub pull_in: Option<f64>,
}

/// The length of an integration of the motor without currents, in units of 1/frequency.
const SWINGS: f64 = 200.0;

/// The scene with its motor alone, on a bench.
pub fn alone(scene: &Scene) -> Scene {
    let axial = match &scene.system {
        Setup::Bench { axial } => *axial,
        Setup::Gyrostat(bodies) => bodies.rotor.axial,
    };
    Scene { system: Setup::Bench { axial }, ..scene.clone() }
}

/// The row for the motor without currents with a given damping, under the total braking torques M + f W, in units of
/// the pull-out torque b.
///
/// # Errors
/// [`NoShares`] gives the reason why no shares were computed.
pub fn over_damping(scene: &Scene, damping: f64, drags: &[f64], starts: (usize, usize)) -> Result<Row, NoShares> {
    let none = || NoShares::Law("the scene's data make no motor without currents".into());
    let scene = alone(&with_damping(scene, damping).ok_or_else(none)?);
    let motor = Loaded::of(&scene).map_err(NoShares::Field)?;
    let facts = &motor.facts;
    let loads: Vec<f64> = drags.iter().map(|drag| drag * facts.hold - facts.friction).collect();
    let starts = Starts { angles: starts.0, slips: starts.1, slip: [-5.0 * facts.frequency, 0.0] };
    let shares = shares(&scene, &loads, starts, SWINGS / facts.frequency)?;
    let all = motor.in_step();
    let pull_out = Loaded::pull_out(&all).map(|standing| standing.load);
    let pull_in = pull_out.zip(motor.out_of_step().ok()).and_then(|(load, found)| Some(found.pull_in(load)?.load));
    Ok(Row { damping, shares, pull_in })
}

/// The outcomes for a scene's motor, in its gyrostat or on its bench, from slips between standstill and synchronism,
/// under loads, N m, within a time, s.
///
/// # Errors
/// [`NoShares`] gives the reason why no shares were computed.
pub fn over_starts(scene: &Scene, loads: &[f64], starts: (usize, usize), span: f64) -> Result<Vec<Share>, NoShares> {
    let motor = Loaded::of(scene).map_err(NoShares::Field)?;
    let starts = Starts { angles: starts.0, slips: starts.1, slip: [-motor.facts.field_speed, 0.0] };
    shares(scene, loads, starts, span)
}
