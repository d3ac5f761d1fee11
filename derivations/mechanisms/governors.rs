//! The friction governors: the programme that keeps the speed of the second shaft, and the governor released.

use super::bodies::{balance, power};
use super::{Amiss, Diagnosis, Ended, Mechanism};
use crate::machines::Quantity;
use crate::systems::governor::constant::{ConstantMoments, Course};
use crate::systems::governor::{Gearing, Governor, Moment};
use field::{Analytic, Over};
use integrators::Method;
use mechanics::constrained::motion::velocity;
use mechanics::constrained::{Charted, State, System, kinetic_energy};
use std::fmt::Debug;
use std::marker::PhantomData;

crate::quantities! {
    /// What every governor has.
    pub struct Shafts {
        /// J1, moment of inertia of the first disc or drum with its shaft
        j1: "kg m^2" > 0,
        /// J2, moment of inertia of the second disc with its shaft
        j2: "kg m^2" > 0,
        /// J, moment of inertia of the wheel
        j: "kg m^2" > 0,
        /// m, mass of the wheel with its axle
        mass: "kg" > 0,
        /// r, radius of the wheel
        wheel: "m" > 0,
        /// M1, moment on the first shaft at t = 0
        m1: "N m",
        /// rate of M1
        m1_growth: "N m/s",
        /// M2, moment on the second shaft at t = 0
        m2: "N m",
        /// rate of M2
        m2_growth: "N m/s",
        /// F11 + F22, friction across the wheel at both contacts, against the growth of rho
        lateral: "N",
    }
}

/// What the wheel rolls on.
pub trait Gear: Copy + Debug + Send + Sync + 'static {
    /// Name and summary of the governor whose speed is kept, and of the one that is released.
    const NAMES: [(&'static str, &'static str); 2];
    /// What rho is.
    const RHO: &'static str;
    /// The one length that the gear has.
    const LENGTH: &'static Quantity;

    fn gearing(length: f64) -> Gearing<f64>;
}

/// A drum, along which the wheel slides, and a disc.
#[derive(Clone, Copy, Debug)]
pub struct Drum;

/// Two discs.
#[derive(Clone, Copy, Debug)]
pub struct Discs;

impl Gear for Drum {
    const NAMES: [(&'static str, &'static str); 2] = [
        ("drum_programme", "a friction governor with a drum, its wheel led so that the second shaft keeps its speed"),
        ("drum_governor", "a friction governor with a drum, its wheel pushed by a constant force"),
    ];
    const RHO: &'static str = "distance of the wheel from the axis of the second disc";
    const LENGTH: &'static Quantity =
        &Quantity { positive: true, ..Quantity::any("drum", "m", "R, radius of the drum on the first shaft") };

    fn gearing(radius: f64) -> Gearing<f64> {
        Gearing::Drum { radius }
    }
}

impl Gear for Discs {
    const NAMES: [(&'static str, &'static str); 2] = [
        ("disc_programme", "a friction governor between two discs, led so that the second shaft keeps its speed"),
        ("disc_governor", "a friction governor between two discs, its wheel pushed by a constant force"),
    ];
    const RHO: &'static str = "distance of the wheel from the axis of the first disc";
    const LENGTH: &'static Quantity =
        &Quantity { positive: true, ..Quantity::any("distance", "m", "a, distance of the axes of both discs") };

    fn gearing(distance: f64) -> Gearing<f64> {
        Gearing::Discs { distance }
    }
}

/// The governor with no push along the axle.
fn governor<G: Gear, E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Governor<f64>, E> {
    let Shafts { j1, j2, j, mass, wheel, m1, m1_growth, m2, m2_growth, lateral } = Shafts::read(&mut *source)?;
    let gearing = G::gearing(source(G::LENGTH)?);
    let moments = [Moment { start: m1, growth: m1_growth }, Moment { start: m2, growth: m2_growth }];
    Ok(Governor { inertia: [j1, j2, j], mass, radius: wheel, gearing, moments, push: 0.0, lateral })
}

/// Where the levers are positive; for the released governor only the first need be.
fn range(gearing: Gearing<f64>, kept: bool) -> [f64; 2] {
    match gearing {
        Gearing::Drum { .. } if kept => [0.0, f64::INFINITY],
        Gearing::Drum { .. } => [f64::NEG_INFINITY, f64::INFINITY],
        Gearing::Discs { distance } if kept => [0.0, distance],
        Gearing::Discs { .. } => [0.0, f64::INFINITY],
    }
}

fn amiss(gearing: Gearing<f64>, kept: bool, rho: f64) -> Option<Amiss> {
    let accepted = match range(gearing, kept) {
        [_, most] if most.is_infinite() => "a positive distance is accepted".to_owned(),
        [least, most] => format!("a distance between {least} m and {most} m is accepted"),
    };
    left(gearing, kept, rho).map(|what| Amiss { name: "rho", what, accepted })
}

fn left(gearing: Gearing<f64>, kept: bool, rho: f64) -> Option<&'static str> {
    let [least, most] = range(gearing, kept);
    match gearing {
        Gearing::Drum { .. } if rho <= least => Some("the wheel has come to the axis of the second disc, or beyond"),
        Gearing::Discs { .. } if rho <= least => Some("the wheel has come to the axis of the first disc, or beyond"),
        _ => (rho >= most).then_some("the wheel has come to the axis of the second disc, or beyond"),
    }
}

/// The wheel led so that the second shaft keeps its speed: rho' by Appell's equation of omega2 with omega2' = 0.
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
    const NAME: &'static str = G::NAMES[0].0;
    const SUMMARY: &'static str = G::NAMES[0].1;
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
        still.into_iter().chain(amiss(self.governor.gearing, true, start[0])).collect()
    }

    fn outside(&self, y: &[f64]) -> Option<&'static str> {
        left(self.governor.gearing, true, y[0])
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let [[_, now], [_, first]] = [run.last, run.start].map(|y| self.governor.levers(y[0]));
        let at = self.closed(run.start[0]).and_then(|closed| match closed.course {
            Course::ReachesAxis { time } => Some(time),
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

    fn theory(&self, start: &[f64], _method: Method, _span: f64) -> Vec<String> {
        let said = self.closed(start[0]).map(|closed| match closed.course {
            Course::Rest => "the moments balance: the wheel rests".to_owned(),
            Course::ReachesAxis { time } => {
                format!("the wheel comes to the axis of the second disc at t = {time:.9} s, and no motion goes on")
            }
            Course::TendsTo { distance: 0.0 } => {
                "the wheel tends to the axis of the first disc, whose speed grows without bound".to_owned()
            }
            Course::TendsTo { distance } => format!("the wheel tends to rho = {distance:.9} m"),
            Course::Grows => "rho grows without bound: the wheel leaves every disc".to_owned(),
        });
        said.into_iter().collect()
    }
}

/// The share of its first lever at which a wheel counts as come to the axis.
const NEAR: f64 = 1e-2;
const BLOWN_UP: &str =
    "blow-up in finite time: the wheel comes to the axis of the second disc with infinite speed, and no motion goes on";

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

    fn outside(&self, y: &[f64]) -> Option<&'static str> {
        left(self.governor.gearing, false, y[1])
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let near = run.left || run.last[1].abs() < NEAR * run.start[1].abs();
        let what = "the wheel comes to the axis of the first disc, which would have to turn with infinite speed";
        (near && matches!(self.governor.gearing, Gearing::Discs { .. })).then_some(Diagnosis { what, at: None })
    }
}
