//! The synchronous motor with permanent magnets on a voltage of constant amplitude, in Park's axes.

use super::{Catalogued, Datum, Machine, RotorState, Source};
use field::{Base, Circle, Over};

crate::quantities! {
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
        /// viscous friction in the bearings
        f: "N m s" in friction,
    }
}

/// The stator's currents in axes that turn with the rotor, d along its magnets and q across. With n pairs of poles and the
/// electric angle n g from the place where the voltage lies across the magnets:
///
///   L_d i_d' = V sin(n g) - R i_d + n phi' L_q i_q ,
///   L_q i_q' = V cos(n g) - R i_q - n phi' (L_d i_d + Psi) ,    M = n (Psi i_q + (L_d - L_q) i_d i_q) - f phi' .
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PermanentMagnet<P> {
    pub magnets: Magnets<P>,
    /// n
    pub pole_pairs: usize,
}

impl<P: Base> Machine<P> for PermanentMagnet<P> {
    const ROTOR: RotorState = RotorState::AngleAndSpeed;

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
        let electric = (1..self.pole_pairs).fold(angle, |sum, _| sum + angle);
        Some(S::lift(self.magnets.voltage) * if winding == 0 { electric.sin } else { electric.cos })
    }

    /// The other axis' flux, which turning sweeps through this one.
    #[inline(always)]
    fn motional<S: Over<P>>(&self, winding: usize, currents: &[S]) -> Option<S> {
        let Magnets { flux, along, across, .. } = self.magnets.map(S::lift);
        let &[d, q] = currents else { return None };
        let swept = if winding == 0 { -across * q } else { flux.and_product(along, d) };
        Some(swept * S::int(self.pole_pairs as i64))
    }

    #[inline(always)]
    fn moment_law<S: Over<P>>(&self, _slip: S, speed: S) -> S {
        -S::lift(self.magnets.f) * speed
    }
}

impl Catalogued for PermanentMagnet<f64> {
    const SUMMARY: &'static str = "synchronous with permanent magnets on a constant voltage, with the currents in Park's axes";
    type Over<P: Datum> = PermanentMagnet<P>;

    fn read<P: Datum, E>(source: &mut impl Source<P, Error = E>) -> Result<PermanentMagnet<P>, E> {
        let magnets = Magnets::read(|quantity| source.quantity(quantity))?;
        let pole_pairs = source.count("pole_pairs", "number of pairs of poles of the rotor")?;
        Ok(PermanentMagnet { magnets, pole_pairs })
    }
}
