//! Bodies that roll, and crank and slider: conservative systems, or with given forces only.
//!
//! A charted system needs nothing but names: its law is Appell's equations, its energy T, its power that of the given
//! forces.

use super::points::{self, Turning};
use super::rewritten::{Rewritten, redundant};
use super::{Amiss, Diagnosis, Ended, Mechanism};
use crate::stabilisation::law::Stabilised;
use field::{Analytic, Over, Scalar, Tangent};
use mechanics::constrained::appell::rates;
use mechanics::constrained::energies::{self, Reduced};
use mechanics::constrained::motion::{Motion, velocity};
use mechanics::constrained::{Charted, State, kinetic_energy};
use mechanics::differentiate::along;
use reader::Quantity;
use simulation::Margin;
use systems::crank_slider::CrankSlider;
use systems::disc::Disc;
use systems::knife_edge::KnifeEdge;

/// (q, p) of a slice.
fn parts<S: Copy, const K: usize, const R: usize>(y: &[S]) -> ([S; K], [S; R]) {
    (std::array::from_fn(|i| y[i]), std::array::from_fn(|j| y[K + j]))
}

/// (q', p') by Appell's equations; no number where a field depends on others, which every integrator refuses.
pub fn charted<Q, S, const N: usize, const K: usize, const R: usize>(system: &Q, time: S, y: &[S], dy: &mut [S])
where
    Q: Charted<N, K, R, Given = f64>,
    S: Over<f64> + Analytic,
{
    let (q, p) = parts::<S, K, R>(y);
    let motion: Motion<S, N, R> = Motion::at(system, time, q, p);
    let found = rates(system, &motion, system.force(&motion.state));
    dy[..K].copy_from_slice(&system.rates(time, q, p));
    dy[K..].copy_from_slice(&found.unwrap_or([S::zero() / S::zero(); R]));
}

/// T, and the power of the given forces.
pub fn balance<Q, S, const N: usize, const K: usize, const R: usize>(system: &Q, time: S, y: &[S]) -> [S; 2]
where
    Q: Charted<N, K, R, Given = f64>,
    S: Over<f64> + Analytic,
{
    let (q, p) = parts::<S, K, R>(y);
    let state = State { time, place: system.place(time, q), velocity: velocity(system, time, q, p) };
    [kinetic_energy(system.masses(), state.velocity), power(system.force(&state), state.velocity)]
}

/// X.x', W.
pub fn power<S: Scalar, const N: usize>(force: [S; N], velocity: [S; N]) -> S {
    force.into_iter().zip(velocity).fold(S::zero(), |sum, (force, rate)| sum + force * rate)
}

impl Mechanism for Disc<f64> {
    const NAME: &'static str = "disc";
    const SUMMARY: &'static str = "a thin disc that rolls on a horizontal plane";
    const STATE: &'static [Quantity] = &[
        Quantity::any("x", "m", "place of the centre"),
        Quantity::any("y", "m", "place of the centre, across"),
        Quantity::any("psi", "rad", "direction of the line in which the disc's plane meets the ground"),
        Quantity::any("theta", "rad", "angle from the vertical to the axis"),
        Quantity::any("phi", "rad", "angle by which the disc has turned about its axis"),
        Quantity::any("dpsi", "rad/s", "rate of psi"),
        Quantity::any("dtheta", "rad/s", "rate of theta"),
        Quantity::any("dphi", "rad/s", "rate of phi"),
    ];

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        Disc::read(source)
    }

    fn rates<S: Over<f64> + Analytic>(&self, time: S, y: &[S], dy: &mut [S]) {
        charted::<_, S, 9, 5, 3>(self, time, y, dy);
    }

    fn energy<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        balance::<_, S, 9, 5, 3>(self, time, y)[0]
    }

    fn power<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        balance::<_, S, 9, 5, 3>(self, time, y)[1]
    }

    fn amiss(&self, start: &[f64]) -> Vec<Amiss> {
        self.outside(start, start)
            .map(|what| Amiss { name: "theta", what, accepted: INCLINED.to_owned() })
            .into_iter()
            .collect()
    }

    fn margins(&self, _start: &[f64], y: &[f64], dy: &[f64]) -> Vec<Margin> {
        let what = "the disc is not above the plane: it lies flat or beyond";
        vec![Margin { value: y[3].sin(), rate: y[3].cos() * dy[3], what, ..Margin::default() }]
    }

    fn rewritten(&self, start: &[f64]) -> Vec<Rewritten> {
        let (q, p) = parts::<f64, 5, 3>(start);
        points::redundant::<_, 9, 6, 5, 3, 2>(self, (q, p, [q[2], q[4]]), |at, [psi, phi]| {
            let ([.., up], [e, f]) = leaning(at);
            let sine = e.value.hypot(f.value);
            let ([dpsi, dphi], theta) = (turning_of_the_disc(at), sine.atan2(up.value));
            vec![at.place[0], at.place[1], psi, theta, phi, dpsi, -up.slope / sine, dphi]
        })
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let what = "the disc lies flat, where it touches the plane with its whole rim and Euler's angles are none";
        (run.left || run.last[3].sin() < 1e-2).then_some(Diagnosis { what, at: None })
    }
}

