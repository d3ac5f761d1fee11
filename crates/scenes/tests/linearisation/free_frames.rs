//! Linear equations of systems with free frames.

use super::{linear, scene};
use dalembert_scenes::ModelScene;
use dalembert_scenes::linearisation::{Stability, Standing, eigenvalues};
use integrators::Ode;
use nalgebra::{DMatrix, DVector};
use simulation::{Axes, IvpScene};

/// A symmetric top about a fixed point, in a free frame; A and C are its moments of inertia about that point.
const FREE_TOP: &str = "title = \"A top\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1.5 kg\"\nl = \"0.2 m\"\nA = \"0.09 kg m^2\"\nC = \"0.01 kg m^2\"\n\
    g = \"9.81 m/s^2\"\nk = \"0 N m s\"\n[coordinates]\n[frames]\nF = \"N free\"\n[bodies.top]\nframe = \"F\"\ncentre = \"O + l*F.z\"\nmass = \"m\"\n\
    inertia = { principal = [\"A - m*l^2\", \"A - m*l^2\", \"C\"] }\n[[torque]]\non = \"top\"\nis = \"-k*angular_velocity(top)\"\n\
    [outputs]\nnorth = \"l*F.z . N.y\"\n[start]\nSTART\n[run]\nspan = \"1 s\"\n";

/// A w'' - i C s w' - m g l w = 0 for the tilt w = x + i y, in axes that rotate with the spin s.
#[test]
fn a_sleeping_top_has_its_closed_form_with_a_row_for_each_turn() {
    let (a, c, torque, l) = (0.09, 0.01, 1.5 * 9.81 * 0.2, 0.2);
    for (spin, standing, stability) in [
        (150.0, Standing::Steady, Stability::Undecided(6)),
        (90.0, Standing::Steady, Stability::Unstable(2)),
        (0.0, Standing::Equilibrium, Stability::Unstable(2)),
    ] {
        let scene = scene(&FREE_TOP.replace("START", &format!("\"F.wz\" = \"{spin} rad/s\"")));
        let (equations, found) = linear(&scene.model, &scene.start, &[]);
        assert_eq!(equations.standing(&found), Ok(standing));
        let (t, g) = (torque / a, (a - c) / a * spin);
        let rows = [
            [0., spin, 0., 1., 0., 0.],
            [-spin, 0., 0., 0., 1., 0.],
            [0., 0., 0., 0., 0., 1.],
            [t, 0., 0., 0., g, 0.],
            [0., t, 0., -g, 0., 0.],
            [0., 0., 0., 0., 0., 0.],
        ];
        let expected = DMatrix::from_row_slice(6, 6, &rows.concat());
        assert!((&found.a - &expected).amax() < 1e-11, "{} {expected}", found.a);
        assert!((&found.c - DMatrix::from_row_slice(1, 6, &[-l, 0., 0., 0., 0., 0.])).amax() < 1e-13, "{}", found.c);
        let all = eigenvalues(&found.a);
        assert_eq!(Stability::of(&all, true), stability, "{spin}");
        // real and imaginary parts of i (C s -+ sqrt((C s)^2 - 4 A m g l))/(2 A) - i s
        let square = (c * spin).powi(2) - 4.0 * a * torque;
        let (real, apart) = if square < 0.0 { ((-square).sqrt(), 0.0) } else { (0.0, square.sqrt()) };
        for sign in [1.0, -1.0] {
            let (re, im) = (sign * real / (2.0 * a), (c * spin + sign * apart) / (2.0 * a) - spin);
            let near = |value: &&nalgebra::Complex<f64>| (value.re - re).hypot(value.im - im) < 1e-9;
            assert!(all.values.iter().any(|value| near(&value)), "{spin}: {re} {im}: {all:?}");
        }
    }
}

