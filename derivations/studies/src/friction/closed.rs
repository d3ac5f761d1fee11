//! Motions with friction in closed form: what runs are compared with.

use super::course::Course;
use super::rough::Rough;
use super::scene::RoughScene;
use crate::regimes::critical;
use field::{Analytic, Circle, Scalar};

/// A comparison: what, and the largest relative deviation.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    pub what: &'static str,
    pub deviation: f64,
}

/// alpha'^2 as a function of alpha while the uniform ladder slides with equal friction, up where it is negative, from
/// (alpha_0, alpha_0'^2): (J + m l^2 cos 2phi) alpha'' = m g l sin(alpha - 2phi) + m l^2 sin 2phi alpha'^2, f = tan phi.
pub fn ladder(friction: f64, gravity: f64, half_length: f64, [start, squared]: [f64; 2], alpha: f64) -> f64 {
    let twice = 2.0 * friction.atan();
    let whole = 1.0 / 3.0 + twice.cos();
    let (k, p) = (gravity / (half_length * whole), twice.sin() / whole);
    let particular = |a: f64| -2.0 * k / (1.0 + 4.0 * p * p) * (2.0 * p * (a - twice).sin() + (a - twice).cos());
    particular(alpha) + (squared - particular(start)) * (2.0 * p * (alpha - start)).exp()
}

/// x1'^2 as a function of theta while the steered rod of equal masses slides without a drive (f < 0 backwards), from
/// (theta_0, x1'_0^2): v' + 2 f v = l g (cos theta - f sin theta).
pub fn steered(friction: f64, gravity: f64, length: f64, [start, squared]: [f64; 2], theta: f64) -> f64 {
    let weight = length * gravity;
    let q = weight * (1.0 - 2.0 * friction * friction) / (1.0 + 4.0 * friction * friction);
    let particular = |a: f64| friction * (weight + 2.0 * q) * a.cos() + q * a.sin();
    particular(theta) + (squared - particular(start)) * (-2.0 * friction * (theta - start)).exp()
}

/// When a climbed ladder that stands begins to slide: both reactions are on their cones.
pub fn climbed<S: Scalar>(
    friction: S,
    [own, load]: [S; 2],
    half_length: S,
    speed: S,
    Circle { cos, sin }: Circle<S>,
) -> S {
    let wall = friction * (own + load) / (S::one() + friction.squared());
    let moment = S::int(2) * half_length * wall * (cos + friction * sin) - own * half_length * sin;
    moment / (load * sin) / speed
}

impl RoughScene {
    /// A run beside the closed form of its motion, where there is one.
    pub fn check(&self, course: &Course) -> Option<Check> {
        match &self.system {
            Rough::Ladder(it) if uniform(it.inertia, it.mass, it.half_length) && it.friction[0] == it.friction[1] => {
                let up = |slides: &[i8]| match slides {
                    [-1, 1] => Some(1.0),
                    [1, -1] => Some(-1.0),
                    _ => None,
                };
                let exact =
                    |sign: f64, start, alpha| ladder(sign * it.friction[0], it.gravity, it.half_length, start, alpha);
                let what = "square of the angular velocity while both ends slide, beside its quadrature";
                largest(course, "angular_velocity", up, exact).map(|deviation| Check { what, deviation })
            }
            Rough::SteeredRod(it) if it.guided == it.free && it.drive == 0.0 => {
                let way = |slides: &[i8]| (slides != [0]).then(|| f64::from(slides[0]));
                let exact = |sign: f64, start, theta| steered(sign * it.friction, it.gravity, it.length, start, theta);
                let what = "square of the sliding velocity beside its closed form";
                largest(course, "sliding_guide", way, exact).map(|deviation| Check { what, deviation })
            }
            Rough::ClimbedLadder(it) if it.ladder.friction[0] == it.ladder.friction[1] => {
                let angle = course.column("angle")?;
                let after = course.log.windows(2).find(|two| two[0].slides == [0, 0, 0] && two[1].slides != [0, 0, 0]);
                let slip = &after?[1];
                let weights = [it.ladder.mass * it.ladder.gravity, it.weight];
                let exact =
                    climbed(it.ladder.friction[0], weights, it.ladder.half_length, it.speed, slip.row[angle].circle());
                let what = "the time at which it slips, by statics with both reactions on their cones";
                Some(Check { what, deviation: (slip.time - exact).abs() / exact.abs().max(1.0) })
            }
            Rough::SlenderRod(it) if course.jammed && !course.log.is_empty() => {
                let end = *course.last().get(course.column("angle")?)?;
                let kappa = it.mass * it.half_length * it.half_length / it.inertia;
                let least = critical::rod(kappa, end.circle());
                let what = "the friction that is critical at the angle of the end, beside that of the scene";
                Some(Check { what, deviation: (least - it.friction).abs() / it.friction })
            }
            _ => None,
        }
    }
}

fn uniform(inertia: f64, mass: f64, half_length: f64) -> bool {
    (inertia * 3.0 - mass * half_length * half_length).abs() <= 1e-12 * inertia
}

/// Of the square of a velocity, in the regimes that have a closed form, from the start of each.
fn largest(
    course: &Course,
    velocity: &str,
    form: impl Fn(&[i8]) -> Option<f64>,
    exact: impl Fn(f64, [f64; 2], f64) -> f64,
) -> Option<f64> {
    let (angle, velocity) = (course.column("angle")?, course.column(velocity)?);
    let mut largest = None;
    for (place, line) in course.log.iter().enumerate() {
        let Some(sign) = form(&line.slides) else { continue };
        let end = course.log.get(place + 1).map_or(f64::INFINITY, |next| next.time);
        let start = [line.row[angle], line.row[velocity].powi(2)];
        let size = start[1].max(1.0);
        let rows = course.times.iter().zip(&course.rows).filter(|(time, _)| (line.time..end).contains(*time));
        for row in rows.map(|(_, row)| row).chain(course.log.get(place + 1).map(|next| &next.row)) {
            let off = (row[velocity].powi(2) - exact(sign, start, row[angle])).abs() / size;
            largest = Some(f64::max(largest.unwrap_or(0.0), off));
        }
    }
    largest
}
