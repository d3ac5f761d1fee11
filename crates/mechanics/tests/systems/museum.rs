//! Published errors, tested so that they remain detected.
//!
//! If Appell's equations are obtained by writing q'' for q' in the kinetic energy, all terms in the velocities are
//! lost. A particle in polar coordinates must give m (r'' - r th'^2) = Q_r.

use dalembert_mechanics::appell::appell;
use dalembert_mechanics::differentiate::along;
use field::{Analytic, Tangent};
use proptest::prelude::*;

/// The acceleration energy S = m/2 |a|^2 of a particle at (r cos th, r sin th), from the position differentiated twice
/// along the motion.
fn acceleration_energy(m: f64, q: [f64; 2], dq: [f64; 2], ddq: [Tangent<f64>; 2]) -> Tangent<f64> {
    type Once = Tangent<Tangent<f64>>;
    let state: [Once; 2] = std::array::from_fn(|i| Tangent::moving(Tangent::fixed(q[i]), Tangent::fixed(dq[i])));
    let rate: [Once; 2] = std::array::from_fn(|i| Tangent::moving(Tangent::fixed(dq[i]), ddq[i]));
    let [r, th] = along(state, rate);
    let point = th.circle();
    let a = [r * point.cos, r * point.sin].map(|x| x.slope.slope);
    (a[0] * a[0] + a[1] * a[1]) * Tangent::fixed(m / 2.0)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, rng_seed: proptest::test_runner::RngSeed::Fixed(7), ..Default::default() })]

    #[test]
    fn a_polar_particle_keeps_its_centrifugal_and_coriolis_terms(
        m in 0.1..5.0, r in 0.1..3.0, th in -3.0..3.0, dr in -2.0..2.0, dth in -2.0..2.0, ddr in -2.0..2.0, ddth in -2.0..2.0,
    ) {
        let by_appell = appell(|a| acceleration_energy(m, [r, th], [dr, dth], a), [ddr, ddth]);
        let expected = [m * (ddr - r * dth * dth), m * (r * r * ddth + 2.0 * r * dr * dth)];
        for (derived, known) in by_appell.into_iter().zip(expected) {
            prop_assert!((derived - known).abs() < 1e-12 * (1.0 + known.abs()));
        }
        // the error: T with q'' for q'
        let wrong = appell(
            |[a, b]| (a * a + b * b * Tangent::fixed(r * r)) * Tangent::fixed(m / 2.0),
            [ddr, ddth],
        );
        prop_assume!((r * dth * dth).abs() > 1e-3);
        prop_assert!((wrong[0] - expected[0]).abs() > 1e-4 * m);
    }
}
