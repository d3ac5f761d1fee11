//! The experiment with the drive: Euler's method with the step 0.01 s, with and without stabilisation, and its
//! stability limit.

use super::bearable::bearable_steps;
use super::drive_law::{Nine, Seven, violation};
use integrators::{Failure, Method, Observer, Record, Span, Tolerance, integrate};
use simulation::CompiledLaw;
use systems::crank_drive::{Circuit, CrankDrive};
use systems::crank_slider::CrankSlider;

/// The step size of the experiment, s.
pub const STEP: f64 = 0.01;
/// The span, s.
pub const SPAN: f64 = 20.0;

/// A slow drive: its electrical time constants exceed half a step, as stability of Euler's method requires.
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

/// The initial state: at rest without currents, the crank at 0.3 rad.
pub fn start() -> [f64; 9] {
    let angle = 0.3;
    [0.0, 0.0, 0.0, 0.0, 0.0, angle, 0.0, DRIVE.mechanism.slider(angle), 0.0]
}

/// The nine unknowns at a time, s.
pub type Sample = (f64, [f64; 9]);

/// A run: times and states after each step, beginning with the start, and the failure if it stopped.
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

/// One run of the nine equations with a step size in s.
pub fn run(name: &str, method: fn(u32) -> Method, step: f64, damping: f64, stiffness: f64) -> Track {
    let law = CompiledLaw::new(Nine { drive: DRIVE, damping, stiffness });
    let mut points = vec![(0.0, start())];
    let span = Span::new(0.0, SPAN, &start());
    let steps = (SPAN / step).round() as u32;
    let outcome = integrate(&law, method(steps), &Tolerance::both(1e-9), &span, &mut Every(&mut points));
    Track { name: name.to_owned(), points, failure: outcome.failure() }
}

impl Track {
    /// The largest |f|, m^2, and |f'|, m^2/s, along the run.
    pub fn drift(&self) -> (f64, f64) {
        self.points.iter().fold((0.0, 0.0), |(f, df): (f64, f64), (_, y)| {
            let (value, rate) = violation(&DRIVE, y);
            (f.max(value.abs()), df.max(rate.abs()))
        })
    }
}

/// The reference motion at equidistant times, from the seven equations, with the slider's position and speed; and the
/// number of digits on which two methods of different families agree.
///
/// # Errors
/// [`Failure`] of one of the two runs.
pub fn exact(outputs: usize) -> Result<(Vec<Sample>, f64), Failure> {
    let y = start();
    let seven = Seven { drive: DRIVE };
    let law = CompiledLaw::new(seven);
    let span = Span::new(0.0, SPAN, &y[..7]).with_even_outputs(outputs);
    let follow = |method| -> Result<Record<f64>, Failure> {
        let mut record = Record::new();
        match integrate(&law, method, &Tolerance::both(1e-12), &span, &mut record).failure() {
            Some(failure) => Err(failure),
            None => Ok(record),
        }
    };
    let (first, second) = (follow(Method::DormandPrince8)?, follow(Method::Gauss { stages: 5 })?);
    let pairs = first.states.iter().flatten().zip(second.states.iter().flatten());
    let apart = pairs.map(|(a, b)| (a - b).abs() / a.abs().max(1.0)).fold(f64::MIN_POSITIVE, f64::max);
    Ok((first.times.iter().copied().zip(first.states.iter().map(|y| seven.whole(y))).collect(), -apart.log10()))
}

/// Stability limits of Euler's step size, s. By theory: the longest for which I + h A has no eigenvalue outside the
/// unit circle, where A is the Jacobian of the circuit's five equations at the times of the motion. By measurement: the
/// longest for which the currents of a run stay bounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearable {
    /// The smallest limit over all times.
    pub least: f64,
    /// The largest limit over all times: longer steps are unstable at every time.
    pub greatest: f64,
    /// The measured limit without stabilisation.
    pub plain: f64,
    /// The measured limit with the gains of the fastest decay for each step size.
    pub stabilised: f64,
}

/// The stability limits of Euler's step size, by theory and by runs.
///
/// # Errors
/// [`Failure`] of the reference run.
pub fn bearable() -> Result<Bearable, Failure> {
    let [least, greatest] = bearable_steps(&Seven { drive: DRIVE }, &start()[..7], SPAN)?;
    Ok(Bearable { least, greatest, plain: measured(0.0, 0.0), stabilised: measured(2.0, 1.0) })
}

/// The longest step (s) with bounded currents and the gains h b and h^2 k, to a relative accuracy of 1/1000.
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

/// A current above which a run counts as unbounded, A: the source could drive 40 A through its resistance.
const LOST: f64 = 200.0;

/// The largest damping b, measured by runs, for which the drive's constraint does not drift with the step size of the
/// experiment and the stiffness k; theoretically h b = 2 + h^2 k / 2.
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
