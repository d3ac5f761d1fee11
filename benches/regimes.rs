//! Microseconds to decide all contact regimes at a state, in f64 and in exact arithmetic: `cargo bench --bench
//! regimes`.

use dalembert_derivations::systems::ladder::Ladder;
use dalembert_derivations::systems::slender_rod::SlenderRod;
use field::{Base, Over, Rational};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Dry, Ordered, Sizes, Touch, touches, verdict};
use std::hint::black_box;
use std::time::Instant;

const REPEATS: usize = 9;

fn main() {
    println!("system  state    f64 [us]  exact [us]");
    for (name, spin) in [("sliding", 1), ("at rest", 0)] {
        row("rod", name, rod::<f64>(spin), rod::<Rational>(spin));
        row("ladder", name, ladder::<f64>(spin), ladder::<Rational>(spin));
    }
}

fn row(system: &str, state: &str, rounded: f64, exact: f64) {
    println!("{system:<7} {state:<8} {rounded:>8.2} {exact:>11.2}");
}

fn ladder<S: Base + Over<S> + Ordered>(spin: i64) -> f64 {
    let (l, third, f) = (S::one(), S::ratio(1, 3), S::ratio(3, 10));
    let ladder = Ladder { mass: l, inertia: third, half_length: l, gravity: S::ratio(981, 100), friction: [f; 2] };
    let (c, s, w) = (S::ratio(4, 5), S::ratio(3, 5), S::int(spin));
    let at = State { time: S::zero(), place: [s, c, c, s], velocity: [w * c, -w * s, -w * s, w * c] };
    microseconds::<_, S, 2>(&ladder, &at)
}

fn rod<S: Base + Over<S> + Ordered>(spin: i64) -> f64 {
    let (l, third, f) = (S::one(), S::ratio(1, 3), S::ratio(3, 10));
    let rod = SlenderRod { mass: l, inertia: third, half_length: l, gravity: S::ratio(981, 100), friction: f };
    let (c, s, w) = (S::ratio(4, 5), S::ratio(3, 5), S::int(spin));
    let at = State { time: S::zero(), place: [c, s, c, s], velocity: [w - w * s, w * c, -w * s, w * c] };
    microseconds::<_, S, 1>(&rod, &at)
}

/// The time of the fastest repetition, which is the least disturbed by other processes.
fn microseconds<Q, S, const K: usize>(system: &Q, at: &State<S, 4>) -> f64
where
    Q: Contacts<4, 1, K>,
    S: Over<Q::Given> + Ordered,
{
    const CALLS: u32 = 2000;
    let decide = || {
        let at = black_box(at);
        let touch: Option<[Touch; K]> = touches(system, at, Sizes::of(at)).ok();
        let dry = Dry::<S, K>::of(system, at, system.force(at)).ok();
        dry.zip(touch).map(|(dry, touch)| verdict(&dry, &touch))
    };
    let once = || {
        let start = Instant::now();
        for _ in 0..CALLS {
            let _ = black_box(decide());
        }
        start.elapsed().as_secs_f64() * 1e6 / f64::from(CALLS)
    };
    (0..REPEATS).map(|_| once()).fold(f64::INFINITY, f64::min)
}
