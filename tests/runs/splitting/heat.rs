//! The energy loss equals the work of friction and resistance, up to the order of the method.

use super::runs;
use dalembert_derivations::studies::scene::Setup as Kind;
use dalembert_derivations::systems::gyrostat::Gyrostat;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::FirstForm;
use field::{Analytic, DoubleDouble, Over};
use integrators::{Method, Ode, Real, Record, Span, Splitting, System, Tolerance, compose, integrate_in};
use motor::{Machine, Motor, RotorState, Separable, joule_heat};
use simulation::Axes;

const TIME: f64 = 0.4;
/// The number of instants at which the energy is compared.
const INSTANTS: usize = 8;

/// A gyrostat with its dissipated energy D as an additional state: D' = sum R_k i_k^2 - m g'.
struct Losing(Driven<f64, FirstForm<f64>, Motor>);

impl<S: Over<f64> + Analytic> Ode<S> for Losing {
    fn dimension(&self) -> usize {
        self.0.dimension() + 1
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        let known = self.0.machine.rotor();
        let (rotor, end) = (6 + known.dimension(), self.0.dimension());
        let (lost, rates) = dy.split_last_mut().expect("it has components");
        self.0.rates(&y[..end], rates);
        let (_, slip) = known.angle_and_slip(&y[6..rotor]);
        let speed = slip + S::lift(self.0.machine.frame_speed());
        *lost = joule_heat(&self.0.machine, &y[rotor..end]) - self.0.machine.torque_law(slip, speed) * slip;
    }
}

impl System for Losing {}

/// Asserts that the energy loss of every splitting equals heat and friction, by bounds on the error of the lost energy
/// at the instants, and on any increase of E - W p + c0 g, c0 = -m(0).
fn loses_what_is_taken(bodies: &Gyrostat<f64>, machine: Motor, state: &[f64]) {
    assert_eq!(machine.rotor(), RotorState::AngleAndSpeed);
    let friction = machine.torque_law(0.0, machine.frame_speed());
    let losing = Losing(Driven::new(bodies.first_form().0, machine));
    let law = &losing.0;
    let (reference, programs) = (reference(&losing, state), law.programs());
    for splitting in Splitting::ALL {
        let run = |steps: usize| {
            let mut composed = compose(law.pieces_by::<f64>(Some(&programs)).expect("it has pieces"), splitting);
            composed.prepare(TIME / steps as f64);
            composed.enter(state);
            let mut y = state.to_vec();
            let start = law.jacobi(&y);
            let (mut error, mut rise, mut lowest) = (0.0_f64, 0.0_f64, f64::INFINITY);
            for k in 1..=steps {
                assert!(composed.advance());
                composed.leave(&mut y);
                let energy = law.jacobi(&y);
                let falling = energy - friction * y[6];
                lowest = lowest.min(falling);
                rise = rise.max(falling - lowest);
                if (k * INSTANTS).is_multiple_of(steps) {
                    error = error.max((start - energy - reference[k * INSTANTS / steps - 1]).abs());
                }
            }
            (error, rise)
        };
        let (small, theory) = match splitting {
            Splitting::Strang => (1e-5, 2.0),
            Splitting::KahanLi8 => (1e-8, 8.0),
            other => (1e-9, f64::from(other.order())),
        };
        let steps = (0..12).map(|k| INSTANTS << k).find(|steps| run(*steps).0 < small).expect("it converges");
        let [(coarse, rise), (fine, _)] = [run(steps), run(2 * steps)];
        let (order, name) = ((coarse / fine).log2(), splitting.name());
        assert!((-0.5..1.0).contains(&(order - theory)), "{name}: {coarse:.1e} {fine:.1e}, order {order:.2}");
        assert!(rise <= 2.0 * coarse, "{name}: rises by {rise:.1e}, the error is {coarse:.1e}");
    }
}

/// The energy lost up to each instant: the integral of heat and friction in double-double, confirmed by the energies.
fn reference(losing: &Losing, state: &[f64]) -> Vec<f64> {
    let mut start: Vec<DoubleDouble> = state.iter().map(|y| DoubleDouble::from(*y)).collect();
    start.push(DoubleDouble::from(0.0));
    let span = Span::new(0.0, TIME, &start).with_even_outputs(INSTANTS);
    let mut record = Record::new();
    let outcome = integrate_in(losing, Method::Gauss { stages: 8 }, &Tolerance::both(1e-20), &span, &mut record);
    assert!(outcome.reached(), "{:?}", outcome.end);
    let energy = |y: &[DoubleDouble]| losing.0.jacobi(&y[..state.len()]);
    let instant = |y: &Vec<DoubleDouble>| {
        let lost = y[state.len()];
        let gap = (energy(&start) - energy(y) - lost).approx();
        assert!(gap.abs() < 1e-17 && lost.approx().abs() > 1e-3, "{gap:e} of {:e}", lost.approx());
        lost.approx()
    };
    record.states.iter().map(instant).collect()
}

#[test]
fn the_energy_lost_is_the_work_of_friction_and_resistance_to_the_order_and_nothing_is_gained_back() {
    for (name, model) in
        [("spin_up", Some("synchronous")), ("spin_up", Some("equivalent_windings")), ("pull_out", None)]
    {
        let scene = runs::scene(name, model);
        let Kind::Gyrostat(bodies) = &scene.system else { panic!("{name} is a gyrostat") };
        loses_what_is_taken(bodies, scene.machine.clone(), &scene.problem(Axes::First).state);
    }
}
