//! Error estimate of a collocation step from the defect of the collocation polynomial.
//!
//! The defect d = u' - f(u) of the polynomial u is evaluated where it is not zero: at the end of the step for Gauss, at
//! its start for Radau IIA, whose end is a node. Over the step the defect is proportional to the nodal polynomial M. By
//! the formula of Alekseev and Groebner the error at the end is h int M(t) exp(z (1 - t)) dt d with z = h J and M
//! scaled to 1 at that point. M is orthogonal to all polynomials below degree m (s for Gauss, s - 1 for Radau IIA). For
//! small z the integral is a z^m with a = c / prod_{k <= m} 2 (2 k - 1), where c = 1 / (2 s + 1) for Gauss and
//! c = 1 / (2 (2 s - 1)) for Radau. For large z it is 1 / z for Gauss, and s / z^2 for Radau, whose M is zero at the
//! end. With w = z / (1 - g z) and the pole 1 / g of the present factorisation, the function
//!
//!   w^m (a - b w) / (1 - g z)^p,  p = 1 or 2,
//!
//! has both limits. Fast decaying modes then do not hide the order of the slow ones.

use crate::methods::implicit::collocation::Family;

/// The coefficients of the rational function.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DefectSpread {
    /// The degree m.
    pub degree: usize,
    /// The exponent p.
    pub filters: usize,
    /// The coefficient a.
    pub small: f64,
    /// The coefficient b.
    pub large: f64,
    /// The coefficient c: the component along M of a defect that varies over the step.
    pub plain: f64,
}

impl DefectSpread {
    /// The function with the pole 1 / g, where g is `pole`.
    pub fn new(family: Family, stages: usize, pole: f64) -> Self {
        let (spread, limit) = DefectSpread::limits(family, stages);
        let large = (limit * pole.powi((spread.degree + spread.filters) as i32) - spread.small).max(0.0) * pole;
        DefectSpread { large, ..spread }
    }

    /// The value of g for which b is zero.
    pub fn pole(family: Family, stages: usize) -> f64 {
        let (spread, limit) = DefectSpread::limits(family, stages);
        (spread.small / limit).powf(1.0 / (spread.degree + spread.filters) as f64)
    }

    /// The coefficients with b = 0, and the limit of the integral times z^p for large z.
    fn limits(family: Family, stages: usize) -> (Self, f64) {
        let (degree, filters, plain, limit) = match family {
            Family::Gauss => (stages, 1, 1.0 / (2 * stages + 1) as f64, 1.0),
            Family::RadauIIA => (stages - 1, 2, 1.0 / (2 * (2 * stages - 1)) as f64, stages as f64),
        };
        let small = (1..=degree).fold(plain, |small, k| small / (2 * (2 * k - 1)) as f64);
        (DefectSpread { degree, filters, small, large: 0.0, plain }, limit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::implicit::collocation::{Collocation, nodal};
    use crate::methods::implicit::stage_matrix::StageMatrix;

    /// The integral int M(t) exp(z (1 - t)) dt over (0, 1) by Simpson's rule, with M = 1 where the defect is evaluated.
    fn exact(family: Family, stages: usize, z: f64) -> f64 {
        let seen = if family == Family::Gauss { 1.0 } else { 0.0 };
        let value = |t: f64| nodal(family, stages, t) / nodal(family, stages, seen) * (z * (1.0 - t)).exp();
        let parts = 20_000;
        let weight = |k: usize| {
            if k == 0 || k == parts {
                1.0
            } else if k % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        (0..=parts).map(|k| weight(k) * value(k as f64 / parts as f64)).sum::<f64>() / (3 * parts) as f64
    }

    #[test]
    fn the_rational_function_is_near_the_integral_at_every_stiffness() {
        for family in [Family::Gauss, Family::RadauIIA] {
            for stages in 1..=5 {
                let matrix = Collocation::<f64>::new(family, stages).matrix;
                let pole = StageMatrix::new(matrix, 1, false, DefectSpread::pole(family, stages)).pole();
                let spread = DefectSpread::new(family, stages, pole);
                for z in [-0.3, -1.0, -3.0, -10.0, -30.0, -100.0, -1e3] {
                    let w = z / (1.0 - pole * z);
                    let found = w.powi(spread.degree as i32) * (spread.small - spread.large * w)
                        / (1.0 - pole * z).powi(spread.filters as i32);
                    let ratio = (found / exact(family, stages, z)).abs();
                    assert!((0.5..1.5).contains(&ratio), "{family:?}, {stages} stages, z = {z}: {ratio}");
                }
            }
        }
    }
}
