//! Rolling balls and free bodies, at states at which their frames are aligned with the parent frames. Many direction cosines vanish
//! there, so none of them may be a divisor.

use super::systems::entries;
use dalembert_model::{BodySource, ConstraintSource, InertiaSource, Source};

fn body(name: &str, frame: &str, centre: &str, mass: &str, moments: [&str; 3]) -> BodySource {
    let [x, y, z] = moments.map(|moment| Some(moment.into()));
    BodySource {
        name: name.into(),
        frame: Some(frame.into()),
        centre: Some(centre.into()),
        mass: Some(mass.into()),
        inertia: Some(InertiaSource::Tensor { axes: None, entries: Box::new([x, y, z, None, None, None]) }),
        ..BodySource::default()
    }
}

fn ball(centre: &str) -> BodySource {
    body("ball", "F", centre, "m", ["2/5*m*r^2"; 3])
}

fn held(zero: &[&str]) -> ConstraintSource {
    ConstraintSource { zero: zero.iter().map(|&each| each.into()).collect(), ..ConstraintSource::default() }
}

/// A ball that rolls on a turntable. The quasi-velocities are components along the axes of the turntable, the slip along the ground's.
pub fn turntable() -> Source {
    let slip = "velocity(ball at K) - cross(W*N.z, K - O)";
    Source {
        parameters: entries(&[("m", "0.5 kg"), ("r", "0.1 m"), ("W", "1.5 rad/s"), ("g", "9.81 m/s^2")]),
        coordinates: entries(&[("x", "m"), ("y", "m")]),
        speeds: entries(&[
            ("ux", "velocity(C in T) . T.x"),
            ("uy", "velocity(C in T) . T.y"),
            ("n", "angular_velocity(ball) . N.z"),
        ]),
        frames: entries(&[("F", "N free"), ("T", "N turned W*t about z")]),
        points: entries(&[("C", "O + x*N.x + y*N.y + r*N.z"), ("K", "C - r*N.z")]),
        bodies: vec![ball("C")],
        gravity: Some("-g*N.z".into()),
        constraints: vec![held(&[&format!("({slip}) . N.x"), &format!("({slip}) . N.y")])],
        ..Source::default()
    }
}

/// A ball that rolls on an inclined plane which rotates about its normal.
pub fn turning_incline() -> Source {
    let slip = "velocity(ball at K) - cross(angular_velocity(T), K - O)";
    let mut source = turntable();
    source.parameters.extend(entries(&[("al", "10 deg")]));
    source.speeds = entries(&[("ux", "x'"), ("uy", "y'"), ("n", "angular_velocity(ball) . T.z")]);
    source.frames = entries(&[("F", "N free"), ("S", "N turned al about y"), ("T", "S turned W*t about z")]);
    source.points = entries(&[("C", "O + x*T.x + y*T.y + r*T.z"), ("K", "C - r*T.z")]);
    source.constraints = vec![held(&[&format!("({slip}) . T.x"), &format!("({slip}) . T.y")])];
    source
}

/// A ball that rolls on a sliding wedge. A force acts on the ball at its point of contact.
pub fn sliding_wedge() -> Source {
    let slip = "velocity(ball at K) - velocity(Q)";
    Source {
        parameters: entries(&[("m", "1 kg"), ("M", "3 kg"), ("r", "0.1 m"), ("al", "0.4 rad"), ("g", "9.81 m/s^2")]),
        coordinates: entries(&[("X", "m"), ("u", "m"), ("w", "m")]),
        speeds: entries(&[
            ("vx", "velocity(C in S) . S.x"),
            ("vy", "velocity(C in S) . S.y"),
            ("spin", "angular_velocity(ball) . S.z"),
            ("V", "X'"),
        ]),
        frames: entries(&[("S", "N turned al about y"), ("F", "N free")]),
        points: entries(&[("Q", "O + X*N.x"), ("C", "Q + u*S.x + w*S.y + r*S.z"), ("K", "C - r*S.z")]),
        bodies: vec![
            BodySource {
                name: "wedge".into(),
                centre: Some("Q".into()),
                mass: Some("M".into()),
                ..BodySource::default()
            },
            ball("C"),
        ],
        forces: vec![dalembert_model::LoadSource {
            on: Some("ball at K".into()),
            is: "-(0.3 N s/m)*velocity(ball) + (2 N)*F.y".into(),
            ..dalembert_model::LoadSource::default()
        }],
        gravity: Some("-g*N.z".into()),
        constraints: vec![held(&[&format!("({slip}) . S.x"), &format!("({slip}) . S.y")])],
        ..Source::default()
    }
}

/// A ball that rolls in a spherical bowl. Its equations contain a root, and a divisor that vanishes at the lowest point.
pub fn bowl() -> Source {
    Source {
        parameters: entries(&[("m", "0.2 kg"), ("r", "0.05 m"), ("g", "9.81 m/s^2")]),
        coordinates: entries(&[("x", "m"), ("y", "m"), ("z", "m")]),
        speeds: entries(&[
            ("vt", "velocity(C) . cross(N.z, unit(C - O))"),
            ("vm", "z'"),
            ("ws", "angular_velocity(ball) . unit(C - O)"),
        ]),
        frames: entries(&[("F", "N free")]),
        points: entries(&[("C", "O + x*N.x + y*N.y + z*N.z"), ("K", "C + r*unit(C - O)")]),
        bodies: vec![ball("C")],
        gravity: Some("-g*N.z".into()),
        constraints: vec![held(&["velocity(ball at K)"])],
        ..Source::default()
    }
}

/// Two bodies on ball joints. The quasi-velocities of the second are components of its angular velocity along the axes of the first.
pub fn joined_bodies() -> Source {
    Source {
        parameters: entries(&[
            ("a", "1 kg"),
            ("b", "0.7 kg"),
            ("l", "0.5 m"),
            ("J", "0.01 kg m^2"),
            ("g", "9.81 m/s^2"),
        ]),
        coordinates: entries(&[("x1", "m"), ("y1", "m"), ("z1", "m"), ("x2", "m"), ("y2", "m"), ("z2", "m")]),
        speeds: entries(&[
            ("p1", "A.wx"),
            ("q1", "A.wy"),
            ("r1", "A.wz"),
            ("p2", "angular_velocity(second) . A.x"),
            ("q2", "angular_velocity(second) . A.y"),
            ("r2", "angular_velocity(second) . A.z"),
        ]),
        frames: entries(&[("A", "N free"), ("B", "N free")]),
        points: entries(&[("C1", "O + x1*N.x + y1*N.y + z1*N.z"), ("C2", "O + x2*N.x + y2*N.y + z2*N.z")]),
        bodies: vec![
            body("first", "A", "C1", "a", ["2*J", "3*J", "J"]),
            body("second", "B", "C2", "b", ["2*J", "1.5*J", "J"]),
        ],
        gravity: Some("-g*N.z".into()),
        constraints: vec![held(&["C1 + l/2*A.z - O"]), held(&["(C2 + l/2*B.z) - (C1 - l/2*A.z)"])],
        ..Source::default()
    }
}
