//! A symmetric body of variable mass with a gyroscope on its axis, about a fixed point in a Newtonian field.
//!
//! Axes of the body: z along the axis of symmetry. (p, q, r) is the angular velocity, gamma the unit vector from the
//! attracting centre, at the distance R, to the fixed point, nu the gyroscope's constant angular momentum along z.
//! A = B, C and the static moment M z_c are functions of the time; body and fuel are taken as solidified at the instant,
//! and the action of ejected and of internally moving mass is a torque besides the given ones.
//!
//!   G = (A p, A q, C r + nu),   2 T = A (p^2 + q^2) + C r^2,
//!   U = -g M z_c gamma_3 - 1/2 kappa (A gamma_1^2 + A gamma_2^2 + C gamma_3^2),   g = mu/R^2, kappa = 3 mu/R^3.

use field::{Scalar, Tangent};
use mechanics::differentiate::gradient;
use mechanics::momentum::absolute_rate;
use mechanics::rotation::determinant;
use nalgebra::{Matrix3, Vector3};

/// The body at an instant; over tangents, with the rates of the varying data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Top<S> {
    /// A = B, kg m^2
    pub equatorial: S,
    /// C, kg m^2
    pub axial: S,
    /// M z_c, kg m
    pub static_moment: S,
    /// nu, kg m^2/s
    pub gyroscope: S,
    /// g = mu/R^2, m/s^2
    pub gravity: S,
    /// kappa = 3 mu/R^3 = 3 g/R, 1/s^2
    pub tide: S,
}

/// The body's angular velocity, and the vertical in its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude<S: Scalar> {
    /// (p, q, r), 1/s
    pub spin: Vector3<S>,
    /// gamma
    pub vertical: Vector3<S>,
}

/// The prescribed integrals: 2(T - U) up to a constant of the field, G.gamma, C (r - r_0), gamma.gamma - 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrals<S> {
    pub energy: S,
    pub vertical_momentum: S,
    pub axial_momentum: S,
    pub length: S,
}

/// The torques that produce prescribed rates of the integrals do not exist, or are not unique.
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
    /// The solidified body: constant parameters.
    pub fn fixed(self) -> Top<Tangent<S>> {
        self.map(Tangent::fixed)
    }

    /// G
    pub fn momentum(&self, spin: Vector3<S>) -> Vector3<S> {
        Vector3::new(self.equatorial * spin.x, self.equatorial * spin.y, self.axial * spin.z + self.gyroscope)
    }

    /// T without the gyroscope's own.
    pub fn kinetic_energy(&self, spin: Vector3<S>) -> S {
        (self.equatorial * (spin.x.squared() + spin.y.squared()) + self.axial * spin.z.squared()).half()
    }

    /// U
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

    /// dG/dt + w x G - torque of the solidified body: vanishes along the motion.
    pub fn residual(&self, spin: Vector3<S>, acceleration: Vector3<S>, moment: Vector3<S>) -> Vector3<S> {
        let moving = spin.zip_map(&acceleration, Tangent::moving);
        absolute_rate(self.fixed().momentum(moving), spin) - moment
    }

    /// (p', q', r') under a torque; A and C must not vanish.
    pub fn acceleration(&self, spin: Vector3<S>, moment: Vector3<S>) -> Vector3<S> {
        let missing = self.residual(spin, Vector3::zeros(), moment);
        Vector3::new(-missing.x / self.equatorial, -missing.y / self.equatorial, -missing.z / self.axial)
    }

    /// The integrals, with the field's part zero for gamma orthogonal to the axis; r_0 is the prescribed axial speed.
    pub fn integrals(&self, at: &Attitude<S>, axial_speed: S) -> Integrals<S> {
        let across = Vector3::new(S::one(), S::zero(), S::zero());
        let field = self.force_function(at.vertical) - self.force_function(across);
        // terms with gamma.gamma - 1 in the field's energy vanish on the motion; 2 (T - U) contains gamma_3 alone
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

/// gamma' = gamma x w: the vertical is at rest in space.
pub fn poisson<S: Scalar>(at: &Attitude<S>) -> Vector3<S> {
    at.vertical.cross(&at.spin)
}

/// The rates of the integrals under a torque, with gamma' given.
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

/// The inverse problem: the torque under which energy, vertical and axial momentum change at prescribed rates.
///
/// # Errors
/// [`StationaryInclination`] where p gamma_2 = q gamma_1 exactly.
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
