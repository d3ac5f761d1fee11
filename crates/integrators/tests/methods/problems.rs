//! Nonlinear problems with known solutions, each written once for all scalar types.

use dalembert_integrators::{Index2Dae, Index2DaeSystem, Ode, Real, System};
use field::{Analytic, DoubleDouble, Over};

/// Kepler's problem q'' = -q / |q|^3, with semi-major axis 1 and the pericentre at t = 0.
pub struct Kepler {
    pub eccentricity: f64,
}

impl<S: Over<f64> + Analytic> Ode<S> for Kepler {
    fn dimension(&self) -> usize {
        4
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        let square = y[0] * y[0] + y[1] * y[1];
        let cube = square * square.sqrt();
        dy[0] = y[2];
        dy[1] = y[3];
        dy[2] = -y[0] / cube;
        dy[3] = -y[1] / cube;
    }
}

impl System for Kepler {}

impl Kepler {
    /// The state at t by Kepler's equation u - e sin u = t, solved by Newton's iteration in the same scalar type.
    pub fn state<S: Real>(&self, t: f64) -> Vec<S> {
        let (t, e) = (S::lift(t), S::lift(self.eccentricity));
        let mut u = t;
        for _ in 0..60 {
            let point = u.circle();
            u -= (u - e * point.sin - t) / (S::one() - e * point.cos);
        }
        let (point, minor) = (u.circle(), (S::one() - e * e).sqrt());
        let speed = S::one() / (S::one() - e * point.cos);
        vec![point.cos - e, minor * point.sin, -point.sin * speed, minor * point.cos * speed]
    }
}

/// A number of independent pendulums: theta'' = -sin theta.
pub struct Pendula(pub usize);

impl<S: Analytic> Ode<S> for Pendula {
    fn dimension(&self) -> usize {
        2 * self.0
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        let (angles, speeds) = y.split_at(self.0);
        dy[..self.0].copy_from_slice(speeds);
        dy[self.0..].iter_mut().zip(angles).for_each(|(rate, angle)| *rate = -angle.circle().sin);
    }
}

impl System for Pendula {}

/// The pendulum theta'' = -omega^2 sin theta.
pub struct Pendulum {
    pub frequency: f64,
}

impl<S: Over<f64> + Analytic> Ode<S> for Pendulum {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[1];
        dy[1] = -S::lift(self.frequency * self.frequency) * y[0].circle().sin;
    }
}

impl System for Pendulum {}

impl Pendulum {
    pub fn energy<S: Real>(&self, y: &[S]) -> S {
        (y[1] * y[1]).half() - S::lift(self.frequency * self.frequency) * y[0].circle().cos
    }
}

/// Kaps' stiff problem y1' = -(lambda + 2) y1 + lambda y2^2, y2' = y1 - y2 - y2^2, with the solution y1 = y2^2, y2 =
/// e^-t.
pub struct Kaps {
    pub lambda: f64,
}

impl<S: Over<f64> + Analytic> Ode<S> for Kaps {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        let lambda = S::lift(self.lambda);
        dy[0] = -(lambda + S::int(2)) * y[0] + lambda * y[1] * y[1];
        dy[1] = y[0] - y[1] - y[1] * y[1];
    }
}

impl System for Kaps {}

impl Kaps {
    pub fn state(t: f64) -> Vec<DoubleDouble> {
        let decayed = (-DoubleDouble::from(t)).exp();
        vec![decayed * decayed, decayed]
    }
}

/// Prothero and Robinson's problem y' = -rate (y - cos t) - sin t, with the solution y = cos t for any rate.
pub struct ProtheroRobinson {
    pub rate: f64,
}

impl<S: Over<f64> + Analytic> Ode<S> for ProtheroRobinson {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let point = t.circle();
        dy[0] = -S::lift(self.rate) * (y[0] - point.cos) - point.sin;
    }
}

impl System for ProtheroRobinson {}

/// The problem y' = y^2, y(0) = 1, with the solution 1 / (1 - t), which is infinite at t = 1.
pub struct Explosion;

impl<S: Over<f64> + Analytic> Ode<S> for Explosion {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        dy[0] = y[0] * y[0];
    }
}

impl System for Explosion {}

/// The problem y' = -sqrt(y - t / 10), y(0) = 1: the rate is undefined once y has decreased to t / 10, at about t =
/// 1.52.
pub struct Funnel;

impl<S: Over<f64> + Analytic> Ode<S> for Funnel {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        dy[0] = -(y[0] - t * S::lift(0.1)).sqrt();
    }
}

impl System for Funnel {}

/// The problem y' = cos(t) y^2, y(0) = 1/2, with the solution y = 1 / (2 - sin t).
pub struct Drive;

impl<S: Over<f64> + Analytic> Ode<S> for Drive {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        dy[0] = t.circle().cos * y[0] * y[0];
    }
}

impl System for Drive {}

