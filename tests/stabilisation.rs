//! Stabilised constraints as they run, beside the exact regions of their gains.

use derivations::stabilisation::experiment;
use derivations::stabilisation::regions::{self, Fate};
use derivations::stabilisation::schemes::Scheme;
use derivations::stabilisation::treatments;
use field::Scalar;
use integrators::{Method, Ode, Span, System, Tolerance, integrate};

/// y'' = -b y' - k y.
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
    for map in regions::maps(24, 20) {
        let cells: usize = map.rows.iter().map(Vec::len).sum();
        let grows = map.rows.iter().flatten().filter(|fate| **fate == Fate::Grows).count();
        println!(
            "{:?}: {} of {cells} cells mistaken, {grows} grow, {} edges",
            map.scheme,
            map.mistaken,
            map.edges.len()
        );
        // a cell whose middle is nearly on the edge may need more steps than are looked at
        assert!(map.mistaken <= cells / 100, "{:?}: {} of {cells} cells", map.scheme, map.mistaken);
    }
}

#[test]
fn treatments_of_the_constraint() {
    for line in treatments::compare().expect("the reference is reached") {
        println!("{:<18} {:>6} {:<32} {:?}", line.scheme.name(), line.steps, line.treatment.name(), line.measured);
    }
}

#[test]
fn the_drive_as_in_the_experiment() {
    let (exact, digits) = experiment::exact(200).expect("reached");
    println!("digits {digits}");
    for (name, b, k) in [
        ("plain", 0.0, 0.0),
        ("paper-like", 2.0, 1.0),
        ("moderate", 20.0, 100.0),
        ("deadbeat", 200.0, 1e4),
        ("too much", 250.0, 1e4),
    ] {
        for step in [0.01, 0.001] {
            let t = experiment::run(name, |steps| Method::Euler { steps }, step, b, k);
            let last = t.points.last().unwrap();
            println!("{name} {step} {:?} drift {:?} end {:?} {:?}", t.failure, t.drift(), last.0, last.1);
        }
    }
    println!("exact {:?}", exact.last().unwrap());
    for k in (0..200).step_by(10) {
        println!("{:.2?}", exact[k]);
    }
}
