//! The stability of a steady motion in words.

use crate::spectrum;
use ::scenes::linearisation::{Linear, Stability, Standing};
use ::scenes::steady_motions::{Eigenvalues, EnclosedSpectrum, SteadyMotion, SteadyMotions, SteadyStability};

/// A sentence on the stability of a steady motion, with the reason.
pub(super) fn stability(motion: &SteadyMotion, found: &SteadyMotions) -> String {
    let cyclic = &found.cyclic;
    let energy = match found.are_in_turning_frames {
        true => "the potential energy less the kinetic energy of rest in the turning frames (Jacobi's integral)",
        false => "the potential energy",
    };
    let directions = |count: usize| if count == 1 { "one direction".to_owned() } else { format!("{count} directions") };
    match &motion.stability {
        SteadyStability::Minimum if cyclic.is_empty() => {
            format!("stable, by enclosures: {energy} has a strict minimum (Lagrange, Dirichlet)")
        }
        SteadyStability::Minimum => format!(
            "stable but for {}, by enclosures: {energy}, amended by the kinetic energy at given momenta, has a strict minimum in the others \
             (Routh)",
            cyclic.join(", ")
        ),
        SteadyStability::MinimumWithLoss => {
            format!("stable, by enclosures: {energy} has a strict minimum, and loads that depend on speeds supply no energy (Lagrange, Dirichlet)")
        }
        SteadyStability::Falls(count) => {
            format!("unstable, by enclosures: {energy} decreases in {}", directions(*count))
        }
        SteadyStability::FallsOdd(count) => format!(
            "unstable, by enclosures: the amended potential energy decreases in an odd number of directions, {count} (Thomson, Tait)"
        ),
        SteadyStability::Linear(found) if decides(found).is_some() => {
            decides(found).map(spectrum::verdict).unwrap_or_default()
        }
        // eigenvalues at one instant of a moving state decide nothing; the equations without cyclic coordinates are constant
        SteadyStability::Linear(found) if found.linear.standing == Standing::Moving => match &found.enclosed {
            Ok(enclosed) => spectrum::verdict(enclosed),
            Err(why) => format!("not decided: eigenvalues are not enclosed, since {why}"),
        },
        SteadyStability::Linear(found) if fades(&found.linear, cyclic.len()) => format!(
            "every eigenvalue has a negative real part but for zeros, which cyclic coordinates and their momenta have: asymptotically stable but for \
             {}, by numbers",
            cyclic.join(", ")
        ),
        SteadyStability::Linear(found)
            if matches!(found.linear.stability, Stability::Asymptotic { idle } if !has_reasons(found, idle)) =>
        {
            "not decided by linear equations: every eigenvalue has a negative real part but for zeros without a known reason".to_owned()
        }
        SteadyStability::Linear(found) => {
            let linear = &found.linear;
            if let Some(enclosed) = found.enclosed.as_ref().ok().filter(|own| own.by_centres().is_some()) {
                // where exact arithmetic leaves the verdict open, floating-point numbers cannot decide it either
                let by_centres = enclosed.by_centres().filter(|_| enclosed.exact.is_none());
                let by_numbers = by_centres.map_or_else(String::new, |own| format!("; by numbers, {own}"));
                return format!("{}{by_numbers}", spectrum::verdict(enclosed));
            }
            let largest = linear.eigenvalues.iter().map(|value| value[0]).fold(f64::NEG_INFINITY, f64::max);
            match linear.eigenvalues.is_empty() {
                true => linear.stability.to_string(),
                false => format!("{}; the largest real part is {largest:.6e} 1/s, by numbers", linear.stability),
            }
        }
        SteadyStability::InTouch(found) => {
            let along = match &found.enclosed {
                Ok(enclosed) => spectrum::verdict(enclosed),
                Err(why) => format!("eigenvalues are not enclosed, since {why}"),
            };
            format!(
                "stability is not decided: a contact presses there, and a small push may open it; of motions that stay in touch: {along}"
            )
        }
        SteadyStability::AtCondition(_) => "stability is not decided: a condition of the law is zero at this motion".to_owned(),
        SteadyStability::HeldByFriction => RESISTS.to_owned(),
        SteadyStability::FedByFriction => FEEDS.to_owned(),
        SteadyStability::Singular(names) => singular(names),
        SteadyStability::MinimumOnSides => {
            "stable, by enclosures: the potential energy has a strict minimum on both sides of the condition that is \
             zero there (Lagrange, Dirichlet)"
                .to_owned()
        }
        SteadyStability::FallsOnSide(count) => format!(
            "unstable, by enclosures: on one side of the condition that is zero there {energy} decreases in {}; motions on that side leave \
             along it (its unstable manifold)",
            directions(*count)
        ),
        SteadyStability::Unknown(why) => format!("stability is not decided: {why}"),
    }
}

