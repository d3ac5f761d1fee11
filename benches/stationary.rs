//! Microseconds to compute all steady motions of a gyrostat with certificates: `cargo bench --bench stationary`. If a
//! number of gyrostats follows `--`, their motions are also found by the box search on a text description of the
//! bodies, and compared: `cargo bench --bench stationary -- 1000`.

#[path = "../tests/physical/mod.rs"]
mod physical;

use algebra::real::Root;
use dalembert_derivations::studies::stationary::energies::{Energies, Kept};
use field::Rational;
use mechanics::steady_rotations::Body;
use physical::steady::compared;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use std::hint::black_box;
use std::time::Instant;

const GYROSTATS: usize = 60;
const REPEATS: usize = 5;

fn main() {
    if let Some(gyrostats) = std::env::args().skip(1).find_map(|word| word.parse().ok()) {
        return compare(gyrostats);
    }
    let mut runner = TestRunner::new(Config { rng_seed: RngSeed::Fixed(1834), ..Config::default() });
    let drawn = (physical::gyrostat(), -400..=400i64, -900..=900i64);
    let draw = |_| drawn.new_tree(&mut runner).expect("data are drawn").current();
    let gyrostats: Vec<_> = (0..GYROSTATS).map(draw).collect();
    println!("per gyrostat, median over {GYROSTATS}, each the fastest of {REPEATS} [us]");
    let bodies: Vec<(Body, Rational)> =
        gyrostats.iter().map(|(g, w, speed)| (body(g, *speed), Rational::new(*w, 10))).collect();
    row("data to W, by differentiation", gyrostats.iter().map(|(g, _, speed)| microseconds(|| body(g, *speed))));
    row("w given: motions, isolated and counted twice", bodies.iter().map(|(b, w)| microseconds(|| b.rotations(*w))));
    row(
        "the same with boxes of 2^-64, disjoint",
        bodies.iter().map(|(b, w)| microseconds(|| b.rotations(*w)?.boxes(64))),
    );
    row("vertical momentum given: all motions", bodies.iter().map(|(b, w)| microseconds(|| b.at_momentum(*w))));
    row("census of all w: folds and counts", bodies.iter().map(|(b, _)| microseconds(|| b.census().ok())));
}

/// Compares the steady motions of a number of gyrostats by both methods.
fn compare(gyrostats: usize) {
    let mut runner = TestRunner::new(Config { rng_seed: RngSeed::Fixed(1834), ..Config::default() });
    let drawn = (physical::gyrostat(), -400..=400i64, -900..=900i64);
    let (mut motions, mut families, mut open, mut boxes) = (0, 0, 0, 0);
    let (mut apart, mut times): (f64, Vec<f64>) = (0.0, Vec::new());
    for k in 0..gyrostats {
        let (g, w, speed) = drawn.new_tree(&mut runner).expect("data are drawn").current();
        let start = Instant::now();
        let Some(both) = compared(&g, Rational::new(w, 10), Rational::new(speed, 10)) else {
            families += 1;
            continue;
        };
        times.push(start.elapsed().as_secs_f64() * 1e3);
        (motions, boxes) = (motions + both.by_polynomial.len(), boxes + both.examined);
        open += usize::from(!both.is_complete);
        match both.distance() {
            Some(distance) if distance < 1e-6 => apart = apart.max(distance),
            distance => println!(
                "gyrostat {k}, w = {w}/10, rotor {speed}/10: {} by the polynomial, {} by boxes, {} apart, complete: {}",
                both.by_polynomial.len(),
                both.by_boxes.len(),
                distance.map_or("not as many".to_owned(), |distance| format!("{distance:.1e}")),
                both.is_complete
            ),
        }
    }
    times.sort_by(f64::total_cmp);
    println!("{gyrostats} gyrostats, {families} of them with families, {motions} motions by the polynomial");
    println!("largest distance of one and the same motion {apart:.1e}; {open} searches not complete; {boxes} boxes");
    if let (Some(middle), Some(last)) = (times.get(times.len() / 2), times.last()) {
        println!("both ways with reading, a gyrostat: {middle:.1} ms, slowest {last:.1} ms");
    }
}

fn body(g: &dalembert_derivations::systems::gyrostat::Gyrostat<Rational>, speed: i64) -> Body {
    let energies = Energies::of(g);
    let (tensor, share) = energies.quadratic(Kept::RelativeSpeed);
    let value = Root::rational(Rational::new(speed, 10)).expect("a fraction");
    Body::new(&tensor, &share, &value, &energies.weight).expect("fractions")
}

fn row(name: &str, times: impl Iterator<Item = f64>) {
    let mut times: Vec<f64> = times.collect();
    times.sort_by(f64::total_cmp);
    println!("{name:<46} {:>9.0}   slowest {:>9.0}", times[times.len() / 2], times[times.len() - 1]);
}

fn microseconds<T>(task: impl Fn() -> T) -> f64 {
    let once = || {
        let start = Instant::now();
        black_box(task());
        start.elapsed().as_secs_f64() * 1e6
    };
    (0..REPEATS).map(|_| once()).fold(f64::INFINITY, f64::min)
}
