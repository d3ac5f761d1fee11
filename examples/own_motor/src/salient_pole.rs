//! The synchronous motor with salient poles, without currents.

use dalembert::field::{Base, Circle, Over};
use dalembert::motor::{Catalogue, Entry, Machine, RotorState, letter, submit};
use dalembert::symbolic::Sym;

dalembert::reader::quantities! {
    /// A magnetised rotor of two diameters in the turning field: U = -b0 cos g - 1/2 b2 cos 2g; friction m = -f phi'.
    pub struct SalientPole {
        /// speed of the stator's field
        field_speed: "rad/s",
        /// greatest torque of the field on the magnets
        b0: "N m",
        /// greatest torque of the field on the poles
        b2: "N m",
        /// viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for SalientPole<P> {
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    fn frame_speed(&self) -> P {
        self.field_speed
    }

    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        let SalientPole { b0, b2, .. } = self.map(S::lift);
        -b0 * angle.cos - b2.half() * (angle + angle).cos
    }

    fn torque_law<S: Over<P>>(&self, _slip: S, speed: S) -> S {
        -S::lift(self.f) * speed
    }
}

/// Among the motors of the catalogue.
pub static ENTRY: Entry = Entry {
    name: "own_salient_pole",
    summary: "synchronous with salient poles, without currents",
    data: SalientPole::<Sym>::QUANTITIES,
    counts: &[],
    write: |given| given.laws(&SalientPole::read(letter)?),
};

submit! {
    Catalogue { name: "own_motor", motors: &[&ENTRY] }
}
