//! Linear equations, equilibria and inverse dynamics of systems that are text, beside closed forms and beside the equations that run.

use derivations::scene::{Axes, Smooth};
use integrators::{Directions, Jacobian, Ode};
use model::Model;
use nalgebra::{DMatrix, DVector};
use scenes::inverse::inverse;
use scenes::linearisation::{Linearisation, Point, Stability, Standing, VariedEquations, eigenvalues};
use scenes::{ModelScene, equilibrium_of, read_prescribed, start_of};
use std::path::{Path, PathBuf};

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn stored(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/models").join(name).with_extension("toml")
}

fn linear(model: &Model, state: &[f64], inputs: &[usize]) -> (VariedEquations, Linearisation) {
    let equations = VariedEquations::of(model, inputs).unwrap_or_else(|why| panic!("{why}"));
    let found = equations.linearised(equations.point(0.0, state)).unwrap_or_else(|why| panic!("{why}"));
    (equations, found)
}

/// Up from a cart that a force pushes: x'' = (F - m g a)/M, a'' = ((M + m) g a - F)/(M l).
const CART: &str = "title = \"A cart with a pole\"\ngravity = \"-g*N.y\"\n[parameters]\nM = \"1.5 kg\"\nm = \"0.25 kg\"\nl = \"0.5 m\"\ng = \"9.8 m/s^2\"\n\
    F = \"0 N\"\n[coordinates]\nx = \"m\"\na = \"rad\"\n[points]\nC = \"O + x*N.x\"\nP = \"C + l*(sin(a)*N.x + cos(a)*N.y)\"\n\
    [bodies.cart]\ncentre = \"C\"\nmass = \"M\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n[[force]]\non = \"cart\"\nis = \"F*N.x\"\n\
    [outputs]\ntip = \"x + l*sin(a)\"\npull = \"rate(x')\"\n[run]\nspan = \"1 s\"\n";

#[test]
fn a_cart_with_a_pole_has_its_closed_form() {
    let scene = scene(CART);
    let input = scene.model.parameters.iter().position(|parameter| parameter.name == "F").expect("it is there");
    let (equations, found) = linear(&scene.model, &scene.start, &[input]);
    let (big, small, l, g) = (1.5, 0.25, 0.5, 9.8);
    let a = [0., 0., 1., 0., 0., 0., 0., 1., 0., -small * g / big, 0., 0., 0., (big + small) * g / (big * l), 0., 0.];
    let b = [0., 0., 1. / big, -1. / (big * l)];
    let close = |found: &DMatrix<f64>, expected: &[f64]| {
        let expected = DMatrix::from_row_slice(found.nrows(), found.ncols(), expected);
        assert!((found - &expected).amax() < 1e-13, "{found} {expected}");
    };
    close(&found.a, &a);
    close(&found.b, &b);
    close(&found.c, &[1., l, 0., 0., 0., -small * g / big, 0., 0.]);
    close(&found.d, &[0., 1. / big]);
    assert_eq!(equations.standing(&found), Ok(Standing::Equilibrium));
    assert_eq!(Stability::of(&eigenvalues(&found.a), true), Stability::Unstable(1));
    let largest = eigenvalues(&found.a).values[0].re;
    assert!((largest - a[13].sqrt()).abs() < 1e-13, "{largest}");
}

#[test]
fn a_hanging_double_pendulum_has_its_two_frequencies() {
    let text = std::fs::read_to_string(stored("double_pendulum")).expect("it is there");
    let hanging = text.replace("a = \"120 deg\"", "a = \"0.1 rad\"").replace("b = \"90 deg\"", "b = \"-0.2 rad\"");
    let scene = scene(&hanging);
    let state = equilibrium_of(&scene.model).unwrap_or_else(|why| panic!("{}", why.title));
    assert!(state.iter().all(|value| value.abs() < 1e-14), "{state:?}");
    let (_, found) = linear(&scene.model, &state, &[]);
    let all = eigenvalues(&found.a);
    for squared in [9.81 * (2.0 - 2.0_f64.sqrt()), 9.81 * (2.0 + 2.0_f64.sqrt())] {
        let pair =
            all.values.iter().filter(|value| (value.im.abs() - squared.sqrt()).abs() < 1e-12 && value.re.abs() < 1e-12);
        assert_eq!(pair.count(), 2, "{all:?}");
    }
    assert_eq!(Stability::of(&all, true), Stability::Undecided(4));
}

