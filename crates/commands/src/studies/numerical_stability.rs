//! The study of numerical stability: the verdicts on all methods at steady motions, for all step sizes.

use crate::job_pool::JobPool;
use charts::{AreaCurve, Areas, Study, Table, significant};
use mechanics::one_step_stability::Judgement;
use studies::numerical_stability::survey::{self, Method, SCENES, Split, Surveyed};
use studies::scene::Scene;

/// The surveyed motions of each scene; each scene is a separate job.
#[derive(Default)]
pub struct NumericalStability {
    scenes: [Option<Result<Vec<Surveyed>, String>>; SCENES.len()],
}

/// The expected time for a scene, s.
const COST: f64 = 8.0;
/// The number of columns of a picture.
const COLUMNS: usize = 240;
const DECADES: [f64; 2] = [-3.0, 0.3];
/// The logarithm of the largest ratio between a step size and the tested one whose result it takes; there are eight tests per decade.
const NEAR: f64 = std::f64::consts::LN_10 / 8.0;

impl NumericalStability {
    /// Adds the jobs for the scenes of the study, which are identified by the names of their files.
    pub fn enlist<'s>(&'s mut self, crew: &mut JobPool<'s>, scene: impl Fn(&str) -> Option<&'s Scene>) {
        for (place, (name, w)) in self.scenes.iter_mut().zip(SCENES) {
            if let Some(scene) = scene(name) {
                crew.add(COST, place, move || survey::survey(scene, w));
            }
        }
    }

    /// The completed study for the report.
    pub fn study(self) -> Study {
        let mut study = Study {
            id: "steps-and-stability".into(),
            title: "Numerical stability of steady motions".into(),
            lead: r"Near a steady motion $\dot x=Ax$ a Runge-Kutta method has the matrix $R(hA)$. A mode $\mu$ decays, keeps its size or grows in the numerical map if $|R(h\mu)|$ is below, at or above one, which may differ from the motion: a method hides growth (phantom stability) or invents it. The verdicts cover every step $h$ (in s): thresholds are roots of one polynomial for each mode, and all of them are isolated. Modes that follow from integrals and from windings without effect are split off exactly.".into(),
            note: r"Splitting methods have a steady motion of their own near that of the law, followed here from short steps to 1 s. The stability of their one-step matrix is proved with Taylor models over the ranges of steps that a row states, and tested at eight steps per decade elsewhere; windows between the tested steps are found too. Dark lines: thresholds from runs near the motion, each as long as the growth near the threshold and the slowest of the other modes require; if that is more than 40 000 steps, as for Euler near lightly damped motions, there is no line. Correct means that the sign of the growth is right, not its rate: the classical Runge-Kutta method and backward Euler may damp much more than the motion.".into(),
            ..Study::default()
        };
        for found in self.scenes.into_iter().flatten() {
            match found {
                Ok(motions) => {
                    study.pictures.extend(motions.iter().map(picture));
                    study.tables.extend(motions.iter().map(table));
                }
                Err(reason) => study.note += &format!(" Not surveyed: {reason}."),
            }
        }
        study
    }
}

/// The kinds of cells of a picture, in the order of its legend.
const KINDS: [&str; 6] = [
    "correct",
    "damps an undamped mode",
    "decays although the motion grows",
    "grows although the motion does not",
    "wrong in some mode",
    "no such step, or no motion found",
];

fn kind(judgement: Judgement) -> usize {
    match judgement {
        Judgement::Correct => 0,
        Judgement::Damps => 1,
        Judgement::Hides => 2,
        Judgement::Invents => 3,
        Judgement::Confuses => 4,
    }
}

