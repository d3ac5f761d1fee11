//! The permanent-magnet motor, derived from its two stationary phases, whose inductance depends on the angle.

use crate::{assert_equal, number, symbol};
use dalembert_derivations::machines::permanent_magnet::{Magnets, PermanentMagnet};
use field::{Analytic, Circle, Rational, Scalar, Tangent};
use mechanics::hamel::boltzmann_hamel;
use mechanics::lagrange::lagrange;
use motor::{Machine, steady_currents, torque_and_current_rates};
use nalgebra::SMatrix;
use num_traits::Zero;
use symbolic::{Sym, symbols};

/// The angle times `pole_pairs`.
fn electric<S: Scalar>(angle: Circle<S>, pole_pairs: usize) -> Circle<S> {
    (1..pole_pairs).fold(angle, |sum, _| sum + angle)
}

/// The components, in axes at rest, of a vector given in rotated axes.
fn at_rest<S: Scalar>(by: Circle<S>, [d, q]: [S; 2]) -> [S; 2] {
    [by.cos * d - by.sin * q, by.sin * d + by.cos * q]
}

/// An instant: the rotor at phi, the field at beta (mechanical angles), and the currents in Park's axes.
struct Instant {
    machine: PermanentMagnet<Sym>,
    phi: Sym,
    speed: Sym,
    acceleration: Sym,
    currents: [Sym; 2],
    /// The rates of the currents by the machine.
    rates: [Sym; 2],
    /// The torque by the machine, without friction.
    torque: Sym,
    /// The voltage in the axes at rest: a rotating vector of constant length, perpendicular to the magnets' field at
    /// g = 0.
    voltage: [Sym; 2],
}

impl Instant {
    fn of(pole_pairs: usize) -> Self {
        let Ok(magnets) = Magnets::<Sym>::read(symbol);
        let machine = PermanentMagnet { magnets, pole_pairs };
        let [phi, beta, slip, acceleration, d, q] = symbols(["phi", "beta", "s", "a", "d", "q"]);
        let (currents, mut rates) = ([d, q], [Sym::ZERO; 2]);
        let speed = slip + machine.frame_speed();
        let torque = torque_and_current_rates(&machine, phi.circle() - beta.circle(), slip, &currents, &mut rates);
        let quarter = Circle { cos: Sym::ZERO, sin: Sym::int(1) };
        let place = electric(beta.circle(), pole_pairs) + quarter;
        let voltage = [magnets.voltage * place.cos, magnets.voltage * place.sin];
        let torque = torque + magnets.f * speed;
        Instant { machine, phi, speed, acceleration, currents, rates, torque, voltage }
    }

    fn electric(&self) -> Circle<Sym> {
        electric(self.phi.circle(), self.machine.pole_pairs)
    }
}

/// The energy K = 1/2 i.L(theta) i + Psi (i_a cos theta + i_b sin theta); for a salient rotor L depends on the double
/// angle.
#[test]
fn parks_transformation_of_the_phases_by_lagrange_and_maxwell_is_the_machine() {
    for pole_pairs in 1..=3 {
        let at = Instant::of(pole_pairs);
        let Magnets { flux, along, across, resistance, .. } = at.machine.magnets;
        let constant = |x: Sym| Tangent::fixed(Tangent::fixed(x));
        let (mean, half) = (constant((along + across).half()), constant((along - across).half()));
        let coenergy = |[_, _, phi]: [_; 3], [a, b, _]: [Tangent<Tangent<Sym>>; 3]| {
            let theta = electric(Analytic::circle(phi), pole_pairs);
            let twice = theta + theta;
            let [of_a, of_b, both] = [mean + half * twice.cos, mean - half * twice.cos, half * twice.sin];
            (of_a * a * a + of_b * b * b).half() + both * a * b + constant(flux) * (a * theta.cos + b * theta.sin)
        };
        let turning = at.electric().moving(at.speed * Sym::int(pole_pairs as i64));
        let [a, b] = at_rest(turning, std::array::from_fn(|k| Tangent::moving(at.currents[k], at.rates[k])));
        let place = [Sym::ZERO, Sym::ZERO, at.phi];
        let velocity = [a.value, b.value, at.speed];
        let residual = lagrange(coenergy, place, velocity, [a.slope, b.slope, at.acceleration]);
        for k in 0..2 {
            let name = format!("{pole_pairs} pole pairs, phase {k}");
            assert_equal(&name, residual[k], at.voltage[k] - resistance * velocity[k]);
        }
        assert_equal("torque", -residual[2], at.torque);
    }
}

