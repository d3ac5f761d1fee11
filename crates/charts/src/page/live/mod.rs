//! A page that is updated whenever the file of a system or paper is saved, and the same page saved as a file.
//!
//! The page has a fixed list of parts. Each part has content, a message about a fault, and a [`Freshness`]. Content and message are HTML with
//! all texts escaped. A live page has one script, allowed by a nonce, which replaces parts by those that a server sends; a saved page has none.
//!
//! ```
//! use dalembert_charts::page::live::{self, Freshness, LivePage, Part, Shown};
//!
//! let heading = Shown { content: live::heading("A <pendulum>", "swing.toml"), freshness: Freshness::Current, ..Shown::default() };
//! let page = LivePage { title: "swing.toml", generator: "me", parts: &[(Part::Heading, heading)], version: 1 };
//! assert!(page.saved().contains("A &lt;pendulum&gt;") && !page.saved().contains("<script"));
//! assert!(page.served("1f").contains("<script nonce=\"1f\""));
//! ```

mod claims;
mod motion;
mod system;
mod values;

pub use claims::{LiveClaim, claims};
pub use motion::motion;
pub use system::{LiveVector, LiveVerdict, equations, vectors, verdicts};
pub use values::{Slider, lines, sliders};

use super::Head;
use maud::{Markup, PreEscaped, html};

/// A part of the page, in the order of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The title, and the name of the file.
    Heading,
    /// The claims of a paper with their verdicts.
    Claims,
    /// A picture of the system.
    Sketch,
    /// Parameters and the start, each with a slider.
    Values,
    /// The lines that would give the file the values of the sliders.
    Lines,
    /// The run: a summary, time series, phase portraits.
    Motion,
    /// Equations of motion.
    Equations,
    /// Verdicts on the agreement of the principles, and on conserved quantities.
    Verdicts,
    /// Derived vectors, and the kinds of constraints.
    Vectors,
}

impl Part {
    /// All parts in the order of the page.
    pub const ALL: [Part; 9] = [
        Part::Heading,
        Part::Claims,
        Part::Sketch,
        Part::Values,
        Part::Lines,
        Part::Motion,
        Part::Equations,
        Part::Verdicts,
        Part::Vectors,
    ];

    /// The id of the part in the page and in messages of the server.
    pub fn id(self) -> &'static str {
        match self {
            Part::Heading => "heading",
            Part::Claims => "claims",
            Part::Sketch => "sketch",
            Part::Values => "values",
            Part::Lines => "lines",
            Part::Motion => "motion",
            Part::Equations => "equations",
            Part::Vectors => "vectors",
            Part::Verdicts => "verdicts",
        }
    }

    /// The heading above the part; the first part contains its own.
    fn title(self) -> &'static str {
        match self {
            Part::Heading => "",
            Part::Claims => "Claims",
            Part::Sketch => "Sketch",
            Part::Values => "Parameters and start",
            Part::Lines => "Lines to write into the file",
            Part::Motion => "Run",
            Part::Equations => "Equations of motion",
            Part::Vectors => "Derived vectors, kinds of constraints",
            Part::Verdicts => "Verdicts",
        }
    }
}

/// The age of a part's content relative to the present text of the file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Freshness {
    /// There is no content yet, or the file describes nothing for this part.
    #[default]
    Absent,
    /// The part is being computed for the present text; the content that is shown belongs to an earlier text.
    Working,
    /// The content belongs to the present text.
    Current,
    /// The content belongs to an earlier text, because the present text describes nothing for this part or has a fault.
    Earlier,
}

impl Freshness {
    /// The value of `data-state` in the page.
    pub fn name(self) -> &'static str {
        match self {
            Freshness::Absent => "absent",
            Freshness::Working => "working",
            Freshness::Current => "current",
            Freshness::Earlier => "earlier",
        }
    }
}

/// The content of a part, its fault, and its age.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// The content as HTML.
    pub content: String,
    /// The message about a fault as HTML; empty without a fault.
    pub fault: String,
    pub freshness: Freshness,
}

