//! Riccati's equation back from the end of a horizon, over equations that change with the time.
//!
//! With P = Y X^-1 Hamilton's equations (X; Y)' = H (X; Y) are linear: over a step (X; Y) is moved by the exponential of Magnus's sum of the
//! fourth order, which is exact where H does not change, however fast P settles. Between the ends of steps it is moved in the same way, by
//! equations through those at the ends and in the middle.

use super::riccati::Stage;
use nalgebra::DMatrix;

/// P at equal steps of a horizon, with the equations at their ends and in their middles.
#[derive(Clone, Debug)]
pub struct Backwards {
    step: f64,
    stages: Vec<Stage>,
    values: Vec<DMatrix<f64>>,
}

impl Backwards {
    /// From the P of the end; none where P has no value.
    pub fn of(stages: Vec<Stage>, step: f64, end: DMatrix<f64>) -> Option<Self> {
        let mut values = vec![end];
        for three in (0..stages.len() / 2).rev().map(|k| &stages[2 * k..2 * k + 3]) {
            let value = moved([&three[0], &three[1], &three[2]], step, values.last()?)?;
            values.push(value);
        }
        values.reverse();
        Some(Backwards { step, stages, values })
    }

    /// P at the beginning.
    pub fn first(&self) -> &DMatrix<f64> {
        &self.values[0]
    }

    /// K at a time; none where P has no value.
    pub fn gains(&self, time: f64) -> Option<DMatrix<f64>> {
        let last = self.values.len().checked_sub(2)?;
        let place = (time / self.step).floor().clamp(0.0, last as f64) as usize;
        let three = self.stages.get(2 * place..2 * place + 3)?;
        let s = (time / self.step - place as f64).clamp(0.0, 1.0);
        let [here, middle] = [s, 0.5 * (1.0 + s)].map(|s| between(three, s));
        here.gains(&moved([&here, &middle, &three[2]], (1.0 - s) * self.step, &self.values[place + 1])?)
    }

    /// The equations, at the ends and in the middles of steps.
    pub fn stages(&self) -> (&[Stage], f64) {
        (&self.stages, self.step)
    }
}

/// An exponent beyond this has no exponential: the step is made in parts.
const MOST: f64 = 30.0;

/// Parts of a step, at most.
const PARTS: f64 = 4096.0;

/// P at the beginning of a step from that at its end.
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

/// The parabola through the equations of a step.
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
