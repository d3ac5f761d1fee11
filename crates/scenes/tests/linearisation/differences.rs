//! Linear equations compared with difference quotients of the law and of states on the constraints.

use super::{CART, linear, scene, stored};
use dalembert_scenes::linearisation::{Linearisation, Point, Standing, VariedEquations};
use integrators::{Dual8, Jacobian, Ode};
use nalgebra::{DMatrix, DVector};
use simulation::{Axes, IvpScene};

/// Without constraints, A is the Jacobian of the integrated law (by dual numbers), at moving points, too.
#[test]
fn a_moving_point_has_the_jacobian_of_the_law_that_runs() {
    let moving = CART.replace("[run]", "[start]\na = \"0.4 rad\"\n\"a'\" = \"1.7 rad/s\"\n\"x'\" = \"0.3 m/s\"\n[run]");
    for text in [moving, std::fs::read_to_string(stored("models/double_pendulum")).expect("it is there")] {
        let scene = scene(&text);
        let (equations, found) = linear(&scene.model, &scene.start, &[]);
        let law = scene.problem(Axes::First).law;
        let n = scene.start.len();
        let mut expected = vec![0.0; n * n];
        let dual: &dyn Ode<Dual8> = &*law;
        Jacobian::new(dual).matrix(0.0, &scene.start, &mut expected);
        let expected = DMatrix::from_row_slice(n, n, &expected);
        assert!((&found.a - &expected).amax() < 1e-11 * expected.amax(), "{} {expected}", found.a);
        assert_eq!(equations.standing(&found), Ok(Standing::Moving));
    }
}

/// The state on the constraints with given values of the independent components.
fn completed(equations: &VariedEquations, about: &Linearisation, independent: &DVector<f64>) -> Point {
    let mut point = about.point.clone();
    let n = point.coordinates.len();
    let (free, free_speeds) = (&about.coordinates, &about.speeds);
    free.iter().enumerate().for_each(|(k, &place)| point.coordinates[place] = independent[k]);
    free_speeds.iter().enumerate().for_each(|(k, &place)| point.speeds[place] = independent[free.len() + k]);
    let fixed: Vec<usize> = (0..n).filter(|place| !free.contains(place)).collect();
    let fixed_speeds: Vec<usize> = (0..n).filter(|place| !free_speeds.contains(place)).collect();
    for _ in 0..20 {
        if !fixed.is_empty() {
            let at = equations.at(&point);
            let rows = DMatrix::from_fn(fixed.len(), fixed.len(), |i, j| at.zero.by_coordinates[(i, fixed[j])]);
            let step = rows.lu().solve(&at.zero.values.rows(0, fixed.len()).into_owned()).expect("it is regular");
            fixed.iter().zip(step.iter()).for_each(|(&place, part)| point.coordinates[place] -= part);
        }
        let at = equations.at(&point);
        let count = fixed_speeds.len();
        let rows = DMatrix::from_fn(count, count, |i, j| at.rate.by_speeds[(i, fixed_speeds[j])]);
        let step = rows.lu().solve(&at.rate.values).expect("it is regular");
        fixed_speeds.iter().zip(step.iter()).for_each(|(&place, part)| point.speeds[place] -= part);
    }
    equations.with_accelerations(point).expect("it is determined")
}

/// With constraints (a closed loop, rolling), A agrees with difference quotients between states on the constraints.
#[test]
fn constrained_systems_have_the_linear_equations_of_states_on_their_constraints() {
    let crank = std::fs::read_to_string(stored("models/slider_crank")).expect("it is there");
    let turned = crank.replace("s = \"0.4 m\"", "theta = \"0.5 rad\"\n\"theta'\" = \"2 rad/s\"\ns = \"guess 0.35 m\"");
    let rolling = std::fs::read_to_string(stored("models/rolling_disc")).expect("it is there");
    for (text, sizes) in [(turned, [1, 1]), (rolling, [5, 3])] {
        let scene = scene(&text);
        let (equations, found) = linear(&scene.model, &scene.start, &[]);
        assert_eq!([found.coordinates.len(), found.speeds.len()], sizes);
        let values = |point: &Point, first: &DVector<f64>, second: &DVector<f64>| {
            let coordinates = found.coordinates.iter().map(|&place| first[place]);
            let speeds = found.speeds.iter().map(|&place| second[place]);
            let all: Vec<f64> = coordinates.chain(speeds).collect();
            assert!(point.time == 0.0);
            DVector::from_vec(all)
        };
        let about = values(&found.point, &found.point.coordinates, &found.point.speeds);
        for column in 0..about.len() {
            let rates = |step: f64| {
                let mut moved = about.clone();
                moved[column] += step;
                let point = completed(&equations, &found, &moved);
                values(&point, &point.speeds, &point.accelerations)
            };
            let step = 1e-4;
            // central differences with Richardson extrapolation
            let [near, far] = [step, 2.0 * step].map(|step| (rates(step) - rates(-step)) / (2.0 * step));
            let expected = (near * 4.0 - far) / 3.0;
            let gap = (found.a.column(column) - &expected).amax();
            assert!(gap < 1e-8 * (1.0 + expected.amax()), "{}, column {column}: {gap:e}", scene.title);
        }
    }
}

