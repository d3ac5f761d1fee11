//! Code generated for other languages is compiled and run; its accelerations and multipliers must equal those of the model's equations.

mod languages;
mod notation;
mod rolling_bodies;
mod systems;
mod tops;

use dalembert_model::equations::{Equations, constraints_of};
use dalembert_model::principles::Principle;
use dalembert_model::{MatrixForm, Model, QuasiPrinciple, QuasiVelocities, Source, Trace};
use rolling_bodies::{bowl, joined_bodies, sliding_wedge, turning_incline, turntable};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use symbolic::{Language, Sym, apart};
use systems::{
    double_pendulum, faller, free_top, led_plate, oscillator, pinned_plate, rolling_disc, slider_crank, stop,
};

/// A system, a state, and the accelerations and multipliers at this state.
struct Case {
    name: &'static str,
    model: Model,
    time: f64,
    coordinates: Vec<f64>,
    speeds: Vec<f64>,
    /// Accelerations, then multipliers.
    expected: Vec<f64>,
    /// Rates of the coordinates, then of the speeds.
    rates: Vec<f64>,
}

fn cases() -> Vec<Case> {
    let case = |name, source: Source, coordinates: &[f64], speeds: &[f64]| {
        let model = Model::of(&source).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
        let (coordinates, speeds, time) = (coordinates.to_vec(), speeds.to_vec(), 0.7);
        let (expected, mut rates) = match model.quasi_velocities.is_empty() {
            true => expected(&model, time, &coordinates, &speeds),
            false => expected_of_quasi_velocities(&model, time, &coordinates, &speeds),
        };
        rates.extend(&expected[..speeds.len()]);
        Case { name, model, time, coordinates, speeds, expected, rates }
    };
    let joined = [0.0, 0.1, -0.25, 0.0, 0.1, -0.75, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    vec![
        case("faller", faller(), &[0.2], &[0.1]),
        case("oscillator", oscillator(), &[0.8, -0.3], &[0.4, 1.1]),
        case("stop", stop(), &[0.2], &[-0.3]),
        case("double_pendulum", double_pendulum(), &[0.9, -0.4], &[1.3, 0.7]),
        case("slider_crank", slider_crank(), &[0.6, 0.2, 0.35], &[2.0, -0.7, 0.3]),
        case("free_top", free_top(), &[0.8, -0.3, 0.5, 0.2], &[0.4, 3.0, -7.0]),
        case("pinned_plate", pinned_plate(), &[0.1, 0.4, 0.8, -0.3, 0.5, 0.2], &[0.3, -0.2, 0.4, 3.0, -7.0]),
        case("rolling_disc", rolling_disc(), &[0.1, 0.4, 0.8, -0.3, 0.5], &[0.3, 5.0, -0.7]),
        case("turntable", turntable(), &[0.5, 0.2, 1.0, 0.0, 0.0, 0.0], &[0.1, 0.2, 3.0]),
        case("turning_incline", turning_incline(), &[0.5, 0.2, 1.0, 0.0, 0.0, 0.0], &[0.1, 0.2, 3.0]),
        case("sliding_wedge", sliding_wedge(), &[0.5, 0.2, 0.1, 1.0, 0.0, 0.0, 0.0], &[0.1, 0.2, 3.0, -0.3]),
        case("bowl", bowl(), &[0.3, 0.1, -0.4, 1.0, 0.0, 0.0, 0.0], &[0.3, 0.1, 2.0]),
        case("joined_bodies", joined_bodies(), &joined, &[0.4, -0.3, 5.0, 0.2, 0.7, -0.6]),
        case("led_plate", led_plate(), &[0.1, 0.4, 0.8, -0.3, 0.5, 0.2], &[0.3, -0.2, 0.4, 3.0]),
    ]
}

/// Values of symbols by name.
type Values = HashMap<String, f64>;

fn value(expression: Sym, values: &Values) -> f64 {
    expression.evaluate_analytic(&|name| values.get(name).copied()).expect("every letter has a value")
}

/// Returns the values of all symbols of a model at a state.
fn values(trace: &Trace<'_>, time: f64, coordinates: &[f64], speeds: &[f64]) -> Values {
    let mut values: Values = [("t".to_owned(), time), ("pi".to_owned(), std::f64::consts::PI)].into_iter().collect();
    for parameter in &trace.model.parameters {
        values.insert(parameter.name.clone(), parameter.value.expect("it has one"));
    }
    let state = coordinates.iter().chain(speeds);
    values.extend(trace.model.state_names().into_iter().zip(state).map(|((name, _), value)| (name, *value)));
    for (letter, condition) in trace.switches.iter().zip(&trace.model.switches) {
        let is_positive = value(trace.scalar(*condition), &values) > 0.0;
        values.insert(letter.to_string(), if is_positive { 1.0 } else { 0.0 });
    }
    values
}

/// Returns the accelerations followed by the multipliers, and the rates of the coordinates.
fn expected(model: &Model, time: f64, coordinates: &[f64], speeds: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let mut rates = vec![0.0; coordinates.len()];
    model.position_rates(&[coordinates, speeds].concat(), &mut rates);
    let solved = apart(|| {
        let trace = Trace::of(model);
        let values = values(&trace, time, coordinates, speeds);
        let (accelerations, multipliers) = Equations::of(&trace).solved().expect("it is regular");
        accelerations.into_iter().chain(multipliers).map(|each| value(each, &values)).collect()
    });
    (solved, rates)
}

/// Returns the rates of the quasi-velocities followed by the multipliers of the stabilised constraints, and the rates of the coordinates.
/// All are computed from the equations in the rates of the coordinates.
fn expected_of_quasi_velocities(model: &Model, time: f64, coordinates: &[f64], quasi: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let speeds: Vec<f64> = apart(|| {
        let trace = Trace::of(model);
        let own = QuasiVelocities::of(&trace).expect("they are independent");
        let mut values = values(&trace, time, coordinates, &[]);
        values.extend(own.symbols.iter().map(Sym::to_string).zip(quasi.iter().copied()));
        own.speeds.iter().map(|speed| value(*speed, &values)).collect()
    });
    let (solved, rates) = expected(model, time, coordinates, &speeds);
    let (accelerations, multipliers) = solved.split_at(speeds.len());
    let moved = apart(|| {
        let trace = Trace::of(model);
        let mut values = values(&trace, time, coordinates, &speeds);
        values.extend(trace.accelerations.iter().map(Sym::to_string).zip(accelerations.iter().copied()));
        let own = QuasiVelocities::of(&trace).expect("they are independent");
        own.definitions.iter().map(|is| value(trace.rate_of(*is), &values)).collect::<Vec<f64>>()
    });
    let gains: Vec<bool> = apart(|| constraints_of(&Trace::of(model)).iter().map(|one| one.gains.is_some()).collect());
    let kept = multipliers.iter().zip(gains).filter(|(_, is_programmed)| *is_programmed).map(|(value, _)| *value);
    (moved.into_iter().chain(kept).collect(), rates)
}

/// Returns the matrix form of a system; in quasi-velocities if the system defines some.
fn form(trace: &Trace<'_>) -> MatrixForm {
    if trace.model.quasi_velocities.is_empty() {
        return MatrixForm::of(trace, Principle::Lagrange).expect("it applies");
    }
    let quasi = QuasiVelocities::of(trace).expect("they are independent");
    let principle = if trace.model.free.is_empty() { QuasiPrinciple::Hamel } else { QuasiPrinciple::VirtualPower };
    MatrixForm::in_quasi_velocities(trace, &quasi, principle).expect("it applies")
}

/// Returns the matrix form in which long derivatives of the speeds have symbols of their own. Generated programs do not need them.
fn named_form(trace: &Trace<'_>) -> MatrixForm {
    if trace.model.quasi_velocities.is_empty() {
        return form(trace);
    }
    let quasi = QuasiVelocities::named(trace).expect("they are independent");
    MatrixForm::in_quasi_velocities(trace, &quasi, QuasiPrinciple::VirtualPower).expect("it applies")
}

fn code(case: &Case, language: Language) -> String {
    apart(|| {
        let trace = Trace::of(&case.model);
        dalembert_model::code(&trace, &form(&trace), language).expect("it can be written")
    })
}

fn agree(case: &Case, output: &str) {
    let found: Vec<f64> = output.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    let known = [&case.expected[..], &case.rates].concat();
    assert_eq!(found.len(), known.len(), "{}: {output}", case.name);
    let size = known.iter().fold(1.0, |most: f64, value| most.max(value.abs()));
    for (found, value) in found.iter().zip(&known) {
        assert!((found - value).abs() <= 1e-12 * size, "{}: {found} for {value}", case.name);
    }
}

fn folder(language: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("systems_{language}"));
    fs::create_dir_all(&folder).expect("a folder for the code");
    folder
}

/// Returns whether a command succeeds; if not, prints that the test is skipped.
fn answers(program: &str, arguments: &[&str]) -> bool {
    let answers = Command::new(program).args(arguments).output().is_ok_and(|output| output.status.success());
    if !answers {
        eprintln!("skipped: `{program} {}` is not there", arguments.join(" "));
    }
    answers
}

fn output(command: &mut Command) -> String {
    let output = command.output().expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn listed(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:?}")).collect::<Vec<_>>().join(", ")
}
