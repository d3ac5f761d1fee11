//! Stored reference solutions: they exist for every scene, were computed by two methods, and are recomputed if a scene
//! has changed.

use dalembert_derivations::studies::AnyScene;
use field::{DoubleDouble, Over};
use integrators::{
    Dual8, Failure, Method, Ode, Record, Span, System, TaylorSeries, Tolerance, integrate, integrate_in,
};
use reader::Family;
use simulation::models::holds_model;
use simulation::{Axes, Problem, Stored, references};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The number of digits of every scene's reference.
const DIGITS: f64 = 25.0;

/// The scene files other than text models, which are tested in `crates/scenes`.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the project has scenes");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("it can be listed").path()).collect();
    paths.sort();
    let inside = |path: PathBuf| if path.is_dir() { files(&path) } else { vec![path] };
    paths.into_iter().flat_map(inside).filter(is_own).collect()
}

fn is_own(path: &PathBuf) -> bool {
    let holds_its_system = || std::fs::read_to_string(path).is_ok_and(|text| holds_model(&text));
    path.extension().is_some_and(|end| end == "toml") && !holds_its_system()
}

/// Every scene that is one initial value problem, with its stored reference.
fn all() -> Vec<(String, Problem, Stored)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let open = |path: PathBuf| {
        let scene = AnyScene::open(&path).unwrap_or_else(|error| panic!("{error}"));
        let problem = scene.smooth().problem(Axes::default());
        let name = path.strip_prefix(root).expect("it is in the project").display().to_string();
        let text = std::fs::read_to_string(references::place(&path)).unwrap_or_else(|error| panic!("{name}: {error}"));
        let kept = Stored::read(&text).unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        (name, problem, kept)
    };
    files(&root.join("scenes")).into_iter().map(open).collect()
}

#[test]
fn every_scene_has_a_reference_of_25_digits_or_more_that_is_its_own() {
    let all = all();
    assert!(all.len() >= 21, "{}", all.len());
    for (name, problem, kept) in all {
        assert!(kept.reference.digits >= DIGITS, "{name}: {} digits", kept.reference.digits);
        assert!(kept.belongs_to(&problem), "{name} has changed: `dalembert reference {name}` makes its reference anew");
        for (time, state) in kept.reference.times.iter().zip(&kept.reference.states) {
            let state: Vec<f64> = state.iter().map(|y| y.hi()).collect();
            let left = problem.outside(*time, &state);
            assert_eq!(left, None, "{name}, t = {time}: a reference ends before its law does");
        }
    }
}

#[test]
fn a_reference_is_not_taken_for_that_of_other_data() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = root.join("scenes/spin_up.toml");
    let kept = std::fs::read_to_string(references::place(&file)).expect("it is kept");
    let kept = Stored::read(&kept).unwrap_or_else(|wrong| panic!("{wrong}"));
    let text = std::fs::read_to_string(&file).expect("the scene is there");
    // change the last digit of a moment of inertia, the load, a resistance
    for (datum, other) in
        [("axial = \"2.4e-4 ", "axial = \"2.40000000000001e-4 "), ("f = \"1e-4 ", "f = \"1.00000001e-4 ")]
    {
        assert!(text.contains(datum), "{datum}");
        let changed =
            AnyScene::parse("spin_up.toml", &text.replace(datum, other)).unwrap_or_else(|error| panic!("{error}"));
        let problem = changed.smooth().problem(Axes::default());
        assert!(!kept.belongs_to(&problem), "{other}");
    }
}

#[test]
fn what_is_written_is_read_again_to_the_last_digit() {
    for (name, _, kept) in all() {
        let text = kept.write(&name);
        let again = Stored::read(&text).unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        assert_eq!(again.reference.states, kept.reference.states, "{name}");
        assert_eq!(again.write(&name), text, "{name}");
    }
    let whole = all().remove(0).2.write("a scene");
    let cut = whole.replace("times = [", "times = [9.0, ");
    assert_eq!(Stored::read(&cut).map(|_| ()), Err("a row is missing or short".to_owned()));
    assert!(Stored::read("digits = 30").is_err() && Stored::read("digits = ]").is_err());
}

