//! A symmetric top under the moments that lead its integrals: Mukharlyamov's inverse problem as a run.

use super::{Amiss, Diagnosis, Ended, Mechanism};
use field::{Analytic, Over, Rational, Scalar};
use reader::Quantity;
use simulation::Margin;
use systems::variable_top::{Attitude, StationaryInclination, Top, poisson, prescribing};

reader::quantities! {
    /// The top, the axial speed that is aimed at, and how fast each integral goes to zero: f' = -k f.
    pub struct PrescribedTop {
        /// A, moment of inertia across the axis
        equatorial: "kg m^2" > 0,
        /// C, moment of inertia about the axis
        axial: "kg m^2" > 0,
        /// M z_c, static moment
        static_moment: "kg m",
        /// nu, moment of momentum of the gyroscope
        gyroscope: "N m s",
        /// g, acceleration of gravity
        gravity: "m/s^2",
        /// r_0, axial speed that is aimed at
        aim: "rad/s",
        /// k, rate at which the integrals are led to zero
        gain: "1/s",
    }
}

/// The share of its first value below which p g2 - q g1 is no coincidence.
const NEAR: f64 = 1e-2;

impl PrescribedTop<f64> {
    fn top<S: Over<f64>>(&self) -> Top<S> {
        let PrescribedTop { equatorial, axial, static_moment, gyroscope, gravity, .. } = self.map(S::lift);
        Top { equatorial, axial, static_moment, gyroscope, gravity, tide: S::zero() }
    }

    /// The moment that leads the integrals.
    ///
    /// # Errors
    /// [`StationaryInclination`] where p g2 = q g1 exactly.
    pub fn moment<S: Over<f64>>(&self, at: &Attitude<S>) -> Result<nalgebra::Vector3<S>, StationaryInclination> {
        let (top, aim, rate) = (self.top::<S>(), S::lift(self.aim), -S::lift(self.gain));
        let now = top.integrals(at, aim);
        let wanted = [now.energy, now.vertical_momentum, now.axial_momentum].map(|integral| rate * integral);
        prescribing(&top.fixed(), at, aim, wanted)
    }
}

/// (p, q, r), gamma of a slice.
pub fn attitude<S: Scalar>(y: &[S]) -> Attitude<S> {
    Attitude { spin: nalgebra::Vector3::new(y[0], y[1], y[2]), vertical: nalgebra::Vector3::new(y[3], y[4], y[5]) }
}

/// p g2 - q g1: the rate of the axis' inclination.
pub fn nodding<S: Scalar>(y: &[S]) -> S {
    y[0] * y[4] - y[1] * y[3]
}

impl Mechanism for PrescribedTop<f64> {
    const NAME: &'static str = "prescribed_top";
    const SUMMARY: &'static str = "a symmetric top under the moments that lead its integrals, after Mukharlyamov";
    const STATE: &'static [Quantity] = &[
        Quantity::any("p", "rad/s", "angular velocity across the axis"),
        Quantity::any("q", "rad/s", "angular velocity across the axis, the other"),
        Quantity::any("r", "rad/s", "angular velocity about the axis"),
        Quantity::any("g1", "1", "component of the vertical across the axis"),
        Quantity::any("g2", "1", "component of the vertical across the axis, the other"),
        Quantity::any("g3", "1", "component of the vertical along the axis"),
    ];
    const SHOWN: &'static [Quantity] = &[Quantity::any("nodding", "rad/s", "p g2 - q g1, by which the moments divide")];

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        PrescribedTop::read(source)
    }

    fn rates<S: Over<f64> + Analytic>(&self, _time: S, y: &[S], dy: &mut [S]) {
        let at = attitude(y);
        let Ok(moment) = self.moment(&at) else {
            dy.fill(S::zero() / S::zero());
            return;
        };
        dy[..3].copy_from_slice(self.top::<S>().acceleration(at.spin, moment).as_slice());
        dy[3..].copy_from_slice(poisson(&at).as_slice());
    }

    fn energy<S: Over<f64> + Analytic>(&self, _time: S, y: &[S]) -> S {
        let at = attitude(y);
        self.top::<S>().kinetic_energy(at.spin) - self.top::<S>().force_function(at.vertical)
    }

    /// Of what the moments add to those of the field.
    fn power<S: Over<f64> + Analytic>(&self, _time: S, y: &[S]) -> S {
        let at = attitude(y);
        let field = self.top::<S>().moment_of_field(at.vertical);
        self.moment(&at).map_or(S::zero() / S::zero(), |moment| (moment - field).dot(&at.spin))
    }

    fn shown(&self, _time: f64, y: &[f64]) -> Vec<f64> {
        vec![nodding(y)]
    }

    fn margins(&self, start: &[f64], y: &[f64], dy: &[f64]) -> Vec<Margin> {
        let sign = nodding(start).signum();
        let rate = dy[0] * y[4] + y[0] * dy[4] - dy[1] * y[3] - y[1] * dy[3];
        let what = "p g2 = q g1: the inclination of the axis is stationary, and no moment leads the integrals";
        vec![Margin { value: sign * nodding(y), rate: sign * rate, what, ..Margin::default() }]
    }

    /// By the decimals that were written: in doubles equal products may differ.
    fn amiss(&self, start: &[f64]) -> Vec<Amiss> {
        let exact: Vec<Rational> = start.iter().map(|value| Rational::decimal(*value)).collect();
        let what = "p g2 = q g1: the inclination of the axis is stationary, and no moment leads the integrals";
        let accepted = "a start with p g2 other than q g1 is accepted".to_owned();
        let stationary = nodding(&exact).sign() == Some(0);
        stationary.then_some(Amiss { name: "g2", what, accepted }).into_iter().collect()
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let what = "p g2 = q g1: the inclination of the axis becomes stationary, where the moments that lead the integrals \
                    are infinite";
        (run.left || nodding(run.last).abs() < NEAR * nodding(run.start).abs()).then_some(Diagnosis { what, at: None })
    }
}
