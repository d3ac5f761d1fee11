//! Exact reduction of the bars of a damper winding to one or two equivalent windings.
//!
//! A bar at the angle t_n acts on the rotor only through its direction u_n = (cos t_n, sin t_n). With the sums X = sum
//! i_n cos t_n, Y = sum i_n sin t_n the torque of the bars is -a2 (X cos g - Y sin g), and
//!
//!   L2 (X, Y)' = -R2 (X, Y) + a2 g' G (cos g, -sin g) ,    G = sum u_n u_n^T .
//!
//! These equations are closed for any angles. For N >= 3 evenly spaced bars G is N/2 times the identity: they are
//! equivalent to two equal orthogonal windings with the flux a2 sqrt(N/2). For N = 1 and N = 2 all bars are collinear:
//! G has rank one, and one winding with the flux a2 sqrt(N) is equivalent. The remaining N - 2 (for N = 2: one)
//! combinations of the currents are not induced, do no work, and decay as exp(-R2 t / L2).

use super::multi_current::{MultiCurrent, Windings};
use field::{Analytic, Base, Circle, Over};
use motor::{Count, Entry, Machine, RotorState, letter};
use symbolic::Sym;

/// A motor with one or two windings equivalent to N evenly spaced bars.
#[derive(Clone, Debug, PartialEq)]
pub struct EquivalentWindings<P>(MultiCurrent<P>);

impl<P: Base + Analytic> EquivalentWindings<P> {
    /// The motor equivalent to `bars` evenly spaced bars, one of them at the angle `bar`.
    pub fn new(windings: Windings<P>, bars: usize, bar: Circle<P>) -> Self {
        let lines = if bars < 3 { 1 } else { 2 };
        let a2 = windings.a2 * (P::int(bars as i64) / P::int(lines as i64)).sqrt();
        let quarter = Circle { cos: P::zero(), sin: P::one() };
        let bars = [bar, bar + quarter].into_iter().take(lines).collect();
        EquivalentWindings(MultiCurrent { windings: Windings { a2, ..windings }, bars })
    }
}

impl<P: Base> Machine<P> for EquivalentWindings<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.0.frame_speed()
    }

    #[inline(always)]
    fn windings(&self) -> usize {
        self.0.windings()
    }

    #[inline(always)]
    fn inductance(&self, winding: usize) -> P {
        self.0.inductance(winding)
    }

    #[inline(always)]
    fn resistance(&self, winding: usize) -> P {
        self.0.resistance(winding)
    }

    #[inline(always)]
    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        self.0.linkage(winding, angle)
    }

    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        self.0.field_energy(angle)
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        self.0.torque_law(slip, speed)
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "equivalent_windings",
    summary: "synchronous with the damper's bars as one or two equivalent windings",
    data: Windings::<Sym>::QUANTITIES,
    counts: &[Count { name: "bars", meaning: "number of bars that the windings stand for" }],
    write: |given| {
        let bar = -Circle::turn(1, 8).map(Sym::lift);
        let EquivalentWindings(mut motor) = EquivalentWindings::new(Windings::read(letter)?, given.count("bars"), bar);
        motor.windings.a2 = given.settled(motor.windings.a2);
        motor.bars.iter_mut().for_each(|bar| *bar = given.settled_point(*bar));
        given.laws(&EquivalentWindings(motor))
    },
};
