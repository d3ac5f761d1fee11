//! Studies on the page: a question, the pictures that answer it, the tables of their numbers.

use super::cards::{figure, table};
use crate::{Study, text::Typesetter};
use maud::{Markup, html};

pub(super) fn section(study: &Study, set: &mut Typesetter) -> Markup {
    html! {
        section id=(study.id) {
            h2 { (study.title) }
            @if !study.lead.is_empty() { p.lead { (set.text(&study.lead)) } }
            @if let Some(run) = &study.run { (figure(&run.title, run.drawing().embedded(&run.title), &run.note, set)) }
            @for two in study.pictures.chunks(2) {
                div.pair {
                    @for picture in two {
                        (figure(&picture.title, picture.drawing().embedded(&picture.title), &picture.note, set))
                    }
                }
            }
            @for each in &study.tables { (table(each, set)) }
            @if !study.note.is_empty() { p.note { (set.text(&study.note)) } }
        }
    }
}
