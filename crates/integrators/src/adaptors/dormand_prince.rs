//! Dormand and Prince's pairs from the crate `ode_solvers`: 5(4) and 8(5,3), after Hairer, Norsett and Wanner's codes.
//!
//! The crate stores every accepted step, so a run of very many steps is cut into stretches: memory stays bounded. The step
//! size goes over from stretch to stretch.
//!
//! Version 0.6.2 has c_12 = 0 instead of 1 in the pair 8(5,3): order 1 for laws that depend on time (reported as pull
//! request 42 of srenevey/ode-solvers). The rows of the matrix are right, so time is made one more component there.

use std::cell::RefCell;

use ode_solvers::dop_shared::{IntegrationError, Stats};
use ode_solvers::{DVector, Dop853, Dopri5, OutputType, SVector, System};

use crate::drive::first_step;
use crate::meter::Meter;
use crate::watch::Watch;
use crate::{Absolute, Failure, Outcome, Tolerance};

/// Which of the two pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pair {
    Five,
    Eight,
}

/// Steps after which a stretch is cut.
const LONGEST_STRETCH: u32 = 10_000;

/// The crate tests for stiffness at every so manieth step.
const STIFFNESS_EVERY: u32 = 100;

/// Runs one pair to the end of the span, or to its failure.
pub(crate) fn run(
    pair: Pair,
    tolerance: &Tolerance,
    meter: &Meter<f64>,
    mut watch: Watch<'_, '_, f64>,
) -> Outcome<f64> {
    let order = if pair == Pair::Five { 5 } else { 8 };
    let mut step = first_step(meter, watch.state(), tolerance, order, watch.length());
    let units = Units::of(tolerance, meter.dimension());
    while watch.goes_on() {
        let stretch = Stretch { pair, meter, units: &units, tolerance, from: watch.tau(), to: watch.landing(), step };
        let (longest, result) = stretch.run_in_its_dimension(&mut watch);
        let at = watch.time();
        if let Some(failure) = meter.exhausted(at) {
            return watch.fail(failure, meter);
        }
        let failure = match result {
            Ok(Ended::Arrived) => None,
            Ok(Ended::NotFinite) => Some(Failure::LeftTheNumbers { at }),
            Err(_) if meter.was_undefined() => Some(Failure::LeftTheNumbers { at }),
            Err(IntegrationError::MaxNumStepReached { .. }) => None,
            Err(IntegrationError::StepSizeUnderflow { .. }) => {
                Some(Failure::StepCollapsed { at, step: 10.0 * f64::EPSILON * at.abs() })
            }
            Err(IntegrationError::StiffnessDetected { .. }) => Some(Failure::Stiff { at }),
        };
        if let Some(failure) = failure {
            return watch.fail(failure, meter);
        }
        step = longest;
    }
    let end = watch.end();
    watch.finish(end, meter)
}

/// How a stretch ended without an error of the crate.
enum Ended {
    Arrived,
    NotFinite,
}

/// The units in which every component has the same absolute tolerance: the crate knows one for all.
struct Units {
    absolute: f64,
    sizes: Option<Vec<f64>>,
}

impl Units {
    fn of(tolerance: &Tolerance, dimension: usize) -> Self {
        let absolute = tolerance.absolute(0);
        let sizes = match &tolerance.absolute {
            Absolute::Same(_) => None,
            Absolute::Each(_) => Some((0..dimension).map(|i| tolerance.absolute(i) / absolute).collect()),
        };
        Units { absolute, sizes }
    }

    /// The state in the problem's own units, without the clock.
    fn read<'v>(&self, y: &'v [f64], buffer: &'v mut [f64]) -> &'v [f64] {
        let Some(sizes) = &self.sizes else { return &y[..buffer.len()] };
        for ((own, y), size) in buffer.iter_mut().zip(y).zip(sizes) {
            *own = y * size;
        }
        buffer
    }

    /// The state, or its rates, in the crate's units.
    fn write(&self, v: &mut [f64]) {
        if let Some(sizes) = &self.sizes {
            v.iter_mut().zip(sizes).for_each(|(v, size)| *v /= size);
        }
    }
}

/// One run of the crate.
struct Stretch<'s, 'l> {
    pair: Pair,
    meter: &'s Meter<'l, f64>,
    units: &'s Units,
    tolerance: &'s Tolerance,
    from: f64,
    to: f64,
    step: f64,
}

impl Stretch<'_, '_> {
    /// Whether the last component is the time.
    fn has_clock(&self) -> bool {
        self.pair == Pair::Eight
    }

    /// Static vectors up to 16 components and the clock, which need no heap, padded with components at rest to the
    /// next size (every size is compiled by itself); beyond, dynamic ones.
    fn run_in_its_dimension(&self, watch: &mut Watch<'_, '_, f64>) -> (f64, Result<Ended, IntegrationError>) {
        let mut y = watch.state().to_vec();
        self.units.write(&mut y);
        if self.has_clock() {
            y.push(self.from);
        }
        let used = y.len();
        macro_rules! dispatch {
            ($($n:literal)*) => {
                match used {
                    $(0..=$n => {
                        y.resize($n, 0.0);
                        self.run(SVector::<f64, $n>::from_column_slice(&y), used, watch)
                    })*
                    _ => self.run(DVector::from_column_slice(&y), used, watch),
                }
            };
        }
        dispatch!(2 4 8 9 12 17)
    }

