//! Three angles that place a frame, as numbers.

use super::SteadyMotion;
use model::{Model, StartValue};
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

/// Names of the angles of both sets.
pub(super) const EULER: [&str; 3] = ["precession", "nutation", "spin"];
pub(super) const TAIT_BRYAN: [&str; 3] = ["yaw", "pitch", "roll"];

/// The angles of one frame.
#[derive(Clone, Debug)]
pub(super) struct Angles {
    pub parent: String,
    pub frame: String,
    /// Those of the parent and of the frames between.
    pub axes: [usize; 3],
    pub names: [&'static str; 3],
    /// The place of the first angle among the coordinates.
    pub first: usize,
}

impl Angles {
    /// The angles and their rates at the start of a model in which the frame turns freely.
    pub fn start(&self, original: &Model, number: usize, is_spinning: bool) -> Vec<StartValue> {
        let state = original.start_state();
        let at = original.free_position(number);
        let quaternion = Quaternion::new(state[at], state[at + 1], state[at + 2], state[at + 3]);
        let matrix = *UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix().matrix();
        let angles = self.of(&matrix);
        let first = original.positions() + original.free_speed(number);
        let own = Vector3::new(state[first], state[first + 1], state[first + 2]);
        let turning = matrix * own;
        // at a pole the rates are those of a frame that rests
        let rates = match is_spinning {
            true => self.turns(angles).lu().solve(&turning).unwrap_or_default(),
            false => Vector3::new(turning[self.axes[0]], 0.0, 0.0),
        };
        let value = |order: usize, values: [f64; 3]| {
            values.into_iter().enumerate().map(move |(k, value)| StartValue {
                coordinate: self.first + k,
                order,
                value,
                is_guess: true,
            })
        };
        value(0, angles).chain(value(1, rates.into())).collect()
    }

    /// The angles of a rotation.
    pub fn of(&self, matrix: &Matrix3<f64>) -> [f64; 3] {
        let [e, a, last] = self.axes;
        let b = 3 - e - a;
        let entry = |row: usize, column: usize| matrix[(row, column)];
        match last == e {
            true => {
                [entry(a, e).atan2(-entry(b, e)), entry(e, e).clamp(-1.0, 1.0).acos(), entry(e, a).atan2(entry(e, b))]
            }
            false => [
                (-entry(a, b)).atan2(entry(b, b)),
                entry(e, b).clamp(-1.0, 1.0).asin(),
                (-entry(e, a)).atan2(entry(e, e)),
            ],
        }
    }

    fn turn(&self, place: usize, angle: f64) -> Matrix3<f64> {
        *Rotation3::from_axis_angle(&Vector3::ith_axis(self.axes[place]), angle).matrix()
    }

    /// The rotation.
    pub fn matrix(&self, angles: [f64; 3]) -> Matrix3<f64> {
        (0..3).fold(Matrix3::identity(), |own, place| own * self.turn(place, angles[place]))
    }

    /// The angular velocities of the three rates, along the axes of the parent.
    pub fn turns(&self, angles: [f64; 3]) -> Matrix3<f64> {
        let mut own = Matrix3::identity();
        let columns: Vec<Vector3<f64>> = (0..3)
            .map(|place| {
                let column = own * Vector3::ith(self.axes[place], 1.0);
                own *= self.turn(place, angles[place]);
                column
            })
            .collect();
        Matrix3::from_columns(&columns)
    }

    /// Axes of the parent: all, or the first one.
    pub fn rows(&self, is_whole: bool) -> impl Iterator<Item = usize> {
        let first = self.axes[0];
        (0..3).filter(move |row| is_whole || *row == first)
    }

    /// The axes of the parent by those of the frame, the first alone where the first angle is none of the motion's, and the angular velocity.
    pub fn seen(&self, motion: &SteadyMotion, is_whole: bool) -> Vec<f64> {
        let n = motion.state.len() / 2;
        let of = |from: usize| -> [f64; 3] { std::array::from_fn(|k| motion.state[from + self.first + k]) };
        let (angles, rates) = (of(0), Vector3::from(of(n)));
        let matrix = self.matrix(angles);
        let turning = matrix.transpose() * (self.turns(angles) * rates);
        let rows = self.rows(is_whole);
        rows.flat_map(|row| matrix.row(row).iter().copied().collect::<Vec<_>>())
            .chain(turning.iter().copied())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// R is put together again from its angles, and the rates give the angular velocity, for every first axis and both sets.
    #[test]
    fn angles_of_a_rotation_give_it_again() {
        let rotation = *Rotation3::from_euler_angles(0.3, -0.8, 1.9).matrix();
        for e in 0..3 {
            let (a, b) = ((e + 1) % 3, (e + 2) % 3);
            for (axes, names) in [([e, a, e], EULER), ([e, a, b], TAIT_BRYAN)] {
                let own = Angles { parent: "N".to_owned(), frame: "F".to_owned(), axes, names, first: 0 };
                let angles = own.of(&rotation);
                assert!((own.matrix(angles) - rotation).amax() < 1e-14, "{axes:?}");
                let by = |h: f64| own.matrix([angles[0] + 0.3 * h, angles[1] - 0.2 * h, angles[2] + 0.7 * h]);
                let rate = (by(1e-6) - by(-1e-6)) / 2e-6 * rotation.transpose();
                let w = own.turns(angles) * Vector3::new(0.3, -0.2, 0.7);
                assert!((rate - w.cross_matrix()).amax() < 1e-9, "{axes:?}");
            }
        }
    }
}
