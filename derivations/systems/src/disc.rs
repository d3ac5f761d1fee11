//! A thin disc that rolls on a horizontal plane.
//!
//! The coordinates are (r, e, e'): the centre and two orthonormal vectors in the disc, with the masses (m, m, m, P,
//! ..., P). Here P is the second moment of mass in each direction, m a^2/4 for a uniform disc and m a^2/2 for a ring.
//! The axis n = e x e' is not needed as a coordinate. The z axis points upwards. The lowest point of the disc is r - a
//! (e_z e + e'_z e')/s with s^2 = e_z^2 + e'_z^2. If it touches the plane, s = z/a, so that the condition of rolling is
//! algebraic.

use field::{Analytic, Base, Over, Scalar};
use mechanics::constrained::newton::{Reactions, at_point};
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};
use mechanics::rotation::euler;

reader::quantities! {
    /// The data of the disc.
    pub struct Disc {
        /// m, mass
        mass: "kg" > 0,
        /// P, second moment of the mass along a diameter, half of the moment of inertia about the axis
        second_moment: "kg m^2" > 0,
        /// a, radius
        radius: "m" > 0,
        /// g, acceleration of gravity
        gravity: "m/s^2",
    }
}

/// The coordinates as three vectors.
fn vectors<S: Scalar>([x, y, z, ex, ey, ez, fx, fy, fz]: [S; 9]) -> [[S; 3]; 3] {
    [[x, y, z], [ex, ey, ez], [fx, fy, fz]]
}

fn dot<S: Scalar>(a: [S; 3], b: [S; 3]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl<P: Base> PointSystem<9> for Disc<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 9] {
        let (m, p) = (S::lift(self.mass), S::lift(self.second_moment));
        [m, m, m, p, p, p, p, p, p]
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 9>) -> [S; 9] {
        let mut force = [S::zero(); 9];
        force[2] = -S::lift(self.mass) * S::lift(self.gravity);
        force
    }
}

/// The constraints: orthonormality of the two vectors, contact with the plane, and no slip of the contact point along x
/// and y.
impl<P: Base> Constrained<9, 6> for Disc<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 9>) -> [Constraint<S>; 6] {
        let ([r, e, f], [dr, de, df]) = (vectors(at.place), vectors(at.velocity));
        let square = S::lift(self.radius).squared();
        let slip = |i: usize| r[2] * dr[i] - square * (e[2] * de[i] + f[2] * df[i]);
        [
            Constraint::Geometric((dot(e, e) - S::one()).half()),
            Constraint::Geometric((dot(f, f) - S::one()).half()),
            Constraint::Geometric(dot(e, f)),
            Constraint::Geometric((r[2].squared() - square * (e[2].squared() + f[2].squared())).half()),
            Constraint::Kinematic(slip(0)),
            Constraint::Kinematic(slip(1)),
        ]
    }
}

/// The reactions: internal forces of the rigid disc on the two vectors; the normal and the tangential force of the
/// plane at the contact point.
impl<P: Base> Reactions<9, 6> for Disc<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 9>) -> [[S; 9]; 6] {
        let [r, e, f] = vectors(at.place);
        let (o, l) = (S::zero(), S::one());
        // the coordinates of the contact point along e and e'
        let radius = S::lift(self.radius);
        let [along_e, along_f] = [e[2], f[2]].map(|height| -radius * radius * height / r[2]);
        let push = |force: [S; 3]| {
            at_point(
                |x| {
                    let [r, e, f] = vectors(x);
                    let fixed = field::Tangent::fixed;
                    std::array::from_fn(|i| r[i] + fixed(along_e) * e[i] + fixed(along_f) * f[i])
                },
                at.place,
                force,
            )
        };
        [
            [o, o, o, e[0], e[1], e[2], o, o, o],
            [o, o, o, o, o, o, f[0], f[1], f[2]],
            [o, o, o, f[0], f[1], f[2], e[0], e[1], e[2]],
            push([o, o, l]),
            push([l, o, o]),
            push([o, l, o]),
        ]
    }
}

/// The chart q = (x, y, psi, theta, phi) with Euler's angles, theta measured from the vertical to the axis; p = (psi',
/// theta', phi').
impl<P: Base> Charted<9, 5, 3> for Disc<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [x, y, psi, theta, phi]: [S; 5]) -> [S; 9] {
        let axes = euler([psi, theta, phi]);
        let (e, f) = (axes.column(0), axes.column(1));
        [x, y, S::lift(self.radius) * theta.circle().sin, e[0], e[1], e[2], f[0], f[1], f[2]]
    }

    /// The centre moves with velocity -a (phi' + psi' cos theta) along the horizontal diameter of the disc, and a
    /// theta' sin theta perpendicular to it.
    fn rates<S: Over<P> + Analytic>(&self, _time: S, q: [S; 5], [spin, tilt, roll]: [S; 3]) -> [S; 5] {
        let (psi, theta) = (q[2].circle(), q[3].circle());
        let radius = S::lift(self.radius);
        let (forward, sideways) = (-radius * (roll + spin * theta.cos), radius * tilt * theta.sin);
        [forward * psi.cos + sideways * psi.sin, forward * psi.sin - sideways * psi.cos, spin, tilt, roll]
    }
}
