//! Whose a reference is: the laws of a scene's regimes, each until it ends.

use crate::friction::held::Held;
use crate::friction::log::Names;
use crate::friction::run::{Plan, run};
use crate::friction::{ForRough, RoughScene};
use field::{DoubleDouble, Over};
use integrators::Ode;
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use simulation::references::Owner;

/// The start of a scene and the laws that it goes through, by a run in `f64`.
pub struct Regimes {
    start: Vec<f64>,
    laws: Vec<(f64, Box<dyn Ode<DoubleDouble>>)>,
}

impl Regimes {
    /// Of a scene.
    pub fn of(scene: &RoughScene) -> Self {
        scene.apply(Found { scene })
    }
}

impl Owner for Regimes {
    fn start(&self) -> &[f64] {
        &self.start
    }

    fn rates_at(&self, time: f64, state: &[DoubleDouble], rates: &mut [DoubleDouble]) {
        let until = self.laws.iter().position(|(until, _)| time < *until);
        if let Some((_, law)) = until.map_or(self.laws.last(), |place| self.laws.get(place)) {
            law.rates(DoubleDouble::lift(time), state, rates);
        }
    }
}

struct Found<'a> {
    scene: &'a RoughScene,
}

impl ForRough for Found<'_> {
    type Output = Regimes;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        _contacts: Names<K>,
    ) -> Regimes
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let found = run(system, &start, &Plan::until(self.scene.plan.end), &mut ());
        let law = |(place, entry): (usize, &crate::friction::Entry<K>)| {
            let until = found.entries.get(place + 1).map_or(f64::INFINITY, |next| next.time);
            let held = Held { system: *system, regime: entry.regime, rests: !entry.determined };
            (until, Box::new(held) as Box<dyn Ode<DoubleDouble>>)
        };
        let laws = found.entries.iter().enumerate().map(law).collect();
        Regimes { start: [&start.place[..], &start.velocity[..], &[0.0; 2]].concat(), laws }
    }
}
