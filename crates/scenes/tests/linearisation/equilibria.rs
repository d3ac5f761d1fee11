//! Equilibria compared with closed forms.

use super::{CART, scene, stored};
use dalembert_scenes::linearisation::VariedEquations;
use dalembert_scenes::{ModelScene, equilibrium_of, start_of};

const SPRING: &str = "title = \"A mass on a spring\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nk = \"50 N/m\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n\
    [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n\
    [[force]]\nbetween = [\"O\", \"bob\"]\nis = \"-k*(distance(O, P) - l)\"\n[start]\nequilibrium = true\nx = \"guess 0.1 m\"\ny = \"guess -1 m\"\n\
    [run]\nspan = \"1 s\"\n";

#[test]
fn an_equilibrium_is_found_from_a_guess_at_which_a_force_is_stationary() {
    let text = std::fs::read_to_string(stored("models/double_pendulum")).expect("it is there");
    let level = text.replace("a = \"120 deg\"", "a = \"90 deg\"");
    let state = equilibrium_of(&scene(&level).model).unwrap_or_else(|why| panic!("{}", why.title)).state;
    assert!(state.iter().all(|value| value.sin().abs() < 1e-12), "{state:?}");
}

#[test]
fn an_equilibrium_is_found_near_a_guess_or_refused_with_what_is_left() {
    let found = scene(SPRING).start;
    assert!(found[0].abs() < 1e-12 && (found[1] + 1.0 + 2.0 * 9.81 / 50.0).abs() < 1e-12, "{found:?}");
    let falling = SPRING.replace("-k*(distance(O, P) - l)", "0*k*(distance(O, P) - l)");
    let refused = ModelScene::parse("scene.toml", &falling).expect_err("nothing holds it").to_string();
    assert!(
        refused.contains("no equilibrium is found near this start")
            && refused.contains("leaves 19.62 N at the best point"),
        "{refused}"
    );
    let moving = SPRING.replace("[run]", "\"x'\" = \"1 m/s\"\n[run]");
    let refused = ModelScene::parse("scene.toml", &moving).expect_err("it moves").to_string();
    assert!(refused.contains("an equilibrium has no speeds"), "{refused}");
    let odd = SPRING.replace("equilibrium = true", "equilibrium = \"yes\"");
    let refused = ModelScene::parse("scene.toml", &odd).expect_err("it is no flag").to_string();
    assert!(refused.contains("`equilibrium` has the wrong type"), "{refused}");
}

/// A slider-crank under gravity with a torsion spring: the torques balance, and the constraints and the given coordinates hold.
#[test]
fn an_equilibrium_keeps_constraints_and_given_coordinates() {
    let text = std::fs::read_to_string(stored("models/slider_crank")).expect("it is there");
    let text = text
        .replace("is = \"T*N.z\"", "is = \"(T - K*theta)*N.z\"")
        .replace("g = \"9.81 m/s^2\"", "g = \"9.81 m/s^2\"\nK = \"1 N m\"");
    let scene = scene(&text.replace("s = \"0.4 m\"", "equilibrium = true\ns = \"guess 0.38 m\""));
    let equations = VariedEquations::of(&scene.model, &[]).unwrap_or_else(|why| panic!("{why}"));
    let point = equations.with_accelerations(equations.point(0.0, &scene.start)).expect("it is determined");
    assert!(point.accelerations.amax() < 1e-8 && point.speeds.amax() == 0.0, "{point:?}");
    // virtual work: T - K theta = mrod g/2 d(height of the rod's middle)/d theta
    let [theta, phi] = [scene.start[0], scene.start[1]];
    let torque = 0.4 * 9.81 * 0.1 / 2.0 * theta.cos();
    assert!((0.2 - theta - torque).abs() < 1e-9, "{theta} {phi}");
}

#[test]
fn a_start_of_a_scene_is_that_of_its_linear_equations() {
    let scene = scene(CART);
    assert_eq!(start_of(&scene.model).unwrap_or_else(|why| panic!("{}", why.title)), scene.start);
}

