//! Lagrange's top with a rotor along its axis, in closed form: a reference solution for long integrations.
//!
//! Consider a gyrostat with the transverse moment of inertia A (about O), whose weight G and free rotor lie along its
//! axis of symmetry l. It conserves the momenta X = x.l and k = x.v, and the energy h = A |w|^2/2 - G u with the
//! component of w perpendicular to l. Then u = v.l satisfies
//!
//!   A^2 u'^2 = 2 A (1 - u^2) (h + G u) - (k - X u)^2 = 2 A G (u - u1) (u - u2) (u3 - u) ,   u1 < -1 <= u2 <= u <= u3 <= 1 :
//!
//!   u = u3 - (u3 - u2) sn^2(n t + a | m) ,   n^2 = G (u3 - u1)/(2 A) ,   m = (u3 - u2)/(u3 - u1) ,
//!
//! with the period 2 K(m)/n (Whittaker, Analytical Dynamics, art. 71; here the vertical points downwards).

use nalgebra::Vector3;

/// A nutation that starts at an extremum of u, so that u' = 0 at time zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nutation {
    /// The period of u, s.
    pub period: f64,
    /// The values of u and u' a quarter of a period after the start.
    pub quarter: (f64, f64),
}

/// The data of a top: A, G, l and X.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Top {
    pub transverse: f64,
    pub weight: f64,
    pub axis: Vector3<f64>,
    pub spin: f64,
}

impl Top {
    /// The nutation from w and v, where l, w and v lie in one plane; `None` if u is constant or G is not positive.
    pub fn nutation(&self, w: Vector3<f64>, v: Vector3<f64>) -> Option<Nutation> {
        let Top { transverse: a, weight: g, axis, spin } = *self;
        let (u, along) = (v.dot(&axis), w.dot(&axis));
        let across = w - axis * along;
        let (k, h) = (a * across.dot(&v) + spin * u, 0.5 * a * across.dot(&across) - g * u);
        // the cubic divided by -2 A G (u - start): u^2 + b u + c
        let scale = 2.0 * a * g;
        let b = (2.0 * a * h + spin * spin) / scale + u;
        let c = u * b - 1.0 - 2.0 * k * spin / scale;
        let first = -0.5 * (b + b.signum() * (b * b - 4.0 * c).sqrt());
        let mut roots = [u, first, c / first];
        roots.sort_by(f64::total_cmp);
        let [u1, u2, u3] = roots;
        let n = (0.5 * g * (u3 - u1) / a).sqrt();
        let complement = ((u2 - u1) / (u3 - u1)).sqrt();
        let half_way = u3 - (u3 - u2) / (1.0 + complement);
        let speed = 2.0 * n * ((half_way - u1) * (half_way - u2) * (u3 - half_way) / (u3 - u1)).sqrt();
        let period = std::f64::consts::PI / (n * mean(1.0, complement));
        let quarter = (half_way, if u == u3 { -speed } else { speed });
        (g > 0.0 && u3 > u2 && period.is_finite()).then_some(Nutation { period, quarter })
    }
}

/// The arithmetic-geometric mean; K(m) = pi / (2 mean(1, sqrt(1 - m))).
fn mean(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 4.0 * f64::EPSILON * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}
