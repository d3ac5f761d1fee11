//! The symbolic state of a motor, with torque and current rates by its law.

use field::{Analytic, Circle};
use motor::{Machine, RotorState, state_names, torque_and_current_rates};
use symbolic::{Decision, Hypotheses, Sym, decide};

/// A general state of a motor, with torque and rates by its law. (Symbols with a space in their name differ from all
/// parameters.)
pub struct Instant {
    pub angle: Circle<Sym>,
    /// The slip g', rad/s.
    pub slip: Sym,
    /// The speed phi', rad/s.
    pub speed: Sym,
    pub currents: Vec<Sym>,
    /// The torque M, N m.
    pub torque: Sym,
    /// The current rates di_k/dt, A/s.
    pub rates: Vec<Sym>,
    /// Whether the rotor's speed is prescribed.
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

/// Proves that every residual vanishes for all states and data.
///
/// # Errors
/// A residual that does not vanish, with a point, or one that is undecided; the former takes precedence.
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

/// The reason why an identity is not proved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// The identity is false.
    Off(String),
    /// The prover did not decide.
    Open(String),
}

/// The state of a motor on a bench as symbols, named after its states.
pub fn bench_state(machine: &impl Machine<Sym>) -> Vec<Sym> {
    state_names(machine).iter().map(|name| Sym::symbol(&format!("the {name}"))).collect()
}
