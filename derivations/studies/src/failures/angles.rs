//! A singular parametrisation of SO(3): Lagrange's equations in Euler's angles.

use super::trials::{Running, Tried, near};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::scene::{Scene, Setup};
use field::{Analytic, DoubleDouble, Over, Rational, Tangent};
use integrators::{Method, Ode, Record, Span, Tolerance, integrate};
use mechanics::definite::root;
use mechanics::rotation::{euler, euler_forms, inverse, vertical};
use nalgebra::Vector3;
use reader::Family;
use simulation::{Axes, CompiledLaw, SymbolicLaw};
use std::path::Path;
use std::sync::Arc;
use systems::gyrostat::Gyrostat;

pub const FAILING: Failing = Failing {
    name: "angles",
    title: "Euler's angles near their pole",
    scene: "failures/near_the_pole.toml",
    why: r"$\omega=W\dot q$ with $\det W=\pm\sin\theta$: at the pole precession and spin turn about one axis, and the matrix of Lagrange's equations, of determinant proportional to $\sin^2\theta$, is singular. Elimination loses the digits of $1/\sin^2\theta$, all of them at $\sin^2\theta=2^{-53}$; a motion that passes the pole at a distance $\delta$ has angles that jump by half a turn within $\delta/|\dot\theta|$, and a constant step passes over that. A pendulum that hangs is at the pole.",
    advice: "Use the angles for derivation and run in angular velocity and vertical, which has no pole; there every method of order two and more holds.",
    asked: "the vertical within 1/1000, in the angles with 3000 evaluations",
    measure,
};

/// The budget of evaluations in Euler angles, whose law is expensive.
const FEW: u64 = 3_000;
/// The precession and the proper rotation (rad), and the rates, for which the rounding error is measured as a function
/// of the nutation.
const ANGLES: [f64; 2] = [0.3, 0.4];
const RATES: [f64; 4] = [0.5, -0.7, 0.9, 1.1];

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = Scene::open(path)?;
    let (Setup::Gyrostat(bodies), "free_rotor") = (&scene.system, scene.machine.name()) else {
        let accepted = "a gyrostat with model = \"free_rotor\"";
        return Err(NotFound::unsuitable(path, "this is another system or machine", accepted));
    };
    let law = Arc::new(InAngles(**bodies));
    // the uncompiled law solves a linear system at each evaluation
    let running = CompiledLaw::of(Arc::clone(&law) as Arc<dyn SymbolicLaw>);
    let digits = Threshold {
        of: "squared sine of the nutation below which the accelerations have no correct digit".into(),
        formula: r"$2^{-53}$".into(),
        exact: Exact::Number(Rational::new(1, 1 << 53)),
        unit: "".into(),
        measured: blind(&law),
        within: Within::Factor(32),
    };
    let problem = scene.problem(Axes::First);
    let tried = Tried { steps: 250, outputs: 10, ..Tried::of(&problem, scene.run.tolerance) };
    let right = tried.right();
    let back = scene.back(Axes::First);
    let seen = |record: &Record<f64>, vertical: &dyn Fn(&[f64]) -> Vec<f64>| Record {
        times: record.times.clone(),
        states: record.states.iter().map(|y| vertical(y)).collect(),
    };
    let by_vector = |y: &[f64]| {
        let mut y = y.to_vec();
        back(&mut y);
        y[3..6].to_vec()
    };
    let by_angles = |y: &[f64]| vertical(&euler([y[0], y[1], y[2]])).as_slice().to_vec();
    let right = seen(&right, &by_vector);
    let named = |name: &str, trials: Vec<Trial>| {
        let name = name.to_owned();
        trials.into_iter().map(move |trial| Trial { by: format!("{name}, {}", trial.by), ..trial })
    };
    let start = law.start(&scene);
    let in_angles = Tried { law: Running::Alone(&running), state: &start, budget: FEW, ..tried };
    let mut trials: Vec<Trial> =
        named("first form", tried.all(|record| near(&seen(record, &by_vector), &right, 1e-3))).collect();
    trials.extend(named("Euler's angles", in_angles.all(|record| near(&seen(record, &by_angles), &right, 1e-3))));
    let mut at_the_pole = start.clone();
    at_the_pole[1] = 0.0;
    let span = Span::new(0.0, 1.0, &at_the_pole);
    let refused = integrate(&running, Method::DormandPrince8, &Tolerance::both(1e-9), &span, &mut ()).failure();
    let diagnosis = refused.map_or_else(String::new, |failure| failure.to_string());
    Ok(Found { thresholds: vec![digits], diagnosis, trials })
}

/// Lagrange's equations in Euler's angles for a gyrostat with a free rotor: y = (angles, their rates, phi').
struct InAngles(Gyrostat<f64>);

impl<S: Over<f64> + Analytic> Ode<S> for InAngles {
    fn dimension(&self) -> usize {
        7
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        let angles = [y[0], y[1], y[2], S::zero()].map(Tangent::fixed);
        let rates = [y[3], y[4], y[5], y[6]].map(Tangent::fixed);
        let free = Tangent::fixed(S::zero());
        let found = root(|accelerations| self.0.by_lagrange(angles, rates, accelerations, free));
        dy[..3].copy_from_slice(&y[3..6]);
        dy[3..].copy_from_slice(&found.unwrap_or([S::zero() / S::zero(); 4]));
    }
}

impl InAngles {
    /// The initial state of a scene in Euler angles: precession zero, the other angles from the vertical.
    fn start(&self, scene: &Scene) -> Vec<f64> {
        let v = scene.start.vertical;
        let angles = [0.0, v.z.clamp(-1.0, 1.0).acos(), v.x.atan2(v.y)];
        let rates: Vector3<f64> = inverse(&euler_forms(angles)) * scene.start.angular_velocity;
        [&angles[..], rates.as_slice(), &[scene.start.rotor_speed]].concat()
    }

    /// The accelerations at a nutation angle, rad.
    fn at<S: Over<f64> + Analytic>(&self, nutation: f64) -> Vec<S> {
        let y = [ANGLES[0], nutation, ANGLES[1], RATES[0], RATES[1], RATES[2], RATES[3]].map(S::lift);
        let mut dy = vec![S::zero(); y.len()];
        self.rates(S::zero(), &y, &mut dy);
        dy.split_off(3)
    }
}

/// The squared sine of the largest nutation angle, among powers of two, at which the rounding error is as large as the
/// accelerations.
fn blind(law: &InAngles) -> Option<f64> {
    let lost = |nutation: &f64| {
        let (found, exact): (Vec<f64>, Vec<DoubleDouble>) = (law.at(*nutation), law.at(*nutation));
        let off = found.iter().zip(&exact).map(|(a, b)| (a - b.hi()).abs()).fold(0.0, f64::max);
        let size = exact.iter().map(|b| b.hi().abs()).fold(0.0, f64::max);
        off.is_nan() || off >= size
    };
    (1..60).map(|k| 0.5_f64.powi(k)).find(lost).map(|nutation| nutation.sin().powi(2))
}