/// A cart at a wall with a spring, pushed by an input; a stabilised constraint removes no degree of freedom.
#[test]
fn inputs_conditions_and_programmed_constraints_are_varied() {
    let text = "title = \"A cart\"\n[parameters]\nm = \"2 kg\"\nk = \"50 N/m\"\na = \"2 rad/s\"\nc = \"5 rad/s\"\n[inputs]\nu = { unit = \"N\", value = \"(3 N)*cos(t/(1 s))\" }\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.cart]\ncentre = \"P\"\nmass = \"m\"\n\
        [[force]]\non = \"cart\"\nis = \"(u - if(x > (0 m), k*x, 0*k*x))*N.x\"\n\
        [[constraint]]\nname = \"path\"\nzero = \"y - x\"\nprogrammed = { gains = [\"a\", \"c*(1 rad/s)\"] }\n\
        [start]\nx = \"0.1 m\"\n[run]\nspan = \"1 s\"\n";
    for (place, stiffness) in [("0.1 m", 50.0), ("-0.1 m", 0.0)] {
        let scene = scene(&text.replace("x = \"0.1 m\"", &format!("x = \"{place}\"")));
        let (equations, found) = linear(&scene.model, &scene.start, &[]);
        assert_eq!(equations.inputs, ["u"]);
        assert_eq!((found.point.inputs[0], found.coordinates.len()), (3.0, 2));
        // m x'' = u - k x + (-lambda), m y'' = lambda, (y - x)'' + 2 (y - x)' + 5 (y - x) = 0
        let s = stiffness;
        let a = [0., 0., 1., 0., 0., 0., 0., 1., -s / 4.0 - 2.5, 2.5, -1.0, 1.0, -s / 4.0 + 2.5, -2.5, 1.0, -1.0];
        let expected = DMatrix::from_row_slice(4, 4, &a);
        assert!((&found.a - &expected).amax() < 1e-12, "{} {expected}", found.a);
        assert!((found.b[(2, 0)] - 0.25).abs() < 1e-13 && (found.b[(3, 0)] - 0.25).abs() < 1e-13, "{}", found.b);
    }
    let equations = VariedEquations::of(&scene(text).model, &[]).unwrap_or_else(|why| panic!("{why}"));
    let refused = equations.linearised(equations.point(0.0, &[0.0; 4])).expect_err("the wall begins there");
    assert!(refused.to_string().contains("is zero: the equations have no derivative"), "{refused}");
}

/// m x'' = min(k (sin t - x), F): the second input depends on the first.
#[test]
fn an_input_may_ask_for_another_one_at_a_condition() {
    let text = "title = \"Two inputs\"\n[parameters]\nk = \"20 N/m\"\n[coordinates]\nx = \"m\"\n[bodies.b]\n\
                centre = \"O + x*N.x\"\nmass = \"(2 kg)\"\n[inputs]\n\
                ref = { unit = \"m\", value = \"max(sin(t*(1 rad/s)), 0)*(1 m)\" }\n\
                u = { unit = \"N\", value = \"min(k*(ref - x), (5 N))\" }\n[[force]]\non = \"b\"\nis = \"u*N.x\"\n\
                [run]\nspan = \"2 s\"\n";
    let scene = scene(text);
    let equations = VariedEquations::of(&scene.model, &[]).unwrap_or_else(|why| panic!("{why}"));
    for (time, x, force) in [(0.1_f64, 0.05, 20.0 * (0.1_f64.sin() - 0.05)), (1.0, 0.1, 5.0)] {
        let point = equations.point(time, &[x, 0.0]);
        assert!((point.inputs[0] - time.sin()).abs() < 1e-15 && (point.inputs[1] - force).abs() < 1e-14, "{point:?}");
        let found = equations.linearised(point).unwrap_or_else(|why| panic!("{why}"));
        assert!((found.b[(1, 1)] - 0.5).abs() < 1e-15 && found.b[(1, 0)] == 0.0, "{}", found.b);
        assert!((found.point.accelerations[0] - force / 2.0).abs() < 1e-14);
    }
}
