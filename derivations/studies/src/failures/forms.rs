//! Rounding errors and step limits of the gyrostat's first and second form for D -> 0.

use super::bounds::swinging;
use super::edge::edge;
use super::trials::{Fate, Tried, near};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::scene::{Scene, Setup};
use crate::stabilisation::schemes::Scheme;
use crate::stationary::motions::decimals;
use field::{Base, Rational};
use integrators::{Method, Span, Tolerance, integrate};
use nalgebra::{Matrix3, Vector3};
use num_traits::One;
use reader::Family;
use simulation::{Axes, Problem};
use std::path::Path;
use systems::gyrostat::Gyrostat;
use systems::gyrostat::forms::{FirstForm, Form, SecondForm};

pub const FAILING: Failing = Failing {
    name: "forms",
    title: "first and second form as D tends to zero",
    scene: "failures/light_carrier.toml",
    why: r"With $l$ and $\Gamma e$ along one principal axis $A'D\,\ddot\varphi=M$: the rotor swings in the field with $\omega^2=b_0/(A'D)$, and an explicit step must follow. The second form has $D=1-A'\,l\cdot A^{*-1}l$ as the difference of two numbers near one, rounded to $\frac32\,2^{-53}$: its accelerations lose the digits of $1/D$, and all of them where $D$ is of that size. The first form divides by $A$, and loses none where $A$ is formed from the bodies and not as $A^*-A'\,l\,l^T$.",
    advice: "Use the first form, whose tensor A comes from the bodies, and a method whose step follows the swing; at D = 0 the motion is not determined, and the scene is refused.",
    asked: "the motion within 1/1000",
    measure,
};

/// The number of steps in which growth of an oscillation is detected.
const STEPS: u32 = 4_000;
/// The initial angle of an oscillation, and the angle that counts as growth, rad.
const SWING: [f64; 2] = [1e-6, 1e-3];
/// The number of carriers whose D is computed in double precision and exactly.
const CARRIERS: u32 = 2_000;
/// The largest allowed relative error of an acceleration.
const DIGITS: f64 = 1e-12;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = Scene::open(path)?;
    let accepted = "a gyrostat with a motor model = \"synchronous\" whose axis and weight are along z";
    let (Setup::Gyrostat(bodies), "synchronous", Some(b0)) =
        (&scene.system, scene.machine.name(), scene.machine.datum("b0"))
    else {
        return Err(NotFound::unsuitable(path, "this is another system or machine", accepted));
    };
    if bodies.rotor.axis != Vector3::z() {
        return Err(NotFound::unsuitable(path, "the rotor's axis is not along z", accepted));
    }
    // friction damps the oscillation and changes the longest step
    if scene.machine.datum("f") != Some(0.0) {
        return Err(NotFound::unsuitable(path, "its rotor is braked", "f = \"0 N m s\""));
    }
    let exact = decimals(bodies);
    let answer = turning(&first_of(&exact, exact.reduced_tensor()), Rational::one());
    let square = Rational::decimal(b0) * answer;
    let problem = scene.problem(Axes::First);
    let step = Exact::root(swinging(Scheme::RungeKutta4, square)).map(|exact| {
        let near = exact.value();
        let measured = edge(0.95 * near, 1.05 * near, 1e-5, |h| swings(&problem, h));
        let of = "longest step of Runge-Kutta 4";
        Threshold {
            of: of.into(),
            formula: r"$\sqrt{8A'D/b_0}$".into(),
            exact,
            unit: "s".into(),
            measured,
            within: Within::Share(1000),
        }
    });
    let lost = Threshold {
        of: "D below which the second form has no correct digit".into(),
        formula: r"$\frac32\,2^{-53}$".into(),
        exact: Exact::Number(Rational::new(3, 1 << 54)),
        unit: "".into(),
        measured: Some(error_of_d(bodies.rotor.axial)),
        within: Within::Factor(2),
    };
    let tried = Tried { steps: 50, ..Tried::of(&problem, scene.run.tolerance) };
    let right = tried.right();
    let mut trials = tried.all(|record| near(record, &right, 1e-3));
    trials.extend(digits(bodies, answer));
    Ok(Found { thresholds: step.into_iter().chain([lost]).collect(), diagnosis: refused(&scene), trials })
}

