//! Six invented scenes, each with six methods at ten tolerances.

use dalembert_charts::{
    Failure, Method, Panel, Parameter, Point, SceneSection, Table, Track, Trajectory, Work, WorkPrecision,
};

const NAMES: [&str; 6] = [
    "Three-current motor from rest",
    "Free rotor, second form",
    "Pull-out of the synchronous motor",
    "Crank-slider with programmed constraint",
    "Rod with Painlevé's paradox",
    "Governor near blow-up",
];

/// For each method: its name, its order, the cost of a step, and the smallest error.
const METHODS: [(&str, f64, f64, f64); 6] = [
    ("DOPRI5", 5.0, 7.0, 4e-15),
    ("DOP853", 8.0, 12.0, 2e-15),
    ("Radau IIA, 3 stages", 5.0, 40.0, 3e-14),
    ("Gauss, 2 stages, projected", 4.0, 30.0, 1e-14),
    ("Taylor, order 24, double-double", 24.0, 90.0, 3e-31),
    ("Störmer-Verlet", 2.0, 1.0, 1e-11),
];

pub fn scenes() -> Vec<SceneSection> {
    NAMES.iter().enumerate().map(|(position, name)| scene(position, name)).collect()
}

fn scene(position: usize, name: &str) -> SceneSection {
    let parameter = |symbol: &str, value: &str, unit: &str, meaning: &str| Parameter {
        symbol: symbol.into(),
        value: value.into(),
        unit: unit.into(),
        meaning: meaning.into(),
    };
    let pair = |name: &str, value: &str| (name.to_owned(), value.to_owned());
    SceneSection {
        id: format!("scene-{}", position + 1),
        title: name.into(),
        description:
            "A specimen scene: the carrier starts at rest with the vertical along $\\nu = (0, 3/5, 4/5)$; the motor \
                      is switched on at $t = 0$ and reaches pull-out before the rotor has the speed $\\Omega$."
                .into(),
        parameters: vec![
            parameter("$A_1^{*}$", "3.2", "kg m²", "moment of inertia about $\\xi_1$"),
            parameter("$A_2^{*}$", "2.1", "kg m²", "about $\\xi_2$"),
            parameter("$A'$", "0.25", "kg m²", "of the rotor about its axis"),
            parameter("$\\Gamma$", "−9.81", "N m", "weight times distance of the centre of mass"),
            parameter("$\\Omega$", "157.0796", "rad/s", "angular velocity of the field"),
            parameter("$R / L$", "1 250", "1/s", "rate of decay of the currents"),
            parameter("$\\mathbf{l}$", "(1/3, 2/3, 2/3)", "", "axis of the rotor"),
        ],
        facts: vec![
            pair("Equations", "9, first form, derived by Lagrange II"),
            pair("Method of the run", "DOP853 at tolerance 10⁻¹²"),
            pair("Evaluations", "12 480 in 1 040 steps, 3 rejected"),
            pair("$|\\nu| - 1$, largest", "4.4·10⁻¹⁵"),
            pair("Energy, relative drift", "2.1·10⁻¹³"),
            pair("Smallest sufficient model", "synchronous, no currents: error at most 3·10⁻⁴"),
        ],
        tables: if position == 0 { vec![models()] } else { Vec::new() },
        trajectory: Some(trajectory(position)),
        work: vec![work(position, Work::Evaluations), work(position, Work::TimeRatio)],
        note: String::new(),
    }
}

fn models() -> Table {
    let row = |cells: [&str; 4]| cells.map(String::from).into();
    Table {
        caption: "Ladder of models".into(),
        head: ["Model", "Equations", "Evaluations", "Error against the full model"].map(String::from).into(),
        rows: vec![
            row(["all bars", "23", "48 210", "—"]),
            row(["two equivalent dampers", "11", "9 004", "3.1·10⁻⁶"]),
            row(["no currents", "8", "1 240", "2.8·10⁻⁴"]),
        ],
    }
}

