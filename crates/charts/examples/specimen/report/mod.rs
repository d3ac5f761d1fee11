//! Invented data with the size and structure of a full report: no statement, number or verdict in it is a real one.

mod ledger;
mod pictures;
mod scenes;

use dalembert_charts::Report;

pub fn specimen() -> Report {
    Report {
        title: "Specimen of a report: made-up data".into(),
        summary: "Nothing on this page is a result. It shows how a report reads: 70 claims of three invented papers, of \
                  which some are refuted with an exact counterexample and corrected, six scenes with six methods at ten \
                  tolerances each, a cone of axes $V^{*}(\\nu_1, \\nu_2, \\nu_3) = 0$ on the sphere, and timings. A price \
                  of \\$5 & a tag such as <script> are text."
            .into(),
        generated_by: "specimen of dalembert-charts; no dates, no paths, the same bytes every time".into(),
        papers: ledger::papers(),
        scenes: scenes::scenes(),
        spheres: pictures::spheres(),
        stability: Vec::new(),
        approximations: Vec::new(),
        friction: pictures::areas(),
        rough: Vec::new(),
        studies: pictures::studies(),
        timings: pictures::timings(),
        timings_missing: String::new(),
    }
}
