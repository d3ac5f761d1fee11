//! The parts of the report: those that are computed in parallel, the times, and the page that contains all of them.

use super::scene::{NoReference, Prepared, Read, prepare};
use super::{REPORT, explained, titled};
use crate::job_pool::JobPool;
use crate::ledger::{self, paper_file};
use crate::pictures;
use crate::speed;
use crate::sphere::Stationary;
use crate::studies::{
    Drive, Endurance, Failures, ForeignProblems, Gains, NumericalStability, Synchronism, atlas, peers,
};
use crate::timings;
use charts::{Areas, PaperSection, Report, SceneSection, Verdict};
use claims::catalogue::papers;
use manuscript::PaperText;
use reader::SceneError;
use std::path::Path;
use studies::AnyScene;
use studies::governors;
use studies::regimes;
use studies::scene::Scene;

/// The parts of the report. Most are independent and are computed in parallel. Times are measured afterwards,
/// while nothing else runs.
pub struct Parts {
    papers: Vec<Option<(PaperSection, bool)>>,
    texts: Vec<Option<Result<(PaperSection, bool), SceneError>>>,
    prepared: Vec<Option<Prepared>>,
    stability: Option<Vec<Areas>>,
    approximations: Option<charts::Trajectory>,
    friction: Option<Vec<Areas>>,
    stationary: Stationary,
    gains: Gains,
    drive: Drive,
    endurance: Endurance,
    numerical_stability: NumericalStability,
    synchronism: Synchronism,
    failures: Failures,
    foreign: ForeignProblems,
}

impl Parts {
    /// Parts that are not computed yet.
    pub fn of(scenes: &[Read], texts: &[PaperText], folder: &Path) -> Self {
        Parts {
            papers: papers().iter().map(|_| None).collect(),
            texts: texts.iter().map(|_| None).collect(),
            prepared: scenes.iter().map(|_| None).collect(),
            stability: None,
            approximations: None,
            friction: None,
            stationary: Stationary::of(driven(scenes)),
            gains: Gains::default(),
            drive: Drive::default(),
            endurance: Endurance::default(),
            numerical_stability: NumericalStability::default(),
            synchronism: Synchronism::default(),
            failures: Failures::of(folder),
            foreign: ForeignProblems::of(folder),
        }
    }

    /// Computes all parts except the times; `done` receives the completed fraction.
    pub fn compute(&mut self, scenes: &[Read], texts: &[PaperText], folder: &Path, done: impl FnMut(f64)) {
        let mut crew = JobPool::default();
        for (place, paper) in self.papers.iter_mut().zip(papers()) {
            crew.add(1.0, place, move || ledger::judged(paper));
        }
        for (place, paper) in self.texts.iter_mut().zip(texts) {
            crew.add(0.5, place, move || paper_file::judged(paper));
        }
        for (place, scene) in self.prepared.iter_mut().zip(scenes) {
            crew.add(3.0, place, move || prepare(scene));
        }
        self.gains.enlist(&mut crew);
        self.drive.enlist(&mut crew);
        self.endurance.enlist(&mut crew);
        self.numerical_stability.enlist(&mut crew, |id| {
            scenes.iter().filter(|read| read.id == id).find_map(|read| match &read.scene {
                AnyScene::Driven(scene) => Some(&**scene),
                _ => None,
            })
        });
        self.synchronism.enlist(driven(scenes), &mut crew);
        self.failures.enlist(&mut crew, folder);
        self.foreign.enlist(&mut crew);
        crew.add(1.5, &mut self.stability, || governors::stability().into_iter().map(pictures::stability).collect());
        crew.add(0.1, &mut self.approximations, || pictures::series_errors(&governors::series_errors()));
        crew.add(0.1, &mut self.friction, || regimes::maps::maps().into_iter().map(pictures::areas).collect());
        self.stationary.enlist(driven(scenes).collect(), &mut crew);
        crew.work(done);
    }

    /// Measures the times, while nothing else runs; `done` receives the completed fraction.
    pub fn take_times(&mut self, mut done: impl FnMut(f64)) {
        let whole = (self.prepared.len() + 1) as f64;
        for (count, prepared) in self.prepared.iter_mut().flatten().enumerate() {
            if let Prepared { atlas: Ok(atlas), trials, timed, .. } = prepared {
                atlas.take_times(trials, *timed);
            }
            done((count + 1) as f64 / whole);
        }
        self.gains.take_times();
    }

    /// Messages about papers with an unsound claim, and about scenes with an unexpected result.
    pub fn faults(&self) -> Vec<String> {
        let unsound = self.papers.iter().flatten().filter(|(_, sound)| !sound);
        let unsound =
            unsound.map(|(paper, _)| format!("{}: a claim is not sound; `dalembert ledger` lists them", paper.id));
        let texts = self.texts.iter().flatten().filter_map(|judged| match judged {
            Ok((_, true)) => None,
            Ok((paper, false)) => Some(format!(
                "{}: a verdict is not the one that its file expects; `dalembert judge` lists them",
                paper.id
            )),
            Err(error) => Some(error.to_string()),
        });
        let unreached = self.prepared.iter().flatten().filter_map(|one| one.unreached.clone());
        unsound.chain(texts).chain(unreached).collect()
    }

