//! Check of the physical dimensions of the torque and the current rates.

use super::instant::{Doubt, Instant};
use super::verdict_of;
use claims::finding::PropertyVerdict;
use symbolic::{Dimension, Sym, dimension};

/// Checks that M is in N m and di/dt in A/s, given the units of the parameters.
pub(super) fn dimensions(at: &Instant, parameters: &[(String, Dimension)]) -> PropertyVerdict {
    let turning = Dimension::none() / Dimension::time();
    let of = |name: &str| match name {
        "the angle" => Some(Dimension::none()),
        "the slip" => Some(turning),
        _ if name.starts_with("current ") => Some(Dimension::current()),
        _ => parameters.iter().find(|(known, _)| known == name).map(|(_, dimension)| *dimension),
    };
    let torque = Dimension::of(1, 2, -2, 0);
    let agrees = |what: &str, law: Sym, wanted: Dimension| match dimension(law, &of) {
        Ok(Some(found)) if found != wanted => Err(Doubt::Off(format!("{what} is {found}, not {wanted}"))),
        Ok(_) => Ok(()),
        Err(mismatch) => Err(Doubt::Off(format!("in {what} {mismatch}"))),
    };
    let rates = at.rates.iter().map(|&rate| ("the rate of a current", rate, Dimension::current() / Dimension::time()));
    let mut all = std::iter::once(("the torque", at.torque, torque)).chain(rates);
    verdict_of(all.try_for_each(|(what, law, wanted)| agrees(what, law, wanted)), "the units of the parameters agree")
}
