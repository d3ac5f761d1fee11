//! Snapshots of the cost, in evaluations, of the configurations in the work-precision study; and tests of their models.
//!
//! The counts must be the same on every computer. If possible, methods run in double-double: differences between
//! computers are then 1e-16 times smaller than the errors that control the steps. Dormand-Prince runs in `f64` with
//! rates computed in double-double and then rounded, so that every cosine is correctly rounded. Taylor's method in
//! `f64` selects its instructions at run time, which changes rounding; its counts here are those of the series in
//! double-double.

use dalembert_derivations::studies::AnyScene;
use field::DoubleDouble;
use field::Over;
use integrators::*;
use reader::Family;
use simulation::work_precision::{Configuration, Goal, Standing, Treated};
use simulation::{Axes, IvpScene};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A scene of any family, including systems written as text.
fn open(name: &str) -> AnyScene {
    scenes::register(|_| ());
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    AnyScene::open(&path).unwrap_or_else(|error| panic!("{error}"))
}

/// A law whose `f64` values are rounded from double-double.
struct Rounded<'a>(&'a dyn System);

fn lifted(y: &[f64]) -> Vec<DoubleDouble> {
    y.iter().map(|y| DoubleDouble::lift(*y)).collect()
}

impl Ode<f64> for Rounded<'_> {
    fn dimension(&self) -> usize {
        Ode::<f64>::dimension(self.0)
    }

    fn rates(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        let mut exact = lifted(dy);
        Ode::<DoubleDouble>::rates(self.0, DoubleDouble::lift(t), &lifted(y), &mut exact);
        dy.iter_mut().zip(exact).for_each(|(dy, exact)| *dy = exact.hi());
    }
}

macro_rules! as_before {
    ($field:ty) => {
        impl Ode<$field> for Rounded<'_> {
            fn dimension(&self) -> usize {
                Ode::<$field>::dimension(self.0)
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                self.0.rates(t, y, dy);
            }
        }
    };
}
as_before!(Dual8);
as_before!(DoubleDouble);
impl System for Rounded<'_> {
    fn projection(&self) -> Option<&dyn Projection<f64>> {
        self.0.projection()
    }
}

const TOLERANCES: [f64; 5] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11];
const STEPS: [u32; 3] = [250, 1_000, 4_000];
const ERRORS: [f64; 3] = [1e-3, 1e-6, 1e-9];
/// The greatest number of evaluations in one run; less for explicit methods that are known to use all of them.
const EVALUATIONS: u64 = 20_000;
const STIFF: u64 = 4_000;
const INSTANTS: usize = 8;
/// Smaller errors are replaced by this one: they may consist of rounding, which differs between computers, and the
/// counts between two tolerances are interpolated by the errors of both.
const ROUNDING: f64 = 1e-11;

/// The reference motion: to 16 digits, by a method in double-double.
fn goal(scene: &dyn IvpScene, stiff: bool) -> Goal {
    let problem = scene.problem(Axes::First);
    let span = Span::new(0.0, problem.span, &lifted(&problem.state)).with_even_outputs(INSTANTS);
    let method = if stiff { Method::RadauIIA { stages: 7 } } else { Method::Taylor };
    let mut record = Record::new();
    let outcome = integrate_in(&*problem.law, method, &Tolerance::both(1e-17), &span, &mut record);
    assert!(outcome.reached(), "{}: {:?}", scene.title(), outcome.end);
    let size = |i: usize| record.states.iter().map(|state| state[i].hi().abs()).fold(problem.state[i].abs(), f64::max);
    let sizes = (0..problem.state.len()).map(size).map(|size| if size > 0.0 { size } else { 1.0 }).collect();
    let Record { times, states } = record;
    let (methods, work) = ([method; 2], [outcome.work; 2]);
    let reference = Reference { times, states, digits: 16.0, sizes, methods, work };
    Goal::of(&problem.columns, &problem.row, &reference, scene.observed(&reference))
}

