//! Pull-out of a synchronous motor as a saddle-node bifurcation: two steady angles of the rotor merge and vanish.

use super::at_a_parameter::newton;
use super::bounds::{numerator, rational};
use super::edge::edge;
use super::trials::{Fate, Tried, near};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::scene::{Scene, Setup, Start};
use crate::stationary::motor::MotorStates;
use field::{Analytic, Circle, Over, Rational, Scalar, Tangent};
use integrators::{Branch, ContinuationSettings, Curve, Failure, Method, continue_branch};
use motor::{Datum, Motor, torque_and_current_rates};
use reader::Family;
use simulation::{Axes, Choice};
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;
use symbolic::Sym;

pub const FAILING: Failing = Failing {
    name: "pull-out",
    title: "pull-out as a saddle-node: root finders near it",
    scene: "pull_out.toml",
    why: r"In synchronism no current flows, and the rotor is at rest in the field where $-b_0\sin\gamma=f\Omega$: at two angles, which merge at $\gamma=-\pi/2$ where $f\Omega=b_0$. There the derivative by the angle vanishes; Newton's method only halves its error in each iteration at the fold, and does not converge beyond it. Along the curve of $(\gamma,f)$ nothing is singular.",
    advice: "Follow the curve by its arc length, which goes round the fold, or isolate the real roots, which also proves that there is none; the failure of a root finder is no proof.",
    asked: "a correct answer; the motion within 1/1000",
    measure,
};

/// The longest step along the curve, rad, and the largest number of points.
const STEP: f64 = 0.15;
const MOST: usize = 200;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = Scene::open(path)?;
    let data = [scene.machine.datum("field_speed"), scene.machine.datum("b0")];
    let (Setup::Gyrostat(bodies), "multi_current", [Some(field_speed), Some(b0)]) =
        (&scene.system, scene.machine.name(), data)
    else {
        let accepted = "a gyrostat with model = \"multi_current\"";
        return Err(NotFound::unsuitable(path, "this is another system or machine", accepted));
    };
    let Some(exact) = critical(&scene.machine).filter(|exact| exact.to_f64() > 0.0) else {
        return Err(NotFound::unsuitable(
            path,
            "no load takes this motor out of step",
            "b0 and field_speed above zero",
        ));
    };
    let at = exact.to_f64();
    // torques in units of b0, the friction in units of b0 over 1 rad/s
    let mut curve = Standing { motors: [0.0, 1.0].map(|f| rubbed(&scene.machine, f)), unit: b0 };
    let round = round_the_fold(&mut curve, field_speed);
    let fold = round.as_ref().and_then(|branch| branch.folds().next());
    let followed = fold.map(|fold| fold.x[1] * b0);
    let behind = round.as_ref().and_then(|branch| branch.places.last()).is_some_and(|last| last.x[0] < -FRAC_PI_2);
    let holds = |f: f64| stays(&scene, bodies.rotor.axial, [field_speed, b0], f);
    let threshold = |of: &'static str, measured, within| {
        let formula = r"$b_0/\Omega$";
        Threshold {
            of: of.into(),
            formula: formula.into(),
            exact: Exact::Number(exact),
            unit: "N m s".into(),
            measured,
            within,
        }
    };
    let thresholds = vec![
        threshold("greatest friction in step: the fold, by arc length", followed, Within::Share(1_000_000_000)),
        threshold(
            "greatest friction in step, by runs of the motor alone, 2 s each",
            edge(0.97 * at, 1.1 * at, 1e-5, holds),
            Within::Share(50),
        ),
    ];
    let mut at_load = |share: f64| newton(&mut curve, 0.0, share * at / b0);
    let answer = |by: &str, found: bool| {
        let fate = if found { Fate::Holds } else { Fate::Stops("Newton did not converge".to_owned()) };
        Trial { by: by.to_owned(), fate }
    };
    let roots = |share: f64| standing_angles(&scene, share * at);
    let mut trials = vec![
        answer("Newton at 0.9 of the load", at_load(0.9).is_ok()),
        answer("Newton at 1.001 of the load", at_load(1.001).is_ok()),
        answer("arc length round the fold", behind),
        answer("real roots isolated", roots(0.9) == Some(2) && roots(1.001) == Some(0)),
    ];
    let problem = scene.problem(Axes::First);
    let tried = Tried { steps: 4_000, ..Tried::of(&problem, scene.run.tolerance) };
    let right = tried.right();
    trials.extend(tried.all(|record| near(record, &right, 1e-3)));
    let diagnosis = at_load(1.001).err().map_or_else(String::new, |error| error.to_string());
    Ok(Found { thresholds, diagnosis, trials })
}

