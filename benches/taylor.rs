//! Nanoseconds for a series: temporary.
use derivations::machines::multi_current::{MultiCurrent, Windings};
use derivations::machines::synchronous::Synchronous;
use derivations::systems::gyrostat::driven::Driven;
use derivations::systems::gyrostat::{Carrier, Gyrostat, Rotor};
use integrators::Ode;
use nalgebra::{Matrix3, Vector3};
use std::time::Instant;
use symbolic::{Equations, Recurrence, Sym};

fn main() {
    let only = std::env::var("ONLY").is_ok();
    let gyrostat = Gyrostat {
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
    let windings = Windings { field_speed: 30.0, b0: 0.05, a1: 0.01, l1: 0.01, r1: 1.0, a2: 0.01, l2: 0.01, r2: 1.0, mu: 1e-4, f: 1e-4 };
    let single = Synchronous { field_speed: windings.field_speed, b0: windings.b0, f: windings.f };
    let bars = MultiCurrent::evenly(windings, 6);
    let (first, second) = (gyrostat.first_form().0, gyrostat.second_form().0);
    row("second", &Driven::new(second, single));
    if only { return; }
    row("first", &Driven::new(first, single));
    row("second", &Driven::new(second, bars.clone()));
    row("first", &Driven::new(first, bars));
}

struct Source<'a> { e: symbolic::Expansion<'a, f64, 8> }
impl integrators::TaylorSeries<f64> for Source<'_> {
    fn expand(&mut self, t: f64, y: &[f64], _order: usize) { self.e.expand(y, t); }
    fn coefficients(&self, k: usize) -> &[f64] { self.e.coefficients(k) }
    fn sum(&self, h: f64, out: &mut [f64]) { self.e.sum(h, out); }
}

fn row<L: Ode<Sym> + Ode<f64>>(form: &str, law: &L) {
    let n = Ode::<f64>::dimension(law);
    let state: Vec<Sym> = (0..n).map(|i| Sym::symbol(&format!("y{i}"))).collect();
    let mut rates = vec![Sym::ZERO; n];
    law.rates(Sym::ZERO, &state, &mut rates);
    if std::env::args().any(|a| a == "--model") {
        for r in &rates { println!("{r}"); }
        println!();
        return;
    }
    let recurrence = Recurrence::record(&Equations { state: &state, time: None, parameters: &[], rates: &rates }).unwrap();
    println!("{n} {form}");
    let mut y: Vec<f64> = vec![1.0, -2.0, 3.0, 0.6, 0.0, 0.8, 0.3, -1.0];
    y.resize(n, 0.1);
    let run = |tol: f64, order: usize| {
        let source = Source { e: recurrence.expansion::<f64, 8, 256>(&[], order).unwrap() };
        let mut taylor = integrators::Taylor::new(source, &integrators::Tolerance::both(tol)).with_order(order);
        let mut end = y.clone();
        let steps = taylor.propagate(0.0, 2.0, &mut end).unwrap();
        let mut t: Vec<f64> = (0..15).map(|_| { let s = Instant::now(); for _ in 0..20 { end.copy_from_slice(&y); taylor.propagate(0.0, 2.0, &mut end).unwrap(); } s.elapsed().as_secs_f64() / 20.0 * 1e3 }).collect();
        t.sort_by(f64::total_cmp);
        (end, steps, t[7])
    };

    if std::env::var("ONLY").is_ok() {
        if let Ok(order) = std::env::var("ORDER") {
            let order = order.parse().unwrap();
            let source = Source { e: recurrence.expansion::<f64, 8, 256>(&[], order).unwrap() };
            let mut taylor = integrators::Taylor::new(source, &integrators::Tolerance::both(1e-6)).with_order(order);
            let mut end = y.clone();
            let mut steps = 0;
            for _ in 0..std::env::var("ONLY").unwrap().parse::<u32>().unwrap() {
                end.copy_from_slice(&y);
                steps += taylor.propagate(0.0, 2.0, &mut end).unwrap();
            }
            println!("{steps}");
            return;
        }
        let order = 15;
        let mut e = recurrence.expansion::<f64, 8, 256>(&[], order).unwrap();
        for _ in 0..std::env::var("ONLY").unwrap().parse::<u32>().unwrap() { e.expand(&y, 0.0); }
        return;
    }
    let exact = run(1e-16, 40).0;
    for tol in [1e-6, 1e-9, 1e-12, 1e-15] {
        for factor in [0.5, 0.6, 0.7, 0.8] {
            let order = (1.0 - factor * f64::ln(tol)).ceil() as usize;
            let (end, steps, ms) = run(tol, order);
            let error = end.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            println!("  {tol:.0e} order {order}: {steps} steps, {ms:.4} ms, {:.0} ns a step, error {error:.1e}", ms * 1e6 / steps as f64);
        }
    }
}
