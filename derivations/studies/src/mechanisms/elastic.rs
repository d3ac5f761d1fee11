//! The governor with an elastic rim: near its stationary motion, or anywhere else.

use super::governors::reductions;
use super::points::{self, Turning};
use super::rewritten::Rewritten;
use super::{Amiss, Diagnosis, Ended, Mechanism};
use crate::governors::{growth, has_positive_minors};
use crate::ladder::Rung;
use field::{Analytic, Over};
use integrators::Method;
use mechanics::constrained::State;
use reader::Quantity;
use simulation::{Margin, SymbolicLaw};
use std::sync::Arc;
use systems::elastic_governor::ElasticGovernor;

/// The state as the system has it.
fn state<S: Copy>(y: &[S]) -> [S; 5] {
    [y[0], y[1], y[2], y[3], y[4]]
}

/// How well the data must balance for their stationary motion to be one, against the largest of what is balanced.
const BALANCED: f64 = 1e-9;

/// The stationary motion that the data have, if they have one: omega1 at x = x0.
fn stationary(data: &ElasticGovernor<f64>) -> Option<f64> {
    let pull = data.c2 * data.delta2 - data.c1 * data.delta1;
    let speed = (pull / (0.5 * data.ball * data.rest)).sqrt();
    let balanced = data.stationary_at(speed);
    let close = |a: f64, b: f64| (a - b).abs() <= BALANCED * a.abs().max(b.abs());
    (speed > 0.0 && close(balanced.m1, data.m1)).then_some(speed)
}

/// Its angles are coordinates.
impl Turning<12, 0> for ElasticGovernor<f64> {
    fn turning<S: Over<f64>>(&self, _at: &State<S, 12>) -> [S; 0] {
        []
    }
}

impl Mechanism for ElasticGovernor<f64> {
    const NAME: &'static str = "elastic_governor";
    const SUMMARY: &'static str = "a governor with centrifugal balls and a wheel with an elastic rim, after Keldysh";
    const STATE: &'static [Quantity] = &[
        Quantity::any("omega1", "rad/s", "speed of the drum"),
        Quantity::any("x", "m", "place of the sleeve"),
        Quantity::any("dx", "m/s", "velocity of the sleeve"),
        Quantity::any("lambda", "m", "displacement of the wheel's centre from that of the contact"),
        Quantity::any("psi", "rad", "angle from the plane of the wheel to the line of rolling"),
    ];
    const SHOWN: &'static [Quantity] = &[Quantity::any("omega2", "rad/s", "speed of the disc")];

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        ElasticGovernor::read(source)
    }

    fn rates<S: Over<f64> + Analytic>(&self, _time: S, y: &[S], dy: &mut [S]) {
        let rates = self.rates_of_state(state(y));
        dy.copy_from_slice(&rates.unwrap_or([S::zero() / S::zero(); 5]));
    }

    fn energy<S: Over<f64> + Analytic>(&self, _time: S, y: &[S]) -> S {
        ElasticGovernor::energy(self, state(y))
    }

    fn power<S: Over<f64> + Analytic>(&self, _time: S, y: &[S]) -> S {
        ElasticGovernor::power(self, state(y))
    }

    fn shown(&self, _time: f64, y: &[f64]) -> Vec<f64> {
        vec![self.drum * y[0] / (y[1] - self.offset)]
    }

    fn amiss(&self, start: &[f64]) -> Vec<Amiss> {
        let accepted = format!("a place between {} m and {} m is accepted", self.offset, 2.0 * self.link);
        self.outside(start, start).map(|what| Amiss { name: "x", what, accepted }).into_iter().collect()
    }

    fn margins(&self, _start: &[f64], y: &[f64], dy: &[f64]) -> Vec<Margin> {
        let of_axis = "the wheel has come to the axis of the disc";
        let of_links = "the links are stretched: the balls are on the axis";
        vec![
            Margin { value: y[1] - self.offset, rate: dy[1], what: of_axis, ..Margin::default() },
            Margin { value: 2.0 * self.link - y[1], rate: -dy[1], what: of_links, ..Margin::default() },
        ]
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let (low, high) = (self.offset, 2.0 * self.link);
        let near = 1e-2 * (high - low);
        let what = match run.last[1] {
            x if x < low + near => "the wheel comes to the axis of the disc, which then turns without bound",
            x if x > high - near => "the links are stretched: the balls come to the axis",
            _ => return None,
        };
        Some(Diagnosis { what, at: None })
    }

    fn rewritten(&self, start: &[f64]) -> Vec<Rewritten> {
        let [speed, x, drift, lambda, psi] = state(start);
        let start = ([0.0, 0.0, 0.0, x, lambda, psi], [speed, drift], []);
        points::redundant::<_, 12, 10, 6, 2, 0>(self, start, |at, []| {
            vec![at.velocity[0], at.place[3], at.velocity[3], at.place[10], at.place[11]]
        })
    }

    fn smaller(&self, start: &[f64], written: &Arc<dyn SymbolicLaw>) -> Vec<Rung> {
        reductions::elastic(self, start, written)
    }

    fn theory(&self, _start: &[f64], _method: Method, _span: f64) -> Vec<String> {
        let Some(speed) = stationary(self) else {
            return vec!["the moments or the springs do not balance at x0: there is no stationary motion".to_owned()];
        };
        let verdict = match has_positive_minors(self, speed) {
            true => "stable, by Hurwitz' minors, which are all positive",
            false => "unstable, by Hurwitz' minors, which are not all positive",
        };
        let growth = growth(self, speed).filter(|rate| rate.is_finite()).map_or_else(String::new, |rate| {
            format!("; a disturbance changes by e^({rate:.3e} t) in the long run, by the eigenvalues")
        });
        vec![format!("the stationary motion at omega1 = {speed:.9} rad/s, x = {} m is {verdict}{growth}", self.rest)]
    }
}
