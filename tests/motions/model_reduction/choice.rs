//! Chosen models satisfy their tolerance, compared with references on which two methods agree to 24 digits.

use super::{ladder, path, scene};
use dalembert_derivations::studies::model_reduction::loss_weights::propagator;
use dalembert_derivations::studies::model_reduction::outputs::Watched;
use dalembert_derivations::studies::model_reduction::sampled_run::instants;
use dalembert_derivations::studies::model_reduction::switching::Schedule;
use dalembert_derivations::studies::model_reduction::{Forms, Hierarchy, Models, Receipt, ReducedModel, Wish, choose};
use dalembert_derivations::studies::scene::Scene;
use integrators::{Jacobian, Method, transition};
use reader::Family;
use simulation::{Axes, Stored};
use std::time::Duration;

fn receipt(name: &str, tolerance: f64) -> Receipt {
    let scene = scene(name);
    let ladders = [Axes::First, Axes::Second].map(|axes| Hierarchy::of_scene(&scene, axes)).into();
    let models = Forms::of(ladders, Stored::beside(&path(name)));
    let wish = Wish { tolerance, outputs: scene.run.outputs.clone(), allowed: Duration::ZERO };
    choose(&models, &wish).expect("it runs")
}

fn present_slip(ladder: &Hierarchy) -> &ReducedModel {
    ladder.models.iter().find(|reduced| reduced.name == "currents at the present slip").expect("on the ladder")
}

fn times(ladder: &Hierarchy) -> Vec<f64> {
    instants(ladder.own.span).collect()
}

/// A scene's model hierarchy, its outputs of interest, and, for an allowed error, the schedule of the model with
/// currents in the steady state of the present slip.
fn scheduled(name: &str, allowed: f64) -> (Hierarchy, Watched, Schedule) {
    let scene = scene(name);
    let ladder = ladder(&scene);
    let (watched, _) = ladder.watched(&scene.run.outputs).expect("it runs");
    let course = ladder.course(&watched, None).expect("it runs");
    let schedule = ladder.schedule(present_slip(&ladder), &course, allowed).expect("somewhere");
    (ladder, watched, schedule)
}

#[test]
fn every_run_of_a_receipt_keeps_the_tolerance() {
    for (name, tolerance) in
        [("stiff_damper", 1e-3), ("permanent_rotation", 1e-4), ("hanging_rest", 1e-2), ("spin_up", 1e-5)]
    {
        let receipt = receipt(name, tolerance);
        assert!(receipt.taken.is_some(), "{name}");
        for line in &receipt.lines {
            let Some(choice) = &line.choice else { continue };
            let measured = choice.measured.expect("a reference is kept");
            assert!(measured <= tolerance, "{name}, {}: {measured:e}, promised {:e}", line.name, choice.promised);
        }
    }
}

/// In these motors the slow windings decay long before the first instant of the references, at which no error remains.
#[test]
fn what_is_promised_holds_between_the_instants_too() {
    const DENSE: usize = 4_000;
    for (text, tolerance) in [
        (include_str!("../../../crates/cli/tests/program/odd/choose_between_instants_1e-1.toml"), 1e-1),
        (include_str!("../../../crates/cli/tests/program/odd/choose_between_instants_1e-2.toml"), 1e-2),
    ] {
        let scene = Scene::parse("between", text).unwrap_or_else(|error| panic!("{error}"));
        let models = Forms::of(vec![Hierarchy::of_scene(&scene, Axes::First)], None);
        let wish = Wish { tolerance, outputs: scene.run.outputs.clone(), allowed: Duration::ZERO };
        let receipt = choose(&models, &wish).expect("it runs");
        let dense: Vec<f64> = (1..=DENSE).map(|k| scene.run.span * k as f64 / DENSE as f64).collect();
        let method = Method::RadauIIA { stages: 5 };
        let (exact, _) = models.forms(1)[0].run(method, 1e-9, u64::MAX, Some(&dense));
        let exact = exact.expect("it reaches its end");
        let mut broken = Vec::new();
        for (at, line) in receipt.lines.iter().enumerate() {
            let Some(choice) = &line.choice else { continue };
            let form = &models.forms(at)[0];
            let (found, _) = form.run(choice.plan.method, choice.plan.tolerance, u64::MAX, Some(&dense));
            let rows = found.expect("it runs").asked.into_iter().zip(&exact.asked);
            let off = rows.map(|((_, row), (_, exact))| receipt.watched.off(&row, exact)).fold(0.0, f64::max);
            if off > tolerance {
                broken.push(format!("{}: {off:e}, promised {:e}", line.name, choice.promised));
            }
        }
        assert!(broken.is_empty(), "{tolerance:e}: {broken:?}");
        let resting = receipt.lines.iter().find(|line| line.name == "resistive currents").expect("on the ladder");
        assert!(resting.choice.is_none(), "{resting:?}");
    }
}

