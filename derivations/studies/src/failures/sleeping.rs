//! Stability tests at a multiple eigenvalue: the sleeping top at its critical speed.

use super::bounds::first_positive;
use super::edge::edge;
use super::trials::{Fate, Tried, near};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::scene::{Scene, Setup, Start};
use crate::stationary::motions::decimals;
use algebra::real::Polynomial;
use field::{Base, Rational, Scalar, Tangent};
use integrators::{Method, Observer, Span, Tolerance, integrate};
use mechanics::differentiate::{along, unit};
use mechanics::stability::{characteristic, hurwitz};
use nalgebra::{Matrix4, Schur, Vector3};
use num_traits::Zero;
use reader::Family;
use simulation::Axes;
use std::path::Path;
use symbolic::Sym;
use systems::gyrostat::Gyrostat;
use systems::gyrostat::forms::{FirstForm, Form};

pub const FAILING: Failing = Failing {
    name: "eigenvalues",
    title: "multiple eigenvalues in tests of stability",
    scene: "failures/sleeping_top.toml",
    why: r"Upright, $\det(\mu-J)=\mu^4+c_2\mu^2+c_4$ for every speed of the rotor: the odd coefficients vanish with Hurwitz' minors, and the sign of $c_2^2-4c_4$ decides. Where it changes, at $(A_3^*\omega_3+A'\dot\varphi)^2=4A\Gamma$ with the momentum of carrier and rotor about the axis, two pairs of imaginary roots meet; a root of multiplicity two moves by the square root of an error of the matrix, and an iteration for eigenvalues in double precision may not end.",
    advice: "Decide by the exact polynomial, factors and discriminants first; limit every iteration for eigenvalues, and use its results for pictures, not for a verdict at a boundary.",
    asked: "the exact verdict at every speed examined; the motion within 1/1000",
    measure,
};

/// The initial tilt, the tilt that counts as growth, and the length of the run, s.
const TILT: [f64; 2] = [1e-6, 1e-2];
const TIME: f64 = 100.0;
/// The tests are made at speeds (1 +- 10^-k) times the critical one, for k up to this number.
const DECADES: i32 = 15;
/// The largest number of iterations for eigenvalues.
const ITERATIONS: usize = 1_000;
/// Real parts below this, relative to the root, count as zero.
const MARGIN: f64 = 1e-9;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = Scene::open(path)?;
    let (Setup::Gyrostat(bodies), "free_rotor") = (&scene.system, scene.machine.name()) else {
        let accepted = "a gyrostat with model = \"free_rotor\"";
        return Err(NotFound::unsuitable(path, "this is another system or machine", accepted));
    };
    let decimal = decimals(bodies);
    let tensor = decimal.full_tensor().diagonal();
    let upright = bodies.rotor.axis == Vector3::z() && bodies.first_moment().xy().norm() == 0.0;
    // with equal transverse moments of inertia the carrier's spin enters only through the momentum about the third axis
    let spin = Rational::decimal(scene.start.angular_velocity.z);
    let spins_alike = spin.is_zero() || tensor.x == tensor.y;
    let shared = tensor.z * spin / decimal.rotor.axial;
    let speed = Sym::symbol("speed");
    let symbolic = lifted(&decimal);
    let discriminant = discriminant(jacobian(&form(&symbolic), speed));
    let resting = first_positive(discriminant, speed).filter(|_| upright && spins_alike);
    let Some(resting) = resting.filter(|resting| resting.to_f64() > shared.to_f64()) else {
        let accepted = "axis and centre of mass along z, and equal moments about x and y where the carrier spins,";
        return Err(NotFound::unsuitable(path, "it has no slowest speed", accepted));
    };
    let of_resting_carrier = resting.to_f64();
    let at = of_resting_carrier - shared.to_f64();
    let exact = match shared.sign() {
        Some(0) => Exact::Root(resting),
        Some(-1) => Exact::Formula(format!("{} + {}", Exact::Root(resting), -shared), at),
        _ => Exact::Formula(format!("{} - {shared}", Exact::Root(resting)), at),
    };
    let sleeps = |speed: f64| stays(&scene, speed);
    let thresholds = vec![Threshold {
        of: "slowest speed of the rotor at which the top sleeps with the carrier's spin of the scene, by runs".into(),
        formula: r"$(2\sqrt{A\Gamma}-A_3^*\omega_3)/A'$".into(),
        exact,
        unit: "rad/s".into(),
        measured: edge(1.05 * at, 0.95 * at, 1e-5, sleeps),
        within: Within::Share(1000),
    }];
    let mut trials = verdicts(bodies, of_resting_carrier);
    let problem = scene.problem(Axes::First);
    let tried = Tried { steps: 20_000, ..Tried::of(&problem, scene.run.tolerance) };
    let right = tried.right();
    trials.extend(tried.all(|record| near(record, &right, 1e-3)));
    let minors = hurwitz(characteristic(jacobian(&form(&decimal), Rational::decimal(of_resting_carrier))));
    let vanish = minors.iter().filter(|minor| minor.is_zero()).count();
    let diagnosis = format!("{vanish} of {} of Hurwitz' minors vanish exactly: they do not decide", minors.len());
    Ok(Found { thresholds, diagnosis, trials })
}

fn lifted(bodies: &Gyrostat<Rational>) -> Gyrostat<Sym> {
    let Gyrostat { carrier, rotor, gravity } = bodies;
    Gyrostat {
        carrier: systems::gyrostat::Carrier {
            mass: Sym::constant(carrier.mass),
            centre: carrier.centre.map(Sym::constant),
            inertia: carrier.inertia.map(Sym::constant),
        },
        rotor: rotor.lift::<Sym>(),
        gravity: Sym::constant(*gravity),
    }
}

