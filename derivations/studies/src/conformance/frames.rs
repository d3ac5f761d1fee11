//! Checks of a motor's equations: derived in the stator's frame, and with rotated windings.

use super::instant::{Instant, vanish};
use super::verdict_of;
use claims::finding::PropertyVerdict;
use field::{Analytic, Circle, Over, Scalar, Tangent};
use motor::{Machine, RotorState, torque_and_current_rates};
use symbolic::Sym;

/// Derives the equations of Lagrange-Maxwell and Hamel in the stator's frame, where the co-energy is K(phi - W t, i)
/// and the rotation of the field a rheonomic constraint, and compares them with the law in the field's frame.
pub(super) fn stator(machine: &impl Machine<Sym>, at: &Instant) -> PropertyVerdict {
    if at.kept {
        return PropertyVerdict::DoesNotApply("the speed is prescribed and does not depend on the torque".to_owned());
    }
    let (phi, field) = match machine.rotor() {
        RotorState::AngleAndSpeed => (Sym::symbol("the angle phi").circle(), Sym::symbol("the angle W t").circle()),
        RotorState::Prescribed | RotorState::Speed => (Circle::zero(), Circle::zero()),
    };
    let mut rates = vec![Sym::ZERO; at.currents.len()];
    let torque = torque_and_current_rates(machine, phi - field, at.slip, &at.currents, &mut rates);
    // dK/dphi at a fixed field
    let varied = phi.moving(Sym::ONE) - field.moving(Sym::ZERO);
    let held: Vec<_> = at.currents.iter().map(|&i| Tangent::fixed(i)).collect();
    let pull = coenergy(machine, varied, &held).slope;
    let motional: Vec<Sym> = (0..rates.len()).map(|k| machine.motional(k, &at.currents).unwrap_or(Sym::ZERO)).collect();
    let sliding = at.currents.iter().zip(&motional).fold(Sym::ZERO, |sum, (&i, &c)| sum + i * c);
    let law = machine.torque_law(at.speed - machine.frame_speed(), at.speed);
    let mut residuals = vec![("the torque".to_owned(), torque - (pull + sliding + law))];
    // d/dt dK/di_k with rotating rotor and field
    let running = phi.moving(at.speed) - field.moving(machine.frame_speed());
    for (k, &motional) in motional.iter().enumerate() {
        let currents = at.currents.iter().zip(&rates).enumerate().map(|(j, (&i, &rate))| {
            let varied = if j == k { Sym::ONE } else { Sym::ZERO };
            Tangent::moving(Tangent::moving(i, rate), Tangent::fixed(varied))
        });
        let flux = coenergy(machine, running.map(Tangent::fixed), &currents.collect::<Vec<_>>()).slope.slope;
        let supply = machine.supply(k, phi - field).unwrap_or(Sym::ZERO);
        let voltage = machine.resistance(k) * at.currents[k] + motional * at.speed - supply;
        residuals.push((format!("the voltage of winding {k}"), flux + voltage));
    }
    verdict_of(vanish(residuals), "from the stator, where the field turns with time, the equations are the same")
}

/// The co-energy K = sum (1/2 L i^2 + i psi(g)) - U(g).
fn coenergy<S: Over<Sym>, M: Machine<Sym>>(machine: &M, angle: Circle<S>, currents: &[S]) -> S {
    currents.iter().enumerate().fold(-machine.field_energy(angle), |sum, (k, &i)| {
        sum + (S::lift(machine.inductance(k)) * i * i).half() + i * machine.linkage(k, angle)
    })
}