#[test]
fn a_tighter_tolerance_asks_for_a_larger_model() {
    let least = |tolerance| {
        let receipt = receipt("stiff_damper", tolerance);
        receipt.lines.iter().filter(|line| line.choice.is_some()).map(|line| line.states).min().expect("its own")
    };
    let [loose, middle, tight] = [1e-1, 1e-3, 1e-6].map(least);
    assert!(loose < middle && middle < tight, "{loose} {middle} {tight}");
}

/// Near the end of the run the rotor is synchronous, and its currents are in the steady state of the present slip.
#[test]
fn a_run_that_switches_is_as_good_as_it_promises() {
    let (ladder, watched, schedule) = scheduled("spin_up", 1e-2);
    let reduced = present_slip(&ladder);
    assert!(schedule.share() > 0.1 && schedule.share() < 1.0, "{:?}", schedule.spans());
    let sides = [(integrators::Method::DormandPrince8, 1e-10); 2];
    let run = ladder.run_switching(reduced, &schedule, sides, 1_000_000, &times(&ladder)).expect("it reaches its end");
    let exact = super::exactly(&ladder);
    let off = run.asked.iter().zip(exact.times.iter().zip(&exact.states));
    let off = off.map(|((_, row), (time, y))| watched.off(row, &ladder.row(*time, y))).fold(0.0, f64::max);
    assert!(off > 0.0 && off <= 1.5 * schedule.promised, "{off:e}, promised {:e}", schedule.promised);
}

#[test]
fn what_weighs_a_loss_is_the_transition_matrix() {
    for (name, from, to) in
        [("spin_up", 0.0, 1.0 / 128.0), ("spin_up", 0.5, 0.5 + 1.0 / 128.0), ("hanging_rest", 0.0, 0.1)]
    {
        let ladder = ladder(&scene(name));
        let n = ladder.start.len();
        let tight = integrators::Tolerance::both(1e-11);
        let knot = |time: f64| {
            let state = match time {
                0.0 => ladder.start.clone(),
                _ => transition(&*ladder.law, &tight, (0.0, time), &ladder.start).expect("a series").state,
            };
            let mut rates = vec![0.0; n];
            ladder.law.rates(time, &state, &mut rates);
            (time, state, rates)
        };
        let (begin, end) = (knot(from), knot(to));
        let exact = transition(&*ladder.law, &tight, (from, to), &begin.1).expect("a series").matrix;
        let found = propagator(&mut Jacobian::of(&*ladder.law), &begin, &end);
        for j in 0..n {
            let size = (0..n).map(|i| exact[i * n + j].abs()).fold(0.0, f64::max);
            for i in 0..n {
                let off = (found[(i, j)] - exact[i * n + j]).abs() / size;
                assert!(off < 1e-2, "{name} from {from}, {i} {j}: {off:e}");
            }
        }
    }
}

/// The error bound of an interval is compared with the dual weights along the reduced model's run: the largest
/// contribution of the interval to an error at the end of any interval.
#[test]
fn what_a_stretch_loses_is_the_most_that_the_dual_makes_of_it() {
    let (mut ladder, watched, all) = scheduled("hanging_rest", f64::INFINITY);
    assert_eq!(all.share(), 1.0);
    let (whole, count) = (ladder.own.span, all.stretches.len());
    let mut largest = vec![0.0; count];
    for end in 1..=count {
        ladder.own.span = whole * end as f64 / count as f64;
        let reduced = present_slip(&ladder);
        let shares = ladder.shares(reduced, &watched, &*ladder.law, end, 1e-10).expect("a series");
        for (k, largest) in largest[..end].iter_mut().enumerate() {
            *largest = shares.parts.iter().map(|parts| parts[k].abs()).fold(*largest, f64::max);
        }
    }
    let dual: f64 = largest.iter().sum();
    // along the reduced model's run, whose own relative error is about one hundredth
    assert!((1.0..1.1).contains(&(all.promised / dual)), "{:e} {dual:e}", all.promised);
}

/// For each interval, a run with the reduced model on this interval only, and with the full model otherwise.
#[test]
fn what_all_stretches_lose_is_the_sum_of_what_each_alone_makes_of_the_run() {
    let (ladder, watched, all) = scheduled("hanging_rest", f64::INFINITY);
    let reduced = present_slip(&ladder);
    let sides = [(integrators::Method::DormandPrince8, 1e-11); 2];
    let ends: Vec<f64> = all.stretches.iter().map(|(end, _)| *end).collect();
    let exact = super::exactly_at(&ladder, &ends);
    let alone = |k: usize| {
        let stretches = all.stretches.iter().enumerate().map(|(j, (end, _))| (*end, j == k)).collect();
        let run = ladder.run_switching(reduced, &Schedule { stretches, promised: 0.0 }, sides, 1_000_000, &ends);
        let rows = run.expect("it reaches its end").asked;
        let off = rows.iter().zip(exact.times.iter().zip(&exact.states));
        off.map(|((_, row), (time, y))| watched.off(row, &ladder.row(*time, y))).fold(0.0, f64::max)
    };
    let sum: f64 = (0..all.stretches.len()).map(alone).sum();
    assert!((all.promised / sum - 1.0).abs() < 1e-3, "{:e} {sum:e}", all.promised);
}
