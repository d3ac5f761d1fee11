//! `dalembert run` of a scene with rough contacts: its log, its table, its section of the report.

use crate::arguments::Format;
use crate::ending::{Ending, print};
use crate::progress::Progress;
use crate::run::Asked;
use crate::run::{refuse, writes};
use crate::{clock, csv};
use charts::{Panel, Parameter, SceneSection, Table, Track, significant, tolerance};
use integrators::Tolerance;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use studies::friction::course::unit;
use studies::friction::run::Plan;
use studies::friction::{Course, RoughScene};

/// Runs a scene and prints its log.
pub fn run(scene: &RoughScene, asked: &Asked) -> Result<Ending, Ending> {
    refuse("a system with rough contacts", asked.model.is_some(), asked.form.is_some(), &asked.scene)?;
    let own = scene.plan.clone();
    let mut plan = Plan {
        method: asked.method.unwrap_or(own.method),
        tolerance: asked.tolerance.map_or(own.tolerance.clone(), Tolerance::both),
        allowed: Some(clock::left()),
        ..own
    };
    if let Some(samples) = asked.samples {
        plan = plan.with_samples(samples as usize);
    }
    let columns: Vec<String> = scene.columns().iter().map(|name| csv::headed(name, unit(name))).collect();
    let table = csv::Table::at(&writes(asked), asked.out.as_deref(), &columns)?;
    let mut progress = Progress::new(&scene.title);
    let course = scene.follow_while(&plan, &mut |fraction| {
        progress.set(fraction);
        clock::goes_on()
    });
    drop(progress);
    let table = table.write(&course.times, &course.rows, (end(&course), course.last()));
    print(&match asked.format {
        Format::Text => text(scene, &plan, &course),
        Format::Json => json(scene, &plan, &course),
    })?;
    if let Some(written) = table? {
        written.tell(asked.format)?;
    }
    Ok(if course.reached { Ending::Done } else { Ending::Stopped })
}

fn end(course: &Course) -> f64 {
    course.times.last().copied().unwrap_or(0.0)
}

fn text(scene: &RoughScene, plan: &Plan, course: &Course) -> String {
    let mut text = format!("{}\n{}\n", scene.title, plan.method);
    // writing to a string cannot fail
    for line in &course.log {
        let _ = writeln!(text, "t = {:>12.9} s  {}", line.time, line.cause);
        let _ = writeln!(text, "{:>20}-> {}", "", line.regime);
    }
    let _ = writeln!(text, "t = {:>12.9} s  {}", end(course), course.ending);
    let _ = writeln!(
        text,
        "work of friction {}; energy balance {}",
        joules(course.friction_work, |work| format!("{work:.9} J")),
        joules(course.imbalance, |open| format!("open by {open:.1e} J"))
    );
    if let Some(check) = scene.check(course) {
        let _ = writeln!(text, "{}: off by {:.1e}", check.what, check.deviation);
    }
    text
}

/// An energy, where it has a value.
fn joules(value: f64, written: impl Fn(f64) -> String) -> String {
    if value.is_finite() { written(value) } else { "undefined".to_owned() }
}

fn json(scene: &RoughScene, plan: &Plan, course: &Course) -> String {
    let object = |row: &[f64]| -> Map<String, Value> {
        course.names.iter().zip(row).map(|(name, value)| (name.clone(), json!(value))).collect()
    };
    let log = course.log.iter().map(|line| {
        json!({
            "time": line.time, "cause": line.cause, "regime": line.regime, "state": object(&line.row),
            "reactions": line.reactions,
        })
    });
    let check = scene.check(course).map(|check| json!({ "what": check.what, "deviation": check.deviation }));
    let object = json!({
        "time": end(course),
        "state": object(course.last()),
        "work": { "evaluations": course.work.rates, "steps": course.work.steps },
        "invariants": { "energy_balance": course.imbalance },
        "friction_work": course.friction_work,
        "model": scene.system.name(),
        "method": plan.method.to_string(),
        "reached": course.reached,
        "stopped": (!course.reached).then_some(&course.ending),
        "log": log.collect::<Vec<_>>(),
        "closed_form": check,
    });
    format!("{object:#}\n")
}

