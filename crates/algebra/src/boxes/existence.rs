//! Proof that a box contains exactly one zero.

use super::Equations;
use super::newton::Local;
use super::search::Zero;
use field::Interval;

/// The largest number of Newton steps towards a zero near a box.
const STEPS: usize = 8;

/// The number of box sizes tried, each an eighth of the one before.
const SIZES: i32 = 8;

/// The smallest half width of a box for the proof, relative to 1 plus the magnitude of the zero.
const ROUNDING: f64 = 1e-13;

/// The largest number of Newton steps that narrow an enclosure.
const NARROWINGS: usize = 20;

/// A zero near a box, approximated by Newton's method and proved in a box around it of up to twice the size; `None`
/// where this fails.
pub(super) fn shown(equations: &mut dyn Equations, near: &[Interval]) -> Option<Zero> {
    let mut at: Vec<f64> = near.iter().map(|part| part.middle()).collect();
    for _ in 0..STEPS {
        let local = Local::of(equations, &points(&at))?;
        at.iter_mut().zip(&local.step).for_each(|(at, step)| *at -= step.middle());
        // in a box as narrow as rounding the proof may fail, in a wider neighbourhood it succeeds
        let reach = |at: f64, near: &Interval| near.width().max(1e-12 * near.size()).max(ROUNDING * (1.0 + at.abs()));
        let strays = |(at, near): (&f64, &Interval)| (at - near.middle()).abs() > reach(*at, near);
        if at.iter().any(|at| !at.is_finite()) || at.iter().zip(near).any(strays) {
            return None;
        }
    }
    (0..SIZES).find_map(|size| {
        let part = 8.0_f64.powi(-size);
        // the half width is never below rounding
        let radius = |(at, near): (&f64, &Interval)| (part * near.width()).max(ROUNDING * (1.0 + at.abs()));
        let alone: Vec<Interval> =
            at.iter().zip(near).map(|pair| Interval::new(pair.0 - radius(pair), pair.0 + radius(pair))).collect();
        let local = Local::of(equations, &alone)?;
        let inside = local.krawczyk(&alone);
        let is_inside = inside.iter().zip(&alone).all(|(inside, alone)| inside.is_inside(*alone));
        is_inside.then(|| Zero { enclosure: enclosed(equations, inside), alone })
    })
}

/// The enclosure of the zero in a box that contains one, as narrow as rounding allows.
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