/// The first form of bodies with diagonal tensors.
fn form<P: Base>(bodies: &Gyrostat<P>) -> FirstForm<P> {
    FirstForm::new(bodies.reduced_tensor().diagonal(), bodies.rotor.axis, bodies.rotor.axial, bodies.weight())
}

/// The Jacobian of the rates of (w1, w2, v1, v2) at the upright position: the carrier at rest, the rotor free with a speed.
fn jacobian<P: Base>(form: &FirstForm<P>, speed: P) -> [[P; 4]; 4] {
    let columns: [[P; 4]; 4] = std::array::from_fn(|k| {
        let [w1, w2, v1, v2] = along([P::zero(); 4], unit(k));
        let (zero, up) = (Tangent::fixed(P::zero()), Tangent::fixed(-P::one()));
        let (w, v) = (Vector3::new(w1, w2, zero), Vector3::new(v1, v2, up));
        let (rate, _) = form.accelerations(w, v, Tangent::fixed(speed), zero);
        let turned = v.cross(&w);
        [rate.x.slope, rate.y.slope, turned.x.slope, turned.y.slope]
    });
    std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]))
}

/// The discriminant c2^2 - 4 c4.
fn discriminant<S: Scalar>(matrix: [[S; 4]; 4]) -> S {
    let [_, c2, _, c4] = characteristic(matrix);
    c2 * c2 - S::int(4) * c4
}

/// The largest real part of an eigenvalue, relative to the largest modulus, in double precision. `None` where the
/// iteration does not converge, as happens for multiple eigenvalues.
fn real_part(matrix: &[[f64; 4]; 4]) -> Option<f64> {
    let all = Schur::try_new(Matrix4::from_fn(|i, j| matrix[i][j]), f64::EPSILON, ITERATIONS)?.complex_eigenvalues();
    let most = |of: fn(&nalgebra::Complex<f64>) -> f64| all.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    Some(most(|root| root.re) / most(|root| root.re.hypot(root.im)))
}

/// For each stability test, whether it is correct at speeds on both sides of the critical one, with the carrier at
/// rest.
fn verdicts(bodies: &Gyrostat<f64>, slowest: f64) -> Vec<Trial> {
    let exact = decimals(bodies);
    let near = (1..=DECADES).flat_map(|k| [1.0, -1.0].map(|side| slowest * (1.0 + side * 10f64.powi(-k))));
    let speeds: Vec<(f64, bool)> = near
        .map(|speed| (speed, discriminant(jacobian(&form(&exact), Rational::exactly(speed))).sign() == Some(1)))
        .collect();
    // the result of a test at each speed, if it terminates
    let right = |says: &dyn Fn(f64) -> Option<bool>| {
        let said: Vec<(Option<bool>, bool)> = speeds.iter().map(|(speed, sleeps)| (says(*speed), *sleeps)).collect();
        match said {
            said if said.iter().any(|(says, _)| says.is_none()) => {
                Fate::Stops("the iteration does not converge".to_owned())
            }
            said if said.iter().all(|(says, sleeps)| *says == Some(*sleeps)) => Fate::Holds,
            _ => Fate::Wrong,
        }
    };
    let in_doubles = |speed: f64| jacobian(&form(bodies), speed);
    let below = |most: f64| move |part: f64| part <= most;
    // the squares of the roots of mu^4 + c2 mu^2 + c4 are two real numbers
    let isolated = |speed: f64| {
        let [_, c2, _, c4] = characteristic(jacobian(&form(&exact), Rational::exactly(speed)));
        Polynomial::from_rationals(&[c4, c2, Rational::int(1)]).map(|squares| squares.real_roots().len() == 2)
    };
    let by_minors = |speed: f64| Some(hurwitz(characteristic(in_doubles(speed))).iter().all(|minor| *minor > 0.0));
    [
        ("real roots isolated", right(&isolated)),
        ("eigenvalues in doubles, growth above 0", right(&|speed| real_part(&in_doubles(speed)).map(below(0.0)))),
        ("eigenvalues in doubles, growth above 1e-9", right(&|speed| real_part(&in_doubles(speed)).map(below(MARGIN)))),
        ("Hurwitz' minors in doubles", right(&by_minors)),
    ]
    .map(|(by, fate)| Trial { by: by.to_owned(), fate })
    .into()
}

/// Whether a small tilt stays small in a run with the carrier's spin of the scene.
fn stays(scene: &Scene, rotor_speed: f64) -> bool {
    let vertical = Vector3::new(TILT[0], 0.0, -1.0);
    let angular_velocity = Vector3::new(0.0, 0.0, scene.start.angular_velocity.z);
    let start = Start { vertical, angular_velocity, rotor_speed, ..scene.start.clone() };
    let problem = Scene { start, ..scene.clone() }.problem(Axes::First);
    let span = Span::new(0.0, TIME, &problem.state);
    let mut falls = Falls { scene, fell: false };
    let outcome = integrate(&*problem.law, Method::DormandPrince8, &Tolerance::both(1e-11), &span, &mut falls);
    outcome.reached() && !falls.fell
}

/// An observer that halts a run when the tilt has grown.
struct Falls<'a> {
    scene: &'a Scene,
    fell: bool,
}

impl Observer<f64> for Falls<'_> {
    fn step(&mut self, _time: f64, y: &[f64]) {
        let mut y = y.to_vec();
        self.scene.back(Axes::First)(&mut y);
        self.fell = y[3].hypot(y[4]) > TILT[1];
    }

    fn enough(&self) -> bool {
        self.fell
    }
}
