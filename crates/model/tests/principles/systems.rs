//! Systems used by several tests.

use dalembert_model::{BodySource, ConstraintSource, Entry, InertiaSource, LoadSource, Source};

pub fn entries(list: &[(&str, &str)]) -> Vec<Entry> {
    list.iter().map(|&entry| entry.into()).collect()
}

pub fn parameters() -> Vec<Entry> {
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

pub fn double_pendulum(relative: bool) -> Source {
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

/// A disc with heading, lean and spin angles and a spring from its centre to a fixed point.
pub fn disc() -> Source {
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

fn some(text: &str) -> Option<dalembert_model::Text> {
    Some(text.into())
}

/// A body with a moment of inertia about z.
pub fn plane_body(name: &str, frame: &str, centre: &str, mass: &str, inertia: &str) -> BodySource {
    BodySource {
        name: name.into(),
        frame: some(frame),
        centre: some(centre),
        mass: some(mass),
        inertia: Some(InertiaSource::Axial(inertia.into())),
        ..BodySource::default()
    }
}

/// A named constraint on the given expressions.
pub fn held(name: &str, zero: &[&str]) -> ConstraintSource {
    ConstraintSource {
        name: some(name),
        zero: zero.iter().map(|&zero| zero.into()).collect(),
        ..ConstraintSource::default()
    }
}

/// The disc of [`disc`] without its spring, rolling without slipping.
pub fn rolling_disc() -> Source {
    let slip = held("rolling", &["velocity(disc at P) . N.x", "velocity(disc at P) . N.y"]);
    Source { constraints: vec![slip], forces: Vec::new(), ..disc() }
}

/// Chaplygin's sleigh with a force along its edge.
pub fn sleigh() -> Source {
    Source {
        parameters: entries(&[("m", "1 kg"), ("J", "0.1 kg m^2"), ("a", "0.1 m"), ("F", "1 N")]),
        coordinates: entries(&[("x", "m"), ("y", "m"), ("psi", "rad")]),
        frames: entries(&[("B", "N turned psi about z")]),
        points: entries(&[("P", "O + x*N.x + y*N.y"), ("G", "P + a*B.x")]),
        bodies: vec![plane_body("sleigh", "B", "G", "m", "J")],
        forces: vec![LoadSource { on: some("sleigh at P"), is: "F*B.x".into(), ..LoadSource::default() }],
        constraints: vec![held("edge", &["velocity(sleigh at P) . B.y"])],
        ..Source::default()
    }
}

/// A slider-crank driven by a torque: one kinematic loop, closed by a vector equation.
pub fn slider_crank() -> Source {
    let turns = BodySource {
        name: "crank".into(),
        turns: some("theta"),
        inertia: Some(InertiaSource::Axial("J".into())),
        ..BodySource::default()
    };
    Source {
        parameters: entries(&[
            ("r", "0.1 m"),
            ("l", "0.3 m"),
            ("J", "0.01 kg m^2"),
            ("I", "0.003 kg m^2"),
            ("mrod", "0.4 kg"),
            ("m", "0.5 kg"),
            ("T", "0.2 N m"),
            ("g", "9.81 m/s^2"),
        ]),
        coordinates: entries(&[("theta", "rad"), ("phi", "rad"), ("s", "m")]),
        frames: entries(&[("R", "N turned -phi about z")]),
        points: entries(&[
            ("A", "O + r*(cos(theta)*N.x + sin(theta)*N.y)"),
            ("M", "A + l/2*R.x"),
            ("B", "A + l*R.x"),
            ("S", "O + s*N.x"),
        ]),
        bodies: vec![turns, plane_body("rod", "R", "M", "mrod", "I"), BodySource::particle("slider", "S", "m")],
        gravity: some("-g*N.y"),
        torques: vec![LoadSource {
            between: Some(["ground".into(), "crank".into()]),
            is: "T*N.z".into(),
            ..LoadSource::default()
        }],
        constraints: vec![held("pin", &["B - S"])],
        ..Source::default()
    }
}

/// Two bodies in space: the first yaws and swings, the second is hinged to it with a spring and a damper.
pub fn two_bodies() -> Source {
    let body = |name: &str, frame: &str, centre: &str, mass: &str, entries: [&str; 6]| BodySource {
        name: name.into(),
        frame: some(frame),
        centre: some(centre),
        mass: some(mass),
        inertia: Some(InertiaSource::Tensor { axes: None, entries: Box::new(entries.map(some)) }),
        ..BodySource::default()
    };
    Source {
        parameters: entries(&[
            ("m", "1 kg"),
            ("M", "2 kg"),
            ("l", "0.4 m"),
            ("b", "0.2 m"),
            ("A", "0.1 kg m^2"),
            ("C", "0.2 kg m^2"),
            ("D", "0.01 kg m^2"),
            ("g", "9.81 m/s^2"),
            ("k", "3 N m"),
            ("c", "0.1 N m s"),
        ]),
        coordinates: entries(&[("p", "rad"), ("q", "rad"), ("w", "rad")]),
        frames: entries(&[("V", "N turned p about z"), ("S", "V turned q about x"), ("H", "S turned w about y")]),
        points: entries(&[("G", "O - l*S.z"), ("E", "O - 2*l*S.z + b*S.y"), ("K", "E + b*H.x - l*H.z")]),
        bodies: vec![
            body("arm", "S", "G", "M", ["A", "A", "C", "D", "0", "0"]),
            body("hand", "H", "K", "m", ["A", "C", "A", "0", "D", "D"]),
        ],
        gravity: some("-g*N.z"),
        torques: vec![LoadSource {
            between: Some(["arm".into(), "hand".into()]),
            is: "-(k*w + c*w')*S.y".into(),
            ..LoadSource::default()
        }],
        ..Source::default()
    }
}

/// A plane chain of hinged links.
pub fn chain(links: usize) -> Source {
    let before = |name: &str, first: &str, k: usize| if k == 1 { first.to_owned() } else { format!("{name}{}", k - 1) };
    let numbered = |line: &dyn Fn(usize) -> Vec<(String, String)>| -> Vec<Entry> {
        (1..=links).flat_map(line).map(|(name, value)| (name.as_str(), value.as_str()).into()).collect()
    };
    Source {
        parameters: entries(&[("m", "1 kg"), ("l", "0.5 m"), ("g", "9.81 m/s^2")]),
        coordinates: numbered(&|k| vec![(format!("q{k}"), "rad".to_owned())]),
        frames: numbered(&|k| vec![(format!("A{k}"), format!("{} turned q{k} about z", before("A", "N", k)))]),
        points: numbered(&|k| {
            let last = before("E", "O", k);
            vec![(format!("G{k}"), format!("{last} - l/2*A{k}.y")), (format!("E{k}"), format!("{last} - l*A{k}.y"))]
        }),
        bodies: (1..=links)
            .map(|k| plane_body(&format!("b{k}"), &format!("A{k}"), &format!("G{k}"), "m", "m*l^2/12"))
            .collect(),
        gravity: some("-g*N.y"),
        ..Source::default()
    }
}

/// The chain of [`chain`] in space: its hinges have the axes z and x alternately.
pub fn spatial_chain(links: usize) -> Source {
    let mut source = chain(links);
    let frame = |k: usize| {
        let before = if k == 1 { "N".to_owned() } else { format!("A{}", k - 1) };
        (format!("A{k}"), format!("{before} turned q{k} about {}", if k % 2 == 1 { "z" } else { "x" }))
    };
    let frames = (1..=links).map(frame);
    source.frames = frames.map(|(name, turned)| (name.as_str(), turned.as_str()).into()).collect();
    for body in &mut source.bodies {
        let about = ["m*l^2/12", "m*l^2/100", "m*l^2/12"].map(some);
        let [xx, yy, zz] = about;
        body.inertia = Some(InertiaSource::Tensor { axes: None, entries: Box::new([xx, yy, zz, None, None, None]) });
    }
    source
}
