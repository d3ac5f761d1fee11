//! A zero that is shown: one in a box, and no other there.

use super::Equations;
use super::newton::Local;
use super::search::Zero;
use field::Interval;

/// Steps of Newton's method towards a zero near a box.
const STEPS: usize = 8;

/// Sizes of a box about it, each an eighth of the one before.
const SIZES: i32 = 8;

/// The smallest size of a box in which a zero is shown, beside one and its own size.
const ROUNDING: f64 = 1e-13;

/// Newton's steps by which an enclosure is narrowed at most.
const NARROWINGS: usize = 20;

/// A zero near a box, from which Newton's method comes to it, in a box about it of up to twice the size.
pub(super) fn shown(equations: &mut dyn Equations, near: &[Interval]) -> Option<Zero> {
    let mut at: Vec<f64> = near.iter().map(|part| part.middle()).collect();
    for _ in 0..STEPS {
        let local = Local::of(equations, &points(&at))?;
        at.iter_mut().zip(&local.step).for_each(|(at, step)| *at -= step.middle());
        // a box as narrow as rounding holds its zero no more surely than the places beside it
        let reach = |at: f64, near: &Interval| near.width().max(1e-12 * near.size()).max(ROUNDING * (1.0 + at.abs()));
        let strays = |(at, near): (&f64, &Interval)| (at - near.middle()).abs() > reach(*at, near);
        if at.iter().any(|at| !at.is_finite()) || at.iter().zip(near).any(strays) {
            return None;
        }
    }
    (0..SIZES).find_map(|size| {
        let part = 8.0_f64.powi(-size);
        // never below rounding
        let radius = |(at, near): (&f64, &Interval)| (part * near.width()).max(ROUNDING * (1.0 + at.abs()));
        let alone: Vec<Interval> =
            at.iter().zip(near).map(|pair| Interval::new(pair.0 - radius(pair), pair.0 + radius(pair))).collect();
        let local = Local::of(equations, &alone)?;
        let inside = local.krawczyk(&alone);
        let is_inside = inside.iter().zip(&alone).all(|(inside, alone)| inside.is_inside(*alone));
        is_inside.then(|| Zero { enclosure: enclosed(equations, inside), alone })
    })
}

/// The zero of a box that holds one, as narrowly as rounding allows.
fn enclosed(equations: &mut dyn Equations, mut at: Vec<Interval>) -> Vec<Interval> {
    for _ in 0..NARROWINGS {
        let Some(left) = Local::of(equations, &at).and_then(|local| local.narrowed(&at)) else { break };
        let gains = left.iter().zip(&at).any(|(left, at)| left.width() < 0.9 * at.width());
        at = left;
        if !gains {
            break;
        }
    }
    at
}

fn points(at: &[f64]) -> Vec<Interval> {
    at.iter().map(|&at| Interval::point(at)).collect()
}
