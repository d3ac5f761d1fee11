//! Studies in the report: gains of stabilised constraints, and the electromechanical drive.

use charts::{AreaCurve, Areas, Panel, Study, Table, Track, Trajectory, significant};
use derivations::stabilisation::experiment::{self, STEP, Track as Run, bearable, most_damping, violation};
use derivations::stabilisation::regions::{Fate, Map, maps};
use derivations::stabilisation::schemes::Scheme;
use derivations::stabilisation::treatments::{Line, SPAN, Scan, compare, scans};
use integrators::{Failure, Method};

/// Regions of gains, what gains do to drift and error, and the treatments of a constraint.
pub fn gains() -> Study {
    let mut study = Study {
        id: "gains".into(),
        title: "Gains of a stabilised constraint".into(),
        lead: r"A violation $y$ of a constraint is led by $\ddot y=-b\dot y-ky$. In steps $h$ its fate depends on the method, $hb$ and $h^2k$ alone. Coloured: what became of a violation of a crank and slider, run by the integrator. Curves: the exact edge, as it is proved in the ledger.".into(),
        pictures: maps(60, 50).into_iter().map(map).collect(),
        ..Study::default()
    };
    match scans() {
        Ok(scans) => study.pictures.extend([
            scanned(&scans, "Drift by gain", "largest |f| (m²)", |point| point.1),
            scanned(&scans, "Error by gain", "largest error, relative", |point| point.2),
        ]),
        Err(failure) => study.note = missing(&failure),
    }
    match compare() {
        Ok(lines) => study.tables.push(treatments(&lines)),
        Err(failure) => study.note = missing(&failure),
    }
    if study.note.is_empty() {
        study.note = r"Error: the largest of angle, place and their rates at 100 times, relative to the size of each. Gains that grow as $1/h$ and $1/h^2$ bring a violation back fastest and make the equations stiff at every step: the classical Runge-Kutta method then has order 1. Moderate gains keep its order. Half-explicit Gear-Gupta-Leimkuhler with the coefficients of the classical method has order 3. The combination with the implicit midpoint rule was not run: it needs a solver for differential-algebraic equations.".into();
    }
    study
}

fn missing(failure: &Failure) -> String {
    format!("Not measured, because the reference stopped: {failure}.")
}

fn map(map: Map) -> Areas {
    let place = |fate: &Fate| Fate::ALL.iter().position(|known| known == fate).unwrap_or(0);
    let cells: usize = map.rows.iter().map(Vec::len).sum();
    let best = map.best.map(|(b, k)| (b, k, "fastest".into()));
    let name = map.scheme.name();
    let note = match map.scheme {
        Scheme::Euler => {
            "The triangle with the corners (0, 0), (2, 0), (4, 4). At (2, 1) a violation is gone after two steps."
        }
        Scheme::RungeKutta4 => "At (3.459, 3.781) a violation is gone after one step.",
        Scheme::ImplicitMidpoint => "All positive gains. At (4, 4) a violation is gone after two steps.",
        Scheme::BackwardEuler => "All positive gains; the larger, the faster.",
    };
    Areas {
        title: format!("Gains that {name} bears"),
        x: ("h b".into(), [0.0, map.most.0]),
        y: ("h² k".into(), [0.0, map.most.1]),
        kinds: Fate::ALL.iter().map(|fate| fate.name().into()).collect(),
        rows: map.rows.iter().map(|row| row.iter().map(place).collect()).collect(),
        curves: ["upper edge, exact", "lower edge, exact"]
            .into_iter()
            .zip(map.edges)
            .map(|(name, points)| AreaCurve { name: name.into(), points })
            .collect(),
        marks: best.into_iter().collect(),
        note: format!(
            "{note} {} of {cells} cells are on the other side of the exact edge than their run.",
            map.mistaken
        ),
    }
}

