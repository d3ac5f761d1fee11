//! The wheel led so that the second shaft keeps its speed.

use super::super::charted::power;
use super::super::rewritten::Rewritten;
use super::super::{Amiss, Diagnosis, Ended, Mechanism, steered};
use super::NEAR;
use super::gear::{Gear, amiss, governor, margins, without_friction};
use super::reductions;
use crate::ladder::Rung;
use field::{Analytic, Over};
use integrators::Method;
use mechanics::constrained::motion::velocity;
use mechanics::constrained::{Charted, State, System, kinetic_energy};
use reader::Quantity;
use simulation::{Margin, SymbolicLaw};
use std::marker::PhantomData;
use std::sync::Arc;
use systems::governor::constant::{ConstantMoments, Course};
use systems::governor::servo::Kept;
use systems::governor::{Governor, Moment};

const BLOWN_UP: &str =
    "blow-up in finite time: the wheel comes to the axis of the second disc with infinite speed, and no motion goes on";

/// rho' by Appell's equation of omega2 with omega2' = 0.
#[derive(Clone, Copy, Debug)]
pub struct Programme<G> {
    governor: Governor<f64>,
    /// omega2, rad/s
    speed: f64,
    gear: PhantomData<G>,
}

const SPEED: &Quantity = &Quantity::any("speed", "rad/s", "omega2, speed that the second shaft keeps");

/// How the motion goes on, where the moments are constant.
struct Closed {
    course: Course,
    what: &'static str,
    distance: Box<dyn Fn(f64) -> Option<f64>>,
}

impl<G: Gear> Programme<G> {
    fn closed(&self, start: f64) -> Option<Closed> {
        if self.governor.moments.iter().any(|moment| moment.growth != 0.0) {
            return None;
        }
        if let Some(between) = self.governor.between(self.speed) {
            let distance = Box::new(move |time| between.distance_at(start, time));
            return Some(Closed { course: between.course(start), what: "the quadrature in closed form", distance });
        }
        let law = self.governor.small_parameter(self.speed)?;
        let (of_second, of_first) = (law.of_second[0], law.of_first[0]);
        let law = ConstantMoments { epsilon: law.epsilon, of_second, of_first, start };
        let distance = Box::new(move |time| law.distance(time));
        Some(Closed { course: law.course(), what: "the closed form by Lambert's W", distance })
    }

    fn motion<S: Over<f64> + Analytic>(&self, time: S, rho: S) -> (S, State<S, 7>) {
        let (zero, speed) = (S::zero(), S::lift(self.speed));
        let drift = self.governor.programme(time, rho, speed);
        let q = [zero, zero, zero, rho];
        let velocity = velocity(&self.governor, time, q, [speed, drift]);
        (drift, State { time, place: self.governor.place(time, q), velocity })
    }
}

