//! The basin of attraction of synchronism, by sampling: the law is integrated from a grid of initial angles and slips
//! under each load.

use super::energy::Wells;
use super::loaded::{Loaded, NoField};
use crate::ensemble::kind::{Kind, form_parameters};
use crate::scene::{Scene, Setup, Start};
use crate::stationary::motor::NoMotor;
use integrators::{Ensemble, Failure, Members};
use simulation::Axes;
use std::f64::consts::{PI, TAU};
use std::fmt;

/// The rotor's initial states: an equidistant grid of angles over one turn and of slips over an interval; all currents
/// are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Starts {
    pub angles: usize,
    pub slips: usize,
    /// The interval of slips, rad/s.
    pub slip: [f64; 2],
}

/// The outcomes of the initial states under one load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The load, N m.
    pub load: f64,
    pub starts: usize,
    /// The number of motions that reach synchronism; on a bench this is proved by the energy.
    pub in_step: usize,
    /// The number of motions that still slip at the end.
    pub slipping: usize,
    /// The median time to synchronism, s, rounded up to the end of a window.
    pub time: Option<f64>,
}

impl Share {
    /// The number of motions that are neither synchronous nor slip by a whole turn in the last quarter of the time:
    /// their initial states are near the boundary of the basin.
    pub fn undecided(&self) -> usize {
        self.starts - self.in_step - self.slipping
    }
}

/// The reason why no shares were computed.
#[derive(Clone, Debug, PartialEq)]
pub enum NoShares {
    Field(NoField),
    Motor(NoMotor),
    /// The law cannot be recorded.
    Law(String),
}

impl fmt::Display for NoShares {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Field(reason) => reason.fmt(f),
            Self::Motor(reason) => reason.fmt(f),
            Self::Law(reason) => write!(f, "the law cannot be written down: {reason}"),
        }
    }
}

impl std::error::Error for NoShares {}

/// The number of windows into which the time is divided; it determines the resolution of times to synchronism.
const WINDOWS: usize = 120;
/// The tolerance of the integration.
const TOLERANCE: f64 = 1e-8;
/// The greatest number of integration steps in a window.
const MOST_STEPS: u64 = 100_000;