/// Decades over decades.
fn scanned(scans: &[Scan], title: &str, label: &str, value: impl Fn(&(f64, f64, f64)) -> f64) -> Areas {
    let curve = |scan: &Scan| AreaCurve {
        name: format!("{}, {} steps", scan.scheme.name(), scan.steps),
        points: scan.points.iter().map(|point| (point.0.log10(), value(point).max(1e-16).log10())).collect(),
    };
    let curves: Vec<AreaCurve> = scans.iter().map(curve).collect();
    Areas {
        title: title.into(),
        x: ("log₁₀ h w, gains b = 2 w, k = w²".into(), [-3.0, 1.0]),
        y: (format!("log₁₀ {label}"), extent(&curves, |point| point.1)),
        curves,
        note: format!(
            "Critically damped, {SPAN} s of the crank and slider. A curve ends where the method bears no more."
        ),
        ..Areas::default()
    }
}

fn extent(curves: &[AreaCurve], value: impl Fn(&(f64, f64)) -> f64) -> [f64; 2] {
    let all = curves.iter().flat_map(|curve| &curve.points).map(value);
    let (low, high) = all.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
    let margin = 0.05 * (high - low).max(1e-9);
    [low - margin, high + margin]
}

fn treatments(lines: &[Line]) -> Table {
    let head = [
        "Method",
        "Steps",
        "Constraint",
        "Largest |f|, m²",
        "Largest |f\u{307}|, m²/s",
        "Error",
        "Evaluations",
        "of the constraint alone",
    ];
    let row = |line: &Line| {
        let mut cells = vec![line.scheme.name().to_owned(), line.steps.to_string(), line.treatment.name().to_owned()];
        match &line.measured {
            Some(Ok(found)) => {
                cells.extend([found.drift, found.rate_drift, found.error].map(|x| significant(x, 2)));
                cells.extend([found.evaluations, found.corrections].map(|count| count.to_string()));
            }
            Some(Err(failure)) => cells.push(failure.to_string()),
            None => cells.extend(["—"; 5].map(str::to_owned)),
        }
        cells
    };
    let caption = "A crank and slider over nine turns, by what is done about its constraint".into();
    Table { caption, head: head.map(String::from).into(), rows: lines.iter().map(row).collect() }
}

/// The gains of the experiment: the fastest that Euler has at its step.
const FASTEST: (f64, f64) = (2.0 / STEP, 1.0 / (STEP * STEP));

/// Until the portrait of the capacitor is one thick line, s.
const FILLS: f64 = 4.0;

/// The experiment with the drive.
pub fn drive() -> Study {
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
    let (exact, digits) = match experiment::exact(1000) {
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
    filling.note = format!("The first {FILLS} s, in which it fills.");
    study.pictures.push(filling);
    study.pictures.push(constraint(&all));
    study.tables.push(table(&all));
    study.note = bounds(digits);
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
        points: run.points.iter().skip(1).map(|(time, y)| (*time, violation(y).0.abs().max(1e-9).log10())).collect(),
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

/// What step and gains the experiment can bear.
fn bounds(digits: f64) -> String {
    let step = match bearable() {
        Ok(found) => format!(
            r"At the instants of the reference, Euler multiplies no disturbance of the five electrical unknowns by more than one for steps below {} s to {} s (frozen coefficients, so neither bound is a theorem on the run). By measurement the currents of a run stay bounded up to $h={}$ s without stabilisation and up to $h={}$ s with it.",
            significant(found.least, 3),
            significant(found.greatest, 3),
            significant(found.plain, 3),
            significant(found.stabilised, 3),
        ),
        Err(failure) => missing(&failure),
    };
    let stiffness = FASTEST.1;
    format!(
        r"The reference is a motion on which two methods of different families agree to {digits:.0} digits. {step} At $h=0.01$ s Euler bears gains in the triangle $0<h^2k<hb<2+h^2k/2$: with $k={}$/s² that is $b<{}$/s by theory, and $b<{}$/s by measurement. A source of 50 Hz is out of reach: in steps of half a period $\sin(100\pi t)$ is zero at each.",
        significant(stiffness, 3),
        significant((2.0 + stiffness * STEP * STEP / 2.0) / STEP, 4),
        significant(most_damping(stiffness), 4),
    )
}
