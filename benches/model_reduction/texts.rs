//! The choices of model and method for random text models, compared with the true errors: estimates, cost, and the best
//! choice by exhaustive search.

use super::drawn_texts::scene;
use super::row;
use dalembert_derivations::studies::model_reduction::receipt::Work;
use dalembert_derivations::studies::model_reduction::run_rows::Run;
use dalembert_derivations::studies::model_reduction::{Choice, Loss, Models, Receipt, TextModels, Wish, choose};
use integrators::{Method, Observer, Span, Tolerance, integrate};
use simulation::Axes;
use simulation::models::{Modelled, readers};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

/// The number of instants at which runs are compared with the reference run.
const DENSE: usize = 2_000;
const TOLERANCES: [f64; 3] = [1e-2, 1e-4, 1e-6];
/// The methods of the exhaustive search.
const METHODS: [Method; 3] = [Method::Taylor, Method::DormandPrince8, Method::RadauIIA { stages: 5 }];
const FINER: [f64; 5] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8];
/// The range of errors in which estimates are compared.
const ESTIMATED: [f64; 2] = [1e-7, 0.1];

/// The numbers of choices of one kind, by outcome.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    choices: usize,
    /// No model satisfied the tolerance.
    none: usize,
    /// The chosen model exceeded the tolerance.
    broken: usize,
    /// The error exceeded its estimate.
    above: usize,
    smaller: usize,
    /// The choice itself cost more than three runs of the scene's own model.
    dear: usize,
    /// The exhaustive search found a smaller model at half the cost; `taken` counts those cases in which a cheaper
    /// model was chosen.
    halves: usize,
    taken: usize,
}

/// Evaluates the choices for a number of random systems.
pub fn survey(count: u64) {
    scenes::register(|_| ());
    let mut by_kind: BTreeMap<&str, (Counts, Vec<f64>)> = BTreeMap::new();
    let mut prices = Vec::new();
    for seed in 0..count {
        let (kind, text) = scene(seed);
        let Some(readers) = readers() else { continue };
        let Ok(scene) = (readers.scene)("drawn", &text) else { continue };
        let (counts, ratios) = by_kind.entry(kind).or_default();
        let tolerance = TOLERANCES[(seed / super::drawn_texts::KINDS) as usize % TOLERANCES.len()];
        judge(&scene, tolerance, counts, ratios, &mut prices);
    }
    println!("{count} random systems as text, in turn to 1e-2, 1e-4, 1e-6, over the whole run\n");
    println!("                                choices  none broken above smaller  >3 runs  half by brute force  taken");
    let mut all = Vec::new();
    for (kind, (it, ratios)) in &by_kind {
        let Counts { choices, none, broken, above, smaller, dear, halves, taken } = it;
        println!("{kind:<32}{choices:>7}{none:>6}{broken:>7}{above:>6}{smaller:>8}{dear:>9}{halves:>21}{taken:>7}");
        all.extend(ratios);
    }
    println!("\nestimate over true error                number       1 %       5 %      50 %      95 %      99 %");
    for (kind, (_, ratios)) in &mut by_kind {
        row(kind, ratios);
    }
    row("all", &mut all);
    println!("price of deciding, runs of the scene's own model");
    row("all", &mut prices);
}

