//! A symmetric body of variable mass with a gyroscope on its axis, about a fixed point in a Newtonian central field.
//!
//! In the axes of the body, z is along the axis of symmetry; (p, q, r) is the angular velocity, gamma the unit vector
//! from the attracting centre, at the distance R, to the fixed point, and nu the constant angular momentum of the
//! gyroscope along z. A = B, C and the static moment M z_c are functions of time. At each instant body and fuel are
//! treated as a rigid body; the effect of ejected and of internally moving mass is a torque in addition to the given
//! ones.
//!
//!   G = (A p, A q, C r + nu),   2 T = A (p^2 + q^2) + C r^2,
//!   U = -g M z_c gamma_3 - 1/2 kappa (A gamma_1^2 + A gamma_2^2 + C gamma_3^2),   g = mu/R^2, kappa = 3 mu/R^3.

use field::{Scalar, Tangent};
use mechanics::differentiate::gradient;
use mechanics::momentum::absolute_rate;
use mechanics::rotation::determinant;
use nalgebra::{Matrix3, Vector3};

/// The body at one instant; over dual numbers (tangents) it contains the rates of the varying data too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Top<S> {
    /// The equatorial moment of inertia A = B, kg m^2.
    pub equatorial: S,
    /// The axial moment of inertia C, kg m^2.
    pub axial: S,
    /// The static moment M z_c, kg m.
    pub static_moment: S,
    /// The gyroscope's angular momentum nu, kg m^2/s.
    pub gyroscope: S,
    /// The acceleration of gravity g = mu/R^2, m/s^2.
    pub gravity: S,
    /// The coefficient of the gravity gradient kappa = 3 mu/R^3 = 3 g/R, 1/s^2.
    pub tide: S,
}

/// The body's angular velocity, and the vertical in its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude<S: Scalar> {
    /// The angular velocity (p, q, r), 1/s.
    pub spin: Vector3<S>,
    /// The unit vector gamma of the vertical.
    pub vertical: Vector3<S>,
}

/// The integrals whose rates are prescribed: 2(T - U) up to a constant of the field, G.gamma, C (r - r_0),
/// gamma.gamma - 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrals<S> {
    pub energy: S,
    pub vertical_momentum: S,
    pub axial_momentum: S,
    pub length: S,
}

/// The error that no torques, or no unique torques, give the prescribed rates of the integrals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StationaryInclination;

impl std::fmt::Display for StationaryInclination {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "p gamma_2 = q gamma_1: the axis, the vertical and the angular velocity lie in one plane, the inclination of \
             the axis is stationary, and a moment across that plane changes neither energy nor momentum; wanted a state \
             with p gamma_2 != q gamma_1, or the moments of a force function"
        )
    }
}

impl std::error::Error for StationaryInclination {}

impl<S> Top<S> {
    /// The top with `f` applied to every parameter.
    pub fn map<T>(self, f: impl Fn(S) -> T) -> Top<T> {
        Top {
            equatorial: f(self.equatorial),
            axial: f(self.axial),
            static_moment: f(self.static_moment),
            gyroscope: f(self.gyroscope),
            gravity: f(self.gravity),
            tide: f(self.tide),
        }
    }
}

impl<S: Scalar> Top<S> {
    /// The body with all parameters constant.
    pub fn fixed(self) -> Top<Tangent<S>> {
        self.map(Tangent::fixed)
    }

    /// The angular momentum G.
    pub fn momentum(&self, spin: Vector3<S>) -> Vector3<S> {
        Vector3::new(self.equatorial * spin.x, self.equatorial * spin.y, self.axial * spin.z + self.gyroscope)
    }

    /// The kinetic energy T without that of the gyroscope.
    pub fn kinetic_energy(&self, spin: Vector3<S>) -> S {
        (self.equatorial * (spin.x.squared() + spin.y.squared()) + self.axial * spin.z.squared()).half()
    }

    /// The force function U.
    pub fn force_function(&self, vertical: Vector3<S>) -> S {
        let [g1, g2, g3] = vertical.map(S::squared).into();
        let tide = self.equatorial * (g1 + g2) + self.axial * g3;
        -(self.gravity * self.static_moment * vertical.z) - (self.tide * tide).half()
    }

    /// The torque of the field about the fixed point, grad U x gamma.
    pub fn moment_of_field(&self, vertical: Vector3<S>) -> Vector3<S> {
        let slope = gradient(|g: [Tangent<S>; 3]| self.fixed().force_function(g.into()), vertical.into());
        Vector3::from(slope).cross(&vertical)
    }

