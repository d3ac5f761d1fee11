//! Scenes on the page: parameters, the summary of the run, its trajectory, the comparison of all methods.

use super::{
    anchor,
    cards::{facts, figure, numeric, table},
};
use crate::{Method, Parameter, Report, SceneSection, Table, WorkPrecision, svg::number::tolerance, text::Typesetter};
use maud::{Markup, html};

pub(super) fn scenes(report: &Report, set: &mut Typesetter) -> Markup {
    html! {
        @if !report.scenes.is_empty() {
            section #scenes {
                h2 { "Scenes" }
                @for scene in &report.scenes { (card(scene, set)) }
            }
        }
    }
}

pub(super) fn card(scene: &SceneSection, set: &mut Typesetter) -> Markup {
    set.at(&scene.id);
    html! {
        article.scene id=(anchor(&scene.id)) {
            h3 { (set.text(&scene.title)) }
            p.lead { (set.text(&scene.description)) }
            div.pair.first {
                div {
                    @if !scene.facts.is_empty() { h4 { "The run" } (facts(&scene.facts, set)) }
                    @if !scene.parameters.is_empty() { h4 { "Parameters" } (parameters(&scene.parameters, set)) }
                }
                @if let Some(trajectory) = &scene.trajectory {
                    (figure(&trajectory.title, trajectory.drawing().embedded(&trajectory.title), &trajectory.note, set))
                }
            }
            div.pair { @for chart in &scene.work {
                (figure(&chart.title, chart.drawing().embedded(&chart.title), &chart.note, set))
            } }
            @if !scene.note.is_empty() { p.note { (set.text(&scene.note)) } }
            @let tables: Vec<Table> = std::iter::once(failures(&scene.work)).chain(scene.tables.iter().cloned()).collect();
            div.pair { @for extra in tables.iter().filter(|table| !table.rows.is_empty()) { (table(extra, set)) } }
        }
    }
}

fn parameters(parameters: &[Parameter], set: &mut Typesetter) -> Markup {
    html! {
        div.scroll { table class={ "parameters " (numeric([1])) } {
            thead { tr; @for head in ["Symbol", "Value", "Unit", "Meaning"] { th scope="col"; (head) } }
            tbody { @for parameter in parameters {
                tr;
                th scope="row"; (set.text(&parameter.symbol))
                td; (set.text(&parameter.value))
                td.unit; (set.text(&parameter.unit))
                td; (set.text(&parameter.meaning))
            } }
        } }
    }
}

/// The table of failures of a scene's methods, from all charts: one row for each method and reason.
fn failures(charts: &[WorkPrecision]) -> Table {
    let mut rows: Vec<(String, String, Vec<f64>)> = Vec::new();
    for method in charts.iter().flat_map(|chart| &chart.series) {
        let own = method.family();
        for failure in &method.failures {
            let known = rows.iter_mut().find(|(name, reason, _)| name == own && *reason == failure.reason);
            match known {
                Some((_, _, tolerances)) if tolerances.iter().any(|t| t.total_cmp(&failure.tolerance).is_eq()) => {}
                Some((_, _, tolerances)) => tolerances.push(failure.tolerance),
                None => rows.push((own.to_owned(), failure.reason.clone(), vec![failure.tolerance])),
            }
        }
    }
    let total = |name: &str| series(charts, name).map(|m| m.points.len() + m.failures.len()).max();
    let list = |name: &str, tolerances: &[f64]| match total(name) {
        Some(all)
            if all > 1 && all == tolerances.len() && series(charts, name).all(|method| method.points.is_empty()) =>
        {
            "all".to_owned()
        }
        _ => tolerances.iter().map(|t| tolerance(*t)).collect::<Vec<_>>().join(", "),
    };
    Table {
        caption: "Methods that fail".into(),
        head: ["Method", "At tolerance", "Reason"].map(String::from).into(),
        rows: rows
            .into_iter()
            .map(|(name, reason, tolerances)| vec![name.clone(), list(&name, &tolerances), reason])
            .collect(),
    }
}

/// All series of a method family, over all charts.
fn series<'a>(charts: &'a [WorkPrecision], name: &'a str) -> impl Iterator<Item = &'a Method> {
    charts.iter().flat_map(|chart| &chart.series).filter(move |method| method.family() == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Failure, Point};

    #[test]
    fn failures_of_two_charts_are_listed_once() {
        let failure = |tolerance| Failure { work: 1.0, tolerance, reason: "stiff".into() };
        let method = |name: &str, points| Method {
            name: name.into(),
            failures: vec![failure(1e-3), failure(1e-6)],
            points,
            ..Default::default()
        };
        let series = vec![method("M", vec![Point { work: 1.0, error: 1.0 }]), method("N", vec![])];
        let chart = WorkPrecision { series, ..Default::default() };
        let rows = failures(&[chart.clone(), chart]).rows;
        assert_eq!(rows, [["M", "10⁻³, 10⁻⁶", "stiff"], ["N", "all", "stiff"]]);
    }
}
