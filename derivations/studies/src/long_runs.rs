//! Long runs of a top whose motion is known in closed form: growth of errors with the number of revolutions.
//!
//! Theory of the errors of a method of even order p at constant step size h over n revolutions:
//!
//! | method | energy | phase |
//! |---|---|---|
//! | any | h^p, oscillating, and h^(p+1) n | h^p n, and h^(p+1) n^2: the frequency depends on the energy |
//! | a splitting, without friction | h^p, bounded (a modified energy is conserved) | h^p n |
//! | either, if only rounding remains | sqrt(n) | n^(3/2) (Brouwer 1937) |
//!
//! The error of v.v grows like that of the energy, or as sqrt(n) if each step rotates v. The law is reversible, and so
//! are the terms of the modified equation with even powers of h (Hairer, Lubich and Wanner, Geometric Numerical
//! Integration, IX and XI): over a nutation, which is symmetric in time, they do not change the energy. The first odd
//! power changes it.

use field::DoubleDouble;
use integrators::{
    Failure, Method, Observer, Real, Span, Splitting, System, Tolerance, Work, Working, integrate, integrate_in,
};
use motor::FreeRotor;
use motor::compiled;
use nalgebra::{Matrix3, Rotation3, Vector3};
use std::sync::Arc;
use systems::gyrostat::driven::Driven;
use systems::gyrostat::forms::FirstForm;
use systems::gyrostat::lagrange::{Nutation, Top};
use systems::gyrostat::{Carrier, Gyrostat, Rotor};

/// A top with a free rotor about its axis, which starts at a turning point of its nutation.
pub struct LongRun {
    law: Arc<Driven<f64, FirstForm<f64>, FreeRotor<f64>>>,
    state: Vec<f64>,
    axis: Vector3<f64>,
    nutation: Nutation,
}

/// The errors of a run after a number of revolutions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The number of periods of the nutation.
    pub revolutions: f64,
    /// The relative error of the energy.
    pub energy: f64,
    /// The largest absolute value of the relative energy error after any step so far.
    pub swing: f64,
    /// The error of v.v, whose exact value is one.
    pub length: f64,
    /// The relative error of x.v.
    pub momentum: f64,
    /// The phase error, in revolutions; `None` once it was too large to be determined from the slope of u.
    pub phase: Option<f64>,
}

/// The samples of a method over a long run.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodRun {
    pub method: Method,
    /// The tolerance; used only by methods with step size control.
    pub tolerance: f64,
    pub samples: Vec<Sample>,
    pub work: Work,
    pub failure: Option<Failure>,
}

/// A method with its number of steps per revolution, or its tolerance.
#[derive(Clone, Copy, Debug)]
pub enum Pace {
    /// A method with this number of steps per revolution, a multiple of four.
    Steps(Constant, u32),
    Tolerance(Method, f64),
}

/// Constructs a method with constant steps from their number.
pub type Constant = fn(u32) -> Method;

/// The largest phase error, in revolutions, up to which u is taken as linear in time.
const LOST: f64 = 0.05;

/// The methods that are compared, with about 320 evaluations (or pairs of forward and adjoint flows) per revolution.
pub const PACES: [Pace; 9] = [
    Pace::Steps(|steps| Method::RungeKutta4 { steps }, 80),
    Pace::Tolerance(Method::DormandPrince8, 1e-10),
    Pace::Steps(|steps| Method::Split { splitting: Splitting::Strang, steps }, 320),
    Pace::Steps(|steps| Method::Split { splitting: Splitting::BlanesMoan4, steps }, 52),
    Pace::Steps(|steps| Method::Split { splitting: Splitting::BlanesMoan6, steps }, 32),
    Pace::Steps(|steps| Method::Split { splitting: Splitting::KahanLi8, steps }, 20),
    Pace::Steps(|steps| Method::ImplicitMidpoint { steps }, 80),
    Pace::Tolerance(Method::Gauss { stages: 6 }, 1e-10),
    Pace::Tolerance(Method::Taylor, 1e-10),
];

impl LongRun {
    /// The top; `None` if its data give no nutation.
    pub fn new() -> Option<Self> {
        Self::turned(0.0)
    }

    /// The top with the carrier rotated about the axis by an initial angle (rad). By symmetry the motion is equivalent,
    /// but rounding differs, and so do methods that do not respect the symmetry.
    pub fn turned(angle: f64) -> Option<Self> {
        let bodies = Gyrostat {
            carrier: Carrier {
                mass: 1.5,
                centre: Vector3::new(0.0, 0.0, 0.06),
                inertia: Matrix3::from_diagonal(&Vector3::new(0.0096, 0.0096, 0.0034)),
            },
            rotor: Rotor {
                mass: 0.3,
                centre: Vector3::new(0.0, 0.0, 0.072),
                axis: Vector3::z(),
                axial: 2.4e-4,
                transverse: 1.5e-4,
            },
            gravity: 9.81,
        };
        let (form, axes) = bodies.first_form();
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
        let (w, v) = (turn * Vector3::new(2.0, 0.0, 12.0), turn * Vector3::new(0.6, 0.0, -0.8));
        let rotor_speed = 100.0;
        let back = axes.transpose();
        let law = Driven::new(form, FreeRotor::default());
        let mut state: Vec<f64> = (back * w).iter().chain((back * v).iter()).copied().collect();
        state.push(rotor_speed);
        let reduced = bodies.reduced_tensor();
        let top = Top {
            transverse: reduced[(0, 0)],
            weight: bodies.weight().z,
            axis: Vector3::z(),
            spin: bodies.full_tensor()[(2, 2)] * w.z + bodies.rotor.axial * rotor_speed,
        };
        let nutation = top.nutation(w, v)?;
        Some(LongRun { law: Arc::new(law), state, axis: back * Vector3::z(), nutation })
    }

