//! Optimal regulators: Riccati's equation compared with Bellman's, the cost of the nonlinear run with the predicted cost, and refusals.

use dalembert_scenes::ModelScene;
use dalembert_scenes::regulator::{Controllability, Regulated, regulated};
use mechanics::bellman::Regulator;
use std::time::Duration;

fn cart_pole(from: &str, to: &str) -> String {
    let path = format!("{}/../../scenes/models/cart_pole.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    assert!(text.contains(from), "{from}");
    text.replace(from, to)
}

/// A pendulum with a torque about its pivot, regulated to its free swing.
const SWING: &str = "title = \"swing\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n[coordinates]\na = \"rad\"\n\
                     [frames]\nA = \"N turned a about z\"\n[points]\nP = \"O - l*A.y\"\n[bodies]\nbob = { centre = \"P\", mass = \"m\" }\n\
                     [inputs]\nu = \"N m\"\n[[force]]\nalong = \"a\"\nis = \"u\"\n[start]\na = \"100 deg\"\n[regulator]\n\
                     cost = \"(a/(0.1 rad))^2 + (u/(1 N m))^2\"\nhorizon = \"3 s\"\ndisplaced = { a = \"0.01 deg\", \"a'\" = \"0.1 deg/s\" }\n\
                     [run]\nspan = \"3 s\"\n";

fn found(text: &str) -> Result<Regulated, String> {
    let scene = ModelScene::parse("scene.toml", text).map_err(|error| error.to_string())?;
    regulated(&scene, Duration::from_secs(60))
        .map_err(|issue| format!("{} {} {}", issue.title, issue.label, issue.help.unwrap_or_default()))
}

fn one(text: &str) -> Regulated {
    found(text).unwrap_or_else(|why| panic!("{why}"))
}

fn cost(found: &Regulated) -> f64 {
    found.run.costs.last().expect("it runs") + found.left
}

/// The cost of the nonlinear run and x^T P x differ by terms of higher than second degree in the deviation.
#[test]
fn the_cost_of_the_run_is_riccatis_value_but_for_higher_degrees() {
    let last = "horizon = \"2 s\"\nlast = \"(theta/(0.01 rad))^2 + (theta'/(0.1 rad/s))^2\"\ndisplaced = { theta = \"0.05 deg\" }";
    for text in [
        cart_pole("5 deg", "0.05 deg"),
        cart_pole("displaced = { theta = \"5 deg\" }", "horizon = \"2 s\"\ndisplaced = { theta = \"0.05 deg\" }"),
        cart_pole("displaced = { theta = \"5 deg\" }", last),
        SWING.to_owned(),
    ] {
        let found = one(&text);
        let (cost, predicted) = (cost(&found), found.predicted);
        assert!(predicted > 0.0 && (cost / predicted - 1.0).abs() < 1e-4, "{cost} {predicted}");
        assert!(found.residual < 1e-9, "{}", found.residual);
    }
    // for ten times the deviation of a symmetric system the relative difference is a hundred times as large
    let [small, large] = ["0.5 deg", "5 deg"].map(|angle| {
        let found = one(&cart_pole("5 deg", angle));
        cost(&found) / found.predicted - 1.0
    });
    assert!((large / small / 100.0 - 1.0).abs() < 0.05, "{small} {large}");
}

/// Any other gains have a higher cost.
#[test]
fn no_other_gains_cost_less() {
    let text = cart_pole("5 deg", "0.05 deg");
    let best = cost(&one(&text));
    // cost of this criterion with multiples of the optimal gains
    let closed = |change: f64| {
        let gains = one(&text).gains * change;
        let terms = ["x/(1 m)", "theta/(1 rad)", "x'/(1 m/s)", "theta'/(1 rad/s)"];
        let law: Vec<String> =
            terms.iter().zip(gains.iter()).map(|(term, gain)| format!("({gain:e})*{term}")).collect();
        let closed = format!("u = {{ unit = \"N\", value = \"-({})*(1 N)\" }}", law.join(" + "));
        let (system, _) = text.split_once("[regulator]").expect("it has one");
        let system = system.replace("u = \"N\"", &closed)
            + "[start]\ntheta = \"0.05 deg\"\n[outputs]\nw = \"(x/(1 m))^2 + (theta/(0.1 rad))^2 + (u/(10 N))^2\"\n[run]\nspan = \"10 s\"\nsamples = 20000\ntolerance = 1e-10\n";
        let scene = ModelScene::parse("closed.toml", &system).unwrap_or_else(|error| panic!("{error}"));
        let run = simulation::IvpScene::run(&scene).choice();
        let trajectory = simulation::IvpScene::problem(&scene, run.axes).simulate(&run, |_| {});
        let column = trajectory.column("w").expect("it is shown");
        // trapezoidal rule over equal steps
        let sum: f64 = trajectory.rows.iter().map(|row| row[column]).sum();
        (sum - 0.5 * trajectory.rows[0][column]) * 10.0 / 20_000.0
    };
    assert!((closed(1.0) / best - 1.0).abs() < 1e-4, "{} {best}", closed(1.0));
    assert!(closed(1.1) > best * 1.0005 && closed(0.95) > best * 1.0005, "{} {} {best}", closed(1.1), closed(0.95));
}

/// P satisfies the equation that follows from Bellman's equation, with matrices written by hand.
#[test]
fn riccatis_solution_obeys_the_equation_that_bellmans_gives() {
    let found = one(&cart_pole("5 deg", "5 deg"));
    let (cart, bob, l, g) = (1.0, 0.1, 0.5, 9.81);
    let matrix = [
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [0.0, -bob * g / cart, 0.0, 0.0],
        [0.0, (cart + bob) * g / (cart * l), 0.0, 0.0],
    ];
    let control = [0.0, 0.0, 1.0 / cart, -1.0 / (cart * l)];
    let regulator = Regulator { matrix, control, weights: [1.0, 100.0, 0.0, 0.0], price: 0.01 };
    let value: [[f64; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| found.value[(i, j)]));
    for rate in regulator.riccati(value).as_flattened() {
        assert!(rate.abs() < 1e-10, "{rate}");
    }
    for (k, unit) in [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]].into_iter().enumerate() {
        let gain = -found.gains[(0, 3 * k)];
        assert!((regulator.optimal(value, unit) - gain).abs() < 1e-9, "{gain}");
    }
}