/// A picture with a row of cells for each method, over the logarithm of the step size.
fn picture(of: &Surveyed) -> Areas {
    let [first, last] = DECADES;
    let step = |column: usize| 10f64.powf(first + (last - first) * (column as f64 + 0.5) / COLUMNS as f64);
    let grows = of.methods.iter().filter_map(|method| method.row.steps.as_ref()?.stretches.first()).next();
    let motion_grows = grows.is_some_and(|first| first.judgement == Judgement::Correct && first.growing > 0);
    let of_method = |method: &Method| -> Vec<usize> {
        let judged = |step: f64| Some(kind(method.row.steps.as_ref()?.at(step)?.judgement));
        (0..COLUMNS).map(|column| judged(step(column)).unwrap_or(KINDS.len() - 1)).collect()
    };
    let of_split = |split: &Split| -> Vec<usize> {
        (0..COLUMNS).map(|column| tested(split, step(column), motion_grows)).collect()
    };
    let rows: Vec<Vec<usize>> =
        of.methods.iter().map(of_method).chain(of.splittings.iter().map(of_split)).rev().collect();
    let names = of.methods.iter().map(|method| method.row.method.to_string());
    let names: Vec<String> =
        names.chain(of.splittings.iter().map(|split| split.tested.splitting.name().into())).collect();
    let count = names.len();
    let place = |number: usize| (count - 1 - number) as f64;
    let edges = of.methods.iter().map(|method| &method.edges).chain(of.splittings.iter().map(|split| &split.edges));
    // a point outside the frame separates the strokes
    let strokes = edges.enumerate().flat_map(|(number, edges)| {
        let seen = edges.iter().filter_map(|(_, found)| *found).filter(|found| (first..last).contains(&found.log10()));
        seen.flat_map(move |found| {
            let x = found.log10();
            [(x, place(number)), (x, place(number) + 1.0), (x, -1.0)]
        })
    });
    Areas {
        title: format!("{}: {}", of.scene, of.motion),
        x: ("log₁₀ of the step, s".into(), DECADES),
        y: (String::new(), [0.0, count as f64]),
        kinds: KINDS.map(String::from).into(),
        rows,
        curves: vec![AreaCurve { name: "threshold by runs".into(), points: strokes.collect() }],
        names: names.into_iter().rev().collect(),
        note: format!("The motion {}.", of.does),
        ..Areas::default()
    }
}

/// The kind of a cell of a splitting method at a step size, from the closest tested step size.
fn tested(split: &Split, step: f64, motion_grows: bool) -> usize {
    let off = |known: f64| (known / step).ln().abs();
    let near = split.tested.grows.iter().filter(|(known, _)| off(*known) < NEAR);
    let nearest = near.min_by(|a, b| off(a.0).total_cmp(&off(b.0)));
    // each threshold between the tested step size and this one reverses the verdict
    match nearest.and_then(|(known, grows)| {
        let passed = |edge: &&f64| (**edge > step) != (**edge > *known);
        grows.map(|grows| grows != (split.tested.edges.iter().filter(passed).count() % 2 == 1))
    }) {
        Some(grows) if grows == motion_grows => kind(Judgement::Correct),
        Some(true) => kind(Judgement::Invents),
        Some(false) => kind(Judgement::Hides),
        None => KINDS.len() - 1,
    }
}

fn table(of: &Surveyed) -> Table {
    let head = ["Method", "Every step judged, h in s", "Edge, exact", "Edge, by runs"].map(String::from).into();
    let one = |(exact, found): &(f64, Option<f64>)| {
        [significant(*exact, 5), found.map_or_else(|| "—".to_owned(), |found| significant(found, 5))]
    };
    let columns = |edges: &[(f64, Option<f64>)]| -> [String; 2] {
        let each: Vec<[String; 2]> = edges.iter().map(one).collect();
        [0, 1].map(|side| each.iter().map(|pair| pair[side].as_str()).collect::<Vec<_>>().join(", "))
    };
    let methods = of.methods.iter().map(|method| {
        let [exact, runs] = columns(&method.edges);
        vec![method.row.method.to_string(), method.row.told(), exact, runs]
    });
    let splittings = of.splittings.iter().map(|split| {
        let [exact, runs] = columns(&split.edges);
        vec![split.tested.splitting.name().into(), split.tested.told(), exact, runs]
    });
    let caption = format!("{}: {}. Eigenvalues, 1/s: {}", of.scene, of.motion, of.eigenvalues);
    Table { caption, head, rows: methods.chain(splittings).collect() }
}
