//! Numerical stability of steady motions: exact thresholds compared with runs, and the exact matrix compared with the
//! compiled law.

use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::studies::numerical_stability::chart::{Chart, ChartedMotion, Row};
use dalembert_derivations::studies::numerical_stability::continuation::{before, followed};
use dalembert_derivations::studies::numerical_stability::linear::Linearised;
use dalembert_derivations::studies::numerical_stability::measured_thresholds::{APART, Run, Runs};
use dalembert_derivations::studies::numerical_stability::methods::OneStep;
use dalembert_derivations::studies::numerical_stability::motions::Stationed;
use dalembert_derivations::studies::numerical_stability::oscillator::bounds;
use dalembert_derivations::studies::numerical_stability::splittings::SplitRuns;
use dalembert_derivations::studies::numerical_stability::step_intervals::Proved;
use dalembert_derivations::studies::numerical_stability::survey::steps;
use dalembert_derivations::studies::numerical_stability::tested_steps::Tested;
use dalembert_derivations::studies::numerical_stability::threshold_run_length::Crossing;
use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::studies::stationary::motions::Stationary;
use field::{DoubleDouble, Scalar};
use integrators::{Collocation, Family, Jacobian, Real, Splitting, compose};
use mechanics::one_step_stability::{HalfPlane, Judgement};
use motor::{Bench, Separable};
use reader::Family as _;
use simulation::Axes;
use std::path::Path;

fn scene(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.toml"));
    Scene::open(&path).unwrap_or_else(|_| panic!("{name} is a scene"))
}

fn with_model(name: &str, model: &str) -> Scene {
    scene(name).with_model(model).unwrap_or_else(|reason| panic!("{name}: {reason}"))
}

/// Scenes with the angular velocity of their steady motions.
fn cases() -> Vec<(&'static str, Scene, f64)> {
    vec![
        ("bench", scene("bench"), 0.0),
        ("permanent_rotation", scene("permanent_rotation"), 6.0),
        ("hanging_rest", scene("hanging_rest"), 0.0),
        ("permanent_rotation-constant_speed", with_model("permanent_rotation", "constant_speed"), 6.0),
        ("hanging_rest-free_rotor", with_model("hanging_rest", "free_rotor"), 0.0),
    ]
}

fn chart(scene: &Scene, w: f64) -> Chart {
    Chart::of(scene, w).expect("it has stationary motions")
}

fn each(chart: &Chart) -> impl Iterator<Item = (&Stationed, &Row)> {
    let rows = chart.all.motions.iter().zip(&chart.rows);
    rows.flat_map(|(motion, rows)| rows.iter().map(move |row| (motion, row)))
}

#[test]
fn every_step_of_every_method_is_judged_as_reviewed() {
    for (name, scene, w) in cases() {
        insta::with_settings!({
            snapshot_path => "../../snapshots/numerical_stability", prepend_module_to_snapshot => false, omit_expression => true,
        }, { insta::assert_snapshot!(name, chart(&scene, w).text()) });
    }
}

/// Every threshold that runs can measure; some multipliers leave the unit circle by only 1e-10 per step.
#[test]
fn thresholds_by_runs_are_the_exact_ones() {
    let (mut measured, mut unseen) = (0, 0);
    for (name, scene, w) in &cases()[..2] {
        for (motion, row) in each(&chart(scene, *w)) {
            let runs = Runs::near(scene, motion);
            let spectrum = motion.spectrum.as_ref().expect("eigenvalues are apart");
            for exact in row.edges().into_iter().map(|edge| edge.to_f64()) {
                let crossing = Crossing::of(row.method, spectrum, exact).expect("it is a method");
                let steps = crossing.steps(APART);
                let found = runs.threshold(Run::OneStep(row.method), exact, crossing);
                println!("{name}, {motion}, {}: {exact:.7e}, by runs of {steps:?} steps {found:?}", row.method);
                assert_eq!(found.is_some(), steps.is_some(), "{motion}, {}", row.method);
                if let Some(found) = found {
                    assert!((found / exact - 1.0).abs() < 2.0 * APART, "{motion}, {}: {found}", row.method);
                }
                (measured, unseen) = (measured + usize::from(found.is_some()), unseen + usize::from(found.is_none()));
            }
        }
    }
    assert_eq!((measured, unseen), (15, 1));
}