/// Without constraints A is the Jacobian of the law that runs, along the motion too, by dual numbers.
#[test]
fn a_moving_point_has_the_jacobian_of_the_law_that_runs() {
    let moving = CART.replace("[run]", "[start]\na = \"0.4 rad\"\n\"a'\" = \"1.7 rad/s\"\n\"x'\" = \"0.3 m/s\"\n[run]");
    for text in [moving, std::fs::read_to_string(stored("double_pendulum")).expect("it is there")] {
        let scene = scene(&text);
        let (equations, found) = linear(&scene.model, &scene.start, &[]);
        let law = scene.problem(Axes::First).law;
        let n = scene.start.len();
        let mut expected = vec![0.0; n * n];
        let dual: &dyn Ode<Directions> = &*law;
        Jacobian::new(dual).matrix(0.0, &scene.start, &mut expected);
        let expected = DMatrix::from_row_slice(n, n, &expected);
        assert!((&found.a - &expected).amax() < 1e-11 * expected.amax(), "{} {expected}", found.a);
        assert_eq!(equations.standing(&found), Ok(Standing::Moving));
    }
}

/// A state on the constraints whose independent parts have these values.
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

/// With constraints A is what the equations make of two states on the constraints, closer and closer: loops, rolling.
#[test]
fn constrained_systems_have_the_linear_equations_of_states_on_their_constraints() {
    let crank = std::fs::read_to_string(stored("slider_crank")).expect("it is there");
    let turned = crank.replace("s = \"0.4 m\"", "theta = \"0.5 rad\"\n\"theta'\" = \"2 rad/s\"\ns = \"guess 0.35 m\"");
    let rolling = std::fs::read_to_string(stored("rolling_disc")).expect("it is there");
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
            // central differences, the error of second order taken out
            let [near, far] = [step, 2.0 * step].map(|step| (rates(step) - rates(-step)) / (2.0 * step));
            let expected = (near * 4.0 - far) / 3.0;
            let gap = (found.a.column(column) - &expected).amax();
            assert!(gap < 1e-8 * (1.0 + expected.amax()), "{}, column {column}: {gap:e}", scene.title);
        }
    }
}

/// Figures of Meijaard et al. at 5 m/s, checked at forty digits: weave and capsize of the nonlinear text, linearised.
#[test]
fn whipples_bicycle_has_the_published_eigenvalues() {
    let text = std::fs::read_to_string(stored("bicycle")).expect("it is there");
    let upright = text.replace("lean = \"0.05 rad\"", "lean = \"0 rad\"");
    let scene = scene(&upright.replace("\"-16.6 rad/s\"", "\"-16.666666666666668 rad/s\""));
    let (equations, found) = linear(&scene.model, &scene.start, &[]);
    assert_eq!(equations.standing(&found), Ok(Standing::Steady));
    assert_eq!([found.coordinates.len(), found.speeds.len()], [7, 3]);
    let all = eigenvalues(&found.a);
    assert_eq!((all.idle, Stability::of(&all, true)), (6, Stability::Asymptotic { idle: 6 }));
    for [re, im] in [
        [-14.0783896927982, 0.0],
        [-0.322866429004087, 0.0],
        [-0.775341882195842, 4.46486771378823],
        [-0.775341882195842, -4.46486771378823],
    ] {
        assert!(all.values.iter().any(|value| (value.re - re).hypot(value.im - im) < 1e-11), "{re} {im}: {all:?}");
    }
}

/// A cart against a wall of spring, pushed by an input; a path that is led to zero ties nothing down.
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

const SPRING: &str = "title = \"A mass on a spring\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nk = \"50 N/m\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n\
    [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n\
    [[force]]\nbetween = [\"O\", \"bob\"]\nis = \"-k*(distance(O, P) - l)\"\n[start]\nequilibrium = true\nx = \"guess 0.1 m\"\ny = \"guess -1 m\"\n\
    [run]\nspan = \"1 s\"\n";