const WHEEL: &str = "title = \"A wheel on a spring\"\n[parameters]\nm = \"2 kg\"\nk = \"50 N/m\"\nr = \"0.2 m\"\n[coordinates]\nx = \"m\"\ntheta = \"rad\"\n\
    [speeds]\nw = \"theta'\"\n[frames]\nA = \"N turned -theta about z\"\n[points]\nP = \"O + x*N.x\"\n\
    [bodies.wheel]\nframe = \"A\"\ncentre = \"P\"\nmass = \"m\"\ninertia = \"m*r^2/2\"\n\
    [[force]]\non = \"P\"\nis = \"-k*x*N.x\"\n[[constraint]]\nname = \"roll\"\nzero = \"x' - r*theta'\"\n\
    [start]\nx = \"0.3 m\"\ntheta = \"0.5 rad\"\nw = \"3 rad/s\"\n[run]\nspan = \"1 s\"\n";

const BOWL: &str = "title = \"A ball in a bowl\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"0.2 kg\"\nr = \"0.05 m\"\ng = \"9.81 m/s^2\"\n\
    [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[frames]\nF = \"N free\"\n\
    [points]\nC = \"O + x*N.x + y*N.y + z*N.z\"\nK = \"C + r*unit(C - O)\"\n\
    [bodies.ball]\nframe = \"F\"\ncentre = \"C\"\nmass = \"m\"\ninertia = { principal = [\"2/5*m*r^2\", \"2/5*m*r^2\", \"2/5*m*r^2\"] }\n\
    [[constraint]]\nname = \"roll\"\nzero = \"velocity(ball at K)\"\n\
    [start]\nx = \"0.3 m\"\nz = \"-0.4 m\"\n\"y'\" = \"0.5 m/s\"\n\"F.wx\" = \"guess 0 rad/s\"\n[run]\nspan = \"1 s\"\n";

/// The wheel turns back by the rolled distance. The ball stays in its bowl and has turned by the length of its path divided by its radius.
#[test]
fn an_equilibrium_is_one_that_motions_along_constraints_of_speeds_reach() {
    let found = equilibrium_of(&scene(WHEEL).model).unwrap_or_else(|why| panic!("{}", why.title));
    let [x, theta, ..] = found.state[..] else { panic!("{found:?}") };
    assert!(x.abs() < 1e-12 && (theta - (0.5 - 0.3 / 0.2)).abs() < 1e-10, "{found:?}");
    assert_eq!((found.family, found.is_reached), (0, true));
    let found = equilibrium_of(&scene(BOWL).model).unwrap_or_else(|why| panic!("{}", why.title));
    let [x, y, z, q0, ..] = found.state[..] else { panic!("{found:?}") };
    assert!(x.abs().max(y.abs()) < 1e-9 && (z + 0.5).abs() < 1e-10, "{found:?}");
    let half = 0.6_f64.asin() * 0.5 / 0.05 / 2.0;
    assert!((q0.abs() - half.cos().abs()).abs() < 1e-9, "{found:?}");
    assert_eq!((found.family, found.is_reached), (1, true));
    // with a guess the ball stays in the bowl, too
    let resting = BOWL.replace(
        "x = \"0.3 m\"\nz = \"-0.4 m\"\n\"y'\" = \"0.5 m/s\"",
        "equilibrium = true\nx = \"guess 0.3 m\"\nz = \"guess -0.4 m\"",
    );
    let start = scene(&resting).start;
    assert!((start[2] + 0.5).abs() < 1e-10, "{start:?}");
}

/// The given angle stays fixed: the equilibrium is not reached by rolling from the guess.
#[test]
fn a_start_at_rest_is_sought_beside_the_ways_that_motions_have() {
    let text =
        WHEEL.replace("x = \"0.3 m\"", "equilibrium = true\nx = \"guess 0.3 m\"").replace("w = \"3 rad/s\"\n", "");
    let start = scene(&text).start;
    assert!(start[0].abs() < 1e-12 && start[1] == 0.5, "{start:?}");
    let moving = WHEEL.replace("x = \"0.3 m\"", "equilibrium = true\nx = \"guess 0.3 m\"");
    let refused = ModelScene::parse("scene.toml", &moving).expect_err("it moves").to_string();
    assert!(refused.contains("an equilibrium has no speeds") && refused.contains("w is not zero"), "{refused}");
}

