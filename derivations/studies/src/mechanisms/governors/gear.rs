//! What every friction governor has, what its wheel rolls on, and where that ends.

use super::super::{Amiss, Mechanism};
use super::reductions::with_data;
use crate::ladder::Rung;
use reader::{Bound, Quantity};
use simulation::SymbolicLaw;
use simulation::events::{Margin, outside};
use std::fmt::Debug;
use std::sync::Arc;
use systems::governor::{Gearing, Governor, Moment};

reader::quantities! {
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
        lateral: "N" in friction,
    }
}

/// What the wheel rolls on.
pub trait Gear: Copy + Debug + Send + Sync + 'static {
    /// Name and summary of the governor.
    const NAME: (&'static str, &'static str);
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
    const NAME: (&'static str, &'static str) =
        ("drum_programme", "a friction governor with a drum, its wheel led so that the second shaft keeps its speed");
    const RHO: &'static str = "distance of the wheel from the axis of the second disc";
    const LENGTH: &'static Quantity =
        &Quantity::within("drum", "m", "R, radius of the drum on the first shaft", Bound::Positive);

    fn gearing(radius: f64) -> Gearing<f64> {
        Gearing::Drum { radius }
    }
}

impl Gear for Discs {
    const NAME: (&'static str, &'static str) =
        ("disc_programme", "a friction governor between two discs, led so that the second shaft keeps its speed");
    const RHO: &'static str = "distance of the wheel from the axis of the first disc";
    const LENGTH: &'static Quantity =
        &Quantity::within("distance", "m", "a, distance of the axes of both discs", Bound::Positive);

    fn gearing(distance: f64) -> Gearing<f64> {
        Gearing::Discs { distance }
    }
}

/// The governor with no push along the axle.
pub(super) fn governor<G: Gear, E>(
    source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>,
) -> Result<Governor<f64>, E> {
    let Shafts { j1, j2, j, mass, wheel, m1, m1_growth, m2, m2_growth, lateral } = Shafts::read(&mut *source)?;
    let gearing = G::gearing(source(G::LENGTH)?);
    let moments = [Moment { start: m1, growth: m1_growth }, Moment { start: m2, growth: m2_growth }];
    Ok(Governor { inertia: [j1, j2, j], mass, radius: wheel, gearing, moments, push: 0.0, lateral })
}

/// The smaller model without the friction across the wheel: its name, what it drops, and what is small then.
pub(super) const FRICTIONLESS: [&str; 3] = [
    "frictionless across",
    "the friction across the wheel at both contacts",
    "F11 + F22 over the force along the axle",
];

/// The governor whose wheel slides along its axle without friction.
pub(super) fn without_friction<M: Mechanism>(smooth: M, start: &[f64], written: &Arc<dyn SymbolicLaw>) -> Option<Rung> {
    let [name, dropped, parameter] = FRICTIONLESS;
    with_data(name, dropped, parameter, smooth, start, written)
}

/// Where the levers are positive.
fn range(gearing: Gearing<f64>) -> [f64; 2] {
    match gearing {
        Gearing::Drum { .. } => [0.0, f64::INFINITY],
        Gearing::Discs { distance } => [0.0, distance],
    }
}

pub(super) fn amiss(gearing: Gearing<f64>, rho: f64) -> Option<Amiss> {
    let accepted = match range(gearing) {
        [_, most] if most.is_infinite() => "a positive distance is accepted".to_owned(),
        [least, most] => format!("a distance between {least} m and {most} m is accepted"),
    };
    outside(&margins(gearing, [rho, 0.0])).map(|what| Amiss { name: "rho", what, accepted })
}

/// Of rho with its rate.
pub(super) fn margins(gearing: Gearing<f64>, [rho, rate]: [f64; 2]) -> Vec<Margin> {
    let [least, most] = range(gearing);
    let first = match gearing {
        Gearing::Drum { .. } => "the wheel has come to the axis of the second disc, or beyond",
        Gearing::Discs { .. } => "the wheel has come to the axis of the first disc, or beyond",
    };
    let last = "the wheel has come to the axis of the second disc, or beyond";
    let below = Margin { value: rho - least, rate, what: first, ..Margin::default() };
    let above = most.is_finite().then_some(Margin { value: most - rho, rate: -rate, what: last, ..Margin::default() });
    std::iter::once(below).chain(above).collect()
}
