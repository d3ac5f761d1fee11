//! The electromechanical drive as an ODE: nine equations with or without stabilisation of the rod's constraint; seven
//! in coordinates that satisfy it; and the stability limit of Euler's step size.

use super::law::Stabilised;
use field::{Analytic, Over};
use integrators::{JacobianFn, Ode, System};
use mechanics::constrained::State;
use mechanics::constrained::energies::{Kinematics, Reduced};
use systems::crank_drive::CrankDrive;

/// The names of the unknowns of the nine equations.
pub const UNKNOWNS: [&str; 9] = ["f1", "f2", "q3", "f4", "f5", "q6", "f6", "q7", "f7"];

/// The nine equations. The charges enter through q3 only; it takes the place of q4, with q5 = 0. The multiplier of the
/// rod's constraint f = 0 is such that f'' = -b f' - k f (Baumgarte).
#[derive(Clone, Copy, Debug)]
pub struct Nine {
    pub drive: CrankDrive<f64>,
    /// The damping gain b, 1/s.
    pub damping: f64,
    /// The stiffness gain k, 1/s^2.
    pub stiffness: f64,
}

/// The time, q and q' of the drive at a state of the nine equations.
fn instant<S: Over<f64> + Analytic>(time: S, y: &[S]) -> State<S, 6> {
    let none = S::zero();
    State { time, place: [none, none, y[2], none, y[5], y[7]], velocity: [y[0], y[1], y[3], y[4], y[6], y[8]] }
}

impl<S: Over<f64> + Analytic> Ode<S> for Nine {
    fn dimension(&self) -> usize {
        9
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let law = Stabilised::<_, 6, 1> { system: &self.drive, damping: self.damping, stiffness: self.stiffness };
        let [a1, a2, a4, a5, a6, a7] = law.acceleration(&instant(t, y));
        dy.copy_from_slice(&[a1, a2, y[3] - y[4], a4, a5, y[6], a6, y[8], a7]);
    }
}

impl System for Nine {}

/// The residuals f and f' at a state of the nine equations.
pub fn violation(drive: &CrankDrive<f64>, y: &[f64]) -> (f64, f64) {
    let found = Kinematics::of(drive, &instant(0.0, y));
    (found.value[0], found.rate[0])
}

/// The seven equations of the drive without the slider: y = (f1, f2, q3, f4, f5, q6, f6).
#[derive(Clone, Copy, Debug)]
pub struct Seven {
    pub drive: CrankDrive<f64>,
}

impl<S: Over<f64> + Analytic> Ode<S> for Seven {
    fn dimension(&self) -> usize {
        7
    }

    fn rates(&self, time: S, y: &[S], dy: &mut [S]) {
        let (none, reduced) = (S::zero(), Reduced(&self.drive));
        let law = Stabilised::<_, 5, 0> { system: &reduced, damping: 0.0, stiffness: 0.0 };
        let place = [none, none, y[2], none, y[5]];
        let [a1, a2, a4, a5, a6] = law.acceleration(&State { time, place, velocity: [y[0], y[1], y[3], y[4], y[6]] });
        dy.copy_from_slice(&[a1, a2, y[3] - y[4], a4, a5, y[6], a6]);
    }
}

impl System for Seven {}

impl Seven {
    /// The nine unknowns from the seven, with the slider's position and speed.
    pub fn whole(&self, y: &[f64]) -> [f64; 9] {
        let (q, dq) = Reduced(&self.drive).motion(0.0, [0.0, 0.0, y[2], 0.0, y[5]], [y[0], y[1], y[3], y[4], y[6]]);
        [y[0], y[1], y[2], y[3], y[4], y[5], y[6], q[5], dq[5]]
    }
}

/// The stability limit (s) of Euler's step size for the five electrical unknowns of the seven, with coefficients frozen
/// at a state: the longest h for which I + h A has no eigenvalue outside the unit circle.
pub fn bearable_step(slopes: &mut dyn JacobianFn, time: f64, y: &[f64]) -> f64 {
    let mut matrix = [0.0; 49];
    slopes.matrix(time, y, &mut matrix);
    longest(&std::array::from_fn(|i| std::array::from_fn(|j| matrix[7 * i + j])))
}

type Five = [[f64; 5]; 5];

/// The longest step size that is searched, s.
const LONGEST: f64 = 1e6;

/// The longest h (s) for which I + h A has no eigenvalue outside the unit circle, by bisection.
fn longest(matrix: &Five) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while high < LONGEST && !grows(matrix, high) {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if grows(matrix, middle) { high = middle } else { low = middle }
    }
    low
}

/// Whether the powers of I + h A grow, by repeated squaring.
fn grows(matrix: &Five, h: f64) -> bool {
    let one = |yes: bool| if yes { 1.0 } else { 0.0 };
    let mut power: Five = std::array::from_fn(|i| std::array::from_fn(|j| one(i == j) + h * matrix[i][j]));
    let mut logarithm = 0.0;
    for doubling in 0..16 {
        let size = power.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
        if size == 0.0 {
            return false;
        }
        power = power.map(|row| row.map(|x| x / size));
        logarithm = if doubling == 0 { size.ln() } else { 2.0 * logarithm + size.ln() };
        power = std::array::from_fn(|i| std::array::from_fn(|j| (0..5).map(|k| power[i][k] * power[k][j]).sum()));
    }
    logarithm > 0.0
}
