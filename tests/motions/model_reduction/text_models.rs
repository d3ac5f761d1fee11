//! The choice for text models: errors are below their estimates, and a smaller model that suffices is chosen.

use super::drawn_texts::{KINDS, scene};
use dalembert_derivations::studies::model_reduction::{
    Choice, Models, Receipt, Simplification, SimplifiedScene, TextModels, Wish, choose,
};
use integrators::{Method, Observer, Span, Tolerance, integrate};
use simulation::Axes;
use simulation::models::{Limit, Modelled, readers};
use std::sync::Arc;
use std::time::Duration;

/// The number of instants at which a run is compared with the reference run.
const DENSE: usize = 2_000;

fn opened(text: &str) -> Arc<dyn Modelled> {
    scenes::register(|_| ());
    (readers().expect("they were given").scene)("drawn", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn chosen(scene: &Arc<dyn Modelled>, tolerance: f64) -> (TextModels, Receipt) {
    let models = TextModels::of(scene, None);
    let wish = Wish { tolerance, outputs: scene.run().outputs.clone(), allowed: Duration::ZERO };
    let receipt = choose(&models, &wish).expect("it runs");
    (models, receipt)
}

/// The largest error of a choice at these instants.
fn off(models: &TextModels, receipt: &Receipt, line: usize, choice: &Choice) -> f64 {
    let own = &models.forms(0)[0];
    let dense: Vec<f64> = (1..=DENSE).map(|k| own.span * k as f64 / DENSE as f64).collect();
    let implicit = receipt.lines[0].choice.as_ref().is_some_and(|own| own.plan.method.traits().implicit);
    let method = if implicit { Method::RadauIIA { stages: 7 } } else { Method::DormandPrince8 };
    let (exact, _) = own.run(method, 1e-11, u64::MAX, Some(&dense));
    let (run, _) = models.forms(line)[0].run(choice.plan.method, choice.plan.tolerance, u64::MAX, Some(&dense));
    let (exact, run) = (exact.expect("it runs"), run.expect("it runs"));
    let rows = run.asked.iter().zip(&exact.asked);
    rows.map(|((_, row), (_, exact))| receipt.watched.off(row, exact)).fold(0.0, f64::max)
}

#[test]
fn what_is_taken_of_random_systems_keeps_its_tolerance_over_the_whole_run() {
    let mut smaller = 0;
    for seed in 0..3 * KINDS {
        let (kind, text) = scene(seed);
        let scene = opened(&text);
        for tolerance in [1e-2, 1e-5] {
            let (models, receipt) = chosen(&scene, tolerance);
            let line = receipt.taken.unwrap_or_else(|| panic!("{kind}, seed {seed}, {tolerance:e}: nothing is taken"));
            let choice = receipt.lines[line].choice.as_ref().expect("it runs");
            let off = off(&models, &receipt, line, choice);
            let name = &receipt.lines[line].name;
            assert!(off <= tolerance, "{kind}, seed {seed}, {tolerance:e}: {name} is off by {off:e}\n{text}");
            smaller += usize::from(line > 0);
        }
    }
    assert!(smaller >= 20, "{smaller}");
}

/// The omitted elements are those with fast time scales, and a run of the model by its printed name repeats the run.
#[test]
fn a_motor_of_small_inductance_is_run_without_its_transient_and_a_short_pendulum_apart_is_not_followed() {
    let taken = |text: &str, tolerance: f64| {
        let scene = opened(text);
        let (models, receipt) = chosen(&scene, tolerance);
        let line = receipt.taken.expect("something is taken");
        let name = receipt.lines[line].name.clone();
        assert!(receipt.saved(line).is_some_and(|saved| saved > 1.3), "{name}");
        let simplified = SimplifiedScene::of(&scene, &Simplification::parse(&name).expect("a name")).expect("a model");
        let problem = simplified.whole_problem();
        assert_eq!(problem.state.len(), receipt.lines[line].states);
        assert_eq!(problem.columns, *models.columns());
        name
    };
    assert_eq!(taken(&scene(2).1, 1e-4), "unfollowed b,b'");
    assert_eq!(taken(&scene(8).1, 1e-4), "fixed b,c,b',c'");
    let (_, motor) = scene(0);
    let motor = motor.replace(" - (0.01 N m)*sin(theta)*N.z", "");
    let line = |line: &str| if line.starts_with("L = ") { "L = \"1e-6 H\"".to_owned() } else { line.to_owned() };
    let motor: Vec<String> = motor.lines().map(line).collect();
    assert_eq!(taken(&motor.join("\n"), 1e-2), "quasi-steady drive.q'; unfollowed theta,drive.q");
}

/// If a transient with the time constant T is omitted, the error is its initial value at first, and then T times the
/// rate.
#[test]
fn the_error_of_a_transient_that_is_left_out_is_that_of_its_closed_form() {
    let text = "title = \"creeping\"\n[parameters]\nm = \"1 g\"\n[coordinates]\nx = \"m\"\n[points]\nA = \"O + x*N.x\"\n\
        [bodies.b]\ncentre = \"A\"\nmass = \"m\"\n[[force]]\non = \"b\"\nis = \"(-(1 N/m)*x - (1 N s/m)*x')*N.x\"\n\
        [start]\nx = \"1 m\"\n[run]\nspan = \"3 s\"\noutputs = [\"x\"]\n";
    let scene = opened(text);
    let models = TextModels::of(&scene, None);
    let (watched, _) = models.watched(&scene.run().outputs).expect("it runs");
    let own = scene.problem(Axes::First);
    let mut along = Along(vec![(0.0, own.state.clone())]);
    let span = Span::new(0.0, own.span, &own.state);
    integrate(&*own.law, Method::DormandPrince8, &Tolerance::both(1e-10), &span, &mut along);
    let estimates = models.estimates(&watched, &along.0).expect("the run is known");
    let (lines, _) = models.lines(&watched, 1e-3);
    let place = lines.iter().position(|line| line.name == "quasi-steady x'").expect("it is found");
    let found = estimates[place - 1].as_ref().expect("an estimate");
    // x'' = -1000 (x + x') compared with x' = -x: the exponents are the roots of s^2 + 1000 s + 1000
    let root = (1e6f64 - 4e3).sqrt();
    let (slow, fast) = ((-1e3 + root) / 2.0, (-1e3 - root) / 2.0);
    let exact = |t: f64| (fast * (slow * t).exp() - slow * (fast * t).exp()) / (fast - slow);
    let off = along.0.iter().map(|(t, _)| (exact(*t) - (-t).exp()).abs()).fold(0.0, f64::max);
    assert!((found.first / off - 1.0).abs() < 0.02, "{:e} {off:e}", found.first);
}

/// The states after each step of a run.
struct Along(Vec<(f64, Vec<f64>)>);

impl Observer<f64> for Along {
    fn step(&mut self, time: f64, state: &[f64]) {
        self.0.push((time, state.to_vec()));
    }
}

/// A block with negligible dry friction, and additional text, for example a motor with negligible inductance.
fn sliding(extra: &str) -> String {
    format!(
        "title = \"sliding\"\n[parameters]\nm = \"1 kg\"\nk = \"1 N/m\"\nF = \"1e-9 N\"\nL = \"1e-5 H\"\n[coordinates]\nx = \"m\"\n{extra}\n\
         [[force]]\nalong = \"x\"\nis = \"-k*x - F*sign(x')\"\n[start]\nx = \"12 m\"\n[run]\nspan = \"30 s\"\noutputs = [\"x\"]\n"
    )
}

/// If an element is omitted, its event condition is omitted too, and the run agrees with the closed form.
#[test]
fn dry_friction_that_hardly_acts_is_left_out_with_its_condition() {
    let scene = opened(&sliding("[energies]\nkinetic = \"m*x'^2/2\""));
    let (models, receipt) = chosen(&scene, 1e-5);
    let line = receipt.taken.expect("something is taken");
    assert_eq!(receipt.lines[line].name, "without F");
    let choice = receipt.lines[line].choice.as_ref().expect("it runs");
    let column = models.columns().iter().position(|name| name == "x").expect("a column");
    for (time, row) in &choice.rows {
        assert!((row[column] - 12.0 * time.cos()).abs() < 12.0 * 1e-5, "{time}");
    }
    let without = scene.in_the_limit(Limit { zero: &["F"], unbounded: &[] }).expect("a scene");
    assert!(scene.problem(Axes::First).switching.is_some() && without.problem(Axes::First).switching.is_none());
    let refused = without.with_values(&[("F", 1.0)]).expect_err("it is left out");
    assert!(refused.contains("`F` is left out"), "{refused}");
}

/// A current whose inductance is omitted satisfies U = R i, and the block that it moves retains its event condition.
#[test]
fn an_inductance_beside_a_condition_is_left_out_and_the_condition_stays() {
    let motor = "q = \"C\"\n[energies]\nkinetic = \"m*x'^2/2 + L*q'^2/2\"\n[[force]]\nalong = \"q\"\nis = \"(3 V) - (2 ohm)*q'\"\n\
                 [[force]]\nalong = \"x\"\nis = \"(1 N/A)*q'\"";
    let scene = opened(&sliding(motor).replace("1e-9 N", "0.5 N").replace("x = \"12 m\"", "x = \"-2 m\""));
    let without = scene.in_the_limit(Limit { zero: &["L"], unbounded: &[] }).expect("a scene");
    let problem = without.problem(Axes::First);
    assert!(problem.switching.is_some());
    let current = problem.columns.iter().position(|name| name == "q'").expect("a column");
    assert!(((problem.row)(0.0, &problem.state)[current] - 1.5).abs() < 1e-12);
    let (models, receipt) = chosen(&scene, 1e-3);
    let line = receipt.taken.expect("something is taken");
    assert_eq!(receipt.lines[line].name, "without L");
    let choice = receipt.lines[line].choice.as_ref().expect("it runs");
    let off = off(&models, &receipt, line, choice);
    assert!(off < 1e-3, "{off:e}");
}

/// Two masses connected by a spring of stiffness K; the second mass has an initial velocity, the first one another
/// spring to the ground.
fn pair(spring: &str) -> String {
    format!(
        "title = \"pair\"\n[parameters]\nm = \"1 kg\"\nM = \"2 kg\"\nk = \"12 N/m\"\nK = \"1e7 N/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
         [bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[bodies.b]\ncentre = \"O + y*N.x\"\nmass = \"M\"\n{spring}\
         [[force]]\non = \"a\"\nis = \"-k*x*N.x\"\n[start]\nx = \"0 m\"\ny = \"0.5 m\"\n\"y'\" = \"3 m/s\"\n\
         [run]\nspan = \"2 s\"\noutputs = [\"x\"]\n"
    )
}

/// For each description of the spring the limit of large stiffness is one mass m + M with the initial momentum: x = 2
/// sin(2 t)/2.
#[test]
fn a_spring_without_bound_joins_two_masses_and_keeps_their_momentum() {
    let springs = [
        "[energies]\npotential = \"K*(y - x - (0.5 m))^2/2\"\n",
        "[[force]]\non = \"a\"\nis = \"K*(y - x - (0.5 m))*N.x\"\n[[force]]\non = \"b\"\nis = \"-K*(y - x - (0.5 m))*N.x\"\n",
        "[[force]]\nbetween = [\"b\", \"a\"]\nis = \"-K*(sqrt((y - x)^2) - (0.5 m))\"\n",
    ];
    for spring in springs {
        let scene = opened(&pair(spring));
        let (models, receipt) = chosen(&scene, 1e-2);
        let line = receipt.taken.expect("something is taken");
        assert_eq!(receipt.lines[line].name, "rigid K", "{spring}");
        let column = models.columns().iter().position(|name| name == "x").expect("a column");
        for (time, row) in &receipt.lines[line].choice.as_ref().expect("it runs").rows {
            assert!((row[column] - (2.0 * time).sin()).abs() < 1e-4, "{time}: {}", row[column]);
        }
    }
}

#[test]
fn what_is_no_spring_and_no_damper_does_not_grow_without_bound() {
    let scene = opened(&pair("[[force]]\nbetween = [\"b\", \"a\"]\nis = \"-K*(y - x - (0.5 m)) - K*x\"\n"));
    for wrong in ["m", "K"] {
        let why = scene.in_the_limit(Limit { zero: &[], unbounded: &[wrong] }).expect_err("it is none");
        assert!(why.contains("is not the stiffness of a spring"), "{wrong}: {why}");
    }
}

/// The model without an element has the law that results from setting the element's parameter to zero, if that law
/// exists.
#[test]
fn what_is_left_out_is_what_is_zero() {
    let mut compared = 0;
    for seed in 0..KINDS {
        let (kind, text) = scene(seed);
        let scene = opened(&text);
        for parameter in scene.parameters() {
            let name = &*parameter.name;
            let Ok(zero) = scene.with_values(&[(name, 0.0)]) else { continue };
            let without = scene.in_the_limit(Limit { zero: &[name], unbounded: &[] }).expect("it runs with zero");
            let rates = |scene: &Arc<dyn Modelled>, state: &[f64]| {
                let mut rates = vec![0.0; state.len()];
                scene.problem(Axes::First).law.rates(0.3, state, &mut rates);
                rates
            };
            let state: Vec<f64> =
                zero.problem(Axes::First).state.iter().zip(1..).map(|(y, k)| y + 0.01 * f64::from(k)).collect();
            let (one, other) = (rates(&zero, &state), rates(&without, &state));
            let size = one.iter().map(|rate| rate.abs()).fold(1.0, f64::max);
            for (one, other) in one.iter().zip(&other) {
                assert!((one - other).abs() <= 1e-12 * size, "{kind}, {name}: {one} {other}");
            }
            compared += 1;
        }
    }
    assert!(compared >= 25, "{compared}");
}

/// The eigenvalues of two blocks on one spring, one of them on a floor: once their iteration did not terminate.
#[test]
fn two_blocks_on_a_spring_of_which_one_touches_a_floor_are_decided() {
    let text = "title = \"blocks\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\ng = \"9.81 m/s^2\"\nK = \"1e3 N/m\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[bodies.a]\ncentre = \"O + x*N.x + y*N.y\"\nmass = \"m\"\n\
        [bodies.b]\ncentre = \"O + z*N.x\"\nmass = \"m\"\n[energies]\npotential = \"K/2*(z - x - (1 m))^2\"\n\
        [[contact]]\nname = \"floor\"\nof = \"a\"\nthrough = \"O\"\nnormal = \"N.y\"\ntouching = true\n\
        [start]\nz = \"1 m\"\n\"x'\" = \"1 m/s\"\n\"z'\" = \"1 m/s\"\n[run]\nspan = \"1 s\"\noutputs = [\"x\"]\n";
    let (_, receipt) = chosen(&opened(text), 1e-2);
    assert!(receipt.taken.is_some());
}

/// A mass on a spring with a stop that it never reaches: events at x = 0 limit the steps of Taylor's method, which are the same at the
/// tolerances of both pilots.
#[test]
fn runs_whose_steps_events_limit_do_not_measure_each_others_errors() {
    let text = "title = \"Stop\"\n[parameters]\nk = \"13.6 N/m\"\ns = \"32.8 N/m\"\ne = \"0.2 m\"\n[coordinates]\nx = \"m\"\n[energies]\n\
        kinetic = \"(0.65 kg)*x'^2\"\npotential = \"k/2*x^2 + (0.0062 N/m^3)*x^4 + s/2*max(abs(x) - e, 0)^2\"\n[start]\nx = \"1 cm\"\n[run]\n\
        span = \"5 s\"\noutputs = [\"kinetic_energy\"]\n";
    let scene = opened(text);
    let (models, receipt) = chosen(&scene, 3e-6);
    let line = receipt.taken.expect("something is taken");
    let choice = receipt.lines[line].choice.as_ref().expect("it runs");
    let off = off(&models, &receipt, line, choice);
    assert!(off <= choice.promised && choice.promised <= 3e-6, "{off:e} where {:e} is promised", choice.promised);
}

/// A fast oscillation without a damper: an implicit method passes over it at a coarse tolerance and not at the fine one.
#[test]
fn a_fast_oscillation_without_loss_is_run_by_an_explicit_method() {
    let text = "title = \"Shaft\"\n[parameters]\nk = \"78100 N m\"\n[coordinates]\nx = \"rad\"\ny = \"rad\"\n[energies]\n\
        kinetic = \"(0.95 kg m^2)*x'^2 + (0.08 kg m^2)*y'^2\"\npotential = \"k/2*(y - x)^2 - (2.78 N m)*cos(y)\"\n\
        dissipation = \"(0.27 N m s)*x'^2\"\n[[force]]\nalong = \"x\"\nis = \"(7.83 N m)\"\n[start]\n\"x'\" = \"1 rad/s\"\n\"y'\" = \"1 rad/s\"\n[run]\n\
        span = \"2 s\"\noutputs = [\"y\"]\n";
    let (_, receipt) = chosen(&opened(text), 1e-7);
    let own = receipt.lines[0].choice.as_ref().expect("it runs");
    assert!(!own.plan.method.traits().implicit && receipt.taken.is_some(), "{:?}", own.plan.method);
}

/// A run has the work of dampers as a state, which changes the steps.
#[test]
fn the_evaluations_that_are_told_of_the_own_model_are_those_of_its_run() {
    let text = "title = \"Damped\"\n[parameters]\nL = \"8 mH\"\n[coordinates]\nx = \"rad\"\ny = \"C\"\n[energies]\nkinetic = \"(0.95 kg m^2)*x'^2\"\n\
        potential = \"(2.1 N m)*x^2\"\ndissipation = \"(0.14 N m s)*x'^2\"\ncoenergy = \"L/2*y'^2\"\n[[force]]\nalong = \"y\"\n\
        is = \"(1 V) - (1.5 ohm)*y' - (0.5 V s)*x'\"\n[[force]]\nalong = \"x\"\nis = \"(0.5 V s)*y'\"\n[start]\nx = \"0.01 rad\"\n[run]\nspan = \"5 s\"\n\
        outputs = [\"x'\", \"y'\"]\n";
    let scene = opened(text);
    for tolerance in [1e-2, 1e-9] {
        let (_, receipt) = chosen(&scene, tolerance);
        let own = receipt.lines[0].choice.as_ref().expect("it runs");
        let problem = scene.metered(Axes::First);
        let choice =
            simulation::Choice { method: own.plan.method, tolerance: own.plan.tolerance, ..scene.run().choice() };
        let trajectory = problem.simulate(&choice, |_| ());
        let work = trajectory.outcome.work;
        let told = work.rates + work.jacobians * problem.state.len() as u64;
        assert_eq!(own.work.evaluations, told, "{tolerance:e}");
    }
}
