//! The page of the specimen: self-contained, escaped, with all formulas typeset, and deterministic.

use crate::report::specimen;
use dalembert_charts::{ClaimRow, PaperSection, Report, Trajectory, Verdict, page};

#[test]
fn every_formula_of_the_specimen_is_typeset() {
    assert_eq!(page::render(&specimen()).unset, []);
}

#[test]
fn output_is_deterministic() {
    assert_eq!(page::render(&specimen()).html, page::render(&specimen()).html);
}

#[test]
fn the_page_refers_to_nothing_outside() {
    let html = page::render(&specimen()).html;
    for attribute in ["src=", "href=", "url(", "@import", "srcset=", "action="] {
        for (at, _) in html.match_indices(attribute) {
            let value = html[at + attribute.len()..].trim_start_matches(['"', '\'']);
            let inside = match attribute {
                "href=" => value.starts_with('#'),
                "url(" => value.starts_with("data:"),
                _ => false,
            };
            assert!(inside, "{attribute}{}", value.chars().take(60).collect::<String>());
        }
    }
    let schemes = html.matches("http://").count() + html.matches("https://").count();
    assert_eq!(schemes, html.matches("\"http://www.w3.org/2000/svg\"").count());
}

#[test]
fn all_text_is_escaped() {
    let evil = "<script>alert('&')</script>\"";
    let claim = ClaimRow {
        id: evil.into(),
        equation_label: evil.into(),
        title: evil.into(),
        latex: vec![evil.into()],
        requires: vec![evil.into()],
        evidence: evil.into(),
        counterexample: vec![(evil.into(), evil.into())],
        difference: Some(evil.into()),
        why: evil.into(),
        reading: evil.into(),
        note: evil.into(),
        ..Default::default()
    };
    let paper = PaperSection { title: evil.into(), claims: vec![claim], ..Default::default() };
    let report = Report { title: evil.into(), summary: evil.into(), papers: vec![paper], ..Default::default() };
    let html = page::render(&report).html;
    assert!(!html.contains("<script>alert") && html.contains("&lt;script&gt;alert"));
    assert_eq!(html.matches("<script").count(), 1);
}

/// A title of an attacker: markup, LaTeX that is invalid or makes a link, terminal escape sequences, a change of the writing direction.
const HOSTILE: &str = "\"><script>alert(1)</script><img src=x onerror=alert(1)>' $\\href{javascript:alert(1)}{x}$ $\\frac{$ \u{1b}]0;T\u{7} \
                       \u{9b}2J \u{202e}B \u{0}&amp;]]>--></style></title></svg>";

#[test]
fn a_hostile_title_acts_nowhere_in_the_page() {
    let mut report = specimen();
    report.title = HOSTILE.into();
    report.generated_by = HOSTILE.into();
    for scene in report.scenes.iter_mut().chain(&mut report.rough) {
        scene.title = HOSTILE.into();
        scene.description = HOSTILE.into();
    }
    let harmless = page::render(&specimen()).html;
    let html = page::render(&report).html;
    assert!(!html.contains(['\u{1b}', '\u{7}', '\u{9b}', '\u{202e}', '\u{0}']));
    for mark in ["<script", "<img", "</style", "</title", "<a ", "javascript:"] {
        let count = |html: &str| html.matches(mark).count();
        let found = html.match_indices(mark).map(|(at, _)| html[at..].chars().take(60).collect::<String>());
        let plain = mark == "javascript:";
        assert!(plain || count(&html) == count(&harmless), "{mark}: {:?}", found.collect::<Vec<_>>());
    }
    assert!(
        !html.contains("href=\"javascript") && !html.contains("href=javascript") && !html.contains("onerror=alert(1)>")
    );
}

#[test]
fn a_hostile_title_acts_nowhere_in_a_picture() {
    let picture = Trajectory { title: HOSTILE.into(), ..Trajectory::default() };
    let svg = picture.svg();
    assert!(!svg.contains(['\u{1b}', '\u{7}', '\u{9b}', '\u{202e}', '\u{0}']), "{svg}");
    assert!(!svg.contains("<script") && !svg.contains("<img") && svg.matches("</svg>").count() == 1, "{svg}");
}

#[test]
fn every_link_has_its_target_and_every_target_is_unique() {
    let html = page::render(&specimen()).html;
    let values = |attribute: &str| -> Vec<String> {
        let starts = html.match_indices(attribute).map(|(at, _)| at + attribute.len());
        starts.map(|start| html[start..].chars().take_while(|c| *c != '"').collect()).collect()
    };
    let targets = values(" id=\"");
    assert!(targets.iter().all(|target| targets.iter().filter(|other| *other == target).count() == 1));
    for link in values("href=\"#") {
        assert!(targets.contains(&link), "{link}");
    }
}

#[test]
fn findings_come_before_the_ledger() {
    let html = page::render(&specimen()).html;
    let at = |id: &str| html.find(&format!("id=\"{id}\"")).expect(id);
    assert!(at("findings") < at("doe2031") && at("doe2031") < at("scenes") && at("scenes") < at("spheres"));
}

#[test]
fn latex_that_does_not_parse_is_shown_and_reported() {
    let claim = ClaimRow { id: "p/eq1".into(), latex: vec![r"\frac{1}{".into()], ..Default::default() };
    let paper = PaperSection { claims: vec![claim], ..Default::default() };
    let page = page::render(&Report { papers: vec![paper], ..Default::default() });
    assert!(page.html.contains(r"\frac{1}{"));
    assert_eq!((page.unset.len(), page.unset[0].place.as_str()), (1, "p/eq1"));
}

#[test]
fn an_empty_report_is_a_page() {
    let page = page::render(&Report::default());
    assert!(page.html.contains("<main") && page.unset.is_empty());
}

#[test]
fn a_full_report_stays_below_two_megabytes() {
    let html = page::render(&specimen()).html;
    assert!(html.len() < 2_000_000, "{}", html.len());
    assert_eq!(specimen().papers.iter().map(|paper| paper.claims.len()).sum::<usize>(), 70);
    assert!(specimen().count(Verdict::Refuted) > 5);
}