impl<G: Gear> Mechanism for Programme<G> {
    const NAME: &'static str = G::NAME.0;
    const SUMMARY: &'static str = G::NAME.1;
    const STATE: &'static [Quantity] = &[Quantity::any("rho", "m", G::RHO)];
    const SHOWN: &'static [Quantity] = &[
        Quantity::any("drho", "m/s", "rate of rho"),
        Quantity::any("omega1", "rad/s", "speed of the first shaft"),
        Quantity::any("push", "N", "force along the axle that leads the wheel"),
    ];

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        Ok(Programme { governor: governor::<G, E>(source)?, speed: source(SPEED)?, gear: PhantomData })
    }

    fn rates<S: Over<f64> + Analytic>(&self, time: S, y: &[S], dy: &mut [S]) {
        dy[0] = self.governor.programme(time, y[0], S::lift(self.speed));
    }

    fn energy<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        kinetic_energy(self.governor.masses(), self.motion(time, y[0]).1.velocity)
    }

    /// Of the shafts, of the friction across, of the push that leads.
    fn power<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        let (drift, state) = self.motion(time, y[0]);
        let push = self.governor.control_force(time, y[0], S::lift(self.speed));
        power(self.governor.force(&state), state.velocity) + push * drift
    }

    fn shown(&self, time: f64, y: &[f64]) -> Vec<f64> {
        let [first, second] = self.governor.levers(y[0]);
        let drift = self.governor.programme(time, y[0], self.speed);
        vec![drift, second / first * self.speed, self.governor.control_force(time, y[0], self.speed)]
    }

    fn amiss(&self, start: &[f64]) -> Vec<Amiss> {
        let accepted = "a speed other than zero is accepted".to_owned();
        let still =
            (self.speed == 0.0).then_some(Amiss { name: "speed", what: "no wheel keeps a shaft at rest", accepted });
        still.into_iter().chain(amiss(self.governor.gearing, start[0])).collect()
    }

    fn margins(&self, _start: &[f64], y: &[f64], dy: &[f64]) -> Vec<Margin> {
        margins(self.governor.gearing, [y[0], dy[0]])
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let [[_, now], [_, first]] = [run.last, run.start].map(|y| self.governor.levers(y[0]));
        let at = self.closed(run.start[0]).and_then(|closed| match closed.course {
            Course::ReachesAxis { time } => Some(time).filter(|time| time.is_finite()),
            _ => None,
        });
        if !run.left && now > NEAR * first && !at.is_some_and(|at| run.was_before(at)) {
            return None;
        }
        let what = match self.governor.moments[1] {
            Moment { start: 0.0, growth: 0.0 } => "the wheel comes to the axis of the second disc: no motion goes on",
            _ => BLOWN_UP,
        };
        Some(Diagnosis { what, at })
    }

    fn exact(&self, start: &[f64], time: f64) -> Option<(&'static str, Vec<f64>)> {
        let closed = self.closed(start[0])?;
        (closed.distance)(time).map(|rho| (closed.what, vec![rho]))
    }

    fn smaller(&self, start: &[f64], written: &Arc<dyn SymbolicLaw>) -> Vec<Rung> {
        let series = self.governor.small_parameter(self.speed).map(|law| reductions::series(&law, start[0]));
        let smooth = Programme { governor: Governor { lateral: 0.0, ..self.governor }, ..*self };
        let smooth = (self.governor.lateral != 0.0).then(|| without_friction(smooth, start, written));
        smooth.flatten().into_iter().chain(series.into_iter().flatten()).collect()
    }

    /// The wheel's contacts by multipliers, the speed by the push: the motion in which the minimal form knows rho alone.
    fn rewritten(&self, start: &[f64]) -> Vec<Rewritten> {
        let (_, start) = self.motion(0.0, start[0]);
        let kept = Kept { governor: self.governor, speed: self.speed };
        steered::redundant::<_, 7, 5, 1>(&kept, &start, |at| vec![at.place[6]])
    }

    fn theory(&self, start: &[f64], _method: Method, _span: f64) -> Vec<String> {
        let said = self.closed(start[0]).map(|closed| match closed.course {
            Course::Rest => "the moments balance: the wheel rests".to_owned(),
            Course::ReachesAxis { time } if !time.is_finite() => {
                "the wheel comes to the axis of the second disc, at a time that doubles do not hold".to_owned()
            }
            Course::ReachesAxis { time } => {
                format!("the wheel comes to the axis of the second disc at t = {time:.9} s, and no motion goes on")
            }
            Course::TendsTo { distance: 0.0 } => {
                "the wheel tends to the axis of the first disc, whose speed grows without bound".to_owned()
            }
            Course::TendsTo { distance } if !distance.is_finite() => {
                "the wheel tends to a distance that doubles do not hold".to_owned()
            }
            Course::TendsTo { distance } => format!("the wheel tends to rho = {distance:.9} m"),
            Course::Grows => "rho grows without bound: the wheel leaves every disc".to_owned(),
        });
        said.into_iter().collect()
    }
}