    /// The longest step tried, and how it ended.
    fn run<V: Column>(
        &self,
        y: V,
        used: usize,
        watch: &mut Watch<'_, '_, f64>,
    ) -> (f64, Result<Ended, IntegrationError>) {
        // the crate's errors are means over all components
        let share = (used as f64 / y.slice().len() as f64).sqrt();
        let mut trace = Trace { longest: 0.0, last: self.from, finite: true };
        let buffer = RefCell::new(vec![0.0; self.meter.dimension()]);
        let law = Law { stretch: self, watch, trace: &mut trace, buffer };
        let result = V::solve(law, self, share, y);
        let longest = if trace.longest > 0.0 { trace.longest } else { self.step };
        if let Ok(stats) = &result {
            watch.rejected(u64::from(stats.rejected_steps));
        }
        (longest, result.map(|_| if trace.finite { Ended::Arrived } else { Ended::NotFinite }))
    }
}

/// What is known of the steps of a stretch.
struct Trace {
    longest: f64,
    last: f64,
    finite: bool,
}

/// The law in the crate's form.
struct Law<'t, 's, 'l, 'w, 'm> {
    stretch: &'t Stretch<'s, 'l>,
    watch: &'t mut Watch<'w, 'm, f64>,
    trace: &'t mut Trace,
    buffer: RefCell<Vec<f64>>,
}

impl<V: Column> System<f64, V> for Law<'_, '_, '_, '_, '_> {
    fn system(&self, tau: f64, y: &V, dy: &mut V) {
        let mut buffer = self.buffer.borrow_mut();
        let n = buffer.len();
        let tau = if self.stretch.has_clock() { y.slice()[n] } else { tau };
        let y = self.stretch.units.read(y.slice(), &mut buffer);
        let dy = dy.slice_mut();
        self.stretch.meter.rates(tau, y, &mut dy[..n]);
        dy[n..].fill(0.0);
        if self.stretch.has_clock() {
            dy[n] = 1.0;
        }
        self.stretch.units.write(dy);
    }

    fn solout(&mut self, tau: f64, y: &V, _: &V) -> bool {
        self.stretch.meter.was_undefined();
        let y = self.stretch.units.read(y.slice(), self.buffer.get_mut());
        self.trace.finite = y.iter().all(|y| y.is_finite());
        if self.trace.finite {
            let lands = (self.stretch.to - tau).abs() <= 4.0 * f64::EPSILON * self.stretch.to;
            self.trace.longest = self.trace.longest.max(tau - self.trace.last);
            self.trace.last = tau;
            self.watch.accept(if lands { self.stretch.to } else { tau }, y);
        }
        !self.trace.finite || !self.watch.goes_on()
    }
}

/// A vector of the crate, static or dynamic.
trait Column: Clone {
    fn slice(&self) -> &[f64];
    fn slice_mut(&mut self) -> &mut [f64];
    /// Runs the pair that the stretch asks for, at this share of its tolerance. The parameters are those of Hairer's
    /// codes.
    fn solve(
        law: Law<'_, '_, '_, '_, '_>,
        stretch: &Stretch<'_, '_>,
        share: f64,
        y: Self,
    ) -> Result<Stats, IntegrationError>;
}

macro_rules! column {
    ($type:ty $(, $n:ident)?) => {
        impl$(<const $n: usize>)? Column for $type {
            fn slice(&self) -> &[f64] {
                self.as_slice()
            }

            fn slice_mut(&mut self) -> &mut [f64] {
                self.as_mut_slice()
            }

            fn solve(
                law: Law<'_, '_, '_, '_, '_>,
                stretch: &Stretch<'_, '_>,
                share: f64,
                y: Self,
            ) -> Result<Stats, IntegrationError> {
                let (from, to, longest) = (stretch.from, stretch.to, stretch.to - stretch.from);
                let (relative, absolute) = (share * stretch.tolerance.relative, share * stretch.units.absolute);
                let (first, most, every) = (stretch.step.min(longest), LONGEST_STRETCH, STIFFNESS_EVERY);
                let quiet = OutputType::Sparse;
                match stretch.pair {
                    Pair::Five => Dopri5::from_param(
                        law, from, to, longest, y, relative, absolute, 0.9, 0.04, 0.2, 10.0, longest, first, most,
                        every, quiet,
                    )
                    .integrate(),
                    Pair::Eight => Dop853::from_param(
                        law, from, to, longest, y, relative, absolute, 0.9, 0.0, 0.333, 6.0, longest, first, most,
                        every, quiet,
                    )
                    .integrate(),
                }
            }
        }
    };
}
column!(SVector<f64, N>, N);
column!(DVector<f64>);