/// The methods of a configuration, each with its runs: (name, runs).
fn runs(way: &Configuration, stiff: bool, tolerance: impl Fn(f64) -> Tolerance) -> Vec<(String, Vec<Attempted>)> {
    let adaptive =
        |method: Method| (method.to_string(), TOLERANCES.map(|each| (Some(method), tolerance(each), None)).to_vec());
    match &way.law {
        Treated::Free(_) if way.formulation.name() == "momenta" => {
            let splitting = Splitting::KahanLi8;
            let each = |steps| (Some(Method::Split { splitting, steps }), tolerance(1e-9), None);
            vec![("Kahan-Li 8".to_owned(), STEPS.map(each).to_vec())]
        }
        // in `f64` only the steps are projected onto the constraints
        Treated::Free(law) if law.projection().is_some() => {
            let each = |steps| (Some(Method::RungeKutta4 { steps }), tolerance(1e-9), None);
            vec![adaptive(Method::DormandPrince8), ("Runge-Kutta 4".to_owned(), STEPS.map(each).to_vec())]
        }
        Treated::Free(_) if way.standing == Standing::Approximate => vec![adaptive(Method::DormandPrince8)],
        Treated::Free(_) => {
            let mut methods = vec![Method::DormandPrince8, Method::GraggBulirschStoer, Method::Taylor];
            if stiff {
                methods.push(Method::RadauIIA { stages: 5 });
            }
            methods.into_iter().map(adaptive).collect()
        }
        Treated::Held(_) => {
            let gauss = |steps| (None, tolerance(1e-9), Some(Index2Method::ProjectedGauss { stages: 3, steps }));
            let explicit = |steps| (None, tolerance(1e-9), Some(Index2Method::HalfExplicitRungeKutta4 { steps }));
            vec![
                ("half-explicit RK 4".to_owned(), STEPS.map(explicit).to_vec()),
                ("Gauss, 3 stages".to_owned(), STEPS.map(gauss).to_vec()),
            ]
        }
        Treated::Hybrid(_) => panic!("no scene of these has events"),
    }
}

type Attempted = (Option<Method>, Tolerance, Option<Index2Method>);

/// The number of evaluations, and the error or the reason why there is none.
fn run(
    way: &Configuration,
    goal: &Goal,
    (span, most): (f64, u64),
    (method, tolerance, holding): &Attempted,
) -> (u64, Result<f64, Failure>) {
    let of = |outcome: Option<Failure>, work: Work, columns: usize, record: Record<f64>| {
        let evaluations = work.rates + work.jacobians * columns as u64 + work.constraints;
        (evaluations, outcome.map_or_else(|| Ok(goal.error(way, &record)), Err))
    };
    let columns = way.state.len();
    let plain = Span::new(0.0, span, &way.state).with_even_outputs(INSTANTS).with_evaluations(most);
    let exact = Span::new(0.0, span, &lifted(&way.state)).with_even_outputs(INSTANTS).with_evaluations(most);
    let mut record = Record::new();
    let outcome = match (&way.law, method, holding) {
        (Treated::Free(law), Some(method), _) if !method.traits().exact || law.projection().is_some() => {
            let mut record = Record::new();
            let outcome = integrate(&Rounded(&**law), *method, tolerance, &plain, &mut record);
            return of(outcome.failure(), outcome.work, columns, record);
        }
        (Treated::Free(law), Some(method), _) => integrate_in(&**law, *method, tolerance, &exact, &mut record),
        (Treated::Held(law), _, Some(holding)) => integrate_index2(&**law, *holding, &exact, &mut record),
        _ => panic!("{} has no such method", way.formulation),
    };
    let states = record.states.iter().map(|state| state.iter().map(|y: &DoubleDouble| y.hi()).collect()).collect();
    let multipliers = if holding.is_some() { 2 } else { 0 };
    of(outcome.failure(), outcome.work, columns + multipliers, Record { times: record.times, states })
}

/// A line for each choice.
fn page(name: &str, stiff: bool) -> String {
    let scene = open(name);
    let scene = scene.smooth();
    let span = scene.problem(Axes::First).span;
    let goal = goal(scene, stiff);
    let most = if stiff { STIFF } else { EVALUATIONS };
    let mut text = format!(
        "{}\n\nevaluations to an error of                                                 1e-3     1e-6     1e-9\n",
        scene.title()
    );
    for way in scene.ways() {
        if way.standing == Standing::Approximate && way.formulation.name() != "first form" {
            continue;
        }
        let model = way.model.replace('_', " ");
        for (method, attempts) in runs(&way, stiff, Tolerance::both) {
            let points: Vec<_> = attempts.iter().map(|attempt| run(&way, &goal, (span, most), attempt)).collect();
            let trials: Vec<Trial> = points
                .iter()
                .map(|(cost, error)| Trial { cost: *cost as f64, error: error.ok().map(|error| error.max(ROUNDING)) })
                .collect();
            let failed = points.iter().find_map(|(_, error)| error.as_ref().err().map(Failure::name));
            let judged = |error: f64| match (cost(&trials, error), failed) {
                (Some(cost), _) => format!("{cost:.0}"),
                (None, Some(failure)) => format!("fails: {failure}"),
                (None, None) if way.standing == Standing::Approximate => "model".to_owned(),
                (None, None) => "above".to_owned(),
            };
            let way_of_it = format!("{method:<22} {:<26} {model:<20}", way.formulation.name());
            let [a, b, c] = ERRORS.map(judged);
            let line = match a == b && b == c && a.parse::<u64>().is_err() {
                true => format!("{way_of_it}  {a}"),
                false => format!("{way_of_it} {a:>8} {b:>8} {c:>8}"),
            };
            text += &format!("{}\n", line.trim_end());
        }
    }
    text
}

