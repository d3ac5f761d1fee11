//! Quantities that splitting steps preserve: |v|, x.v, the Poisson bracket, the energy within bounds, the contraction
//! of volumes.

use super::runs::{self, SCENES, split};
use dalembert_derivations::studies::scene::Setup;
use dalembert_derivations::systems::gyrostat::Gyrostat;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::momenta::Point;
use field::DoubleDouble;
use integrators::{Jacobian, Method, Pieces, Span, Splitting, compose};
use motor::{Motor, Point as RotorPoint, Separable};
use nalgebra::{DMatrix, Vector3};
use simulation::Axes;

/// The deviation of a named invariant at the end of a run, relative to its initial magnitude or to the given scale.
fn drift(name: &str, model: Option<&str>, method: Method, time: f64, invariant: &str, scale: f64) -> f64 {
    let problem = runs::problem(name, model, Axes::First);
    let found = problem.invariants.iter().find(|known| known.name == invariant).expect("the scene has it");
    let outcome = runs::run(&problem, method, &Span::new(0.0, time, &problem.state));
    ((found.value)(time, &outcome.state) - (found.value)(0.0, &problem.state)).abs() / scale
}

/// Each of n rotations changes the length of v by about half a rounding unit with a random sign: a random walk with a
/// displacement of about sqrt(n) units. Four times this is allowed, which is far less than n units.
#[test]
fn the_length_of_the_vertical_and_the_vertical_momentum_walk_at_random() {
    for (name, model) in SCENES {
        for splitting in [Splitting::Strang, Splitting::BlanesMoan6] {
            let steps = 40_000;
            let turns = f64::from(steps) * (4.0 * splitting.stages() as f64 + 1.0);
            let allowed = 4.0 * turns.sqrt() * f64::EPSILON / 2.0;
            let length = drift(name, model, split(splitting, steps), 20.0, "vertical_length", 2.0);
            // |x| is below 0.1 kg m^2/s in these scenes
            let momentum = drift(name, model, split(splitting, steps), 20.0, "vertical_momentum", 0.1);
            let what = format!("{name} {model:?} {}", splitting.name());
            assert!(length < allowed, "{what}: |v| by {length:.1e}, allowed {allowed:.1e}");
            assert!(momentum < allowed, "{what}: x.v by {momentum:.1e}, allowed {allowed:.1e}");
        }
    }
}

#[test]
fn a_rotor_without_moment_keeps_its_spin_exactly() {
    let spin = drift("free_rotor", None, split(Splitting::BlanesMoan4, 10_000), 10.0, "rotor_momentum", 1.0);
    assert!(spin < 1e-16, "{spin:e}");
}

/// For a run sixteen times as long, on a nonintegrable motion, the energy error oscillates within the same bounds,
/// which depend on the step size according to the order. The energy drift of other methods is measured for a motion in
/// closed form: `long.rs`.
#[test]
fn the_energy_swings_within_bounds_that_have_the_order_of_the_method() {
    for (splitting, order) in [(Splitting::Strang, 2.0), (Splitting::BlanesMoan4, 4.0)] {
        let worst = |rate: f64, time: f64| {
            let problem = runs::problem("free_rotor", None, Axes::First);
            let jacobi = problem.invariants.iter().find(|known| known.name == "jacobi").expect("it is conserved");
            let span = Span::new(0.0, time, &problem.state).with_monitor("jacobi", |t, y| (jacobi.value)(t, y));
            runs::run(&problem, split(splitting, (time * rate) as u32), &span).deviations[0].largest
        };
        let (brief, long) = (worst(500.0, 10.0), worst(500.0, 160.0));
        assert!(long < 1.5 * brief, "{splitting:?}: {brief:e} {long:e}");
        let (coarse, fine) = (worst(1000.0, 10.0), worst(2000.0, 10.0));
        assert!(((coarse / fine).log2() - order).abs() < 0.2, "{splitting:?}: {coarse:e} {fine:e}");
    }
}

/// The Jacobian matrix of one step, by differences in double-double, between any two coordinates.
fn matrix(step: impl Fn(&[DoubleDouble]) -> Vec<DoubleDouble>, at: &[DoubleDouble]) -> DMatrix<f64> {
    let tiny = DoubleDouble::from(1e-9);
    let columns: Vec<Vec<f64>> = (0..at.len())
        .map(|k| {
            let moved = |by: DoubleDouble| {
                let mut at = at.to_vec();
                at[k] += by;
                step(&at)
            };
            let (above, below) = (moved(tiny), moved(-tiny));
            above.iter().zip(&below).map(|(a, b)| ((*a - *b) / (tiny + tiny)).hi()).collect()
        })
        .collect();
    DMatrix::from_fn(columns[0].len(), at.len(), |i, k| columns[k][i])
}

const STEP: f64 = 0.01;