    /// The content of the page.
    pub fn report(self, folder: &Path) -> Report {
        let mut report = titled(REPORT, "dalembert", SUMMARY);
        let mut digits = f64::INFINITY;
        let atlas = {
            let prepared = self.prepared.iter().flatten();
            let found: Vec<_> =
                prepared.filter_map(|one| Some((one.section.title.as_str(), one.atlas.as_ref().ok()?))).collect();
            atlas::study(&found)
        };
        let mut charted = |Prepared { mut section, atlas, .. }: Prepared| {
            match atlas {
                Ok(atlas) => {
                    digits = digits.min(atlas.reference.digits);
                    section.work = speed::pictures::work_precision(&atlas).into();
                    explained(&mut section, &atlas);
                }
                Err(NoReference::Stopped(failure)) => {
                    section.note = format!("No chart, because the reference stopped: {failure}.");
                }
                Err(NoReference::Unknown(unknown)) => section.note = format!("No chart: {unknown}."),
                Err(NoReference::Ends) => section.note = "No chart, because the run ends before its span.".to_owned(),
            }
            section
        };
        let prepared = self.prepared.into_iter().flatten();
        let (across, smooth): (Vec<Prepared>, Vec<Prepared>) = prepared.partition(|one| one.across_events);
        report.scenes = smooth.into_iter().map(&mut charted).collect();
        // scenes with events have tables without pictures, to keep the page small; `dalembert chart` draws the pictures
        let tabled = |prepared| SceneSection { work: Vec::new(), ..charted(prepared) };
        report.rough = across.into_iter().map(tabled).collect();
        let texts = self.texts.into_iter().flatten().flatten();
        report.papers = self.papers.into_iter().flatten().chain(texts).map(|(section, _)| section).collect();
        report.stability = self.stability.unwrap_or_default();
        report.approximations = self.approximations.into_iter().collect();
        report.friction = self.friction.unwrap_or_default();
        let (spheres, stationary) = self.stationary.pictures();
        report.spheres = spheres;
        report.studies = stationary.into_iter().collect();
        report.studies.extend(self.synchronism.study());
        report.studies.extend([
            atlas,
            self.gains.study(),
            self.drive.study(),
            self.endurance.study(folder),
            self.numerical_stability.study(),
        ]);
        report.studies.extend(self.failures.study());
        report.studies.extend(self.foreign.study());
        report.studies.push(peers::study(folder));
        match timings::read(folder) {
            Ok(timings) => report.timings = vec![timings],
            Err(reason) => report.timings_missing = reason,
        }
        report.summary = format!("{} {}", report.summary, found(&report, digits));
        report
    }
}

/// The scenes with a motor.
fn driven(scenes: &[Read]) -> impl Iterator<Item = &Scene> {
    scenes.iter().filter_map(|read| match &read.scene {
        AnyScene::Driven(scene) => Some(&**scene),
        _ => None,
    })
}

const SUMMARY: &str = "Equations of motion derived from bodies and energies; every statement of a paper judged by exact \
                       arithmetic; every method on every scene measured by a reference that two methods confirm.";

/// The summary of the results, with advice on where to begin.
fn found(report: &Report, digits: f64) -> String {
    let claims: usize = report.papers.iter().map(|paper| paper.claims.len()).sum();
    let mut text = String::new();
    if claims > 0 {
        text += &format!("Of {claims} claims, {}. ", counted(report));
    }
    if report.count(Verdict::Refuted) > 0 {
        text += "Begin with the findings: each refuted statement with exact values for which it fails, and the proved \
                 statement that holds instead. ";
    }
    if digits.is_finite() {
        let count = report.scenes.iter().filter(|scene| !scene.work.is_empty()).count();
        let scenes = if count == 1 { "The scene is".to_owned() } else { format!("The {count} scenes are") };
        text += &format!(
            "{scenes} measured by references on which two methods agree to {digits:.0} digits or more: choose the one \
             nearest to your own problem; its charts show which method is cheapest at which accuracy."
        );
    }
    text.trim_end().to_owned()
}

/// The numbers of claims by verdict, the most frequent first: `149 are proved, 11 refuted, 3 definitions`.
fn counted(report: &Report) -> String {
    let mut counts = Verdict::ALL.map(|verdict| (report.count(verdict), verdict));
    counts.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let name = |count: usize, verdict: Verdict| match verdict {
        Verdict::Definition if count > 1 => "definitions",
        other => other.name(),
    };
    let present = counts.into_iter().filter(|(count, _)| *count > 0).enumerate();
    let one =
        |(place, (count, verdict))| format!("{count} {}{}", if place == 0 { "are " } else { "" }, name(count, verdict));
    present.map(one).collect::<Vec<_>>().join(", ")
}