/// A bead between two springs of natural length: the transverse force is of third order, so that Newton's method converges linearly. With
/// stretched springs the position is precise.
#[test]
fn a_place_that_terms_of_higher_order_hold_is_told_to_be_known_roughly() {
    let bead = |rest: &str| {
        let scene = scene(&format!(
            "title = \"A bead\"\n[parameters]\nk = \"300 N/m\"\nL = \"0.5 m\"\nr = \"{rest}\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\n\
             P = \"O + x*N.x + y*N.y\"\nA = \"O - L*N.x\"\nB = \"O + L*N.x\"\n[bodies.bead]\ncentre = \"P\"\nmass = \"(0.2 kg)\"\n\
             [[force]]\nbetween = [\"ground at A\", \"bead\"]\nis = \"-k*(distance(A, P) - r)\"\n\
             [[force]]\nbetween = [\"ground at B\", \"bead\"]\nis = \"-k*(distance(B, P) - r)\"\n\
             [start]\nx = \"0.05 m\"\ny = \"0.02 m\"\n[run]\nspan = \"1 s\"\n"
        ));
        equilibrium_of(&scene.model).unwrap_or_else(|why| panic!("{why:?}"))
    };
    let flat = bead("0.5 m");
    assert_eq!(flat.flat, ["y"]);
    assert!(flat.choice().is_some_and(|told| told.contains("no force rises with `y` to first order")), "{flat:?}");
    let held = bead("0.4 m");
    assert!(held.flat.is_empty() && held.choice().is_none() && held.state[1].abs() < 1e-12, "{held:?}");
}

/// A spring that is slack below its length, and a controller: x = 1 m + 2 N/(20 N/m) if the spring acts, 2/5 m if only the controller does.
#[test]
fn an_equilibrium_has_the_law_of_its_conditions_and_of_its_controller() {
    let pulled = |force: &str, start: &str| {
        format!(
            "title = \"pulled\"\n[coordinates]\nx = \"m\"\n[bodies.bob]\ncentre = \"O + x*N.x\"\nmass = \"(1 kg)\"\n[inputs]\n\
             u = {{ unit = \"N\", value = \"(2 N) - (5 N/m)*x\" }}\n[[force]]\nalong = \"x\"\nis = \"{force}\"\n[start]\nequilibrium = true\n\
             x = \"guess {start}\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let slack = "(2 N) - if(x > (1 m), (20 N/m)*(x - (1 m)), 0)";
    let found = scene(&pulled(slack, "1.2 m")).start;
    assert!((found[0] - 1.1).abs() < 1e-12, "{found:?}");
    assert!((scene(&pulled("u", "0 m")).start[0] - 0.4).abs() < 1e-12);
    let rough =
        ModelScene::parse("scene.toml", &pulled("u - (1 N)*sign(x')", "0 m")).expect_err("it sticks").to_string();
    assert!(rough.contains("an equilibrium at which a condition changes"), "{rough}");
}

/// A capacitor behind a resistor has one law with charge and current; no displacement is admissible, and q = U C is found nevertheless.
#[test]
fn an_equilibrium_is_not_sought_along_laws_of_places() {
    let found = scene(
        "title = \"charged\"\n[coordinates]\nq = \"C\"\n[energies]\npotential = \"q^2/(2*(1 mF))\"\ndissipation = \"(5 ohm)/2*q'^2\"\n\
         [[force]]\nalong = \"q\"\nis = \"(10 V)\"\n[run]\nspan = \"1 s\"\n",
    );
    let rest = equilibrium_of(&found.model).unwrap_or_else(|why| panic!("{}", why.title));
    assert!((rest.state[0] - 0.01).abs() < 1e-14 && rest.state[1] == 0.0 && !rest.is_reached, "{rest:?}");
}
