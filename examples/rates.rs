use derivations::machines::{
    multi_current::{MultiCurrent, Windings},
    synchronous::Synchronous,
};
use derivations::systems::gyrostat::{Carrier, Gyrostat, Rotor, driven::Driven};
use nalgebra::{Matrix3, Vector3};
use std::time::Instant;
fn main() {
    let g = Gyrostat {
        carrier: Carrier {
            mass: 1.5,
            centre: Vector3::new(0.01, -0.02, 0.05),
            inertia: Matrix3::new(0.02, 0.001, -0.002, 0.001, 0.03, 0.0005, -0.002, 0.0005, 0.025),
        },
        rotor: Rotor {
            mass: 0.4,
            centre: Vector3::new(0.0, 0.03, 0.04),
            axis: Vector3::new(2.0, -1.0, 2.0) / 3.0,
            axial: 3e-4,
            transverse: 2e-4,
        },
        gravity: 9.81,
    };
    let (first, _) = g.first_form();
    let (second, _) = g.second_form();
    let sync = Synchronous { field_speed: 300.0, b0: 0.5, f: 1e-4 };
    let w = Windings {
        field_speed: 300.0,
        b0: 0.5,
        a1: 0.01,
        l1: 0.01,
        r1: 1.0,
        a2: 0.01,
        l2: 0.01,
        r2: 1.0,
        mu: 1e-4,
        f: 1e-4,
    };
    bench("8 first", &Driven::new(first, sync));
    bench("8 second", &Driven::new(second, sync));
    bench("15 first", &Driven::new(first, MultiCurrent::evenly(w, 6)));
    bench("15 second", &Driven::new(second, MultiCurrent::evenly(w, 6)));
}
fn bench<F: derivations::systems::gyrostat::forms::Form<f64>, M: derivations::machines::Machine<f64>>(
    name: &str,
    d: &Driven<f64, F, M>,
) {
    let n = d.dimension();
    let mut y: Vec<f64> = (0..n).map(|i| 0.1 + i as f64 * 0.05).collect();
    let mut dy = vec![0.0; n];
    let mut best = f64::MAX;
    for _ in 0..7 {
        let t = Instant::now();
        for _ in 0..1_000_000 {
            d.rates(&y, &mut dy);
            y[0] += 1e-12 * dy[0];
        }
        best = best.min(t.elapsed().as_secs_f64());
    }
    println!("{name}: {:.1} ns", best * 1e3);
    let mut yd: Vec<num_dual::DualSVec64<8>> = y.iter().map(|&x| num_dual::DualSVec64::from(x)).collect();
    let mut dyd = yd.clone();
    let t = Instant::now();
    for _ in 0..100_000 {
        d.rates(&yd, &mut dyd);
        yd[0] += dyd[0] * 1e-12;
    }
    println!("   duals of 8: {:.1} ns", t.elapsed().as_secs_f64() * 1e4);
}