#[test]
fn the_midpoint_rule_and_gauss_are_correct_at_every_step_and_backward_euler_hides_every_motion_that_grows() {
    for (_, scene, w) in cases() {
        for (motion, row) in each(&chart(&scene, w)) {
            let steps = row.steps.as_ref().expect("thresholds are apart");
            let spectrum = motion.spectrum.as_ref().expect("eigenvalues are apart");
            let grows = matches!(ChartedMotion::of(spectrum), ChartedMotion::Grows { .. });
            let last = steps.stretches.last().map(|stretch| stretch.judgement);
            match row.method.to_string().as_str() {
                "implicit midpoint" | "Gauss, 2 stages" | "Gauss, 3 stages" => assert_eq!(steps.correct(), Ok(None)),
                "backward Euler" if grows => assert_eq!(last, Some(Judgement::Hides), "{motion}"),
                "Euler" if !grows => assert_eq!(last, Some(Judgement::Invents), "{motion}"),
                _ => {}
            }
        }
    }
}

/// An independent method: the compiled law, in other axes and in floating-point numbers, differentiated by dual
/// numbers.
#[test]
fn the_exact_eigenvalues_are_those_of_the_law_that_runs() {
    // those with currents from a supply
    let fed = ["brushed_bench", "brushed", "permanent_magnet_bench", "permanent_magnet"];
    let fed = fed.map(|name| (name, scene(&format!("machines/{name}")), 0.0));
    for (name, scene, w) in cases().into_iter().chain(fed) {
        let chart = chart(&scene, w);
        for motion in &chart.all.motions {
            let spectrum = motion.spectrum.as_ref().expect("eigenvalues are apart");
            let problem = Scene { start: motion.start.clone(), ..scene.clone() }.problem(Axes::First);
            let n = problem.state.len();
            let mut matrix = vec![0.0; n * n];
            Jacobian::new(&*problem.law).matrix(0.0, &problem.state, &mut matrix);
            let mut left = integrators::spectrum(n, &matrix).expect("the iteration ends");
            let integrals = chart.all.linear.integrals;
            let exact = spectrum.modes.iter().flat_map(|mode| {
                let [re, im] = mode.place.point();
                (0..mode.count).map(move |k| (re, if k % 2 == 1 && im != 0.0 { -im } else { im }))
            });
            for (re, im) in exact.chain(std::iter::repeat_n((0.0, 0.0), integrals)) {
                let off = |k: &usize| (left[*k].re - re).hypot(left[*k].im - im);
                let nearest = (0..left.len()).min_by(|a, b| off(a).total_cmp(&off(b))).expect("as many as states");
                // a multiple eigenvalue is found to a fraction of the digits only
                assert!(off(&nearest) < 2e-6, "{name}, {motion}: {re} + {im} i is off by {:.1e}", off(&nearest));
                left.remove(nearest);
            }
            assert!(left.is_empty(), "{name}, {motion}: {} eigenvalues are left", left.len());
        }
    }
}

/// Hamilton's equations imply this; the matrix is computed without them.
#[test]
fn where_energy_is_kept_the_odd_coefficients_vanish_to_a_hundred_digits() {
    for (name, model, w) in [("permanent_rotation", "constant_speed", 6.0), ("hanging_rest", "free_rotor", 0.0)] {
        let scene = with_model(name, model);
        let stationary = Stationary::of(&scene).expect("a gyrostat");
        let linear = Linearised::of(&scene, &stationary.motor).expect("its law is algebraic");
        assert!(linear.symmetric);
        for motion in &chart(&scene, w).all.motions {
            let polynomial = linear.polynomial(&motion.at, 384).expect("integrals are kept");
            for odd in polynomial.iter().skip(1).step_by(2) {
                assert!(odd.sign().is_none_or(|sign| sign == 0) && odd.radius() < 1e-95, "{odd:?}");
            }
        }
    }
    let scene = scene("permanent_rotation");
    let stationary = Stationary::of(&scene).expect("a gyrostat");
    assert!(!Linearised::of(&scene, &stationary.motor).expect("its law is algebraic").symmetric);
}

