//! Systems whose equations are exported as code.

use dalembert_model::{BodySource, ConstraintSource, Entry, InertiaSource, LoadSource, Source};

pub fn entries(list: &[(&str, &str)]) -> Vec<Entry> {
    list.iter().map(|&entry| entry.into()).collect()
}

/// An oscillator whose parameters are named like keywords of the target languages, in a frame rotated by 30 degrees.
pub fn oscillator() -> Source {
    Source {
        parameters: entries(&[("double", "2 kg"), ("lambda", "30 N/m"), ("fn", "0.4 N s/m"), ("M", "1.5 m")]),
        coordinates: entries(&[("q", "m"), ("u", "m")]),
        frames: entries(&[("A", "N turned (30 deg) about z")]),
        points: entries(&[("P", "O + q*A.x + u*A.y")]),
        bodies: vec![BodySource::particle("bob", "P", "double")],
        energies: entries(&[
            ("potential", "lambda/2*(distance(O, P) - M)^2"),
            ("dissipation", "fn/2*(q'^2 + 0.35*u'^2)"),
        ]),
        gravity: Some("-(9.81 m/s^2)*N.y".into()),
        ..Source::default()
    }
}

/// A falling particle, without any parameter.
pub fn faller() -> Source {
    Source {
        coordinates: entries(&[("y", "m")]),
        points: entries(&[("P", "O + y*N.y")]),
        bodies: vec![BodySource::particle("stone", "P", "(2 kg)")],
        gravity: Some("-(9.81 m/s^2)*N.y".into()),
        ..Source::default()
    }
}

/// A particle with a stiff stop, given by a condition, and with a smoothed friction force `f tanh(x'/w)`.
pub fn stop() -> Source {
    Source {
        parameters: entries(&[("m", "2 kg"), ("k", "300 N/m"), ("f", "0.7 N"), ("w", "0.1 m/s")]),
        coordinates: entries(&[("x", "m")]),
        points: entries(&[("P", "O + x*N.x")]),
        bodies: vec![BodySource::particle("mass", "P", "m")],
        forces: vec![LoadSource {
            on: Some("mass".into()),
            is: "(if(x > (0.15 m), -k*(x - (0.15 m)), 0*k*x) - f*tanh(x'/w))*N.x".into(),
            ..LoadSource::default()
        }],
        ..Source::default()
    }
}

pub fn double_pendulum() -> Source {
    Source {
        parameters: entries(&[
            ("m1", "1 kg"),
            ("m2", "2 kg"),
            ("l1", "1 m"),
            ("l2", "0.5 m"),
            ("g", "9.81 m/s^2"),
            ("T", "0.3 N m"),
        ]),
        coordinates: entries(&[("a", "rad"), ("b", "rad")]),
        frames: entries(&[("A", "N turned a about z"), ("B", "N turned b about z")]),
        points: entries(&[("P", "O - l1*A.y"), ("Q", "P - l2*B.y")]),
        bodies: vec![BodySource::particle("first", "P", "m1"), BodySource::particle("second", "Q", "m2")],
        gravity: Some("-g*N.y".into()),
        torques: vec![LoadSource { on: Some("A".into()), is: "T*cos(t/(1 s))*N.z".into(), ..LoadSource::default() }],
        ..Source::default()
    }
}

pub fn slider_crank() -> Source {
    let body = |name: &str| BodySource { name: name.into(), ..BodySource::default() };
    let text = |text: &str| Some(text.into());
    Source {
        parameters: entries(&[
            ("r", "0.1 m"),
            ("l", "0.3 m"),
            ("J", "0.01 kg m^2"),
            ("Jrod", "0.003 kg m^2"),
            ("mrod", "0.4 kg"),
            ("m", "0.5 kg"),
            ("T", "0.2 N m"),
            ("g", "9.81 m/s^2"),
        ]),
        coordinates: entries(&[("theta", "rad"), ("phi", "rad"), ("s", "m")]),
        frames: entries(&[("R", "N turned -phi about z")]),
        points: entries(&[
            ("A", "O + r*(cos(theta)*N.x + sin(theta)*N.y)"),
            ("G", "A + l/2*R.x"),
            ("B", "A + l*R.x"),
            ("S", "O + s*N.x"),
        ]),
        bodies: vec![
            BodySource { turns: text("theta"), inertia: Some(InertiaSource::Axial("J".into())), ..body("crank") },
            BodySource {
                frame: text("R"),
                centre: text("G"),
                mass: text("mrod"),
                inertia: Some(InertiaSource::Axial("Jrod".into())),
                ..body("rod")
            },
            BodySource::particle("slider", "S", "m"),
        ],
        gravity: text("-g*N.y"),
        torques: vec![LoadSource {
            between: Some(["ground".into(), "crank".into()]),
            is: "T*N.z".into(),
            ..LoadSource::default()
        }],
        constraints: vec![ConstraintSource {
            name: text("pin"),
            zero: vec!["B - S".into()],
            ..ConstraintSource::default()
        }],
        ..Source::default()
    }
}