/// A page with its parts.
#[derive(Clone, Copy, Debug)]
pub struct LivePage<'a> {
    pub title: &'a str,
    /// The program that made the page, with its version.
    pub generator: &'a str,
    pub parts: &'a [(Part, Shown)],
    /// The version of the parts; the script of the page asks the server for parts with a higher version.
    pub version: u64,
}

impl LivePage<'_> {
    /// The HTML that a server sends; its content security policy allows only scripts with this nonce.
    pub fn served(&self, nonce: &str) -> String {
        let policy = format!(
            "default-src 'none'; font-src data:; img-src data:; style-src 'unsafe-inline'; script-src 'nonce-{nonce}'; \
             connect-src 'self'; base-uri 'none'; form-action 'none'"
        );
        let script = html! { script nonce=(nonce) { (PreEscaped(include_str!("live.js"))) } };
        self.whole(&policy, true, &script)
    }

    /// The HTML of a file that needs neither a server nor a script.
    pub fn saved(&self) -> String {
        let policy = "default-src 'none'; font-src data:; img-src data:; style-src 'unsafe-inline'";
        self.whole(policy, false, &html! {})
    }

    fn whole(&self, policy: &str, is_served: bool, script: &Markup) -> String {
        let LivePage { title, generator, parts, version } = self;
        let known = |part: Part| parts.iter().find(|(own, _)| *own == part).map(|(_, shown)| shown);
        let absent = Shown::default();
        let body = html! {
            div.live data-version=(version) {
                @for part in Part::ALL { (section(part, known(part).unwrap_or(&absent), is_served)) }
                footer {
                    p { (generator) }
                    @if is_served {
                        p { a href="page.html" download { "Save this page" } " as a file that is read without the program." }
                        p #connection role="status" hidden { "The program has ended: this page shows its last state." }
                    }
                }
            }
            (script)
        };
        let style = format!("{}{}", crate::SKETCH_STYLE, include_str!("live.css"));
        Head { title, generator, policy, style: &style, icon: Some("data:,") }.over(&body)
    }
}

fn section(part: Part, Shown { content, fault, freshness }: &Shown, is_served: bool) -> Markup {
    let (id, title) = (part.id(), part.title());
    let content = html! { div.content { (PreEscaped(content)) } };
    html! {
        section id=(id) data-state=(freshness.name()) aria-live=[(part == Part::Heading).then_some("polite")] {
            @if !title.is_empty() { h2 { (title) } }
            div.fault { (PreEscaped(fault)) }
            @if part == Part::Values { fieldset disabled[!is_served] { (content) } } @else { (content) }
        }
    }
}

/// The title of a system or paper above the name of its file.
pub fn heading(title: &str, file: &str) -> String {
    html! { h1 { @if title.is_empty() { (file) } @else { (title) } } p.file { code { (file) } } }.into_string()
}

/// A message of several lines, as a terminal shows it; `kind` is `error`, `warning` or `note`.
pub fn message(kind: &str, text: &str) -> String {
    html! { @if !text.is_empty() { pre class={ "message " (kind) } role="status" { (text) } } }.into_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_stands_once_and_what_a_text_holds_is_escaped() {
        let fault = message("error", "<b>\u{202e}");
        let parts: Vec<(Part, Shown)> =
            Part::ALL.map(|part| (part, Shown { fault: fault.clone(), ..Shown::default() })).into();
        let page = LivePage { title: "<i>", generator: "g", parts: &parts, version: 3 };
        for html in [page.served("n"), page.saved()] {
            assert!(Part::ALL.iter().all(|part| html.matches(&format!("id=\"{}\"", part.id())).count() == 1));
            assert!(html.contains("&lt;b&gt;") && !html.contains("<b>") && !html.contains("<i>"));
            assert!(!html.contains('\u{202e}') && !html.contains("src=\"http"));
        }
    }

    #[test]
    fn sliders_of_a_saved_page_do_not_move() {
        let page = LivePage { title: "", generator: "", parts: &[], version: 0 };
        assert!(page.saved().contains("<fieldset disabled>") && page.served("n").contains("<fieldset>"));
    }
}
