//! A synchronous motor with permanent magnets at a voltage of constant amplitude, in Park's axes.

use field::{Base, Circle, Over, Scalar};
use motor::{Count, Entry, Machine, RotorState, letter};
use symbolic::Sym;

reader::quantities! {
    /// The electric and mechanical constants: V, Psi, L_d, L_q, R and f below.
    pub struct Magnets {
        /// speed of the stator's field, that of the supply over the pairs of poles
        field_speed: "rad/s",
        /// amplitude of the voltage, Park's transformation keeping the power
        voltage: "V",
        /// flux of the magnets through the windings, scaled likewise
        flux: "Wb",
        /// inductance along the magnets
        along: "H" > 0,
        /// inductance across them
        across: "H" > 0,
        /// resistance of a phase
        resistance: "ohm" in resistance,
        /// coefficient of viscous friction in the bearings
        f: "N m s" in friction,
    }
}

/// The stator currents in axes that rotate with the rotor, d along its magnets and q perpendicular. With n pole pairs
/// and the electric angle n g, measured from the position where the voltage is perpendicular to the magnets:
///
///   L_d i_d' = V sin(n g) - R i_d + n phi' L_q i_q ,
///   L_q i_q' = V cos(n g) - R i_q - n phi' (L_d i_d + Psi) ,    M = n (Psi i_q + (L_d - L_q) i_d i_q) - f phi' .
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PermanentMagnet<P> {
    pub magnets: Magnets<P>,
    /// The number n of pole pairs.
    pub pole_pairs: usize,
}

impl<P: Base> Machine<P> for PermanentMagnet<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.magnets.field_speed
    }

    #[inline(always)]
    fn windings(&self) -> usize {
        2
    }

    fn current_name(&self, winding: usize) -> String {
        if winding == 0 { "id".into() } else { "iq".into() }
    }

    #[inline(always)]
    fn inductance(&self, winding: usize) -> P {
        if winding == 0 { self.magnets.along } else { self.magnets.across }
    }

    #[inline(always)]
    fn resistance(&self, _winding: usize) -> P {
        self.magnets.resistance
    }

    #[inline(always)]
    fn supply<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> Option<S> {
        let electric = times(angle, self.pole_pairs);
        Some(S::lift(self.magnets.voltage) * if winding == 0 { electric.sin } else { electric.cos })
    }

    /// The flux linkage of the other axis, which rotation couples into this winding.
    #[inline(always)]
    fn motional<S: Over<P>>(&self, winding: usize, currents: &[S]) -> Option<S> {
        let Magnets { flux, along, across, .. } = self.magnets.map(S::lift);
        let &[d, q] = currents else { return None };
        let swept = if winding == 0 { -across * q } else { flux.and_product(along, d) };
        Some(swept * S::int(self.pole_pairs as i64))
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, _slip: S, speed: S) -> S {
        -S::lift(self.magnets.f) * speed
    }
}

/// The angle n g, by binary doubling.
#[inline(always)]
fn times<S: Scalar>(angle: Circle<S>, n: usize) -> Circle<S> {
    let mut sum = angle;
    // the binary digits of n after the first
    for place in (0..n.max(1).ilog2()).rev() {
        sum = sum + sum;
        if n >> place & 1 == 1 {
            sum = sum + angle;
        }
    }
    sum
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "permanent_magnet",
    summary: "synchronous with permanent magnets on a constant voltage, with the currents in Park's axes",
    data: Magnets::<Sym>::QUANTITIES,
    counts: &[Count { name: "pole_pairs", meaning: "number of pairs of poles of the rotor" }],
    write: |given| {
        let (magnets, pole_pairs) = (Magnets::read(letter)?, given.count("pole_pairs"));
        given.laws(&PermanentMagnet { magnets, pole_pairs })
    },
};