const SCENES: [(&str, bool); 14] = [
    ("asynchronous_drive", false),
    ("bench", false),
    ("constant_speed", false),
    ("free_rotor", false),
    ("hanging_rest", false),
    ("permanent_rotation", false),
    ("pull_out", false),
    ("spin_up", false),
    ("stiff_damper", true),
    ("bodies/crank_slider", false),
    ("bodies/sleigh", false),
    ("governors/between_discs", false),
    ("governors/drum_programme", false),
    ("governors/released", false),
];

#[test]
fn the_work_of_every_choice_is_what_was_reviewed() {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        while let Some((name, stiff)) = SCENES.get(next.fetch_add(1, Ordering::Relaxed)) {
            done.push((*name, page(name, *stiff)));
        }
        done
    };
    let pages: Vec<(&str, String)> = std::thread::scope(|scope| {
        let hands = std::thread::available_parallelism().map_or(1, usize::from);
        let running: Vec<_> = (0..hands).map(|_| scope.spawn(work)).collect();
        running.into_iter().flat_map(|hand| hand.join().expect("a page is computed")).collect()
    });
    insta::with_settings!({snapshot_path => "../../snapshots/atlas", prepend_module_to_snapshot => false, omit_expression => true}, {
        for (name, page) in &pages {
            insta::assert_snapshot!(name.replace('/', "-"), page);
        }
    });
}

/// The scenes with bars are compared in the common outputs: angular velocity, direction, rotor angle and slip.
#[test]
fn two_windings_have_the_motion_of_all_bars_and_smaller_models_have_not() {
    let scene = open("spin_up");
    let scene = scene.smooth();
    let goal = goal(scene, false);
    let observed: Vec<&str> = goal.observed.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(observed, ["w1", "w2", "w3", "v1", "v2", "v3", "angle", "rotor_speed"]);
    for way in scene.ways().iter().filter(|way| way.formulation.name() == "first form") {
        let attempt = (Some(Method::GraggBulirschStoer), Tolerance::both(1e-13), None);
        let (_, error) = run(way, &goal, (2.0, EVALUATIONS), &attempt);
        let error = error.unwrap_or_else(|failure| panic!("{}: {failure}", way.model));
        assert_eq!(error < 1e-10, way.is_exact(), "{}: {error:e}", way.model);
    }
}

/// A scene of a mechanism over another span.
fn over(name: &str, span: &str) -> AnyScene {
    scenes::register(|_| ());
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    let text = std::fs::read_to_string(path).expect("a scene");
    let line = |line: &str| if line.starts_with("span = ") { format!("span = \"{span}\"") } else { line.to_owned() };
    let text: Vec<String> = text.lines().map(line).collect();
    AnyScene::parse(name, &text.join("\n")).unwrap_or_else(|error| panic!("{error}"))
}

/// Minimal coordinates and every treatment of redundant coordinates give the same motion in the limit.
#[test]
fn every_formulation_of_a_mechanism_tends_to_one_motion() {
    for (name, span) in [
        ("bodies/crank_slider", "10 s"),
        ("drive/euler_bears", "5 s"),
        ("bodies/sleigh", "10 s"),
        ("bodies/coin", "1 s"),
        ("governors/released", "3 s"),
        ("governors/drum_programme", "10 s"),
        ("governors/between_discs", "5 s"),
        ("governors/elastic_stable", "5 s"),
    ] {
        let scene = over(name, span);
        let scene = scene.smooth();
        let (goal, span) = (goal(scene, false), scene.problem(Axes::First).span);
        let ways = scene.ways();
        assert!(ways.len() >= 4, "{name}");
        for way in &ways {
            let attempt = match way.law {
                Treated::Free(_) => (Some(Method::DormandPrince8), Tolerance::both(1e-9), None),
                Treated::Held(_) => {
                    (None, Tolerance::both(1e-9), Some(Index2Method::ProjectedGauss { stages: 3, steps: 400 }))
                }
                Treated::Hybrid(_) => panic!("no mechanism has events"),
            };
            let (_, error) = run(way, &goal, (span, EVALUATIONS), &attempt);
            let error = error.unwrap_or_else(|failure| panic!("{name}, {}: {failure}", way.formulation));
            assert!(error < 1e-4, "{name}, {}: {error:e}", way.formulation);
        }
    }
}