fn trajectory(position: usize) -> Trajectory {
    let shift = position as f64;
    let run = |phase: f64, end: f64, stopped: Option<&str>, name: &str| Track {
        name: name.into(),
        points: (0..20_000)
            .map(|i| f64::from(i) * 5e-4)
            .filter(|t| *t <= end)
            .map(|t| (t, (2.0 * t + phase + shift).sin() * (-0.1 * t).exp() + 0.05 * (70.0 * t).sin() * (-t).exp()))
            .collect(),
        stopped: stopped.map(String::from),
    };
    let singular = "det A vanishes: coordinates are singular at θ = π";
    let panels = ["ω₁, rad/s", "ν₃", "rotor, rad/s", "current i₁, A"];
    let panel = |(at, y): (usize, &&str)| Panel {
        y: (*y).into(),
        series: vec![
            run(at as f64, 10.0, None, "quaternion coordinates"),
            run(at as f64 + 0.15, 6.2, Some(singular), "Euler angles"),
            run(at as f64 + 0.4, 4.1, Some("step below 1e-14"), "explicit method, fixed step"),
        ],
    };
    Trajectory {
        title: "Motion".into(),
        x: "time, s".into(),
        panels: panels
            .iter()
            .take(2 + position % 3)
            .enumerate()
            .map(panel)
            .map(|panel| runs(panel, position))
            .collect(),
        note: "Tracks of one name look alike in all panels.".into(),
    }
}

/// The panel with its first three series; with two of them at position 3.
fn runs(mut panel: Panel, position: usize) -> Panel {
    panel.series.truncate(if position == 3 { 2 } else { 3 });
    panel
}

fn work(position: usize, x: Work) -> WorkPrecision {
    let series = METHODS.iter().enumerate().map(|(at, method)| run_all(position, x, at, *method)).collect();
    let unit = if x == Work::Evaluations { "evaluations" } else { "time" };
    WorkPrecision {
        title: format!("Error against {unit}"),
        x,
        error: "largest error of ν and ω, relative".into(),
        series,
        note: "Reference: double-double Taylor series, confirmed by Gauss' method of 6 stages to 3·10⁻²⁹.".into(),
        front: Vec::new(),
    }
}

fn run_all(position: usize, x: Work, at: usize, (name, order, cost, floor): (&str, f64, f64, f64)) -> Method {
    let mut method = Method { name: name.into(), ..Default::default() };
    for k in 0..10 {
        let step = 10_f64.powf(-f64::from(k) * 1.3 * 5.0_f64.min(order) / 5.0);
        let tolerance = 10_f64.powi(-3 - k);
        let wobble = 1.0 + 0.4 * (3.7 * f64::from(k) + at as f64 + position as f64).sin();
        let evaluations = (40.0 * cost * (step / 1e-2).powf(-1.0 / order) * wobble).round();
        let error = if at == 4 {
            (0.02 * tolerance.powf(2.3) * wobble).max(floor)
        } else {
            (3.0 * tolerance * wobble).max(floor)
        };
        let work =
            if x == Work::Evaluations { evaluations } else { 1.0 + evaluations / 90.0 * (1.0 + at as f64 * 0.3) };
        let fails = (at == 0 && k < 2 && position.is_multiple_of(2))
            || (at == 5 && k > 6)
            || (at == 3 && k == 4 && position == 1);
        if fails {
            let reason = match at {
                0 => "stiff windings: the step falls below 10⁻¹⁴ at t = 0.0031",
                5 => "constraint drift exceeds 10⁻³ at t = 7.2; the method does not project",
                _ => "Newton's iteration does not converge",
            };
            method.failures.push(Failure { work, tolerance, reason: reason.into() });
        } else {
            method.points.push(Point { work, error });
        }
    }
    if at == 1 && position == 2 {
        method.points.push(Point { work: f64::NAN, error: 1e-9 });
        method.points.push(Point { work: 100.0, error: 0.0 });
    }
    method
}