/// Where the forces' derivatives vanish Newton's method has no way: points around it do.
/// m x'' = min(k (sin t - x), F), of which the second input holds the first.
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

#[test]
fn an_equilibrium_is_found_from_a_guess_at_which_a_force_is_stationary() {
    let text = std::fs::read_to_string(stored("double_pendulum")).expect("it is there");
    let level = text.replace("a = \"120 deg\"", "a = \"90 deg\"");
    let state = equilibrium_of(&scene(&level).model).unwrap_or_else(|why| panic!("{}", why.title));
    assert!(state.iter().all(|value| value.sin().abs() < 1e-12), "{state:?}");
}

#[test]
fn an_equilibrium_is_found_near_a_guess_or_refused_with_what_is_left() {
    let found = scene(SPRING).start;
    assert!(found[0].abs() < 1e-12 && (found[1] + 1.0 + 2.0 * 9.81 / 50.0).abs() < 1e-12, "{found:?}");
    let falling = SPRING.replace("-k*(distance(O, P) - l)", "0*k*(distance(O, P) - l)");
    let refused = ModelScene::parse("scene.toml", &falling).expect_err("nothing holds it").to_string();
    assert!(refused.contains("no equilibrium is found near this start") && refused.contains("1.962000e1"), "{refused}");
    let moving = SPRING.replace("[run]", "\"x'\" = \"1 m/s\"\n[run]");
    let refused = ModelScene::parse("scene.toml", &moving).expect_err("it moves").to_string();
    assert!(refused.contains("an equilibrium has no speeds"), "{refused}");
    let odd = SPRING.replace("equilibrium = true", "equilibrium = \"yes\"");
    let refused = ModelScene::parse("scene.toml", &odd).expect_err("it is no flag").to_string();
    assert!(refused.contains("`equilibrium` has the wrong type"), "{refused}");
}

/// A crank on a slider that rests on its guide under its own weight: the reaction and the torque of the spring balance.
#[test]
fn an_equilibrium_keeps_constraints_and_given_coordinates() {
    let text = std::fs::read_to_string(stored("slider_crank")).expect("it is there");
    let text = text
        .replace("is = \"T*N.z\"", "is = \"(T - K*theta)*N.z\"")
        .replace("g = \"9.81 m/s^2\"", "g = \"9.81 m/s^2\"\nK = \"1 N m\"");
    let scene = scene(&text.replace("s = \"0.4 m\"", "equilibrium = true\ns = \"guess 0.38 m\""));
    let equations = VariedEquations::of(&scene.model, &[]).unwrap_or_else(|why| panic!("{why}"));
    let point = equations.with_accelerations(equations.point(0.0, &scene.start)).expect("it is determined");
    assert!(point.accelerations.amax() < 1e-8 && point.speeds.amax() == 0.0, "{point:?}");
    // virtual work: T - K theta = mrod g/2 d(height of the rod's middle)/d theta, by the crank's angle
    let [theta, phi] = [scene.start[0], scene.start[1]];
    let torque = 0.4 * 9.81 * 0.1 / 2.0 * theta.cos();
    assert!((0.2 - theta - torque).abs() < 1e-9, "{theta} {phi}");
}

