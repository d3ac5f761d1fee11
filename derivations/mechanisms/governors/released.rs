//! The wheel pushed along its axle by a constant force.

use super::super::charted::balance;
use super::super::points::{self, Turning};
use super::super::rewritten::Rewritten;
use super::super::{Amiss, Diagnosis, Ended, Mechanism};
use super::NEAR;
use super::gear::{Gear, amiss, governor, margins, without_friction};
use crate::ladder::Rung;
use crate::systems::governor::{Gearing, Governor};
use field::{Analytic, Over};
use mechanics::constrained::State;
use reader::Quantity;
use simulation::{Margin, SymbolicLaw};
use std::marker::PhantomData;
use std::sync::Arc;

/// The wheel pushed along its axle by a constant force.
#[derive(Clone, Copy, Debug)]
pub struct Released<G> {
    governor: Governor<f64>,
    gear: PhantomData<G>,
}

const PUSH: &Quantity = &Quantity::any("push", "N", "u, force along the axle");

/// (phi1, phi2, phi, rho, omega2, rho'), the angles zero: no equation can see them.
fn whole<S: Over<f64>>(y: &[S]) -> [S; 6] {
    let zero = S::zero();
    [zero, zero, zero, y[1], y[0], y[2]]
}

/// No equation sees an angle.
impl Turning<7, 0> for Governor<f64> {
    fn turning<S: Over<f64>>(&self, _at: &State<S, 7>) -> [S; 0] {
        []
    }
}

impl<G: Gear> Mechanism for Released<G> {
    const NAME: &'static str = G::NAMES[1].0;
    const SUMMARY: &'static str = G::NAMES[1].1;
    const STATE: &'static [Quantity] = &[
        Quantity::any("omega2", "rad/s", "speed of the second shaft"),
        Quantity::any("rho", "m", G::RHO),
        Quantity::any("drho", "m/s", "rate of rho"),
    ];
    const SHOWN: &'static [Quantity] = &[Quantity::any("omega1", "rad/s", "speed of the first shaft")];

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        let governor = Governor { push: source(PUSH)?, ..governor::<G, E>(source)? };
        Ok(Released { governor, gear: PhantomData })
    }

    fn rates<S: Over<f64> + Analytic>(&self, time: S, y: &[S], dy: &mut [S]) {
        let found = self.governor.released(time, [y[0], y[1], y[2]], S::zero());
        dy.copy_from_slice(&found.unwrap_or([S::zero() / S::zero(); 3]));
    }

    fn energy<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        balance::<_, S, 7, 4, 2>(&self.governor, time, &whole(y))[0]
    }

    fn power<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        balance::<_, S, 7, 4, 2>(&self.governor, time, &whole(y))[1]
    }

    fn shown(&self, _time: f64, y: &[f64]) -> Vec<f64> {
        let [first, second] = self.governor.levers(y[1]);
        vec![second / first * y[0]]
    }

    fn amiss(&self, start: &[f64]) -> Vec<Amiss> {
        amiss(self.governor.gearing, false, start[1]).into_iter().collect()
    }

    fn margins(&self, _start: &[f64], y: &[f64], dy: &[f64]) -> Vec<Margin> {
        margins(self.governor.gearing, false, [y[1], dy[1]])
    }

    fn smaller(&self, start: &[f64], written: &Arc<dyn SymbolicLaw>) -> Vec<Rung> {
        let smooth = Released { governor: Governor { lateral: 0.0, ..self.governor }, ..*self };
        let smooth = (self.governor.lateral != 0.0).then(|| without_friction(smooth, start, written));
        smooth.flatten().into_iter().collect()
    }

    fn rewritten(&self, start: &[f64]) -> Vec<Rewritten> {
        let [_, _, _, rho, speed, drift] = whole(start);
        let start = ([0.0, 0.0, 0.0, rho], [speed, drift], []);
        points::redundant::<_, 7, 5, 4, 2, 0>(&self.governor, start, |at, []| {
            let ([_, _, c, s, _, _, rho], [_, _, dc, ds, _, _, drift]) = (at.place, at.velocity);
            vec![c * ds - s * dc, rho, drift]
        })
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let near = run.left || run.last[1].abs() < NEAR * run.start[1].abs();
        let what = "the wheel comes to the axis of the first disc, which would have to turn with infinite speed";
        (near && matches!(self.governor.gearing, Gearing::Discs { .. })).then_some(Diagnosis { what, at: None })
    }
}