/// The first form of bodies with diagonal tensors, from A.
fn first_of<P: Base>(bodies: &Gyrostat<P>, reduced: Matrix3<P>) -> FirstForm<P> {
    FirstForm::new(reduced.diagonal(), bodies.rotor.axis, bodies.rotor.axial, bodies.weight())
}

fn second_of<P: Base>(bodies: &Gyrostat<P>) -> SecondForm<P> {
    SecondForm::new(bodies.full_tensor().diagonal(), bodies.rotor.axis, bodies.rotor.axial, bodies.weight())
}

/// phi'' of a gyrostat that hangs at rest, for a torque on its rotor.
fn turning<P: Base>(form: &impl Form<P>, torque: P) -> P {
    let (rest, down) = (Vector3::zeros(), Vector3::new(P::zero(), P::zero(), P::one()));
    form.accelerations(rest, down, P::zero(), torque).1
}

/// The largest error of D in double precision, over carriers with small D.
fn error_of_d(axial: f64) -> f64 {
    let one = |j: u32| {
        let along = axial * (1.0 + 1e-7 * f64::from(j));
        fn d<P: Base>(along: P, axial: P) -> P {
            let axis = Vector3::new(P::zero(), P::zero(), P::one());
            let form = SecondForm::new(Vector3::new(along, along, along), axis, axial, Vector3::zeros());
            // A' D phi'' = M, with M = A'
            P::one() / turning(&form, axial)
        }
        let exact = d(Rational::exactly(along), Rational::exactly(axial));
        (Rational::exactly(d(along, axial)) - exact).to_f64().abs()
    };
    (1..=CARRIERS).map(one).fold(0.0, f64::max)
}

/// For each form, whether its acceleration for a torque of 1 N m is accurate to `DIGITS`.
fn digits(bodies: &Gyrostat<f64>, exact: Rational) -> Vec<Trial> {
    let keeps = |found: f64| {
        let off = (Rational::exactly(found) / exact - Rational::one()).to_f64().abs();
        if off <= DIGITS { Fate::Holds } else { Fate::Wrong }
    };
    let l = bodies.rotor.axis;
    let subtracted = bodies.full_tensor() - l * l.transpose() * bodies.rotor.axial;
    [
        ("12 digits in the first form, A from the bodies", turning(&bodies.first_form().0, 1.0)),
        ("12 digits in the first form, A = A* - A' l l", turning(&first_of(bodies, subtracted), 1.0)),
        ("12 digits in the second form", turning(&second_of(bodies), 1.0)),
    ]
    .map(|(by, found)| Trial { by: by.to_owned(), fate: keeps(found) })
    .into()
}

/// Whether a small oscillation does not grow with Runge-Kutta 4 with the step size h, s.
fn swings(problem: &Problem, h: f64) -> bool {
    let Some(angle) = problem.columns.iter().position(|name| name == "angle") else { return false };
    let mut state = problem.state.clone();
    state[angle] = SWING[0];
    let span = Span::new(0.0, h * f64::from(STEPS), &state);
    let method = Method::RungeKutta4 { steps: STEPS };
    let outcome = integrate(&*problem.law, method, &Tolerance::both(1e-9), &span, &mut ());
    outcome.reached() && outcome.state[angle].abs() < SWING[1]
}

/// The message that rejects the scene's carrier if it has no inertia about the axis.
fn refused(scene: &Scene) -> String {
    let Setup::Gyrostat(bodies) = &scene.system else { return String::new() };
    let mut flat = **bodies;
    flat.carrier.inertia[(2, 2)] = 0.0;
    flat.carrier.inertia[(1, 1)] = flat.carrier.inertia[(0, 0)];
    let broken = flat.admissible().err().unwrap_or_default();
    broken.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