#[test]
fn inverse_dynamics_gives_the_torque_that_runs_the_motion() {
    let path = stored("slider_crank");
    let motion = [("theta".to_owned(), "0.4 + 0.3*sin(t*(5 rad/s))".to_owned())];
    let (model, prescribed) = read_prescribed(&path, &motion).unwrap_or_else(|error| panic!("{error}"));
    let place = model.parameters.iter().position(|parameter| parameter.name == "T").expect("it is there");
    let times = [0.0, 0.1, 0.55];
    let (found, _) = inverse(&model, &prescribed, &["T".to_owned()], &times).unwrap_or_else(|why| panic!("{why}"));
    for forces in found {
        let mut driven = model.clone();
        driven.parameters[place].value = Some(forces.unknowns[0]);
        let equations = VariedEquations::of(&driven, &[]).unwrap_or_else(|why| panic!("{why}"));
        let state = [forces.coordinates.clone(), forces.speeds.clone()].concat();
        let point = equations.with_accelerations(equations.point(forces.time, &state)).expect("it is determined");
        let exact = -0.3 * 25.0 * (5.0 * forces.time).sin();
        assert!((point.accelerations[0] - exact).abs() < 1e-9, "{} {exact}", point.accelerations[0]);
        for (k, value) in forces.multipliers.iter().enumerate() {
            assert!((point.multipliers[k] - value).abs() < 1e-9, "{value}");
        }
    }
    let refused = |motion: &[(String, String)], unknowns: &[&str]| {
        let unknowns: Vec<String> = unknowns.iter().map(|name| (*name).to_owned()).collect();
        let (model, prescribed) = read_prescribed(&path, motion).unwrap_or_else(|error| panic!("{error}"));
        inverse(&model, &prescribed, &unknowns, &times).expect_err("it is refused").to_string()
    };
    assert!(refused(&motion, &[]).contains("2 of 3 equations (the rank): underactuated"));
    assert!(refused(&motion, &["theta"]).contains("neither a parameter nor an input"));
    assert!(refused(&motion, &["r"]).contains("not linear in `r`"));
    let state = [("theta".to_owned(), "phi".to_owned())];
    assert!(refused(&state, &["T"]).contains("must be an expression of t"));
    let wrong = read_prescribed(&path, &[("theta".to_owned(), "(1 m)".to_owned())]).expect_err("metres").to_string();
    assert!(wrong.contains("a prescribed motion: ") && wrong.contains("different dimensions"), "{wrong}");
    let zero = [("theta".to_owned(), "(0 deg)".to_owned())];
    let (model, prescribed) = read_prescribed(&path, &zero).unwrap_or_else(|error| panic!("{error}"));
    let (resting, _) = inverse(&model, &prescribed, &["T".to_owned()], &[0.0]).unwrap_or_else(|why| panic!("{why}"));
    // level, the rod's weight on the crank's end: half of it, a tenth of a metre out
    assert!((resting[0].unknowns[0] - 0.4 * 9.81 * 0.1 / 2.0).abs() < 1e-12, "{resting:?}");
}

#[test]
fn a_start_of_a_scene_is_that_of_its_linear_equations() {
    let scene = scene(CART);
    assert_eq!(start_of(&scene.model).unwrap_or_else(|why| panic!("{}", why.title)), scene.start);
}

/// A symmetric top about a fixed point, A and C its moments there, in a frame that turns freely.
const FREE_TOP: &str = "title = \"A top\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1.5 kg\"\nl = \"0.2 m\"\nA = \"0.09 kg m^2\"\nC = \"0.01 kg m^2\"\n\
    g = \"9.81 m/s^2\"\nk = \"0 N m s\"\n[coordinates]\n[frames]\nF = \"N free\"\n[bodies.top]\nframe = \"F\"\ncentre = \"O + l*F.z\"\nmass = \"m\"\n\
    inertia = { principal = [\"A - m*l^2\", \"A - m*l^2\", \"C\"] }\n[[torque]]\non = \"top\"\nis = \"-k*angular_velocity(top)\"\n\
    [outputs]\nnorth = \"l*F.z . N.y\"\n[start]\nSTART\n[run]\nspan = \"1 s\"\n";

/// A w'' - i C s w' - m g l w = 0 of the tilt w = x + i y, seen from axes that turn with s.
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

