//! Results as the data of charts: runs, stability maps, errors of series, maps of friction.

use charts::{AreaCurve, Areas, Panel, Sheet, Track, significant};
use integrators as run;
use reader::Quantity;
use simulation::{IvpScene, Trajectory};
use studies::governors::StabilityMap;
use studies::regimes::maps::{Kind, Map};
use studies::scene::state::unit;

/// The chart of the scene's outputs over time. Components of one vector share a panel, and so do all currents.
pub fn trajectory(scene: &dyn IvpScene, run: &Trajectory) -> charts::Trajectory {
    let outputs = &scene.run().outputs;
    let shown: Vec<&String> = run.names.iter().filter(|name| outputs.is_empty() || outputs.contains(name)).collect();
    let failure = run.outcome.failure();
    let stopped = run.left.or(failure.as_ref().map(run::Failure::name)).map(str::to_owned);
    let mut panels: Vec<(String, Panel)> = Vec::new();
    for name in shown {
        let Some(column) = run.column(name) else { continue };
        let points = run.times.iter().zip(&run.rows).map(|(time, row)| (*time, row[column])).collect();
        let (label, quantity) = match scene.column(name) {
            Some(Quantity { name, unit, meaning, .. }) => (name.to_string(), format!("{meaning}, {unit}")),
            None if scene.has_own_names() => (name.clone(), of_unit(&scene.unit(name))),
            None => (label(name), quantity(name)),
        };
        let track = Track { name: label, points, stopped: stopped.clone() };
        match panels.iter_mut().find(|(known, _)| *known == quantity) {
            Some((_, panel)) => panel.series.push(track),
            None => panels.push((quantity.clone(), Panel { y: quantity, series: vec![track] })),
        }
    }
    let panels = panels.into_iter().map(|(_, panel)| small(panel)).collect();
    charts::Trajectory {
        title: "The run against time".to_owned(),
        x: "time, s".to_owned(),
        panels,
        note: String::new(),
    }
}

/// The charts of one run on one sheet: outputs over time, below them quantities that should stay zero, next to them speeds over coordinates.
pub fn sheet(scene: &dyn IvpScene, run: &Trajectory) -> Sheet {
    let mut against_time = trajectory(scene, run);
    let stopped = run.stopped();
    // the reason of an early stop appears once, below all panels
    let tracks = against_time.panels.iter_mut().flat_map(|panel| &mut panel.series);
    tracks.for_each(|track| track.stopped = None);
    let checks = run.checks.iter().enumerate().map(|(place, name)| {
        let points = run.times.iter().zip(&run.checked).map(|(time, row)| (*time, row[place])).collect();
        Panel { y: name.replace('_', " "), series: vec![Track { name: String::new(), points, stopped: None }] }
    });
    let checks = charts::Trajectory { x: "time, s".to_owned(), panels: checks.collect(), ..Default::default() };
    let outputs = &scene.run().outputs;
    let is_shown = |name: &String| outputs.is_empty() || outputs.contains(name);
    let phases = run.names.iter().enumerate().filter(|(_, name)| is_shown(name)).filter_map(|(place, name)| {
        let (rate, own) = (run.column(&format!("{name}'"))?, scene.unit(name));
        let points = run.rows.iter().map(|row| (row[place], row[rate])).collect();
        let track = Track { name: name.clone(), points, stopped: None };
        let heading = with_unit(&run.names[rate], &scene.unit(&run.names[rate]));
        let panels = vec![Panel { y: heading, series: vec![track] }];
        Some(charts::Trajectory { x: with_unit(name, &own), panels, ..Default::default() })
    });
    let left = if checks.panels.is_empty() { vec![against_time] } else { vec![against_time, checks] };
    let note = stopped.map_or_else(String::new, |why| format!("The run stopped: {why}."));
    Sheet { title: scene.title().to_owned(), columns: vec![left, phases.take(MOST_PHASES).collect()], note }
}

/// The largest number of phase portraits on a sheet.
const MOST_PHASES: usize = 4;

/// A name with its unit.
fn with_unit(name: &str, unit: &str) -> String {
    if unit == "1" || unit.is_empty() { name.to_owned() } else { format!("{name}, {unit}") }
}

/// The panel; where its curves are far apart and hardly change, a panel with their changes since the start.
fn small(mut panel: Panel) -> Panel {
    let extent = |points: &mut dyn Iterator<Item = f64>| {
        let (low, high) = points.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
        high - low
    };
    let own = panel.series.iter().map(|track| extent(&mut track.points.iter().map(|point| point.1)));
    let largest = own.fold(0.0, f64::max);
    let whole = extent(&mut panel.series.iter().flat_map(|track| track.points.iter().map(|point| point.1)));
    if largest > SMALL * whole {
        return panel;
    }
    for track in &mut panel.series {
        let start = track.points.first().map_or(0.0, |point| point.1);
        track.points.iter_mut().for_each(|point| point.1 -= start);
    }
    panel.y = format!("change of {}", panel.y);
    panel
}