fn judge(scene: &Arc<dyn Modelled>, tolerance: f64, counts: &mut Counts, ratios: &mut Vec<f64>, prices: &mut Vec<f64>) {
    let models = TextModels::of(scene, None);
    let wish = Wish { tolerance, outputs: scene.run().outputs.clone(), allowed: Duration::ZERO };
    let Ok(receipt) = choose(&models, &wish) else { return };
    counts.choices += 1;
    let (Some(line), Some(own)) = (receipt.taken, receipt.lines[0].choice.as_ref()) else {
        counts.none += 1;
        return;
    };
    let dense: Vec<f64> = (1..=DENSE).map(|k| scene.run().span * k as f64 / DENSE as f64).collect();
    let exactly =
        if own.plan.method.traits().implicit { Method::RadauIIA { stages: 7 } } else { Method::DormandPrince8 };
    let (Some(exact), _) = models.forms(0)[0].run(exactly, 1e-11, u64::MAX, Some(&dense)) else { return };
    let off = |run: &Run| {
        let rows = run.asked.iter().zip(&exact.asked);
        rows.map(|((_, row), (_, exact))| receipt.watched.off(row, exact)).fold(0.0, f64::max)
    };
    let Some(choice) = &receipt.lines[line].choice else { return };
    let Choice { plan, promised, .. } = choice;
    let (ran, _) = models.forms(line)[0].run(plan.method, plan.tolerance, u64::MAX, Some(&dense));
    let error = ran.as_ref().map_or(f64::INFINITY, off);
    if error > tolerance {
        counts.broken += 1;
        println!(
            "{}: {} to {tolerance:e} is off by {error:e} by {} at {:e}",
            scene.title(),
            receipt.lines[line].name,
            plan.method,
            plan.tolerance
        );
    }
    counts.above += usize::from(error > *promised);
    counts.smaller += usize::from(line > 0);
    let price = receipt.worth().unwrap_or(f64::INFINITY);
    counts.dear += usize::from(price > 3.0);
    prices.push(price);
    let least = |line: usize| least_work(&models, line, &dense, own.work.evaluations, &|run| off(run) <= tolerance);
    if let Some(own) = least(0) {
        let shares = (1..receipt.lines.len()).filter_map(|line| Some(least(line)?.over(own)));
        if shares.fold(1.0, f64::min) <= 0.5 {
            counts.halves += 1;
            counts.taken += usize::from(line > 0 && receipt.saved(line).is_some_and(|saved| saved > 1.3));
        }
    }
    ratios.extend(effectivities(scene, &models, &receipt, &dense, &off));
}

/// The least work with which a model satisfies the tolerance, over all methods and tolerances.
fn least_work(
    models: &TextModels,
    line: usize,
    dense: &[f64],
    own: u64,
    serves: &dyn Fn(&Run) -> bool,
) -> Option<Work> {
    let form = models.forms(line).into_iter().next()?;
    let by = |method: Method| {
        let runs = FINER.into_iter().filter_map(|finer| form.run(method, finer, 4 * own, Some(dense)).0);
        let run = runs.into_iter().find(|run| serves(run))?;
        Some(Work { evaluations: run.evaluations, code: models.code_size(line) })
    };
    METHODS.into_iter().filter_map(by).reduce(|best, work| if work.over(best) < 1.0 { work } else { best })
}

/// Effectivities: the estimates along a run divided by the true errors of the models.
fn effectivities(
    scene: &Arc<dyn Modelled>,
    models: &TextModels,
    receipt: &Receipt,
    dense: &[f64],
    off: &dyn Fn(&Run) -> f64,
) -> Vec<f64> {
    let own = scene.problem(Axes::First);
    let implicit = receipt.watched.stiff;
    let method = if implicit { Method::RadauIIA { stages: 5 } } else { Method::DormandPrince8 };
    let mut along = Along(vec![(0.0, own.state.clone())]);
    let span = Span::new(0.0, own.span, &own.state);
    if own.switching.is_some() || !integrate(&*own.law, method, &Tolerance::both(1e-8), &span, &mut along).reached() {
        return Vec::new();
    }
    let Some(estimates) = models.estimates(&receipt.watched, &along.0) else { return Vec::new() };
    let known = receipt.lines.len() - estimates.len();
    let one = |(at, estimate): (usize, &Option<dalembert_derivations::studies::model_reduction::Estimate>)| {
        let line = known + at;
        let estimate = estimate.as_ref().filter(|_| matches!(receipt.lines[line].loss, Loss::Small { .. }))?;
        let form = models.forms(line).into_iter().next()?;
        let run = METHODS.into_iter().rev().find_map(|method| form.run(method, 1e-10, 200_000, Some(dense)).0)?;
        let error = off(&run);
        (ESTIMATED[0]..ESTIMATED[1]).contains(&error).then_some(estimate.first / error)
    };
    estimates.iter().enumerate().filter_map(one).collect()
}

/// The states after each step of a run.
struct Along(Vec<(f64, Vec<f64>)>);

impl Observer<f64> for Along {
    fn step(&mut self, time: f64, state: &[f64]) {
        self.0.push((time, state.to_vec()));
    }
}
