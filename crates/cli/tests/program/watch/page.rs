//! The content of the page: a text, an error and its correction, sliders, a paper, and the page saved as a file.

use super::{PENDULUM, Watched, copied, is_own_processor};
use crate::{run, temporary};
use serde_json::json;

#[test]
fn a_page_shows_equations_verdicts_and_the_run_of_its_file() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    let mut events = watched.events();
    let parts = ["heading", "values", "equations", "vectors", "verdicts", "motion", "sketch"];
    let is_moving = |page: &super::Page| page.content("sketch").contains("<animate");
    let page = events.until("all is done", |page| is_moving(page) && parts.iter().all(|part| page.is(part, "current")));
    assert!(page.content("heading").contains("A &lt;pendulum&gt;"));
    assert!(
        page.content("equations").contains("<math")
            && page.content("equations").contains("by the principle virtual-power")
    );
    assert!(
        page.content("vectors").contains("<code>velocity(bob)</code></dt><dd><div class=\"formula\"><math"),
        "{}",
        page.content("vectors")
    );
    assert!(page.content("verdicts").contains("chip proved"), "{}", page.content("verdicts"));
    let motion = page.content("motion");
    assert!(motion.contains("<svg") && motion.contains("reached              t = 1 s"), "{motion}");
    let sketch = page.content("sketch");
    assert!(sketch.contains("<svg") && sketch.contains("<animate"), "{sketch}");
    assert!(page.content("values").contains("name=\"parameters.m\"") && !page.parts.contains_key("claims"));
}

#[test]
fn a_fault_is_told_at_its_place_above_the_last_good_state_until_it_is_mended() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    let mut events = watched.events();
    let is_good = |page: &super::Page| page.is("heading", "current") && page.is("motion", "current");
    events.until("all is done", is_good);
    watched.save(&PENDULUM.replace("l*A.y", "ll*A.y"));
    let page = events.until("the fault is told", |page| page.is("heading", "earlier"));
    let fault = page.text("heading", "fault");
    assert!(fault.contains("swing.toml:6:") && fault.contains("ll") && fault.contains("message error"), "{fault}");
    let page = events.until("the run is of an earlier text", |page| page.is("motion", "earlier"));
    assert!(page.content("motion").contains("<svg") && page.content("equations").contains("<math"));
    watched.save(&PENDULUM.replace("0.5 m", "0.7 m"));
    assert_eq!(events.until("all is good again", is_good).text("heading", "fault"), "");
    std::fs::remove_file(&watched.file).expect("it is there");
    let page = events.until("the file is away", |page| page.is("heading", "earlier"));
    assert!(page.text("heading", "fault").contains("there is no such file"));
    // editors save by writing another file and renaming it
    let other = watched.folder.path().join("swing.toml~");
    std::fs::write(&other, PENDULUM).expect("it can be written");
    std::fs::rename(&other, &watched.file).expect("it can be moved");
    assert_eq!(events.until("all is good again", is_good).text("heading", "fault"), "");
}

#[test]
fn a_slider_runs_the_text_with_its_value_and_leaves_the_file_alone() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    let mut events = watched.events();
    let before = events.until("the run is there", |page| page.is("motion", "current")).content("motion").to_owned();
    assert_eq!(watched.move_to(&json!({ "parameters.l": 0.25, "start.\"theta'\"": 0.5 })), 200);
    let is_moved = |page: &super::Page| page.is("motion", "current") && page.content("motion") != before;
    let page = events.until("another run is there", is_moved);
    let lines = page.content("lines");
    assert!(lines.contains("line 3") && lines.contains("l = &quot;0.250 m&quot;"), "{lines}");
    assert!(lines.contains("line 7") && lines.contains("0.50 rad/s&quot;"), "{lines}");
    assert_eq!(page.values, json!({ "parameters.l": "0.250", "start.\"theta'\"": "0.50" }));
    assert_eq!(std::fs::read_to_string(&watched.file).expect("it is there"), PENDULUM);
    assert_eq!(watched.move_to(&json!({})), 200);
    let page =
        events.until("the first run is back", |page| page.is("motion", "current") && page.content("motion") == before);
    assert!(page.is("lines", "absent") && page.values == json!({}));
}

#[test]
fn sliders_that_there_are_not_and_values_beyond_their_ends_are_refused_with_the_reason() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    watched.events().until("the sliders are there", |page| page.is("values", "current"));
    for (values, told) in [
        (
            json!({ "nobody": 3 }),
            "no slider is called `nobody`; sliders of the present text: parameters.m, parameters.l",
        ),
        (json!({ "parameters.l": 0.3, "parameters.m": 1e9 }), "parameters.m: 1000000000; a number from 0.02 to 2"),
        (json!({ "parameters.l": -0.1 }), "a number from 0.01 to 1"),
    ] {
        let (status, answer) = watched.ask(&watched.head("POST", "values"), &values.to_string());
        assert!(status == 400 && answer.contains(told), "{values}: {answer}");
    }
}

/// A pendulum whose length and mass have no values.
fn open(title: &str) -> String {
    let text = PENDULUM.replace("\"1 kg\"", "\"kg\"").replace("\"0.5 m\"", "\"m\"").replace("A <pendulum>", title);
    text.lines().filter(|line| !line.starts_with("run")).map(|line| format!("{line}\n")).collect()
}