impl Drive {
    pub fn state(t: f64) -> f64 {
        1.0 / (2.0 - t.sin())
    }
}

/// Lorenz' equations: the distance of neighbouring solutions grows tenfold in about 2.5 units of time.
pub struct Lorenz;

impl<S: Over<f64> + Analytic> Ode<S> for Lorenz {
    fn dimension(&self) -> usize {
        3
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        dy[0] = S::int(10) * (y[1] - y[0]);
        dy[1] = y[0] * (S::int(28) - y[2]) - y[1];
        dy[2] = y[0] * y[1] - S::ratio(8, 3) * y[2];
    }
}

impl System for Lorenz {}

/// The problem y' = rate * y: constant for the rate 0, and beyond all resolution for the rate 1e200.
pub struct Growth {
    pub rate: f64,
}

impl<S: Over<f64> + Analytic> Ode<S> for Growth {
    fn dimension(&self) -> usize {
        3
    }

    fn rates(&self, _: S, y: &[S], dy: &mut [S]) {
        dy.iter_mut().zip(y).for_each(|(dy, y)| *dy = S::lift(self.rate) * *y);
    }
}

impl System for Growth {}

/// A chain of `bars` pendulums of slightly different lengths, each of which drives the next one; the first is driven by
/// a function of time.
pub struct Chain {
    pub bars: usize,
    pub frequency: f64,
}

impl<S: Over<f64> + Analytic> Ode<S> for Chain {
    fn dimension(&self) -> usize {
        2 * self.bars
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let square = S::lift(self.frequency * self.frequency);
        let mut pull = t.circle().sin;
        for bar in 0..self.bars {
            let (angle, speed) = (y[2 * bar], y[2 * bar + 1]);
            let point = angle.circle();
            dy[2 * bar] = speed;
            dy[2 * bar + 1] = square * (pull * S::ratio(1, 8) - point.sin) / S::ratio(bar as i64 + 8, 8);
            pull = point.cos * point.sin;
        }
    }
}

impl System for Chain {}

/// The largest difference between two states, relative to the magnitude of the second.
pub fn distance<S: Real>(a: &[S], b: &[S]) -> f64 {
    let size = b.iter().map(|b| b.approx().abs()).fold(f64::MIN_POSITIVE, f64::max);
    a.iter().zip(b).map(|(a, b)| (*a - *b).approx().abs()).fold(0.0, f64::max) / size
}

/// A point on the unit circle at the angle t + 0.3 sin t, under a tangential force and friction, with the constraint on
/// position and that on velocity: y = (q, v), q' = v + q mu, v' = F + q lambda, |q|^2 = 1, q.v = 0 (Gear, Gupta,
/// Leimkuhler).
pub struct Rim;

const DRAG: f64 = 0.5;

impl Rim {
    pub fn state<S: Real>(t: f64) -> Vec<S> {
        let point = S::lift(t).circle();
        let at = (S::lift(t) + S::lift(0.3) * point.sin).circle();
        let speed = S::one() + S::lift(0.3) * point.cos;
        vec![at.cos, at.sin, -at.sin * speed, at.cos * speed]
    }
}

impl<S: Over<f64> + Analytic> Index2Dae<S> for Rim {
    fn sizes(&self) -> (usize, usize) {
        (4, 2)
    }

    fn rates(&self, t: S, y: &[S], z: &[S], dy: &mut [S]) {
        let (now, drag) = (t.circle(), S::lift(DRAG));
        let push = drag * (S::one() + S::lift(0.3) * now.cos) - S::lift(0.3) * now.sin;
        dy[0] = y[2] + y[0] * z[0];
        dy[1] = y[3] + y[1] * z[0];
        dy[2] = -push * y[1] - drag * y[2] + y[0] * z[1];
        dy[3] = push * y[0] - drag * y[3] + y[1] * z[1];
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], columns: &mut [S]) {
        let none = S::zero();
        self.rates(t, y, &[none; 2], dy);
        columns.copy_from_slice(&[y[0], y[1], none, none, none, none, y[0], y[1]]);
    }

    fn constraints(&self, _: S, y: &[S], g: &mut [S]) {
        g[0] = (y[0] * y[0] + y[1] * y[1] - S::one()).half();
        g[1] = y[0] * y[2] + y[1] * y[3];
    }
}

impl Index2DaeSystem for Rim {}

/// The same point with the Lagrange multiplier from the twice differentiated constraint, so that the constraint drifts.
pub struct LooseRim;

impl<S: Over<f64> + Analytic> Ode<S> for LooseRim {
    fn dimension(&self) -> usize {
        4
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        Rim.rates(t, y, &[S::zero(); 2], dy);
        let lacking = y[2] * y[2] + y[3] * y[3] + y[0] * dy[2] + y[1] * dy[3];
        let lambda = -lacking / (y[0] * y[0] + y[1] * y[1]);
        dy[2] += lambda * y[0];
        dy[3] += lambda * y[1];
    }
}

impl System for LooseRim {}
