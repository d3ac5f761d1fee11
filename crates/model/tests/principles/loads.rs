//! Loads of every kind, compared with equivalent energies and generalised forces.

use crate::statements::says_of;
use crate::systems::{entries, parameters};
use dalembert_model::principles::Principle;
use dalembert_model::{BodySource, LoadSource, MatrixForm, Model, Source, Trace};
use symbolic::{Decision, Hypotheses, Sym, apart};

/// Asserts that all sources describe one system: every principle gives one residual for all of them.
pub fn are_one(sources: &[Source]) {
    let models = sources.iter().map(|source| Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}")));
    let models: Vec<Model> = models.collect();
    apart(|| {
        let first = Principle::Lagrange.residual(&Trace::of(&models[0])).expect("it applies");
        for (place, model) in models.iter().enumerate() {
            let trace = Trace::of(model);
            for principle in Principle::ALL {
                for (own, first) in principle.residual(&trace).expect("it applies").iter().zip(&first) {
                    let decided = Hypotheses::none().equal(*own, *first);
                    assert!(matches!(decided, Decision::Zero(_)), "system {place}, {principle:?}: {decided}");
                }
            }
        }
    });
}

fn along(coordinate: &str, is: &str) -> LoadSource {
    LoadSource { along: Some(coordinate.into()), is: is.into(), ..LoadSource::default() }
}

fn between(first: &str, second: &str, is: &str) -> LoadSource {
    LoadSource { between: Some([first.into(), second.into()]), is: is.into(), ..LoadSource::default() }
}

/// A spring and a damper between two particles, as a force and as energies.
#[test]
fn a_force_between_two_particles_is_that_of_the_energy_of_their_spring() {
    let free = Source {
        parameters: entries(&[("m", "kg"), ("M", "kg"), ("k", "N/m"), ("c", "N s/m"), ("h", "m")]),
        coordinates: entries(&[("x", "m"), ("y", "m"), ("z", "m")]),
        points: entries(&[("P", "O + x*N.x + y*N.y"), ("Q", "O + z*N.y")]),
        bodies: vec![BodySource::particle("first", "P", "m"), BodySource::particle("second", "Q", "M")],
        ..Source::default()
    };
    let by_force = vec![between("P", "Q", "-k*(distance(P, Q) - h) - c*rate(distance(P, Q))")];
    let by_energies = entries(&[
        ("potential", "k/2*(distance(P, Q) - h)^2"),
        // Rayleigh's dissipation function is half the dissipated power
        ("dissipation", "c/2*rate(distance(P, Q))^2"),
    ]);
    let all = [Source { forces: by_force, ..free.clone() }, Source { energies: by_energies, ..free }];
    are_one(&all);
    // whether the spring is a potential energy or a force, the damper dissipates
    for source in all {
        assert_eq!(says_of(&source)[0], "energy: (T + V)' is the power of the forces");
    }
}

/// Two pendulums about one axis, coupled by a spring and a damper.
fn coupled() -> Source {
    Source {
        parameters: parameters(),
        coordinates: entries(&[("a", "rad"), ("b", "rad")]),
        frames: entries(&[("A", "N turned a about z"), ("B", "N turned b about z")]),
        points: entries(&[("P", "O - l1*A.y"), ("Q", "O - l2*B.y")]),
        bodies: vec![BodySource::particle("first", "P", "m1"), BodySource::particle("second", "Q", "m2")],
        gravity: Some("-g*N.y".into()),
        ..Source::default()
    }
}

#[test]
fn a_torque_between_two_frames_is_energies_and_forces_along_their_angles() {
    let by_torque = vec![between("A", "B", "(-k*(1 m^2)*(b - a) - c*(b' - a'))*N.z")];
    let by_forces = vec![along("a", "k*(1 m^2)*(b - a) + c*(b' - a')"), along("b", "k*(1 m^2)*(a - b) + c*(a' - b')")];
    let by_energies = entries(&[("potential", "k*(1 m^2)/2*(a - b)^2"), ("dissipation", "c/2*(a' - b')^2")]);
    are_one(&[
        Source { torques: by_torque, ..coupled() },
        Source { forces: by_forces, ..coupled() },
        Source { energies: by_energies, ..coupled() },
    ]);
}

#[test]
fn forces_of_every_kind_stand_on_the_right_of_the_matrix_form() {
    let source = Source {
        torques: vec![LoadSource { on: Some("A".into()), is: "c*a'*N.z".into(), ..LoadSource::default() }],
        forces: vec![
            along("a", "k*(1 m^2)"),
            LoadSource { on: Some("P".into()), is: "k*(1 m)*A.x".into(), ..LoadSource::default() },
        ],
        energies: entries(&[("potential", "k*(1 m^2)*a"), ("dissipation", "c*a'^2")]),
        ..coupled()
    };
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let [c, k, l, m, g, rate] = ["c", "k", "l1", "m1", "g", "a'"].map(Sym::symbol);
        // derived by hand: terms of the torque c a', the dissipation -2 c a', force and weight with their lever arms; the gradient of the
        // potential cancels the generalised force k
        let by_hand = k * l - c * rate - m * g * l * sine("a");
        for principle in Principle::ALL {
            let form = MatrixForm::of(&trace, principle).expect("it applies");
            assert!(Hypotheses::none().equal(form.forces[0], by_hand).is_zero(), "{principle:?}: {}", form.forces[0]);
            assert!(Hypotheses::none().equal(form.inertia[0], Sym::ZERO).is_zero(), "{principle:?}");
        }
    });
}

fn sine(name: &str) -> Sym {
    use field::Analytic;
    Sym::symbol(name).circle().sin
}
