//! Velocities and accelerations of points, compared with independent derivations.

use crate::systems::{disc, entries, two_bodies};
use dalembert_model::{Model, Source, Trace};
use symbolic::{Hypotheses, apart};

/// Asserts that vector expressions are zero for every motion.
pub fn vanish(source: Source, vectors: &[&str]) {
    let along = |axis: &str| -> Vec<(String, String)> {
        vectors.iter().enumerate().map(|(k, is)| (format!("{axis}{k}"), format!("({is}) . N.{axis}"))).collect()
    };
    let named: Vec<(String, String)> = ["x", "y", "z"].into_iter().flat_map(along).collect();
    let pairs: Vec<(&str, &str)> = named.iter().map(|(name, is)| (name.as_str(), is.as_str())).collect();
    let source = Source { outputs: entries(&pairs), ..source };
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        for output in &model.outputs {
            let decided = symbolic::decide(trace.scalar(output.is), &Hypotheses::none());
            assert!(decided.is_zero(), "{}: {decided}", output.name);
        }
    });
}

/// The point E of the arm depends on coordinates of its own definition; the pin of the hand is there. Arm and hand must move it alike.
#[test]
fn a_point_of_a_body_moves_as_the_body_does() {
    vanish(
        two_bodies(),
        &[
            "velocity(arm at E) - velocity(E)",
            "velocity(hand at E) - velocity(E)",
            "acceleration(arm at E) - acceleration(E)",
            "acceleration(hand at E) - acceleration(E)",
        ],
    );
}

/// Coriolis: velocity and acceleration relative to a moving frame, composed with the motion of the frame.
#[test]
fn a_motion_seen_from_a_frame_lacks_what_the_frame_adds() {
    let w = "angular_velocity(C)";
    vanish(
        disc(),
        &[
            &format!("velocity(G in C) - velocity(G) + cross({w}, G - O)"),
            &format!(
                "acceleration(G) - acceleration(G in C) - 2*cross({w}, velocity(G in C)) - cross(rate({w}), G - O) \
                 - cross({w}, cross({w}, G - O))"
            ),
            &format!("rate(F - G in C) - rate(F - G) + cross({w}, F - G)"),
            "angular_velocity(D in C) - spin'*C.y",
        ],
    );
}
