//! Data of figures on friction governors: stability maps for an elastic rim, and errors of the series of the programmed
//! motion.

use integrators::spectrum;
use mechanics::stability::{characteristic, hurwitz};
use systems::elastic_governor::ElasticGovernor;
use systems::governor::constant::ConstantTorques;
use systems::governor::{Gearing, Governor, Torque};

/// The stability of the steady motion over two parameters.
#[derive(Clone, Debug)]
pub struct StabilityMap {
    pub title: &'static str,
    pub x: (&'static str, [f64; 2]),
    pub y: (&'static str, [f64; 2]),
    /// Whether every eigenvalue has a negative real part: rows from the lowest y, at the centres of the cells.
    pub rows: Vec<Vec<bool>>,
    /// The y at which Hurwitz' minors cease to be positive, as a function of x.
    pub curve: Vec<(f64, f64)>,
    /// The largest distance in y between `curve` and the boundary by eigenvalues.
    pub distance: f64,
    pub note: &'static str,
}

const COLUMNS: usize = 90;
const ROWS: usize = 75;
/// omega1 of the steady motion, rad/s.
pub const SPEED: f64 = 2.0;

/// The governor of the maps, with a lateral stiffness and a load, in SI units; the disc is in contact at 0.5 m from its
/// axis. The rim resists, as in the interpretation of the paper's Z: with the printed +a lambda of (3.17) a is minus
/// the stiffness.
pub fn governor(stiffness: f64, load: f64) -> ElasticGovernor<f64> {
    ElasticGovernor {
        drum_inertia: 1.0,
        disc_inertia: 1.0,
        wheel_inertia: 0.1,
        drum: 0.5,
        wheel: 0.2,
        offset: 0.1,
        sleeve: 1.0,
        ball: 1.0,
        link: 0.5,
        m1: 0.0,
        m2: -load,
        c1: 30.0,
        c2: 20.0,
        delta1: 0.1,
        delta2: 0.0,
        rest: 0.6,
        across: -stiffness,
        twist: 0.0,
        drill: 0.0,
        alpha: 5.0,
        beta: 8.0,
        rim_mass: 0.0,
        rim_inertia: 0.0,
    }
    .stationary_at(SPEED)
}

/// Whether Hurwitz' minors of the exact characteristic polynomial are positive: the steady motion at (omega1, x0) is
/// then exponentially stable.
pub fn has_positive_minors(data: &ElasticGovernor<f64>, speed: f64) -> bool {
    let minors = data.linearised(speed).map(|matrix| hurwitz(characteristic(matrix)));
    minors.is_ok_and(|minors| minors.iter().all(|minor| *minor > 0.0))
}

/// The largest real part of an eigenvalue of the linearisation, 1/s; `None` where none was found.
pub fn growth(data: &ElasticGovernor<f64>, speed: f64) -> Option<f64> {
    let matrix = data.linearised(speed).ok()?;
    spectrum(matrix.len(), matrix.as_flattened())?.first().map(|root| root.re)
}

/// Two stability maps: load and stiffness of the rim, and load and the coefficient by which the rim's angle bends the
/// rolling line.
pub fn stability() -> [StabilityMap; 2] {
    [
        map(
            "Stability of the governor with an elastic rim: load and stiffness across",
            ("stiffness of the rim across, -a, N/m", 200.0),
            governor,
            "Stable where the disc is braked, $M_2<0$, and not too hard. The curve is where the first of Hurwitz' minors \
             of the exact characteristic polynomial vanishes.",
        ),
        map(
            "Stability of the governor with an elastic rim: load and damping",
            ("β of Keldysh's curvature, 1/m", 20.0),
            |beta, load| ElasticGovernor { beta, ..governor(50.0, load) },
            "Without $\\beta$ nothing is damped. The curve is where the first of Hurwitz' minors vanishes.",
        ),
    ]
}

const MOST_LOAD: f64 = 30.0;

fn map(
    title: &'static str,
    (x, most): (&'static str, f64),
    data: impl Fn(f64, f64) -> ElasticGovernor<f64>,
    note: &'static str,
) -> StabilityMap {
    let decays = |data: &ElasticGovernor<f64>| growth(data, SPEED).is_some_and(|rate| rate < 0.0);
    let middle = |k: usize, of: usize| (k as f64 + 0.5) / of as f64;
    let row = |r: usize| {
        let load = MOST_LOAD * middle(r, ROWS);
        (0..COLUMNS).map(|c| decays(&data(most * middle(c, COLUMNS), load))).collect()
    };
    let curve: Vec<(f64, f64)> = (1..=4 * COLUMNS)
        .map(|k| most * k as f64 / (4 * COLUMNS) as f64)
        .map(|x| (x, boundary(|load| has_positive_minors(&data(x, load), SPEED))))
        .collect();
    let distance = curve
        .iter()
        .step_by(4)
        .map(|(x, exact)| (boundary(|load| decays(&data(*x, load))) - exact).abs())
        .fold(0.0, f64::max);
    let y = ("braking moment on the disc, -M₂, N m", [0.0, MOST_LOAD]);
    StabilityMap { title, x: (x, [0.0, most]), y, rows: (0..ROWS).map(row).collect(), curve, distance, note }
}

/// The largest load for which a condition is true, by bisection; it is true for small loads.
fn boundary(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, MOST_LOAD);
    loop {
        let middle = 0.5 * (low + high);
        if middle == low || middle == high || high - low < 1e-12 * MOST_LOAD {
            return middle;
        }
        if holds(middle) { low = middle } else { high = middle }
    }
}

/// For each prescribed speed, rad/s: the error of the series of the programmed motion at one time, by its order.
pub fn series_errors() -> Vec<(f64, Vec<(usize, f64)>)> {
    let data = Governor {
        inertia: [0.6, 0.5, 0.1],
        mass: 0.8,
        radius: 0.2,
        gearing: Gearing::Drum { radius: 0.5 },
        moments: [Torque::constant(-0.5), Torque::constant(0.6)],
        push: 0.0,
        lateral: 0.0,
    };
    let (start, time, order) = (0.3, 0.5, 16);
    let errors = |speed: f64| {
        let law = data.small_parameter(speed)?;
        let closed =
            ConstantTorques { epsilon: law.epsilon, of_second: law.of_second[0], of_first: law.of_first[0], start };
        let exact = closed.distance(time)?;
        let sums = law.approximations(start, order, time);
        Some((speed, sums.iter().enumerate().map(|(n, sum)| (n, (sum - exact).abs())).collect()))
    };
    [2.0, 4.0, 8.0, 16.0].into_iter().filter_map(errors).collect()
}
