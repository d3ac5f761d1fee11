//! The three angles that describe the orientation of a frame: Euler or Tait-Bryan angles.

use super::SteadyMotion;
use model::{Model, StartValue};
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

/// A trigonometric function of an angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    Sine,
    Cosine,
}

/// A set of three angles about successive axes.
#[derive(Clone, Debug)]
pub(super) struct Set {
    pub axes: [usize; 3],
    pub names: [&'static str; 3],
    /// The names of the angles in the other set.
    pub other: [&'static str; 3],
    /// The axis fixed in the frame; `is_spinning` says whether no equation depends on the rotation about it.
    pub own: usize,
    pub is_spinning: bool,
    /// Whether this is the first set, whose last axis is that of the frame.
    pub is_main: bool,
    /// For the second set, if no equation depends on the spin: whether the axis of the frame points along or against that of the parent.
    pub is_positive: Option<bool>,
    /// The function of the second angle that is zero at singular orientations of the set.
    pub regular: Factor,
    /// Whether the second angle is pi/2, not 0, in the middle of the orientations for which the set is used.
    pub has_angle_from_axis: bool,
    /// For the second set: factors whose product is, up to the sign, the cosine of the angle between the axes of parent and frame. Each is an index
    /// of an angle and its function.
    pub alignment: Vec<(usize, Factor)>,
}

const EULER: [&str; 3] = ["precession", "nutation", "spin"];
const ELEVATED: [&str; 3] = ["precession", "elevation", "spin"];
const TAIT_BRYAN: [&str; 3] = ["yaw", "pitch", "roll"];

impl Set {
    /// The first set of angles, for an axis of the parent and one of the frame.
    pub fn main((parent, own): (usize, usize), is_spinning: bool) -> Self {
        let is_euler = parent == own;
        let between = if is_euler { (parent + 1) % 3 } else { 3 - parent - own };
        Set {
            axes: [parent, between, own],
            names: if is_euler { EULER } else { ELEVATED },
            other: TAIT_BRYAN,
            own,
            is_spinning,
            is_main: true,
            is_positive: None,
            regular: if is_euler { Factor::Sine } else { Factor::Cosine },
            has_angle_from_axis: is_euler,
            alignment: Vec::new(),
        }
    }

    /// The first set, then the second; if the frame spins, the second set for both directions of its axis.
    pub fn all((parent, own): (usize, usize), is_spinning: bool) -> Vec<Self> {
        let main = Set::main((parent, own), is_spinning);
        let (next, last) = ((parent + 1) % 3, (parent + 2) % 3);
        let is_euler = parent != own;
        let alignment = match (is_euler, own == next) {
            (false, _) => vec![(1, Factor::Cosine), (2, Factor::Cosine)],
            (true, true) => vec![(1, Factor::Sine), (2, Factor::Sine)],
            (true, false) => vec![(1, Factor::Sine), (2, Factor::Cosine)],
        };
        let second = |is_positive: Option<bool>| Set {
            axes: [parent, next, if is_euler { parent } else { last }],
            names: TAIT_BRYAN,
            other: main.names,
            is_main: false,
            is_positive,
            regular: if is_euler { Factor::Sine } else { Factor::Cosine },
            has_angle_from_axis: is_euler,
            alignment: alignment.clone(),
            ..main.clone()
        };
        let seconds = match is_spinning {
            true => vec![second(Some(true)), second(Some(false))],
            false => vec![second(None)],
        };
        std::iter::once(main.clone()).chain(seconds).collect()
    }
}

/// If the determinant of the rotation axes is below this value, two of the rotations cannot be separated.
const SINGULAR: f64 = 1e-6;

/// Components of an angular velocity below this fraction of its norm are rounding errors.
const ROUNDING: f64 = 1e-13;

/// The angles of one frame relative to its parent.
#[derive(Clone, Debug)]
pub(super) struct Angles {
    pub parent: String,
    pub frame: String,
    /// The rotation axes (0 to 2) of the three angles, in the parent and in the intermediate frames.
    pub axes: [usize; 3],
    pub names: [&'static str; 3],
    /// The index of the first angle among the coordinates.
    pub first: usize,
}

impl Angles {
    /// The angles of this frame by the first set.
    pub fn as_main(&self, set: &Set) -> Angles {
        let main = Set::main((self.axes[0], set.own), set.is_spinning);
        Angles { axes: main.axes, names: main.names, ..self.clone() }
    }

    /// Start values of the angles, then of their rates, from the free frame of the original model. The rates give the whole angular velocity if the
    /// spin is cyclic, otherwise only its component along the first axis.
    pub fn start(&self, original: &Model, number: usize, is_spinning: bool) -> Vec<StartValue> {
        let state = original.start_state();
        let at = original.free_position(number);
        let quaternion = Quaternion::new(state[at], state[at + 1], state[at + 2], state[at + 3]);
        let matrix = *UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix().matrix();
        let angles = self.of(&matrix);
        let first = original.positions() + original.free_speed(number);
        let own = Vector3::new(state[first], state[first + 1], state[first + 2]);
        let turning = matrix * own;
        let turns = self.turns(angles);
        let mut rates = match is_spinning {
            true if turns.determinant().abs() > SINGULAR => turns.lu().solve(&turning).unwrap_or_default(),
            // first and last axis coincide: the whole rate is attributed to the spin
            true => Vector3::new(0.0, 0.0, own[self.axes[2]]),
            false => Vector3::new(turning[self.axes[0]], 0.0, 0.0),
        };
        let size = own.norm();
        rates.iter_mut().filter(|rate| rate.abs() <= ROUNDING * size).for_each(|rate| *rate = 0.0);
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

    /// The angles of a rotation matrix, in radians.
    fn of(&self, matrix: &Matrix3<f64>) -> [f64; 3] {
        let [e, a, last] = self.axes;
        let b = 3 - e - a;
        let entry = |row: usize, column: usize| matrix[(row, column)];
        let angles = match last == e {
            true => {
                [entry(a, e).atan2(-entry(b, e)), entry(e, e).clamp(-1.0, 1.0).acos(), entry(e, a).atan2(entry(e, b))]
            }
            false => [
                (-entry(a, b)).atan2(entry(b, b)),
                entry(e, b).clamp(-1.0, 1.0).asin(),
                (-entry(e, a)).atan2(entry(e, e)),
            ],
        };
        // with the opposite cyclic order of axes, angles change their signs
        if a == (e + 1) % 3 { angles } else { angles.map(|angle| -angle) }
    }

    fn turn(&self, place: usize, angle: f64) -> Matrix3<f64> {
        *Rotation3::from_axis_angle(&Vector3::ith_axis(self.axes[place]), angle).matrix()
    }

    /// The rotation matrix of the angles: from components in the frame to those in the parent.
    pub fn matrix(&self, angles: [f64; 3]) -> Matrix3<f64> {
        (0..3).fold(Matrix3::identity(), |own, place| own * self.turn(place, angles[place]))
    }

    /// The angular velocities per unit of the three rates, as columns of components in the parent.
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

    /// The axes of the parent that a motion determines: all, or the first one.
    pub fn rows(&self, is_whole: bool) -> impl Iterator<Item = usize> {
        let first = self.axes[0];
        (0..3).filter(move |row| is_whole || *row == first)
    }

    /// The axes of the parent in the frame, then the angular velocity in the frame (rad/s); only the first axis unless `is_whole`.
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

    /// For all orders of axes, the angles of R reproduce R, and their rates reproduce the angular velocity.
    #[test]
    fn angles_of_a_rotation_give_it_again() {
        let rotation = *Rotation3::from_euler_angles(0.3, -0.8, 1.9).matrix();
        for e in 0..3 {
            let (a, b) = ((e + 1) % 3, (e + 2) % 3);
            for axes in [[e, a, e], [e, a, b], [e, b, a]] {
                let own = Angles { parent: "N".to_owned(), frame: "F".to_owned(), axes, names: EULER, first: 0 };
                let angles = own.of(&rotation);
                assert!((own.matrix(angles) - rotation).amax() < 1e-14, "{axes:?}");
                let by = |h: f64| own.matrix([angles[0] + 0.3 * h, angles[1] - 0.2 * h, angles[2] + 0.7 * h]);
                let rate = (by(1e-6) - by(-1e-6)) / 2e-6 * rotation.transpose();
                let w = own.turns(angles) * Vector3::new(0.3, -0.2, 0.7);
                assert!((rate - w.cross_matrix()).amax() < 1e-9, "{axes:?}");
            }
        }
    }

    /// The factors of `alignment` multiply to the cosine of the angle between both axes.
    #[test]
    fn the_second_set_tells_how_both_axes_lie() {
        let rotation = *Rotation3::from_euler_angles(0.3, -0.8, 1.9).matrix();
        for (parent, own) in (0..3).flat_map(|parent| (0..3).map(move |own| (parent, own))) {
            let [_, set] = &Set::all((parent, own), false)[..] else { panic!("two sets") };
            let angles =
                Angles { parent: "N".to_owned(), frame: "F".to_owned(), axes: set.axes, names: set.names, first: 0 };
            let angles = angles.of(&rotation);
            let factor = |&(at, factor): &(usize, Factor)| {
                let (sin, cos) = f64::sin_cos(angles[at]);
                if factor == Factor::Sine { sin } else { cos }
            };
            let product: f64 = set.alignment.iter().map(factor).product();
            assert!((product - rotation[(parent, own)]).abs() < 1e-14, "{parent} {own}: {product}");
        }
    }
}
