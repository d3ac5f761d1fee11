//! Rotations of frames relative to their parents.

use field::{Circle, Scalar};
use symbolic::Sym;

/// The rotation of a frame relative to its parent.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rotation {
    /// A rotation about a common axis.
    About { axis: usize, angle: Circle<Sym> },
    /// A rotation matrix by rows, which maps components along the frame's axes to components along the parent's axes.
    Matrix([[Sym; 3]; 3]),
}

impl Rotation {
    /// Returns the rotation matrix of the quaternion a + b i + c j + d k of any nonzero norm, so that rounding errors of the norm do not affect orthogonality.
    pub fn direction_cosines([a, b, c, d]: [Sym; 4]) -> [[Sym; 3]; 3] {
        let two = Sym::int(2);
        let square = a * a + b * b + c * c + d * d;
        let diagonal =
            |plus: Sym, minus: [Sym; 2]| (a * a + plus * plus - minus[0] * minus[0] - minus[1] * minus[1]) / square;
        let beside = |product: Sym, turn: Sym| two * (product + turn) / square;
        [
            [diagonal(b, [c, d]), beside(b * c, -(a * d)), beside(b * d, a * c)],
            [beside(b * c, a * d), diagonal(c, [b, d]), beside(c * d, -(a * b))],
            [beside(b * d, -(a * c)), beside(c * d, a * b), diagonal(d, [b, c])],
        ]
    }

    /// Maps components along the axes of the frame to components along the axes of the parent.
    pub fn to_parent(self, components: [Sym; 3]) -> [Sym; 3] {
        match self {
            Rotation::About { axis, angle } => turned(components, axis, angle),
            Rotation::Matrix(rows) => rows.map(|row| product(row, components)),
        }
    }

    /// Maps components along the axes of the parent to components along the axes of the frame.
    pub fn into_frame(self, components: [Sym; 3]) -> [Sym; 3] {
        match self {
            Rotation::About { axis, angle: Circle { cos, sin } } => turned(components, axis, Circle { cos, sin: -sin }),
            Rotation::Matrix(rows) => std::array::from_fn(|column| product(rows.map(|row| row[column]), components)),
        }
    }
}

/// Returns the rates of a quaternion q from the angular velocity w in rad/s along the frame's own axes: q w/2.
pub fn quaternion_rates<S: Scalar>([a, b, c, d]: [S; 4], [x, y, z]: [S; 3]) -> [S; 4] {
    let half = S::ratio(1, 2);
    [
        -half * (b * x + c * y + d * z),
        half * (a * x + c * z - d * y),
        half * (a * y + d * x - b * z),
        half * (a * z + b * y - c * x),
    ]
}

/// Returns the product of two quaternions: the first rotation, then the second one about the rotated axes.
pub(crate) fn quaternion_product<S: Scalar>([a, b, c, d]: [S; 4], [e, f, g, h]: [S; 4]) -> [S; 4] {
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

/// Returns the quaternion after a further rotation, about a vector along the frame's own axes, by its length in radians.
pub fn turned_further(quaternion: [f64; 4], [x, y, z]: [f64; 3]) -> [f64; 4] {
    let half = (x * x + y * y + z * z).sqrt() / 2.0;
    // sin(h)/(2 h), with its limit at zero
    let share = if half > 0.0 { half.sin() / (2.0 * half) } else { 0.5 };
    quaternion_product(quaternion, [half.cos(), share * x, share * y, share * z])
}

fn product(a: [Sym; 3], b: [Sym; 3]) -> Sym {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns the components along the parent's axes, for a rotation about an axis.
fn turned(components: [Sym; 3], axis: usize, Circle { cos, sin }: Circle<Sym>) -> [Sym; 3] {
    let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turned = components;
    turned[first] = cos * components[first] - sin * components[second];
    turned[second] = sin * components[first] + cos * components[second];
    turned
}