/// A scene's section of the report, from its own run.
pub fn section(id: &str, scene: &RoughScene) -> SceneSection {
    let mut course = scene.follow(&scene.plan, &mut |_| ());
    if !course.reached && end(&course) > 0.0 {
        // the instants of the scene are those of its whole span: a curve that ends early has as many
        let spread = scene.plan.outputs.iter().map(|time| time * end(&course) / scene.plan.end);
        let plan = Plan { outputs: spread.collect(), ..scene.plan.clone() };
        course = scene.follow(&plan, &mut |_| ());
    }
    let text = |text: &str| text.to_owned();
    let mut facts = vec![
        (text("system"), scene.system.name().replace('_', " ")),
        (text("method"), format!("{}, tolerance {}", scene.plan.method, tolerance(scene.plan.tolerance.relative))),
        (text("work"), format!("{} evaluations, {} steps", course.work.rates, course.work.steps)),
        (text("ends"), format!("at {} s: {}", significant(end(&course), 6), course.ending)),
        (text("work of friction"), joules(course.friction_work, |work| format!("{} J", significant(work, 6)))),
        (text("energy balance"), joules(course.imbalance, |open| format!("open by {} J", significant(open.abs(), 2)))),
    ];
    if let Some(check) = scene.check(&course) {
        facts.push((text("closed form"), format!("{}: off by {}", check.what, significant(check.deviation, 2))));
    }
    let parameters = scene.system.data().into_iter().map(|(symbol, unit, meaning, value)| Parameter {
        symbol: text(symbol),
        value: significant(value, 6),
        unit: text(unit),
        meaning: text(meaning),
    });
    SceneSection {
        id: text(id),
        title: scene.title.clone(),
        description: scene.description.clone(),
        parameters: parameters.collect(),
        facts,
        tables: if course.log.is_empty() { Vec::new() } else { vec![log(&course)] },
        trajectory: (course.rows.len() > 1).then(|| picture(&course)),
        ..SceneSection::default()
    }
}

fn log(course: &Course) -> Table {
    let events =
        course.log.iter().map(|line| vec![format!("{:.6}", line.time), line.cause.clone(), line.regime.clone()]);
    let last = vec![format!("{:.6}", end(course)), course.ending.clone(), String::new()];
    Table {
        caption: "What happened, and why".to_owned(),
        head: ["Time, s", "What happened", "From here on"].map(String::from).into(),
        rows: events.chain([last]).collect(),
    }
}

/// The angle, its rate, the velocities at the contacts, the works.
fn picture(course: &Course) -> charts::Trajectory {
    let stopped = (!course.reached).then(|| course.ending.clone());
    let track = |name: &str, label: String| {
        let column = course.column(name)?;
        // the states of events belong to the curve
        let mut points: Vec<(f64, f64)> =
            course.times.iter().zip(&course.rows).map(|(t, row)| (*t, row[column])).collect();
        points.extend(course.log.iter().map(|line| (line.time, line.row[column])));
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        // the reason is told once, at the angle
        Some(Track { name: label, points, stopped: stopped.clone().filter(|_| name == "angle") })
    };
    let panel = |y: &str, names: &[(&str, String)]| Panel {
        y: y.to_owned(),
        series: names.iter().filter_map(|(name, label)| track(name, label.clone())).collect(),
    };
    let contacts =
        course.names.iter().filter_map(|name| Some((name.as_str(), name.strip_prefix("sliding_")?.to_owned())));
    charts::Trajectory {
        title: "The run against time".to_owned(),
        x: "time, s".to_owned(),
        panels: vec![
            panel("angle, rad", &[("angle", "angle".to_owned())]),
            panel("velocity along the contact, m/s", &contacts.collect::<Vec<_>>()),
            panel(
                "work, J",
                &[("friction_work", "of friction".to_owned()), ("force_work", "of the forces".to_owned())],
            ),
        ],
        note: String::new(),
    }
}