/// The Butcher tableaus of the implementation: 1 + z b (I - z A)^-1 1 in double-double.
#[test]
fn the_tables_of_collocation_have_the_exact_stability_functions() {
    for (family, stages) in [(Family::Gauss, 2), (Family::Gauss, 3), (Family::RadauIIA, 2), (Family::RadauIIA, 3)] {
        let function = OneStep::Collocation(family, stages).function().expect("it is a method");
        let table = Collocation::<DoubleDouble>::new(family, stages.into());
        for z in [-7, -2, 1, 3] {
            let z = DoubleDouble::ratio(z, 2);
            let run = solved(&table, z);
            let ratio =
                |c: &[field::Rational]| c.iter().rev().fold(DoubleDouble::int(0), |sum, c| sum * z + quotient(*c));
            let exact = ratio(&function.numerator) / ratio(&function.denominator);
            assert!((run - exact).approx().abs() < 1e-27, "{family:?}, {stages}: {:e}", (run - exact).approx());
        }
    }
}

fn quotient(c: field::Rational) -> DoubleDouble {
    let big = c.to_big().expect("coefficients are defined");
    let whole = |text: String| text.parse::<i64>().expect("coefficients are short");
    DoubleDouble::ratio(whole(big.numerator().to_string()), whole(big.denominator().to_string()))
}

fn solved(table: &Collocation<DoubleDouble>, z: DoubleDouble) -> DoubleDouble {
    let s = table.stages();
    let one = DoubleDouble::int(1);
    let unit = |i: usize, j: usize| if i == j { one } else { DoubleDouble::int(0) };
    let mut rows: Vec<Vec<DoubleDouble>> = (0..s)
        .map(|i| (0..s).map(|j| unit(i, j) - z * table.matrix[i][j]).chain(std::iter::once(one)).collect())
        .collect();
    for k in 0..s {
        let pivot = rows[k].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot[k];
            row.iter_mut().zip(&pivot).for_each(|(entry, above)| *entry -= factor * *above);
        }
    }
    let stages = (0..s).map(|k| rows[k][s] / rows[k][k]);
    table.weights.iter().zip(stages).fold(one, |sum, (b, y)| sum + z * *b * y)
}

/// A synchronous motor without friction, whose oscillation is split into two flows only.
#[test]
fn splittings_stay_bounded_where_their_traces_say() {
    let machine = Synchronous { field_speed: 0.0, b0: 0.25, f: 0.0 };
    let bench = Bench { machine, axial: 1.0 };
    let bounded = |splitting: Splitting, step: f64| {
        let pieces = bench.pieces::<f64>().expect("it has pieces");
        let mut map = compose(pieces, splitting);
        map.prepare(step);
        map.enter(&[1e-9, 1e-9]);
        let mut state = [0.0; 2];
        (0..4000).all(|_| {
            let moved = map.advance();
            map.leave(&mut state);
            moved && state[0].hypot(state[1]) < 1e-6
        })
    };
    for splitting in Splitting::ALL {
        let (cuts, inside) = bounds(splitting).expect("its coefficients are numbers");
        // h = sqrt(kappa / k)
        let steps: Vec<f64> = cuts.iter().map(|cut| (cut.to_f64() / 0.25).sqrt()).collect();
        println!("{splitting:?}: {:?} {inside:?}", cuts.iter().map(|cut| cut.to_f64().sqrt()).collect::<Vec<_>>());
        assert!(inside[0] && !inside[inside.len() - 1]);
        for (place, step) in steps.iter().enumerate() {
            let below = place.checked_sub(1).map_or(0.0, |last| steps[last] / step);
            let above = steps.get(place + 1).map_or(f64::INFINITY, |next| next / step);
            // in a narrower instability interval the growth is too slow to be observed
            for (side, within, seen) in
                [(0.999, inside[place], below < 0.998), (1.001, inside[place + 1], above > 1.002)]
            {
                assert!(!seen || bounded(splitting, side * step) == within, "{splitting:?} at {side} of {step}");
            }
        }
    }
}

