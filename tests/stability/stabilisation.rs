//! Runs with constraint stabilisation, compared with the exact stability regions of the gains.

use dalembert_derivations::studies::stabilisation::drive_law::UNKNOWNS;
use dalembert_derivations::studies::stabilisation::experiment;
use dalembert_derivations::studies::stabilisation::law::BothHeld;
use dalembert_derivations::studies::stabilisation::regions::{self, Fate};
use dalembert_derivations::studies::stabilisation::schemes::Scheme;
use dalembert_derivations::studies::stabilisation::treatments::{
    Goal, Line, Measured, Scan, Treatment, measure, times,
};
use field::Scalar;
use integrators::{Index2Dae, Method, Ode, Span, System, Tolerance, integrate};
use std::time::Duration;

/// The violation y of a constraint: y'' = -b y' - k y.
struct Violation {
    damping: f64,
    stiffness: f64,
}

impl<S: Scalar + field::Over<f64>> Ode<S> for Violation {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[1];
        dy[1] = -S::lift(self.damping) * y[1] - S::lift(self.stiffness) * y[0];
    }
}

impl System for Violation {}

#[test]
fn the_step_that_is_proved_is_the_step_that_runs() {
    let (h, beta, kappa) = (0.125, 1.25, 0.75);
    let law = Violation { damping: beta / h, stiffness: kappa / (h * h) };
    for scheme in Scheme::ALL {
        let matrix = scheme.transition(beta, kappa).expect("these gains can be solved for");
        for (y, dy) in [(1.0, 0.0), (0.0, 1.0), (0.3, -2.0)] {
            let span = Span::new(0.0, h, &[y, dy]);
            let ran = integrate(&law, scheme.method(1), &Tolerance::both(1e-9), &span, &mut ()).state;
            let exact = [matrix[0][0] * y + matrix[0][1] * h * dy, (matrix[1][0] * y + matrix[1][1] * h * dy) / h];
            for (ran, exact) in ran.iter().zip(exact) {
                assert!((ran - exact).abs() < 1e-13 * exact.abs().max(1.0), "{scheme:?}: {ran} is not {exact}");
            }
        }
    }
}

#[test]
fn the_mechanism_regains_its_constraint_where_theory_says() {
    for map in Scheme::ALL.map(|scheme| regions::map(scheme, 24, 20)) {
        let cells: usize = map.rows.iter().map(Vec::len).sum();
        let grows = map.rows.iter().flatten().filter(|fate| **fate == Fate::Grows).count();
        println!(
            "{:?}: {} of {cells} cells mistaken, {grows} grow, {} edges",
            map.scheme,
            map.mistaken,
            map.edges.len()
        );
        // a cell whose centre is close to the boundary may need more steps than are computed
        assert!(map.mistaken <= cells / 100, "{:?}: {} of {cells} cells", map.scheme, map.mistaken);
    }
}

/// A treatment with a number of steps, and with twice as many.
fn of(goal: &Goal, scheme: Scheme, steps: u32, treatment: Treatment) -> [Measured; 2] {
    [steps, 2 * steps].map(|steps| {
        let found = measure(scheme, steps, treatment, goal).expect("the combination exists");
        found.unwrap_or_else(|failure| panic!("{scheme:?}, {}: {failure}", treatment.name()))
    })
}

/// The observed order of the error in the step size.
fn order([coarse, fine]: [Measured; 2]) -> f64 {
    (coarse.error / fine.error).log2()
}

fn goal() -> Goal {
    Goal::new().expect("the reference is reached")
}

#[test]
fn treatments_of_the_constraint_have_their_orders_and_drifts() {
    use Treatment::*;
    let goal = goal();
    let kutta = |treatment| of(&goal, Scheme::RungeKutta4, 1_000, treatment);
    for (treatment, theory) in [(IndexReduction, 4.0), (Moderate, 4.0), (Projected, 4.0), (Minimal, 4.6)] {
        let found = order(kutta(treatment));
        assert!((found - theory).abs() < 0.7, "{treatment:?}: {found:.2}");
    }
    // gains that grow as 1/h make the equations stiff for every step size
    assert!((order(kutta(Fastest)) - 1.0).abs() < 0.3);
    for (scheme, steps) in [(Scheme::Euler, 20_000), (Scheme::RungeKutta4, 1_000), (Scheme::ImplicitMidpoint, 1_000)] {
        for treatment in [Projected, GearGuptaLeimkuhler, Minimal] {
            let kept = of(&goal, scheme, steps, treatment);
            assert!(kept.iter().all(|found| found.drift < 1e-14 && found.rate_drift < 1e-13), "{scheme:?}: {kept:?}");
        }
    }
    // Euler's residual violation decreases with h^2, the drift without stabilisation with h
    let drifts = |treatment| of(&goal, Scheme::Euler, 20_000, treatment).map(|found| found.drift);
    let ratio = |[coarse, fine]: [f64; 2]| coarse / fine;
    assert!((ratio(drifts(Fastest)) - 4.0).abs() < 0.3 && (ratio(drifts(IndexReduction)) - 2.0).abs() < 0.2);
}

