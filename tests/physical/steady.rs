//! Steady rotations of a gyrostat by two methods: the polynomial of its tensor, and the box search on a text model.

use algebra::real::{Enclosure, Root};
use dalembert_derivations::studies::stationary::energies::{Energies, Kept};
use dalembert_derivations::systems::gyrostat::Gyrostat;
use field::Rational;
use mechanics::steady_rotations::Body;
use nalgebra::Vector3;
use scenes::steady_motions::{Range, SteadyMotions, SteadySearch};
use scenes::{Task, parse_titled};
use std::f64::consts::PI;
use std::fmt::Write;

/// Directions of the vertical closer than this to the third axis of the carrier, rad, are omitted, since Euler's angles
/// are singular there.
const POLE: f64 = 1e-3;

/// The greatest number of boxes that are examined.
const BOXES: usize = 200_000;

/// The directions of the vertical relative to the carrier, by both methods.
pub struct Compared {
    pub by_polynomial: Vec<Vector3<f64>>,
    pub by_boxes: Vec<Vector3<f64>>,
    /// Whether the box search left no box undecided.
    pub is_complete: bool,
    pub examined: usize,
}

impl Compared {
    /// The largest distance of a direction found by one method from the nearest one of the other; `None` if their
    /// numbers differ.
    pub fn distance(&self) -> Option<f64> {
        let nearest = |v: &Vector3<f64>, all: &[Vector3<f64>]| {
            all.iter().map(|other| (other - v).norm()).fold(f64::INFINITY, f64::min)
        };
        let (a, b) = (&self.by_polynomial, &self.by_boxes);
        let all = a.iter().map(|v| nearest(v, b)).chain(b.iter().map(|v| nearest(v, a)));
        (a.len() == b.len()).then(|| all.fold(0.0, f64::max))
    }
}

/// A text model of the bodies of a gyrostat in Euler's angles; the rotor's speed is that of a cyclic coordinate.
pub fn text(bodies: &Gyrostat<f64>) -> String {
    let Gyrostat { carrier, rotor, gravity } = bodies;
    let (c, h, axis, inertia) = (carrier.centre, rotor.centre, rotor.axis, carrier.inertia);
    let mut out = "title = \"A gyrostat\"\ngravity = \"g*N.z\"\n\n[parameters]\n".to_owned();
    let mut parameter = |name: &str, value: f64, unit: &str| {
        // writing to a String cannot fail
        let _ = writeln!(out, "{name} = \"{value:?} {unit}\"");
    };
    parameter("m0", carrier.mass, "kg");
    parameter("m1", rotor.mass, "kg");
    parameter("A", rotor.axial, "kg m^2");
    parameter("B", rotor.transverse, "kg m^2");
    parameter("g", *gravity, "m/s^2");
    parameter("alpha", axis.y.atan2(axis.x), "rad");
    parameter("beta", axis.x.hypot(axis.y).atan2(axis.z), "rad");
    for k in 0..3 {
        parameter(&format!("c{}", k + 1), c[k], "m");
        parameter(&format!("h{}", k + 1), h[k], "m");
        for j in k..3 {
            parameter(&format!("J{}{}", k + 1, j + 1), inertia[(k, j)], "kg m^2");
        }
    }
    out + BODIES
}

const BODIES: &str = r#"
[coordinates]
psi = "rad"
theta = "rad"
phi = "rad"
spin = "rad"

[frames]
F = "N turned psi about z"
E = "F turned theta about x"
C = "E turned phi about z"
S = "C turned alpha about z"
T = "S turned beta about y"
R = "T turned spin about z"

[points]
G0 = "O + c1*C.x + c2*C.y + c3*C.z"
G1 = "O + h1*C.x + h2*C.y + h3*C.z"

[bodies.carrier]
frame = "C"
centre = "G0"
mass = "m0"
inertia = { axes = "C", xx = "J11 - m0*(c2^2 + c3^2)", yy = "J22 - m0*(c3^2 + c1^2)", zz = "J33 - m0*(c1^2 + c2^2)", xy = "J12 + m0*c1*c2", xz = "J13 + m0*c1*c3", yz = "J23 + m0*c2*c3" }

[bodies.rotor]
frame = "R"
centre = "G1"
mass = "m1"
inertia = { axes = "T", xx = "B", yy = "B", zz = "A" }

[start]
theta = "1 rad"
"#;

/// The results of both methods for an angular velocity about the vertical and a relative rotor speed, rad/s; `None` if
/// rotations form families.
pub fn compared(bodies: &Gyrostat<Rational>, w: Rational, speed: Rational) -> Option<Compared> {
    let energies = Energies::of(bodies);
    let (tensor, share) = energies.quadratic(Kept::RelativeSpeed);
    let body = Body::new(&tensor, &share, &Root::rational(speed)?, &energies.weight)?;
    let all = body.rotations(w)?;
    if all.motions.len() > all.isolated() {
        return None;
    }
    let directions = all.boxes(64)?.into_iter().map(|v| Vector3::from(v.each_ref().map(Enclosure::to_f64)));
    let by_polynomial = directions.filter(|v| v.x.hypot(v.y) > POLE.sin()).collect();

    let text = text(&super::rounded(bodies));
    let (_, model) = parse_titled("gyrostat.toml", &text, Task::Vary).unwrap_or_else(|error| panic!("{error}"));
    let point = |value: Rational| Range { from: value.to_f64(), to: value.to_f64() };
    let ranges = [("theta", Range { from: POLE, to: PI - POLE }), ("psi'", point(w)), ("spin'", point(speed))];
    let asked = SteadySearch {
        ranges: ranges.map(|(name, range)| (name.to_owned(), range)).to_vec(),
        boxes: BOXES,
        ..SteadySearch::default()
    };
    let found = SteadyMotions::of(&model, &asked, || true).expect("steady motions are sought");
    let direction = |state: &[f64]| {
        let ((sin, cos), (s, c)) = (state[1].sin_cos(), state[2].sin_cos());
        Vector3::new(sin * s, sin * c, cos)
    };
    let by_boxes = found.motions.iter().map(|motion| direction(&motion.state)).collect();
    Some(Compared { by_polynomial, by_boxes, is_complete: found.is_complete(), examined: found.examined })
}
