//! Motions across events to all digits that two methods share.
//!
//! The run tells the regimes, which each method follows (`follow`). Where the determinant of a regime vanishes, that regime is slowed
//! down by it (`slowed`).

mod follow;
mod owner;
mod slowed;

pub use owner::Regimes;

use super::log::{Ending, Names, describe};
use super::run::{Plan, run};
use super::{ForRough, RoughScene};
use follow::Follower;
use integrators::Sizes;
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use simulation::references::{Exact, Unknown, agreed, instants};
use std::time::Duration;

impl RoughScene {
    /// The motion to all digits, each of two methods in half of the time.
    ///
    /// # Errors
    /// Why it is not known.
    pub fn exact(&self, allowed: Duration) -> Result<Exact, Unknown> {
        self.apply(Exactly { scene: self, allowed })
    }
}

struct Exactly<'a> {
    scene: &'a RoughScene,
    allowed: Duration,
}

impl ForRough for Exactly<'_> {
    type Output = Result<Exact, Unknown>;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        contacts: Names<K>,
    ) -> Result<Exact, Unknown>
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let y0 = [&start.place[..], &start.velocity[..], &[0.0; 2]].concat();
        let mut sizes = Sizes(y0.iter().map(|y| y.abs()).collect());
        let found = run(system, &start, &Plan::until(self.scene.plan.end), &mut sizes);
        let known = matches!(
            found.ending,
            Ending::Reached | Ending::TouchDown { .. } | Ending::Critical | Ending::Undetermined
        );
        if !known || found.entries.is_empty() {
            return Err(Unknown::Ends(found.ending.describe(&contacts)));
        }
        let times = instants(&y0, found.state.time, found.ending == Ending::Reached);
        let sizes = of_kinds::<N>(&sizes.0);
        let follow = |means| Follower { system, run: &found, start: &y0, instants: &times, means }.follow();
        let words = |place: usize| {
            let next = found.entries.get(place + 1);
            let what = next.map_or_else(|| found.ending.describe(&contacts), |next| next.cause.describe(&contacts));
            [what, next.map_or_else(String::new, |next| describe(&contacts, &next.regime))]
        };
        agreed(times.clone(), sizes, self.allowed, follow, words)
    }
}

/// The sizes of places, velocities and works, each kind by itself: what is rounding beside its kind has the size of that.
fn of_kinds<const N: usize>(largest: &[f64]) -> Vec<f64> {
    let (places, rest) = largest.split_at(N);
    let (velocities, works) = rest.split_at(N);
    let of_kind = |kind: &[f64]| -> Vec<f64> {
        let whole = kind.iter().copied().fold(0.0, f64::max);
        let whole = if whole > 0.0 { whole } else { 1.0 };
        kind.iter().map(|size| if *size > ROUNDING * whole { *size } else { whole }).collect()
    };
    [places, velocities, works].map(of_kind).concat()
}

/// Beside the others of a kind nothing.
const ROUNDING: f64 = 1e-9;
