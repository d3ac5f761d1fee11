//! The experiment with the drive: Euler with the step 0.01 s, with and without stabilisation, and what step it can bear.

use super::law::Stabilised;
use crate::systems::crank_drive::{Circuit, CrankDrive};
use crate::systems::crank_slider::CrankSlider;
use field::{Analytic, Over};
use integrators::{Failure, Method, Observer, Ode, Span, System, Tolerance, integrate, reference};
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

/// A run: times and states after each step (the first is the start), and why it broke off, if it did.
#[derive(Clone, Debug)]
pub struct Track {
    pub name: String,
    pub points: Vec<(f64, [f64; 9])>,
    pub failure: Option<Failure>,
}

struct Every<'a>(&'a mut Vec<(f64, [f64; 9])>);

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

/// The exact motion at so many equal times after the start, the slider's place and speed added.
///
/// # Errors
/// Where the reference broke off.
pub fn exact(outputs: usize) -> Result<(Vec<(f64, [f64; 9])>, f64), Failure> {
    let y = start();
    let seven = [y[0], y[1], y[2], y[3], y[4], y[5], y[6]];
    let found = reference(&Seven, &Span::new(0.0, SPAN, &seven).with_even_outputs(outputs))?;
    let whole = |s: &Vec<field::DoubleDouble>| {
        let s: [f64; 7] = std::array::from_fn(|i| s[i].hi());
        let (q, dq) = Reduced(&DRIVE).motion(0.0, [0.0, 0.0, s[2], 0.0, s[5]], [s[0], s[1], s[3], s[4], s[6]]);
        [s[0], s[1], s[2], s[3], s[4], s[5], s[6], q[5], dq[5]]
    };
    Ok((found.times.iter().copied().zip(found.states.iter().map(whole)).collect(), found.digits))
}
