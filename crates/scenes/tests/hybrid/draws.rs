//! Systems with random parameters, each run with four methods at three tolerances.

use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene};

pub const DRAWS: u64 = 200;
const METHODS: [Method; 4] = [Method::Taylor, Method::DormandPrince8, Method::DormandPrince5, Method::Radau5];
const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];

/// A deterministic generator of pseudo-random numbers (splitmix64).
pub struct Draw(u64);

impl Draw {
    pub fn new(seed: u64, number: u64) -> Self {
        Draw(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ number)
    }

    /// A uniformly distributed number between two bounds.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + (high - low) * ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn array<const N: usize>(&mut self, low: f64, high: f64) -> [f64; N] {
        std::array::from_fn(|_| self.between(low, high))
    }
}

/// Runs a system with every method at every tolerance. Each run must reach its end and agree with the closed form within `within` tolerances and
/// a rounding error.
pub fn ends_at(text: &str, known: &[(&str, f64)], within: f64) {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let problem = scene.problem(scene.run().choice().axes);
    for method in METHODS {
        for tolerance in TOLERANCES {
            let choice = Choice { method, tolerance, ..scene.run().choice() };
            let run = problem.simulate(&choice, |_| {});
            assert_eq!(run.stopped(), None, "{method:?} {tolerance:e} at {}\n{text}", run.outcome.time);
            for (name, value) in known {
                let found = run.last[run.column(name).unwrap()];
                let error = (found - value).abs() / value.abs().max(1.0);
                assert!(
                    error <= within * tolerance + 1e-11,
                    "{method:?} {tolerance:e}: {name} = {found}, and not {value}\n{text}"
                );
            }
        }
    }
}

/// The text of bodies on a line: coordinate, mass (kg) and force of each, and further tables.
pub fn on_a_line(bodies: &[(&str, f64, &str)], rest: &str) -> String {
    let coordinates: String = bodies.iter().map(|(name, ..)| format!("{name} = \"m\"\n")).collect();
    let bodies: String = bodies
        .iter()
        .map(|(name, mass, force)| {
            format!(
                "[bodies.of_{name}]\ncentre = \"O + {name}*N.x\"\nmass = \"({mass} kg)\"\n\
                 [[force]]\nalong = \"{name}\"\nis = \"{force}\"\n"
            )
        })
        .collect();
    format!("title = \"Bodies on a line\"\n[coordinates]\n{coordinates}{bodies}{rest}")
}

/// The first zero of a function after a time, by steps and then by bisection.
pub fn first_zero(function: impl Fn(f64) -> f64, after: f64, step: f64) -> f64 {
    let mut low = after + step;
    while function(low) * function(low + step) > 0.0 {
        low += step;
    }
    let mut high = low + step;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if function(low) * function(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