/// The torque on a rotor at synchronous speed, where no currents flow.
fn torque<P: Datum, S: Over<P>>(motor: &Motor<P>, angle: Circle<S>) -> S {
    torque_and_current_rates(motor, angle, S::zero(), &[], &mut [])
}

/// The motor with another coefficient of viscous friction.
fn rubbed<P: Datum>(motor: &Motor<P>, friction: P) -> Motor<P> {
    motor.over(|quantity, value| if quantity.name == "f" { friction } else { value })
}

/// The friction at pull-out: the derivative of the torque with respect to the angle vanishes, and the friction torque
/// balances the torque.
fn critical(motor: &Motor) -> Option<Rational> {
    let t = Sym::symbol("t");
    let [free, rubbed] = [0, 1].map(|f| rubbed(&motor.decimals(), Sym::int(f)));
    let slope = torque(&free, Circle::from_half_tangent(t).moving(Sym::int(1))).slope;
    let load = |half: Rational| {
        let angle = Circle::from_half_tangent(Sym::constant(half));
        let [free, rubbed] = [&free, &rubbed].map(|motor| torque(motor, angle));
        (-free / (rubbed - free)).as_constant()
    };
    let folds = numerator(slope, t)?.real_roots();
    folds.iter().filter_map(rational).filter_map(load).find(|load| load.sign() == Some(1))
}

/// The torque balance of a rotor at synchronous speed, divided by b0, as a function of the angle and of the friction
/// divided by b0.
struct Standing {
    /// The motor without friction, and with a friction coefficient of 1 N m s.
    motors: [Motor; 2],
    unit: f64,
}

impl Standing {
    /// the friction torque is linear in its coefficient
    fn value(&self, angle: Tangent<f64>, friction: Tangent<f64>) -> Tangent<f64> {
        let [free, rubbed] = self.motors.each_ref().map(|motor| torque(motor, angle.circle()));
        free / Tangent::fixed(self.unit) + friction * (rubbed - free)
    }
}

impl Curve for Standing {
    fn unknowns(&self) -> usize {
        2
    }

    fn evaluate(&mut self, x: &[f64], residual: &mut [f64], matrix: &mut [f64]) -> Result<(), Failure> {
        let by_angle = self.value(Tangent::variable(x[0]), Tangent::fixed(x[1]));
        let by_friction = self.value(Tangent::fixed(x[0]), Tangent::variable(x[1]));
        residual[0] = by_angle.value;
        matrix.copy_from_slice(&[by_angle.slope, by_friction.slope]);
        Ok(())
    }
}

/// Continuation of the steady angle from zero friction around the fold, until the angle exceeds half a turn.
fn round_the_fold(curve: &mut Standing, field_speed: f64) -> Option<Branch> {
    let within = |x: &[f64]| x[0].abs() < PI;
    let walk = ContinuationSettings {
        sizes: &[1.0, 1.0 / field_speed.abs()],
        parameter: 1,
        step: STEP,
        most: MOST,
        within: &within,
    };
    continue_branch(curve, &[0.0, 0.0], &[0.0, 1.0], &walk)
}

/// Whether a run of the motor alone stays synchronous with a given friction, from its steady angle or, beyond pull-out,
/// from a quarter turn behind the field.
fn stays(scene: &Scene, axial: f64, [field_speed, b0]: [f64; 2], f: f64) -> bool {
    let Some(machine) = scene.machine.with("f", f) else { return false };
    let held = (f * field_speed / b0).min(1.0);
    let start =
        Start { rotor_angle: -held.asin(), rotor_speed: field_speed, currents: Vec::new(), ..scene.start.clone() };
    let alone = Scene { system: Setup::Bench { axial }, machine, start, ..scene.clone() };
    let choice = Choice { method: Method::DormandPrince8, tolerance: 1e-8, ..scene.choice() };
    let run = alone.simulate(&choice, |_| ());
    let angle = run.column("angle").and_then(|angle| run.last.get(angle));
    run.outcome.reached() && angle.is_some_and(|angle| angle.abs() < PI)
}

/// The number of steady angles for a given friction, by isolation of real roots.
fn standing_angles(scene: &Scene, friction: f64) -> Option<usize> {
    let motor = scene.given.with("f", friction)?.model("synchronous").ok()?;
    match MotorStates::of(&motor).ok()? {
        MotorStates::InStep { angles, .. } => Some(angles.len()),
        _ => None,
    }
}
