//! The experiment with the drive: Euler with the step 0.01 s, with and without stabilisation, and what step it can bear.

use super::law::Stabilised;
use crate::systems::crank_drive::{Circuit, CrankDrive};
use crate::systems::crank_slider::CrankSlider;
use field::{Analytic, Over};
use integrators::{Failure, Jacobian, Method, Observer, Ode, Record, Span, System, Tolerance, integrate};
use mechanics::constrained::State;
use mechanics::constrained::energies::{Kinematics, Reduced};

/// The step of the experiment, s.
pub const STEP: f64 = 0.01;
/// The span, s.
pub const SPAN: f64 = 20.0;

/// A slow drive: its currents decay over more than half a step, because otherwise Euler could not follow them.
pub const DRIVE: CrankDrive<f64> = CrankDrive {
    circuit: Circuit {
        amplitude: 40.0,
        frequency: 10.0,
        l1: 0.5,
        l2: 0.5,
        mutual: 0.3,
        r1: 1.0,
        r2: 1.0,
        forward: 0.5,
        reverse: 20.0,
        knee: 0.2,
        c3: 0.05,
        l4: 0.5,
        r4: 1.0,
        l5: 0.5,
        r5: 2.0,
        motor: 1.0,
        b6: 0.1,
        b7: 0.2,
    },
    mechanism: CrankSlider { inertia: 0.5, mass: 0.5, crank: 0.2, rod: 0.6, weight: 1.0 },
};

/// The unknowns of the nine equations.
pub const UNKNOWNS: [&str; 9] = ["f1", "f2", "q3", "f4", "f5", "q6", "f6", "q7", "f7"];

/// At rest without currents, the crank up by 0.3.
pub fn start() -> [f64; 9] {
    let angle = 0.3;
    [0.0, 0.0, 0.0, 0.0, 0.0, angle, 0.0, DRIVE.mechanism.slider(angle), 0.0]
}

/// The nine equations: of the charges only q3 acts, and stands in the place of q4 with q5 = 0.
#[derive(Clone, Copy, Debug)]
pub struct Nine {
    pub damping: f64,
    pub stiffness: f64,
}

fn anywhere<S: Over<f64> + Analytic>(time: S, y: &[S]) -> State<S, 6> {
    let none = S::zero();
    State { time, place: [none, none, y[2], none, y[5], y[7]], velocity: [y[0], y[1], y[3], y[4], y[6], y[8]] }
}

impl<S: Over<f64> + Analytic> Ode<S> for Nine {
    fn dimension(&self) -> usize {
        9
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let law = Stabilised::<_, 6, 1> { system: &DRIVE, damping: self.damping, stiffness: self.stiffness };
        let [a1, a2, a4, a5, a6, a7] = law.acceleration(&anywhere(t, y));
        dy.copy_from_slice(&[a1, a2, y[3] - y[4], a4, a5, y[6], a6, y[8], a7]);
    }
}

impl System for Nine {}

/// The seven equations of the drive without the slider: y = (f1, f2, q3, f4, f5, q6, f6).
#[derive(Clone, Copy, Debug)]
struct Seven;

impl<S: Over<f64> + Analytic> Ode<S> for Seven {
    fn dimension(&self) -> usize {
        7
    }

    fn rates(&self, time: S, y: &[S], dy: &mut [S]) {
        let (none, reduced) = (S::zero(), Reduced(&DRIVE));
        let law = Stabilised::<_, 5, 0> { system: &reduced, damping: 0.0, stiffness: 0.0 };
        let place = [none, none, y[2], none, y[5]];
        let [a1, a2, a4, a5, a6] = law.acceleration(&State { time, place, velocity: [y[0], y[1], y[3], y[4], y[6]] });
        dy.copy_from_slice(&[a1, a2, y[3] - y[4], a4, a5, y[6], a6]);
    }
}

impl System for Seven {}

/// f and f' of a state of the nine.
pub fn violation(y: &[f64]) -> (f64, f64) {
    let found = Kinematics::of(&DRIVE, &anywhere(0.0, y));
    (found.value[0], found.rate[0])
}

/// The nine unknowns at a time, s.
pub type Sample = (f64, [f64; 9]);

/// A run: times and states after each step (the first is the start), and why it broke off, if it did.
#[derive(Clone, Debug)]
pub struct Track {
    pub name: String,
    pub points: Vec<Sample>,
    pub failure: Option<Failure>,
}

struct Every<'a>(&'a mut Vec<Sample>);

impl Observer<f64> for Every<'_> {
    fn step(&mut self, time: f64, y: &[f64]) {
        self.0.push((time, std::array::from_fn(|i| y[i])));
    }
}

/// One run of the nine equations in steps of so many seconds.
pub fn run(name: &str, method: fn(u32) -> Method, step: f64, damping: f64, stiffness: f64) -> Track {
    let law = Nine { damping, stiffness };
    let mut points = vec![(0.0, start())];
    let span = Span::new(0.0, SPAN, &start());
    let steps = (SPAN / step).round() as u32;
    let outcome = integrate(&law, method(steps), &Tolerance::both(1e-9), &span, &mut Every(&mut points));
    Track { name: name.to_owned(), points, failure: outcome.failure() }
}