/// A pendulum on a wheel driven by a DC motor; the voltage is the input, and no equation depends on the charge of the winding.
const MOTOR: &str = "title = \"wheel\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"0.3 kg\"\nl = \"0.4 m\"\nr = \"0.1 m\"\ng = \"9.81 m/s^2\"\n\
                     [coordinates]\ntheta = \"rad\"\nphi = \"rad\"\n[points]\nA = \"O + r*theta*N.x\"\nP = \"A + l*(sin(phi)*N.x + cos(phi)*N.y)\"\n\
                     [bodies.wheel]\ncentre = \"A\"\nmass = \"(1 kg)\"\nturns = \"theta\"\ninertia = \"(0.01 kg m^2)\"\n\
                     [bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n[inputs]\nu = \"V\"\n[[drive]]\nname = \"motor\"\nturns = \"theta\"\n\
                     [[drive.winding]]\ninductance = \"(2 mH)\"\nresistance = \"(1 ohm)\"\nsupply = \"u\"\nmotional = \"(0.1 V s)\"\n\
                     [regulator]\ncost = \"(phi/(0.1 rad))^2 + (theta/(1 rad))^2 + (u/(1 V))^2\"\ndisplaced = { phi = \"0.02 deg\" }\n\
                     [run]\nspan = \"10 s\"\n";

