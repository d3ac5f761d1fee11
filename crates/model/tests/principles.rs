//! Every principle gives the same equations, whatever the model.

use model::principles::Principle;
use model::{BodySource, Entry, InertiaSource, LoadSource, Model, Source, Trace};
use symbolic::{Decision, Hypotheses, apart};

fn entries(list: &[(&str, &str)]) -> Vec<Entry> {
    list.iter().map(|&entry| entry.into()).collect()
}

fn parameters() -> Vec<Entry> {
    entries(&[
        ("m1", "1 kg"),
        ("m2", "2 kg"),
        ("l1", "1 m"),
        ("l2", "0.5 m"),
        ("g", "9.81 m/s^2"),
        ("k", "10 N/m"),
        ("c", "0.1 N m s"),
    ])
}

fn double_pendulum(relative: bool) -> Source {
    Source {
        parameters: parameters(),
        coordinates: entries(&[("a", "rad"), ("b", "rad")]),
        frames: entries(&[
            ("A", "N turned a about z"),
            ("B", if relative { "A turned b about z" } else { "N turned b about z" }),
        ]),
        points: entries(&[("P", "O - l1*A.y"), ("Q", "P - l2*B.y")]),
        bodies: vec![BodySource::particle("first", "P", "m1"), BodySource::particle("second", "Q", "m2")],
        gravity: Some("-g*N.y".into()),
        torques: vec![LoadSource {
            between: Some(["A".into(), "B".into()]),
            is: "-c*(b' - a')*N.z".into(),
            ..LoadSource::default()
        }],
        ..Source::default()
    }
}

/// A disc that leans, heads and spins, with a spring from its centre to a fixed point.
fn disc() -> Source {
    let entry = |text: &str| Some(text.into());
    Source {
        parameters: entries(&[("m", "2 kg"), ("r", "343 mm"), ("g", "9.81 m/s^2"), ("k", "10 N/m"), ("h", "1 m")]),
        coordinates: entries(&[("x", "m"), ("y", "m"), ("heading", "rad"), ("lean", "rad"), ("spin", "rad")]),
        frames: entries(&[
            ("D", "C turned spin about y"),
            ("C", "B turned -lean about x"),
            ("B", "N turned heading about z"),
        ]),
        points: entries(&[("G", "P + r*C.z"), ("P", "O + x*N.x + y*N.y"), ("F", "O + h*N.z")]),
        bodies: vec![BodySource {
            name: "disc".into(),
            frame: entry("D"),
            centre: entry("G"),
            mass: entry("m"),
            inertia: Some(InertiaSource::Tensor {
                axes: entry("C"),
                entries: Box::new([entry("m*r^2/4"), entry("m*r^2/2"), entry("m*r^2/4"), None, None, None]),
            }),
            ..BodySource::default()
        }],
        gravity: entry("-g*N.z"),
        forces: vec![LoadSource {
            between: Some(["F".into(), "disc at P".into()]),
            is: "-k*(distance(P, F) - h)".into(),
            ..LoadSource::default()
        }],
        ..Source::default()
    }
}

fn agree(source: &Source) {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let all = Principle::ALL.map(|principle| principle.residual(&trace).expect("it applies"));
        for (principle, residual) in Principle::ALL.iter().zip(&all).skip(1) {
            for (i, (own, first)) in residual.iter().zip(&all[0]).enumerate() {
                let decided = Hypotheses::none().equal(*own, *first);
                assert!(matches!(decided, Decision::Zero(_)), "{principle:?}, equation {i}: {decided}");
            }
        }
    });
}

#[test]
fn principles_agree_on_a_double_pendulum() {
    agree(&double_pendulum(false));
    agree(&double_pendulum(true));
}

#[test]
fn principles_agree_on_a_leaning_disc() {
    agree(&disc());
}

#[test]
fn constraints_are_told_apart_by_what_they_speak_of() {
    let mut source = disc();
    let held = |zero: &str| model::ConstraintSource { zero: vec![zero.into()], ..model::ConstraintSource::default() };
    source.parameters.push(("w", "1 rad/s").into());
    source.constraints = vec![
        held("velocity(disc at P) . N.x"),
        held("lean - w*t"),
        held("x' - w*y - (1 m/s)"),
        held("x'^2 + y'^2 - (1 m/s)^2"),
    ];
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    let told = apart(|| model::constraints(&Trace::of(&model)));
    let kinds = ["of speeds, linear", "of positions, with the time", "of speeds, affine", "of speeds, nonlinear"];
    assert_eq!(told.len(), kinds.len());
    for (told, kind) in told.iter().zip(kinds) {
        assert!(told.ends_with(kind), "{told}");
    }
}