/// The verdict where dry friction resists every motion.
pub(super) const RESISTS: &str = "stable, by enclosures: dry friction resists every motion, so that the system comes to rest nearby after a small push";

/// The verdict where dry friction has negative coefficients.
pub(super) const FEEDS: &str = "unstable, by enclosures: the coefficient of dry friction is negative, so that friction supplies power to every motion";

/// The sentence on a position that the coordinates do not describe.
pub fn singular(names: &[String]) -> String {
    let (are, s) = if names.len() == 1 { ("has", "") } else { ("have", "s") };
    format!(
        "no verdict: the mass matrix is singular there, since the coordinate{s} {} {are} no inertia: these coordinates do not describe the position, \
         and the equations hold there whatever the forces are; other coordinates do, such as angles about another axis, or Cartesian coordinates \
         with a constraint",
        names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
    )
}

/// The enclosed eigenvalues if they decide the stability, or prove that the linear equations do not decide it.
fn decides(found: &Eigenvalues) -> Option<&EnclosedSpectrum> {
    found.enclosed.as_ref().ok().filter(|found| spectrum::is_decided(found))
}

/// Whether at least `zeros` zero eigenvalues have reasons in the nonlinear equations, such as a cyclic coordinate; a zero from a force x³ has none.
fn has_reasons(found: &Eigenvalues, zeros: usize) -> bool {
    zeros == 0 || found.enclosed.as_ref().is_ok_and(|enclosed| enclosed.zeros.len() >= zeros)
}

/// Eigenvalues below this fraction of the largest count as zero.
const ROUNDING: f64 = 1e-9;

/// Whether all eigenvalues have negative real parts except for zeros, of which there are at most two for each cyclic coordinate.
fn fades(linear: &Linear, cyclic: usize) -> bool {
    let size = |[re, im]: &[f64; 2]| re.hypot(*im);
    let largest = linear.eigenvalues.iter().map(size).fold(0.0, f64::max);
    let (zeros, others): (Vec<[f64; 2]>, Vec<[f64; 2]>) =
        linear.eigenvalues.iter().partition(|value| size(value) <= ROUNDING * largest);
    let negative = others.iter().all(|[re, _]| *re < -ROUNDING * largest);
    linear.standing != Standing::Moving && !others.is_empty() && negative && (1..=2 * cyclic).contains(&zeros.len())
}

/// The stability of a motion in one or two words, and whether enclosures prove it.
pub fn verdict(motion: &SteadyMotion, cyclic: &[String]) -> (&'static str, bool) {
    match &motion.stability {
        SteadyStability::Minimum
        | SteadyStability::MinimumWithLoss
        | SteadyStability::MinimumOnSides
        | SteadyStability::HeldByFriction => ("stable", true),
        SteadyStability::Falls(_)
        | SteadyStability::FallsOdd(_)
        | SteadyStability::FallsOnSide(_)
        | SteadyStability::FedByFriction => ("unstable", true),
        SteadyStability::Linear(found) if decides(found).is_some() => {
            let word = decides(found).map_or("not decided", spectrum::word);
            (word, word != "not decided")
        }
        SteadyStability::Linear(found) => match found.by_numbers() {
            _ if found.linear.standing == Standing::Moving => ("not decided", false),
            _ if fades(&found.linear, cyclic.len()) => ("asymptotically stable", false),
            Stability::Unstable(_) => ("unstable", false),
            Stability::Asymptotic { idle } if has_reasons(found, idle) => ("asymptotically stable", false),
            _ => ("not decided", false),
        },
        SteadyStability::InTouch(_) | SteadyStability::AtCondition(_) | SteadyStability::Unknown(_) => {
            ("not known", false)
        }
        SteadyStability::Singular(_) => ("singular coordinates", false),
    }
}
