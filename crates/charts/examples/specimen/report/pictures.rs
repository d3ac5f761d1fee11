//! An invented cone of axes, an invented map with two kinds of areas, and invented timings.

use dalembert_charts::{
    AreaCurve, Areas, Contender, Curve, CurvePoint, Mark, Sphere, Study, Table, TimingRow, Timings,
};
use std::f64::consts::TAU;

pub fn spheres() -> Vec<Sphere> {
    let coloured = Sphere {
        title: "Axes of permanent rotation, $\\Gamma \\ne 0$".into(),
        description: "The curve in which a cone of degree 8 meets the unit sphere. Each point is an axis fixed in the \
                      carrier; the colour is the angular velocity $\\omega^0$ about it."
            .into(),
        facts: vec![("weight".into(), "2 N m".into())],
        value: "angular velocity ω⁰, rad/s".into(),
        axes: ["ξ₁", "ξ₂", "ξ₃"].map(String::from),
        curves: vec![branch("upper branch", 1.0, true), branch("lower branch", -1.0, true)],
        marks: vec![
            Mark { name: "l".into(), at: [1.0, 2.0, 2.0], note: "axis of the rotor".into(), hollow: false },
            Mark {
                name: "e".into(),
                at: [0.6, 0.0, 0.8],
                note: "direction to the centre of mass".into(),
                hollow: false,
            },
            Mark { name: "−e".into(), at: [-0.6, 0.0, -0.8], note: "on no branch".into(), hollow: true },
        ],
        view: (35.0, 24.0),
        note: "Both half-axes of a direction are shown where both are axes of rotation.".into(),
        ..Sphere::default()
    };
    let plain = Sphere {
        title: "The same without weight, $\\Gamma = 0$".into(),
        value: String::new(),
        curves: vec![branch("cone of degree 2", 0.6, false), branch("its other sheet", -0.6, false)],
        marks: vec![Mark { name: "l".into(), at: [1.0, 2.0, 2.0], note: "axis of the rotor".into(), hollow: false }],
        description: String::new(),
        note: String::new(),
        ..coloured.clone()
    };
    vec![coloured, plain]
}

fn branch(name: &str, side: f64, valued: bool) -> Curve {
    let point = |i: i32| {
        let longitude = f64::from(i) * TAU / 900.0;
        let latitude = side * (0.35 + 0.42 * (4.0 * longitude).sin() * (0.5 + 0.3 * longitude.cos()));
        let at = [latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin()];
        let value = 12.0 * side * (2.0 * longitude).sin() + 0.4 / (0.02 + (longitude - 2.0).powi(2)).sqrt();
        CurvePoint { at, value: valued.then_some(value) }
    };
    Curve { name: name.into(), points: (0..=900).map(point).collect(), ..Curve::default() }
}

/// One study with a map, a table and a remark.
pub fn studies() -> Vec<Study> {
    vec![Study {
        id: "invented".into(),
        title: "An invented study".into(),
        lead: "What is compared, with $x^2$ in it.".into(),
        pictures: areas(),
        tables: vec![Table {
            caption: "Invented numbers".into(),
            head: vec!["What".into(), "How much".into()],
            rows: vec![vec!["one <thing>".into(), "1.5".into()]],
        }],
        note: "A remark.".into(),
        ..Study::default()
    }]
}

pub fn areas() -> Vec<Areas> {
    let below = |x: usize, y: usize| usize::from(y * 40 > x * x);
    vec![Areas {
        title: "An invented plane".into(),
        x: ("a quantity".into(), [0.0, 1.0]),
        y: ("another".into(), [0.0, 1.0]),
        kinds: vec!["below".into(), "above".into()],
        rows: (0..40).map(|y| (0..40).map(|x| below(x, y)).collect()).collect(),
        curves: vec![AreaCurve {
            name: "the parabola".into(),
            points: (0..=40).map(|k| (f64::from(k) / 40.0, (f64::from(k) / 40.0).powi(2))).collect(),
        }],
        dots: Vec::new(),
        marks: vec![(0.5, 0.25, "a point".into())],
        note: "Nothing is meant.".into(),
        ..Areas::default()
    }]
}

pub fn timings() -> Vec<Timings> {
    let row = |task: &str, ours: f64, theirs: [Result<f64, &str>; 2]| TimingRow {
        task: task.into(),
        ours,
        others: ["SymPy", "a C++ library"]
            .into_iter()
            .zip(theirs)
            .map(|(name, outcome)| Contender { name: name.into(), outcome: outcome.map_err(String::from) })
            .collect(),
    };
    vec![Timings {
        title: "Against others".into(),
        ours: "dalembert".into(),
        rows: vec![
            row("identity of the determinant, 12 variables", 8e-6, [Ok(40e-3), Ok(62e-6)]),
            row("power with 600 000 terms", 0.51, [Ok(5.7), Ok(0.48)]),
            row("equations of the gyrostat by Lagrange II, nine coordinates", 1.9e-3, [Ok(14.2), Err("not offered")]),
            row("det(AB) = det A det B, generic 4 × 4", 0.75e-3, [Err("stopped after 600 s"), Ok(1.1e-3)]),
        ],
        note: "Specimen values; one core, median of 5.".into(),
    }]
}