/// A top about a fixed point with air drag. Its frame is free or given by three angles, according to the arguments.
pub fn top(coordinates: &[(&str, &str)], frames: &[(&str, &str)]) -> Source {
    let entry = |text: &str| Some(text.into());
    let moments = [entry("A"), entry("1.2*A"), entry("C"), None, None, None];
    Source {
        parameters: entries(&[
            ("m", "1.5 kg"),
            ("l", "0.2 m"),
            ("A", "0.03 kg m^2"),
            ("C", "0.01 kg m^2"),
            ("k", "0.02 N m s"),
        ]),
        coordinates: entries(coordinates),
        frames: entries(frames),
        points: entries(&[("P", "O + l*F.z")]),
        bodies: vec![BodySource {
            name: "top".into(),
            frame: entry("F"),
            centre: entry("P"),
            mass: entry("m"),
            inertia: Some(InertiaSource::Tensor { axes: None, entries: Box::new(moments) }),
            ..BodySource::default()
        }],
        gravity: entry("-(9.81 m/s^2)*N.z"),
        torques: vec![LoadSource { on: entry("top"), is: "-k*angular_velocity(top)".into(), ..LoadSource::default() }],
        ..Source::default()
    }
}

pub fn free_top() -> Source {
    top(&[], &[("F", "N free")])
}

pub fn turned_top() -> Source {
    top(
        &[("yaw", "rad"), ("tilt", "rad"), ("spin", "rad")],
        &[("Y", "N turned yaw about z"), ("T", "Y turned tilt about x"), ("F", "T turned spin about z")],
    )
}

/// A free body whose corner stays on a plane; its speed in one direction of the plane is zero.
pub fn pinned_plate() -> Source {
    Source {
        coordinates: entries(&[("x", "m"), ("z", "m")]),
        points: entries(&[("P", "O + x*N.x + z*N.z"), ("E", "P + l*F.x - l/2*F.z")]),
        constraints: vec![ConstraintSource {
            name: Some("plane".into()),
            zero: vec!["(E - O) . N.z".into(), "velocity(top at E) . N.y".into()],
            ..ConstraintSource::default()
        }],
        ..free_top()
    }
}

/// A disc that rolls without slipping. The quasi-velocities are components of its angular velocity along axes that do not spin with it.
pub fn rolling_disc() -> Source {
    let entry = |text: &str| Some(text.into());
    let moments = [entry("m*r^2/4"), entry("m*r^2/2"), entry("m*r^2/4"), None, None, None];
    Source {
        parameters: entries(&[("m", "2 kg"), ("r", "343 mm"), ("g", "9.81 m/s^2"), ("c", "0.3 N m s")]),
        coordinates: entries(&[("x", "m"), ("y", "m"), ("heading", "rad"), ("lean", "rad"), ("spin", "rad")]),
        speeds: entries(&[
            ("w1", "angular_velocity(C) . C.x"),
            ("w2", "angular_velocity(D) . C.y"),
            ("w3", "angular_velocity(C) . C.z"),
        ]),
        frames: entries(&[
            ("B", "N turned heading about z"),
            ("C", "B turned -lean about x"),
            ("D", "C turned spin about y"),
        ]),
        points: entries(&[("P", "O + x*N.x + y*N.y"), ("G", "P + r*C.z")]),
        bodies: vec![BodySource {
            name: "disc".into(),
            frame: entry("D"),
            centre: entry("G"),
            mass: entry("m"),
            inertia: Some(InertiaSource::Tensor { axes: entry("C"), entries: Box::new(moments) }),
            ..BodySource::default()
        }],
        gravity: entry("-g*N.z"),
        torques: vec![LoadSource { on: entry("disc"), is: "-c*w2*C.y".into(), ..LoadSource::default() }],
        constraints: vec![ConstraintSource {
            zero: vec!["velocity(disc at P) . N.x".into(), "velocity(disc at P) . N.y".into()],
            ..ConstraintSource::default()
        }],
        ..Source::default()
    }
}

/// The body of [`pinned_plate`] with quasi-velocities. A stabilised constraint makes the height of its corner follow a function of time.
pub fn led_plate() -> Source {
    let mut plate = pinned_plate();
    plate.speeds = entries(&[
        ("p", "F.wx + 0.5*F.wy"),
        ("n", "F.w . F.y"),
        ("s", "velocity(top at E) . N.x + (0.1 m/s^2)*t"),
        ("v", "z'"),
    ]);
    plate.constraints[0].zero.truncate(0);
    plate.constraints[0].zero.push("velocity(top at E) . N.y".into());
    plate.constraints.push(ConstraintSource {
        name: Some("path".into()),
        zero: vec!["(E - O) . N.z - (0.1 m)*sin(t*(1 rad/s))".into()],
        gains: Some(vec!["(2 1/s)".into(), "(1 1/s^2)".into()]),
        ..ConstraintSource::default()
    });
    plate
}