/// On a bench, where the equilibrium is a fixed point of all sub-flows: thresholds by the derivative of the step and by
/// runs.
#[test]
fn the_map_of_a_splitting_and_its_runs_leave_at_one_step() {
    let scene = scene("bench");
    let chart = chart(&scene, 0.0);
    let steps: Vec<f64> = (0..8).map(|k| 0.02 * 1.5f64.powi(k)).collect();
    let held = &chart.all.motions[1];
    let (near, runs) = (SplitRuns::near(&scene, held), Runs::near(&scene, held));
    for splitting in [Splitting::Strang, Splitting::BlanesMoan4] {
        let tested = near.course(splitting, &steps);
        println!("{splitting:?}: {}", tested.told());
        let edge = *tested.edges.first().expect("some step is too long");
        let crossing = near.crossing(splitting, edge).expect("all pieces rest");
        let found = runs.threshold(Run::Splitting(splitting), edge, crossing).expect("runs see it");
        println!("{edge} {found} {crossing:?}");
        assert!((found / edge - 1.0).abs() < 2.0 * APART, "{splitting:?}: {edge} and {found}");
    }
}

/// Every step size between the first and the last by Taylor models of the sub-flows, and some by the derivative of the
/// implemented step. The instability interval of Blanes and Moan's splitting of order 4, of width 2e-4, lies between
/// tested step sizes.
#[test]
fn on_the_bench_what_a_splitting_does_between_the_tested_steps_is_proved() {
    let scene = scene("bench");
    let mut windows = 0;
    for motion in &chart(&scene, 0.0).all.motions {
        let near = SplitRuns::near(&scene, motion);
        for splitting in Splitting::ALL {
            let (_, proved) = beside_the_map_that_runs(&near, splitting, &motion.to_string());
            assert!(proved.open().is_empty(), "{proved:?}");
            windows += proved.edges().windows(2).filter(|pair| pair[1].0 / pair[0].0 < 1.001).count();
        }
    }
    assert_eq!(windows, 1);
}

/// An independent method: the implemented step, in double-double, differentiated by differences, at every tested step
/// size for which there is a proof, in the middle of every interval, and next to every threshold.
fn beside_the_map_that_runs(near: &SplitRuns, splitting: Splitting, motion: &str) -> (Tested, Proved) {
    let tested = near.course(splitting, &steps());
    println!("{motion}, {splitting:?}: {}", tested.told());
    let proved = tested.proved.clone().unwrap_or_else(|reason| panic!("{motion}: {reason}"));
    let beside = proved.edges().into_iter().flat_map(|(at, width)| [at - 30.0 * width, at + 30.0 * width]);
    let inside = proved.stretches.iter().map(|(low, high, _)| 0.5 * (low + high));
    let sampled = tested.grows.iter().map(|(step, _)| *step);
    for step in beside.chain(inside).chain(sampled) {
        let Some(grows) = proved.at(step) else { continue };
        let own = near.own(splitting, step, tested.before(step));
        let own = own.unwrap_or_else(|| panic!("{motion}, {splitting:?}: no motion at {step}"));
        // the error of differences for a multiplier on the unit circle
        let leaves = own.radius > 1.0 + 1e-11;
        assert!(grows == leaves || (own.radius - 1.0).abs() < 1e-11, "{motion}, {splitting:?} at {step}: {own:?}");
    }
    (tested, proved)
}

/// Carriers at rest, where the equilibrium is a fixed point of all sub-flows, and rotating ones, where a splitting has
/// its own fixed point. The range of a proof between two tested step sizes depends on rounding, and is not in the
/// snapshot.
#[test]
fn near_gyrostats_what_a_splitting_does_between_the_tested_steps_is_proved_as_far_as_its_row_says() {
    let rows = |(name, scene, w): &(&str, Scene, f64)| {
        let ends = [steps()[0], steps()[steps().len() - 1]];
        let mut page = format!("at {} steps from {:.1e} to {:.1e} s: ", steps().len(), ends[0], ends[1]);
        page += "G grows, S stays, proved; g grows, s stays, tested alone; ";
        page += "- no step is taken, since what fades would grow on its way back; . no motion of its own is found\n";
        for (place, motion) in chart(scene, *w).all.motions.iter().enumerate() {
            let near = SplitRuns::near(scene, motion);
            page += &format!("\n{} {motion}\n", place + 1);
            for splitting in Splitting::ALL {
                let (tested, proved) = beside_the_map_that_runs(&near, splitting, &format!("{name}, {motion}"));
                let known = proved.stretches.iter().filter(|(.., grows)| grows.is_some());
                assert!(known.map(|(low, high, _)| high / low).product::<f64>() > 10.0, "{name}, {motion}: {proved:?}");
                let letter = |(step, seen): &(f64, Option<bool>)| match (proved.at(*step), seen) {
                    (Some(true), _) => 'G',
                    (Some(false), _) => 'S',
                    (None, Some(true)) => 'g',
                    (None, Some(false)) => 's',
                    (None, None) if tested.refuses(*step) => '-',
                    (None, None) => '.',
                };
                let letters: String = tested.grows.iter().map(letter).collect();
                page += &format!("  {:<20} {letters}\n", splitting.name());
            }
        }
        page
    };
    for case in &cases()[1..] {
        insta::with_settings!({
            snapshot_path => "../../snapshots/numerical_stability", prepend_module_to_snapshot => false, omit_expression => true,
        }, { insta::assert_snapshot!(format!("{}-splittings", case.0), rows(case)) });
    }
}

