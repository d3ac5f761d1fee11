//! Accelerations computed recursively over the tree of bodies, compared with those of the mass matrix.

use super::systems::{chain, disc, double_pendulum, held, sleigh};
use dalembert_model::equations::{Equations, has_tree, solved_over_tree, vanishes};
use dalembert_model::{LoadSource, Model, Source, Trace};
use symbolic::apart;

/// Returns whether both methods give identical expressions; `None` if the system is no tree.
fn agree(source: &Source) -> Option<bool> {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let (accelerations, multipliers) = solved_over_tree(&trace)?.expect("it is regular");
        let (by_matrix, lambda) = Equations::of(&trace).solved().expect("it is regular");
        let pairs = accelerations.iter().zip(&by_matrix).chain(multipliers.iter().zip(&lambda));
        Some(pairs.map(|(a, b)| *a - *b).all(vanishes))
    })
}

#[test]
fn bodies_in_a_tree_have_the_accelerations_of_their_mass_matrix() {
    for source in [double_pendulum(false), double_pendulum(true), chain(3), disc(), sleigh()] {
        assert_eq!(agree(&source), Some(true), "{source:?}");
    }
}

/// Constrained trees: a double pendulum with one constraint and a disc with three.
#[test]
fn constraints_on_a_tree_have_the_multipliers_of_the_mass_matrix() {
    let mut loop_of = double_pendulum(true);
    loop_of.constraints = vec![held("path", &["a + 2*b - (1 1/s)*t"])];
    assert_eq!(agree(&loop_of), Some(true));
    let mut on_a_path = disc();
    on_a_path.constraints =
        vec![held("first", &["x'*cos(heading) - y'*sin(heading)", "lean - (1 rad/s)*t", "x + y - (2 m)"])];
    assert_eq!(agree(&on_a_path), Some(true));
}

/// A load on a point that belongs to no body is projected on every speed.
#[test]
fn loads_beside_the_tree_count() {
    let mut source = double_pendulum(true);
    source.coordinates.push(("s", "m").into());
    source.points.push(("R", "P + s*A.x").into());
    source.bodies.push(dalembert_model::BodySource::particle("bead", "R", "m1"));
    source.forces.push(LoadSource { on: Some("P".into()), is: "k*l1*B.y".into(), ..LoadSource::default() });
    assert_eq!(agree(&source), Some(true));
}

#[test]
fn a_speed_that_moves_two_joints_makes_no_tree() {
    let mut source = double_pendulum(false);
    source.frames.push(("M", "N turned 2*b about z").into());
    source.points.push(("R", "O + l1*M.x").into());
    source.bodies.push(dalembert_model::BodySource::particle("counterweight", "R", "m1"));
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    assert!(!apart(|| has_tree(&Trace::of(&model))));
}