/// The states are theta, phi, their rates and the current; the matrices are derived by hand for the system without charge.
#[test]
fn the_charge_of_a_motor_is_no_state_of_a_regulator() {
    let found = one(MOTOR);
    assert_eq!((&found.states.kept[..], &found.states.left_out[..]), (&[0, 1, 3, 4, 5][..], &[2][..]));
    let (m, l, r, g, k, inductance) = (0.3, 0.4, 0.1, 9.81, 0.1, 2e-3);
    let [turning, both, swinging] = [(1.0 + m) * r * r + 0.01, m * r * l, m * l * l];
    let determinant = turning * swinging - both * both;
    let weight = m * g * l / determinant;
    let matrix = [
        [0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0],
        [0.0, -both * weight, 0.0, 0.0, swinging * k / determinant],
        [0.0, turning * weight, 0.0, 0.0, -both * k / determinant],
        [0.0, 0.0, -k / inductance, 0.0, -1.0 / inductance],
    ];
    let control = [0.0, 0.0, 0.0, 0.0, 1.0 / inductance];
    let regulator = Regulator { matrix, control, weights: [1.0, 100.0, 0.0, 0.0, 0.0], price: 1.0 };
    let value: [[f64; 5]; 5] = std::array::from_fn(|i| std::array::from_fn(|j| found.value[(i, j)]));
    for rate in regulator.riccati(value).as_flattened() {
        assert!(rate.abs() < 1e-9, "{rate}");
    }
    for place in 0..5 {
        let unit = std::array::from_fn(|k| if k == place { 1.0 } else { 0.0 });
        let gain = -found.gains[(0, place)];
        assert!((regulator.optimal(value, unit) - gain).abs() < 1e-8, "{gain}");
    }
    let last = "horizon = \"0.3 s\"\nlast = \"(theta'/(1 rad/s))^2\"\ndisplaced";
    for found in [found, one(&MOTOR.replace("displaced", last))] {
        let (cost, predicted) = (cost(&found), found.predicted);
        assert!(predicted > 0.0 && (cost / predicted - 1.0).abs() < 1e-6, "{cost} {predicted}");
        assert!(found.states.left_out == [2] && found.residual < 1e-9, "{found:?}");
        // the current settles within a small fraction of a step
        let all = [Controllability::Modes(Vec::new()), Controllability::Directions { rank: 5, of: 5 }];
        assert!(all.contains(&found.controllability), "{:?}", found.controllability);
    }
}

/// Two carts with a damper on the first: equations and cost depend on their distance only.
#[test]
fn a_regulator_of_a_distance_leaves_the_place_of_both_out() {
    let text = "title = \"carts\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies]\na = { centre = \"O + x*N.x\", mass = \"(1 kg)\" }\n\
                b = { centre = \"O + y*N.x\", mass = \"(1 kg)\" }\n[inputs]\nu = \"N\"\n[[force]]\nalong = \"x\"\nis = \"(1 N/m)*(y - x) - u - (1 N s/m)*x'\"\n\
                [[force]]\nalong = \"y\"\nis = \"u - (1 N/m)*(y - x)\"\n\
                [regulator]\ncost = \"((x - y)/(1 m))^2 + (x'/(1 m/s))^2 + (u/(1 N))^2\"\ndisplaced = { x = \"1 m\" }\n[run]\nspan = \"20 s\"\n";
    let found = one(text);
    assert_eq!((&found.states.kept[..], &found.states.left_out[..]), (&[0, 2, 3][..], &[1][..]));
    assert!((found.states.by_variations[(0, 1)] + 1.0).abs() < 1e-14, "{found:?}");
    let matrix = [[0.0, 1.0, -1.0], [-1.0, -1.0, 0.0], [1.0, 0.0, 0.0]];
    let regulator = Regulator { matrix, control: [0.0, -1.0, 1.0], weights: [1.0, 1.0, 0.0], price: 1.0 };
    let value: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| found.value[(i, j)]));
    for rate in regulator.riccati(value).as_flattened() {
        assert!(rate.abs() < 1e-12, "{rate}");
    }
    assert!((cost(&found) / found.predicted - 1.0).abs() < 1e-8, "{} {}", cost(&found), found.predicted);
    // no internal force changes x + x' + y'; with a position in the cost, this variation is a state that does not decay
    let placed = self::found(&text.replace("(x'/(1 m/s))^2", "(x'/(1 m/s))^2 + (y/(1 m))^2"));
    assert!(placed.is_err_and(|why| why.contains("and no input influences it")));
}

