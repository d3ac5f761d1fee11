//! Linear equations compared with closed forms and published values.

use super::{CART, linear, scene, stored};
use dalembert_scenes::equilibrium_of;
use dalembert_scenes::linearisation::{NotLinear, Stability, Standing, VariedEquations, eigenvalues};
use nalgebra::DMatrix;

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
    let text = std::fs::read_to_string(stored("models/double_pendulum")).expect("it is there");
    let hanging = text.replace("a = \"120 deg\"", "a = \"0.1 rad\"").replace("b = \"90 deg\"", "b = \"-0.2 rad\"");
    let scene = scene(&hanging);
    let state = equilibrium_of(&scene.model).unwrap_or_else(|why| panic!("{}", why.title)).state;
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

/// The matrices M, v C1 and g K0 + v^2 K2 for lean and steer of the upright bicycle at a speed (m/s), with torques along lean and steer as inputs.
fn bicycle(speed: f64) -> [DMatrix<f64>; 3] {
    let text = std::fs::read_to_string(stored("foreign/bicycle")).expect("it is there");
    let text = text
        .replace("lean = \"0.05 rad\"", "lean = \"0 rad\"")
        .replace("\"-16.6 rad/s\"", &format!("\"{} rad/s\"", -speed / 0.3))
        .replacen("[parameters]", "[parameters]\nT1 = \"0 N m\"\nT2 = \"0 N m\"", 1)
        + "\n[[force]]\nalong = \"lean\"\nis = \"T1\"\n[[force]]\nalong = \"steer\"\nis = \"T2\"\n";
    let scene = scene(&text);
    let (_, found) = linear(&scene.model, &scene.start, &[0, 1]);
    let place = |name: &str| scene.model.coordinates.iter().position(|own| own.name == name).expect("it is there");
    let own = [place("lean"), place("steer")];
    let of =
        |list: &[usize]| own.map(|place| list.iter().position(|known| *known == place).expect("it is independent"));
    let (places, speeds) = (of(&found.coordinates), of(&found.speeds));
    let first = found.coordinates.len();
    let block = |matrix: &DMatrix<f64>, columns: [usize; 2]| {
        DMatrix::from_fn(2, 2, |row, column| matrix[(first + speeds[row], columns[column])])
    };
    let mass = block(&found.b, [0, 1]).try_inverse().expect("a mass matrix");
    let damping = -&mass * block(&found.a, speeds.map(|speed| first + speed));
    let stiffness = -&mass * block(&found.a, places);
    [mass, damping, stiffness]
}

/// The nonlinear model of the file has the matrices of the benchmark (Meijaard et al. 2007) and its critical speeds of weave and capsize.
#[test]
fn whipples_bicycle_has_the_published_matrices_and_critical_speeds() {
    let ([mass, damping, at_5], [_, _, at_3]) = (bicycle(5.0), bicycle(3.0));
    let of_speed = (&at_5 - &at_3) / (25.0 - 9.0);
    let of_weight = (&at_3 - &of_speed * 9.0) / 9.81;
    for (found, known) in [
        (&mass, [80.81722, 2.319413322087091, 2.319413322087091, 0.2978418819968555]),
        (&(damping / 5.0), [0.0, 33.86641391492494, -0.8503564145697844, 1.6854039739755966]),
        (&of_weight, [-80.95, -2.5995168524987164, -2.5995168524987164, -0.8032948845861769]),
        (&of_speed, [0.0, 76.59734589573222, 0.0, 2.65431523794604]),
    ] {
        for (place, known) in known.into_iter().enumerate() {
            let value = found[(place / 2, place % 2)];
            assert!((value - known).abs() < 1e-9, "{value} and {known}");
        }
    }
    // between the critical speeds the upright motion is stable
    for (speed, stable) in [(4.29238, false), (4.29239, true), (6.02426, true), (6.02427, false)] {
        let [mass, damping, stiffness] = bicycle(speed);
        let inverse = mass.try_inverse().expect("a mass matrix");
        let mut all = DMatrix::zeros(4, 4);
        all.view_mut((0, 2), (2, 2)).fill_with_identity();
        all.view_mut((2, 0), (2, 2)).copy_from(&(-&inverse * stiffness));
        all.view_mut((2, 2), (2, 2)).copy_from(&(-&inverse * damping));
        let largest = eigenvalues(&all).values[0].re;
        assert_eq!(largest < 0.0, stable, "{speed}: {largest}");
    }
}

/// Eigenvalues of Meijaard et al. (2007) at 5 m/s, checked with forty digits, and those of the linearised nonlinear model.
#[test]
fn whipples_bicycle_has_the_published_eigenvalues() {
    let text = std::fs::read_to_string(stored("foreign/bicycle")).expect("it is there");
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

/// An input with a gain is a feedback that A does not contain; with the gain zero it is none.
#[test]
fn an_input_whose_gain_is_zero_is_no_feedback() {
    let with = |gain: &str| {
        let input = format!(
            "[inputs]\nu = {{ unit = \"N\", value = \"{gain}*a\" }}\n[[force]]\non = \"cart\"\nis = \"u*N.x\"\n[outputs]"
        );
        let text = CART.replace("[outputs]", &input).replace("F = \"0 N\"", "F = \"0 N\"\nkp = \"3 N\"");
        let scene = scene(&text);
        VariedEquations::of(&scene.model, &[]).unwrap_or_else(|why| panic!("{why}")).feedback
    };
    assert_eq!(with("kp"), ["u"]);
    assert_eq!(with("F"), [""; 0]);
}

/// A pendulum in the middle of a backlash, where the sign of the angle is zero without effect; and with a spring that begins there.
#[test]
fn a_point_at_a_condition_has_linear_equations_where_both_sides_have_the_same() {
    let pendulum = |spring: &str| {
        scene(&format!(
            "title = \"Pendulum in a play\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"1 kg\"\nk = \"50 N m\"\ne = \"0.1 rad\"\n[coordinates]\n\
             a = \"rad\"\n[bodies]\nb = {{ centre = \"O + (0.5 m)*(sin(a)*N.x - cos(a)*N.y)\", mass = \"m\" }}\n\
             [energies]\npotential = \"{spring}\"\n[run]\nspan = \"1 s\"\n"
        ))
    };
    let about = |spring: &str| {
        let equations = VariedEquations::of(&pendulum(spring).model, &[]).unwrap_or_else(|why| panic!("{why}"));
        equations.about(0.0, &[0.0, 0.0]).map(|found| found.linear.a[(1, 0)])
    };
    // the derivative of the force is equal on both sides
    for spring in ["k*max(abs(a) - e, 0)^2/2", "k*abs(a)^3"] {
        let stiffness = about(spring).unwrap_or_else(|why| panic!("{spring}: {why}"));
        assert!((stiffness + 9.81 / 0.5).abs() < 1e-13, "{spring}: {stiffness}");
    }
    assert_eq!(about("k*max(a, 0)^2/2").err(), Some(NotLinear::AtCondition { switch: 0 }));
}