#[test]
fn references_that_are_made_again_are_those_that_are_kept() {
    // scenes whose references take one or two seconds
    let quick = ["spin_up", "/stiff_diode", "stiff_damper", "pull_out", "between_discs.", "volterra"];
    for (name, mut problem, kept) in
        all().into_iter().filter(|(name, ..)| quick.iter().any(|quick| name.contains(quick)))
    {
        problem.span = *kept.reference.times.last().expect("there are instants");
        let again = problem.reference(Duration::from_secs(600)).unwrap_or_else(|failure| panic!("{name}: {failure}"));
        // other processors round functions differently, which may change a step, but not the methods
        assert_eq!(again.methods, kept.reference.methods, "{name}");
        for (again, kept) in again.work.iter().zip(&kept.reference.work) {
            let apart = again.steps.abs_diff(kept.steps);
            assert!(50 * apart <= kept.steps + 50, "{name}: {} steps, {} kept", again.steps, kept.steps);
        }
        let claimed = 10f64.powf(-kept.reference.digits) + 10f64.powf(-again.digits);
        for (a, b) in again.states.iter().zip(&kept.reference.states) {
            for ((a, b), size) in a.iter().zip(b).zip(&again.sizes) {
                let off = (*a - *b).hi().abs() / size;
                assert!(off < claimed, "{name}: {off:.1e}, {claimed:.1e} claimed");
            }
        }
    }
}

/// A method of a third family, in `f64`, agrees with each reference up to its own errors.
#[test]
fn every_kept_reference_agrees_with_a_run_in_f64() {
    for (name, problem, kept) in all() {
        let times = &kept.reference.times;
        let end = *times.last().expect("there are instants");
        let span = Span::new(0.0, end, &problem.state).with_outputs(times);
        let run = |method, tolerance| {
            let mut record = Record::new();
            let outcome = integrate(&*problem.law, method, &Tolerance::both(tolerance), &span, &mut record);
            (outcome, record)
        };
        let (mut outcome, mut record) = run(Method::DormandPrince8, 1e-13);
        if let Some(Failure::Stiff { .. }) = outcome.failure() {
            (outcome, record) = run(Method::RadauIIA { stages: 5 }, 1e-11);
        }
        assert!(outcome.reached(), "{name}: {:?}", outcome.end);
        let error = kept.reference.error(&record);
        assert!(error < 1e-7, "{name}: {error:.1e}");
    }
}

/// A system whose series are computed in full precision at all orders.
struct AllDigits<'a>(&'a dyn System);

macro_rules! as_before {
    ($field:ty) => {
        impl Ode<$field> for AllDigits<'_> {
            fn dimension(&self) -> usize {
                Ode::<$field>::dimension(self.0)
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                self.0.rates(t, y, dy);
            }
        }
    };
}
as_before!(f64);
as_before!(Dual8);
as_before!(DoubleDouble);

impl System for AllDigits<'_> {
    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        Some(Box::new(Whole(self.0.taylor_exact()?)))
    }
}

struct Whole<'a>(Box<dyn TaylorSeries<DoubleDouble> + 'a>);

impl TaylorSeries<DoubleDouble> for Whole<'_> {
    fn expand(&mut self, t: DoubleDouble, y: &[DoubleDouble], order: usize) {
        self.0.expand(t, y, order);
    }

    fn coefficients(&self, k: usize) -> &[DoubleDouble] {
        self.0.coefficients(k)
    }

    fn sum(&self, h: DoubleDouble, out: &mut [DoubleDouble]) {
        self.0.sum(h, out);
    }
}

#[test]
fn what_series_in_double_double_round_to_f64_does_not_show_at_any_tolerance() {
    let all = all();
    let by_series = all.iter().filter(|(_, _, kept)| kept.reference.methods[1] == Method::Taylor);
    for (name, problem, Stored { reference, .. }) in by_series {
        let start: Vec<DoubleDouble> = problem.state.iter().map(|y| DoubleDouble::lift(*y)).collect();
        let end = *reference.times.last().expect("there are instants");
        let span = Span::new(0.0, end, &start).with_outputs(&reference.times);
        let off = |law: &dyn System, tolerance: f64| {
            let tolerance = Tolerance::scaled(tolerance, &reference.sizes);
            let mut record = Record::new();
            let outcome = integrate_in(law, Method::Taylor, &tolerance, &span, &mut record);
            assert!(outcome.reached(), "{name}: {:?}", outcome.end);
            let rows = record.states.iter().flatten().zip(reference.states.iter().flatten());
            let apart = rows.zip(reference.sizes.iter().cycle()).map(|((a, b), size)| (*a - *b).hi().abs() / size);
            (apart.fold(0.0, f64::max), outcome.work.steps as f64)
        };
        for tolerance in [1e-9, 1e-15, 1e-18, 1e-21, 1e-25, 1.003e-28, 1e-28] {
            let ((rounding, steps), (whole, _)) =
                (off(&*problem.law, tolerance), off(&AllDigits(&*problem.law), tolerance));
            // the error of a step may be as large as the tolerance
            assert!(
                rounding <= 3.0 * whole + steps * tolerance,
                "{name} at {tolerance:e}: {rounding:.1e}, {whole:.1e}"
            );
        }
    }
}