/// conj(q0) q1: the quaternion of the rotation from one orientation to another.
fn way(from: &[f64], to: &[f64]) -> [f64; 4] {
    let ([a, b, c, d], [e, f, g, h]) = ([from[0], -from[1], -from[2], -from[3]], [to[0], to[1], to[2], to[3]]);
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

/// Along a motion, A agrees with difference quotients of the integrated law. Variations of orientations are twice the vector part of the quaternion
/// between two orientations; their rates follow from the rates of both.
#[test]
fn a_free_frame_that_moves_has_the_linear_equations_of_the_law_that_runs() {
    let top = FREE_TOP.replace("k = \"0 N m s\"", "k = \"0.02 N m s\"").replace(
        "START",
        "F = \"20 deg about z, then 40 deg about x\"\n\"F.wx\" = \"2 rad/s\"\n\"F.wy\" = \"-1 rad/s\"\n\"F.wz\" = \"9 rad/s\"",
    );
    let sprung = top
        .replace("[coordinates]\n", "[coordinates]\nx = \"m\"\nz = \"m\"\n")
        .replace("O + l*F.z", "O + x*N.x + z*N.z + l*F.z")
        .replace("[start]\n", "[[force]]\nbetween = [\"ground at O - (1 m)*N.x\", \"top at O + x*N.x + z*N.z + l*F.x\"]\n\
            is = \"-(40 N/m)*(distance(O - (1 m)*N.x, O + x*N.x + z*N.z + l*F.x) - (0.8 m))\"\n[start]\nx = \"0.3 m\"\n\"z'\" = \"0.4 m/s\"\n");
    let carried = top
        .replace("F = \"N free\"", "Y = \"N turned (1 rad/s)*t about y\"\nF = \"Y free\"\nH = \"F free\"")
        .replace(
            "[outputs]",
            "[bodies.gyro]\nframe = \"H\"\ncentre = \"O + 2*l*F.z + l*H.x\"\nmass = \"m/3\"\n\
            inertia = { principal = [\"A\", \"1.1*A\", \"1.3*A\"] }\n[outputs]",
        )
        .replace("[run]", "H = \"50 deg about y\"\n\"H.wx\" = \"3 rad/s\"\n\"H.wz\" = \"-1 rad/s\"\n[run]");
    for text in [top, sprung, carried] {
        let scene = scene(&text);
        let (equations, found) = linear(&scene.model, &scene.start, &[]);
        assert_eq!(equations.standing(&found), Ok(Standing::Moving));
        let (own, p, n) = (scene.model.coordinates.len(), scene.model.positions(), scene.model.speeds());
        assert_eq!(found.a.shape(), (2 * n, 2 * n));
        let quaternion_of = |turn: usize| own + 4 * ((turn - own) / 3);
        let law = scene.problem(Axes::First).law;
        let rates = |state: &[f64]| {
            let mut rates = vec![0.0; state.len()];
            Ode::<f64>::rates(&*law, 0.0, state, &mut rates);
            rates
        };
        let about = rates(&scene.start);
        for column in 0..2 * n {
            let moved = |step: f64| {
                let mut state = scene.start.clone();
                match column {
                    place if place < own => state[place] += step,
                    turn if turn < n => {
                        let (mut along, first) = ([0.0; 3], quaternion_of(turn));
                        along[(turn - own) % 3] = step;
                        let quaternion = std::array::from_fn(|part| state[first + part]);
                        state[first..first + 4].copy_from_slice(&model::turned_further(quaternion, along));
                    }
                    speed => state[p + speed - n] += step,
                }
                let there = rates(&state);
                let apart = |place: usize| there[place] - about[place];
                let turned = |turn: usize| {
                    let at = quaternion_of(turn)..quaternion_of(turn) + 4;
                    let ways = [way(&about[at.clone()], &state[at.clone()]), way(&scene.start[at.clone()], &there[at])];
                    let part = 1 + (turn - own) % 3;
                    2.0 * (ways[0][part] + ways[1][part])
                };
                let displaced = (0..n).map(|place| if place < own { apart(place) } else { turned(place) });
                DVector::from_vec(displaced.chain((p..p + n).map(apart)).collect())
            };
            let step = 1e-4;
            let [near, far] = [step, 2.0 * step].map(|step| (moved(step) - moved(-step)) / (2.0 * step));
            let expected = (near * 4.0 - far) / 3.0;
            let gap = (found.a.column(column) - &expected).amax();
            assert!(
                gap < 1e-8 * (1.0 + expected.amax()),
                "column {column}: {gap:e}\n{} {expected}",
                found.a.column(column)
            );
        }
    }
}

/// A plate on a pin at its edge, with three constraints for six degrees of freedom: it swings in two planes with w^2 = m g a/(J + m a^2).
#[test]
fn a_hanging_plate_with_a_free_frame_is_found_at_rest_and_swings_as_a_pendulum() {
    let text = "title = \"A plate on a pin\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1 kg\"\na = \"0.3 m\"\nJ = \"0.01 kg m^2\"\ng = \"9.81 m/s^2\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\n\
        [bodies.plate]\nframe = \"F\"\ncentre = \"G\"\nmass = \"m\"\ninertia = { principal = [\"J\", \"2*J\", \"3*J\"] }\n\
        [[constraint]]\nname = \"pin\"\nzero = \"G + a*F.x - O\"\n\
        [start]\nequilibrium = true\nF = \"guess -70 deg about y, then 10 deg about z\"\nz = \"guess -0.2 m\"\n[run]\nspan = \"1 s\"\n";
    let scene = scene(text);
    let hangs = [scene.start[0], scene.start[1], scene.start[2] + 0.3];
    assert!(hangs.iter().all(|gap| gap.abs() < 1e-9), "{:?}", scene.start);
    let (equations, found) = linear(&scene.model, &scene.start, &[]);
    assert_eq!(equations.standing(&found), Ok(Standing::Equilibrium));
    assert_eq!([found.coordinates.len(), found.speeds.len()], [3, 3]);
    let all = eigenvalues(&found.a);
    for moment in [0.02, 0.03] {
        let speed = (9.81 * 0.3 / (moment + 0.09_f64)).sqrt();
        let pair = all.values.iter().filter(|value| (value.im.abs() - speed).abs() < 1e-9 && value.re.abs() < 1e-9);
        assert_eq!(pair.count(), 2, "{speed}: {all:?}");
    }
    let refused = ModelScene::parse("scene.toml", &text.replace("[run]", "\"F.wx\" = \"1 rad/s\"\n[run]"));
    assert!(refused.expect_err("it turns").to_string().contains("F.wx is not zero"));
}
