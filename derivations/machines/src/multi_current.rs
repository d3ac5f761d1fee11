//! A synchronous motor with the currents of the excitation and of every bar of the damper winding, after Leonov and
//! Zaretskii.

use field::{Base, Circle, Over};
use motor::{Count, Datum, Entry, Machine, RotorState, letter};
use symbolic::Sym;

reader::quantities! {
    /// The electric and mechanical constants, common with the equivalent windings.
    pub struct Windings {
        /// speed of the stator's field
        field_speed: "rad/s",
        /// greatest torque of the field on the rotor with the constant part of the excitation
        b0: "N m",
        /// flux of the field through the excitation winding
        a1: "Wb",
        /// inductance of the excitation winding
        l1: "H" > 0,
        /// resistance of the excitation winding
        r1: "ohm" in resistance,
        /// flux of the field through a bar's circuit
        a2: "Wb",
        /// inductance of a bar's circuit
        l2: "H" > 0,
        /// resistance of a bar's circuit
        r2: "ohm" in resistance,
        /// coefficient of damping proportional to the slip
        mu: "N m s" in friction,
        /// coefficient of viscous friction in the bearings
        f: "N m s" in friction,
    }
}

/// The flux linkages psi_1 = a1 cos g of the excitation (x is its current minus the constant part), and psi_n = -a2
/// sin(g + t_n) of the bar at the angle t_n on the rotor; U = -b0 cos g; m = -mu g' - f phi'.
#[derive(Clone, Debug, PartialEq)]
pub struct MultiCurrent<P> {
    pub windings: Windings<P>,
    /// The angles t_n of the bars; those of the paper are -pi/4 + 2 pi n/N.
    pub bars: Vec<Circle<P>>,
}

impl<P: Datum> MultiCurrent<P> {
    /// The motor with N evenly spaced bars.
    pub fn evenly(windings: Windings<P>, bars: usize) -> Self {
        let whole = u32::try_from(bars).unwrap_or(u32::MAX);
        let bars = (1..=whole).map(|n| (Circle::turn(n, whole) - Circle::turn(1, 8)).map(P::lift)).collect();
        MultiCurrent { windings, bars }
    }
}

impl<P: Base> Machine<P> for MultiCurrent<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.windings.field_speed
    }

    #[inline(always)]
    fn windings(&self) -> usize {
        1 + self.bars.len()
    }

    #[inline(always)]
    fn inductance(&self, winding: usize) -> P {
        if winding == 0 { self.windings.l1 } else { self.windings.l2 }
    }

    #[inline(always)]
    fn resistance(&self, winding: usize) -> P {
        if winding == 0 { self.windings.r1 } else { self.windings.r2 }
    }

    #[inline(always)]
    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        match winding.checked_sub(1).and_then(|n| self.bars.get(n)) {
            Some(bar) => -S::lift(self.windings.a2) * (angle + bar.map(S::lift)).sin,
            None => S::lift(self.windings.a1) * angle.cos,
        }
    }

    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        -S::lift(self.windings.b0) * angle.cos
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        -(S::lift(self.windings.mu) * slip + S::lift(self.windings.f) * speed)
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "multi_current",
    summary: "synchronous with the currents of the excitation and of every damper bar",
    data: Windings::<Sym>::QUANTITIES,
    counts: &[Count { name: "bars", meaning: "number of bars of the damper" }],
    write: |given| {
        let mut motor = MultiCurrent::evenly(Windings::read(letter)?, given.count("bars"));
        motor.bars.iter_mut().for_each(|bar| *bar = given.settled_point(*bar));
        given.laws(&motor)
    },
};
