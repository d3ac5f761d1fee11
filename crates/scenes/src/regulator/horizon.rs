//! Riccati's differential equation, integrated backwards from the end of a finite horizon, with time-varying coefficients.
//!
//! With P = Y X^-1, X and Y satisfy the linear Hamiltonian equations (X; Y)' = H (X; Y). Each step multiplies (X; Y) by the matrix exponential
//! of the Magnus expansion of fourth order (Magnus 1954); for constant H this is exact, however stiff the equation is. At times between the
//! ends of a step, the coefficients are interpolated by a parabola through both ends and the middle.

use super::riccati::Stage;
use nalgebra::DMatrix;

/// The solution P of Riccati's equation at the ends of equal steps, with the linear equations at the ends and middles of the steps.
#[derive(Clone, Debug)]
pub struct Backwards {
    step: f64,
    stages: Vec<Stage>,
    values: Vec<DMatrix<f64>>,
}

impl Backwards {
    /// Integrates backwards from P = `end` over steps of the length `step` (s); `None` where P becomes infinite.
    pub fn of(stages: Vec<Stage>, step: f64, end: DMatrix<f64>) -> Option<Self> {
        let mut values = vec![end];
        for three in (0..stages.len() / 2).rev().map(|k| &stages[2 * k..2 * k + 3]) {
            let value = moved([&three[0], &three[1], &three[2]], step, values.last()?)?;
            values.push(value);
        }
        values.reverse();
        Some(Backwards { step, stages, values })
    }

    /// P at the start of the horizon.
    pub fn first(&self) -> &DMatrix<f64> {
        &self.values[0]
    }

    /// The gains K at a time in seconds, inputs by states; `None` where P is infinite.
    pub fn gains(&self, time: f64) -> Option<DMatrix<f64>> {
        let last = self.values.len().checked_sub(2)?;
        let place = (time / self.step).floor().clamp(0.0, last as f64) as usize;
        let three = self.stages.get(2 * place..2 * place + 3)?;
        let s = (time / self.step - place as f64).clamp(0.0, 1.0);
        let [here, middle] = [s, 0.5 * (1.0 + s)].map(|s| between(three, s));
        here.gains(&moved([&here, &middle, &three[2]], (1.0 - s) * self.step, &self.values[place + 1])?)
    }

    /// The linear equations at the ends and middles of the steps, and the length of a step in seconds.
    pub fn stages(&self) -> (&[Stage], f64) {
        (&self.stages, self.step)
    }
}

/// Largest norm of an exponent, beyond which the matrix exponential could overflow: a longer step is divided.
const MOST: f64 = 30.0;

/// Largest number of parts of a step.
const PARTS: f64 = 4096.0;

/// P at the beginning of a step from its value at the end; `None` where P is infinite.
fn moved(stages: [&Stage; 3], step: f64, value: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let size = stages.iter().map(|stage| stage.hamiltonian().map_or(f64::NAN, |all| all.norm())).fold(0.0, f64::max);
    let parts = (size * step / MOST).ceil();
    if parts <= 1.0 {
        return moved_once(stages, step, value);
    }
    let parts = if parts <= PARTS { parts as usize } else { return None };
    let all = stages.map(Clone::clone);
    let mut value = value.clone();
    for k in (0..parts).rev() {
        let at = |s: f64| between(&all, (k as f64 + s) / parts as f64);
        value = moved_once([&at(0.0), &at(0.5), &at(1.0)], step / parts as f64, &value)?;
    }
    Some(value)
}

fn moved_once(stages: [&Stage; 3], step: f64, value: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = value.nrows();
    let [first, middle, last] = stages.map(Stage::hamiltonian);
    let (first, middle, last) = (first?, middle?, last?);
    let sum = (&first + middle * 4.0 + &last) * (-step / 6.0);
    let commutator = (&last * &first - &first * &last) * (step * step / 12.0);
    let moved = (sum - commutator).exp();
    let block = |row: usize, column: usize| moved.view((row * n, column * n), (n, n)).into_owned();
    let (x, y) = (block(0, 0) + block(0, 1) * value, block(1, 0) + block(1, 1) * value);
    let value = x.transpose().lu().solve(&y.transpose())?;
    value.iter().all(|entry| entry.is_finite()).then(|| (&value + value.transpose()) * 0.5)
}

/// The coefficients at the fraction s of a step, by a parabola through its beginning, middle and end.
fn between(three: &[Stage], s: f64) -> Stage {
    let factors = [(1.0 - s) * (1.0 - 2.0 * s), 4.0 * s * (1.0 - s), s * (2.0 * s - 1.0)];
    let part = |of: fn(&Stage) -> &DMatrix<f64>| {
        of(&three[0]) * factors[0] + of(&three[1]) * factors[1] + of(&three[2]) * factors[2]
    };
    Stage {
        a: part(|stage| &stage.a),
        b: part(|stage| &stage.b),
        state: part(|stage| &stage.state),
        mixed: part(|stage| &stage.mixed),
        input: part(|stage| &stage.input),
    }
}