/// Inside the limits of the force, the loop equals that without limits; beyond them the cost is higher, and an event ends the run.
#[test]
fn a_loop_runs_across_the_bounds_of_its_force_and_across_events() {
    let fine = |text: String| one(&text.replace("span = \"10 s\"", "span = \"10 s\"\ntolerance = 1e-13"));
    let free = fine(cart_pole("5 deg", "5 deg"));
    let bounded = |bound: &str| {
        cart_pole("is = \"u\"", "is = \"min(max(u, -Umax), Umax)\"")
            .replace("g = \"9.81", &format!("Umax = \"{bound}\"\ng = \"9.81"))
    };
    let wide = fine(bounded("100 N"));
    assert!(
        (cost(&wide) / cost(&free) - 1.0).abs() < 1e-10 && wide.run.passages.len() <= 1,
        "{} {}",
        cost(&wide),
        cost(&free)
    );
    assert!((wide.predicted - free.predicted).abs() < 1e-12);
    for (one, other) in wide.run.states.iter().zip(&free.run.states) {
        assert!(one.iter().zip(other).all(|(one, other)| (one - other).abs() < 1e-10), "{one:?} {other:?}");
    }
    let narrow = one(&bounded("2 N"));
    assert!(cost(&narrow) > 1.02 * cost(&free), "{} {}", cost(&narrow), cost(&free));
    assert!(narrow.run.passages.len() >= 2 && narrow.run.left.is_none(), "{:?}", narrow.run.passages);
    let end = narrow.run.states.last().expect("it runs");
    assert!(end.iter().all(|part| part.abs() < 1e-3), "{end:?}");
    let stopped = one(&cart_pole(
        "[run]",
        "[[event]]\nname = \"wall\"\nwhen = \"x - (0.05 m)\"\ndirection = \"up\"\nend = true\n[run]",
    ));
    let end = stopped.run.states.last().expect("it runs");
    assert!((end[0] - 0.05).abs() < 1e-9 && stopped.run.outcome.time < 1.0, "{end:?} {}", stopped.run.outcome.time);
}

/// A mass in uniform motion: the loop returns it to the moving position, with and without limits of the force.
#[test]
fn a_loop_that_changes_brings_back_to_a_steady_motion() {
    let text = |force: &str| {
        format!(
            "title = \"mass\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"(1 kg)\" }}\n[inputs]\nu = \"N\"\n\
             [[force]]\nalong = \"x\"\nis = \"{force}\"\n[start]\n\"x'\" = \"2 m/s\"\n[regulator]\ncost = \"(x/(1 m))^2 + (u/(1 N))^2\"\n\
             displaced = {{ x = \"0.1 m\" }}\n[run]\nspan = \"20 s\"\ntolerance = 1e-13\n"
        )
    };
    let [free, bounded] = ["u", "min(u, (9 N))"].map(|force| one(&text(force)));
    for found in [&free, &bounded] {
        let end = found.run.states.last().expect("it runs");
        assert!((end[0] - 40.0).abs() < 1e-5 && (end[1] - 2.0).abs() < 1e-5, "{end:?}");
        // P = (sqrt 2, 1; 1, sqrt 2)
        assert!((cost(found) - 0.01 * 2.0_f64.sqrt()).abs() < 1e-11, "{}", cost(found));
    }
}

/// A second bob that no input moves; with a spring and a damper its variation decays.
#[test]
fn what_inputs_do_not_reach_is_told() {
    let beside = |force: &str| {
        cart_pole("x = \"m\"\n", "x = \"m\"\ny = \"m\"\n")
            .replace("[bodies]\n", "[bodies]\nother = { centre = \"O + y*N.y\", mass = \"m\" }\n")
            .replace("-g*N.y\"\n\n[parameters]", "-g*N.y\"\n\n[parameters]\nk = \"5 N/m\"\nd = \"1 N s/m\"")
            + &format!("[[force]]\nalong = \"y\"\nis = \"m*g{force}\"\n")
    };
    let why = found(&beside("")).expect_err("nothing moves y");
    assert!(
        why.contains("the mode with the eigenvalue 0.0000 1/s does not decay, and no input influences it"),
        "{why}"
    );
    let damped = one(&beside(" - k*y - d*y'"));
    let Controllability::Modes(modes) = damped.controllability else { panic!("{:?}", damped.controllability) };
    assert_eq!(modes.len(), 2);
    let over = one(&beside("").replace("displaced", "horizon = \"1 s\"\ndisplaced"));
    // the position of the other bob is not a state
    assert_eq!(over.controllability, Controllability::Directions { rank: 4, of: 5 });
    assert_eq!(one(SWING).controllability, Controllability::Directions { rank: 2, of: 2 });
}

