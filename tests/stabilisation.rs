//! Stabilised constraints as they run, beside the exact regions of their gains.

use derivations::stabilisation::experiment;
use derivations::stabilisation::regions::{self, Fate};
use derivations::stabilisation::schemes::Scheme;
use derivations::stabilisation::treatments::{Goal, Line, Measured, RUNS, Scan, Treatment, compare, times};
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

fn of(lines: &[Line], scheme: Scheme, treatment: Treatment) -> [Measured; 2] {
    let mut found = lines.iter().filter(|line| line.scheme == scheme && line.treatment == treatment);
    [(); 2].map(|()| {
        let line = found.next().expect("every treatment is run with two steps");
        line.measured.as_ref().expect("the combination exists").as_ref().copied().expect("the run reached its end")
    })
}

/// Which power of the step the error goes with.
fn order([coarse, fine]: [Measured; 2]) -> f64 {
    (coarse.error / fine.error).log2()
}

#[test]
fn look() {
    let goal = Goal::new().expect("ref");
    let begin = std::time::Instant::now();
    let scans: Vec<Scan> = RUNS
        .iter()
        .map(|(scheme, steps)| {
            let s = Scan::of(*scheme, *steps, &goal);
            println!("{scheme:?} {steps} {:.2}", begin.elapsed().as_secs_f64());
            s
        })
        .collect();
    for s in &scans {
        println!("{:?} {} {:?} {:?}", s.scheme, s.steps, s.best(), s.without);
        for p in &s.points {
            println!("   {:.4} {:.3e} {:.3e}", p.rate, p.drift, p.error);
        }
    }
    let lines: Vec<Line> = RUNS.iter().zip(&scans).flat_map(|((a, b), c)| compare(*a, *b, c, &goal)).collect();
    println!("{:.2}", begin.elapsed().as_secs_f64());
    let t = times(&lines, std::time::Duration::from_secs(20));
    println!("{:.2}", begin.elapsed().as_secs_f64());
    let f = t.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    for (l, t) in lines.iter().zip(t) {
        println!("{:?} {} {} {:?} {:?}", l.scheme, l.steps, l.treatment.name(), l.measured, t.map(|t| t / f));
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
            assert!((exact[i] - found[i]).abs() < 1e-4, "{}: {} and {}", experiment::UNKNOWNS[i], exact[i], found[i]);
        }
    }
}
