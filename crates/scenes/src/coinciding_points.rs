//! Check for forces between two points that coincide: the direction of such a force is undefined.

use crate::letters::Letters;
use crate::program::recorded;
use model::{Force, FrameId, Material, Model, Trace};

/// The names of each pair of points between which a force acts and which coincide at `state` (coordinates, then speeds) at time zero.
/// Empty if the positions have no value.
pub fn of_forces(model: &Model, state: &[f64]) -> Vec<[String; 2]> {
    let pairs: Vec<[Material; 2]> = (model.forces.iter())
        .filter_map(|force| match force {
            Force::Between { points, .. } => Some(*points),
            Force::On { .. } => None,
        })
        .collect();
    let states = model.positions() + model.speeds();
    let written = recorded(states, |time, inputs| {
        let trace = Trace::of(model);
        let between = |[from, to]: &[Material; 2]| {
            let way = trace.between(from.point, to.point);
            trace.express(way, FrameId::GROUND)
        };
        let ways: Vec<_> = pairs.iter().flat_map(between).collect();
        Letters::with_data(time, inputs).put_into(&trace, &ways)
    });
    let Ok(program) = written else { return Vec::new() };
    let mut ways = vec![f64::NAN; 3 * pairs.len()];
    let _ = program.run(0.0, &state[..states.min(state.len())], &mut ways);
    let coincide = pairs.iter().zip(ways.chunks(3)).filter(|(_, way)| way.iter().all(|part| *part == 0.0));
    coincide.map(|(pair, _)| pair.map(|end| called(model, end))).collect()
}

/// The quoted name of the body if the point is its centre of mass, else the quoted name of the point.
fn called(model: &Model, end: Material) -> String {
    let of_body = end.body.map(|body| &model.bodies[body.0]).filter(|body| body.centre == Some(end.point));
    let name = of_body.map_or(&model.points[end.point.0].name, |body| &body.name);
    if name.is_empty() { "a point".to_owned() } else { format!("`{name}`") }
}
