//! Sections that consist mainly of pictures: spheres, stability maps, maps of friction and timings.

use super::cards::{facts, figure, table};
use crate::{Report, Sphere, Table, Timings, svg::timings::seconds, text::Typesetter};
use maud::{Markup, html};

pub(super) fn spheres(report: &Report, set: &mut Typesetter) -> Markup {
    html! {
        @if !report.spheres.is_empty() {
            section #spheres data-shared=(Sphere::shared_data()) {
                h2 { "Directions on the sphere" }
                @for sphere in &report.spheres { (card(sphere, set)) }
            }
        }
    }
}

/// A sphere as a still picture, with the data by which the script of the page turns it.
fn card(sphere: &Sphere, set: &mut Typesetter) -> Markup {
    set.at(&sphere.title);
    html! {
        div.sphere.pair data-sphere=(sphere.data()) {
            div {
                (figure(&sphere.title, sphere.drawing().embedded(&sphere.title), "", set))
                p.readout hidden { output { "Drag or use the arrow keys to turn; point at a curve to read its value." } " "
                    button type="button" { "First view" } }
            }
            div {
                @if !sphere.description.is_empty() { p { (set.text(&sphere.description)) } }
                (facts(&sphere.facts, set))
                @if !sphere.note.is_empty() { p.note { (set.text(&sphere.note)) } }
            }
        }
    }
}

pub(super) fn stability(report: &Report, set: &mut Typesetter) -> Markup {
    html! {
        @if !report.stability.is_empty() || !report.approximations.is_empty() {
            section #governors {
                h2 { "Stability and series" }
                @for two in report.stability.chunks(2) {
                    div.pair {
                        @for areas in two {
                            (figure(&areas.title, areas.drawing().embedded(&areas.title), &areas.note, set))
                        }
                    }
                }
                @for chart in &report.approximations {
                    (figure(&chart.title, chart.drawing().embedded(&chart.title), &chart.note, set))
                }
            }
        }
    }
}

pub(super) fn friction(report: &Report, set: &mut Typesetter) -> Markup {
    html! {
        @if !report.friction.is_empty() || !report.rough.is_empty() {
            section #friction {
                h2 { "Friction" }
                @for two in report.friction.chunks(2) {
                    div.pair {
                        @for areas in two {
                            (figure(&areas.title, areas.drawing().embedded(&areas.title), &areas.note, set))
                        }
                    }
                }
                @for scene in &report.rough { (super::scenes::card(scene, set)) }
            }
        }
    }
}

pub(super) fn timings(report: &Report, set: &mut Typesetter) -> Markup {
    html! {
        @if !report.timings.is_empty() || !report.timings_missing.is_empty() {
            section #timings {
                h2 { "Timings" }
                @if report.timings.is_empty() { p.lead { (set.text(&report.timings_missing)) } }
                @for timings in &report.timings {
                    div.pair {
                        (figure(&timings.title, timings.drawing().embedded(&timings.title), &timings.note, set))
                        (table(&times(timings), set))
                    }
                }
            }
        }
    }
}

/// The table of the times that the bars show.
fn times(timings: &Timings) -> Table {
    let names = timings.names();
    let head = ["Task", &timings.ours].into_iter().chain(names.iter().copied()).map(String::from).collect();
    let row = |row: &crate::TimingRow| {
        let theirs = names.iter().map(|name| match row.others.iter().find(|other| other.name == **name) {
            Some(other) => other.outcome.as_ref().map_or("—".to_owned(), |time| seconds(*time)),
            None => "—".to_owned(),
        });
        [row.task.clone(), seconds(row.ours)].into_iter().chain(theirs).collect()
    };
    Table { caption: "Times".into(), head, rows: timings.rows.iter().map(row).collect() }
}
