//! Check of bodies that rotate relative to the axes of their inertia tensor.
//!
//! Let the inertia tensor I be constant in axes relative to which the body has the angular velocity s. In the body it changes at the rate
//!
//!   s x I - I x s .
//!
//! This rate is zero if I has equal moments about all axes perpendicular to s, as for a disc that spins in the axes of its fork.

use crate::equations::vanishes;
use crate::{Body, Fault, Inertia, Model, Trace};
use field::Rational;
use symbolic::{Sym, apart, substitute_all};

/// Returns the faults of bodies whose inertia tensor would change in the body, which is impossible for a rigid body.
pub(super) fn turning(model: &Model) -> Vec<Fault> {
    let in_other_axes = |body: &&Body| matches!(&body.inertia, Some(Inertia::Tensor { axes, .. }) if body.frame.is_some_and(|frame| frame != *axes));
    if !model.bodies.iter().any(|body| in_other_axes(&body)) {
        return Vec::new();
    }
    apart(|| {
        let trace = Trace::of(model);
        let bodies = model.bodies.iter().filter(in_other_axes);
        bodies.filter(|body| changes(&trace, body)).map(|body| fault(model, body)).collect()
    })
}

fn fault(model: &Model, body: &Body) -> Fault {
    let frame = |frame: Option<crate::FrameId>| frame.map_or("N", |frame| model.frames[frame.0].name.as_str());
    let own = frame(body.frame);
    let axes = frame(match &body.inertia {
        Some(Inertia::Tensor { axes, .. }) => Some(*axes),
        _ => None,
    });
    Fault::at(
        body.inertia_at.clone(),
        format!(
            "`{}` turns with `{own}` in the axes of its inertia, `{axes}`: in the body this inertia would change",
            body.name
        ),
        format!("its moments differ about axes of `{axes}` that `{own}` turns through"),
        format!(
            "axes that rest in `{own}`, or equal moments about the two axes of `{axes}` across the one about which the body spins"
        ),
    )
}

/// Returns whether the inertia tensor changes in the body. Parameters with values are replaced by these.
fn changes(trace: &Trace<'_>, body: &Body) -> bool {
    let (Some(inertia @ Inertia::Tensor { axes, .. }), Some(frame)) = (&body.inertia, body.frame) else { return false };
    let [x, y, z] = trace.express(trace.turning_beside(frame, *axes), *axes);
    let spin = crate::Vector { frame: *axes, components: [x, y, z] };
    let rates: Vec<Sym> = (0..3)
        .flat_map(|axis| {
            let along = crate::Vector::axis(*axes, axis);
            let first = trace.cross(spin, trace.inertia_times(inertia, along));
            let second = trace.inertia_times(inertia, trace.cross(spin, along));
            std::array::from_fn::<Sym, 3, _>(|part| first.components[part] - second.components[part])
        })
        .collect();
    let values = trace.parameters.iter().zip(&trace.model.parameters);
    let values: Vec<(Sym, Sym)> = values
        .filter_map(|(&letter, parameter)| Some((letter, Sym::constant(Rational::decimal(parameter.value?)))))
        .collect();
    !substitute_all(&rates, &values).into_iter().all(vanishes)
}