/// conj(q0) q1: the quaternion of the way from one orientation to another.
fn way(from: &[f64], to: &[f64]) -> [f64; 4] {
    let ([a, b, c, d], [e, f, g, h]) = ([from[0], -from[1], -from[2], -from[3]], [to[0], to[1], to[2], to[3]]);
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

/// Along a motion A is what the law that runs makes of states near it: coordinates apart, and twice the vector of the quaternion between
/// two orientations, whose rate follows from the rates of both.
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

/// A plate that hangs on a pin at its edge, three constraints beside six directions: it swings by m g a/(J + m a^2) in two planes.
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

/// A body on a slide, pushed and turned by forces that are sought; its frame is FRAMES.
const TURNED: &str = "title = \"A body\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"2 kg\"\nA = \"0.3 kg m^2\"\nB = \"0.4 kg m^2\"\nC = \"0.6 kg m^2\"\n\
    g = \"9.81 m/s^2\"\nP = \"0 N\"\nT1 = \"0 N m\"\nT2 = \"0 N m\"\nT3 = \"0 N m\"\n[coordinates]\nx = \"m\"\nCOORDINATES\n[frames]\nFRAMES\n\
    [bodies.stone]\nframe = \"F\"\ncentre = \"O + x*N.x + (0.1 m)*F.z\"\nmass = \"m\"\ninertia = { principal = [\"A\", \"B\", \"C\"] }\n\
    [[force]]\non = \"stone at O + x*N.x\"\nis = \"P*N.x\"\n[[torque]]\non = \"stone\"\nis = \"T1*F.x + T2*F.y + T3*F.z\"\n[run]\nspan = \"1 s\"\n";

fn forces_of(name: &str, text: &str, motions: &[(&str, &str)]) -> Vec<scenes::inverse::Forces> {
    let path = std::env::temp_dir().join(format!("dalembert_{}_{name}.toml", std::process::id()));
    std::fs::write(&path, text).expect("it can be written");
    let motions: Vec<(String, String)> = motions.iter().map(|&(name, is)| (name.to_owned(), is.to_owned())).collect();
    let read = read_prescribed(&path, &motions);
    std::fs::remove_file(&path).expect("it is there");
    let (model, prescribed) = read.unwrap_or_else(|error| panic!("{error}"));
    let unknowns = ["P", "T1", "T2", "T3"].map(str::to_owned);
    inverse(&model, &prescribed, &unknowns, &[0.0, 0.3, 1.1]).unwrap_or_else(|why| panic!("{why}")).0
}

/// A free frame that is turned one turn after the other needs the torques that three angles need.
#[test]
fn forces_for_turns_of_a_free_frame_are_those_for_three_angles() {
    let slide = ("x", "(0.2 m)*sin(t*(3 rad/s))");
    let [yaw, tilt, spin] = ["0.4 + t*(0.7 rad/s)", "1 + 0.3*cos(t*(2 rad/s))", "t^2*(3 1/s^2)"];
    let free = TURNED.replace("COORDINATES", "").replace("FRAMES", "F = \"N free\"");
    let free =
        forces_of("free", &free, &[slide, ("F", &format!("{yaw} about z, then {tilt} about x, then {spin} about z"))]);
    let turned = TURNED.replace("COORDINATES", "yaw = \"rad\"\ntilt = \"rad\"\nspin = \"rad\"").replace(
        "FRAMES",
        "Y = \"N turned yaw about z\"\nT = \"Y turned tilt about x\"\nF = \"T turned spin about z\"",
    );
    let turned = forces_of("turned", &turned, &[slide, ("yaw", yaw), ("tilt", tilt), ("spin", spin)]);
    for (free, turned) in free.iter().zip(&turned) {
        assert_eq!([free.coordinates.len(), free.speeds.len(), free.accelerations.len()], [5, 4, 4]);
        for (one, other) in free.unknowns.iter().zip(&turned.unknowns) {
            assert!((one - other).abs() < 1e-9 * (1.0 + other.abs()), "{free:?} {turned:?}");
        }
        // at the start one of them is zero
        let act = free.unknowns.iter().filter(|force| force.abs() > 1e-3).count();
        assert_eq!(act, if free.time > 0.0 { 4 } else { 3 }, "{free:?}");
    }
}

/// About one axis alone the torque is C theta''; coordinates that a constraint ties to a free frame follow it.
#[test]
fn a_free_frame_that_turns_about_one_axis_needs_the_torque_of_its_moment() {
    let held = TURNED
        .replace("COORDINATES", "y = \"m\"")
        .replace("FRAMES", "F = \"N free\"")
        .replace("[run]", "[[constraint]]\nname = \"tie\"\nzero = \"y - (0.5 m)*(F.x . N.y)\"\n[run]");
    let found = forces_of("tied", &held, &[("x", "(0 m)"), ("F", "t^2*(2 1/s^2) about z")]);
    for forces in found {
        let angle = 2.0 * forces.time * forces.time;
        assert!((forces.coordinates[1] - 0.5 * angle.sin()).abs() < 1e-12, "{forces:?}");
        assert!((forces.unknowns[3] - 0.6 * 4.0).abs() < 1e-9 && forces.unknowns[0].abs() < 1e-9, "{forces:?}");
    }
}

#[test]
fn a_motion_of_a_free_frame_that_is_no_turn_is_refused() {
    let path = stored("tumbling_body");
    let refused = |motion: &[(&str, &str)]| {
        let motion: Vec<_> = motion.iter().map(|&(name, is)| (name.to_owned(), is.to_owned())).collect();
        match read_prescribed(&path, &motion) {
            Err(error) => error.to_string(),
            Ok((model, prescribed)) => {
                inverse(&model, &prescribed, &[], &[0.0]).expect_err("it is refused").to_string()
            }
        }
    };
    assert!(refused(&[("F", "t*(1 rad/s)")]).contains("turns one after the other: F = "));
    assert!(refused(&[("F", "t*(1 rad/s) about w")]).contains("a free frame turns"));
    assert!(refused(&[("F", "t about z")]).contains("different dimensions"));
    assert!(refused(&[("F", "F.wx*t about z")]).contains("the motion of `F` must be an expression of t"));
    assert!(refused(&[("F", "t*(1 rad/s) about z"), ("F", "0 about x")]).contains("it is prescribed twice"));
    assert!(refused(&[("G", "0 about x")]).contains("a motion for each of: x, F"));
    assert!(refused(&[("x", "(1 m)")]).contains("do not determine `F.wx`, `F.wy`, `F.wz`"));
}

/// Three constraints turn a free frame about N.z by 0.5 t^2, which nobody prescribes: it follows from them, and the third one acts with
/// C theta'' = lambda cos(theta), since it holds sin(theta).
#[test]
fn a_free_frame_that_constraints_turn_is_found_from_them() {
    let held = TURNED.replace("COORDINATES", "").replace("FRAMES", "F = \"N free\"").replace("(0.1 m)*F.z", "0*x*F.z").replace(
        "[[torque]]\non = \"stone\"\nis = \"T1*F.x + T2*F.y + T3*F.z\"\n",
        "[[constraint]]\nname = \"turn\"\nzero = [\"F.x . N.z\", \"F.y . N.z\", \"F.x . N.y - sin(t^2*(0.5 1/s^2))\"]\n",
    );
    let path = std::env::temp_dir().join(format!("dalembert_{}_held.toml", std::process::id()));
    std::fs::write(&path, &held).expect("it can be written");
    let read = read_prescribed(&path, &[("x".to_owned(), "(0.1 m)*t^2/(1 s^2)".to_owned())]);
    std::fs::remove_file(&path).expect("it is there");
    let (model, prescribed) = read.unwrap_or_else(|error| panic!("{error}"));
    let times: Vec<f64> = (0..=10).map(|k| 0.1 * f64::from(k)).collect();
    for forces in inverse(&model, &prescribed, &["P".to_owned()], &times).unwrap_or_else(|why| panic!("{why}")).0 {
        let angle = 0.5 * forces.time * forces.time;
        let [q0, q3] = [forces.coordinates[1], forces.coordinates[4]];
        assert!((2.0 * q3.atan2(q0) - angle).abs() < 1e-9, "{forces:?}");
        assert!(
            (forces.speeds[3] - forces.time).abs() < 1e-9 && (forces.accelerations[3] - 1.0).abs() < 1e-8,
            "{forces:?}"
        );
        assert!((forces.multipliers[2] * angle.cos() - 0.6).abs() < 1e-8, "{forces:?}");
        assert!((forces.unknowns[0] - 2.0 * 0.2).abs() < 1e-9, "{forces:?}");
    }
}