/// One motion of the ensemble.
struct Runner {
    load: usize,
    state: Vec<f64>,
    /// The rotor's angle at the end of each window, rad.
    angles: Vec<f64>,
    fate: Fate,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Fate {
    UnderWay,
    InStep {
        window: usize,
    },
    Slipping,
    /// The law could not be continued, or the greatest number of steps was reached.
    Lost,
}

/// The outcomes of all initial states under each load, N m, within a time, s. On a bench a motion is synchronous, and
/// remains so, once its energy V is below the energies of both neighbouring unstable equilibria. In a gyrostat, whose
/// carrier has its own energy, a motion counts as synchronous if its angle varies by less than half a turn in the last
/// quarter of the time. The computation is deterministic and runs in one thread.
///
/// # Errors
/// [`NoShares`] gives the reason why no shares were computed.
pub fn shares(scene: &Scene, loads: &[f64], starts: Starts, span: f64) -> Result<Vec<Share>, NoShares> {
    let axes = Axes::Second;
    let motor = Loaded::of(scene).map_err(NoShares::Field)?;
    let kind = Kind::under_load(&scene.system, &scene.machine, axes);
    let kind = kind.map_err(|reason| NoShares::Law(reason.to_string()))?;
    let series = kind.series(integrators::taylor_order(TOLERANCE));
    let series = series.ok_or_else(|| NoShares::Law("it is too long".into()))?;
    let wells = match scene.system {
        Setup::Bench { .. } => loads.iter().map(|load| Wells::of(&motor, *load)).collect::<Result<Vec<_>, _>>(),
        Setup::Gyrostat(_) => Ok(Vec::new()),
    };
    let wells = wells.map_err(NoShares::Motor)?;
    let (_, mut parameters) = form_parameters(&scene.system, axes);
    parameters.extend(scene.machine.values());
    let place = scene.names().iter().position(|name| name == "angle").unwrap_or(0);
    let window = span / WINDOWS as f64;
    let mut ensemble =
        Ensemble::new(series, TOLERANCE, window, kind.states(), kind.parameters()).with_most_steps(MOST_STEPS);
    let grid = grid(scene, motor.facts.field_speed, starts, axes);
    let runner =
        |load: usize, state: &Vec<f64>| Runner { load, state: state.clone(), angles: Vec::new(), fate: Fate::UnderWay };
    let mut runners: Vec<Runner> =
        (0..loads.len()).flat_map(|load| grid.iter().map(move |state| runner(load, state))).collect();
    for number in 0..WINDOWS {
        ensemble.run(&mut Window { runners: &mut runners, next: 0, parameters: &parameters, loads });
        for runner in runners.iter_mut().filter(|runner| runner.fate == Fate::UnderWay) {
            let angle = runner.state[place];
            runner.angles.push(angle);
            if let Some(wells) = wells.get(runner.load) {
                let at: Vec<f64> = runner.state.iter().copied().chain([loads[runner.load]]).collect();
                if wells.hold(angle, motor.own.height(&at)) {
                    runner.fate = Fate::InStep { window: number };
                }
            }
        }
    }
    let on_bench = !wells.is_empty();
    runners.iter_mut().filter(|runner| runner.fate == Fate::UnderWay).for_each(|runner| runner.end(on_bench));
    let of_load = |(number, load): (usize, &f64)| {
        let own = || runners.iter().filter(|runner| runner.load == number);
        let mut windows: Vec<usize> = own().filter_map(Runner::in_step).collect();
        windows.sort_unstable();
        Share {
            load: *load,
            starts: own().count(),
            in_step: windows.len(),
            slipping: own().filter(|runner| runner.fate == Fate::Slipping).count(),
            time: windows.get(windows.len() / 2).map(|count| (count + 1) as f64 * window),
        }
    };
    Ok(loads.iter().enumerate().map(of_load).collect())
}

/// The initial states of the grid; all other data are those of the scene.
fn grid(scene: &Scene, field_speed: f64, starts: Starts, axes: Axes) -> Vec<Vec<f64>> {
    let even = |[from, to]: [f64; 2], i: usize, count: usize| from + (to - from) * (i as f64 + 0.5) / count as f64;
    let mut one = scene.clone();
    let mut states = Vec::with_capacity(starts.angles * starts.slips);
    for i in 0..starts.angles {
        for j in 0..starts.slips {
            let (rotor_angle, slip) = (even([-PI, PI], i, starts.angles), even(starts.slip, j, starts.slips));
            let start = Start { rotor_angle, rotor_speed: field_speed + slip, currents: Vec::new(), ..one.start };
            one.start = start;
            states.push(one.state(axes));
        }
    }
    states
}

impl Runner {
    /// Decides the outcome of a motion from its angles, if the energy has not decided it.
    fn end(&mut self, on_bench: bool) {
        let from = WINDOWS - WINDOWS / 4;
        let Some((last, late)) = self.angles.get(from..).and_then(<[f64]>::split_last) else { return };
        let turned = late.first().map_or(0.0, |first| (last - first).abs());
        if turned > TAU {
            self.fate = Fate::Slipping;
        } else if !on_bench && late.iter().all(|angle| (angle - last).abs() < PI) {
            let lost = self.angles.iter().rposition(|angle| (angle - last).abs() >= PI);
            self.fate = Fate::InStep { window: lost.map_or(0, |window| window + 1) };
        }
    }

    fn in_step(&self) -> Option<usize> {
        match self.fate {
            Fate::InStep { window } => Some(window),
            _ => None,
        }
    }
}

/// The motions whose outcome is still open, as members of an ensemble integrated over one window.
struct Window<'a> {
    runners: &'a mut [Runner],
    next: usize,
    parameters: &'a [f64],
    loads: &'a [f64],
}

impl Members for Window<'_> {
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64> {
        let ahead = self.runners.get(self.next..)?;
        let number = self.next + ahead.iter().position(|runner| runner.fate == Fate::UnderWay)?;
        self.next = number + 1;
        let runner = &self.runners[number];
        if let [data @ .., load] = parameters {
            data.copy_from_slice(self.parameters);
            *load = self.loads[runner.load];
        }
        state.copy_from_slice(&runner.state);
        Some(number as u64)
    }

    fn ended(&mut self, number: u64, state: &[f64], _: u64, _: f64, failure: Option<Failure>) {
        let Some(runner) = usize::try_from(number).ok().and_then(|number| self.runners.get_mut(number)) else { return };
        runner.state.copy_from_slice(state);
        if failure.is_some() {
            runner.fate = Fate::Lost;
        }
    }
}
