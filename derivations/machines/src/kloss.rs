//! An asynchronous motor without currents: the torque is that of Kloss.

use field::{Base, Over};
use motor::{Entry, Machine, RotorState, letter};
use symbolic::Sym;

reader::quantities! {
    /// With the slip ratio s = (W - phi') / W: m = 2 m_k s s_k / (s^2 + s_k^2) - f phi'. The torque of the motor
    /// decreases beyond the slip ratio s_k; the total torque can vanish at up to three speeds.
    pub struct Kloss {
        /// speed of the stator's field
        field_speed: "rad/s" != 0,
        /// pull-out torque
        pull_out: "N m",
        /// slip ratio at the pull-out torque
        pull_out_slip: "1" > 0,
        /// coefficient of viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for Kloss<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::Speed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.field_speed
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        let Kloss { field_speed, pull_out, pull_out_slip, f } = self.map(S::lift);
        let s = -slip / field_speed;
        S::int(2) * pull_out * s * pull_out_slip / (s * s + pull_out_slip * pull_out_slip) - f * speed
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "kloss",
    summary: "asynchronous without currents, torque after Kloss",
    data: Kloss::<Sym>::QUANTITIES,
    counts: &[],
    write: |given| given.laws(&Kloss::read(letter)?),
};