#[test]
fn both_constraints_held_have_the_order_of_theory_with_every_method() {
    let goal = goal();
    let both = |scheme, steps| of(&goal, scheme, steps, Treatment::GearGuptaLeimkuhler);
    for (scheme, steps, theory) in [
        (Scheme::Euler, 80_000, 1.0),
        (Scheme::RungeKutta4, 2_000, 3.0),
        (Scheme::ImplicitMidpoint, 4_000, 2.0),
        // with fewer steps its error over nine turns is as large as the motion
        (Scheme::BackwardEuler, 80_000, 1.0),
    ] {
        let found = both(scheme, steps);
        assert!((order(found) - theory).abs() < 0.15, "{scheme:?}: {:.2}", order(found));
        // the angle ends at 60 and is rounded there; f changes at most twice as fast as the angle, f' twelve times
        let rounding = 60.0 * f64::EPSILON;
        let kept = |found: &Measured| found.drift < 2.0 * rounding && found.rate_drift < 12.0 * rounding;
        assert!(found.iter().all(kept), "{scheme:?}: {found:?}");
    }
}

/// In q' = v + M^-1 J^T mu and v' = M^-1 (F + J^T lambda) the columns are those of (mu, lambda), in this order.
#[test]
fn the_first_multiplier_moves_the_places_and_the_second_the_velocities() {
    let law = BothHeld::<_, 2, 1>(&regions::MECHANISM);
    let (y, z) = ([0.3, 1.5, 1.0, -0.2], [2.0, -3.0]);
    let ([mut rates, mut free], mut columns) = ([[0.0; 4]; 2], [0.0; 8]);
    law.rates(0.0, &y, &z, &mut rates);
    law.parts(0.0, &y, &mut free, &mut columns);
    for i in 0..4 {
        let sum = free[i] + columns[i] * z[0] + columns[4 + i] * z[1];
        assert!((rates[i] - sum).abs() < 1e-14, "{i}: {} and {sum}", rates[i]);
    }
    assert_eq!((&free[..2], &columns[2..4], &columns[4..6]), (&y[2..], &[0.0; 2][..], &[0.0; 2][..]));
}

#[test]
fn the_gain_of_the_least_error_does_not_go_with_the_step() {
    let goal = goal();
    for (scheme, steps) in [(Scheme::Euler, 20_000), (Scheme::RungeKutta4, 1_000), (Scheme::ImplicitMidpoint, 1_000)] {
        let scans = [steps, 2 * steps].map(|steps| Scan::of(scheme, steps, &goal));
        let [coarse, fine] = scans.map(|scan| scan.best().expect("some gain is better than none"));
        let ratio = fine.rate / coarse.rate;
        assert!((0.85..1.15).contains(&ratio), "{scheme:?}: {} and {}", coarse.rate, fine.rate);
        // the chosen gains are worth their cost: neither without stabilisation nor with the fastest decay is the error
        // as small
        let error = |treatment| of(&goal, scheme, steps, treatment)[0].error;
        assert!(coarse.error < 0.5 * error(Treatment::IndexReduction), "{scheme:?}: {}", coarse.error);
        assert!(coarse.error < 0.1 * error(Treatment::Fastest), "{scheme:?}: {}", coarse.error);
    }
}

#[test]
fn every_treatment_that_reached_its_end_is_timed_and_no_other() {
    let (goal, scheme, steps) = (goal(), Scheme::BackwardEuler, 200);
    let line = |treatment| Line { scheme, steps, treatment, measured: measure(scheme, steps, treatment, &goal) };
    let lines = Treatment::PLAIN.map(line);
    let times = times(&lines, Duration::from_secs(10));
    for (line, time) in lines.iter().zip(times) {
        assert_eq!(
            time.is_some_and(|time| time > 0.0),
            matches!(line.measured, Some(Ok(_))),
            "{}",
            line.treatment.name()
        );
    }
}

#[test]
fn the_drive_bears_the_step_and_the_gains_that_theory_allows() {
    let bearable = experiment::bearable().expect("the exact motion is reached");
    println!("{bearable:?} {}", experiment::most_damping(1e4));
    assert!(bearable.plain > experiment::STEP && bearable.stabilised > experiment::STEP);
    assert!((experiment::most_damping(1e4) - 250.0).abs() < 10.0);
    let euler = |damping, stiffness| {
        experiment::run("", |steps| Method::Euler { steps }, experiment::STEP, damping, stiffness).drift().0
    };
    let (plain, kept) = (euler(0.0, 0.0), euler(200.0, 1e4));
    assert!(plain > 0.1 && kept < 2e-3, "{plain} and {kept}");
}

#[test]
fn the_nine_equations_are_those_of_the_drive_without_its_slider() {
    let (exact, digits) = experiment::exact(20).expect("both methods reach the end");
    assert!(digits > 8.0, "{digits}");
    let nine = experiment::run("", |steps| Method::RungeKutta4 { steps }, 0.002, 0.0, 0.0);
    for ((_, exact), (_, found)) in exact.iter().zip(nine.points[1..].chunks(500).map(|chunk| chunk[499])) {
        for i in 0..9 {
            assert!((exact[i] - found[i]).abs() < 1e-4, "{}: {} and {}", UNKNOWNS[i], exact[i], found[i]);
        }
    }
}
