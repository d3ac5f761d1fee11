//! The study of an electromechanical drive: the experiment of its paper, and the step sizes and gains for which Euler's method is stable.

use super::{extent, missing};
use crate::job_pool::JobPool;
use charts::{AreaCurve, Areas, Panel, Study, Table, Track, Trajectory, significant};
use integrators::{Failure, Method};
use studies::stabilisation::drive_law::violation;
use studies::stabilisation::experiment::{self, Bearable, DRIVE, STEP, Sample, Track as Run, bearable, most_damping};

/// The gains b and k of the experiment: those with the fastest decay of violations under Euler's method with its step size.
const FASTEST: (f64, f64) = (2.0 / STEP, 1.0 / (STEP * STEP));

/// The end of the phase portrait of the capacitor, s; a longer curve would fill an area.
const FILLS: f64 = 4.0;

/// The parts of the study, each a separate job.
#[derive(Default)]
pub struct Drive {
    /// The samples of an accurate run, and the number of digits on which two runs agree.
    exact: Option<Result<(Vec<Sample>, f64), Failure>>,
    bearable: Option<Result<Bearable, Failure>>,
    /// The largest damping gain for which Euler's method is stable.
    most_damping: Option<f64>,
}

impl Drive {
    /// Adds the jobs of the study.
    pub fn enlist<'s>(&'s mut self, crew: &mut JobPool<'s>) {
        crew.add(1.0, &mut self.exact, || experiment::exact(1000));
        crew.add(2.0, &mut self.bearable, bearable);
        crew.add(0.3, &mut self.most_damping, || most_damping(FASTEST.1));
    }

    /// The completed study for the report.
    pub fn study(self) -> Study {
        match (self.exact, self.bearable, self.most_damping) {
            (Some(exact), Some(bearable), Some(most_damping)) => study(exact, bearable, most_damping),
            _ => Study::default(),
        }
    }
}

/// The study from its results.
fn study(exact: Result<(Vec<Sample>, f64), Failure>, bearable: Result<Bearable, Failure>, most_damping: f64) -> Study {
    let euler: fn(u32) -> Method = |steps| Method::Euler { steps };
    let runs = [
        experiment::run("Euler, h = 0.01 s, not stabilised", euler, STEP, 0.0, 0.0),
        experiment::run("Euler, h = 0.01 s, stabilised", euler, STEP, FASTEST.0, FASTEST.1),
    ];
    let mut study = Study {
        id: "drive".into(),
        title: "The electromechanical drive".into(),
        lead: r"Source, transformer, bridge of diodes, capacitor and choke, motor, crank, rod and slider: nine equations of the first order in $f^1,f^2,q^3,f^4,f^5,q^6,f^6,q^7,f^7$. The equations and data are this workbench's own: the paper prints the constraint $(q^7-r\cos q^6)^2+(r\sin q^6)^2=l^2$, the number of equations, the method and its step.".into(),
        ..Study::default()
    };
    let (exact, digits) = match exact {
        Ok(found) => found,
        Err(failure) => {
            study.note = missing(&failure);
            return study;
        }
    };
    let exact = Run { name: "reference".into(), points: exact, failure: None };
    let all = [&exact, &runs[0], &runs[1]];
    study.run = Some(in_time(&all));
    study.pictures.push(portrait("crank", &all, ["q6, rad", "f6, rad/s"], |state| (state[5], state[6])));
    study.pictures.push(portrait("slider", &all, ["q7, m", "f7, m/s"], |state| (state[7], state[8])));
    let [first, second, third] = all.map(|run| Run {
        points: run.points.iter().filter(|(time, _)| *time < FILLS).copied().collect(),
        ..run.clone()
    });
    let mut filling = portrait("capacitor", &[&first, &second, &third], ["q3, A s", "f3 = f4 - f5, A"], |state| {
        (state[2], state[3] - state[4])
    });
    filling.note = format!("The first {FILLS} s, in which it charges.");
    study.pictures.push(filling);
    study.pictures.push(constraint(&all));
    study.tables.push(table(&all));
    study.note = bounds(digits, bearable, most_damping);
    study
}

