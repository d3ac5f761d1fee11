//! The page: one self-contained HTML file.

mod cards;
mod claims;
mod conditions;
mod figures;
mod findings;
mod font;
pub mod live;
mod outline;
mod scenes;
mod statement;
mod studies;

use crate::{Report, Unset, svg, text::Typesetter};
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A finished page.
#[derive(Clone, Debug)]
pub struct Page {
    pub html: String,
    /// LaTeX that could not be typeset and is shown as source text.
    pub unset: Vec<Unset>,
}

/// The report as one HTML file. Equal reports give equal bytes.
pub fn render(report: &Report) -> Page {
    let set = &mut Typesetter::default();
    set.at("heading");
    let body = html! {
        a.skip href="#main" { "Skip to the content" }
        div.shell {
            (outline::heading(report, set))
            (outline::contents(report, set))
            main #main {
                (findings::findings(report, set))
                @for paper in &report.papers { (claims::ledger(paper, set)) }
                (scenes::scenes(report, set))
                (figures::spheres(report, set))
                (figures::stability(report, set))
                (figures::friction(report, set))
                @for study in &report.studies { (studies::section(study, set)) }
                (figures::timings(report, set))
                footer { p { (report.generated_by) } }
            }
        }
    };
    Page { html: document(report, &body), unset: std::mem::take(set).into_unset() }
}

fn document(report: &Report, body: &Markup) -> String {
    let head = Head {
        title: &crate::text::plain(&report.title),
        generator: &report.generated_by,
        policy: POLICY,
        style: "",
        icon: None,
    };
    head.over(&html! {
        (body)
        script { (PreEscaped(include_str!("filter.js"))) (PreEscaped(include_str!("search.js"))) (PreEscaped(include_str!("sphere.js"))) }
    })
}

/// The content security policy: the page loads nothing from outside.
const POLICY: &str = "default-src 'none'; font-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

/// The head of a page.
struct Head<'a> {
    title: &'a str,
    generator: &'a str,
    /// The content security policy.
    policy: &'a str,
    /// CSS rules that follow the rules of every page.
    style: &'a str,
    /// The address of the icon; with `None` the browser asks the server for its default icon.
    icon: Option<&'a str>,
}

impl Head<'_> {
    /// The whole HTML document with this head and body.
    fn over(&self, body: &Markup) -> String {
        let Head { title, generator, policy, style, icon } = self;
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    meta http-equiv="Content-Security-Policy" content=(policy);
                    meta name="generator" content=(generator);
                    @if let Some(icon) = icon { link rel="icon" href=(icon); }
                    title { (title) }
                    style { (PreEscaped(font::face())) (PreEscaped(svg::STYLE)) (PreEscaped(include_str!("page.css"))) (PreEscaped(cards::signs())) (PreEscaped(cards::numbers())) (PreEscaped(style)) }
                }
                body { (body) }
            }
        };
        crate::visible(&page.into_string()).into_owned()
    }
}

/// An identifier with its spaces replaced by `-`, for use in a link.
fn anchor(id: &str) -> String {
    id.split_whitespace().collect::<Vec<_>>().join("-")
}
