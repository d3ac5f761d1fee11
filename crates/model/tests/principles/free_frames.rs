//! Bodies with free frames: rotations about their axes do not commute.

use crate::systems::entries;
use crate::{agree, loads::are_one, motions::vanish, statements::says_of};
use dalembert_model::{BodySource, InertiaSource, LoadSource, Model, Source, StartValue, Trace};
use symbolic::apart;

fn body(name: &str, frame: &str, centre: &str, moments: [&str; 3]) -> BodySource {
    let [x, y, z] = moments.map(|moment| Some(moment.into()));
    BodySource {
        name: name.into(),
        frame: Some(frame.into()),
        centre: Some(centre.into()),
        mass: Some("m".into()),
        inertia: Some(InertiaSource::Tensor { axes: None, entries: Box::new([x, y, z, None, None, None]) }),
        ..BodySource::default()
    }
}

/// Two heavy tops about fixed points. A torque on the second depends on the spin of the first.
fn tops() -> Source {
    Source {
        parameters: entries(&[
            ("m", "kg"),
            ("l", "m"),
            ("J", "kg m^2"),
            ("K", "kg m^2"),
            ("L", "kg m^2"),
            ("g", "m/s^2"),
            ("c", "N m s"),
        ]),
        frames: entries(&[("F", "N free"), ("H", "N free")]),
        points: entries(&[("G", "O + l*F.x + 2*l*F.z"), ("K1", "O + l*H.y")]),
        bodies: vec![body("first", "F", "G", ["J", "K", "L"]), body("second", "H", "K1", ["L", "J", "K"])],
        gravity: Some("-g*N.z".into()),
        torques: vec![LoadSource { on: Some("H".into()), is: "-c*F.wx*N.y".into(), ..LoadSource::default() }],
        ..Source::default()
    }
}

#[test]
fn principles_agree_on_two_frames_that_turn_freely() {
    agree(&tops());
}

/// Euler's rigid body without torque: with equal moments of inertia about y and z, the angular momentum about x is constant as well as
/// the energy; with three different moments, `prove` states only the energy.
#[test]
fn the_spin_of_a_free_body_is_kept_about_an_axis_of_symmetry_alone() {
    let free = |moments: [&str; 3]| {
        let bodies = vec![body("rotor", "F", "O", moments)];
        Source {
            frames: entries(&[("F", "N free")]),
            points: Vec::new(),
            bodies,
            torques: Vec::new(),
            gravity: None,
            ..tops()
        }
    };
    assert_eq!(says_of(&free(["J", "K", "L"])), ["energy: (T + V)' is zero"]);
    assert_eq!(says_of(&free(["J", "K", "K"])), ["energy: (T + V)' is zero", "momentum of F.wx: (dT/dF.wx)' is zero"]);
}

/// Start values of a free frame as successive rotations: its axes must equal those of frames given by the same rotations.
#[test]
fn a_free_frame_starts_as_frames_that_are_turned_one_after_the_other() {
    let pairs = ["x", "y", "z"].map(|a| ["x", "y", "z"].map(|b| (format!("{a}{b}"), format!("F.{a} . C.{b}"))));
    let pairs: Vec<(&str, &str)> = pairs.iter().flatten().map(|(name, is)| (name.as_str(), is.as_str())).collect();
    let source = Source {
        frames: entries(&[
            ("H", "N free"),
            ("F", "N free"),
            ("A", "N turned (30 deg) about x"),
            ("B", "A turned (-50 deg) about z"),
            ("D", "B turned (20 deg) about y"),
            ("E", "D turned (40 deg) about z"),
            ("G0", "E turned (-70 deg) about x"),
            ("C", "G0 turned (25 deg) about y"),
        ]),
        start: entries(&[(
            "F",
            "30 deg about x, then -50 deg about z, then 20 deg about y, \
             then 40 deg about z, then -70 deg about x, then 25 deg about y",
        )]),
        outputs: entries(&pairs),
        ..tops()
    };
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let letters = |name: &str| {
            let of = |start: &StartValue| trace.coordinates[start.coordinate].to_string() == name;
            let pi = (name == "pi").then_some(std::f64::consts::PI);
            pi.or_else(|| model.start.iter().find(|start| of(start)).map(|start| start.value))
        };
        for (k, output) in model.outputs.iter().enumerate() {
            let found = trace.scalar(output.is).evaluate_analytic(&letters).expect("every letter has a value");
            let expected = if k % 4 == 0 { 1.0 } else { 0.0 };
            assert!((found - expected).abs() < 1e-14, "{}: {found}", output.name);
        }
    });
}

#[test]
fn the_parts_of_an_angular_velocity_are_those_of_their_frame() {
    vanish(
        tops(),
        &[
            "angular_velocity(F) - F.wx*F.x - F.wy*F.y - F.wz*F.z",
            "angular_velocity(H) - H.wx*H.x - H.wy*H.y - H.wz*H.z",
        ],
    );
    // the generalised force along `H.wz` equals a torque about H.z
    let torque = LoadSource { on: Some("H".into()), is: "c*F.wy*H.z".into(), ..LoadSource::default() };
    let along = LoadSource { along: Some("H.wz".into()), is: "c*F.wy".into(), ..LoadSource::default() };
    are_one(&[
        Source { torques: vec![torque], ..tops() },
        Source { torques: Vec::new(), forces: vec![along], ..tops() },
    ]);
}

/// The rates of the axes of free frames are w x e, and the axes are unit vectors; verified from the quaternions.
#[test]
fn axes_of_free_frames_move_by_their_angular_velocities() {
    let (f, h) = ("angular_velocity(F)", "angular_velocity(H)");
    let rates = [("F.x", "H.y"), ("F.y", "H.z"), ("F.z", "H.z")]
        .map(|(a, b)| format!("(rate({a} . {b}) - dot(cross({f}, {a}), {b}) - dot({a}, cross({h}, {b})))*N.x"));
    let lengths = ["F.x", "F.y", "F.z"].map(|a| format!("(({a} . N.x)^2 + ({a} . N.y)^2 + ({a} . N.z)^2 - 1)*N.x"));
    vanish(tops(), &rates.iter().chain(&lengths).map(String::as_str).collect::<Vec<_>>());
}
