//! Certificates of stability by a minimum of the energy: the minors of both quadratic forms, and the rules that prove their signs.

use crate::certificate::Record;
use crate::condition_products;
use crate::conditions::Hypothesis;
use crate::energy_form::EnergyForm;
use crate::linear_motion::LinearMotion;
use crate::motion::Motion;
use crate::signs::is_written_as_positive;
use claims::Condition;
use claims::certificate::{Minimum, Part, PartProof};
use symbolic::Sym;

/// The citations of the theorems.
const MINIMUM: &str = "J. L. Lagrange; P. G. Lejeune Dirichlet, J. reine angew. Math. 32 (1846), 85-88: a minimum of the potential energy is stable; \
    J. J. Sylvester: a form is positive where its leading principal minors are; A. M. Lyapunov: a root with a positive real part is unstable";

/// A sign that the theorems require.
struct Sign<'a> {
    /// Conditions in addition to those of the claim.
    added: &'a [Condition],
    expression: Sym,
    is_strict: bool,
}

/// Records the proof that a printed condition is equivalent to a minimum of the energy. If a sign needs a rule that the second checker does not have,
/// records that there is no certificate.
pub(crate) fn minimum(
    record: &mut Record,
    (motion, assumed, known): (&Motion<'_, '_>, &[Hypothesis], &[Condition]),
    linear: &LinearMotion,
    form: &EnergyForm,
    printed: Sym,
) {
    if !record.is_wanted() {
        return;
    }
    let holds = [Condition::Positive(printed)];
    let stable: Vec<Condition> = form.principal.iter().copied().map(Condition::NotNegative).collect();
    let of_inertia = form.inertia.iter().map(|&expression| Sign { added: &[], expression, is_strict: true });
    let of_energy = form.potential.iter().map(|&expression| Sign { added: &holds, expression, is_strict: true });
    let of_printed = Sign { added: &stable, expression: printed, is_strict: false };
    let signs = of_inertia.chain(of_energy).chain([of_printed]);
    let implied: Option<Vec<Part>> = signs.map(|sign| implied(record, (motion, assumed, known), &sign)).collect();
    let Some(implied) = implied.filter(|_| !form.is_gyroscopic && !form.has_momenta) else {
        return record.leave_out();
    };
    let trace = motion.trace;
    record.part(motion, assumed, &holds, |relations| {
        let mut places = |expressions: &[Sym]| relations.recorder.places(expressions.iter().copied());
        PartProof::Minimum(Box::new(Minimum {
            theorem: MINIMUM,
            equations: places(&linear.equations),
            coordinates: places(&trace.coordinates),
            speeds: places(&trace.speeds),
            accelerations: places(&trace.accelerations),
            printed: places(&[printed])[0],
            inertia: places(&form.inertia),
            leading: places(&form.potential),
            principal: places(&form.principal),
            implied,
        }))
    });
}

/// The proof of a sign: by the terms without simplification, or by products of conditions; `None` without such a proof.
fn implied(
    record: &mut Record,
    (motion, assumed, known): (&Motion<'_, '_>, &[Hypothesis], &[Condition]),
    sign: &Sign<'_>,
) -> Option<Part> {
    let all = [known, sign.added].concat();
    let as_written =
        is_written_as_positive(sign.expression, &all).is_some_and(|is_strict| is_strict || !sign.is_strict);
    let products = match as_written {
        true => None,
        false => {
            let (list, products) = condition_products::proof(sign.expression, sign.is_strict, &all)?;
            // the cited theorem does not cover conditions with a variable denominator
            (list.len() == all.len() + 1).then_some(())?;
            Some(products)
        }
    };
    Some(record.shown_by_signs(motion, assumed, (sign.expression, sign.is_strict), &all, products.as_deref()))
}
