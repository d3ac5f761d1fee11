//! Systems of the second paper (Mukharlyamov 2007) as text, compared with closed forms and with the paper's own equations.

use dalembert_scenes::ModelScene;
use integrators::{Method, Ode, Span, System, Tolerance, integrate};
use nalgebra::Vector3;
use simulation::{Choice, IvpScene, Trajectory};
use systems::variable_top::{Attitude, Top, poisson};

fn runs(name: &str, edits: &[(&str, &str)]) -> Trajectory {
    let path = format!("{}/../../scenes/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let text = edits.iter().fold(text, |text, (from, to)| {
        assert_eq!(text.matches(from).count(), 1, "{from}");
        text.replace(from, to)
    });
    let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method: Method::DormandPrince8, tolerance: 1e-12, ..scene.run().choice() };
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    assert_eq!(trajectory.stopped(), None, "{name}");
    trajectory
}

/// Compares every row of a run with a function of the time.
fn follows(trajectory: &Trajectory, column: &str, known: impl Fn(f64) -> f64) {
    let at = trajectory.column(column).unwrap_or_else(|| panic!("{column}: {:?}", trajectory.names));
    for (time, row) in trajectory.times.iter().zip(&trajectory.rows) {
        let known = known(*time);
        assert!((row[at] - known).abs() < 1e-9 * (1.0 + known.abs()), "{time}: {} and {known}", row[at]);
    }
}

/// p' + w p = u for the funds p = m y'.
#[test]
fn funds_go_to_the_supply_over_the_wear() {
    follows(&runs("production", &[]), "funds", |t| 1.5 / 0.3 * (1.0 - (-0.3 * t).exp()));
}

/// Without denial and from I = 0, v = I' satisfies L/2 d(v^2)/dI = M - I/G + b v^2: v^2 is the sum of an exponential and a linear function of I.
#[test]
fn learning_without_denial_has_its_first_integral() {
    let trajectory =
        runs("learning", &[("tau = \"1.2 kg/s\"", "tau = \"0 kg/s\""), ("span = \"10 s\"", "span = \"1.5 s\"")]);
    let (inertia, bend, leak, potential) = (2.0, 0.4, 0.5, 1.0);
    let growth = 2.0 * bend / inertia;
    // v^2 = a + c I + e exp(growth I), with the linear part from the equation and v(0) = 0
    let c = 1.0 / (leak * bend);
    let a = (c * inertia / 2.0 - potential) / bend;
    for row in &trajectory.rows {
        let (learned, rate) = (row[0], row[1]);
        let square = a + c * learned - a * (growth * learned).exp();
        assert!((rate * rate - square).abs() < 1e-9, "{learned}: {} {square}", rate * rate);
    }
}

/// Without gravity the angular momentum is M t.
#[test]
fn a_loaded_link_without_weight_has_the_moment_of_momentum_of_its_motor() {
    let trajectory = runs("loaded_link", &[("g = \"9.81 m/s^2\"", "g = \"0 m/s^2\"")]);
    follows(&trajectory, "phi'", |t| 5.0 * t / (0.05 + 2.0 * (0.2 + 0.05 * t).powi(2)));
}

/// p' + (beta/m) p = R with m = m0 + c t: p = R m/(beta + c) + C m^(-beta/c).
#[test]
fn a_point_of_variable_mass_slows_down_as_its_closed_form() {
    let (first, rate, resistance, push) = (3.0, -0.1, 0.4, 1.0);
    let even = push / (resistance + rate);
    let scale = (first * 2.0 - even * first) / f64::powf(first, -resistance / rate);
    follows(&runs("variable_point", &[]), "x'", |t| {
        let mass: f64 = first + rate * t;
        (even * mass + scale * mass.powf(-resistance / rate)) / mass
    });
}

/// The paper's equations of the body with a gyroscope, compiled into the program for the claims.
struct Paper;

impl Paper {
    fn top(t: f64) -> Top<f64> {
        let left = 1.0 - 0.02 * t;
        Top {
            equatorial: 1.2 * left,
            axial: 0.5 * left,
            static_moment: 0.8 * left,
            gyroscope: 2.0,
            gravity: 9.81,
            tide: 3.0 * 9.81 / 40.0,
        }
    }
}

impl Ode<f64> for Paper {
    fn dimension(&self) -> usize {
        6
    }

    fn rates(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        let at = Attitude { spin: Vector3::new(y[0], y[1], y[2]), vertical: Vector3::new(y[3], y[4], y[5]) };
        let top = Paper::top(t);
        let spin = top.acceleration(at.spin, top.moment_of_field(at.vertical));
        dy[..3].copy_from_slice(spin.as_slice());
        dy[3..].copy_from_slice(poisson(&at).as_slice());
    }
}

macro_rules! not_asked_for {
    ($($field:ty),*) => {$(
        impl Ode<$field> for Paper {
            fn dimension(&self) -> usize {
                6
            }

            fn rates(&self, _: $field, _: &[$field], dy: &mut [$field]) {
                dy.fill(<$field>::from(f64::NAN));
            }
        }
    )*};
}
not_asked_for!(integrators::Dual8, field::DoubleDouble);

impl System for Paper {}

#[test]
fn a_body_of_variable_mass_with_a_gyroscope_moves_by_the_papers_equations() {
    let trajectory = runs("variable_top", &[]);
    let tilt = 30f64.to_radians();
    let start = [0.2, 0.0, 3.0, 0.0, tilt.sin(), tilt.cos()];
    let span = Span::new(0.0, 5.0, &start);
    let known = integrate(&Paper, Method::DormandPrince8, &Tolerance::both(1e-12), &span, &mut ());
    assert!(known.reached());
    for (name, expected) in ["F.wx", "F.wy", "F.wz"].iter().zip(&known.state) {
        let found = trajectory.last[trajectory.column(name).expect("a speed")];
        assert!((found - expected).abs() < 1e-8, "{name}: {found} {expected}");
    }
}