    /// Runs a method; samples are taken at n + 1/4 revolutions, n = 1, 2, 5, 10, ...
    pub fn course(&self, pace: Pace, revolutions: u32) -> MethodRun {
        let (period, quarter) = (self.nutation.period, 0.25);
        let counts = (0..).map(|k| [1, 2, 5][k % 3] * 10_u32.pow(k as u32 / 3));
        let counts: Vec<u32> = counts.take_while(|count| *count <= revolutions).collect();
        let outputs: Vec<f64> = counts.iter().map(|count| period * (f64::from(*count) + quarter)).collect();
        let end = outputs.last().copied().unwrap_or(period);
        let span = Span::new(0.0, end, &self.state).with_outputs(&outputs).with_evaluations(u64::MAX);
        let (method, tolerance) = match pace {
            Pace::Steps(method, each) => {
                let last = counts.last().copied().unwrap_or(1);
                (method(last.saturating_mul(each).saturating_add(each / 4)), 1e-10)
            }
            Pace::Tolerance(method, tolerance) => (method, tolerance),
        };
        let mut samples = Sampled { run: self, samples: Vec::new(), swing: 0.0 };
        let outcome = integrate(&self.system(), method, &Tolerance::both(tolerance), &span, &mut samples);
        MethodRun { method, tolerance, samples: samples.samples, work: outcome.work, failure: outcome.failure() }
    }

    /// The compiled equations of motion.
    pub fn system(&self) -> impl System {
        compiled(&self.law)
    }

    /// The initial state.
    pub fn start(&self) -> &[f64] {
        &self.state
    }

    /// The period of the nutation, s.
    pub fn period(&self) -> f64 {
        self.nutation.period
    }

    /// The relative difference of a state's energy from that at the start.
    pub fn energy(&self, state: &[f64]) -> f64 {
        let start = self.law.energy(&self.state);
        (self.law.energy(state) - start) / start
    }

    /// The rounding errors in energy (relative), v.v and x.v (relative) after a number of revolutions, from a run of
    /// the method in double-double; `None` for a method without double-double, or a failed run.
    pub fn rounding(&self, method: Constant, each: u32, revolutions: u32) -> Option<[f64; 3]> {
        let method = method(each * revolutions);
        let time = self.nutation.period * f64::from(revolutions);
        let twice: Vec<DoubleDouble> = self.state.iter().map(|y| DoubleDouble::from(*y)).collect();
        let (rounded, exact) = (self.end(method, time, &self.state)?, self.end(method, time, &twice)?);
        let near: Vec<DoubleDouble> = rounded.iter().map(|y| DoubleDouble::from(*y)).collect();
        let of = |value: &dyn Fn(&[DoubleDouble]) -> DoubleDouble| (value(&near) - value(&exact)).approx();
        Some([
            of(&|y| self.law.energy(y)) / self.law.energy(&self.state),
            of(&|y| self.law.vertical_length(y)),
            of(&|y| self.law.vertical_momentum(y)) / self.law.vertical_momentum(&self.state),
        ])
    }

    fn end<S: Working>(&self, method: Method, time: f64, state: &[S]) -> Option<Vec<S>> {
        let span = Span::new(0.0, time, state).with_evaluations(u64::MAX);
        let outcome = integrate_in(&self.system(), method, &Tolerance::both(1e-10), &span, &mut ());
        outcome.reached().then_some(outcome.state)
    }

    fn sample(&self, time: f64, state: &[f64], swing: f64) -> Sample {
        let vertical = Vector3::new(state[3], state[4], state[5]);
        let (u, speed) = self.nutation.quarter;
        let phase = (vertical.dot(&self.axis) - u) / (speed * self.nutation.period);
        let momentum = self.law.vertical_momentum(&self.state);
        Sample {
            revolutions: time / self.nutation.period,
            energy: self.energy(state),
            swing,
            length: self.law.vertical_length(state) - 1.0,
            momentum: (self.law.vertical_momentum(state) - momentum) / momentum,
            phase: Some(phase).filter(|phase| phase.abs() < LOST),
        }
    }
}

impl MethodRun {
    /// The exponent e of error ~ n^e, from a hundredth of the run to its end, or to the last sample for which `of`
    /// gives a value.
    pub fn growth(&self, of: impl Fn(&Sample) -> Option<f64>) -> Option<f64> {
        let seen = |sample: &Sample| Some((sample.revolutions, of(sample)?));
        let (end, last) = self.samples.iter().filter_map(seen).next_back()?;
        let (start, first) = self.samples.iter().filter_map(seen).find(|(at, _)| *at >= end / 110.0)?;
        let growth = (last / first).abs().ln() / (end / start).ln();
        growth.is_finite().then_some(growth)
    }
}

struct Sampled<'a> {
    run: &'a LongRun,
    samples: Vec<Sample>,
    swing: f64,
}

impl Observer<f64> for Sampled<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        let mut sample = self.run.sample(time, state, self.swing);
        // a phase error that becomes small again after it was lost belongs to another revolution
        if self.samples.last().is_some_and(|before| before.phase.is_none()) {
            sample.phase = None;
        }
        self.samples.push(sample);
    }

    fn step(&mut self, _: f64, state: &[f64]) {
        self.swing = self.swing.max(self.run.energy(state).abs());
    }
}
