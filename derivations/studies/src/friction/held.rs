//! One regime held, whatever its conditions say: a smooth law, which is the motion as long as they hold.
//!
//! How far they are from failing is seen at the ends of the steps and, between two of them, by the cubic through the values and
//! the rates at both: tested, not enclosed.

use super::stretch::{Stretch, Watched};
use field::{Analytic, Over};
use integrators::{Method, Observer, Ode, Signal, Span, Switches, Tolerance, integrate};
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::Mode;

/// A system in a regime. The state is that of a [`Stretch`].
#[derive(Clone, Copy, Debug)]
pub struct Held<Q, const N: usize, const C: usize, const K: usize> {
    pub system: Q,
    pub regime: [Mode; K],
    /// Whether the system rests, held by more reactions than are determined.
    pub rests: bool,
}

impl<Q, S, const N: usize, const C: usize, const K: usize> Ode<S> for Held<Q, N, C, K>
where
    Q: Contacts<N, C, K, Given = f64>,
    S: Over<f64> + Analytic,
{
    fn dimension(&self) -> usize {
        2 * N + 2
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let Held { system, regime, rests } = self;
        // what is seen of signals is not asked for
        let (rough, orientation, speed, load) = ([true; K], 1.0, 0.0, 0.0);
        Stretch { system, regime: *regime, rough, rests: *rests, orientation, speed, load }.rates(t, y, dy);
    }
}

/// The least of what keeps a regime, along a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// Beside the load, the speed or the length that it is measured by.
    pub least: f64,
    pub at: f64,
    pub watched: Watched,
    pub steps: usize,
}

/// Places between the ends of a step at which the cubic is looked at.
const BETWEEN: usize = 16;

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Stretch<'_, Q, N, C, K> {
    /// Along the run from a state; none where that does not reach its end, or nothing can fail.
    pub fn margin(&self, start: &[f64], span: f64, tolerance: f64) -> Option<Margin> {
        let mut seen = Seen { stretch: self, last: None, armed: vec![false; self.count()], least: None, steps: 0 };
        seen.step(0.0, start);
        let whole = Span::new(0.0, span, start);
        let run = integrate(self, Method::DormandPrince8, &Tolerance::both(tolerance), &whole, &mut seen);
        let (least, at, watched) = seen.least?;
        run.reached().then_some(Margin { least, at, watched, steps: seen.steps })
    }
}

struct Seen<'a, 'b, Q, const N: usize, const C: usize, const K: usize> {
    stretch: &'a Stretch<'b, Q, N, C, K>,
    last: Option<(f64, Vec<Signal>)>,
    /// Which were positive once: one that starts at zero may rise first.
    armed: Vec<bool>,
    least: Option<(f64, f64, Watched)>,
    steps: usize,
}

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Observer<f64>
    for Seen<'_, '_, Q, N, C, K>
{
    fn step(&mut self, time: f64, state: &[f64]) {
        let mut now = vec![Signal::default(); self.armed.len()];
        self.stretch.signals(time, state, &mut now);
        for (place, watched) in self.stretch.watched().enumerate() {
            let Some(size) = self.stretch.size(watched) else { continue };
            let end = now[place];
            if self.armed[place] {
                let begin = self.last.as_ref().map(|(from, signals)| (*from, signals[place]));
                let between = begin.into_iter().flat_map(|begin| cubic(begin, (time, end)));
                for (at, value) in between.chain([(time, end.value)]) {
                    if self.least.is_none_or(|(least, ..)| value / size < least) {
                        self.least = Some((value / size, at, watched));
                    }
                }
            }
            self.armed[place] |= end.value > end.noise;
        }
        self.steps += usize::from(self.last.is_some());
        self.last = Some((time, now));
    }
}

/// The cubic through values and rates at both ends.
fn cubic((from, begin): (f64, Signal), (to, end): (f64, Signal)) -> impl Iterator<Item = (f64, f64)> {
    let h = to - from;
    (1..=BETWEEN).map(move |place| {
        let s = place as f64 / (BETWEEN + 1) as f64;
        let (a, b) = ((1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), s * (1.0 - s) * (1.0 - s));
        let (c, d) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0));
        (from + s * h, a * begin.value + b * h * begin.rate + c * end.value + d * h * end.rate)
    })
}
