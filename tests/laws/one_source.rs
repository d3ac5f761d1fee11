//! One law over many scalar types: as an expression it has the same values as the compiled law, and three methods of
//! differentiation agree.

use crate::physical::fixed;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::systems::gyrostat::forms::{FirstForm, Form, SecondForm};
use dalembert_derivations::systems::gyrostat::{Carrier, Gyrostat, Rotor};
use field::{Analytic, Base, Circle, Over, Tangent};
use motor::{Machine, joule_heat, stored_energy, torque_and_current_rates};
use nalgebra::{Matrix3, Vector3};
use num_dual::Dual64;
use proptest::prelude::*;
use std::convert::Infallible;
use symbolic::Sym;

/// The numbers of parameters and of variables of the laws.
const PARAMETERS: usize = 39;
const VARIABLES: usize = 18;

/// Numbers, taken in order.
struct Given<I>(I);

impl<P, I: Iterator<Item = P>> Given<I> {
    fn one(&mut self) -> P {
        self.0.next().expect("as many numbers as the laws ask for")
    }
    fn three(&mut self) -> Vector3<P>
    where
        P: field::Scalar,
    {
        Vector3::from([self.one(), self.one(), self.one()])
    }
}

/// The laws used in integrations, each with a name: those of the bodies, of both forms, of a motor with three bars.
fn laws<P: Base, S: Over<P> + Analytic>(parameters: &[P], variables: &[S]) -> Vec<(&'static str, S)> {
    let mut p = Given(parameters.iter().copied());
    let mut x = Given(variables.iter().copied());
    let (w, w_rate, v) = (x.three(), x.three(), x.three());
    let (speed, acceleration, moment, angle, slip) = (x.one(), x.one(), x.one(), x.one().circle(), x.one());
    let currents = [x.one(), x.one(), x.one(), x.one()];

    let g = Gyrostat {
        carrier: Carrier { mass: p.one(), centre: p.three(), inertia: symmetric(p.three(), p.three()) },
        rotor: Rotor { mass: p.one(), centre: p.three(), axis: p.three(), axial: p.one(), transverse: p.one() },
        gravity: p.one(),
    };
    let (first, second) = (
        FirstForm::new(p.three(), g.rotor.axis, g.rotor.axial, g.weight()),
        SecondForm::new(p.three(), g.rotor.axis, g.rotor.axial, g.weight()),
    );
    let Ok(windings) = Windings::read(|_| Ok::<P, Infallible>(p.one()));
    let motor = MultiCurrent { windings, bars: [p.one(), p.one(), p.one()].map(Circle::from_half_tangent).into() };

    let [total, spin] = g.angular_momentum(w, speed);
    let (a1, f1) = first.accelerations(w, v, speed, moment);
    let (a2, f2) = second.accelerations(w, v, speed, moment);
    let (kept, reaction) = second.prescribed(w, v, speed);
    let mut rates = [S::zero(); 4];
    let torque = torque_and_current_rates(&motor, angle, slip, &currents, &mut rates);
    vec![
        ("T", g.kinetic_energy(w, speed)),
        ("V", g.potential_energy(v)),
        ("S", g.acceleration_energy(w, speed, w_rate, acceleration)),
        ("x1", total.x),
        ("l.x'", spin.dot(&g.rotor.axis.map(S::lift))),
        ("w1' of the first form", a1.x),
        ("phi'' of the first form", f1),
        ("w2' of the second form", a2.y),
        ("phi'' of the second form", f2),
        ("w3' at a kept speed", kept.z),
        ("reaction", reaction),
        ("energy of the first form", first.energy(w, v, speed)),
        ("energy of the second form", second.energy(w, v, speed)),
        ("flux of the excitation", motor.linkage(0, angle)),
        ("flux of a bar", motor.linkage(2, angle)),
        ("moment of the motor", torque),
        ("rate of the excitation", rates[0]),
        ("rate of a bar", rates[3]),
        ("energy of the circuits", stored_energy(&motor, angle, &currents)),
        ("heat", joule_heat(&motor, &currents)),
    ]
}

fn symmetric<P: field::Scalar>(diagonal: Vector3<P>, off: Vector3<P>) -> Matrix3<P> {
    Matrix3::new(diagonal.x, off.x, off.y, off.x, diagonal.y, off.z, off.y, off.z, diagonal.z)
}

fn symbols(stem: char, count: usize) -> Vec<Sym> {
    (0..count).map(|n| Sym::symbol(&format!("{stem}{n}"))).collect()
}

/// The value of an expression in p0, p1, ... and x0, x1, ...
fn value(expression: Sym, parameters: &[f64], variables: &[f64]) -> f64 {
    let number = |name: &str| {
        let (stem, place) = name.split_at(1);
        let numbers = if stem == "p" { parameters } else { variables };
        place.parse().ok().and_then(|place: usize| numbers.get(place).copied())
    };
    expression.evaluate_analytic(&number).expect("every symbol has a value")
}

/// Whether two numbers are equal up to rounding. The laws are sums of a few dozen products of up to six numbers below
/// 2, divided by numbers above 1/4: intermediate terms are below 2^12.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 4096.0 * 64.0 * f64::EPSILON
}

/// The bodies' data are below 1/2, the forms' moments of inertia and all other data above 1, so that no form comes near
/// D = 0.
fn parameters() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.25..0.5f64, PARAMETERS).prop_map(|mut p| {
        p[18..].iter_mut().for_each(|p| *p *= 4.0);
        p
    })
}

fn variables() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-2.0..2.0f64, VARIABLES)
}

proptest! {
    #![proptest_config(fixed(64))]

    #[test]
    fn a_law_written_down_has_the_value_of_the_law_that_runs(p in parameters(), x in variables()) {
        let written = laws(&symbols('p', PARAMETERS), &symbols('x', VARIABLES));
        for ((name, expression), (_, number)) in written.into_iter().zip(laws(&p, &x)) {
            let from_text = value(expression, &p, &x);
            prop_assert!(close(from_text, number), "{name}: {from_text} and {number}");
        }
    }

    #[test]
    fn tangents_duals_and_expressions_have_the_same_derivatives(p in parameters(), x in variables(), along in 0..VARIABLES) {
        let (written, variable) = (symbols('x', VARIABLES), symbols('x', VARIABLES)[along]);
        let moving = |i| if i == along { 1.0 } else { 0.0 };
        let tangents: Vec<_> = x.iter().enumerate().map(|(i, &x)| Tangent::moving(x, moving(i))).collect();
        let duals: Vec<_> = x.iter().enumerate().map(|(i, &x)| Dual64::new(x, moving(i))).collect();
        let expressions = laws(&symbols('p', PARAMETERS), &written);
        let numbers = laws(&p, &tangents).into_iter().zip(laws(&p, &duals));
        for ((name, expression), ((_, tangent), (_, dual))) in expressions.into_iter().zip(numbers) {
            let slope = value(expression.diff(variable), &p, &x);
            prop_assert!(close(tangent.slope, dual.eps), "{name}: {} and {}", tangent.slope, dual.eps);
            prop_assert!(close(tangent.slope, slope), "{name}: {} and {slope}", tangent.slope);
        }
    }
}