/// Without dissipation the thresholds are exactly those of the oscillator, which follow from the trace.
#[test]
fn without_losses_the_proved_edges_are_those_of_the_oscillator() {
    let scene = scene("closed_forms/unloaded_motor");
    let chart = chart(&scene, 0.0);
    let held = &chart.all.motions[0];
    let [mode] = &held.spectrum.as_ref().expect("one mode").modes[..] else { panic!("one mode") };
    let HalfPlane::Imaginary(rate) = &mode.place else { panic!("it swings") };
    let near = SplitRuns::near(&scene, held);
    for splitting in [Splitting::Strang, Splitting::BlanesMoan4, Splitting::BlanesMoan6] {
        let proved = near.course(splitting, &steps()).proved.expect("all pieces rest");
        let (cuts, _) = bounds(splitting).expect("its coefficients are numbers");
        let exact = cuts.iter().map(|cut| cut.to_f64().sqrt() / rate.to_f64()).filter(|step| *step < 1.0);
        let exact: Vec<f64> = exact.collect();
        println!("{splitting:?}: {exact:?} {:?}", proved.edges());
        assert_eq!(exact.len(), proved.edges().len());
        for (exact, (at, width)) in exact.iter().zip(proved.edges()) {
            assert!((exact - at).abs() <= 0.5 * width + 1e-15, "{splitting:?}: {exact} and {at} to {width:e}");
        }
    }
}

#[test]
fn a_member_of_a_family_is_judged_across_it() {
    let chart = chart(&scene("closed_forms/lagrange_top"), 20.0);
    assert_eq!((chart.all.motions.len(), chart.all.families), (3, 0));
    let member = &chart.all.motions[2];
    let spectrum = member.spectrum.as_ref().unwrap();
    // without the two zero eigenvalues of the circle and those of the integrals only the nutation remains
    let [mode] = &spectrum.modes[..] else { panic!("{spectrum:?}") };
    assert!(member.member.is_some() && matches!(mode.place, HalfPlane::Imaginary(_)), "{mode:?}");
    assert_eq!(ChartedMotion::of(spectrum), ChartedMotion::Stays { staying: 2 });
}

#[test]
fn what_is_found_is_carried_on_over_steps_between_and_not_beyond_where_it_is_lost() {
    // the search succeeds if the previous result is close enough
    let near = |step: f64, before: Option<&f64>| before.is_none_or(|before| step < 1.5 * before).then_some(step);
    let found = followed(&[1.0, 1.4, 8.0], near);
    assert!(found.iter().any(|(step, _)| *step == 8.0) && found.is_sorted_by(|(a, _), (b, _)| a < b), "{found:?}");
    assert_eq!((before(&found, 1.3), before(&found, 8.5)), (Some(&1.0), Some(&8.0)));
    let lost = followed(&[1.0, 1e9, 1.2], near);
    assert!(lost.iter().all(|(step, _)| *step < 1e9 && *step != 1.2), "{lost:?}");
}

/// A search that starts from the law's own motion, which is far away for a long step, does not find the fixed point.
#[test]
fn a_splittings_own_motion_is_followed_from_short_steps() {
    let scene = scene("permanent_rotation");
    let chart = chart(&scene, 6.0);
    let near = SplitRuns::near(&scene, &chart.all.motions[0]);
    let tested = near.course(Splitting::Strang, &steps());
    assert!(tested.grows.iter().all(|(_, grows)| *grows == Some(true)), "{:?}", tested.grows);
    assert!(near.own(Splitting::Strang, 1.0, None).is_none());
}