#[test]
fn criteria_that_mean_nothing_are_refused_at_their_place() {
    let cost = "(x/(1 m))^2 + (theta/(0.1 rad))^2 + (u/(10 N))^2";
    for (from, to, message) in [
        (cost, "x/(1 m) + (u/(10 N))^2", "terms of the first degree"),
        (cost, "(x/(1 m))^4 + (u/(10 N))^2", "terms beyond the second degree"),
        (cost, "(x/(1 m))^2", "the cost grows with every input"),
        (cost, "(x/(1 m))^2 + (x''/(1 m/s^2))^2 + (u/(10 N))^2", "holds accelerations"),
        (cost, "(theta'/(1 rad/s))^2 + (u/(10 N))^2", "no solution that makes the motion stable"),
        ("inputs = [\"u\"]", "inputs = [\"v\"]", "no input is called `v`"),
        ("displaced = {", "last = \"(x/(1 m))^2\"\ndisplaced = {", "a cost of the end belongs to a horizon"),
        ("displaced = {", "horizon = \"2 m\"\ndisplaced = {", "the horizon cannot be read"),
        ("displaced = {", "horizon = \"-2 s\"\ndisplaced = {", "the horizon of a regulator is positive"),
        ("{ theta = \"5 deg\" }", "{ theta = \"5 m\" }", "the deviation of `theta` cannot be read"),
        ("[regulator]\ninputs = [\"u\"]", "[regulator]\nweight = 2", "unknown key `weight`"),
        (
            "displaced = {",
            "horizon = \"2 s\"\nlast = \"(u/(1 N))^2\"\ndisplaced = {",
            "the cost of the end holds inputs",
        ),
        ("[run]", "[start]\ntheta = \"30 deg\"\n[run]", "is no equilibrium"),
        (
            "displaced = { theta = \"5 deg\" }\n",
            "horizon = \"2 s\"\n[[event]]\nwhen = \"x - (1 m)\"\nend = true\n",
            "over a horizon of a law that changes at conditions or events are not supported yet",
        ),
        ("is = \"u\"", "is = \"u - (1 N)*sign(x')\"", "condition 1 of `if`"),
        (
            "[run]",
            "[[contact]]\nof = \"bob\"\nthrough = \"O - (5 m)*N.x\"\nnormal = \"N.x\"\n[run]",
            "regulators of a model with contacts are not supported yet",
        ),
    ] {
        let why = found(&cart_pole(from, to)).expect_err(to);
        assert!(why.contains(message), "{message}: {why}");
    }
}

/// A rod held at an angle that is not representable: the reference stays at this equilibrium and does not drift away by rounding errors.
#[test]
fn an_unstable_equilibrium_stays_where_it_is() {
    let text = "title = \"rod\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\na = \"rad\"\n[frames]\nA = \"N turned a about z\"\n[bodies.rod]\n\
                frame = \"A\"\ncentre = \"O + (0.5 m)*A.x\"\nmass = \"(1 kg)\"\ninertia = \"(0.01 kg m^2)\"\n\
                [inputs]\nT = { unit = \"N m\", value = \"(0.5 m)*(1 kg)*(9.81 m/s^2)*cos(60*pi/180)\" }\n[[torque]]\non = \"rod\"\nis = \"T*N.z\"\n\
                [start]\na = \"60 deg\"\n[regulator]\ncost = \"(a/(0.1 rad))^2 + (T/(1 N m))^2\"\ndisplaced = { a = \"2 deg\" }\n[run]\nspan = \"40 s\"\n";
    let found = one(text);
    let end = found.run.states.last().expect("it runs");
    assert!((end[0] - 60.0_f64.to_radians()).abs() < 1e-9 && end[1].abs() < 1e-9, "{end:?}");
}

/// For x'' = u with the cost x^2 + u^2, P = (sqrt 2, 1; 1, sqrt 2), also far from the end of a long horizon, for any terminal cost.
#[test]
fn a_long_horizon_has_the_value_of_none() {
    let text = |more: &str| {
        format!(
            "title = \"mass\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"(1 kg)\" }}\n[inputs]\nu = \"N\"\n\
             [[force]]\nalong = \"x\"\nis = \"u\"\n[regulator]\ncost = \"(x/(1 m))^2 + (u/(1 N))^2\"\n{more}[run]\nspan = \"1 s\"\n"
        )
    };
    for more in ["", "horizon = \"1e3 s\"\nlast = \"3*(x/(1 m))^2\"\n", "horizon = \"1e6 s\"\n"] {
        let found = one(&text(more)).value;
        for (entry, known) in found.iter().zip([2.0_f64.sqrt(), 1.0, 1.0, 2.0_f64.sqrt()]) {
            assert!((entry - known).abs() < 1e-9, "{more}: {found}");
        }
    }
}
