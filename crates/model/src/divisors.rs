//! Descriptions of the divisors of a normal form, such as |F.q|^2 for the quaternion of a free frame. Divisors that cannot vanish have none.

use crate::Trace;
use crate::arena::{Part, Scalar};
use crate::parts::QUATERNION;
use crate::real_points::value_at_point;
use crate::{FrameId, ScalarId};
use symbolic::Sym;

/// Divisors with more characters are described in words.
const MOST_READ: usize = 200;

/// The number of random points at which the ratio of a divisor and a length is compared: if it is constant, the divisor is a multiple of the length.
const POINTS: u64 = 4;

/// The relative accuracy of this comparison.
const DIGITS: f64 = 1e-10;

/// The largest power of a squared quaternion norm as a cofactor of a length.
const MOST_POWER: i32 = 4;

/// Describes a divisor; `None` for a divisor that cannot vanish: a number, pi, or a product of these.
pub(crate) fn named(trace: &Trace<'_>, divisor: Sym) -> Option<String> {
    if divisor.symbols_of().iter().all(|&symbol| symbol == trace.pi) {
        return None;
    }
    let mut text = divisor.to_string();
    for FrameId(frame) in &trace.model.free {
        let name = &trace.model.frames[*frame].name;
        let square = QUATERNION.map(|part| format!("{name}.{part}^2")).join(" + ");
        for power in 2..=MOST_POWER {
            text = text.replace(&format!("({square})^{power}"), &format!("|{name}.q|^{}", 2 * power));
        }
        text = text.replace(&format!("({square})"), &format!("|{name}.q|^2"));
        text = text.replace(&square, &format!("|{name}.q|^2"));
    }
    Some(match text.len() <= MOST_READ {
        true => text,
        false if is_length(trace, divisor) => "the length in a distance, a norm or a force `between`".to_owned(),
        false => format!("an expression of {} operations", Sym::operations_of(&[divisor])),
    })
}

/// Returns whether a divisor is a multiple of a length that the model contains, up to powers of squared quaternion norms.
fn is_length(trace: &Trace<'_>, divisor: Sym) -> bool {
    let symbols = divisor.symbols_of();
    let quaternions = trace.turns().map(|(quaternion, _)| quaternion);
    let squares: Vec<Sym> = quaternions
        .filter(|parts| symbols.contains(&parts[0]))
        .map(|parts| parts.into_iter().fold(Sym::ZERO, |sum, part| sum + part * part))
        .collect();
    let parts = trace.model.arena.parts.iter().enumerate();
    let lengths = parts.filter(|(_, part)| matches!(part, Part::Scalar(Scalar::Norm(_))));
    lengths.map(|(place, _)| trace.scalar(ScalarId(place))).any(|length| {
        let is_multiple = |ratios: Option<Vec<f64>>| {
            let Some([first, rest @ ..]) = ratios.as_deref() else { return false };
            first.is_finite() && rest.iter().all(|ratio| (ratio - first).abs() <= DIGITS * first.abs())
        };
        let ratio = |powers: [i32; 2], point: u64| {
            let below = squares.iter().zip(powers);
            let below = below.map(|(&square, power)| Some(value_at_point(square, point)?.powi(power)));
            let below = below.collect::<Option<Vec<f64>>>()?.into_iter().product::<f64>();
            Some(value_at_point(divisor, point)? / (value_at_point(length, point)? * below))
        };
        let powers = (0..=MOST_POWER).flat_map(|one| (0..=MOST_POWER).map(move |other| [one, other]));
        squares.len() <= 2
            && powers.into_iter().any(|powers| is_multiple((0..POINTS).map(|point| ratio(powers, point)).collect()))
    })
}
