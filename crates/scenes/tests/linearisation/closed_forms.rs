//! Linear equations beside closed forms and published figures.

use super::{CART, linear, scene, stored};
use nalgebra::DMatrix;
use scenes::equilibrium_of;
use scenes::linearisation::{Stability, Standing, eigenvalues};

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
