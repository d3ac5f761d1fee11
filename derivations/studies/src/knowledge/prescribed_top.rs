//! A symmetric top under the torques of Mukharlyamov's inverse problem, for which given functions are integrals;
//! margins of its law.

use field::Scalar;
use nalgebra::Vector3;
use simulation::events::{Margin, Margins};
use simulation::knowledge::{Diagnosis, Ended, Knowledge, submit};
use simulation::models::Modelled;
use systems::variable_top::{Attitude, poisson};

/// The name in the key `known_as` of scene files.
pub const NAME: &str = "prescribed_top";

/// The name of the scene's output p g2 - q g1.
pub const NODDING: &str = "nodding";

submit! { Knowledge {
    name: NAME,
    summary: "a symmetric top under the moments that lead its integrals, after Mukharlyamov",
    parameters: &["A", "C", "static_moment", "g", "aim", "k"],
    columns: &["F.q0", "F.q1", "F.q2", "F.q3", "F.wx", "F.wy", "F.wz", NODDING],
    equations: &[include_str!("../../../../scenes/failures/nodding_top.toml")],
    diagnosis,
    margins,
    ..Knowledge::EMPTY
} }

/// The fraction of its initial value below which A p g2 - q g1 counts as zero, the singularity of the law.
const NEAR: f64 = 1e-2;

fn diagnosis(run: &Ended<'_>) -> Option<Diagnosis> {
    let place = run.trajectory.column(NODDING)?;
    let first = run.trajectory.rows.first()?[place];
    let what = "p g2 = q g1: the inclination of the axis becomes stationary, where the moments that lead the integrals are infinite";
    let is_near = run.last(NODDING).abs() < NEAR * first.abs();
    (run.has_left_its_law() || is_near).then(|| Diagnosis { what: what.to_owned(), at: None })
}

/// (p, q, r) and the vertical in the axes of the top, from its quaternion and angular velocity.
fn attitude<S: Scalar>(quaternion: [S; 4], spin: [S; 3]) -> Attitude<S> {
    let [w, x, y, z] = quaternion;
    let two = S::int(2);
    let vertical = Vector3::new(
        two * (x * z - w * y),
        two * (y * z + w * x),
        w.squared() - x.squared() - y.squared() + z.squared(),
    );
    Attitude { spin: spin.into(), vertical }
}

/// The expression p g2 - q g1, which is the rate of the inclination of the axis.
pub fn nodding<S: Scalar>(at: &Attitude<S>) -> S {
    at.spin.x * at.vertical.y - at.spin.y * at.vertical.x
}

/// The margin of the law: the rate of the axis' inclination, with its initial sign.
fn margins(scene: &dyn Modelled, states: &[String]) -> Option<Box<Margins>> {
    const STATE: [&str; 7] = ["F.q0", "F.q1", "F.q2", "F.q3", "F.wx", "F.wy", "F.wz"];
    let mut places = [0; 7];
    for (place, name) in places.iter_mut().zip(STATE) {
        *place = states.iter().position(|state| state == name)?;
    }
    let parts = move |y: &[f64]| places.map(|place| y[place]);
    let at = |[q0, q1, q2, q3, p, q, r]: [f64; 7]| attitude([q0, q1, q2, q3], [p, q, r]);
    let mut start = [0.0; 7];
    for (value, name) in start.iter_mut().zip(STATE) {
        *value = scene.value(name)?;
    }
    let sign = nodding(&at(start)).signum();
    let what = "p g2 = q g1: the inclination of the axis is stationary, and no moment leads the integrals";
    Some(Box::new(move |_, y, dy| {
        let (now, [.., p, q, _]) = (at(parts(y)), parts(dy));
        let vertical = poisson(&now);
        let rate = p * now.vertical.y + now.spin.x * vertical.y - q * now.vertical.x - now.spin.y * vertical.x;
        vec![Margin { value: sign * nodding(&now), rate: sign * rate, what, ..Margin::default() }]
    }))
}
