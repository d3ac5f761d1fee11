//! Maps over angle and friction of the states with exactly one motion, decided state by state, with the exact critical
//! curve.

use super::critical::{rod, two_masses};
use field::Circle;
use mechanics::constrained::State;
use mechanics::constrained::contacts::{Contacts, Sides};
use mechanics::regimes::{Consistency, Mode, posed, verdict};
use std::f64::consts::{FRAC_PI_2, SQRT_2};
use systems::ladder::Ladder;
use systems::rod::Rod;
use systems::slender_rod::SlenderRod;

/// The number and kind of motions of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One motion, with closed contacts.
    Slides,
    /// One motion, in which a contact opens.
    Leaves,
    /// No motion.
    None,
    /// Several motions.
    Several,
}

impl Kind {
    /// All kinds, in the order of a legend.
    pub const ALL: [Kind; 4] = [Kind::Slides, Kind::Leaves, Kind::None, Kind::Several];

    /// The text in a legend.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Slides => "one motion: slides on",
            Kind::Leaves => "one motion: a contact opens",
            Kind::None => "none",
            Kind::Several => "several",
        }
    }

    fn is_determined(self) -> bool {
        matches!(self, Kind::Slides | Kind::Leaves)
    }
}

/// A map over the angle from 0 to 90 degrees and the friction from 0 up.
#[derive(Clone, Debug)]
pub struct Map {
    pub title: &'static str,
    pub angle: &'static str,
    pub most_friction: f64,
    /// Rows from the lowest friction, each over all angles, at the centres of the cells.
    pub rows: Vec<Vec<Kind>>,
    /// The exact critical friction as a function of the angle in degrees.
    pub curve: Vec<(f64, f64)>,
    /// The minimum of `curve`: angle in degrees, friction, and both in closed form.
    pub least: (f64, f64, &'static str),
    /// The largest distance between `curve` and the boundary by the decisions alone, where a single contact is
    /// decisive.
    pub distance: f64,
    pub note: &'static str,
}

const COLUMNS: usize = 90;
const ROWS: usize = 75;

/// Maps of Painleve's two masses, the uniform rod, and the uniform ladder in both directions.
pub fn maps() -> Vec<Map> {
    vec![
        map(
            "Two equal masses on a massless rod, sliding towards their contact",
            "angle from the line to the rod, degrees",
            |angle, f| {
                let data = Rod { guided: 1.0, free: 1.0, length: 1.0, gravity: 1.0, friction: f, sides: Sides::One };
                // above the curve, which is y < 0 there
                let spin = 2.4_f64.sqrt();
                let place = [0.0, 0.0, angle.cos, -angle.sin];
                let velocity = [-1.0, 0.0, -1.0 + spin * angle.sin, spin * angle.cos];
                kind::<_, 1>(&data, place, velocity)
            },
            |angle| two_masses(1.0, angle),
            f64::INFINITY,
            (SQRT_2.atan(), 8.0_f64.sqrt(), "tan² = 2, f = 2√2"),
            "Turning with $l\\dot\\theta^2 = 2.4g$: where the rotation lifts the contact, at $\\sin\\theta > 5/6$, there are \
             two motions beyond the curve, elsewhere none. The exact curve is $(k+\\cos^2\\theta)/(\\sin\\theta\\cos\\theta)$ with $k = 1$.",
        ),
        map(
            "Uniform rod, sliding towards its contact",
            "angle from the line to the rod, degrees",
            |angle, f| {
                let data = SlenderRod { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: 1.0, friction: f };
                let spin = 1.2_f64.sqrt();
                let (c, s) = (angle.cos, angle.sin);
                kind::<_, 1>(&data, [c, s, c, s], [-1.0 - spin * s, spin * c, -spin * s, spin * c])
            },
            |angle| rod(3.0, angle),
            f64::INFINITY,
            (2.0_f64.atan(), 4.0 / 3.0, "tan = 2, f = 4/3"),
            "Turning with $l\\dot\\theta^2 = 1.2g$. The exact curve is $(1+3\\cos^2\\theta)/(3\\sin\\theta\\cos\\theta)$.",
        ),
        map(
            "Uniform ladder between wall and floor, sliding down",
            "angle from the wall to the ladder, degrees",
            |angle, f| ladder(angle, f, 0.3_f64.sqrt()),
            |Circle { cos, sin }| rod(3.0, Circle { cos: sin, sin: cos }).min(SQRT_2),
            SQRT_2,
            (0.5_f64.atan(), 4.0 / 3.0, "tan = 1/2, f = 4/3"),
            "Equal friction, turning with $l\\dot\\alpha^2 = 0.3g$. The exact curve is the floor's own, \
             $(1+3\\sin^2\\alpha)/(3\\sin\\alpha\\cos\\alpha)$, where it is below $\\sqrt2$, and $\\sqrt2$, where both contacts \
             together become singular. Below it every load leaves one motion, above it this one may.",
        ),
        map(
            "Uniform ladder between wall and floor, sliding up",
            "angle from the wall to the ladder, degrees",
            |angle, f| ladder(angle, f, -SQRT_2),
            |angle| rod(3.0, angle).min(SQRT_2),
            SQRT_2,
            (2.0_f64.atan(), 4.0 / 3.0, "tan = 2, f = 4/3"),
            "Equal friction, turning with $l\\dot\\alpha^2 = 2g$. The exact curve is the wall's own, the floor's with $\\alpha$ \
             and $90^\\circ-\\alpha$ exchanged, and $\\sqrt2$ as before.",
        ),
    ]
}

/// The ladder of mass, half length and gravity 1 on wall and floor.
fn ladder(Circle { cos, sin }: Circle<f64>, f: f64, spin: f64) -> Kind {
    let data = Ladder { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: 1.0, friction: [f; 2] };
    kind::<_, 2>(&data, [sin, cos, cos, sin], [spin * cos, -spin * sin, -spin * sin, spin * cos])
}

/// A map; `bounded` is the value of the critical curve up to which it is the boundary under this load.
fn map(
    title: &'static str,
    angle: &'static str,
    judge: impl Fn(Circle<f64>, f64) -> Kind,
    exact: impl Fn(Circle<f64>) -> f64,
    bounded: f64,
    (least_at, least, name): (f64, f64, &'static str),
    note: &'static str,
) -> Map {
    let most_friction = 2.25 * least;
    let turn = |share: f64| {
        let (sin, cos) = (share * FRAC_PI_2).sin_cos();
        Circle { cos, sin }
    };
    let middle = |k: usize, of: usize| (k as f64 + 0.5) / of as f64;
    let row = |r: usize| {
        let friction = most_friction * middle(r, ROWS);
        (0..COLUMNS).map(|c| judge(turn(middle(c, COLUMNS)), friction)).collect()
    };
    let distance = (0..COLUMNS)
        .map(|c| turn(middle(c, COLUMNS)))
        .filter(|angle| exact(*angle) < bounded.min(most_friction))
        .map(|angle| (boundary(|f| judge(angle, f).is_determined(), most_friction) - exact(angle)).abs())
        .fold(0.0, f64::max);
    let curve = (1..4 * COLUMNS).map(|k| k as f64 / (4 * COLUMNS) as f64);
    Map {
        title,
        angle,
        most_friction,
        rows: (0..ROWS).map(row).collect(),
        curve: curve.map(|share| (90.0 * share, exact(turn(share)))).collect(),
        least: (least_at.to_degrees(), least, name),
        distance,
        note,
    }
}

/// The value at which a condition becomes false, by bisection.
fn boundary(holds: impl Fn(f64) -> bool, most: f64) -> f64 {
    let (mut low, mut high) = (0.0, most);
    loop {
        let middle = 0.5 * (low + high);
        if middle == low || middle == high {
            return middle;
        }
        if holds(middle) { low = middle } else { high = middle }
    }
}

/// The kind of a state under the system's own forces.
fn kind<Q, const K: usize>(system: &Q, place: [f64; 4], velocity: [f64; 4]) -> Kind
where
    Q: Contacts<4, 1, K, Given = f64>,
{
    let at = State { time: 0.0, place, velocity };
    let Ok((dry, touch)) = posed(system, &at) else { return Kind::None };
    match verdict(&dry, &touch) {
        Consistency::Unique(found) if found.regime.contains(&Mode::Apart) => Kind::Leaves,
        Consistency::Unique(_) => Kind::Slides,
        Consistency::None | Consistency::Undefined => Kind::None,
        Consistency::Several(..) | Consistency::Continuum(_) => Kind::Several,
    }
}