/// The determinant of the Jacobian matrix of a step, and its value from the divergence of the law.
fn volumes(bodies: &Gyrostat<f64>, machine: Motor, state: &[f64], splitting: Splitting) -> (f64, f64) {
    let law = Driven::new(bodies.first_form().0, machine);
    let n = state.len();
    let step = |y: &[DoubleDouble]| {
        let mut composed = compose(law.pieces().expect("it has pieces"), splitting);
        composed.prepare(DoubleDouble::from(STEP));
        composed.enter(y);
        assert!(composed.advance());
        let mut after = y.to_vec();
        composed.leave(&mut after);
        after
    };
    let twice: Vec<DoubleDouble> = state.iter().map(|y| DoubleDouble::from(*y)).collect();
    let mut jacobian = vec![0.0; n * n];
    Jacobian::new(&law).matrix(0.0, state, &mut jacobian);
    let divergence: f64 = (0..n).map(|k| jacobian[k * n + k]).sum();
    (matrix(step, &twice).determinant(), (STEP * divergence).exp())
}

/// Friction and resistance contract volumes at a constant rate; every step does so exactly, for any step size and
/// order.
#[test]
fn volumes_shrink_exactly_as_the_divergence_of_the_law_says() {
    for (name, model) in [("pull_out", None), ("spin_up", Some("synchronous")), ("free_rotor", None)] {
        let scene = runs::scene(name, model);
        let Setup::Gyrostat(bodies) = &scene.system else { panic!("{name} is a gyrostat") };
        let state = scene.problem(Axes::First).state;
        for splitting in Splitting::ALL {
            let (found, theory) = volumes(bodies, scene.machine.clone(), &state, splitting);
            let what = format!("{name} {model:?} {}", splitting.name());
            assert!((found / theory - 1.0).abs() < 1e-12, "{what}: {found} and {theory}");
            assert_eq!(theory < 0.999, name != "free_rotor", "{what}: {theory}");
        }
    }
}

/// The matrix B of the bracket {f, g} = df.B dg in the coordinates (x, v, angle, spin): x' = x x dH/dx + v x dH/dv,
/// v' = v x dH/dx, angle' = dH/dp, p' = -dH/dangle.
fn bracket(z: &[DoubleDouble]) -> DMatrix<f64> {
    let at = point(z);
    let [x, v] = [at.momentum, at.vertical].map(|a| a.map(|a| a.hi()).cross_matrix());
    let mut b = DMatrix::zeros(8, 8);
    b.view_mut((0, 0), (3, 3)).copy_from(&x);
    b.view_mut((0, 3), (3, 3)).copy_from(&v);
    b.view_mut((3, 0), (3, 3)).copy_from(&v);
    (b[(6, 7)], b[(7, 6)]) = (1.0, -1.0);
    b
}

/// The condition M B(z) M^T = B(step(z)): without friction a step is a Poisson map, like the flow itself.
#[test]
fn without_friction_a_step_keeps_the_bracket() {
    let scene = runs::scene("spin_up", Some("synchronous"));
    let Setup::Gyrostat(bodies) = &scene.system else { panic!("it is a gyrostat") };
    let law = Driven::new(bodies.first_form().0, scene.machine.with("f", 0.0).expect("it has friction"));
    let pieces = law.in_momenta::<DoubleDouble>(None).expect("it has pieces");
    let state = [0.3, -0.2, 4.0, 0.6, 0.0, 0.8, 0.7, -11.0].map(DoubleDouble::from);
    let start = flat(&pieces.enter(&state));
    for splitting in Splitting::ALL {
        let step = |z: &[DoubleDouble]| {
            let mut at = point(z);
            for (place, share) in splitting.coefficients::<DoubleDouble>().into_iter().enumerate() {
                let count = pieces.pieces();
                for piece in (0..count).map(|k| if place % 2 == 0 { k } else { count - 1 - k }) {
                    let substep = pieces.substep(piece, share * DoubleDouble::from(STEP));
                    assert!(pieces.flow(piece, &substep, &mut at));
                }
            }
            flat(&at)
        };
        let m = matrix(step, &start);
        let gap = (&m * bracket(&start) * m.transpose() - bracket(&step(&start))).amax();
        assert!(gap < 1e-12, "{}: {gap:e}", splitting.name());
    }
}

fn point(z: &[DoubleDouble]) -> Point<DoubleDouble> {
    let three = |from: usize| Vector3::new(z[from], z[from + 1], z[from + 2]);
    let rotor = RotorPoint { angle: z[6], momentum: z[7], fluxes: Vec::new() };
    Point { momentum: three(0), vertical: three(3), rotor }
}

fn flat(at: &Point<DoubleDouble>) -> Vec<DoubleDouble> {
    let bodies = at.momentum.iter().chain(at.vertical.iter());
    bodies.chain([&at.rotor.angle, &at.rotor.momentum]).copied().collect()
}