#[test]
fn a_sketch_needs_neither_a_run_nor_values_and_leaves_with_its_system() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", &open("Open"));
    let mut events = watched.events();
    let page = events.until("the sketch is there", |page| page.is("sketch", "current"));
    assert!(page.content("sketch").contains("Parameters without a value are drawn as 1: m, l."), "{:?}", page.parts);
    // the run fails: the error belongs to this text, and the sketch is still drawn
    watched.save(&format!("{}run = {{ span = \"1 s\" }}\n", open("Failing")));
    let page = events.until("the run fails", |page| page.text("motion", "fault").contains("no value"));
    assert!(page.is("motion", "current") && page.is("sketch", "current"), "{:?}", page.parts);
    let placeless = "title = \"Two\"\ncoordinates = { x = \"m\" }\nenergies = { kinetic = \"(1 kg)*x'^2/2\" }\n";
    watched.save(placeless);
    let page =
        events.until("the other system is read", |page| page.is("sketch", "absent") && page.is("motion", "absent"));
    assert!(page.content("sketch").is_empty() && page.text("motion", "fault").is_empty(), "{:?}", page.parts);
}

#[test]
fn a_page_that_is_saved_when_the_time_is_over_keeps_what_there_is() {
    if !is_own_processor() {
        return;
    }
    let [scene, page] = ["late.toml", "late.html"].map(temporary);
    // on any machine the run takes longer than the time limit
    let sines: Vec<String> = (2..200).map(|k| format!("sin({k}*theta)")).collect();
    let force = format!("force = [{{ along = \"theta\", is = \"-(1e-6 N m)*({})\" }}]\n", sines.join(" + "));
    std::fs::write(&scene, PENDULUM.replace("1 s", "1e9 s") + &force).expect("it can be written");
    let paths = [&scene, &page].map(|path| path.to_string_lossy().into_owned());
    let output = run(&["watch", &paths[0], "--save", &paths[1], "--seconds", "4"]);
    let html = std::fs::read_to_string(&page).unwrap_or_default();
    assert!(output.status.code() == Some(1) && html.contains("A &lt;pendulum&gt;"), "{output:?}");
    assert!(html.contains("not finished when the page was written") && html.contains("<math"), "{html}");
    for path in [scene, page] {
        std::fs::remove_file(path).expect("it is there");
    }
}

#[test]
fn two_pages_are_told_the_same_whenever_they_come() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    let is_done = |page: &super::Page| page.is("motion", "current") && page.is("verdicts", "current");
    let mut first = watched.events();
    let motion = first.until("all is done", is_done).content("motion").to_owned();
    let mut second = watched.events();
    assert_eq!(second.until("the second is told", is_done).content("motion"), motion);
    watched.save(&PENDULUM.replace("40 deg", "70 deg"));
    for events in [&mut first, &mut second] {
        events.until("both are told", |page| is_done(page) && page.content("motion") != motion);
    }
}

#[test]
fn claims_of_a_paper_stand_beside_their_source_and_follow_its_model() {
    if !is_own_processor() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder can be made");
    let model = copied(folder.path(), "scenes/foreign/pushed_cart_pole.toml");
    let paper = copied(folder.path(), "papers/cart_pole.toml");
    let text = std::fs::read_to_string(&paper).expect("it is there");
    std::fs::write(&paper, text.replace("../scenes/foreign/", "")).expect("it can be written");
    let watched = Watched::in_folder(folder, paper);
    let mut events = watched.events();
    let page = events.until("all claims are decided", |page| page.is("claims", "current"));
    let claims = page.content("claims");
    assert!(
        claims.contains("8 of 8 decided") && claims.contains("chip refuted") && claims.contains("Correction, proved")
    );
    assert!(claims.contains(r"\ddot{x} = \frac{F + m l") && !page.parts.contains_key("motion"), "{claims}");
    std::fs::write(&model, "title = 3").expect("it can be written");
    events.until("the model is wrong", |page| page.is("heading", "earlier"));
}

#[test]
fn a_saved_page_needs_neither_the_program_nor_anything_from_outside() {
    if !is_own_processor() {
        return;
    }
    let [scene, page] = ["saved.toml", "saved.html"].map(temporary);
    std::fs::write(&scene, PENDULUM).expect("it can be written");
    let paths = [&scene, &page].map(|path| path.to_string_lossy().into_owned());
    let asked = ["watch", &paths[0], "--save", &paths[1]];
    let output = run(&asked);
    let html = std::fs::read_to_string(&page).unwrap_or_default();
    assert!(output.status.success(), "{output:?}");
    for shown in ["chip proved", "<math", "<svg", "velocity(bob)", "A &lt;pendulum&gt;"] {
        assert!(html.contains(shown), "{shown}");
    }
    for outside in ["<script", "http://", "https://", "src=", "at work"] {
        assert!(!html.split("</style>").last().unwrap_or_default().contains(outside), "{outside}");
    }
    std::fs::write(&page, "mine").expect("it can be written");
    let refused = run(&asked);
    assert_eq!((refused.status.code(), std::fs::read_to_string(&page).ok()), (Some(2), Some("mine".to_owned())));
    std::fs::write(&scene, PENDULUM.replace("l*A.y", "ll*A.y")).expect("it can be written");
    std::fs::remove_file(&page).expect("it is there");
    let wrong = run(&asked);
    assert_eq!((wrong.status.code(), page.exists()), (Some(2), false), "{wrong:?}");
    assert!(String::from_utf8_lossy(&wrong.stderr).contains("saved.toml:6:"));
    std::fs::remove_file(&scene).expect("it is there");
}