/// The fraction of the common range of all curves; where every curve varies less than this, the panel shows changes.
const SMALL: f64 = 0.1;

/// The label of a panel for columns with this unit.
fn of_unit(unit: &str) -> String {
    if unit.is_empty() { "without a unit".to_owned() } else { unit.to_owned() }
}

/// The label of a state or output.
pub fn label(name: &str) -> String {
    match name {
        "angle" => "\u{3b3}".to_owned(),
        "slip" => "\u{3b3}\u{307}".to_owned(),
        "x" => "x (excitation)".to_owned(),
        "rotor_speed" => "\u{3c6}\u{307}".to_owned(),
        _ => {
            let letters = name.replace('w', "\u{3c9}").replace('v', "\u{3bd}");
            letters.chars().map(|c| c.to_digit(10).and_then(|d| char::from_u32(0x2080 + d)).unwrap_or(c)).collect()
        }
    }
}

/// The label of the panel for a column, with its unit.
fn quantity(name: &str) -> String {
    let kind = match name.as_bytes() {
        b"angle" => "angle to the field",
        b"slip" => "slip",
        b"rotor_speed" => "speed of the rotor",
        [b'w', ..] => "angular velocity",
        [b'v', ..] => "vertical",
        _ => "currents",
    };
    match unit(name) {
        "1" => kind.to_owned(),
        unit => format!("{kind}, {unit}"),
    }
}

/// A stability map over two parameters.
pub fn stability(map: StabilityMap) -> Areas {
    let distance = significant(map.distance, 1);
    Areas {
        title: map.title.into(),
        x: (map.x.0.into(), map.x.1),
        y: (map.y.0.into(), map.y.1),
        names: Vec::new(),
        kinds: vec!["every eigenvalue has a negative real part".into(), "some has not".into()],
        rows: map.rows.iter().map(|row| row.iter().map(|stable| usize::from(!stable)).collect()).collect(),
        curves: vec![AreaCurve { name: "Hurwitz' boundary, exact".into(), points: map.curve }],
        dots: Vec::new(),
        marks: Vec::new(),
        note: format!("{} The boundary by eigenvalues is within {distance} of it.", map.note),
    }
}

/// The error of a series over its order, one line for each speed.
pub fn series_errors(errors: &[(f64, Vec<(usize, f64)>)]) -> charts::Trajectory {
    let track = |(speed, points): &(f64, Vec<(usize, f64)>)| Track {
        name: format!("ω₂ = {speed} rad/s"),
        points: points.iter().map(|(order, error)| (*order as f64, error.max(f64::MIN_POSITIVE).log10())).collect(),
        stopped: None,
    };
    charts::Trajectory {
        title: "Programme of the friction governor: error of the series in ε = 1/k against its order".to_owned(),
        x: "order".to_owned(),
        panels: vec![Panel { y: "log₁₀ of the error, m".to_owned(), series: errors.iter().map(track).collect() }],
        note: "Under constant torques, half a second after the start, compared with the closed form. The error falls by a factor \
               with each order, until only rounding is left; the higher the kept speed, the faster."
            .to_owned(),
    }
}

/// A map of verdicts over the angle and the coefficient of friction.
pub fn areas(map: Map) -> Areas {
    let place = |kind: &Kind| Kind::ALL.iter().position(|known| known == kind).unwrap_or(0);
    let (at, least, name) = map.least;
    let distance = significant(map.distance, 1);
    Areas {
        title: map.title.into(),
        x: (map.angle.into(), [0.0, 90.0]),
        y: ("coefficient of friction f".into(), [0.0, map.most_friction]),
        names: Vec::new(),
        kinds: Kind::ALL.iter().map(|kind| kind.name().into()).collect(),
        rows: map.rows.iter().map(|row| row.iter().map(place).collect()).collect(),
        curves: vec![AreaCurve { name: "critical friction, exact".into(), points: map.curve }],
        dots: Vec::new(),
        marks: vec![(at, least, name.into())],
        note: format!("{} The boundary found by decisions alone is within {distance} of it.", map.note),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_far_apart_that_hardly_move_are_shown_as_changes() {
        let track = |values: [f64; 2]| Track { points: vec![(0.0, values[0]), (1.0, values[1])], ..Track::default() };
        let panel = |series| small(Panel { y: "speed".into(), series });
        assert_eq!(panel(vec![track([6.0, 6.01]), track([0.0, 0.02])]).y, "change of speed");
        assert_eq!(panel(vec![track([6.0, 1.0]), track([0.0, 0.02])]).y, "speed");
        assert_eq!(panel(vec![track([6.0, 6.01])]).y, "speed");
    }
}
