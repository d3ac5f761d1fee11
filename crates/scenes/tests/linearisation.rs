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
    let found = inverse(&model, &prescribed, &["T".to_owned()], &times).unwrap_or_else(|why| panic!("{why}"));
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
    let resting = inverse(&model, &prescribed, &["T".to_owned()], &[0.0]).unwrap_or_else(|why| panic!("{why}"));
    // level, the rod's weight on the crank's end: half of it, a tenth of a metre out
    assert!((resting[0].unknowns[0] - 0.4 * 9.81 * 0.1 / 2.0).abs() < 1e-12, "{resting:?}");
}

#[test]
fn a_start_of_a_scene_is_that_of_its_linear_equations() {
    let scene = scene(CART);
    assert_eq!(start_of(&scene.model).unwrap_or_else(|why| panic!("{}", why.title)), scene.start);
}
