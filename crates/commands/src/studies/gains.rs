//! The study of the gains of a stabilised constraint: stability regions, drift and error as functions of the gain, other treatments.

use super::missing;
use super::treatments::{note, scanned, table};
use crate::job_pool::JobPool;
use charts::{AreaCurve, Areas, Study};
use integrators::Failure;
use std::sync::OnceLock;
use std::time::Duration;
use studies::stabilisation::regions::{self, Fate, Map};
use studies::stabilisation::schemes::Scheme;
use studies::stabilisation::treatments::{Goal, Line, RUNS, Scan, compare, times};

/// The parts of the study, each a separate job.
#[derive(Default)]
pub struct Gains {
    maps: [Option<Map>; SCHEMES.len()],
    goal: OnceLock<Result<Goal, Failure>>,
    compared: [Option<Result<Compared, Failure>>; RUNS.len()],
    /// The time of each treatment, s; `None` where it was not measured.
    times: Vec<Option<f64>>,
}

/// The results of a method with one step size: the scan over gains, and the treatments of the constraint.
type Compared = (Scan, Vec<Line>);

/// The methods in the order of the page, each with the expected time for its map, s.
const SCHEMES: [(Scheme, f64); 4] =
    [(Scheme::Euler, 0.1), (Scheme::RungeKutta4, 0.3), (Scheme::ImplicitMidpoint, 0.5), (Scheme::BackwardEuler, 3.0)];
/// The numbers of columns and rows of a map.
const CELLS: (usize, usize) = (60, 50);
/// The time for measuring the times of all treatments.
const ALLOWED: Duration = Duration::from_secs(6);

impl Gains {
    /// Adds the jobs of the study; times are measured later.
    pub fn enlist<'s>(&'s mut self, crew: &mut JobPool<'s>) {
        let Gains { maps, goal, compared, .. } = self;
        for (place, (scheme, cost)) in maps.iter_mut().zip(SCHEMES) {
            crew.add(cost, place, move || regions::map(scheme, CELLS.0, CELLS.1));
        }
        let goal = &*goal;
        for (place, (scheme, steps)) in compared.iter_mut().zip(RUNS) {
            crew.add(1.0, place, move || {
                let goal = goal.get_or_init(Goal::new).as_ref().map_err(|failure| *failure)?;
                let scan = Scan::of(scheme, steps, goal);
                let lines = compare(scheme, steps, &scan, goal);
                Ok((scan, lines))
            });
        }
    }

    /// Measures the times of the treatments, while nothing else runs.
    pub fn take_times(&mut self) {
        self.times = times(&self.lines(), ALLOWED);
    }

    fn lines(&self) -> Vec<Line> {
        self.compared.iter().flatten().flatten().flat_map(|(_, lines)| lines.clone()).collect()
    }

    /// The completed study for the report.
    pub fn study(self) -> Study {
        let lines = self.lines();
        let failed = self.compared.iter().flatten().find_map(|compared| compared.as_ref().err());
        let mut study = Study {
            id: "gains".into(),
            title: "Gains of a stabilised constraint".into(),
            lead: r"A violation $y$ of a constraint satisfies $\ddot y=-b\dot y-ky$. With steps $h$ its decay or growth depends only on the method, $hb$ and $h^2k$. Colours: results of runs of a crank and slider with a violated constraint. Curves: the exact boundary, proved in the ledger.".into(),
            note: failed.map_or_else(|| note().into(), missing),
            ..Study::default()
        };
        study.pictures = self.maps.into_iter().flatten().map(map).collect();
        let scans: Vec<&Scan> = self.compared.iter().flatten().flatten().map(|(scan, _)| scan).collect();
        if !scans.is_empty() {
            study.pictures.push(scanned(&scans, "Drift by gain", "largest |f| (m²)", |point| point.drift));
            study.pictures.push(scanned(&scans, "Error by gain", "largest error, relative", |point| point.error));
            study.tables.push(table(&lines, &self.times));
        }
        study
    }
}

fn map(map: Map) -> Areas {
    let place = |fate: &Fate| Fate::ALL.iter().position(|known| known == fate).unwrap_or(0);
    let cells: usize = map.rows.iter().map(Vec::len).sum();
    let best = map.best.map(|(b, k)| (b, k, "fastest".into()));
    let name = map.scheme.name();
    let note = match map.scheme {
        Scheme::Euler => {
            "The triangle with the corners (0, 0), (2, 0), (4, 4). At (2, 1) a violation is zero after two steps."
        }
        Scheme::RungeKutta4 => "At (3.459, 3.781) a violation is zero after one step.",
        Scheme::ImplicitMidpoint => "All positive gains. At (4, 4) a violation is zero after two steps.",
        Scheme::BackwardEuler => "All positive gains; the larger, the faster.",
    };
    Areas {
        title: format!("Stable gains of {name}"),
        x: ("h b".into(), [0.0, map.most.0]),
        y: ("h² k".into(), [0.0, map.most.1]),
        names: Vec::new(),
        kinds: Fate::ALL.iter().map(|fate| fate.name().into()).collect(),
        rows: map.rows.iter().map(|row| row.iter().map(place).collect()).collect(),
        curves: ["upper edge, exact", "lower edge, exact"]
            .into_iter()
            .zip(map.edges)
            .map(|(name, points)| AreaCurve { name: name.into(), points })
            .collect(),
        dots: Vec::new(),
        marks: best.into_iter().collect(),
        note: format!("{note} In {} of {cells} cells the run and the exact boundary disagree.", map.mistaken),
    }
}