impl Track {
    /// The largest |f| and |f'| along the way.
    pub fn drift(&self) -> (f64, f64) {
        self.points.iter().fold((0.0, 0.0), |(f, df): (f64, f64), (_, y)| {
            let (value, rate) = violation(y);
            (f.max(value.abs()), df.max(rate.abs()))
        })
    }
}

/// The motion at so many equal times after the start in coordinates without the slider, whose place and speed are added;
/// and the digits on which two methods of different families agree.
///
/// # Errors
/// Where one of them broke off.
pub fn exact(outputs: usize) -> Result<(Vec<Sample>, f64), Failure> {
    let y = start();
    let span = Span::new(0.0, SPAN, &y[..7]).with_even_outputs(outputs);
    let follow = |method| -> Result<Record<f64>, Failure> {
        let mut record = Record::new();
        match integrate(&Seven, method, &Tolerance::both(1e-12), &span, &mut record).failure() {
            Some(failure) => Err(failure),
            None => Ok(record),
        }
    };
    let (first, second) = (follow(Method::DormandPrince8)?, follow(Method::Gauss { stages: 5 })?);
    let pairs = first.states.iter().flatten().zip(second.states.iter().flatten());
    let apart = pairs.map(|(a, b)| (a - b).abs() / a.abs().max(1.0)).fold(f64::MIN_POSITIVE, f64::max);
    let whole = |s: &Vec<f64>| {
        let (q, dq) = Reduced(&DRIVE).motion(0.0, [0.0, 0.0, s[2], 0.0, s[5]], [s[0], s[1], s[3], s[4], s[6]]);
        [s[0], s[1], s[2], s[3], s[4], s[5], s[6], q[5], dq[5]]
    };
    Ok((first.times.iter().copied().zip(first.states.iter().map(whole)).collect(), -apart.log10()))
}

/// What step Euler can bear, s. By theory: the longest with which I + h A has no eigenvalue outside the unit circle, A the
/// Jacobian of the circuit's five equations at the instants of the exact motion. By measurement: the longest with which a
/// run keeps its currents bounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearable {
    /// The least over all instants.
    pub least: f64,
    /// The greatest: what is beyond it is outside at every instant.
    pub greatest: f64,
    /// Without stabilisation.
    pub plain: f64,
    /// With the gains of the fastest decay at each step.
    pub stabilised: f64,
}

/// The bound on the step of Euler, both ways.
///
/// # Errors
/// Where the exact motion broke off.
pub fn bearable() -> Result<Bearable, Failure> {
    let (points, _) = exact(200)?;
    let mut jacobian = Jacobian::new(&Seven);
    let mut matrix = [0.0; 49];
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    for (time, y) in &points {
        jacobian.matrix(*time, &y[..7], &mut matrix);
        let circuit: Five = std::array::from_fn(|i| std::array::from_fn(|j| matrix[7 * i + j]));
        let step = longest(&circuit);
        (least, greatest) = (least.min(step), greatest.max(step));
    }
    Ok(Bearable { least, greatest, plain: measured(0.0, 0.0), stabilised: measured(2.0, 1.0) })
}

/// The longest step, to a thousandth of it, with gains h b and h^2 k.
fn measured(beta: f64, kappa: f64) -> f64 {
    let bounded = |steps: u32| {
        let h = SPAN / f64::from(steps);
        let track = run("", |steps| Method::Euler { steps }, h, beta / h, kappa / (h * h));
        track.failure.is_none() && track.points.iter().all(|(_, y)| y[..5].iter().all(|f| f.abs() < LOST))
    };
    let (mut too_few, mut enough) = (50, 4000);
    while enough - too_few > 1 {
        let middle = (too_few + enough) / 2;
        if bounded(middle) { enough = middle } else { too_few = middle }
    }
    SPAN / f64::from(enough)
}

type Five = [[f64; 5]; 5];

/// The longest step with which I + h A has no eigenvalue outside the unit circle.
fn longest(matrix: &Five) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        if grows(matrix, middle) { high = middle } else { low = middle }
    }
    low
}

/// Whether the powers of I + h A grow, by squaring.
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

/// A current beyond which a run is lost, A: the source could drive 40 through its resistance.
const LOST: f64 = 200.0;

/// The largest damping with which the constraint of the drive stays kept at the step of the experiment and the stiffness
/// k: what a run shows; theory says h b = 2 + h^2 k / 2.
pub fn most_damping(stiffness: f64) -> f64 {
    let kept = |damping: f64| {
        let track = run("", |steps| Method::Euler { steps }, STEP, damping, stiffness);
        track.failure.is_none() && track.drift().0 < 0.1
    };
    let (mut low, mut high) = (1.0 / STEP, 5.0 / STEP);
    for _ in 0..12 {
        let middle = 0.5 * (low + high);
        if kept(middle) { low = middle } else { high = middle }
    }
    low
}