    /// The residual dG/dt + w x G - torque, with the data constant; it is zero along a motion.
    pub fn residual(&self, spin: Vector3<S>, acceleration: Vector3<S>, moment: Vector3<S>) -> Vector3<S> {
        let moving = spin.zip_map(&acceleration, Tangent::moving);
        absolute_rate(self.fixed().momentum(moving), spin) - moment
    }

    /// The rates (p', q', r') under a torque; A and C must not be zero.
    pub fn acceleration(&self, spin: Vector3<S>, moment: Vector3<S>) -> Vector3<S> {
        let missing = self.residual(spin, Vector3::zeros(), moment);
        Vector3::new(-missing.x / self.equatorial, -missing.y / self.equatorial, -missing.z / self.axial)
    }

    /// The integrals; the field's part is zero for gamma orthogonal to the axis. r_0 is the prescribed axial angular
    /// velocity.
    pub fn integrals(&self, at: &Attitude<S>, axial_speed: S) -> Integrals<S> {
        let across = Vector3::new(S::one(), S::zero(), S::zero());
        let field = self.force_function(at.vertical) - self.force_function(across);
        // the terms with gamma.gamma - 1 in the field's energy are zero on a motion; 2 (T - U) then depends on gamma_3
        // only
        let length = at.vertical.dot(&at.vertical) - S::one();
        let alone = field + (self.tide * self.equatorial * length).half();
        Integrals {
            energy: (self.kinetic_energy(at.spin) - alone) * S::int(2),
            vertical_momentum: self.momentum(at.spin).dot(&at.vertical),
            axial_momentum: self.axial * (at.spin.z - axial_speed),
            length,
        }
    }
}

/// The rate gamma' = gamma x w, since the vertical is fixed in space.
pub fn poisson<S: Scalar>(at: &Attitude<S>) -> Vector3<S> {
    at.vertical.cross(&at.spin)
}

/// The rates of the integrals under a torque, with given gamma'.
pub fn rates<S: Scalar>(
    top: &Top<Tangent<S>>,
    at: &Attitude<S>,
    axial_speed: S,
    moment: Vector3<S>,
    vertical_rate: Vector3<S>,
) -> Integrals<S> {
    let now = top.map(|x| x.value);
    let moving = Attitude {
        spin: at.spin.zip_map(&now.acceleration(at.spin, moment), Tangent::moving),
        vertical: at.vertical.zip_map(&vertical_rate, Tangent::moving),
    };
    let integrals = top.integrals(&moving, Tangent::fixed(axial_speed));
    Integrals {
        energy: integrals.energy.slope,
        vertical_momentum: integrals.vertical_momentum.slope,
        axial_momentum: integrals.axial_momentum.slope,
        length: integrals.length.slope,
    }
}

/// The inverse problem: the torque for which energy, vertical and axial angular momentum have prescribed rates.
///
/// # Errors
/// [`StationaryInclination`] if p gamma_2 = q gamma_1 exactly.
pub fn prescribing<S: Scalar>(
    top: &Top<Tangent<S>>,
    at: &Attitude<S>,
    axial_speed: S,
    wanted: [S; 3],
) -> Result<Vector3<S>, StationaryInclination> {
    let vertical_rate = poisson(at);
    let (lifted, slow) =
        (top.map(|x| Tangent::moving(Tangent::fixed(x.value), Tangent::fixed(x.slope))), Tangent::fixed);
    let fixed = Attitude { spin: at.spin.map(slow), vertical: at.vertical.map(slow) };
    let under = |moment: Vector3<Tangent<S>>| {
        let found = rates(&lifted, &fixed, slow(axial_speed), moment, vertical_rate.map(slow));
        [found.energy, found.vertical_momentum, found.axial_momentum]
    };
    let columns: [[S; 3]; 3] = std::array::from_fn(|k| {
        let along = |i| if i == k { S::one() } else { S::zero() };
        under(Vector3::from_fn(|i, _| Tangent::moving(S::zero(), along(i)))).map(|rate| rate.slope)
    });
    let matrix = Matrix3::from_columns(&columns.map(Vector3::from));
    let free = Vector3::from(under(Vector3::zeros()).map(|rate| rate.value));
    if determinant(&matrix).is_zero() {
        return Err(StationaryInclination);
    }
    Ok(mechanics::rotation::inverse(&matrix) * (Vector3::from(wanted) - free))
}
