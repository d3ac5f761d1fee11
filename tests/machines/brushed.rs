//! The brushed motor, derived from a rotating armature and compared with textbook results.

use crate::{assert_equal, number, symbol};
use dalembert_derivations::machines::brushed::Brushed;
use field::{Analytic, Circle, Over, Rational, Scalar, Tangent};
use integrators::{Method, Ode, Span, System, Tolerance, integrate};
use mechanics::lagrange::lagrange;
use motor::{Bench, Machine, electrical_power, joule_heat, steady_currents, torque_and_current_rates};
use num_traits::Zero;
use symbolic::{Sym, symbols};

/// Two windings rotate with the rotor in the field of fixed magnets. The brushes keep the current vector perpendicular
/// to this field, at -90 degrees in space, and connect the terminals to the windings' voltages along this direction.
#[test]
fn an_armature_whose_current_brushes_hold_in_space_is_the_machine() {
    let Ok(machine) = Brushed::<Sym>::read(symbol);
    let [phi, speed, acceleration, current] = symbols(["phi", "w", "a", "i"]);
    let mut rates = [Sym::ZERO];
    let moment = torque_and_current_rates(&machine, Circle::zero(), speed, &[current], &mut rates);
    let constant = |x: Sym| Tangent::fixed(Tangent::fixed(x));
    let coenergy = |[_, _, phi]: [_; 3], [a, b, _]: [Tangent<Tangent<Sym>>; 3]| {
        let turned = Analytic::circle(phi);
        (constant(machine.inductance) * (a * a + b * b)).half()
            + constant(machine.flux) * (a * turned.cos - b * turned.sin)
    };
    // the direction (0, -1) in space, in the axes of the rotor
    let axis = |phi: Circle<Tangent<Sym>>| [-phi.sin, -phi.cos];
    let carried = axis(phi.circle().moving(speed)).map(|along| along * Tangent::moving(current, rates[0]));
    let velocity = [carried[0].value, carried[1].value, speed];
    let residual =
        lagrange(coenergy, [Sym::ZERO, Sym::ZERO, phi], velocity, [carried[0].slope, carried[1].slope, acceleration]);
    let [a, b] = axis(phi.circle().map(Tangent::fixed)).map(|x| x.value);
    let felt = residual[0] * a + residual[1] * b;
    assert_equal("brushes", felt, machine.voltage - machine.resistance * current);
    assert_equal("moment", -residual[2], moment + machine.f * speed);
}

fn motor<S>(number: impl Fn(i64, i64) -> S) -> Brushed<S> {
    Brushed {
        voltage: number(24, 1),
        flux: number(45, 1000),
        inductance: number(2, 1000),
        resistance: number(6, 10),
        f: number(1, 10_000),
    }
}

/// w = u k / (k^2 + f R): from u = R i + k w and k i = f w.
#[test]
fn the_steady_speed_is_that_of_textbooks() {
    let machine = motor(number);
    let Brushed { voltage: u, flux: k, resistance: r, f, .. } = machine;
    let speed = u * k / (k * k + f * r);
    let current = steady_currents(&machine, Circle::zero(), speed).expect("it rests");
    assert_eq!(current, [f * speed / k]);
    let mut rates = [number(1, 1)];
    assert_eq!(torque_and_current_rates(&machine, Circle::zero(), speed, &current, &mut rates), Rational::zero());
    assert_eq!(rates, [Rational::zero()]);
    // locked rotor: the whole voltage drops at the resistance
    let locked = steady_currents(&machine, Circle::zero(), Rational::zero());
    assert_eq!(locked, Some(vec![u / r]));
    let ideal = Brushed { resistance: Rational::zero(), ..machine };
    assert_eq!(steady_currents(&ideal, Circle::zero(), Rational::zero()), None);
}

/// A bench with the work of its supply as an additional state.
struct Metered(Bench<f64, Brushed<f64>>);

impl<S: Over<f64> + Analytic> Ode<S> for Metered {
    fn dimension(&self) -> usize {
        self.0.dimension() + 1
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        let (machine, speed) = (&self.0.machine, y[0]);
        self.0.rates(&y[..2], &mut dy[..2]);
        dy[2] = electrical_power(machine, Circle::zero(), &y[1..2]) - joule_heat(machine, &y[1..2])
            + machine.torque_law(speed, speed) * speed;
    }
}

impl System for Metered {}

#[test]
fn what_the_supply_gives_is_stored_heated_or_rubbed_away() {
    let system = Metered(Bench { machine: motor(|n, d| n as f64 / d as f64), axial: 2.4e-4 });
    let start = [0.0; 3];
    let span = Span::new(0.0, 0.6, &start);
    let outcome = integrate(&system, Method::Gauss { stages: 6 }, &Tolerance::both(1e-12), &span, &mut ());
    assert!(outcome.reached(), "{:?}", outcome.end);
    let energy = system.0.energy(&outcome.state[..2]);
    assert!(energy > 30.0 && (energy - outcome.state[2]).abs() < 1e-9 * energy, "{energy} and {}", outcome.state[2]);
}