/// In Park's axes the coenergy does not depend on the angle; the motional terms result from the brackets of the axes'
/// vector fields.
#[test]
fn the_motional_terms_are_those_of_boltzmann_and_hamel() {
    for pole_pairs in 1..=3 {
        let at = Instant::of(pole_pairs);
        let Magnets { flux, along, across, resistance, .. } = at.machine.magnets;
        let constant = |x: Sym| Tangent::fixed(Tangent::fixed(x));
        let coenergy = |[d, q, _]: [Tangent<Tangent<Sym>>; 3]| {
            (constant(along) * d * d + constant(across) * q * q).half() + constant(flux) * d
        };
        let axes = |theta: Circle<Tangent<Sym>>| {
            let (zero, one) = (Tangent::zero(), Tangent::fixed(Sym::int(1)));
            SMatrix::<_, 3, 3>::new(theta.cos, -theta.sin, zero, theta.sin, theta.cos, zero, zero, zero, one)
        };
        let fields = |[_, _, phi]: [Tangent<Sym>; 3]| axes(electric(phi.circle(), pole_pairs));
        let forms = axes(at.electric().map(Tangent::fixed)).map(|x| x.value).transpose();
        let [d, q] = at.currents;
        let rates = [at.rates[0], at.rates[1], at.acceleration];
        let place = [Sym::ZERO, Sym::ZERO, at.phi];
        let residual = boltzmann_hamel(coenergy, forms, fields, place, [d, q, at.speed], rates);
        let voltage = at_rest(-at.electric(), at.voltage);
        for k in 0..2 {
            let name = format!("{pole_pairs} pole pairs, axis {k}");
            assert_equal(&name, residual[k], voltage[k] - resistance * at.currents[k]);
        }
        assert_equal("torque", -residual[2], at.torque);
    }
}

/// The textbook solution i_q = (V cos - ...)/R, by Cramer's rule.
#[test]
fn the_currents_that_rest_in_step_are_those_of_the_phasor_diagram() {
    let n = |a, b| number(a, b);
    let magnets = Magnets {
        field_speed: n(150, 1),
        voltage: n(14, 1),
        flux: n(3, 100),
        along: n(12, 10_000),
        across: n(2, 1000),
        resistance: n(1, 4),
        f: n(1, 10_000),
    };
    let machine = PermanentMagnet { magnets, pole_pairs: 3 };
    let angle = Circle::from_half_tangent(n(-1, 20));
    let found = steady_currents(&machine, angle, Rational::zero()).expect("they rest");
    let (r, w) = (magnets.resistance, magnets.field_speed * n(3, 1));
    let (reactance_d, reactance_q) = (w * magnets.along, w * magnets.across);
    let load = angle + angle + angle;
    let (along, across) = (magnets.voltage * load.sin, magnets.voltage * load.cos - w * magnets.flux);
    let below = r * r + reactance_d * reactance_q;
    assert_eq!(found[0], (r * along + reactance_q * across) / below);
    assert_eq!(found[1], (r * across - reactance_d * along) / below);
    let mut rates = [number(1, 1); 2];
    torque_and_current_rates(&machine, angle, Rational::zero(), &found, &mut rates);
    assert_eq!(rates, [Rational::zero(); 2]);
}