fn in_time(runs: &[&Run]) -> Trajectory {
    let panel = |&(place, label): &(usize, &str)| Panel {
        y: label.into(),
        series: runs
            .iter()
            .map(|run| Track {
                name: run.name.clone(),
                points: run.points.iter().map(|(time, y)| (*time, y[place])).collect(),
                ..Track::default()
            })
            .collect(),
    };
    let shown = [(2, "q3, A s"), (5, "q6, rad"), (6, "f6, rad/s"), (7, "q7, m"), (8, "f7, m/s")];
    Trajectory {
        title: "Charge of the capacitor, crank and slider".into(),
        x: "time, s".into(),
        panels: shown.iter().map(panel).collect(),
        note: String::new(),
    }
}

fn portrait(title: &str, runs: &[&Run], [x, y]: [&str; 2], of: impl Fn(&[f64; 9]) -> (f64, f64)) -> Areas {
    let curve =
        |run: &&Run| AreaCurve { name: run.name.clone(), points: run.points.iter().map(|(_, y)| of(y)).collect() };
    let curves: Vec<AreaCurve> = runs.iter().map(curve).collect();
    Areas {
        title: format!("Phase portrait of the {title}"),
        x: (x.into(), extent(&curves, |point| point.0)),
        y: (y.into(), extent(&curves, |point| point.1)),
        curves,
        ..Areas::default()
    }
}

fn constraint(runs: &[&Run]) -> Areas {
    let curve = |run: &&Run| AreaCurve {
        name: run.name.clone(),
        points: run
            .points
            .iter()
            .skip(1)
            .map(|(time, y)| (*time, violation(&DRIVE, y).0.abs().max(1e-9).log10()))
            .collect(),
    };
    let curves: Vec<AreaCurve> = runs.iter().map(curve).collect();
    Areas {
        title: "The constraint over time".into(),
        x: ("time, s".into(), [0.0, experiment::SPAN]),
        y: ("log₁₀ |f| (m²)".into(), extent(&curves, |point| point.1)),
        curves,
        note: "Below 1e-9 shown as that.".into(),
        ..Areas::default()
    }
}

fn table(runs: &[&Run]) -> Table {
    let head =
        ["Run", "Largest |f|, m²", "Largest |f\u{307}|, m²/s", "q6 at the end, rad", "f6, rad/s", "q7, m", "f7, m/s"];
    let row = |run: &&Run| {
        let (f, df) = run.drift();
        let mut cells = vec![run.name.clone(), significant(f, 2), significant(df, 2)];
        match (&run.failure, run.points.last()) {
            (None, Some((_, y))) => cells.extend([5, 6, 7, 8].map(|i| significant(y[i], 5))),
            (Some(failure), _) => cells.push(failure.to_string()),
            (None, None) => {}
        }
        cells
    };
    Table { caption: String::new(), head: head.map(String::from).into(), rows: runs.iter().map(row).collect() }
}

/// The text on the step sizes and gains for which Euler's method is stable in the experiment.
fn bounds(digits: f64, bearable: Result<Bearable, Failure>, most_damping: f64) -> String {
    let step = match bearable {
        Ok(found) => format!(
            r"At the instants of the motion, Euler multiplies no disturbance of the five electrical unknowns by more than one for steps below {} s to {} s (frozen coefficients, so neither bound is a theorem on the run). By measurement the currents of a run stay bounded up to $h={}$ s without stabilisation and up to $h={}$ s with it.",
            significant(found.least, 3),
            significant(found.greatest, 3),
            significant(found.plain, 3),
            significant(found.stabilised, 3),
        ),
        Err(failure) => missing(&failure),
    };
    let stiffness = FASTEST.1;
    format!(
        r"The reference is a motion on which two methods of different families agree to {digits:.0} digits. {step} At $h=0.01$ s Euler is stable for gains in the triangle $0<h^2k<hb<2+h^2k/2$: with $k={}$/s² that is $b<{}$/s by theory, and $b<{}$/s by measurement. A source of 50 Hz cannot be represented: with steps of half a period $\sin(100\pi t)$ is zero at each.",
        significant(stiffness, 3),
        significant((2.0 + stiffness * STEP * STEP / 2.0) / STEP, 4),
        significant(most_damping, 4),
    )
}