/// The axis n = e x e', and the heights of e and e', with their rates.
fn leaning<S: Scalar>(at: &State<S, 9>) -> ([Tangent<S>; 3], [Tangent<S>; 2]) {
    let [_, _, _, ex, ey, ez, fx, fy, fz] = along(at.place, at.velocity);
    ([ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx], [ez, fz])
}

/// psi' and phi': n is along (sin psi, -cos psi), the heights of e and e' are as sin phi and cos phi.
fn turning_of_the_disc<S: Scalar>(at: &State<S, 9>) -> [S; 2] {
    let ([nx, ny, _], [e, f]) = leaning(at);
    [turn(nx, -ny), turn(e, f)]
}

/// The rate of the angle whose sine and cosine these are, but for a common factor.
fn turn<S: Scalar>(sine: Tangent<S>, cosine: Tangent<S>) -> S {
    let area = sine.slope * cosine.value - sine.value * cosine.slope;
    area / (sine.value.squared() + cosine.value.squared())
}

impl Turning<9, 2> for Disc<f64> {
    fn turning<S: Over<f64>>(&self, at: &State<S, 9>) -> [S; 2] {
        turning_of_the_disc(at)
    }
}

impl Turning<4, 1> for KnifeEdge<f64> {
    fn turning<S: Over<f64>>(&self, at: &State<S, 4>) -> [S; 1] {
        let [_, _, c, s] = along(at.place, at.velocity);
        [turn(s, c)]
    }
}

const INCLINED: &str = "an angle between 0 and 180 degrees is accepted; at 90 degrees the disc stands upright";

impl Mechanism for KnifeEdge<f64> {
    const NAME: &'static str = "knife_edge";
    const SUMMARY: &'static str = "a sleigh on a knife edge on an inclined plane, after Chaplygin";
    const STATE: &'static [Quantity] = &[
        Quantity::any("x", "m", "place of the centre down the slope"),
        Quantity::any("y", "m", "place of the centre across the slope"),
        Quantity::any("theta", "rad", "direction of the blade"),
        Quantity::any("u", "m/s", "speed of the blade along itself"),
        Quantity::any("w", "rad/s", "rate of theta"),
    ];

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        KnifeEdge::read(source)
    }

    fn rates<S: Over<f64> + Analytic>(&self, time: S, y: &[S], dy: &mut [S]) {
        charted::<_, S, 4, 3, 2>(self, time, y, dy);
    }

    fn energy<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        balance::<_, S, 4, 3, 2>(self, time, y)[0]
    }

    fn power<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        balance::<_, S, 4, 3, 2>(self, time, y)[1]
    }

    fn rewritten(&self, start: &[f64]) -> Vec<Rewritten> {
        let ((q, p), d) = (parts::<f64, 3, 2>(start), self.offset);
        points::redundant::<_, 4, 2, 3, 2, 1>(self, (q, p, [q[2]]), move |at, [theta]| {
            let ([x, y, c, s], [dx, dy, dc, ds]) = (at.place, at.velocity);
            vec![x, y, theta, c * (dx - d * dc) + s * (dy - d * ds), c * ds - s * dc]
        })
    }
}

impl Mechanism for CrankSlider<f64> {
    const NAME: &'static str = "crank_slider";
    const SUMMARY: &'static str = "crank, connecting rod and slider, in the crank's angle";
    const STATE: &'static [Quantity] = &[
        Quantity::any("angle", "rad", "angle of the crank from the slider's line"),
        Quantity::any("speed", "rad/s", "rate of the angle"),
    ];
    const SHOWN: &'static [Quantity] =
        &[Quantity::any("slider", "m", "place of the slider"), Quantity::any("slide", "m/s", "velocity of the slider")];

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        CrankSlider::read(source)
    }

    fn rates<S: Over<f64> + Analytic>(&self, time: S, y: &[S], dy: &mut [S]) {
        let law = Stabilised::<_, 1, 0> { system: &Reduced(self), damping: 0.0, stiffness: 0.0 };
        dy[0] = y[1];
        [dy[1]] = law.acceleration(&turning(time, y));
    }

    fn energy<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        energies::energy(&Reduced(self), &turning(time, y))
    }

    fn power<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        energies::power(&Reduced(self), &turning(time, y))
    }

    fn shown(&self, time: f64, y: &[f64]) -> Vec<f64> {
        let (q, dq) = Reduced(self).motion(time, [y[0]], [y[1]]);
        vec![q[1], dq[1]]
    }

    fn rewritten(&self, start: &[f64]) -> Vec<Rewritten> {
        let (q, dq) = Reduced(self).motion(0.0, [start[0]], [start[1]]);
        redundant::<_, 2, 1>(self, &[q, dq].concat(), |y| vec![y[0], y[2]])
    }

    fn amiss(&self, _start: &[f64]) -> Vec<Amiss> {
        rod_too_short(self).into_iter().collect()
    }
}

fn turning<S: Copy>(time: S, y: &[S]) -> State<S, 1> {
    State { time, place: [y[0]], velocity: [y[1]] }
}

/// The crank turns all the way round only with a rod that is longer.
pub fn rod_too_short(mechanism: &CrankSlider<f64>) -> Option<Amiss> {
    let accepted = format!("a rod longer than the crank, {} m, is accepted", mechanism.crank);
    let what = "the rod is no longer than the crank: the crank cannot turn round";
    (mechanism.rod <= mechanism.crank).then_some(Amiss { name: "rod", what, accepted })
}