/// Replaces two windings of equal inductance and resistance by two orthogonal combinations; the equations must not change.
pub(super) fn turned_windings(machine: &impl Machine<Sym>, at: &Instant) -> PropertyVerdict {
    let alike = |&(j, k): &(usize, usize)| {
        machine.inductance(j) == machine.inductance(k) && machine.resistance(j) == machine.resistance(k)
    };
    let count = at.currents.len();
    let pairs: Vec<(usize, usize)> = (1..count).map(|k| (k - 1, k)).filter(alike).collect();
    if pairs.is_empty() {
        return PropertyVerdict::DoesNotApply("no two windings in a row are alike".to_owned());
    }
    let turn = Circle { cos: Sym::ratio(3, 5), sin: Sym::ratio(4, 5) };
    let residuals = pairs.into_iter().flat_map(|pair| {
        let turned = Turned { machine, pair, turn };
        let (currents, expected) = (turned.forwards(&at.currents), turned.forwards(&at.rates));
        let mut rates = vec![Sym::ZERO; count];
        let torque = torque_and_current_rates(&turned, at.angle, at.slip, &currents, &mut rates);
        let off = rates.into_iter().zip(expected).enumerate();
        let off = off.map(|(k, (rate, expected))| (format!("the rate of turned current {k}"), rate - expected));
        std::iter::once(("the torque of turned windings".to_owned(), torque - at.torque)).chain(off).collect::<Vec<_>>()
    });
    verdict_of(vanish(residuals.collect::<Vec<_>>()), "windings that are alike may be turned among themselves")
}

/// A machine two of whose windings are replaced by orthogonal combinations, rotated by the angle `turn`.
struct Turned<'a, M> {
    machine: &'a M,
    pair: (usize, usize),
    turn: Circle<Sym>,
}

impl<M> Turned<'_, M> {
    /// The value at a winding, rotated within the pair; values of other windings are unchanged.
    fn turned<S: Over<Sym>>(&self, winding: usize, of: impl Fn(usize) -> S) -> S {
        let ((j, k), turn) = (self.pair, self.turn.map(S::lift));
        match winding {
            _ if winding == j => turn.cos * of(j) + turn.sin * of(k),
            _ if winding == k => turn.cos * of(k) - turn.sin * of(j),
            _ => of(winding),
        }
    }

    fn forwards(&self, values: &[Sym]) -> Vec<Sym> {
        (0..values.len()).map(|winding| self.turned(winding, |k| values[k])).collect()
    }

    fn backwards<S: Over<Sym>>(&self, values: &[S]) -> Vec<S> {
        let back = Turned { machine: self.machine, pair: self.pair, turn: -self.turn };
        (0..values.len()).map(|winding| back.turned(winding, |k| values[k])).collect()
    }
}

impl<M: Machine<Sym>> Machine<Sym> for Turned<'_, M> {
    fn rotor(&self) -> RotorState {
        self.machine.rotor()
    }

    fn frame_speed(&self) -> Sym {
        self.machine.frame_speed()
    }

    fn windings(&self) -> usize {
        self.machine.windings()
    }

    fn inductance(&self, winding: usize) -> Sym {
        self.machine.inductance(winding)
    }

    fn resistance(&self, winding: usize) -> Sym {
        self.machine.resistance(winding)
    }

    fn linkage<S: Over<Sym>>(&self, winding: usize, angle: Circle<S>) -> S {
        self.turned(winding, |k| self.machine.linkage(k, angle))
    }

    fn supply<S: Over<Sym>>(&self, winding: usize, angle: Circle<S>) -> Option<S> {
        Some(self.turned(winding, |k| self.machine.supply(k, angle).unwrap_or_else(S::zero)))
    }

    fn motional<S: Over<Sym>>(&self, winding: usize, currents: &[S]) -> Option<S> {
        let own = self.backwards(currents);
        Some(self.turned(winding, |k| self.machine.motional(k, &own).unwrap_or_else(S::zero)))
    }

    fn field_energy<S: Over<Sym>>(&self, angle: Circle<S>) -> S {
        self.machine.field_energy(angle)
    }

    fn torque_law<S: Over<Sym>>(&self, slip: S, speed: S) -> S {
        self.machine.torque_law(slip, speed)
    }
}
