//! A motor at an instant, over symbols: torque and current rates by its law at any state.

use field::{Analytic, Circle};
use motor::{Machine, RotorState, state_names, torque_and_current_rates};
use symbolic::{Decision, Hypotheses, Sym, decide};

/// Any state of a motor, with torque and rates by its law. (A symbol with a space in its name is no parameter of any motor.)
pub struct Instant {
    pub angle: Circle<Sym>,
    /// g', rad/s
    pub slip: Sym,
    /// phi', rad/s
    pub speed: Sym,
    pub currents: Vec<Sym>,
    /// the torque M, N m
    pub torque: Sym,
    /// di_k/dt, A/s
    pub rates: Vec<Sym>,
    /// Whether the rotor's speed is prescribed, by whatever torque that takes.
    pub kept: bool,
}

impl Instant {
    /// A symbolic state of the machine, with torque and rates by its law.
    pub fn of(machine: &impl Machine<Sym>) -> Self {
        let kept = machine.rotor() == RotorState::Prescribed;
        let angle = match machine.rotor() {
            RotorState::AngleAndSpeed => Sym::symbol("the angle").circle(),
            RotorState::Prescribed | RotorState::Speed => Circle { cos: Sym::ONE, sin: Sym::ZERO },
        };
        let slip = if kept { Sym::ZERO } else { Sym::symbol("the slip") };
        let currents: Vec<Sym> = (0..machine.windings()).map(|k| Sym::symbol(&format!("current {k}"))).collect();
        let mut rates = vec![Sym::ZERO; currents.len()];
        let torque = torque_and_current_rates(machine, angle, slip, &currents, &mut rates);
        Instant { angle, slip, speed: slip + machine.frame_speed(), currents, torque, rates, kept }
    }
}

/// Ok if every residual vanishes for all states and data; otherwise the one that does not, with a point. A residual that does not
/// vanish is reported even after one that was not decided.
pub fn vanish(residuals: impl IntoIterator<Item = (String, Sym)>) -> Result<(), Doubt> {
    let mut doubt = Ok(());
    for (what, residual) in residuals {
        match decide(residual, &Hypotheses::none()) {
            Decision::Zero(_) => {}
            Decision::GaveUp(reason) => doubt = doubt.and(Err(Doubt::Open(format!("{what}: {reason}")))),
            off @ (Decision::NonZero(_) | Decision::Undefined(_)) => {
                return Err(Doubt::Off(format!("{what} is off: {off}")));
            }
        }
    }
    doubt
}

/// The reason for which an identity is not proved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// The identity is false.
    Off(String),
    /// The prover gave up.
    Open(String),
}

/// The state of a motor on a bench as symbols, by the names of its states.
pub fn bench_state(machine: &impl Machine<Sym>) -> Vec<Sym> {
    state_names(machine).iter().map(|name| Sym::symbol(&format!("the {name}"))).collect()
}
